// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace pelage::frame {

/// Places by which their neighbours are found: a k-d tree of their numbers. 4 bytes a place; O(n log n) to build.
class nearest_places {
 public:
  /// The places are finite and outlive the tree.
  explicit nearest_places(std::span<const glm::vec3> places);

  struct neighbour {
    double distance;  ///< length units
    std::uint32_t place;
  };

  /// The nearest others of a place, at most so many, nearest first, ties by number. O(most · log n) where places are
  /// spread, O(n) where they coincide.
  [[nodiscard]] std::vector<neighbour> nearest_to(std::uint32_t place, std::size_t most) const;

 private:
  void build(std::size_t begin, std::size_t end, int axis);

  struct search;
  void find(search& all, std::size_t begin, std::size_t end, int axis) const;

  std::span<const glm::vec3> places_;
  std::vector<std::uint32_t> order_;  ///< the middle of each range splits it by one coordinate
};

}  // namespace pelage::frame
