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

/// The sum up to a place inside a layer, from those up to its begin and through its end: a line between the two. `own`:
/// what of the layer is left out.
[[nodiscard]] constexpr float sum_inside(std::uint32_t before, std::uint32_t through, std::uint32_t own,
                                         float inside) noexcept {
  const std::uint32_t held = through - before;
  const std::uint32_t others = held > own ? held - own : 0u;
  const float most = static_cast<float>(before + others);
  const float sum = static_cast<float>(before) + inside * static_cast<float>(others);
  return sum < most ? sum : most;
}

}  // namespace detail

/// One texel of an opacity map: a sum for each layer. With slice_position() it is an opacity shadow map
/// [Kim & Neumann 2001], with equal_layer_position() or growing_layer_position() a deep opacity map
/// [Yuksel & Keyser 2008; Svoboda §1.5.4].
///
/// Keeps what each layer holds, what lies beyond the last in the last; drops where in its layer a fragment lies.
/// Depends on the set of fragments alone, bit for bit. Sums count fragments, or whatever `added` the caller gives,
/// such as optical_depth(alpha), which transmittance_of() reads back; they stop at 2³² - 1. 4 · Layers bytes, 8 more
/// with the depth_range.
template <std::uint32_t Layers>
struct opacity_map {
  static_assert(Layers > 0u, "pelage::opacity_map<Layers>: at least one layer");

  static constexpr std::uint32_t cells = Layers;  ///< a texel, for a cell_storage

  std::array<std::uint32_t, Layers> amount;  ///< of each layer; after accumulate() of it and all before it

  /// A texel without fragments.
  [[nodiscard]] static constexpr opacity_map<Layers> empty() noexcept {
    opacity_map<Layers> map;
    for (std::uint32_t i = 0u; i < Layers; ++i) {
      map.amount[i] = 0u;
    }
    return map;
  }

  /// Puts a fragment in. `position`: [0, Layers], see layer_position.hpp. Not concurrent (see
  /// atomic_opacity_map).
  constexpr void add(float position, std::uint32_t added) noexcept {
    const std::uint32_t layer = layer_at(position, Layers);
    amount[layer] = add_saturating(amount[layer], added);
  }

  /// Puts another map with the same layers in. Associative and commutative, empty() is the identity.
  constexpr void merge(const opacity_map<Layers>& other) noexcept {
    for (std::uint32_t i = 0u; i < Layers; ++i) {
      amount[i] = add_saturating(amount[i], other.amount[i]);
    }
  }

  /// The sum of all layers, before accumulate().
  [[nodiscard]] constexpr std::uint32_t total() const noexcept {
    std::uint32_t sum = 0u;
    for (std::uint32_t i = 0u; i < Layers; ++i) {
      sum = add_saturating(sum, amount[i]);
    }
    return sum;
  }

  /// The estimate of what lies before a position, from 0 to total(): each layer weighs as much of itself as lies
  /// before, by one formula without a branch [Svoboda §2.7.3, there with running sums, and §1.5.3]. Never falls as the
  /// position grows; exact at the ends of layers (so what lies at the far end of the range counts as before that end),
  /// except that sums from 2²⁴ on are rounded twice a layer, by up to 2⁻²⁴ of themselves. Where total() stops it goes
  /// on beyond. O(Layers).
  [[nodiscard]] constexpr float amount_before(float position) const noexcept {
    float sum = 0.0f;
    for (std::uint32_t i = 0u; i < Layers; ++i) {
      sum += saturate(position - static_cast<float>(i)) * static_cast<float>(amount[i]);
    }
    return sum;
  }

  /// The same for a fragment that is in the map itself, which must not lie before itself: what lies before its layer.
  [[nodiscard]] constexpr float amount_before_fragment(float position) const noexcept {
    return amount_before(static_cast<float>(layer_at(position, Layers)));
  }

  /// Replaces each sum by that of its layer and all before it, for accumulated_before(). Once, when all is in.
  constexpr void accumulate() noexcept {
    for (std::uint32_t i = 1u; i < Layers; ++i) {
      amount[i] = add_saturating(amount[i], amount[i - 1u]);
    }
  }

  /// amount_before() of a map after accumulate(), up to rounding: two sums and a line between them. O(1).
  [[nodiscard]] constexpr float accumulated_before(float position) const noexcept {
    return accumulated_before_fragment(position, 0u);
  }

  /// The same for a fragment that is in the map itself, with `own` added, which is left out of its layer: exact where
  /// its layer holds no other. Never above accumulated_before(). O(1).
  [[nodiscard]] constexpr float accumulated_before_fragment(float position, std::uint32_t own) const noexcept {
    const std::uint32_t layer = layer_at(position, Layers);
    const std::uint32_t before = layer > 0u ? amount[layer - 1u] : 0u;
    return detail::sum_inside(before, amount[layer], own, position - static_cast<float>(layer));
  }
};

/// A texel that many threads fill at once: cells [texel · Map::cells, (texel + 1) · Map::cells) of the storage, all 0
/// at first, for Map = opacity_map<Layers>.
namespace atomic_opacity_map {

/// opacity_map::add(). Lock-free; memory orders: core/atomic_cells.hpp.
template <class Map, cell_storage Storage>
void add(Storage& storage, std::uint32_t texel, float position, std::uint32_t added) noexcept {
  PELAGE_ASSERT(texel < storage.size() / Map::cells);
  add_to_cell(storage, texel * Map::cells + layer_at(position, Map::cells), added);
}

/// The texel. Not concurrent with add().
template <class Map, cell_storage Storage>
[[nodiscard]] Map load(const Storage& storage, std::uint32_t texel) noexcept {
  Map map = Map::empty();
  for (std::uint32_t i = 0u; i < Map::cells; ++i) {
    map.amount[i] = storage.load(texel * Map::cells + i, std::memory_order_relaxed);
  }
  return map;
}

}  // namespace atomic_opacity_map

/// A texel whose number of layers is known at run time alone, [1, 2³¹]: texel_cells(layers) cells of a storage from
/// `first` on, all 0 at first; a sum a layer, then a bit for each sum that passed 2³² - 1. Many threads fill it at
/// once, then, behind a barrier, one thread calls accumulate(), then look-ups read two cells, however many layers there
/// are. Gives the bits of an opacity_map with as many.
namespace layer_sums {

/// 4 bytes each.
[[nodiscard]] constexpr std::uint32_t texel_cells(std::uint32_t layers) noexcept {
  return layers + (layers + 31u) / 32u;
}

/// opacity_map::add(). Wait-free where the hardware adds atomically; memory orders: (1) and (2) of add_and_mark().
template <cell_storage Storage>
void add(Storage& storage, std::uint32_t first, std::uint32_t layers, float position, std::uint32_t added) noexcept {
  PELAGE_ASSERT(first <= storage.size() && texel_cells(layers) <= storage.size() - first);
  const std::uint32_t layer = layer_at(position, layers);
  add_and_mark(storage, first + layer, added, first + layers + layer / 32u, 1u << (layer % 32u));
}

/// opacity_map::accumulate(). O(layers). Not concurrent with anything else of the texel.
template <cell_storage Storage>
void accumulate(Storage& storage, std::uint32_t first, std::uint32_t layers) noexcept {
  std::uint32_t sum = 0u;
  for (std::uint32_t i = 0u; i < layers; ++i) {
    sum = add_saturating(sum, load_marked(storage, first + i, first + layers + i / 32u, 1u << (i % 32u)));
    raise_cell(storage, first + i, sum);
  }
}

/// opacity_map::accumulated_before_fragment(); with `own` 0 accumulated_before(). O(1). Not concurrent with add() and
/// accumulate().
template <cell_storage Storage>
[[nodiscard]] float accumulated_before(const Storage& storage, std::uint32_t first, std::uint32_t layers,
                                       float position, std::uint32_t own) noexcept {
  const std::uint32_t layer = layer_at(position, layers);
  const std::uint32_t through = storage.load(first + layer, std::memory_order_relaxed);
  const std::uint32_t before = layer > 0u ? storage.load(first + layer - 1u, std::memory_order_relaxed) : 0u;
  return detail::sum_inside(before, through, own, position - static_cast<float>(layer));
}

}  // namespace layer_sums

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
