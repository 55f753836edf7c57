// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/measure.hpp"

#include <cstddef>

#include "frame/model/built_in.hpp"

namespace pelage::truth {

subject built_in(std::uint32_t strands, std::uint32_t segments, int size, int samples) {
  subject s{frame::make_built_in(strands, segments, 1), {}, samples};
  s.settings.width = s.settings.height = size;
  s.settings.on_bust = true;
  return s;
}

frame::image draw(const subject& s, const frame::frame_settings& settings) {
  return frame::draw_frame(s.model, settings, [](const std::string&, double) {}).picture;
}

coverage_error measure_coverage(const subject& s) {
  frame::frame_settings settings = s.settings;
  settings.opacity = 0.5F;
  const frame::stage set = frame::set_up(s.model, settings);
  const fibre_rays fibres(set.fibres);
  const picture truth = see_fibres(set.eye, fibres, s.samples, 1);
  const drawn_coverage drawn = draw_coverage(set, set.eye);
  coverage_error error;
  double entries = 0;
  double met = 0;
  for (std::size_t i = 0; i < drawn.alpha.size(); ++i) {
    const half_pixel& a = truth.halves[0][i];
    const half_pixel& b = truth.halves[1][i];
    entries += drawn.entries[i];
    met += 0.5 * static_cast<double>(a.entries + b.entries);
    error.alpha_bias += drawn.alpha[i] - 0.5 * static_cast<double>(a.alpha + b.alpha);
    error.alpha.see(drawn.alpha[i], static_cast<double>(a.alpha), static_cast<double>(b.alpha));
  }
  error.entries = met > 0.0 ? entries / met - 1.0 : 0.0;
  error.alpha_bias /= static_cast<double>(drawn.alpha.size());
  return error;
}

light_errors shadow_judge::judge(const frame::frame_settings& settings) const {
  frame::frame_settings own = settings;
  const frame::stage set = [&] {
    frame::stage s = set_;
    for (std::size_t i = 0; i < s.lights.size(); ++i) {
      if (own.map_size != 0) s.light_views[i] = frame::light_view(s.lights[i], s.round, own.map_size);
    }
    return s;
  }();
  light_errors errors;
  for (std::size_t i = 0; i < set.lights.size(); ++i) {
    const drawn_shadow map(set, own, i);
    errors.fibres.push_back(compare(map.to_fibres(places_.fibre), truth_.to_fibres[i], places_.fibre_share));
    errors.opaque.push_back(compare(map.to_opaque(places_.opaque), truth_.to_opaque[i], places_.opaque_share));
  }
  return errors;
}

}  // namespace pelage::truth
