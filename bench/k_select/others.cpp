// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/k_buffer.hpp>

#include "method.hpp"

#include <hwy/contrib/sort/vqsort.h>

#include <algorithm>
#include <array>
#include <bit>
#include <queue>

namespace bench {
namespace {

using pelage::before;
using pelage::fragment;

constexpr std::size_t longest = 1024u;
using list_of = std::span<const fragment>;

template <std::uint32_t K>
struct priority_queue {
  static void select(list_of list, fragment* nearest) {
    std::vector<fragment> heap;
    heap.reserve(K + 1u);
    std::priority_queue queue(before, std::move(heap));
    for (const fragment f : list) {
      if (queue.size() < K) {
        queue.push(f);
      } else if (before(f, queue.top())) {
        queue.pop();
        queue.push(f);
      }
    }
    for (std::size_t i = queue.size(); i > 0u; --i) {
      nearest[i - 1u] = queue.top();
      queue.pop();
    }
  }
};

template <std::uint32_t K>
struct nth_element {
  static void select(list_of list, fragment* nearest) {
    std::array<fragment, longest> copy;
    const auto end = std::copy(list.begin(), list.end(), copy.begin());
    const auto kept = std::min<std::ptrdiff_t>(K, end - copy.begin());
    if (kept < end - copy.begin()) {
      std::nth_element(copy.begin(), copy.begin() + kept, end, before);
    }
    std::sort(copy.begin(), copy.begin() + kept, before);
    std::copy_n(copy.begin(), kept, nearest);
  }
};

template <std::uint32_t K>
struct partial_sort_copy {
  static void select(list_of list, fragment* nearest) {
    std::partial_sort_copy(list.begin(), list.end(), nearest, nearest + K, before);
  }
};

template <std::uint32_t K>
struct selection_sort {
  static void select(list_of list, fragment* nearest) {
    std::array<fragment, longest> copy;
    const auto end = std::copy(list.begin(), list.end(), copy.begin());
    const auto kept = std::min<std::ptrdiff_t>(K, end - copy.begin());
    for (auto at = copy.begin(); at != copy.begin() + kept; ++at) {
      std::iter_swap(at, std::min_element(at, end, before));
    }
    std::copy_n(copy.begin(), kept, nearest);
  }
};

template <std::uint32_t K>
struct select_and_replace {
  static void select(list_of list, fragment* nearest) {
    auto buffer = pelage::k_buffer<K>::empty();
    for (const fragment f : list) {
      static_cast<void>(buffer.insert(f));
    }
    buffer.sort();
    std::copy(buffer.slot.begin(), buffer.slot.end(), nearest);
  }
};

template <std::uint32_t K>
struct vqsort {
  static void select(list_of list, fragment* nearest) {
    static const hwy::Sorter sorter;
    std::array<std::uint64_t, longest> key;
    for (std::size_t i = 0u; i < list.size(); ++i) {  // depths of the benchmark are positive
      key[i] = std::uint64_t{std::bit_cast<std::uint32_t>(list[i].depth)} << 32 | list[i].id;
    }
    sorter(key.data(), list.size(), hwy::SortAscending());
    for (std::size_t i = 0u; i < std::min<std::size_t>(K, list.size()); ++i) {
      nearest[i] = {std::bit_cast<float>(static_cast<std::uint32_t>(key[i] >> 32)), static_cast<std::uint32_t>(key[i])};
    }
  }
};

template <template <std::uint32_t> class Way, std::uint32_t K>
void run(const workload& w) {
  for (std::size_t p = 0u; p + 1u < w.first.size(); ++p) {
    Way<K>::select(w.fragments.subspan(w.first[p], w.first[p + 1u] - w.first[p]), w.nearest.data() + p * K);
  }
}

template <template <std::uint32_t> class Way>
method of(const char* name) {
  return {name, false, {run<Way, 4>, run<Way, 8>, run<Way, 16>, run<Way, 32>, run<Way, 64>}};
}

}  // namespace

std::vector<method> other_methods() {
  return {of<priority_queue>("std::priority_queue"),       of<nth_element>("std::nth_element + sort"),
          of<partial_sort_copy>("std::partial_sort_copy"), of<selection_sort>("selection sort"),
          of<select_and_replace>("select-and-replace"),    of<vqsort>("vqsort")};
}

}  // namespace bench
