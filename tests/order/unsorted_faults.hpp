// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "order/lists.hpp"

#include <atomic>
#include <cstdint>
#include <string>
#include <vector>

namespace pelage::test {

inline const std::vector<offer> two = {{0u, fragment{2.0f, 2u}}, {0u, fragment{1.0f, 1u}}};

/// The law that pushes to one unsorted list break, the last while the last but one is on its way, or "".
template <class Storage, class Lists>
std::string interrupted_law(std::uint32_t capacity, const std::vector<offer>& offers = two) {
  pool<Storage> storage(1u, capacity);
  const std::vector<offer> returned = offer_interrupted(storage, Lists{}, offers);
  return broken_law(storage, Lists{}, offers, returned, 2u);
}

/// An exchange in two steps.
struct torn_exchange : interrupted {
  std::uint32_t exchange_link(std::uint32_t link, std::uint32_t node, std::memory_order order) {
    const std::uint32_t found = load_link(link, order);
    interrupt();
    store_link(link, node, order);
    return found;
  }
};

}  // namespace pelage::test
