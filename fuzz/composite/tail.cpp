// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// Tails do not depend on order, and nothing finite makes a NaN: any bits for opacities and colours.
#include <pelage/composite/atomic_tail.hpp>
#include <pelage/composite/over.hpp>
#include <pelage/composite/radiance.hpp>
#include <pelage/composite/tail.hpp>

#include "../input.hpp"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace {

using namespace pelage;

struct layer {
  float alpha;
  glm::vec3 colour;
};

bool equal(const tail& a, const tail& b) {
  return a.optical == b.optical && a.weight == b.weight && a.red == b.red && a.green == b.green && a.blue == b.blue;
}

template <class Layers>
tail in_turn(const Layers& layers) {
  tail t = empty_tail();
  for (const layer& l : layers) {
    t = add_fragment(t, l.alpha, l.colour);
  }
  return t;
}

void check_tail(std::vector<layer> layers, std::size_t cut) {
  const tail forwards = in_turn(layers);
  cut = std::min(cut, layers.size());
  const tail front = in_turn(std::vector<layer>(layers.begin(), layers.begin() + static_cast<std::ptrdiff_t>(cut)));
  const tail back = in_turn(std::vector<layer>(layers.begin() + static_cast<std::ptrdiff_t>(cut), layers.end()));
  fuzz::law(equal(merge(front, back), forwards) && equal(merge(back, front), forwards), "tails merge in any way");

  std::array<std::uint32_t, tail_words()> words{};
  atomic_cells<std::uint32_t> storage{words};
  std::reverse(layers.begin(), layers.end());
  for (const layer& l : layers) {
    atomic_tail::add(storage, 0u, add_fragment(empty_tail(), l.alpha, l.colour));
  }
  fuzz::law(equal(in_turn(layers), forwards), "a tail does not depend on the order of its fragments");
  fuzz::law(equal(atomic_tail::load(storage, 0u), forwards), "an atomic tail is the tail");

  const float passes = transmittance_of(forwards);
  fuzz::law(passes >= 0.0f && passes <= 1.0f, "a tail's transmittance is in [0, 1]");
  const glm::vec3 mean = mean_colour(forwards);
  fuzz::law(mean.x >= 0.0f && mean.y >= 0.0f && mean.z >= 0.0f && std::isfinite(mean.x + mean.y + mean.z),
            "a tail's colour is finite and not negative");
}

void check_finite(fuzz::input& in) {
  auto pixel = empty_pixel<float>();
  glm::vec4 over_all(0.0f);
  for (int i = 0; i < 16; ++i) {
    const glm::vec3 light = 1e4f * glm::vec3(in.unit(), in.unit(), in.unit());
    const glm::vec3 attenuation(in.unit(), in.unit(), in.unit());
    pixel = add_fibre(pixel, light, attenuation, in.unit());
    over_all = over(over_all, premultiply(light, in.unit()));
  }
  const glm::vec3 seen = resolve(pixel, glm::vec3(1.0f));
  fuzz::law(std::isfinite(seen.x + seen.y + seen.z), "a pixel's radiance is finite");
  for (int c = 0; c < 3; ++c) {
    fuzz::law(pixel.transmittance[c] >= 0.0f && pixel.transmittance[c] <= 1.0f, "a pixel's transmittance is in [0, 1]");
  }
  fuzz::law(std::isfinite(over_all.x + over_all.y + over_all.z + over_all.w), "over is finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in(data, size);
  const std::size_t cut = in.below(65u);
  fuzz::input again(data, size);
  check_finite(again);
  std::vector<layer> layers;
  while (!in.empty() && layers.size() < 64) {
    const auto alpha = in.take<float>();
    const auto red = in.take<float>();
    const auto green = in.take<float>();
    const auto blue = in.take<float>();
    layers.push_back(layer{alpha, glm::vec3(red, green, blue)});
  }
  check_tail(layers, cut);
  return 0;
}
