// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The lists of one frame. The blocks bear names that the mirror's functions use for their locals: neither may see
// the other's.
#include "pelage/glsl/core/fragment.glsl"

layout(local_size_x_id = 0) in;
layout(std430, binding = 0) readonly buffer offers {
  uint limit;
  uint lists;
  pelage_fragment offered[];
};
layout(std430, binding = 1) coherent buffer link_block {
  uint link[];
};
layout(std430, binding = 2) coherent buffer node_block {
  pelage_fragment node[];
};
layout(std430, binding = 3) coherent buffer counters {
  uint successor;
  uint found;
};

#define PELAGE_ATOMIC_LIST_STORAGE_LINKS(i) link[i]
#define PELAGE_ATOMIC_LIST_STORAGE_LINKS_SIZE link.length()
#define PELAGE_ATOMIC_LIST_STORAGE_NODES(i) node[i]
#define PELAGE_ATOMIC_LIST_STORAGE_NODES_SIZE node.length()
#define PELAGE_ATOMIC_LIST_STORAGE_TAKEN successor
#define PELAGE_ATOMIC_LIST_STORAGE_REFUSED found
