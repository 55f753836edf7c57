// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Whole frames by every method of shadows and of blending.
#include "frame/fibres.hpp"
#include "frame/frame.hpp"
#include "frame/model/built_in.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace pelage::test {

using namespace frame;

const std::vector<std::string> shadows{
    "k_buffer", "occupancy", "opacity:16", "deep_opacity:16", "deep_opacity_growing:8", "deep:0.05", "exact"};
const std::vector<std::string> blends{
    "k_buffer",      "exact",        "order_weighted",  "weighted_average",         "weighted_blended",
    "depth_peeling", "stochastic:8", "deep_opacity:32", "deep_opacity_corrected:32"};

frame_settings small_frame(const std::string& shadow, const std::string& blend) {
  frame_settings s;
  s.width = s.height = 64;
  s.k = 4;
  s.opacity = 0.4F;
  s.fibre_radius = 0.015F;
  s.on_bust = true;
  s.shadow = parse_shadow(shadow);
  s.blend = parse_blend(blend);
  return s;
}

frame_result draw(const frame_settings& settings, int threads = 2) {
  static const hair_model model = make_built_in(200, 10, 1);
  return on_threads(threads, [&] { return draw_frame(model, settings, [](const std::string&, double) {}); });
}

bool same_picture(const image& a, const image& b) {
  return same_bits(a.pixels, b.pixels);
}

TEST_CASE("neither threads nor drawing order change a bit of a picture, whatever the methods") {
  const auto check = [](const std::string& shadow, const std::string& blend) {
    CAPTURE(shadow);
    CAPTURE(blend);
    frame_settings settings = small_frame(shadow, blend);
    const frame_result first = draw(settings, 1);
    for (const int threads : {2, 4}) {
      settings.shuffle = static_cast<std::uint64_t>(threads);
      const frame_result other = draw(settings, threads);
      CHECK(same_picture(other.picture, first.picture));
      REQUIRE(other.passes.size() == 3);
      for (std::size_t p = 0; p < 3; ++p) {
        CHECK(other.passes[p].order.refused == 0);
        CHECK(other.passes[p].order.fragments == first.passes[p].order.fragments);
        CHECK(other.passes[p].order.longest == first.passes[p].order.longest);
        CHECK(other.passes[p].bytes == first.passes[p].bytes);
      }
    }
  };
  for (const std::string& shadow : shadows)
    check(shadow, "k_buffer");
  for (const std::string& blend : blends)
    check("k_buffer", blend);
}

TEST_CASE("depth peeling, and a K-buffer that holds every fragment, are sorting to the bit") {
  for (const bool antialias : {true, false}) {
    frame_settings settings = small_frame("k_buffer", "exact");
    settings.antialias = antialias;
    settings.opacity = 0.2F;
    settings.fibre_radius = 0.004F;
    settings.k = 64;
    const frame_result truth = draw(settings);
    REQUIRE(truth.passes.back().order.longest <= 64);
    CHECK(truth.passes.back().order.longest > 4);
    for (const std::string blend : {"k_buffer", "depth_peeling"}) {
      CAPTURE(blend);
      settings.blend = parse_blend(blend);
      CHECK(same_picture(draw(settings).picture, truth.picture));
    }
    settings.shadow = parse_shadow("exact");
    CHECK(same_picture(draw(settings).picture, truth.picture));
    settings.shadow = parse_shadow("deep:0");
    CHECK(compare(draw(settings).picture, truth.picture).rms < 1e-4);
  }
}

TEST_CASE("each method is as near to the true picture as its kind can be, and no two are the same") {
  struct bound {
    std::string name;
    double most;
  };
  const image truth = draw(small_frame("exact", "exact")).picture;
  std::vector<image> pictures;
  const auto check = [&](const frame_settings& settings, const bound& b) {
    CAPTURE(b.name);
    pictures.push_back(draw(settings).picture);
    CHECK(compare(pictures.back(), truth).rms < b.most);
  };
  for (const bound& b :
       {bound{"k_buffer", 0.01}, bound{"occupancy", 0.01}, bound{"opacity:16", 0.02}, bound{"deep_opacity:16", 0.01},
        bound{"deep_opacity_growing:8", 0.01}, bound{"deep:0.05", 0.005}}) {
    check(small_frame(b.name, "exact"), b);
  }
  for (const bound& b : {bound{"k_buffer", 0.01}, bound{"order_weighted", 0.01}, bound{"weighted_average", 0.06},
                         bound{"weighted_blended", 0.06}, bound{"stochastic:8", 0.03}, bound{"deep_opacity:32", 0.02},
                         bound{"deep_opacity_corrected:32", 0.005}}) {
    check(small_frame("exact", b.name), b);
  }
  for (std::size_t a = 0; a < pictures.size(); ++a) {
    for (std::size_t b = 0; b < a; ++b)
      CHECK_FALSE(same_picture(pictures[a], pictures[b]));
  }
}

TEST_CASE("another seed draws other stochastic samples, and nothing else") {
  frame_settings settings = small_frame("k_buffer", "stochastic:4");
  const image first = draw(settings).picture;
  settings.blend.seed = 2;
  CHECK_FALSE(same_picture(draw(settings).picture, first));
  settings.blend = parse_blend("weighted_average");
  const image other = draw(settings).picture;
  settings.blend.seed = 2;
  CHECK(same_picture(draw(settings).picture, other));
}

}  // namespace pelage::test
