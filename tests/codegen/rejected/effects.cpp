// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Effects belong into statements of their own: C++ and GLSL order them differently inside an expression.
#include <array>
#include <utility>

namespace rejected {

struct counter {
  int count;
  int next() noexcept {
    count += 1;
    return count;
  }
};

int bump(int& x) noexcept {
  x += 1;
  return x;
}

int increment_in_an_index(std::array<int, 4> a, int i) noexcept {
  a[i] = i++;  // error: increment inside an expression: make it a statement of its own
  return a[i];
}

int assignment_in_an_expression(int a) noexcept {
  int b = 0;
  int c = (b = a) + 1;  // error: assignment inside an expression: make it a statement of its own
  return b + c;
}

int chained_assignment(int a) noexcept {
  int b = 0;
  int c = 0;
  b = c = a;  // error: assignment inside an expression: make it a statement of its own
  return b + c;
}

int two_effects(int a) noexcept {
  return bump(a) + a;  // error: call with an effect inside an expression: give its result a name first
}

int effect_in_an_argument(int a, int b) noexcept {
  return bump(a) * b + bump(b);  // error: call with an effect inside an expression: give its result a name first
}

int effect_of_a_member(counter c) noexcept {
  return c.next() - c.next();  // error: call with an effect inside an expression: give its result a name first
}

int comma(int a) noexcept {
  int b = (a, 2);  // error: comma operator
  return b;
}

int no_effect(int a) noexcept {
  a + 1;  // error: statement without effect
  return a;
}

bool effect_behind_and(int a) noexcept {
  return a > 0 && bump(a) > 2;  // error: call with an effect inside an expression: give its result a name first
}

}  // namespace rejected
