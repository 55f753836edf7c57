// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/raster/line_in_pixel.hpp"

#include "frame/fibres.hpp"
#include "frame/frame.hpp"
#include "frame/model/built_in.hpp"
#include "frame/raster/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace pelage::test {

using namespace frame;

using pixel = std::pair<int, int>;

std::map<pixel, pixel_fragment> drawn_by(const raster& from, std::uint32_t segment) {
  std::map<pixel, pixel_fragment> found;
  from.for_each(segment, whole(from.from()), [&](int x, int y, const pixel_fragment& f) {
    RC_ASSERT(found.emplace(pixel{x, y}, f).second);
  });
  return found;
}

/// Any fibres before any camera, or round it; or before a light.
view any_view() {
  if (*rc::gen::arbitrary<bool>())
    return any_perspective(any_float(-0.5F, 4.0F), std::pow(10.0F, any_float(-3.0F, -0.5F)));
  return orthographic_view(any_vec3(-0.3F, 0.3F), any_vec3(-1.0F, 1.0F) + glm::vec3(0.0F, 0.0F, 1e-3F), 2.0F,
                           *rc::gen::inRange(1, 40), any_footprint());
}

TEST_CASE("a sweep finds exactly the pixels of each line, with the bits of a look at them one by one") {
  holds("any fibres, view and bins", [] {
    const strands fibres =
        fibres_of(any_lines(3, glm::vec3(0.0F), 1.5F), std::pow(10.0F, any_float(-4.0F, 0.3F)), 1.0F);
    const view v = any_view();
    const raster from(fibres, v, *rc::gen::arbitrary<bool>(),
                      line_depths_of(fibres, v, *rc::gen::element(0U, 1U, 256U), any_float(0.1F, 4.0F)));
    for (std::uint32_t s = 0; s < fibres.segment_count(); ++s) {
      const std::map<pixel, pixel_fragment> found = drawn_by(from, s);
      const pixel_rect b = from.bounds(s);
      std::size_t asked = 0;
      for (int y = 0; y < v.height; ++y) {
        for (int x = 0; x < v.width; ++x) {
          const pixel_fragment f = from.at(s, x, y);
          if (!(f.coverage > 0.0F)) continue;
          ++asked;
          const auto other = found.find({x, y});
          RC_ASSERT(other != found.end());
          RC_ASSERT(std::memcmp(&other->second, &f, sizeof f) == 0);
          RC_ASSERT((x >= b.x0 && x < b.x1 && y >= b.y0 && y < b.y1));
          RC_ASSERT((f.coverage <= 1.0F && f.along >= 0.0F && f.along <= 1.0F && f.depth >= v.near_plane));
        }
      }
      RC_ASSERT(asked == found.size());
    }
  });
}

TEST_CASE("a thin line draws the pixel of each column or row that it runs through, and its strand each once") {
  holds("a strand that never turns back", [] {
    // Pixels are units here. Double finds the pixel that the line passes at the column's middle, unless it is a tie.
    const bool steep = *rc::gen::arbitrary<bool>();
    std::vector<glm::vec3> line;
    float across = any_float(-14.0F, -8.0F);
    float beside = any_float(-5.0F, 5.0F);
    for (int points = *rc::gen::inRange(2, 6); points > 0; --points) {
      line.push_back({steep ? beside : across, steep ? across : beside, any_float(-3.0F, 3.0F)});
      const float step = any_float(0.1F, 6.0F);
      across += step;
      beside += any_float(-0.9F, 0.9F) * step;
    }
    const strands fibres = fibres_of({line}, 0.1F, 1.0F);
    const view seen = flat_view(32);
    const raster from(fibres, seen, true, line_depths_of(fibres, seen, 0, 1.0F));
    std::set<int> columns;
    for (std::uint32_t s = 0; s < fibres.segment_count(); ++s) {
      const glm::dvec3 a(fibres.point[s]);
      const glm::dvec3 b(fibres.point[s + 1]);
      for (const auto& [at, f] : drawn_by(from, s)) {
        const double centre[] = {at.first - 15.5, 15.5 - at.second};
        const double place = (centre[steep] - a[steep]) / (b[steep] - a[steep]);
        RC_ASSERT((place > -1e-5 && place < 1.0 + 1e-5));
        RC_ASSERT(std::abs(a[!steep] + place * (b[!steep] - a[!steep]) - centre[!steep]) < 0.5 + 1e-5);
        RC_ASSERT(std::abs(static_cast<double>(f.along) - place) < 1e-4);
        RC_ASSERT(std::abs(static_cast<double>(f.coverage) - 0.231421356237309) < 1e-6);  // Eq. 1.1 for w = 0.2
        RC_ASSERT(columns.insert(steep ? at.second : at.first).second);
      }
    }
    const float from_end = line.front()[steep];
    const float to_end = line.back()[steep];
    std::size_t passed = 0;
    for (int i = 0; i < 32; ++i)
      passed += static_cast<float>(i) - 15.5F >= from_end && static_cast<float>(i) - 15.5F < to_end;
    RC_ASSERT(columns.size() == passed);
  });
}

TEST_CASE("a line wider than a pixel has its fibre's width in pixels down each column") {
  holds("any width and slope", [] {
    const float width = any_float(1.0F, 9.0F);
    const glm::vec3 end(14.0F, any_float(-5.0F, 5.0F), 0.0F);
    const strands fibres = fibres_of({{{-14.0F, any_float(-5.0F, 5.0F), 0.0F}, end}}, 0.5F * width, 1.0F);
    std::map<int, int> rows;
    for (const auto& [at, f] :
         drawn_by(raster(fibres, flat_view(32), true, line_depths_of(fibres, flat_view(32), 0, 1.0F)), 0)) {
      RC_ASSERT(f.coverage == 1.0F);
      ++rows[at.first];
    }
    RC_ASSERT(rows.size() == 28);
    for (const auto& [column, count] : rows)
      RC_ASSERT(std::abs(static_cast<float>(count) - width) < 1.0F);
  });
}

/// Coverage of all pixels, by column.
std::map<int, double> sums(const raster& from) {
  std::map<int, double> sum;
  for (const auto& [at, f] : drawn_by(from, 0))
    sum[at.first] += static_cast<double>(f.coverage);
  return sum;
}

TEST_CASE("widths are those of each end's depth before a camera, and of one depth in a light's map") {
  // 64 pixels from bottom to top, whose half has the tangent 1/2: 64 pixels are as long as the view is deep.
  const view v = perspective_view(glm::vec3(0.0F), {0.0F, 0.0F, -1.0F}, 0.5F, 64, 64, 0.1F);
  const strands fibres = fibres_of({{{-0.9F, 0.01F, -2.0F}, {1.8F, 0.02F, -4.0F}}}, 0.0125F, 1.0F);
  const raster camera(fibres, v, true, line_depths_of(fibres, v, 256, 0.0F));
  // Widths of 0.8 and 0.4 pixels: w Rat is 0.80568542494924 and 0.442842712474619.
  for (const auto& [at, f] : drawn_by(camera, 0)) {
    const double expected = 0.80568542494924 + static_cast<double>(f.along) * (0.442842712474619 - 0.80568542494924);
    CHECK(static_cast<double>(f.coverage) == doctest::Approx(expected).epsilon(1e-5));
    const double x = (at.first + 0.5 - 32.0) / 64.0;  // over the depth, which is 2 + 2 t where x = -0.9 + 2.7 t
    CHECK(static_cast<double>(f.along) == doctest::Approx((2.0 * x + 0.9) / (2.7 - 2.0 * x)).epsilon(1e-4));
  }
  for (const auto& [at, f] : drawn_by(raster(fibres, v, true, line_depths_of(fibres, v, 0, 4.0F)), 0))
    CHECK(f.coverage == doctest::Approx(0.4428427F));
  for (const auto& [at, f] : drawn_by(raster(fibres, v, false, line_depths_of(fibres, v, 256, 0.0F)), 0))
    CHECK(f.coverage == 1.0F);

  // Wide lines by bins: as wide as the fibre is where the bin of its farther end begins.
  const strands wide = fibres_of(
      {{{-0.5F, -0.4F, -2.0F}, {0.9F, 0.6F, -3.0F}}, {{0.0F, 5.0F, -6.0F}, {1.0F, 5.0F, -6.0F}}}, 0.25F, 1.0F);
  for (const auto& [bins, depth] : {std::pair{4U, 3.0}, {5U, 2.8}, {3U, 2.0}, {1U, 2.0}}) {
    double sum = 0.0;
    const std::map<int, double> columns = sums(raster(wide, v, true, line_depths_of(wide, v, bins, 0.0F)));
    for (const auto& [column, count] : columns)
      sum += count / static_cast<double>(columns.size());
    CHECK(sum == doctest::Approx(64.0 * 0.5 / depth).epsilon(0.01));
  }
}

frame_result draw(const hair_model& model, const frame_settings& settings, int threads = 2) {
  return on_threads(threads, [&] { return draw_frame(model, settings, [](const std::string&, double) {}); });
}

TEST_CASE("neither threads nor the order of segments nor the structure changes a bit of a picture of lines") {
  const hair_model hair = make_built_in(300, 12, 1);
  frame_settings settings;
  settings.width = settings.height = 96;
  settings.k = 4;
  settings.opacity = 0.4F;
  settings.fibre_radius = 0.015F;
  settings.on_bust = true;
  const frame_result segments = draw(hair, settings);
  settings.drawn = primitive::line;
  for (const bool antialias : {true, false}) {
    settings.antialias = antialias;
    settings.order = order_method::k_buffer;
    const frame_result first = draw(hair, settings, 1);
    CHECK_FALSE(same_bits(first.picture.pixels, segments.picture.pixels));
    for (const order_method method :
         {order_method::k_buffer, order_method::a_buffer, order_method::unrolled_list, order_method::ordered_list,
          order_method::atomic_k_buffer, order_method::split_k_buffer}) {
      settings.order = method;
      settings.shuffle += 1;
      for (const int threads : {1, 4})
        CHECK(same_bits(draw(hair, settings, threads).picture.pixels, first.picture.pixels));
    }
  }
}

/// The light that hair takes from the background, in pixels at distance 1.
double taken(frame_settings settings, primitive drawn, float distance) {
  settings.drawn = drawn;
  settings.distance = distance;
  const hair_model hair = make_built_in(300, 12, 1);
  const auto sum = [](const image& picture) {
    double light = 0.0;
    for (const glm::vec3& p : picture.pixels)
      light += static_cast<double>(p.x + p.y + p.z);
    return light;
  };
  const double seen = sum(draw(hair, settings).picture);
  settings.opacity = 0.0F;
  return (sum(draw(hair, settings).picture) - seen) * static_cast<double>(distance) * static_cast<double>(distance);
}

TEST_CASE("as the camera moves away hair takes the light of its area, and lines take within a tenth of it") {
  frame_settings settings;
  settings.width = settings.height = 128;
  settings.shown = components::translucency;
  settings.fibre_radius = 0.005F;
  settings.on_bust = true;
  const double near = taken(settings, primitive::segment, 1.0F);
  CHECK(near > 0.0);
  for (const float distance : {2.0F, 4.0F}) {
    CAPTURE(distance);
    // From afar a little more of it is seen beside the head.
    const double exact = taken(settings, primitive::segment, distance);
    CHECK(exact == doctest::Approx(near).epsilon(0.1));
    CHECK(taken(settings, primitive::line, distance) == doctest::Approx(exact).epsilon(0.1));
  }
  settings.distance = 0.4F;
  CHECK_THROWS_AS((void)draw(make_built_in(2, 2, 1), settings), std::invalid_argument);
}

}  // namespace pelage::test
