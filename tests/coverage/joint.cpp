// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/disc_strip.hpp>
#include <pelage/coverage/joint.hpp>

#include "property.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace pelage::test {
namespace {

/// A strand of points on the screen, seen along -z with pixels of side 1.
using strand = std::vector<glm::dvec2>;

strand_joint<double> joint_of(const strand& s, std::size_t i) {
  return {s[i], s[std::min(i + 1, s.size() - 1)] - s[i == 0 ? 0 : i - 1]};
}

/// What the segments of a strand cover of one pixel, by the recipe.
double share_of(const strand& s, double radius, const glm::dvec2& pixel) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < s.size(); ++i) {
    const double owned = owned_by_segment(joint_of(s, i), joint_of(s, i + 1), pixel);
    const auto pair = closest_points(glm::dvec3(pixel, 0.0), glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(s[i], -9.0),
                                     glm::dvec3(s[i + 1], -9.0));
    sum += owned * disc_strip_share(pair.distance, radius, 0.5);
  }
  return sum;
}

template <class See>
void for_each_pixel(const strand& s, See see) {
  glm::dvec2 low = s[0];
  glm::dvec2 high = s[0];
  for (const glm::dvec2& p : s) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  for (double y = std::floor(low.y) - 1.5; y < high.y + 2.0; y += 1.0) {
    for (double x = std::floor(low.x) - 1.5; x < high.x + 2.0; x += 1.0)
      see(glm::dvec2(x, y));
  }
}

/// The coverage of all pixels over the strand's own area.
double area_of(const strand& s, double radius) {
  double covered = 0.0;
  for_each_pixel(s, [&](const glm::dvec2& pixel) { covered += share_of(s, radius, pixel); });
  double length = 0.0;
  for (std::size_t i = 0; i + 1 < s.size(); ++i)
    length += std::hypot(s[i + 1].x - s[i].x, s[i + 1].y - s[i].y);
  return covered / (2.0 * radius * length);
}

glm::dvec2 towards(double angle) {
  return {std::cos(angle), std::sin(angle)};
}

}  // namespace

TEST_CASE("the parts of a straight strand cover each pixel as the whole does, however short they are") {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double worst = 0.0;
  for (const double length : {8.0, 2.0, 1.0, 0.5, 0.25}) {
    for (const double radius : {0.02, 0.1, 0.4, 2.0}) {
      for (int k = 0; k < 6; ++k) {
        const glm::dvec2 from(share(random), share(random));
        const glm::dvec2 way = towards(2.0 * std::numbers::pi * share(random));
        strand parts;
        for (double at = 0.0; at <= 16.0; at += length)
          parts.push_back(from + at * way);
        const strand whole = {parts.front(), parts.back()};
        for_each_pixel(whole, [&](const glm::dvec2& pixel) {
          worst = std::max(worst, std::abs(share_of(parts, radius, pixel) - share_of(whole, radius, pixel)));
        });
      }
    }
  }
  CHECK(worst < 1e-12);
}

TEST_CASE("a bent strand keeps its area, within 1 % for turns of up to 45 degrees, within 2 % for up to 90") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (const double most_turn : {45.0, 90.0}) {
    for (const double length : {4.0, 1.0, 0.5}) {
      double sum = 0.0;
      const int strands = 400;
      for (int k = 0; k < strands; ++k) {
        strand s = {{share(random), share(random)}};
        double angle = 2.0 * std::numbers::pi * share(random);
        for (int i = 0; i < static_cast<int>(24.0 / length); ++i) {
          s.push_back(s.back() + length * towards(angle));
          angle += (i / 3 % 2 == 0 ? 1.0 : -1.0) * share(random) * most_turn * std::numbers::pi / 180.0;
        }
        sum += area_of(s, 0.1);
      }
      CHECK(sum / strands < 1.01);
      CHECK(sum / strands > (most_turn < 60.0 ? 0.99 : 0.98));
    }
  }
}

TEST_CASE("a pixel on the line between two segments belongs to the second") {
  const strand_joint<float> start{{1.0f, 1.0f}, {2.0f, 0.0f}};
  const strand_joint<float> end{{3.0f, 1.0f}, {2.0f, 0.0f}};
  CHECK(owned_by_segment(start, end, glm::vec2(1.0f, 7.0f)) == 1.0f);
  CHECK(owned_by_segment(start, end, glm::vec2(3.0f, -7.0f)) == 0.0f);
  CHECK(owned_by_segment(start, end, glm::vec2(2.9999f, 1.0f)) == 1.0f);
  CHECK(owned_by_segment(start, end, glm::vec2(0.9999f, 1.0f)) == 0.0f);
}

TEST_CASE("a segment seen end on owns every pixel, NaN none") {
  const strand_joint<float> point{{1.0f, 1.0f}, {0.0f, 0.0f}};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(owned_by_segment(point, point, glm::vec2(1.0f, 1.0f)) == 1.0f);
  CHECK(owned_by_segment(point, point, glm::vec2(-400.0f, 3.0f)) == 1.0f);
  const strand_joint<float> start{{1.0f, 1.0f}, {2.0f, 0.0f}};
  const strand_joint<float> end{{3.0f, 1.0f}, {2.0f, 0.0f}};
  CHECK(owned_by_segment(start, end, glm::vec2(nan, 1.0f)) == 0.0f);
  CHECK(owned_by_segment({{nan, 1.0f}, {2.0f, 0.0f}}, end, glm::vec2(2.0f, 1.0f)) == 0.0f);
  CHECK(owned_by_segment({{1.0f, 1.0f}, {nan, 0.0f}}, end, glm::vec2(2.0f, 1.0f)) == 0.0f);
  CHECK(owned_by_segment(start, {{nan, 1.0f}, {2.0f, 0.0f}}, glm::vec2(2.0f, 1.0f)) == 0.0f);
  CHECK(owned_by_segment(start, {{3.0f, 1.0f}, {nan, 0.0f}}, glm::vec2(2.0f, 1.0f)) == 0.0f);
}

}  // namespace pelage::test
