// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>

#include "frame/order/order_pass.hpp"
#include "frame/shadows/shadow_map.hpp"

namespace pelage::frame {

/// What a light's map keeps of the fibres.
enum class shadow_method {
  k_buffer,              ///< the K nearest fragments and the sum of the rest
  occupancy,             ///< 128 slices and 4 slabs of each texel's range [Sintorn & Assarsson 2009]
  opacity,               ///< equal slices of the whole model's range [Kim & Neumann 2001]
  deep_opacity,          ///< equal layers from each texel's first depth on [Yuksel & Keyser 2008]
  deep_opacity_growing,  ///< the same with widths that grow linearly [Svoboda §1.5.4]
  deep,                  ///< deep shadow maps of a greatest error [Lokovic & Veach 2000]
  exact                  ///< all fragments, sorted
};

/// Layers that the renderer is compiled for.
inline constexpr std::array<std::uint32_t, 7> compiled_layers{4, 8, 16, 32, 64, 128, 256};

/// A method and its parameter.
struct shadow_choice {
  shadow_method method = shadow_method::k_buffer;
  std::uint32_t layers = 0;  ///< of opacity and both deep_opacity, one of compiled_layers
  float max_error = 0.0F;    ///< of deep, [0, 1]
};

/// Reads "k_buffer", "occupancy", "opacity:N", "deep_opacity:N", "deep_opacity_growing:N", "deep:ERR" or "exact".
/// Throws std::invalid_argument with one line that says what is wrong.
[[nodiscard]] shadow_choice parse_shadow(const std::string& text);

/// A map and what it took to make it.
struct cast_shadow {
  std::unique_ptr<shadow_map> map;
  order_report report;
};

/// Makes the map of a light. `order` says how k_buffer finds its fragments, and the order of drawing for all. Throws as
/// run_order_pass() does.
[[nodiscard]] cast_shadow cast(const shadow_choice& choice, const raster& from, const solids& opaque,
                               const order_options& order, bool translucent);

}  // namespace pelage::frame
