// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace pelage::frame {

/// Files that appear together or not at all. Each is written beside its name first and takes it in commit(); until
/// then what the names stood for is as it was, and without commit() nothing is left, folders included that add() made.
class output_files {
 public:
  output_files() = default;
  output_files(const output_files&) = delete;
  output_files& operator=(const output_files&) = delete;
  ~output_files();

  /// Begins a file, so that a path that cannot be written is found before the work for it is done. Makes its folder.
  /// Throws std::runtime_error, "FILE: what is wrong" on one line; also for what is no regular file (a folder, a
  /// device), and for a path that was added before.
  void add(const std::filesystem::path& path);

  /// Gives a file that was added its bytes. Throws as add() does.
  void write(const std::filesystem::path& path, std::span<const std::byte> bytes);

  /// Gives all files their names. Throws as add() does.
  void commit();

 private:
  struct file {
    std::filesystem::path path, partial;
  };
  std::vector<file> files_;
  std::vector<std::filesystem::path> folders_;  ///< made by add(), outermost first
};

/// Writes a whole file or nothing. Throws as output_files does.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// A path as one line of text: control characters become '?'.
[[nodiscard]] std::string printable(const std::filesystem::path& path);

}  // namespace pelage::frame
