// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/random_colours.hpp"

#include "property.hpp"

#include <set>
#include <tuple>
#include <vector>

using namespace pelage::frame;
using namespace pelage::test;

TEST_CASE("all points of a strand have the colour of its number, empty strands too have a number") {
  holds("any strands", [] {
    hair_model model;
    for (const int n : *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 5))) {
      model.points.resize(model.points.size() + static_cast<std::size_t>(n));
      model.first_point.push_back(static_cast<std::uint32_t>(model.points.size()));
    }
    if (*rc::gen::arbitrary<bool>()) model.colour.assign(model.points.size(), glm::vec3(2.0F));
    set_random_colours(model);
    RC_ASSERT(model.colour.size() == model.points.size());
    for (std::uint32_t s = 0; s < model.strand_count(); ++s) {
      for (std::uint32_t i = model.first_point[s]; i < model.first_point[s + 1]; ++i)
        RC_ASSERT(model.colour[i] == random_colour(s));
    }
  });
}

TEST_CASE("colours differ, fill [0, 1) evenly and have channels that tell nothing of each other") {
  constexpr std::uint32_t count = 20000;
  std::set<std::tuple<float, float, float>> all;
  double sum[3] = {0, 0, 0};
  double product = 0;
  for (std::uint32_t s = 0; s < count; ++s) {
    const glm::vec3 c = random_colour(s);
    for (int i = 0; i < 3; ++i) {
      REQUIRE(c[i] >= 0.0F);
      REQUIRE(c[i] < 1.0F);
      sum[i] += double{c[i]} / count;
    }
    product += double{c.x} * double{c.y} / count;
    all.insert({c.x, c.y, c.z});
  }
  CHECK(all.size() == count);
  for (const double mean : sum)
    CHECK(mean == doctest::Approx(0.5).epsilon(0.02));
  CHECK(product == doctest::Approx(0.25).epsilon(0.02));
}
