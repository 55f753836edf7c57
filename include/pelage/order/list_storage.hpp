// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/fragment.hpp>

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstdint>
#include <span>

namespace pelage::inline PELAGE_ABI {

/// The link that ends a list, and the node that stands for none.
[[nodiscard]] constexpr std::uint32_t no_node() noexcept {
  return 0xffffffffu;
}

/// Where concurrent per-pixel lists live: links, nodes and two counters, each cell reached by a call that names
/// its memory order, so that the same algorithm runs on std::atomic_ref, on a shader's buffers and on cells that a
/// concurrency test watches.
///
/// Not cell_storage: a list's cells lie in four places, and in a shader a storage is its names.
///
/// Links [0, list_count()) are the lists' heads; the link that leaves node n is link list_count() + n, a sum that
/// must not wrap. Every link is a node's number or no_node(). A compare-exchange returns the value it found; it took
/// place exactly when that is `expected`, and must not fail spuriously.
template <class Storage>
concept list_storage = requires(Storage& s, const Storage& c, std::uint32_t n, fragment f, std::memory_order order) {
  { c.list_count() } -> std::same_as<std::uint32_t>;
  { c.node_capacity() } -> std::same_as<std::uint32_t>;
  { c.load_link(n, order) } -> std::same_as<std::uint32_t>;
  { s.store_link(n, n, order) } -> std::same_as<void>;
  { s.exchange_link(n, n, order) } -> std::same_as<std::uint32_t>;
  { s.compare_exchange_link(n, n, n, order) } -> std::same_as<std::uint32_t>;
  { c.load_taken(order) } -> std::same_as<std::uint32_t>;
  { s.add_taken(order) } -> std::same_as<std::uint32_t>;
  { s.add_refused(order) } -> std::same_as<void>;
  { c.read_node(n) } -> std::same_as<fragment>;
  { s.write_node(n, f) } -> std::same_as<void>;
};

/// list_storage over the caller's memory, atomic through std::atomic_ref. Lock-free where a 32-bit atomic_ref is.
/// 4 bytes a list, 12 bytes a node.
struct atomic_list_storage {
  std::span<std::uint32_t> links;  ///< one a list, then one a node; at most 2^32 - 2^24; clear() before use
  std::span<fragment> nodes;       ///< the pool, shared by all lists
  std::uint32_t* taken;            ///< nodes asked for: those in use, and what full pools were asked for besides
  std::uint32_t* refused;          ///< fragments that found the pool full, or are no fragments (NaN); modulo 2^32

  /// Empties every list and both counters. Not concurrent.
  void clear() noexcept {
    PELAGE_ASSERT(nodes.size() <= links.size() && links.size() <= 0xff000000u);
    std::fill(links.begin(), links.end(), no_node());
    *taken = 0u;
    *refused = 0u;
  }

  [[nodiscard]] std::uint32_t list_count() const noexcept {
    return static_cast<std::uint32_t>(links.size()) - static_cast<std::uint32_t>(nodes.size());
  }
  [[nodiscard]] std::uint32_t node_capacity() const noexcept { return static_cast<std::uint32_t>(nodes.size()); }

  [[nodiscard]] std::uint32_t load_link(std::uint32_t link, std::memory_order order) const noexcept {
    return std::atomic_ref(links[link]).load(order);
  }
  void store_link(std::uint32_t link, std::uint32_t node, std::memory_order order) noexcept {
    std::atomic_ref(links[link]).store(node, order);
  }
  [[nodiscard]] std::uint32_t exchange_link(std::uint32_t link, std::uint32_t node, std::memory_order order) noexcept {
    return std::atomic_ref(links[link]).exchange(node, order);
  }
  [[nodiscard]] std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired,
                                                    std::memory_order order) noexcept {
    std::atomic_ref(links[link]).compare_exchange_strong(expected, desired, order, std::memory_order_relaxed);
    return expected;
  }

  [[nodiscard]] std::uint32_t load_taken(std::memory_order order) const noexcept {
    return std::atomic_ref(*taken).load(order);
  }
  [[nodiscard]] std::uint32_t add_taken(std::memory_order order) noexcept {
    return std::atomic_ref(*taken).fetch_add(1u, order);
  }
  [[nodiscard]] std::uint32_t add_taken_nodes(std::uint32_t count, std::memory_order order) noexcept {
    return std::atomic_ref(*taken).fetch_add(count, order);
  }
  void add_refused(std::memory_order order) noexcept { std::atomic_ref(*refused).fetch_add(1u, order); }

  [[nodiscard]] fragment read_node(std::uint32_t node) const noexcept { return nodes[node]; }
  void write_node(std::uint32_t node, fragment f) noexcept { nodes[node] = f; }
};

static_assert(list_storage<atomic_list_storage>);

/// Takes a node of the pool, or no_node() when all are taken. Wait-free, O(1). The count stays near the capacity: a
/// thread looks before it asks, so it asks a full pool once at most, and whoever took the last node never does. It
/// wraps only if more threads (on a GPU, invocations in flight) than 2^32 - node_capacity() do so.
///
/// (1) Relaxed load: the count never falls, so a thread that has seen the pool full, or whose own (2) found it full,
/// sees that forever. (2) Relaxed add: it hands out numbers and publishes nothing; a node's content is published by
/// the link that leads to it.
template <list_storage Storage>
[[nodiscard]] std::uint32_t take_node(Storage& storage) noexcept {
  if (storage.load_taken(std::memory_order_relaxed) >= storage.node_capacity()) {  // (1)
    return no_node();
  }
  const std::uint32_t node = storage.add_taken(std::memory_order_relaxed);  // (2)
  return node < storage.node_capacity() ? node : no_node();
}

/// The link that leaves a node.
template <list_storage Storage>
[[nodiscard]] std::uint32_t link_of(const Storage& storage, std::uint32_t node) noexcept {
  return storage.list_count() + node;
}

}  // namespace pelage
