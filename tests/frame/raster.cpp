// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/raster/sweep.hpp"

#include "frame/fibres.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace pelage::test {

using namespace frame;

using found_fragments = std::vector<std::tuple<int, int, float, float, float>>;

found_fragments swept(const raster& from, std::uint32_t segment, const pixel_rect& clip) {
  found_fragments found;
  from.for_each(segment, clip,
                [&](int x, int y, const pixel_fragment& f) { found.emplace_back(x, y, f.depth, f.coverage, f.along); });
  return found;
}

found_fragments asked_pixel_by_pixel(const raster& from, std::uint32_t segment, const pixel_rect& clip) {
  found_fragments found;
  for (int y = clip.y0; y < clip.y1; ++y) {
    for (int x = clip.x0; x < clip.x1; ++x) {
      const pixel_fragment f = from.at(segment, x, y);
      if (f.coverage > 0.0F) found.emplace_back(x, y, f.depth, f.coverage, f.along);
    }
  }
  return found;
}

/// A part of the picture, now and then all of it.
pixel_rect any_clip(const view& v) {
  const int x0 = *rc::gen::inRange(0, v.width);
  const int y0 = *rc::gen::inRange(0, v.height);
  const int x1 = *rc::gen::inRange(x0, v.width + 1);
  const int y1 = *rc::gen::inRange(y0, v.height + 1);
  return *rc::gen::arbitrary<bool>() ? whole(v) : pixel_rect{x0, y0, x1, y1};
}

/// Pixels of many segments go through the kernels together; what a clip lies beside must not disturb the others.
void assert_together_as_alone(const raster& from, const pixel_rect& clip) {
  std::vector<std::uint32_t> all(from.fibres().segment_count());
  std::iota(all.begin(), all.end(), 0U);
  std::vector<found_fragments> together(all.size());
  from.for_each(all, clip, [&](int x, int y, const pixel_fragment& f) {
    together[f.id].emplace_back(x, y, f.depth, f.coverage, f.along);
  });
  for (const std::uint32_t s : all)
    RC_ASSERT(together[s] == swept(from, s, clip));
}

void assert_sweep_is_complete(const strands& fibres, const view& v) {
  const raster from(fibres, v, *rc::gen::arbitrary<bool>());
  const pixel_rect clip = any_clip(v);
  std::uint32_t bounded = 0;
  from.for_each_bounds(0, fibres.segment_count(), [&](std::uint32_t segment, const pixel_rect& b) {
    const pixel_rect alone = from.bounds(segment);
    RC_ASSERT(segment == bounded++);
    RC_ASSERT((b.x0 == alone.x0 && b.y0 == alone.y0 && b.x1 == alone.x1 && b.y1 == alone.y1));
  });
  RC_ASSERT(bounded == fibres.segment_count());
  assert_together_as_alone(from, clip);
  const int side = *rc::gen::inRange(1, 12);
  for (int x = 0; x < v.width; x += side)
    assert_together_as_alone(from, {x, 0, std::min(x + side, v.width), v.height});
  for (std::uint32_t s = 0; s < fibres.segment_count(); ++s) {
    RC_ASSERT(swept(from, s, clip) == asked_pixel_by_pixel(from, s, clip));
    const pixel_rect b = from.bounds(s);
    for (const auto& [x, y, depth, coverage, along] : asked_pixel_by_pixel(from, s, whole(v))) {
      RC_ASSERT((x >= b.x0 && x < b.x1 && y >= b.y0 && y < b.y1));
      RC_ASSERT(depth >= v.near_plane);
      RC_ASSERT(coverage <= 1.0F);
      RC_ASSERT((along >= 0.0F && along <= 1.0F));
    }
  }
}

/// 10 to a power drawn evenly.
float any_radius(float lower_exponent, float upper_exponent) {
  return std::pow(10.0F, any_float(lower_exponent, upper_exponent));
}

TEST_CASE("a sweep finds exactly the pixels that hold the segment, and all lie within its bounds") {
  holds("perspective, fibres in front of the eye", [] {
    assert_sweep_is_complete(fibres_of(any_lines(3, glm::vec3(0.0F), 1.5F), any_radius(-4.0F, -0.7F), 1.0F),
                             any_perspective(3.0F, 0.05F));
  });
  holds("perspective, fibres that cross the near plane", [] {
    assert_sweep_is_complete(fibres_of(any_lines(3, glm::vec3(0.0F), 1.0F), any_radius(-4.0F, -1.0F), 1.0F),
                             any_perspective(any_float(-0.2F, 0.8F), 0.1F));
  });
  holds("perspective, fibres round the eye and thicker than their distance", [] {
    assert_sweep_is_complete(fibres_of(any_lines(3, glm::vec3(0.0F), 1.0F), any_radius(-1.0F, 0.5F), 1.0F),
                             any_perspective(any_float(-0.5F, 1.5F), any_radius(-3.0F, -0.5F)));
  });
  holds("orthographic", [] {
    const glm::vec3 direction = any_vec3(-1.0F, 1.0F) + glm::vec3(0.0F, 0.0F, 1e-3F);
    const view v = orthographic_view(any_vec3(-0.3F, 0.3F), direction, 2.0F, *rc::gen::inRange(1, 40), any_footprint());
    assert_sweep_is_complete(fibres_of(any_lines(3, glm::vec3(0.0F), 1.5F), any_radius(-4.0F, 0.3F), 1.0F), v);
  });
  holds("fibres far outside the picture", [] {
    const float far = any_radius(0.0F, 12.0F);
    assert_sweep_is_complete(fibres_of(any_lines(2, far * any_vec3(-1.0F, 1.0F), far), far * 0.01F, 1.0F),
                             any_perspective(1.0F, any_radius(-6.0F, -1.0F)));
  });
}

/// Coverage and number of fragments of each pixel.
std::map<std::pair<int, int>, std::pair<double, int>> coverage_by_pixel(const std::vector<glm::vec3>& line,
                                                                        float radius, const view& v) {
  const strands fibres = fibres_of({line}, radius, 1.0F);
  const raster from(fibres, v, true);
  std::map<std::pair<int, int>, std::pair<double, int>> sum;
  for (std::uint32_t s = 0; s < fibres.segment_count(); ++s) {
    from.for_each(s, whole(v), [&](int x, int y, const pixel_fragment& f) {
      auto& [coverage, count] = sum[{x, y}];
      coverage += static_cast<double>(f.coverage);
      ++count;
    });
  }
  return sum;
}

/// The farthest that any pixel's coverage moves when a straight fibre is cut in pieces; -1 where one counts twice.
double change_by_cutting(const glm::vec3& start, const glm::vec3& end, int pieces, float radius, const view& v) {
  std::vector<glm::vec3> cut;
  for (int i = 0; i <= pieces; ++i) {
    cut.push_back(glm::mix(start, end, static_cast<float>(i) / static_cast<float>(pieces)));
  }
  auto difference = coverage_by_pixel({start, end}, radius, v);
  for (const auto& [pixel, sum] : coverage_by_pixel(cut, radius, v)) {
    if (sum.second != 1) return -1.0;
    difference[pixel].first -= sum.first;
  }
  double most = 0.0;
  for (const auto& [pixel, sum] : difference)
    most = std::max(most, std::abs(sum.first));
  return most;
}

/// For a fibre that crosses the middle of the view, a quarter of it long at least and at up to 45° to the screen.
void assert_cutting_changes_less_than(double most, const view& v) {
  const float angle = any_float(0.0F, 2.0F * std::numbers::pi_v<float>);
  const glm::vec3 seen(std::cos(angle), std::sin(angle), any_float(-1.0F, 1.0F));
  const glm::vec3 half = any_float(0.25F, 1.0F) * v.direction_to_world(seen);
  const glm::vec3 middle = any_vec3(-0.3F, 0.3F);
  const double change =
      change_by_cutting(middle - half, middle + half, *rc::gen::inRange(2, 9), any_radius(-4.0F, -1.0F), v);
  RC_LOG() << change;
  RC_ASSERT(change >= 0.0);
  RC_ASSERT(change < most);
}

TEST_CASE("a straight fibre covers the same when it is cut in pieces, and no pixel counts two of them") {
  holds("orthographic pieces", [] {
    const view v = orthographic_view(glm::vec3(0.0F), any_vec3(-1.0F, 1.0F) + glm::vec3(0.0F, 0.0F, 1e-3F), 2.0F, 32);
    assert_cutting_changes_less_than(1e-5, v);
  });
  holds("perspective pieces", [] {
    // The line through a joint is drawn on the screen, and off the middle the nearest point of a ray lies beside it.
    assert_cutting_changes_less_than(1e-3,
                                     perspective_view({0.0F, 0.0F, 4.0F}, glm::vec3(0.0F), 0.268F, 32, 32, 0.01F));
  });
}

/// The summed coverage of a straight fibre over its area in pixels, mean over where the pixels' grid may lie.
double area_ratio(float length, float radius, float angle, bool antialias) {
  constexpr int steps = 12;
  const view v = flat_view(32);
  const glm::vec3 half = 0.5F * length * glm::vec3(std::cos(angle), std::sin(angle), 0.0F);
  double sum = 0.0;
  for (int i = 0; i < steps * steps; ++i) {
    const glm::vec3 middle((static_cast<float>(i % steps) + 0.5F) / steps,
                           (static_cast<float>(i / steps) + 0.5F) / steps, 0.0F);
    const strands fibres = fibres_of({{middle - half, middle + half}}, radius, 1.0F);
    const raster from(fibres, v, antialias);
    from.for_each(0, whole(v), [&](int, int, const pixel_fragment& f) { sum += static_cast<double>(f.coverage); });
  }
  const float width = antialias ? 2.0F * radius : std::max(2.0F * radius, 1.0F);
  return sum / (steps * steps) / static_cast<double>(length * width);
}

TEST_CASE("a straight fibre covers its area, at any angle and width") {
  holds("length times width", [] {
    const float angle = any_float(0.0F, 2.0F * std::numbers::pi_v<float>);
    const double ratio =
        area_ratio(any_float(8.0F, 24.0F), any_radius(-3.0F, 0.6F), angle, *rc::gen::arbitrary<bool>());
    RC_LOG() << ratio;
    RC_ASSERT(std::abs(ratio - 1.0) < 0.05);
  });
}

TEST_CASE("without anti-aliasing a pixel is covered whole or not at all") {
  holds("all or nothing", [] {
    const strands fibres = fibres_of(any_lines(3, glm::vec3(0.0F), 1.5F), any_radius(-4.0F, -0.7F), 1.0F);
    const view v = any_perspective(3.0F, 0.05F);
    const raster from(fibres, v, false);
    for (std::uint32_t s = 0; s < fibres.segment_count(); ++s) {
      from.for_each(s, whole(v), [&](int, int, const pixel_fragment& f) { RC_ASSERT(f.coverage == 1.0F); });
    }
  });
}

}  // namespace pelage::test
