// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT

// How far every visibility structure and every blending is from the sorted truth on real hair: the fragments are those
// of the frame renderer, the truth is each pixel's whole list, sorted. Writes one JSON file; figures.py draws it. Times are bench/visibility's.
#include <pelage/composite/order_weighted.hpp>
#include <pelage/composite/radiance.hpp>
#include <pelage/composite/stochastic.hpp>
#include <pelage/composite/weighted_average.hpp>
#include <pelage/composite/weighted_blended.hpp>
#include <pelage/core/mixed_bits.hpp>
#include <pelage/visibility/deep_shadow_map.hpp>
#include <pelage/visibility/density_clusters.hpp>
#include <pelage/visibility/depth_range.hpp>
#include <pelage/visibility/occupancy_batch.hpp>
#include <pelage/visibility/occupancy_map.hpp>
#include <pelage/visibility/opacity_map.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "frame/built_in.hpp"
#include "frame/bust.hpp"
#include "frame/hair_file.hpp"
#include "frame/lights.hpp"
#include "frame/opaque_depth.hpp"
#include "frame/order_pass.hpp"
#include "frame/output_file.hpp"
#include "frame/strands.hpp"
#include "frame/tfx_file.hpp"

namespace pelage::frame {
namespace {

/// One fragment of a pixel's sorted list.
struct sample {
  float depth;
  float coverage;
  std::uint32_t id;
};

/// Every pixel's whole list, nearest first.
class lists final : public pixel_visitor {
 public:
  explicit lists(const raster& from) : from_(from) {}

  void expect(std::span<const std::uint32_t> fragments_per_pixel) override {
    first_.assign(1, 0);
    for (const std::uint32_t n : fragments_per_pixel) first_.push_back(first_.back() + n);
    all_.resize(first_.back());
  }
  void lose(int, int, std::span<const seen_fragment>, tail&) override {}
  void finish(int x, int y, std::span<const seen_fragment> nearest, const tail&) override {
    sample* out = all_.data() + first_[static_cast<std::size_t>(y * from_.from().width + x)];
    for (const auto& [segment, where] : nearest) *out++ = {where.depth, where.coverage, segment};
  }

  [[nodiscard]] std::size_t pixels() const { return first_.size() - 1; }
  [[nodiscard]] std::size_t fragments() const { return all_.size(); }
  [[nodiscard]] std::span<const sample> of(std::size_t pixel) const {
    return std::span(all_).subspan(first_[pixel], first_[pixel + 1] - first_[pixel]);
  }

 private:
  const raster& from_;
  std::vector<std::size_t> first_;
  std::vector<sample> all_;
};

/// What all texels of a map share, and one texel's fragments.
struct texel {
  std::span<const sample> list;
  std::vector<std::uint32_t> optical;  ///< of each fragment
  depth_range range;                   ///< of the texel
  depth_range whole;                   ///< of the map
  float extent;                        ///< of deep opacity layers together
};

/// A visibility structure under test: fills `passed` with its transmittance before each of some depths.
struct method {
  std::string name;
  std::size_t bytes;  ///< a texel; deep shadow maps: 0, counted in `vertices`
  void (*estimate)(const texel&, std::span<const float> depths, std::span<float> passed, std::uint64_t& vertices);
};

float passed_by(float optical) { return fast_exp2(-optical * (1.0F / 1048576.0F)); }

template <class Map, class Position>
void estimate_by(const texel& t, std::span<const float> depths, std::span<float> passed, Position position) {
  Map map = Map::empty();
  for (std::size_t i = 0; i < t.list.size(); ++i) map.add(position(t.list[i].depth), t.optical[i]);
  for (std::size_t i = 0; i < depths.size(); ++i) passed[i] = passed_by(map.amount_before(position(depths[i])));
}

void by_occupancy(const texel& t, std::span<const float> depths, std::span<float> passed, std::uint64_t&) {
  estimate_by<occupancy_map<>>(t, depths, passed,
                               [&](float depth) { return slice_position(t.range.relative(depth), 128U); });
}

template <std::uint32_t Slices>
void by_opacity(const texel& t, std::span<const float> depths, std::span<float> passed, std::uint64_t&) {
  estimate_by<opacity_map<Slices>>(t, depths, passed,
                                   [&](float depth) { return slice_position(t.whole.relative(depth), Slices); });
}

template <std::uint32_t Layers>
void by_deep_opacity(const texel& t, std::span<const float> depths, std::span<float> passed, std::uint64_t&) {
  estimate_by<opacity_map<Layers>>(t, depths, passed, [&](float depth) {
    return equal_layer_position(depth - t.range.nearest_depth(), t.extent / static_cast<float>(Layers), Layers);
  });
}

template <std::uint32_t Layers>
void by_growing_layers(const texel& t, std::span<const float> depths, std::span<float> passed, std::uint64_t&) {
  const float width = growing_layer_width(t.extent, Layers);
  estimate_by<opacity_map<Layers>>(t, depths, passed, [&](float depth) {
    return growing_layer_position(depth - t.range.nearest_depth(), width, Layers);
  });
}

/// Clusters count; all their fragments have the mean optical depth.
void by_clusters(const texel& t, std::span<const float> depths, std::span<float> passed, std::uint64_t&) {
  density_clusters<4> map = density_clusters<4>::empty();
  double optical = 0;
  for (std::size_t i = 0; i < t.list.size(); ++i) {
    map.add(slice_position(t.range.relative(t.list[i].depth), 4U));
    optical += t.optical[i];
  }
  const float mean = static_cast<float>(optical / static_cast<double>(std::max<std::size_t>(t.list.size(), 1)));
  for (std::size_t i = 0; i < depths.size(); ++i) {
    passed[i] = passed_by(mean * map.count_before(slice_position(t.range.relative(depths[i]), 4U)));
  }
}

template <int PerMille>
void by_deep_shadow(const texel& t, std::span<const float> depths, std::span<float> passed, std::uint64_t& vertices) {
  static thread_local std::vector<deep_shadow_vertex> memory;
  memory.resize(2 * t.list.size());
  span_vertex_storage storage{memory};
  deep_shadow_builder builder = deep_shadow_builder::begin(0, static_cast<float>(PerMille) / 1000.0F);
  for (std::size_t i = 0; i < t.list.size(); ++i) {
    builder.add(storage, t.list[i].depth, 1.0F - transmittance_of(t.optical[i]));
  }
  builder.finish(storage);
  vertices += builder.count;
  for (std::size_t i = 0; i < depths.size(); ++i) passed[i] = deep_shadow_at(storage, 0, builder.count, depths[i]);
}

template <class Map>
constexpr std::size_t with_range = sizeof(Map) + sizeof(depth_range);

const std::vector<method> methods{
    {"occupancy 128/4", with_range<occupancy_map<>>, by_occupancy},
    {"deep opacity 4", with_range<opacity_map<4>>, by_deep_opacity<4>},
    {"deep opacity 16", with_range<opacity_map<16>>, by_deep_opacity<16>},
    {"deep opacity 32", with_range<opacity_map<32>>, by_deep_opacity<32>},
    {"deep opacity 16, growing", with_range<opacity_map<16>>, by_growing_layers<16>},
    {"opacity 16", with_range<opacity_map<16>>, by_opacity<16>},
    {"opacity 128", with_range<opacity_map<128>>, by_opacity<128>},
    {"opacity 256", with_range<opacity_map<256>>, by_opacity<256>},
    {"density clusters 4", with_range<density_clusters<4>>, by_clusters},
    {"deep shadow map 0.01", 0, by_deep_shadow<10>},
    {"deep shadow map 0.03", 0, by_deep_shadow<30>},
};

/// The truth at each fragment of a sorted list: what passes all that lie strictly before it.
std::vector<float> truth_of(const texel& t) {
  std::vector<float> passed;
  float before = 1.0F;
  float all = 1.0F;
  for (std::size_t i = 0; i < t.list.size(); ++i) {
    if (i > 0 && t.list[i].depth > t.list[i - 1].depth) before = all;
    passed.push_back(before);
    all *= transmittance_of(t.optical[i]);
  }
  return passed;
}

std::vector<float> depths_of(std::span<const sample> list) {
  std::vector<float> depths;
  for (const sample& s : list) depths.push_back(s.depth);
  return depths;
}

std::vector<std::uint32_t> optical_of(std::span<const sample> list, float alpha) {
  std::vector<std::uint32_t> optical;
  for (const sample& s : list) optical.push_back(optical_depth(alpha * s.coverage));
  return optical;
}

/// The sum of squares and the largest of many differences.
struct difference {
  double squares = 0;
  double largest = 0;
  std::uint64_t count = 0;

  void see(double d) {
    squares += d * d;
    largest = std::max(largest, std::abs(d));
    ++count;
  }
  [[nodiscard]] double rms() const { return count > 0 ? std::sqrt(squares / static_cast<double>(count)) : 0.0; }
};

nlohmann::json visibility(const lists& light, float alpha) {
  depth_range whole = depth_range::empty();
  std::vector<float> extents;
  std::size_t longest = 0;
  for (std::size_t p = 0; p < light.pixels(); ++p) {
    const std::span<const sample> list = light.of(p);
    if (list.empty()) continue;
    whole.extend(list.front().depth);
    whole.extend(list.back().depth);
    extents.push_back(list.back().depth - list.front().depth);
    if (list.size() > light.of(longest).size()) longest = p;
  }
  if (extents.empty()) return {};
  const auto most = extents.begin() + static_cast<std::ptrdiff_t>(extents.size() * 9 / 10);
  std::nth_element(extents.begin(), most, extents.end());

  const auto texel_of = [&](std::size_t p) {
    texel t{light.of(p), optical_of(light.of(p), alpha), depth_range::empty(), whole, *most};
    t.range.extend(t.list.front().depth);
    t.range.extend(t.list.back().depth);
    return t;
  };
  std::vector<difference> errors(methods.size());
  std::vector<std::uint64_t> vertices(methods.size(), 0);
  std::vector<float> passed;
  for (std::size_t p = 0; p < light.pixels(); ++p) {
    if (light.of(p).empty()) continue;
    const texel t = texel_of(p);
    const std::vector<float> truth = truth_of(t);
    const std::vector<float> depths = depths_of(t.list);
    passed.resize(truth.size());
    for (std::size_t m = 0; m < methods.size(); ++m) {
      methods[m].estimate(t, depths, passed, vertices[m]);
      for (std::size_t i = 0; i < truth.size(); ++i) errors[m].see(double{passed[i]} - double{truth[i]});
    }
  }

  nlohmann::json result{{"alpha", alpha}, {"extent", *most}, {"fragments", light.fragments()}};
  for (std::size_t m = 0; m < methods.size(); ++m) {
    const double bytes = methods[m].bytes > 0 ? static_cast<double>(methods[m].bytes)
                                              : static_cast<double>(vertices[m]) * sizeof(deep_shadow_vertex) /
                                                    static_cast<double>(light.pixels());
    result["methods"].push_back({{"name", methods[m].name},
                                 {"rms", errors[m].rms()},
                                 {"maximum", errors[m].largest},
                                 {"bytes_per_texel", bytes}});
  }
  // The ray with most fragments, drawn at 400 depths.
  const texel t = texel_of(longest);
  std::vector<float> depths(400);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    depths[i] = t.list.front().depth +
                1.02F * (t.list.back().depth - t.list.front().depth) * static_cast<float>(i) / 399.0F;
  }
  std::vector<float> truth(depths.size());
  std::uint64_t unused = 0;
  by_deep_shadow<0>(t, depths, truth, unused);
  result["ray"] = {{"depth", depths}, {"truth", truth}};
  std::vector<float> along(depths.size());
  for (const method& each : methods) {
    each.estimate(t, depths, along, unused);
    result["ray"]["methods"][each.name] = along;
  }
  return result;
}

/// A fibre's colour: random by strand, so that a wrong order shows.
glm::vec3 random_colour(std::uint32_t strand) {
  const auto channel = [strand](std::uint32_t c) {
    return static_cast<float>(mixed_bits(3U * strand + c) >> 8U) / 16777216.0F;
  };
  return {channel(0), channel(1), channel(2)};
}

/// A pixel whose fragments are to be blended: sorted, so that a method that must not know the order only sees sums.
struct pixel {
  const texel& t;
  const std::vector<float>& alpha;
  const std::vector<glm::vec3>& colour;
  std::uint32_t number;
};

constexpr glm::vec3 background(0.8F);

/// The first k sorted, the others as their tail; k from the list's length on: the truth.
glm::vec3 by_nearest(const pixel& p, std::size_t k) {
  pixel_radiance<float> sum = empty_pixel<float>();
  tail behind = empty_tail();
  for (std::size_t i = 0; i < p.alpha.size(); ++i) {
    if (i < k) {
      sum = add_fibre(sum, p.colour[i], glm::vec3(0.0F), p.alpha[i]);
    } else {
      behind = add_fragment(behind, p.alpha[i], p.colour[i]);
    }
  }
  sum = add_fibre(sum, mean_colour(behind), glm::vec3(transmittance_of(behind)), 1.0F);
  return resolve(sum, background);
}

/// Weighs each fragment by what a map lets through to it. `corrected`: the sum is scaled to what the fibres cover.
template <auto Estimate>
glm::vec3 by_map(const pixel& p, bool corrected) {
  const std::vector<float> depths = depths_of(p.t.list);
  std::vector<float> passed(depths.size());
  std::uint64_t unused = 0;
  Estimate(p.t, depths, passed, unused);
  tail sum = empty_tail();
  glm::vec3 colour(0.0F);
  for (std::size_t i = 0; i < depths.size(); ++i) {
    sum = add_weighted(sum, p.alpha[i], p.alpha[i] * passed[i], p.colour[i]);
    colour += p.alpha[i] * passed[i] * p.colour[i];
  }
  return corrected ? resolve(sum, background) : colour + transmittance_of(sum) * background;
}

/// The paper's own weight: the order is counted, and all fragments have the mean alpha.
glm::vec3 by_counted_order(const pixel& p) {
  occupancy_map<> map = occupancy_map<>::empty();
  for (const sample& s : p.t.list) map.add(slice_position(p.t.range.relative(s.depth), 128U), 1U);
  float mean = 0.0F;
  for (const float a : p.alpha) mean += a / static_cast<float>(p.alpha.size());
  tail sum = empty_tail();
  for (std::size_t i = 0; i < p.alpha.size(); ++i) {
    const float order = map.amount_before(slice_position(p.t.range.relative(p.t.list[i].depth), 128U));
    const float before = mean > 0.0F ? order_weight(mean, order) / mean : 1.0F;
    sum = add_weighted(sum, p.alpha[i], p.alpha[i] * before, p.colour[i]);
  }
  return resolve(sum, background);
}

glm::vec3 by_weighted_average(const pixel& p) {
  weighted_average sum = weighted_average::empty();
  for (std::size_t i = 0; i < p.alpha.size(); ++i) sum.add(p.alpha[i], p.colour[i]);
  return sum.resolve(background);
}

glm::vec3 by_weighted_blended(const pixel& p) {
  tail sum = empty_tail();
  for (std::size_t i = 0; i < p.alpha.size(); ++i) {
    const float weight = depth_weight(p.alpha[i], p.t.range.relative(p.t.list[i].depth));
    sum = add_weighted(sum, p.alpha[i], weight, p.colour[i]);
  }
  return resolve(sum, background);
}

template <std::uint32_t Samples>
glm::vec3 by_stochastic(const pixel& p) {
  auto depths = stochastic_depths<Samples>::empty();
  for (std::size_t i = 0; i < p.alpha.size(); ++i) {
    const fragment f{p.t.list[i].depth, p.t.list[i].id};
    depths.add(f, p.alpha[i], stochastic_stream(1U, p.number));
  }
  tail sum = empty_tail();
  for (std::size_t i = 0; i < p.alpha.size(); ++i) {
    const float passed = depths.transmittance_before(p.t.list[i].depth);
    sum = add_weighted(sum, p.alpha[i], p.alpha[i] * passed, p.colour[i]);
  }
  return resolve(sum, background);
}

struct blending {
  std::string name;
  glm::vec3 (*blend)(const pixel&);
};

const std::vector<blending> blendings{
    {"K-buffer 4", [](const pixel& p) { return by_nearest(p, 4); }},
    {"K-buffer 8", [](const pixel& p) { return by_nearest(p, 8); }},
    {"K-buffer 16", [](const pixel& p) { return by_nearest(p, 16); }},
    {"K-buffer 32", [](const pixel& p) { return by_nearest(p, 32); }},
    {"deep opacity 32", [](const pixel& p) { return by_map<by_deep_opacity<32>>(p, false); }},
    {"deep opacity 32, corrected", [](const pixel& p) { return by_map<by_deep_opacity<32>>(p, true); }},
    {"order-weighted, counted", by_counted_order},
    {"order-weighted, optical", [](const pixel& p) { return by_map<by_occupancy>(p, true); }},
    {"weighted average", by_weighted_average},
    {"weighted blended", by_weighted_blended},
    {"stochastic 8", by_stochastic<8>},
    {"stochastic 32", by_stochastic<32>},
};

nlohmann::json blending_errors(const lists& camera, const strands& fibres, float alpha) {
  std::vector<std::uint32_t> strand_of(fibres.point.size(), 0);
  for (std::size_t i = 1; i < strand_of.size(); ++i) {
    strand_of[i] = strand_of[i - 1] + ((fibres.end_of[i] & strands::first) != 0 ? 1U : 0U);
  }
  std::vector<difference> errors(blendings.size());
  for (std::size_t n = 0; n < camera.pixels(); ++n) {
    const std::span<const sample> list = camera.of(n);
    if (list.empty()) continue;
    texel t{list, optical_of(list, alpha), depth_range::empty(), depth_range::empty(), 0.0F};
    t.range.extend(list.front().depth);
    t.range.extend(list.back().depth);
    t.extent = list.back().depth - list.front().depth;  // layers between the true nearest and farthest depth
    std::vector<float> alphas;
    std::vector<glm::vec3> colours;
    for (const sample& s : list) {
      alphas.push_back(alpha * s.coverage);
      colours.push_back(random_colour(strand_of[fibres.segment[s.id]]));
    }
    const pixel p{t, alphas, colours, static_cast<std::uint32_t>(n)};
    const glm::vec3 truth = by_nearest(p, list.size());
    for (std::size_t b = 0; b < blendings.size(); ++b) {
      const glm::vec3 d = blendings[b].blend(p) - truth;
      for (int c = 0; c < 3; ++c) errors[b].see(d[c]);
    }
  }
  nlohmann::json result{{"alpha", alpha}, {"fragments", camera.fragments()}};
  for (std::size_t b = 0; b < blendings.size(); ++b) {
    result["methods"].push_back(
        {{"name", blendings[b].name}, {"rms", errors[b].rms()}, {"maximum", errors[b].largest}});
  }
  return result;
}

/// Memory of the maps for 512 × 512 texels, as the structures have it.
nlohmann::json memory() {
  nlohmann::json rows = nlohmann::json::array();
  for (const method& each : methods) {
    if (each.bytes > 0) rows.push_back({{"name", each.name}, {"bytes", each.bytes * 512 * 512}});
  }
  return rows;
}

void measure(const std::string& hair, std::uint32_t strand_count, int size, const std::filesystem::path& out) {
  const std::filesystem::path path = hair;
  const hair_model model = hair.empty()                  ? make_built_in(strand_count, 40, 1)
                           : path.extension() == ".tfx" ? load_tfx(path)
                                                         : load_hair(path);
  const strands fibres = prepare_strands(model, {});
  const box bounds = model.bounds();
  if (bounds.empty()) throw std::runtime_error("the model has no fibres");
  const sphere round{0.5F * (bounds.lower + bounds.upper), 0.5F * glm::length(bounds.upper - bounds.lower)};
  solids opaque;
  if (hair.empty()) opaque.parts.assign(bust.begin(), bust.end());

  const auto lists_of = [&](const char* from, bool antialias, const auto& use) {
    const view seen = light_view(place_light(parse_light(from), round), round, size);
    const raster fragments(fibres, seen, antialias);
    const std::vector<float> limit = opaque_depths(seen, opaque);
    lists all(fragments);
    const order_report report = run_order_pass(fragments, limit, {order_method::full_sort, 16, {}}, all);
    if (report.refused > 0) throw std::runtime_error("fragments were refused");
    use(all);
  };
  nlohmann::json result{{"model", hair.empty() ? "built-in" : path.filename().string()},
                        {"strands", model.strand_count()},
                        {"size", size},
                        {"memory", memory()}};
  // Fibres as thin as they are, and as the papers draw them: lines of a pixel's width, whose alpha is never shared.
  for (const bool antialias : {true, false}) {
    nlohmann::json& part = result[antialias ? "thin" : "lines"];
    lists_of("directional:0.5,1.4,1.9:1,1,1", antialias, [&](const lists& all) {
      for (const float alpha : {0.25F, 0.15F, 0.03F}) part["visibility"].push_back(visibility(all, alpha));
    });
    lists_of("directional:0.4,0.14,0.9:1,1,1", antialias, [&](const lists& all) {
      for (const float alpha : {0.25F, 0.15F, 0.03F}) part["blending"].push_back(blending_errors(all, fibres, alpha));
    });
  }
  const std::string text = result.dump(1) + "\n";
  write_file(out, std::as_bytes(std::span(text)));
}

}  // namespace
}  // namespace pelage::frame

int main(int argc, char** argv) {
  CLI::App app{"Measures the errors of visibility maps and blendings against sorted hair."};
  std::string hair;
  std::string out = "quality.json";
  std::uint32_t strands = 10000;
  int size = 512;
  app.add_option("--hair", hair, "a .hair or .tfx file in place of the built-in model");
  app.add_option("--strands", strands, "of the built-in model")->capture_default_str();
  app.add_option("--size", size, "pixels a side, [1, 4096]")->capture_default_str()->check(CLI::Range(1, 4096));
  app.add_option("--out", out, "the JSON file")->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error);
  }
  try {
    pelage::frame::measure(hair, strands, size, out);
  } catch (const std::exception& error) {
    fmt::print(stderr, "pelage-quality: {}\n", error.what());
    return 2;
  }
  return 0;
}
