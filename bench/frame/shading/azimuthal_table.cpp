// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading/azimuthal_table.hpp"

#include <pelage/bsdf/chiang_far_field.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pelage::frame {
namespace {

constexpr float pi = 3.14159265F;

float sine_of_row(std::uint32_t row) {
  return static_cast<float>(row) / static_cast<float>(azimuthal_table::rows - 1);
}

glm::vec3 colour_of(const std::array<float, 3>& a) {
  return {a[0], a[1], a[2]};
}

}  // namespace

azimuthal_table::azimuthal_table()
    : reflected_(rows * columns),
      transmitted_(rows * columns),
      returned_(rows * columns),
      residual_(rows),
      passage_(rows),
      backward_(rows),
      table_{rows, columns, reflected_, transmitted_, returned_} {
}

azimuthal_table::azimuthal_table(const marschner_parameters<float>& parameters) : azimuthal_table() {
  fill_marschner_table(parameters, table_);
  integrate();
}

azimuthal_table::azimuthal_table(const chiang_fibre<float>& fibre) : azimuthal_table() {
  tbb::parallel_for(0U, rows, [&](std::uint32_t row) {
    const float sine = sine_of_row(row);
    const float cosine = std::sqrt((1.0F - sine) * (1.0F + sine));
    for (std::uint32_t column = 0; column < columns; ++column) {
      const float phi = pi * static_cast<float>(column) / static_cast<float>(columns - 1);
      const auto lobes = chiang_far_lobes(fibre, sine, cosine, rotation<float>{std::cos(phi), std::sin(phi)}).value;
      const std::size_t at = row * columns + column;
      reflected_[at] = colour_of(lobes[0]);
      transmitted_[at] = colour_of(lobes[1]);
      returned_[at] = colour_of(lobes[2]);
      residual_[row] = colour_of(lobes[3]);
    }
  });
  integrate();
}

/// By the trapezium rule.
void azimuthal_table::integrate() {
  const float step = pi / static_cast<float>(columns - 1);
  for (std::uint32_t row = 0; row < rows; ++row) {
    backward_[row] = pi * residual_[row];
    for (std::uint32_t column = 0; column < columns; ++column) {
      const float both_sides = column == 0 || column == columns - 1 ? step : 2.0F * step;
      const float back = 1.0F - static_cast<float>(column) / static_cast<float>(columns - 1);
      const std::size_t at = row * columns + column;
      passage_[row] += both_sides * transmitted_[at];
      backward_[row] += both_sides * back * (reflected_[at] + transmitted_[at] + returned_[at]);
    }
  }
}

marschner_lobes<float> azimuthal_table::lobes(float sin_theta, float phi) const {
  return look_up_marschner(table_, sin_theta, phi);
}

glm::vec3 azimuthal_table::look_up(const std::vector<glm::vec3>& values, float sin_theta) {
  const float place = std::min(std::abs(sin_theta), 1.0F) * static_cast<float>(rows - 1);
  const std::uint32_t row = std::min(static_cast<std::uint32_t>(place), rows - 2);
  return glm::mix(values[row], values[row + 1], place - static_cast<float>(row));
}

}  // namespace pelage::frame
