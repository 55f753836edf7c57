// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <tbb/parallel_for.h>

#include <cstddef>
#include <cstdint>

#include "frame/base/random.hpp"
#include "frame/scene/view.hpp"
#include "truth/fibre_rays.hpp"

namespace pelage::truth {

/// The ray of a view through pixel coordinates, in the world.
[[nodiscard]] ray ray_through(const frame::view& from, double x, double y);

/// Calls `visit(x, y, pixel)` for all pixels, rows at once on all threads.
template <class Visit>
void for_each_pixel(const frame::view& from, const Visit& visit) {
  tbb::parallel_for(0, from.height, [&](int y) {
    for (int x = 0; x < from.width; ++x)
      visit(x, y, static_cast<std::size_t>(y) * static_cast<std::size_t>(from.width) + static_cast<std::size_t>(x));
  });
}

/// Independent rays through a pixel, evenly over its square: their mean is what a box filter sees. Pixels and seeds
/// have streams of their own, so that the same rays come from any number of threads.
class pixel_rays {
 public:
  pixel_rays(const frame::view& from, int x, int y, std::uint64_t seed)
      : from_(from),
        x_(x),
        y_(y),
        random_(seed, static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(from.width) +
                          static_cast<std::uint64_t>(x)) {}

  [[nodiscard]] ray next() {
    const double across = static_cast<double>(random_.unit());
    const double down = static_cast<double>(random_.unit());
    return ray_through(from_, x_ + across, y_ + down);
  }

  [[nodiscard]] frame::random_stream& random() { return random_; }

 private:
  const frame::view& from_;
  double x_, y_;
  frame::random_stream random_;
};

inline ray ray_through(const frame::view& from, double x, double y) {
  const double right = (x - 0.5 * from.width) / static_cast<double>(from.scale);
  const double up = (0.5 * from.height - y) / static_cast<double>(from.scale);
  const glm::dmat3 to_world = glm::transpose(glm::dmat3(from.rotation));
  const glm::dvec3 eye(from.eye);
  if (from.perspective) return {eye, to_world * glm::dvec3(right, up, -1.0)};
  return {eye + to_world * glm::dvec3(right, up, 0.0), to_world * glm::dvec3(0.0, 0.0, -1.0)};
}

}  // namespace pelage::truth
