// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/frame.hpp"

#include "frame/fibres.hpp"
#include "frame/model/built_in.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace pelage::test {

using namespace frame;

constexpr components all_components[]{components::single, components::shadows, components::translucency,
                                      components::full};

/// Hair so thick that no pixel of it keeps all its fragments at K = 4.
const hair_model& small_hair() {
  static const hair_model model = make_built_in(300, 12, 1);
  return model;
}

frame_settings small_frame() {
  frame_settings s;
  s.width = 96;
  s.height = 96;
  s.k = 4;
  s.opacity = 0.4F;
  s.fibre_radius = 0.015F;
  s.on_bust = true;
  return s;
}

frame_result draw(const hair_model& model, const frame_settings& settings, int threads = 2) {
  return on_threads(threads, [&] { return draw_frame(model, settings, [](const std::string&, double) {}); });
}

bool same_picture(const image& a, const image& b) {
  return a.width == b.width && a.height == b.height && same_bits(a.pixels, b.pixels);
}

std::uint64_t lost(const frame_result& frame) {
  std::uint64_t refused = 0;
  for (const pass_report& p : frame.passes)
    refused += p.order.refused;
  return refused;
}

std::uint32_t longest(const frame_result& frame) {
  std::uint32_t most = 0;
  for (const pass_report& p : frame.passes)
    most = std::max(most, p.order.longest);
  return most;
}

std::vector<std::uint64_t> fragments(const frame_result& frame) {
  std::vector<std::uint64_t> counts;
  for (const pass_report& p : frame.passes)
    counts.push_back(p.order.fragments);
  return counts;
}

TEST_CASE("neither threads nor drawing order nor the choice of structure changes a bit of the picture") {
  for (const components shown : all_components) {
    for (const bool antialias : {true, false}) {
      CAPTURE(static_cast<int>(shown));
      CAPTURE(antialias);
      frame_settings settings = small_frame();
      settings.shown = shown;
      settings.antialias = antialias;
      const frame_result first = draw(small_hair(), settings, 1);
      CHECK(first.passes.size() == (has_shadows(shown) ? 3 : 1));
      CHECK(longest(first) > 4 * settings.k);
      std::uint64_t seed = 0;
      for (const order_method method :
           {order_method::k_buffer, order_method::a_buffer, order_method::unrolled_list, order_method::ordered_list,
            order_method::atomic_k_buffer, order_method::split_k_buffer, order_method::partial_selection_sort}) {
        for (const int threads : {1, 2, 4}) {
          CAPTURE(static_cast<int>(method));
          CAPTURE(threads);
          settings.order = method;
          settings.shuffle = seed++;
          const frame_result frame = draw(small_hair(), settings, threads);
          CHECK(same_picture(frame.picture, first.picture));
          CHECK(fragments(frame) == fragments(first));
          CHECK(lost(frame) == 0);
        }
      }
    }
  }
}

TEST_CASE("each model of scattering draws the same bits on any number of threads, and others than the next model") {
  std::vector<image> pictures;
  for (const bsdf_model model :
       {bsdf_model::kajiya_kay, bsdf_model::marschner, bsdf_model::chiang, bsdf_model::dual_scattering}) {
    CAPTURE(static_cast<int>(model));
    frame_settings settings = small_frame();
    settings.look.model = model;
    const frame_result first = draw(small_hair(), settings, 1);
    settings.shuffle = 7;
    for (const int threads : {2, 4})
      CHECK(same_picture(draw(small_hair(), settings, threads).picture, first.picture));
    for (const image& other : pictures)
      CHECK_FALSE(same_picture(other, first.picture));
    pictures.push_back(first.picture);
  }
}

TEST_CASE("100 frames from structures that all threads build at once are one picture") {
  const hair_model few = make_built_in(60, 8, 1);
  frame_settings settings = small_frame();
  settings.width = settings.height = 32;
  settings.k = 2;
  const image first = draw(few, settings, 1).picture;
  for (const order_method method :
       {order_method::ordered_list, order_method::atomic_k_buffer, order_method::split_k_buffer}) {
    settings.order = method;
    int other = 0;
    for (int repeat = 0; repeat < 100; ++repeat) {
      for (const int threads : {1, 2, 4})
        other += same_picture(draw(few, settings, threads).picture, first) ? 0 : 1;
    }
    CHECK(other == 0);
  }
}

TEST_CASE("the structures at a K that holds every fragment, and sorting by selection, give the true picture") {
  for (const components shown : all_components) {
    CAPTURE(static_cast<int>(shown));
    const hair_model thin = make_built_in(60, 12, 1);
    frame_settings settings = small_frame();
    settings.shown = shown;
    settings.k = 64;
    settings.order = order_method::full_sort;
    const frame_result truth = draw(thin, settings);
    REQUIRE(longest(truth) <= settings.k);
    CHECK(longest(truth) > 4);
    for (const order_method method :
         {order_method::k_buffer, order_method::a_buffer, order_method::unrolled_list, order_method::ordered_list,
          order_method::atomic_k_buffer, order_method::split_k_buffer, order_method::partial_selection_sort,
          order_method::selection_sort}) {
      CAPTURE(static_cast<int>(method));
      settings.order = method;
      const frame_result frame = draw(thin, settings);
      CHECK(same_picture(frame.picture, truth.picture));
      CHECK(fragments(frame) == fragments(truth));
      CHECK(lost(frame) == 0);
    }
  }
}

TEST_CASE("the tail stands in for what K leaves out, and a greater K comes nearer to the true picture") {
  frame_settings settings = small_frame();
  settings.order = order_method::full_sort;
  const image truth = draw(small_hair(), settings).picture;
  settings.order = order_method::k_buffer;
  struct bound {
    std::uint32_t k;
    double most;
  };
  for (const bound& b : {bound{1, 0.01}, bound{4, 0.004}, bound{16, 0.0004}, bound{64, 1e-5}}) {
    CAPTURE(b.k);
    settings.k = b.k;
    CHECK(compare(draw(small_hair(), settings).picture, truth).rms < b.most);  // without tails: 0.09 at K = 1
  }
}

TEST_CASE("a tail a slice comes nearer to the true picture, in any order, by any method and on any threads") {
  frame_settings settings = small_frame();
  settings.order = order_method::full_sort;
  const image truth = draw(small_hair(), settings).picture;
  settings.order = order_method::k_buffer;
  settings.k = 4;
  double last = 0.09;  // without tails
  for (const std::uint32_t tails : {0U, 1U, 4U, 16U, 64U}) {
    CAPTURE(tails);
    settings.tails = tails;
    const double rms = compare(draw(small_hair(), settings).picture, truth).rms;
    CHECK(rms < last);
    last = rms;
  }
  settings.tails = 16;
  const image first = draw(small_hair(), settings).picture;
  for (const order_method order : {order_method::a_buffer, order_method::unrolled_list, order_method::ordered_list,
                                   order_method::atomic_k_buffer}) {
    settings.order = order;
    settings.shuffle += 1;
    const image other = draw(small_hair(), settings, 3).picture;
    CHECK(same_picture(other, first));
  }
}

TEST_CASE("each part of the framework shows in the picture") {
  frame_settings settings = small_frame();
  std::vector<image> pictures;
  for (const components shown : all_components) {
    for (const bool antialias : {true, false}) {
      settings.shown = shown;
      settings.antialias = antialias;
      pictures.push_back(draw(small_hair(), settings).picture);
    }
  }
  for (std::size_t a = 0; a < pictures.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b)
      CHECK(compare(pictures[a], pictures[b]).rms > 0.005);
  }
}

TEST_CASE("fibres that nothing stops at are not in the picture, nor is a model without strands") {
  frame_settings settings = small_frame();
  settings.opacity = 0.0F;
  const image invisible = draw(small_hair(), settings).picture;
  hair_model rootless = small_hair();  // the same points, so the same camera, but no segments
  rootless.first_point.resize(rootless.points.size() + 1);
  std::iota(rootless.first_point.begin(), rootless.first_point.end(), 0U);
  const frame_result bald = draw(rootless, settings);
  CHECK(same_picture(invisible, bald.picture));
  CHECK(bald.passes.back().order.fragments == 0);

  CHECK(draw({}, settings).picture.pixels.size() == 96 * 96);
  settings.on_bust = false;
  CHECK(draw({}, settings).picture.pixels.size() == 96 * 96);
}

TEST_CASE("progress rises to 1 and names every pass") {
  std::vector<std::string> names;
  double before = -1.0;
  const frame_result frame = draw_frame(small_hair(), small_frame(), [&](const std::string& name, double done) {
    CHECK(done > before);
    before = done;
    names.push_back(name);
  });
  CHECK(before == 1.0);
  REQUIRE(names.size() == frame.passes.size() + 1);
  for (std::size_t i = 0; i < frame.passes.size(); ++i)
    CHECK(names[i] == frame.passes[i].name);
}

TEST_CASE("a setting out of range is refused") {
  const float infinity = std::numeric_limits<float>::infinity();
  const float not_a_number = std::numeric_limits<float>::quiet_NaN();
  const auto refused = [](auto change) {
    frame_settings settings = small_frame();
    change(settings);
    CHECK_THROWS_AS(static_cast<void>(draw(small_hair(), settings)), std::invalid_argument);
  };
  refused([](frame_settings& s) { s.width = 0; });
  refused([](frame_settings& s) { s.height = 16385; });
  refused([](frame_settings& s) { s.map_size = -1; });
  refused([](frame_settings& s) { s.k = 5; });
  refused([](frame_settings& s) { s.opacity = 1.5F; });
  refused([&](frame_settings& s) { s.opacity = not_a_number; });
  refused([&](frame_settings& s) { s.fibre_radius = infinity; });
  refused([&](frame_settings& s) { s.fibre_radius = not_a_number; });
  refused([](frame_settings& s) { s.from = glm::vec2(0.0F, 90.0F); });
  refused([&](frame_settings& s) { s.from = glm::vec2(infinity, 0.0F); });
  refused([](frame_settings& s) { s.lights = {parse_light("point:0.5,0,0:1,1,1")}; });
}

}  // namespace pelage::test
