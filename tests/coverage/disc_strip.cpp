// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/lanes.hpp>
#include <pelage/coverage/disc_strip.hpp>

#include "lane_bits.hpp"
#include "property.hpp"
#include "sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace pelage::test {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

/// The share of a unit disc from `depth` below its rim down over `width`, both up to the centre, by quadrature: chords
/// of length 2 √(e (2 - e)), with e = s² so that Simpson's rule meets no singular end.
double slice(double depth, double width) {
  const double from = std::sqrt(depth);
  const double length = width / (from + std::sqrt(depth + width));
  const int steps = 160;
  double sum = 0.0;
  for (int i = 0; i <= steps; ++i) {
    const double s = from + length * i / steps;
    const double weight = i == 0 || i == steps ? 1.0 : 2.0 + 2.0 * (i % 2);
    sum += weight * 4.0 * s * s * std::sqrt(2.0 - s * s);
  }
  return sum * length / (3.0 * steps) / 3.141592653589793;
}

/// disc_strip_share by quadrature in double, each half of the disc for itself.
double exact_share(double offset, double fibre_radius, double disc_radius) {
  double share = 0.0;
  for (const double axis : {offset, -offset}) {
    // The strip's outer and inner edge as heights over the centre, then as depths below this half's rim.
    const double outer = disc_radius - axis - fibre_radius;
    const double inner = disc_radius - axis + fibre_radius;
    const double depth = std::clamp(outer / disc_radius, 0.0, 1.0);
    const double width = outer > 0.0 && inner < disc_radius ? 2.0 * fibre_radius / disc_radius
                                                            : std::clamp(inner / disc_radius, 0.0, 1.0) - depth;
    if (width > 0.0) share += slice(depth, width);
  }
  return share;
}

/// Calls see(offset, fibre_radius, disc_radius) with ratios of the radii from 1e-4 to 1e4, at offsets that are even
/// over the disc, crowd at the touching points from inside, and crowd at the disc's rim.
template <class Real, class See>
void for_each_strip(int count, See see) {
  for (int i = 0; i < count; ++i) {
    const auto [u, v, w] = even_point<3>(i);
    const double disc = on_log_scale(u, 0.1, 10.0);
    const double fibre = disc * on_log_scale(v, 1e-4, 1e4);
    const double near_touch = on_log_scale(w, 1e-7, 1.0);
    const double touch = disc + fibre;
    const double inner_touch = std::abs(disc - fibre);
    for (const double offset : {w * touch, touch * (1.0 - near_touch), inner_touch * (1.0 + near_touch),
                                inner_touch * (1.0 - near_touch), disc + (2.0 * w - 1.0) * fibre}) {
      see(static_cast<Real>(offset), static_cast<Real>(fibre), static_cast<Real>(disc));
    }
  }
}

TEST_CASE("the quadrature itself knows the whole, the half and a thin slice") {
  CHECK(std::abs(exact_share(0.0, 2.0, 1.0) - 1.0) < 1e-9);
  CHECK(std::abs(exact_share(1.0, 1.0, 1.0) - 0.5) < 1e-9);
  CHECK(std::abs(exact_share(0.6, 1e-9, 1.0) - 1.6 * 2e-9 / 3.141592653589793) < 1e-17);
}

template <class Real>
worst_case worst_share() {
  worst_case worst;
  for_each_strip<Real>(10'000, [&](Real offset, Real fibre, Real disc) {
    worst.see(relative_error(disc_strip_share(offset, fibre, disc), exact_share(offset, fibre, disc)),
              {offset, fibre, disc});
  });
  return worst;
}

TEST_CASE("a strip's share is quadrature's within 1e-6 relative in float, from 1e-4 to 1e4 disc radii") {
  const worst_case worst = worst_share<float>();
  CHECK_MESSAGE(worst.error < 1e-6, worst);
}

TEST_CASE("a strip's share is quadrature's within 5e-7 relative in double") {
  const worst_case worst = worst_share<double>();
  CHECK_MESSAGE(worst.error < 5e-7, worst);
}

/// What disc_strip_share replaces: circle minus the caps on both sides, each by its arc and its triangle.
float share_by_caps(float offset, float fibre_radius, float disc_radius) {
  const auto cap = [&](float height) {
    const float x = std::clamp(height / disc_radius, -1.0f, 1.0f);
    return (std::acos(x) - x * std::sqrt(1.0f - x * x)) / 3.14159265f;
  };
  return cap(offset - fibre_radius) - cap(offset + fibre_radius);
}

TEST_CASE("the difference of two caps would lose the digits of a thin strip") {
  const float naive = share_by_caps(0.7f, 1e-4f, 1.0f);
  CHECK(relative_error(naive, exact_share(0.7f, 1e-4f, 1.0f)) > 1e-4);
  CHECK(relative_error(share_by_caps(0.7f, 0.5f, 1.0f), exact_share(0.7f, 0.5f, 1.0f)) < 1e-6);
}

TEST_CASE("Yu §4.2: the disc less the caps above and below the fibre, worked out by hand") {
  const double sixth = std::sqrt(3.0) / 3.141592653589793;  // a cap above half the radius is π/3 - √3/4
  CHECK(std::abs(disc_strip_share(0.0, 0.5, 1.0) - (1.0 / 3.0 + sixth / 2.0)) < 5e-7);  // both caps are cut off
  CHECK(std::abs(disc_strip_share(1.0, 0.5, 1.0) - (1.0 / 3.0 - sixth / 4.0)) < 5e-7);  // U reaches beyond the disc
  CHECK(std::abs(disc_strip_share(0.5, 0.5, 1.0) - 0.5) < 5e-7);                        // B is the centre, U the rim
  CHECK(std::abs(disc_strip_share(-3.0, 2.5, 1.0) - (1.0 / 3.0 - sixth / 4.0)) < 5e-7);
  CHECK(disc_strip_share(1.6, 0.5, 1.0) == 0.0);  // B > R
}

TEST_CASE("a share is in [0, 1], and the offset's sign does not matter") {
  int wrong = 0;
  for_each_strip<float>(20'000, [&](float offset, float fibre, float disc) {
    const float share = disc_strip_share(offset, fibre, disc);
    wrong += !(share >= 0.0f && share <= 1.0f && share == disc_strip_share(-offset, fibre, disc));
  });
  CHECK(wrong == 0);
}

TEST_CASE("the unit of length does not matter, bit for bit in powers of two") {
  int wrong = 0;
  for_each_strip<float>(20'000, [&](float offset, float fibre, float disc) {
    for (const float unit : {0x1p-40f, 0x1p40f}) {
      wrong += disc_strip_share(unit * offset, unit * fibre, unit * disc) != disc_strip_share(offset, fibre, disc);
    }
  });
  CHECK(wrong == 0);
}

TEST_CASE("a wider fibre never covers less except for the stated error, however little wider") {
  worst_case worst;
  for_each_strip<float>(20'000, [&](float offset, float fibre, float disc) {
    const float share = disc_strip_share(offset, fibre, disc);
    for (const float wider : {std::nextafter(fibre, inf), 1.001f * fibre, 1.5f * fibre}) {
      if (share > 0.0f) worst.see(1.0 - disc_strip_share(offset, wider, disc) / share, {offset, fibre, wider, disc});
    }
  });
  CHECK_MESSAGE(worst.error < 2e-6, worst);
}

TEST_CASE("a strip that only touches the disc covers none of it, one that reaches round it all") {
  for_each_strip<float>(1'000, [](float, float fibre, float disc) {
    const auto [thin, wide] = std::minmax({fibre, disc});
    const float touch = std::nextafter(thin + wide, inf);
    CHECK(disc_strip_share(touch, fibre, disc) == 0.0f);
    CHECK(disc_strip_share(0.0f, std::nextafter(disc, inf), disc) == 1.0f);
    CHECK(disc_strip_share(0.0f, disc, disc) == 1.0f);
    CHECK(disc_strip_share(disc, fibre + 2.0f * disc, disc) == 1.0f);
  });
}

TEST_CASE("a share has the same bits at every scale that keeps its lengths exact, discs up to 2^127") {
  holds("by powers of two", [] {
    const float disc = 1.0f + 0x1p-23f * static_cast<float>(*rc::gen::inRange(0, 1 << 23));
    const float fibre = disc * std::exp2(0.01f * static_cast<float>(*rc::gen::inRange(-1000, 200)));
    const float offset = (disc + fibre) * 1e-3f * static_cast<float>(*rc::gen::inRange(0, 1001));
    const int exponent = *rc::gen::oneOf(rc::gen::inRange(-100, 127), rc::gen::inRange(120, 127));
    const auto scaled = [=](float length) { return std::ldexp(length, exponent); };
    RC_PRE(std::isfinite(scaled(offset)) && std::isfinite(scaled(fibre)));
    RC_ASSERT(disc_strip_share(scaled(offset), scaled(fibre), scaled(disc)) == disc_strip_share(offset, fibre, disc));
  });
}

TEST_CASE("a fibre of radius 0 covers nothing, an infinite one everything") {
  for (const float offset : {0.0f, 0.5f, 1.0f, 1e30f}) {
    CHECK(disc_strip_share(offset, 0.0f, 1.0f) == 0.0f);
    CHECK(disc_strip_share(offset, inf, 1.0f) == 1.0f);
  }
}

TEST_CASE("a disc of radius 0 is a point, in the strip or not") {
  CHECK(disc_strip_share(0.0f, 1.0f, 0.0f) == 1.0f);
  CHECK(disc_strip_share(-0.99f, 1.0f, 0.0f) == 1.0f);
  CHECK(disc_strip_share(1.0f, 1.0f, 0.0f) == 0.0f);
  CHECK(disc_strip_share(1.01f, 1.0f, 0.0f) == 0.0f);
  CHECK(disc_strip_share(0.0f, 0.0f, 0.0f) == 0.0f);
}

TEST_CASE("NaN, negative radii and infinite offsets or discs cover nothing") {
  CHECK(disc_strip_share(nan, 1.0f, 1.0f) == 0.0f);
  CHECK(disc_strip_share(0.0f, nan, 1.0f) == 0.0f);
  CHECK(disc_strip_share(0.0f, 1.0f, nan) == 0.0f);
  CHECK(disc_strip_share(0.0f, -1.0f, 2.0f) == 0.0f);
  CHECK(disc_strip_share(0.0f, 1.0f, -2.0f) == 0.0f);
  CHECK(disc_strip_share(inf, 1.0f, 1.0f) == 0.0f);
  CHECK(disc_strip_share(inf, inf, 1.0f) == 0.0f);
  CHECK(disc_strip_share(0.0f, 1.0f, inf) == 0.0f);
}

TEST_CASE("a cap's share is quadrature's within 3e-8, and both caps of a disc make it whole") {
  worst_case worst;
  worst_case whole;
  for (int i = 0; i < 20'000; ++i) {
    const double height = on_log_scale(even_point<1>(i)[0], 1e-8, 1.0);
    worst.see(relative_error(cap_share(height), slice(0.0, height)), {height});
    whole.see(std::abs(cap_share(height) + cap_share(2.0 - height) - 1.0), {height});
  }
  CHECK_MESSAGE(worst.error < 3e-8, worst);
  CHECK_MESSAGE(whole.error < 1e-15, whole);
}

TEST_CASE("a cap's height is clamped to [0, 2], and NaN has no share") {
  for (const float height : {0.0f, -1.0f, -inf, nan}) {
    CHECK(cap_share(height) == 0.0f);
  }
  for (const float height : {2.0f, 3.0f, inf}) {
    CHECK(cap_share(height) == 1.0f);
  }
}

template <int W>
void check_shares() {
  values<W> offset = any_values<W>();
  values<W> fibre = any_values<W>();
  values<W> disc = any_values<W>();
  for (std::size_t k = 0; k < W; ++k) {  // most as a renderer has them; the rest keep their signs
    if (*rc::gen::inRange(0, 8) != 0) {
      disc[k] = std::abs(disc[k]);
      fibre[k] = disc[k] * std::exp2(static_cast<float>(*rc::gen::inRange(-40, 20)) / 8.0f);
      offset[k] = (disc[k] + fibre[k]) * static_cast<float>(*rc::gen::inRange(-1100, 1101)) / 1000.0f;
    }
  }
  for (values<W>* one : {&offset, &fibre, &disc}) {
    const auto k = static_cast<std::size_t>(*rc::gen::inRange(0, W));
    (*one)[k] = *rc::gen::element((*one)[k], 0.0f, inf, nan);
  }
  const lanes<W> found =
      disc_strip_share(lanes<W>::load(offset.data()), lanes<W>::load(fibre.data()), lanes<W>::load(disc.data()));
  for (std::size_t k = 0; k < W; ++k) {
    RC_LOG() << offset[k] << " " << fibre[k] << " " << disc[k];
    RC_ASSERT(same_value(found.lane[k], disc_strip_share(offset[k], fibre[k], disc[k])));
  }
}

TEST_CASE("shares of lanes are those of the kernel, bit for bit, and so is what no fibre has") {
  holds("4 lanes", check_shares<4>);
  holds("8 lanes", check_shares<8>);
  holds("16 lanes", check_shares<16>);
}

}  // namespace pelage::test
