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
PELAGE_KERNEL(special_values)
PELAGE_KERNEL(lobes)
PELAGE_KERNEL(chiang)
PELAGE_KERNEL(chiang_sample)
PELAGE_KERNEL(chiang_far)
PELAGE_KERNEL(marschner)
PELAGE_KERNEL(dual_scattering)
PELAGE_KERNEL(highlights)
PELAGE_KERNEL(contraction)
PELAGE_KERNEL(features)
PELAGE_KERNEL(storage)
PELAGE_KERNEL(k_buffer_16)
PELAGE_KERNEL(k_buffer_8)
PELAGE_KERNEL(a_buffer)
PELAGE_KERNEL(ordered_list)
PELAGE_KERNEL(atomic_k_buffer)
PELAGE_KERNEL(two_pass_depths)
PELAGE_KERNEL(two_pass_ids)
PELAGE_KERNEL(two_pass_read)
PELAGE_KERNEL(visibility)
PELAGE_KERNEL(deep_shadow_map)
PELAGE_KERNEL(blending)
PELAGE_KERNEL(maps)
PELAGE_KERNEL(loaded_maps)
#undef PELAGE_KERNEL

}  // namespace pelage::test::kernels
