// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/composite/optical_depth.hpp>

#include <cstdint>
#include <span>

#include "frame/order/list_pass.hpp"
#include "frame/shadows/shadow_map.hpp"

namespace pelage::frame {

/// A map that takes each texel's fragments together, in any order, from run_list_pass().
class list_shadow : public shadow_map {
 public:
  using shadow_map::shadow_map;

  /// All fragments of a texel; may sort them. Once a texel.
  virtual void fill(int x, int y, std::span<pixel_fragment> all) = 0;

 protected:
  /// Calls `use(fragment, optical depth)` for each and says what all sum up to.
  template <class Use>
  void sum_up(std::size_t texel, std::span<const pixel_fragment> all, Use&& use) {
    std::uint32_t coverage = 0;
    std::uint32_t optical = 0;
    for (const pixel_fragment& f : all) {
      const std::uint32_t one = optical_depth(alpha(f));
      use(f, one);
      coverage = add_saturating(coverage, to_fixed(f.coverage));
      optical = add_saturating(optical, one);
    }
    set_sums(texel, coverage, optical);
  }
};

}  // namespace pelage::frame
