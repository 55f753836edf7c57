// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/atomic_cells.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>
#include <pelage/visibility/layer_position.hpp>

#include <array>
#include <atomic>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

namespace detail {

/// Where in its bin a position lies, [0, 512].
[[nodiscard]] constexpr std::uint32_t step_in_bin(float position, std::uint32_t bin) noexcept {
  return static_cast<std::uint32_t>(saturate(position - static_cast<float>(bin)) * 512.0f + 0.5f);
}

}  // namespace detail

/// One texel's fragments as K clusters, each with its number, mean depth and variance. [Mertens et al. 2004, §3]
///
/// A cluster here is one of K equal bins of the depth range, where the paper moves them by k-means. Between
/// mean ± √3 σ, clamped to its bin, a cluster's fragments lie evenly. Depths in a bin are rounded to 512 steps and
/// summed as integers, so the state depends on the set of fragments alone, bit for bit; the sums stop at 2³² - 1,
/// squares from 16,384 fragments a bin on. 12 K bytes, 8 more with the depth_range.
template <std::uint32_t K>
struct density_clusters {
  static_assert(K > 0u, "pelage::density_clusters<K>: at least one cluster");

  static constexpr std::uint32_t cells = 3u * K;  ///< a texel, for a cell_storage

  std::array<std::uint32_t, K> count;    ///< fragments in each bin
  std::array<std::uint32_t, K> sum;      ///< of their positions in the bin, 512 steps to a bin
  std::array<std::uint32_t, K> squares;  ///< of those

  /// A texel without fragments.
  [[nodiscard]] static constexpr density_clusters<K> empty() noexcept {
    density_clusters<K> none;
    for (std::uint32_t i = 0u; i < K; ++i) {
      none.count[i] = 0u;
      none.sum[i] = 0u;
      none.squares[i] = 0u;
    }
    return none;
  }

  /// Puts a fragment in. `position`: slice_position(relative depth, K), [0, K]. Not concurrent (see
  /// atomic_density_clusters). O(1).
  constexpr void add(float position) noexcept {
    const std::uint32_t bin = layer_at(position, K);
    const std::uint32_t place = detail::step_in_bin(position, bin);
    count[bin] = add_saturating(count[bin], 1u);
    sum[bin] = add_saturating(sum[bin], place);
    squares[bin] = add_saturating(squares[bin], place * place);
  }

  /// The estimate of how many fragments lie before a position, from 0 to their number. Never falls as the position
  /// grows; exact at the ends of bins. O(K).
  [[nodiscard]] float count_before(float position) const noexcept;
};

/// A texel that many threads fill at once: cells [texel · Map::cells, (texel + 1) · Map::cells) of the storage, all 0
/// at first, for Map = density_clusters<K>.
namespace atomic_density_clusters {

/// density_clusters::add(). Lock-free; memory orders: core/atomic_cells.hpp.
template <class Map, cell_storage Storage>
void add(Storage& storage, std::uint32_t texel, float position) noexcept {
  PELAGE_ASSERT(texel < storage.size() / Map::cells);
  const std::uint32_t bins = Map::cells / 3u;
  const std::uint32_t bin = layer_at(position, bins);
  const std::uint32_t place = detail::step_in_bin(position, bin);
  const std::uint32_t first = texel * Map::cells + bin;
  add_to_cell(storage, first, 1u);
  add_to_cell(storage, first + bins, place);
  add_to_cell(storage, first + 2u * bins, place * place);
}

/// The texel. Not concurrent with add().
template <class Map, cell_storage Storage>
[[nodiscard]] Map load(const Storage& storage, std::uint32_t texel) noexcept {
  const std::uint32_t bins = Map::cells / 3u;
  const std::uint32_t first = texel * Map::cells;
  Map clusters = Map::empty();
  for (std::uint32_t i = 0u; i < bins; ++i) {
    clusters.count[i] = storage.load(first + i, std::memory_order_relaxed);
    clusters.sum[i] = storage.load(first + bins + i, std::memory_order_relaxed);
    clusters.squares[i] = storage.load(first + 2u * bins + i, std::memory_order_relaxed);
  }
  return clusters;
}

}  // namespace atomic_density_clusters

// ---------------------------------------------------------------------------------------------------------

template <std::uint32_t K>
float density_clusters<K>::count_before(float position) const noexcept {
  float before = 0.0f;
  for (std::uint32_t i = 0u; i < K; ++i) {
    const float number = static_cast<float>(count[i]);
    const float inside = saturate(position - static_cast<float>(i));
    if (count[i] > 0u) {
      const float mean = static_cast<float>(sum[i]) / number;
      const float variance = static_cast<float>(squares[i]) / number - mean * mean;
      const float reach = 1.73205081f * safe_sqrt(variance);
      const float from = saturate((mean - reach) * (1.0f / 512.0f));
      const float to = saturate((mean + reach) * (1.0f / 512.0f));
      const float whole = inside > to || inside == 1.0f ? 1.0f : 0.0f;
      before += number * (to > from && inside < 1.0f ? saturate((inside - from) / (to - from)) : whole);
    }
  }
  return before;
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
