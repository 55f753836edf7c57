// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <charconv>
#include <cstring>
#include <filesystem>
#include <map>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>

#include "frame/built_in.hpp"
#include "frame/follow_strands.hpp"
#include "frame/frame.hpp"
#include "frame/hair_file.hpp"
#include "frame/input_file.hpp"
#include "frame/output_file.hpp"
#include "frame/tfx_file.hpp"

namespace {

using namespace pelage::frame;

const std::map<std::string, order_method> order_names{{"k_buffer", order_method::k_buffer},
                                                      {"a_buffer", order_method::a_buffer},
                                                      {"ordered_list", order_method::ordered_list},
                                                      {"atomic_k_buffer", order_method::atomic_k_buffer},
                                                      {"selection_sort", order_method::selection_sort},
                                                      {"full_sort", order_method::full_sort}};
const std::map<std::string, components> component_names{{"single", components::single},
                                                        {"shadows", components::shadows},
                                                        {"translucency", components::translucency},
                                                        {"full", components::full}};

template <class Value>
std::vector<std::string> names(const std::map<std::string, Value>& all) {
  std::vector<std::string> list;
  for (const auto& [name, value] : all)
    list.push_back(name);
  return list;
}

struct command_line {
  std::string hair;
  std::uint32_t follow = 0;
  float follow_radius = 0.0F;
  std::uint32_t strands = 50000;
  std::uint32_t segments = 48;
  std::uint64_t seed = 1;
  std::string size = "640x640";
  std::vector<std::string> lights;
  std::vector<float> from;
  std::string order = "k_buffer";
  std::string components = "full";
  std::string antialias = "on";
  int threads = 0;
  std::string out = "out/frame.png";
  std::string report;
  std::string compare;
  frame_settings settings;
};

void parse(CLI::App& app, command_line& c, int argc, char** argv) {
  CLI::Option* hair = app.add_option("--hair", c.hair, "a .hair or .tfx file; without it the built-in model is drawn");
  app.add_option("--follow", c.follow, "follow strands for each strand of the file")
      ->check(CLI::Range(0, 4096))
      ->needs(hair);
  app.add_option("--follow-radius", c.follow_radius, "how far they spread, model units; 0: 0.6 % of the model's size")
      ->check(CLI::Range(0.0, 1e12))
      ->needs(hair);
  app.add_option("--strands", c.strands, "of the built-in model")->excludes(hair)->capture_default_str();
  app.add_option("--segments", c.segments, "of each strand of the built-in model")
      ->excludes(hair)
      ->capture_default_str();
  app.add_option("--seed", c.seed, "of the built-in model and of follow strands")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--size", c.size, "WIDTHxHEIGHT or SIDE, pixels")->capture_default_str();
  app.add_option("--map-size", c.settings.map_size,
                 "side of each light's map, texels; 0: as the picture, at most 2048");
  app.add_option("--k", c.settings.k, "fragments kept a pixel and texel: 1, 2, 4, 8, 16, 32 or 64")
      ->check(CLI::IsMember({1, 2, 4, 8, 16, 32, 64}))
      ->capture_default_str();
  app.add_option("--order", c.order, "how fragments are put in order")
      ->check(CLI::IsMember(names(order_names)))
      ->capture_default_str();
  app.add_option("--components", c.components, "what is drawn")
      ->check(CLI::IsMember(names(component_names)))
      ->capture_default_str();
  app.add_option("--aa", c.antialias, "anti-aliasing, on or off")->check(CLI::IsMember({"on", "off"}));
  app.add_option("--alpha", c.settings.opacity, "opacity of all fibres, [0, 1]; else the model's")
      ->check(CLI::Range(0.0, 1.0));
  app.add_option("--fibre-radius", c.settings.fibre_radius, "of all fibres, model units; else the model's")
      ->check(CLI::Range(0.0, 1e12));
  app.add_option("--lights", c.lights,
                 "directional:X,Y,Z:R,G,B, point:X,Y,Z:R,G,B or spot:X,Y,Z:R,G,B:DEGREES, any number; positions in "
                 "radii of the model round its centre");
  app.add_option("--from", c.from, "AZIMUTH,ELEVATION of the camera, degrees; else where the hair is seen best")
      ->delimiter(',')
      ->expected(2);
  app.add_option("--threads", c.threads, "0: one a core")->check(CLI::Range(0, 1024));
  app.add_option("--shuffle", c.settings.shuffle, "draw segments in an order of this seed; the picture is the same")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--out", c.out, "the picture, PNG")->capture_default_str();
  app.add_option("--report", c.report, "a JSON file for times, counts and memory");
  app.add_option("--compare", c.compare, "a PNG to compare with; writes an error map beside --out");
  app.parse(argc, argv);
}

/// Reads all of "640x480" or "640".
void read_size(const std::string& text, frame_settings& settings) {
  const auto number = [&](const std::string& part) {
    int value = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc() || end != part.data() + part.size() || value < 1 || value > 16384) {
      throw std::invalid_argument(fmt::format("--size '{}': sides must be whole numbers in [1, 16384]", text));
    }
    return value;
  };
  const std::size_t cross = text.find('x');
  settings.width = number(text.substr(0, cross));
  settings.height = cross == std::string::npos ? settings.width : number(text.substr(cross + 1));
}

/// The two formats are told apart by what they begin with: a .tfx has a version number there.
bool begins_as_hair(const std::string& path) {
  const input_file file(path);
  return file.size() < 4 || std::memcmp(file.bytes().data(), "HAIR", 4) == 0;
}

hair_model load(const command_line& c) {
  if (c.hair.empty()) return make_built_in(c.strands, c.segments, c.seed);
  hair_model model = begins_as_hair(c.hair) ? load_hair(c.hair) : load_tfx(c.hair);
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

nlohmann::json report_of(const command_line& c, const hair_model& model, const frame_result& frame) {
  nlohmann::json passes = nlohmann::json::array();
  for (const pass_report& p : frame.passes) {
    passes.push_back({{"name", p.name},
                      {"prepare_seconds", p.prepare_seconds},
                      {"bin_seconds", p.order.bin_seconds},
                      {"build_seconds", p.order.build_seconds},
                      {"resolve_seconds", p.order.resolve_seconds},
                      {"fragments", p.order.fragments},
                      {"longest_list", p.order.longest},
                      {"refused", p.order.refused},
                      {"structure_bytes", p.order.bytes},
                      {"result_bytes", p.bytes}});
  }
  return {{"strands", model.strand_count()},
          {"segments", model.segment_count()},
          {"width", c.settings.width},
          {"height", c.settings.height},
          {"order", c.order},
          {"components", c.components},
          {"k", c.settings.k},
          {"seconds", frame.seconds},
          {"peak_bytes", peak_memory()},
          {"passes", passes}};
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

void run(command_line& c) {
  read_size(c.size, c.settings);
  c.settings.order = order_names.at(c.order);
  c.settings.shown = component_names.at(c.components);
  c.settings.antialias = c.antialias == "on";
  c.settings.on_bust = c.hair.empty();
  for (const std::string& text : c.lights)
    c.settings.lights.push_back(parse_light(text));
  if (!c.from.empty()) c.settings.from = glm::vec2(c.from[0], c.from[1]);
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
  const hair_model model = arena.execute([&] { return load(c); });
  const frame_result frame = arena.execute([&] { return draw_frame(model, c.settings, show_progress); });
  nlohmann::json report = report_of(c, model, frame);
  report["threads"] = threads;

  std::string said =
      fmt::format("{}: {} strands, {} segments, {:.2f} s, {:.0f} MB at most\n", printable(out), model.strand_count(),
                  model.segment_count(), frame.seconds, static_cast<double>(peak_memory()) / 1e6);
  results.write(out, encode_png(frame.picture));
  if (other) {
    const image_difference difference = compare(frame.picture, *other);
    report["rms"] = difference.rms;
    report["maximum"] = difference.maximum;
    results.write(error_picture, encode_png(error_map(frame.picture, *other)));
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
  command_line c;
  try {
    parse(app, c, argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return fail(error.what());
  }
  try {
    run(c);
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory for this model and size");
  } catch (const std::exception& error) {
    return fail(error.what());
  }
  return 0;
}
