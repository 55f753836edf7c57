// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/order/a_buffer.hpp>
#include <pelage/order/list_storage.hpp>

#include <cstdint>
#include <vector>

#include "frame/order/order_job.hpp"

namespace pelage::frame {

/// Memory for lists to which all threads push at once. Their nodes have been counted before, so that the pool is never
/// full.
struct list_memory {
  std::vector<std::uint32_t> count;  ///< fragments a pixel
  std::vector<std::uint32_t> links;
  std::vector<fragment> nodes;
  std::uint32_t taken = 0;
  std::uint32_t refused = 0;
  atomic_list_storage lists{};

  /// Counts, and reports what it found. Throws std::runtime_error when the nodes' numbers would not fit.
  list_memory(order_job& work, std::size_t lists_per_pixel);

  /// The list of a pixel; those of the n-th kind follow n times the number of pixels later.
  [[nodiscard]] static std::uint32_t list(const order_job& work, int x, int y) {
    return static_cast<std::uint32_t>(work.pixel(x, y));
  }

  /// Appends the fragments of a list that a_buffer::push() built.
  void append(std::uint32_t list, std::vector<fragment>& to) const {
    for (std::uint32_t node = a_buffer::first(lists, list); node != no_node(); node = a_buffer::next(lists, node)) {
      to.push_back(lists.read_node(node));
    }
  }

  /// How many fragments do not find room among K.
  [[nodiscard]] std::uint64_t beyond(std::uint32_t k) const;
};

}  // namespace pelage::frame
