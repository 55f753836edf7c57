// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

namespace pelage::frame {

/// Calls `use.operator()<N>()` with the one of `Sizes` that is `size`: from a number that the user chose to a
/// template's argument. False, and no call, if there is none.
template <auto Sizes, class Use>
bool with_compiled_size(std::uint32_t size, const Use& use) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return ((Sizes[I] == size && (use.template operator()<Sizes[I]>(), true)) || ...);
  }
  (std::make_index_sequence<Sizes.size()>());
}

/// The same, which throws std::invalid_argument where there is none. `what`: the sizes are of.
template <auto Sizes, class Use>
void with_size_of(const std::string& what, std::uint32_t size, const Use& use) {
  if (!with_compiled_size<Sizes>(size, use)) {
    throw std::invalid_argument("the renderer is not compiled for this number of " + what);
  }
}

}  // namespace pelage::frame
