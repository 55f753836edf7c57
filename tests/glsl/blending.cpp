// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/depth_peeling.hpp>
#include <pelage/composite/order_weighted.hpp>
#include <pelage/composite/stochastic.hpp>
#include <pelage/composite/weighted_average.hpp>
#include <pelage/composite/weighted_blended.hpp>
#include <pelage/composite/weighted_sum.hpp>
#include <pelage/order/slice_pieces.hpp>

#include <algorithm>

#include "glsl/comparison.hpp"
#include "glsl/kernels.hpp"
#include "property.hpp"

namespace pelage::test {

namespace {

constexpr std::size_t fragments = 8;  ///< for each invocation, as in the kernel

void put(results& out, fragment f) {
  out.put(f.depth);
  out.put(f.id);
}

void blending_row(row in, results& out) {
  const glm::vec3 colour = in.v3(3 * fragments);
  const glm::vec3 background(colour.z, colour.y, colour.x);
  const float share = in.f(3 * fragments + 3);
  const float order = in.f(3 * fragments + 4);
  const std::uint32_t seed = in.u(3 * fragments + 5);
  tail weighted = empty_tail();
  weighted_average average = weighted_average::empty();
  weighted_average others = weighted_average::empty();
  stochastic_depths<16> depths = stochastic_depths<16>::empty();
  for (std::size_t i = 0; i < fragments; ++i) {
    const fragment offered{in.f(3 * i), in.u(3 * i + 1)};
    const float alpha = in.f(3 * i + 2);
    weighted = add_weighted(weighted, alpha, depth_weight(alpha, share), colour);
    (i % 2 == 0 ? average : others).add(alpha, colour);
    depths.add(offered, alpha, stochastic_stream(seed, i % 2));
  }
  average.merge(others);
  depth_peeling peeled = depth_peeling::begin();
  dual_depth_peeling dual = dual_depth_peeling::begin();
  for (int pass = 0; pass < 5; ++pass) {
    for (std::size_t i = 0; i < fragments; ++i) {
      const fragment offered{in.f(3 * i), in.u(3 * i + 1)};
      peeled.offer(offered);
      dual.offer(offered);
    }
    put(out, peeled.layer());
    put(out, dual.front());
    put(out, dual.back());
    peeled.advance();
    dual.advance();
  }
  for (const std::uint32_t sum : {weighted.optical, weighted.weight, weighted.red, weighted.green, weighted.blue})
    out.put(sum);
  out.put(resolve(weighted, background));
  out.put(resolve_unscaled(weighted, background));
  for (const std::uint32_t sum : {average.count, average.sums.optical, average.sums.weight, average.sums.red})
    out.put(sum);
  out.put(average.transmittance());
  out.put(average.resolve(background));
  for (const std::uint32_t key : depths.nearest)
    out.put(key);
  out.put(depths.transmittance_before(order));
  out.put(order_weight(share, order));
  out.put(optical_weight(share, order));
  out.put(depth_weight(share, order));
  out.put(distance_weight(share, 0.05F * order, 6.0F));
  const float end = in.f(3 * fragments + 6);
  const std::uint32_t pieces = slice_sort::piece_count(order, end, 20U);
  out.put(slice_sort::slice_of(order, end, 20U));
  out.put(pieces);
  for (std::uint32_t i = 0; i < 5; ++i) {
    const slice_sort::piece piece = slice_sort::piece_at(order, end, 20U, std::min(i, pieces - 1U));
    out.put(piece.slice);
    out.put(piece.begin);
    out.put(piece.end);
  }
}

}  // namespace

TEST_CASE("Blending without sorting has the same sums on every device, its colours differ by the stated ulps") {
  const auto unit = between(0.0F, 1.0F);
  const auto share = rc::gen::weightedOneOf<std::uint32_t>({{6, unit}, {1, any_float()}});
  std::vector<rc::Gen<std::uint32_t>> inputs;
  for (std::size_t i = 0; i < fragments; ++i) {
    inputs.push_back(rc::gen::weightedOneOf<std::uint32_t>({{3, between(1.0F, 20.0F)}, {1, any_float()}}));
    inputs.push_back(rc::gen::weightedOneOf<std::uint32_t>({{3, few_words()}, {1, any_word()}}));
    inputs.push_back(share);
  }
  inputs.insert(inputs.end(), {unit, unit, unit, share, between(0.0F, 20.0F), any_word(), between(0.0F, 20.0F)});
  std::vector<column> columns;
  for (std::size_t pass = 0; pass < 5; ++pass) {
    for (const char* peeling : {"depth_peeling layer", "dual_depth_peeling front", "dual_depth_peeling back"}) {
      columns.push_back({peeling, 1, 0, 0});
      columns.push_back({peeling, 1, bits(), bits()});
    }
  }
  columns.insert(columns.end(), {{"add_weighted", 5, bits(), bits()},
                                 {"resolve, resolve_unscaled of weighted sums", 6, 0, 4},
                                 {"weighted_average add, merge", 4, bits(), bits()},
                                 {"weighted_average transmittance", 1, 0, 64, 1.0F},
                                 {"weighted_average resolve", 3, 0, 64, 1.0F},
                                 {"stochastic_depths add", 16, bits(), bits()},
                                 {"stochastic_depths transmittance_before", 1, 0, 3},
                                 {"order_weight", 1, 0, 0},
                                 {"optical_weight", 1, 0, 0},
                                 {"depth_weight", 1, 0, 0},
                                 {"distance_weight", 1, 0, 0},
                                 {"slice_of, piece_count", 2, bits(), bits()}});
  for (std::size_t i = 0; i < 5; ++i) {
    columns.push_back({"piece_at slice", 1, bits(), bits()});
    columns.push_back({"piece_at", 2, 0, 3});
  }
  holds("blending", [&] { compare(kernels::blending, inputs, blending_row, columns); });
}

}  // namespace pelage::test
