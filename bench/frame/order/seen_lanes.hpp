// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/lane_moves.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "frame/order/order_pass.hpp"

namespace pelage::frame {

/// A vector's worth of seen fragments.
struct seen_lanes {
  static constexpr int width = raster::width;
  using pack = lanes<width>;
  using integers = pack::integers;

  integers id;
  pack depth, coverage, along;

  /// `width` fragments from memory, and back.
  [[nodiscard]] static seen_lanes load(const seen_fragment* from);
  void store(seen_fragment* to) const;

  /// Bit k is set where the fragment of that depth_key() and id is before() lane k's.
  [[nodiscard]] std::uint32_t behind(pack::naturals last_key, pack::naturals last_id) const;

  /// Those whose bit is set, in their order.
  [[nodiscard]] seen_lanes packed_left(std::uint32_t set) const;
};

/// The opacity of each, looked up, times its coverage.
[[nodiscard]] inline seen_lanes::pack alpha_of(const strands& fibres, const seen_lanes& all);

/// Calls `use(seen_lanes)` until each of the fragments has been in it once. Lanes without one have coverage 0, depth 0
/// and the id of one of them.
template <class Use>
void for_each_lanes(std::span<const seen_fragment> all, Use&& use);

// ---------------------------------------------------------------------------------------------------------

static_assert(sizeof(seen_fragment) == 4 * sizeof(float));

inline seen_lanes seen_lanes::load(const seen_fragment* from) {
  seen_lanes f;
  pack number;
  load_quads(reinterpret_cast<const float*>(from), number, f.depth, f.coverage, f.along);
  f.id = reinterpret_cast<integers>(number.lane);
  return f;
}

inline void seen_lanes::store(seen_fragment* to) const {
  store_quads(pack(reinterpret_cast<pack::vector>(id)), depth, coverage, along, reinterpret_cast<float*>(to));
}

inline std::uint32_t seen_lanes::behind(pack::naturals last_key, pack::naturals last_id) const {
  using naturals = pack::naturals;
  const naturals depth_bits = reinterpret_cast<naturals>(depth.lane);
  const naturals sign = naturals{} + 0x80000000U;
  const naturals flipped = depth_bits >= sign ? ~depth_bits : depth_bits | sign;
  const naturals key = depth_bits == sign ? sign : flipped;
  const auto later = (last_key < key) | ((last_key == key) & (last_id < reinterpret_cast<naturals>(id)));
  return bits(lane_mask<width>{later});
}

inline seen_lanes seen_lanes::packed_left(std::uint32_t set) const {
  const pack number = pelage::packed_left(set, pack(reinterpret_cast<pack::vector>(id)));
  return {reinterpret_cast<integers>(number.lane), pelage::packed_left(set, depth), pelage::packed_left(set, coverage),
          pelage::packed_left(set, along)};
}

inline seen_lanes::pack alpha_of(const strands& fibres, const seen_lanes& all) {
  if (fibres.same_opacity) return seen_lanes::pack(*fibres.same_opacity) * all.coverage;
  seen_lanes::pack opacity;
  for (int k = 0; k < seen_lanes::width; ++k)
    opacity.lane[k] = fibres.mix(fibres.opacity, static_cast<std::uint32_t>(all.id[k]), all.along.lane[k]);
  return opacity * all.coverage;
}

template <class Use>
void for_each_lanes(std::span<const seen_fragment> all, Use&& use) {
  constexpr std::size_t width = seen_lanes::width;
  const std::size_t whole = all.size() / width * width;
  for (std::size_t i = 0; i < whole; i += width)
    use(seen_lanes::load(&all[i]));
  const std::span<const seen_fragment> rest = all.subspan(whole);
  if (rest.empty()) return;
  std::array<seen_fragment, width> few;
  std::fill(std::copy(rest.begin(), rest.end(), few.begin()), few.end(), seen_fragment{rest[0].id, {0.0F, 0.0F, 0.0F}});
  use(seen_lanes::load(few.data()));
}

}  // namespace pelage::frame
