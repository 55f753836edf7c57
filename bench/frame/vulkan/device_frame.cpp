// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/device_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "frame/stage.hpp"
#include "frame/vulkan/buffers.hpp"
#include "frame/vulkan/device.hpp"
#include "frame/vulkan/scene_block.hpp"

namespace pelage::frame {
namespace {

using namespace vulkan;

constexpr std::uint32_t any_k[]{4, 8, 16, 32, 64};  ///< that resolving kernels are compiled for

/// What the shaders do not have is refused before any work.
void check(const frame_settings& s) {
  if (std::find(std::begin(any_k), std::end(any_k), s.k) == std::end(any_k)) {
    throw std::runtime_error("--device vulkan: --k must be 4, 8, 16, 32 or 64");
  }
  if (s.look.model != bsdf_model::kajiya_kay || s.look.pigment) {
    throw std::runtime_error("--device vulkan: fibres are lit by --bsdf kajiya_kay in their own colours");
  }
  if (s.shadow.method != shadow_method::k_buffer) {
    throw std::runtime_error("--device vulkan: maps are made by --shadow k_buffer");
  }
  if (s.blend.method != blend_method::k_buffer) {
    throw std::runtime_error("--device vulkan: pixels are made by --blend k_buffer");
  }
}

/// What a method asks for.
struct plan {
  std::vector<std::string> build;  ///< kernels that put fragments into the structure; # stands for K
  std::string resolve;             ///< kernel that takes them out; @ stands for the sink
  bool by_subgroup;                ///< that has a subgroup a pixel
  bool records;                    ///< the camera's runs hold records
  std::uint32_t lists;             ///< a pixel; 0: the pool is cut into runs
  bool slots;                      ///< K of 8 bytes a pixel stand before the list
};

plan plan_of(order_method method) {
  switch (method) {
    case order_method::k_buffer:
      return {{"count", "allocate", "scatter"}, "select_@_#", true, true, 0, false};
    case order_method::a_buffer:
      return {{"push"}, "resolve_lists_@_#", false, false, 1, false};
    case order_method::ordered_list:
      return {{"insert_ordered"}, "resolve_ordered_@", false, false, 2, false};
    case order_method::atomic_k_buffer:
      return {{"clear_slots_#", "insert_atomic_#"}, "resolve_slots_@_#", false, false, 1, true};
    case order_method::two_pass_k_buffer:
      return {{"offer_depths_#", "insert_ids_#"}, "resolve_split_@_#", false, false, 1, true};
    case order_method::selection_sort:
      return {{"count", "allocate", "scatter"}, "resolve_sorted_@", false, false, 0, false};
    case order_method::full_sort:
      break;
  }
  throw std::runtime_error("--device vulkan: there is no --order full_sort; selection_sort gives its picture");
}

/// A plan's kernel for one sink and K.
std::string kernel_name(std::string pattern, const std::string& sink, std::uint32_t k) {
  if (const std::size_t at = pattern.find('@'); at != std::string::npos) pattern.replace(at, 1, sink);
  if (const std::size_t at = pattern.find('#'); at != std::string::npos) pattern.replace(at, 1, std::to_string(k));
  return pattern;
}

std::uint64_t hash_of(std::span<const float> values) {
  std::uint64_t hash = 14695981039346656037U;  // FNV-1a, by words
  for (const float v : values)
    hash = (hash ^ std::bit_cast<std::uint32_t>(v)) * 1099511628211U;
  return hash;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// One model and view on one device.
class session {
 public:
  session(const stage& set, const frame_settings& settings)
      : set_(set), k_(settings.k), shadows_(has_shadows(settings.shown)), plan_(plan_of(settings.order)) {
    if (settings.order == order_method::atomic_k_buffer && !device_.has_64_bit_atomics()) {
      throw std::runtime_error("--device vulkan: " + device_.name() +
                               " has no 64-bit atomics for --order atomic_k_buffer");
    }
    const scene_block constants = make_scene_block(set, settings);
    device_.resize(scene_buffer, sizeof constants);
    device_.upload(scene_buffer, std::as_bytes(std::span(&constants, 1)));
    upload_fibres(device_, set.fibres, set.drawing_order);
    make_buffers();
  }

  [[nodiscard]] const std::string& device_name() const { return device_.name(); }
  [[nodiscard]] std::uint64_t bytes() const { return device_.bytes(); }
  [[nodiscard]] const std::vector<step>& frame() const { return frame_; }
  [[nodiscard]] std::vector<double> draw() { return device_.run(frame_); }

  void read_picture(image& picture) {
    device_.download(picture_buffer, std::as_writable_bytes(std::span(picture.pixels)));
  }

  /// One a light with shadows, then the camera's.
  [[nodiscard]] std::vector<device_frame::fragments> read_fragments() {
    std::vector<view_report> last(set_.lights.size() + 1);
    device_.download(report_buffer, std::as_writable_bytes(std::span(last)));
    std::vector<device_frame::fragments> all;
    for (const std::uint32_t v : views())
      all.push_back({counted_[v].fragments, counted_[v].longest, last[v].refused});
    return all;
  }

 private:
  [[nodiscard]] std::uint32_t camera() const { return static_cast<std::uint32_t>(set_.lights.size()); }
  [[nodiscard]] const view& view_of(std::uint32_t v) const { return v == camera() ? set_.eye : set_.light_views[v]; }
  [[nodiscard]] std::uint64_t pixels(std::uint32_t v) const {
    return static_cast<std::uint64_t>(view_of(v).width) * static_cast<std::uint64_t>(view_of(v).height);
  }
  /// Invocations of a kernel that walks a view's pixels in blocks of 8 × 8.
  [[nodiscard]] std::uint64_t blocks(std::uint32_t v) const {
    const auto rounded = [](int n) { return static_cast<std::uint64_t>((n + 7) / 8 * 8); };
    return rounded(view_of(v).width) * rounded(view_of(v).height);
  }
  [[nodiscard]] std::vector<std::uint32_t> views() const {
    std::vector<std::uint32_t> all;
    for (std::uint32_t v = shadows_ ? 0 : camera(); v <= camera(); ++v)
      all.push_back(v);
    return all;
  }
  [[nodiscard]] std::string view_name(std::uint32_t v) const {
    return v == camera() ? "camera" : fmt::format("light {}", v + 1);
  }

  void fill(std::vector<step>& to, std::uint32_t v, const std::string& what, std::uint32_t binding,
            std::uint32_t value) const {
    to.push_back({view_name(v), "clear " + what, "", binding, value, 0, false, {}});
  }
  void run(std::vector<step>& to, std::uint32_t v, const std::string& kernel, std::uint64_t invocations,
           bool by_subgroup = false) const {
    to.push_back({view_name(v), kernel, kernel, 0, 0, invocations, by_subgroup, {v, capacity_, plan_.lists, k_}});
  }
  void allocate(std::vector<step>& to, std::uint32_t v) const {
    run(to, v, "opaque", blocks(v));
    fill(to, v, "counts", count_buffer, 0);
    run(to, v, "count", set_.fibres.segment_count());
    run(to, v, "allocate", blocks(v));
  }

  void make_buffers();
  [[nodiscard]] std::vector<view_report> run_and_read(const std::vector<step>& steps);
  void measure();
  void tally();
  void make_frame();

  device device_;
  const stage& set_;
  std::uint32_t k_;
  bool shadows_;
  plan plan_;
  std::uint32_t capacity_ = 0;
  std::vector<view_report> counted_;
  std::vector<step> frame_;
};

void session::make_buffers() {
  std::uint64_t all = 0;
  std::uint64_t most = 0;
  for (std::uint32_t v = 0; v <= camera(); ++v) {
    all += pixels(v);
    most = std::max(most, pixels(v));
  }
  const std::uint64_t points = set_.fibres.point.size();
  device_.resize(limit_buffer, all * sizeof(float));
  device_.resize(sample_buffer, pixels(camera()) * 9 * sizeof(float));
  device_.resize(count_buffer, most * sizeof(std::uint32_t));
  device_.resize(run_buffer, most * 2 * sizeof(std::uint32_t));
  device_.resize(report_buffer, (set_.lights.size() + 1) * sizeof(view_report));
  device_.resize(seen_buffer, points * sizeof(std::uint32_t));
  device_.resize(shaded_buffer, points * 2 * sizeof(std::uint32_t));
  device_.resize(picture_buffer, pixels(camera()) * 3 * sizeof(float));
  device_.resize(pool_buffer, 0);
  device_.resize(record_buffer, 0);
  measure();
  const std::uint64_t texels = all - pixels(camera());
  const std::uint64_t entries = plan_.resolve == "resolve_sorted_@" ? camera() * std::uint64_t{capacity_} : texels * k_;
  const std::uint64_t links = plan_.lists == 0 ? 0 : plan_.lists * most + capacity_;
  if (links > 0xff000000U || entries > 0xffffffffU) {
    throw std::runtime_error("--device vulkan: the frame has more fragments than can be numbered");
  }
  device_.resize(pool_buffer, std::uint64_t{capacity_} * 2 * sizeof(std::uint32_t));
  device_.resize(texel_buffer, texels * 4 * sizeof(std::uint32_t));
  device_.resize(entry_buffer, entries * 2 * sizeof(std::uint32_t));
  device_.resize(link_buffer, links * sizeof(std::uint32_t));
  device_.resize(slot_buffer, plan_.slots ? most * k_ * sizeof(std::uint64_t) : 0);
  device_.resize(record_buffer,
                 plan_.records ? std::uint64_t{counted_[camera()].taken} * 4 * sizeof(std::uint32_t) : 0);
  tally();
  make_frame();
}

std::vector<view_report> session::run_and_read(const std::vector<step>& steps) {
  (void)device_.run(steps);
  std::vector<view_report> read(set_.lights.size() + 1);
  device_.download(report_buffer, std::as_writable_bytes(std::span(read)));
  return read;
}

/// Finds how many places the view that has most fragments wants in the pool.
void session::measure() {
  std::vector<step> steps;
  fill(steps, camera(), "reports", report_buffer, 0);
  fill(steps, camera(), "seen", seen_buffer, 0);
  for (const std::uint32_t v : views())
    allocate(steps, v);
  counted_ = run_and_read(steps);
  for (const view_report& r : counted_)
    capacity_ = std::max(capacity_, r.taken);
}

/// Counts the fragments of every view once, for the report.
void session::tally() {
  std::vector<step> steps;
  fill(steps, camera(), "reports", report_buffer, 0);
  for (const std::uint32_t v : views()) {
    allocate(steps, v);
    run(steps, v, "scatter", set_.fibres.segment_count());
    run(steps, v, "tally", blocks(v));
  }
  counted_ = run_and_read(steps);
}

void session::make_frame() {
  fill(frame_, views().front(), "reports", report_buffer, 0);
  for (const std::uint32_t v : views()) {
    run(frame_, v, "opaque", blocks(v));
    if (plan_.lists == 0) {
      fill(frame_, v, "counts", count_buffer, 0);
    } else {
      fill(frame_, v, "links", link_buffer, 0xffffffffU);
    }
    if (plan_.slots && plan_.build.front() != "clear_slots_#") fill(frame_, v, "slots", slot_buffer, 0xffffffffU);
    const std::string sink = v == camera() ? "camera" : "light";
    for (const std::string& pattern : plan_.build) {
      const bool by_pixel = pattern == "allocate" || pattern == "clear_slots_#";
      const bool records = plan_.records && v == camera() && pattern == "scatter";
      run(frame_, v, records ? "scatter_records" : kernel_name(pattern, sink, k_),
          by_pixel ? blocks(v) : set_.fibres.segment_count());
    }
    if (v == camera()) {
      run(frame_, v, "shade", set_.fibres.segment_count());
      run(frame_, v, "background", blocks(v));
    }
    run(frame_, v, kernel_name(plan_.resolve, sink, k_), blocks(v), plan_.by_subgroup);
  }
}

}  // namespace

device_frame draw_frame_on_device(const hair_model& model, const frame_settings& settings, std::uint32_t frames) {
  check(settings);
  (void)plan_of(settings.order);  // refuses
  const stage set = set_up(model, settings);
  session on(set, settings);
  device_frame result{image(settings.width, settings.height), on.device_name(), {}, {}, 0, on.bytes(), 0, frames, 0};
  std::vector<std::vector<double>> times(on.frame().size());
  std::vector<double> whole;
  for (std::uint32_t f = 0; f < frames / 10; ++f)
    (void)on.draw();
  for (std::uint32_t f = 0; f < frames; ++f) {
    const std::vector<double> milliseconds = on.draw();
    double sum = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
      times[i].push_back(milliseconds[i]);
      sum += milliseconds[i];
    }
    whole.push_back(sum);
    on.read_picture(result.picture);
    const std::span<const glm::vec3> pixels = result.picture.pixels;
    const std::uint64_t hash = hash_of({&pixels.front().x, 3 * pixels.size()});
    if (f == 0) result.hash = hash;
    result.same += hash == result.hash ? 1 : 0;
  }
  for (std::size_t i = 0; i < times.size(); ++i)
    result.passes.push_back({on.frame()[i].view, on.frame()[i].pass, median(times[i])});
  result.milliseconds = median(whole);
  result.views = on.read_fragments();
  return result;
}

}  // namespace pelage::frame
