// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "glsl/device.hpp"

/// The kernels of tests/glsl/kernels, compiled into the program, so that it runs where no compiler is.
namespace pelage::test::kernels {

#define PELAGE_KERNEL(name) extern const kernel name;
PELAGE_KERNEL(arithmetic)
PELAGE_KERNEL(core)
PELAGE_KERNEL(coverage)
PELAGE_KERNEL(composite)
PELAGE_KERNEL(bsdf)
PELAGE_KERNEL(elementary)
PELAGE_KERNEL(lobes)
PELAGE_KERNEL(chiang)
PELAGE_KERNEL(chiang_sample)
PELAGE_KERNEL(chiang_far)
PELAGE_KERNEL(marschner)
PELAGE_KERNEL(dual_scattering)
PELAGE_KERNEL(highlights)
PELAGE_KERNEL(contraction)
PELAGE_KERNEL(features)
PELAGE_KERNEL(k_buffer_16)
PELAGE_KERNEL(k_buffer_8)
PELAGE_KERNEL(a_buffer)
PELAGE_KERNEL(ordered_list)
#undef PELAGE_KERNEL

}  // namespace pelage::test::kernels
