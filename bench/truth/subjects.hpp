// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "frame/model/hair_model.hpp"
#include "frame/settings.hpp"

namespace pelage::truth {

/// What a measurement is made of: a model, how it is drawn, and by how many rays it is judged.
struct subject {
  frame::hair_model model;
  frame::frame_settings settings;
  int samples = 64;  ///< rays a pixel in each half of the truth, [2, inf)
};

/// The built-in model, as pelage-frame draws it by default.
[[nodiscard]] subject built_in(std::uint32_t strands, std::uint32_t segments, int size, int samples);

/// A ball before hair so dense that little is seen through it: the hair's roots are the ball's far side, whence it runs
/// in all directions across the ball's edge, behind it.
[[nodiscard]] subject ball_before_hair(int size, int samples);

/// Upright straight fibres side by side, `lone_fibres_count` of them at as many places in a pixel, some 4.1 pixels
/// apart. `radius`: of all, pixels.
inline constexpr int lone_fibres_count = 39;
[[nodiscard]] subject lone_fibres(double radius, int samples);

}  // namespace pelage::truth
