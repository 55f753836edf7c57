// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading/shaded_fibres.hpp"

#include "frame/fibres.hpp"
#include "frame/raster/sweep.hpp"
#include "frame/shadows/k_buffer_shadow.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace pelage::test {

using namespace frame;

constexpr float whole_segments = std::numeric_limits<float>::infinity();

/// Fibres before a camera in a light that is near enough to change along them.
struct lit_scene {
  strands fibres = fibres_of(any_lines(4, glm::vec3(0.0F), 1.0F), 0.01F, 1.0F);
  view eye = perspective_view({0.0F, 0.0F, 5.0F}, glm::vec3(0.0F), 0.3F, 64, 64, 0.1F);
  raster from{fibres, eye, true};
  scene world{fibres, {}, {}, {glm::vec3(0.0F), 1.8F}, glm::vec3(0.5F), fibre_bsdf({}, glm::vec3(0.5F))};

  lit_scene() { world.lights.push_back({place_light(parse_light("point:1.5,2,1:1,0.9,0.8"), world.bounds), nullptr}); }

  [[nodiscard]] std::uint32_t any_segment() const { return *rc::gen::inRange(0U, fibres.segment_count()); }

  [[nodiscard]] glm::vec3 exact(std::uint32_t segment, float along) const {
    const glm::vec3 place = fibres.mix(fibres.point, segment, along);
    return world.fibre_radiance(segment, along, glm::normalize(eye.eye - place));
  }
};

bool near(const glm::vec3& a, const glm::vec3& b, float tolerance) {
  return glm::all(glm::lessThanEqual(glm::abs(a - b), glm::vec3(tolerance)));
}

TEST_CASE("at spacing 0 every place is shaded by itself") {
  holds("anywhere", [] {
    const lit_scene s;
    const shaded_fibres shades(s.world, s.from, {}, 0.0F);
    const std::uint32_t segment = s.any_segment();
    const float along = any_float(0.0F, 1.0F);
    RC_ASSERT(shades.evaluations() == 0U);
    RC_ASSERT(near(shades.at(segment, along), s.exact(segment, along), 1e-5F));
  });
}

TEST_CASE("at a segment's ends the shading is exact, and between two places it is mixed from them") {
  holds("whole segments", [] {
    const lit_scene s;
    const shaded_fibres shades(s.world, s.from, {}, whole_segments);
    const std::uint32_t segment = s.any_segment();
    const float along = any_float(0.0F, 1.0F);
    const glm::vec3 first = s.exact(segment, 0.0F);
    const glm::vec3 last = s.exact(segment, 1.0F);
    RC_ASSERT(near(shades.at(segment, 0.0F), first, 1e-5F));
    RC_ASSERT(near(shades.at(segment, 1.0F), last, 1e-5F));
    RC_ASSERT(near(shades.at(segment, along), glm::mix(first, last, along), 1e-5F));
  });
  holds("places a spacing apart at most", [] {
    const lit_scene s;
    const float spacing = any_float(1.0F, 16.0F);
    const shaded_fibres shades(s.world, s.from, {}, spacing);
    const std::uint32_t segment = s.any_segment();
    const float intervals = std::max(1.0F, std::ceil(s.from.length_on_screen(segment) / spacing));
    const float before = std::floor(any_float(0.0F, 1.0F) * intervals);
    const float inside = any_float(0.0F, 1.0F);
    const glm::vec3 expected =
        glm::mix(s.exact(segment, before / intervals), s.exact(segment, (before + 1.0F) / intervals), inside);
    RC_ASSERT(near(shades.at(segment, (before + inside) / intervals), expected, 1e-4F));
  });
}

TEST_CASE("two segments that meet are shaded alike where they meet, and points are shaded once") {
  holds("at joints", [] {
    const lit_scene s;
    const shaded_fibres shades(s.world, s.from, {}, whole_segments);
    RC_ASSERT(shades.evaluations() == s.fibres.point.size());
    for (std::uint32_t segment = 0; segment + 1 < s.fibres.segment_count(); ++segment) {
      if (s.fibres.segment[segment] + 1 != s.fibres.segment[segment + 1]) continue;
      RC_ASSERT(near(shades.at(segment, 1.0F), shades.at(segment + 1, 0.0F), 0.0F));
    }
  });
}

TEST_CASE("what no limit hides is shaded as without limits, and what is hidden whole is not shaded") {
  holds("behind and before a wall", [] {
    const lit_scene s;
    const std::vector<float> wall(64 * 64, any_float(3.5F, 6.5F));
    const float spacing = any_float(1.0F, 16.0F);
    const shaded_fibres all(s.world, s.from, {}, spacing);
    const shaded_fibres some(s.world, s.from, wall, spacing);
    for (std::uint32_t segment = 0; segment < s.fibres.segment_count(); ++segment) {
      s.from.for_each(segment, whole(s.eye), [&](int, int, const pixel_fragment& f) {
        if (f.depth < wall.front()) RC_ASSERT(near(some.at(segment, f.along), all.at(segment, f.along), 0.0F));
      });
    }
    RC_ASSERT(some.evaluations() <= all.evaluations());
    RC_ASSERT(shaded_fibres(s.world, s.from, std::vector<float>(64 * 64, 3.0F), spacing).evaluations() == 0U);
  });
}

TEST_CASE("places that are shaded together get the bits that each gets alone, whatever scatters") {
  holds("in maps' shadows", [] {
    const lit_scene s;
    fibre_look look;
    look.model = *rc::gen::element(bsdf_model::kajiya_kay, bsdf_model::marschner, bsdf_model::chiang);
    scene world{s.fibres, {}, {}, s.world.bounds, s.world.sky, fibre_bsdf(look, glm::vec3(0.5F))};
    for (const char* text : {"point:1.5,2,1:1,0.9,0.8", "directional:1,1,-1:0.5,0.6,0.7", "spot:0,3,1:1,1,1:80"}) {
      const light placed = place_light(parse_light(text), world.bounds);
      const view from = light_view(placed, world.bounds, 24);
      const raster seen(s.fibres, from, true);
      auto map = std::make_unique<k_buffer_shadow>(seen, solids{});
      run_order_pass(seen, map->limit(), {order_method::k_buffer, 2, {}}, *map);
      world.lights.push_back({placed, std::move(map)});
    }
    std::vector<lit_place> places(static_cast<std::size_t>(*rc::gen::inRange(1, 300)));
    for (lit_place& p : places)
      p = {s.any_segment(), any_float(0.0F, 1.0F), glm::normalize(any_vec3(0.1F, 1.0F))};
    std::vector<glm::vec3> together(places.size());
    world.fibre_radiance(places, together);
    std::vector<glm::vec3> alone;
    for (const lit_place& p : places)
      alone.push_back(world.fibre_radiance(p.segment, p.along, p.to_eye));
    RC_ASSERT(same_bits(together, alone));
  });
}

}  // namespace pelage::test
