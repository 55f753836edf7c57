// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/math.hpp>
#include <pelage/core/vector_math.hpp>

#include <glm/vec3.hpp>

namespace pelage {

/// The two lobes of a fibre lit from one direction. [Kajiya & Kay 1989, §4]
struct kajiya_kay_lobes {
  float diffuse;   ///< sin(t, l), [0, 1]: the light that a thin diffuse cylinder receives
  float specular;  ///< cosᵖ(θr - θi), [0, 1]: the cone of mirror directions round the fibre
};

/// Evaluates both lobes; the caller weighs them with its colours. [Kajiya & Kay 1989, Eqs. 14 and 16]
///
/// `tangent`, `to_light`, `to_eye`: unit vectors, the last two pointing away from the fibre. The highlight is largest
/// where the eye lies on the cone of mirrored light: t·e = -(t·l). Where the angle between the two exceeds 90° the
/// specular lobe is 0, where pow() of a negative cosine would be NaN. `exponent` p: [0, inf); 0 gives 1 on all of
/// the other side. Both lobes stay in [0, 1] for vectors that are off unit length; a NaN or zero vector gives 0.
/// Error below 4e-7 in the diffuse lobe, 4e-7 · (1 + p) in the specular one for p ≥ 1.
[[nodiscard]] inline kajiya_kay_lobes kajiya_kay(const glm::vec3& tangent, const glm::vec3& to_light,
                                                 const glm::vec3& to_eye, float exponent) noexcept;

// ---------------------------------------------------------------------------------------------------------

inline kajiya_kay_lobes kajiya_kay(const glm::vec3& tangent, const glm::vec3& to_light, const glm::vec3& to_eye,
                                   float exponent) noexcept {
  const float along_light = dot_product(tangent, to_light);
  const float along_eye = dot_product(tangent, to_eye);
  // The sine as a length: √(1 - cos²) would lose half its digits for light along the fibre.
  const float across_light = saturate(vector_length(cross_product(tangent, to_light)));
  const float across_eye = saturate(vector_length(cross_product(tangent, to_eye)));
  const float cosine = saturate(across_light * across_eye - along_light * along_eye);
  return kajiya_kay_lobes{across_light, cosine > 0.0f ? power_of_cosine(cosine, exponent) : 0.0f};
}

}  // namespace pelage
