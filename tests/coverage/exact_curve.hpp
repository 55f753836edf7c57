// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/coverage/curve_basis.hpp>

#include <glm/vec4.hpp>
#include <rapidcheck.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

/// Splines by their definitions in long double, over lists that hold the phantom and the repeated vertices.
namespace pelage::test {

using exact_value = glm::vec<4, long double>;

constexpr std::array all_bases{curve_basis::linear, curve_basis::bezier, curve_basis::b_spline,
                               curve_basis::catmull_rom};
constexpr std::array all_wraps{curve_wrap::nonperiodic, curve_wrap::periodic, curve_wrap::pinned};

/// A segment by its basis: de Casteljau, Cox-de Boor over whole knots, Catmull and Rom's pyramid.
inline exact_value exact_point(curve_basis basis, const std::array<exact_value, 4>& v, long double t) {
  const auto mix = [](const exact_value& a, const exact_value& b, long double u) { return a + (b - a) * u; };
  std::array<exact_value, 4> p = v;
  if (basis == curve_basis::linear) {
    return mix(v[0], v[1], t);
  }
  if (basis == curve_basis::catmull_rom) {
    const exact_value left = mix(mix(v[0], v[1], t + 1), mix(v[1], v[2], t), (t + 1) / 2);
    const exact_value right = mix(mix(v[1], v[2], t), mix(v[2], v[3], t - 1), t / 2);
    return mix(left, right, t);
  }
  for (int level = 1; level <= 3; ++level) {
    for (int i = 3; i >= level; --i) {
      const auto k = static_cast<std::size_t>(i);
      const long double knots = 4 - level;
      p[k] = mix(p[k - 1], p[k], basis == curve_basis::bezier ? t : (t + static_cast<long double>(3 - i)) / knots);
    }
  }
  return p[3];
}

/// The vertices of each segment of a nonperiodic curve.
inline std::vector<std::array<exact_value, 4>> exact_segments(curve_basis basis, curve_wrap wrap,
                                                              std::vector<exact_value> v) {
  const std::size_t width = basis == curve_basis::linear ? 2 : 4;
  const std::size_t stride = basis == curve_basis::bezier ? 3 : 1;
  if (wrap == curve_wrap::periodic) {
    const std::size_t n = v.size();
    for (std::size_t k = 0; k < width - stride; ++k)
      v.push_back(v.at(k % n));
  } else if (wrap == curve_wrap::pinned && width == 4 && stride == 1) {
    const exact_value before = v[0] + (v[0] - v[1]);
    const exact_value after = v.back() + (v.back() - v[v.size() - 2]);
    v.insert(v.begin(), before);
    v.push_back(after);
  }
  std::vector<std::array<exact_value, 4>> segments;
  for (std::size_t i = 0; i + width <= v.size(); i += stride) {
    std::array<exact_value, 4> segment{};
    std::copy_n(v.begin() + static_cast<std::ptrdiff_t>(i), width, segment.begin());
    segments.push_back(segment);
  }
  return segments;
}

template <class Real>
using values_of_curve = std::vector<glm::vec<4, Real>>;

/// Vertices of a curve that has segments: any, on a line, few places so that many are equal, or all equal.
template <class Real>
values_of_curve<Real> drawn_vertices(curve_basis basis, curve_wrap wrap) {
  std::uint32_t count = static_cast<std::uint32_t>(*rc::gen::inRange(2, 14));
  while (curve_segments(basis, wrap, count) == 0u)
    ++count;
  const int kind = *rc::gen::inRange(0, 6);
  const int places = kind == 1 ? 2 : kind == 2 ? 1 : 10'000;
  const Real scale = std::exp2(static_cast<Real>(*rc::gen::inRange(-12, 13)));
  values_of_curve<Real> vertices;
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto coordinate = [&] { return static_cast<Real>(*rc::gen::inRange(0, places)) / Real(10'000) * scale; };
    glm::vec<4, Real> vertex(coordinate(), coordinate(), coordinate(), coordinate());
    if (kind == 3) vertex.y = vertex.z = vertex.x * Real(0.7);
    vertices.push_back(vertex);
  }
  return vertices;
}

template <class Real>
std::vector<exact_value> exact_values(const values_of_curve<Real>& vertices) {
  return {vertices.begin(), vertices.end()};
}

template <class Real>
bezier_segment<Real> segment_of(curve_basis basis, curve_wrap wrap, const values_of_curve<Real>& v,
                                std::uint32_t segment) {
  const segment_vertices from = vertices_of_segment(basis, wrap, static_cast<std::uint32_t>(v.size()), segment);
  std::array<glm::vec<4, Real>, 4> value;
  for (std::size_t k = 0; k < 4; ++k)
    value[k] = v.at(from.vertex[k]);
  if (from.phantom_start) value[0] = glm::vec<4, Real>(std::numeric_limits<Real>::quiet_NaN());  // must not be read
  if (from.phantom_end) value[3] = glm::vec<4, Real>(std::numeric_limits<Real>::quiet_NaN());
  return bezier_of(basis, from, value);
}

template <class Real>
std::vector<bezier_segment<Real>> segments_of(curve_basis basis, curve_wrap wrap, const values_of_curve<Real>& v) {
  std::vector<bezier_segment<Real>> segments;
  const std::uint32_t count = curve_segments(basis, wrap, static_cast<std::uint32_t>(v.size()));
  for (std::uint32_t i = 0; i < count; ++i)
    segments.push_back(segment_of(basis, wrap, v, i));
  return segments;
}

/// Calls see(basis, wrap) for every kind of curve.
template <class See>
void for_each_kind(See see) {
  for (const curve_basis basis : all_bases) {
    for (const curve_wrap wrap : all_wraps)
      see(basis, wrap);
  }
}

inline long double size_of(const exact_value& v) {
  return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

template <class Real>
long double largest_size(const bezier_segment<Real>& curve) {
  long double size = 0;
  for (const glm::vec<4, Real>& p : curve.point)
    size = std::max(size, size_of(exact_value(p)));
  return size;
}

template <class Real>
long double largest_radius(const bezier_segment<Real>& curve) {
  long double size = 0;
  for (const glm::vec<4, Real>& p : curve.point)
    size = std::max(size, std::abs(static_cast<long double>(p.w)));
  return size;
}

}  // namespace pelage::test
