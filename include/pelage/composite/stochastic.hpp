// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/atomic_cells.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/core/mixed_bits.hpp>

#include <array>
#include <atomic>
#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// True if a fragment is opaque in the sample of this number.
[[nodiscard]] constexpr bool takes_sample(std::uint32_t id, float alpha, std::uint32_t stream,
                                          std::uint32_t number) noexcept {
  const std::uint32_t drawn = mixed_bits(mixed_bits(id ^ stream) + number * 0x9e3779b9u);
  return static_cast<float>(drawn >> 8u) * (1.0f / 16777216.0f) < alpha;
}

/// Stochastic transparency [Enderton et al. 2010]: each of a pixel's samples takes a fragment as opaque with the
/// probability alpha and keeps the nearest depth that it took, like an ordinary depth buffer. The share of samples in
/// which nothing lies before a depth is an estimate, right on average, of the transmittance up to it.
///
/// Which samples a fragment takes depends on the seed, the pixel, its id and the sample's number alone, so that the
/// state depends on the set of fragments alone, bit for bit, in every frame. For the alpha-corrected colour (§3.3)
/// weigh each fragment in a second pass by alpha times transmittance_before(its depth) with add_weighted().
/// 4 · Samples bytes.
template <std::uint32_t Samples>
struct stochastic_depths {
  static_assert(Samples > 0u, "pelage::stochastic_depths<Samples>: at least one sample");

  static constexpr std::uint32_t cells = Samples;  ///< a pixel, for a cell_storage

  std::array<std::uint32_t, Samples> nearest;  ///< key of the nearest depth in each sample; all ones: none

  /// A pixel with nothing in it.
  [[nodiscard]] static constexpr stochastic_depths<Samples> empty() noexcept {
    stochastic_depths<Samples> none;
    for (std::uint32_t i = 0u; i < Samples; ++i) {
      none.nearest[i] = 0xffffffffu;
    }
    return none;
  }

  /// Adds a fragment; what is_fragment() refuses changes nothing. `alpha`: [0, 1]; 0 takes no sample, 1 takes all.
  /// `stream`: stochastic_stream() of the pixel. Not concurrent (see atomic_stochastic_depths). O(Samples).
  constexpr void add(fragment f, float alpha, std::uint32_t stream) noexcept {
    if (!is_fragment(f)) {
      return;
    }
    const std::uint32_t key = depth_key(f.depth);
    for (std::uint32_t i = 0u; i < Samples; ++i) {
      const bool taken = takes_sample(f.id, alpha, stream, i);
      nearest[i] = taken && key < nearest[i] ? key : nearest[i];
    }
  }

  /// The share of samples that hold nothing before a depth, [0, 1]; never rises with depth. A NaN depth lies
  /// before or behind all.
  [[nodiscard]] constexpr float transmittance_before(float depth) const noexcept {
    const std::uint32_t key = depth_key(depth);
    std::uint32_t open = 0u;
    for (std::uint32_t i = 0u; i < Samples; ++i) {
      open += nearest[i] >= key ? 1u : 0u;
    }
    return static_cast<float>(open) / static_cast<float>(Samples);
  }
};

/// The numbers that one pixel draws under a seed: two pixels, or two seeds, draw others.
[[nodiscard]] constexpr std::uint32_t stochastic_stream(std::uint32_t seed, std::uint32_t pixel) noexcept {
  return mixed_bits(mixed_bits(seed) + pixel);
}

/// A pixel that many threads fill at once: cells [pixel · Depths::cells, (pixel + 1) · Depths::cells) of the storage,
/// all ones at first, for Depths = stochastic_depths<Samples>.
namespace atomic_stochastic_depths {

/// stochastic_depths::add() with the stream of the pixel under a seed. Lock-free; memory orders: core/atomic_cells.hpp.
template <class Depths, cell_storage Storage>
void add(Storage& storage, std::uint32_t pixel, fragment f, float alpha, std::uint32_t seed) noexcept {
  PELAGE_ASSERT(pixel < storage.size() / Depths::cells);
  if (!is_fragment(f)) {
    return;
  }
  const std::uint32_t stream = stochastic_stream(seed, pixel);
  for (std::uint32_t i = 0u; i < Depths::cells; ++i) {
    if (takes_sample(f.id, alpha, stream, i)) {
      lower_cell(storage, pixel * Depths::cells + i, depth_key(f.depth));
    }
  }
}

/// The pixel. Not concurrent with add().
template <class Depths, cell_storage Storage>
[[nodiscard]] Depths load(const Storage& storage, std::uint32_t pixel) noexcept {
  Depths depths = Depths::empty();
  for (std::uint32_t i = 0u; i < Depths::cells; ++i) {
    depths.nearest[i] = storage.load(pixel * Depths::cells + i, std::memory_order_relaxed);
  }
  return depths;
}

}  // namespace atomic_stochastic_depths

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
