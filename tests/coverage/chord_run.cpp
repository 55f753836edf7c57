// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/coverage/chord_run.hpp>

#include "property.hpp"
#include "sweep.hpp"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace pelage::test {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

struct strand_point {
  glm::vec3 at;
  float radius;
};

/// A strand that curls and wavers, now and then turns back or stands still, in front of the origin.
std::vector<strand_point> random_strand() {
  const auto unit = [] { return static_cast<float>(*rc::gen::inRange(0, 100'001)) / 1e5f; };
  const auto either = [&] { return 2.0f * unit() - 1.0f; };
  const int count = *rc::gen::inRange(2, 40);
  const float step = 0.02f + 0.1f * unit();
  const float wildness = *rc::gen::element(0.0f, 0.02f, 0.1f, 0.5f, 2.0f);
  glm::vec3 way(either(), either(), either());
  strand_point p{{either(), either(), -3.0f + either()}, 0.001f + 0.01f * unit()};
  std::vector<strand_point> strand;
  for (int i = 0; i < count; ++i) {
    strand.push_back(p);
    way += wildness * glm::vec3(either(), either(), either());
    if (*rc::gen::inRange(0, 30) > 0) p.at += step / (glm::length(way) + 1e-3f) * way;
    p.radius = std::max(0.0f, p.radius * (1.0f + 0.2f * wildness * either()));
  }
  return strand;
}

struct tolerances {
  float place, radius;
};

/// The numbers of the points that stay.
template <class Tolerance>
std::vector<std::size_t> kept(const std::vector<strand_point>& strand, Tolerance&& tolerance) {
  std::vector<std::size_t> stay{0};
  tolerances room = tolerance(strand[0]);
  chord_run<float> run = begin_chord(strand[0].at, strand[0].radius, room.place);
  for (std::size_t i = 1; i < strand.size(); ++i) {
    const tolerances before = room;
    room = tolerance(strand[i]);
    if (!chord_reaches(run, strand[i].at, strand[i].radius, room.place) && i - 1 > stay.back()) {
      stay.push_back(i - 1);
      run = begin_chord(strand[i - 1].at, strand[i - 1].radius, before.place);
    }
    run = pass_point(run, strand[i].at, strand[i].radius, room.place, room.radius);
  }
  stay.push_back(strand.size() - 1);
  return stay;
}

/// Where on the line from a to b, in lengths of it, a point stands across from.
double place_on(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p, const glm::dvec3& along) {
  return glm::dot(p - a, along) / glm::dot(b - a, along);
}

TEST_CASE("what a chord stands for lies within the tolerance of the chord's own points, in their order") {
  holds("points, radii and places", [] {
    const std::vector<strand_point> strand = random_strand();
    const float scale = *rc::gen::element(1e-5f, 1e-3f, 1e-2f, 0.1f);
    const auto tolerance = [&](const strand_point& p) { return tolerances{-scale * p.at.z, 0.1f * p.radius}; };
    const std::vector<std::size_t> stay = kept(strand, tolerance);
    RC_ASSERT(std::is_sorted(stay.begin(), stay.end()));
    for (std::size_t k = 0; k + 1 < stay.size(); ++k) {
      const glm::dvec3 a = strand[stay[k]].at;
      const glm::dvec3 b = strand[stay[k + 1]].at;
      if (stay[k + 1] == stay[k] + 1) continue;
      const glm::dvec3 along = glm::normalize(glm::dvec3(strand[stay[k] + 1].at) - a);
      double before = 0.0;
      for (std::size_t i = stay[k] + 1; i < stay[k + 1]; ++i) {
        const double place = place_on(a, b, strand[i].at, along);
        const glm::dvec3 gap = glm::dvec3(strand[i].at) - (a + place * (b - a));
        const tolerances room = tolerance(strand[i]);
        RC_ASSERT(glm::length(gap) <= room.place + 2e-6);
        const double radius =
            strand[stay[k]].radius + place * (double{strand[stay[k + 1]].radius} - double{strand[stay[k]].radius});
        RC_ASSERT(std::abs(radius - strand[i].radius) <= room.radius + 1e-7);
        RC_ASSERT(place > before);
        RC_ASSERT(place < 1.0);
        before = place;
      }
    }
  });
}

TEST_CASE("the first and the last point stay, and a strand without tolerance loses nothing that bends") {
  holds("ends", [] {
    const std::vector<strand_point> strand = random_strand();
    const std::vector<std::size_t> stay = kept(strand, [](const strand_point&) { return tolerances{1e3f, 1e3f}; });
    RC_ASSERT(stay.front() == 0u);
    RC_ASSERT(stay.back() == strand.size() - 1);
    const std::vector<std::size_t> all = kept(strand, [](const strand_point&) { return tolerances{-1.0f, 1.0f}; });
    RC_ASSERT(all.size() == strand.size());
  });
}

TEST_CASE("a straight strand that tapers evenly is one chord") {
  std::vector<strand_point> strand;
  for (int i = 0; i <= 20; ++i)
    strand.push_back({glm::vec3(0.25f, 0.5f, -2.0f) + 0.125f * static_cast<float>(i) * glm::vec3(1.0f, -1.0f, 0.5f),
                      0.01f - 0.0004f * static_cast<float>(i)});
  CHECK(kept(strand, [](const strand_point&) { return tolerances{1e-6f, 1e-7f}; }).size() == 2);
}

TEST_CASE("a chord of a circle leaves it by the tolerance at most, and by no less than a third of it") {
  // How long chords are: the greatest that a tolerance allows at all has a sagitta of twice the tolerance.
  const double radius = 1.0;
  const double tolerance = 1e-3;
  std::vector<strand_point> strand;
  for (int i = 0; i <= 400; ++i) {
    const double angle = i * 0.005;
    strand.push_back({glm::vec3(radius * std::cos(angle), radius * std::sin(angle), -3.0), 0.01f});
  }
  const std::vector<std::size_t> stay = kept(strand, [&](const strand_point&) {
    return tolerances{static_cast<float>(tolerance), 1.0f};
  });
  for (std::size_t k = 0; k + 2 < stay.size(); ++k) {
    const double half = 0.5 * 0.005 * static_cast<double>(stay[k + 1] - stay[k]);
    const double sagitta = radius * (1.0 - std::cos(half));
    CHECK(sagitta <= tolerance);
    CHECK(sagitta >= tolerance / 3.0);
  }
}

TEST_CASE("a point that turns back, stands on the start, or is no number stays") {
  const glm::vec3 start(0.0f, 0.0f, -2.0f);
  const glm::vec3 ahead(1.0f, 0.0f, -2.0f);
  const chord_run<float> run = begin_chord(start, 0.1f, 1.0f);
  CHECK(chord_reaches(run, ahead, 0.1f, 1.0f));
  CHECK(chord_reaches(run, start, 0.5f, 1.0f));
  CHECK_FALSE(chord_reaches(run, {nan, 0.0f, 0.0f}, 0.1f, 1.0f));
  CHECK_FALSE(chord_reaches(run, {inf, 0.0f, 0.0f}, 0.1f, 1.0f));
  const chord_run<float> gone = pass_point(run, ahead, 0.1f, 10.0f, 10.0f);
  CHECK(chord_reaches(gone, {2.0f, 1.0f, -2.0f}, 0.2f, 1.0f));
  CHECK_FALSE(chord_reaches(gone, {0.9f, 0.0f, -2.0f}, 0.1f, 1.0f));
  CHECK_FALSE(chord_reaches(gone, ahead, 0.1f, 1.0f));
  CHECK_FALSE(chord_reaches(gone, {2.0f, nan, -2.0f}, 0.1f, 1.0f));
  CHECK_FALSE(chord_reaches(gone, {2.0f, 0.0f, -2.0f}, nan, 1.0f));
  for (const float none : {-1.0f, nan}) {
    CHECK(chord_reaches(run, ahead, 0.1f, none));
    CHECK_FALSE(chord_reaches(gone, {2.0f, 1.0f, -2.0f}, 0.2f, none));
  }
  const chord_run<float> still = pass_point(run, start, 0.5f, 10.0f, 10.0f);
  CHECK_FALSE(chord_reaches(still, ahead, 0.1f, 1.0f));
  for (const float none : {-1.0f, nan}) {
    CHECK_FALSE(chord_reaches(pass_point(run, ahead, 0.1f, none, 1.0f), {2.0f, 0.0f, -2.0f}, 0.1f, 1.0f));
    CHECK_FALSE(chord_reaches(pass_point(run, ahead, 0.1f, 1.0f, none), {2.0f, 0.0f, -2.0f}, 0.1f, 1.0f));
  }
  const chord_run<float> closed = begin_chord(start, 0.1f, -1.0f);
  CHECK(chord_reaches(closed, ahead, 0.1f, 1.0f));
  CHECK_FALSE(chord_reaches(pass_point(closed, ahead, 0.1f, 1.0f, 1.0f), {2.0f, 0.0f, -2.0f}, 0.1f, 1.0f));
  CHECK_FALSE(chord_reaches(pass_point(run, {nan, 0.0f, 0.0f}, 0.1f, 1.0f, 1.0f), {2.0f, 0.0f, -2.0f}, 0.1f, 1.0f));
}

TEST_CASE(
    "what moves in space by the tolerance of a view moves on its screen by the error at most, and can by nearly that") {
  const double scale = 300.0;
  const double near_plane = 0.1;
  const double slant = std::sqrt(1.0 + 2.0 * 0.5 * 0.5);  // of a view whose tangents are within 0.5
  double nearest = 0.0;
  for (const double error : {0.1, 0.5, 4.0, 64.0}) {
    worst_case worst;
    for (int i = 0; i < 40'000; ++i) {
      const auto [x, y, d, u, v] = even_point<5>(i);
      const double depth = on_log_scale(d, near_plane, 100.0);
      const glm::dvec2 tangent(x - 0.5, y - 0.5);
      const glm::dvec3 p(depth * tangent, -depth);
      const double move = screen_tolerance(error, depth, near_plane, scale, slant);
      const glm::dvec3 q = p + move * on_sphere(u, v);
      const double apart = glm::length(scale * glm::dvec2(q) / -q.z - scale * tangent);
      worst.see(apart / error, {depth, x, y, u, v});
    }
    CHECK(worst.error <= 1.0 + 1e-12);
    nearest = std::max(nearest, worst.error);
  }
  CHECK(nearest > 0.95);
}

TEST_CASE("nearer than the near plane, or nowhere, there is no tolerance") {
  CHECK(screen_tolerance(0.5f, 0.999f, 1.0f, 300.0f, 1.2f) == -1.0f);
  CHECK(screen_tolerance(0.5f, -5.0f, 1.0f, 300.0f, 1.2f) == -1.0f);
  CHECK(screen_tolerance(0.5f, nan, 1.0f, 300.0f, 1.2f) == -1.0f);
  CHECK(screen_tolerance(0.5f, 1.0f, 1.0f, 300.0f, 1.2f) > 0.0f);
  CHECK(screen_tolerance(0.0f, 1.0f, 1.0f, 300.0f, 1.2f) == 0.0f);
}

TEST_CASE("a strand through the near plane keeps both ends of each segment that crosses it") {
  holds("crossing", [] {
    const std::vector<strand_point> strand = random_strand();
    const float near_plane = 3.0f;
    const std::vector<std::size_t> stay = kept(strand, [&](const strand_point& p) {
      return tolerances{screen_tolerance(10.0f, -p.at.z, near_plane, 300.0f, 1.2f), 1.0f};
    });
    for (std::size_t i = 0; i + 1 < strand.size(); ++i) {
      const bool crosses = (-strand[i].at.z >= near_plane) != (-strand[i + 1].at.z >= near_plane);
      const bool is_kept =
          std::binary_search(stay.begin(), stay.end(), i) && std::binary_search(stay.begin(), stay.end(), i + 1);
      RC_ASSERT(!crosses || is_kept);
    }
  });
}

}  // namespace pelage::test
