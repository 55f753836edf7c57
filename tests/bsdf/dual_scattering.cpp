// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/dual_scattering_table.hpp>
#include <bsdf/sphere.hpp>

#include <property.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace pelage;

namespace {

constexpr double pi = std::numbers::pi;
const dual_density<double> usual = {0.7, 0.7};

/// A fibre that sends a share of its light evenly to all directions.
struct even_fibre {
  double share;
  glm::dvec3 operator()(double, double, double) const { return glm::dvec3(share / (4.0 * pi)); }
};

chiang_fibre_model<double> hair_model(double sigma) {
  return {make_chiang_fibre<double>({1.55, {0.0, sigma, 4.0 * sigma}, 0.3, 0.3, 0.035})};
}

/// ∫ e dω of what dual_scattering() sends, all light of one channel.
template <class Function>
double energy_of(Function scattering) {
  return test::integrate(-1.55, 1.55, 60, [&](double theta) {
    double row = 0.0;
    for (int k = 0; k < 48; ++k) {
      row += scattering(theta, -pi + (k + 0.5) * 2.0 * pi / 48).y;
    }
    return row * std::cos(theta) * 2.0 * pi / 48;
  });
}

}  // namespace

TEST_CASE("an even fibre sends half of its share each way, without a shift") {
  const auto averages = average_fibre(even_fibre{0.6}, 0.0, 200u, 64u);
  CHECK(averages.forward.x == doctest::Approx(0.3).epsilon(1e-4));
  CHECK(averages.backward.x == doctest::Approx(0.3).epsilon(1e-4));
  CHECK(std::abs(averages.forward_shift.x) < 1e-12);
  // θ_r has density cos/2: its variance is π²/4 - 2, and θ_h is half of it.
  CHECK(averages.forward_variance.x == doctest::Approx((pi * pi / 4.0 - 2.0) / 4.0).epsilon(1e-3));
}

TEST_CASE("the averages of hair share out its energy: all of it where nothing is absorbed") {
  const auto averages = average_fibre(hair_model(0.5), 0.3, 96u, 96u);
  CHECK(averages.forward.x + averages.backward.x == doctest::Approx(1.0).epsilon(2e-3));
  CHECK(averages.forward.y + averages.backward.y < 0.8);
  CHECK(averages.forward.y > averages.forward.z);
  // TT dominates what goes on and is narrower than what turns back.
  CHECK(averages.forward.x > averages.backward.x);
  CHECK(averages.forward_variance.x < averages.backward_variance.x);
}

TEST_CASE("Marschner's model, taken in shares, has averages like Chiang's") {
  auto parameters = common_marschner_parameters<double>({0.0, 0.5, 2.0});
  const marschner_fibre_model<double> model = {parameters};
  const auto averages = average_fibre(model, 0.1, 120u, 120u);
  CHECK(averages.forward.x + averages.backward.x > 0.85);
  CHECK(averages.forward.x + averages.backward.x < 1.1);
  CHECK(averages.forward.y < averages.forward.x);
  // The tilt moves R by α = -0.12 and TT by +0.06.
  CHECK(averages.forward_shift.x > 0.02);
  CHECK(averages.forward_shift.x < 0.08);
}

TEST_CASE("the tilt shifts what turns back by its sign") {
  const auto shift = [](double tilt) {
    const chiang_fibre_model<double> model = {make_chiang_fibre<double>({1.55, {5.0, 5.0, 5.0}, 0.2, 0.3, tilt})};
    return average_fibre(model, 0.0, 96u, 64u).backward_shift.x;
  };
  // Absorption leaves R, whose θ_i + θ_o is 2α: θ_h is α.
  CHECK(shift(0.05) == doctest::Approx(0.05).epsilon(0.05));
  CHECK(shift(-0.05) == doctest::Approx(-0.05).epsilon(0.05));
}

TEST_CASE("local scattering is the sum over one and three turns back") {
  dual_averages<double> averages = {glm::dvec3(0.5),   glm::dvec3(0.3),  glm::dvec3(0.01),
                                    glm::dvec3(-0.02), glm::dvec3(0.04), glm::dvec3(0.09)};
  const auto local = dual_local_scattering(averages, usual);
  // Σ over the numbers of forward scatterings before each turn: a_b Σ a_f^2i and a_b³ Σ i(i+1)/2 a_f^2i.
  double one = 0.0;
  double three = 0.0;
  for (int i = 1; i < 200; ++i) {
    one += 0.3 * std::pow(0.5, 2 * i);
    three += 0.027 * 0.5 * i * (i + 1) * std::pow(0.5, 2 * i);
  }
  CHECK(local.albedo.x == doctest::Approx(one + three).epsilon(1e-12));
  const double lost = 0.75;
  CHECK(local.shift.x ==
        doctest::Approx(-0.02 * (1.0 - 0.18 / (lost * lost)) + 0.01 * (2.0 * lost * lost + 0.09) / (lost * lost * lost))
            .epsilon(1e-12));
  CHECK(local.variance.x > averages.backward_variance.x);
}

TEST_CASE("clear and black fibres have finite local scattering") {
  dual_averages<double> clear = {glm::dvec3(1.0), glm::dvec3(0.0),  glm::dvec3(0),
                                 glm::dvec3(0),   glm::dvec3(0.04), glm::dvec3(0.0)};
  CHECK(std::isfinite(dual_local_scattering(clear, usual).albedo.x));
  CHECK(std::isfinite(dual_local_scattering(clear, usual).variance.x));
  dual_averages<double> black = {};
  CHECK(dual_local_scattering(black, usual).albedo.x == 0.0);
  CHECK(dual_local_scattering(black, usual).variance.x == 0.0);
}

TEST_CASE("counted fibres are passed fibres") {
  const auto averages = average_fibre(hair_model(0.5), 0.1, 64u, 64u);
  auto traced = dual_unshadowed<double>();
  for (int fibres = 1; fibres <= 5; ++fibres) {
    traced = dual_pass_fibre(traced, averages, usual);
    const auto counted = dual_global_scattering(averages, usual, static_cast<double>(fibres), 0.0);
    CHECK(counted.direct == traced.direct);
    CHECK(counted.transmitted.y == doctest::Approx(traced.transmitted.y).epsilon(1e-12));
    CHECK(counted.variance.y == doctest::Approx(traced.variance.y).epsilon(1e-12));
  }
}

TEST_CASE("without fibres in front all light is direct; scattered light is what opaque fibres would have kept") {
  const auto averages = average_fibre(hair_model(0.5), 0.1, 64u, 64u);
  const auto open = dual_global_scattering(averages, usual, 0.0, 1.0);
  CHECK(open.direct == 1.0);
  CHECK(open.transmitted.x == 0.0);
  CHECK(open.variance.x == 0.0);
  test::holds("direct and scattered light never exceed all light, and more fibres leave less", [&](std::uint16_t n) {
    const double count = n / 1000.0;
    const auto global = dual_global_scattering(averages, usual, count, std::exp(-count));
    const auto deeper = dual_global_scattering(averages, usual, count + 1.0, std::exp(-count - 1.0));
    for (int c = 0; c < 3; ++c) {
      RC_ASSERT(global.transmitted[c] >= 0.0);
      RC_ASSERT(global.direct + global.transmitted[c] <= 1.0);
      RC_ASSERT(deeper.direct + deeper.transmitted[c] <= global.direct + global.transmitted[c] + 1e-12);
    }
  });
}

TEST_CASE("unshadowed, what leaves is one scattering and the light back from behind") {
  const auto averages = average_fibre(hair_model(0.5), 0.1, 64u, 64u);
  const auto local = dual_local_scattering(averages, usual);
  const double energy = energy_of([&](double theta, double phi) {
    return dual_scattering(averages, local, dual_unshadowed<double>(), usual, glm::dvec3(0.0), 0.1, theta, phi);
  });
  CHECK(energy == doctest::Approx(2.0 * usual.backward * local.albedo.y).epsilon(0.03));
}

TEST_CASE("behind fibres, what is scattered has the energy of the averages") {
  const auto averages = average_fibre(hair_model(0.5), 0.0, 64u, 64u);
  const auto local = dual_local_scattering(averages, usual);
  const auto global = dual_global_scattering(averages, usual, 2.0, 0.0);
  const double energy = energy_of([&](double theta, double phi) {
    return dual_scattering(averages, local, global, usual, glm::dvec3(9.0), 0.0, theta, phi);
  });
  const double expected =
      global.transmitted.y * (averages.forward.y + averages.backward.y + 2.0 * usual.backward * local.albedo.y);
  CHECK(energy == doctest::Approx(expected).epsilon(0.05));
}

TEST_CASE("azimuths have no edge, and light scattered on is largest straight on") {
  const auto averages = average_fibre(hair_model(0.5), 0.0, 64u, 64u);
  const auto local = dual_local_scattering(averages, usual);
  const auto global = dual_global_scattering(averages, usual, 3.0, 0.0);
  const auto at = [&](double phi) {
    return dual_scattering(averages, local, global, usual, glm::dvec3(0.0), 0.0, 0.05, phi).x;
  };
  for (int k = 0; k < 100; ++k) {
    CHECK(std::abs(at(k * pi / 100.0) - at((k + 1) * pi / 100.0)) < 0.05 * at(pi));
  }
  CHECK(at(pi) > 0.0);
}

TEST_CASE("a table looks up what it was filled with, between its entries and at its ends") {
  std::vector<dual_averages<double>> table(16);
  fill_dual_scattering_table(hair_model(0.5), std::span(table), 48u, 32u);
  const std::span<const dual_averages<double>> view(table);
  const double step = pi / 16.0;
  CHECK(look_up_dual_scattering(view, -pi / 2 + 2.5 * step).forward.y ==
        doctest::Approx(table[2].forward.y).epsilon(1e-12));
  CHECK(look_up_dual_scattering(view, -pi / 2 + 3.0 * step).backward.y ==
        doctest::Approx(0.5 * (table[2].backward.y + table[3].backward.y)).epsilon(1e-12));
  CHECK(look_up_dual_scattering(view, pi / 2).forward.x == table[15].forward.x);
  CHECK(look_up_dual_scattering(view, -pi / 2).forward.x == table[0].forward.x);
}

TEST_CASE("Marschner's model sends out more light than it takes, as much as is said") {
  const auto most_sent = [](double eta, double beta, double alpha) {
    marschner_fibre_model<double> model = {common_marschner_parameters<double>({0.0, 0.0, 0.0})};
    model.parameters.eta = eta;
    model.parameters.beta = beta;
    model.parameters.alpha = alpha;
    double most = 0.0;
    for (const double theta : {0.0, 0.5, 1.0, 1.1, 1.4}) {
      const auto averages = average_fibre<double>(model, theta, 200, 40);
      most = std::max(most, averages.forward[0] + averages.backward[0]);
    }
    return most;
  };
  CHECK(most_sent(1.55, 0.05, -0.17) == doctest::Approx(1.095).epsilon(0.01));
  CHECK(most_sent(1.55, 0.02, -0.17) < 1.11);
  CHECK(most_sent(1.8, 0.3, 0.0) > 0.87);
  CHECK(most_sent(1.2, 0.05, -0.17) < 1.24);
}
