// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/dual_scattering_table.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "glsl/double_comparison.hpp"
#include "glsl/kernels.hpp"
#include "property.hpp"

namespace pelage::test {

using words = rc::Gen<std::uint32_t>;

TEST_CASE("Dual scattering is within 2e-5 of double on every device") {
  std::vector<words> inputs(3, between(0.0F, 0.95F));
  inputs.insert(inputs.end(), 3, between(0.0F, 0.5F));
  inputs.insert(inputs.end(), 6, between(-0.1F, 0.1F));
  inputs.insert(inputs.end(), 6, magnitude(-8, -2));
  const words unit = between(0.0F, 1.0F);
  const words theta = between(-1.4F, 1.4F);
  inputs.insert(inputs.end(), {unit, unit, between(0.0F, 20.0F), unit, unit, unit, unit, theta, theta,
                               between(-3.14F, 3.14F), few_words()});
  holds("dual scattering", [&] {
    compare_with_double(
        kernels::dual_scattering, inputs,
        [](row in, row, wanted& out) {
          const auto averages_from = [&](std::array<std::size_t, 6> at) {
            return dual_averages<double>{in.d3(at[0]), in.d3(at[1]), in.d3(at[2]),
                                         in.d3(at[3]), in.d3(at[4]), in.d3(at[5])};
          };
          const auto averages = averages_from({0, 3, 6, 9, 12, 15});
          const dual_density<double> density = {in.d(18), in.d(19)};
          const auto local = dual_local_scattering(averages, density);
          out.put(local.albedo);
          out.put(local.shift);
          out.put(local.variance);
          const auto global = dual_global_scattering(averages, density, in.d(20), in.d(21));
          out.put(global.direct);
          out.put(global.transmitted);
          out.put(global.variance);
          const auto passed =
              dual_pass_fibre(dual_pass_fibre(dual_unshadowed<double>(), averages, density), averages, density);
          out.put(passed.direct);
          out.put(passed.transmitted);
          out.put(passed.variance);
          out.put(dual_scattering(averages, local, global, density, in.d3(22), in.d(25), in.d(26), in.d(27)));
          out.put(detail::dual_lobe(in.d(6), in.d(12), in.d(18), in.d(19)));
          const double last = in.u(28);
          const double place = (in.d(25) / 3.141592653589793 + 0.5) * (last + 1.0) - 0.5;
          const double held = std::clamp(place, 0.0, last);
          out.put(held);
          out.put(std::min(std::floor(held) + 1.0, last));
          const auto other = averages_from({3, 0, 9, 6, 15, 12});
          const double share = in.d(18);
          const auto blend = [&](const glm::dvec3& a, const glm::dvec3& b) { out.put(a * (1.0 - share) + b * share); };
          blend(averages.forward, other.forward);
          blend(averages.backward, other.backward);
          blend(averages.forward_shift, other.forward_shift);
          blend(averages.backward_shift, other.backward_shift);
          blend(averages.forward_variance, other.forward_variance);
          blend(averages.backward_variance, other.backward_variance);
        },
        {{"dual_local_scattering albedo", 3, 1e-5, 1e-3},
         {"dual_local_scattering shift", 3, 2e-5, 0.1},
         {"dual_local_scattering variance", 3, 1e-5, 1e-6},
         {"dual_global_scattering direct", 1, 0.0},
         {"dual_global_scattering transmitted", 3, 1e-5, 0.1},
         {"dual_global_scattering variance", 3, 1e-6},
         {"dual_pass_fibre", 7, 1e-6},
         {"dual_scattering", 3, 2e-5, 1e-3},
         {"dual_lobe", 1, 1e-5, 1e-6},
         {"dual_table_place_of", 1, 1e-6, 1.0},
         {"dual_table_place_of high", 1, 0.0},
         {"blend_dual_averages", 18, 1e-6, 0.1}});
  });
}

}  // namespace pelage::test
