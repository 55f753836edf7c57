// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/fragment.hpp>

#include "property.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <tuple>

namespace pelage {

std::ostream& operator<<(std::ostream& out, fragment f) {
  return out << '{' << f.depth << " (" << std::bit_cast<std::uint32_t>(f.depth) << "), " << f.id << '}';
}

}  // namespace pelage

namespace pelage::test {

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float denormal = std::numeric_limits<float>::denorm_min();
constexpr float greatest = std::numeric_limits<float>::max();

static_assert(sizeof(fragment) == 8);
static_assert(before(fragment{1.0f, 7u}, fragment{1.0f, 8u}) && depth_from_key(depth_key(1.0f)) == 1.0f);

/// Any bit pattern of a float, often a special one.
rc::Gen<float> any_float() {
  return rc::gen::oneOf(rc::gen::element(-inf, -greatest, -1.0f, -denormal, -0.0f, 0.0f, denormal, 1.0f, inf),
                        rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>()),
                                     [](std::uint32_t bits) { return std::bit_cast<float>(bits); }));
}

rc::Gen<float> any_depth() {
  return rc::gen::suchThat(any_float(), [](float depth) { return !std::isnan(depth); });
}

rc::Gen<float> any_nan() {
  return rc::gen::map(rc::gen::inRange(0x7f800001u, 0x7fffffffu), [](std::uint32_t bits) {
    return std::bit_cast<float>(bits % 2u == 0u ? bits : bits | 0x80000000u);
  });
}

/// An id that some primitive may have; from a few, so that depth and id often tie.
rc::Gen<std::uint32_t> any_id() {
  return rc::gen::element(0u, 1u, 2u, 0x7fffffffu, 0x80000000u, 0xfffffffeu);
}

rc::Gen<fragment> any_fragment() {
  return rc::gen::apply([](float depth, std::uint32_t id) { return fragment{depth, id}; }, any_depth(), any_id());
}

TEST_CASE("before is depth, then id, and -0 ties with +0") {
  holds("before agrees with the order of pairs", [] {
    const fragment a = *any_fragment();
    const fragment b = *any_fragment();
    RC_ASSERT(before(a, b) == (std::tie(a.depth, a.id) < std::tie(b.depth, b.id)));
    RC_ASSERT(same(a, b) == (std::tie(a.depth, a.id) == std::tie(b.depth, b.id)));
  });
  CHECK(before(fragment{0.0f, 1u}, fragment{-0.0f, 2u}));
  CHECK(before(fragment{-0.0f, 1u}, fragment{0.0f, 2u}));
  CHECK(same(fragment{-0.0f, 1u}, fragment{0.0f, 1u}));
}

TEST_CASE("before is a strict total order") {
  holds("exactly one of before, after and same", [] {
    const fragment a = *any_fragment();
    const fragment b = *any_fragment();
    RC_ASSERT(int{before(a, b)} + int{before(b, a)} + int{same(a, b)} == 1);
  });
  holds("transitive", [] {
    const fragment a = *any_fragment();
    const fragment b = *any_fragment();
    const fragment c = *any_fragment();
    RC_ASSERT(!before(a, b) || !before(b, c) || before(a, c));
  });
}

TEST_CASE("a NaN depth lies beyond the infinity of its sign and is no fragment") {
  holds("before all depths or behind them all", [] {
    const fragment bad{*any_nan(), *any_id()};
    const fragment f{*any_depth(), *any_id()};
    RC_ASSERT((std::signbit(bad.depth) ? before(bad, f) : before(f, bad)));
    RC_ASSERT(!is_fragment(bad));
  });
}

TEST_CASE("no_fragment is no fragment and lies behind every one") {
  CHECK_FALSE(is_fragment(no_fragment()));
  holds("behind every fragment", [] {
    const fragment f = *any_fragment();
    RC_ASSERT(is_fragment(f));
    RC_ASSERT(before(f, no_fragment()) && !before(no_fragment(), f));
  });
  holds("its id is refused at any depth", [] { RC_ASSERT(!is_fragment(fragment{*any_float(), no_fragment().id})); });
}

TEST_CASE("keys order as depths do") {
  holds("key(a) < key(b) exactly when a < b", [] {
    const float a = *any_depth();
    const float b = *any_depth();
    RC_ASSERT((depth_key(a) < depth_key(b)) == (a < b));
    RC_ASSERT((depth_key(a) == depth_key(b)) == (a == b));
  });
}

TEST_CASE("keys rise by one from each float to the next, in steps of 1023 from the least to the greatest") {
  bool by_one = true;
  for (std::uint32_t bits = 1u; bits < 0x7f800000u; bits += 1023u) {
    const float x = std::bit_cast<float>(bits);
    const float next = std::nextafter(x, inf);
    by_one = by_one && depth_key(next) == depth_key(x) + 1u && depth_key(-x) == depth_key(-next) + 1u;
  }
  CHECK(by_one);
}

TEST_CASE("the key of NaN is outside those of the infinities") {
  holds("outside", [] {
    const std::uint32_t key = depth_key(*any_nan());
    RC_ASSERT(key < depth_key(-inf) || key > depth_key(inf));
  });
}

TEST_CASE("depth_from_key inverts depth_key except for the sign of zero") {
  holds("from depth to key and back", [] {
    const float depth = *any_float();
    const float back = depth_from_key(depth_key(depth));
    const float expected = depth == 0.0f ? 0.0f : depth;
    RC_ASSERT(std::bit_cast<std::uint32_t>(back) == std::bit_cast<std::uint32_t>(expected));
  });
}

}  // namespace pelage::test
