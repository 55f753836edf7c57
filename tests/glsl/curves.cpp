// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/coverage/curve_basis.hpp>
#include <pelage/coverage/flatten_curve.hpp>

#include <array>
#include <cstdint>

#include "glsl/comparison.hpp"
#include "glsl/kernels.hpp"
#include "property.hpp"

namespace pelage::test {

TEST_CASE("Curves are cut into as many pieces on every device, their points have the same bits or a division's error") {
  const auto place = between(-4.0F, 4.0F);
  const auto error = rc::gen::weightedOneOf<std::uint32_t>({{6, magnitude(-20, 2)}, {1, any_normal_float()}});
  holds("curves", [&] {
    compare(kernels::curves, {place,      place,      place,      place,      place, place, place,           place,
                              place,      place,      place,      place,      place, place, place,           place,
                              any_word(), any_word(), any_word(), any_word(), error, error, magnitude(-8, 2)},
            [](row in, results& out) {
              const auto basis = static_cast<curve_basis>(in.u(16) % 4U);
              const auto wrap = static_cast<curve_wrap>(in.u(17) % 3U);
              const std::uint32_t vertices = in.u(18) % 20U;
              const std::uint32_t segment = in.u(19) % 20U;
              out.put(curve_segments(basis, wrap, vertices));
              out.put(varying_values(basis, wrap, vertices));
              out.put(varying_at_end(basis, wrap, vertices, segment));
              const segment_vertices from = vertices_of_segment(basis, wrap, vertices, segment);
              for (const std::uint32_t vertex : from.vertex)
                out.put(vertex);
              out.put(from.phantom_start);
              out.put(from.phantom_end);
              const auto curve = bezier_of(basis, from, std::array{in.v4(0), in.v4(4), in.v4(8), in.v4(12)});
              for (const glm::vec4& point : curve.point)
                out.put(point);
              const std::uint32_t pieces = pieces_within(curve, in.f(20), in.f(21));
              out.put(pieces);
              out.put(piece_error(curve, pieces));
              out.put(radius_piece_error(curve, pieces));
              out.put(point_of_piece(curve, segment, 19U));
              out.put(greatest_piece_length(in.f(20), in.f(21)));
              out.put(error_on_screen(curve, in.f(20), in.f(22)));
              const auto varied = with_varying(straight_segment(in.v4(0), in.v4(4)), in.f(20), in.f(21));
              out.put(varied.point[1]);
              out.put(varied.point[2]);
            },
            {{"curve_segments", 1, bits(), bits()},
             {"varying_values", 1, bits(), bits()},
             {"varying_at_end", 1, bits(), bits()},
             {"vertices_of_segment", 6, bits(), bits()},
             {"bezier_of", 16, 0, 0},
             {"pieces_within", 1, bits(), bits()},
             {"piece_error", 1, 0, 8},
             {"radius_piece_error", 1, 0, 8},
             {"point_of_piece", 4, 0, 32, 4.0F},
             {"greatest_piece_length", 1, 0, 4},
             {"error_on_screen", 1, 0, 16},
             {"with_varying", 8, 0, 0}});
  });
}

}  // namespace pelage::test
