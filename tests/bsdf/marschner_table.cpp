// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/marschner_table.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "property.hpp"

using namespace pelage;

namespace {

/// A table with its storage.
struct stored_table {
  stored_table(const marschner_parameters<float>& parameters, std::uint32_t thetas, std::uint32_t phis)
      : r(thetas * phis), tt(thetas * phis), trt(thetas * phis), table{thetas, phis, r, tt, trt} {
    fill_marschner_table(parameters, table);
  }
  std::vector<glm::vec3> r, tt, trt;
  marschner_table<float> table;
};

marschner_parameters<float> hair() {
  return common_marschner_parameters<float>({0.1f, 0.4f, 1.0f});
}

/// The largest difference of each lobe, in parts of its greatest value, for θ_d from 0 to `end`.
std::array<float, 3> worst_errors(std::uint32_t thetas, std::uint32_t phis, float end = 1.2f, float sigma = 0.1f) {
  const auto parameters = common_marschner_parameters<float>({sigma, 0.4f, 1.0f});
  const stored_table stored(parameters, thetas, phis);
  std::array<float, 3> worst = {0.0f, 0.0f, 0.0f};
  std::array<float, 3> greatest = {0.0f, 0.0f, 0.0f};
  for (int i = 0; i <= 240; ++i) {
    const float theta = end * static_cast<float>(i) / 240.0f;
    const auto section = make_fibre_section(parameters.eta, theta);
    for (int k = 0; k <= 1500; ++k) {
      const float phi = 3.14159265f * static_cast<float>(k) / 1500.0f;
      const auto found = look_up_marschner(stored.table, std::sin(theta), phi);
      const std::array<float, 3> exact = {bare_azimuthal(section, 0, phi, parameters.sigma_a)[0],
                                          bare_azimuthal(section, 1, phi, parameters.sigma_a)[0],
                                          smooth_trt(section, phi, parameters.sigma_a, parameters.caustic)[0]};
      const std::array<float, 3> looked_up = {found.reflected.x, found.transmitted.x, found.returned.x};
      for (std::size_t p = 0; p < 3; ++p) {
        worst[p] = std::max(worst[p], std::abs(exact[p] - looked_up[p]));
        greatest[p] = std::max(greatest[p], exact[p]);
      }
    }
  }
  return {worst[0] / greatest[0], worst[1] / greatest[1], worst[2] / greatest[2]};
}

}  // namespace

TEST_CASE("a table of 64 × 256 is within the stated error, and a finer one is better") {
  const std::array<float, 3> coarse = worst_errors(64, 256);
  MESSAGE("largest errors by the lobe's peak: R ", coarse[0], ", TT ", coarse[1], ", TRT ", coarse[2]);
  CHECK(coarse[0] < 0.006f);
  CHECK(coarse[1] < 0.002f);
  CHECK(coarse[2] < 0.04f);
  for (const float sigma : {0.0f, 5.0f}) {
    const std::array<float, 3> worst = worst_errors(64, 256, 1.2f, sigma);
    CHECK((worst[0] < 0.006f && worst[1] < 0.002f && worst[2] < 0.04f));
  }
  const std::array<float, 3> grazing = worst_errors(64, 256, 1.5707f, 0.0f);
  CHECK((grazing[0] < 0.25f && grazing[1] < 0.03f && grazing[2] < 0.12f));
  const std::array<float, 3> coarser = worst_errors(16, 64);
  for (std::size_t p = 0; p < 3; ++p) {
    CHECK(coarser[p] > 1.5f * coarse[p]);
  }
}

TEST_CASE("at the table's own points the look-up is exact, in every channel") {
  const auto parameters = hair();
  const stored_table stored(parameters, 8, 16);
  const auto section = make_fibre_section(parameters.eta, angle_of_sine(3.0f / 7.0f));
  const float phi = 3.14159265f * 5.0f / 15.0f;
  const auto found = look_up_marschner(stored.table, 3.0f / 7.0f, phi);
  const auto expected = bare_azimuthal(section, 0, phi, parameters.sigma_a);
  CHECK(found.reflected.z == doctest::Approx(expected[2]).epsilon(1e-5));
}

TEST_CASE("both axes are even and held at their ends") {
  const stored_table stored(hair(), 16, 32);
  const auto a = look_up_marschner(stored.table, 0.3f, 0.2f);
  const auto b = look_up_marschner(stored.table, -0.3f, -0.2f);
  CHECK(a.returned == b.returned);
  const auto end = look_up_marschner(stored.table, 1.0f, 3.1415927f);
  const auto beyond = look_up_marschner(stored.table, 1.5f, 4.0f);
  CHECK(end.reflected == beyond.reflected);
}

TEST_CASE("a place's weights are a mean over neighbours, whose own place is the place asked for") {
  pelage::test::holds("a place in a table", [] {
    const auto drawn = [](int least, int end) {
      return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, end));
    };
    const auto thetas = static_cast<std::uint32_t>(drawn(2, 4097));
    const auto phis = static_cast<std::uint32_t>(drawn(2, 4097));
    const float sine = static_cast<float>(drawn(-1200000, 1200001)) * 1e-6f;
    const float phi = static_cast<float>(drawn(-3500000, 3500001)) * 1e-6f;
    const auto place = marschner_table_place_of(sine, phi, thetas, phis);
    double sum = 0.0, row = 0.0, column = 0.0;
    for (std::size_t corner = 0; corner < 4; ++corner) {
      RC_ASSERT(place.weight[corner] >= 0.0f && place.entry[corner] < thetas * phis);
      RC_ASSERT(place.entry[corner] == place.entry[0] + corner % 2 + corner / 2 * phis);
      RC_ASSERT(place.entry[corner] % phis >= corner % 2);
      const double weight = place.weight[corner];
      sum += weight;
      row += weight * (place.entry[corner] / phis);
      column += weight * (place.entry[corner] % phis);
    }
    RC_ASSERT(std::abs(sum - 1.0) < 1e-6);
    const double last_row = thetas - 1u, last_column = phis - 1u;
    RC_ASSERT(std::abs(row - std::min(std::abs(double{sine}), 1.0) * last_row) < 1e-6 * (1.0 + last_row));
    const double turn = std::abs(double{phi}) / std::numbers::pi;
    RC_ASSERT(std::abs(column - std::min(turn, 1.0) * last_column) < 1e-6 * (1.0 + last_column));
  });
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(marschner_table_place_of(nan, nan, 5u, 7u).weight[3] == 1.0f);
  CHECK(marschner_table_place_of(nan, nan, 5u, 7u).entry[3] == 34u);
}

TEST_CASE("texture coordinates put the ends on the first and the last texel's middle") {
  CHECK(table_coordinate(0.0, 64u) == 0.5 / 64.0);
  CHECK(table_coordinate(1.0, 64u) == 63.5 / 64.0);
  CHECK(table_coordinate(2.0, 64u) == 63.5 / 64.0);
  CHECK(table_coordinate(0.5, 3u) == 0.5);
}
