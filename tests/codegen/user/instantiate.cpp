// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "shading.hpp"

template float fur::nearest_depth(const pelage::k_buffer<16u>&) noexcept;
template float fur::nearest_depth(const pelage::k_buffer<8u>&) noexcept;
template bool fur::is_bare(const pelage::k_buffer<16u>&) noexcept;
template bool fur::is_bare(const pelage::k_buffer<8u>&) noexcept;
