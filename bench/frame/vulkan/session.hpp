// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "frame/image/image.hpp"
#include "frame/stage.hpp"
#include "frame/vulkan/buffers.hpp"
#include "frame/vulkan/device_frame.hpp"
#include "frame/vulkan/plan.hpp"
#include "frame/vulkan/scene_block.hpp"
#include "vulkan/device.hpp"

namespace pelage::frame::vulkan {

/// What a device does, and under which view and pass each step's time is reported.
struct named_steps {
  struct name {
    std::string view;
    std::string pass;
  };
  std::vector<pelage::vulkan::step> steps;
  std::vector<name> names;  ///< one a step

  void add(name n, pelage::vulkan::step s) {
    names.push_back(std::move(n));
    steps.push_back(std::move(s));
  }
};

/// One model and view on one device.
class session {
 public:
  /// Throws std::runtime_error, one line, where the device lacks what the settings ask for.
  session(const stage& set, const frame_settings& settings);

  [[nodiscard]] const std::string& device_name() const { return device_.name(); }
  [[nodiscard]] std::uint64_t bytes() const { return device_.bytes(); }
  [[nodiscard]] const named_steps& frame() const { return frame_; }
  /// Draws a frame; which one matters to hair that moves. Milliseconds of each step.
  [[nodiscard]] std::vector<double> draw(std::uint32_t frame = 0);
  /// How often a frame of moving hair had to be drawn again, since it needed more room than those before.
  [[nodiscard]] std::uint32_t redrawn() const { return redrawn_; }
  /// After the stage's camera has moved: all that depends on it anew.
  void move_camera(const frame_settings& settings);
  void read_picture(image& picture);
  /// Points and radii of the frame that was drawn last, and tangents; as many as the stage has.
  void read_fibres(std::span<glm::vec4> points, std::span<glm::vec3> tangents);
  /// One a light with shadows, then the camera's; of hair that moves in the frame that was drawn last.
  [[nodiscard]] std::vector<device_frame::fragments> read_fragments();

 private:
  /// For a view's fragments, and for the stamps of its segments.
  struct room {
    std::uint64_t places, stamps;
    friend bool operator==(const room&, const room&) = default;
  };
  [[nodiscard]] std::uint32_t camera() const { return static_cast<std::uint32_t>(set_.lights.size()); }
  [[nodiscard]] const plan& plan_for(std::uint32_t v) const { return v == camera() ? camera_plan_ : light_plan_; }
  /// Whether the view's fragments are records, which do not lie in the pool.
  [[nodiscard]] bool has_records(std::uint32_t v) const { return v == camera() && camera_plan_.records; }
  [[nodiscard]] const view& view_of(std::uint32_t v) const { return v == camera() ? set_.eye : set_.light_views[v]; }
  [[nodiscard]] std::uint64_t pixels(std::uint32_t v) const {
    return static_cast<std::uint64_t>(view_of(v).width) * static_cast<std::uint64_t>(view_of(v).height);
  }
  /// Invocations of a kernel that walks a view's pixels in blocks of 8 × 8.
  [[nodiscard]] std::uint64_t blocks(std::uint32_t v) const {
    const auto rounded = [](int n) { return static_cast<std::uint64_t>((n + 7) / 8 * 8); };
    return rounded(view_of(v).width) * rounded(view_of(v).height);
  }
  [[nodiscard]] std::uint32_t first_view() const { return shadows_ ? 0 : camera(); }

  /// Views that one step works for.
  struct view_range {
    std::string name;
    std::uint32_t first, end;
  };
  [[nodiscard]] view_range only(std::uint32_t v) const;
  [[nodiscard]] view_range lights() const { return {"lights", first_view(), camera()}; }
  [[nodiscard]] view_range all_views() const {
    return shadows_ ? view_range{"all", first_view(), camera() + 1} : only(camera());
  }
  [[nodiscard]] std::vector<view_range> one_by_one() const {
    std::vector<view_range> all;
    for (std::uint32_t v = first_view(); v <= camera(); ++v)
      all.push_back(only(v));
    return all;
  }

  [[nodiscard]] std::uint64_t invocations(const view_range& views, over what) const;
  void fill(named_steps& to, const view_range& views, const std::string& what, std::uint32_t binding,
            std::uint32_t value) const;
  void run(named_steps& to, const view_range& views, const std::string& kernel, over what) const;
  void run(named_steps& to, const view_range& views, const std::vector<plan::pass>& passes) const;
  void run_slices(named_steps& to, const view_range& views, const std::vector<plan::pass>& passes) const;

  void check_device() const;
  void upload_constants();
  void upload_strands();
  void make_buffers();
  [[nodiscard]] std::vector<view_report> read_reports();
  [[nodiscard]] std::vector<view_report> run_and_read(const named_steps& steps);
  void blow(pelage::vulkan::step& s) const;
  void begin(named_steps& to) const;
  void measure();
  void make_room();
  [[nodiscard]] bool all_fitted();
  void tally();
  void build(const view_range& views);
  void finish(const view_range& views);
  void make_frame();

  device device_;
  const stage& set_;
  std::uint32_t k_;
  std::uint32_t sorts_;  ///< of the slices, when segments were uploaded
  bool shadows_;
  std::string lookup_;  ///< at the end of the name of the kernel that lights fibres
  plan light_plan_;
  plan camera_plan_;
  std::string shading_;              ///< the kernel, less what its name says of the maps
  std::optional<glm::vec3> colour_;  ///< of all fibres, where kajiya_kay has a pigment
  scene_block constants_;
  std::uint32_t places_ = 0;   ///< in the pool
  std::uint32_t records_ = 0;  ///< of the camera, for which there is memory
  std::vector<view_report> counted_;
  std::vector<room> rooms_;  ///< that each view has
  std::uint32_t time_ = 0;   ///< the frame that is drawn
  std::uint32_t redrawn_ = 0;
  named_steps frame_;
};

}  // namespace pelage::frame::vulkan
