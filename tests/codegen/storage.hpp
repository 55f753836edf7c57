// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/atomic_cells.hpp>
#include <pelage/core/lane_group.hpp>

#include <array>
#include <atomic>
#include <cstdint>
#include <span>

/// Cells that the shader provides, atomics of both widths, and whose size is whose: compared with its translation in
/// storage.glsl and run on a device.
namespace features {

/// Nothing but spans and pointers: it vanishes from signatures.
struct cells {
  std::span<std::uint32_t> words;  ///< of 32 bits, count() of them
  std::span<std::uint64_t> wides;  ///< of 64 bits
  std::uint32_t* total;            ///< one cell

  [[nodiscard]] std::uint32_t count() const noexcept { return static_cast<std::uint32_t>(words.size()); }
  [[nodiscard]] std::uint32_t load(std::uint32_t i, std::memory_order order) const noexcept {
    return std::atomic_ref(words[i]).load(order);
  }
  void store(std::uint32_t i, std::uint32_t value) noexcept {
    std::atomic_ref(words[i]).store(value, std::memory_order_release);
  }
  std::uint32_t exchange(std::uint32_t i, std::uint32_t value) noexcept {
    return std::atomic_ref(words[i]).exchange(value, std::memory_order_acq_rel);
  }
  std::uint32_t claim(std::uint32_t i, std::uint32_t expected, std::uint32_t value) noexcept {
    std::atomic_ref(words[i]).compare_exchange_strong(expected, value, std::memory_order_acquire,
                                                      std::memory_order_relaxed);
    return expected;
  }
  void add_to_total(std::uint32_t value) noexcept {
    std::atomic_ref(*total).fetch_add(value, std::memory_order_relaxed);
  }
  void change(std::uint32_t i, std::uint32_t value) noexcept {
    std::atomic_ref(words[i]).fetch_add(value, std::memory_order_relaxed);
    std::atomic_ref(words[i + 1u]).fetch_and(value, std::memory_order_relaxed);
    std::atomic_ref(words[i + 2u]).fetch_or(value, std::memory_order_relaxed);
    std::atomic_ref(words[i + 3u]).fetch_xor(value, std::memory_order_relaxed);
    pelage::fetch_minimum(std::atomic_ref(words[i + 4u]), value, std::memory_order_relaxed);
    pelage::fetch_maximum(std::atomic_ref(words[i + 7u]), value, std::memory_order_relaxed);
  }
  [[nodiscard]] std::uint64_t load_wide(std::uint32_t i, std::memory_order order) const noexcept {
    return std::atomic_ref(wides[i]).load(order);
  }
  void change_wide(std::uint32_t i, std::uint64_t value) noexcept {
    std::atomic_ref(wides[i]).fetch_add(value, std::memory_order_release);
    std::atomic_ref(wides[i + 1u]).fetch_xor(value, std::memory_order_relaxed);
    pelage::fetch_minimum(std::atomic_ref(wides[i + 2u]), value, std::memory_order_relaxed);
  }
};

/// Effects on cells are statements of their own. Leaves the changed cells the same in whatever order the calls come.
inline void use(cells& storage, std::uint32_t i, std::uint32_t value) noexcept {
  storage.change(0u, value);
  const std::uint64_t wide = (static_cast<std::uint64_t>(value) << 32u) | static_cast<std::uint64_t>(i);
  storage.change_wide(0u, wide + (storage.load_wide(3u, std::memory_order_acquire)));
  const std::uint32_t found = storage.claim(5u, 0u, i + 1u);
  if (found == 0u) {
    const std::uint32_t before = storage.exchange(6u, 7u);
    storage.add_to_total(before);
  }
}

/// The size of a function in a namespace of its own is the namespace's.
namespace tally {

template <std::uint32_t N, class Cells>
void add(Cells& storage, std::uint32_t x) noexcept {
  static_assert(N >= 1u && N <= 16u, "features::tally: N must be in [1, 16]");
  storage.add_to_total(x % N);
}

template <std::uint32_t N, class Cells>
[[nodiscard]] bool is_first(const Cells& storage, std::uint32_t i) noexcept {
  return storage.load(i % N, std::memory_order_acquire) == 0u;
}

}  // namespace tally

/// A struct with a size, and a member over storage.
template <std::uint32_t N>
struct histogram {
  static constexpr std::uint32_t bins = N + 1u;
  std::array<std::uint32_t, bins> held;

  template <class Cells>
  void store(Cells& storage, std::uint32_t first) const noexcept {
    for (std::uint32_t i = 0u; i < bins; ++i) {
      storage.store(first + i, held[i]);
    }
  }
};

/// The size of a function beside a struct is the struct's.
template <std::uint32_t N, class Cells>
[[nodiscard]] std::uint32_t place_in(const Cells& storage, std::uint32_t x) noexcept {
  return x % N + storage.count() - storage.count();
}

/// The size of a type that is an argument is the function's.
template <class Histogram, class Cells>
[[nodiscard]] Histogram load_histogram(const Cells& storage, std::uint32_t first) noexcept {
  Histogram result;
  for (std::uint32_t i = 0u; i < Histogram::bins; ++i) {
    result.held[i] = storage.load(first + i, std::memory_order_relaxed);
  }
  return result;
}

/// A subgroup vanishes from signatures as storage does; what it can do is GLSL's.
template <pelage::lane_group Group>
[[nodiscard]] std::uint32_t use_lanes(Group& group, std::uint32_t x) noexcept {
  std::uint32_t sum = x;
  for (std::uint32_t bits = group.size() / 2u; bits > 0u; bits /= 2u) {
    sum += group.shuffle_xor(sum, bits);
  }
  group.store(group.lane(), sum + group.count(x > 3u).all + group.count(x > 5u).below);
  group.barrier();
  return group.load(group.size() - 1u - group.lane()) ^ group.shuffle(sum, 0u);
}

}  // namespace features
