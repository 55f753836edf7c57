// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/interpolated_strands.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "frame/base/random.hpp"
#include "frame/model/nearest_places.hpp"

namespace pelage::frame {
namespace {

constexpr std::size_t most_neighbours = 8;  ///< as many as surround a point of a square lattice

template <class Visit>
void for_each_in_parallel(std::size_t count, Visit&& visit) {
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count), [&](const tbb::blocked_range<std::size_t>& some) {
    for (std::size_t i = some.begin(); i != some.end(); ++i)
      visit(i);
  });
}

/// The roots of strands that have segments, and the neighbours of each.
class neighbourhood {
 public:
  explicit neighbourhood(const hair_model& guides) {
    for (std::uint32_t g = 0; g < guides.strand_count(); ++g) {
      if (guides.point_count(g) < 2) continue;
      guide_.push_back(g);
      root_.push_back(guides.points[guides.first_point[g]]);
    }
    const nearest_places tree(root_);
    near_.resize(root_.size());
    for_each_in_parallel(root_.size(), [&](std::size_t i) {
      near_[i] = tree.nearest_to(static_cast<std::uint32_t>(i), most_neighbours);
    });
    const double limit = greatest_spacing * mean_spacing();
    for (std::vector<nearest_places::neighbour>& all : near_)
      std::erase_if(all, [&](const nearest_places::neighbour& one) { return one.distance > limit; });
  }

  [[nodiscard]] std::size_t size() const { return root_.size(); }
  [[nodiscard]] std::uint32_t guide(std::size_t i) const { return guide_[i]; }

  /// Guide i and two of its neighbours, as far as it has any, at a random place.
  [[nodiscard]] guide_mix draw(std::size_t i, random_stream random) const {
    std::vector<nearest_places::neighbour> near = near_[i];
    guide_mix mix{{guide_[i], guide_[i], guide_[i]}, {1.0F, 0.0F, 0.0F}};
    if (near.empty()) return mix;
    const auto second = near.begin() + static_cast<std::ptrdiff_t>(random.next() % near.size());
    const std::uint32_t place = second->place;
    mix.guide[1] = guide_[place];
    near.erase(second);
    for (nearest_places::neighbour& one : near)
      one.distance += glm::distance(glm::dvec3(root_[one.place]), glm::dvec3(root_[place]));
    std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.distance < b.distance; });
    if (near.empty()) {
      mix.weight[1] = 0.5F * random.unit();
      mix.weight[0] = 1.0F - mix.weight[1];
    } else {
      mix.guide[2] = guide_[near[random.next() % std::min(near.size(), std::size_t{2})].place];
      mix.weight = in_triangle(random);
    }
    return mix;
  }

 private:
  [[nodiscard]] double mean_spacing() const {
    double sum = 0.0;
    std::size_t spaced = 0;
    for (const std::vector<nearest_places::neighbour>& all : near_) {
      const auto apart = std::find_if(all.begin(), all.end(), [](const auto& one) { return one.distance > 0.0; });
      if (apart == all.end()) continue;
      sum += apart->distance;
      ++spaced;
    }
    return spaced == 0 ? 0.0 : sum / static_cast<double>(spaced);
  }

  /// Evenly spread over the third of a triangle where the first weight is the greatest.
  static std::array<float, 3> in_triangle(random_stream& random) {
    const float root = std::sqrt(random.unit());
    const float u = random.unit();
    std::array<float, 3> weight{1.0F - root, root * (1.0F - u), root * u};
    std::swap(weight[0], *std::max_element(weight.begin(), weight.end()));
    return weight;
  }

  std::vector<std::uint32_t> guide_;
  std::vector<glm::vec3> root_;
  std::vector<std::vector<nearest_places::neighbour>> near_;
};

/// Where a parameter lies on a polyline: point `low`, and from it so far to the next.
struct place_on_guide {
  std::size_t low;
  float along;  ///< [0, 1)

  template <class Value>
  [[nodiscard]] Value in(const std::vector<Value>& values) const {
    return along > 0.0F ? glm::mix(values[low], values[low + 1], along) : values[low];
  }
};

/// The parameter i / (count - 1) on a strand of the guides.
place_on_guide place_of(const hair_model& guides, std::uint32_t guide, std::uint32_t i, std::uint32_t count) {
  const std::uint64_t first = guides.first_point[guide];
  if (count < 2) return {static_cast<std::size_t>(first), 0.0F};
  const std::uint64_t scaled = std::uint64_t{i} * (guides.point_count(guide) - 1);
  return {static_cast<std::size_t>(first + scaled / (count - 1)),
          static_cast<float>(scaled % (count - 1)) / static_cast<float>(count - 1)};
}

/// The weights where the strand has been drawn to its own guide by a share of the way.
std::array<float, 3> drawn(const std::array<float, 3>& weight, float share) {
  if (share == 0.0F) return weight;
  const float left = 1.0F - share;
  return {share + left * weight[0], left * weight[1], left * weight[2]};
}

template <class Value>
Value mean_of(const std::vector<Value>& values, const std::array<place_on_guide, 3>& at,
              const std::array<float, 3>& weight) {
  Value sum(0.0F);
  bool is_first = true;
  for (std::size_t g = 0; g < 3; ++g) {
    if (weight[g] == 0.0F) continue;
    const Value part = weight[g] * at[g].in(values);
    sum = is_first ? part : sum + part;
    is_first = false;
  }
  return sum;
}

std::uint32_t points_of(const hair_model& guides, const guide_mix& mix) {
  std::uint32_t most = 0;
  for (std::size_t g = 0; g < 3; ++g) {
    if (mix.weight[g] > 0.0F) most = std::max(most, guides.point_count(mix.guide[g]));
  }
  return most;
}

/// A model of the same defaults, whose strands have so many points; the arrays that the guides have are as long.
hair_model with_room(const hair_model& guides, std::span<const guide_mix> mixes) {
  hair_model out;
  out.default_thickness = guides.default_thickness;
  out.default_transparency = guides.default_transparency;
  out.default_colour = guides.default_colour;
  std::uint64_t points = 0;
  for (const guide_mix& mix : mixes) {
    points += points_of(guides, mix);
    if (points > std::numeric_limits<std::uint32_t>::max()) {
      throw std::length_error("the interpolated strands would have more than 2^32 - 1 points");
    }
    out.first_point.push_back(static_cast<std::uint32_t>(points));
  }
  const auto count = static_cast<std::size_t>(points);
  out.points.resize(count);
  if (!guides.thickness.empty()) out.thickness.resize(count);
  if (!guides.transparency.empty()) out.transparency.resize(count);
  if (!guides.colour.empty()) out.colour.resize(count);
  return out;
}

}  // namespace

std::vector<guide_mix> mix_guides(const hair_model& guides, std::uint32_t n, std::uint64_t seed) {
  std::vector<guide_mix> mixes;
  mixes.reserve(guides.strand_count() * n);
  for (std::uint32_t g = 0; g < guides.strand_count(); ++g)
    mixes.insert(mixes.end(), n, {{g, g, g}, {1.0F, 0.0F, 0.0F}});
  const neighbourhood roots(guides);
  for_each_in_parallel(roots.size(), [&](std::size_t i) {
    const std::size_t first = std::size_t{roots.guide(i)} * n;
    for (std::size_t m = first; m < first + n; ++m)
      mixes[m] = roots.draw(i, random_stream(seed, m));
  });
  return mixes;
}

hair_model interpolate_strands(const hair_model& guides, std::span<const guide_mix> mixes, float clump) {
  if (!(clump >= 0.0F && clump <= 1.0F)) throw std::invalid_argument("the clump of strands is not in [0, 1]");
  hair_model out = with_room(guides, mixes);
  for_each_in_parallel(mixes.size(), [&](std::size_t s) {
    const guide_mix& mix = mixes[s];
    const std::uint32_t count = out.point_count(s);
    for (std::uint32_t i = 0; i < count; ++i) {
      const float t = count < 2 ? 0.0F : static_cast<float>(i) / static_cast<float>(count - 1);
      const std::array<float, 3> weight = drawn(mix.weight, clump * t);
      std::array<place_on_guide, 3> at{};
      for (std::size_t g = 0; g < 3; ++g)
        at[g] = place_of(guides, mix.guide[g], i, count);
      const std::size_t target = out.first_point[s] + i;
      out.points[target] = mean_of(guides.points, at, weight);
      if (!out.thickness.empty()) out.thickness[target] = mean_of(guides.thickness, at, weight);
      if (!out.transparency.empty()) out.transparency[target] = mean_of(guides.transparency, at, weight);
      if (!out.colour.empty()) out.colour[target] = mean_of(guides.colour, at, weight);
    }
  });
  return out;
}

hair_model add_interpolated_strands(const hair_model& guides, std::uint32_t n, float clump, std::uint64_t seed) {
  const std::vector<guide_mix> between = mix_guides(guides, n, seed);
  std::vector<guide_mix> all;
  all.reserve(guides.strand_count() + between.size());
  for (std::uint32_t g = 0; g < guides.strand_count(); ++g) {
    all.push_back({{g, g, g}, {1.0F, 0.0F, 0.0F}});
    const auto first = between.begin() + static_cast<std::ptrdiff_t>(std::size_t{g} * n);
    all.insert(all.end(), first, first + n);
  }
  return interpolate_strands(guides, all, clump);
}

}  // namespace pelage::frame
