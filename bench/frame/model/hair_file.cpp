// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/hair_file.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "frame/base/output_file.hpp"

namespace pelage::frame {

namespace {

constexpr std::uint32_t has_segments = 1U << 0U;
constexpr std::uint32_t has_points = 1U << 1U;
constexpr std::uint32_t has_thickness = 1U << 2U;
constexpr std::uint32_t has_transparency = 1U << 3U;
constexpr std::uint32_t has_colour = 1U << 4U;
constexpr std::uint32_t all_flags = (1U << 5U) - 1U;

constexpr std::uint64_t info_size = 88;
constexpr std::uint64_t header_size = 128;

struct range {
  float lower;
  float upper;
};
constexpr range non_negative{0.0F, std::numeric_limits<float>::max()};
constexpr range unit{0.0F, 1.0F};

void check_range(const input_file& file, std::span<const float> values, std::uint64_t offset, range allowed,
                 const std::string& what) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] >= allowed.lower && values[i] <= allowed.upper) continue;
    file.fail(offset + i * sizeof(float), what + (values[i] < allowed.lower ? " is negative" : " is above 1"));
  }
}

float read_in_range(input_file& file, range allowed, const std::string& what) {
  const std::uint64_t offset = file.offset();
  const float value = file.read_float(what);
  check_range(file, std::span(&value, 1), offset, allowed, what);
  return value;
}

std::vector<float> read_in_range(input_file& file, std::uint64_t count, range allowed, const std::string& what) {
  const std::uint64_t offset = file.offset();
  std::vector<float> values = file.read_floats(count, what);
  check_range(file, values, offset, allowed, what);
  return values;
}

void check_colours(const input_file& file, std::span<const glm::vec3> colours, std::uint64_t offset,
                   const std::string& what) {
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const std::array<float, 3> channels{colours[i].r, colours[i].g, colours[i].b};
    check_range(file, channels, offset + i * sizeof(glm::vec3), non_negative, what);
  }
}

/// Fills first_point; the array of segment counts, if any, begins at the cursor.
void read_strands(input_file& file, hair_model& model, std::uint32_t strands, std::uint32_t points, std::uint32_t flags,
                  std::uint32_t default_segments) {
  constexpr std::uint64_t point_count_offset = 8;
  constexpr std::uint64_t default_segments_offset = 16;

  std::uint64_t total = 0;
  if ((flags & has_segments) != 0) {
    const std::vector<std::uint16_t> segments = file.read_u16s(strands, "segment counts");
    model.first_point.reserve(std::size_t{strands} + 1);
    for (const std::uint16_t n : segments) {
      total += std::uint64_t{n} + 1;
      model.first_point.push_back(static_cast<std::uint32_t>(std::min<std::uint64_t>(total, points)));
    }
  } else {
    if (strands > 0 && default_segments == 0) {
      file.fail(default_segments_offset, "default segment count is 0 and there are no segment counts");
    }
    if (default_segments == std::numeric_limits<std::uint32_t>::max()) {
      file.fail(default_segments_offset, "default segment count is too large");
    }
    total = strands * (std::uint64_t{default_segments} + 1);
  }
  if (total != points) {
    file.fail(point_count_offset, "point count is " + std::to_string(points) + ", but the strands have " +
                                      std::to_string(total) + " points");
  }
  if ((flags & has_segments) == 0) {
    file.require(points, sizeof(glm::vec3), "point");
    model.first_point.reserve(std::size_t{strands} + 1);
    for (std::uint32_t s = 1; s <= strands; ++s)
      model.first_point.push_back(s * (default_segments + 1));
  }
}

class byte_writer {
 public:
  template <class T>
  void put(const T& value) {
    put(std::span<const T>(&value, 1));
  }
  template <class T>
  void put(std::span<const T> values) {
    if (values.empty()) return;
    const std::size_t end = bytes_.size();
    bytes_.resize(end + values.size_bytes());
    std::memcpy(&bytes_[end], values.data(), values.size_bytes());
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(std::span<const T>(values));
  }
  [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

}  // namespace

hair_model read_hair(input_file& file) {
  constexpr std::uint64_t flags_offset = 12;

  file.require(header_size, 1, "the .hair header");
  if (file.read_text(4, "signature") != "HAIR") file.fail(0, "not a .hair file (no \"HAIR\" signature)");
  const std::uint32_t strands = file.read_u32("strand count");
  const std::uint32_t points = file.read_u32("point count");
  const std::uint32_t flags = file.read_u32("flags");
  if ((flags & ~all_flags) != 0) file.fail(flags_offset, "unknown flags are set");
  if ((flags & has_points) == 0) file.fail(flags_offset, "the file has no points");

  hair_model model;
  const std::uint32_t default_segments = file.read_u32("default segment count");
  model.default_thickness = read_in_range(file, non_negative, "default thickness");
  model.default_transparency = read_in_range(file, unit, "default transparency");
  const std::uint64_t colour_offset = file.offset();
  model.default_colour = file.read_vec3("default colour");
  check_colours(file, std::span(&model.default_colour, 1), colour_offset, "default colour");
  file.seek(file.offset() + info_size, "information text");

  read_strands(file, model, strands, points, flags, default_segments);
  model.points = file.read_vec3s(points, "point");
  if ((flags & has_thickness) != 0) model.thickness = read_in_range(file, points, non_negative, "thickness");
  if ((flags & has_transparency) != 0) model.transparency = read_in_range(file, points, unit, "transparency");
  if ((flags & has_colour) != 0) {
    const std::uint64_t offset = file.offset();
    model.colour = file.read_vec3s(points, "colour");
    check_colours(file, model.colour, offset, "colour");
  }
  file.require_end();
  return model;
}

hair_model load_hair(const std::filesystem::path& path) {
  input_file file(path);
  return read_hair(file);
}

std::vector<std::byte> encode_hair(const hair_model& model) {
  constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
  if (model.strand_count() > most || model.points.size() > most) {
    throw std::invalid_argument("a .hair file cannot hold 2^32 strands or points");
  }
  std::vector<std::uint16_t> segments;
  segments.reserve(model.strand_count());
  for (std::size_t s = 0; s < model.strand_count(); ++s) {
    const std::uint32_t n = model.point_count(s);
    if (n == 0 || n > 65536) throw std::invalid_argument("a .hair strand has 1 to 65,536 points");
    segments.push_back(static_cast<std::uint16_t>(n - 1));
  }

  std::uint32_t flags = has_segments | has_points;
  if (!model.thickness.empty()) flags |= has_thickness;
  if (!model.transparency.empty()) flags |= has_transparency;
  if (!model.colour.empty()) flags |= has_colour;

  byte_writer out;
  out.put(std::array<char, 4>{'H', 'A', 'I', 'R'});
  out.put(std::array<std::uint32_t, 4>{static_cast<std::uint32_t>(model.strand_count()),
                                       static_cast<std::uint32_t>(model.points.size()), flags, 0U});
  out.put(std::array<float, 5>{model.default_thickness, model.default_transparency, model.default_colour.r,
                               model.default_colour.g, model.default_colour.b});
  out.put(std::array<char, info_size>{"written by Pelage"});
  out.put(segments);
  out.put(model.points);
  out.put(model.thickness);
  out.put(model.transparency);
  out.put(model.colour);
  return out.take();
}

void save_hair(const std::filesystem::path& path, const hair_model& model) {
  const std::vector<std::byte> bytes = encode_hair(model);
  write_file(path, bytes);
}

}  // namespace pelage::frame
