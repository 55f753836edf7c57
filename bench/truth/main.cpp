// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT

// The frame renderer against rays through the same fibres: Embree finds where those are entered, and light, opaque
// objects and the pixel's mean are computed in text of their own.
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <functional>
#include <string>

#include "frame/base/output_file.hpp"
#include "truth/gates.hpp"
#include "truth/pictures.hpp"
#include "truth/tables.hpp"

namespace pelage::truth {
namespace {

struct options {
  std::uint32_t strands = 5000;
  std::uint32_t segments = 48;
  int size = 160;
  int samples = 64;
  int rounds = 5;
  std::size_t threads = 2;
  std::string out = "out/truth";

  [[nodiscard]] subject chosen() const { return built_in(strands, segments, size, samples); }
};

void print_frame(const subject& s) {
  const judge rays(s);
  print_split(s, rays);
  print_choices(s, rays);
}

void print_ball(const options& o) {
  const subject s = ball_before_hair(o.size, o.samples);
  fmt::print("A ball before dense hair. ");
  print_split(s, judge(s));
}

std::vector<subject> timed(int samples) {
  return {built_in(5000, 48, 160, 8 * samples), built_in(50000, 48, 320, 2 * samples),
          built_in(50000, 48, 640, samples)};
}

int run(CLI::App& app, int argc, char** argv) {
  options o;
  app.require_subcommand(1);
  app.fallthrough();
  app.add_option("--strands", o.strands, "of the built-in model")->capture_default_str();
  app.add_option("--segments", o.segments, "of each of its strands")->capture_default_str();
  app.add_option("--size", o.size, "pixels a side")->capture_default_str()->check(CLI::Range(8, 4096));
  app.add_option("--samples", o.samples, "rays a pixel in each half of the truth")
      ->capture_default_str()
      ->check(CLI::Range(2, 65536));
  app.add_option("--rounds", o.rounds, "of time, interleaved")->capture_default_str()->check(CLI::Range(1, 1000));
  app.add_option("--threads", o.threads, "of both")->capture_default_str()->check(CLI::Range(1, 1024));
  app.add_option("--out", o.out, "the folder of pictures")->capture_default_str();
  int status = 0;
  const auto add = [&](const char* name, const char* what, std::function<void()> print) {
    app.add_subcommand(name, what)->callback([&o, print = std::move(print)] {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, o.threads);
      print();
    });
  };
  add("coverage", "summed coverage and alpha", [&] { print_coverage(o.chosen()); });
  add("fibre", "a lone upright fibre's coverage", [] { print_lone_fibres(); });
  add("transmittance", "each light at the places seen", [&] { print_transmittance(o.chosen()); });
  add("frame", "the frame's RMS, by part and by choice", [&] { print_frame(o.chosen()); });
  add("split", "the same by part alone", [&] {
    const subject s = o.chosen();
    print_split(s, judge(s));
  });
  add("ball", "the frame's RMS where a ball stands before dense hair", [&] { print_ball(o); });
  add("pictures", "both pictures of hair and of the ball before hair", [&] {
    save_pictures(o.chosen(), o.out, "hair");
    save_pictures(ball_before_hair(o.size, o.samples), o.out, "ball");
  });
  add("time", "seconds of rays for the frame's RMS; smaller pictures have more samples",
      [&] { print_times(timed(o.samples), o.rounds); });
  add("gates", "whether the frame keeps its bounds; exits 1 if not", [&] { status = check_gates() ? 0 : 1; });
  app.parse(argc, argv);
  return status;
}

}  // namespace
}  // namespace pelage::truth

int main(int argc, char** argv) {
  CLI::App app{"The frame renderer against rays through the same fibres."};
  try {
    return pelage::truth::run(app, argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const std::exception& error) {
    fmt::print(stderr, "pelage-truth: {}\n", pelage::frame::printable(error.what()));
    return 2;
  }
}
