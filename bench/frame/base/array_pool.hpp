// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace pelage::frame {

/// Memory for very many short arrays, given to all threads at once. They stay where they are until the pool goes.
template <class T>
class array_pool {
 public:
  /// `n` elements that are not initialised.
  [[nodiscard]] std::span<T> take(std::size_t n) {
    own& mine = per_thread_.local();
    if (n > mine.rest.size()) {
      const std::size_t size = std::max(n, chunk);
      mine.chunks.push_back(std::make_unique_for_overwrite<T[]>(size));
      mine.rest = {mine.chunks.back().get(), size};
    }
    mine.elements += n;
    const std::span<T> taken = mine.rest.first(n);
    mine.rest = mine.rest.subspan(n);
    return taken;
  }

  /// What is taken; a thread has at most one chunk of 65,536 elements more.
  [[nodiscard]] std::size_t bytes() const {
    std::size_t elements = 0;
    for (const own& one : per_thread_)
      elements += one.elements;
    return elements * sizeof(T);
  }

 private:
  static constexpr std::size_t chunk = 65536;

  struct own {
    std::vector<std::unique_ptr<T[]>> chunks;
    std::span<T> rest;         ///< of the last chunk
    std::size_t elements = 0;  ///< taken
  };
  tbb::enumerable_thread_specific<own> per_thread_;
};

}  // namespace pelage::frame
