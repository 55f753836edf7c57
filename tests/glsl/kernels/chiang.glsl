// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// A fibre and how it is seen, from the first eleven words of a row.
#include "pelage/glsl/bsdf/chiang.glsl"

pelage_chiang_fibre fibre() {
  return pelage_make_chiang_fibre(
      pelage_chiang_parameters(f(0u), float[3](f(1u), f(2u), f(3u)), f(4u), f(5u), f(6u)));
}

pelage_fibre_direction eye() { return pelage_fibre_direction_of(f(8u), f(9u), f(10u)); }

pelage_chiang_view view() { return pelage_view_chiang(fibre(), f(7u), eye()); }
