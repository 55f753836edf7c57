// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

/// One function for each feature of the subset, compared with its translation in features.glsl and run on a device.
namespace features {

/// An enumeration becomes constants.
enum class kind : std::uint32_t {
  round,     ///< the first
  flat = 4,  ///< with a value
  frizzy
};

/// A constant of the namespace.
inline constexpr float third = 1.0f / 3.0f;

/// A constant for every type; at float only in GLSL.
template <typename Real>
inline constexpr Real half_pi = Real(1.5707963267948966);

/// A table.
inline constexpr std::array<float, 3> weights = {0.25f, 0.5f, 0.25f};

/// A struct within a struct, with a constant of its own.
struct sample_pair {
  static constexpr std::uint32_t parts = 2u;  ///< how many
  std::array<float, parts> value;             ///< one for each part
  kind what;

  [[nodiscard]] float sum() const noexcept { return value[0] + value[1]; }
  void scale(float by) noexcept {
    value[0] *= by;
    value[1] *= by;
  }
  [[nodiscard]] static sample_pair of(float a, float b) noexcept { return sample_pair{{a, b}, kind::flat}; }
};

[[nodiscard]] inline std::uint32_t switched(kind k, std::uint32_t x) noexcept {
  std::uint32_t result = 0u;
  switch (k) {
    case kind::round:
    case kind::flat:  // falls in from above
      result = x + 1u;
      break;
    case kind::frizzy:
      result = x * 3u;
      break;
    default: {
      result = x ^ 0xffu;
      break;
    }
  }
  return result;
}

/// while, do, break and continue.
[[nodiscard]] inline std::uint32_t loops(std::uint32_t n) noexcept {
  std::uint32_t steps = 0u;
  std::uint32_t x = n % 1000u + 1u;
  while (x != 1u) {
    x = (x & 1u) != 0u ? 3u * x + 1u : x / 2u;
    ++steps;
    if (steps > 100u) {
      break;
    }
  }
  do {
    steps += 2u;
    if (steps % 3u == 0u) continue;
    x += steps;
  } while (steps < 50u);
  return steps ^ x;
}

/// Range-for by value and by reference; swap, min, max and clamp.
[[nodiscard]] inline float ranges(std::array<float, 4> a) noexcept {
  float total = 0.0f;
  for (float& x : a) {
    x = std::clamp(x, -1.0f, 1.0f);
  }
  for (const float x : a) {
    total += x;
  }
  std::swap(a[0], a[3]);
  return total + 2.0f * a[0] + std::max(a[1], a[2]) - std::min(total, a[3]);
}

/// Bits: popcount, leading and trailing zeros, width, conversions of bit patterns.
[[nodiscard]] inline std::uint32_t bit_counts(std::uint32_t x, float f) noexcept {
  const int zeros =
      std::countl_zero(x) + 3 * std::countr_zero(x) + 5 * static_cast<int>(std::bit_width(x)) - std::popcount(x);
  const std::uint32_t pattern = std::bit_cast<std::uint32_t>(f);
  return static_cast<std::uint32_t>(zeros + 1000) ^ (pattern >> 3u) ^ std::min(x, 77u) ^ std::max(x, 5u);
}

/// Signed numbers, negation, comparison chains and nested choices.
[[nodiscard]] inline int choices(int a, int b) noexcept {
  const int shifted = a >> 2;
  if (a < b && !(a == 0)) {
    return shifted - b;
  } else if (a > b) {
    return -shifted;
  } else {
    return ~a & (b | 3);
  }
}

/// Vectors and matrices of GLM.
[[nodiscard]] inline glm::vec3 vectors(const glm::vec3& a, const glm::vec4& b) noexcept {
  const glm::mat3 turned = glm::mat3(0.0f, 1.0f, 0.0f, -1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 1.0f);
  glm::vec3 sum = turned * a + glm::vec3(b) * b.w - 0.5f * a;
  sum.x += b[1];
  sum *= 2.0f;
  const bool behind = sum.z < 0.0f;
  return behind ? -sum : glm::min(sum, glm::vec3(4.0f));
}

/// References: what is passed by reference is written to.
inline void divide(std::uint32_t x, std::uint32_t by, std::uint32_t& quotient, std::uint32_t& rest) noexcept {
  quotient = x / by;
  rest = x - quotient * by;
}

/// Members, constants of a struct, a default argument, and calls with effects as statements.
[[nodiscard]] inline float members(float a, float b, float by = third) noexcept {
  sample_pair pair = sample_pair::of(a, b);
  pair.scale(by);
  const sample_pair other = pair;
  pair.value[sample_pair::parts - 1u] = weights[1] + by * half_pi<float>;
  return pair.sum() + other.sum();
}

/// 64-bit integers where they are declared.
[[nodiscard]] inline std::uint32_t wide(std::uint32_t high, std::uint32_t low) noexcept {
  const std::uint64_t both = (static_cast<std::uint64_t>(high) << 32u) | static_cast<std::uint64_t>(low);
  const std::uint64_t scaled = both / 3u + std::uint64_t{0x100000001u};
  return static_cast<std::uint32_t>(scaled >> 16u) ^ (both > scaled ? 1u : 0u);
}

/// Limits of a type, in comparisons that NaN fails.
[[nodiscard]] inline float limits(float x) noexcept {
  if (!(x < std::numeric_limits<float>::infinity())) {
    return std::numeric_limits<float>::max();
  }
  return x > 0.0f ? x : -std::numeric_limits<float>::infinity();
}

/// An operator is a function by another name.
struct turn {
  float cosine;
  float sine;
};

[[nodiscard]] inline turn operator*(const turn& a, const turn& b) noexcept {
  return turn{a.cosine * b.cosine - a.sine * b.sine, a.sine * b.cosine + a.cosine * b.sine};
}

/// Operators, and a reference to what cannot change.
[[nodiscard]] inline float operators(const sample_pair& pair, float angle) noexcept {
  const std::array<float, 2>& value = pair.value;
  const turn once = turn{value[0], value[1]};
  const turn twice = once * once;
  return (twice * turn{angle, 1.0f}).sine;
}

/// Constants that a compiler folds: in float, as C++ rounds them.
[[nodiscard]] inline float folded(float x) noexcept {
  const float tenth = 0.1f;
  return x * (tenth * 3.0f) + (third + half_pi<float>)+(0.25f + 0.5f) + (weights[1] + half_pi<float>);
}

/// Conversions: one to the type at hand vanishes, what it encloses stays together.
template <typename Real>
[[nodiscard]] Real conversions(Real x, Real y, int n) noexcept {
  return Real(x + y) * Real(n + 1) - Real(n < 0 ? x : y) * Real(2);
}

// clang-format off

/// Copies: what they enclose stays together, and so do two signs; attributes and what only a compiler reads vanish.
[[nodiscard]] inline float copies(const glm::vec3& a, const glm::vec3& b, turn t) noexcept {
  const bool less = a.x < b.x;
  [[maybe_unused]] const turn other = turn{b.y, a.y};
  const glm::vec3 doubled = glm::vec3(less ? a : b) * 2.0f - glm::vec3{less ? b : a} * 4.0f;
  const glm::vec3 halved = static_cast<glm::vec3>(less ? b : a) * 0.5f;
  // A line of its own.
  static_assert(sizeof(float) == 4); const glm::vec3 same = - -a;
  const float chosen = float{less ? a.z : b.z} * 2.0f;
  return doubled.x + halved.y + same.z + chosen + turn(less ? t : other).sine + turn{less ? other : t}.cosine;
}

// clang-format on

/// The branch that a type takes, with its own comments alone.
template <typename Real>
[[nodiscard]] Real by_type(Real x) noexcept {
  if constexpr (sizeof(Real) > 4) {
    // In double the library's.
    return std::expm1(x);
  } else {
    // In float the series' first terms.
    return x + Real(0.5) * x * x;
  }
}

/// A struct with a size, and a function over it whose size is the struct's.
template <std::uint32_t N>
struct ring {
  static_assert(N >= 2u && N <= 32u, "features::ring<N>: N must be in [2, 32]");
  std::array<std::uint32_t, N> entry;
  std::uint32_t next;

  void push(std::uint32_t x) noexcept {
    // `next` counts from 0, as empty_ring() leaves it (for sample_pair::parts>1 too).
    entry[next % N] = x;
    ++next;
  }
};

template <std::uint32_t N>
[[nodiscard]] ring<N> empty_ring() noexcept {
  ring<N> r;
  for (std::uint32_t i = 0u; i < N; ++i) {
    r.entry[i] = 0u;
  }
  r.next = 0u;
  return r;
}

/// Names in comments are those of GLSL: empty_ring(), ring<N>::push, features::sample_pair::of(), kind::flat, half_pi,
/// `third`, `N`, features.hpp. Others stay: a fold of the `entries` that one may push, `r`, r.push(), ring<N>::turn(),
/// std::swap(), storage.hpp.
template <std::uint32_t N>
[[nodiscard]] std::uint32_t fold(const ring<N>& r) noexcept {
  auto entries = r.entry;
  std::uint32_t sum = 0u;
  for (const std::uint32_t x : entries) {
    sum = sum * 31u + x;
  }
  if constexpr (sample_pair::parts == 2u) {
    sum += N;
  }
  return sum;
}

}  // namespace features
