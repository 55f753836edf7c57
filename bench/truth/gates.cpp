// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/gates.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "truth/measure.hpp"

namespace pelage::truth {
namespace {

/// The numbers that must lie within bounds, as they come.
class gates {
 public:
  void below(const std::string& what, double value, double bound) {
    say(what, value, std::abs(value) < bound, fmt::format("below {}", bound));
  }
  void between(const std::string& what, double value, double least, double greatest) {
    say(what, value, value >= least && value <= greatest, fmt::format("in [{}, {}]", least, greatest));
  }
  [[nodiscard]] bool all_kept() const { return kept_; }

 private:
  void say(const std::string& what, double value, bool kept, const std::string& bound) {
    fmt::print("{} {}: {:.5f}, {}\n", kept ? "pass" : "FAIL", what, value, bound);
    kept_ = kept_ && kept;
  }

  bool kept_ = true;
};

void check_coverage(gates& g, subject s) {
  s.samples = 128;  // of which the sum has a noise of 0.05 %
  const coverage_error e = measure_coverage(s, 0.5F);
  g.below("summed coverage against fibres met, %", 100.0 * e.entries, 0.2);
  g.below("alpha bias", e.alpha_bias, 0.001);
  g.below("alpha RMS", e.alpha.rms(), 0.009);
}

void check_fibre(gates& g) {
  const fibre_error e = measure_lone_fibres(0.125, 256);
  g.between("an upright fibre's mean coverage, widths", e.mean, 0.98, 1.02);
  g.between("its least", e.least, 0.7, 1.0);
  g.between("its greatest", e.greatest, 1.0, 1.2);
}

void check_light(gates& g, const subject& s, const lighting& scene) {
  const shadow_judge rays(scene, 16);
  for (const char* const method : {"exact", "k_buffer"}) {
    frame::frame_settings settings = s.settings;
    settings.shadow = frame::parse_shadow(method);
    const shadow_judge::errors e = rays.errors_of(settings);
    for (std::size_t i = 0; i < e.fibres.size(); ++i) {
      g.below(fmt::format("light {} on fibres by {} against rays, %", i + 1, method), 100.0 * e.fibres[i].ratio, 1.0);
      g.below(fmt::format("light {} on opaque objects by {} against rays, %", i + 1, method), 100.0 * e.opaque[i].ratio,
              1.0);
    }
  }
}

void check_frame(gates& g, const subject& s, const judge& rays) {
  frame::frame_settings view = s.settings;
  view.shown = frame::components::translucency;
  const frame_error alone = rays.error_of(view);
  const frame_error full = rays.error_of(s.settings);
  g.below("RMS without shadows", alone.all.rms(), 0.0036);
  g.below("RMS", full.all.rms(), 0.0045);
  g.below("RMS where there is no hair", full.of(region::bare).rms(), 0.0022);
}

void check_ball(gates& g) {
  const subject s = ball_before_hair(64, 32);
  frame::frame_settings view = s.settings;
  view.shown = frame::components::translucency;
  const frame_error e = judge(s).error_of(view);
  g.below("RMS at the edge of a ball before hair", e.of(region::edge).rms(), 0.014);
}

}  // namespace

bool check_gates() {
  gates g;
  const subject s = built_in(5000, 48, 160, 32);
  check_coverage(g, s);
  check_fibre(g);
  const judge rays(s);
  check_light(g, s, rays.scene());
  check_frame(g, s, rays);
  check_ball(g);
  return g.all_kept();
}

}  // namespace pelage::truth
