// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/lit_fibres.hpp"
#include "frame/shadows/layer_layout.hpp"
#include "frame/shadows/shadow_choice.hpp"

#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pelage::test {

using namespace frame;

cast_shadow cast_growing(const lit_fibres& scene, std::uint32_t layers) {
  const shadow_choice choice{shadow_method::deep_opacity_growing, layers};
  return cast(choice, scene.fragments, scene.opaque, {order_method::k_buffer, 4, {}}, true);
}

/// Octaves before a depth, by the definition: layer i of n begins at i (i + 1) / (n (n + 1)) of the extent behind the
/// nearest fragment, and lets through by how much of it lies before the depth; what lies beyond the last is in the
/// last.
double octaves_before(const std::vector<std::pair<float, double>>& fragments, double extent, int layers, double depth) {
  const double first = static_cast<double>(fragments.front().first);
  const auto begin = [&](int i) { return first + extent * i * (i + 1.0) / (layers * (layers + 1.0)); };
  double sum = 0.0;
  for (int i = 0; i < layers; ++i) {
    double held = 0.0;
    for (const auto& [at, passed] : fragments) {
      const bool is_last = i + 1 == layers;
      if (at >= begin(i) && (is_last || at < begin(i + 1))) held -= std::max(std::log2(std::max(passed, 1e-30)), -32.0);
    }
    const double share = (depth - begin(i)) / (begin(i + 1) - begin(i));
    sum += held * std::min(std::max(share, 0.0), 1.0);
  }
  return sum;
}

/// True where rounding may put a fragment into the layer beside its own.
bool is_near_end(const std::vector<std::pair<float, double>>& fragments, double extent, int layers) {
  for (const auto& [at, passed] : fragments) {
    const double widths = (static_cast<double>(at - fragments.front().first)) / extent * layers * (layers + 1.0) / 2.0;
    const double layer = 0.5 * (std::sqrt(8.0 * widths + 1.0) - 1.0);
    if (at > fragments.front().first && std::abs(layer - std::round(layer)) < 1e-3) return true;
  }
  return false;
}

TEST_CASE("growing layers let through what layers of 1, 2, 3... widths hold, summed up by hand") {
  holds("any depth of any texel", [] {
    const lit_fibres scene;
    const std::uint32_t layers = *rc::gen::element(4U, 8U, 16U, 32U);
    const cast_shadow made = cast_growing(scene, layers);
    order_report report;
    const layer_layout own = layers_of_texels(scene.fragments, made.map->limit(), {}, report);
    const int x = any_texel();
    const int y = any_texel();
    const auto fragments = scene.fragments_of(x, y, *made.map);
    if (fragments.empty() || own.extent < 0.1F ||
        is_near_end(fragments, static_cast<double>(own.extent), static_cast<int>(layers)))
      return;
    for (int repeat = 0; repeat < 20; ++repeat) {
      const float depth = any_depth();
      if (depth > made.map->limit()[static_cast<std::size_t>(y * texels + x)]) continue;
      const double octaves = octaves_before(fragments, static_cast<double>(own.extent), static_cast<int>(layers),
                                            static_cast<double>(depth));
      const double passed = static_cast<double>(made.map->transmittance_to(scene.centre(x, y, depth), 0.0F));
      RC_ASSERT(std::abs(passed - std::exp2(-octaves)) < 2e-3);
    }
  });
}

TEST_CASE("growing layers are narrowest where light enters: nearer to all fragments kept there than equal ones") {
  // Fibres side by side along the light, one a unit, each letting half of the light through.
  std::vector<std::vector<glm::vec3>> lines;
  for (int i = 0; i < 16; ++i)
    lines.push_back({{-8.0F, 0.5F, -static_cast<float>(i)}, {8.0F, 0.5F, -static_cast<float>(i)}});
  const strands fibres = fibres_of(lines, 2.0F, 0.5F);
  const view light = flat_view(texels);
  const raster fragments(fibres, light, true);
  const auto made = [&](const std::string& method) {
    return cast(parse_shadow(method), fragments, {}, {order_method::k_buffer, 16, {}}, true);
  };
  const cast_shadow exact = made("exact");
  const cast_shadow equal = made("deep_opacity:4");
  const cast_shadow growing = made("deep_opacity_growing:4");
  const auto error = [&](const shadow_map& map) {
    double squares = 0.0;
    for (float z = 0.5F; z > -3.0F; z -= 0.125F) {
      const glm::vec3 at(0.5F, 0.5F, z);
      const double apart = static_cast<double>(map.transmittance_to(at, 0.0F) - exact.map->transmittance_to(at, 0.0F));
      squares += apart * apart;
    }
    return std::sqrt(squares);
  };
  CHECK(error(*growing.map) > 0.0);
  CHECK(error(*growing.map) < error(*equal.map));
  CHECK(growing.map->bytes() == equal.map->bytes());
}

}  // namespace pelage::test
