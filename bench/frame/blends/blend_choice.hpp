// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "frame/order/order_pass.hpp"
#include "frame/order/slice_order.hpp"
#include "frame/shading/camera_film.hpp"

namespace pelage::frame {

/// How the camera's fragments become a pixel.
enum class blend_method {
  exact,                   ///< all fragments, sorted
  k_buffer,                ///< the K nearest in order over the mean of the rest
  order_weighted,          ///< by an order estimated from an occupancy map [Sintorn & Assarsson 2009]
  weighted_average,        ///< as equal fragments of mean colour and alpha [Bavoil & Myers 2008]
  weighted_blended,        ///< by a function of depth [McGuire & Bavoil 2013]
  deep_opacity,            ///< by layers between the pixel's nearest and farthest depth [Yu12 Fig. 8]
  deep_opacity_corrected,  ///< the same, no fragment before itself, their sum scaled
  depth_peeling,           ///< layer after layer, a pass over all fragments for each [Everitt 2001]
  stochastic,              ///< by random samples, alpha-corrected [Enderton et al. 2010]
  sliced,                  ///< in the order of the depth slices of segments' farther ends [Svoboda §1.3.3]
  sliced_clipped,          ///< the same of segments that are cut at the slices' planes [Sintorn & Assarsson 2008]
  moments,                 ///< by what power moments tell of the pixel [Münstermann et al. 2018]
  trigonometric,           ///< by trigonometric moments
  layers                   ///< as layers, of which the farthest are merged [Salvi & Vaidyanathan 2014]
};

/// Samples a pixel that the renderer is compiled for.
inline constexpr std::array<std::uint32_t, 7> compiled_samples{1, 2, 4, 8, 16, 32, 64};

/// Slices that the depths of a model can be cut into.
inline constexpr std::array<std::uint32_t, 8> slice_counts{8, 16, 32, 64, 128, 256, 512, 1024};

/// Layers between a pixel's nearest and farthest depth that the renderer is compiled for.
inline constexpr std::array<std::uint32_t, 7> blended_layers{4, 8, 16, 32, 64, 128, 256};

/// Moments and layers a pixel that the renderer is compiled for.
inline constexpr std::array<std::uint32_t, 2> compiled_moments{4, 6};
inline constexpr std::array<std::uint32_t, 2> compiled_trigonometric{2, 3};
inline constexpr std::array<std::uint32_t, 6> compiled_alpha_layers{1, 2, 4, 8, 16, 32};

/// A method and its parameters.
struct blend_choice {
  blend_method method = blend_method::k_buffer;
  std::uint32_t size = 0;  ///< samples of stochastic, slices, layers or moments, of those that the renderer has
  std::uint32_t seed = 1;  ///< of stochastic
};

/// Reads "exact", "k_buffer", "order_weighted", "weighted_average", "weighted_blended", "deep_opacity:N",
/// "deep_opacity_corrected:N", "depth_peeling", "stochastic:N", "sliced", "sliced:N", "sliced_clipped",
/// "sliced_clipped:N", 256 slices without N, "moments:N", "trigonometric:N" or "layers:N"; the seed is another
/// option's. Throws std::invalid_argument with one line that says what is wrong.
[[nodiscard]] blend_choice parse_blend(const std::string& text);

/// Slices that a pixel's tails can be cut into.
inline constexpr std::array<std::uint32_t, 6> tail_slices{2, 4, 8, 16, 32, 64};

/// How many tails a pixel has: reads "none" as 0, "mean" as 1, "sliced:N" as N, one of tail_slices. Throws as
/// parse_blend() does.
[[nodiscard]] std::uint32_t parse_tail(const std::string& text);

/// Draws all fragments of a raster, the film's own, on the film. `order` says how k_buffer finds its fragments, and the
/// order of drawing for all; `slices`, the order of sliced and sliced_clipped. Throws as run_order_pass() does.
order_report draw_on(camera_film& film, const blend_choice& choice, const raster& from, const order_options& order,
                     const slice_order& slices = {});

}  // namespace pelage::frame
