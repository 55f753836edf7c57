// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/k_buffer.hpp>
#include <pelage/order/k_select.hpp>

#include "property.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <utility>
#include <vector>

using pelage::fragment;
using pelage::vector_isa;

namespace {

using fragments = std::vector<fragment>;

/// By integers alone, so that no setting of the floating-point unit touches it.
std::uint64_t order_of(fragment f) {
  return std::uint64_t{pelage::depth_key(f.depth)} << 32 | f.id;
}

fragments sorted_nearest(fragments list, std::uint32_t k) {
  std::erase_if(list, [](fragment f) { return !pelage::is_fragment(f); });
  std::sort(list.begin(), list.end(), [](fragment a, fragment b) { return order_of(a) < order_of(b); });
  list.resize(k, pelage::no_fragment());
  return list;
}

bool same_bits(std::span<const fragment> a, std::span<const fragment> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](fragment x, fragment y) {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  });
}

struct selector {
  std::uint32_t k;
  vector_isa isa;
  std::uint32_t (*one)(std::span<const fragment>, std::span<fragment>);
  void (*many)(std::span<const fragment>, std::span<const std::uint32_t>, std::span<fragment>);
};

template <std::uint32_t K, vector_isa Isa>
selector make_selector() {
  return {K, Isa,
          [](std::span<const fragment> list, std::span<fragment> nearest) {
            return pelage::k_select<K, Isa>(list, std::span<fragment, K>(nearest));
          },
          [](std::span<const fragment> list, std::span<const std::uint32_t> first, std::span<fragment> nearest) {
            pelage::k_select<K, Isa>(list, first, nearest);
          }};
}

template <vector_isa Isa, std::uint32_t... K>
void add_selectors(std::vector<selector>& all, std::integer_sequence<std::uint32_t, K...>) {
  (all.push_back(make_selector<K + 1u, Isa>()), ...);
}

/// K from 1 to 64 for the widest instructions that this file is compiled for, and once for those of every machine.
const std::vector<selector>& selectors() {
  static const std::vector<selector> all = [] {
    std::vector<selector> made;
    constexpr auto each_k = std::make_integer_sequence<std::uint32_t, 64u>{};
    add_selectors<pelage::widest_isa>(made, each_k);
#if !defined(PELAGE_EXPECTED_ISA)
    add_selectors<vector_isa::plain>(made, each_k);
#endif
    return made;
  }();
  return all;
}

/// Empty if the selector agrees with a sort on this list.
std::string disagreement(const selector& s, const fragments& list) {
  const fragments expected = sorted_nearest(list, s.k);
  const auto held = static_cast<std::uint32_t>(
      std::count_if(expected.begin(), expected.end(), [](fragment f) { return pelage::is_fragment(f); }));
  fragments nearest(s.k, fragment{-7.0f, 7u});
  const std::uint32_t count = s.one(list, nearest);
  if (count == held && same_bits(nearest, expected)) {
    return {};
  }
  return "K " + std::to_string(s.k) + ", isa " + std::to_string(static_cast<int>(s.isa)) + ", n " +
         std::to_string(list.size()) + ": " + std::to_string(count) + " of " + std::to_string(held);
}

/// A list of n fragments whose depths come from one of several kinds of source.
fragments random_list(std::mt19937& random, std::size_t n) {
  constexpr std::array<std::uint32_t, 16> special{
      0x00000000u, 0x80000000u, 0x7f800000u, 0xff800000u, 0x7fc00000u, 0x7f800001u, 0xffffffffu, 0x00000001u,
      0x80000001u, 0x007fffffu, 0x000fffffu, 0x00100000u, 0x00800000u, 0x7f7fffffu, 0xff7fffffu, 0x3f800000u};
  const auto kind = static_cast<std::uint32_t>(random() % 9u);
  const auto bits = [&](std::size_t i) -> std::uint32_t {
    const auto r = static_cast<std::uint32_t>(random());
    const auto step = static_cast<std::uint32_t>(i);
    switch (kind) {
      case 0:
        return r;  // any bits at all
      case 1:
        return special[r % 16u];  // ties of everything awkward
      case 2:
        return r & 0x007fffffu;  // denormals
      case 3:
        return r & 0x807fffffu;  // denormals of both signs
      case 4:
        return 0x3f800000u + (r & 3u);  // few depths
      case 5:
        return 0x3f800000u + (r & 0x007fffffu);  // [1, 2)
      case 6:
        return 0x3f800000u + step;  // in order
      case 7:
        return 0x40000000u - step;  // in the opposite order
      default:
        return r % 50u == 0u ? special[r / 50u % 16u] : 0x3f800000u + (r & 0x007fffffu);
    }
  };
  std::vector<std::uint32_t> id(n);
  std::iota(id.begin(), id.end(), random() % 2u == 0u ? 0u : 0xfffffffeu - static_cast<std::uint32_t>(n));
  std::shuffle(id.begin(), id.end(), random);
  if (n > 0u && random() % 8u == 0u) {
    id[random() % n] = 0xffffffffu;
  }
  fragments list(n);
  for (std::size_t i = 0u; i < n; ++i) {
    list[i] = fragment{std::bit_cast<float>(bits(i)), id[i]};
  }
  return list;
}

const selector& drawn_selector() {
  return selectors()[*rc::gen::inRange<std::size_t>(0u, selectors().size())];
}

#if defined(__SSE2__)
/// Denormals are zero, going in and coming out, until the end of the scope.
class flush_denormals {
 public:
  flush_denormals() { _mm_setcsr(before_ | 0x8040u); }
  ~flush_denormals() { _mm_setcsr(before_); }
  flush_denormals(const flush_denormals&) = delete;
  flush_denormals& operator=(const flush_denormals&) = delete;

 private:
  unsigned before_ = _mm_getcsr();
};
#elif defined(__aarch64__)
class flush_denormals {
 public:
  flush_denormals() { set(before_ | 1u << 24); }
  ~flush_denormals() { set(before_); }
  flush_denormals(const flush_denormals&) = delete;
  flush_denormals& operator=(const flush_denormals&) = delete;

 private:
  static std::uint64_t get() {
    std::uint64_t fpcr;
    asm volatile("mrs %0, fpcr" : "=r"(fpcr));
    return fpcr;
  }
  static void set(std::uint64_t fpcr) { asm volatile("msr fpcr, %0" : : "r"(fpcr)); }
  std::uint64_t before_ = get();
};
#endif

}  // namespace

TEST_CASE("the instructions are those that the file is compiled for") {
#if defined(PELAGE_EXPECTED_ISA)
  CHECK(pelage::widest_isa == vector_isa::PELAGE_EXPECTED_ISA);
  CHECK(selectors().size() == 64u);
#else
  CHECK(selectors().size() == 128u);
#endif
}

TEST_CASE("the K nearest are the first K of a sort, bit for bit") {
  pelage::test::holds("any list", [](std::uint32_t seed) {
    std::mt19937 random(seed);
    const selector& s = drawn_selector();
    for (int i = 0; i < 20; ++i) {
      RC_ASSERT(disagreement(s, random_list(random, random() % 1000u)) == std::string());
    }
  });
}

TEST_CASE("every K agrees with a sort at every length where the way changes") {
  std::mt19937 random(7u);
  std::string first;
  std::size_t lists = 0u;
  for (const selector& s : selectors()) {
    const std::uint32_t network = std::max(8u, std::bit_ceil(s.k));
    for (const std::uint32_t about :
         {0u, 4u, s.k, 2u * s.k, network / 2u, network, 2u * network, 64u, 128u, 192u, 256u}) {
      for (std::uint32_t n = about < 3u ? 0u : about - 3u; n <= about + 3u; ++n) {
        for (int i = 0; i < 4 && first.empty(); ++i, ++lists) {
          first = disagreement(s, random_list(random, n));
        }
      }
    }
  }
  CHECK(first == "");
  CHECK(lists > 10000u);
}

TEST_CASE("the K nearest of long lists are found where whole blocks are passed over, and behind those") {
  std::mt19937 random(5u);
  std::string first;
  for (const selector& s : selectors()) {
    for (const std::size_t n : {255u, 256u, 320u, 2047u, 2048u, 2113u, 5000u}) {
      fragments list = random_list(random, n);
      for (int i = 0; i < 3 && s.k <= 9u && first.empty(); ++i) {
        first = disagreement(s, list);
        std::rotate(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(n / 3u), list.end());
      }
    }
  }
  CHECK(first == "");
}

TEST_CASE("many lists at once give what each gives alone") {
  pelage::test::holds("lists of mixed lengths", [](std::uint32_t seed) {
    std::mt19937 random(seed);
    const selector& s = drawn_selector();
    const std::size_t longest = 1u + random() % (6u * s.k);
    const std::size_t lists = random() % 14u;
    fragments all, expected;
    std::vector<std::uint32_t> first{0u};
    for (std::size_t p = 0u; p < lists; ++p) {
      const fragments list = random_list(random, random() % 2u == 0u ? random() % longest : longest);
      const fragments nearest = sorted_nearest(list, s.k);
      all.insert(all.end(), list.begin(), list.end());
      expected.insert(expected.end(), nearest.begin(), nearest.end());
      first.push_back(static_cast<std::uint32_t>(all.size()));
    }
    fragments nearest(lists * s.k);
    s.many(all, first, nearest);
    RC_ASSERT(same_bits(nearest, expected));
  });
}

TEST_CASE("no lists at all are no work") {
  for (const selector& s : selectors()) {
    s.many({}, {}, {});
    const std::uint32_t start = 0u;
    s.many({}, std::span(&start, 1u), {});
    fragments nearest(s.k, fragment{1.0f, 1u});
    CHECK(s.one({}, nearest) == 0u);
    CHECK(same_bits(nearest, fragments(s.k, pelage::no_fragment())));
  }
}

TEST_CASE("the K nearest are what a k_buffer holds") {
  pelage::test::holds("K = 16", [](std::uint32_t seed) {
    std::mt19937 random(seed);
    const fragments list = random_list(random, random() % 300u);
    auto buffer = pelage::k_buffer<16>::empty();
    for (const fragment f : list) {
      static_cast<void>(buffer.insert(f));
    }
    buffer.sort();
    std::array<fragment, 16> nearest;
    RC_ASSERT(pelage::k_select<16>(list, std::span(nearest)) == buffer.size());
    RC_ASSERT(same_bits(nearest, buffer.slot));
  });
}

TEST_CASE("lists in which the near fill few columns are selected exactly") {
  std::mt19937 random(3u);
  for (const selector& s : selectors()) {
    const std::uint32_t columns = 2u * std::max(8u, std::bit_ceil(s.k));
    for (const std::uint32_t near_columns : {1u, columns / 2u - 1u, columns - 1u}) {
      fragments list(1000u);
      for (std::uint32_t i = 0u; i < list.size(); ++i) {
        const auto jitter = static_cast<float>(random() % 1000u);
        list[i] = fragment{jitter + (i % columns < near_columns ? 1.0f : 5000.0f), i};
      }
      CHECK(disagreement(s, list) == "");
    }
  }
}

TEST_CASE("equal depths fall to the smaller ids, however long the list") {
  for (const selector& s : selectors()) {
    fragments list(777u);
    for (std::uint32_t i = 0u; i < list.size(); ++i) {
      list[i] = fragment{3.0f, 776u - i};
    }
    CHECK(disagreement(s, list) == "");
  }
}

#if defined(__SSE2__) || defined(__aarch64__)
TEST_CASE("denormals keep their order where the floating-point unit takes them for zero") {
  std::mt19937 random(11u);
  for (const selector& s : selectors()) {
    for (const std::size_t n : {5u, 40u, 150u, 600u}) {
      fragments list(n);
      for (std::uint32_t i = 0u; i < n; ++i) {
        const auto bits = static_cast<std::uint32_t>(random());
        const std::uint32_t sign = n == 150u ? bits & 0x80000000u : 0u;
        list[i] = fragment{std::bit_cast<float>(sign | (bits & (i % 3u == 0u ? 0x000fffffu : 0x00ffffffu))), i};
      }
      const fragments expected = sorted_nearest(list, s.k);
      fragments nearest(s.k);
      {
        const flush_denormals flush;
        s.one(list, nearest);
      }
      CHECK(same_bits(nearest, expected));
      list[n / 2u].depth = -0.0f;
      const fragments with_zero = sorted_nearest(list, s.k);
      {
        const flush_denormals flush;
        s.one(list, nearest);
      }
      CHECK(same_bits(nearest, with_zero));
    }
  }
}
#endif
