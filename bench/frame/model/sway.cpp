// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/sway.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pelage::frame {
namespace {

constexpr double frames_a_second = 30.0;
constexpr std::array<double, 3> turns_a_second{0.6, 1.1, 0.8};

float dot(const glm::vec3& a, const glm::vec3& b) {
  return std::fma(a.z, b.z, std::fma(a.y, b.y, a.x * b.x));
}

/// Two parabolas a turn, in [-1, 1], within 0.06 of the sine up to the rounding of `turns`.
float wave(float turns) {
  const float u = std::clamp(turns - std::floor(turns + 0.5F), -0.5F, 0.5F);
  return u * std::fma(std::abs(u), -16.0F, 8.0F);
}

// Between which the wind's force is.
constexpr glm::vec3 least_force{-0.15F, -0.1F, -0.35F};
constexpr glm::vec3 greatest_force{0.85F, 0.3F, 0.35F};

/// Less than 1 long; `place` in reaches.
glm::vec3 force_at(const glm::vec3& place, const std::array<float, 3>& phase) {
  const float gust = wave(dot(place, {0.45F, 0.1F, 0.2F}) - phase[0]);
  const float ripple = wave(dot(place, {0.7F, -0.8F, -0.3F}) - phase[1]);
  const float swirl = wave(dot(place, {0.3F, 0.4F, 0.7F}) - phase[2]);
  return {std::fma(0.15F, ripple, std::fma(0.35F, gust, 0.35F)), std::fma(0.2F, ripple, 0.1F), 0.35F * swirl};
}

/// How far along each axis the end of an arm is pushed by any wind of those forces, before it turns.
box range_of_push(const glm::vec3& arm, float bend) {
  const float square = dot(arm, arm);
  box range{glm::vec3(0.0F), glm::vec3(0.0F)};
  for (int k = 0; k < 3; ++k) {
    for (int j = 0; j < 3; ++j) {
      const float share = (k == j ? square : 0.0F) - arm[k] * arm[j];
      range.lower[k] += 2.0F * bend * std::min(share * least_force[j], share * greatest_force[j]);
      range.upper[k] += 2.0F * bend * std::max(share * least_force[j], share * greatest_force[j]);
    }
  }
  return range;
}

}  // namespace

glm::vec3 wind::moved(const glm::vec3& place, const glm::vec3& root) const {
  const glm::vec3 arm = place - root;
  const glm::vec3 force = force_at(scale * place, phase);
  const float square = dot(arm, arm);
  const float along = dot(arm, force);
  // A turn about arm × force by an angle of which tangent2 is tan² of the half.
  const glm::vec3 push = bend * (square * force - along * arm);
  const float tangent2 = bend * bend * std::max(std::fma(square, dot(force, force), -(along * along)), 0.0F);
  return place + (2.0F / (1.0F + tangent2)) * (push - tangent2 * arm);
}

wind swaying_hair::wind_at(std::uint32_t frame) const {
  wind now{{}, 0.5F * amplitude / reach, 1.0F / reach};
  for (std::size_t i = 0; i < now.phase.size(); ++i) {
    const double turns = turns_a_second[i] * static_cast<double>(frame) / frames_a_second;
    now.phase[i] = static_cast<float>(turns - std::floor(turns));
  }
  return now;
}

box swaying_hair::range_of(const rest_point& p) const {
  const glm::vec3& root = rest[p.root].place;
  const glm::vec3 arm = p.place - root;
  const float bend = 0.5F * amplitude / reach;
  const box push = range_of_push(arm, bend);
  // A point is at root - arm + c (2 arm + push), c = 1 / (1 + tan²): linear in c, which is from this to 1.
  const float least = 1.0F / (1.0F + bend * bend * dot(arm, arm));
  const glm::vec3 turned = root + (2.0F * least - 1.0F) * arm;
  const glm::vec3 rounding = 1e-5F * (glm::abs(p.place) + reach);
  return {glm::min(p.place + push.lower, turned + least * push.lower) - rounding,
          glm::max(p.place + push.upper, turned + least * push.upper) + rounding};
}

swaying_hair make_swaying(const hair_model& model, float amplitude) {
  swaying_hair hair;
  if (!(amplitude > 0.0F)) return hair;
  hair.amplitude = amplitude;
  hair.rest.reserve(model.points.size());
  float most = 0.0F;
  for (std::size_t strand = 0; strand < model.strand_count(); ++strand) {
    const std::uint32_t root = model.first_point[strand];
    for (std::uint32_t i = root; i < model.first_point[strand + 1]; ++i) {
      hair.rest.push_back({model.points[i], root});
      most = std::max(most, glm::length(model.points[i] - model.points[root]));
    }
  }
  if (most > 0.0F) hair.reach = most;
  return hair;
}

box bounds_of(const hair_model& model, const swaying_hair& hair) {
  box all = model.bounds();
  for (const rest_point& p : hair.rest) {
    const box range = hair.range_of(p);
    all.lower = glm::min(all.lower, range.lower);
    all.upper = glm::max(all.upper, range.upper);
  }
  return all;
}

void sway(const swaying_hair& hair, std::uint32_t frame, strands& fibres) {
  const wind now = hair.wind_at(frame);
  const std::vector<rest_point>& rest = hair.rest;
  tbb::parallel_for(std::size_t{0}, rest.size(),
                    [&](std::size_t i) { fibres.point[i] = now.moved(rest[i].place, rest[rest[i].root].place); });
  tbb::parallel_for(std::size_t{0}, rest.size(), [&](std::size_t i) {
    if (rest[i].root != i) return;
    std::size_t end = i;
    while (end < rest.size() && rest[end].root == i)
      ++end;
    set_tangents(fibres.point, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(end), fibres.tangent);
  });
}

}  // namespace pelage::frame
