// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/scene/detail.hpp"

#include <pelage/coverage/strand_share.hpp>

#include "frame/fibres.hpp"
#include "frame/frame.hpp"
#include "frame/model/built_in.hpp"
#include "frame/model/crowd.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <set>
#include <span>
#include <vector>

namespace pelage::test {

using namespace frame;

const hair_model& small_hair() {
  static const hair_model model = make_built_in(300, 24, 1);
  return model;
}

const strands& small_strands() {
  static const strands fibres = prepare_strands(small_hair(), {});
  return fibres;
}

std::vector<view> any_views() {
  const glm::vec3 eye = any_float(3.0F, 30.0F) * glm::normalize(any_vec3(-1.0F, 1.0F) + glm::vec3(0.0F, 0.0F, 1.5F));
  std::vector<view> views{perspective_view(eye, glm::vec3(0.0F), any_float(0.1F, 0.5F), 200, 150, 0.02F)};
  if (*rc::gen::arbitrary<bool>()) {
    views.push_back(orthographic_view(glm::vec3(0.0F), any_vec3(-1.0F, 1.0F) + glm::vec3(0.0F, -1.2F, 0.0F),
                                      any_float(3.0F, 12.0F), 150));
  }
  return views;
}

detailed_strands reduced(const detail_errors& errors, std::span<const view> views, int threads = 2,
                         std::span<const placement> copies = {}) {
  const placement here;
  return on_threads(threads, [&] {
    return strands_in_detail(small_strands(), small_hair().first_point, copies.empty() ? std::span(&here, 1) : copies,
                             views, errors);
  });
}

bool same_strands(const strands& a, const strands& b) {
  const auto same = [](const auto& x, const auto& y) { return same_bits(std::span(x), std::span(y)); };
  return same(a.point, b.point) && same(a.tangent, b.tangent) && same(a.radius, b.radius) &&
         same(a.opacity, b.opacity) && same(a.colour, b.colour) && same(a.segment, b.segment) && a.end_of == b.end_of &&
         a.same_opacity == b.same_opacity;
}

float distance_to_segment(const glm::vec2& p, const glm::vec2& a, const glm::vec2& b) {
  const glm::vec2 way = b - a;
  const float length2 = glm::dot(way, way);
  const float t = length2 > 0.0F ? std::clamp(glm::dot(p - a, way) / length2, 0.0F, 1.0F) : 0.0F;
  return glm::length(p - (a + t * way));
}

TEST_CASE("without errors the strands are the model's, bit for bit") {
  const std::vector<view> views{flat_view(64)};
  const detailed_strands all = reduced({}, views);
  CHECK(all.count == small_hair().strand_count());
  CHECK(same_strands(all.fibres, small_strands()));
}

TEST_CASE("any number of threads makes the same strands") {
  holds("threads", [] {
    const std::vector<view> views = any_views();
    const detail_errors errors{any_float(0.0F, 1.0F), any_float(0.0F, 2.0F)};
    const strands first = reduced(errors, views, 1).fibres;
    RC_ASSERT(same_strands(first, reduced(errors, views, 2).fibres));
    RC_ASSERT(same_strands(first, reduced(errors, views, 4).fibres));
  });
}

TEST_CASE("in every view all points of the model lie within the error of the strand that is drawn") {
  holds("on the screen", [] {
    const std::vector<view> views = any_views();
    const float error = *rc::gen::element(0.05F, 0.2F, 1.0F);
    const strands drawn = reduced({error, 0.0F}, views).fibres;
    RC_ASSERT(drawn.point.size() <= small_strands().point.size());
    const std::vector<std::uint32_t>& first = small_hair().first_point;
    std::size_t chord = 0;  // its first point among those drawn
    for (std::size_t s = 0; s + 1 < first.size(); ++s) {
      for (std::uint32_t i = first[s]; i < first[s + 1]; ++i) {
        const glm::vec3& p = small_strands().point[i];
        while ((drawn.end_of[chord + 1] & strands::last) == 0 && drawn.point[chord + 1] == p)
          ++chord;
        for (const view& v : views) {
          if (-v.to_view(p).z < v.near_plane) continue;
          const auto seen = [&](const glm::vec3& at) { return v.to_pixel(v.to_view(at)); };
          const glm::vec2 at = seen(p);
          if (at.x < 0.0F || at.y < 0.0F || at.x > static_cast<float>(v.width) || at.y > static_cast<float>(v.height))
            continue;
          RC_ASSERT(distance_to_segment(at, seen(drawn.point[chord]), seen(drawn.point[chord + 1])) <= error + 2e-3F);
        }
      }
      chord += 2;
    }
    RC_ASSERT(chord == drawn.point.size());
  });
}

TEST_CASE("a strand is drawn in a nearer view if it is in a farther one, and its ends always are") {
  holds("going away", [] {
    const float near = any_float(3.0F, 10.0F);
    const float far = near * any_float(1.0F, 4.0F);
    const auto strands_from = [&](float distance) {
      const std::vector<view> views{perspective_view({0.0F, 0.0F, distance}, glm::vec3(0.0F), 0.3F, 200, 200, 0.02F)};
      const strands found = reduced({0.5F, 1.0F}, views).fibres;
      std::set<std::vector<float>> roots;
      for (std::size_t i = 0; i < found.point.size(); ++i)
        if ((found.end_of[i] & strands::first) != 0)
          roots.insert({found.point[i].x, found.point[i].y, found.point[i].z});
      return roots;
    };
    const std::set<std::vector<float>> few = strands_from(far);
    const std::set<std::vector<float>> more = strands_from(near);
    RC_ASSERT(std::includes(more.begin(), more.end(), few.begin(), few.end()));
    RC_ASSERT(!few.empty());
  });
}

TEST_CASE("strands that are left out are in the widths of the others") {
  const hair_model model = make_built_in(20000, 4, 1);
  const strands whole = prepare_strands(model, {});
  const std::vector<view> views{perspective_view({0.0F, 0.0F, 40.0F}, glm::vec3(0.0F), 0.3F, 300, 300, 0.1F)};
  const placement here;
  const auto width_of = [](const strands& s) {
    double sum = 0.0;
    for (std::uint32_t i : s.segment)
      sum += s.radius[i];
    return sum;
  };
  for (const float error : {0.05F, 0.2F, 1.0F}) {
    const detailed_strands few = strands_in_detail(whole, model.first_point, std::span(&here, 1), views, {0.0F, error});
    CHECK(few.count < 0.8 * 20000);
    CHECK(width_of(few.fibres) == doctest::Approx(width_of(whole)).epsilon(0.01));
  }
}

TEST_CASE("a crowd's copies do not touch, and one alone stands where it is") {
  const upright_bounds one = upright_bounds::of(small_hair(), {}, {});
  for (const std::uint32_t n : {2U, 7U, 100U}) {
    const std::vector<placement> all = crowd_places(n, one, 1.8F);
    REQUIRE(all.size() == n);
    const auto axis = [&](const placement& p) { return p.to_world(glm::vec3(one.axis.x, 0.0F, one.axis.y)); };
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < i; ++j)
        CHECK(glm::length(axis(all[i]) - axis(all[j])) > 1.9F * one.radius);
  }
  CHECK(crowd_places(1, one, 1.0F)[0].to_world(glm::vec3(1.0F, 2.0F, 3.0F)) == glm::vec3(1.0F, 2.0F, 3.0F));
}

TEST_CASE("a crowd is as many models, each turned to its place") {
  const upright_bounds one = upright_bounds::of(small_hair(), {}, {});
  const std::vector<placement> places = crowd_places(5, one, 1.0F);
  const std::vector<view> views{flat_view(64)};
  const detailed_strands crowd = reduced({}, views, 2, places);
  const std::size_t points = small_strands().point.size();
  REQUIRE(crowd.fibres.point.size() == 5 * points);
  CHECK(crowd.count == 5 * small_hair().strand_count());
  CHECK(crowd.fibres.segment_count() == 5 * small_strands().segment_count());
  const box all = crowd_bounds(places, one);
  for (std::size_t i = 0; i < crowd.fibres.point.size(); ++i) {
    const glm::vec3 back = places[i / points].to_model(crowd.fibres.point[i]);
    CHECK(glm::length(back - small_strands().point[i % points]) < 1e-4F);
    CHECK(glm::all(glm::lessThanEqual(all.lower - 1e-4F, crowd.fibres.point[i])));
    CHECK(glm::all(glm::lessThanEqual(crowd.fibres.point[i], all.upper + 1e-4F)));
  }
}

frame_settings small_frame() {
  frame_settings s;
  s.width = 96;
  s.height = 72;
  s.k = 4;
  s.on_bust = true;
  return s;
}

frame_result draw(const frame_settings& settings, int threads = 2) {
  return on_threads(threads, [&] { return draw_frame(small_hair(), settings, [](const std::string&, double) {}); });
}

TEST_CASE("neither threads nor drawing order change a bit of a picture with less detail, of one head or a crowd") {
  for (const std::uint32_t crowd : {1U, 7U}) {
    frame_settings settings = small_frame();
    settings.detail = {0.3F, 0.2F};
    settings.crowd = crowd;
    const frame_result first = draw(settings, 1);
    CHECK(first.drawn.segments < crowd * small_strands().segment_count());
    CHECK(first.drawn.strands < crowd * small_hair().strand_count());
    for (const int threads : {2, 4}) {
      settings.shuffle = static_cast<std::uint64_t>(threads);
      CHECK(same_bits(draw(settings, threads).picture.pixels, first.picture.pixels));
    }
  }
}

TEST_CASE("a picture whose segments are within a tenth of a pixel is the full one within 0.001") {
  frame_settings settings = small_frame();
  settings.fibre_radius = 0.01F;
  const frame_result full = draw(settings);
  settings.detail.segment = 0.1F;
  const frame_result few = draw(settings);
  CHECK(few.drawn.segments < 0.95 * full.drawn.segments);
  CHECK(compare(few.picture, full.picture).rms < 0.001);
}

TEST_CASE("a turning camera has the detail of each of its frames") {
  frame_settings settings = small_frame();
  settings.detail = {0.3F, 0.2F};
  settings.from = glm::vec2(10.0F, 5.0F);
  const frame_result turned_to =
      on_threads(2, [&] { return draw_turn(small_hair(), settings, 3, 20.0F, [](const std::string&, double) {}); });
  settings.from = glm::vec2(50.0F, 5.0F);
  CHECK(same_bits(turned_to.picture.pixels, draw(settings).picture.pixels));
}

TEST_CASE("errors and crowds out of range are refused") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const detail_errors errors : {detail_errors{-1.0F, 0.0F}, {nan, 0.0F}, {0.0F, 65.0F}, {0.0F, nan}}) {
    frame_settings settings = small_frame();
    settings.detail = errors;
    CHECK_THROWS_AS((void)draw(settings), std::invalid_argument);
  }
  for (const std::uint32_t crowd : {0U, 4097U}) {
    frame_settings settings = small_frame();
    settings.crowd = crowd;
    CHECK_THROWS_AS((void)draw(settings), std::invalid_argument);
  }
}

}  // namespace pelage::test
