// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/moment_bounds.hpp>
#include <pelage/core/assert.hpp>
#include <pelage/core/atomic_cells.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>

#include <array>
#include <atomic>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// What power moments tell of a pixel: the recurrence of the polynomials that are orthogonal over its optical depth,
/// and from it what lies before any depth. 32 bytes.
struct power_visibility {
  std::uint32_t amount;         ///< of the whole pixel
  std::uint32_t levels;         ///< coefficients that are told from noise, [0, 3]
  std::array<float, 3> centre;  ///< pⱼ₊₁ = (x - centreⱼ) pⱼ - ratioⱼ₋₁ pⱼ₋₁ over x in [-1, 1]
  std::array<float, 3> ratio;   ///< the norm of pⱼ₊₁ over that of pⱼ, squared

  /// The bounds of what lies before a depth. `relative`: depth_range::relative in the range of the sums. Nothing lies
  /// before the range: {0, 0} for 0 and below and for NaN. Above 1: as at 1. None of them falls as the depth grows, and
  /// what lies before it is within them, except by rounding: by 1e-4 in what passes with N = 4. With N = 6 by 1e-2 in
  /// the pixel's own range, and by more where few units of amount lie in a part of a wider one: nodes that noise hides
  /// are taken for none.
  [[nodiscard]] inline moment_bounds bounds_before(float relative) const noexcept;

  /// The estimate, [0, amount] in units of optical_depth(), for transmittance_of().
  [[nodiscard]] float amount_before(float relative) const noexcept { return middle_of(bounds_before(relative)); }

  /// The same before a fragment that is in the sums, with `own` amount, which is not before itself.
  [[nodiscard]] float amount_before_fragment(float relative, std::uint32_t own) const noexcept {
    return middle_of_others(bounds_before(relative), own);
  }
};

/// The moments of a pixel's optical depth over depth: moment-based transparency. [Münstermann et al. 2018] What lies
/// before a depth is estimated from N + 1 sums; weigh a fragment by optical_weight(alpha, amount_before_fragment())
/// of order_weighted.hpp, then add_weighted() and resolve() of weighted_sum.hpp, whose transmittance is exact.
///
/// N is 4 or 6; with 2 mean and variance are all that is known, and those beyond 6 are not made use of. Depth is linear
/// in the pixel's own range (the paper: logarithmic in the scene's), so that a first pass finds it by depth_range, and
/// all moments serve the pixel's own fibres. They are taken of Chebyshev polynomials T₁ to Tₙ, which span what powers
/// span, but whose rounding the reconstruction does not amplify. Integer sums of optical_depth(): any order of
/// fragments gives the same bits; they are rounded by a unit a fragment, and stop at 2³² - 1. In the pixel's own range
/// one fragment alone is exact, as are all at one depth, and so is each of two within 2⁻¹⁷ of the pixel's octaves and 8
/// units, which is 1e-4 in what passes. With N = 6 each of three that lie apart by a twentieth of the range is within
/// 1e-3 in what passes for alphas from 0.01 on; nearer ones run together. A nearly opaque fragment holds nearly all of
/// the sum, and leaves wide bounds to the others. 4 N + 4 bytes, 8 more with the depth_range.
template <std::uint32_t N = 4u>
struct power_moments {
  static_assert(N >= 2u && N <= 30u && N % 2u == 0u, "pelage::power_moments<N>: N must be even, in [2, 30]");

  static constexpr std::uint32_t cells = N + 2u;  ///< a pixel, for a cell_storage

  std::array<std::uint32_t, N + 1u> sum;  ///< the amount, then that of moment_part() for T₁ to Tₙ

  /// A pixel with nothing in it.
  [[nodiscard]] static constexpr power_moments<N> empty() noexcept {
    power_moments<N> none;
    for (std::uint32_t i = 0u; i < N + 1u; ++i) {
      none.sum[i] = 0u;
    }
    return none;
  }

  /// The moments of one fragment. `relative`: depth_range::relative, clamped to [0, 1]; NaN counts as 0. `amount`:
  /// optical_depth(alpha), which ends at 32 octaves for an opaque fragment.
  [[nodiscard]] static constexpr power_moments<N> of(float relative, std::uint32_t amount) noexcept {
    const float position = 2.0f * saturate(relative) - 1.0f;
    power_moments<N> one;
    one.sum[0] = amount;
    float last = 1.0f;
    float moment = position;
    for (std::uint32_t i = 1u; i < N + 1u; ++i) {
      one.sum[i] = moment_part(amount, moment);
      const float next = 2.0f * position * moment - last;
      last = moment;
      moment = next;
    }
    return one;
  }

  /// Adds another pixel's part, of the same range. Associative and commutative, empty() is the identity.
  constexpr void merge(const power_moments<N>& other) noexcept {
    for (std::uint32_t i = 0u; i < N + 1u; ++i) {
      sum[i] = add_saturating(sum[i], other.sum[i]);
    }
  }

  /// Adds a fragment; parameters as of(). Not concurrent (see atomic_power_moments).
  constexpr void add(float relative, std::uint32_t amount) noexcept { merge(of(relative, amount)); }

  /// What the sums tell. Once a pixel, or before each look-up. O(N²).
  [[nodiscard]] constexpr power_visibility visibility() const noexcept;
};

/// A pixel that many threads fill at once: cells [pixel · Moments::cells, (pixel + 1) · Moments::cells) of the storage,
/// all 0 at first, for Moments = power_moments<N>. The last one marks the ends of sums.
namespace atomic_power_moments {

/// power_moments::merge(). Wait-free where the hardware adds atomically. Memory orders: add_and_mark().
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

}  // namespace atomic_power_moments

// ---------------------------------------------------------------------------------------------------------

template <std::uint32_t N>
constexpr power_visibility power_moments<N>::visibility() const noexcept {
  power_visibility told;
  told.amount = sum[0];
  told.levels = 0u;
  // Wheeler's form of the modified Chebyshev algorithm: `now[l]` is the mean of pₖ times the monic Tₗ.
  std::array<float, N + 1u> before;
  std::array<float, N + 1u> now;
  std::array<float, N + 1u> next;
  const float kept = unbiased_share(sum[0]);
  float scale = 1.0f;
  for (std::uint32_t i = 0u; i < N + 1u; ++i) {
    before[i] = 0.0f;
    now[i] = i > 0u && sum[0] > 0u ? scale * kept * mean_moment(sum[i], sum[0]) : 1.0f;
    next[i] = 0.0f;
    scale = i > 0u ? 0.5f * scale : scale;
  }
  float centre = now[1];
  float slope = now[1];
  float ratio = 0.0f;
  bool noise = sum[0] == 0u;
  for (std::uint32_t k = 0u; k < 3u; ++k) {
    told.centre[k] = 0.0f;
    told.ratio[k] = 1.0f;
    if (k < N / 2u && !noise) {
      for (std::uint32_t l = k + 1u; l < N - k; ++l) {
        const float own = l > 1u ? 0.25f : 0.5f;
        next[l] = now[l + 1u] - centre * now[l] - ratio * before[l] + own * now[l - 1u];
      }
      ratio = clamp_moment_ratio(next[k + 1u] / now[k]);
      told.centre[k] = centre;
      told.ratio[k] = ratio;
      told.levels = k + 1u;
      noise = ratio < moment_noise();
      const float norm = ratio * now[k];
      const float steeper = next[k + 2u] / norm;
      centre = 2.0f * saturate(0.5f + 0.5f * (steeper - slope)) - 1.0f;
      slope = steeper;
      for (std::uint32_t l = k + 1u; l < N - k; ++l) {
        before[l] = now[l];
        now[l] = next[l];
      }
      now[k + 1u] = norm;
    }
  }
  return told;
}

namespace detail {

/// 1 over the greatest weight that a distribution can have at a position: the sum of the squares of its orthonormal
/// polynomials there, from 1 on.
[[nodiscard]] constexpr float inverse_weight(const power_visibility& told, float position) noexcept {
  float before = 0.0f;
  float now = 1.0f;
  float norm = 1.0f;
  float ratio = 0.0f;
  float sum = 1.0f;
  for (std::uint32_t j = 0u; j < told.levels; ++j) {
    const float next = (position - told.centre[j]) * now - ratio * before;
    before = now;
    now = next;
    ratio = told.ratio[j];
    norm = norm * ratio;
    sum = sum + now * now / norm;
  }
  return sum;
}

}  // namespace detail

inline moment_bounds power_visibility::bounds_before(float relative) const noexcept {
  if (!(relative > 0.0f)) {
    return moment_bounds{0.0f, 0.0f};
  }
  const float position = 2.0f * saturate(relative) - 1.0f;
  // The kernel Σ pⱼ(position + t) pⱼ(position) / normⱼ as a polynomial of t: its roots are the other nodes of the
  // quadrature that has one at the position. Divided by its value at t = 0, it has 1 / t for its unknown, so that a
  // node at infinity, which weighs nothing, is the root 0.
  std::array<float, 4> before = {0.0f, 0.0f, 0.0f, 0.0f};
  std::array<float, 4> now = {1.0f, 0.0f, 0.0f, 0.0f};
  std::array<float, 4> kernel = {1.0f, 0.0f, 0.0f, 0.0f};
  float norm = 1.0f;
  float last = 0.0f;
  for (std::uint32_t j = 0u; j < levels; ++j) {
    std::array<float, 4> next = {0.0f, 0.0f, 0.0f, 0.0f};
    for (std::uint32_t i = 0u; i < 4u; ++i) {
      next[i] = (position - centre[j]) * now[i] - last * before[i];
      if (i > 0u) {
        next[i] = next[i] + now[i - 1u];
      }
    }
    last = ratio[j];
    norm = norm * last;
    for (std::uint32_t i = 0u; i < 4u; ++i) {
      kernel[i] = kernel[i] + next[i] * next[0] / norm;
      before[i] = now[i];
      now[i] = next[i];
    }
  }
  const std::array<float, 3> root = real_roots(kernel[1] / kernel[0], kernel[2] / kernel[0], kernel[3] / kernel[0]);
  const float here = 1.0f / kernel[0];
  // Roots may lie as near to each other as rounding allows, and then their weights are lost, but not the sum of both.
  // So the weight of a node that is alone on its side of the position tells what the other side holds.
  float nearer = 0.0f;
  float farther = 0.0f;
  std::uint32_t nodes_nearer = 0u;
  for (std::uint32_t i = 0u; i < levels; ++i) {
    const float held = absolute(root[i]) > 1e-4f ? root[i] : 1e-4f;
    const float weight = 1.0f / detail::inverse_weight(*this, position + 1.0f / held);
    nearer = held < 0.0f ? nearer + weight : nearer;
    farther = held < 0.0f ? farther : farther + weight;
    nodes_nearer += held < 0.0f ? 1u : 0u;
  }
  const float others = 1.0f - here;
  nearer = nodes_nearer > 1u ? others - farther : nearer;
  nearer = others * saturate(nearer / (others > 1e-12f ? others : 1e-12f));
  const float scale = static_cast<float>(amount);
  return moment_bounds{scale * nearer, scale * (nearer + here)};
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
