// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/chiang.hpp>
#include <pelage/core/assert.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/lanes.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace pelage::inline PELAGE_ABI {

/// Chiang's model for many pairs of directions at once, on the CPU: the kernel of chiang.hpp run on lanes of floats,
/// so each result has the bits that the scalar kernel in float gives. Structure of arrays; all spans of one length.
struct chiang_batch {
  std::span<const float> h;                     ///< as for view_chiang()
  std::array<std::span<const float>, 3> eye;    ///< x, y, z of unit vectors to the eye
  std::array<std::span<const float>, 3> light;  ///< and to the light
};

/// What comes out, of the same length; may not overlap the inputs.
struct chiang_batch_result {
  std::array<std::span<float>, 3> value;  ///< for red, green, blue: as that of chiang_result
  std::span<float> density;               ///< per steradian
};

/// A parameter set per element, where each fibre is its own.
struct chiang_batch_parameters {
  std::span<const float> eta;
  std::array<std::span<const float>, 3> sigma_a;
  std::span<const float> beta_m;
  std::span<const float> beta_n;
  std::span<const float> tilt;
};

/// Evaluates all elements on one fibre. W: lanes at a time, lane_width() by default. O(n), nothing allocated.
template <int W = lane_width()>
void evaluate_chiang_batch(const chiang_fibre<float>& fibre, const chiang_batch& batch,
                           const chiang_batch_result& result) noexcept;

/// Makes each element's fibre and evaluates it.
template <int W = lane_width()>
void evaluate_chiang_batch(const chiang_batch_parameters& parameters, const chiang_batch& batch,
                           const chiang_batch_result& result) noexcept;

// ---------------------------------------------------------------------------------------------------------

namespace detail {

/// W floats from `from[at]` on; lanes past the end repeat the last element.
template <int W>
[[nodiscard]] lanes<W> load_lanes(std::span<const float> from, std::size_t at) noexcept {
  if (at + W <= from.size()) {
    return lanes<W>::load(from.data() + at);
  }
  std::array<float, W> rest;
  for (std::size_t k = 0; k < W; ++k) {
    rest[k] = from[at + k < from.size() ? at + k : from.size() - 1];
  }
  return lanes<W>::load(rest.data());
}

/// Writes W floats from `to[at]` on, those past the end excepted.
template <int W>
void store_lanes(lanes<W> values, std::span<float> to, std::size_t at) noexcept {
  if (at + W <= to.size()) {
    values.store(to.data() + at);
    return;
  }
  std::array<float, W> rest;
  values.store(rest.data());
  for (std::size_t k = 0; at + k < to.size(); ++k) {
    to[at + k] = rest[k];
  }
}

/// The same fibre in every lane.
template <int W>
[[nodiscard]] chiang_fibre<lanes<W>> broadcast(const chiang_fibre<float>& fibre) noexcept {
  using pack = lanes<W>;
  chiang_fibre<pack> wide;
  wide.eta = pack(fibre.eta);
  for (std::uint32_t c = 0u; c < 3u; ++c) {
    wide.sigma_a[c] = pack(fibre.sigma_a[c]);
    wide.tilts[c] = rotation<pack>{pack(fibre.tilts[c].cosine), pack(fibre.tilts[c].sine)};
  }
  for (std::uint32_t p = 0u; p < 4u; ++p) {
    const longitudinal_lobe<float> lobe = fibre.longitudinal[p];
    wide.tints[p] = pack(fibre.tints[p]);
    wide.longitudinal[p] = longitudinal_lobe<pack>{pack(lobe.variance), pack(lobe.concentration), pack(lobe.height)};
  }
  wide.azimuthal =
      azimuthal_lobe<pack>{pack(fibre.azimuthal.scale), pack(fibre.azimuthal.steepness), pack(fibre.azimuthal.height)};
  return wide;
}

/// Evaluates the W elements from `at` on.
template <int W>
void evaluate_chiang_lanes(const chiang_fibre<lanes<W>>& fibre, const chiang_batch& batch,
                           const chiang_batch_result& result, std::size_t at) noexcept {
  using pack = lanes<W>;
  const pack h = load_lanes<W>(batch.h, at);
  const fibre_direction<pack> eye = fibre_direction_of(load_lanes<W>(batch.eye[0], at), load_lanes<W>(batch.eye[1], at),
                                                       load_lanes<W>(batch.eye[2], at));
  const fibre_direction<pack> light = fibre_direction_of(
      load_lanes<W>(batch.light[0], at), load_lanes<W>(batch.light[1], at), load_lanes<W>(batch.light[2], at));
  const chiang_result<pack> found = evaluate_chiang(fibre, view_chiang(fibre, h, eye), light);
  store_lanes<W>(found.value.x, result.value[0], at);
  store_lanes<W>(found.value.y, result.value[1], at);
  store_lanes<W>(found.value.z, result.value[2], at);
  store_lanes<W>(found.density, result.density, at);
}

/// The caller's contract: one length for all.
inline void assert_one_length([[maybe_unused]] const chiang_batch& batch,
                              [[maybe_unused]] const chiang_batch_result& result) noexcept {
  for (std::uint32_t c = 0u; c < 3u; ++c) {
    PELAGE_ASSERT(batch.eye[c].size() == batch.h.size() && batch.light[c].size() == batch.h.size());
    PELAGE_ASSERT(result.value[c].size() == batch.h.size());
  }
  PELAGE_ASSERT(result.density.size() == batch.h.size());
}

}  // namespace detail

template <int W>
void evaluate_chiang_batch(const chiang_fibre<float>& fibre, const chiang_batch& batch,
                           const chiang_batch_result& result) noexcept {
  detail::assert_one_length(batch, result);
  const chiang_fibre<lanes<W>> wide = detail::broadcast<W>(fibre);
  for (std::size_t at = 0; at < batch.h.size(); at += W) {
    detail::evaluate_chiang_lanes<W>(wide, batch, result, at);
  }
}

template <int W>
void evaluate_chiang_batch(const chiang_batch_parameters& parameters, const chiang_batch& batch,
                           const chiang_batch_result& result) noexcept {
  detail::assert_one_length(batch, result);
  for (std::size_t at = 0; at < batch.h.size(); at += W) {
    const chiang_parameters<lanes<W>> here = {
        detail::load_lanes<W>(parameters.eta, at),
        {detail::load_lanes<W>(parameters.sigma_a[0], at), detail::load_lanes<W>(parameters.sigma_a[1], at),
         detail::load_lanes<W>(parameters.sigma_a[2], at)},
        detail::load_lanes<W>(parameters.beta_m, at),
        detail::load_lanes<W>(parameters.beta_n, at),
        detail::load_lanes<W>(parameters.tilt, at)};
    detail::evaluate_chiang_lanes<W>(make_chiang_fibre(here), batch, result, at);
  }
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
