// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/k_buffer.hpp>

#include "order/oracle.hpp"
#include "property.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace pelage::test {

using tested_k = std::integer_sequence<std::uint32_t, 1, 2, 3, 4, 8, 16, 33, 64>;

/// The obvious K-buffer: a sorted vector. Returns what k_buffer::insert should.
fragment insert_obviously(std::vector<fragment>& held, std::size_t k, fragment offered) {
  if (refusable(offered)) return offered;
  held.insert(std::upper_bound(held.begin(), held.end(), offered, nearer), offered);
  if (held.size() <= k) return no_fragment();
  const fragment lost = held.back();
  held.pop_back();
  return lost;
}

/// True if the buffer can go on: its farthest slot is named rightly.
template <std::uint32_t K>
bool is_valid(const k_buffer<K>& buffer) {
  return buffer.farthest_slot < K && bits(buffer.slot[buffer.farthest_slot]) == bits(buffer.farthest) &&
         std::none_of(buffer.slot.begin(), buffer.slot.end(),
                      [&](fragment held) { return nearer(buffer.farthest, held); });
}

template <std::uint32_t K>
k_buffer<K> built_from(std::span<const fragment> input) {
  k_buffer<K> buffer = k_buffer<K>::empty();
  for (const fragment f : input) {
    static_cast<void>(buffer.insert(f));
  }
  return buffer;
}

template <std::uint32_t K>
std::vector<std::uint64_t> sorted_bits(k_buffer<K> buffer) {
  buffer.sort();
  return bits(buffer.slot);
}

/// The sorted slots of a, once b is merged into it.
template <std::uint32_t K>
k_buffer<K> merged(k_buffer<K> a, k_buffer<K> b) {
  a.merge(b);
  return a;
}

TEST_CASE("insert keeps the K nearest and hands back what falls out, sorted in between or not") {
  holds("every offer has the oracle's answer", [] {
    const std::vector<fragment> input = *any_fragments();
    const std::size_t period = *rc::gen::inRange<std::size_t>(1u, 70u);
    for_each_k(tested_k{}, [&]<std::uint32_t K>() {
      k_buffer<K> buffer = k_buffer<K>::empty();
      std::vector<fragment> held;
      for (std::size_t i = 0u; i < input.size(); ++i) {
        RC_ASSERT(bits(buffer.insert(input[i])) == bits(insert_obviously(held, K, input[i])));
        RC_ASSERT(buffer.size() == held.size());
        if (i % period == 0u) buffer.sort();
        RC_ASSERT(is_valid(buffer));
      }
      RC_ASSERT(sorted_bits(buffer) == bits(in_order(input, 0u, K)));
    });
  });
}

TEST_CASE("every permutation of the input ends in the same bits") {
  std::array<fragment, 6> input = {fragment{-0.0f, 3u}, fragment{0.0f, 1u}, fragment{0.0f, 7u},
                                   fragment{-1.0f, 9u}, fragment{2.0f, 0u}, fragment{2.0f, 5u}};
  std::sort(input.begin(), input.end(), nearer);
  const std::vector<fragment> sorted(input.begin(), input.end());
  for_each_k(tested_k{}, [&]<std::uint32_t K>() {
    bool same = true;
    do {
      same = same && sorted_bits(built_from<K>(input)) == bits(in_order(sorted, 0u, K));
    } while (std::next_permutation(input.begin(), input.end(), nearer));
    CHECK_MESSAGE(same, "K = ", K);
  });
}

TEST_CASE("merge keeps the K nearest of two and leaves the rest, whatever the order of merging") {
  holds("merge is associative and commutative, and loses nothing", [] {
    const std::vector<fragment> input = *any_fragments();
    const std::size_t cut = *rc::gen::inRange<std::size_t>(0u, input.size() + 1u);
    const std::size_t width = *rc::gen::inRange<std::size_t>(0u, input.size() - cut + 1u);
    const std::span all(input);
    for_each_k(tested_k{}, [&]<std::uint32_t K>() {
      const k_buffer<K> a = built_from<K>(all.first(cut));
      const k_buffer<K> b = built_from<K>(all.subspan(cut, width));
      const k_buffer<K> c = built_from<K>(all.subspan(cut + width));
      const std::vector<fragment> both = joined(joined({}, a.slot), b.slot);

      k_buffer<K> kept = a;
      k_buffer<K> left = b;
      kept.merge(left);
      RC_ASSERT(sorted_bits(kept) == bits(in_order(both, 0u, K)));
      RC_ASSERT(sorted_bits(left) == bits(in_order(both, K, K)));
      RC_ASSERT(is_valid(kept));
      RC_ASSERT(is_valid(left));

      RC_ASSERT(sorted_bits(merged(b, a)) == sorted_bits(kept));
      RC_ASSERT(sorted_bits(merged(kept, c)) == bits(in_order(input, 0u, K)));
      RC_ASSERT(sorted_bits(merged(a, merged(b, c))) == bits(in_order(input, 0u, K)));
    });
  });

  holds("empty() is merge's identity, on both sides", [] {
    const std::vector<fragment> input = *any_fragments();
    for_each_k(tested_k{}, [&]<std::uint32_t K>() {
      k_buffer<K> a = built_from<K>(input);
      k_buffer<K> none = k_buffer<K>::empty();
      a.merge(none);
      RC_ASSERT(sorted_bits(a) == bits(in_order(input, 0u, K)));
      RC_ASSERT(none.size() == 0u);
      none.merge(a);
      RC_ASSERT(sorted_bits(none) == bits(in_order(input, 0u, K)));
      RC_ASSERT(a.size() == 0u);
    });
  });
}

TEST_CASE("find_farthest repairs a buffer whose slots were written by hand") {
  holds("any slots", [] {
    const std::vector<fragment> input = *any_fragments();
    for_each_k(tested_k{}, [&]<std::uint32_t K>() {
      k_buffer<K> buffer = k_buffer<K>::empty();
      std::vector<fragment> written = input;
      std::erase_if(written, refusable);
      written.resize(K, no_fragment());
      std::copy_n(written.begin(), K, buffer.slot.begin());
      buffer.find_farthest();
      RC_ASSERT(is_valid(buffer));
    });
  });
}

TEST_CASE("a buffer of K takes 8 K + 12 bytes and works at compile time") {
  for_each_k(tested_k{}, []<std::uint32_t K>() { static_assert(sizeof(k_buffer<K>) == 8u * K + 12u); });
  static_assert([] {
    k_buffer<2> near = k_buffer<2>::empty();
    k_buffer<2> far = k_buffer<2>::empty();
    const bool all_taken = bits(near.insert(fragment{3.0f, 0u})) == bits(no_fragment()) &&
                           bits(near.insert(fragment{1.0f, 1u})) == bits(no_fragment()) &&
                           bits(far.insert(fragment{2.0f, 2u})) == bits(no_fragment());
    near.merge(far);
    near.sort();
    return all_taken && near.slot[0].id == 1u && near.slot[1].id == 2u && far.size() == 1u;
  }());
}

}  // namespace pelage::test
