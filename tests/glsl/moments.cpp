// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/alpha_layers.hpp>
#include <pelage/composite/optical_depth.hpp>
#include <pelage/composite/power_moments.hpp>
#include <pelage/composite/trigonometric_moments.hpp>

#include "glsl/comparison.hpp"
#include "glsl/kernels.hpp"
#include "property.hpp"

namespace pelage::test {

namespace {

constexpr std::size_t fragments = 8;  ///< for each invocation, as in the kernel

template <std::uint32_t N>
void moments_row(row in, results& out) {
  const float at = in.f(4 * fragments);
  const glm::vec3 colour = in.v3(4 * fragments + 1);
  auto moments = power_moments<N>::empty();
  auto angles = trigonometric_moments<N / 2>::empty();
  auto layers = alpha_layers<4>::empty();
  for (std::size_t i = 0; i < fragments; ++i) {
    const float alpha = in.f(4 * i + 1);
    moments.add(in.f(4 * i), optical_depth(alpha));
    angles.add(in.f(4 * i), optical_depth(alpha));
    layers.insert({in.f(4 * i + 2), in.u(4 * i + 3)}, alpha, colour * static_cast<float>(i));
  }
  for (std::size_t i = 0; i < 5; ++i)
    out.put(moments.sum[i]);
  const power_visibility told = moments.visibility();
  const moment_bounds bounds = told.bounds_before(at);
  out.put(transmittance_of(bounds.least));
  out.put(transmittance_of(bounds.most));
  out.put(transmittance_of(told.amount_before(at)));
  out.put(transmittance_of(told.amount_before_fragment(in.f(0), optical_depth(in.f(1)))));
  for (const alpha_layer& each : layers.layer)
    out.put(each.nearest.id);
  out.put(layers.transmittance());
  out.put(layers.resolve(glm::vec3(colour.z, colour.y, colour.x)));
  out.put(moments.sum[N]);
  for (std::size_t i = 0; i < 5; ++i)
    out.put(angles.sum[i]);
  out.put(angles.sum[N]);
  const trigonometric_visibility circle = angles.visibility();
  const moment_bounds interval = circle.interval_before(at);
  out.put(transmittance_of(interval.least));
  out.put(transmittance_of(interval.most));
  out.put(transmittance_of(circle.amount_before(at)));
  out.put(transmittance_of(circle.amount_before_fragment(in.f(0), optical_depth(in.f(1)))));
}

}  // namespace

TEST_CASE("Moments have the same sums on every device, what passes differs by less than 1.6e-2") {
  const auto unit = between(0.0F, 1.0F);
  const auto share = rc::gen::weightedOneOf<std::uint32_t>({{9, unit}, {1, any_float()}});
  std::vector<rc::Gen<std::uint32_t>> inputs;
  for (std::size_t i = 0; i < fragments; ++i) {
    inputs.push_back(share);
    inputs.push_back(share);
    inputs.push_back(rc::gen::weightedOneOf<std::uint32_t>({{3, between(1.0F, 20.0F)}, {1, any_float()}}));
    inputs.push_back(rc::gen::weightedOneOf<std::uint32_t>({{3, few_words()}, {1, any_word()}}));
  }
  inputs.insert(inputs.end(), {share, unit, unit, unit});
  const std::vector<column> columns{{"power_moments add, merge", 5, bits(), bits()},
                                    {"power_visibility bounds_before", 2, 0, 131072, 1.0F},
                                    {"power_visibility amount_before", 1, 0, 131072, 1.0F},
                                    {"power_visibility amount_before_fragment", 1, 0, 131072, 1.0F},
                                    {"alpha_layers insert", 4, bits(), bits()},
                                    {"alpha_layers transmittance", 1, 0, 0},
                                    {"alpha_layers resolve", 3, 0, 0},
                                    {"power_moments add of the last", 1, bits(), bits()},
                                    {"trigonometric_moments add", 6, bits(), bits()},
                                    {"trigonometric_visibility interval_before", 2, 0, 131072, 1.0F},
                                    {"trigonometric_visibility amount_before", 1, 0, 131072, 1.0F},
                                    {"trigonometric_visibility amount_before_fragment", 1, 0, 131072, 1.0F}};
  holds("4 moments", [&] { compare(kernels::moments_4, inputs, moments_row<4>, columns); });
  holds("6 moments", [&] { compare(kernels::moments_6, inputs, moments_row<6>, columns); });
}

}  // namespace pelage::test
