// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT

// The frame renderer against rays.
#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <chrono>
#include <string>

#include "frame/base/input_file.hpp"
#include "frame/base/output_file.hpp"
#include "truth/measure.hpp"

namespace pelage::truth {
namespace {

struct options {
  std::uint32_t strands = 5000;
  std::uint32_t segments = 48;
  int size = 160;
  int samples = 64;
};

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void run(const options& o) {
  double t = now();
  const auto lap = [&](const char* what) {
    fmt::print(stderr, "{}: {:.1f} s\n", what, now() - t);
    t = now();
  };
  const subject s = built_in(o.strands, o.segments, o.size, o.samples);
  lap("model");
  const coverage_error c = measure_coverage(s);
  fmt::print("summed coverage {:+.3f} %, alpha bias {:+.5f}, alpha RMS {:.5f} +- {:.5f}\n", 100 * c.entries,
             c.alpha_bias, c.alpha.rms(), c.alpha.rms_noise());
  lap("coverage");
  const frame::stage set = frame::set_up(s.model, s.settings);
  const fibre_rays fibres(set.fibres);
  lap("BVH");
  const lighting scene(set, fibres);
  const shadow_judge judge(scene, 2);
  lap("true shadows");
  for (const char* method : {"k_buffer", "exact"}) {
    frame::frame_settings settings = s.settings;
    settings.shadow = frame::parse_shadow(method);
    const light_errors errors = judge.judge(settings);
    for (std::size_t i = 0; i < errors.fibres.size(); ++i) {
      fmt::print("{} light {}: fibres {:+.2f} % of {:.4f}, RMS {:.4f}; solids {:+.2f} % of {:.4f}, RMS {:.4f}\n",
                 method, i + 1, 100 * errors.fibres[i].ratio, errors.fibres[i].mean_truth, errors.fibres[i].rms,
                 100 * errors.opaque[i].ratio, errors.opaque[i].mean_truth, errors.opaque[i].rms);
    }
  }
  lap("maps");
  const picture truth = see(scene, s.samples, 1);
  lap("truth");
  for (const bool shadows : {true, false}) {
    frame::frame_settings settings = s.settings;
    settings.shown = shadows ? frame::components::full : frame::components::translucency;
    const frame_error error = compare(draw(s, settings), truth, shadows ? &half_pixel::full : &half_pixel::lit);
    fmt::print("{}: RMS {:.5f} +- {:.5f} largest {:.3f}", shadows ? "full" : "view", error.all.rms(),
               error.all.rms_noise(), error.largest);
    for (std::size_t r = 0; r < region_names.size(); ++r)
      fmt::print("; {}: {:.5f} ({:.0f} % of pixels, {:.0f} % of error)", region_names[r], error.in[r].rms(),
                 100.0 * static_cast<double>(error.in[r].count) / static_cast<double>(error.all.count),
                 100.0 * error.in[r].sum / error.all.sum);
    fmt::print("\n");
  }
  lap("frames");
}

}  // namespace
}  // namespace pelage::truth

int main(int argc, char** argv) {
  CLI::App app{"The frame renderer against rays."};
  pelage::truth::options o;
  app.add_option("--strands", o.strands)->capture_default_str();
  app.add_option("--segments", o.segments)->capture_default_str();
  app.add_option("--size", o.size)->capture_default_str();
  app.add_option("--samples", o.samples)->capture_default_str();
  try {
    app.parse(argc, argv);
    pelage::truth::run(o);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const std::exception& error) {
    fmt::print(stderr, "pelage-truth: {}\n", pelage::frame::printable(error.what()));
    return 2;
  }
  return 0;
}
