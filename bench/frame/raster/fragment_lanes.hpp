// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/lane_moves.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "frame/base/wide.hpp"
#include "frame/raster/pixel_fragment.hpp"

namespace pelage::frame {

/// A vector's worth of pixel_fragment.
struct fragment_lanes {
  static constexpr int width = lane_width();
  using pack = lanes<width>;
  using integers = pack::integers;

  integers id;
  pack depth, coverage, along;

  /// `width` fragments from memory, and back.
  [[nodiscard]] static fragment_lanes load(const pixel_fragment* from);
  void store(pixel_fragment* to) const;

  /// Bit k is set where the fragment of that depth_key() and id is before() lane k's.
  [[nodiscard]] std::uint32_t behind(pack::naturals last_key, pack::naturals last_id) const;

  /// Those whose bit is set, in their order.
  [[nodiscard]] fragment_lanes packed_left(std::uint32_t set) const;
};

/// Fragments as they are drawn: those of the lanes whose bit is set, each with its pixel.
struct drawn_fragments {
  std::uint32_t set;
  fragment_lanes::integers x, y;
  fragment_lanes lanes;
};

/// Calls `visit(k, x, y, pixel_fragment)` for each lane whose bit is set.
template <class Visit>
void for_each_drawn(const drawn_fragments& all, Visit&& visit);

/// Calls `use(fragment_lanes)` until each of the fragments has been in it once. Lanes without one have coverage 0,
/// depth 0 and the id of one of them.
template <class Use>
void for_each_lanes(std::span<const pixel_fragment> all, Use&& use);

// ---------------------------------------------------------------------------------------------------------

static_assert(sizeof(pixel_fragment) == 4 * sizeof(float));

inline fragment_lanes fragment_lanes::load(const pixel_fragment* from) {
  fragment_lanes f;
  pack number;
  load_quads(reinterpret_cast<const float*>(from), number, f.depth, f.coverage, f.along);
  f.id = reinterpret_cast<integers>(number.lane);
  return f;
}

inline void fragment_lanes::store(pixel_fragment* to) const {
  store_quads(pack(reinterpret_cast<pack::vector>(id)), depth, coverage, along, reinterpret_cast<float*>(to));
}

inline std::uint32_t fragment_lanes::behind(pack::naturals last_key, pack::naturals last_id) const {
  using naturals = pack::naturals;
  const naturals depth_bits = reinterpret_cast<naturals>(depth.lane);
  const naturals sign = naturals{} + 0x80000000U;
  const naturals flipped = depth_bits >= sign ? ~depth_bits : depth_bits | sign;
  const naturals key = depth_bits == sign ? sign : flipped;
  const auto later = (last_key < key) | ((last_key == key) & (last_id < reinterpret_cast<naturals>(id)));
  return bits(lane_mask<width>{later});
}

inline fragment_lanes fragment_lanes::packed_left(std::uint32_t set) const {
  const pack number = pelage::packed_left(set, pack(reinterpret_cast<pack::vector>(id)));
  return {reinterpret_cast<integers>(number.lane), pelage::packed_left(set, depth), pelage::packed_left(set, coverage),
          pelage::packed_left(set, along)};
}

template <class Visit>
void for_each_drawn(const drawn_fragments& all, Visit&& visit) {
  pixel_fragment each[fragment_lanes::width];
  all.lanes.store(each);
  for_each_lane(all.set, [&](int lane) {
    const auto k = static_cast<std::size_t>(lane);
    visit(k, all.x[k], all.y[k], each[k]);
  });
}

template <class Use>
void for_each_lanes(std::span<const pixel_fragment> all, Use&& use) {
  constexpr std::size_t width = fragment_lanes::width;
  const std::size_t whole = all.size() / width * width;
  for (std::size_t i = 0; i < whole; i += width)
    use(fragment_lanes::load(&all[i]));
  const std::span<const pixel_fragment> rest = all.subspan(whole);
  if (rest.empty()) return;
  std::array<pixel_fragment, width> few;
  std::fill(std::copy(rest.begin(), rest.end(), few.begin()), few.end(), pixel_fragment{rest[0].id, 0.0F, 0.0F, 0.0F});
  use(fragment_lanes::load(few.data()));
}

}  // namespace pelage::frame
