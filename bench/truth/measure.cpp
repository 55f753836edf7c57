// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/measure.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace pelage::truth {

frame::frame_result draw(const subject& s, const frame::frame_settings& settings) {
  return frame::draw_frame(s.model, settings, [](const std::string&, double) {});
}

judge::judge(const subject& s)
    : subject_(s),
      set_(frame::set_up(s.model, s.settings)),
      fibres_(set_.fibres),
      scene_(set_, fibres_),
      truth_(see(scene_, s.samples, 1)) {
}

frame_error judge::error_of(const frame::frame_settings& settings) const {
  return error_of(draw(subject_, settings).picture, settings.shown);
}

frame_error judge::error_of(const frame::image& drawn, frame::components shown) const {
  return compare(drawn, truth_, frame::has_shadows(shown) ? &half_pixel::full : &half_pixel::lit);
}

coverage_error measure_coverage(const subject& s, float opacity) {
  frame::frame_settings settings = s.settings;
  settings.opacity = opacity;
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

fibre_error measure_lone_fibres(double radius, int samples) {
  const subject s = lone_fibres(radius, samples);
  const frame::stage set = frame::set_up(s.model, s.settings);
  const fibre_rays fibres(set.fibres);
  const picture truth = see_fibres(set.eye, fibres, samples, 1);
  const drawn_coverage drawn = draw_coverage(set, set.eye);
  const int row = s.settings.height / 2;  // all rows between the fibres' ends are alike
  fibre_error error{1e30, 0.0, -1e30, 0.0};
  squared_error pixels;
  for (int i = 0; i < lone_fibres_count; ++i) {
    const glm::vec3 middle = set.fibres.point[3 * static_cast<std::size_t>(i) + 1];
    const double tangent = static_cast<double>(middle.x) / static_cast<double>(set.eye.eye.z - middle.z);
    const double pixel = 0.5 * set.eye.width + static_cast<double>(set.eye.scale) * tangent;
    const double width = 2.0 * radius * std::sqrt(1.0 + tangent * tangent);  // seen from aside it is wider
    double sum = 0;
    for (int x = static_cast<int>(std::floor(pixel)) - 1; x <= static_cast<int>(std::floor(pixel)) + 1; ++x) {
      const auto at = static_cast<std::size_t>(row * set.eye.width + x);
      sum += drawn.entries[at] / width;
      pixels.see(drawn.entries[at] / width, static_cast<double>(truth.halves[0][at].entries) / width,
                 static_cast<double>(truth.halves[1][at].entries) / width);
    }
    error.least = std::min(error.least, sum);
    error.greatest = std::max(error.greatest, sum);
    error.mean += sum / lone_fibres_count;
  }
  error.rms = pixels.rms();
  return error;
}

shadow_judge::shadow_judge(const lighting& scene, int samples)
    : set_(scene.set()), places_(places_seen(scene, samples, 3)), truth_(shadows_at(scene, places_)) {
}

shadow_judge::errors shadow_judge::errors_of(const frame::frame_settings& settings) const {
  frame::stage set = set_;
  for (std::size_t i = 0; i < set.lights.size() && settings.map_size != 0; ++i)
    set.light_views[i] = frame::light_view(set.lights[i], set.round, settings.map_size);
  errors found;
  for (std::size_t i = 0; i < set.lights.size(); ++i) {
    const drawn_shadow map(set, settings, i);
    found.fibres.push_back(compare(map.to_fibres(places_.fibre), truth_.to_fibres[i], places_.fibre_share));
    found.opaque.push_back(compare(map.to_opaque(places_.opaque), truth_.to_opaque[i], places_.opaque_share));
  }
  return found;
}

}  // namespace pelage::truth
