// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The map that a shader is compiled for. All have extend_range() and load_range(), map_position(), occupy(), and for
// sums.glsl mark_end(), passed_ends() and total_of().
#ifdef LAYERED
#include "layer_map.glsl"
#elif defined(MOMENTS)
#include "moment_map.glsl"
#else
#include "occupancy.glsl"
#endif
