// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/optical_depth.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>

#include <glm/vec3.hpp>

#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// What lies behind the K nearest fragments of a pixel, as one layer that does not depend on the order of arrival:
/// integers only, so that every interleaving gives the same bits. Keeps the exact product of transmittances and the
/// alpha-weighted mean colour; drops the order among the tail's own fragments. 20 bytes.
///
/// Sums of alpha and alpha · colour are in units of 2⁻²⁰, range [0, 4096), rounded by at most 2⁻²¹ a fragment (a
/// product above 8 by the float's own last bit); each saturates by itself, which needs 4096 opaque white fragments in
/// one pixel.
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

/// The tail with one more fragment. `alpha`: opacity times coverage, clamped to [0, 1]. `colour`: linear RGB,
/// [0, inf]; alpha · colour is clamped to [0, 4096). NaN counts as 0. Any order of calls gives the same tail.
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

inline tail add_fragment(const tail& t, float alpha, const glm::vec3& colour) noexcept {
  const float held = saturate(alpha);
  const tail one = tail{optical_depth(held), to_fixed(held), to_fixed(held * colour.x), to_fixed(held * colour.y),
                        to_fixed(held * colour.z)};
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
