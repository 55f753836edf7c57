// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/order/list_storage.hpp>

#include <atomic>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// One CPU thread's way to lists that many threads build: as atomic_list_storage, but it takes nodes from the pool in
/// blocks, so that threads neither meet at one counter for each fragment nor write to the same cache lines.
///
/// Every thread makes its own from the storage that all share. What is left of its last block when it is done serves no
/// one: a pool of n + (block_size() - 1) · threads nodes takes n fragments for every interleaving, a smaller one may be
/// full earlier. `taken` counts blocks' nodes, and passes the capacity by at most block_size() for each thread.
class block_list_storage : public atomic_list_storage {
 public:
  explicit block_list_storage(const atomic_list_storage& shared) noexcept : atomic_list_storage(shared) {}
  block_list_storage(const block_list_storage&) = delete;  // two would hand out the same nodes
  block_list_storage& operator=(const block_list_storage&) = delete;

  /// Nodes that are taken at once: 64, so that fragments and links of a block fill cache lines.
  [[nodiscard]] static constexpr std::uint32_t block_size() noexcept { return 64u; }

  /// The next node of the own block, or where that is used up, the shared counter.
  [[nodiscard]] std::uint32_t load_taken(std::memory_order order) const noexcept {
    return next_ < end_ ? next_ : atomic_list_storage::load_taken(order);
  }

  /// A node of the own block, after taking another one if need be. The add is take_node()'s (2), for 64 nodes.
  [[nodiscard]] std::uint32_t add_taken(std::memory_order order) noexcept {
    if (next_ == end_) {
      next_ = std::atomic_ref(*taken).fetch_add(block_size(), order);
      end_ = next_ + block_size();
    }
    return next_++;
  }

 private:
  std::uint32_t next_ = 0u;
  std::uint32_t end_ = 0u;
};

static_assert(list_storage<block_list_storage>);

}  // namespace pelage
