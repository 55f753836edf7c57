// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/divided_pixel.hpp>

#include "composite/layers.hpp"
#include "property.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace pelage::test {

constexpr float infinity = std::numeric_limits<float>::infinity();

/// A fibre, or an opaque sample of the pixel, for which only depth and light count.
struct seen {
  float depth;
  glm::vec3 light, attenuation;
  float coverage;
};

/// Any number of them, up to 60, at depths of which many are equal; nearest first.
std::vector<seen> draw_in_order(std::size_t least) {
  std::vector<seen> all(*rc::gen::inRange<std::size_t>(least, 61u));
  for (seen& each : all)
    each = {1.0f + draw_share(), draw_colour(), draw_colour(), draw_share()};
  std::sort(all.begin(), all.end(), [](const seen& a, const seen& b) { return a.depth < b.depth; });
  return all;
}

/// The samples of two surfaces, those of each at one depth.
std::vector<seen> draw_samples() {
  const float near_depth = 1.0f + draw_share();
  const float far_depth = *rc::gen::element(infinity, 2.1f, near_depth);
  std::vector<seen> samples(*rc::gen::inRange<std::size_t>(1u, 17u));
  for (seen& each : samples)
    each = {*rc::gen::element(near_depth, far_depth), draw_colour(), glm::vec3(0.0f), 0.0f};
  return samples;
}

/// As any includer does it: the samples' extremes first, then those of either surface.
divided_backdrop<float> backdrop_of(const std::vector<seen>& samples) {
  const auto by_depth = [](const seen& a, const seen& b) { return a.depth < b.depth; };
  const auto [nearest, farthest] = std::minmax_element(samples.begin(), samples.end(), by_depth);
  const float parting = parting_depth(nearest->depth, farthest->depth);
  divided_backdrop<float> behind{infinity, 0.0f, glm::vec3(0.0f), glm::vec3(0.0f)};
  float near_depths = 0.0f, near_count = 0.0f;
  const auto count = static_cast<float>(samples.size());
  for (const seen& each : samples) {
    behind.all_light += each.light / count;
    if (each.depth < parting) {
      near_depths += each.depth;
      near_count += 1.0f;
    } else {
      behind.far_light += each.light / count;
    }
  }
  behind.far_share = (count - near_count) / count;
  if (near_count > 0.0f && near_count < count) behind.edge = near_depths / near_count;
  return behind;
}

/// What a sample sees of the fibres before it, in double.
glm::dvec3 seen_by(const seen& sample, const std::vector<seen>& fibres) {
  glm::dvec3 sum(0.0), passed(1.0);
  for (const seen& each : fibres) {
    if (each.depth >= sample.depth) break;
    const glm::dvec3 stopped = (1.0 - glm::dvec3(each.attenuation)) * static_cast<double>(each.coverage);
    sum += passed * stopped * glm::dvec3(each.light);
    passed *= 1.0 - stopped;
  }
  return sum + passed * glm::dvec3(sample.light);
}

divided_pixel<float> gathered(const std::vector<seen>& fibres, float edge) {
  divided_pixel<float> pixel = empty_divided_pixel<float>();
  for (const seen& each : fibres)
    pixel = add_fibre(pixel, each.depth < edge, each.light, each.attenuation, each.coverage);
  return pixel;
}

TEST_CASE("a pixel that an edge divides is the mean of its samples, each composited with the fibres before it") {
  holds("samples of two depths, in double", [] {
    const std::vector<seen> samples = draw_samples();
    const divided_backdrop<float> behind = backdrop_of(samples);
    std::vector<seen> fibres = draw_in_order(0u);
    // None behind all samples, and none within the rounding of a mean depth from the edge.
    std::erase_if(fibres, [&](const seen& each) {
      return std::abs(each.depth - behind.edge) < 1e-5f ||
             std::none_of(samples.begin(), samples.end(), [&](const seen& s) { return each.depth < s.depth; });
    });
    glm::dvec3 mean(0.0);
    for (const seen& each : samples)
      mean += seen_by(each, fibres) / static_cast<double>(samples.size());
    RC_ASSERT(glm::length(glm::dvec3(resolve(gathered(fibres, behind.edge), behind)) - mean) < 5e-6);
  });
}

TEST_CASE("fibres behind an edge never hide what is nearer, however many they are") {
  holds("white fibres, a black object before a black sky", [] {
    const float far_share = draw_share();
    const divided_backdrop<float> behind{1.0f, far_share, glm::vec3(0.0f), glm::vec3(0.0f)};
    divided_pixel<float> pixel = empty_divided_pixel<float>();
    tail lost = empty_tail();
    for (const layer& each : draw_layers()) {
      pixel = add_fibre(pixel, false, glm::vec3(1.0f), glm::vec3(1.0f - each.alpha), 1.0f);
      lost = add_fragment(lost, each.alpha, glm::vec3(1.0f));
    }
    RC_ASSERT(resolve(add_tails(pixel, empty_tail(), lost), behind).x <= far_share * 1.00001f);
  });
}

TEST_CASE("with no fibre behind the edge the bits are those of an undivided pixel") {
  holds("fibres and tail before it", [] {
    const std::vector<seen> fibres = draw_in_order(0u);
    pixel_radiance<float> plain = empty_pixel<float>();
    for (const seen& each : fibres)
      plain = add_fibre(plain, each.light, each.attenuation, each.coverage);
    tail before = empty_tail();
    for (const layer& each : draw_layers())
      before = add_fragment(before, each.alpha, each.colour);
    const divided_backdrop<float> behind{3.0f, draw_share(), draw_colour(), draw_colour()};
    RC_ASSERT(resolve(add_tails(gathered(fibres, behind.edge), before, empty_tail()), behind) ==
              resolve(add_tail(plain, before), behind.all_light));
  });
}

TEST_CASE("a tail behind the edge is seen beside the nearer surface alone") {
  holds("both parts in double", [] {
    const divided_pixel<float> pixel = gathered(draw_in_order(0u), 1.5f);
    tail before = empty_tail(), lost = empty_tail();
    for (const layer& each : draw_layers(0.9f))
      before = add_fragment(before, each.alpha, each.colour);
    for (const layer& each : draw_layers(0.9f))
      lost = add_fragment(lost, each.alpha, each.colour);
    const float far_share = draw_share();
    const glm::vec3 near_light = (1.0f - far_share) * draw_colour();
    const glm::vec3 far_light = far_share * draw_colour();
    const auto part = [](const pixel_radiance<float>& p, const tail& t, double share, const glm::vec3& light) {
      const double passed = transmittance_of(t);
      const glm::dvec3 layer = share * (1.0 - passed) * glm::dvec3(mean_colour(t)) + passed * glm::dvec3(light);
      return share * glm::dvec3(p.radiance) + glm::dvec3(p.transmittance) * layer;
    };
    const glm::dvec3 expected = part(pixel.near_part, before, 1.0 - far_share, near_light) +
                                part(pixel.far_part, merge(before, lost), far_share, far_light);
    const glm::vec3 found =
        resolve(add_tails(pixel, before, lost), {1.5f, far_share, far_light, near_light + far_light});
    RC_ASSERT(glm::length(glm::dvec3(found) - expected) < 3e-6);
  });
}

TEST_CASE("samples part between the nearest and the farthest") {
  holds("both groups have a sample, unless all are as far", [] {
    const float nearest = 1e-3f + 1e3f * draw_share();
    const float farthest = *rc::gen::element(infinity, nearest * (1.0f + draw_share()));
    const float parting = parting_depth(nearest, farthest);
    RC_ASSERT(parting >= nearest * 0.999999f);
    RC_ASSERT(parting <= farthest * 1.000001f);
    RC_ASSERT(farthest < nearest * 1.00001f || (nearest < parting && parting < farthest));
  });
  CHECK(parting_depth(infinity, infinity) == infinity);
}

}  // namespace pelage::test
