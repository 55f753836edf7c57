// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shadows/k_buffer_shadow.hpp"

#include "frame/lit_fibres.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pelage::test {

using namespace frame;

TEST_CASE("with all fragments kept a texel passes the product of what is nearer, and nothing behind an opaque object") {
  holds("brute force at texel centres", [] {
    const lit_fibres scene;
    const k_buffer_shadow map = scene.map(order_method::full_sort, 1);
    for (int repeat = 0; repeat < 50; ++repeat) {
      const int x = any_texel();
      const int y = any_texel();
      const float depth = any_depth();
      const bool hidden = depth > map.limit()[static_cast<std::size_t>(y * texels + x)];
      const double passed = hidden ? 0.0 : product(scene.fragments_of(x, y, map), depth);
      RC_ASSERT(std::abs(static_cast<double>(map.transmittance_to(scene.centre(x, y, depth), 0.0F)) - passed) < 1e-5);
    }
  });
}

TEST_CASE("with K kept a texel is exact among them, then falls, and is exact again behind the farthest") {
  holds("the tail", [] {
    lit_fibres scene;
    scene.opaque.parts.clear();
    const std::uint32_t k = *rc::gen::element(1U, 2U, 4U);
    const k_buffer_shadow map =
        scene.map(*rc::gen::element(order_method::k_buffer, order_method::a_buffer, order_method::unrolled_list), k);
    const int x = any_texel();
    const int y = any_texel();
    const auto fragments = scene.fragments_of(x, y, map);
    const float kept_to = fragments.size() > k ? fragments[k - 1].first : 1e30F;
    const float farthest = fragments.empty() ? 0.0F : fragments.back().first;
    const double total = product(fragments, 1e30F);
    for (float depth = 0.0F; depth < 32.0F; depth += 0.0625F) {
      const double passed = static_cast<double>(map.transmittance_to(scene.centre(x, y, depth), 0.0F));
      if (depth <= kept_to || depth > farthest) {
        RC_ASSERT(std::abs(passed - product(fragments, depth)) < 1e-5);
      } else {
        RC_ASSERT((passed >= total - 1e-5 && passed <= product(fragments, kept_to) + 1e-5));
      }
    }
  });
}

TEST_CASE("at the mean depth of the fragments behind the K nearest half their optical depth is passed") {
  std::size_t asked = 0;
  holds("texels of overlapping fibres", [&] {
    lit_fibres scene;
    scene.opaque.parts.clear();
    const std::uint32_t k = *rc::gen::element(1U, 2U, 4U);
    const k_buffer_shadow map = scene.map(order_method::k_buffer, k);
    for (int texel = 0; texel < (texels - 1) * (texels - 1); ++texel) {
      const int x = texel % (texels - 1);
      const int y = texel / (texels - 1);
      const auto fragments = scene.fragments_of(x, y, map);
      double octaves = 0.0;
      double moment = 0.0;
      for (std::size_t i = k; i < fragments.size(); ++i) {
        const double one = -std::log2(std::max(fragments[i].second, 1e-6));
        octaves += one;
        moment += one * static_cast<double>(fragments[i].first);
      }
      if (!(octaves > 0.01 && octaves < 10.0)) continue;
      const auto mean = static_cast<float>(moment / octaves);
      if (mean - fragments[k - 1].first < 0.25F || fragments.back().first - mean < 0.25F) continue;
      const double before = product(fragments, std::nextafter(fragments[k - 1].first, 1e30F));
      const double half = before * std::exp2(-0.5 * octaves);
      RC_ASSERT(std::abs(static_cast<double>(map.transmittance_to(scene.centre(x, y, mean), 0.0F)) - half) < 1e-3);
      ++asked;
    }
  });
  CHECK(asked > 100);
}

TEST_CASE("what passes never rises with depth, stays in [0, 1], and is 1 before the first fragment") {
  holds("any place, any K", [] {
    const lit_fibres scene;
    const k_buffer_shadow map = scene.map(order_method::k_buffer, *rc::gen::element(1U, 2U, 4U, 64U));
    const float x = any_float(-2.0F, texels + 2.0F);
    const float y = any_float(-2.0F, texels + 2.0F);
    float before = 1.0F;
    RC_ASSERT(map.transmittance_to(scene.point(x, y, -1.0F), 0.0F) == 1.0F);
    RC_ASSERT(map.transmittance_to(scene.point(x, y, 0.5F), 0.0F) == 1.0F);
    for (float depth = 0.0F; depth < 32.0F; depth += 0.125F) {
      const float passed = map.transmittance_to(scene.point(x, y, depth), 0.0F);
      RC_ASSERT((passed <= before && passed >= 0.0F));
      before = passed;
    }
  });
}

TEST_CASE("outside the map everything is lit") {
  holds("beside it", [] {
    const lit_fibres scene;
    const k_buffer_shadow map = scene.map(order_method::k_buffer, 4);
    const float along = any_float(-4.0F, texels + 4.0F);
    const float beside =
        *rc::gen::arbitrary<bool>() ? any_float(-4.0F, -0.01F) : any_float(texels + 0.01F, texels + 4.0F);
    RC_ASSERT(map.transmittance_to(scene.point(along, beside, 31.0F), 0.0F) == 1.0F);
    RC_ASSERT(map.transmittance_to(scene.point(beside, along, 31.0F), 0.0F) == 1.0F);
  });
}

TEST_CASE("the rim of the map has the value of its texels' centres") {
  holds("all four sides", [] {
    const lit_fibres scene;
    const k_buffer_shadow map = scene.map(order_method::k_buffer, 4);
    const float along = any_float(0.5F, texels - 0.5F);
    const float out = any_float(0.01F, 0.5F);
    const float depth = any_depth();
    const auto same = [&](const glm::vec2& at, const glm::vec2& centre) {
      RC_ASSERT(map.transmittance_to(scene.point(at.x, at.y, depth), 0.0F) ==
                map.transmittance_to(scene.point(centre.x, centre.y, depth), 0.0F));
    };
    same({along, out}, {along, 0.5F});
    same({along, texels - out}, {along, texels - 0.5F});
    same({out, along}, {0.5F, along});
    same({texels - out, along}, {texels - 0.5F, along});
  });
}

TEST_CASE("between texels' centres it is their bilinear mean, and a bias asks nearer to the light") {
  holds("mean and bias", [] {
    const lit_fibres scene;
    const k_buffer_shadow map = scene.map(order_method::k_buffer, 4);
    const int x = any_texel();
    const int y = any_texel();
    const float depth = any_depth();
    const auto at = [&](int dx, int dy) { return map.transmittance_to(scene.centre(x + dx, y + dy, depth), 0.0F); };
    const float u = static_cast<float>(*rc::gen::inRange(0, 8)) / 8.0F;
    const float v = static_cast<float>(*rc::gen::inRange(0, 8)) / 8.0F;
    const float mean = glm::mix(glm::mix(at(0, 0), at(1, 0), u), glm::mix(at(0, 1), at(1, 1), u), v);
    const auto passed = [&](float to, float bias) {
      return map.transmittance_to(scene.point(static_cast<float>(x) + 0.5F + u, static_cast<float>(y) + 0.5F + v, to),
                                  bias);
    };
    RC_ASSERT(std::abs(passed(depth, 0.0F) - mean) < 1e-6F);
    for (float to = 1.0F; to < 32.0F; to += 0.25F)
      RC_ASSERT(passed(to, 0.25F) == passed(to - 0.25F, 0.0F));
  });
}

TEST_CASE("the fibres in the way never fall with depth, and are the sum of coverages behind the last or an object") {
  holds("fibres passed", [] {
    const lit_fibres scene;
    const k_buffer_shadow map = scene.map(order_method::k_buffer, *rc::gen::element(1U, 4U, 64U));
    const int x = any_texel();
    const int y = any_texel();
    double sum = 0.0;
    double stopped = 0.0;
    for (std::uint32_t s = 0; s < scene.fibres.segment_count(); ++s) {
      const pixel_fragment t = scene.fragments.at(s, x, y);
      if (t.depth >= map.limit()[static_cast<std::size_t>(y * texels + x)]) continue;
      sum += static_cast<double>(t.coverage);
      stopped += static_cast<double>(t.coverage * scene.fragments.mix(scene.fibres.opacity, s, t.along));
    }
    const passage all = map.passed_to(scene.centre(x, y, 100.0F), 0.0F);
    RC_ASSERT(all.transmittance == map.transmittance_to(scene.centre(x, y, 100.0F), 0.0F));
    if (stopped > 1e-3) RC_ASSERT(std::abs(static_cast<double>(all.fibres) - sum) < 1e-4 * (1.0 + sum));
    float before = 0.0F;
    for (float depth = 0.0F; depth < 32.0F; depth += 0.125F) {
      const passage passed = map.passed_to(scene.centre(x, y, depth), 0.0F);
      RC_ASSERT(passed.transmittance == map.transmittance_to(scene.centre(x, y, depth), 0.0F));
      RC_ASSERT(passed.fibres >= before);
      before = passed.fibres;
    }
    RC_ASSERT((map.passed_to(scene.centre(x, y, 0.5F), 0.0F).fibres == 0.0F && before <= all.fibres));
  });
}

}  // namespace pelage::test
