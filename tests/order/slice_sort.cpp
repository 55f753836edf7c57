// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/slice_sort.hpp>

#include "property.hpp"
#include "visibility/cells.hpp"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

namespace pelage::test {

/// The draw order of segments from their slices, by chunks that threads work on.
std::vector<std::uint32_t> order_of(const std::vector<std::uint32_t>& slice, std::uint32_t slices, std::size_t chunks,
                                    std::uint32_t threads) {
  std::vector<std::uint32_t> counts(chunks * slices);
  std::vector<std::uint32_t> order(slice.size(), 0xffffffffu);
  const std::size_t length = slice.size() / chunks + 1u;
  const auto part = [&](std::size_t c) {
    const std::size_t begin = std::min(c * length, slice.size());
    return std::span(slice).subspan(begin, std::min(length, slice.size() - begin));
  };
  const auto counts_of = [&](std::size_t c) { return std::span(counts).subspan(c * slices, slices); };
  deal_to_threads(threads, chunks, [&](std::size_t c) { slice_sort::count(part(c), counts_of(c)); });
  slice_sort::place(counts, slices);
  deal_to_threads(threads, chunks, [&](std::size_t c) {
    slice_sort::fill(part(c), static_cast<std::uint32_t>(std::min(c * length, slice.size())), counts_of(c), order);
  });
  return order;
}

TEST_CASE("the order is a stable sort by slice, for any chunks and threads") {
  holds("any slices", [] {
    const auto slices = *rc::gen::inRange<std::uint32_t>(1u, 12u);
    const auto slice = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0u, slices));
    std::vector<std::uint32_t> expected(slice.size());
    std::iota(expected.begin(), expected.end(), 0u);
    std::stable_sort(expected.begin(), expected.end(), [&](auto a, auto b) { return slice[a] < slice[b]; });
    for (const std::size_t chunks : {1u, 2u, 7u}) {
      RC_ASSERT(order_of(slice, slices, chunks, 1u) == expected);
      RC_ASSERT(order_of(slice, slices, chunks, 4u) == expected);
    }
  });
}

float draw_position(std::uint32_t slices) {
  return static_cast<float>(*rc::gen::inRange<std::uint32_t>(0u, 16u * slices + 1u)) / 16.0f;
}

TEST_CASE("a segment's slice is that of its farther end, the last for the end of all") {
  holds("any ends", [] {
    const auto slices = *rc::gen::inRange<std::uint32_t>(1u, 12u);
    const float a = draw_position(slices);
    const float b = draw_position(slices);
    const float farther = std::min(std::max(a, b), static_cast<float>(slices) - 0.5f);
    RC_ASSERT(slice_sort::slice_of(a, b, slices) == static_cast<std::uint32_t>(farther));
    RC_ASSERT(slice_sort::slice_of(b, a, slices) == slice_sort::slice_of(a, b, slices));
  });
  CHECK(slice_sort::slice_of(std::numeric_limits<float>::quiet_NaN(), 0.0f, 4u) == 0u);
}

TEST_CASE("the pieces of a cut segment lie in neighbouring slices and join without gap or overlap") {
  holds("any ends", [] {
    const auto slices = *rc::gen::inRange<std::uint32_t>(1u, 12u);
    const float a = draw_position(slices);
    const float b = draw_position(slices);
    const std::uint32_t count = slice_sort::piece_count(a, b, slices);
    float joint = 0.0f;
    for (std::uint32_t i = 0u; i < count; ++i) {
      const slice_sort::piece p = slice_sort::piece_at(a, b, slices, i);
      RC_ASSERT(p.slice < slices);
      RC_ASSERT(p.begin == joint);
      RC_ASSERT(p.end >= p.begin);
      const double from = a + (double{b} - a) * p.begin;
      const double to = a + (double{b} - a) * p.end;
      RC_ASSERT(std::min(from, to) >= p.slice - 1e-5);
      RC_ASSERT(std::max(from, to) <= p.slice + 1.0 + 1e-5);
      joint = p.end;
    }
    RC_ASSERT(joint == 1.0f);
  });
}

TEST_CASE("no piece crosses a plane, so pieces drawn slice by slice are in depth order between slices") {
  holds("two segments", [] {
    const float a = draw_position(8u);
    const float b = draw_position(8u);
    const std::uint32_t pieces = slice_sort::piece_count(a, b, 8u);
    const slice_sort::piece first = slice_sort::piece_at(a, b, 8u, 0u);
    const slice_sort::piece last = slice_sort::piece_at(a, b, 8u, pieces - 1u);
    RC_ASSERT(std::max(first.slice, last.slice) == slice_sort::slice_of(a, b, 8u));
    RC_ASSERT(std::max(first.slice, last.slice) - std::min(first.slice, last.slice) + 1u == pieces);
  });
}

TEST_CASE("an order is stale from a turn of acos 0.95 on, and one for no direction always") {
  holds("any direction and turn", [] {
    const double azimuth = *rc::gen::inRange(0, 628) / 100.0;
    const double height = *rc::gen::inRange(-99, 100) / 100.0;
    const double width = std::sqrt(1.0 - height * height);
    const glm::dvec3 axis(width * std::cos(azimuth), width * std::sin(azimuth), height);
    const glm::dvec3 across(-std::sin(azimuth), std::cos(azimuth), 0.0);
    const double degrees = *rc::gen::inRange(0, 1801) / 10.0;
    const double turn = degrees * 0.017453292519943295;
    const glm::dvec3 seen = std::cos(turn) * axis + std::sin(turn) * across;
    RC_ASSERT(slice_sort::is_stale(glm::vec3(axis), glm::vec3(seen)) == (degrees > 18.194872338766785));
  });
  CHECK(slice_sort::is_stale(glm::vec3(0.0f), glm::vec3(0.0f, 0.0f, 1.0f)));
  CHECK(slice_sort::is_stale(glm::vec3(0.0f, 0.0f, 1.0f), glm::vec3(std::numeric_limits<float>::quiet_NaN())));
}

}  // namespace pelage::test
