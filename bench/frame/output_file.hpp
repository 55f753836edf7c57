// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace pelage::frame {

/// Writes a whole file or nothing: the bytes go to "FILE.partial", which then takes the file's name.
///
/// Throws std::runtime_error, "FILE: what is wrong" on one line, and then leaves the file as it was and no
/// partial file. Refuses a path that names something other than a regular file (a folder, a device).
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// A path as one line of text: control characters become '?'.
[[nodiscard]] std::string printable(const std::filesystem::path& path);

}  // namespace pelage::frame
