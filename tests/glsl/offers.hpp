// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include <bit>
#include <cstdint>
#include <vector>

namespace pelage::test {

/// Many fragments from one drawn number: rapidcheck's own containers are made for tens, not for 60 000.
inline std::vector<fragment> many(std::uint32_t seed, std::uint32_t count, std::uint32_t depths) {
  std::vector<fragment> all(count);
  std::uint32_t state = seed * 2654435761U + 12345U;
  for (std::uint32_t i = 0; i < count; ++i) {
    state = state * 1664525U + 1013904223U;
    all[i] = fragment{static_cast<float>((state >> 8U) % depths), i};
  }
  return all;
}

/// The buffer from which the invocations of a concurrent kernel take one fragment each, behind two words of its own.
inline std::vector<std::uint32_t> offers_of(std::uint32_t first, std::uint32_t second,
                                            const std::vector<fragment>& fragments) {
  std::vector<std::uint32_t> words{first, second};
  for (const fragment& f : fragments) {
    words.push_back(std::bit_cast<std::uint32_t>(f.depth));
    words.push_back(f.id);
  }
  return words;
}

}  // namespace pelage::test
