// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/order/order_pass.hpp"

#include <algorithm>
#include <stdexcept>

#include "frame/order/methods.hpp"
#include "frame/order/order_job.hpp"

namespace pelage::frame {

void pixel_visitor::lose_lanes(const drawn_fragments& lost, const std::array<std::uint32_t, raster::width>& tail_of,
                               std::span<tail> behind) {
  for_each_drawn(lost, [&](std::size_t k, int x, int y, const pixel_fragment& f) {
    lose(x, y, std::span(&f, 1), behind.subspan(tail_of[k], tails()));
  });
}

order_report run_order_pass(const raster& from, std::span<const float> limit, const order_options& options,
                            pixel_visitor& visitor) {
  if (std::find(compiled_k.begin(), compiled_k.end(), options.k) == compiled_k.end()) {
    throw std::invalid_argument("k must be one of 1, 2, 4, 8, 16, 32, 64");
  }
  order_job work{from, limit, options.drawing_order, visitor, {}};
  switch (options.method) {
    case order_method::k_buffer:
      run_k_buffer(work, options.k);
      break;
    case order_method::a_buffer:
      run_a_buffer(work, options.k);
      break;
    case order_method::unrolled_list:
      run_unrolled_list(work, options.k);
      break;
    case order_method::ordered_list:
      run_ordered_list(work, options.k);
      break;
    case order_method::atomic_k_buffer:
      run_atomic_k_buffer(work, options.k);
      break;
    case order_method::split_k_buffer:
      run_split_k_buffer(work, options.k);
      break;
    case order_method::partial_selection_sort:
      run_partial_selection_sort(work, options.k);
      break;
    case order_method::selection_sort:
      run_selection_sort(work);
      break;
    case order_method::full_sort:
      run_full_sort(work);
      break;
  }
  return work.report;
}

}  // namespace pelage::frame
