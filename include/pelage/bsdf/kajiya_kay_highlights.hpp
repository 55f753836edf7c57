// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/kajiya_kay.hpp>
#include <pelage/core/elementary.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>
#include <pelage/core/vector_math.hpp>

#include <glm/vec3.hpp>

#include <cmath>

namespace pelage::inline PELAGE_ABI {

/// The two highlights that games give hair: white light off the surface (R), coloured light from within (TRT), each on
/// its own cone, since the cuticle's scales tilt the one towards the root and the other towards the tip.
struct double_highlight {
  float primary;    ///< R, [0, 1]; the light's colour
  float secondary;  ///< TRT, [0, 1]; times the hair's colour
};

/// What shapes one of them.
struct highlight_shape {
  float exponent;  ///< p of cosᵖ, [0, inf)
  float shift;     ///< radians by which the cone turns towards the tip (+) or the root (-), (-π/2, π/2)
};

/// The diffuse reflectance of a fibre whose albedo is `kd`: kd/π², to be multiplied by sin(t, l) as the lobe of
/// kajiya_kay() is. A fibre shows its width to the eye as sin(t, e), and ∫ sin(t, e) dω over the sphere is π², so that
/// it sends out kd of the light that meets it, where the bare kd of Kajiya & Kay 1989, Eq. 14 sends π² times as much.
[[nodiscard]] constexpr float normalised_fibre_diffuse(float kd) noexcept {
  return kd * 0.101321184f;
}

/// Both highlights: cosᵖ(θ_i + θ_r - shift) with the inclinations of light and eye, 0 beyond 90°. The shifts are those
/// of R and TRT in Marschner 2003, Table 1 and the widths those of two powers, after Scheuermann 2004; Kajiya & Kay's
/// own highlight is a shift of 0. `tangent`, `to_light`, `to_eye` as for kajiya_kay(); the tangent points to the tip.
[[nodiscard]] inline double_highlight kajiya_kay_double(const glm::vec3& tangent, const glm::vec3& to_light,
                                                        const glm::vec3& to_eye, const highlight_shape& primary,
                                                        const highlight_shape& secondary) noexcept;

/// A tangent moved along the strand's normal, by which Scheuermann 2004 shifts a highlight in a texture's steps:
/// normalise(t + shift n), for use in kajiya_kay(). The highlight turns by about 2 atan(shift) about a normal that
/// faces light and eye. A zero sum gives the tangent.
[[nodiscard]] inline glm::vec3 shifted_tangent(const glm::vec3& tangent, const glm::vec3& normal, float shift) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// cosᵖ of the sum of two inclinations less the shift.
[[nodiscard]] inline float shifted_lobe(const rotation<float>& sum, const highlight_shape& shape) noexcept {
  const float cosine = saturate(turned_back(sum, rotation_by(shape.shift)).cosine);
  return cosine > 0.0f ? power_of_cosine(cosine, shape.exponent) : 0.0f;
}

}  // namespace detail

inline double_highlight kajiya_kay_double(const glm::vec3& tangent, const glm::vec3& to_light, const glm::vec3& to_eye,
                                          const highlight_shape& primary, const highlight_shape& secondary) noexcept {
  const float along_light = dot_product(tangent, to_light);
  const float along_eye = dot_product(tangent, to_eye);
  const float across_light = saturate(vector_length(cross_product(tangent, to_light)));
  const float across_eye = saturate(vector_length(cross_product(tangent, to_eye)));
  const rotation<float> sum =
      turned_by(rotation<float>{across_light, along_light}, rotation<float>{across_eye, along_eye});
  return double_highlight{detail::shifted_lobe(sum, primary), detail::shifted_lobe(sum, secondary)};
}

inline glm::vec3 shifted_tangent(const glm::vec3& tangent, const glm::vec3& normal, float shift) noexcept {
  const glm::vec3 moved = tangent + shift * normal;
  const float length2 = dot_product(moved, moved);
  return length2 > 0.0f ? moved * (1.0f / std::sqrt(length2)) : tangent;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
