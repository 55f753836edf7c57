// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/strands.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pelage::frame {
namespace {

/// The direction from the first to the last of the given points; the one before it stands in where they coincide.
glm::vec3 direction_or(const glm::vec3& from, const glm::vec3& to, const glm::vec3& otherwise) {
  const glm::vec3 d = to - from;
  const float length2 = glm::dot(d, d);
  return length2 > 0.0F ? d / std::sqrt(length2) : otherwise;
}

/// A value per point, each made by `make` from what the model gives.
template <class T, class Make>
big_array<T> per_point(const std::vector<T>& given, const T& otherwise, std::size_t count, Make&& make) {
  big_array<T> all(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { all[i] = make(given.empty() ? otherwise : given[i]); });
  return all;
}

/// Where each strand's segments begin in a list of all.
std::vector<std::uint32_t> first_segments(const hair_model& model) {
  std::vector<std::uint32_t> first(model.strand_count());
  std::uint32_t next = 0;
  for (std::size_t strand = 0; strand < first.size(); ++strand) {
    first[strand] = next;
    next += std::max(model.point_count(strand), 1U) - 1U;
  }
  return first;
}

}  // namespace

void set_tangents(std::span<const glm::vec3> point, std::uint32_t first, std::uint32_t end,
                  big_array<glm::vec3>& tangent) {
  glm::vec3 last(0.0F, 1.0F, 0.0F);
  for (std::uint32_t i = first; i < end; ++i) {
    const std::uint32_t before = i > first ? i - 1 : i;
    const std::uint32_t after = i + 1 < end ? i + 1 : i;
    last = direction_or(point[before], point[after], last);
    tangent[i] = last;
  }
}

strands prepare_strands(const hair_model& model, const strand_overrides& overrides) {
  const std::size_t count = model.points.size();
  const auto same = [](const auto& value) { return value; };
  const bool own_radius = overrides.radius < 0.0F;
  const bool own_opacity = overrides.opacity < 0.0F;
  const std::vector<float> none;
  strands s;
  s.point = per_point(model.points, glm::vec3(0.0F), count, same);
  s.tangent.resize(count);
  s.end_of.assign(count, 0);
  s.colour = per_point(model.colour, model.default_colour, count, same);
  s.radius = own_radius ? per_point(model.thickness, model.default_thickness, count, [](float t) { return 0.5F * t; })
                        : per_point(none, overrides.radius, count, same);
  s.opacity = own_opacity
                  ? per_point(model.transparency, model.default_transparency, count, [](float t) { return 1.0F - t; })
                  : per_point(none, overrides.opacity, count, same);
  const bool one_opacity = !own_opacity || model.transparency.empty();
  if (one_opacity && count > 0) s.same_opacity = s.opacity.front();

  s.segment.resize(model.segment_count());
  const std::vector<std::uint32_t> first_segment = first_segments(model);
  tbb::parallel_for(std::size_t{0}, model.strand_count(), [&](std::size_t strand) {
    const std::uint32_t first = model.first_point[strand];
    const std::uint32_t end = model.first_point[strand + 1];
    if (first == end) return;
    for (std::uint32_t i = first; i + 1 < end; ++i)
      s.segment[first_segment[strand] + (i - first)] = i;
    s.end_of[first] |= strands::first;
    s.end_of[end - 1] |= strands::last;
    set_tangents(model.points, first, end, s.tangent);
  });
  return s;
}

}  // namespace pelage::frame
