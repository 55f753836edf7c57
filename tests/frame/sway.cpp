// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/sway.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "frame/fibres.hpp"
#include "frame/frame.hpp"
#include "frame/model/built_in.hpp"
#include "frame/model/crowd.hpp"

namespace pelage::test {

using namespace frame;

/// Lines anywhere, and a wind of any strength.
struct blown_lines {
  hair_model model = model_of(any_lines(6, any_vec3(-20.0F, 20.0F), any_float(0.1F, 8.0F)), 0.05F, 0.5F);
  swaying_hair hair = make_swaying(model, any_float(0.01F, 1.0F));
  std::uint32_t at = *rc::gen::inRange(0U, 100000U);

  [[nodiscard]] strands moved() const {
    strands fibres = prepare_strands(model, {});
    sway(hair, at, fibres);
    return fibres;
  }
  [[nodiscard]] double arm(std::size_t i) const {
    return glm::distance(glm::dvec3(hair.rest[i].place), glm::dvec3(hair.rest[hair.rest[i].root].place));
  }
};

TEST_CASE("a root stays to the bit, and every point as far from its root as it rests") {
  holds("roots and arms", [] {
    const blown_lines lines;
    const strands fibres = lines.moved();
    for (std::size_t i = 0; i < fibres.point.size(); ++i) {
      const std::uint32_t root = lines.hair.rest[i].root;
      RC_ASSERT(fibres.point[root] == lines.model.points[root]);
      const double arm = glm::distance(glm::dvec3(fibres.point[i]), glm::dvec3(fibres.point[root]));
      RC_ASSERT(std::abs(arm - lines.arm(i)) < 2e-5 * (lines.arm(i) + 1.0));
    }
  });
}

TEST_CASE("no point moves farther than the amplitude's share of what bends, nor out of the bounds, at any time") {
  holds("bounds", [] {
    blown_lines lines;
    if (*rc::gen::arbitrary<bool>()) lines.hair = make_swaying(lines.model, 1.0F);  // where boxes are tightest
    const strands fibres = lines.moved();
    const box bounds = bounds_of(lines.model, lines.hair);
    const upright_bounds upright = upright_bounds::of(lines.model, lines.hair, {});
    const auto amplitude = static_cast<double>(lines.hair.amplitude);
    const auto reach = static_cast<double>(lines.hair.reach);
    for (std::size_t i = 0; i < fibres.point.size(); ++i) {
      const double way = glm::distance(glm::dvec3(fibres.point[i]), glm::dvec3(lines.model.points[i]));
      RC_ASSERT(way <= amplitude * lines.arm(i) * lines.arm(i) / reach + 1e-5);
      RC_ASSERT(glm::all(glm::lessThanEqual(bounds.lower, fibres.point[i])));
      RC_ASSERT(glm::all(glm::lessThanEqual(fibres.point[i], bounds.upper)));
      const box range = lines.hair.range_of(lines.hair.rest[i]);
      RC_ASSERT(glm::all(glm::lessThanEqual(range.lower, fibres.point[i])));
      RC_ASSERT(glm::all(glm::lessThanEqual(fibres.point[i], range.upper)));
      const glm::vec2 aside = glm::vec2(fibres.point[i].x, fibres.point[i].z) - upright.axis;
      RC_ASSERT(glm::length(aside) <= upright.radius);
      RC_ASSERT(fibres.point[i].y >= upright.lower);
      RC_ASSERT(fibres.point[i].y <= upright.upper);
    }
  });
}

TEST_CASE("hair of full reach stays in its bounds in the strongest wind, whichever way it stands") {
  holds("stiff hair", [] {
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::normal_distribution<float> any;
    std::vector<std::vector<glm::vec3>> hairs(500);
    for (std::vector<glm::vec3>& hair : hairs) {
      const glm::vec3 root(any(random), any(random), any(random));
      hair = {root, root + glm::normalize(glm::vec3(any(random), any(random), any(random)))};
    }
    const hair_model model = model_of(hairs, 0.01F, 0.5F);
    const swaying_hair hair = make_swaying(model, 1.0F);
    const wind now = hair.wind_at(*rc::gen::inRange(0U, 100000U));
    for (const rest_point& p : hair.rest) {
      const glm::vec3 there = now.moved(p.place, hair.rest[p.root].place);
      const box range = hair.range_of(p);
      RC_ASSERT(glm::all(glm::lessThanEqual(range.lower, there)));
      RC_ASSERT(glm::all(glm::lessThanEqual(there, range.upper)));
    }
  });
}

TEST_CASE("the bounds are those of what the wind does, within a quarter of the amplitude") {
  // A strand that hangs: the wind blows toward +x, so beside it there are 0.85 of the amplitude and 0.15.
  const hair_model model = model_of({{{0.0F, 0.0F, 0.0F}, {0.0F, -1.0F, 0.0F}, {0.0F, -2.0F, 0.0F}}}, 0.01F, 0.5F);
  const swaying_hair hair = make_swaying(model, 0.2F);
  box met;
  for (std::uint32_t frame = 0; frame < 3000; ++frame) {
    const wind now = hair.wind_at(frame);
    const glm::vec3 tip = now.moved(model.points[2], model.points[0]);
    met.lower = glm::min(met.lower, tip);
    met.upper = glm::max(met.upper, tip);
  }
  const box bounds = bounds_of(model, hair);
  CHECK(met.upper.x > 0.8F * 0.2F * 2.0F);
  CHECK(bounds.upper.x - met.upper.x < 0.25F * 0.2F * 2.0F);
  CHECK(bounds.lower.x > -0.16F * 0.2F * 2.0F);
  CHECK(bounds.lower.y > -2.01F);
}

TEST_CASE("tangents are those of the same points in a model that rests there") {
  holds("tangents", [] {
    const blown_lines lines;
    const strands fibres = lines.moved();
    hair_model there = lines.model;
    there.points.assign(fibres.point.begin(), fibres.point.end());
    const strands expected = prepare_strands(there, {});
    RC_ASSERT(std::equal(fibres.tangent.begin(), fibres.tangent.end(), expected.tangent.begin()));
  });
}

TEST_CASE("neighbours in space and in time stay neighbours: gusts travel, they do not jump") {
  holds("smooth", [] {
    const blown_lines lines;
    const float reach = lines.hair.reach;
    const glm::vec3 root = lines.model.points[0];
    const glm::vec3 place = root + reach * any_vec3(-0.5F, 0.5F);
    const wind now = lines.hair.wind_at(lines.at);
    const glm::vec3 aside = 0.001F * reach * any_vec3(-1.0F, 1.0F);
    const glm::vec3 apart = now.moved(place + aside, root + aside) - now.moved(place, root);
    RC_ASSERT(glm::length(apart) <= 0.01F * reach + 1e-4F);
    glm::vec3 before = now.moved(place, root);
    for (std::uint32_t later = 1; later < 75; ++later) {
      const glm::vec3 after = lines.hair.wind_at(lines.at + later).moved(place, root);
      RC_ASSERT(glm::distance(before, after) <= 0.2F * lines.hair.amplitude * reach);
      before = after;
    }
  });
}

frame_settings small_frame() {
  frame_settings s;
  s.width = 40;
  s.height = 32;
  s.k = 8;
  s.opacity = 0.4F;
  s.fibre_radius = 0.02F;
  s.on_bust = true;
  return s;
}

frame_result draw(const frame_settings& settings, std::uint32_t frames) {
  return draw_turn(make_built_in(60, 8, 1), settings, frames, 0.0F, [](const std::string&, double) {});
}

TEST_CASE("without a wind all frames are the picture at rest, bit for bit; in one each differs") {
  frame_settings settings = small_frame();
  const image rest = draw(settings, 1).picture;
  settings.sway = 0.0F;
  CHECK(same_bits(draw(settings, 3).picture.pixels, rest.pixels));
  settings.sway = 0.2F;
  const image first = draw(settings, 1).picture;
  CHECK_FALSE(same_bits(first.pixels, rest.pixels));
  CHECK_FALSE(same_bits(draw(settings, 2).picture.pixels, first.pixels));
}

TEST_CASE("moving hair is drawn as the same bits on any number of threads, shuffled, and by any structure") {
  frame_settings settings = small_frame();
  settings.sway = 0.2F;
  const image one = on_threads(1, [&] { return draw(settings, 3); }).picture;
  for (const order_method order :
       {order_method::k_buffer, order_method::a_buffer, order_method::unrolled_list, order_method::atomic_k_buffer}) {
    settings.order = order;
    settings.shuffle += 5;
    CHECK(same_bits(on_threads(3, [&] { return draw(settings, 3); }).picture.pixels, one.pixels));
  }
}

TEST_CASE("moving hair in less detail, of one head or a crowd, is the same bits on any number of threads, shuffled") {
  for (const std::uint32_t crowd : {1U, 3U}) {
    CAPTURE(crowd);
    frame_settings settings = small_frame();
    settings.sway = 0.2F;
    settings.detail = {0.5F, 2.0F};
    settings.crowd = crowd;
    const frame_result first = on_threads(1, [&] { return draw(settings, 3); });
    CHECK(first.drawn.strands < crowd * 60);
    CHECK(first.drawn.segments < 8 * first.drawn.strands);
    CHECK_FALSE(same_bits(draw(settings, 2).picture.pixels, first.picture.pixels));
    settings.shuffle = 5;
    CHECK(same_bits(on_threads(3, [&] { return draw(settings, 3); }).picture.pixels, first.picture.pixels));
  }
}

TEST_CASE(
    "the wind moves the strands from which those to draw are chosen: all of them are the picture without errors") {
  frame_settings settings = small_frame();
  settings.sway = 0.2F;
  for (const std::uint32_t frames : {1U, 9U}) {
    settings.detail = {};
    const image all = draw(settings, frames).picture;
    settings.detail.strand = 1e-6F;  // all strands are wider
    CHECK(same_bits(draw(settings, frames).picture.pixels, all.pixels));
  }
}

TEST_CASE("an amplitude out of range, and slices, are refused") {
  frame_settings settings = small_frame();
  for (const float amplitude : {-0.1F, 1.5F, std::numeric_limits<float>::quiet_NaN()}) {
    settings.sway = amplitude;
    CHECK_THROWS_AS((void)draw(settings, 1), std::invalid_argument);
  }
  settings.sway = 0.1F;
  for (const blend_method method : {blend_method::sliced, blend_method::sliced_clipped}) {
    settings.blend = {method, 16};
    CHECK_THROWS_AS((void)draw(settings, 1), std::invalid_argument);
  }
}

}  // namespace pelage::test
