// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <doctest/doctest.h>
#include <sys/wait.h>

#include "frame/base/output_file.hpp"
#include "frame/model/built_in.hpp"
#include "frame/model/hair_file.hpp"
#include "frame/scratch_folder.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <span>
#include <string>
#include <vector>

/// The program pelage-frame from outside, for tests of what it says and leaves behind.
namespace pelage::test {

using namespace frame;
namespace fs = std::filesystem;

inline std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Runs the program in a folder of its own. What it prints goes to files beside that folder.
struct terminal {
  scratch_folder scratch;
  fs::path folder = scratch.path / "here";

  terminal() { fs::create_directory(folder); }

  [[nodiscard]] int run(const std::string& options) const {
    const std::string command =
        "cd '" + folder.string() + "' && '" PELAGE_FRAME_PROGRAM "' " + options + " >../out 2>../err";
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] std::string printed() const { return text_of(scratch.path / "out"); }
  [[nodiscard]] std::string complaint() const { return text_of(scratch.path / "err"); }

  [[nodiscard]] std::set<std::string> files() const {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      names.insert(entry.path().lexically_relative(folder).string());
    }
    return names;
  }

  void write(const std::string& name, std::span<const std::byte> bytes) const { write_file(folder / name, bytes); }

  /// Status 2, one line that holds `words`, nothing printed, and the same files as before.
  void check_refused(const std::string& options, const std::string& words) const {
    CAPTURE(options);
    const std::set<std::string> before = files();
    CHECK(run(options) == 2);
    const std::string said = complaint();
    CAPTURE(said);
    CHECK(std::count(said.begin(), said.end(), '\n') == 1);
    CHECK(said.ends_with('\n'));
    CHECK(said.starts_with("pelage-frame: "));
    CHECK(said.find(words) != std::string::npos);
    CHECK(files() == before);
  }
};

/// Options for a frame of milliseconds; what a case adds must name other options.
inline const std::string tiny = "--strands 60 --segments 6 --size 24 --k 4 ";

inline std::vector<std::byte> hair_bytes() {
  return encode_hair(make_built_in(20, 4, 1));
}

/// A .tfx of two strands of two points.
inline std::vector<std::byte> tfx_bytes() {
  std::array<float, 40 + 16> file{};
  const std::array<std::uint32_t, 3> counts{2, 2, 160};
  file[0] = 4.0F;
  std::copy_n(std::as_bytes(std::span(counts)).begin(), sizeof(counts),
              std::as_writable_bytes(std::span(file)).begin() + 4);
  for (std::size_t i = 0; i < 16; ++i)
    file[40 + i] = static_cast<float>(i % 5);
  const auto bytes = std::as_bytes(std::span(file));
  return {bytes.begin(), bytes.end()};
}

}  // namespace pelage::test
