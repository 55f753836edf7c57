// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/mixed_bits.hpp>
#include <pelage/visibility/deep_shadow_map.hpp>
#include <pelage/visibility/density_clusters.hpp>
#include <pelage/visibility/depth_range.hpp>
#include <pelage/visibility/layer_position.hpp>
#include <pelage/visibility/lookup_jitter.hpp>
#include <pelage/visibility/occupancy_map.hpp>
#include <pelage/visibility/opacity_map.hpp>
#include <pelage/visibility/receiver.hpp>

#include <array>
#include <bit>

#include "glsl/comparison.hpp"
#include "glsl/kernels.hpp"
#include "property.hpp"

namespace pelage::test {

namespace {

constexpr std::size_t fragments = 12;  ///< for each invocation, as in the kernels

template <std::size_t N>
void put(results& out, const std::array<std::uint32_t, N>& words) {
  for (const std::uint32_t w : words)
    out.put(w);
}

void maps_row(row in, results& out) {
  depth_range range = depth_range::empty();
  depth_range behind = depth_range::empty();
  occupancy_map<128, 4> occupancy = occupancy_map<128, 4>::empty();
  occupancy_map<128, 4> others = occupancy_map<128, 4>::empty();
  occupancy_map<96, 12> few = occupancy_map<96, 12>::empty();
  opacity_map<16> opacity = opacity_map<16>::empty();
  opacity_map<16> rest = opacity_map<16>::empty();
  density_clusters<4> clusters = density_clusters<4>::empty();
  for (std::size_t i = 0; i < fragments; ++i) {
    const float relative = in.f(2 * i);
    const std::uint32_t added = in.u(2 * i + 1);
    (i % 2 == 0 ? range : behind).extend(i % 2 == 0 ? std::bit_cast<float>(added) : relative);
    (i % 2 == 0 ? occupancy : others).add(slice_position(relative, 128U), added);
    (i % 2 == 0 ? opacity : rest).add(slice_position(relative, 16U), added);
    few.add(slice_position(relative, 96U), 1U);
    clusters.add(slice_position(relative, 4U));
  }
  range.merge(behind);
  occupancy.merge(others);
  opacity.merge(rest);
  const float look = in.f(2 * fragments);
  out.put(range.nearest);
  out.put(range.farthest);
  put(out, occupancy.occupied);
  put(out, occupancy.amount);
  out.put(occupancy.total());
  put(out, few.occupied);
  put(out, few.amount);
  put(out, opacity.amount);
  out.put(opacity.total());
  for (std::size_t i = 0; i < 4; ++i) {
    out.put(clusters.count[i]);
    out.put(clusters.sum[i]);
    out.put(clusters.squares[i]);
  }
  out.put(occupancy.amount_before(slice_position(look, 128U)));
  out.put(occupancy.amount_before_fragment(slice_position(look, 128U)));
  out.put(occupancy.interpolated_before_fragment(slice_position(look, 128U)));
  out.put(few.amount_before(slice_position(look, 96U)));
  out.put(opacity.amount_before(slice_position(look, 16U)));
  out.put(opacity.amount_before_fragment(slice_position(look, 16U)));
  opacity.accumulate();
  put(out, opacity.amount);
  out.put(opacity.accumulated_before(slice_position(look, 16U)));
  out.put(opacity.accumulated_before_fragment(slice_position(look, 16U), in.u(1)));
  out.put(clusters.count_before(slice_position(look, 4U)));
  const float offset = in.f(2 * fragments + 1);
  const float width = in.f(2 * fragments + 2);
  out.put(behind.nearest_depth());
  out.put(behind.farthest_depth());
  out.put(behind.relative(look));
  out.put(equal_layer_position(offset, width, 16U));
  out.put(growing_layer_position(offset, width, 16U));
  out.put(growing_layer_width(offset, 16U));
  out.put(layer_at(slice_position(look, 7U), 7U));
  out.put(mixed_bits(in.u(2 * fragments + 3)));
  const glm::vec2 jitter = lookup_jitter(in.u(2 * fragments + 4));
  out.put(jitter.x);
  out.put(jitter.y);
  const glm::vec3 ray(in.f(2 * fragments + 5), in.f(2 * fragments + 6), -1.0F);
  const glm::vec2 line = line_depth_slope(ray, in.v3(2 * fragments + 7), 64.0F);
  out.put(line.x);
  out.put(line.y);
  const glm::vec2 plane = plane_depth_slope(ray, in.v3(2 * fragments + 7), 64.0F);
  out.put(plane.x);
  out.put(plane.y);
}

struct shadow {
  std::array<deep_shadow_vertex, 2 * fragments> memory;
  span_vertex_storage storage{memory};
  deep_shadow_builder builder;

  shadow(row in, float max_error) : builder(deep_shadow_builder::begin(0U, max_error)) {
    float depth = in.f(2 * fragments);
    for (std::size_t i = 0; i < fragments; ++i) {
      depth += in.f(2 * i);
      builder.add(storage, depth, in.f(2 * i + 1));
    }
    builder.finish(storage);
  }
  [[nodiscard]] float at(float depth) const { return deep_shadow_at(storage, 0U, builder.count, depth); }
};

}  // namespace

TEST_CASE("Maps have the same bits on every device, look-ups in them differ by the stated ulps") {
  const auto unit = between(0.0F, 1.0F);
  const auto relative = rc::gen::weightedOneOf<std::uint32_t>(
      {{6, unit}, {1, rc::gen::element(0U, std::bit_cast<std::uint32_t>(1.0F), std::bit_cast<std::uint32_t>(0.5F))}});
  const auto added = rc::gen::weightedOneOf<std::uint32_t>({{3, few_words()}, {1, any_word()}});
  std::vector<rc::Gen<std::uint32_t>> inputs;
  for (std::size_t i = 0; i < fragments; ++i) {
    inputs.push_back(relative);
    inputs.push_back(added);
  }
  const auto length = rc::gen::oneOf(magnitude(-20, 20), between(-1.0F, 20.0F), any_normal_float());
  const auto slant = between(-2.0F, 2.0F);
  inputs.insert(inputs.end(), {relative, length, length, any_word(), any_word(), slant, slant, slant, slant, slant});
  holds("maps", [&] {
    compare(kernels::visibility, inputs, maps_row,
            {{"depth_range", 2, bits(), bits()},
             {"occupancy_map add, merge, total", 9, bits(), bits()},
             {"occupancy_map add, 96 slices", 15, bits(), bits()},
             {"opacity_map add, merge, total", 17, bits(), bits()},
             {"density_clusters add", 12, bits(), bits()},
             {"occupancy_map amount_before", 1, 0, 4},
             {"occupancy_map amount_before_fragment, interpolated_before_fragment", 2, 0, 4},
             {"occupancy_map amount_before, 96 slices", 1, 0, 4},
             {"opacity_map amount_before, amount_before_fragment", 2, 0, 0},
             {"opacity_map accumulate", 16, bits(), bits()},
             {"opacity_map accumulated_before, accumulated_before_fragment", 2, 0, 0},
             {"density_clusters count_before", 1, 0, 256, 1.0F},  // its variances cancel
             {"depth_range nearest_depth, farthest_depth", 2, 0, 0},
             {"depth_range relative", 1, 0, 3},
             {"equal_layer_position", 1, 0, 3, 1.0F},
             {"growing_layer_position", 1, 0, 8, 1.0F},
             {"growing_layer_width", 1, 0, 3},
             {"layer_at", 1, bits(), bits()},
             {"mixed_bits", 1, bits(), bits()},
             {"lookup_jitter", 2, 0, 0},
             {"line_depth_slope", 2, 0, 8},
             {"plane_depth_slope", 2, 0, 8}});
  });
}

TEST_CASE("A deep shadow map is the same on lavapipe, and within twice its error on a GPU") {
  constexpr double ulps_of_one = 8388608.0;
  std::vector<rc::Gen<std::uint32_t>> inputs;
  for (std::size_t i = 0; i < fragments; ++i) {
    inputs.push_back(rc::gen::weightedOneOf<std::uint32_t>({{4, between(0.0F, 2.0F)}, {1, rc::gen::just(0U)}}));
    inputs.push_back(between(0.0F, 1.0F));
  }
  inputs.insert(inputs.end(), {between(-4.0F, 4.0F), between(-6.0F, 30.0F)});
  holds("deep shadow maps", [&] {
    compare(kernels::deep_shadow_map, inputs,
            [](row in, results& out) {
              const float look = in.f(2 * fragments + 1);
              const shadow exact(in, 0.0F);
              out.put(exact.builder.count);
              out.put(exact.at(look));
              out.put(shadow(in, 0.05F).at(look));
              out.put(exact.at(look));
            },
            {{"deep_shadow_builder vertices", 1, bits(), bits()},
             {"deep_shadow_at", 1, 0, 4},
             {"deep_shadow_at, error 0.05", 1, 0, 0.1 * ulps_of_one, 1.0F},
             {"deep_shadow_at, from the truth", 1, 0.05 * ulps_of_one, 0.05 * ulps_of_one, 1.0F}});
  });
}

}  // namespace pelage::test
