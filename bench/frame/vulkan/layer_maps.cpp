// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/layer_maps.hpp"

#include "frame/raster/raster.hpp"
#include "frame/scene/opaque_depth.hpp"
#include "frame/shadows/layer_layout.hpp"

namespace pelage::frame::vulkan {
namespace {

// As in shaders/layer_map.glsl.
constexpr std::uint32_t from_nearest = 0x80000000U;
constexpr std::uint32_t to_farthest = 0x40000000U;
constexpr std::uint32_t growing_widths = 0x20000000U;

/// What a light sees of the fibres; opacities have no say in where layers begin.
raster raster_of(const stage& set, const view& from, primitive drawn) {
  if (drawn == primitive::segment) return {set.fibres, from, true};
  return {set.fibres, from, true, line_depths_of(set, from)};
}

void place(scene_block::view_block& to, std::uint32_t layers, const raster& from, const solids& opaque,
           shadow_method method) {
  if (method == shadow_method::opacity) {
    const layer_layout model = layers_of_model(from);
    to.layers = layers;
    to.layer_first = model.first.front();
    to.layer_width = model.width(layers);
    return;
  }
  order_report unused;
  layer_layout own = layers_of_texels(from, opaque_depths(from.from(), opaque), {}, unused);
  const bool grows = method == shadow_method::deep_opacity_growing;
  own.widths = grows ? layer_widths::growing : layer_widths::equal;
  to.layers = layers | from_nearest | (grows ? growing_widths : 0U);
  to.layer_width = own.width(layers);
}

}  // namespace

std::uint32_t light_layers(const frame_settings& settings) {
  const shadow_method method = settings.shadow.method;
  const bool is_layered = method == shadow_method::opacity || method == shadow_method::deep_opacity ||
                          method == shadow_method::deep_opacity_growing;
  return is_layered ? settings.shadow.layers : 0;
}

std::uint32_t camera_layers(const frame_settings& settings) {
  switch (settings.blend.method) {
    case blend_method::deep_opacity:
    case blend_method::deep_opacity_corrected:
      return settings.blend.size;
    case blend_method::weighted_average:
    case blend_method::weighted_blended:
      return 1;
    default:
      return 0;
  }
}

std::uint32_t layer_words(std::uint32_t layers) {
  return layers == 0 ? 0 : layers + (layers + 40) / 32 + 2;
}

void place_layers(scene_block& to, const stage& set, const frame_settings& settings) {
  const std::uint32_t layers = has_shadows(settings.shown) ? light_layers(settings) : 0;
  for (std::size_t i = 0; layers > 0 && i < set.lights.size(); ++i)
    place(to.views[i], layers, raster_of(set, set.light_views[i], settings.drawn), set.opaque, settings.shadow.method);
  if (const std::uint32_t own = camera_layers(settings); own > 0) {
    to.views[set.lights.size()].layers = own | from_nearest | to_farthest;
  }
}

}  // namespace pelage::frame::vulkan
