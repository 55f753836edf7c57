// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <vector>

#include "frame/base/input_file.hpp"
#include "frame/model/hair_model.hpp"

namespace pelage::frame {

/// Reads Cem Yuksel's binary .hair format; the cursor is at the file's start.
///
/// Throws input_error for a file that is truncated, has bytes after its last array, contradicts itself
/// (unknown flags, no points, segments that do not add up to the points), or holds a value outside the ranges
/// of hair_model.
[[nodiscard]] hair_model read_hair(input_file& file);

/// read_hair() of a file on disk.
[[nodiscard]] hair_model load_hair(const std::filesystem::path& path);

/// A model as the bytes of a .hair file; read_hair() gives the same model back, bit for bit.
///
/// Throws std::invalid_argument for what the format cannot hold: strands of 0 points or of more than 65,536,
/// and 2^32 strands or points.
[[nodiscard]] std::vector<std::byte> encode_hair(const hair_model& model);

/// Writes encode_hair() as write_file() does (output_file.hpp): the whole file or nothing.
void save_hair(const std::filesystem::path& path, const hair_model& model);

}  // namespace pelage::frame
