// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/blends/sliced.hpp"

#include <pelage/order/slice_pieces.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include "frame/order/list_pass.hpp"

namespace pelage::frame {
namespace {

/// A fragment of a clipped piece, and what puts it in order.
struct piece_fragment {
  std::pair<std::uint32_t, std::uint32_t> key;  ///< slice, segment
  pixel_fragment seen;
};

}  // namespace

order_report draw_sliced(camera_film& film, const raster& from, const slice_order& order, at_planes how) {
  const auto piece_of = [&](const pixel_fragment& f) {
    const float at = order.position(from.mix(from.fibres().point, f.id, f.along));
    return piece_fragment{{slice_sort::slice_at(at, order.slices), f.id}, f};
  };
  return run_list_pass(from, film.limit(), order.segments, [&](int x, int y, std::span<pixel_fragment> all) {
    if (how == at_planes::clipped) {
      static thread_local std::vector<piece_fragment> pieces;
      pieces.clear();
      for (const pixel_fragment& f : all)
        pieces.push_back(piece_of(f));
      std::sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a.key < b.key; });
      for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = pieces[i].seen;
    }
    film.finish(x, y, all, {});
  });
}

}  // namespace pelage::frame
