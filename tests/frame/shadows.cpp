// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shadows/shadow_choice.hpp"

#include "frame/lit_fibres.hpp"
#include "frame/shadows/layer_layout.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace pelage::test {

using namespace frame;

const std::vector<std::string> all_shadows{"k_buffer",    "occupancy",      "opacity:4",
                                           "opacity:256", "deep_opacity:4", "deep_opacity:256",
                                           "deep:0.02",   "deep:0",         "deep_opacity_growing:8",
                                           "exact"};

cast_shadow cast_in(const lit_fibres& scene, const std::string& method, std::span<const std::uint32_t> order = {}) {
  return cast(parse_shadow(method), scene.fragments, scene.opaque, {order_method::k_buffer, 4, order}, true);
}

/// What some places and depths of a map let through, and the fibres before them.
std::vector<float> look_ups(const lit_fibres& scene, const shadow_map& map) {
  std::vector<float> seen;
  for (int place = 0; place < 64; ++place) {
    for (float depth = 0.0F; depth < 33.0F; depth += 0.5F) {
      const auto across = static_cast<float>(place % 8);
      const passage p =
          map.passed_to(scene.point(2.0F * across + 0.7F, static_cast<float>(place / 8) + 4.3F, depth), 0);
      seen.insert(seen.end(), {p.transmittance, p.fibres});
    }
  }
  return seen;
}

TEST_CASE("whatever a map keeps, light never rises with depth, and behind the last fibre the product of all is left") {
  holds("any fibres", [] {
    const lit_fibres scene;
    const int x = any_texel();
    const int y = any_texel();
    for (const std::string& method : all_shadows) {
      const cast_shadow made = cast_in(scene, method);
      const auto fragments = scene.fragments_of(x, y, *made.map);
      const float limit = made.map->limit()[static_cast<std::size_t>(y * texels + x)];
      RC_ASSERT(made.map->transmittance_to(scene.centre(x, y, -1.0F), 0.0F) == 1.0F);
      float before = 1.0F;
      for (float depth = 0.0F; depth < 64.0F; depth += 0.125F) {
        const float passed = made.map->transmittance_to(scene.centre(x, y, depth), 0.0F);
        RC_ASSERT((passed <= before && passed >= 0.0F));
        before = passed;
      }
      const double all = std::isinf(limit) ? product(fragments, 1e30F) : 0.0;
      const double bound = method == "deep:0.02" ? 0.02001 : 1e-5;
      RC_ASSERT(std::abs(static_cast<double>(before) - all) < bound);
    }
  });
}

TEST_CASE("deep shadow maps keep within their error of all fragments kept, and an error of 0 is those") {
  holds("any error", [] {
    const lit_fibres scene;
    const cast_shadow exact = cast_in(scene, "exact");
    const float error = any_float(0.0F, 0.5F);
    const cast_shadow some = cast_in(scene, "deep:" + std::to_string(error));
    const cast_shadow none = cast_in(scene, "deep:0");
    for (int repeat = 0; repeat < 200; ++repeat) {
      const glm::vec3 at = scene.centre(any_texel(), any_texel(), any_depth());
      const float truth = exact.map->transmittance_to(at, 0.0F);
      RC_ASSERT(std::abs(none.map->transmittance_to(at, 0.0F) - truth) < 1e-5F);
      RC_ASSERT(std::abs(some.map->transmittance_to(at, 0.0F) - truth) < error + 1e-5F);
    }
    RC_ASSERT(some.map->bytes() <= none.map->bytes());
  });
}

/// True if a map passes the product of what is nearer at a texel's depth; depths so near to a fragment that rounding
/// decides on its side count as well.
bool exact_at(const lit_fibres& scene, const shadow_map& map, int x, int y, float depth) {
  const auto fragments = scene.fragments_of(x, y, map);
  const bool hidden = depth > map.limit()[static_cast<std::size_t>(y * texels + x)];
  const bool beside =
      std::any_of(fragments.begin(), fragments.end(), [&](const auto& f) { return std::abs(f.first - depth) < 1e-3F; });
  const double passed = static_cast<double>(map.transmittance_to(scene.centre(x, y, depth), 0.0F));
  return hidden || beside || std::abs(passed - product(fragments, depth)) < 1e-3;
}

TEST_CASE("opacity maps and occupancy maps are exact at the ends of their layers and slabs") {
  holds("every end of a texel's", [] {
    const lit_fibres scene;
    const std::uint32_t layers = *rc::gen::elementOf(compiled_layers);
    const int x = any_texel();
    const int y = any_texel();
    const auto texel = static_cast<std::size_t>(y * texels + x);
    const auto check = [&](const std::string& method, float first, float extent, std::uint32_t parts) {
      const cast_shadow made = cast_in(scene, method);
      for (std::uint32_t i = 0; i < parts; ++i) {
        const float end = first + extent * static_cast<float>(i) / static_cast<float>(parts);
        RC_ASSERT(exact_at(scene, *made.map, x, y, end));
      }
    };
    const cast_shadow exact = cast_in(scene, "exact");
    const layer_layout model = layers_of_model(scene.fragments);
    check("opacity:" + std::to_string(layers), model.first_of(texel), model.extent, layers);
    order_report report;
    const layer_layout own = layers_of_texels(scene.fragments, exact.map->limit(), {}, report);
    check("deep_opacity:" + std::to_string(layers), own.first_of(texel), own.extent, layers);
    const auto fragments = scene.fragments_of(x, y, *exact.map);
    if (fragments.empty()) return;
    check("occupancy", fragments.front().first, fragments.back().first - fragments.front().first, 4);
  });
}

TEST_CASE("layers begin at a texel's nearest fragment, and nine texels in ten end within them") {
  holds("brute force", [] {
    const lit_fibres scene;
    const cast_shadow exact = cast_in(scene, "exact");
    order_report report;
    const layer_layout own = layers_of_texels(scene.fragments, exact.map->limit(), {}, report);
    const layer_layout model = layers_of_model(scene.fragments);
    int filled = 0;
    int beyond = 0;
    for (int t = 0; t < texels * texels; ++t) {
      const auto fragments = scene.fragments_of(t % texels, t / texels, *exact.map);
      if (fragments.empty()) continue;
      ++filled;
      beyond += fragments.back().first - fragments.front().first > own.extent ? 1 : 0;
      RC_ASSERT(own.first_of(static_cast<std::size_t>(t)) == fragments.front().first);
    }
    RC_ASSERT(10 * beyond <= filled);
    for (const glm::vec3& p : scene.fibres.point) {
      const float depth = -scene.light.to_view(p).z;
      RC_ASSERT((depth >= model.first_of(0) && depth <= model.first_of(0) + model.extent * 1.000001F));
    }
  });
}

TEST_CASE("every map is the same to the bit on 1, 2 and 4 threads and for shuffled segments, and tells its memory") {
  holds("look-ups everywhere", [] {
    const lit_fibres scene;
    const std::vector<std::uint32_t> order =
        shuffled(scene.fibres.segment_count(), *rc::gen::arbitrary<std::uint32_t>());
    for (const std::string& method : all_shadows) {
      const cast_shadow first = on_threads(1, [&] { return cast_in(scene, method); });
      for (const int threads : {2, 4}) {
        const cast_shadow other = on_threads(threads, [&] { return cast_in(scene, method, order); });
        RC_ASSERT(same_bits(look_ups(scene, *first.map), look_ups(scene, *other.map)));
        RC_ASSERT(first.map->bytes() == other.map->bytes());
        RC_ASSERT(first.report.fragments == other.report.fragments);
      }
    }
  });
}

TEST_CASE("a map's memory is what its method keeps of each texel") {
  const strands two = fibres_of({{{-4, 0.5F, 1}, {4, 0.5F, 1}}, {{-4, 0.5F, 0}, {4, 0.5F, 0}}}, 0.5F, 0.5F);
  const view light = flat_view(texels);
  const raster fragments(two, light, true);
  constexpr std::uint64_t shared = 8;  // the opaque object's depth, and fibres an octave
  const auto made = [&](const std::string& method) {
    return cast(parse_shadow(method), fragments, {}, {order_method::k_buffer, 16, {}}, true);
  };
  const auto bytes = [&](const std::string& method) { return made(method).map->bytes() / (texels * texels) - shared; };
  CHECK(bytes("occupancy") == 40);
  CHECK(bytes("opacity:16") == 64);
  CHECK(bytes("opacity:128") == 512);
  CHECK(bytes("deep_opacity:16") == 68);
  CHECK(bytes("deep_opacity_growing:8") == 36);
  const cast_shadow kept = made("k_buffer");
  CHECK(kept.report.fragments > 0);
  CHECK(kept.map->bytes() == texels * texels * (24 + shared) + 8 * kept.report.fragments);
}

TEST_CASE("what is no shadow method is refused") {
  const auto refused = [](const std::string& text, const std::string& words) {
    CAPTURE(text);
    CHECK_THROWS_WITH_AS((void)parse_shadow(text), doctest::Contains(words.c_str()), std::invalid_argument);
  };
  for (const char* argument : {"", ":", ":0", ":5", ":-4", ":4.0", ":16 ", ":4294967300", ":nan"}) {
    refused(std::string("opacity") + argument, "N layers, one of 4, 8,");
    refused(std::string("deep_opacity") + argument, "N layers, one of 4, 8,");
    refused(std::string("deep_opacity_growing") + argument, "N layers, one of 4, 8,");
  }
  for (const char* argument : {"", ":", ":-1", ":1.1", ":nan", ":inf", ":0.1x", ":1e99"})
    refused(std::string("deep") + argument, "in [0, 1]");
  for (const char* text : {"k_buffer:16", "occupancy:", "exact:0"})
    refused(text, "nothing follows");
  for (const char* text : {"", ":", "shallow", "Exact"})
    refused(text, "not k_buffer, occupancy");

  const strands none = fibres_of({}, 0.0F, 1.0F);
  const view light = flat_view(texels);
  const raster fragments(none, light, true);
  CHECK_THROWS_AS((void)cast({shadow_method::opacity, 5}, fragments, {}, {}, true), std::invalid_argument);
}

}  // namespace pelage::test
