// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/hair_file.hpp"

#include "frame/base/output_file.hpp"
#include "frame/draws.hpp"
#include "frame/file_bytes.hpp"
#include "property.hpp"

#include <bit>
#include <cstring>
#include <filesystem>
#include <limits>
#include <string>

using namespace pelage::frame;
using namespace pelage::test;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

hair_model any_model() {
  hair_model model;
  for (const int n : *rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 6))) {
    for (int i = 0; i < n; ++i)
      model.points.push_back(any_vec3(-1e6F, 1e6F));
    model.first_point.push_back(static_cast<std::uint32_t>(model.points.size()));
  }
  const std::size_t points = model.points.size();
  if (*rc::gen::arbitrary<bool>()) {
    for (std::size_t i = 0; i < points; ++i)
      model.thickness.push_back(any_float(0, 10));
  }
  if (*rc::gen::arbitrary<bool>()) {
    for (std::size_t i = 0; i < points; ++i)
      model.transparency.push_back(any_float(0, 1));
  }
  if (*rc::gen::arbitrary<bool>()) {
    for (std::size_t i = 0; i < points; ++i)
      model.colour.push_back(any_vec3(0, 2));
  }
  model.default_thickness = any_float(0, 10);
  model.default_transparency = any_float(0, 1);
  model.default_colour = any_vec3(0, 2);
  return model;
}

/// Two strands of 3 and 1 points with every array.
hair_model small_model() {
  hair_model model;
  model.points = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0.5F}, {1, 0, 0}};
  model.first_point = {0, 3, 4};
  model.thickness = {0.1F, 0.2F, 0.0F, 0.3F};
  model.transparency = {0.0F, 0.5F, 1.0F, 0.25F};
  model.colour = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 2, 2}};
  return model;
}

constexpr std::size_t segments_at = 128;
constexpr std::size_t points_at = segments_at + 2 * 2;
constexpr std::size_t thickness_at = points_at + 4 * 12;
constexpr std::size_t transparency_at = thickness_at + 4 * 4;
constexpr std::size_t colour_at = transparency_at + 4 * 4;
constexpr std::size_t small_size = colour_at + 4 * 12;

hair_model read(bytes file) {
  input_file input("x.hair", std::move(file));
  return read_hair(input);
}

bool same(const hair_model& a, const hair_model& b) {
  return a.points == b.points && a.first_point == b.first_point && a.thickness == b.thickness &&
         a.transparency == b.transparency && a.colour == b.colour && a.default_thickness == b.default_thickness &&
         a.default_transparency == b.default_transparency && a.default_colour == b.default_colour;
}

bool obeys_its_contract(const hair_model& model) {
  const auto length_fits = [&](std::size_t n) { return n == 0 || n == model.points.size(); };
  if (model.first_point.empty() || model.first_point.front() != 0) return false;
  if (model.first_point.back() != model.points.size()) return false;
  for (std::size_t s = 0; s < model.strand_count(); ++s) {
    if (model.first_point[s] > model.first_point[s + 1]) return false;
  }
  return length_fits(model.thickness.size()) && length_fits(model.transparency.size()) &&
         length_fits(model.colour.size());
}

void check_refused_at(const bytes& file, std::uint64_t offset) {
  pelage::test::check_refused_at(read, "hair", file, offset);
}

}  // namespace

TEST_CASE("a saved model loads as the same model") {
  const std::filesystem::path path = std::filesystem::temp_directory_path() / "pelage_round_trip.hair";
  save_hair(path, small_model());
  CHECK(same(load_hair(path), small_model()));
  std::filesystem::remove(path);

  holds("decoding undoes encoding", [] {
    const hair_model model = any_model();
    RC_ASSERT(same(read(encode_hair(model)), model));
  });
}

TEST_CASE("a strand without points or with too many cannot be encoded") {
  hair_model model = small_model();
  model.first_point = {0, 0, 4};
  CHECK_THROWS_AS(static_cast<void>(encode_hair(model)), std::invalid_argument);

  model = {};
  model.points.resize(65537);
  model.first_point = {0, 65537};
  CHECK_THROWS_AS(static_cast<void>(encode_hair(model)), std::invalid_argument);
  model.points.resize(65536);
  model.first_point = {0, 65536};
  CHECK(same(read(encode_hair(model)), model));
}

TEST_CASE("segments and bounds are those of the points") {
  const hair_model model = small_model();
  CHECK(model.strand_count() == 2);
  CHECK(model.segment_count() == 2);
  CHECK(model.bounds().lower == glm::vec3(0, 0, 0));
  CHECK(model.bounds().upper == glm::vec3(1, 2, 0.5F));
  CHECK(hair_model{}.segment_count() == 0);
  CHECK(hair_model{}.bounds().empty());
}

TEST_CASE("a file of no strands is an empty model") {
  const hair_model model = read(encode_hair(hair_model{}));
  CHECK(model.strand_count() == 0);
  CHECK(model.points.empty());
}

TEST_CASE("the default segment count stands in for absent segment counts") {
  bytes file = encode_hair(small_model());
  file.erase(file.begin() + segments_at, file.begin() + points_at);
  file = with(file, 12, std::uint32_t{30});
  file = with(file, 16, std::uint32_t{1});
  const hair_model model = read(file);
  CHECK(model.first_point == std::vector<std::uint32_t>{0, 2, 4});

  check_refused_at(with(file, 16, std::uint32_t{0}), 16);
  check_refused_at(with(file, 16, std::uint32_t{2}), 8);
  check_refused_at(with(file, 16, std::uint32_t{0xffffffff}), 16);
  check_refused_at(with(with(file, 4, std::uint32_t{0x80000000}), 16, std::uint32_t{1}), 8);
}

TEST_CASE("every truncation is refused within the bytes that are left") {
  const bytes file = encode_hair(small_model());
  REQUIRE(file.size() == small_size);
  check_truncations_refused(read, file);
}

TEST_CASE("bytes after the last array are refused") {
  bytes file = encode_hair(small_model());
  file.push_back(std::byte{0});
  check_refused_at(file, small_size);
}

TEST_CASE("every field that contradicts the file or its range is refused at its offset") {
  const bytes file = encode_hair(small_model());
  check_refused_at(with(file, 0, 'h'), 0);
  check_refused_at(with(file, 3, ' '), 0);
  check_refused_at(with(file, 4, std::uint32_t{1}), 8);
  check_refused_at(with(file, 4, std::uint32_t{3}), 8);
  check_refused_at(with(file, 4, std::uint32_t{0xffffffff}), segments_at);
  check_refused_at(with(file, 8, std::uint32_t{3}), 8);
  check_refused_at(with(file, 8, std::uint32_t{0xffffffff}), 8);
  check_refused_at(with(file, 12, std::uint32_t{31 | 32}), 12);
  check_refused_at(with(file, 12, std::uint32_t{0x8000001f}), 12);
  check_refused_at(with(file, 12, std::uint32_t{31 - 2}), 12);
  check_refused_at(with(file, 20, -0.5F), 20);
  check_refused_at(with(file, 20, not_a_number), 20);
  check_refused_at(with(file, 24, 1.5F), 24);
  check_refused_at(with(file, 24, -0.1F), 24);
  check_refused_at(with(file, 32, infinity), 32);
  check_refused_at(with(file, 36, -1.0F), 36);
  check_refused_at(with(file, segments_at, std::uint16_t{65535}), 8);
  check_refused_at(with(file, points_at + 16, not_a_number), points_at + 16);
  check_refused_at(with(file, points_at + 44, -infinity), points_at + 44);
  check_refused_at(with(file, thickness_at + 4, -0.1F), thickness_at + 4);
  check_refused_at(with(file, thickness_at + 8, infinity), thickness_at + 8);
  check_refused_at(with(file, transparency_at + 12, 1.01F), transparency_at + 12);
  check_refused_at(with(file, transparency_at, -0.01F), transparency_at);
  check_refused_at(with(file, colour_at + 8, -1.0F), colour_at + 8);
  check_refused_at(with(file, colour_at + 20, not_a_number), colour_at + 20);
}

TEST_CASE("flags that promise absent arrays, or leave arrays over, are refused") {
  const bytes file = encode_hair(small_model());
  for (const std::uint32_t bit : {1U, 4U, 8U, 16U}) {
    CHECK_THROWS_AS(static_cast<void>(read(with(file, 12, std::uint32_t{31} ^ bit))), input_error);
  }
  hair_model bare = small_model();
  bare.thickness.clear();
  bare.transparency.clear();
  bare.colour.clear();
  const bytes bare_file = encode_hair(bare);
  for (const std::uint32_t bit : {4U, 8U, 16U})
    check_refused_at(with(bare_file, 12, 3U | bit), thickness_at);
}

TEST_CASE("a flipped bit gives a valid model or an input error") {
  const bytes file = encode_hair(small_model());
  for (std::size_t bit = 0; bit < file.size() * 8; ++bit) {
    bytes flipped = file;
    flipped[bit / 8] ^= std::byte{1} << (bit % 8);
    try {
      const hair_model model = read(flipped);
      CHECK(obeys_its_contract(model));
    } catch (const input_error& error) {
      CHECK(error.offset <= file.size());
    }
  }
}

TEST_CASE("arbitrary bytes after the signature give a valid model or an input error") {
  holds("garbage is a model or refused", [](const std::vector<std::uint8_t>& tail) {
    bytes file = encode_hair(small_model());
    for (std::size_t i = 0; i < tail.size() && 4 + i < file.size(); ++i)
      file[4 + i] = std::byte{tail[i]};
    try {
      const hair_model model = read(file);
      RC_ASSERT(obeys_its_contract(model));
    } catch (const input_error& error) {
      RC_ASSERT(error.offset <= file.size());
    }
  });
}

TEST_CASE("a path that cannot be read is an input error on one line") {
  for (const char* path : {"/nonexistent/a\nb.hair", "/", "/dev/zero"}) {
    try {
      static_cast<void>(load_hair(path));
      FAIL_CHECK("the file was accepted");
    } catch (const input_error& error) {
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
      CHECK(std::string(error.what()).starts_with(printable(path) + ": offset 0: "));
    }
  }
}
