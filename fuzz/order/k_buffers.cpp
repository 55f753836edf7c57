// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// k_buffer, atomic_k_buffer, cascade_k_buffer and split_k_buffer against sorting, and so against each other: any
// depths, any order.
#include <pelage/order/atomic_k_buffer.hpp>
#include <pelage/order/cascade_k_buffer.hpp>
#include <pelage/order/k_buffer.hpp>
#include <pelage/order/split_k_buffer.hpp>

#include "../input.hpp"

#include <cstddef>
#include <vector>

namespace {

using namespace pelage;

/// What a buffer of K holds in order, and what it handed back of what can be held.
struct held {
  std::vector<fragment> slots;
  std::vector<fragment> back;

  void lost(fragment f) {
    if (is_fragment(f)) {
      back.push_back(f);
    }
  }
  void slot(fragment f) {
    if (is_fragment(f)) {
      slots.push_back(f);
    }
  }
};

template <std::uint32_t K>
held by_selection(const std::vector<fragment>& all) {
  held h;
  auto buffer = k_buffer<K>::empty();
  for (const fragment f : all) {
    h.lost(buffer.insert(f));
  }
  buffer.sort();
  for (const fragment f : buffer.slot) {
    h.slot(f);
  }
  return h;
}

template <std::uint32_t K>
held by_exchange(const std::vector<fragment>& all) {
  held h;
  std::vector<std::uint64_t> slots(K, pack(no_fragment()));
  atomic_cells<std::uint64_t> storage{slots};
  for (const fragment f : all) {
    h.lost(atomic_k_buffer::insert<K>(storage, 0u, f));
  }
  for (const fragment f : atomic_k_buffer::load<K>(storage, 0u)) {
    h.slot(f);
  }
  return h;
}

template <std::uint32_t K>
held by_cascade(const std::vector<fragment>& all) {
  held h;
  std::vector<std::uint64_t> slots(K, pack(no_fragment()));
  atomic_cells<std::uint64_t> storage{slots};
  for (const fragment f : all) {
    h.lost(cascade_k_buffer::insert<K>(storage, 0u, f));
  }
  for (std::uint32_t i = 0; i < K; ++i) {
    h.slot(cascade_k_buffer::at<K>(storage, 0u, i));
  }
  return h;
}

template <std::uint32_t K>
held by_split_slots(const std::vector<fragment>& all) {
  held h;
  std::vector<std::uint32_t> cells(2U * K, 0xffffffffU);
  atomic_cells<std::uint32_t> storage{cells};
  for (const fragment f : all) {
    split_k_buffer::offer_depth<K>(storage, 0u, f);
  }
  for (const fragment f : all) {
    h.lost(split_k_buffer::insert<K>(storage, 0u, f));
  }
  for (std::uint32_t i = 0; i < K; ++i) {
    h.slot(split_k_buffer::at<K>(storage, 0u, i));
  }
  return h;
}

void check(const held& h, std::uint32_t k, const std::vector<fragment>& all) {
  const std::vector<fragment> in_order = fuzz::sorted(all);
  const auto kept = static_cast<std::ptrdiff_t>(std::min<std::size_t>(k, in_order.size()));
  fuzz::law(fuzz::equal(h.slots, {in_order.begin(), in_order.begin() + kept}), "the slots are the K nearest, in order");
  fuzz::law(fuzz::equal(fuzz::sorted(h.back), {in_order.begin() + kept, in_order.end()}),
            "what comes back is the rest, each once");
}

template <std::uint32_t K>
void check_all(const std::vector<fragment>& all) {
  check(by_selection<K>(all), K, all);
  check(by_exchange<K>(all), K, all);
  check(by_cascade<K>(all), K, all);
  check(by_split_slots<K>(all), K, all);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in(data, size);
  const std::vector<fragment> all = fuzz::take_fragments(in, 64);
  check_all<1>(all);
  check_all<2>(all);
  check_all<7>(all);
  check_all<16>(all);
  for (const fragment f : all) {
    fuzz::law(!is_fragment(f) || same(unpack(pack(f)), f), "a packed fragment comes back");
  }
  return 0;
}
