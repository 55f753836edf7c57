// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/strands.hpp"

#include <tbb/parallel_for.h>

#include <cmath>

namespace pelage::frame {
namespace {

/// The direction from the first to the last of the given points; the one before it stands in where they coincide.
glm::vec3 direction_or(const glm::vec3& from, const glm::vec3& to, const glm::vec3& otherwise) {
  const glm::vec3 d = to - from;
  const float length2 = glm::dot(d, d);
  return length2 > 0.0F ? d / std::sqrt(length2) : otherwise;
}

void set_tangents(const hair_model& model, std::uint32_t first, std::uint32_t end, std::vector<glm::vec3>& tangent) {
  glm::vec3 last(0.0F, 1.0F, 0.0F);
  for (std::uint32_t i = first; i < end; ++i) {
    const std::uint32_t before = i > first ? i - 1 : i;
    const std::uint32_t after = i + 1 < end ? i + 1 : i;
    last = direction_or(model.points[before], model.points[after], last);
    tangent[i] = last;
  }
}

template <class T>
std::vector<T> per_point(const std::vector<T>& given, const T& otherwise, std::size_t count) {
  return given.empty() ? std::vector<T>(count, otherwise) : given;
}

}  // namespace

strands prepare_strands(const hair_model& model, const strand_overrides& overrides) {
  const std::size_t count = model.points.size();
  strands s;
  s.point = model.points;
  s.tangent.resize(count);
  s.end_of.assign(count, 0);
  s.colour = per_point(model.colour, model.default_colour, count);
  s.radius = overrides.radius >= 0.0F ? std::vector<float>(count, overrides.radius)
                                      : per_point(model.thickness, model.default_thickness, count);
  if (overrides.radius < 0.0F) {
    for (float& r : s.radius)
      r *= 0.5F;
  }
  s.opacity = overrides.opacity >= 0.0F ? std::vector<float>(count, overrides.opacity)
                                        : per_point(model.transparency, model.default_transparency, count);
  if (overrides.opacity < 0.0F) {
    for (float& o : s.opacity)
      o = 1.0F - o;
  }
  const bool one_opacity = overrides.opacity >= 0.0F || model.transparency.empty();
  if (one_opacity && count > 0) s.same_opacity = s.opacity.front();

  s.segment.reserve(model.segment_count());
  for (std::size_t strand = 0; strand < model.strand_count(); ++strand) {
    const std::uint32_t first = model.first_point[strand];
    const std::uint32_t end = model.first_point[strand + 1];
    for (std::uint32_t i = first; i + 1 < end; ++i)
      s.segment.push_back(i);
    if (first == end) continue;
    s.end_of[first] |= strands::first;
    s.end_of[end - 1] |= strands::last;
  }
  tbb::parallel_for(std::size_t{0}, model.strand_count(), [&](std::size_t strand) {
    set_tangents(model, model.first_point[strand], model.first_point[strand + 1], s.tangent);
  });
  return s;
}

}  // namespace pelage::frame
