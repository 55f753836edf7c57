// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "features.hpp"

namespace features {

template float conversions(float, float, int) noexcept;
template float by_type(float) noexcept;
template struct ring<6u>;
template struct ring<9u>;
template ring<6u> empty_ring<6u>() noexcept;
template ring<9u> empty_ring<9u>() noexcept;
template std::uint32_t fold(const ring<6u>&) noexcept;
template std::uint32_t fold(const ring<9u>&) noexcept;

}  // namespace features
