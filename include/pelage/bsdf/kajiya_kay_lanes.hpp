// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/kajiya_kay.hpp>
#include <pelage/core/lane_math.hpp>

namespace pelage {

/// kajiya_kay() of W fibres at once, on the CPU: fields as kajiya_kay_lobes has them, each lane with its bits.
template <int W>
struct kajiya_kay_lanes {
  lanes<W> diffuse, specular;
};

template <int W>
[[nodiscard, gnu::always_inline]] inline kajiya_kay_lanes<W> kajiya_kay(const lane_vector<W>& tangent,
                                                                        const lane_vector<W>& to_light,
                                                                        const lane_vector<W>& to_eye,
                                                                        float exponent) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <int W>
kajiya_kay_lanes<W> kajiya_kay(const lane_vector<W>& tangent, const lane_vector<W>& to_light,
                               const lane_vector<W>& to_eye, float exponent) noexcept {
  const lanes<W> zero(0.0f);
  const lanes<W> along_light = dot_product(tangent, to_light);
  const lanes<W> along_eye = dot_product(tangent, to_eye);
  const lanes<W> across_light = saturate(vector_length(cross_product(tangent, to_light)));
  const lanes<W> across_eye = saturate(vector_length(cross_product(tangent, to_eye)));
  const lanes<W> cosine = saturate(across_light * across_eye - along_light * along_eye);
  return {across_light, select(cosine > zero, power_of_cosine(cosine, lanes<W>(exponent)), zero)};
}

}  // namespace pelage
