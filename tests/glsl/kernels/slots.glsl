// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The slots of one frame's K-buffers, and what falls out of them. The blocks bear names that the mirror's functions use
// for their locals: neither may see the other's.
#include "pelage/glsl/core/fragment.glsl"

layout(local_size_x_id = 0) in;
layout(std430, binding = 0) readonly buffer offers {
  uint unused;
  uint pixels;
  pelage_fragment offered[];
};
layout(std430, binding = 1) coherent buffer slot_block {
#ifdef WIDE
  uint64_t held[];
#else
  uint held[];
#endif
};
layout(std430, binding = 2) buffer lost_block {
  pelage_fragment lost[];
};
