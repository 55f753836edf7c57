// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The size of a subgroup, known before a shader is compiled for the device.
#ifndef PELAGE_FRAME_SUBGROUP_GLSL
#define PELAGE_FRAME_SUBGROUP_GLSL

layout(constant_id = 1) const uint lanes = 32u;  ///< of a subgroup, a power of two

#endif
