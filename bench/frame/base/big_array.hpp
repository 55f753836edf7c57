// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace pelage::frame {

/// Leaves new elements as memory has them, where std::allocator sets numbers to 0.
template <class T>
struct uninitialised : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = uninitialised<U>;
  };
  template <class U>
  void construct(U* at) {
    ::new (static_cast<void*>(at)) U;
  }
  template <class U, class... Values>
  void construct(U* at, Values&&... values) {
    ::new (static_cast<void*>(at)) U(std::forward<Values>(values)...);
  }
};

/// An array that all threads fill: nothing writes it before them, so that each brings its own pages in.
template <class T>
using big_array = std::vector<T, uninitialised<T>>;

}  // namespace pelage::frame
