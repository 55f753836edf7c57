// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/moment_bounds.hpp>
#include <pelage/core/assert.hpp>
#include <pelage/core/atomic_cells.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>

#include <glm/vec2.hpp>

#include <array>
#include <atomic>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// What trigonometric moments tell of a pixel: the reflections of Szegő's polynomials, which are orthogonal over its
/// optical depth on the circle. 32 bytes.
struct trigonometric_visibility {
  std::uint32_t amount;                 ///< of the whole pixel
  std::uint32_t levels;                 ///< reflections that are told from noise, [0, 3]
  std::array<glm::vec2, 3> reflection;  ///< complex, magnitude below 1

  /// What the nodes before a depth hold, and those before it and at it. `relative`: depth_range::relative in the range
  /// of the sums; {0, 0} for 0 and below and for NaN, above 1 as at 1. The node at the depth holds as much as any
  /// distribution with these moments can have there; but a circle has no first node, and where it is cut decides what
  /// is before. So, unlike those of powers, these are no bounds, and may fall as the depth grows.
  [[nodiscard]] inline moment_bounds interval_before(float relative) const noexcept;

  /// As power_visibility::amount_before().
  [[nodiscard]] float amount_before(float relative) const noexcept { return middle_of(interval_before(relative)); }

  /// As power_visibility::amount_before_fragment().
  [[nodiscard]] float amount_before_fragment(float relative, std::uint32_t own) const noexcept {
    return middle_of_others(interval_before(relative), own);
  }
};

/// As power_moments, with the moments e^(i k φ), k from 1 to N, over depth as an angle φ in 0.9 · [-π, π]: as fine in
/// the middle of the range as at its ends, where powers are finer. [Münstermann et al. 2018] N is 2 or 3; those beyond
/// 3 are not made use of. As many sums as with 2 N powers, and as many fragments told apart, three with less precision:
/// within 0.02 in what passes for alphas from 0.05 to 0.95 that lie apart by a twentieth of the range. A node in the
/// tenth of the circle where no fragment is counts by where it lies there, the mean over the angles at which the circle
/// can be cut, so that the estimate is continuous. 8 N + 4 bytes, 8 more with the depth_range.
template <std::uint32_t N = 2u>
struct trigonometric_moments {
  static_assert(N >= 1u && N <= 15u, "pelage::trigonometric_moments<N>: N must be in [1, 15]");

  static constexpr std::uint32_t cells = 2u * N + 2u;  ///< a pixel, for a cell_storage

  std::array<std::uint32_t, 2u * N + 1u> sum;  ///< the amount, then that of moment_part() for cos kφ, sin kφ

  /// A pixel with nothing in it.
  [[nodiscard]] static constexpr trigonometric_moments<N> empty() noexcept {
    trigonometric_moments<N> none;
    for (std::uint32_t i = 0u; i < 2u * N + 1u; ++i) {
      none.sum[i] = 0u;
    }
    return none;
  }

  /// The moments of one fragment; parameters as power_moments::of().
  [[nodiscard]] static trigonometric_moments<N> of(float relative, std::uint32_t amount) noexcept {
    const rotation<float> once = rotation_by(2.82743339f * (2.0f * saturate(relative) - 1.0f));
    rotation<float> moment = once;
    trigonometric_moments<N> one;
    one.sum[0] = amount;
    for (std::uint32_t k = 0u; k < N; ++k) {
      one.sum[2u * k + 1u] = moment_part(amount, moment.cosine);
      one.sum[2u * k + 2u] = moment_part(amount, moment.sine);
      moment = turned_by(moment, once);
    }
    return one;
  }

  /// Adds another pixel's part, of the same range. Associative and commutative, empty() is the identity.
  constexpr void merge(const trigonometric_moments<N>& other) noexcept {
    for (std::uint32_t i = 0u; i < 2u * N + 1u; ++i) {
      sum[i] = add_saturating(sum[i], other.sum[i]);
    }
  }

  /// Adds a fragment; parameters as of(). Not concurrent (see atomic_trigonometric_moments).
  inline void add(float relative, std::uint32_t amount) noexcept { merge(of(relative, amount)); }

  /// What the sums tell. Once a pixel, or before each look-up. O(N²).
  [[nodiscard]] inline trigonometric_visibility visibility() const noexcept;
};

/// As atomic_power_moments, for Moments = trigonometric_moments<N>.
namespace atomic_trigonometric_moments {

/// trigonometric_moments::merge(). Wait-free where the hardware adds atomically. Memory orders: add_and_mark().
template <class Moments, cell_storage Storage>
void add(Storage& storage, std::uint32_t pixel, const Moments& one) noexcept {
  PELAGE_ASSERT(pixel < storage.size() / Moments::cells);
  const std::uint32_t first = pixel * Moments::cells;
  for (std::uint32_t i = 0u; i + 1u < Moments::cells; ++i) {
    add_and_mark(storage, first + i, one.sum[i], first + Moments::cells - 1u, 1u << i);
  }
}

/// The pixel. Not concurrent with add().
template <class Moments, cell_storage Storage>
[[nodiscard]] Moments load(const Storage& storage, std::uint32_t pixel) noexcept {
  const std::uint32_t first = pixel * Moments::cells;
  Moments moments = Moments::empty();
  for (std::uint32_t i = 0u; i + 1u < Moments::cells; ++i) {
    moments.sum[i] = load_marked(storage, first + i, first + Moments::cells - 1u, 1u << i);
  }
  return moments;
}

}  // namespace atomic_trigonometric_moments

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// The product of two complex numbers.
[[nodiscard]] inline glm::vec2 complex_product(const glm::vec2& a, const glm::vec2& b) noexcept {
  return glm::vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
}

[[nodiscard]] inline glm::vec2 conjugate(const glm::vec2& a) noexcept {
  return glm::vec2(a.x, -a.y);
}

/// power_visibility's inverse weight, at a point of the circle.
[[nodiscard]] inline float inverse_weight(const std::array<glm::vec2, 3>& reflection, std::uint32_t levels,
                                          const glm::vec2& point) noexcept {
  glm::vec2 polynomial = glm::vec2(1.0f, 0.0f);
  glm::vec2 reversed = polynomial;
  float norm = 1.0f;
  float sum = 1.0f;
  for (std::uint32_t j = 0u; j < levels; ++j) {
    const glm::vec2 along = complex_product(point, polynomial);
    polynomial = along - complex_product(reflection[j], reversed);
    reversed = reversed - complex_product(conjugate(reflection[j]), along);
    norm = norm * clamp_moment_ratio(1.0f - reflection[j].x * reflection[j].x - reflection[j].y * reflection[j].y);
    sum = sum + (polynomial.x * polynomial.x + polynomial.y * polynomial.y) / norm;
  }
  return sum;
}

}  // namespace detail

template <std::uint32_t N>
inline trigonometric_visibility trigonometric_moments<N>::visibility() const noexcept {
  trigonometric_visibility told;
  told.amount = sum[0];
  told.levels = 0u;
  const float kept = unbiased_share(sum[0]);
  // Levinson's algorithm: `polynomial` holds Φₖ by its coefficients.
  std::array<glm::vec2, 4> polynomial;
  std::array<glm::vec2, 4> longer;
  for (std::uint32_t i = 0u; i < 4u; ++i) {
    polynomial[i] = glm::vec2(i > 0u ? 0.0f : 1.0f, 0.0f);
  }
  float norm = 1.0f;
  bool noise = sum[0] == 0u;
  for (std::uint32_t k = 0u; k < 3u; ++k) {
    told.reflection[k] = glm::vec2(0.0f);
    if (k < N && !noise) {
      glm::vec2 reflection = glm::vec2(0.0f);
      for (std::uint32_t i = 0u; i <= k; ++i) {
        const glm::vec2 moment =
            kept * glm::vec2(mean_moment(sum[2u * i + 1u], sum[0]), mean_moment(sum[2u * i + 2u], sum[0]));
        reflection = reflection + detail::complex_product(polynomial[i], moment);
      }
      reflection = reflection / norm;
      const float squared = reflection.x * reflection.x + reflection.y * reflection.y;
      const float ratio = clamp_moment_ratio(1.0f - squared);
      reflection = squared > 1.0f - ratio ? reflection * safe_sqrt((1.0f - ratio) / squared) : reflection;
      for (std::uint32_t i = 0u; i < 4u; ++i) {
        longer[i] = glm::vec2(0.0f);
      }
      for (std::uint32_t i = 0u; i <= k; ++i) {
        longer[i + 1u] = longer[i + 1u] + polynomial[i];
        longer[i] = longer[i] - detail::complex_product(reflection, detail::conjugate(polynomial[k - i]));
      }
      for (std::uint32_t i = 0u; i < 4u; ++i) {
        polynomial[i] = longer[i];
      }
      told.reflection[k] = reflection;
      told.levels = k + 1u;
      norm = norm * ratio;
      noise = ratio < moment_noise();
    }
  }
  return told;
}

inline moment_bounds trigonometric_visibility::interval_before(float relative) const noexcept {
  if (!(relative > 0.0f)) {
    return moment_bounds{0.0f, 0.0f};
  }
  const rotation<float> half_angle = rotation_by(1.41371669f * (2.0f * saturate(relative) - 1.0f));
  const rotation<float> angle = turned_by(half_angle, half_angle);
  // The circle is turned until the depth is at 1, which turns the reflections.
  const glm::vec2 back = glm::vec2(angle.cosine, -angle.sine);
  std::array<glm::vec2, 3> turned;
  glm::vec2 turn = back;
  for (std::uint32_t j = 0u; j < 3u; ++j) {
    turned[j] = detail::complex_product(reflection[j], turn);
    turn = detail::complex_product(turn, back);
  }
  // The kernel Σ Φⱼ(s) Φⱼ(1)* / normⱼ by its coefficients, of which the last mirror the first.
  std::array<glm::vec2, 4> polynomial;
  std::array<glm::vec2, 4> longer;
  std::array<glm::vec2, 4> kernel;
  for (std::uint32_t i = 0u; i < 4u; ++i) {
    polynomial[i] = glm::vec2(i > 0u ? 0.0f : 1.0f, 0.0f);
    kernel[i] = polynomial[i];
  }
  float norm = 1.0f;
  for (std::uint32_t j = 0u; j < levels; ++j) {
    for (std::uint32_t i = 0u; i < 4u; ++i) {
      longer[i] = glm::vec2(0.0f);
    }
    for (std::uint32_t i = 0u; i <= j; ++i) {
      longer[i + 1u] = longer[i + 1u] + polynomial[i];
      longer[i] = longer[i] - detail::complex_product(turned[j], detail::conjugate(polynomial[j - i]));
    }
    glm::vec2 value = glm::vec2(0.0f);
    for (std::uint32_t i = 0u; i < 4u; ++i) {
      polynomial[i] = longer[i];
      value = value + longer[i];
    }
    norm = norm * clamp_moment_ratio(1.0f - turned[j].x * turned[j].x - turned[j].y * turned[j].y);
    for (std::uint32_t i = 0u; i < 4u; ++i) {
      kernel[i] = kernel[i] + detail::complex_product(polynomial[i], detail::conjugate(value)) / norm;
    }
  }
  // Rounding that breaks the symmetry would move the roots where a norm is small.
  for (std::uint32_t i = 0u; i < 2u; ++i) {
    if (2u * i < levels) {
      kernel[levels - i] = 0.5f * (kernel[levels - i] + detail::conjugate(kernel[i]));
    }
  }
  // With s = (y + i) / (y - i), where y is the cotangent of half the angle from the depth on, the kernel is real.
  float leading = 1.0f;
  float c2 = 0.0f;
  float c1 = 0.0f;
  float c0 = 0.0f;
  if (levels == 1u) {
    leading = 2.0f * kernel[1].x;
    c2 = -2.0f * kernel[1].y;
  } else if (levels == 2u) {
    leading = kernel[1].x + 2.0f * kernel[2].x;
    c2 = -4.0f * kernel[2].y;
    c1 = kernel[1].x - 2.0f * kernel[2].x;
  } else if (levels == 3u) {
    leading = 2.0f * (kernel[3].x + kernel[2].x);
    c2 = -2.0f * (3.0f * kernel[3].y + kernel[2].y);
    c1 = 2.0f * (kernel[2].x - 3.0f * kernel[3].x);
    c0 = 2.0f * (kernel[3].y - kernel[2].y);
  }
  const std::array<float, 3> root = real_roots(c2 / leading, c1 / leading, c0 / leading);
  const float here = 1.0f / leading;
  std::array<float, 3> weight = {0.0f, 0.0f, 0.0f};
  std::array<float, 3> share = {0.0f, 0.0f, 0.0f};
  std::array<float, 3> size = {1.0f, 1.0f, 1.0f};
  for (std::uint32_t i = 0u; i < levels; ++i) {
    const float y = root[i];
    size[i] = y * y + 1.0f;
    weight[i] = 1.0f / detail::inverse_weight(turned, levels, glm::vec2((y * y - 1.0f) / size[i], 2.0f * y / size[i]));
    // The tangent of half the angle by which the node is past π, over that at which fragments begin again.
    const float past = half_angle.sine - half_angle.cosine * y;
    const float end = 0.158384440f * absolute(half_angle.cosine + half_angle.sine * y);
    share[i] = past > end ? 1.0f : past > -end ? 0.5f + 0.5f * past / end : 0.0f;
  }
  // Of three nodes two may lie as near to each other as rounding allows, and then their weights are lost, but not the
  // sum of both.
  std::uint32_t alone = 3u;
  float closest = 2.0f;
  for (std::uint32_t i = 0u; i < 3u; ++i) {
    const std::uint32_t j = i < 2u ? i + 1u : 0u;
    const float apart = (root[i] - root[j]) * (root[i] - root[j]) / (size[i] * size[j]);
    alone = levels == 3u && apart < closest ? 3u - i - j : alone;
    closest = apart < closest ? apart : closest;
  }
  float rest = 1.0f - here;
  float nearer = 0.0f;
  float together = 1e-12f;
  float together_nearer = 0.0f;
  for (std::uint32_t i = 0u; i < levels; ++i) {
    if (i == alone) {
      const float held = weight[i] < rest ? weight[i] : rest;
      nearer = share[i] * held;
      rest = rest - held;
    } else {
      together = together + weight[i];
      together_nearer = together_nearer + share[i] * weight[i];
    }
  }
  nearer = nearer + rest * (together_nearer / together);
  const float scale = static_cast<float>(amount);
  return moment_bounds{scale * nearer, scale * (nearer + here)};
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
