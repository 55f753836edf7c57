// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Compiled once for each instruction set, with PELAGE_BENCH_ISA as its name.
#include <pelage/order/k_select.hpp>

#include "method.hpp"

namespace bench {

static_assert(pelage::widest_isa == pelage::vector_isa::PELAGE_BENCH_ISA);

template <std::uint32_t K>
static void run(const workload& w) {
  pelage::k_select<K>(w.fragments, w.first, w.nearest);
}

#define PELAGE_JOIN(a, b) a##b
#define PELAGE_TEXT(a) #a
#define PELAGE_METHOD(isa)                     \
  const method PELAGE_JOIN(k_select_, isa) = { \
      "k_select " PELAGE_TEXT(isa), true, {run<4>, run<8>, run<16>, run<32>, run<64>}}
PELAGE_METHOD(PELAGE_BENCH_ISA);

}  // namespace bench
