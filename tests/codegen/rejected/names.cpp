// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <cstdint>

namespace rejected {

int keyword(int sample) noexcept {  // error: `sample` is a keyword or a reserved word in GLSL
  return sample;
}

int reserved_word(int x) noexcept {
  const int input = x;  // error: `input` is a keyword or a reserved word in GLSL
  return input;
}

float built_in_function(float x) noexcept {
  const float length = x;  // error: `length` is a built-in function in GLSL
  return length;
}

int double_underscore(int a__b) noexcept {  // error: the name `a__b` is reserved in GLSL
  return a__b;
}

int like_a_global_of_ours(int pelage_x) noexcept {  // error: the name `pelage_x` begins like the mirror's global names
  return pelage_x;
}

struct fields {
  float distance;
  float buffer;  // error: `buffer` is a keyword or a reserved word in GLSL
};

float use(fields f) noexcept {
  return f.distance + f.buffer;
}

int overloaded(int x) noexcept {
  return x;
}

int overloaded(std::int32_t x, int y) noexcept {
  return x + y;
}

enum class colour : int { red, green };

int overloaded(colour x) noexcept {  // error: `rejected_overloaded` stands for two things in GLSL
  return x == colour::red ? 1 : 0;
}

struct outer {
  int x;
};

int outer_x(int y) noexcept {
  return y;
}

int hides(int rejected_outer_x) noexcept {
  return outer_x(rejected_outer_x);  // error: the local name `rejected_outer_x` hides the function or constant of that name in GLSL
}

}  // namespace rejected

float mix(float x) noexcept {  // error: `mix` is a built-in function in GLSL
  return x;
}
