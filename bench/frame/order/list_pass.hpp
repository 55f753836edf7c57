// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "frame/order/order_pass.hpp"

namespace pelage::frame {

/// Takes all fragments of a pixel, in the order of drawing; may change them. Calls for different pixels come from many
/// threads at once.
using list_visitor = std::function<void(int x, int y, std::span<pixel_fragment> all)>;

/// Draws all segments of a raster for methods that see a pixel's fragments together: gives each pixel its list once,
/// pixels without fragments included. Fragments at or behind `limit` (view depth, one a pixel; or empty) are hidden.
/// `drawing_order`: segments' numbers, or empty: by number. The lists of one tile and thread exist at a time.
order_report run_list_pass(const raster& from, std::span<const float> limit,
                           std::span<const std::uint32_t> drawing_order, const list_visitor& visit);

}  // namespace pelage::frame
