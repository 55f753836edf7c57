// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "frame/order/slice_order.hpp"
#include "frame/shading/camera_film.hpp"

namespace pelage::frame {

/// Whether a segment lies whole in the slice of its farther end, or cut at the slices' planes, each piece in its own.
enum class at_planes { whole, clipped };

/// Draws all fragments in the order of their segments' slices, "over" one another: no pixel's list is sorted, and
/// inside a slice the segment of the smaller number lies in front. [Svoboda §1.3.3; clipped: Sintorn & Assarsson 2008]
/// The order of clipped pieces is found pixel by pixel.
order_report draw_sliced(camera_film& film, const raster& from, const slice_order& order, at_planes how);

}  // namespace pelage::frame
