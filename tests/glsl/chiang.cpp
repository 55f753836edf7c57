// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/chiang_far_field.hpp>
#include <pelage/bsdf/chiang_sampling.hpp>
#include <pelage/bsdf/fibre_hit.hpp>
#include <pelage/bsdf/passage.hpp>
#include <pelage/core/vector_math.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

#include "bsdf/sphere.hpp"
#include "glsl/double_comparison.hpp"
#include "glsl/kernels.hpp"
#include "property.hpp"

namespace pelage::test {

namespace {

using words = rc::Gen<std::uint32_t>;

/// Any sign, but no nearer to 0 than `low`.
words apart_from_zero(float low) {
  return rc::gen::oneOf(between(low, 1.0F), between(-1.0F, -low));
}

/// Fibres and how they are seen, as kernels/chiang.glsl reads them.
std::vector<words> seen_fibres(const words& beta) {
  const words sigma = rc::gen::weightedOneOf<std::uint32_t>({{1, rc::gen::just(0U)}, {6, magnitude(-6, 4)}});
  const words part = between(-1.0F, 1.0F);
  return {between(1.1F, 2.0F), sigma, sigma, sigma, beta, beta, between(-0.17F, 0.17F), part, part, part, part};
}

chiang_fibre<double> fibre_of(row in) {
  return make_chiang_fibre<double>({in.d(0), in.channels(1), in.d(4), in.d(5), in.d(6)});
}

chiang_view<double> view_of(row in) {
  return view_chiang(fibre_of(in), in.d(7), fibre_direction_of(in.d3(8)));
}

}  // namespace

TEST_CASE("Chiang's model is within 5e-5 of double on every device") {
  std::vector<words> inputs = seen_fibres(between(0.08F, 1.0F));
  const words part = between(-1.0F, 1.0F);
  inputs.insert(inputs.end(), {part, part, apart_from_zero(0.1F)});
  holds("chiang", [&] {
    compare_with_double(kernels::chiang, inputs,
                        [](row in, row, wanted& out) {
                          const auto light = fibre_direction_of(in.d3(11));
                          const auto result = evaluate_chiang(fibre_of(in), view_of(in), light);
                          out.put(result.value);
                          out.put(result.density);
                          out.put(result.density);
                          const auto whole = evaluate_chiang_bsdf(fibre_of(in), in.d(7), in.d3(8), in.d3(11));
                          out.put(whole.f);
                          out.put(whole.density);
                        },
                        {{"evaluate_chiang", 3, 5e-5, 1e-6},
                         {"evaluate_chiang density", 1, 5e-5, 1e-6},
                         {"chiang_density", 1, 5e-5, 1e-6},
                         {"evaluate_chiang_bsdf", 3, 5e-5, 1e-5},
                         {"evaluate_chiang_bsdf density", 1, 5e-5, 1e-6}});
  });
}

TEST_CASE("Directions drawn on a device are unit vectors, from a lobe by its weight, with their density") {
  std::vector<words> inputs = seen_fibres(between(0.08F, 1.0F));
  inputs.insert(inputs.end(), 4, between(0.0F, 0.999F));
  holds("chiang samples", [&] {
    compare_with_double(kernels::chiang_sample, inputs,
                        [](row in, row got, wanted& out) {
                          const glm::dvec3 direction = got.d3(0);
                          RC_ASSERT(std::abs(vector_length(direction) - 1.0) < 4e-7);
                          const auto view = view_of(in);
                          const auto lobe = static_cast<std::size_t>(got.f(7));
                          RC_ASSERT(lobe <= 3U);
                          double before = 0.0;
                          for (std::size_t p = 0; p < lobe; ++p)
                            before += view.weights[p];
                          RC_ASSERT(in.d(11) > before - 1e-6 && in.d(11) < before + view.weights[lobe] + 1e-6);
                          const auto result = evaluate_chiang(fibre_of(in), view, fibre_direction_of(direction));
                          out.put(direction);
                          out.put(result.value);
                          out.put(result.density);
                          out.put(static_cast<double>(lobe));
                        },
                        {{"sample_chiang direction", 3, 0.0},
                         {"sample_chiang", 3, 5e-5, 1e-6},
                         {"sample_chiang density", 1, 5e-5, 1e-6},
                         {"sample_chiang lobe", 1, 0.0}});
  });
}

TEST_CASE("Averages over a fibre's width are within 5e-5 of double on every device") {
  std::vector<words> inputs = seen_fibres(between(0.08F, 1.0F));
  inputs.insert(inputs.end(), 3, between(-1.0F, 1.0F));
  holds("chiang far", [&] {
    compare_with_double(kernels::chiang_far, inputs,
                        [](row in, row, wanted& out) {
                          const auto far = evaluate_chiang_far(fibre_of(in), fibre_direction_of(in.d3(8)),
                                                               fibre_direction_of(in.d3(11)));
                          out.put(far.value);
                          out.put(far.density);
                          out.put(axial_passage(in.d(0), in.channels(1), in.d(8)));
                          out.put(mean_passage<4>(in.d(0), in.channels(1), in.d(8)));
                        },
                        {{"evaluate_chiang_far", 3, 5e-5, 1e-6},
                         {"evaluate_chiang_far density", 1, 5e-5, 1e-6},
                         {"axial_passage", 3, 5e-5, 1e-6},
                         {"mean_passage", 3, 5e-5, 1e-6}});
  });
}

TEST_CASE("Directions drawn for a fibre seen from afar are unit vectors that carry their density") {
  std::vector<words> inputs = seen_fibres(between(0.08F, 1.0F));
  inputs.insert(inputs.end(), 4, between(0.0F, 0.999F));
  holds("chiang far samples", [&] {
    compare_with_double(kernels::chiang_far_sample, inputs,
                        [](row in, row got, wanted& out) {
                          const glm::dvec3 direction = got.d3(0);
                          RC_ASSERT(std::abs(vector_length(direction) - 1.0) < 4e-7);
                          RC_ASSERT(got.f(7) >= 0.0F && got.f(7) <= 3.0F);
                          const auto far = evaluate_chiang_far(fibre_of(in), fibre_direction_of(in.d3(8)),
                                                               fibre_direction_of(direction));
                          out.put(direction);
                          out.put(far.value);
                          out.put(far.density);
                          out.put(got.d(7));
                        },
                        {{"sample_chiang_far direction", 3, 0.0},
                         {"sample_chiang_far", 3, 5e-5, 1e-6},
                         {"sample_chiang_far density", 1, 5e-5, 1e-6},
                         {"sample_chiang_far lobe", 1, 0.0}});
  });
}

TEST_CASE("Hits on segments are placed on a device as in double") {
  const words place = between(-2.0F, 2.0F);
  const words radius = between(0.5F, 4.0F);
  std::vector<words> inputs(12, place);
  inputs.insert(inputs.end(), 2, radius);
  holds("fibre hits", [&] {
    compare_with_double(kernels::fibre_hit, inputs,
                        [](row in, row, wanted& out) {
                          const glm::dvec3 hit = in.d3(0), direction = in.d3(3), start = in.d3(6), end = in.d3(9);
                          const auto at = fibre_hit_on_segment(hit, direction, start, end, in.d(12), in.d(13));
                          const auto own = fibre_hit_of(hit, direction, start, in.d(12));
                          // Close to the ray's direction the frame's turn about x has few digits.
                          if (!(at.eye.cosine > 0.1) || !(own.eye.cosine > 0.1) || !(vector_length(direction) > 0.1) ||
                              !(vector_length(end - start) > 0.1) || !(vector_length(start) > 0.1)) {
                            out.skip(14);
                            return;
                          }
                          out.put(at.h);
                          out.put(at.gamma);
                          out.put(at.theta);
                          out.put(at.eye.sine);
                          out.put(at.eye.cosine);
                          out.put(into_frame(at.frame, direction));
                          out.put(out_of_frame(at.frame, direction));
                          out.put(own.frame.z);
                        },
                        {{"fibre_hit_on_segment h", 1, 2e-5, 1.0},
                         {"fibre_hit_on_segment gamma", 1, 5e-3, 1.0},
                         {"fibre_hit_on_segment theta", 1, 2e-6, 1.0},
                         {"fibre_hit_on_segment eye", 2, 2e-6, 1.0},
                         {"into_frame", 3, 2e-5, 1.0},
                         {"out_of_frame", 3, 2e-5, 1.0},
                         {"fibre_hit_of frame", 3, 2e-5, 1.0}});
  });
}

namespace {

/// A fibre as the eye sees it, in the order of kernels/chiang.glsl.
using seen_fibre = std::array<float, 11>;

seen_fibre clear_fibre(float beta_m, float beta_n, float tilt, float h, double theta) {
  const glm::vec3 eye = unit_vector<float>(theta, 0.4);
  return {1.55F, 0.0F, 0.0F, 0.0F, beta_m, beta_n, tilt, h, eye.x, eye.y, eye.z};
}

void append(std::vector<std::uint32_t>& words_of_rows, std::span<const float> values) {
  for (const float x : values)
    words_of_rows.push_back(std::bit_cast<std::uint32_t>(x));
}

/// The light that leaves in all directions, and the integral of the density: a run for all nodes of the quadrature.
std::array<double, 2> furnace(const seen_fibre& seen) {
  const auto fibre = make_chiang_fibre<float>({seen[0], {seen[1], seen[2], seen[3]}, seen[4], seen[5], seen[6]});
  const int thetas = theta_panels_for(fibre);
  const int phis = phi_count_for(fibre);
  std::vector<std::uint32_t> given;
  (void)integrate_sphere<float>(thetas, phis, [&](const glm::vec3& light) {
    append(given, seen);
    append(given, std::array{light.x, light.y, light.z});
    return 0.0;
  });
  const run_rows run = run_over(kernels::chiang, given, 14, 9);
  std::array<double, 2> sums{};
  for (std::size_t i = 0; i < 2; ++i) {
    std::size_t r = 0;
    sums[i] =
        integrate_sphere<float>(thetas, phis, [&](const glm::vec3&) { return run.results(r++).d(i == 0 ? 1 : 4); });
  }
  return sums;
}

}  // namespace

TEST_CASE("White furnace on a device: a clear fibre sends out all light within 2e-4, and densities integrate to 1") {
  for (const seen_fibre& seen :
       {clear_fibre(0.3F, 0.3F, 0.0F, 0.0F, 0.0), clear_fibre(0.2F, 0.9F, 0.17F, 0.7F, 1.48),
        clear_fibre(0.9F, 0.2F, -0.17F, -1.0F, -1.48), clear_fibre(0.5F, 0.5F, 0.035F, 0.999F, 0.8)}) {
    const std::array<double, 2> sums = furnace(seen);
    CHECK(std::abs(sums[0] - 1.0) < 2e-4);
    CHECK(std::abs(sums[1] - 1.0) < 1e-3);
  }
}

TEST_CASE("The mean weight of directions drawn on a device is the light that the fibre scatters, within 1e-3") {
  constexpr std::uint32_t count = 65536;
  seen_fibre seen = clear_fibre(0.3F, 0.25F, 0.035F, 0.4F, 0.5);
  seen[1] = 0.1F;
  seen[2] = 0.5F;
  seen[3] = 2.0F;
  std::mt19937 generator(1);
  std::uniform_real_distribution<float> draw(0.0F, 0.9999F);
  std::vector<std::uint32_t> given;
  for (std::uint32_t i = 0; i < count; ++i) {
    append(given, seen);
    const float stratum = (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
    append(given, std::array{stratum, draw(generator), draw(generator), draw(generator)});
  }
  const run_rows run = run_over(kernels::chiang_sample, given, 15, 8);
  const row first = run.inputs(0);
  const auto view = view_of(first);
  for (std::size_t c = 0; c < 3; ++c) {
    double mean = 0.0;
    for (std::size_t r = 0; r < count; ++r)
      mean += run.results(r).d(3 + c) / run.results(r).d(6) / count;
    double scattered = 0.0;
    for (std::size_t p = 0; p < 4; ++p)
      scattered += view.attenuation[p][c];
    CHECK(std::abs(mean - scattered) < 1e-3);
  }
}

}  // namespace pelage::test
