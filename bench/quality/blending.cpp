// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "quality/blending.hpp"

#include <pelage/composite/order_weighted.hpp>
#include <pelage/composite/radiance.hpp>
#include <pelage/composite/sliced_tail.hpp>
#include <pelage/composite/stochastic.hpp>
#include <pelage/composite/weighted_sum.hpp>
#include <pelage/visibility/occupancy_map.hpp>

#include <string>

#include "frame/blends/deep_opacity.hpp"
#include "frame/blends/moments.hpp"
#include "frame/blends/unordered.hpp"
#include "frame/model/random_colours.hpp"
#include "quality/difference.hpp"
#include "quality/visibility_methods.hpp"

namespace pelage::frame {
namespace {

/// A pixel whose fragments are to be blended: sorted, which the methods without order make no use of.
struct pixel {
  texel t;
  std::vector<layer> layers;
  std::uint32_t number;
};

constexpr glm::vec3 background(0.8F);

/// The first k sorted, the others as their tail, or lost [Yu12]; k from the list's length on: the truth.
glm::vec3 by_nearest(const pixel& p, std::size_t k, bool has_tail = true) {
  pixel_radiance<float> sum = empty_pixel<float>();
  tail behind = empty_tail();
  for (std::size_t i = 0; i < p.layers.size(); ++i) {
    const layer& l = p.layers[i];
    if (i < k) {
      sum = add_fibre(sum, l.radiance, glm::vec3(0.0F), l.alpha);
    } else {
      behind = add_fragment(behind, l.alpha, l.radiance);
    }
  }
  if (has_tail) sum = add_tail(sum, behind);
  return resolve(sum, background);
}

/// The first K sorted over a tail for each of some slices of the view's depths.
template <std::size_t K, std::uint32_t Slices>
glm::vec3 by_nearest_and_slices(const pixel& p) {
  pixel_radiance<float> sum = empty_pixel<float>();
  auto behind = sliced_tail<Slices>::empty();
  for (std::size_t i = 0; i < p.layers.size(); ++i) {
    const layer& l = p.layers[i];
    if (i < K) {
      sum = add_fibre(sum, l.radiance, glm::vec3(0.0F), l.alpha);
    } else {
      behind.add(slice_position(p.t.whole.relative(l.where.depth), Slices), l.alpha, l.radiance);
    }
  }
  return resolve(add_sliced_tail(sum, behind), background);
}

/// The paper's own weight: the order is counted, and all fragments have the mean alpha.
glm::vec3 by_counted_order(const pixel& p) {
  const auto position = [&](const layer& l) { return slice_position(p.t.range.relative(l.where.depth), 128U); };
  occupancy_map<> map = occupancy_map<>::empty();
  float mean = 0.0F;
  for (const layer& l : p.layers) {
    map.add(position(l), 1U);
    mean += l.alpha / static_cast<float>(p.layers.size());
  }
  tail sum = empty_tail();
  for (const layer& l : p.layers) {
    const float before = mean > 0.0F ? order_weight(mean, map.interpolated_before_fragment(position(l))) / mean : 1.0F;
    sum = add_weighted(sum, l.alpha, l.alpha * before, l.radiance);
  }
  return resolve(sum, background);
}

/// The order of whole slices, which the paper's interpolation is compared with.
glm::vec3 by_whole_slices(const pixel& p) {
  const auto position = [&](const layer& l) { return slice_position(p.t.range.relative(l.where.depth), 128U); };
  occupancy_map<> map = occupancy_map<>::empty();
  for (const layer& l : p.layers)
    map.add(position(l), optical_depth(l.alpha));
  tail sum = empty_tail();
  for (const layer& l : p.layers)
    sum = add_weighted(sum, l.alpha, optical_weight(l.alpha, map.amount_before_fragment(position(l))), l.radiance);
  return resolve(sum, background);
}

template <std::uint32_t Samples>
glm::vec3 by_samples(const pixel& p) {
  return blend_stochastic<Samples>(p.layers, background, stochastic_stream(1U, p.number));
}

template <class Moments>
glm::vec3 by_moments(const pixel& p) {
  return blend_moments<Moments>(p.layers, background);
}

template <std::uint32_t N>
glm::vec3 by_layers(const pixel& p) {
  return blend_layers<N>(p.layers, background);
}

struct blending {
  std::string name;
  glm::vec3 (*blend)(const pixel&);
};

const std::vector<blending> blendings{
    {"K-buffer 4", [](const pixel& p) { return by_nearest(p, 4); }},
    {"K-buffer 8", [](const pixel& p) { return by_nearest(p, 8); }},
    {"K-buffer 16", [](const pixel& p) { return by_nearest(p, 16); }},
    {"K-buffer 32", [](const pixel& p) { return by_nearest(p, 32); }},
    {"K-buffer 16, no tail", [](const pixel& p) { return by_nearest(p, 16, false); }},
    {"K-buffer 16, 4 slices", by_nearest_and_slices<16, 4>},
    {"K-buffer 16, 8 slices", by_nearest_and_slices<16, 8>},
    {"K-buffer 16, 16 slices", by_nearest_and_slices<16, 16>},
    {"K-buffer 16, 32 slices", by_nearest_and_slices<16, 32>},
    {"K-buffer 32, 16 slices", by_nearest_and_slices<32, 16>},
    {"deep opacity 32", [](const pixel& p) { return blend_deep_opacity<32>(p.layers, background, false); }},
    {"deep opacity 32, corrected", [](const pixel& p) { return blend_deep_opacity<32>(p.layers, background, true); }},
    {"order-weighted, counted", by_counted_order},
    {"order-weighted, optical", [](const pixel& p) { return blend_order_weighted(p.layers, background); }},
    {"order-weighted, whole slices", by_whole_slices},
    {"weighted average", [](const pixel& p) { return blend_weighted_average(p.layers, background); }},
    {"weighted blended", [](const pixel& p) { return blend_weighted_blended(p.layers, background); }},
    {"stochastic 8", by_samples<8>},
    {"stochastic 32", by_samples<32>},
    {"power moments 4", by_moments<power_moments<4>>},
    {"power moments 6", by_moments<power_moments<6>>},
    {"trigonometric moments 2", by_moments<trigonometric_moments<2>>},
    {"trigonometric moments 3", by_moments<trigonometric_moments<3>>},
    {"alpha layers 4", by_layers<4>},
    {"alpha layers 8", by_layers<8>},
    {"alpha layers 16", by_layers<16>},
};

/// The strand of each point.
std::vector<std::uint32_t> strands_of(const strands& fibres) {
  std::vector<std::uint32_t> strand(fibres.point.size(), 0);
  for (std::size_t i = 1; i < strand.size(); ++i)
    strand[i] = strand[i - 1] + ((fibres.end_of[i] & strands::first) != 0 ? 1U : 0U);
  return strand;
}

}  // namespace

nlohmann::json measure_blending(const lists& camera, const strands& fibres, float alpha) {
  const std::vector<std::uint32_t> strand_of = strands_of(fibres);
  std::vector<difference> errors(blendings.size());
  depth_range whole = depth_range::empty();
  for (std::size_t n = 0; n < camera.pixels(); ++n) {
    for (const sample& s : camera.of(n))
      whole.extend(s.depth);
  }
  for (std::size_t n = 0; n < camera.pixels(); ++n) {
    const std::span<const sample> list = camera.of(n);
    if (list.empty()) continue;
    pixel p{{list, {}, depth_range::empty(), whole, list.back().depth - list.front().depth},
            {},
            static_cast<std::uint32_t>(n)};
    p.t.range.extend(list.front().depth);
    p.t.range.extend(list.back().depth);
    for (const sample& s : list) {
      p.t.optical.push_back(optical_depth(alpha * s.coverage));
      p.layers.push_back({{s.depth, s.id}, alpha * s.coverage, random_colour(strand_of[fibres.segment[s.id]])});
    }
    const glm::vec3 truth = by_nearest(p, list.size());
    for (std::size_t b = 0; b < blendings.size(); ++b) {
      const glm::vec3 d = blendings[b].blend(p) - truth;
      for (int c = 0; c < 3; ++c)
        errors[b].see(double{d[c]});
    }
  }
  nlohmann::json result{{"alpha", alpha}, {"fragments", camera.fragments()}};
  for (std::size_t b = 0; b < blendings.size(); ++b) {
    result["methods"].push_back(
        {{"name", blendings[b].name}, {"rms", errors[b].rms()}, {"maximum", errors[b].largest}});
  }
  return result;
}

}  // namespace pelage::frame
