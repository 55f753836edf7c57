// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/blends/blend_choice.hpp"

#include "frame/blends/unordered.hpp"
#include "frame/drawn_layers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace pelage::test {

using namespace frame;

using blend = std::function<glm::vec3(const layers&, const glm::vec3&)>;

const std::vector<blend> all_blends{
    blend_order_weighted, blend_weighted_average, blend_weighted_blended,
    [](const layers& all, const glm::vec3& background) { return blend_stochastic<8>(all, background, 5); }};

TEST_CASE("no order of layers changes a bit, and finite colours stay finite") {
  holds("any layers", [] {
    layers all = any_layers(64);
    if (*rc::gen::arbitrary<bool>()) all.push_back(any_layer(1000, all.front().where.depth, 1.0F));
    const glm::vec3 background = any_vec3(0.0F, 2.0F);
    layers other = all;
    std::shuffle(other.begin(), other.end(), std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
    for (const blend& by : all_blends) {
      const glm::vec3 seen = by(all, background);
      const glm::vec3 again = by(other, background);
      RC_ASSERT(std::memcmp(&seen, &again, sizeof(seen)) == 0);
      RC_ASSERT((std::isfinite(seen.x) && std::isfinite(seen.y) && std::isfinite(seen.z)));
    }
  });
}

TEST_CASE("without layers the background is left, one layer is over it, and layers of one colour need no order") {
  holds("where all blends are exact", [] {
    const glm::vec3 background = any_vec3(0.0F, 2.0F);
    const layers one{any_layer(0, any_float(1.0F, 9.0F), any_float(0.1F, 1.0F))};
    layers alike = any_layers(16);
    for (layer& l : alike) {
      l.radiance = alike.front().radiance;
      l.alpha = std::max(0.1F, alike.front().alpha);
    }
    for (const blend& by : all_blends) {
      RC_ASSERT(by({}, background) == background);
      RC_ASSERT(near(by(one, background), over_all(one, background), 1e-4));
      RC_ASSERT(near(by(alike, background), over_all(alike, background), 2e-3));
    }
  });
}

TEST_CASE("order-weighted blending is sorting where alphas are equal and an empty slice lies between any two layers") {
  holds("up to 65 layers in 128 slices", [] {
    std::vector<std::uint32_t> slices;
    for (std::uint32_t slice = 0; slice < 128; slice += 2)
      slices.push_back(slice);
    slices.push_back(127);  // whose end is whole
    std::shuffle(slices.begin() + 1, slices.end() - 1, std::mt19937(*rc::gen::arbitrary<std::uint32_t>()));
    std::swap(slices[1], slices.back());  // the first and the last slice always hold one
    slices.resize(*rc::gen::inRange<std::size_t>(2, 66));
    const float alpha = any_float(0.01F, 0.9F);
    layers all;
    for (const std::uint32_t slice : slices) {
      const float inside = slice == 0 ? 0.0F : slice == 127 ? 1.0F : 0.5F;  // from one end of the range to the other
      all.push_back(any_layer(slice, 3.0F + static_cast<float>(slice) + inside, alpha));
    }
    const glm::vec3 background = any_vec3(0.0F, 2.0F);
    RC_ASSERT(near(blend_order_weighted(all, background), over_all(all, background), 1e-3));
  });
}

TEST_CASE("an opaque layer hides what lies behind it from stochastic blending, as from sorting") {
  holds("an opaque layer in front", [] {
    layers all = any_layers(32);
    const layer front = any_layer(1000, 0.5F, 1.0F);
    all.push_back(front);
    RC_ASSERT(near(blend_stochastic<4>(all, any_vec3(0.0F, 2.0F), 7), glm::dvec3(front.radiance), 1e-4));
  });
}

TEST_CASE("stochastic blending comes nearer to sorting with more samples") {
  layers all;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> any(0.0F, 1.0F);
  for (std::uint32_t id = 0; id < 12; ++id)
    all.push_back({{any(random), id}, 0.3F, {any(random), any(random), any(random)}});
  const glm::dvec3 truth = over_all(all, glm::vec3(0.5F));
  const auto rms = [&](auto by) {
    double squares = 0.0;
    for (std::uint32_t pixel = 0; pixel < 500; ++pixel) {
      const glm::dvec3 d = glm::dvec3(by(all, glm::vec3(0.5F), stochastic_stream(1, pixel))) - truth;
      squares += glm::dot(d, d) / 1500.0;
    }
    return std::sqrt(squares);
  };
  const double with_4 = rms(blend_stochastic<4>);
  const double with_64 = rms(blend_stochastic<64>);
  CHECK(with_4 < 0.15);
  CHECK(with_64 < 0.3 * with_4);  // a quarter, if samples are independent
}

TEST_CASE("what is no blend is refused") {
  const auto refused = [](const std::string& text, const std::string& words) {
    CAPTURE(text);
    CHECK_THROWS_WITH_AS((void)parse_blend(text), doctest::Contains(words.c_str()), std::invalid_argument);
  };
  for (const char* argument : {"", ":", ":0", ":3", ":-4", ":x", ":8.0", ":128"})
    refused(std::string("stochastic") + argument, "N samples, one of 1, 2,");
  for (const char* text : {"exact:1", "k_buffer:", "depth_peeling:4"})
    refused(text, "nothing follows");
  for (const char* text : {"", "over", "Exact"})
    refused(text, "not exact, k_buffer");
  CHECK(parse_blend("stochastic:32").size == 32);
  CHECK(parse_blend("order_weighted").method == blend_method::order_weighted);
}

TEST_CASE("a tail is none, a mean or so many slices") {
  CHECK(parse_tail("none") == 0);
  CHECK(parse_tail("mean") == 1);
  for (const std::uint32_t slices : tail_slices)
    CHECK(parse_tail("sliced:" + std::to_string(slices)) == slices);
  for (const char* text : {"", "sliced", "sliced:1", "sliced:3", "sliced:-4", "sliced:128", "mean:1", "none:", "Mean"})
    CHECK_THROWS_AS((void)parse_tail(text), std::invalid_argument);
}

}  // namespace pelage::test
