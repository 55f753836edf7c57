// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/marschner.hpp>
#include <pelage/core/assert.hpp>
#include <pelage/core/exact_begin.hpp>

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace pelage::inline PELAGE_ABI {

/// N_R, N_TT and N_TRT of one fibre over θ_d × φ, for shaders that look them up as textures. [Nguyen & Donnelly 2005]
///
/// One colour per lobe, θ_d and φ; both axes by their absolute values, N being even in them. Row i holds sin θ_d =
/// i/(theta_count - 1), column k holds φ = π k/(phi_count - 1): the texel's middles, ends included, so a sampler that
/// clamps needs the coordinates of table_coordinate(). Looked up linearly.
///
/// Error at 64 × 256 for η 1.55 with the caustic smoothed, against the greatest N of the lobe: up to θ_d = 1.2 below
/// 0.006 for R, 0.002 for TT and 0.04 for TRT, beyond below 0.25, 0.03 and 0.12; the errors fall with the square of the
/// counts, but at TRT's edges in φ and R's at π, where they fall linearly. 36 bytes per entry in float, 576 KiB at that
/// size. Round fibres only.
template <std::floating_point Real>
struct marschner_table {
  std::uint32_t theta_count;                 ///< [2, 4096]
  std::uint32_t phi_count;                   ///< [2, 4096]
  std::span<glm::vec<3, Real>> reflected;    ///< N_R, rows of phi_count; theta_count phi_count in all
  std::span<glm::vec<3, Real>> transmitted;  ///< N_TT
  std::span<glm::vec<3, Real>> returned;     ///< N_TRT
};

/// The three lobes looked up.
template <std::floating_point Real>
struct marschner_lobes {
  glm::vec<3, Real> reflected;
  glm::vec<3, Real> transmitted;
  glm::vec<3, Real> returned;
};

/// An entry: N of the three lobes at a section and an azimuth, the caustic as the parameters treat it. Round fibres
/// only.
template <std::floating_point Real>
[[nodiscard]] marschner_lobes<Real> azimuthal_lobes(const fibre_section<Real>& section,
                                                    const marschner_parameters<Real>& parameters, Real phi) noexcept;

/// Fills a table whose spans the caller has sized.
template <std::floating_point Real>
void fill_marschner_table(const marschner_parameters<Real>& parameters, const marschner_table<Real>& table) noexcept;

/// The normalised texture coordinate, [0, 1], of a position in [0, 1] along an axis of `count` texels whose first and
/// last middles are the ends.
template <std::floating_point Real>
[[nodiscard]] Real table_coordinate(Real position, std::uint32_t count) noexcept;

/// The four entries of a table between which a look-up lies.
template <std::floating_point Real>
struct marschner_table_place {
  std::array<std::uint32_t, 4> entry;  ///< by rows
  std::array<Real, 4> weight;          ///< [0, 1]; they sum to 1
};

/// The place of `sin_theta_d` in [-1, 1] and `phi` in [-π, π], both clamped to that, in a table of these counts in
/// [2, 4096]. NaN counts as 1 and π.
template <std::floating_point Real>
[[nodiscard]] marschner_table_place<Real> marschner_table_place_of(Real sin_theta_d, Real phi,
                                                                   std::uint32_t theta_count,
                                                                   std::uint32_t phi_count) noexcept;

/// N of the three lobes, linear between the entries of that place.
template <std::floating_point Real>
[[nodiscard]] marschner_lobes<Real> look_up_marschner(const marschner_table<Real>& table, Real sin_theta_d,
                                                      Real phi) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
marschner_lobes<Real> azimuthal_lobes(const fibre_section<Real>& section, const marschner_parameters<Real>& parameters,
                                      Real phi) noexcept {
  return marschner_lobes<Real>{bare_azimuthal(section, 0, phi, parameters.sigma_a),
                               bare_azimuthal(section, 1, phi, parameters.sigma_a),
                               treated_trt(section, phi, parameters.sigma_a, parameters.caustic)};
}

template <std::floating_point Real>
void fill_marschner_table(const marschner_parameters<Real>& parameters, const marschner_table<Real>& table) noexcept {
  PELAGE_ASSERT(table.theta_count >= 2u && table.phi_count >= 2u);
  PELAGE_ASSERT(table.reflected.size() == std::size_t{table.theta_count} * table.phi_count);
  PELAGE_ASSERT(table.transmitted.size() == table.reflected.size());
  PELAGE_ASSERT(table.returned.size() == table.reflected.size());
  for (std::uint32_t i = 0u; i < table.theta_count; ++i) {
    const Real sine = static_cast<Real>(i) / static_cast<Real>(table.theta_count - 1u);
    const fibre_section<Real> section = make_fibre_section(parameters.eta, angle_of_sine(sine));
    for (std::uint32_t k = 0u; k < table.phi_count; ++k) {
      const Real phi = Real(3.141592653589793238) * static_cast<Real>(k) / static_cast<Real>(table.phi_count - 1u);
      const marschner_lobes<Real> lobes = azimuthal_lobes(section, parameters, phi);
      const std::size_t at = std::size_t{i} * table.phi_count + k;
      table.reflected[at] = lobes.reflected;
      table.transmitted[at] = lobes.transmitted;
      table.returned[at] = lobes.returned;
    }
  }
}

template <std::floating_point Real>
Real table_coordinate(Real position, std::uint32_t count) noexcept {
  const Real last = static_cast<Real>(count - 1u);
  return (least(greatest(position, Real(0)), Real(1)) * last + Real(0.5)) / static_cast<Real>(count);
}

template <std::floating_point Real>
marschner_table_place<Real> marschner_table_place_of(Real sin_theta_d, Real phi, std::uint32_t theta_count,
                                                     std::uint32_t phi_count) noexcept {
  const Real row = least(absolute(sin_theta_d), Real(1)) * static_cast<Real>(theta_count - 1u);
  const Real column = least(absolute(phi) * Real(0.318309886183790672), Real(1)) * static_cast<Real>(phi_count - 1u);
  const std::uint32_t i = std::min(static_cast<std::uint32_t>(row), theta_count - 2u);
  const std::uint32_t k = std::min(static_cast<std::uint32_t>(column), phi_count - 2u);
  const Real down = row - static_cast<Real>(i);
  const Real right = column - static_cast<Real>(k);
  const std::uint32_t first = i * phi_count + k;
  return marschner_table_place<Real>{
      std::array<std::uint32_t, 4>{first, first + 1u, first + phi_count, first + phi_count + 1u},
      std::array<Real, 4>{(Real(1) - down) * (Real(1) - right), (Real(1) - down) * right, down * (Real(1) - right),
                          down * right}};
}

template <std::floating_point Real>
marschner_lobes<Real> look_up_marschner(const marschner_table<Real>& table, Real sin_theta_d, Real phi) noexcept {
  const marschner_table_place<Real> place =
      marschner_table_place_of(sin_theta_d, phi, table.theta_count, table.phi_count);
  marschner_lobes<Real> sum = {glm::vec<3, Real>(0), glm::vec<3, Real>(0), glm::vec<3, Real>(0)};
  for (std::uint32_t corner = 0u; corner < 4u; ++corner) {
    const std::uint32_t at = place.entry[corner];
    sum.reflected += place.weight[corner] * table.reflected[at];
    sum.transmitted += place.weight[corner] * table.transmitted[at];
    sum.returned += place.weight[corner] * table.returned[at];
  }
  return sum;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
