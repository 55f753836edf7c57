// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/tfx_file.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace pelage::frame {

namespace {

constexpr std::uint64_t header_size = 160;
constexpr std::uint64_t alignment = 8;

struct array_extent {
  std::string what;
  std::uint64_t header_offset;  ///< of the field that places it
  std::uint64_t begin;
  std::uint64_t end;
};

/// Arrays of the file with the field that places each; checks that together they cover it.
class layout {
 public:
  /// Fails unless the array starts after the header, aligned, and ends within the file.
  void add(input_file& file, const char* what, std::uint64_t header_offset, std::uint64_t begin, std::uint64_t count,
           std::uint64_t element_size) {
    const std::string name = what;
    if (begin < header_size) file.fail(header_offset, name + " would overlap the header");
    if (begin % alignment != 0) file.fail(header_offset, "offset of " + name + " is not a multiple of 8");
    if (begin > file.size()) file.fail(header_offset, name + " would begin past the end of the file");
    file.seek(begin, name);
    file.require(count, element_size, name);
    extents_.push_back({name, header_offset, begin, begin + count * element_size});
  }

  void check(const input_file& file) {
    std::stable_sort(extents_.begin(), extents_.end(),
                     [](const array_extent& a, const array_extent& b) { return a.begin < b.begin; });
    std::uint64_t end = header_size;
    for (const array_extent& e : extents_) {
      if (e.begin < end) file.fail(e.header_offset, e.what + " would overlap another array");
      if (e.begin - end >= alignment) file.fail(end, "bytes that belong to no array");
      end = e.end;
    }
    if (file.size() - end >= alignment) file.fail(end, "bytes that belong to no array");
  }

 private:
  std::vector<array_extent> extents_;
};

void read_positions(input_file& file, hair_model& model, std::uint64_t begin, std::uint64_t count) {
  file.seek(begin, "positions");
  const std::vector<glm::vec4> positions = file.read_vec4s(count, "position");
  model.points.reserve(positions.size());
  for (const glm::vec4& p : positions)
    model.points.emplace_back(p);
}

void read_thickness(input_file& file, hair_model& model, std::uint64_t begin, std::uint32_t strands,
                    std::uint32_t vertices) {
  file.seek(begin, "strand thickness");
  const std::vector<float> thickness = file.read_floats(strands, "strand thickness");
  model.thickness.reserve(model.points.size());
  for (std::size_t s = 0; s < thickness.size(); ++s) {
    if (thickness[s] < 0.0F) file.fail(begin + s * sizeof(float), "strand thickness is negative");
    model.thickness.insert(model.thickness.end(), vertices, thickness[s]);
  }
}

void read_colours(input_file& file, hair_model& model, std::uint64_t begin, std::uint64_t count) {
  file.seek(begin, "vertex colours");
  const std::vector<glm::vec4> colours = file.read_vec4s(count, "vertex colour");
  model.colour.reserve(colours.size());
  model.transparency.reserve(colours.size());
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const glm::vec4 c = colours[i];
    const std::uint64_t offset = begin + i * sizeof(glm::vec4);
    for (int k = 0; k < 4; ++k) {
      const std::uint64_t at = offset + static_cast<std::uint64_t>(k) * sizeof(float);
      if (c[k] < 0.0F) file.fail(at, "vertex colour is negative");
      if (k == 3 && c[k] > 1.0F) file.fail(at, "alpha of a vertex colour is above 1");
    }
    model.colour.emplace_back(c);
    model.transparency.push_back(1.0F - c.a);
  }
}

}  // namespace

hair_model read_tfx(input_file& file) {
  enum : std::size_t { position, strand_uv, vertex_uv, strand_thickness, vertex_colour, array_count };
  constexpr std::uint64_t strand_count_field = 4;
  constexpr std::uint64_t vertex_count_field = 8;
  constexpr std::uint64_t first_offset_field = 12;

  file.require(header_size, 1, "the .tfx header");
  if (file.read_float("version") != 4.0F) file.fail(0, "not a .tfx file of version 4.0");
  const std::uint32_t strands = file.read_u32("strand count");
  const std::uint32_t vertices = file.read_u32("vertices per strand");
  std::array<std::uint32_t, array_count> begin{};
  for (std::uint32_t& b : begin)
    b = file.read_u32("array offset");

  const std::uint64_t points = std::uint64_t{strands} * vertices;
  if (strands > 0 && vertices == 0) file.fail(vertex_count_field, "strands of 0 vertices");
  if (points > std::numeric_limits<std::uint32_t>::max()) file.fail(strand_count_field, "too many vertices");
  if (begin[position] == 0 && points > 0) file.fail(first_offset_field, "the file has no positions");

  constexpr std::array<const char*, array_count> names{
      "positions", "strand texture coordinates", "vertex texture coordinates", "strand thickness", "vertex colours"};
  constexpr std::array<std::uint64_t, array_count> element_sizes{16, 8, 8, 4, 16};
  const std::array<std::uint64_t, array_count> counts{points, strands, points, strands, points};
  layout arrays;
  for (std::size_t i = 0; i < array_count; ++i) {
    if (begin[i] != 0) {
      arrays.add(file, names[i], first_offset_field + 4 * i, begin[i], counts[i], element_sizes[i]);
    }
  }
  arrays.check(file);

  hair_model model;
  read_positions(file, model, begin[position], points);
  model.first_point.reserve(std::size_t{strands} + 1);
  for (std::uint32_t s = 1; s <= strands && points > 0; ++s)
    model.first_point.push_back(s * vertices);

  if (begin[strand_uv] != 0) {
    file.seek(begin[strand_uv], names[strand_uv]);
    static_cast<void>(file.read_floats(std::uint64_t{strands} * 2, "strand texture coordinate"));
  }
  if (begin[vertex_uv] != 0) {
    file.seek(begin[vertex_uv], names[vertex_uv]);
    static_cast<void>(file.read_floats(points * 2, "vertex texture coordinate"));
  }
  if (begin[strand_thickness] != 0) read_thickness(file, model, begin[strand_thickness], strands, vertices);
  if (begin[vertex_colour] != 0) read_colours(file, model, begin[vertex_colour], points);

  const box b = model.bounds();
  // In double: the square of a diagonal, and for points far enough apart the diagonal itself, is no float.
  if (!b.empty()) {
    model.default_thickness = static_cast<float>(glm::length(glm::dvec3(b.upper) - glm::dvec3(b.lower)) / 2000.0);
  }
  return model;
}

hair_model load_tfx(const std::filesystem::path& path) {
  input_file file(path);
  return read_tfx(file);
}

}  // namespace pelage::frame
