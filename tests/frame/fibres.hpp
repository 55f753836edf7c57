// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "frame/draws.hpp"
#include "frame/model/hair_model.hpp"
#include "frame/model/strands.hpp"
#include "frame/raster/raster.hpp"
#include "frame/scene/view.hpp"
#include "property.hpp"

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <random>
#include <span>
#include <vector>

/// What the renderer's tests share: fibres and views, fixed or drawn at random.
namespace pelage::test {

inline frame::hair_model model_of(const std::vector<std::vector<glm::vec3>>& lines, float radius, float opacity) {
  frame::hair_model model;
  for (const std::vector<glm::vec3>& line : lines) {
    model.points.insert(model.points.end(), line.begin(), line.end());
    model.first_point.push_back(static_cast<std::uint32_t>(model.points.size()));
  }
  model.default_thickness = 2.0F * radius;
  model.default_transparency = 1.0F - opacity;
  return model;
}

inline frame::strands fibres_of(const std::vector<std::vector<glm::vec3>>& lines, float radius, float opacity) {
  return frame::prepare_strands(model_of(lines, radius, opacity), {});
}

/// From one to `most` polylines of up to four segments in a cube of half side `reach` round `centre`.
inline std::vector<std::vector<glm::vec3>> any_lines(int most, const glm::vec3& centre, float reach) {
  std::vector<std::vector<glm::vec3>> lines(static_cast<std::size_t>(*rc::gen::inRange(1, most + 1)));
  for (std::vector<glm::vec3>& line : lines) {
    for (int points = *rc::gen::inRange(2, 6); points > 0; --points) {
      line.push_back(centre + any_vec3(-reach, reach));
    }
  }
  return lines;
}

/// One texel per unit of length, looking along -z: exact where the maps' arithmetic would round.
inline frame::view flat_view(int texels) {
  return frame::orthographic_view(glm::vec3(0.0F), {0.0F, 0.0F, -1.0F}, static_cast<float>(texels), texels);
}

inline pixel_footprint any_footprint() {
  return *rc::gen::element(pixel_footprint::inscribed, pixel_footprint::equal_area, pixel_footprint::yu);
}

/// From +z toward the origin, wide enough that rounding at a picture's rim shows.
inline frame::view any_perspective(float distance, float near_plane) {
  const int width = *rc::gen::inRange(1, 40);
  const int height = *rc::gen::inRange(1, 40);
  return frame::perspective_view({0.0F, 0.0F, distance}, glm::vec3(0.0F), any_float(0.2F, 1.0F), width, height,
                                 near_plane, any_footprint());
}

inline frame::pixel_rect whole(const frame::view& v) {
  return {0, 0, v.width, v.height};
}

template <class Value>
bool same_bits(std::span<const Value> a, std::span<const Value> b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}

template <class Value>
bool same_bits(const std::vector<Value>& a, const std::vector<Value>& b) {
  return same_bits(std::span<const Value>(a), std::span<const Value>(b));
}

/// What `work` returns when it runs on this many threads, also where there are fewer cores.
template <class Work>
auto on_threads(int count, const Work& work) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
  return tbb::task_arena(count).execute(work);
}

/// Every segment's number, in an order that the seed picks.
inline std::vector<std::uint32_t> shuffled(std::uint32_t segments, std::uint32_t seed) {
  std::vector<std::uint32_t> order(segments);
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), std::mt19937(seed));
  return order;
}

}  // namespace pelage::test
