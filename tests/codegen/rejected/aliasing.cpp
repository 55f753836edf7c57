// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// GLSL copies inout arguments in and out, so two that share a place would end otherwise than in C++.
#include <array>

namespace rejected {

struct pair {
  int a;
  int b;
  std::array<int, 4> more;
  void take(int& x) noexcept {
    a += x;
    x = b;
  }
};

void exchange(int& x, int& y) noexcept {
  const int z = x;
  x = y;
  y = z;
}

void change(pair& p, const int& by) noexcept {
  p.a += by;
  p.b += by;
}

int itself_twice(int a) noexcept {
  exchange(a, a);  // error: aliasing arguments: `a` and `a` share a place that the call writes to
  return a;
}

int one_element_twice(std::array<int, 4> a, int i) noexcept {
  exchange(a[i], a[i]);  // error: aliasing arguments: `a[i]` and `a[i]` share a place that the call writes to
  return a[0];
}

pair whole_and_part(pair p) noexcept {
  change(p, p.a);  // error: aliasing arguments: `p` and `p.a` share a place that the call writes to
  return p;
}

pair object_and_member(pair p) noexcept {
  p.take(p.b);  // error: aliasing arguments: `p` and `p.b` share a place that the call writes to
  return p;
}

pair different_elements_are_fine(pair p, int i) noexcept {
  exchange(p.more[i], p.more[i + 1]);
  return p;
}

}  // namespace rejected
