// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "frame/base/output_file.hpp"
#include "frame/command_line.hpp"
#include "frame/frame.hpp"
#include "frame/look_options.hpp"
#include "frame/model/built_in.hpp"
#include "frame/model/follow_strands.hpp"
#include "frame/model/interpolated_strands.hpp"
#include "frame/model/load_model.hpp"
#include "frame/model/random_colours.hpp"
#include "frame/vulkan/device_frame.hpp"

namespace {

using namespace pelage::frame;

hair_model load(const command_line& c) {
  if (c.hair.empty()) return make_built_in(c.strands, c.segments, c.seed);
  hair_model model = load_model(c.hair);
  if (c.interpolate > 0) model = add_interpolated_strands(model, c.interpolate, c.clump, c.seed);
  if (c.follow == 0) return model;
  const box bounds = model.bounds();
  const float size = bounds.empty() ? 1.0F : glm::length(bounds.upper - bounds.lower);
  return add_follow_strands(model, c.follow, c.follow_radius != 0.0F ? c.follow_radius : 0.006F * size, c.seed);
}

std::uint64_t peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024U;
}

/// What a report says of any frame.
nlohmann::json report_of(const command_line& c, const hair_model& model) {
  return {{"strands", model.strand_count()},
          {"segments", model.segment_count()},
          {"width", c.settings.width},
          {"height", c.settings.height},
          {"order", name_of(c.settings.order)},
          {"shadow", c.shadow},
          {"blend", c.blend},
          {"components", name_of(c.settings.shown)},
          {"bsdf", name_of(c.settings.look.model)},
          {"attenuation", c.settings.look.passing == attenuation::fresnel ? "fresnel" : "constant"},
          {"segment_error", c.settings.detail.segment},
          {"strand_error", c.settings.detail.strand},
          {"crowd", c.settings.crowd},
          {"k", c.settings.k},
          {"sway", c.settings.sway}};
}

nlohmann::json report_of(const drawn_report& drawn) {
  return {{"strands_drawn", drawn.strands},
          {"segments_drawn", drawn.segments},
          {"detail_seconds", drawn.detail_seconds},
          {"slice_sorts", drawn.sorts},
          {"slice_sort_seconds", drawn.sort_seconds}};
}

nlohmann::json report_of(const frame_result& frame) {
  nlohmann::json passes = nlohmann::json::array();
  for (const pass_report& p : frame.passes) {
    passes.push_back({{"name", p.name},
                      {"prepare_seconds", p.prepare_seconds},
                      {"shade_seconds", p.shade_seconds},
                      {"bin_seconds", p.order.bin_seconds},
                      {"build_seconds", p.order.build_seconds},
                      {"resolve_seconds", p.order.resolve_seconds},
                      {"fragments", p.order.fragments},
                      {"longest_list", p.order.longest},
                      {"tail_fragments", p.order.behind},
                      {"refused", p.order.refused},
                      {"structure_bytes", p.order.bytes},
                      {"result_bytes", p.bytes}});
  }
  return {{"seconds", frame.seconds}, {"passes", passes}};
}

nlohmann::json report_of(const device_frame& frame) {
  nlohmann::json passes = nlohmann::json::array();
  for (const device_frame::pass& p : frame.passes)
    passes.push_back({{"view", p.view}, {"name", p.name}, {"milliseconds", p.milliseconds}});
  nlohmann::json views = nlohmann::json::array();
  for (const device_frame::fragments& v : frame.views)
    views.push_back({{"fragments", v.offered}, {"longest_list", v.longest}, {"refused", v.refused}});
  return {{"device", frame.device},
          {"milliseconds", frame.milliseconds},
          {"frames", frame.frames},
          {"same_hash", frame.same},
          {"hash", fmt::format("{:016x}", frame.hash)},
          {"device_bytes", frame.bytes},
          {"redrawn", frame.redrawn},
          {"views", views},
          {"passes", passes}};
}

/// Of all passes: fragments, and those of them that went to tails.
std::pair<std::uint64_t, std::uint64_t> count_fragments(const frame_result& frame) {
  std::pair<std::uint64_t, std::uint64_t> sum{0, 0};
  for (const pass_report& p : frame.passes) {
    sum.first += p.order.fragments;
    sum.second += p.order.behind;
  }
  return sum;
}

/// What is drawn of a model, where that is not all of it once.
std::string drawn_in(const command_line& c, const drawn_report& drawn) {
  if (c.settings.crowd == 1 && !c.settings.detail.any()) return {};
  return fmt::format("{} strands and {} segments drawn, ", drawn.strands, drawn.segments);
}

/// Linear red, green and blue, as they are before they become 8 bits.
std::array<double, 3> mean_of(const image& picture) {
  glm::dvec3 sum(0.0);
  for (const glm::vec3& p : picture.pixels)
    sum += glm::dvec3(p);
  sum /= static_cast<double>(picture.pixels.size());
  return {sum.x, sum.y, sum.z};
}

void show_progress(const std::string& what, double done) {
  if (isatty(STDERR_FILENO) == 0) return;
  const int filled = static_cast<int>(done * 30.0);
  fmt::print(stderr, "\r[{:<30}] {:<10}{}", std::string(static_cast<std::size_t>(filled), '#'), what,
             done < 1.0 ? "" : "\n");
}

int fail(const std::string& fault) {
  if (isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\r\033[K");  // over the progress bar
  fmt::print(stderr, "pelage-frame: {}\n", printable(fault));      // one line, whatever names it has
  return 2;
}

/// The picture to compare with, if any; refused before the work if it is of another size.
std::optional<image> load_other(const command_line& c) {
  if (c.compare.empty()) return std::nullopt;
  image other = load_png(c.compare);
  if (other.width != c.settings.width || other.height != c.settings.height) {
    throw std::invalid_argument(fmt::format("{}: {} x {} pixels, but the frame has {} x {}", printable(c.compare),
                                            other.width, other.height, c.settings.width, c.settings.height));
  }
  return other;
}

void run(const command_line& c) {
  const std::size_t threads = static_cast<std::size_t>(c.threads > 0 ? c.threads : tbb::info::default_concurrency());
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);

  const std::filesystem::path out = c.out;
  std::filesystem::path error_picture = out;
  error_picture.replace_extension(".error.png");
  const std::optional<image> other = load_other(c);
  if (other && std::filesystem::weakly_canonical(c.compare) == std::filesystem::weakly_canonical(error_picture)) {
    throw std::invalid_argument(printable(c.compare) + ": the error map would take its name");
  }
  output_files results;
  results.add(out);
  if (other) results.add(error_picture);
  if (!c.report.empty()) results.add(c.report);

  tbb::task_arena arena(static_cast<int>(threads));  // may be more than there are cores
  hair_model model = arena.execute([&] { return load(c); });
  if (c.random_colours) set_random_colours(model);
  nlohmann::json report = report_of(c, model);
  image picture;
  std::string said =
      fmt::format("{}: {} strands, {} segments, ", printable(out), model.strand_count(), model.segment_count());
  if (c.on_device) {
    device_frame frame = draw_frame_on_device(model, c.settings, c.frames, c.turn);
    report.update(report_of(frame));
    report.update(report_of(frame.drawn));
    said += drawn_in(c, frame.drawn);
    said +=
        fmt::format("{:.3f} ms on {}, {} of {} frames are {}{:016x}\n", frame.milliseconds, frame.device, frame.same,
                    frame.frames, c.settings.sway > 0.0F ? "the same when drawn again, all together " : "", frame.hash);
    picture = std::move(frame.picture);
  } else {
    frame_result frame = arena.execute([&] { return draw_turn(model, c.settings, c.frames, c.turn, show_progress); });
    report.update(report_of(frame));
    report.update(report_of(frame.drawn));
    report["threads"] = threads;
    const auto [fragments, behind] = count_fragments(frame);
    said += drawn_in(c, frame.drawn);
    said += fmt::format("{:.2f} s, {:.0f} MB at most, {:.1f} million fragments, {:.1f} million of them in tails\n",
                        frame.seconds, static_cast<double>(peak_memory()) / 1e6, static_cast<double>(fragments) / 1e6,
                        static_cast<double>(behind) / 1e6);
    picture = std::move(frame.picture);
  }
  report["peak_bytes"] = peak_memory();
  results.write(out, encode_png(picture));
  report["mean"] = mean_of(picture);
  if (other) {
    const image_difference difference = compare(picture, *other);
    report["rms"] = difference.rms;
    report["maximum"] = difference.maximum;
    results.write(error_picture, encode_png(error_map(picture, *other)));
    said += fmt::format("{}: RMS {:.5f}, maximum {:.5f} of {}\n", printable(error_picture), difference.rms,
                        difference.maximum, printable(c.compare));
  }
  if (!c.report.empty()) {
    const std::string text = report.dump(2) + "\n";
    results.write(c.report, std::as_bytes(std::span(text)));
  }
  results.commit();
  fmt::print("{}", said);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Draws hair with the pelage headers: sorted translucency, self-shadowing, anti-aliasing."};
  try {
    run(parse_command_line(app, argc, argv));
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory for this model and size");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
  return 0;
}
