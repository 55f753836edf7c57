// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/atomic_tail.hpp>
#include <pelage/composite/sliced_tail.hpp>
#include <pelage/visibility/depth_range.hpp>

#include "composite/layers.hpp"
#include "property.hpp"
#include "visibility/cells.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

namespace pelage::test {

constexpr std::uint32_t slices = 16u;
using sliced = sliced_tail<slices>;

static_assert(sizeof(sliced) == 320);

std::array<std::uint32_t, 80> bits(const sliced& s) {
  return std::bit_cast<std::array<std::uint32_t, 80>>(s);
}

struct placed {
  float position;
  layer what;
};

std::vector<placed> draw_placed(float most_alpha = 1.0f) {
  std::vector<placed> all;
  for (const layer& each : draw_layers(most_alpha)) {
    all.push_back({16.0f * draw_share(), each});
  }
  return all;
}

sliced sliced_of(const std::vector<placed>& all) {
  sliced s = sliced::empty();
  for (const placed& each : all) {
    s.add(each.position, each.what.alpha, each.what.colour);
  }
  return s;
}

pixel_radiance<float> seen(const sliced& s) {
  return add_sliced_tail(empty_pixel<float>(), s);
}

/// Layer over layer, nearest first.
pixel_radiance<double> sorted(std::vector<placed> all) {
  std::stable_sort(all.begin(), all.end(), [](const placed& a, const placed& b) { return a.position < b.position; });
  pixel_radiance<double> pixel = empty_pixel<double>();
  for (const placed& each : all) {
    pixel = add_fibre(pixel, glm::dvec3(each.what.colour), glm::dvec3(0.0), static_cast<double>(each.what.alpha));
  }
  return pixel;
}

bool near(const pixel_radiance<float>& a, const pixel_radiance<double>& b, double error) {
  return glm::length(glm::dvec3(a.radiance) - b.radiance) < error &&
         glm::length(glm::dvec3(a.transmittance) - b.transmittance) < error;
}

TEST_CASE("any order of arrival and any split into parts gives the same bits") {
  holds("shuffled and merged", [] {
    const std::vector<placed> all = draw_placed();
    std::vector<placed> shuffled = all;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
    const auto cut = static_cast<std::ptrdiff_t>(*rc::gen::inRange<std::size_t>(0u, all.size() + 1u));
    sliced parts = sliced_of({shuffled.begin(), shuffled.begin() + cut});
    parts.merge(sliced_of({shuffled.begin() + cut, shuffled.end()}));
    RC_ASSERT(bits(parts) == bits(sliced_of(all)));
  });
}

TEST_CASE("fragments that no slice has two of are blended as if sorted") {
  holds("one a slice, in any order", [] {
    std::vector<float> order(slices);
    std::iota(order.begin(), order.end(), 0.0f);
    std::shuffle(order.begin(), order.end(), std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
    std::vector<placed> all;
    for (const layer& each : draw_layers()) {
      if (order.empty()) break;
      // Alphas that the sums hold to some digits.
      all.push_back({order.back() + 0.99f * draw_share(), {each.alpha < 1e-3f ? 0.0f : each.alpha, each.colour}});
      order.pop_back();
    }
    RC_ASSERT(near(seen(sliced_of(all)), sorted(all), 2e-3));
  });
}

TEST_CASE("slices that each have one colour are blended as if sorted") {
  holds("any number in each", [] {
    std::array<glm::vec3, slices> hue;
    std::generate(hue.begin(), hue.end(), draw_colour);
    std::vector<placed> all = draw_placed();
    for (placed& each : all) {
      each.what.alpha = std::max(each.what.alpha, 1e-3f);
      each.what.colour = hue[layer_at(each.position, slices)];
    }
    RC_ASSERT(near(seen(sliced_of(all)), sorted(all), 2e-3));
  });
}

TEST_CASE("what is seen lies between the least and the greatest of the colours, and lets the exact product pass") {
  holds("any layers", [] {
    const std::vector<placed> all = draw_placed();
    const pixel_radiance<float> pixel = seen(sliced_of(all));
    const pixel_radiance<double> truth = sorted(all);
    for (int c = 0; c < 3; ++c) {
      double least = 1.0;
      double most = 0.0;
      for (const placed& each : all) {
        if (each.what.alpha < 1e-3f) continue;
        least = std::min(least, double{each.what.colour[c]});
        most = std::max(most, double{each.what.colour[c]});
      }
      const double covered = 1.0 - truth.transmittance[c];
      RC_ASSERT(pixel.radiance[c] >= least * covered - 0.035);
      RC_ASSERT(pixel.radiance[c] <= most * covered + 0.035);
    }
    RC_ASSERT(glm::length(glm::dvec3(pixel.transmittance) - truth.transmittance) < 1e-4);
  });
}

TEST_CASE("one slice is a tail, and empty slices change nothing") {
  holds("the same bits", [] {
    sliced_tail<1> one = sliced_tail<1>::empty();
    tail whole = empty_tail();
    const auto all = draw_placed();
    for (const placed& each : all) {
      one.add(each.position / 16.0f, each.what.alpha, each.what.colour);
      whole = add_fragment(whole, each.what.alpha, each.what.colour);
    }
    const pixel_radiance<float> a = add_sliced_tail(empty_pixel<float>(), one);
    const pixel_radiance<float> b = add_tail(empty_pixel<float>(), whole);
    RC_ASSERT(a.radiance == b.radiance && a.transmittance == b.transmittance);
    sliced alone = sliced::empty();
    alone.slice[*rc::gen::inRange<std::size_t>(0u, slices)] = whole;
    RC_ASSERT(seen(alone).radiance == b.radiance && seen(alone).transmittance == b.transmittance);
  });
}

TEST_CASE("a depth beyond the range is in the slice at that end") {
  depth_range range = depth_range::empty();
  range.extend(2.0f);
  range.extend(3.0f);
  sliced s = sliced::empty();
  for (const float depth : {1.0f, 2.0f, 3.0f, 9.0f}) {
    s.add(slice_position(range.relative(depth), slices), 0.5f, glm::vec3(depth));
  }
  CHECK(mean_colour(s.slice.front()) == glm::vec3(1.5f));
  CHECK(mean_colour(s.slice.back()) == glm::vec3(6.0f));
}

TEST_CASE("the order of slices is kept: the nearer of two equal fragments weighs more by its alpha") {
  const float alpha = 0.5f;
  sliced s = sliced::empty();
  s.add(12.0f, alpha, glm::vec3(0.0f, 1.0f, 0.0f));
  s.add(3.0f, alpha, glm::vec3(1.0f, 0.0f, 0.0f));
  const glm::vec3 both = seen(s).radiance;
  CHECK(glm::length(both - glm::vec3(0.5f, 0.25f, 0.0f)) < 1e-6f);  // one tail has (0.375, 0.375, 0)
}

TEST_CASE("cells that threads fill, a texel a slice, hold the same tails") {
  holds("through atomic_tail", [] {
    constexpr std::uint32_t pixel = 2u;
    cells_of<atomic_cells<std::uint32_t>> cells(3u * slices * tail_words(), 0u);
    const std::vector<placed> all = draw_placed();
    for (const placed& each : all) {
      const std::uint32_t texel = pixel * slices + layer_at(each.position, slices);
      atomic_tail::add(cells, texel, add_fragment(empty_tail(), each.what.alpha, each.what.colour));
    }
    sliced loaded = sliced::empty();
    for (std::uint32_t i = 0u; i < slices; ++i) {
      loaded.slice[i] = atomic_tail::load(cells, pixel * slices + i);
    }
    RC_ASSERT(bits(loaded) == bits(sliced_of(all)));
  });
}

}  // namespace pelage::test
