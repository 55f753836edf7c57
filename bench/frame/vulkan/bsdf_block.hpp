// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "frame/shading/fibre_bsdf.hpp"
#include "frame/vulkan/buffers.hpp"

namespace pelage::frame::vulkan {

/// Uploads how fibres scatter light: nothing for kajiya_kay; for the others the processor's own tables, 0.8 MB, laid
/// out as shaders/tabulated_fibre.glsl has them.
void upload_bsdf(device& to, const fibre_bsdf& bsdf);

}  // namespace pelage::frame::vulkan
