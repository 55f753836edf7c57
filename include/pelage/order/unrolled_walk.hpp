// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/lane_group.hpp>
#include <pelage/order/unrolled_list.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// A group of W lanes at an unrolled_list: lane l has the l-th node of what is left of a block, so that fragments side
/// by side are loaded together. Each lane has an object of its own. 12 bytes a lane, in registers.
///
///     walk.go_to(storage, group, unrolled_list::first(storage, list));
///     while (walk.size > 0u) {
///       // lane l < walk.size: node walk.begin + l
///       walk.go_to(storage, group, walk.then);
///     }
struct unrolled_walk {
  std::uint32_t begin;  ///< the first lane's node, or no_node() behind the end; in all lanes alike
  std::uint32_t size;   ///< lanes that have a node, [1, W], or 0 behind the end; in all lanes alike
  std::uint32_t then;   ///< the node after theirs, or no_node(); in all lanes alike

  /// Goes to a node of a list, or with no_node() behind the end. All lanes call it together, with the same node; not
  /// concurrent with push. It loads a link a lane, which may be another list's: O(1), two counts and a shuffle.
  template <unrolled_list::block_storage Storage, lane_group Group>
  void go_to(const Storage& storage, const Group& group, std::uint32_t node) noexcept {
    begin = node;
    size = 0u;
    then = no_node();
    if (node != no_node()) {
      // The pool's last node ends a block wherever it is in a list, so that lanes beyond it are left out, too.
      const std::uint32_t mine = std::min(node + group.lane(), storage.node_capacity() - 1u);
      const std::uint32_t link = storage.load_link(link_of(storage, mine), std::memory_order_relaxed);
      const bool is_last = link != no_node();
      size = group.count(group.count(is_last).below == 0u).all;
      then = unrolled_list::after(node + size - 1u, group.shuffle(link, size - 1u));
    }
  }
};

}  // namespace pelage
