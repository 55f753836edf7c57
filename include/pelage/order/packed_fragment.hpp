// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// A fragment as a number that orders as the fragment does: depth_key in the high word, id in the low one. What
/// no_fragment() gives is above that of every fragment. For fragments that is_fragment() accepts, or no_fragment().
[[nodiscard]] constexpr std::uint64_t pack(fragment f) noexcept {
  return (static_cast<std::uint64_t>(depth_key(f.depth)) << 32u) | static_cast<std::uint64_t>(f.id);
}

/// The fragment that was packed, except for the sign of a zero depth.
[[nodiscard]] constexpr fragment unpack(std::uint64_t number) noexcept {
  return fragment{depth_from_key(static_cast<std::uint32_t>(number >> 32u)), static_cast<std::uint32_t>(number)};
}

}  // namespace pelage
