// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>
#include <pelage/core/real_number.hpp>
#include <pelage/core/vector_math.hpp>

#include <glm/vec3.hpp>

namespace pelage::inline PELAGE_ABI {

/// The two lobes of a fibre lit from one direction. [Kajiya & Kay 1989, §4]
template <real_number Real>
struct kajiya_kay_lobes {
  Real diffuse;   ///< sin(t, l), [0, 1]: the light that a thin diffuse cylinder receives
  Real specular;  ///< cosᵖ(θr - θi), [0, 1]: the cone of mirror directions round the fibre
};

/// Evaluates both lobes; the caller weighs them with its colours. [Kajiya & Kay 1989, Eqs. 14 and 16]
///
/// `tangent`, `to_light`, `to_eye`: unit vectors, the last two pointing away from the fibre. The highlight is largest
/// where the eye lies on the cone of mirrored light: t·e = -(t·l). Where the angle between the two exceeds 90° the
/// specular lobe is 0, where pow() of a negative cosine would be NaN. `exponent` p: [0, inf); 0 gives 1 on all of
/// the other side. Both lobes stay in [0, 1] for vectors that are off unit length; a NaN or zero vector gives 0.
/// Error below 4e-7 in the diffuse lobe, 4e-7 · (1 + p) in the specular one for p ≥ 1.
template <real_number Real>
[[nodiscard, gnu::always_inline]] inline kajiya_kay_lobes<Real> kajiya_kay(const glm::vec<3, Real>& tangent,
                                                                           const glm::vec<3, Real>& to_light,
                                                                           const glm::vec<3, Real>& to_eye,
                                                                           Real exponent) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <real_number Real>
kajiya_kay_lobes<Real> kajiya_kay(const glm::vec<3, Real>& tangent, const glm::vec<3, Real>& to_light,
                                  const glm::vec<3, Real>& to_eye, Real exponent) noexcept {
  const Real along_light = dot_product(tangent, to_light);
  const Real along_eye = dot_product(tangent, to_eye);
  // The sine as a length: √(1 - cos²) would lose half its digits for light along the fibre.
  const Real across_light = saturate(vector_length(cross_product(tangent, to_light)));
  const Real across_eye = saturate(vector_length(cross_product(tangent, to_eye)));
  const Real cosine = saturate(across_light * across_eye - along_light * along_eye);
  return kajiya_kay_lobes<Real>{across_light, select(cosine > Real(0), power_of_cosine(cosine, exponent), Real(0))};
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
