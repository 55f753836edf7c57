// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <atomic>
#include <cstdint>
#include <span>

namespace rejected {

struct cells {
  std::span<std::uint32_t> word;
  std::uint32_t* total;

  std::uint32_t take() noexcept { return std::atomic_ref(*total).fetch_add(1u, std::memory_order_relaxed); }
  bool claim(std::uint32_t i, std::uint32_t v) noexcept {
    std::uint32_t expected = 0u;
    return std::atomic_ref(word[i]).compare_exchange_strong(expected, v, std::memory_order_relaxed);  // error: result of compare_exchange_strong: compare `expected`
  }
  std::uint32_t subtract(std::uint32_t i) noexcept {
    return std::atomic_ref(word[i]).fetch_sub(1u, std::memory_order_relaxed);  // error: std::atomic_ref::fetch_sub has no GLSL form
  }
  std::uint64_t count() const noexcept { return word.size(); }  // error: a span's size is a size_t: write static_cast<std::uint32_t>(x.size())
};

std::uint32_t effect_inside(cells& c) noexcept {
  return 2u * c.take();  // error: call with an effect inside an expression: give its result a name first
}

std::uint32_t past_the_functions(cells& c) noexcept {
  return c.word[0];  // error: spans and pointers can only be members of storage, reached by its functions
}

std::uint32_t by_value(cells c) noexcept {  // error: storage by value: pass it by reference
  return c.take();
}

std::uint32_t kept(cells& c) noexcept {
  cells copy = c;  // error: storage can only be a function's parameter | storage can only be passed on whole, or called
  return copy.take();
}

std::uint32_t use(cells& c) noexcept {
  const bool mine = c.claim(0u, 1u);
  const std::uint32_t left = c.subtract(1u);
  return mine ? left : static_cast<std::uint32_t>(c.count());
}

}  // namespace rejected
