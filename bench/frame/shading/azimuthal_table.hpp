// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/bsdf/chiang.hpp>
#include <pelage/bsdf/marschner_table.hpp>

#include <glm/glm.hpp>
#include <vector>

namespace pelage::frame {

/// What a fibre seen from afar does round its axis, precomputed so that a shading costs two look-ups: N of R, TT and
/// TRT over inclination × azimuth, the residual lobe's, and their integrals. 0.6 MB; made in about 0.1 s.
///
/// Marschner's model takes the difference angle θ_d for the inclination, Chiang's the eye's θ: all else in it depends
/// on the longitudinal lobes alone, so that its average over the width is as separable as Marschner's.
///
/// Largest error against the models, relative to the greatest N of the row: 0.04 in TRT (see marschner_table.hpp) for
/// Marschner's, 0.01 for Chiang's with β_n ≥ 0.1 (0.013 at 0.05), for inclinations up to 1.2 (69°).
class azimuthal_table {
 public:
  static constexpr std::uint32_t rows = 64;      ///< sines of inclination from 0 to 1
  static constexpr std::uint32_t columns = 256;  ///< azimuths from 0 to π

  azimuthal_table(azimuthal_table&&) = default;  // spans keep pointing to what the vectors hold
  azimuthal_table& operator=(azimuthal_table&&) = default;
  explicit azimuthal_table(const marschner_parameters<float>& parameters);
  explicit azimuthal_table(const chiang_fibre<float>& fibre);

  /// N per radian; `phi` in [0, π], 0 where light and eye are on one side.
  [[nodiscard]] marschner_lobes<float> lobes(float sin_theta, float phi) const;

  /// What light that was reflected more than once inside leaves: evenly round the fibre, per radian.
  [[nodiscard]] glm::vec3 residual(float sin_theta) const { return look_up(residual_, sin_theta); }

  /// ∫ N_TT dφ: the share of the light met that passes straight on. [passage.hpp]
  [[nodiscard]] glm::vec3 passage(float sin_theta) const { return look_up(passage_, sin_theta); }

  /// ∫ Σ N (1 - |φ|/π) dφ: the share that turns back, as dual scattering takes it apart.
  [[nodiscard]] glm::vec3 backward(float sin_theta) const { return look_up(backward_, sin_theta); }

  /// The entries themselves: N by rows and columns, the others by rows.
  [[nodiscard]] const marschner_table<float>& lobes() const { return table_; }
  [[nodiscard]] const std::vector<glm::vec3>& residual() const { return residual_; }
  [[nodiscard]] const std::vector<glm::vec3>& passage() const { return passage_; }
  [[nodiscard]] const std::vector<glm::vec3>& backward() const { return backward_; }

 private:
  azimuthal_table();
  void integrate();
  [[nodiscard]] static glm::vec3 look_up(const std::vector<glm::vec3>& rows, float sin_theta);

  std::vector<glm::vec3> reflected_, transmitted_, returned_;  ///< rows of inclination, columns of azimuth
  std::vector<glm::vec3> residual_, passage_, backward_;       ///< per row
  marschner_table<float> table_;                               ///< the first three
};

}  // namespace pelage::frame
