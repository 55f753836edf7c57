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

// FNV-1a, by words.
constexpr std::uint64_t empty_hash = 14695981039346656037U;

constexpr std::uint64_t with_word(std::uint64_t hash, std::uint64_t word) {
  return (hash ^ word) * 1099511628211U;
}

std::uint64_t hash_of(const image& picture) {
  std::uint64_t hash = empty_hash;
  for (const glm::vec3& p : picture.pixels)
    for (const float channel : {p.r, p.g, p.b})
      hash = with_word(hash, std::bit_cast<std::uint32_t>(channel));
  return hash;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Of steps that are reported together, a time a frame: a pass that is repeated for each layer is one.
struct pass_times {
  std::string view;
  std::string name;
  std::vector<double> milliseconds;
};

/// Takes in a frame, which may have other steps than those before.
void add_times(std::vector<pass_times>& all, const std::vector<named_steps::name>& names,
               const std::vector<double>& milliseconds) {
  std::vector<bool> has_time(all.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto same = [&](const pass_times& p) { return p.view == names[i].view && p.name == names[i].pass; };
    const auto found = std::find_if(all.begin(), all.end(), same);
    const auto at = static_cast<std::size_t>(found - all.begin());
    if (found == all.end()) {
      all.push_back({names[i].view, names[i].pass, {}});
      has_time.push_back(false);
    }
    if (!has_time[at]) all[at].milliseconds.push_back(0.0);
    has_time[at] = true;
    all[at].milliseconds.back() += milliseconds[i];
  }
}

}  // namespace

device_frame draw_frame_on_device(const hair_model& model, const frame_settings& settings, std::uint32_t frames,
                                  float degrees) {
  check_settings(settings);
  stage set = set_up(model, settings);
  frame_settings now = settings;
  const glm::vec2 first = set.from;
  session on(set, settings);
  device_frame result{image(settings.width, settings.height), on.device_name(), {}, {}, 0, 0, 0, frames, 0};
  std::vector<pass_times> passes;
  std::vector<double> whole;
  std::vector<std::uint64_t> hashes;
  const auto drawn_hash = [&] {
    on.read_picture(result.picture);
    return hash_of(result.picture);
  };
  for (std::uint32_t f = 0; f < frames / 10; ++f)
    (void)on.draw(f);
  for (std::uint32_t f = 0; f < frames; ++f) {
    if (degrees != 0.0F && f > 0) {
      now.from = turned(first, degrees, f);
      move_camera(set, now);
      on.move_camera(now);
    }
    const std::vector<double> milliseconds = on.draw(f);
    add_times(passes, on.frame().names, milliseconds);
    whole.push_back(std::accumulate(milliseconds.begin(), milliseconds.end(), 0.0));
    hashes.push_back(drawn_hash());
  }
  for (std::uint32_t f = 0; f < frames; ++f) {
    if (set.hair.moves()) (void)on.draw(f);
    result.same += hashes[f] == (set.hair.moves() ? drawn_hash() : hashes.front()) ? 1 : 0;
  }
  result.hash =
      set.hair.moves() ? std::accumulate(hashes.begin(), hashes.end(), empty_hash, with_word) : hashes.front();
  for (const pass_times& p : passes)
    result.passes.push_back({p.view, p.name, median(p.milliseconds)});
  result.bytes = on.bytes();
  result.redrawn = on.redrawn();
  result.milliseconds = median(whole);
  result.views = on.read_fragments();
  result.drawn = report_of(set);
  return result;
}

}  // namespace pelage::frame
