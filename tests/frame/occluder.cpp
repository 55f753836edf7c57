// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/raster/occluder.hpp"

#include "frame/fibres.hpp"
#include "frame/raster/sweep.hpp"
#include "frame/scene/opaque_depth.hpp"

#include <cstdint>
#include <vector>

namespace pelage::test {

using namespace frame;

solids ball(const glm::vec3& centre, float radius) {
  solids s;
  s.parts.push_back({centre, glm::vec3(radius)});
  return s;
}

bool leaves_fragments_before(const raster& from, std::span<const float> limit, std::uint32_t segment) {
  bool any = false;
  from.for_each(segment, whole(from.from()), [&](int x, int y, const pixel_fragment& f) {
    any = any || !(f.depth >= limit[static_cast<std::size_t>(y * from.from().width + x)]);
  });
  return any;
}

TEST_CASE("no segment that leaves a fragment before its pixel's limit is taken for hidden") {
  holds("thin and thick fibres round a ball, seen by cameras and lights", [] {
    const solids opaque = ball(any_vec3(-0.5F, 0.5F), any_float(0.2F, 1.0F));
    const strands fibres = fibres_of(any_lines(8, glm::vec3(0.0F), 1.0F), any_float(0.0F, 0.3F), 1.0F);
    const bool perspective = *rc::gen::arbitrary<bool>();
    const view eye = perspective
                         ? any_perspective(any_float(0.5F, 4.0F), 0.05F)
                         : orthographic_view(glm::vec3(0.0F), any_vec3(0.1F, 1.0F), 3.0F, *rc::gen::inRange(1, 40));
    const raster from(fibres, eye, *rc::gen::arbitrary<bool>());
    const std::vector<float> limit = opaque_depths(eye, opaque);
    const occluder hidden(from, limit);
    for (std::uint32_t s = 0; s < fibres.segment_count(); ++s) {
      if (hidden.hides(s, from.bounds(s))) RC_ASSERT(!leaves_fragments_before(from, limit, s));
    }
  });
}

TEST_CASE("fibres behind a wall are hidden, and those before it and without limits are not") {
  holds("at any depth", [] {
    const strands fibres = fibres_of(any_lines(8, glm::vec3(0.0F), 1.0F), any_float(0.001F, 0.1F), 1.0F);
    const view eye = perspective_view({0.0F, 0.0F, 5.0F}, glm::vec3(0.0F), 0.3F, 50, 40, 0.1F);
    const raster from(fibres, eye, true);
    const std::vector<float> before(50 * 40, 3.8F);
    const std::vector<float> behind(50 * 40, 6.2F);
    for (std::uint32_t s = 0; s < fibres.segment_count(); ++s) {
      RC_ASSERT(occluder(from, before).hides(s, from.bounds(s)));
      RC_ASSERT(!occluder(from, behind).hides(s, from.bounds(s)));
      RC_ASSERT(!occluder(from, {}).hides(s, from.bounds(s)));
    }
  });
}

}  // namespace pelage::test
