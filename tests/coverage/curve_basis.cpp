// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/coverage/curve_basis.hpp>

#include "coverage/exact_curve.hpp"
#include "property.hpp"

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <vector>

namespace pelage::test {

TEST_CASE("USD's example counts of segments and of varying values") {
  struct example {
    curve_wrap wrap;
    curve_basis basis;
    std::vector<std::uint32_t> vertices, segments, varying;
  };
  for (const example& of : {
           example{curve_wrap::nonperiodic, curve_basis::linear, {2, 3, 2, 5}, {1, 2, 1, 4}, {2, 3, 2, 5}},
           example{curve_wrap::nonperiodic, curve_basis::bezier, {4, 7, 10, 4, 7}, {1, 2, 3, 1, 2}, {2, 3, 4, 2, 3}},
           example{curve_wrap::nonperiodic, curve_basis::b_spline, {5, 4, 6, 7}, {2, 1, 3, 4}, {3, 2, 4, 5}},
           example{curve_wrap::periodic, curve_basis::bezier, {6, 9, 6}, {2, 3, 2}, {2, 3, 2}},
           example{curve_wrap::periodic, curve_basis::linear, {3, 7}, {3, 7}, {3, 7}},
           example{curve_wrap::periodic, curve_basis::catmull_rom, {3, 7}, {3, 7}, {3, 7}},
           example{curve_wrap::pinned, curve_basis::b_spline, {2, 3, 7}, {1, 2, 6}, {2, 3, 7}},
           example{curve_wrap::pinned, curve_basis::bezier, {4, 7}, {1, 2}, {2, 3}},
       }) {
    for (std::size_t k = 0; k < of.vertices.size(); ++k) {
      CHECK(curve_segments(of.basis, of.wrap, of.vertices[k]) == of.segments[k]);
      CHECK(varying_values(of.basis, of.wrap, of.vertices[k]) == of.varying[k]);
    }
  }
}

TEST_CASE("a count of vertices that no curve of its kind has makes no segment and no varying value") {
  const auto none = [](curve_basis basis, curve_wrap wrap, std::initializer_list<std::uint32_t> counts) {
    for (const std::uint32_t count : counts) {
      CHECK(curve_segments(basis, wrap, count) == 0u);
      CHECK(varying_values(basis, wrap, count) == 0u);
      CHECK(varying_at_end(basis, wrap, count, 0u) == 0u);
    }
  };
  none(curve_basis::linear, curve_wrap::nonperiodic, {0u, 1u});
  none(curve_basis::bezier, curve_wrap::nonperiodic, {0u, 1u, 2u, 3u, 5u, 6u, 8u, 4294967295u});
  none(curve_basis::bezier, curve_wrap::pinned, {0u, 3u, 5u});
  none(curve_basis::bezier, curve_wrap::periodic, {0u, 1u, 2u, 4u, 5u, 7u});
  none(curve_basis::b_spline, curve_wrap::nonperiodic, {0u, 1u, 2u, 3u});
  none(curve_basis::catmull_rom, curve_wrap::pinned, {0u, 1u});
  none(curve_basis::catmull_rom, curve_wrap::periodic, {0u, 1u, 2u});
}

TEST_CASE("each number of a segment is a vertex's, whatever the segment's own number") {
  for_each_kind([](curve_basis basis, curve_wrap wrap) {
    for (std::uint32_t count = 1; count < 12; ++count) {
      const std::uint32_t segments = curve_segments(basis, wrap, count);
      for (std::uint32_t i = 0; i < std::max(segments, 1u); ++i) {
        for (const std::uint32_t vertex : vertices_of_segment(basis, wrap, count, i).vertex)
          CHECK(vertex < count);
        CHECK(varying_at_end(basis, wrap, count, i) < std::max(varying_values(basis, wrap, count), 1u));
      }
    }
  });
}

template <class Real>
void check_basis(curve_basis basis, curve_wrap wrap) {
  const auto vertices = drawn_vertices<Real>(basis, wrap);
  const auto expected = exact_segments(basis, wrap, exact_values(vertices));
  const auto found = segments_of(basis, wrap, vertices);
  RC_ASSERT(found.size() == expected.size());
  const long double rounding = 16.0L * std::numeric_limits<Real>::epsilon();
  for (std::size_t i = 0; i < found.size(); ++i) {
    std::array<exact_value, 4> bezier;
    std::copy(found[i].point.begin(), found[i].point.end(), bezier.begin());
    long double size = 0;
    for (const exact_value& v : expected[i])
      size = std::max(size, size_of(v) + std::abs(v.w));
    for (int k = 0; k <= 8; ++k) {
      const exact_value difference =
          exact_point(curve_basis::bezier, bezier, k / 8.0L) - exact_point(basis, expected[i], k / 8.0L);
      RC_ASSERT(size_of(difference) + std::abs(difference.w) <= rounding * size);
    }
  }
}

TEST_CASE("segments are those of the bases' definitions, with phantom and repeated vertices written out") {
  holds("for every basis and wrap", [] {
    for_each_kind([](curve_basis basis, curve_wrap wrap) {
      check_basis<float>(basis, wrap);
      check_basis<double>(basis, wrap);
    });
  });
}

TEST_CASE("neighbours share an end bit for bit, periodic curves close, pinned ones begin and end at a vertex") {
  holds("for every basis and wrap", [] {
    for_each_kind([](curve_basis basis, curve_wrap wrap) {
      const auto vertices = drawn_vertices<float>(basis, wrap);
      const auto found = segments_of(basis, wrap, vertices);
      for (std::size_t i = 0; i + 1 < found.size(); ++i)
        RC_ASSERT(found[i].point[3] == found[i + 1].point[0]);
      if (wrap == curve_wrap::periodic) {
        RC_ASSERT(found.back().point[3] == found.front().point[0]);
      } else if (wrap == curve_wrap::pinned || basis == curve_basis::bezier || basis == curve_basis::linear) {
        RC_ASSERT(found.front().point[0] == vertices.front());
        RC_ASSERT(found.back().point[3] == vertices.back());
      }
    });
  });
}

TEST_CASE("vertices in reverse order give the same points in reverse order") {
  holds("for every basis, not periodic", [] {
    for_each_kind([](curve_basis basis, curve_wrap wrap) {
      if (wrap == curve_wrap::periodic) return;
      auto vertices = drawn_vertices<float>(basis, wrap);
      const auto forth = segments_of(basis, wrap, vertices);
      std::reverse(vertices.begin(), vertices.end());
      const auto back = segments_of(basis, wrap, vertices);
      for (std::size_t i = 0; i < forth.size(); ++i) {
        auto points = back[back.size() - 1 - i].point;
        std::reverse(points.begin(), points.end());
        RC_ASSERT(points == forth[i].point);
      }
    });
  });
}

TEST_CASE("what all vertices share comes back exactly") {
  holds("for every basis and wrap", [] {
    for_each_kind([](curve_basis basis, curve_wrap wrap) {
      auto vertices = drawn_vertices<float>(basis, wrap);
      for (glm::vec4& vertex : vertices)
        vertex.w = vertices.front().w;
      for (const bezier_segment<float>& curve : segments_of(basis, wrap, vertices)) {
        for (const glm::vec4& point : curve.point)
          RC_ASSERT(point.w == vertices.front().w);
      }
    });
  });
}

TEST_CASE("a varying radius is linear along the segment and leaves the place alone") {
  holds("from end to end", [] {
    const auto curve = segments_of(curve_basis::b_spline, curve_wrap::pinned,
                                   drawn_vertices<double>(curve_basis::b_spline, curve_wrap::pinned))
                           .front();
    const double start = 1e-3 * *rc::gen::inRange(0, 1000);
    const double end = 1e-3 * *rc::gen::inRange(0, 1000);
    const auto varied = with_varying(curve, start, end);
    const auto straight = straight_segment(glm::dvec4(start), glm::dvec4(end));
    for (std::size_t k = 0; k < 4; ++k) {
      RC_ASSERT(glm::dvec3(varied.point[k]) == glm::dvec3(curve.point[k]));
      RC_ASSERT(varied.point[k].w == straight.point[k].w);
      RC_ASSERT(std::abs(varied.point[k].w - (start + (end - start) * static_cast<double>(k) / 3.0)) < 1e-15);
    }
    RC_ASSERT(varied.point[3].w == end);
  });
}

TEST_CASE("NaN and infinity stay in their component") {
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    values_of_curve<float> vertices(6, glm::vec4(1.0f));
    vertices[2].y = bad;
    for_each_kind([&](curve_basis basis, curve_wrap wrap) {
      for (const bezier_segment<float>& curve : segments_of(basis, wrap, vertices)) {
        for (const glm::vec4& point : curve.point)
          CHECK((point.x == 1.0f && point.z == 1.0f && point.w == 1.0f));
      }
    });
  }
}

}  // namespace pelage::test
