// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/order/slice_order.hpp"

#include <pelage/order/slice_sort.hpp>
#include <pelage/visibility/layer_position.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>

#include "frame/base/stopwatch.hpp"

namespace pelage::frame {
namespace {

constexpr std::size_t chunk = 16384;  ///< segments

}  // namespace

float slice_order::position(const glm::vec3& place) const {
  const float relative = 0.5F + 0.5F * (glm::dot(place, direction) - middle) / extent;
  return slice_position(extent > 0.0F ? relative : 0.0F, slices);
}

void slice_order::update(const strands& fibres, const box& bounds, const glm::vec3& toward) {
  const std::size_t count = fibres.segment_count();
  if (slices == 0 || (segments.size() == count && sorts > 0 && !slice_sort::is_stale(direction, toward))) return;
  stopwatch watch;
  direction = toward;
  middle = 0.0F;
  extent = 0.0F;
  if (!bounds.empty()) {
    middle = glm::dot(0.5F * (bounds.lower + bounds.upper), direction);
    extent = glm::dot(0.5F * (bounds.upper - bounds.lower), glm::abs(direction));
  }
  const std::size_t chunks = (count + chunk - 1) / chunk;
  std::vector<std::uint32_t> slice(count);
  std::vector<std::uint32_t> places(std::max<std::size_t>(chunks, 1) * slices);
  const auto part = [&](std::size_t c) {
    return std::span<const std::uint32_t>(slice).subspan(c * chunk, std::min(chunk, count - c * chunk));
  };
  const auto places_of = [&](std::size_t c) { return std::span(places).subspan(c * slices, slices); };
  segments.resize(count);
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) {
    for (std::size_t s = c * chunk; s < std::min(count, (c + 1) * chunk); ++s) {
      const std::uint32_t i = fibres.segment[s];
      slice[s] = slice_sort::slice_of(position(fibres.point[i]), position(fibres.point[i + 1]), slices);
    }
    slice_sort::count(part(c), places_of(c));
  });
  slice_sort::place(places, slices);
  first.assign(places.begin(), places.begin() + slices);
  first.push_back(static_cast<std::uint32_t>(count));
  tbb::parallel_for(std::size_t{0}, chunks, [&](std::size_t c) {
    slice_sort::fill(part(c), static_cast<std::uint32_t>(c * chunk), places_of(c), segments);
  });
  ++sorts;
  sort_seconds += watch.lap();
}

}  // namespace pelage::frame
