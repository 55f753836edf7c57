// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/marschner_table.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "bsdf/sphere.hpp"
#include "glsl/double_comparison.hpp"
#include "glsl/kernels.hpp"
#include "property.hpp"

namespace pelage::test {

namespace {

using words = rc::Gen<std::uint32_t>;

/// Whether a sum over a path's roots has float's precision: as the header says, |dφ/dh| ≥ 0.2 at each, and none about
/// to appear, at the caustic or at the fibre's edge.
bool well_conditioned(const fibre_section<double>& section, int path, double phi) {
  const scattering_roots<double> roots = find_scattering_roots(path, phi, section.excess);
  for (std::uint32_t k = 0; k < roots.count; ++k) {
    const scattering_root<double>& root = roots.root[k];
    if (2.0 * std::abs(root.slope) < 0.2 * root.cosine || root.cosine < 0.03) return false;
  }
  if (path != 2) return true;
  const double phi_c = 2.0 * find_caustic(section.excess).half_azimuth;
  return std::abs(std::abs(phi) - phi_c) > 0.02;
}

marschner_parameters<double> marschner_of(row in, bool smoothed) {
  auto hair = common_marschner_parameters<double>(in.channels(1));
  // The caustic's constants are decimals: as floats on the device.
  hair.caustic = {smoothed, static_cast<double>(0.26F), 0.5, 1.0, static_cast<double>(0.3F)};
  hair.eta = in.d(0);
  hair.alpha = in.d(4);
  hair.beta = in.d(5);
  hair.eccentricity = in.d(6);
  return hair;
}

}  // namespace

TEST_CASE("N_R + N_TT + N_TRT of clear hair at θ = 0 integrates to 0.9924 on every device") {
  // Offsets from TRT's caustic are squared, which takes its singularity out of the integrand.
  const auto section = make_fibre_section(1.55, 0.0);
  const double phi_c = 2.0 * find_caustic(section.excess).half_azimuth;
  std::vector<std::uint32_t> given;
  std::vector<double> weights;
  for (const double end : {0.0, std::numbers::pi}) {
    const double sign = end < phi_c ? -1.0 : 1.0;
    const auto node = [&](double t) {
      std::vector<float> inputs(13, 0.0F);
      inputs[0] = 1.55F;
      inputs[5] = 0.13F;
      inputs[6] = 1.0F;
      inputs[9] = static_cast<float>(phi_c + sign * t * t);
      for (const float x : inputs)
        given.push_back(std::bit_cast<std::uint32_t>(x));
      return 0.0;
    };
    const double length = std::sqrt(std::abs(end - phi_c));
    (void)integrate(0.0, length, 400, node);
    weights.push_back(length);
  }
  const run_rows run = run_over(kernels::marschner, given, 13, 48);
  std::size_t r = 0;
  double sum = 0.0;
  for (const double length : weights) {
    sum += integrate(0.0, length, 400, [&](double t) {
      const row n = run.results(r++);
      return 2.0 * t * (n.d(3) + n.d(6) + n.d(9));
    });
  }
  CHECK(2.0 * sum == doctest::Approx(0.9924).epsilon(5e-4));
}

TEST_CASE("Marschner's model is within 6e-5 of double on every device") {
  const words sigma = magnitude(-6, 3);
  const words theta = between(-1.4F, 1.4F);
  const words phi = between(-3.14F, 3.14F);
  holds("marschner", [&] {
    compare_with_double(
        kernels::marschner,
        {between(1.3F, 1.8F), sigma, sigma, sigma, between(-0.2F, 0.2F), between(0.06F, 0.3F), between(0.85F, 1.15F),
         theta, theta, phi, phi, few_words(), between(0.0F, 0.99F)},
        [](row in, row, wanted& out) {
          const double theta_d = 0.5 * (in.d(8) - in.d(7));
          const auto hair = marschner_of(in, false);
          const auto bare = evaluate_marschner(hair, in.d(7), in.d(8), in.d(9), in.d(10));
          const auto smoothed = evaluate_marschner(marschner_of(in, true), in.d(7), in.d(8), in.d(9), in.d(10));
          const auto section = make_fibre_section(hair.eta, theta_d);
          const double bent = eccentric_index(hair.eta, hair.eccentricity, in.d(10));
          const bool sharp = well_conditioned(make_fibre_section(bent, theta_d), 2, in.d(9));
          const auto put_or_skip = [&](bool known, const glm::dvec3& value) {
            if (known) {
              out.put(value);
            } else {
              out.skip(3);
            }
          };
          out.put(bare.longitudinal);
          out.put(bare.azimuthal[0]);
          put_or_skip(well_conditioned(section, 1, in.d(9)), bare.azimuthal[1]);
          put_or_skip(sharp, bare.azimuthal[2]);
          put_or_skip(sharp, smoothed.azimuthal[2]);
          put_or_skip(sharp, bare.scattering);
          put_or_skip(sharp, smoothed.scattering);
          out.put(section.eta_perpendicular);
          out.put(section.eta_parallel);
          out.put(section.excess);
          out.put(section.path_stretch);
          const auto caustic = find_caustic(section.excess);
          if (std::abs(section.excess - 3.0) > 0.1) {
            out.put(caustic.sine);
            out.put(caustic.cosine);
            out.put(caustic.half_azimuth);
            out.put(caustic.curvature);
          } else {
            out.skip(4);  // it vanishes, as the root of a difference
          }
          const int path = static_cast<int>(in.u(11) % 3U);
          const auto roots = find_scattering_roots(path, in.d(9), section.excess);
          const bool apart = well_conditioned(section, path, in.d(9));
          if (apart) {
            out.put(roots.count);
          } else {
            out.skip(1);
          }
          put_or_skip(apart, {roots.root[0].sine, roots.root[1].sine, roots.root[2].sine});
          const double h = in.d(12);
          out.put(path_attenuation(section, path, h, std::sqrt((1.0 - h) * (1.0 + h)), in.d(1)));
          out.put(azimuth_derivative(path, h, section.eta_perpendicular));
          out.put(eccentric_index(hair.eta, hair.eccentricity, in.d(10)));
          out.put((h * 255.0 + 0.5) / 256.0);
          const auto lobes = azimuthal_lobes(section, hair, in.d(9));
          out.put(lobes.reflected);
          put_or_skip(well_conditioned(section, 1, in.d(9)),
                      {lobes.transmitted.x, lobes.transmitted.y, lobes.transmitted.z});
          put_or_skip(well_conditioned(section, 2, in.d(9)), {lobes.returned.x, lobes.returned.y, lobes.returned.z});
          out.put(63.0 * h);
          out.put(255.0 * std::abs(in.d(9)) / std::numbers::pi);
        },
        {{"gaussian", 3, 2e-5, 1e-6},
         {"bare_azimuthal R", 3, 2e-5, 1e-6},
         {"bare_azimuthal TT", 3, 2e-5, 1e-6},
         {"bare_azimuthal TRT", 3, 6e-5, 1e-6},
         {"smooth_trt", 3, 6e-5, 1e-6},
         {"evaluate_marschner, bare", 3, 6e-5, 1e-6},
         {"evaluate_marschner", 3, 2e-5, 1e-6},
         {"make_fibre_section", 4, 2e-6},
         {"find_caustic", 4, 2e-5, 1e-2},
         {"find_scattering_roots count", 1, 0.0},
         {"find_scattering_roots", 3, 5e-6, 1.0},
         {"path_attenuation", 1, 2e-5, 1e-6},
         {"azimuth_derivative", 1, 2e-6, 1.0},
         {"eccentric_index", 1, 1e-6},
         {"table_coordinate", 1, 5e-7},
         {"azimuthal_lobes R, TT", 6, 2e-5, 1e-6},
         {"azimuthal_lobes TRT", 3, 6e-5, 1e-6},
         {"marschner_table_place_of", 2, 1e-6, 1.0}});
  });
}

}  // namespace pelage::test
