// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/exact_begin.hpp>
#include <pelage/version.hpp>

#include <glm/vec4.hpp>

#include <array>
#include <concepts>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// Hair stored as splines, by the rules of USD's BasisCurves and RenderMan's Curves: vertices, a basis and a wrap give
/// segments, each of which is a cubic Bézier curve here, whatever its basis. flatten_curve.hpp makes lines of them.

/// What a segment makes of its vertices. Bézier segments share an end vertex, 3 after the other's; those of the other
/// bases begin 1 vertex apart.
enum class curve_basis : std::uint32_t {
  linear,      ///< through all vertices, straight
  bezier,      ///< cubic
  b_spline,    ///< cubic, uniform knots
  catmull_rom  ///< cubic, uniform knots: through all vertices that have a neighbour on both sides
};

/// What happens at a curve's ends.
enum class curve_wrap : std::uint32_t {
  nonperiodic,  ///< the vertices alone
  periodic,     ///< closed: the first vertices follow the last again
  pinned  ///< B-splines and Catmull-Rom from the first vertex to the last, by P₋₁ = 2 P₀ - P₁ and its like at the end
};

/// How many segments a curve has. 0 for a count of vertices that no curve of the kind has: fewer than 2 for linear and
/// pinned ones, 4 for nonperiodic cubic ones, 3 for periodic ones; or Bézier vertices left over, which are in no
/// segment. Linear and Bézier curves are the same pinned as nonperiodic. O(1).
[[nodiscard]] constexpr std::uint32_t curve_segments(curve_basis basis, curve_wrap wrap,
                                                     std::uint32_t vertices) noexcept;

/// How many values an attribute has that varies linearly along each segment ("varying"): one where each segment begins,
/// and one at the end of a curve that is not periodic. One of the rule "vertex" has as many as vertices.
[[nodiscard]] constexpr std::uint32_t varying_values(curve_basis basis, curve_wrap wrap,
                                                     std::uint32_t vertices) noexcept;

/// The varying value at a segment's end; that at its start has the segment's own number. 0 at the end of a periodic
/// one.
[[nodiscard]] constexpr std::uint32_t varying_at_end(curve_basis basis, curve_wrap wrap, std::uint32_t vertices,
                                                     std::uint32_t segment) noexcept;

/// The four vertices of a segment. A linear one is between the two in the middle.
struct segment_vertices {
  std::array<std::uint32_t, 4> vertex;  ///< numbers in the curve
  bool phantom_start;                   ///< of a pinned curve: the first one is the second mirrored, not a vertex
  bool phantom_end;                     ///< the same for the last
};

/// `segment` in [0, curve_segments()). Each number is one of a vertex, phantoms' too, as long as there is any. O(1).
[[nodiscard]] constexpr segment_vertices vertices_of_segment(curve_basis basis, curve_wrap wrap, std::uint32_t vertices,
                                                             std::uint32_t segment) noexcept;

/// A cubic Bézier curve of four numbers: place and radius, or colour and opacity.
template <std::floating_point Real>
struct bezier_segment {
  std::array<glm::vec<4, Real>, 4> point;
};

/// A straight one with even speed: a linear segment, or an attribute that varies linearly or, from `a` to `a`, not.
template <std::floating_point Real>
[[nodiscard]] bezier_segment<Real> straight_segment(const glm::vec<4, Real>& start,
                                                    const glm::vec<4, Real>& end) noexcept;

/// A segment as a Bézier curve. `value`: those of its vertices, of which a phantom's is not read. What all values share
/// comes back exactly.
///
/// Neighbours share an end bit for bit, periodic curves close bit for bit, and vertices in reverse order give the same
/// points in reverse order. Ends of linear, Bézier and Catmull-Rom segments, and of pinned curves, are vertices
/// exactly. Cubic bases overshoot: a radius may fall below 0 between positive vertices of Catmull-Rom. NaN and
/// infinities give NaN or infinities in their component alone.
template <std::floating_point Real>
[[nodiscard]] bezier_segment<Real> bezier_of(curve_basis basis, const segment_vertices& from,
                                             const std::array<glm::vec<4, Real>, 4>& value) noexcept;

/// The same curve with a fourth number, a radius or opacity, that varies linearly.
template <std::floating_point Real>
[[nodiscard]] bezier_segment<Real> with_varying(const bezier_segment<Real>& curve, Real start, Real end) noexcept;

// ---------------------------------------------------------------------------------------------------------

constexpr std::uint32_t curve_segments(curve_basis basis, curve_wrap wrap, std::uint32_t vertices) noexcept {
  const std::uint32_t stride = basis == curve_basis::bezier ? 3u : 1u;
  if (wrap == curve_wrap::periodic) {
    return vertices >= 3u && vertices % stride == 0u ? vertices / stride : 0u;
  }
  if (basis == curve_basis::linear || (wrap == curve_wrap::pinned && basis != curve_basis::bezier)) {
    return vertices >= 2u ? vertices - 1u : 0u;
  }
  return vertices >= 4u && (vertices - 4u) % stride == 0u ? (vertices - 4u) / stride + 1u : 0u;
}

constexpr std::uint32_t varying_values(curve_basis basis, curve_wrap wrap, std::uint32_t vertices) noexcept {
  const std::uint32_t segments = curve_segments(basis, wrap, vertices);
  return segments == 0u || wrap == curve_wrap::periodic ? segments : segments + 1u;
}

constexpr std::uint32_t varying_at_end(curve_basis basis, curve_wrap wrap, std::uint32_t vertices,
                                       std::uint32_t segment) noexcept {
  return segment + 1u < varying_values(basis, wrap, vertices) ? segment + 1u : 0u;
}

constexpr segment_vertices vertices_of_segment(curve_basis basis, curve_wrap wrap, std::uint32_t vertices,
                                               std::uint32_t segment) noexcept {
  const std::uint32_t count = vertices > 0u ? vertices : 1u;
  if (basis == curve_basis::linear) {
    const std::uint32_t start = segment % count;
    const std::uint32_t end = (segment + 1u) % count;
    return segment_vertices{{start, start, end, end}, false, false};
  }
  if (wrap == curve_wrap::pinned && basis != curve_basis::bezier) {
    const std::uint32_t start = segment % count;
    const std::uint32_t end = (segment + 1u) % count;
    const bool first = segment == 0u;
    const bool last = segment + 2u >= vertices;
    return segment_vertices{{first ? start : start - 1u, start, end, last ? end : end + 1u}, first, last};
  }
  const std::uint32_t first = segment * (basis == curve_basis::bezier ? 3u : 1u);
  return segment_vertices{
      {first % count, (first + 1u) % count, (first + 2u) % count, (first + 3u) % count}, false, false};
}

namespace detail {

/// A third of the way from a to b, and exactly a where they are equal.
template <std::floating_point Real>
[[nodiscard]] glm::vec<4, Real> third_of_way(const glm::vec<4, Real>& a, const glm::vec<4, Real>& b) noexcept {
  return a + (b - a) * Real(0.33333333333333333);
}

/// Where two segments of a B-spline meet.
template <std::floating_point Real>
[[nodiscard]] glm::vec<4, Real> b_spline_knot(const glm::vec<4, Real>& before, const glm::vec<4, Real>& at,
                                              const glm::vec<4, Real>& after) noexcept {
  return at + ((before - at) + (after - at)) * Real(0.16666666666666667);
}

}  // namespace detail

template <std::floating_point Real>
bezier_segment<Real> straight_segment(const glm::vec<4, Real>& start, const glm::vec<4, Real>& end) noexcept {
  return bezier_segment<Real>{{start, detail::third_of_way(start, end), detail::third_of_way(end, start), end}};
}

template <std::floating_point Real>
bezier_segment<Real> bezier_of(curve_basis basis, const segment_vertices& from,
                               const std::array<glm::vec<4, Real>, 4>& value) noexcept {
  if (basis == curve_basis::bezier) {
    return bezier_segment<Real>{value};
  }
  bezier_segment<Real> curve = straight_segment(value[1], value[2]);
  if (basis == curve_basis::b_spline) {
    if (!from.phantom_start) {
      curve.point[0] = detail::b_spline_knot(value[0], value[1], value[2]);
    }
    if (!from.phantom_end) {
      curve.point[3] = detail::b_spline_knot(value[1], value[2], value[3]);
    }
  } else if (basis == curve_basis::catmull_rom) {
    // Beside a phantom the tangent is the chord, as straight_segment() has it.
    if (!from.phantom_start) {
      curve.point[1] = value[1] + (value[2] - value[0]) * Real(0.16666666666666667);
    }
    if (!from.phantom_end) {
      curve.point[2] = value[2] + (value[1] - value[3]) * Real(0.16666666666666667);
    }
  }
  return curve;
}

template <std::floating_point Real>
bezier_segment<Real> with_varying(const bezier_segment<Real>& curve, Real start, Real end) noexcept {
  bezier_segment<Real> varied = curve;
  varied.point[0].w = start;
  varied.point[1].w = start + (end - start) * Real(0.33333333333333333);
  varied.point[2].w = end + (start - end) * Real(0.33333333333333333);
  varied.point[3].w = end;
  return varied;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
