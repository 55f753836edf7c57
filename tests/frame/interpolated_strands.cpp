// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/interpolated_strands.hpp"

#include "frame/fibres.hpp"
#include "frame/model/nearest_places.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

namespace pelage::test {

using namespace frame;

/// Up to eight guides of two to six points each, with every array that a point may have.
hair_model any_guides() {
  hair_model model = model_of(any_lines(8, glm::vec3(0.0F), 10.0F), 0.01F, 0.5F);
  for (std::size_t i = 0; i < model.points.size(); ++i) {
    model.thickness.push_back(any_float(0.0F, 1.0F));
    model.transparency.push_back(any_float(0.0F, 1.0F));
    model.colour.push_back(any_vec3(0.0F, 1.0F));
  }
  return model;
}

std::uint32_t any_guide(const hair_model& guides) {
  return *rc::gen::inRange(0U, static_cast<std::uint32_t>(guides.strand_count()));
}

guide_mix any_mix(const hair_model& guides) {
  guide_mix mix{{any_guide(guides), any_guide(guides), any_guide(guides)}, {}};
  const glm::vec3 raw = any_vec3(0.01F, 1.0F);
  for (int g = 0; g < 3; ++g)
    mix.weight[static_cast<std::size_t>(g)] = raw[g] / (raw.x + raw.y + raw.z);
  return mix;
}

template <class Value>
std::span<const Value> strand(const hair_model& model, std::size_t s, const std::vector<Value>& values) {
  return std::span(values).subspan(model.first_point[s], model.point_count(s));
}

bool same_strand(const hair_model& a, std::size_t s, const hair_model& b, std::size_t t) {
  const auto same = [&](const auto& of_a, const auto& of_b) {
    return of_a.empty() == of_b.empty() && (of_a.empty() || same_bits(strand(a, s, of_a), strand(b, t, of_b)));
  };
  return same(a.points, b.points) && same(a.thickness, b.thickness) && same(a.transparency, b.transparency) &&
         same(a.colour, b.colour);
}

bool same_model(const hair_model& a, const hair_model& b) {
  return a.first_point == b.first_point && same_bits(a.points, b.points) && same_bits(a.thickness, b.thickness) &&
         same_bits(a.transparency, b.transparency) && same_bits(a.colour, b.colour);
}

/// A polyline's point at a parameter, [0, 1].
glm::dvec3 point_at(std::span<const glm::vec3> line, double t) {
  const double x = t * static_cast<double>(line.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(x), line.size() - 1);
  const std::size_t high = std::min(low + 1, line.size() - 1);
  return glm::mix(glm::dvec3(line[low]), glm::dvec3(line[high]), x - static_cast<double>(low));
}

/// The roots of straight guides of four points.
hair_model guides_at(const std::vector<glm::vec3>& roots) {
  std::vector<std::vector<glm::vec3>> lines;
  for (const glm::vec3& root : roots) {
    lines.emplace_back();
    for (int i = 0; i < 4; ++i)
      lines.back().push_back(root + glm::vec3(0.0F, static_cast<float>(i), 0.0F));
  }
  return model_of(lines, 0.01F, 0.5F);
}

std::vector<glm::vec3> lattice(int side, const glm::vec3& from, float spacing) {
  std::vector<glm::vec3> roots;
  for (int i = 0; i < side * side; ++i) {
    roots.push_back(from + spacing * glm::vec3(static_cast<float>(i % side), 0.0F, static_cast<float>(i / side)));
  }
  return roots;
}

TEST_CASE("a place's neighbours are the first of all others by distance, then by number") {
  holds("neighbours, as sorting finds them", [] {
    std::vector<glm::vec3> places(static_cast<std::size_t>(*rc::gen::inRange(1, 60)));
    const bool even = *rc::gen::arbitrary<bool>();  // on a lattice distances tie and places coincide
    for (glm::vec3& p : places)
      p = even ? glm::round(any_vec3(-2.0F, 2.0F)) : any_vec3(-1.0F, 1.0F);
    const nearest_places tree(places);
    const auto from = *rc::gen::inRange(0U, static_cast<std::uint32_t>(places.size()));
    const std::size_t most = *rc::gen::inRange(0U, 8U);
    std::vector<std::pair<double, std::uint32_t>> expected;
    for (std::uint32_t i = 0; i < places.size(); ++i) {
      if (i != from) expected.emplace_back(glm::distance(glm::dvec3(places[i]), glm::dvec3(places[from])), i);
    }
    std::sort(expected.begin(), expected.end());
    expected.resize(std::min(expected.size(), most));
    std::vector<std::pair<double, std::uint32_t>> found;
    for (const nearest_places::neighbour& one : tree.nearest_to(from, most))
      found.emplace_back(one.distance, one.place);
    RC_ASSERT(found == expected);
  });
}

TEST_CASE("a strand whose weights are a corner is that guide, bit for bit, clumped or not") {
  holds("corners", [] {
    const hair_model guides = any_guides();
    guide_mix mix = any_mix(guides);
    const auto corner = static_cast<std::size_t>(*rc::gen::inRange(0, 3));
    mix.weight = {0.0F, 0.0F, 0.0F};
    mix.weight[corner] = 1.0F;
    if (corner == 0) {
      RC_ASSERT(
          same_strand(interpolate_strands(guides, std::span(&mix, 1), any_float(0.0F, 1.0F)), 0, guides, mix.guide[0]));
    }
    RC_ASSERT(same_strand(interpolate_strands(guides, std::span(&mix, 1), 0.0F), 0, guides, mix.guide[corner]));
  });
}

TEST_CASE("a strand's points are the weighted means of its guides at each parameter, and lie in their hull") {
  holds("means and hulls", [] {
    const hair_model guides = any_guides();
    const guide_mix mix = any_mix(guides);
    const float clump = any_float(0.0F, 1.0F);
    const hair_model out = interpolate_strands(guides, std::span(&mix, 1), clump);
    std::uint32_t most = 0;
    for (const std::uint32_t g : mix.guide)
      most = std::max(most, guides.point_count(g));
    RC_ASSERT(out.points.size() == most);
    const glm::dvec3 direction(any_vec3(-1.0F, 1.0F));
    for (std::size_t i = 0; i < out.points.size(); ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(out.points.size() - 1);
      double least = std::numeric_limits<double>::infinity();
      double greatest = -least;
      glm::dvec3 mean(0.0);
      for (std::size_t g = 0; g < 3; ++g) {
        const glm::dvec3 p = point_at(strand(guides, mix.guide[g], guides.points), t);
        mean += static_cast<double>(mix.weight[g]) * p;
        least = std::min(least, glm::dot(direction, p));
        greatest = std::max(greatest, glm::dot(direction, p));
      }
      const glm::dvec3 own = point_at(strand(guides, mix.guide[0], guides.points), t);
      const glm::dvec3 q(out.points[i]);
      RC_ASSERT(glm::distance(q, glm::mix(mean, own, static_cast<double>(clump) * t)) < 2e-5);
      RC_ASSERT(glm::dot(direction, q) > least - 2e-5);
      RC_ASSERT(glm::dot(direction, q) < greatest + 2e-5);
    }
  });
}

TEST_CASE("clumped by 1 strands end at their guide's tip and begin where they did") {
  const hair_model guides = guides_at(lattice(5, glm::vec3(0.0F), 1.0F));
  const hair_model loose = add_interpolated_strands(guides, 6, 0.0F, 3);
  const hair_model tight = add_interpolated_strands(guides, 6, 1.0F, 3);
  int moved = 0;
  for (std::size_t s = 0; s < tight.strand_count(); ++s) {
    const std::span<const glm::vec3> own = strand(guides, s / 7, guides.points);
    CHECK(strand(tight, s, tight.points).back() == own.back());
    CHECK(strand(tight, s, tight.points).front() == strand(loose, s, loose.points).front());
    moved += strand(loose, s, loose.points).back() == own.back() ? 0 : 1;
  }
  CHECK(moved == 6 * 25);
}

TEST_CASE("each guide comes before its strands, and in those it has the greatest of weights whose sum is 1") {
  const hair_model guides = guides_at(lattice(6, glm::vec3(0.0F), 1.0F));
  const hair_model out = add_interpolated_strands(guides, 30, 0.3F, 1);
  REQUIRE(out.strand_count() == 31 * guides.strand_count());
  for (std::size_t g = 0; g < guides.strand_count(); ++g)
    CHECK(same_strand(out, 31 * g, guides, g));
  const std::vector<guide_mix> mixes = mix_guides(guides, 30, 1);
  for (std::size_t m = 0; m < mixes.size(); ++m) {
    const auto& [guide, weight] = mixes[m];
    CHECK(guide[0] == m / 30);
    CHECK(weight[0] >= std::max(weight[1], weight[2]));
    CHECK(std::min(weight[1], weight[2]) >= 0.0F);
    CHECK(std::abs(weight[0] + weight[1] + weight[2] - 1.0F) <= 0x1p-22F);
  }
}

TEST_CASE("roots fill the ground between guides evenly") {
  const hair_model guides = guides_at(lattice(20, glm::vec3(0.0F), 1.0F));
  const hair_model out = add_interpolated_strands(guides, 100, 0.0F, 1);
  std::vector<int> held(16 * 4, 0);  // quarters of a spacing, of the guides' inner squares
  int inner = 0;
  for (std::size_t s = 0; s < out.strand_count(); ++s) {
    const glm::vec3 root = out.points[out.first_point[s]];
    if (s % 101 == 0 || root.x < 5.0F || root.x >= 14.0F || root.z < 5.0F || root.z >= 14.0F) continue;
    const auto quarter = [](float x) { return static_cast<std::size_t>(4.0F * (x - std::floor(x))); };
    ++held[4 * quarter(root.x) + quarter(root.z)];
    ++inner;
  }
  for (std::size_t i = 0; i < 16; ++i)
    CHECK(held[i] > inner / 16 / 3);
}

TEST_CASE("the number of threads changes no bit, another seed changes the strands") {
  const hair_model guides = guides_at(lattice(12, glm::vec3(0.0F), 0.5F));
  const hair_model first = on_threads(1, [&] { return add_interpolated_strands(guides, 9, 0.5F, 7); });
  for (const int threads : {2, 4})
    CHECK(same_model(on_threads(threads, [&] { return add_interpolated_strands(guides, 9, 0.5F, 7); }), first));
  CHECK_FALSE(same_model(add_interpolated_strands(guides, 9, 0.5F, 8), first));
}

TEST_CASE("no strand lies between guides that are farther apart than four mean spacings") {
  for (const float gap : {3.5F, 4.5F, 1000.0F}) {
    CAPTURE(gap);
    std::vector<glm::vec3> roots = lattice(4, glm::vec3(0.0F), 1.0F);
    for (const glm::vec3& far : lattice(1, {3.0F + gap, 0.0F, 1.0F}, 1.0F))
      roots.push_back(far);
    for (const glm::vec3& far : lattice(4, {10.0F + 2.0F * gap, 0.0F, 0.0F}, 1.0F))
      roots.push_back(far);
    const hair_model guides = guides_at(roots);
    bool alone = true;
    bool across = false;
    for (const guide_mix& mix : mix_guides(guides, 40, 1)) {
      for (std::size_t g = 1; g < 3; ++g) {
        if (mix.weight[g] == 0.0F) continue;
        if (mix.guide[0] == 16) alone = false;
        if ((mix.guide[0] < 16) != (mix.guide[g] < 16) && mix.guide[0] != 16 && mix.guide[g] != 16) across = true;
      }
    }
    CHECK(alone == (gap > 4.4F));  // the far guide's own distance is in the mean, too
    CHECK_FALSE(across);
  }
}

TEST_CASE("no guides, one, two, coinciding ones and dots have strands that are defined") {
  CHECK(add_interpolated_strands({}, 5, 0.5F, 1).strand_count() == 0);
  CHECK(mix_guides({}, 5, 1).empty());

  const hair_model one = guides_at({glm::vec3(1.0F)});
  const hair_model copies = add_interpolated_strands(one, 5, 0.5F, 1);
  REQUIRE(copies.strand_count() == 6);
  for (std::size_t s = 0; s < 6; ++s)
    CHECK(same_strand(copies, s, one, 0));
  CHECK(same_model(add_interpolated_strands(one, 0, 0.5F, 1), one));

  const hair_model pair = add_interpolated_strands(guides_at({glm::vec3(0.0F), {2.0F, 0.0F, 0.0F}}), 50, 0.0F, 1);
  for (std::size_t s = 0; s < pair.strand_count(); ++s) {
    const glm::vec3 root = pair.points[pair.first_point[s]];
    CHECK((s < 51 ? root.x >= 0.0F && root.x <= 1.0F : root.x >= 1.0F && root.x <= 2.0F));
    CHECK(root.z == 0.0F);
  }

  const hair_model same = guides_at(std::vector<glm::vec3>(9, glm::vec3(0.3F, 0.1F, 0.7F)));
  const hair_model round = add_interpolated_strands(same, 4, 0.5F, 1);
  for (std::size_t i = 0; i < round.points.size(); ++i)
    CHECK(glm::distance(round.points[i], same.points[i % 4]) < 1e-6F);

  // A strand without points, and one of a single point that stands between two guides.
  const hair_model dots = model_of(
      {{}, {{1.0F, 0.0F, 0.0F}}, {{0.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}}, {{2.0F, 0.0F, 0.0F}, {2.0F, 1.0F, 0.0F}}},
      0.01F, 0.5F);
  for (const guide_mix& mix : mix_guides(dots, 20, 1)) {
    for (std::size_t g = 0; g < 3; ++g) {
      if (mix.weight[g] == 0.0F) continue;
      CHECK((mix.guide[0] < 2 ? g == 0 : mix.guide[g] >= 2));
    }
  }
  CHECK(add_interpolated_strands(dots, 3, 1.0F, 1).points.size() == 4 * (1 + 2 + 2));
}

TEST_CASE("a clump that is no share is refused, and so are more points than can be numbered") {
  const hair_model guides = guides_at(lattice(3, glm::vec3(0.0F), 1.0F));
  for (const float clump : {-0.1F, 1.1F, std::numeric_limits<float>::quiet_NaN()})
    CHECK_THROWS_AS((void)add_interpolated_strands(guides, 1, clump, 1), std::invalid_argument);
  const hair_model long_guide = model_of({std::vector<glm::vec3>(std::size_t{1} << 20U)}, 0.01F, 0.5F);
  CHECK_THROWS_AS((void)add_interpolated_strands(long_guide, 4096, 0.0F, 1), std::length_error);
}

}  // namespace pelage::test
