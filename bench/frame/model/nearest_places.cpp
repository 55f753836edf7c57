// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/nearest_places.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace pelage::frame {

nearest_places::nearest_places(std::span<const glm::vec3> places) : places_(places), order_(places.size()) {
  std::iota(order_.begin(), order_.end(), 0U);
  build(0, order_.size(), 0);
}

void nearest_places::build(std::size_t begin, std::size_t end, int axis) {
  if (end - begin < 2) return;
  const auto at = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t middle = begin + (end - begin) / 2;
  std::nth_element(at(begin), at(middle), at(end),
                   [&](std::uint32_t a, std::uint32_t b) { return places_[a][axis] < places_[b][axis]; });
  build(begin, middle, (axis + 1) % 3);
  build(middle + 1, end, (axis + 1) % 3);
}

struct nearest_places::search {
  std::uint32_t from;
  std::size_t most;
  std::vector<neighbour> found;

  [[nodiscard]] bool may_hold(double distance) const {
    return found.size() < most || distance <= found.back().distance;
  }
  void offer(neighbour one) {
    const auto nearer = [](const neighbour& a, const neighbour& b) {
      return std::tie(a.distance, a.place) < std::tie(b.distance, b.place);
    };
    found.insert(std::upper_bound(found.begin(), found.end(), one, nearer), one);
    if (found.size() > most) found.pop_back();
  }
};

void nearest_places::find(search& all, std::size_t begin, std::size_t end, int axis) const {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const std::uint32_t here = order_[middle];
  const glm::dvec3 way = glm::dvec3(places_[here]) - glm::dvec3(places_[all.from]);
  if (here != all.from) all.offer({glm::length(way), here});
  const bool is_before = way[axis] > 0.0;
  const int next = (axis + 1) % 3;
  is_before ? find(all, begin, middle, next) : find(all, middle + 1, end, next);
  if (!all.may_hold(std::abs(way[axis]))) return;
  is_before ? find(all, middle + 1, end, next) : find(all, begin, middle, next);
}

std::vector<nearest_places::neighbour> nearest_places::nearest_to(std::uint32_t place, std::size_t most) const {
  search all{place, most, {}};
  if (most > 0) find(all, 0, order_.size(), 0);
  return all.found;
}

}  // namespace pelage::frame
