// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/order/list_storage.hpp>

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstdint>

/// An A-buffer whose lists are chains of blocks: nodes side by side, as many as one writer has for one list at a time.
/// [Yang10 §3; an unrolled linked list, with blocks of any size]
///
/// Whoever has several fragments of a pixel takes one block for them and links it with one exchange, in place of one a
/// fragment; a reader loads a block's nodes at once, and waits once a block in place of once a fragment (a group of
/// lanes: unrolled_walk.hpp). A writer is a thread, or in a shader a workgroup that gathers what its invocations draw;
/// none waits for another one's link. All that the pool holds is kept, unsorted, and every list stays whole; the order
/// inside a list is the order of arrival. Build and read are two phases, as a_buffer's. Memory: see list_storage, a
/// node for each one taken, whether used or not; progress: wait-free.
///
/// A node's link is no_node() as clear() has left it where the list goes on with the next node of the pool, so that
/// only a block's last node has a link to store; list_end() ends a list.
namespace pelage::inline PELAGE_ABI::unrolled_list {

/// A storage whose counter takes any number of nodes at once: as `add_taken`, by `count`.
template <class Storage>
concept block_storage = list_storage<Storage> && requires(Storage& s, std::uint32_t count, std::memory_order order) {
  { s.add_taken_nodes(count, order) } -> std::same_as<std::uint32_t>;
};

/// Nodes [first, first + size) of the pool.
struct node_block {
  std::uint32_t first;
  std::uint32_t size;
};

/// The link of a list's last node.
[[nodiscard]] constexpr std::uint32_t list_end() noexcept {
  return 0xfffffffeu;
}

/// Takes `wanted` nodes, or as many as the pool has left: 0 of more than 0 means that it is full. The caller leaves out
/// what is_fragment() refuses, writes fragments to any part of the block's beginning, and counts with add_refused()
/// those that found no node. Wait-free, O(1). The
/// count wraps only if those who ask before they see the pool full want more than 2^32 - node_capacity() nodes
/// together.
///
/// (1) and (2) are relaxed as take_node()'s, and for the same reasons.
template <block_storage Storage>
[[nodiscard]] node_block take(Storage& storage, std::uint32_t wanted) noexcept {
  const std::uint32_t capacity = storage.node_capacity();
  if (storage.load_taken(std::memory_order_relaxed) >= capacity) {  // (1)
    return node_block{capacity, 0u};
  }
  const std::uint32_t before = storage.add_taken_nodes(wanted, std::memory_order_relaxed);  // (2)
  const std::uint32_t first = std::min(before, capacity);
  return node_block{first, std::min(wanted, capacity - first)};
}

/// What is left of `wanted` nodes from the one numbered `offset` of a block on: a block taken for several lists is cut
/// into one for each. Any values.
[[nodiscard]] constexpr node_block part(node_block whole, std::uint32_t offset, std::uint32_t wanted) noexcept {
  const std::uint32_t skipped = std::min(offset, whole.size);
  return node_block{whole.first + skipped, std::min(wanted, whole.size - skipped)};
}

/// Puts a block's nodes, all of them written, at the head of a list; an empty block leaves it as it is. `list`: [0,
/// list_count()). Where a group wrote the nodes, all have done so before one pushes. Wait-free, O(1).
///
/// (3) The exchange is relaxed: no thread reads a list while others push, and atomic exchanges on one head still give
/// each pusher its own predecessor. (4) Relaxed as well; only the barrier after the phase publishes it.
template <block_storage Storage>
void push(Storage& storage, std::uint32_t list, node_block block) noexcept {
  PELAGE_ASSERT(list < storage.list_count());
  if (block.size > 0u) {
    const std::uint32_t head = storage.exchange_link(list, block.first, std::memory_order_relaxed);  // (3)
    const std::uint32_t successor = head == no_node() ? list_end() : head;
    storage.store_link(link_of(storage, block.first + block.size - 1u), successor, std::memory_order_relaxed);  // (4)
  }
}

/// The first node of a list, or no_node(). Not concurrent with push.
template <block_storage Storage>
[[nodiscard]] std::uint32_t first(const Storage& storage, std::uint32_t list) noexcept {
  return storage.load_link(list, std::memory_order_relaxed);
}

/// The node after a node whose link is `link`, or no_node().
[[nodiscard]] constexpr std::uint32_t after(std::uint32_t node, std::uint32_t link) noexcept {
  const std::uint32_t elsewhere = link == list_end() ? no_node() : link;
  return link == no_node() ? node + 1u : elsewhere;
}

/// The node after a node, or no_node(). Not concurrent with push.
template <block_storage Storage>
[[nodiscard]] std::uint32_t next(const Storage& storage, std::uint32_t node) noexcept {
  return after(node, storage.load_link(link_of(storage, node), std::memory_order_relaxed));
}

}  // namespace pelage::unrolled_list
