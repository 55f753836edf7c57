// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once

/// The version: PELAGE_VERSION is major · 10000 + minor · 100 + patch. Names may change with the minor version while
/// the major one is 0, with the major one alone after that.
#define PELAGE_VERSION_MAJOR 0
#define PELAGE_VERSION_MINOR 2
#define PELAGE_VERSION_PATCH 0
#define PELAGE_VERSION (PELAGE_VERSION_MAJOR * 10000 + PELAGE_VERSION_MINOR * 100 + PELAGE_VERSION_PATCH)

#if !(defined(__clang_major__) && __clang_major__ >= 14) && \
    !(!defined(__clang__) && defined(__GNUC__) && __GNUC__ >= 12)
#error "pelage: needs g++ 12 or clang 14, or a later one"
#elif __cplusplus < 202002L
#error "pelage: needs C++20: -std=c++20"
#endif

/// PELAGE_ABI names the inline namespace that everything stands in: major and minor version, the vectors and the
/// instructions for bits that a translation unit is compiled for, and whether it gave up the bits
/// (core/exact_begin.hpp). So units of one program that differ in these share no function. A type of Pelage as a
/// parameter between such units is an undefined reference; as a result, or within a type of yours, it links unnoticed.
/// Extensions not named here are your care, and so are the functions of GLM and std: the linker takes those of the unit
/// that it meets first.
#if defined(__AVX512VL__)
#define PELAGE_VECTORS _avx512vl
#elif defined(__AVX512F__)
#define PELAGE_VECTORS _avx512
#elif defined(__AVX2__) && defined(__BMI2__)
#define PELAGE_VECTORS _avx2_bmi2
#elif defined(__AVX2__)
#define PELAGE_VECTORS _avx2
#elif defined(__AVX__)
#define PELAGE_VECTORS _avx
#elif defined(__SSE4_1__)
#define PELAGE_VECTORS _sse4
#else
#define PELAGE_VECTORS
#endif
#if defined(__BMI__) && defined(__POPCNT__)
#define PELAGE_COUNTS _bmi_popcnt
#elif defined(__BMI__)
#define PELAGE_COUNTS _bmi
#elif defined(__POPCNT__)
#define PELAGE_COUNTS _popcnt
#else
#define PELAGE_COUNTS
#endif
#if defined(PELAGE_ALLOW_FAST_MATH) || defined(PELAGE_ALLOW_CONTRACTION)
#define PELAGE_BITS _inexact
#else
#define PELAGE_BITS
#endif
#define PELAGE_JOINED(major, minor, vectors, counts, bits) v##major##_##minor##vectors##counts##bits
#define PELAGE_NAMED(major, minor, vectors, counts, bits) PELAGE_JOINED(major, minor, vectors, counts, bits)
#define PELAGE_ABI PELAGE_NAMED(PELAGE_VERSION_MAJOR, PELAGE_VERSION_MINOR, PELAGE_VECTORS, PELAGE_COUNTS, PELAGE_BITS)

namespace pelage::inline PELAGE_ABI {

/// PELAGE_VERSION as a constant.
inline constexpr int version = PELAGE_VERSION;

}  // namespace pelage
