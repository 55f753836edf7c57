// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/core/math.hpp>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// Fragments that follow each other in depth, composited.
struct alpha_layer {
  fragment nearest;     ///< the first of them
  float transmittance;  ///< of all of them, [0, 1]
  glm::vec3 radiance;   ///< Σ alpha · colour · what passes those before, linear RGB
};

/// Multi-layer alpha blending [Salvi & Vaidyanathan 2014]: a pixel as N layers in the order of depth. Each fragment is
/// a new layer; of N + 1 the two farthest become one, by `over`, at the nearer one's depth.
///
/// Exact while N layers hold all, and whatever their number where fragments come in the order of depth, from either
/// end: only one that comes later than those that it belongs between is composited behind them. So the state depends on
/// the order of arrival, and no rule of merging helps: where nothing arrives out of order nothing is lost, and then it
/// is sorting. What can be chosen is the order, and one that the set of fragments alone defines gives the same bits in
/// every frame: insert by ascending id, which is the order of drawing that rasterizer-ordered access gives the paper.
/// It has nothing to do with depth, and so shows the method's true error. For an order of arrival that is free, keep
/// the nearest in a k_buffer over a tail. 24 N bytes.
template <std::uint32_t N = 4u>
struct alpha_layers {
  static_assert(N >= 1u && N <= 64u, "pelage::alpha_layers<N>: N must be in [1, 64]");

  std::array<alpha_layer, N> layer;  ///< nearest first; those that are left hold no_fragment()

  /// A pixel with nothing in it.
  [[nodiscard]] static inline alpha_layers<N> empty() noexcept {
    alpha_layers<N> none;
    for (std::uint32_t i = 0u; i < N; ++i) {
      none.layer[i] = alpha_layer{no_fragment(), 1.0f, glm::vec3(0.0f)};
    }
    return none;
  }

  /// Puts a fragment in. `alpha`: clamped to [0, 1]; NaN and what is below the least normal float, which devices take
  /// for 0, change nothing, nor does what is_fragment() refuses. `colour`: linear RGB, finite. Not concurrent. O(N).
  inline void insert(fragment where, float alpha, const glm::vec3& colour) noexcept {
    const float opacity = saturate(alpha);
    if (!is_fragment(where) || opacity < 1.17549435e-38f) {
      return;
    }
    alpha_layer last = alpha_layer{where, 1.0f - opacity, opacity * colour};
    for (std::uint32_t i = 0u; i < N; ++i) {
      if (before(last.nearest, layer[i].nearest)) {
        const alpha_layer farther = layer[i];
        layer[i] = last;
        last = farther;
      }
    }
    layer[N - 1u].radiance = layer[N - 1u].radiance + layer[N - 1u].transmittance * last.radiance;
    layer[N - 1u].transmittance = layer[N - 1u].transmittance * last.transmittance;
  }

  /// What passes all layers, [0, 1]: the product of 1 - alpha, whatever was merged.
  [[nodiscard]] constexpr float transmittance() const noexcept {
    float passed = 1.0f;
    for (std::uint32_t i = 0u; i < N; ++i) {
      passed = passed * layer[i].transmittance;
    }
    return passed;
  }

  /// What is seen of the pixel in front of a background.
  [[nodiscard]] inline glm::vec3 resolve(const glm::vec3& background) const noexcept {
    glm::vec3 seen = background;
    for (std::uint32_t i = N; i > 0u; --i) {
      seen = layer[i - 1u].radiance + layer[i - 1u].transmittance * seen;
    }
    return seen;
  }
};

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
