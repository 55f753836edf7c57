// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <array>
#include <utility>

namespace rejected {

int jump(int x) noexcept {
  if (x > 0) goto end;  // error: goto and labels
  x = -x;
end:  // error: goto and labels
  return x;
}

int throws(int x) {
  if (x < 0) throw 1;  // error: exceptions
  return x;
}

int tries(int x) noexcept {
  try {  // error: exceptions
    return x;
  } catch (...) {
    return 0;
  }
}

int in_if(int x) noexcept {
  if (const int y = x; y > 0) {  // error: declaration inside `if`
    return y;
  }
  return 0;
}

int in_while(int x) noexcept {
  while (const int y = x) {  // error: declaration inside `while`
    x = y - 1;
  }
  return x;
}

int two_in_a_head(int x) noexcept {
  for (int i = 0, n = 4; i < n; ++i) {  // error: several variables in the head of `for`
    x += i;
  }
  return x;
}

int remembers(int x) noexcept {
  static int seen = 0;  // error: static local variable
  seen += x;
  return seen;
}

int taken_apart(int x) noexcept {
  const auto [a, b] = std::pair<int, int>{x, x};  // error: structured binding
  return a + b;
}

int another_name(int x) noexcept {
  int& y = x;  // error: local reference: make a copy, or name the place each time
  y += 1;
  return x;
}

int local_type(int x) noexcept {
  struct inner {  // error: local type
    int y;
  };
  return inner{x}.y;
}

int cases(int x) noexcept {
  switch (x) {
    case 1 ... 3: return 1;  // error: range of cases
    default: return 0;
  }
}

int rest(int a, int b) noexcept {
  a %= b;  // error: % on signed integers
  return a % b;  // error: % on signed integers
}

#define TWICE(x) \
  (x) += 1;      \
  (x) += 1

int statements_of_a_macro(int x) noexcept {
  if (x > 0) {  // error: macro of statements: write a function
    TWICE(x);
  }
  return x;
}

#define STOP break
#define UNROLL
#define OTHERWISE else
#define DONE return
#define NOTHING

int macros_of_keywords(int x) noexcept {
  while (x < 9) {
    x += 1;
    STOP;  // error: macro of statements: write a function
  }
  UNROLL for (int i = 0; i < 4; ++i) {  // error: macro of statements: write a function
    x += i;
  }
  if (x > 0) {
    x = 1;
  } OTHERWISE {  // error: macro of statements: write a function
    x = 2;
  }
  for (int i = 0; i < 4; ++i) {
    NOTHING;  // error: macro of statements: write a function
  }
  DONE x;  // error: macro of statements: write a function
}

int configured(int x) noexcept {
#ifdef REJECTED  // error: preprocessor line inside a function
  x = 2;
#else
  x = 3;
#endif  // error: preprocessor line inside a function
  return x;
}

int digraphs(int x) noexcept {
  if (x > 0) <%  // error: `<%` between statements
    x = 1;
  }
  return x;
}

int in_constant_if(int x) noexcept {
  if constexpr (const int y = 1; sizeof(int) == 4) {  // error: declaration inside `if`
    return x + y;
  }
  return 0;
}

int in_range_for(std::array<int, 4> a) noexcept {
  int total = 0;
  for (const int start = 1; const int x : a) {  // error: statement in the head of a range-for
    total += x * start;
  }
  return total;
}

int switch_without_block(int x) noexcept {
  switch (x)  // error: switch without a block
  case 1: x = 2;
  return x;
}

int case_in_a_loop(int x) noexcept {
  switch (x) {
    case 0:
      do {
        x += 1;
        case 1:  // error: case inside another statement
          x += 2;
      } while (x < 9);
  }
  return x;
}

int before_the_cases(int x) noexcept {
  switch (x) {
    int y;  // error: statement before the first case
    case 0:
      y = 1;
      x = y;
  }
  return x;
}

}  // namespace rejected
