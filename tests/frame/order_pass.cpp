// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/order/order_pass.hpp"

#include <pelage/core/fragment.hpp>

#include "frame/fibres.hpp"
#include "frame/model/built_in.hpp"
#include "frame/order_methods.hpp"
#include "frame/raster/sweep.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace pelage::test {

using namespace frame;

bool keeps_all(order_method method) {
  return method == order_method::selection_sort || method == order_method::full_sort;
}

/// What a pass left in each pixel, as numbers that compare bit for bit.
using pages = std::vector<std::vector<std::uint32_t>>;

std::size_t pixel_of(const raster& from, int x, int y) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(from.from().width) + static_cast<std::size_t>(x);
}

std::size_t pixels_of(const raster& from) {
  return pixel_of(from, 0, from.from().height);
}

tail with(const tail& behind, const pixel_fragment& lost) {
  const glm::vec3 colour(static_cast<float>(lost.id), lost.depth, lost.along);
  return add_fragment(behind, lost.coverage, colour);
}

/// The pixel's tail that a recorder puts a fragment into.
std::size_t tail_of(const pixel_fragment& lost, std::size_t tails) {
  return lost.id % tails;
}

std::vector<std::uint32_t> page_of(std::span<const pixel_fragment> nearest, std::span<const tail> behind) {
  std::vector<std::uint32_t> page;
  for (const pixel_fragment& f : nearest) {
    for (const float value : {f.depth, f.coverage, f.along})
      page.push_back(std::bit_cast<std::uint32_t>(value));
    page.push_back(f.id);
  }
  for (const tail& t : behind)
    page.insert(page.end(), {t.optical, t.weight, t.red, t.green, t.blue});
  return page;
}

/// Writes down all that a pass tells it.
struct recorder : pixel_visitor {
  const raster& from;
  std::vector<std::uint32_t> expected;
  pages written;

  std::size_t tails_a_pixel;

  explicit recorder(const raster& r, std::size_t tails = 1) : from(r), written(pixels_of(r)), tails_a_pixel(tails) {}

  void expect(std::span<const std::uint32_t> counts) override { expected.assign(counts.begin(), counts.end()); }
  [[nodiscard]] std::size_t tails() const override { return tails_a_pixel; }
  void lose(int, int, std::span<const pixel_fragment> lost, std::span<tail> behind) override {
    if (behind.size() != tails_a_pixel) throw std::logic_error("a pixel has another number of tails");
    for (const pixel_fragment& f : lost) {
      tail& t = behind[tail_of(f, tails_a_pixel)];
      t = with(t, f);
    }
  }
  void finish(int x, int y, std::span<const pixel_fragment> nearest, std::span<const tail> behind) override {
    std::vector<std::uint32_t>& page = written[pixel_of(from, x, y)];
    if (!page.empty()) throw std::logic_error("a pixel is finished twice");
    page = page_of(nearest, behind);
  }
};

/// The fragments of each pixel in the order of drawing, found one by one.
std::vector<std::vector<pixel_fragment>> arrivals(const raster& from, std::span<const float> limit,
                                                  std::span<const std::uint32_t> order) {
  std::vector<std::vector<pixel_fragment>> lists(pixels_of(from));
  for (std::uint32_t i = 0; i < from.fibres().segment_count(); ++i) {
    const std::uint32_t segment = order.empty() ? i : order[i];
    from.for_each(segment, whole(from.from()), [&](int x, int y, const pixel_fragment& f) {
      const std::size_t p = pixel_of(from, x, y);
      if (limit.empty() || f.depth < limit[p]) lists[p].push_back(f);
    });
  }
  return lists;
}

bool nearer(const pixel_fragment& a, const pixel_fragment& b) {
  return before(fragment_of(a), fragment_of(b));
}

/// What a pass has to leave: the first K of the sorted fragments, and the others in the tail.
pages truth(const raster& from, std::span<const float> limit, std::size_t k, std::size_t tails = 1) {
  pages pages;
  for (std::vector<pixel_fragment>& list : arrivals(from, limit, {})) {
    std::sort(list.begin(), list.end(), nearer);
    const std::size_t kept = std::min(k, list.size());
    std::vector<tail> behind(tails, empty_tail());
    for (std::size_t i = kept; i < list.size(); ++i) {
      tail& t = behind[tail_of(list[i], tails)];
      t = with(t, list[i]);
    }
    pages.push_back(page_of(std::span(list).first(kept), behind));
  }
  return pages;
}

order_report run_on(int count, const raster& from, std::span<const float> limit, const order_options& options,
                    pixel_visitor& visitor) {
  return on_threads(count, [&] { return run_order_pass(from, limit, options, visitor); });
}

/// The model and the same strands once more, so that depths tie.
hair_model doubled(const hair_model& once) {
  hair_model twice = once;
  for (std::size_t s = 1; s <= once.strand_count(); ++s) {
    twice.first_point.push_back(once.first_point.back() + once.first_point[s]);
  }
  twice.points.insert(twice.points.end(), once.points.begin(), once.points.end());
  twice.thickness.insert(twice.thickness.end(), once.thickness.begin(), once.thickness.end());
  twice.colour.insert(twice.colour.end(), once.colour.begin(), once.colour.end());
  return twice;
}

TEST_CASE("every method leaves the K nearest in order and the rest in its tails, whoever comes first") {
  holds("any fibres, limit, K, number of tails, order of drawing and number of threads", [] {
    const hair_model model = model_of(any_lines(8, glm::vec3(0.0F), 1.0F), any_float(0.0F, 0.1F), 1.0F);
    const strands fibres = prepare_strands(doubled(model), {});
    const view v = any_perspective(3.0F, 0.1F);
    const raster from(fibres, v, *rc::gen::arbitrary<bool>());
    std::vector<float> limit;
    if (*rc::gen::arbitrary<bool>()) {
      for (std::size_t p = 0; p < pixels_of(from); ++p)
        limit.push_back(2.0F + 0.1F * static_cast<float>(p % 20));
    }
    const auto seed = *rc::gen::arbitrary<std::uint32_t>();
    const std::vector<std::uint32_t> order = shuffled(fibres.segment_count(), seed);
    const std::uint32_t k = *rc::gen::elementOf(compiled_k);
    const std::size_t tails = *rc::gen::element<std::size_t>(1, 2, 5);
    const int count = *rc::gen::element(1, 2, 4);

    std::vector<std::uint32_t> counts;
    std::uint64_t beyond_k = 0;
    for (const std::vector<pixel_fragment>& list : arrivals(from, limit, {})) {
      counts.push_back(static_cast<std::uint32_t>(list.size()));
      beyond_k += list.size() > k ? list.size() - k : 0;
    }
    const pages first_k = truth(from, limit, k, tails);
    const pages all = truth(from, limit, 0xffffffff, tails);
    for (const order_method method : all_methods) {
      recorder seen(from, tails);
      const order_report report = run_on(count, from, limit, {method, k, order}, seen);
      RC_ASSERT(seen.written == (keeps_all(method) ? all : first_k));
      RC_ASSERT(seen.expected == (keeps_all(method) ? counts : std::vector<std::uint32_t>{}));
      RC_ASSERT(report.fragments == std::accumulate(counts.begin(), counts.end(), std::uint64_t{0}));
      RC_ASSERT(report.longest == *std::max_element(counts.begin(), counts.end()));
      RC_ASSERT(report.behind == (keeps_all(method) ? 0U : beyond_k));
      RC_ASSERT(report.refused == 0U);
    }
  });
}

/// Thick hair, every depth of it there twice.
struct hair_with_ties {
  strands fibres = prepare_strands(doubled(make_built_in(200, 12, 1)), {0.02F, -1.0F});
  view from = perspective_view({0.0F, 0.0F, 7.0F}, {0.0F, -0.6F, 0.0F}, 0.3F, 64, 64, 0.1F);
  raster fragments{fibres, from, true};
};

TEST_CASE("all methods agree on hair, on 1, 2 and 4 threads, and keep their fragments") {
  const hair_with_ties hair;
  const raster& from = hair.fragments;
  const std::vector<std::uint32_t> order = shuffled(hair.fibres.segment_count(), 7);
  const pages first_k = truth(from, {}, 4);
  const pages all = truth(from, {}, 0xffffffff);
  for (const order_method method : all_methods) {
    for (const int count : {1, 2, 4}) {
      CAPTURE(static_cast<int>(method));
      CAPTURE(count);
      recorder seen(from);
      const order_report report = run_on(count, from, {}, {method, 4, order}, seen);
      CHECK(seen.written == (keeps_all(method) ? all : first_k));
      CHECK(report.refused == 0);
      CHECK(report.longest > 8);  // the tails matter
    }
  }
}

TEST_CASE("a K that the renderer is not compiled for is refused") {
  const strands none = fibres_of({}, 0.0F, 1.0F);
  const view v = flat_view(1);
  const raster from(none, v, true);
  recorder seen(from);
  for (const std::uint32_t k : {0U, 3U, 65U, 128U}) {
    CHECK_THROWS_AS(run_order_pass(from, {}, {order_method::k_buffer, k, {}}, seen), std::invalid_argument);
  }
}

// What follows shows that the tests above would notice: the same comparison of drawing orders, with seeded faults. ----

/// True if `draw`, given an order of drawing, does not always come to the same result.
template <class Draw>
bool depends_on_drawing_order(std::uint32_t segments, const Draw& draw) {
  const auto by_number = draw(std::vector<std::uint32_t>{});
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    if (!same_bits(draw(shuffled(segments, seed)), by_number)) return true;
  }
  return false;
}

std::vector<std::uint32_t> in_one(const pages& all) {
  std::vector<std::uint32_t> bits;
  for (const std::vector<std::uint32_t>& page : all)
    bits.insert(bits.end(), page.begin(), page.end());
  return bits;
}

/// The fault of a tail that adds up floats: (a + b) + c is not a + (b + c).
struct float_tail : recorder {
  std::vector<float> sum;

  explicit float_tail(const raster& r) : recorder(r), sum(pixels_of(r), 0.0F) {}

  void lose(int x, int y, std::span<const pixel_fragment> lost, std::span<tail>) override {
    for (const pixel_fragment& f : lost)
      sum[pixel_of(from, x, y)] += f.coverage * f.depth;
  }
};

TEST_CASE("drawing orders leave the same bits, but not with ties by arrival, nor with a tail of floats") {
  const hair_with_ties hair;
  const raster& from = hair.fragments;
  const std::uint32_t segments = hair.fibres.segment_count();

  CHECK_FALSE(depends_on_drawing_order(segments, [&](std::span<const std::uint32_t> order) {
    recorder seen(from);
    run_order_pass(from, {}, {order_method::k_buffer, 4, order}, seen);
    return in_one(seen.written);
  }));
  CHECK(depends_on_drawing_order(segments, [&](std::span<const std::uint32_t> order) {
    float_tail seen(from);
    run_order_pass(from, {}, {order_method::k_buffer, 4, order}, seen);
    return seen.sum;
  }));
  CHECK(depends_on_drawing_order(segments, [&](std::span<const std::uint32_t> order) {
    pages written;
    for (std::vector<pixel_fragment>& list : arrivals(from, {}, order)) {
      std::stable_sort(list.begin(), list.end(),
                       [](const pixel_fragment& a, const pixel_fragment& b) { return a.depth < b.depth; });
      written.push_back(page_of(list, {}));
    }
    return in_one(written);
  }));
}

}  // namespace pelage::test
