// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// atomic_k_buffer, cascade_k_buffer and split_k_buffer with real threads; tests/concurrency/slots.cpp and cascade.cpp
// explore their schedules.
#include <pelage/order/atomic_k_buffer.hpp>

#include <pelage/order/cascade_k_buffer.hpp>
#include <pelage/order/split_k_buffer.hpp>

#include "order/slots.hpp"
#include "property.hpp"

#include <limits>

namespace pelage::test {

template <std::uint32_t K>
outcome one_pass(const std::vector<fragment>& all, std::uint32_t threads) {
  packed_pixels<K> pixels;
  outcome seen;
  seen.back = offer_all(pixels.storage, all, threads,
                        [](auto& storage, fragment f) { return atomic_k_buffer::insert<K>(storage, 1u, f); });
  const auto slots = atomic_k_buffer::load<K>(pixels.storage, 1u);
  seen.slots.assign(slots.begin(), slots.end());
  for (const std::uint32_t neighbour : {0u, 2u}) {
    for (const fragment f : atomic_k_buffer::load<K>(pixels.storage, neighbour)) {
      CHECK(bits(f) == bits(no_fragment()));
    }
  }
  return seen;
}

template <std::uint32_t K>
outcome cascade(const std::vector<fragment>& all, std::uint32_t threads) {
  packed_pixels<K> pixels;
  outcome seen;
  seen.back = offer_all(pixels.storage, all, threads,
                        [](auto& storage, fragment f) { return cascade_k_buffer::insert<K>(storage, 1u, f); });
  for (std::uint32_t i = 0u; i < K; ++i) {
    seen.slots.push_back(cascade_k_buffer::at<K>(pixels.storage, 1u, i));
    const bool neighbours_empty = bits(cascade_k_buffer::at<K>(pixels.storage, 0u, i)) == bits(no_fragment()) &&
                                  bits(cascade_k_buffer::at<K>(pixels.storage, 2u, i)) == bits(no_fragment());
    CHECK(neighbours_empty);
  }
  return seen;
}

template <std::uint32_t K>
outcome split(const std::vector<fragment>& all, std::uint32_t threads) {
  split_pixels<K> pixels;
  outcome seen;
  static_cast<void>(offer_all(pixels.storage, all, threads, [](auto& storage, fragment f) {
    split_k_buffer::offer_depth<K>(storage, 1u, f);
    return no_fragment();
  }));
  seen.back = offer_all(pixels.storage, all, threads,
                        [](auto& storage, fragment f) { return split_k_buffer::insert<K>(storage, 1u, f); });
  for (std::uint32_t i = 0u; i < K; ++i) {
    seen.slots.push_back(split_k_buffer::at<K>(pixels.storage, 1u, i));
    const bool neighbours_empty = bits(split_k_buffer::at<K>(pixels.storage, 0u, i)) == bits(no_fragment()) &&
                                  bits(split_k_buffer::at<K>(pixels.storage, 2u, i)) == bits(no_fragment());
    CHECK(neighbours_empty);
  }
  return seen;
}

using telling_k = std::integer_sequence<std::uint32_t, 1u, 2u, 3u, 8u, 16u, 64u>;

TEST_CASE("atomic_k_buffer holds the K nearest of any bits, whoever inserts them") {
  holds("atomic_k_buffer, 1 to 4 threads", [] {
    const std::vector<fragment> all = *any_fragments();
    for_each_k(telling_k{}, [&]<std::uint32_t K>() {
      for (std::uint32_t threads = 1u; threads <= 4u; ++threads) {
        RC_ASSERT(is_k_nearest(one_pass<K>(all, threads), all));
      }
    });
  });
}

TEST_CASE("cascade_k_buffer holds the K nearest of any bits, whoever inserts them") {
  holds("cascade_k_buffer, 1 to 4 threads", [] {
    const std::vector<fragment> all = *any_fragments();
    for_each_k(telling_k{}, [&]<std::uint32_t K>() {
      for (std::uint32_t threads = 1u; threads <= 4u; ++threads) {
        RC_ASSERT(is_k_nearest(cascade<K>(all, threads), all));
      }
    });
  });
}

TEST_CASE("split_k_buffer holds the K nearest of any bits, whoever inserts them") {
  holds("split_k_buffer, 1 to 4 threads", [] {
    const std::vector<fragment> all = *any_fragments();
    for_each_k(telling_k{}, [&]<std::uint32_t K>() {
      for (std::uint32_t threads = 1u; threads <= 4u; ++threads) {
        RC_ASSERT(is_k_nearest(split<K>(all, threads), all));
      }
    });
  });
}

/// Farthest first, the order that moves most slots; eight of each depth.
std::vector<fragment> crowd(std::uint32_t count) {
  std::vector<fragment> all;
  for (std::uint32_t i = 0u; i < count; ++i) {
    all.push_back(fragment{static_cast<float>((count - i) / 8u), i * 0x9e3779b9u});
  }
  return all;
}

TEST_CASE("a hundred crowds from four threads end in the same slots") {
  const std::vector<fragment> all = crowd(2000u);
  for (int repeat = 0; repeat < 100; ++repeat) {
    REQUIRE(is_k_nearest(one_pass<16>(all, 4u), all));
    REQUIRE(is_k_nearest(cascade<16>(all, 4u), all));
    REQUIRE(is_k_nearest(split<16>(all, 4u), all));
  }
}

TEST_CASE("a packed fragment orders as the fragment does, and comes back") {
  holds("pack keeps the order", [] {
    const fragment a{*any_depth(), *rc::gen::element(0u, 1u, 0xfffffffeu)};
    const fragment b{*any_depth(), *rc::gen::element(0u, 1u, 0xfffffffeu)};
    RC_PRE(is_fragment(a) && is_fragment(b));
    RC_ASSERT((pack(a) < pack(b)) == before(a, b));
    RC_ASSERT(same(unpack(pack(a)), a));
    RC_ASSERT(pack(a) < pack(no_fragment()));
  });
  CHECK(bits(unpack(pack(no_fragment()))) == bits(no_fragment()));
}

TEST_CASE("the check itself is checked: a slot or a returned fragment too many, too few or out of order is seen") {
  const std::vector<fragment> all = {{1.0f, 1u}, {1.0f, 0u}, {3.0f, 2u}, {std::numeric_limits<float>::quiet_NaN(), 3u}};
  const outcome right{{all[1], all[0]}, {all[3], all[2]}};
  CHECK(is_k_nearest(right, all));
  CHECK_FALSE(is_k_nearest({{all[0], all[1]}, right.back}, all));
  CHECK_FALSE(is_k_nearest({right.slots, {all[2]}}, all));
  CHECK_FALSE(is_k_nearest({right.slots, {all[3], all[2], all[2]}}, all));
}

}  // namespace pelage::test
