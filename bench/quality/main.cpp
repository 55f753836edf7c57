// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT

// How far every visibility structure and every blending is from the sorted truth on real hair: the fragments are those
// of the frame renderer's key light and camera, the truth is each pixel's whole list, sorted. Writes one JSON file;
// figures.py draws it.
#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "frame/base/output_file.hpp"
#include "frame/model/built_in.hpp"
#include "frame/model/load_model.hpp"
#include "frame/scene/opaque_depth.hpp"
#include "frame/stage.hpp"
#include "quality/blending.hpp"
#include "quality/visibility.hpp"

namespace pelage::frame {
namespace {

struct options {
  std::vector<std::string> files;
  std::string out = "quality.json";
  std::uint32_t strands = 10000;
  int size = 512;
  std::string only;  ///< "visibility", "blending" or empty: both
};

/// Measures with the lists of one view.
template <class Measure>
nlohmann::json measure_view(const stage& set, const view& seen, bool antialias, const Measure& measure) {
  const raster fragments(set.fibres, seen, antialias);
  lists all(fragments);
  const std::vector<float> limit = opaque_depths(seen, set.opaque);
  const order_report report = run_order_pass(fragments, limit, {order_method::full_sort, 16, {}}, all);
  if (report.refused > 0) throw std::runtime_error("fragments were refused");
  nlohmann::json by_alpha;
  for (const float alpha : {0.25F, 0.15F, 0.03F})
    by_alpha.push_back(measure(all, alpha));
  return by_alpha;
}

nlohmann::json measure_model(const hair_model& model, const std::string& name, bool on_bust, const options& o) {
  if (model.segment_count() == 0) throw std::runtime_error(printable(name) + ": there are no fibres");
  frame_settings settings;
  settings.width = settings.height = settings.map_size = o.size;
  settings.on_bust = on_bust;
  const stage set = set_up(model, settings);
  nlohmann::json result{{"model", name}, {"strands", model.strand_count()}, {"size", o.size}};
  // Fibres as thin as they are, and as the papers draw them: lines of a pixel's width, whose alpha is never shared.
  for (const bool antialias : {true, false}) {
    nlohmann::json& part = result[antialias ? "thin" : "lines"];
    if (o.only != "blending") {
      part["visibility"] = measure_view(set, set.light_views.front(), antialias, measure_visibility);
    }
    if (o.only == "visibility") continue;
    part["blending"] = measure_view(set, set.eye, antialias, [&](const lists& all, float alpha) {
      return measure_blending(all, set.fibres, alpha);
    });
  }
  return result;
}

void run(const options& o) {
  output_files results;
  results.add(o.out);
  nlohmann::json models;
  models.push_back(measure_model(make_built_in(o.strands, 48, 1), "built-in", true, o));
  for (const std::string& file : o.files)
    models.push_back(measure_model(load_model(file), std::filesystem::path(file).stem().string(), false, o));
  const std::string text = nlohmann::json{{"models", models}}.dump(1) + "\n";
  results.write(o.out, std::as_bytes(std::span(text)));
  results.commit();
}

}  // namespace
}  // namespace pelage::frame

int main(int argc, char** argv) {
  CLI::App app{"Measures the errors of visibility maps and blendings against sorted hair."};
  pelage::frame::options o;
  app.add_option("files", o.files, ".hair or .tfx files to measure after the built-in model");
  app.add_option("--strands", o.strands, "of the built-in model")->capture_default_str();
  app.add_option("--size", o.size, "pixels a side, [2, 4096]")->capture_default_str()->check(CLI::Range(2, 4096));
  app.add_option("--only", o.only, "visibility or blending; without it both")
      ->check(CLI::IsMember({"visibility", "blending"}));
  app.add_option("--out", o.out, "the JSON file")->capture_default_str();
  try {
    app.parse(argc, argv);
    pelage::frame::run(o);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const std::exception& error) {
    fmt::print(stderr, "pelage-quality: {}\n", pelage::frame::printable(error.what()));
    return 2;
  }
  return 0;
}
