// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/order/list_storage.hpp>

#include <atomic>
#include <cstdint>

/// Every fragment of every pixel, in lists that many threads build at once. [Yang10 §3]
///
/// Keeps all that the pool holds, unsorted; what finds the pool full comes back and is counted, and every list stays
/// whole. The order inside a list is the order of arrival: read it into a k_buffer or sort it, and the result is the
/// same for every interleaving. Build and read are two phases: between the last push and the first read the caller
/// joins its threads, or waits at a barrier that synchronises them. Memory: see list_storage.
namespace pelage::inline PELAGE_ABI::a_buffer {

/// Puts a fragment at the head of a list. Returns no_fragment(), or the fragment itself if it was refused and
/// counted: the pool is full, or is_fragment() is false. `list`: [0, list_count()). Wait-free, O(1).
///
/// (1) The exchange is relaxed: no thread reads a list while others push, and atomic exchanges on one head still
/// give each pusher its own predecessor. (2) Relaxed as well; only the barrier after the phase publishes it.
template <list_storage Storage>
[[nodiscard]] fragment push(Storage& storage, std::uint32_t list, fragment offered) noexcept {
  PELAGE_ASSERT(list < storage.list_count());
  const std::uint32_t node = is_fragment(offered) ? take_node(storage) : no_node();
  if (node == no_node()) {
    storage.add_refused(std::memory_order_relaxed);
    return offered;
  }
  storage.write_node(node, offered);
  const std::uint32_t successor = storage.exchange_link(list, node, std::memory_order_relaxed);  // (1)
  storage.store_link(link_of(storage, node), successor, std::memory_order_relaxed);              // (2)
  return no_fragment();
}

/// The first node of a list, or no_node(). Not concurrent with push.
template <list_storage Storage>
[[nodiscard]] std::uint32_t first(const Storage& storage, std::uint32_t list) noexcept {
  return storage.load_link(list, std::memory_order_relaxed);
}

/// The node after a node, or no_node(). Not concurrent with push.
template <list_storage Storage>
[[nodiscard]] std::uint32_t next(const Storage& storage, std::uint32_t node) noexcept {
  return storage.load_link(link_of(storage, node), std::memory_order_relaxed);
}

}  // namespace pelage::a_buffer
