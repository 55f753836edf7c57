// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "quality/visibility_methods.hpp"

#include <pelage/composite/optical_depth.hpp>
#include <pelage/visibility/deep_shadow_map.hpp>
#include <pelage/visibility/density_clusters.hpp>
#include <pelage/visibility/layer_position.hpp>
#include <pelage/visibility/occupancy_batch.hpp>
#include <pelage/visibility/occupancy_map.hpp>
#include <pelage/visibility/opacity_map.hpp>

#include <algorithm>

namespace pelage::frame {
namespace {

float passed_by(float optical) {
  return fast_exp2(-optical * (1.0F / 1048576.0F));
}

template <std::uint32_t Layers, class Position>
void estimate_by(const texel& t, std::span<const float> depths, std::span<float> passed, Position position) {
  opacity_map<Layers> map = opacity_map<Layers>::empty();
  for (std::size_t i = 0; i < t.list.size(); ++i)
    map.add(position(t.list[i].depth), t.optical[i]);
  map.accumulate();
  for (std::size_t i = 0; i < depths.size(); ++i)
    passed[i] = passed_by(map.accumulated_before(position(depths[i])));
}

void by_occupancy(const texel& t, std::span<const float> depths, std::span<float> passed, std::uint64_t&) {
  const auto position = [&](float depth) { return slice_position(t.range.relative(depth), 128U); };
  occupancy_map<> map = occupancy_map<>::empty();
  for (std::size_t i = 0; i < t.list.size(); ++i)
    map.add(position(t.list[i].depth), t.optical[i]);
  std::transform(depths.begin(), depths.end(), passed.begin(), position);
  amounts_before(map, passed, passed);
  std::transform(passed.begin(), passed.end(), passed.begin(), passed_by);
}

template <std::uint32_t Slices>
void by_opacity(const texel& t, std::span<const float> depths, std::span<float> passed, std::uint64_t&) {
  estimate_by<Slices>(t, depths, passed, [&](float depth) { return slice_position(t.whole.relative(depth), Slices); });
}

template <std::uint32_t Layers>
void by_deep_opacity(const texel& t, std::span<const float> depths, std::span<float> passed, std::uint64_t&) {
  estimate_by<Layers>(t, depths, passed, [&](float depth) {
    return equal_layer_position(depth - t.range.nearest_depth(), t.extent / static_cast<float>(Layers), Layers);
  });
}

template <std::uint32_t Layers>
void by_growing_layers(const texel& t, std::span<const float> depths, std::span<float> passed, std::uint64_t&) {
  const float width = growing_layer_width(t.extent, Layers);
  estimate_by<Layers>(t, depths, passed, [&](float depth) {
    return growing_layer_position(depth - t.range.nearest_depth(), width, Layers);
  });
}

/// Clusters count; all their fragments have the mean optical depth.
void by_clusters(const texel& t, std::span<const float> depths, std::span<float> passed, std::uint64_t&) {
  density_clusters<4> map = density_clusters<4>::empty();
  double optical = 0;
  for (std::size_t i = 0; i < t.list.size(); ++i) {
    map.add(slice_position(t.range.relative(t.list[i].depth), 4U));
    optical += t.optical[i];
  }
  const float mean = static_cast<float>(optical / static_cast<double>(std::max<std::size_t>(t.list.size(), 1)));
  for (std::size_t i = 0; i < depths.size(); ++i) {
    passed[i] = passed_by(mean * map.count_before(slice_position(t.range.relative(depths[i]), 4U)));
  }
}

template <int PerMille>
void by_deep_shadow(const texel& t, std::span<const float> depths, std::span<float> passed, std::uint64_t& vertices) {
  static thread_local std::vector<deep_shadow_vertex> memory;
  memory.resize(2 * t.list.size());
  span_vertex_storage storage{memory};
  deep_shadow_builder builder = deep_shadow_builder::begin(0, static_cast<float>(PerMille) / 1000.0F);
  for (std::size_t i = 0; i < t.list.size(); ++i) {
    builder.add(storage, t.list[i].depth, 1.0F - transmittance_of(t.optical[i]));
  }
  builder.finish(storage);
  vertices += builder.count;
  for (std::size_t i = 0; i < depths.size(); ++i)
    passed[i] = deep_shadow_at(storage, 0, builder.count, depths[i]);
}

template <class Map>
constexpr std::size_t with_range = sizeof(Map) + sizeof(depth_range);

const std::vector<visibility_method> all_methods{
    {"occupancy 128/4", with_range<occupancy_map<>>, by_occupancy},
    {"deep opacity 4", with_range<opacity_map<4>>, by_deep_opacity<4>},
    {"deep opacity 8", with_range<opacity_map<8>>, by_deep_opacity<8>},
    {"deep opacity 16", with_range<opacity_map<16>>, by_deep_opacity<16>},
    {"deep opacity 32", with_range<opacity_map<32>>, by_deep_opacity<32>},
    {"deep opacity 4, growing", with_range<opacity_map<4>>, by_growing_layers<4>},
    {"deep opacity 8, growing", with_range<opacity_map<8>>, by_growing_layers<8>},
    {"deep opacity 16, growing", with_range<opacity_map<16>>, by_growing_layers<16>},
    {"deep opacity 32, growing", with_range<opacity_map<32>>, by_growing_layers<32>},
    {"opacity 16", with_range<opacity_map<16>>, by_opacity<16>},
    {"opacity 128", with_range<opacity_map<128>>, by_opacity<128>},
    {"opacity 256", with_range<opacity_map<256>>, by_opacity<256>},
    {"density clusters 4", with_range<density_clusters<4>>, by_clusters},
    {"deep shadow map 0.01", 0, by_deep_shadow<10>},
    {"deep shadow map 0.03", 0, by_deep_shadow<30>},
};

}  // namespace

std::span<const visibility_method> visibility_methods() {
  return all_methods;
}

}  // namespace pelage::frame
