// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Between this file and exact_end.hpp every product is rounded before it is added, so that formulas have the same bits
// in each unit that includes them, in packs as alone, under every flag that keeps IEEE 754. Clang obeys a pragma,
// unless -ffp-contract=fast is given; that and its -fassociative-math and -freciprocal-math cannot be seen here. GCC
// has none: where the target has fused multiply-add, it needs a flag, which pelage::pelage brings in CMake. No include
// guard: every header with formulas has its own pair.
#ifndef PELAGE_FLOATING_POINT_CHECKED
#define PELAGE_FLOATING_POINT_CHECKED
#if (defined(__FAST_MATH__) || __FINITE_MATH_ONLY__ + 0 > 0 || defined(__ASSOCIATIVE_MATH__) || \
     defined(__RECIPROCAL_MATH__)) &&                                                           \
    !defined(PELAGE_ALLOW_FAST_MATH)
#error "pelage: -ffast-math and its parts break NaN and bits; -DPELAGE_ALLOW_FAST_MATH takes what comes"
#elif defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ == 1 || __FLT_EVAL_METHOD__ == 2)
#error "pelage: floats have the bits of doubles here: compile with -msse2 -mfpmath=sse"
#elif !defined(__clang__) && (defined(__FMA__) || defined(__FMA4__) || defined(__FP_FAST_FMAF)) && \
    !defined(PELAGE_CONTRACTION_OFF) && !defined(PELAGE_ALLOW_CONTRACTION)
#error \
    "pelage: this target fuses multiply-add: -ffp-contract=off -DPELAGE_CONTRACTION_OFF, or -DPELAGE_ALLOW_CONTRACTION"
#endif
#endif

#if defined(__clang__) && !defined(PELAGE_ALLOW_CONTRACTION)
#pragma float_control(push)
#pragma clang fp contract(off)
#endif
