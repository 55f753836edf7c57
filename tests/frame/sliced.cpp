// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/blends/sliced.hpp"

#include <pelage/order/slice_sort.hpp>
#include <pelage/visibility/opacity_map.hpp>

#include "frame/blends/blend_choice.hpp"
#include "frame/fibres.hpp"
#include "frame/frame.hpp"
#include "frame/model/built_in.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pelage::test {

using namespace frame;

frame_result draw(const hair_model& model, const frame_settings& settings, std::uint32_t frames = 1,
                  float degrees = 0.0F, int threads = 2) {
  return on_threads(threads,
                    [&] { return draw_turn(model, settings, frames, degrees, [](const std::string&, double) {}); });
}

bool same_picture(const frame_result& a, const frame_result& b) {
  return same_bits(a.picture.pixels, b.picture.pixels);
}

/// Seen along -z.
frame_settings small_frame(blend_method method, std::uint32_t slices) {
  frame_settings s;
  s.width = s.height = 64;
  s.shown = components::translucency;
  s.opacity = 0.4F;
  s.from = glm::vec2(0.0F);
  s.blend.method = method;
  s.blend.size = slices;
  return s;
}

glm::vec3 any_direction() {
  const glm::vec3 d = any_vec3(-1.0F, 1.0F);
  RC_PRE(glm::length(d) > 0.1F);
  return glm::normalize(d);
}

TEST_CASE("segments lie in the order of their farther ends' slices, then of their numbers, on any threads") {
  holds("any fibres and direction", [] {
    const strands fibres = fibres_of(any_lines(20, glm::vec3(1.0F, 2.0F, 3.0F), 2.0F), 0.01F, 0.5F);
    box bounds;
    for (const glm::vec3& p : fibres.point)
      bounds = {glm::min(bounds.lower, p), glm::max(bounds.upper, p)};
    const glm::vec3 direction = any_direction();
    slice_order order;
    order.slices = *rc::gen::element(8U, 64U, 256U);
    on_threads(1, [&] { order.update(fibres, bounds, direction); });
    const auto end_of = [&](std::uint32_t s) {
      return std::max(order.position(fibres.point[fibres.segment[s]]),
                      order.position(fibres.point[fibres.segment[s] + 1]));
    };
    const auto slice_of = [&](std::uint32_t s) { return std::min(std::floor(end_of(s)), float(order.slices) - 1.0F); };
    std::vector<std::uint32_t> expected(fibres.segment_count());
    std::iota(expected.begin(), expected.end(), 0U);
    std::stable_sort(expected.begin(), expected.end(), [&](auto a, auto b) { return slice_of(a) < slice_of(b); });
    RC_ASSERT(order.segments == expected);
    for (std::uint32_t slice = 0; slice < order.slices; ++slice) {
      for (std::uint32_t i = order.first[slice]; i < order.first[slice + 1]; ++i)
        RC_ASSERT(slice_of(order.segments[i]) == static_cast<float>(slice));
    }
    slice_order other;
    other.slices = order.slices;
    on_threads(4, [&] { other.update(fibres, bounds, direction); });
    RC_ASSERT(other.segments == order.segments);
  });
}

TEST_CASE("a position is where a place lies in the box's depths along the direction") {
  holds("any place in any box", [] {
    const glm::vec3 lower = any_vec3(-3.0F, 3.0F);
    const box bounds{lower, lower + any_vec3(0.5F, 3.0F)};
    slice_order order;
    order.slices = 256;
    order.update(strands{}, bounds, any_direction());
    double nearest = 1e9;
    double farthest = -1e9;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::dvec3 at((corner & 1) != 0 ? bounds.lower.x : bounds.upper.x,
                          (corner & 2) != 0 ? bounds.lower.y : bounds.upper.y,
                          (corner & 4) != 0 ? bounds.lower.z : bounds.upper.z);
      nearest = std::min(nearest, glm::dot(at, glm::dvec3(order.direction)));
      farthest = std::max(farthest, glm::dot(at, glm::dvec3(order.direction)));
    }
    const glm::vec3 place = bounds.lower + any_vec3(0.0F, 1.0F) * (bounds.upper - bounds.lower);
    const double depth = glm::dot(glm::dvec3(place), glm::dvec3(order.direction));
    RC_ASSERT(std::abs(order.position(place) - 256.0 * (depth - nearest) / (farthest - nearest)) < 1e-3);
  });
}

TEST_CASE("there are 256 slices where none are asked for, else one of a few numbers") {
  for (const auto& [word, method] :
       {std::pair{"sliced", blend_method::sliced}, {"sliced_clipped", blend_method::sliced_clipped}}) {
    const std::string name = word;
    CHECK(parse_blend(name).method == method);
    CHECK(parse_blend(name).size == 256);
    CHECK(parse_blend(name + ":64").method == method);
    CHECK(parse_blend(name + ":64").size == 64);
    for (const char* wrong : {":", ":0", ":7", ":-8", ":64x", ":2048"})
      CHECK_THROWS_AS((void)parse_blend(name + wrong), std::invalid_argument);
  }
}

TEST_CASE("neither threads nor the order of segments changes a bit of a sliced picture") {
  const hair_model hair = make_built_in(300, 12, 1);
  for (const blend_method method : {blend_method::sliced, blend_method::sliced_clipped}) {
    frame_settings settings = small_frame(method, 32);
    settings.shown = components::full;
    settings.fibre_radius = 0.015F;
    const frame_result first = draw(hair, settings, 1, 0.0F, 1);
    CHECK(first.passes.back().order.longest > 16);
    for (const int threads : {1, 2, 4}) {
      settings.shuffle += 1;
      CHECK(same_picture(draw(hair, settings, 1, 0.0F, threads), first));
    }
  }
}

/// Strands across the view, each in a plane of its own.
hair_model curtain() {
  std::vector<std::vector<glm::vec3>> lines;
  for (const int plane : {3, 0, 6, 1, 7, 2, 5, 4}) {
    const auto z = static_cast<float>(plane);
    lines.push_back({{-4.0F, -3.0F + z, z}, {0.0F, 0.5F * z, z}, {4.0F, 3.0F - z, z}});
  }
  return model_of(lines, 0.3F, 0.4F);
}

TEST_CASE("where a slice holds one strand, slices are sorting to the last bit") {
  frame_settings settings = small_frame(blend_method::exact, 0);
  const frame_result exact = draw(curtain(), settings);
  CHECK(exact.passes.back().order.longest > 3);
  for (const blend_method method : {blend_method::sliced, blend_method::sliced_clipped}) {
    settings = small_frame(method, 64);
    CHECK(same_picture(draw(curtain(), settings), exact));
  }
  settings = small_frame(blend_method::sliced, 8);
  settings.from = glm::vec2(90.0F, 0.0F);  // all strands are in all slices
  CHECK_FALSE(same_picture(draw(curtain(), settings), exact));
}

TEST_CASE("a long segment before another one is in order only where it is cut at the planes") {
  // From before the crossing strand to far behind it: its farther end says that all of it is behind.
  const hair_model crossing =
      model_of({{{-4.0F, 0.0F, 4.0F}, {4.0F, 0.0F, -4.0F}}, {{-3.0F, -2.0F, 1.0F}, {-2.0F, 2.0F, 1.0F}}}, 0.3F, 0.4F);
  frame_settings settings = small_frame(blend_method::exact, 0);
  const frame_result exact = draw(crossing, settings);
  settings = small_frame(blend_method::sliced_clipped, 64);
  CHECK(same_picture(draw(crossing, settings), exact));
  settings.blend.method = blend_method::sliced;
  CHECK_FALSE(same_picture(draw(crossing, settings), exact));
}

TEST_CASE("more slices come nearer to sorting, and clipped ones nearer than whole") {
  const hair_model hair = make_built_in(300, 12, 1);
  frame_settings settings = small_frame(blend_method::exact, 0);
  settings.fibre_radius = 0.015F;
  const image exact = draw(hair, settings).picture;
  double whole_error[2];
  double clipped_error[2];
  for (const int i : {0, 1}) {
    settings.blend = {blend_method::sliced, i == 0 ? 8U : 256U};
    whole_error[i] = compare(draw(hair, settings).picture, exact).rms;
    settings.blend.method = blend_method::sliced_clipped;
    clipped_error[i] = compare(draw(hair, settings).picture, exact).rms;
  }
  CHECK(whole_error[1] < whole_error[0]);
  CHECK(clipped_error[1] < 0.25 * clipped_error[0]);
  CHECK(clipped_error[1] < whole_error[1]);
}

TEST_CASE("a turning camera sorts anew once it has turned by more than 18.2 degrees, and only then") {
  const hair_model hair = make_built_in(60, 8, 1);
  frame_settings settings = small_frame(blend_method::sliced, 256);
  settings.from = glm::vec2(5.0F, 0.0F);
  CHECK(draw(hair, settings).drawn.sorts == 1);
  CHECK(draw(hair, settings, 5, 4.5F).drawn.sorts == 1);   // 18 degrees at the last
  CHECK(draw(hair, settings, 5, 4.6F).drawn.sorts == 2);   // 18.4
  CHECK(draw(hair, settings, 5, 10.0F).drawn.sorts == 3);  // at 0, 20 and 40
  CHECK(draw(hair, settings, 4, 19.0F).drawn.sorts == 4);
  frame_settings there = settings;
  there.from = turned(*settings.from, 19.0F, 3);
  CHECK(same_picture(draw(hair, settings, 4, 19.0F), draw(hair, there)));
  there.from = turned(*settings.from, 9.0F, 2);
  CHECK_FALSE(same_picture(draw(hair, settings, 3, 9.0F), draw(hair, there)));  // the order of 18 degrees before
  settings.blend = there.blend = {};
  CHECK(draw(hair, settings, 3, 9.0F).drawn.sorts == 0);
  CHECK(same_picture(draw(hair, settings, 3, 9.0F), draw(hair, there)));
}

TEST_CASE("running sums over sorted slices of clipped segments are the opacity map of their fragments") {
  holds("any segments through one texel, in slices or in any order", [] {
    constexpr std::uint32_t slices = 16;
    struct piece_of_segment {
      float first, second;
      slice_sort::piece part;
    };
    const auto position = [] { return static_cast<float>(*rc::gen::inRange(0, 16 * 16 + 1)) / 16.0F; };
    std::vector<piece_of_segment> pieces;
    std::vector<std::uint32_t> slice;
    opacity_map<slices> map = opacity_map<slices>::empty();
    const std::vector<float> places{1.0F / 32, 9.0F / 32, 21.0F / 32, 31.0F / 32};  // on a segment, of its fragments
    const auto optical = [](float place) { return 1U + static_cast<std::uint32_t>(1000.0F * place); };
    for (int segments = *rc::gen::inRange(1, 12); segments > 0; --segments) {
      const float first = position();
      const float second = position();
      for (std::uint32_t n = 0; n < slice_sort::piece_count(first, second, slices); ++n) {
        pieces.push_back({first, second, slice_sort::piece_at(first, second, slices, n)});
        slice.push_back(pieces.back().part.slice);
      }
      for (const float place : places)
        map.add(first + place * (second - first), optical(place));
    }
    map.accumulate();

    std::vector<std::uint32_t> counts(slices);
    std::vector<std::uint32_t> order(slice.size());
    slice_sort::count(slice, counts);
    slice_sort::place(counts, slices);
    slice_sort::fill(slice, 0, counts, order);
    std::uint32_t sum = 0;
    auto next = order.begin();
    for (std::uint32_t s = 0; s < slices; ++s) {
      for (; next != order.end() && slice[*next] == s; ++next) {
        const piece_of_segment& p = pieces[*next];
        for (const float place : places) {
          const bool after = p.second > p.first ? place >= p.part.begin : place > p.part.begin || p.part.begin == 0.0F;
          const bool before = p.second > p.first ? place < p.part.end : place <= p.part.end;
          if (after && before) sum += optical(place);
        }
      }
      RC_ASSERT(map.amount[s] == sum);
    }
  });
}

}  // namespace pelage::test
