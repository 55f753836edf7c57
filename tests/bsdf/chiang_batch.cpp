// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/chiang_batch.hpp>
#include <bsdf/sphere.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cstddef>
#include <random>
#include <span>
#include <vector>

using namespace pelage;

namespace {

using column = std::vector<float>;

/// Random elements with the results' room, each result filled with a mark.
struct elements {
  explicit elements(std::size_t count) {
    std::mt19937 generator(static_cast<std::uint32_t>(count) + 1u);
    std::uniform_real_distribution<float> draw(0.0f, 1.0f);
    const auto fill = [&](column& all, float low, float high) {
      all.resize(count);
      for (float& x : all) {
        x = low + (high - low) * draw(generator);
      }
    };
    fill(h, -1.0f, 1.0f);
    fill(eta, 1.3f, 1.8f);
    fill(beta_m, 0.0f, 1.0f);
    fill(beta_n, 0.0f, 1.0f);
    fill(tilt, -0.17f, 0.17f);
    for (std::size_t c = 0; c < 3; ++c) {
      fill(sigma[c], 0.0f, 3.0f);
      eye[c].resize(count);
      light[c].resize(count);
      value[c].assign(count, -1.0f);
    }
    density.assign(count, -1.0f);
    for (std::size_t k = 0; k < count; ++k) {
      const glm::vec3 a = test::unit_vector<float>(3.1 * static_cast<double>(draw(generator)) - 1.55, 6.0 * h[k]);
      const glm::vec3 b = test::unit_vector<float>(3.1 * static_cast<double>(draw(generator)) - 1.55, 6.0 * eta[k]);
      for (int c = 0; c < 3; ++c) {
        eye[static_cast<std::size_t>(c)][k] = a[c];
        light[static_cast<std::size_t>(c)][k] = b[c];
      }
    }
  }

  [[nodiscard]] chiang_batch batch() const { return {h, {eye[0], eye[1], eye[2]}, {light[0], light[1], light[2]}}; }
  [[nodiscard]] chiang_batch_parameters parameters() const {
    return {eta, {sigma[0], sigma[1], sigma[2]}, beta_m, beta_n, tilt};
  }
  [[nodiscard]] chiang_batch_result result() { return {{value[0], value[1], value[2]}, density}; }

  [[nodiscard]] chiang_parameters<float> parameters_of(std::size_t k) const {
    return {eta[k], {sigma[0][k], sigma[1][k], sigma[2][k]}, beta_m[k], beta_n[k], tilt[k]};
  }

  /// True if element k holds the bits that the kernel gives.
  [[nodiscard]] bool as_kernel(const chiang_fibre<float>& fibre, std::size_t k) const {
    const auto view = view_chiang(fibre, h[k], fibre_direction_of(eye[0][k], eye[1][k], eye[2][k]));
    const auto expected = evaluate_chiang(fibre, view, fibre_direction_of(light[0][k], light[1][k], light[2][k]));
    return expected.value == glm::vec3(value[0][k], value[1][k], value[2][k]) && expected.density == density[k];
  }

  column h, eta, beta_m, beta_n, tilt, density;
  std::array<column, 3> sigma, eye, light, value;
};

}  // namespace

TEST_CASE_TEMPLATE("every element of a batch has the kernel's bits, at every length", Width,
                   std::integral_constant<int, 4>, std::integral_constant<int, 8>, std::integral_constant<int, 16>) {
  for (const std::size_t count : {0u, 1u, 3u, 4u, 5u, 15u, 16u, 17u, 64u, 1000u}) {
    elements all(count);
    evaluate_chiang_batch<Width::value>(all.parameters(), all.batch(), all.result());
    std::size_t right = 0;
    for (std::size_t k = 0; k < count; ++k) {
      right += all.as_kernel(make_chiang_fibre(all.parameters_of(k)), k) ? 1 : 0;
    }
    CHECK(right == count);
  }
}

TEST_CASE("one fibre for all gives the same as that fibre for each") {
  elements all(333);
  auto fibre = make_chiang_fibre<float>({1.55f, {0.1f, 0.4f, 0.9f}, 0.3f, 0.25f, 0.05f});
  fibre.tints = {1.0f, 0.5f, 0.7f, 0.0f};
  evaluate_chiang_batch(fibre, all.batch(), all.result());
  std::size_t right = 0;
  for (std::size_t k = 0; k < 333; ++k) {
    right += all.as_kernel(fibre, k) ? 1 : 0;
  }
  CHECK(right == 333);
}

TEST_CASE("nothing is written past the end") {
  elements all(21);
  chiang_batch batch = all.batch();
  chiang_batch_result result = all.result();
  const auto shorten = [](auto& span) { span = span.first(18); };
  shorten(batch.h);
  shorten(result.density);
  for (std::size_t c = 0; c < 3; ++c) {
    shorten(batch.eye[c]);
    shorten(batch.light[c]);
    shorten(result.value[c]);
  }
  evaluate_chiang_batch<16>(make_chiang_fibre(all.parameters_of(0)), batch, result);
  CHECK(all.density[17] >= 0.0f);
  for (std::size_t k = 18; k < 21; ++k) {
    CHECK(all.density[k] == -1.0f);
    CHECK(all.value[2][k] == -1.0f);
  }
}
