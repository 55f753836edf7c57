// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/lane_moves.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "frame/order_pass.hpp"

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

  /// Writes fragment_of() each.
  void store_fragments(fragment* to) const;

  /// Bit k is set where a fragment is before lane k's.
  [[nodiscard]] std::uint32_t behind(fragment last) const;

  /// Those whose bit is set, in their order.
  [[nodiscard]] seen_lanes packed_left(std::uint32_t set) const;
};

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

inline void seen_lanes::store_fragments(fragment* to) const {
  const pack number(reinterpret_cast<pack::vector>(id));
  zip_low(depth, number).store(reinterpret_cast<float*>(to));
  zip_high(depth, number).store(reinterpret_cast<float*>(to) + width);
}

inline std::uint32_t seen_lanes::behind(fragment last) const {
  // depth_key() and before() of each lane.
  using naturals = pack::naturals;
  const naturals depth_bits = reinterpret_cast<naturals>(depth.lane);
  const naturals sign = naturals{} + 0x80000000U;
  const naturals flipped = depth_bits >= sign ? ~depth_bits : depth_bits | sign;
  const naturals key = depth_bits == sign ? sign : flipped;
  const naturals last_key = naturals{} + depth_key(last.depth);
  const naturals last_id = naturals{} + last.id;
  const auto later = (last_key < key) | ((last_key == key) & (last_id < reinterpret_cast<naturals>(id)));
  return bits(lane_mask<width>{later});
}

inline seen_lanes seen_lanes::packed_left(std::uint32_t set) const {
  const pack number = pelage::packed_left(set, pack(reinterpret_cast<pack::vector>(id)));
  return {reinterpret_cast<integers>(number.lane), pelage::packed_left(set, depth), pelage::packed_left(set, coverage),
          pelage::packed_left(set, along)};
}

template <class Use>
void for_each_lanes(std::span<const seen_fragment> all, Use&& use) {
  constexpr std::size_t width = seen_lanes::width;
  const std::size_t whole = all.size() / width * width;
  for (std::size_t i = 0; i < whole; i += width)
    use(seen_lanes::load(&all[i]));
  const std::size_t rest = all.size() - whole;
  if (rest == 0) return;
  std::array<seen_fragment, width> few;
  const seen_fragment* last = few.data();
  if (whole > 0) {
    last = &all[all.size() - width];  // those seen before lose their coverage
  } else {
    std::copy(all.begin(), all.end(), std::fill_n(few.begin(), width - rest, all[0]));
  }
  seen_lanes f = seen_lanes::load(last);
  using pack = seen_lanes::pack;
  pack number;
  for (int k = 0; k < seen_lanes::width; ++k)
    number.lane[k] = static_cast<float>(k);
  const lane_mask<seen_lanes::width> seen = number < pack(static_cast<float>(width - rest));
  f.depth = select(seen, pack(0.0F), f.depth);
  f.coverage = select(seen, pack(0.0F), f.coverage);
  use(f);
}

}  // namespace pelage::frame
