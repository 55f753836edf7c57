// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/tail.hpp>
#include <pelage/core/assert.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <atomic>
#include <concepts>
#include <cstdint>
#include <span>

namespace pelage {

/// The words of a pixel in atomic_tail: the five sums of a tail, and one bit a sum that went beyond 2^32.
[[nodiscard]] constexpr std::uint32_t tail_words() noexcept {
  return 6u;
}

/// Where atomic_tail lives: 32-bit cells. add_word() adds modulo 2^32 and returns what the cell held before;
/// or_word() sets bits.
template <class Storage>
concept tail_storage = requires(Storage& s, const Storage& c, std::uint32_t n, std::uint32_t value,
                                std::memory_order order) {
  { c.word_count() } -> std::same_as<std::uint32_t>;
  { c.load_word(n, order) } -> std::same_as<std::uint32_t>;
  { s.add_word(n, value, order) } -> std::same_as<std::uint32_t>;
  { s.or_word(n, value, order) } -> std::same_as<void>;
};

/// tail_storage over the caller's memory, atomic through std::atomic_ref. 24 bytes a pixel.
struct atomic_tail_storage {
  std::span<std::uint32_t> words;  ///< tail_words() a pixel, pixel after pixel; clear() before use

  /// Empties every tail. Not concurrent.
  void clear() noexcept { std::fill(words.begin(), words.end(), 0u); }

  [[nodiscard]] std::uint32_t word_count() const noexcept { return static_cast<std::uint32_t>(words.size()); }
  [[nodiscard]] std::uint32_t load_word(std::uint32_t word, std::memory_order order) const noexcept {
    return std::atomic_ref(words[word]).load(order);
  }
  std::uint32_t add_word(std::uint32_t word, std::uint32_t value, std::memory_order order) noexcept {
    return std::atomic_ref(words[word]).fetch_add(value, order);
  }
  void or_word(std::uint32_t word, std::uint32_t bits, std::memory_order order) noexcept {
    std::atomic_ref(words[word]).fetch_or(bits, order);
  }
};

static_assert(tail_storage<atomic_tail_storage>);

/// A tail (composite/tail.hpp) a pixel, to which many threads add at once: for what falls out of an atomic_k_buffer.
///
/// Holds the same five sums, bit for bit, whatever the interleaving. A sum modulo 2^32 passes its end once for every
/// 2^32 of the true sum, in whichever order the parts come; so whether one of the additions saw it pass says whether
/// the sum saturates, and atomic additions suffice where tail's own need a saturating one.
namespace atomic_tail {

/// Adds one fragment's tail, as add_fragment(empty_tail(), alpha, colour) makes it. `pixel`: [0, word_count() / 6).
/// Wait-free where the hardware adds atomically; O(1): at most 6 atomics, none for a sum that gains nothing.
///
/// (1) and (2) are relaxed: sums and bits are read after the barrier that ends the phase, and publish nothing else.
template <tail_storage Storage>
void add(Storage& storage, std::uint32_t pixel, const tail& one) noexcept;

/// The tail that merge() gives for all that was added. Not concurrent with add: (3) is relaxed, the barrier orders it
/// after every (1) and (2).
template <tail_storage Storage>
[[nodiscard]] tail load(const Storage& storage, std::uint32_t pixel) noexcept;

/// Adds to one sum, `sum` in [0, 5) in tail's order. Part of add().
template <tail_storage Storage>
void add_to_sum(Storage& storage, std::uint32_t pixel, std::uint32_t sum, std::uint32_t part) noexcept;

/// One sum as tail has it. Part of load().
template <tail_storage Storage>
[[nodiscard]] std::uint32_t load_sum(const Storage& storage, std::uint32_t pixel, std::uint32_t sum) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <tail_storage Storage>
void add_to_sum(Storage& storage, std::uint32_t pixel, std::uint32_t sum, std::uint32_t part) noexcept {
  if (part != 0u) {
    const std::uint32_t first = pixel * tail_words();
    const std::uint32_t held = storage.add_word(first + sum, part, std::memory_order_relaxed);  // (1)
    if (held > 0xffffffffu - part) {
      storage.or_word(first + 5u, 1u << sum, std::memory_order_relaxed);  // (2)
    }
  }
}

template <tail_storage Storage>
std::uint32_t load_sum(const Storage& storage, std::uint32_t pixel, std::uint32_t sum) noexcept {
  const std::uint32_t first = pixel * tail_words();
  const std::uint32_t passed = storage.load_word(first + 5u, std::memory_order_relaxed);  // (3)
  const std::uint32_t held = storage.load_word(first + sum, std::memory_order_relaxed);   // (3)
  return ((passed >> sum) & 1u) != 0u ? 0xffffffffu : held;
}

template <tail_storage Storage>
void add(Storage& storage, std::uint32_t pixel, const tail& one) noexcept {
  PELAGE_ASSERT(pixel < storage.word_count() / tail_words());
  add_to_sum(storage, pixel, 0u, one.optical);
  add_to_sum(storage, pixel, 1u, one.weight);
  add_to_sum(storage, pixel, 2u, one.red);
  add_to_sum(storage, pixel, 3u, one.green);
  add_to_sum(storage, pixel, 4u, one.blue);
}

template <tail_storage Storage>
tail load(const Storage& storage, std::uint32_t pixel) noexcept {
  PELAGE_ASSERT(pixel < storage.word_count() / tail_words());
  return tail{load_sum(storage, pixel, 0u), load_sum(storage, pixel, 1u), load_sum(storage, pixel, 2u),
              load_sum(storage, pixel, 3u), load_sum(storage, pixel, 4u)};
}

}  // namespace atomic_tail

}  // namespace pelage
