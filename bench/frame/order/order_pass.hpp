// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/tail.hpp>
#include <pelage/core/fragment.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "frame/raster/raster.hpp"

namespace pelage::frame {

/// How the fragments of a pixel are put in order.
enum class order_method {
  k_buffer,                ///< the K nearest, built tile by tile as fragments arrive
  a_buffer,                ///< all fragments in lists that threads build at once, then the K nearest [Yu12 §5.1]
  unrolled_list,           ///< the same with lists of blocks, one for what a batch leaves in a pixel
  ordered_list,            ///< as a_buffer with lists that are sorted while they are built [Yu12 §5.2]
  atomic_k_buffer,         ///< the K nearest, built by all threads with 64-bit atomics; cascade_k_buffer on a device
  split_k_buffer,          ///< the same with 32-bit atomics, depths before ids
  partial_selection_sort,  ///< all fragments in lists, each sorted by selection up to the K-th
  selection_sort,          ///< all fragments, each list sorted whole by selection [Yang10]
  full_sort                ///< all fragments, each list sorted whole by std::sort: the truth
};

/// The K that the renderer is compiled for.
inline constexpr std::array<std::uint32_t, 7> compiled_k{1, 2, 4, 8, 16, 32, 64};

/// What becomes of the fragments once they are in order. Calls for different pixels come from many threads at once,
/// those for one pixel from one thread after the other.
class pixel_visitor {
 public:
  virtual ~pixel_visitor() = default;

  /// How many fragments each pixel has, before any other call; only from the methods that keep all of them.
  virtual void expect(std::span<const std::uint32_t> fragments_per_pixel) = 0;

  /// How many tails a pixel has, all empty at first. The same at every call.
  [[nodiscard]] virtual std::size_t tails() const { return 1; }

  /// Fragments that are not among the K nearest go to the pixel's tails: in any order, any number at a time, and
  /// before finish().
  virtual void lose(int x, int y, std::span<const pixel_fragment> lost, std::span<tail> behind) = 0;

  /// The same for fragments of any pixels, all of one thread; lane k's pixel has the tails from behind[tail_of[k]] on.
  /// At least one lane is set; those that are not hold the number of some segment.
  virtual void lose_lanes(const drawn_fragments& lost, const std::array<std::uint32_t, raster::width>& tail_of,
                          std::span<tail> behind);

  /// The pixel's fragments, nearest first, and its tails; none where all are kept. Once a pixel, pixels without
  /// fragments included.
  virtual void finish(int x, int y, std::span<const pixel_fragment> nearest, std::span<const tail> behind) = 0;
};

/// What a pass did and what it took.
struct order_report {
  std::uint64_t fragments = 0;  ///< offered
  std::uint64_t behind = 0;     ///< of those, in tails: not among the K nearest
  std::uint64_t refused = 0;    ///< lost to a NaN depth or a full pool: 0, or the frame is wrong
  std::uint32_t longest = 0;    ///< fragments of the pixel that has most
  std::uint64_t bytes = 0;      ///< of the structure, the tiles' lists of segments included
  double bin_seconds = 0;       ///< cutting the view into tiles, or counting fragments
  double build_seconds = 0;     ///< fragments to structure; for k_buffer all the rest, too
  double resolve_seconds = 0;   ///< structure to what becomes of it; 0 for k_buffer
};

struct order_options {
  order_method method = order_method::k_buffer;
  std::uint32_t k = 16;                          ///< one of compiled_k
  std::span<const std::uint32_t> drawing_order;  ///< empty: by number
};

/// Draws all segments of a raster. Fragments at or behind `limit` (view depth, one a pixel; or empty) are hidden and
/// go nowhere. Throws std::runtime_error when the lists would not fit 32-bit node numbers.
order_report run_order_pass(const raster& from, std::span<const float> limit, const order_options& options,
                            pixel_visitor& visitor);

}  // namespace pelage::frame
