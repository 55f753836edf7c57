// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/blends/moments.hpp"

#include "frame/blends/blend_choice.hpp"
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

const std::vector<blend> by_moments{blend_moments<power_moments<4>>, blend_moments<power_moments<6>>,
                                    blend_moments<trigonometric_moments<2>>, blend_moments<trigonometric_moments<3>>};
const std::vector<blend> all_blends{blend_layers<1>, blend_layers<4>, by_moments[0],
                                    by_moments[1],   by_moments[2],   by_moments[3]};

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

TEST_CASE("without layers the background is left; one, any number of one colour, and an opaque nearest are sorted") {
  holds("where all blends are exact", [] {
    const glm::vec3 background = any_vec3(0.0F, 2.0F);
    const layers one{any_layer(0, any_float(-9.0F, 9.0F), any_float(0.001F, 1.0F))};
    layers alike = any_layers(16);
    for (layer& l : alike) {
      l.radiance = alike.front().radiance;
      l.alpha = std::max(0.1F, l.alpha);
    }
    layers hidden = any_layers(32);
    hidden.push_back(any_layer(1000, 0.5F, 1.0F));
    for (const blend& by : all_blends) {
      RC_ASSERT(by({}, background) == background);
      RC_ASSERT(near(by(one, background), over_all(one, background), 2e-3 * static_cast<double>(one[0].alpha) + 2e-6));
      RC_ASSERT(near(by(alike, background), over_all(alike, background), 2e-3));
    }
    for (const blend& by : {all_blends[0], all_blends[1]})
      RC_ASSERT(near(by(hidden, background), glm::dvec3(hidden.back().radiance), 1e-6));
  });
}

TEST_CASE("two layers are sorted by their moments, at whatever depths") {
  holds("any two", [] {
    const float depth = any_float(0.1F, 9.0F);
    const float apart = any_float(0.0F, 1.0F) * any_float(0.0F, 1.0F) * depth;
    const layers two{any_layer(0, depth, any_float(0.01F, 1.0F)), any_layer(1, depth + apart, any_float(0.01F, 1.0F))};
    RC_PRE(two[0].where.depth != two[1].where.depth);
    const glm::vec3 background = any_vec3(0.0F, 2.0F);
    for (const blend& by : by_moments)
      RC_ASSERT(near(by(two, background), over_all(two, background), 1e-3));
  });
}

TEST_CASE("as many layers as are kept are sorted") {
  holds("up to 4", [] {
    const layers all = any_layers(4);
    const glm::vec3 background = any_vec3(0.0F, 2.0F);
    RC_ASSERT(near(blend_layers<4>(all, background), over_all(all, background), 1e-5));
  });
}

TEST_CASE("moments come nearer to sorting than nothing but the mean does, more of them nearer") {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> any(0.0F, 1.0F);
  std::vector<double> squares(5, 0.0);
  for (int pixel = 0; pixel < 300; ++pixel) {
    layers all;
    for (std::uint32_t id = 0; id < 24; ++id)
      all.push_back({{any(random), id}, 0.3F * any(random), {any(random), any(random), any(random)}});
    const glm::vec3 background(0.5F);
    const glm::dvec3 truth = over_all(all, background);
    tail mean = empty_tail();
    for (const layer& l : all)
      mean = add_fragment(mean, l.alpha, l.radiance);
    const glm::dvec3 errors[]{
        glm::dvec3(resolve(mean, background)) - truth, glm::dvec3(by_moments[0](all, background)) - truth,
        glm::dvec3(by_moments[1](all, background)) - truth, glm::dvec3(by_moments[2](all, background)) - truth,
        glm::dvec3(by_moments[3](all, background)) - truth};
    for (std::size_t i = 0; i < 5; ++i)
      squares[i] += glm::dot(errors[i], errors[i]);
  }
  CHECK(squares[1] < 0.25 * squares[0]);
  CHECK(squares[2] < squares[1]);
  CHECK(squares[3] < 0.5 * squares[0]);
  CHECK(squares[4] < squares[3]);
}

TEST_CASE("what is no number of moments or of layers is refused") {
  for (const char* text : {"moments", "moments:5", "moments:2", "moments:x", "trigonometric:4", "trigonometric",
                           "layers", "layers:0", "layers:3"}) {
    CAPTURE(text);
    CHECK_THROWS_AS((void)parse_blend(text), std::invalid_argument);
  }
  CHECK(parse_blend("moments:6").method == blend_method::moments);
  CHECK(parse_blend("moments:6").size == 6);
  CHECK(parse_blend("trigonometric:3").method == blend_method::trigonometric);
  CHECK(parse_blend("trigonometric:3").size == 3);
  CHECK(parse_blend("layers:16").method == blend_method::layers);
  CHECK(parse_blend("layers:16").size == 16);
}

}  // namespace pelage::test
