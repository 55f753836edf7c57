// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/command_line.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <vector>

#include "frame/look_options.hpp"
#include "frame/option_names.hpp"

namespace pelage::frame {
namespace {

const std::map<std::string, order_method> order_names{{"k_buffer", order_method::k_buffer},
                                                      {"a_buffer", order_method::a_buffer},
                                                      {"unrolled_list", order_method::unrolled_list},
                                                      {"ordered_list", order_method::ordered_list},
                                                      {"atomic_k_buffer", order_method::atomic_k_buffer},
                                                      {"split_k_buffer", order_method::split_k_buffer},
                                                      {"partial_selection_sort", order_method::partial_selection_sort},
                                                      {"selection_sort", order_method::selection_sort},
                                                      {"full_sort", order_method::full_sort}};
const std::map<std::string, components> component_names{{"single", components::single},
                                                        {"shadows", components::shadows},
                                                        {"translucency", components::translucency},
                                                        {"full", components::full}};
const std::map<std::string, primitive> primitive_names{{"segment", primitive::segment}, {"line", primitive::line}};
const std::map<std::string, pixel_footprint> footprint_names{{"inscribed", pixel_footprint::inscribed},
                                                             {"equal_area", pixel_footprint::equal_area},
                                                             {"yu", pixel_footprint::yu}};

const std::map<std::string, map_lookup> lookup_names{{"filtered", map_lookup::filtered},
                                                     {"jittered", map_lookup::jittered}};

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

/// Refuses the options that have no meaning on what draws.
void check_drawn_on(bool device, const CLI::Option* spacing, float pixels, const CLI::Option* frames, bool moves) {
  if (device && spacing->count() > 0 && pixels != std::numeric_limits<float>::infinity()) {
    throw std::invalid_argument("--shading-spacing: --device vulkan shades the ends of segments alone, as inf does");
  }
  if (!device && !moves && frames->count() > 0) {
    throw std::invalid_argument("--frames needs --device vulkan, --turn or --sway");
  }
}

}  // namespace

command_line parse_command_line(CLI::App& app, int argc, char** argv) {
  command_line c;
  frame_settings& s = c.settings;
  std::string size = "640x640";
  std::string order = name_of(s.order);
  std::string shown = name_of(s.shown);
  std::string antialias = "on";
  std::string footprint = name_in(footprint_names, s.footprint);
  std::string lookup = name_in(lookup_names, s.lookup);
  std::string drawn = name_in(primitive_names, s.drawn);
  std::string device = "cpu";
  std::vector<std::string> lights;
  std::vector<float> from;
  std::vector<float> ambient;

  CLI::Option* hair = app.add_option("--hair", c.hair, "a .hair or .tfx file; without it the built-in model is drawn");
  app.add_option("--follow", c.follow, "follow strands for each strand of the file")
      ->check(CLI::Range(0, 4096))
      ->needs(hair);
  app.add_option("--follow-radius", c.follow_radius, "how far they spread, model units; 0: 0.6 % of the model's size")
      ->check(CLI::Range(0.0, 1e12))
      ->needs(hair);
  CLI::Option* interpolate =
      app.add_option("--interpolate", c.interpolate, "strands between neighbouring guides for each strand of the file")
          ->check(CLI::Range(0, 4096))
          ->needs(hair);
  app.add_option("--clump", c.clump, "how far their tips are drawn to that strand, [0, 1]; 0: not, 1: to its tip")
      ->check(CLI::Range(0.0, 1.0))
      ->needs(interpolate)
      ->capture_default_str();
  app.add_option("--strands", c.strands, "of the built-in model")->excludes(hair)->capture_default_str();
  app.add_option("--segments", c.segments, "of each strand of the built-in model")
      ->excludes(hair)
      ->capture_default_str();
  app.add_option("--seed", c.seed,
                 "of the built-in model, of follow and interpolated strands and of stochastic blending")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--size", size, "WIDTHxHEIGHT or SIDE, pixels")->capture_default_str();
  app.add_option("--map-size", s.map_size, "side of each light's map, texels; 0: as the picture, at most 2048");
  app.add_option("--k", s.k, "fragments kept a pixel and texel: 1, 2, 4, 8, 16, 32 or 64")
      ->check(CLI::IsMember({1, 2, 4, 8, 16, 32, 64}))
      ->capture_default_str();
  app.add_option("--order", order, "how fragments are put in order")
      ->check(CLI::IsMember(names(order_names)))
      ->capture_default_str();
  app.add_option(
         "--shadow", c.shadow,
         "what a light's map keeps: k_buffer, occupancy, opacity:N, deep_opacity:N or deep_opacity_growing:N "
         "with N layers, 4, 8 ... 256, deep:ERR with the greatest error, or exact; --k and --order are k_buffer's")
      ->capture_default_str();
  app.add_option(
         "--lookup", lookup,
         "how fibres read the lights' maps: filtered, the mean of four texels, or jittered, one of a place moved by "
         "up to half a texel")
      ->check(CLI::IsMember(names(lookup_names)))
      ->capture_default_str();
  app.add_option(
         "--blend", c.blend,
         "how fragments become a pixel: k_buffer, exact, order_weighted, weighted_average, weighted_blended, "
         "deep_opacity:N or deep_opacity_corrected:N with N layers, 4, 8 ... 256, depth_peeling, stochastic:N with "
         "N samples, 1, 2, 4 ... 64, sliced:N or sliced_clipped:N with N slices, 8, 16 ... 1024, else 256, moments:N "
         "with N power moments, 4 or 6, trigonometric:N with 2 or 3, or layers:N with N layers, 1, 2, 4 ... 32; --k "
         "and --order are k_buffer's")
      ->capture_default_str();
  CLI::Option* tail =
      app.add_option(
             "--tail", c.tail,
             "what k_buffer's blending keeps of what is not among the K nearest: mean, none, or sliced:N for the "
             "mean of each of N slices of depth, 2, 4, 8 ... 64, on the CPU alone")
          ->capture_default_str();
  app.add_option("--components", shown, "what is drawn")
      ->check(CLI::IsMember(names(component_names)))
      ->capture_default_str();
  CLI::Option* spacing =
      app.add_option("--shading-spacing", s.shading_spacing,
                     "pixels between the places of a segment that are shaded; 0: each fragment is; --device vulkan "
                     "shades the ends alone, as inf does")
          ->check(CLI::Range(0.0F, std::numeric_limits<float>::infinity()))
          ->capture_default_str();
  std::string fibre_colours = "model";
  app.add_option("--fibre-colours", fibre_colours, "model, or random: a colour a strand, so that a wrong order shows")
      ->check(CLI::IsMember({"model", "random"}))
      ->capture_default_str();
  app.add_option("--aa", antialias, "anti-aliasing, on or off")->check(CLI::IsMember({"on", "off"}));
  app.add_option("--alpha", s.opacity, "opacity of all fibres, [0, 1]; else the model's")->check(CLI::Range(0.0, 1.0));
  app.add_option("--footprint", footprint, "the disc that stands for an anti-aliased pixel of the camera")
      ->check(CLI::IsMember(names(footprint_names)))
      ->capture_default_str();
  app.add_option("--primitive", drawn, "how segments become fragments: by exact coverage or as one-pixel lines")
      ->check(CLI::IsMember(names(primitive_names)))
      ->capture_default_str();
  look_options look;
  add_look_options(app, look, s.look);
  app.add_option("--fibre-radius", s.fibre_radius, "of all fibres, model units; else the model's")
      ->check(CLI::Range(0.0, 1e12));
  app.add_option("--lights", lights,
                 "directional:X,Y,Z:R,G,B, point:X,Y,Z:R,G,B or spot:X,Y,Z:R,G,B:DEGREES, any number; positions in "
                 "radii of the model round its centre");
  app.add_option("--ambient", ambient,
                 "R,G,B, or one number for all: light from all sides that nothing shadows, [0, 1e6]")
      ->delimiter(',')
      ->expected(1, 3)
      ->check(CLI::Range(0.0, 1e6));
  app.add_option("--from", from, "AZIMUTH,ELEVATION of the camera, degrees; else where the hair is seen best")
      ->delimiter(',')
      ->expected(2);
  app.add_option("--distance", s.distance, "of the camera, in distances from which it just sees all hair")
      ->check(CLI::Range(0.5, 1000.0))
      ->capture_default_str();
  app.add_option("--threads", c.threads, "0: one a core")->check(CLI::Range(0, 1024));
  app.add_option("--device", device, "what draws: cpu or vulkan")
      ->check(CLI::IsMember({"cpu", "vulkan"}))
      ->capture_default_str();
  app.add_option("--segment-error", s.detail.segment,
                 "neighbouring segments that stay within so many pixels in every view are drawn as one; 0: none are")
      ->check(CLI::Range(0.0F, 64.0F))
      ->capture_default_str();
  app.add_option(
         "--strand-error", s.detail.strand,
         "of strands thinner than so many pixels in every view some are drawn, wider, for all; 0: all are drawn")
      ->check(CLI::Range(0.0F, 64.0F))
      ->capture_default_str();
  app.add_option("--crowd", s.crowd, "copies of the model that stand in rows")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  CLI::Option* frames =
      app.add_option("--frames", c.frames,
                     "drawn by --device vulkan, whose report has their median times, or of --turn or --sway")
          ->check(CLI::Range(1, 100000));
  CLI::Option* sway = app.add_option("--sway", s.sway,
                                     "a wind that moves the hair from frame to frame, 1/30 s each: how far tips move, "
                                     "in shares of the longest strand's reach")
                          ->check(CLI::Range(0.0, 1.0));
  CLI::Option* turn =
      app.add_option("--turn", c.turn, "how far the camera goes round the model from frame to frame, degrees")
          ->check(CLI::Range(-360.0, 360.0))
          ->excludes(sway);
  app.add_option("--shuffle", s.shuffle, "draw segments in an order of this seed; the picture is the same")
      ->check(CLI::NonNegativeNumber);
  app.add_option("--out", c.out, "the picture, PNG")->capture_default_str();
  app.add_option("--report", c.report, "a JSON file for times, counts and memory");
  app.add_option("--compare", c.compare, "a PNG to compare with; writes an error map beside --out");
  app.parse(argc, argv);

  read_size(size, s);
  s.order = order_names.at(order);
  s.shadow = parse_shadow(c.shadow);
  s.blend = parse_blend(c.blend);
  s.blend.seed = static_cast<std::uint32_t>(c.seed ^ (c.seed >> 32U));
  s.tails = parse_tail(c.tail);
  s.shown = component_names.at(shown);
  s.antialias = antialias == "on";
  s.footprint = footprint_names.at(footprint);
  s.lookup = lookup_names.at(lookup);
  s.drawn = primitive_names.at(drawn);
  read_look(look, s.look);
  s.on_bust = c.hair.empty();
  c.random_colours = fibre_colours == "random";
  c.on_device = device == "vulkan";
  if (tail->count() > 0 && s.blend.method != blend_method::k_buffer) {
    throw std::invalid_argument("--tail needs --blend k_buffer");
  }
  if (c.on_device && s.tails > 1) throw std::invalid_argument("--tail: --device vulkan keeps the mean or none");
  check_drawn_on(c.on_device, spacing, s.shading_spacing, frames, turn->count() + sway->count() > 0);
  if (std::isnan(c.turn)) throw std::invalid_argument("--turn must be in [-360, 360] degrees");
  for (const std::string& text : lights)
    s.lights.push_back(parse_light(text));
  if (ambient.size() == 2) throw std::invalid_argument("--ambient takes R,G,B or one number");
  if (!ambient.empty()) s.ambient = {ambient.front(), ambient[ambient.size() / 2], ambient.back()};
  if (!from.empty()) s.from = glm::vec2(from[0], from[1]);
  return c;
}

std::string name_of(order_method method) {
  return name_in(order_names, method);
}

std::string name_of(components shown) {
  return name_in(component_names, shown);
}

}  // namespace pelage::frame
