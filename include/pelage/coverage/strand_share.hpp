// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>
#include <pelage/core/mixed_bits.hpp>

#include <concepts>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// Of strands too thin to tell apart a share is drawn, each of them as much wider as the share is smaller: coverage
/// summed over all strands stays what it was. (Cook et al. 2007, stochastic simplification, with widths for areas.)
/// Which ones stay depends on their numbers alone, and the widths change without a jump when the share does, so that
/// nothing flickers when the camera moves.

/// A strand's place in the order in which strands stay, [0, 1), a multiple of 2⁻²⁴: those of the lowest ranks stay
/// longest. By its number alone. Of 2ᵏ strands with numbers from a multiple of 2ᵏ on, k ≤ 6, one has its rank in each
/// of the 2ᵏ equal parts of [0, 1), so that neighbours thin out evenly; beyond 64, ranks are as random. (Radical
/// inverse of the lowest bits, scrambled by Laine & Karras's hash with the others for its seed: Burley 2020.)
[[nodiscard]] constexpr float strand_rank(std::uint32_t strand) noexcept;

/// The share of strands that is enough where a strand is `width` pixels wide and strands may be widened to `error`
/// pixels: width / error, [least, 1]. `width`: [0, inf], the widest that a strand is seen. `error`: pixels, [0, inf).
/// `least`: (0, 1], the smallest share, so that a strand of width 0 has one. An error of 0, or less, means that all
/// strands stay: 1; so does NaN in either.
template <std::floating_point Real>
[[nodiscard]] Real kept_share(Real width, Real error, Real least) noexcept;

/// What the width of a strand of this rank is multiplied with where this share of the strands is drawn, [0, 1 / share]:
/// 1 / share for ranks well below the share, 0 from a little above it on, where the strand is not drawn, and a smooth
/// step over the quarter of min(share, 1 - share) on either side, by which a strand fades in or out.
///
/// The mean over all of [0, 1) is 1 for any share (over the ranks that strand_rank() has, within 3e-5 of it
/// for shares from 0.001 on), and 1 is the factor of all at a share of 1. Continuous in the share at
/// each rank; a strand that is drawn at a share is drawn at each greater one. `rank`: [0, 1). `share`: [2⁻²⁰, 1]; above
/// 1, at or below 0, and for NaN in either, 1.
template <std::floating_point Real>
[[nodiscard]] Real width_factor(Real rank, Real share) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// The 32 bits in reverse.
[[nodiscard]] constexpr std::uint32_t reversed_bits(std::uint32_t x) noexcept {
  const std::uint32_t ones = ((x & 0x55555555u) << 1u) | ((x >> 1u) & 0x55555555u);
  const std::uint32_t twos = ((ones & 0x33333333u) << 2u) | ((ones >> 2u) & 0x33333333u);
  const std::uint32_t fours = ((twos & 0x0f0f0f0fu) << 4u) | ((twos >> 4u) & 0x0f0f0f0fu);
  const std::uint32_t bytes = ((fours & 0x00ff00ffu) << 8u) | ((fours >> 8u) & 0x00ff00ffu);
  return (bytes << 16u) | (bytes >> 16u);
}

}  // namespace detail

constexpr float strand_rank(std::uint32_t strand) noexcept {
  // Each step changes a bit by the bits below it alone: reversed, a part of [0, 1) by the parts that hold it.
  const std::uint32_t seed = mixed_bits(strand >> 6u);
  const std::uint32_t a = strand ^ (strand * 0x3d20adeau);
  const std::uint32_t b = (a + seed) * ((seed >> 16u) | 1u);
  const std::uint32_t c = b ^ (b * 0x05526c56u);
  const std::uint32_t d = c ^ (c * 0x53a22864u);
  return static_cast<float>(detail::reversed_bits(d) >> 8u) / 16777216.0f;
}

template <std::floating_point Real>
Real kept_share(Real width, Real error, Real least) noexcept {
  const Real share = width / error;
  const Real held = share < least ? least : share;
  return error > Real(0) && held < Real(1) ? held : Real(1);
}

template <std::floating_point Real>
Real width_factor(Real rank, Real share) noexcept {
  const Real rest = Real(1) - share;
  const Real half_band = Real(0.25) * (share < rest ? share : rest);
  if (!(half_band > Real(0)) || !(rank >= Real(0))) {
    return Real(1);
  }
  const Real inside = saturate(Real(0.5) + Real(0.5) * (share - rank) / half_band);
  return inside * inside * (Real(3) - Real(2) * inside) / share;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
