// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/plan.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "frame/vulkan/buffers.hpp"
#include "frame/vulkan/layer_maps.hpp"

namespace pelage::frame::vulkan {
namespace {

constexpr std::uint32_t any_k[]{4, 8, 16, 32, 64};  ///< that resolving kernels are compiled for

/// By --order and --k.
plan plan_by_order(const frame_settings& s, bool camera) {
  const std::string sink = camera ? "camera" : "light";
  const std::string k = std::to_string(s.k);
  const std::string tail = camera && s.tails == 0 ? "_truncated" : "";
  const plan::clearing counts{"counts", count_buffer, 0};
  const plan::clearing links{"links", link_buffer, 0xffffffffU};
  const std::vector<plan::pass> runs{{"count", over::segments}, {"allocate", over::pixels}, {"scatter", over::stamps}};
  const std::vector<plan::pass> records{
      {"count", over::segments}, {"allocate", over::pixels}, {"scatter_records", over::stamps}};
  plan p{};
  p.pool = true;
  switch (s.order) {
    case order_method::k_buffer:
      p.clear = {counts};
      p.build = records;
      p.runs = true;
      p.finish = {{"select_" + sink + "_" + k + tail, over::subgroups}};
      p.records = true;
      return p;
    case order_method::a_buffer:
      p.clear = {links};
      p.build = {{"push", over::segments}};
      p.finish = {{"resolve_lists_" + sink + "_" + k + tail, over::pixels}};
      p.lists = 1;
      return p;
    case order_method::unrolled_list:
      p.clear = {links};
      p.build = {{"push_blocks", over::segments}};
      p.finish = {{"resolve_blocks_" + sink + "_" + k + tail, over::subgroups}};
      p.records = true;
      p.lists = 1;
      return p;
    case order_method::ordered_list:
      p.clear = {links};
      p.build = {{"insert_ordered", over::segments}};
      p.finish = {{"resolve_ordered_" + sink + tail, over::pixels}};
      p.lists = 2;
      return p;
    case order_method::atomic_k_buffer:
      p.clear = {links};
      p.build = {{"clear_slots_" + k, over::pixels}, {"insert_atomic_" + k, over::segments}};
      p.finish = {{"resolve_slots_" + sink + "_" + k + tail, over::pixels}};
      p.lists = 1;
      p.slots = s.k;
      return p;
    case order_method::split_k_buffer:
      p.clear = {links, {"slots", slot_buffer, 0xffffffffU}};
      p.build = {{"offer_depths_" + k, over::segments}, {"insert_ids_" + k, over::segments}};
      p.finish = {{"resolve_split_" + sink + "_" + k + tail, over::pixels}};
      p.lists = 1;
      p.slots = s.k;
      return p;
    case order_method::partial_selection_sort:
      p.clear = {counts};
      p.build = runs;
      p.runs = true;
      p.finish = {{"resolve_partial_" + sink + tail, over::pixels}};
      return p;
    case order_method::selection_sort:
      p.clear = {counts};
      p.build = runs;
      p.runs = true;
      p.finish = {{"resolve_sorted_" + sink, over::pixels}};
      p.whole = true;
      return p;
    case order_method::full_sort:
      break;
  }
  throw std::runtime_error("--device vulkan: there is no --order full_sort; selection_sort gives its picture");
}

/// All fragments drawn three times: for the depth range, for the map of it, and to be blended.
plan plan_by_weight() {
  plan p{};
  p.clear = {{"sums", blended_buffer, 0}};
  p.build = {{"extend_range", over::segments}};
  p.finish = {
      {"occupy_camera", over::segments}, {"blend_weighted", over::segments}, {"resolve_weighted", over::pixels}};
  p.maps = true;
  p.blended = 9;
  return p;
}

/// The same with moments in the place of the map.
plan plan_by_moments(const frame_settings& s) {
  const bool powers = s.blend.method == blend_method::moments;
  const std::string moments = (powers ? "moments_" : "moments_trigonometric_") + std::to_string(s.blend.size);
  plan p = plan_by_weight();
  p.finish = {{"occupy_" + moments, over::segments},
              {"blend_" + moments, over::segments},
              {"resolve_" + moments, over::pixels}};
  return p;
}

/// A light's map of layers that begin at its texels' nearest fragments, or where the model does.
plan plan_by_layers(const frame_settings& s) {
  plan p{};
  if (s.shadow.method != shadow_method::opacity) p.build = {{"extend_range_layered", over::segments}};
  p.build.insert(p.build.end(), {{"occupy_layered_light", over::segments}, {"accumulate", over::pixels}});
  p.layers = light_layers(s);
  return p;
}

/// All fragments drawn three times, as by plan_by_weight(); once where neither their range nor a map of it is asked
/// for, and every point is lit; twice where the range is.
plan plan_by_sums(const frame_settings& s) {
  plan p{};
  p.clear = {{"sums", blended_buffer, 0}};
  p.layers = camera_layers(s);
  p.blended = 9;
  if (s.blend.method == blend_method::weighted_average) {
    p.clear.push_back({"seen", seen_buffer, 1});
    p.finish = {{"blend_average", over::segments}, {"resolve_average", over::pixels}};
    return p;
  }
  p.build = {{"extend_range_layered", over::segments}};
  if (s.blend.method == blend_method::weighted_blended) {
    p.finish = {{"blend_by_depth", over::segments}, {"resolve_scaled", over::pixels}};
    return p;
  }
  const bool is_corrected = s.blend.method == blend_method::deep_opacity_corrected;
  p.finish = {{"occupy_layered_camera", over::segments},
              {"accumulate", over::pixels},
              {is_corrected ? "blend_corrected" : "blend_layered", over::segments},
              {is_corrected ? "resolve_scaled" : "resolve_unscaled", over::pixels}};
  return p;
}

/// All fragments drawn for each layer. Every point is lit: no pass before has said what the camera sees.
plan plan_by_peeling() {
  plan p{};
  p.clear = {{"seen", seen_buffer, 1}};
  p.build = {{"clear_layers", over::pixels}};
  p.layer = {{"peel", over::segments}, {"take_layer", over::pixels}};
  p.finish = {{"resolve_layers", over::pixels}};
  p.slots = 2;
  p.blended = 8;
  return p;
}

/// The segments of each slice drawn to lists, which are empty again once they are blended. Every point is lit, as
/// before peeling.
plan plan_by_slices() {
  plan p{};
  p.clear = {{"seen", seen_buffer, 1}, {"links", link_buffer, 0xffffffffU}};
  p.build = {{"clear_fronts", over::pixels}};
  p.slice = {{"push_slice", over::segments}, {"blend_slice", over::pixels}};
  p.finish = {{"resolve_layers", over::pixels}};
  p.pool = true;
  p.lists = 1;
  p.blended = 8;
  return p;
}

/// A light's map that keeps no fragment: which slices of its depth range hold any, and slabs' sums.
plan plan_by_occupancy() {
  plan p{};
  p.build = {{"extend_range", over::segments}, {"occupy_light", over::segments}};
  p.maps = true;
  return p;
}

plan plan_of_maps(const frame_settings& s) {
  switch (s.shadow.method) {
    case shadow_method::k_buffer:
      return plan_by_order(s, false);
    case shadow_method::occupancy:
      return plan_by_occupancy();
    case shadow_method::opacity:
    case shadow_method::deep_opacity:
    case shadow_method::deep_opacity_growing:
      return plan_by_layers(s);
    case shadow_method::deep:
    case shadow_method::exact:
      break;
  }
  throw std::runtime_error(
      "--device vulkan: maps are made by --shadow k_buffer, occupancy, opacity:N, deep_opacity:N or "
      "deep_opacity_growing:N");
}

plan plan_of_lights(const frame_settings& s) {
  plan p = plan_of_maps(s);
  p.covered = s.look.model == bsdf_model::dual_scattering;
  if (p.covered) p.finish.push_back({"cover", over::segments});
  return p;
}

plan plan_of_camera(const frame_settings& s) {
  switch (s.blend.method) {
    case blend_method::k_buffer:
      return plan_by_order(s, true);
    case blend_method::order_weighted:
      return plan_by_weight();
    case blend_method::weighted_average:
    case blend_method::weighted_blended:
    case blend_method::deep_opacity:
    case blend_method::deep_opacity_corrected:
      return plan_by_sums(s);
    case blend_method::moments:
    case blend_method::trigonometric:
      return plan_by_moments(s);
    case blend_method::depth_peeling:
      return plan_by_peeling();
    case blend_method::sliced:
      return plan_by_slices();
    case blend_method::exact:
    case blend_method::stochastic:
    case blend_method::sliced_clipped:
    case blend_method::layers:
      break;
  }
  throw std::runtime_error(
      "--device vulkan: pixels are made by --blend k_buffer, order_weighted, weighted_average, weighted_blended, "
      "deep_opacity:N, deep_opacity_corrected:N, depth_peeling, sliced:N, moments:N or trigonometric:N");
}

}  // namespace

std::string shading_kernel(const fibre_look& look) {
  if (look.model == bsdf_model::marschner) return "shade_marschner";
  if (look.model == bsdf_model::chiang) return "shade_chiang";
  return look.model == bsdf_model::dual_scattering ? "shade_dual_scattering" : "shade";
}

plan plan_of(const frame_settings& s, bool camera) {
  return camera ? plan_of_camera(s) : plan_of_lights(s);
}

void check_settings(const frame_settings& s) {
  if (std::find(std::begin(any_k), std::end(any_k), s.k) == std::end(any_k)) {
    throw std::runtime_error("--device vulkan: --k must be 4, 8, 16, 32 or 64");
  }
  if (s.sway > 0.0F && (s.crowd > 1 || s.detail.any())) {
    throw std::runtime_error(
        "--device vulkan: --sway moves the model's strands on the device; --segment-error, --strand-error and --crowd "
        "make others of them on the CPU");
  }
  for (const bool camera : {false, true})
    (void)plan_of(s, camera);
}

bool needs_64_bit_atomics(const frame_settings& s) {
  const bool by_order = s.shadow.method == shadow_method::k_buffer || s.blend.method == blend_method::k_buffer;
  return s.blend.method == blend_method::depth_peeling || (by_order && s.order == order_method::atomic_k_buffer);
}

}  // namespace pelage::frame::vulkan
