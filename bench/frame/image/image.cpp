// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/image/image.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

#include "frame/base/input_file.hpp"
#include "frame/base/output_file.hpp"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb_image_write.h>

namespace pelage::frame {

namespace {

double srgb_to_linear(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// The linear values half-way, in sRGB, between neighbours of the 256: an encoded value is the number of them
/// that do not exceed it.
std::array<double, 255> make_thresholds() {
  std::array<double, 255> t{};
  for (std::size_t i = 0; i < t.size(); ++i)
    t[i] = srgb_to_linear((static_cast<double>(i) + 0.5) / 255.0);
  return t;
}

std::array<float, 256> make_linear_values() {
  std::array<float, 256> v{};
  for (std::size_t i = 0; i < v.size(); ++i)
    v[i] = static_cast<float>(srgb_to_linear(static_cast<double>(i) / 255.0));
  return v;
}

bool is_finite(glm::vec3 p) {
  return std::isfinite(p.r) && std::isfinite(p.g) && std::isfinite(p.b);
}

bool is_consistent(const image& a) {
  return a.width >= 0 && a.height >= 0 &&
         a.pixels.size() == static_cast<std::size_t>(a.width) * static_cast<std::size_t>(a.height);
}

void append_bytes(void* context, void* data, int size) {
  const std::span<const std::byte> bytes(static_cast<const std::byte*>(data), static_cast<std::size_t>(size));
  auto& out = *static_cast<std::vector<std::byte>*>(context);
  out.insert(out.end(), bytes.begin(), bytes.end());
}

bool ends_as_png(std::span<const std::byte> bytes) {
  constexpr std::array<std::uint8_t, 12> marker{0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xae, 0x42, 0x60, 0x82};
  return bytes.size() >= marker.size() &&
         std::memcmp(bytes.last(marker.size()).data(), marker.data(), marker.size()) == 0;
}

void check_comparable(const image& a, const image& b) {
  if (!is_consistent(a) || !is_consistent(b) || a.width != b.width || a.height != b.height) {
    throw std::invalid_argument("the pictures differ in size");
  }
  if (!std::all_of(a.pixels.begin(), a.pixels.end(), is_finite) ||
      !std::all_of(b.pixels.begin(), b.pixels.end(), is_finite)) {
    throw std::invalid_argument("a picture has a pixel that is not finite");
  }
}

int channel_difference(glm::vec3 a, glm::vec3 b, int channel) {
  return std::abs(int{encode_srgb(a[channel])} - int{encode_srgb(b[channel])});
}

}  // namespace

std::uint8_t encode_srgb(float linear) {
  static const std::array<double, 255> thresholds = make_thresholds();
  if (std::isnan(linear)) return 0;
  const auto above = std::upper_bound(thresholds.begin(), thresholds.end(), double{linear});
  return static_cast<std::uint8_t>(above - thresholds.begin());
}

float decode_srgb(std::uint8_t encoded) {
  static const std::array<float, 256> values = make_linear_values();
  return values[encoded];
}

std::vector<std::byte> encode_png(const image& picture) {
  const auto fail = [](const std::string& fault) { throw std::runtime_error(fault); };
  if (picture.pixels.empty() || !is_consistent(picture)) fail("the picture has no pixels");
  if (picture.width > INT_MAX / 3 / picture.height) fail("the picture is too large for a PNG");

  std::vector<std::uint8_t> encoded;
  encoded.reserve(picture.pixels.size() * 3);
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const glm::vec3 p = picture.at(x, y);
      if (!is_finite(p)) fail("pixel " + std::to_string(x) + ", " + std::to_string(y) + " is not finite");
      for (int c = 0; c < 3; ++c)
        encoded.push_back(encode_srgb(p[c]));
    }
  }
  std::vector<std::byte> png;
  if (stbi_write_png_to_func(append_bytes, &png, picture.width, picture.height, 3, encoded.data(), picture.width * 3) ==
      0) {
    fail("the picture cannot be encoded");
  }
  return png;
}

void save_png(const std::filesystem::path& path, const image& picture) {
  std::vector<std::byte> png;
  try {
    png = encode_png(picture);
  } catch (const std::runtime_error& fault) {
    throw std::runtime_error(printable(path) + ": " + fault.what());
  }
  write_file(path, png);
}

image load_png(const std::filesystem::path& path) {
  const input_file file(path);
  if (file.size() > INT_MAX) file.fail(0, "too large for a PNG");
  const auto* data = reinterpret_cast<const stbi_uc*>(file.bytes().data());
  const int size = static_cast<int>(file.size());

  int width = 0;
  int height = 0;
  int channels = 0;
  if (size == 0 || stbi_info_from_memory(data, size, &width, &height, &channels) == 0) file.fail(0, "not a PNG");
  if (!ends_as_png(file.bytes())) file.fail(file.size(), "the PNG does not end with its end marker");

  // A deflate stream grows to at most 1032 times its size, and a pixel takes at least one bit.
  constexpr std::uint64_t pixels_per_byte = 1032 * 8;
  const std::uint64_t count = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
  if (count > file.size() * pixels_per_byte || count > INT_MAX / 4) {
    file.fail(16, "a PNG of " + std::to_string(width) + " x " + std::to_string(height) + " cannot be in " +
                      std::to_string(size) + " bytes");
  }

  const std::unique_ptr<stbi_uc, void (*)(void*)> texels(
      stbi_load_from_memory(data, size, &width, &height, &channels, 3), &stbi_image_free);
  if (!texels) file.fail(0, std::string("a damaged PNG (") + stbi_failure_reason() + ")");

  image picture(width, height);
  const stbi_uc* next = texels.get();
  for (glm::vec3& p : picture.pixels) {
    p = {decode_srgb(next[0]), decode_srgb(next[1]), decode_srgb(next[2])};
    next += 3;
  }
  return picture;
}

image_difference compare(const image& a, const image& b) {
  check_comparable(a, b);
  std::uint64_t squares = 0;
  int largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    for (int c = 0; c < 3; ++c) {
      const int d = channel_difference(a.pixels[i], b.pixels[i], c);
      squares += static_cast<std::uint64_t>(d) * static_cast<std::uint64_t>(d);
      largest = std::max(largest, d);
    }
  }
  if (a.pixels.empty()) return {};
  const double mean = static_cast<double>(squares) / (3.0 * static_cast<double>(a.pixels.size()));
  return {std::sqrt(mean) / 255.0, largest / 255.0};
}

image error_map(const image& a, const image& b, double full_scale) {
  if (!(full_scale > 0.0) || !std::isfinite(full_scale)) {
    throw std::invalid_argument("the full scale of an error map is not in (0, inf)");
  }
  check_comparable(a, b);
  image map(a.width, a.height);
  for (std::size_t i = 0; i < map.pixels.size(); ++i) {
    int largest = 0;
    for (int c = 0; c < 3; ++c)
      largest = std::max(largest, channel_difference(a.pixels[i], b.pixels[i], c));
    map.pixels[i] = error_colour(largest / 255.0 / full_scale);
  }
  return map;
}

glm::vec3 error_colour(double t) {
  struct srgb {
    double r, g, b;
  };
  static constexpr std::array<srgb, 7> ramp{{
      {0.00, 0.00, 0.00},
      {0.10, 0.08, 0.55},
      {0.45, 0.10, 0.65},
      {0.80, 0.15, 0.35},
      {0.95, 0.45, 0.10},
      {0.98, 0.82, 0.25},
      {1.00, 1.00, 1.00},
  }};
  const double x = (t > 0.0 ? std::min(t, 1.0) : 0.0) * static_cast<double>(ramp.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(x), ramp.size() - 2);
  const double f = x - static_cast<double>(i);
  const auto mix = [f](double lower, double upper) {
    return static_cast<float>(srgb_to_linear(lower + (upper - lower) * f));
  };
  return {mix(ramp[i].r, ramp[i + 1].r), mix(ramp[i].g, ramp[i + 1].g), mix(ramp[i].b, ramp[i + 1].b)};
}

}  // namespace pelage::frame
