// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace pelage::frame {

/// Files that appear together or not at all: they and their folders are made in commit(), each beside its name first.
/// Until then they are kept in memory, so that a process that ends before, by a signal too, leaves nothing behind;
/// while add() and commit() run, SIGHUP, SIGINT and SIGTERM are ignored. A symbolic link is replaced, not followed.
class output_files {
 public:
  /// Promises a file, so that a path that cannot be written is found before the work for it is done: makes it and its
  /// folders and takes them away again. Throws std::runtime_error, "FILE: what is wrong" on one line; also for what is
  /// no regular file (a folder, a device), for a path that was added before, and for one that would be the folder of
  /// another.
  void add(const std::filesystem::path& path);

  /// Gives a file that was added its bytes. Throws as add() does.
  void write(const std::filesystem::path& path, std::span<const std::byte> bytes);

  /// Makes all files. Throws as add() does; a folder that took the place of one of them meanwhile leaves those before
  /// it.
  void commit();

 private:
  struct file {
    std::filesystem::path path;
    std::vector<std::byte> bytes;
  };
  std::vector<file> files_;
};

/// Writes a whole file or nothing. Throws as output_files does.
void write_file(const std::filesystem::path& path, std::span<const std::byte> bytes);

/// A path as one line of text: control characters become '?'.
[[nodiscard]] std::string printable(const std::filesystem::path& path);

}  // namespace pelage::frame
