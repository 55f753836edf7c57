// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <iterator>
#include <string>

namespace pelage::test {

/// An empty folder that goes with its contents at the end of a test.
struct scratch_folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / ("pelage_test_" + std::to_string(::getpid()));

  scratch_folder() {
    std::filesystem::remove_all(path);
    std::filesystem::create_directory(path);
  }
  ~scratch_folder() { std::filesystem::remove_all(path); }
  scratch_folder(const scratch_folder&) = delete;
  scratch_folder& operator=(const scratch_folder&) = delete;

  [[nodiscard]] std::ptrdiff_t entries() const {
    return std::distance(std::filesystem::directory_iterator(path), std::filesystem::directory_iterator());
  }
};

}  // namespace pelage::test
