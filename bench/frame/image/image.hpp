// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace pelage::frame {

/// A picture in linear RGB with sRGB primaries: rows from the top, each from the left.
struct image {
  int width = 0;
  int height = 0;
  std::vector<glm::vec3> pixels;  ///< width * height of them

  image() = default;
  image(int width_, int height_, glm::vec3 fill = glm::vec3(0.0F))
      : width(width_),
        height(height_),
        pixels(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), fill) {}

  [[nodiscard]] glm::vec3& at(int x, int y) { return pixels[index(x, y)]; }
  [[nodiscard]] const glm::vec3& at(int x, int y) const { return pixels[index(x, y)]; }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// The 8-bit sRGB value nearest to a linear one (IEC 61966-2-1); outside [0, 1] is clamped, NaN gives 0.
/// encode_srgb(decode_srgb(v)) == v for all v.
[[nodiscard]] std::uint8_t encode_srgb(float linear);

/// The linear value of an 8-bit sRGB one, [0, 1].
[[nodiscard]] float decode_srgb(std::uint8_t encoded);

/// An 8-bit sRGB PNG. The same picture gives the same bytes. Colours outside [0, 1] are clamped.
/// Throws std::runtime_error, one line, for a non-finite pixel or an empty picture.
[[nodiscard]] std::vector<std::byte> encode_png(const image& picture);

/// Writes encode_png() to a file.
///
/// Throws std::runtime_error, "FILE: what is wrong" on one line, for a non-finite pixel, an empty picture, or
/// a file that cannot be written; then the file is as it was before and nothing is left beside it.
void save_png(const std::filesystem::path& path, const image& picture);

/// Reads a PNG as 8-bit sRGB; an alpha channel is dropped and grey is spread over RGB.
/// Throws input_error (input_file.hpp) for anything that is not a whole PNG.
[[nodiscard]] image load_png(const std::filesystem::path& path);

/// How far two pictures are apart as a viewer sees them: over the 8-bit sRGB values of all channels, divided
/// by 255. Both members are in [0, 1].
struct image_difference {
  double rms = 0.0;      ///< root of the mean square
  double maximum = 0.0;  ///< largest in any channel
};

/// Throws std::invalid_argument if the sizes differ or a pixel is not finite. Two empty pictures do not
/// differ.
[[nodiscard]] image_difference compare(const image& a, const image& b);

/// A false-colour picture of the largest channel difference per pixel, measured as in compare().
///
/// The ramp rises in luminance all the way: 0 is black, then blue, violet, red, orange and yellow at even
/// steps, and white is `full_scale` or more. full_scale in (0, +inf). Throws as compare() does, and
/// std::invalid_argument for a full_scale outside its range.
[[nodiscard]] image error_map(const image& a, const image& b, double full_scale = 0.1);

/// The ramp of error_map(): linear RGB for t, clamped to [0, 1]; NaN counts as 0.
[[nodiscard]] glm::vec3 error_colour(double t);

}  // namespace pelage::frame
