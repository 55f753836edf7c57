// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "frame/base/input_file.hpp"
#include "frame/model/hair_model.hpp"

namespace pelage::frame {

/// Reads a TressFX 4.0 .tfx file: guide strands of equal length, without follow strands (follow_strands.hpp).
///
/// Texture coordinates are checked and dropped, so is the movability flag in a position's w. Strand thickness
/// and vertex colour (its alpha as 1 - transparency) are kept where the file has them; without thickness, the
/// default is 1/2000 of the bounds' diagonal.
///
/// Throws input_error for another version, counts that disagree with the file's size, arrays that are
/// truncated, unaligned or overlap each other or the header, bytes that belong to no array, and values that
/// are not finite or outside the ranges of hair_model.
[[nodiscard]] hair_model read_tfx(input_file& file);

/// read_tfx() of a file on disk.
[[nodiscard]] hair_model load_tfx(const std::filesystem::path& path);

}  // namespace pelage::frame
