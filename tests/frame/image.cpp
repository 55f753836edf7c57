// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/image/image.hpp"

#include "frame/base/input_file.hpp"
#include "frame/base/output_file.hpp"
#include "frame/scratch_folder.hpp"
#include "property.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

using namespace pelage::frame;
using pelage::test::holds;
using pelage::test::scratch_folder;
namespace fs = std::filesystem;

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

image any_image() {
  image picture(*rc::gen::inRange(1, 9), *rc::gen::inRange(1, 9));
  for (glm::vec3& p : picture.pixels) {
    for (int c = 0; c < 3; ++c)
      p[c] = decode_srgb(*rc::gen::arbitrary<std::uint8_t>());
  }
  return picture;
}

double luminance(glm::vec3 c) {
  return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

}  // namespace

TEST_CASE("every 8-bit sRGB value survives decoding and encoding, and decoding rises") {
  for (int v = 0; v < 256; ++v) {
    const auto value = static_cast<std::uint8_t>(v);
    CHECK(encode_srgb(decode_srgb(value)) == value);
    if (v > 0) CHECK(decode_srgb(value) > decode_srgb(static_cast<std::uint8_t>(v - 1)));
  }
  CHECK(decode_srgb(0) == 0.0F);
  CHECK(decode_srgb(255) == 1.0F);
}

TEST_CASE("encoding rounds the sRGB transfer function to the nearest and clamps") {
  holds("encoding is nearest", [] {
    const float linear = static_cast<float>(*rc::gen::inRange(0, 1 << 24)) * 0x1p-24F;
    const double x = linear;
    const double exact = 255.0 * (x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055);
    RC_ASSERT(std::abs(exact - encode_srgb(linear)) < 0.5 + 1e-5);
  });
  CHECK(encode_srgb(-1.0F) == 0);
  CHECK(encode_srgb(-infinity) == 0);
  CHECK(encode_srgb(2.0F) == 255);
  CHECK(encode_srgb(infinity) == 255);
  CHECK(encode_srgb(not_a_number) == 0);
  CHECK(encode_srgb(0.5F) == 188);
}

TEST_CASE("a saved picture loads as the same picture and leaves nothing beside it") {
  const scratch_folder folder;
  const fs::path path = folder.path / "a.png";
  holds("loading undoes saving", [&] {
    const image picture = any_image();
    save_png(path, picture);
    const image loaded = load_png(path);
    RC_ASSERT(loaded.width == picture.width);
    RC_ASSERT(loaded.height == picture.height);
    RC_ASSERT(loaded.pixels == picture.pixels);
  });
  CHECK(folder.entries() == 1);
}

TEST_CASE("a picture that cannot be saved leaves no file, and an older file as it was") {
  const scratch_folder folder;
  const fs::path path = folder.path / "a.png";
  image bad(3, 2);
  bad.at(2, 1).g = not_a_number;
  CHECK_THROWS_WITH_AS(save_png(path, bad), (path.string() + ": pixel 2, 1 is not finite").c_str(), std::runtime_error);
  CHECK_THROWS_AS(save_png(path, image()), std::runtime_error);
  CHECK(folder.entries() == 0);

  save_png(path, image(2, 2, glm::vec3(1.0F)));
  CHECK_THROWS_AS(save_png(path / "b.png", image(1, 1)), std::runtime_error);
  bad.at(2, 1).g = infinity;
  CHECK_THROWS_AS(save_png(path, bad), std::runtime_error);
  CHECK(load_png(path).pixels.front() == glm::vec3(1.0F));
  CHECK(folder.entries() == 1);

  CHECK_THROWS_AS(save_png(folder.path, image(1, 1)), std::runtime_error);
  CHECK_THROWS_AS(save_png("/dev/null", image(1, 1)), std::runtime_error);
  CHECK(fs::is_character_file("/dev/null"));
}

TEST_CASE("every truncation of a PNG is refused") {
  const scratch_folder folder;
  const fs::path path = folder.path / "a.png";
  image picture(5, 4, glm::vec3(0.25F));
  picture.at(1, 1) = glm::vec3(1.0F);
  save_png(path, picture);
  const input_file file(path);
  const std::size_t size = file.bytes().size();
  for (std::size_t length = 0; length < size; ++length) {
    CAPTURE(length);
    write_file(folder.path / "b.png", file.bytes().first(length));
    CHECK_THROWS_AS(static_cast<void>(load_png(folder.path / "b.png")), input_error);
  }
}

TEST_CASE("a PNG that claims more pixels than its bytes can hold is refused") {
  const scratch_folder folder;
  const fs::path path = folder.path / "a.png";
  save_png(path, image(2, 2));
  const input_file file(path);
  std::vector<std::byte> bytes(file.bytes().begin(), file.bytes().end());
  bytes[17] = std::byte{0x80};
  bytes[21] = std::byte{0x80};
  write_file(path, bytes);
  CHECK_THROWS_AS(static_cast<void>(load_png(path)), input_error);
}

TEST_CASE("comparing gives zero for the same picture, is symmetric, and rms is at most the maximum") {
  holds("comparing is a distance", [] {
    const image a = any_image();
    image b = a;
    for (glm::vec3& p : b.pixels) {
      for (int c = 0; c < 3; ++c)
        p[c] = decode_srgb(*rc::gen::arbitrary<std::uint8_t>());
    }
    const image_difference none = compare(a, a);
    RC_ASSERT(none.rms == 0.0 && none.maximum == 0.0);
    const image_difference ab = compare(a, b);
    const image_difference ba = compare(b, a);
    RC_ASSERT(ab.rms == ba.rms && ab.maximum == ba.maximum);
    RC_ASSERT(ab.rms <= ab.maximum + 1e-12);
    RC_ASSERT(ab.maximum <= 1.0);
  });
}

TEST_CASE("comparing gives the known difference of known pictures") {
  const image black(2, 1);
  image other(2, 1);
  other.at(1, 0) = glm::vec3(1.0F, 0.0F, 0.0F);
  const image_difference d = compare(black, other);
  CHECK(d.maximum == 1.0);
  CHECK(d.rms == doctest::Approx(std::sqrt(1.0 / 6.0)));
  CHECK(compare(image(), image()).rms == 0.0);

  other.at(0, 0).r = not_a_number;
  CHECK_THROWS_AS(static_cast<void>(compare(black, other)), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(compare(black, image(1, 2))), std::invalid_argument);
}

TEST_CASE("an error map is black where pictures agree, white at full scale, and its ramp rises in luminance") {
  const image black(2, 1);
  image other(2, 1);
  other.at(1, 0).g = decode_srgb(51);
  const image map = error_map(black, other, 0.2);
  CHECK(map.at(0, 0) == glm::vec3(0.0F));
  CHECK(map.at(1, 0) == glm::vec3(1.0F));
  for (int i = 1; i <= 1000; ++i) {
    CHECK(luminance(error_colour(i * 0.001)) > luminance(error_colour((i - 1) * 0.001)));
  }
  CHECK(error_colour(7.0) == glm::vec3(1.0F));
  CHECK(error_colour(-1.0) == glm::vec3(0.0F));
  CHECK(error_colour(std::nan("")) == glm::vec3(0.0F));
  CHECK_THROWS_AS(static_cast<void>(error_map(black, other, 0.0)), std::invalid_argument);
  CHECK_THROWS_AS(static_cast<void>(error_map(black, other, std::nan(""))), std::invalid_argument);
}
