// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The pool as the library's list storage: `push.lists` lists a pixel, one node a fragment.
#ifndef PELAGE_FRAME_LISTS_GLSL
#define PELAGE_FRAME_LISTS_GLSL
#include "scene.glsl"

uint view_pixels() {
  return uint(VIEW.size.x) * uint(VIEW.size.y);
}

#define PELAGE_ATOMIC_LIST_STORAGE_LINKS(i) links[i]
#define PELAGE_ATOMIC_LIST_STORAGE_LINKS_SIZE (push.lists * view_pixels() + push.capacity)
#define PELAGE_ATOMIC_LIST_STORAGE_NODES(i) pool[i]
#define PELAGE_ATOMIC_LIST_STORAGE_NODES_SIZE push.capacity
#define PELAGE_ATOMIC_LIST_STORAGE_TAKEN reports[this_view()].taken
#define PELAGE_ATOMIC_LIST_STORAGE_REFUSED reports[this_view()].refused
#include "pelage/glsl/order/a_buffer.glsl"
#include "pelage/glsl/order/ordered_list.glsl"
#include "pelage/glsl/order/unrolled_list.glsl"

#endif
