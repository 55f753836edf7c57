// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/optical_depth.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>

#include <glm/vec3.hpp>

#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// What lies behind the K nearest fragments of a pixel, which [Yu12 §5.1] leaves out, as one layer that does not depend
/// on the order of arrival: integers only, so that every interleaving gives the same bits. Keeps the exact product of
/// transmittances and the alpha-weighted mean colour; drops the order among the tail's own fragments. 20 bytes.
///
/// Sums of alpha and alpha · colour are in units of 2⁻²⁰, range [0, 4096), rounded by at most 2⁻²¹ a fragment (a
/// product above 8 by the float's own last bit); each saturates by itself, and then the hue is lost.
///
/// So colours are in units of the scene's white. Where that is not 1, as with physical units of light, divide every
/// colour by it, and multiply by it what mean_colour() or resolve() gives. A colour of more than 64 whites is scaled
/// down as a whole (clamp_keeping_hue), so that none of these sums ends while Σ alpha is below 63, whatever the
/// colours, nor below 4095 where none is brighter than white.
struct tail {
  std::uint32_t optical;  ///< Σ optical_depth(alpha)
  std::uint32_t weight;   ///< Σ alpha
  std::uint32_t red;      ///< Σ alpha · red; green and blue in the same way
  std::uint32_t green;
  std::uint32_t blue;
};

/// A tail that holds nothing: transmittance 1.
[[nodiscard]] constexpr tail empty_tail() noexcept {
  return tail{0u, 0u, 0u, 0u, 0u};
}

/// A colour scaled down as a whole, which keeps its hue, until no channel is above 64 (by more than 1e-5 of it); the
/// same bits where none is. Infinite channels count as the greatest float; negative and NaN channels stay what they
/// are.
template <single_precision Real>
[[nodiscard, gnu::always_inline]] inline glm::vec<3, Real> clamp_keeping_hue(const glm::vec<3, Real>& colour) noexcept;

/// The tail with one more fragment. `alpha`: opacity times coverage, clamped to [0, 1]. `colour`: linear RGB over the
/// scene's white, [0, inf], brought to [0, 64] by clamp_keeping_hue(). NaN counts as 0. Any order of calls gives the
/// same tail.
[[nodiscard]] inline tail add_fragment(const tail& t, float alpha, const glm::vec3& colour) noexcept;

/// Both tails in one. Associative and commutative, empty_tail() is the identity.
[[nodiscard]] constexpr tail merge(const tail& a, const tail& b) noexcept {
  return tail{add_saturating(a.optical, b.optical), add_saturating(a.weight, b.weight), add_saturating(a.red, b.red),
              add_saturating(a.green, b.green), add_saturating(a.blue, b.blue)};
}

/// The light that passes the whole tail, [0, 1].
[[nodiscard]] constexpr float transmittance_of(const tail& t) noexcept {
  return transmittance_of(t.optical);
}

/// The mean colour of the tail's fragments, weighted by alpha; black when it is empty, or when no alpha in it reaches
/// 2⁻²¹. What the tail adds to a pixel is this times 1 - transmittance_of(t).
[[nodiscard]] inline glm::vec3 mean_colour(const tail& t) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// x · scale, infinity as the greatest float; negative and NaN as it is, where a device's own minimum would drop a NaN.
template <single_precision Real>
[[nodiscard, gnu::always_inline]] inline Real scaled_channel(Real x, Real scale) noexcept {
  const Real largest = Real(3.40282347e38f);
  return select(x > Real(0.0f), select(x > largest, largest, x) * scale, x);
}

}  // namespace detail

template <single_precision Real>
glm::vec<3, Real> clamp_keeping_hue(const glm::vec<3, Real>& colour) noexcept {
  Real most = select(colour.x > Real(64.0f), colour.x, Real(64.0f));
  most = select(colour.y > most, colour.y, most);
  most = select(colour.z > most, colour.z, most);
  if (!holds_for_any(most > Real(64.0f))) {
    return colour;
  }
  const Real scale = select(most > Real(64.0f), fast_exp2(Real(6.0f) - fast_log2(most)), Real(1.0f));
  return glm::vec<3, Real>(detail::scaled_channel(colour.x, scale), detail::scaled_channel(colour.y, scale),
                           detail::scaled_channel(colour.z, scale));
}

inline tail add_fragment(const tail& t, float alpha, const glm::vec3& colour) noexcept {
  const float held = saturate(alpha);
  const glm::vec3 share = held * clamp_keeping_hue(colour);
  const tail one = tail{optical_depth(held), to_fixed(held), to_fixed(share.x), to_fixed(share.y), to_fixed(share.z)};
  return merge(t, one);
}

inline glm::vec3 mean_colour(const tail& t) noexcept {
  if (t.weight == 0u) {
    return glm::vec3(0.0f);
  }
  const float weight = static_cast<float>(t.weight);
  return glm::vec3(static_cast<float>(t.red) / weight, static_cast<float>(t.green) / weight,
                   static_cast<float>(t.blue) / weight);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
