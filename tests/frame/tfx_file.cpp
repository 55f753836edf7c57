// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/tfx_file.hpp"

#include "frame/file_bytes.hpp"
#include "frame/model/follow_strands.hpp"
#include "property.hpp"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string>

using namespace pelage::frame;
using namespace pelage::test;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

template <class T>
void append(bytes& file, T value) {
  const auto* p = reinterpret_cast<const std::byte*>(&value);
  file.insert(file.end(), p, p + sizeof(T));
}

constexpr std::uint32_t strands = 3;
constexpr std::uint32_t vertices = 4;
constexpr std::uint32_t points = strands * vertices;
constexpr std::uint32_t positions_at = 160;
constexpr std::uint32_t strand_uv_at = positions_at + points * 16;
constexpr std::uint32_t vertex_uv_at = strand_uv_at + strands * 8;
constexpr std::uint32_t thickness_at = vertex_uv_at + points * 8;
constexpr std::uint32_t colours_at = thickness_at + strands * 4 + 4;  // aligned to 8
constexpr std::uint32_t file_size = colours_at + points * 16;

glm::vec3 position(std::uint32_t i) {
  return {static_cast<float>(i / vertices), static_cast<float>(i % vertices), 0.5F};
}

/// Three strands of four vertices with every array.
bytes full_file() {
  bytes file;
  append(file, 4.0F);
  for (const std::uint32_t field :
       {strands, vertices, positions_at, strand_uv_at, vertex_uv_at, thickness_at, colours_at}) {
    append(file, field);
  }
  for (int i = 0; i < 32; ++i)
    append(file, std::uint32_t{0});
  for (std::uint32_t i = 0; i < points; ++i)
    append(file, glm::vec4(position(i), i % vertices == 0 ? 0.0F : 1.0F));
  for (std::uint32_t i = 0; i < strands; ++i)
    append(file, glm::vec2(0.5F));
  for (std::uint32_t i = 0; i < points; ++i)
    append(file, glm::vec2(0.25F));
  for (std::uint32_t i = 0; i < strands; ++i)
    append(file, 0.1F * static_cast<float>(i));
  append(file, std::uint32_t{0});
  for (std::uint32_t i = 0; i < points; ++i)
    append(file, glm::vec4(0.1F, 0.2F, 0.3F, 0.75F));
  return file;
}

hair_model read(bytes file) {
  input_file input("x.tfx", std::move(file));
  return read_tfx(input);
}

void check_refused_at(const bytes& file, std::uint64_t offset) {
  pelage::test::check_refused_at(read, "tfx", file, offset);
}

float distance_to_segment(glm::vec3 p, glm::vec3 a, glm::vec3 b) {
  const glm::vec3 d = b - a;
  const float squared = glm::dot(d, d);
  const float t = squared > 0.0F ? std::clamp(glm::dot(p - a, d) / squared, 0.0F, 1.0F) : 0.0F;
  return glm::length(p - a - d * t);
}

}  // namespace

TEST_CASE("a file with every array gives all that a model holds") {
  REQUIRE(full_file().size() == file_size);
  const hair_model model = read(full_file());
  CHECK(model.first_point == std::vector<std::uint32_t>{0, 4, 8, 12});
  CHECK(model.segment_count() == 9);
  for (std::uint32_t i = 0; i < points; ++i) {
    CHECK(model.points[i] == position(i));
    CHECK(model.thickness[i] == 0.1F * static_cast<float>(i / vertices));
    CHECK(model.transparency[i] == 0.25F);
    CHECK(model.colour[i] == glm::vec3(0.1F, 0.2F, 0.3F));
  }
}

TEST_CASE("a file with positions alone falls back on defaults") {
  bytes file = full_file();
  file.resize(strand_uv_at);
  for (std::size_t field = 16; field < 32; field += 4)
    file = with(file, field, std::uint32_t{0});
  const hair_model model = read(file);
  CHECK(model.points.size() == points);
  CHECK(model.thickness.empty());
  CHECK(model.transparency.empty());
  CHECK(model.colour.empty());
  CHECK(model.default_thickness == doctest::Approx(std::sqrt(13.0) / 2000.0));
}

TEST_CASE("a file of no strands is an empty model") {
  bytes file = full_file();
  file.resize(160);
  for (std::size_t field = 4; field < 32; field += 4)
    file = with(file, field, std::uint32_t{0});
  CHECK(read(file).strand_count() == 0);
}

TEST_CASE("every truncation is refused within the bytes that are left") {
  const bytes file = full_file();
  check_truncations_refused(read, file);
}

TEST_CASE("every field that contradicts the file or its range is refused at its offset") {
  const bytes file = full_file();
  check_refused_at(with(file, 0, 3.0F), 0);
  check_refused_at(with(file, 0, not_a_number), 0);
  check_refused_at(with(file, 4, std::uint32_t{2}), strand_uv_at - 64);
  check_refused_at(with(file, 4, std::uint32_t{4}), colours_at);
  check_refused_at(with(file, 4, std::uint32_t{0xffffffff}), 4);
  check_refused_at(with(file, 4, std::uint32_t{0x20000000}), positions_at);
  check_refused_at(with(file, 8, std::uint32_t{0}), 8);
  check_refused_at(with(file, 8, std::uint32_t{5}), colours_at);
  check_refused_at(with(file, 12, std::uint32_t{0}), 12);
  check_refused_at(with(file, 12, std::uint32_t{152}), 12);
  check_refused_at(with(file, 12, std::uint32_t{164}), 12);
  check_refused_at(with(file, 12, std::uint32_t{0xfffffff8}), 12);
  check_refused_at(with(file, 16, positions_at), 16);
  check_refused_at(with(file, 16, strand_uv_at - 8), 16);
  check_refused_at(with(file, 16, std::uint32_t{0}), strand_uv_at);
  check_refused_at(with(file, 28, std::uint32_t{0}), thickness_at + 12);
  check_refused_at(with(file, positions_at + 20, not_a_number), positions_at + 20);
  check_refused_at(with(file, positions_at + 12, not_a_number), positions_at + 12);
  check_refused_at(with(file, strand_uv_at + 4, not_a_number), strand_uv_at + 4);
  check_refused_at(with(file, vertex_uv_at, not_a_number), vertex_uv_at);
  check_refused_at(with(file, thickness_at + 8, -1.0F), thickness_at + 8);
  check_refused_at(with(file, colours_at + 16, -1.0F), colours_at + 16);
  check_refused_at(with(file, colours_at + 12, 1.5F), colours_at + 12);
}

TEST_CASE("bytes that belong to no array are refused, padding to 8 is not") {
  bytes file = full_file();
  file.resize(file.size() + 7);
  CHECK(read(file).points.size() == points);
  file.push_back(std::byte{0});
  check_refused_at(file, file_size);
}

TEST_CASE("a flipped bit gives a valid model or an input error") {
  const bytes file = full_file();
  for (std::size_t bit = 0; bit < file.size() * 8; ++bit) {
    bytes flipped = file;
    flipped[bit / 8] ^= std::byte{1} << (bit % 8);
    try {
      const hair_model model = read(flipped);
      CHECK(model.first_point.back() == model.points.size());
    } catch (const input_error& error) {
      CHECK(error.offset <= 0xffffffffU);
    }
  }
}

TEST_CASE("follow strands keep within the radius of their guide and have its points and attributes") {
  const hair_model guides = read(full_file());
  holds("followers stay near", [&](std::uint64_t seed) {
    const auto n = *rc::gen::inRange<std::uint32_t>(0, 9);
    const float radius = static_cast<float>(*rc::gen::inRange(0, 100)) * 0.01F;
    const hair_model model = add_follow_strands(guides, n, radius, seed);
    RC_ASSERT(model.strand_count() == strands * (n + 1));
    RC_ASSERT(model.segment_count() == guides.segment_count() * (n + 1));
    for (std::size_t s = 0; s < model.strand_count(); ++s) {
      const std::size_t guide = guides.first_point[s / (n + 1)];
      for (std::uint32_t i = 0; i < vertices; ++i) {
        const std::size_t p = model.first_point[s] + i;
        float nearest = std::numeric_limits<float>::max();
        for (std::uint32_t k = 0; k + 1 < vertices; ++k) {
          nearest = std::min(
              nearest, distance_to_segment(model.points[p], guides.points[guide + k], guides.points[guide + k + 1]));
        }
        RC_ASSERT(nearest <= radius + 1e-5F);
        if (s % (n + 1) == 0) RC_ASSERT(model.points[p] == guides.points[guide + i]);
        RC_ASSERT(model.thickness[p] == guides.thickness[guide + i]);
        RC_ASSERT(model.colour[p] == guides.colour[guide + i]);
      }
    }
    RC_ASSERT(add_follow_strands(guides, n, radius, seed).points == model.points);
  });
}

TEST_CASE("follow strands of degenerate guides are finite and their points counted") {
  hair_model guides;
  guides.points = {{0, 0, 0}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {0, 0, 0}, {0, 1, 0}, {0, 0, 0}};
  guides.first_point = {0, 0, 1, 4, 7};
  const hair_model model = add_follow_strands(guides, 3, 0.5F, 9);
  CHECK(model.strand_count() == 16);
  CHECK(model.points.size() == 28);
  for (const glm::vec3& p : model.points)
    CHECK(glm::length(p) < 3.0F);
  for (std::size_t i = 0; i < 4; ++i)
    CHECK(model.points[i] == glm::vec3(0.0F));
}

TEST_CASE("follow strands refuse a radius out of range and more points than an index can name") {
  const hair_model guides = read(full_file());
  CHECK_THROWS_AS(static_cast<void>(add_follow_strands(guides, 1, -1.0F, 0)), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(add_follow_strands(guides, 1, not_a_number, 0)), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(add_follow_strands(guides, 0xffffffff, 1.0F, 0)), std::length_error);
}
