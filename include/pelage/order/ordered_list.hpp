// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/order/list_storage.hpp>

#include <atomic>
#include <cstdint>

/// Sorted per-pixel lists that many threads build at once, readable while they grow. [Yu12 §5.2, whose text has the
/// compare-exchange return the new value where it succeeds: its algorithm needs the one found, as here; a list ends
/// with no_node() in the place of a node of depth 1]
///
/// Keeps the total order in the links themselves; what finds the pool full, or lies behind `limit` nearer ones,
/// comes back. Once all inserts are done a list holds the same sequence for every interleaving, or with a limit begins
/// with the same sequence, as long as no fragment found the pool full. A reader that walks a list at the same time sees
/// a sorted list of complete nodes, some of those being inserted among them. Memory: see list_storage.
namespace pelage::inline PELAGE_ABI::ordered_list {

/// The limit that never ends a search.
[[nodiscard]] constexpr std::uint32_t unlimited() noexcept {
  return 0xffffffffu;
}

/// Inserts a fragment at its place. Returns no_fragment(), or the fragment itself where it did not enter: it is
/// refused and counted (pool full, or is_fragment() is false), or `limit` fragments of the list are before it, which
/// is not a loss but an answer: it is not among the `limit` nearest and never will be. If all inserts have the same
/// limit and none found the pool full, the list's first `limit` nodes are the nearest of all for every interleaving.
/// Nodes behind them may remain, how many depends on the interleaving: only a node for every offer is surely enough.
///
/// `list`: [0, list_count()). `limit`: [1, unlimited()]. Lock-free: an exchange fails only because another insert
/// succeeded, and costs one more step. O(n) steps for the n fragments before this one; of those that were there when
/// it came, it passes at most `limit`.
///
/// (1) Acquire load of a link; synchronises with (3) of whoever published the node that it leads to, so the node's
/// fragment and link may be read. (2) Relaxed store of the own link: no one reaches the node before (3). (3) The
/// compare-exchange verifies that the successor is still the one that was compared with, and releases the node's
/// fragment and its link (2) to the acquire loads (1) and (4). On failure, relaxed, it takes nothing: the search goes
/// on from the same place, the head or a node that is still before the fragment since none is ever removed, and (1)
/// loads anew.
template <list_storage Storage>
[[nodiscard]] fragment insert(Storage& storage, std::uint32_t list, fragment offered, std::uint32_t limit) noexcept {
  PELAGE_ASSERT(list < storage.list_count() && limit >= 1u);
  if (!is_fragment(offered)) {
    storage.add_refused(std::memory_order_relaxed);
    return offered;
  }
  std::uint32_t node = no_node();
  std::uint32_t place = list;
  std::uint32_t passed = 0u;
  for (;;) {
    const std::uint32_t successor = storage.load_link(place, std::memory_order_acquire);  // (1)
    if (successor != no_node() && before(storage.read_node(successor), offered)) {
      place = link_of(storage, successor);
      ++passed;
      if (passed >= limit && node == no_node()) {
        return offered;
      }
    } else {
      if (node == no_node()) {
        node = take_node(storage);
        if (node == no_node()) {
          storage.add_refused(std::memory_order_relaxed);
          return offered;
        }
        storage.write_node(node, offered);
      }
      storage.store_link(link_of(storage, node), successor, std::memory_order_relaxed);  // (2)
      const std::uint32_t found =
          storage.compare_exchange_link(place, successor, node, std::memory_order_release);  // (3)
      if (found == successor) {
        return no_fragment();
      }
    }
  }
}

/// The first node of a list, or no_node(). (4) Acquire, pairs with (3). Wait-free.
template <list_storage Storage>
[[nodiscard]] std::uint32_t first(const Storage& storage, std::uint32_t list) noexcept {
  return storage.load_link(list, std::memory_order_acquire);  // (4)
}

/// The node after a node, or no_node(). (4) Acquire, pairs with (3). Wait-free.
template <list_storage Storage>
[[nodiscard]] std::uint32_t next(const Storage& storage, std::uint32_t node) noexcept {
  return storage.load_link(link_of(storage, node), std::memory_order_acquire);  // (4)
}

}  // namespace pelage::ordered_list
