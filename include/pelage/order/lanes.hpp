// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>
#if defined(__SSE2__)
#include <immintrin.h>
#elif defined(__aarch64__)
#include <arm_neon.h>
#endif

namespace pelage {

/// The vector instructions that k_select is written for. `plain` is any machine: the compiler makes of it what it can.
enum class vector_isa { plain, sse2, neon, avx2, avx512 };

/// The widest that this translation unit is compiled for.
#if defined(__AVX512F__)
inline constexpr vector_isa widest_isa = vector_isa::avx512;
#elif defined(__AVX2__)
inline constexpr vector_isa widest_isa = vector_isa::avx2;
#elif defined(__SSE2__)
inline constexpr vector_isa widest_isa = vector_isa::sse2;
#elif defined(__aarch64__)
inline constexpr vector_isa widest_isa = vector_isa::neon;
#else
inline constexpr vector_isa widest_isa = vector_isa::plain;
#endif

/// One vector of depths, one of keys, and what can be done with them, in the compiler's vector types. The instruction
/// sets below differ only in how they make bits of a comparison.
template <std::uint32_t Bytes>
struct vector_lanes {
  using depths [[gnu::vector_size(Bytes)]] = float;
  using keys [[gnu::vector_size(Bytes)]] = double;
  using words [[gnu::vector_size(Bytes)]] = std::uint32_t;
  using longs [[gnu::vector_size(Bytes)]] = std::uint64_t;
  static constexpr std::uint32_t depth_count = Bytes / 4u;
  static constexpr std::uint32_t key_count = Bytes / 8u;
};

}  // namespace pelage
