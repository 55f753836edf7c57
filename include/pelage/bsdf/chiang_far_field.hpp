// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/chiang_sampling.hpp>
#include <pelage/core/exact_begin.hpp>

#include <array>
#include <concepts>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// A fibre thinner than a pixel: the model averaged over the fibre's width, ½ ∫ f(h) dh over [-1, 1].
///
/// Half the width is cut into cells; the other half mirrors it. In a cell the attenuation is that of its middle, and
/// the middle of a lobe moves evenly, so that its N is a band and no cell shows by itself however narrow the lobe is.
/// The number of cells is 12 for β_n from 0.3 on and grows with the root of 1/s to 37 at 0.05 and 40 at most; R, which
/// absorption leaves alone, has twice as many, crowded at the edge, where Fresnel's term is steep.
///
/// Error: at most 0.01 of the greatest value at the same θ_i for η in [1.4, 1.8], any absorption and inclinations and
/// β_n in [0.05, 1]. A clear fibre's energy is 1 within 3e-4. Cost in exponentials: 12 a cell and 3 a cell of R, M
/// once.

/// Azimuths of the averaged lobes for one eye and one light: what is left of the model without M.
template <std::floating_point Real>
struct chiang_far_azimuths {
  std::array<std::array<Real, 3>, 4> value;  ///< N_p A_p for red, green, blue; R, TT, TRT, residual; per radian
  std::array<Real, 4> density;               ///< of sample_chiang_far() drawing that azimuth by each lobe, per radian
};

/// They depend on the eye's inclination and the azimuth between eye and light alone. `azimuth`: of the light about the
/// fibre, counted from the eye's, of any length but 0; its sign does not matter.
template <std::floating_point Real>
[[nodiscard]] inline chiang_far_azimuths<Real> chiang_far_lobes(const chiang_fibre<Real>& fibre, Real sin_o, Real cos_o,
                                                                const rotation<Real>& azimuth) noexcept;

/// The average. `value` holds f |cos|, to be multiplied by no further cosine, and `density` that of
/// sample_chiang_far(), above 0 where `value` is above 1e-37.
template <std::floating_point Real>
[[nodiscard]] inline chiang_result<Real> evaluate_chiang_far(const chiang_fibre<Real>& fibre,
                                                             const fibre_direction<Real>& eye,
                                                             const fibre_direction<Real>& light) noexcept;

/// Draws a direction from four numbers in [0, 1): lobe and cell by what they send, then as sample_chiang(). The mean of
/// a weight's channels is within 0.01 of the mean of what leaves, whatever the numbers are.
template <std::floating_point Real>
[[nodiscard]] inline chiang_sample<Real> sample_chiang_far(const chiang_fibre<Real>& fibre,
                                                           const fibre_direction<Real>& eye,
                                                           const std::array<Real, 4>& u) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// Part of half a fibre's width.
template <std::floating_point Real>
struct width_cell {
  Real h, cosine;  ///< of its middle: sin γ and cos γ
  Real extent;     ///< its extent in γ
  Real weight;     ///< its extent in h
};

/// Cell `cell` of `count`. The tangent of γ/2 is t = (1 + crowd) u - crowd u² for an even u; the greater `crowd` in
/// [0, 1), the smaller the cells at the edge.
template <std::floating_point Real>
[[nodiscard]] inline width_cell<Real> width_cell_of(int cell, int count, Real crowd) noexcept {
  const Real over = Real(1) / Real(count);
  const Real u = (Real(cell) + Real(0.5)) * over;
  const Real before = Real(cell) * over;
  const Real after = Real(cell + 1) * over;
  const Real t = u * (Real(1) + crowd * (Real(1) - u));
  const Real low = before * (Real(1) + crowd * (Real(1) - before));
  const Real high = after * (Real(1) + crowd * (Real(1) - after));
  const Real secant2 = Real(1) + t * t;
  return width_cell<Real>{
      Real(2) * t / secant2, (Real(1) - t) * (Real(1) + t) / secant2,
      Real(2) * (Real(1) + crowd * (Real(1) - Real(2) * u)) * over / secant2,
      Real(2) * (high - low) * (Real(1) - low * high) / ((Real(1) + low * low) * (Real(1) + high * high))};
}

/// The number of cells for a fibre.
template <std::floating_point Real>
[[nodiscard]] inline int chiang_far_cells(const chiang_fibre<Real>& fibre) noexcept {
  const int cells = static_cast<int>(Real(3.66) / square_root(fibre.azimuthal.scale)) + 1;
  return cells < 12 ? 12 : (cells < 40 ? cells : 40);
}

/// What one cell sends by one lobe.
template <std::floating_point Real>
struct chiang_far_path {
  rotation<Real> middle;      ///< counted from the eye's azimuth; the other half's is mirrored
  azimuthal_band<Real> band;  ///< N round it
  std::array<Real, 3> part;   ///< the cell's weight times A_p
};

/// A cell's R, and in `passed` its weight times 1 - F.
template <std::floating_point Real>
[[nodiscard]] inline chiang_far_path<Real> reflect_in_cell(const chiang_fibre<Real>& fibre, Real cos_o, int cell,
                                                           int count, Real& passed) noexcept {
  const width_cell<Real> place = width_cell_of(cell, count, Real(0.6));
  const interface_shares<Real> surface = dielectric_interface(cos_o * place.cosine, fibre.eta);
  const Real part = place.weight * (fibre.tints[0] * surface.reflected);
  passed = place.weight * surface.transmitted;
  return chiang_far_path<Real>{rotation<Real>{Real(1) - Real(2) * place.h * place.h, Real(-2) * place.h * place.cosine},
                               make_azimuthal_band(fibre.azimuthal, Real(2) * place.extent),
                               std::array<Real, 3>{part, part, part}};
}

/// A cell's TT, TRT and residual, the last without direction, and in `passed` its weight times 1 - F.
template <std::floating_point Real>
[[nodiscard]] inline std::array<chiang_far_path<Real>, 3> pass_cell(const chiang_fibre<Real>& fibre, Real sin_o,
                                                                    Real cos_o, int cell, int count,
                                                                    Real& passed) noexcept {
  const width_cell<Real> place = width_cell_of(cell, count, Real(0));
  const chiang_section<Real> section = cross_chiang_section(fibre.eta, place.h, sin_o, cos_o);
  passed = place.weight * section.surface.transmitted;
  // dγ_t/dγ_o; a lobe's middle moves by 2p γ_t - 2 γ_o.
  const Real cosine = cos_o * place.cosine;
  const Real inside2 = (fibre.eta - Real(1)) * (fibre.eta + Real(1)) + cosine * cosine;
  const Real turn = cosine / square_root(greatest(inside2, Real(1e-36)));
  std::array<chiang_far_path<Real>, 3> paths;
  paths[0].middle = turned_by(rotation<Real>{section.entry.cosine, Real(0) - section.entry.sine}, section.crossing);
  paths[1].middle = turned_by(paths[0].middle, section.crossing);
  paths[2].middle = rotation<Real>{Real(1), Real(0)};
  paths[0].band = make_azimuthal_band(fibre.azimuthal, Real(2) * absolute(turn - Real(1)) * place.extent);
  paths[1].band = make_azimuthal_band(fibre.azimuthal, Real(2) * absolute(Real(2) * turn - Real(1)) * place.extent);
  paths[2].band = paths[1].band;
  for (std::uint32_t c = 0u; c < 3u; ++c) {
    const std::array<Real, 4> path = chiang_attenuation(section, fibre.sigma_a[c]);
    for (std::uint32_t p = 0u; p < 3u; ++p) {
      paths[p].part[c] = place.weight * (fibre.tints[p + 1u] * path[p + 1u]);
    }
  }
  return paths;
}

/// N of a path and of its mirror image, averaged.
template <std::floating_point Real>
[[nodiscard]] inline Real both_sides(const chiang_far_path<Real>& path, const rotation<Real>& azimuth) noexcept {
  const rotation<Real> one = turned_back(azimuth, path.middle);
  const rotation<Real> other = turned_by(azimuth, path.middle);
  return Real(0.5) * (evaluate_azimuthal(path.band, unsigned_angle(one.sine, one.cosine)) +
                      evaluate_azimuthal(path.band, unsigned_angle(other.sine, other.cosine)));
}

/// A choice among paths, as they come, each by its share of the sum so far.
template <std::floating_point Real>
struct chiang_far_choice {
  chiang_far_path<Real> path;  ///< the one chosen so far
  std::uint32_t lobe;
  Real sum;   ///< of all paths so far
  Real left;  ///< the number that chooses, [3e-8, 1), so none of a lesser share; each choice leaves an even one
};

template <std::floating_point Real>
inline void offer_path(chiang_far_choice<Real>& choice, const chiang_far_path<Real>& path,
                       std::uint32_t lobe) noexcept {
  const Real offered = path.part[0] + path.part[1] + path.part[2];
  choice.sum = choice.sum + offered;
  const Real share = choice.sum > Real(0) ? offered / choice.sum : Real(0);
  const bool taken = choice.left < share;
  const Real rest = taken ? choice.left / share : (choice.left - share) / (Real(1) - share);
  choice.left = least(greatest(rest, Real(3e-8)), Real(0.99999994));
  if (taken) {
    choice.path = path;
    choice.lobe = lobe;
  }
}

}  // namespace detail

template <std::floating_point Real>
chiang_far_azimuths<Real> chiang_far_lobes(const chiang_fibre<Real>& fibre, Real sin_o, Real cos_o,
                                           const rotation<Real>& azimuth) noexcept {
  chiang_far_azimuths<Real> averages;
  for (std::uint32_t p = 0u; p < 4u; ++p) {
    averages.value[p] = std::array<Real, 3>{Real(0), Real(0), Real(0)};
  }
  const int cells = detail::chiang_far_cells(fibre);
  Real total = Real(0);
  Real passed = Real(0);
  Real met = Real(0);
  for (int k = 0; k < 2 * cells; ++k) {
    Real through = Real(0);
    const detail::chiang_far_path<Real> path = detail::reflect_in_cell(fibre, cos_o, k, 2 * cells, through);
    const Real n = detail::both_sides(path, azimuth);
    passed = passed + through;
    for (std::uint32_t c = 0u; c < 3u; ++c) {
      total = total + path.part[c];
      averages.value[0][c] = averages.value[0][c] + n * path.part[c];
    }
  }
  for (int k = 0; k < cells; ++k) {
    Real through = Real(0);
    const std::array<detail::chiang_far_path<Real>, 3> paths =
        detail::pass_cell(fibre, sin_o, cos_o, k, cells, through);
    met = met + through;
    for (std::uint32_t p = 0u; p < 3u; ++p) {
      const Real n = p == 2u ? Real(0.159154943091895336) : detail::both_sides(paths[p], azimuth);
      for (std::uint32_t c = 0u; c < 3u; ++c) {
        total = total + paths[p].part[c];
        averages.value[p + 1u][c] = averages.value[p + 1u][c] + n * paths[p].part[c];
      }
    }
  }
  // What R's cells let through is what the others share, so that none is lost between them.
  const Real balance = met > Real(0) ? passed / met : Real(1);
  const Real over = total > Real(0) ? Real(1) / total : Real(0);
  for (std::uint32_t p = 0u; p < 4u; ++p) {
    averages.density[p] = (averages.value[p][0] + averages.value[p][1] + averages.value[p][2]) * over;
    for (std::uint32_t c = 0u; c < 3u; ++c) {
      averages.value[p][c] = p == 0u ? averages.value[p][c] : balance * averages.value[p][c];
    }
  }
  return averages;
}

template <std::floating_point Real>
chiang_result<Real> evaluate_chiang_far(const chiang_fibre<Real>& fibre, const fibre_direction<Real>& eye,
                                        const fibre_direction<Real>& light) noexcept {
  const std::array<Real, 4> along = chiang_inclinations(fibre, view_chiang(fibre, Real(0), eye), light);
  const chiang_far_azimuths<Real> averages = chiang_far_lobes(
      fibre, eye.sine, eye.cosine, turned_back(rotation<Real>{light.y, light.z}, rotation<Real>{eye.y, eye.z}));
  chiang_result<Real> result = {glm::vec<3, Real>(Real(0)), Real(0)};
  for (std::uint32_t p = 0u; p < 4u; ++p) {
    result.value.x = result.value.x + along[p] * averages.value[p][0];
    result.value.y = result.value.y + along[p] * averages.value[p][1];
    result.value.z = result.value.z + along[p] * averages.value[p][2];
    result.density = result.density + along[p] * averages.density[p];
  }
  return result;
}

template <std::floating_point Real>
chiang_sample<Real> sample_chiang_far(const chiang_fibre<Real>& fibre, const fibre_direction<Real>& eye,
                                      const std::array<Real, 4>& u) noexcept {
  const int cells = detail::chiang_far_cells(fibre);
  Real passed = Real(0);
  detail::chiang_far_choice<Real> choice;
  choice.path = detail::reflect_in_cell(fibre, eye.cosine, 0, 2 * cells, passed);
  choice.lobe = 0u;
  choice.sum = Real(0);
  choice.left = greatest(u[0], Real(3e-8));
  for (int k = 0; k < 2 * cells; ++k) {
    const detail::chiang_far_path<Real> path = detail::reflect_in_cell(fibre, eye.cosine, k, 2 * cells, passed);
    detail::offer_path(choice, path, 0u);
  }
  for (int k = 0; k < cells; ++k) {
    const std::array<detail::chiang_far_path<Real>, 3> paths =
        detail::pass_cell(fibre, eye.sine, eye.cosine, k, cells, passed);
    for (std::uint32_t p = 0u; p < 3u; ++p) {
      detail::offer_path(choice, paths[p], p + 1u);
    }
  }

  // What is left of the first number chooses the half of the width and the place in the cell.
  const bool mirrored = choice.left < Real(0.5);
  const Real place = mirrored ? Real(2) * choice.left : Real(2) * choice.left - Real(1);
  const rotation<Real> eyes = {eye.y, eye.z};
  const rotation<Real> side = mirrored ? turned_back(eyes, choice.path.middle) : turned_by(eyes, choice.path.middle);
  const rotation<Real> middle = turned_by(side, rotation_by(choice.path.band.width * (place - Real(0.5))));
  const chiang_view<Real> view = view_chiang(fibre, Real(0), eye);
  longitudinal_lobe<Real> along = fibre.longitudinal[3];
  rotation<Real> tilted = rotation<Real>{eye.cosine, eye.sine};
  for (std::uint32_t p = 0u; p < 3u; ++p) {
    if (p == choice.lobe) {
      along = fibre.longitudinal[p];
      tilted = view.tilted[p];
    }
  }
  chiang_sample<Real> drawn;
  drawn.lobe = choice.lobe;
  drawn.direction = detail::draw_chiang_direction(along, make_azimuthal_lobe(choice.path.band.scale), tilted, middle,
                                                  choice.lobe == 3u, u);
  drawn.result = evaluate_chiang_far(fibre, eye, fibre_direction_of(drawn.direction));
  return drawn;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
