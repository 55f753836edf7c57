// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/device_frame.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

#include "frame/stage.hpp"
#include "frame/vulkan/session.hpp"

namespace pelage::frame {
namespace {

using namespace vulkan;

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

/// The steps of a frame that are reported together: a pass that is repeated for each layer is one.
struct pass_of {
  std::string view;
  std::string name;
  std::vector<std::size_t> steps;
};

std::vector<pass_of> passes_of(const std::vector<named_steps::name>& frame) {
  std::vector<pass_of> all;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    const auto same = [&](const pass_of& p) { return p.view == frame[i].view && p.name == frame[i].pass; };
    auto found = std::find_if(all.begin(), all.end(), same);
    if (found == all.end()) found = all.insert(all.end(), {frame[i].view, frame[i].pass, {}});
    found->steps.push_back(i);
  }
  return all;
}

double sum_of(const std::vector<double>& milliseconds, const std::vector<std::size_t>& steps) {
  double sum = 0;
  for (const std::size_t i : steps)
    sum += milliseconds[i];
  return sum;
}

}  // namespace

device_frame draw_frame_on_device(const hair_model& model, const frame_settings& settings, std::uint32_t frames,
                                  float degrees) {
  check_settings(settings);
  stage set = set_up(model, settings);
  frame_settings now = settings;
  const glm::vec2 first = set.from;
  session on(set, settings);
  device_frame result{image(settings.width, settings.height), on.device_name(), {}, {}, 0, on.bytes(), 0, frames, 0};
  std::vector<pass_of> passes = passes_of(on.frame().names);
  std::vector<std::vector<double>> times(passes.size());
  std::vector<double> whole;
  for (std::uint32_t f = 0; f < frames / 10; ++f)
    (void)on.draw();
  for (std::uint32_t f = 0; f < frames; ++f) {
    if (degrees != 0.0F && f > 0) {
      now.from = turned(first, degrees, f);
      move_camera(set, model, now);
      on.move_camera(now);
      passes = passes_of(on.frame().names);  // with other steps
    }
    const std::vector<double> milliseconds = on.draw();
    for (std::size_t p = 0; p < passes.size(); ++p)
      times[p].push_back(sum_of(milliseconds, passes[p].steps));
    whole.push_back(std::accumulate(milliseconds.begin(), milliseconds.end(), 0.0));
    on.read_picture(result.picture);
    const std::span<const glm::vec3> pixels = result.picture.pixels;
    const std::uint64_t hash = hash_of({&pixels.front().x, 3 * pixels.size()});
    if (f == 0) result.hash = hash;
    result.same += hash == result.hash ? 1 : 0;
  }
  for (std::size_t p = 0; p < passes.size(); ++p)
    result.passes.push_back({passes[p].view, passes[p].name, median(times[p])});
  result.milliseconds = median(whole);
  result.views = on.read_fragments();
  result.sorts = set.slices.sorts;
  result.sort_seconds = set.slices.sort_seconds;
  return result;
}

}  // namespace pelage::frame
