// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "frame/blends/blend_choice.hpp"
#include "truth/draws.hpp"
#include "truth/tables.hpp"

namespace pelage::truth {
namespace {

constexpr int most_samples = 4096;

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Seconds by the clock, and of all threads' work: the second hardly depends on what else the machine does.
struct spent {
  double seconds;
  double processor_seconds;
};

template <class Work>
spent time_spent(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t worked = std::clock();
  work();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          static_cast<double>(std::clock() - worked) / static_cast<double>(CLOCKS_PER_SEC)};
}

spent median(const std::vector<spent>& all) {
  std::vector<double> seconds;
  std::vector<double> processor_seconds;
  for (const spent& s : all) {
    seconds.push_back(s.seconds);
    processor_seconds.push_back(s.processor_seconds);
  }
  return {median(seconds), median(processor_seconds)};
}

/// Samples whose mean has a mean square error: between two numbers of samples the error is taken to fall as a power.
struct error_at {
  double samples;
  double square;
};
double samples_for(double square, const error_at& before, const error_at& after) {
  const double slope = std::log(after.square / before.square) / std::log(after.samples / before.samples);
  return before.samples * std::pow(square / before.square, 1.0 / slope);
}

struct timing {
  spent frame;
  spent sample;
  double samples;
};

/// Frames and samples in turns, twice as many samples each round, until the error is below the frame's.
timing race(const subject& s, const frame::frame_settings& settings, const judge& rays, double frame_square,
            int rounds) {
  drawn_by_rays drawn(rays.scene());
  std::vector<spent> frames;
  std::vector<spent> draws;
  std::vector<error_at> errors;
  for (int round = 0; round < rounds || errors.back().square > frame_square; ++round) {
    if (drawn.samples() >= most_samples) break;
    frames.push_back(time_spent([&] { (void)draw(s, settings); }));
    const int samples = std::max(1, drawn.samples());
    const spent all = time_spent([&] { drawn.add(samples); });
    draws.push_back({all.seconds / samples, all.processor_seconds / samples});
    errors.push_back(
        {static_cast<double>(drawn.samples()), rays.error_of(drawn.mean(), frame::components::full).all.mean_square()});
  }
  const auto reached =
      std::find_if(errors.begin() + 1, errors.end() - 1, [&](const error_at& e) { return e.square <= frame_square; });
  return {median(frames), median(draws), samples_for(frame_square, *(reached - 1), *reached)};
}

}  // namespace

void print_times(const std::vector<subject>& subjects, int rounds) {
  fmt::print("Seconds for the frame's RMS, medians, interleaved; Embree's hierarchy apart:\n\n");
  fmt::print(
      "| strands | size | --tail | frame's RMS | frame, s | samples a pixel | a sample, s | rays, s | rays / frame | "
      "by "
      "processor "
      "time | hierarchy, s |\n");
  fmt::print("| ---: | ---: | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  for (const subject& s : subjects) {
    const judge rays(s);
    for (const char* const tail : {"mean", "sliced:16"}) {
      frame::frame_settings settings = s.settings;
      settings.tails = frame::parse_tail(tail);
      const squared_error error = rays.error_of(settings).all;
      const timing t = race(s, settings, rays, error.mean_square(), std::max(rounds, 3));
      fmt::print("| {} | {} | `{}` | {:.5f} | {:.3f} | {:.1f} | {:.3f} | {:.2f} | {:.1f}× | {:.1f}× | {:.2f} |\n",
                 s.model.strand_count(), settings.width, tail, error.rms(), t.frame.seconds, t.samples,
                 t.sample.seconds, t.samples * t.sample.seconds, t.samples * t.sample.seconds / t.frame.seconds,
                 t.samples * t.sample.processor_seconds / t.frame.processor_seconds,
                 rays.scene().fibres().build_seconds());
      std::fflush(stdout);
    }
  }
  fmt::print("\n");
}

}  // namespace pelage::truth
