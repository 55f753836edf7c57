// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/session.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <stdexcept>
#include <utility>

#include "frame/vulkan/bsdf_block.hpp"
#include "frame/vulkan/kernels.hpp"
#include "frame/vulkan/layer_maps.hpp"

namespace pelage::frame::vulkan {

using pelage::vulkan::device_options;
using pelage::vulkan::kernel;
using pelage::vulkan::step;

namespace {

const device_options wanted{
    .caller = "--device vulkan",
    .application = "pelage-frame",
    .bindings = buffer_count,
    .has_uniforms = true,
    .push_bytes = 44,
    .gpu_workgroup = 256,
    .timed = true,
    .validate = false,
};

device_options options_for(const frame_settings& settings) {
  device_options options = wanted;
  options.variant = settings.drawn == primitive::line ? 1 : 0;
  return options;
}

const kernel& kernel_called(const std::string& name) {
  const auto found =
      std::find_if(kernels::all.begin(), kernels::all.end(), [&](const kernel& one) { return one.name == name; });
  if (found == kernels::all.end()) throw std::invalid_argument("--device vulkan: there is no kernel " + name);
  return *found;
}

}  // namespace

session::session(const stage& set, const frame_settings& settings)
    : device_(options_for(settings)),
      set_(set),
      k_(settings.k),
      sorts_(set.slices.sorts),
      shadows_(has_shadows(settings.shown)),
      lookup_(settings.lookup == map_lookup::jittered ? "_jittered" : ""),
      light_plan_(plan_of(settings, false)),
      camera_plan_(plan_of(settings, true)),
      shading_(shading_kernel(settings.look)),
      constants_(make_scene_block(set, settings)) {
  check_device();
  place_layers(constants_, set, settings);
  if (needs_64_bit_atomics(settings) && !device_.has_64_bit_atomics()) {
    throw std::runtime_error("--device vulkan: " + device_.name() +
                             " has no 64-bit atomics for --order atomic_k_buffer or --blend depth_peeling");
  }
  device_.resize(scene_buffer, sizeof constants_);
  upload_constants();
  const fibre_bsdf bsdf = make_bsdf(set, settings.look);
  upload_bsdf(device_, bsdf);
  if (bsdf.table() == nullptr) colour_ = bsdf.pigment_colour();
  upload_strands();
  upload_rest(device_, set.hair);
  make_buffers();
}

/// What depends on the order of drawing, and room for what fibres stop in each view.
void session::upload_strands() {
  upload_fibres(device_, set_.fibres, set_.slices.slices > 0 ? set_.slices.segments : set_.drawing_order, colour_);
  if (constants_.eta > 0.0F) {
    device_.resize(opacity_buffer, (set_.lights.size() + 1) * set_.fibres.point.size() * sizeof(float));
  }
}

void session::move_camera(const frame_settings& settings) {
  constants_ = make_scene_block(set_, settings);
  place_layers(constants_, set_, settings);
  upload_constants();
  if (set_.whole || set_.slices.sorts != sorts_) upload_strands();
  sorts_ = set_.slices.sorts;
  frame_ = {};
  make_buffers();
}

/// Throws for what the kernels cannot do without; a subgroup of any size up to 64 will do.
void session::check_device() const {
  const VkPhysicalDeviceSubgroupProperties& has = device_.physical().subgroups;
  const VkPhysicalDeviceLimits& limits = device_.physical().properties.limits;
  constexpr VkSubgroupFeatureFlags needed = VK_SUBGROUP_FEATURE_BASIC_BIT | VK_SUBGROUP_FEATURE_VOTE_BIT |
                                            VK_SUBGROUP_FEATURE_ARITHMETIC_BIT | VK_SUBGROUP_FEATURE_BALLOT_BIT |
                                            VK_SUBGROUP_FEATURE_SHUFFLE_BIT;
  if ((has.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT) == 0 || (has.supportedOperations & needed) != needed) {
    throw std::runtime_error("--device vulkan: " + device_.name() +
                             " lacks subgroup vote, arithmetic, ballot or shuffle");
  }
  if (device_.subgroup() > 64) {  // the pixels of a block: shaders/opaque.comp
    throw std::runtime_error(fmt::format("--device vulkan: {} has subgroups of {} invocations, at most 64 will do",
                                         device_.name(), device_.subgroup()));
  }
  const std::uint32_t most = std::min(limits.maxComputeWorkGroupInvocations, limits.maxComputeWorkGroupSize[0]);
  if (most < device_.workgroup()) {
    throw std::runtime_error(fmt::format("--device vulkan: {} has workgroups of at most {} invocations, {} are needed",
                                         device_.name(), most, device_.workgroup()));
  }
}

std::vector<double> session::draw(std::uint32_t frame) {
  if (!set_.hair.moves()) return device_.run(frame_.steps);
  time_ = frame;
  if (camera_plan_.layer.empty()) {
    blow(frame_.steps.front());
  } else {
    tally();
    frame_ = {};
    make_frame();
  }
  std::vector<double> milliseconds = device_.run(frame_.steps);
  for (bool has_grown = true; has_grown && !all_fitted(); ++redrawn_) {
    const std::vector<room> before = rooms_;
    frame_ = {};
    make_buffers();
    has_grown = rooms_ != before;  // else what is refused has no place anywhere, as a depth that is no number
    milliseconds = device_.run(frame_.steps);
  }
  return milliseconds;
}

void session::read_picture(image& picture) {
  device_.download(picture_buffer, std::as_writable_bytes(std::span(picture.pixels)));
}

void session::read_fibres(std::span<glm::vec4> points, std::span<glm::vec3> tangents) {
  device_.download(point_buffer, std::as_writable_bytes(points));
  device_.download(tangent_buffer, std::as_writable_bytes(tangents));
}

std::vector<device_frame::fragments> session::read_fragments() {
  const std::vector<view_report> last = read_reports();
  if (set_.hair.moves()) tally();
  std::vector<device_frame::fragments> all;
  for (std::uint32_t v = first_view(); v <= camera(); ++v)
    all.push_back({counted_[v].with_carries(counted_[v].fragments), counted_[v].longest, last[v].refused});
  return all;
}

session::view_range session::only(std::uint32_t v) const {
  return {v == camera() ? "camera" : fmt::format("light {}", v + 1), v, v + 1};
}

std::uint64_t session::invocations(const view_range& views, over what) const {
  if (what == over::segments) return set_.fibres.segment_count();
  if (what == over::points) return set_.fibres.point.size();
  std::uint64_t most = 0;
  for (std::uint32_t v = views.first; v < views.end; ++v) {
    most = std::max(most, what == over::stamps ? std::uint64_t{constants_.views[v].stamp_count} : blocks(v));
  }
  return most;
}

void session::fill(named_steps& to, const view_range& views, const std::string& what, std::uint32_t binding,
                   std::uint32_t value) const {
  step s;
  s.binding = binding;
  s.value = value;
  to.add({views.name, "clear " + what}, std::move(s));
}

void session::run(named_steps& to, const view_range& views, const std::string& kernel, over what) const {
  step s;
  s.program = &kernel_called(kernel);
  s.invocations = invocations(views, what) * (what == over::subgroups ? device_.subgroup() : 1);
  s.layers = views.end - views.first;
  s.push = {views.first, has_records(views.first) ? records_ : places_, plan_for(views.first).lists, k_};
  to.add({views.name, kernel}, std::move(s));
}

void session::run(named_steps& to, const view_range& views, const std::vector<plan::pass>& passes) const {
  for (const plan::pass& p : passes)
    run(to, views, p.kernel, p.what);
}

void session::run_slices(named_steps& to, const view_range& views, const std::vector<plan::pass>& passes) const {
  const std::vector<std::uint32_t>& first = set_.slices.first;
  for (std::size_t slice = 0; slice + 1 < first.size(); ++slice) {
    if (first[slice] == first[slice + 1]) continue;
    for (const plan::pass& p : passes) {
      run(to, views, p.kernel, p.what);
      step& added = to.steps.back();
      added.push.insert(added.push.end(), {first[slice], first[slice + 1]});
      if (p.what == over::segments) added.invocations = first[slice + 1] - first[slice];
    }
  }
}

void session::upload_constants() {
  device_.upload(scene_buffer, std::as_bytes(std::span(&constants_, 1)));
}

void session::make_buffers() {
  std::uint64_t all = 0;
  std::uint64_t most = 0;
  std::uint64_t all_blocks = 0;
  for (std::uint32_t v = 0; v <= camera(); ++v) {
    all += pixels(v);
    all_blocks += blocks(v) / 64;
    most = std::max(most, pixels(v));
  }
  const std::uint64_t points = set_.fibres.point.size();
  device_.resize(limit_buffer, all * sizeof(float));
  device_.resize(block_limit_buffer, all_blocks * sizeof(float));
  device_.resize(edge_buffer, pixels(camera()) * 5 * sizeof(float));
  device_.resize(count_buffer, all * sizeof(std::uint32_t));
  device_.resize(run_buffer, all * 2 * sizeof(std::uint32_t));
  device_.resize(report_buffer, (set_.lights.size() + 1) * sizeof(view_report));
  device_.resize(seen_buffer, points * sizeof(std::uint32_t));
  device_.resize(shaded_buffer, points * 2 * sizeof(std::uint32_t));
  device_.resize(picture_buffer, pixels(camera()) * 3 * sizeof(float));
  device_.resize(pool_buffer, 0);
  device_.resize(record_buffer, 0);
  device_.resize(stamp_buffer, 0);
  for (scene_block::view_block& v : constants_.views)
    v.stamp_count = v.end_place = 0;
  upload_constants();
  const std::uint64_t texels = all - pixels(camera());
  device_.resize(cell_buffer, (light_plan_.maps || camera_plan_.maps ? all : 0) * 12 * sizeof(std::uint32_t));
  device_.resize(covered_buffer, (light_plan_.covered ? texels : 0) * 2 * sizeof(std::uint32_t));
  device_.resize(blended_buffer, pixels(camera()) * camera_plan_.blended * sizeof(std::uint32_t));
  const std::uint64_t layered =
      texels * layer_words(light_plan_.layers) + pixels(camera()) * layer_words(camera_plan_.layers);
  if (layered > 0xffffffffU)
    throw std::runtime_error("--device vulkan: the maps have more layers than can be numbered");
  device_.resize(layer_buffer, layered * sizeof(std::uint32_t));
  measure();
  make_room();
  const std::uint64_t entries = light_plan_.whole ? places_ : texels * k_;
  const std::uint64_t lists = std::max(light_plan_.lists, camera_plan_.lists);
  const std::uint64_t links = lists == 0 ? 0 : lists * most + std::max(places_, records_);
  if (links > 0xff000000U || entries > 0xffffffffU) {
    throw std::runtime_error("--device vulkan: the frame has more fragments than can be numbered");
  }
  device_.resize(texel_buffer, (light_plan_.pool ? texels : 0) * 8 * sizeof(std::uint32_t));
  device_.resize(entry_buffer, (light_plan_.pool ? entries : 0) * 2 * sizeof(std::uint32_t));
  device_.resize(link_buffer, links * sizeof(std::uint32_t));
  device_.resize(slot_buffer, most * std::max(light_plan_.slots, camera_plan_.slots) * sizeof(std::uint64_t));
  tally();
  make_frame();
}

std::vector<view_report> session::run_and_read(const named_steps& steps) {
  (void)device_.run(steps.steps);
  return read_reports();
}

std::vector<view_report> session::read_reports() {
  std::vector<view_report> read(set_.lights.size() + 1);
  device_.download(report_buffer, std::as_writable_bytes(std::span(read)));
  return read;
}

/// Brings the wind of the frame that is drawn.
void session::blow(step& s) const {
  static_assert(sizeof(wind) == 5 * sizeof(std::uint32_t));
  const auto words = std::bit_cast<std::array<std::uint32_t, 5>>(set_.hair.wind_at(time_));
  s.push.resize(6);
  s.push.insert(s.push.end(), words.begin(), words.end());
}

/// What every frame begins with.
void session::begin(named_steps& to) const {
  if (set_.hair.moves()) {
    run(to, {all_views().name, first_view(), first_view() + 1}, "sway", over::points);
    blow(to.steps.back());
  }
  fill(to, all_views(), "reports", report_buffer, 0);
  fill(to, all_views(), "seen", seen_buffer, 0);
  fill(to, all_views(), "block limits", block_limit_buffer, 0);
  run(to, all_views(), "opaque", over::pixels);
}

/// Finds how many fragments each view that holds them has at most.
void session::measure() {
  named_steps steps;
  begin(steps);
  fill(steps, all_views(), "counts", count_buffer, 0);
  for (const view_range& views : one_by_one()) {
    if (plan_for(views.first).pool) run(steps, views, {{"count", over::segments}, {"allocate", over::pixels}});
  }
  counted_ = run_and_read(steps);
  rooms_.resize(counted_.size());
  for (std::uint32_t v = first_view(); v <= camera(); ++v) {
    const std::uint64_t places = counted_[v].with_carries(counted_[v].taken);
    const std::uint64_t stamps = counted_[v].stamps;
    if (!set_.hair.moves()) {
      rooms_[v] = {places, stamps};
      continue;
    }
    // Never less than before: what one frame needs another may need again.
    rooms_[v].places = std::max(rooms_[v].places, places + places / 8);
    rooms_[v].stamps = std::max(rooms_[v].stamps, stamps + set_.fibres.segment_count() / 8);
  }
}

/// Whether the last frame of moving hair found the room that it needed.
bool session::all_fitted() {
  const std::vector<view_report> last = read_reports();
  for (std::uint32_t v = first_view(); v <= camera(); ++v) {
    const bool has_room = !plan_for(v).runs || (last[v].with_carries(last[v].taken) <= rooms_[v].places &&
                                                last[v].stamps <= rooms_[v].stamps);
    if (last[v].refused > 0 || !has_room) return false;
  }
  return true;
}

/// Gives each view its part of the pool and of the stamps. Runs lie one view's behind another's; lists have
/// the pool to themselves, one view after another. The camera's records have memory of their own.
void session::make_room() {
  std::uint64_t stamps = 0;
  std::uint64_t places = 0;
  std::uint64_t records = 0;
  for (std::uint32_t v = first_view(); v <= camera(); ++v) {
    const plan& p = plan_for(v);
    const std::uint64_t taken = rooms_[v].places;
    if (!p.runs) {
      std::uint64_t& of_lists = has_records(v) ? records : places;
      of_lists = std::max(of_lists, taken);
      continue;
    }
    if (has_records(v)) {
      records = taken;
    } else {
      constants_.views[v].first_place = static_cast<std::uint32_t>(places);
      places += taken;
    }
    constants_.views[v].end_place = constants_.views[v].first_place + static_cast<std::uint32_t>(taken);
    const std::uint64_t count = std::uint64_t{set_.fibres.segment_count()} + rooms_[v].stamps;
    constants_.views[v].first_stamp = static_cast<std::uint32_t>(stamps);
    constants_.views[v].stamp_count = static_cast<std::uint32_t>(count);
    stamps += count;
  }
  if (std::max({stamps, places, records}) > 0xffffffffU) {
    throw std::runtime_error("--device vulkan: the frame has more fragments than can be numbered");
  }
  places_ = static_cast<std::uint32_t>(places);
  records_ = static_cast<std::uint32_t>(records);
  device_.resize(pool_buffer, places * 2 * sizeof(std::uint32_t));
  device_.resize(record_buffer, records * 4 * sizeof(std::uint32_t));
  device_.resize(stamp_buffer, stamps * 4 * sizeof(std::uint32_t));
  upload_constants();
}

/// Counts the fragments of every view once, for the report and for layers.
void session::tally() {
  named_steps steps;
  begin(steps);
  fill(steps, all_views(), "counts", count_buffer, 0);
  run(steps, all_views(), {{"count_drawn", over::segments}, {"tally", over::pixels}});
  counted_ = run_and_read(steps);
}

void session::build(const view_range& views) {
  for (const plan::clearing& c : plan_for(views.first).clear)
    fill(frame_, views, c.what, c.binding, c.value);
  run(frame_, views, plan_for(views.first).build);
}

void session::finish(const view_range& views) {
  const plan& p = plan_for(views.first);
  if (views.first == camera()) {
    const std::string maps = light_plan_.layers > 0 ? "_layered" : light_plan_.maps ? "_occupancy" : "";
    run(frame_, views, {{shading_ + maps + lookup_, over::points}, {"background" + maps, over::pixels}});
    frame_.steps.back().beside = true;
    frame_.names.back().pass = (frame_.names.end() - 2)->pass = "shade, background";
  }
  const std::uint32_t layers = p.layer.empty() ? 0 : counted_[views.first].longest;
  if (frame_.steps.size() + layers * p.layer.size() + p.finish.size() > device::most_steps) {
    throw std::runtime_error(
        fmt::format("--device vulkan: --blend depth_peeling: {} layers are too many for a frame", layers));
  }
  for (std::uint32_t layer = 0; layer < layers; ++layer)
    run(frame_, views, p.layer);
  if (!p.slice.empty()) run_slices(frame_, views, p.slice);
  run(frame_, views, p.finish);
}

void session::make_frame() {
  begin(frame_);
  if (constants_.eta > 0.0F) run(frame_, all_views(), "attenuate", over::points);
  if (light_plan_.maps || camera_plan_.maps) fill(frame_, all_views(), "maps", cell_buffer, 0);
  if (light_plan_.covered) fill(frame_, all_views(), "covered", covered_buffer, 0);
  if (light_plan_.layers + camera_plan_.layers > 0) fill(frame_, all_views(), "layers", layer_buffer, 0);
  if (light_plan_.runs && camera_plan_.runs) {
    build(all_views());
    if (lights().end > 0 && shadows_) finish(lights());
    finish(only(camera()));
    return;
  }
  for (const view_range& views : one_by_one()) {
    build(views);
    finish(views);
  }
}

}  // namespace pelage::frame::vulkan
