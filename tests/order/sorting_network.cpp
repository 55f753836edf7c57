// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/sorting_network.hpp>

#include "order/oracle.hpp"
#include "property.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pelage::test {

/// The slots of 64 networks side by side, in each a 0 or a 1.
struct lanes {
  std::uint64_t ones;
};

constexpr void order_pair(lanes& a, lanes& b) noexcept {
  const lanes nearer{a.ones & b.ones};
  b.ones |= a.ones;
  a = nearer;
}

/// The lanes in which a 1 stands before a 0.
template <std::size_t K>
std::uint64_t unsorted(const std::array<lanes, K>& slot) {
  std::uint64_t wrong = 0u;
  for (std::size_t i = 1u; i < K; ++i) {
    wrong |= slot[i - 1u].ones & ~slot[i].ones;
  }
  return wrong;
}

/// Counts its compares.
struct counter {
  std::uint32_t* compares;
};

constexpr void order_pair(counter& a, counter&) noexcept {
  ++*a.compares;
}

template <std::uint32_t K>
constexpr std::uint32_t compares() {
  std::uint32_t count = 0u;
  std::array<counter, K> slot{};
  slot.fill(counter{&count});
  sort_network<K>(slot);
  return count;
}

/// 1, 2, ..., Last
template <std::uint32_t... I>
constexpr std::integer_sequence<std::uint32_t, (I + 1u)...> from_one(std::integer_sequence<std::uint32_t, I...>) {
  return {};
}
template <std::uint32_t Last>
using up_to = decltype(from_one(std::make_integer_sequence<std::uint32_t, Last>{}));

// A network that sorts every input of zeros and ones sorts every input [Knuth, TAOCP 3, 5.3.4, theorem Z].
TEST_CASE("the network sorts every sequence of zeros and ones, up to K = 20") {
  constexpr std::array<std::uint64_t, 6> counting = {0xaaaaaaaaaaaaaaaau, 0xccccccccccccccccu, 0xf0f0f0f0f0f0f0f0u,
                                                     0xff00ff00ff00ff00u, 0xffff0000ffff0000u, 0xffffffff00000000u};
  for_each_k(up_to<20>{}, [&]<std::uint32_t K>() {
    std::uint64_t wrong = 0u;
    for (std::uint32_t high = 0u; high == 0u || high < (1u << K) / 64u; ++high) {
      std::array<lanes, K> slot{};
      for (std::size_t i = 0u; i < K; ++i) {
        slot[i].ones = i < 6u ? counting[i] : 0u - std::uint64_t{(high >> (i - 6u)) & 1u};
      }
      sort_network<K>(slot);
      wrong |= unsorted(slot);
    }
    CHECK_MESSAGE(wrong == 0u, "K = ", K);
  });
}

TEST_CASE("the network merges every two sorted parts of zeros and ones, up to K = 64") {
  for_each_k(up_to<64>{}, []<std::uint32_t K>() {
    constexpr std::uint64_t all = ~std::uint64_t{0};
    const std::uint32_t part = std::bit_ceil(K) / 2u;  // where the last merge finds its second part
    std::uint64_t wrong = 0u;
    for (std::uint32_t ones = 0u; ones <= part; ++ones) {
      std::array<lanes, K> slot{};  // lane b: the first part ends with `ones` ones, the second with b
      for (std::uint32_t i = 0u; i < K; ++i) {
        slot[i].ones = i >= part ? all << (K - i) : i + ones >= part ? all : 0u;
      }
      sort_network<K>(slot);
      wrong |= unsorted(slot);
    }
    CHECK_MESSAGE(wrong == 0u, "K = ", K);
  });
}

TEST_CASE("the network sorts as std::sort does, bit for bit, for every K in [1, 64]") {
  holds("any fragments", [] {
    std::vector<fragment> input = *any_fragments();
    std::erase_if(input, refusable);
    input.resize(64u, no_fragment());
    for_each_k(up_to<64>{}, [&]<std::uint32_t K>() {
      std::array<fragment, K> slot{};
      std::copy_n(input.begin(), K, slot.begin());
      const std::vector<fragment> sorted = in_order(joined({}, slot), 0u, K);
      sort_network<K>(slot);
      RC_ASSERT(bits(slot) == bits(sorted));
    });
  });
}

TEST_CASE("the network takes 63 compares at K = 16 and 543 at 64") {
  static_assert(compares<1>() == 0u);
  static_assert(compares<2>() == 1u);
  static_assert(compares<16>() == 63u);
  static_assert(compares<64>() == 543u);
  CHECK(compares<16>() == 63u);
}

TEST_CASE("the network runs at compile time") {
  static_assert([] {
    std::array<fragment, 3> slot = {fragment{2.0f, 0u}, fragment{1.0f, 2u}, fragment{1.0f, 1u}};
    sort_network<3>(slot);
    return slot[0].id == 1u && slot[1].id == 2u && slot[2].id == 0u;
  }());
}

}  // namespace pelage::test
