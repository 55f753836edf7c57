// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#version 450
#extension GL_GOOGLE_include_directive : require
#include "lists.glsl"

#include "pelage/glsl/order/ordered_list.glsl"

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= uint(offered.length())) return;
  pelage_ordered_list_insert(i % lists, offered[i], limit);
}
