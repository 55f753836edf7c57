// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/coverage/ray_cone.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <vector>

#include "frame/blends/blend_choice.hpp"
#include "frame/order/order_pass.hpp"
#include "frame/raster/line_in_pixel.hpp"
#include "frame/scene/detail.hpp"
#include "frame/scene/lights.hpp"
#include "frame/shading/camera_film.hpp"
#include "frame/shading/fibre_bsdf.hpp"
#include "frame/shadows/shadow_choice.hpp"

namespace pelage::frame {

/// What to draw and how. A model and its settings determine the picture, bit for bit: neither the number of threads,
/// nor the drawing order, nor the choice among k_buffer, a_buffer, unrolled_list, ordered_list, atomic_k_buffer,
/// split_k_buffer and partial_selection_sort changes it.
struct frame_settings {
  int width = 640;  ///< pixels, [1, 16384]
  int height = 640;
  int map_size = 0;  ///< texels a side of each light's map, [2, 16384]; 0: the picture's larger side, at most 2048
  order_method order = order_method::k_buffer;
  std::uint32_t k = 16;  ///< one of compiled_k
  shadow_choice shadow;
  map_lookup lookup = map_lookup::filtered;  ///< of fibres in the lights' maps
  blend_choice blend;
  std::uint32_t tails = 1;  ///< a pixel's, of k_buffer's blending, [0, 256]: 0 loses what is behind the K nearest, 1
                            ///< keeps its mean, more keep one a slice of the depths that are seen
  components shown = components::full;
  fibre_look look;               ///< how fibres scatter light
  float shading_spacing = 8.0F;  ///< pixels between the places of a segment that are shaded, [0, inf]; 0: each fragment
  primitive drawn = primitive::segment;
  bool antialias = true;
  pixel_footprint footprint = pixel_footprint::equal_area;  ///< of the camera, where it is anti-aliased
  std::vector<light> lights;      ///< relative to the scene; empty: two that go with the camera
  glm::vec3 ambient{0.0F};        ///< radiance from all sides that nothing shadows, linear RGB, [0, 1e6] each
  float opacity = -1.0F;          ///< of all fibres, [0, 1]; negative: the model's own
  float fibre_radius = -1.0F;     ///< of all fibres, length units, [0, inf); negative: the model's own
  std::uint64_t shuffle = 0;      ///< seed of the drawing order; 0: the model's order
  std::optional<glm::vec2> from;  ///< where the camera stands: azimuth from +z toward +x and elevation,
                                  ///< degrees, elevation in (-90, 90); none: where the hair is seen best
  float sway = 0.0F;              ///< how far a wind moves tips, in shares of the longest strand's reach, [0, 1]
  float distance = 1.0F;          ///< of the camera, in distances from which it just sees all hair, [0.5, 1000]
  detail_errors detail;           ///< that are allowed to the strands; none: all are drawn as they are
  std::uint32_t crowd = 1;        ///< copies of the model, [1, 4096]
  bool on_bust = false;           ///< the opaque object is the built-in bust, not a sphere that fits
};

}  // namespace pelage::frame
