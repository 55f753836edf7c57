// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "concurrency/list_program.hpp"
#include "concurrency/watched_barrier.hpp"
#include "concurrency/watched_lists.hpp"

#include <cstdint>

/// The library's own list algorithms over a storage that does one thing less, or one thing more, than it is asked:
/// the faults that the explorer must find, and the variants that it must not report.
///
/// A wrapper hides the calls that it changes. "Inserting" and "reading" tell the threads apart, since the numbered
/// atomics of one call differ by who makes it: (1) is an inserter's load, (4) a reader's.
namespace pelage::explore::list_variants {

using order = std::memory_order;
constexpr order relaxed = std::memory_order_relaxed;

/// watched_lists that knows which of its threads insert.
struct aware : watched_lists {
  aware(pool kind, std::uint32_t capacity, std::uint32_t threads)
      : watched_lists(kind, capacity, threads), inserters(static_cast<int>(threads)) {}
  [[nodiscard]] bool inserting() const {
    return world::current().thread() >= 0 && world::current().thread() < inserters;
  }
  int inserters;
};

/// Loads, exchanges or compare-exchanges of links with other orders than the library asks for.
template <order Inserting, order Reading, order Publishing>
struct with_orders : aware {
  using aware::aware;
  [[nodiscard]] std::uint32_t load_link(std::uint32_t link, order) const {
    return aware::load_link(link, inserting() ? Inserting : Reading);
  }
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired, order) {
    return aware::compare_exchange_link(link, expected, desired, Publishing);
  }
};

constexpr order acquire = std::memory_order_acquire;
constexpr order release = std::memory_order_release;
using insert_loads_relaxed = with_orders<relaxed, acquire, release>;
using reader_loads_relaxed = with_orders<acquire, relaxed, release>;
using publishes_relaxed = with_orders<acquire, acquire, relaxed>;
using publishes_acquire = with_orders<acquire, acquire, acquire>;
using publishes_acq_rel = with_orders<acquire, acquire, std::memory_order_acq_rel>;
using all_seq_cst = with_orders<std::memory_order_seq_cst, std::memory_order_seq_cst, std::memory_order_seq_cst>;

/// Relaxed accesses with fences in place of acquire and release, as the GLSL mirror has them; any of the three left
/// out, or the one that releases behind what it should release.
template <bool InsertFence, bool ReadFence, bool PublishFence, bool PublishFenceLate>
struct with_fences : aware {
  using aware::aware;
  [[nodiscard]] std::uint32_t load_link(std::uint32_t link, order) const {
    const std::uint32_t node = aware::load_link(link, relaxed);
    if (inserting() ? InsertFence : ReadFence) {
      fence(acquire);
    }
    return node;
  }
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired, order) {
    if (PublishFence && !PublishFenceLate) {
      fence(release);
    }
    const std::uint32_t found = aware::compare_exchange_link(link, expected, desired, relaxed);
    if (PublishFenceLate) {
      fence(release);
    }
    return found;
  }
};

using fences = with_fences<true, true, true, false>;
using no_insert_fence = with_fences<false, true, true, false>;
using no_reader_fence = with_fences<true, false, true, false>;
using no_publish_fence = with_fences<true, true, false, false>;
using late_publish_fence = with_fences<true, true, true, true>;

/// The successor is not verified: whatever is there is replaced.
struct no_verification : aware {
  using aware::aware;
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired, order o) {
    aware::exchange_link(link, desired, o);
    return expected;
  }
};

/// The successor is verified, but by a load before a store.
struct verifies_then_stores : aware {
  using aware::aware;
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired, order o) {
    const std::uint32_t found = aware::load_link(link, acquire);
    if (found == expected) {
      aware::store_link(link, desired, o);
    }
    return found;
  }
};

/// An exchange that failed is not tried again.
struct no_retry : aware {
  using aware::aware;
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired, order o) {
    (void)aware::compare_exchange_link(link, expected, desired, o);
    return expected;
  }
};

/// The node's own link (2) is stored in the first attempt only; a retry goes on with the old successor.
struct keeps_old_successor : aware {
  keeps_old_successor(pool kind, std::uint32_t capacity, std::uint32_t threads)
      : aware(kind, capacity, threads), stored(capacity + 1u, false) {}
  void store_link(std::uint32_t link, std::uint32_t node, order o) {
    if (!stored[link]) {
      aware::store_link(link, node, o);
      stored[link] = true;
    }
  }
  std::vector<bool> stored;
};

/// The node's own link (2) is stored behind the publication (3).
struct links_after_publishing : aware {
  links_after_publishing(pool kind, std::uint32_t capacity, std::uint32_t threads)
      : aware(kind, capacity, threads), waiting(threads) {}
  void store_link(std::uint32_t link, std::uint32_t node, order) { mine() = {link, node}; }
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired, order o) {
    const std::uint32_t found = aware::compare_exchange_link(link, expected, desired, o);
    if (found == expected) {
      aware::store_link(mine().first, mine().second, relaxed);
    }
    return found;
  }
  std::pair<std::uint32_t, std::uint32_t>& mine() {
    return waiting[static_cast<std::size_t>(world::current().thread())];
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> waiting;
};

/// Ties in depth go to the smaller slot, not to the smaller id: what was there first stays in front.
struct ties_by_slot : aware {
  using aware::aware;
  [[nodiscard]] fragment read_node(std::uint32_t node) const {
    const fragment f = aware::read_node(node);
    return inserting() ? fragment{f.depth, 0u} : f;
  }
};

/// Takes a node without asking first whether the pool is full: the counter grows without a bound.
struct unbounded_counter : aware {
  using aware::aware;
  [[nodiscard]] std::uint32_t load_taken(order o) const { return inserting() ? 0u : aware::load_taken(o); }
};

/// Takes a node without asking afterwards whether the pool had one left.
struct overdrawn_pool : aware {
  overdrawn_pool(pool kind, std::uint32_t capacity, std::uint32_t threads) : aware(kind, capacity, threads) {}
  std::uint32_t add_taken(order o) { return std::min(aware::add_taken(o), node_capacity() - 1u); }
};

/// Counts nodes by a load and a store.
struct counter_in_two_steps : aware {
  using aware::aware;
  std::uint32_t add_taken(order o) {
    const std::uint32_t taken = aware::load_taken(o);
    aware::store_taken(taken + 1u);
    return taken;
  }
  std::uint32_t add_taken_nodes(std::uint32_t count, order o) {
    const std::uint32_t taken = aware::load_taken(o);
    aware::store_taken(taken + count);
    return taken;
  }
};

/// Counts refused fragments by a load and a store.
struct refusals_in_two_steps : aware {
  using aware::aware;
  void add_refused(order) { aware::store_refused(aware::load_refused() + 1u); }
};

/// Holds a lock around each publication, so that one suspended thread stops all.
struct locked : aware {
  using aware::aware;
  std::uint32_t compare_exchange_link(std::uint32_t link, std::uint32_t expected, std::uint32_t desired, order o) {
    while (lock.exchange(1u, acquire) != 0u) {
    }
    const std::uint32_t found = aware::compare_exchange_link(link, expected, desired, o);
    lock.store(0u, release);
    return found;
  }
  watched_atomic<std::uint32_t> lock{"lock"};
};

/// a_buffer: the head is taken by a load and a store.
struct head_in_two_steps : aware {
  using aware::aware;
  std::uint32_t exchange_link(std::uint32_t link, std::uint32_t node, order o) {
    const std::uint32_t old = aware::load_link(link, o);
    aware::store_link(link, node, o);
    return old;
  }
};

/// a_buffer: the node's own link (2) is left out.
struct unlinked : aware {
  using aware::aware;
  void store_link(std::uint32_t, std::uint32_t, order) {}
};

/// A barrier between the phases, in place of a join.
template <class Barrier>
struct with_barrier : aware {
  using aware::aware;
  void done() { barrier.arrive(); }
  void wait_for_others() { barrier.wait(inserters); }
  Barrier barrier{"arrived"};
};

}  // namespace pelage::explore::list_variants
