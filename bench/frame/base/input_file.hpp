// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace pelage::frame {

/// What is wrong with an input file. what() is one line: "FILE: offset N: what is wrong", N in bytes.
struct input_error : std::runtime_error {
  input_error(std::string_view file, std::uint64_t offset, std::string_view fault);

  std::uint64_t offset;
};

/// A little-endian binary file, read in order from a cursor that starts at offset 0.
///
/// Every read is checked against the file's size before memory is taken for it, and every float must be
/// finite; whatever fails throws input_error with the offset of the value concerned. `what` names a value in
/// messages.
class input_file {
 public:
  /// Reads a regular file as a whole.
  explicit input_file(const std::filesystem::path& path);

  /// Takes bytes that are in memory already; `name` stands for the file in messages.
  input_file(std::string name, std::vector<std::byte> bytes);

  [[nodiscard]] std::uint64_t size() const { return bytes_.size(); }
  [[nodiscard]] std::uint64_t offset() const { return cursor_; }
  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

  /// Moves the cursor to an offset in [0, size()].
  void seek(std::uint64_t offset, std::string_view what);

  [[nodiscard]] std::uint32_t read_u32(std::string_view what);
  [[nodiscard]] float read_float(std::string_view what);
  [[nodiscard]] glm::vec3 read_vec3(std::string_view what);
  [[nodiscard]] std::string read_text(std::uint64_t length, std::string_view what);

  [[nodiscard]] std::vector<std::uint16_t> read_u16s(std::uint64_t count, std::string_view what);
  [[nodiscard]] std::vector<float> read_floats(std::uint64_t count, std::string_view what);
  [[nodiscard]] std::vector<glm::vec3> read_vec3s(std::uint64_t count, std::string_view what);
  [[nodiscard]] std::vector<glm::vec4> read_vec4s(std::uint64_t count, std::string_view what);

  /// Fails unless count * element_size bytes follow the cursor.
  void require(std::uint64_t count, std::uint64_t element_size, std::string_view what) const;

  /// Fails unless the cursor is at the end.
  void require_end() const;

  [[noreturn]] void fail(std::uint64_t offset, std::string_view fault) const;

 private:
  template <class T>
  [[nodiscard]] std::vector<T> read_array(std::uint64_t count, std::string_view what);
  template <class T>
  [[nodiscard]] T read_one(std::string_view what);
  void check_finite(std::span<const float> values, std::uint64_t first_offset, std::string_view what) const;

  std::string name_;
  std::vector<std::byte> bytes_;
  std::uint64_t cursor_ = 0;
};

}  // namespace pelage::frame
