// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include <cstdint>

namespace pelage::inline PELAGE_ABI {

/// One layer of a pixel at a time, without memory for more: the reference that the approximations are compared with.
/// [Everitt 2001, nearest first] Each pass offers all fragments in any order; then advance() and begin the next, until
/// layer() is none. n + 1 passes for n fragments. Ties in depth go to the smaller id, none is lost: what the original
/// loses at equal depth, the total order keeps apart. 20 bytes.
struct depth_peeling {
  fragment last;     ///< the layer before this pass's; no_fragment() in the first
  fragment nearest;  ///< of those behind it so far
  bool began;        ///< a layer has been peeled

  /// Before the first pass.
  [[nodiscard]] static constexpr depth_peeling begin() noexcept {
    return depth_peeling{no_fragment(), no_fragment(), false};
  }

  /// Offers a fragment to this pass. What is_fragment() refuses changes nothing. O(1).
  constexpr void offer(fragment offered) noexcept {
    if (is_fragment(offered) && (!began || before(last, offered)) && before(offered, nearest)) {
      nearest = offered;
    }
  }

  /// The layer that the pass found, or no_fragment().
  [[nodiscard]] constexpr fragment layer() const noexcept { return nearest; }

  /// Ends the pass.
  constexpr void advance() noexcept {
    last = nearest;
    nearest = no_fragment();
    began = true;
  }
};

/// Two layers a pass, the nearest and the farthest that are left. [Bavoil & Myers 2008, §3] n / 2 + 1 passes. Fronts
/// come nearest first, backs farthest first; the last layer of an odd number comes as a front alone. 36 bytes.
struct dual_depth_peeling {
  fragment front_last;  ///< the last front; layers left lie behind it
  fragment back_last;   ///< the last back; layers left lie before it
  fragment nearest;     ///< of those left so far
  fragment farthest;    ///< of those left so far
  bool began;           ///< a front has been peeled

  /// Before the first pass.
  [[nodiscard]] static constexpr dual_depth_peeling begin() noexcept {
    return dual_depth_peeling{no_fragment(), no_fragment(), no_fragment(), no_fragment(), false};
  }

  /// Offers a fragment to this pass. What is_fragment() refuses changes nothing. O(1).
  constexpr void offer(fragment offered) noexcept {
    // no_fragment() lies behind every fragment, so that before the first back none is too far.
    if (!is_fragment(offered) || (began && !before(front_last, offered)) || !before(offered, back_last)) {
      return;
    }
    if (before(offered, nearest)) {
      nearest = offered;
    }
    if (!is_fragment(farthest) || before(farthest, offered)) {
      farthest = offered;
    }
  }

  /// The front that the pass found, or no_fragment().
  [[nodiscard]] constexpr fragment front() const noexcept { return nearest; }

  /// The back that the pass found, or no_fragment() when there is none or it is the front.
  [[nodiscard]] constexpr fragment back() const noexcept { return same(nearest, farthest) ? no_fragment() : farthest; }

  /// Ends the pass.
  constexpr void advance() noexcept {
    front_last = nearest;
    back_last = farthest;
    nearest = no_fragment();
    farthest = no_fragment();
    began = true;
  }
};

}  // namespace pelage
