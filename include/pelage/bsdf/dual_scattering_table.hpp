// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/chiang_far_field.hpp>
#include <pelage/bsdf/dual_scattering.hpp>
#include <pelage/bsdf/marschner.hpp>
#include <pelage/core/assert.hpp>
#include <pelage/core/exact_begin.hpp>

#include <glm/vec3.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace pelage::inline PELAGE_ABI {

/// A model of one fibre: the share of light that it sends from inclination θ_i to (θ_r, φ), per steradian and channel.
/// ∫ e dω over the directions (θ_r, φ) is at most 1 for a model that keeps energy. Symmetric in φ.
template <class Model, class Real>
concept fibre_model = requires(const Model& model, Real angle) {
  { model(angle, angle, angle) } -> std::same_as<glm::vec<3, Real>>;
};

/// Marschner's model in shares of light: ½ S cos θ_r. It does not keep energy, since M is a Gaussian whatever the
/// inclination: without absorption a fibre of η in [1.55, 1.8] and β in [0.02, 0.3] sends out 0.87 to 1.11 of the light
/// of the worst inclination for α to -0.17, one of η 1.2 up to 1.24.
template <std::floating_point Real>
struct marschner_fibre_model {
  marschner_parameters<Real> parameters;
  [[nodiscard]] glm::vec<3, Real> operator()(Real theta_i, Real theta_r, Real phi) const noexcept;
};

/// Chiang's model in shares of light, averaged over the fibre's width by the rule of evaluate_chiang_far().
template <std::floating_point Real>
struct chiang_fibre_model {
  chiang_fibre<Real> fibre;
  [[nodiscard]] glm::vec<3, Real> operator()(Real theta_i, Real theta_r, Real phi) const noexcept;
};

/// The averages of a model at one inclination of the light. [Zinke 2008 Eqs. 6 and 12]
///
/// Light comes from a half circle of azimuths evenly: of what leaves at φ from it, the part |φ|/π goes on and the rest
/// turns back. Shifts and variances are the moments of θ_h. By the midpoint rule over `theta_count` inclinations and
/// `phi_count` azimuths of half the sphere; the integrand's lobes must be wider than π/theta_count and π/phi_count.
/// Where a lobe carries no light its moments are 0.
template <std::floating_point Real, fibre_model<Real> Model>
[[nodiscard]] dual_averages<Real> average_fibre(const Model& model, Real theta_i, std::uint32_t theta_count,
                                                std::uint32_t phi_count) noexcept;

/// Fills a table with averages for inclinations from -π/2 to π/2, the middles of table.size() equal steps.
/// O(table.size() theta_count phi_count) evaluations; nothing is allocated.
template <std::floating_point Real, fibre_model<Real> Model>
void fill_dual_scattering_table(const Model& model, std::span<dual_averages<Real>> table, std::uint32_t theta_count,
                                std::uint32_t phi_count) noexcept;

/// The two entries of a table between which an inclination lies.
template <std::floating_point Real>
struct dual_table_place {
  std::uint32_t low;
  std::uint32_t high;
  Real share;  ///< of the high one, [0, 1]
};

/// The place of an inclination in [-π/2, π/2], held there, in a table of `count` > 0 entries.
template <std::floating_point Real>
[[nodiscard]] dual_table_place<Real> dual_table_place_of(Real theta, std::uint32_t count) noexcept;

/// Averages between those of two entries; `share` in [0, 1] is that of b.
template <std::floating_point Real>
[[nodiscard]] dual_averages<Real> blend_dual_averages(const dual_averages<Real>& a, const dual_averages<Real>& b,
                                                      Real share) noexcept;

/// The averages at an inclination in [-π/2, π/2], linear between the table's entries, held at its ends. Not empty.
template <std::floating_point Real>
[[nodiscard]] dual_averages<Real> look_up_dual_scattering(std::span<const dual_averages<Real>> table,
                                                          Real theta) noexcept;

// ---------------------------------------------------------------------------------------------------------

template <std::floating_point Real>
glm::vec<3, Real> marschner_fibre_model<Real>::operator()(Real theta_i, Real theta_r, Real phi) const noexcept {
  const marschner_result<Real> result = evaluate_marschner(parameters, theta_i, theta_r, phi, Real(0));
  const Real half_cosine = Real(0.5) * rotation_by(theta_r).cosine;
  return half_cosine * result.scattering;
}

template <std::floating_point Real>
glm::vec<3, Real> chiang_fibre_model<Real>::operator()(Real theta_i, Real theta_r, Real phi) const noexcept {
  const rotation<Real> from = rotation_by(theta_i);
  const rotation<Real> to = rotation_by(theta_r);
  const rotation<Real> azimuth = rotation_by(phi);
  const fibre_direction<Real> known = {from.sine, absolute(from.cosine), Real(1), Real(0)};
  const fibre_direction<Real> other = {to.sine, absolute(to.cosine), azimuth.cosine, azimuth.sine};
  return evaluate_chiang_far(fibre, known, other).value;
}

template <std::floating_point Real, fibre_model<Real> Model>
dual_averages<Real> average_fibre(const Model& model, Real theta_i, std::uint32_t theta_count,
                                  std::uint32_t phi_count) noexcept {
  using colour = glm::vec<3, Real>;
  const Real pi = Real(3.141592653589793238);
  const Real theta_step = pi / static_cast<Real>(theta_count);
  const Real phi_step = pi / static_cast<Real>(phi_count);
  // Sums of weight, weight θ_h and weight θ_h² for what goes on and what turns back.
  colour on(0), on_shift(0), on_square(0);
  colour back(0), back_shift(0), back_square(0);
  for (std::uint32_t i = 0u; i < theta_count; ++i) {
    const Real theta_r = (static_cast<Real>(i) + Real(0.5)) * theta_step - Real(0.5) * pi;
    const Real theta_h = Real(0.5) * (theta_i + theta_r);
    // Both sides of the fibre at once.
    const Real area = Real(2) * theta_step * phi_step * rotation_by(theta_r).cosine;
    colour row_on(0), row_back(0);
    for (std::uint32_t k = 0u; k < phi_count; ++k) {
      const Real phi = (static_cast<Real>(k) + Real(0.5)) * phi_step;
      const colour share = area * model(theta_i, theta_r, phi);
      row_on += share * (phi / pi);
      row_back += share * (Real(1) - phi / pi);
    }
    on += row_on;
    on_shift += row_on * theta_h;
    on_square += row_on * (theta_h * theta_h);
    back += row_back;
    back_shift += row_back * theta_h;
    back_square += row_back * (theta_h * theta_h);
  }
  dual_averages<Real> averages = {on, back, colour(0), colour(0), colour(0), colour(0)};
  for (int c = 0; c < 3; ++c) {
    if (on[c] > Real(0)) {
      averages.forward_shift[c] = on_shift[c] / on[c];
      averages.forward_variance[c] = greatest(on_square[c] / on[c] - sqr(averages.forward_shift[c]), Real(0));
    }
    if (back[c] > Real(0)) {
      averages.backward_shift[c] = back_shift[c] / back[c];
      averages.backward_variance[c] = greatest(back_square[c] / back[c] - sqr(averages.backward_shift[c]), Real(0));
    }
  }
  return averages;
}

template <std::floating_point Real, fibre_model<Real> Model>
void fill_dual_scattering_table(const Model& model, std::span<dual_averages<Real>> table, std::uint32_t theta_count,
                                std::uint32_t phi_count) noexcept {
  const Real step = Real(3.141592653589793238) / static_cast<Real>(table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Real theta = (static_cast<Real>(i) + Real(0.5)) * step - Real(1.57079632679489662);
    table[i] = average_fibre(model, theta, theta_count, phi_count);
  }
}

template <std::floating_point Real>
dual_table_place<Real> dual_table_place_of(Real theta, std::uint32_t count) noexcept {
  const Real last = static_cast<Real>(count - 1u);
  const Real place = (theta * Real(0.318309886183790672) + Real(0.5)) * static_cast<Real>(count) - Real(0.5);
  const Real held = least(greatest(place, Real(0)), last);
  const std::uint32_t low = static_cast<std::uint32_t>(held);
  const std::uint32_t high = low + 1u < count ? low + 1u : low;
  return dual_table_place<Real>{low, high, held - static_cast<Real>(low)};
}

template <std::floating_point Real>
dual_averages<Real> blend_dual_averages(const dual_averages<Real>& a, const dual_averages<Real>& b,
                                        Real share) noexcept {
  const Real rest = Real(1) - share;
  return dual_averages<Real>{a.forward * rest + b.forward * share,
                             a.backward * rest + b.backward * share,
                             a.forward_shift * rest + b.forward_shift * share,
                             a.backward_shift * rest + b.backward_shift * share,
                             a.forward_variance * rest + b.forward_variance * share,
                             a.backward_variance * rest + b.backward_variance * share};
}

template <std::floating_point Real>
dual_averages<Real> look_up_dual_scattering(std::span<const dual_averages<Real>> table, Real theta) noexcept {
  PELAGE_ASSERT(!table.empty());
  const dual_table_place<Real> place = dual_table_place_of(theta, static_cast<std::uint32_t>(table.size()));
  return blend_dual_averages(table[place.low], table[place.high], place.share);
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
