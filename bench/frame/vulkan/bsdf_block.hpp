// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "frame/shading/fibre_bsdf.hpp"
#include "frame/vulkan/buffers.hpp"

namespace pelage::frame::vulkan {

/// Uploads how fibres scatter light. For kajiya_kay with a pigment all of the `points` get the colour of such hair; for
/// the others the processor's own tables, 0.8 MB, laid out as shaders/tabulated_fibre.glsl has them.
void upload_bsdf(device& to, const fibre_bsdf& bsdf, std::size_t points);

}  // namespace pelage::frame::vulkan
