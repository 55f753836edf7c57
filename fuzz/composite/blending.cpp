// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// Blending without order: any bits for depths, opacities, weights and colours; no order changes a bit, and nothing
// makes a NaN.
#include <pelage/composite/atomic_tail.hpp>
#include <pelage/composite/order_weighted.hpp>
#include <pelage/composite/stochastic.hpp>
#include <pelage/composite/weighted_average.hpp>
#include <pelage/composite/weighted_blended.hpp>
#include <pelage/composite/weighted_sum.hpp>

#include "../input.hpp"

#include <glm/vec3.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

namespace {

using namespace pelage;
using fuzz::law;

struct layer {
  fragment where;
  float alpha, weight;
  glm::vec3 colour;
};

bool same_bits(const tail& a, const tail& b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

bool is_colour(const glm::vec3& c) {
  return c.x >= 0.0f && c.y >= 0.0f && c.z >= 0.0f && std::isfinite(c.x + c.y + c.z);
}

void check_sums(const std::vector<layer>& all, const glm::vec3& background) {
  tail sum = empty_tail();
  tail backwards = empty_tail();
  std::array<std::uint32_t, tail_words()> cells{};
  atomic_cells<std::uint32_t> storage{cells};
  weighted_average mean = weighted_average::empty();
  weighted_average halves = weighted_average::empty();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const layer& one = all[i];
    const layer& other = all[all.size() - 1 - i];
    sum = add_weighted(sum, one.alpha, one.weight, one.colour);
    backwards = add_weighted(backwards, other.alpha, other.weight, other.colour);
    atomic_tail::add(storage, 0u, add_weighted(empty_tail(), one.alpha, one.weight, one.colour));
    mean.add(one.alpha, one.colour);
    weighted_average single = weighted_average::empty();
    single.add(other.alpha, other.colour);
    halves.merge(single);
  }
  law(same_bits(sum, backwards) && same_bits(sum, atomic_tail::load(storage, 0u)),
      "a weighted sum depends on no order");
  law(is_colour(resolve(sum, background)), "a weighted sum is a colour");
  law(same_bits(mean.sums, halves.sums) && mean.count == halves.count, "a weighted average depends on no order");
  law(mean.transmittance() >= 0.0f && mean.transmittance() <= 1.0f, "what passes an average is in [0, 1]");
  law(is_colour(mean.resolve(background)), "a weighted average is a colour");
}

void check_weights(const layer& l) {
  const float order = l.weight > 0.0f ? l.weight : 0.0f;
  const float by_depth = depth_weight(l.alpha, l.where.depth);
  law(by_depth >= 0.0f && by_depth <= 1.0f, "a weight by depth is in [0, 1]");
  const float by_optical = optical_weight(l.alpha, order < 4294967296.0f ? order : 4294967296.0f);
  law(by_optical >= 0.0f && by_optical <= 1.0f, "a weight by optical depth is in [0, 1]");
  if (l.alpha == l.alpha && std::isfinite(order)) {
    const float by_order = order_weight(l.alpha, order);
    law(by_order >= 0.0f && by_order <= 1.0f, "a weight by order is in [0, 1]");
  }
}

void check_samples(const std::vector<layer>& all, std::uint32_t seed) {
  constexpr std::uint32_t samples = 8;
  const std::uint32_t stream = stochastic_stream(seed, 0u);
  auto depths = stochastic_depths<samples>::empty();
  std::vector<std::uint32_t> cells(samples, 0xffffffffu);
  atomic_cells<std::uint32_t> storage{cells};
  bool opaque = false;
  float nearest_opaque = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < all.size(); ++i) {
    depths.add(all[i].where, all[i].alpha, stream);
    const layer& other = all[all.size() - 1 - i];
    atomic_stochastic_depths::add<stochastic_depths<samples>>(storage, 0u, other.where, other.alpha, seed);
    if (is_fragment(all[i].where) && all[i].alpha >= 1.0f) {
      opaque = true;
      nearest_opaque = std::min(nearest_opaque, all[i].where.depth);
    }
  }
  law(depths.nearest == atomic_stochastic_depths::load<stochastic_depths<samples>>(storage, 0u).nearest,
      "samples depend on no order");
  for (const layer& l : all) {
    const float passed = depths.transmittance_before(l.where.depth);
    law(passed >= 0.0f && passed <= 1.0f, "a share of samples is in [0, 1]");
    law(!opaque || !(l.where.depth > nearest_opaque) || passed == 0.0f, "nothing passes an opaque layer");
    for (const layer& farther : all) {
      law(!(farther.where.depth > l.where.depth) || depths.transmittance_before(farther.where.depth) <= passed,
          "samples close with depth");
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in(data, size);
  const auto seed = in.take<std::uint32_t>();
  const glm::vec3 background(in.unit(), in.unit(), in.unit());
  std::vector<layer> all;
  while (!in.empty() && all.size() < 32) {
    layer l{};
    l.where = fragment{in.take<float>(), in.take<std::uint8_t>()};
    const bool ordinary = in.below(4) > 0;
    l.alpha = ordinary ? in.unit() : in.take<float>();
    l.weight = ordinary ? in.unit() : in.take<float>();
    l.colour.x = ordinary ? in.unit() : in.take<float>();
    l.colour.y = ordinary ? in.unit() : in.take<float>();
    l.colour.z = ordinary ? in.unit() : in.take<float>();
    all.push_back(l);
  }
  check_sums(all, background);
  for (const layer& l : all) {
    check_weights(l);
  }
  check_samples(all, seed);
  return 0;
}
