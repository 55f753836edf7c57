// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/tables.hpp"

#include <fmt/format.h>

#include <string>

namespace pelage::truth {
namespace {

constexpr std::initializer_list<const char*> shadow_methods{
    "exact",       "k_buffer",       "occupancy",       "opacity:16",
    "opacity:128", "deep_opacity:4", "deep_opacity:16", "deep_opacity_growing:8",
    "deep:0.01",   "deep:0.1"};
constexpr std::initializer_list<const char*> blends{"exact",
                                                    "k_buffer",
                                                    "order_weighted",
                                                    "weighted_average",
                                                    "weighted_blended",
                                                    "deep_opacity:32",
                                                    "deep_opacity_corrected:32",
                                                    "stochastic:8",
                                                    "stochastic:32"};

/// "0.00642 ± 0.00003", or 0 and what the noise could hide.
std::string rms_text(const squared_error& e) {
  return fmt::format("{:.5f} ± {:.5f}", e.rms(), e.rms_noise());
}

frame::frame_settings with_shadow(frame::frame_settings s, const char* method, int map_size) {
  s.shadow = frame::parse_shadow(method);
  s.map_size = map_size;
  return s;
}

frame::frame_settings without_shadows(frame::frame_settings s) {
  s.shown = frame::components::translucency;
  return s;
}

std::string name_of_subject(const subject& s) {
  return fmt::format("{} strands, {}×{}", s.model.strand_count(), s.settings.width, s.settings.height);
}

}  // namespace

void print_coverage(const subject& s) {
  fmt::print("Coverage of {}, exact lists, no opaque object:\n\n", name_of_subject(s));
  fmt::print("| alpha | summed coverage / fibres met - 1 | alpha bias | alpha RMS |\n| ---: | ---: | ---: | ---: |\n");
  for (const float alpha : {0.5F, 0.15F}) {
    const coverage_error e = measure_coverage(s, alpha);
    fmt::print("| {} | {:+.3f} % | {:+.5f} | {} |\n", alpha, 100.0 * e.entries, e.alpha_bias, rms_text(e.alpha));
  }
  fmt::print("\n");
}

void print_lone_fibres() {
  fmt::print(
      "An upright fibre's coverage summed over the pixels across it, in its widths (rays: 1 at every place):\n\n");
  fmt::print("| radius, pixels | least | mean | greatest | RMS of a pixel's |\n| ---: | ---: | ---: | ---: | ---: |\n");
  for (const double radius : {0.05, 0.125, 0.25, 0.5}) {
    const fibre_error e = measure_lone_fibres(radius, 512);
    fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", radius, e.least, e.mean, e.greatest, e.rms);
  }
  fmt::print("\n");
}

void print_transmittance(const subject& s) {
  const frame::stage set = frame::set_up(s.model, s.settings);
  const fibre_rays fibres(set.fibres);
  const lighting scene(set, fibres);
  const shadow_judge rays(scene, 4);
  fmt::print("Light at the places seen, map / rays - 1 (RMS of the difference at a place), {}:\n\n",
             name_of_subject(s));
  fmt::print("| --shadow | --map-size |");
  for (std::size_t i = 0; i < set.lights.size(); ++i)
    fmt::print(" light {0}: fibres | light {0}: opaque objects |", i + 1);
  fmt::print("\n| --- | ---: |");
  for (std::size_t i = 0; i < set.lights.size(); ++i)
    fmt::print(" ---: | ---: |");
  fmt::print("\n");
  const auto row = [&](const char* method, int map_size) {
    const shadow_judge::errors e = rays.errors_of(with_shadow(s.settings, method, map_size));
    fmt::print("| `{}` | {} |", method, map_size != 0 ? map_size : set.light_views.front().width);
    for (std::size_t i = 0; i < e.fibres.size(); ++i) {
      fmt::print(" {:+.2f} % ({:.3f}) | {:+.2f} % ({:.3f}) |", 100.0 * e.fibres[i].ratio, e.fibres[i].rms,
                 100.0 * e.opaque[i].ratio, e.opaque[i].rms);
    }
    fmt::print("\n");
  };
  for (const char* method : shadow_methods)
    row(method, 0);
  for (const int map_size : {128, 256, 512, 1024, 2048}) {
    row("exact", map_size);
    row("k_buffer", map_size);
  }
  fmt::print("\n");
}

void print_split(const subject& s, const judge& rays) {
  const frame_error view = rays.error_of(without_shadows(s.settings));
  const frame_error full = rays.error_of(s.settings);
  fmt::print("RMS of {}, sRGB without rounding, against {} rays a pixel:\n\n", name_of_subject(s), 2 * s.samples);
  fmt::print("| pixels | share | no shadows | of its error | with shadows | of its error |\n");
  fmt::print("| --- | ---: | ---: | ---: | ---: | ---: |\n");
  const auto share = [](double part, double whole) { return whole > 0.0 ? 100.0 * part / whole : 0.0; };
  fmt::print("| all | | {} | | {} | |\n", rms_text(view.all), rms_text(full.all));
  for (std::size_t r = 0; r < region_names.size(); ++r) {
    fmt::print("| {} | {:.1f} % | {} | {:.0f} % | {} | {:.0f} % |\n", region_names[r],
               share(static_cast<double>(view.in[r].count), static_cast<double>(view.all.count)), rms_text(view.in[r]),
               share(view.in[r].sum, view.all.sum), rms_text(full.in[r]), share(full.in[r].sum, full.all.sum));
  }
  fmt::print("| largest difference | | {:.3f} | | {:.3f} | |\n\n", view.largest, full.largest);
}

void print_choices(const subject& s, const judge& rays) {
  fmt::print("RMS of {} by one choice, all else as by default:\n\n", name_of_subject(s));
  fmt::print("| | no shadows | with shadows |\n| --- | ---: | ---: |\n");
  const auto row = [&](const std::string& name, const frame::frame_settings& settings, bool view) {
    const std::string alone = view ? rms_text(rays.error_of(without_shadows(settings)).all) : "";
    fmt::print("| `{}` | {} | {} |\n", name, alone, rms_text(rays.error_of(settings).all));
  };
  for (const int map_size : {128, 256, 512, 1024, 2048})
    row(fmt::format("--map-size {}", map_size), with_shadow(s.settings, "k_buffer", map_size), false);
  for (const char* method : shadow_methods)
    row(fmt::format("--shadow {}", method), with_shadow(s.settings, method, 0), false);
  for (const char* blend : blends) {
    frame::frame_settings settings = s.settings;
    settings.blend = frame::parse_blend(blend);
    row(fmt::format("--blend {}", blend), settings, true);
  }
  for (const std::uint32_t k : {4U, 8U, 16U, 32U, 64U}) {
    frame::frame_settings settings = s.settings;
    settings.k = k;
    row(fmt::format("--k {}", k), settings, true);
  }
  for (const char* tail : {"none", "sliced:4", "sliced:8", "sliced:16"}) {
    frame::frame_settings settings = s.settings;
    settings.tails = frame::parse_tail(tail);
    row(fmt::format("--tail {}", tail), settings, true);
  }
  frame::frame_settings settings = s.settings;
  settings.footprint = pixel_footprint::inscribed;
  row("--footprint inscribed", settings, true);
  settings.footprint = s.settings.footprint;
  settings.shading_spacing = 0.0F;
  row("--shading-spacing 0", settings, true);
  settings.blend = frame::parse_blend("exact");
  settings.shadow = frame::parse_shadow("exact");
  row("--shading-spacing 0 --blend exact --shadow exact", settings, true);
  fmt::print("\n");
}

}  // namespace pelage::truth
