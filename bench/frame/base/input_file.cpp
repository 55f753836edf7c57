// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/base/input_file.hpp"

#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <system_error>
#include <type_traits>
#include <utility>

#include "frame/base/output_file.hpp"

namespace pelage::frame {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little, "input_file copies little-endian values as they are");
static_assert(sizeof(glm::vec3) == 12 && sizeof(glm::vec4) == 16, "input_file needs unpadded GLM vectors");

namespace {

std::vector<std::byte> whole_file(const fs::path& path, const std::string& name) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) throw input_error(name, 0, error ? error.message() : "no such file");
  if (!fs::is_regular_file(status)) throw input_error(name, 0, "not a regular file");

  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), &std::fclose);
  if (!file) throw input_error(name, 0, std::string("cannot be opened: ") + std::strerror(errno));
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw input_error(name, 0, error.message());
  if (size > std::numeric_limits<std::size_t>::max() / 2) throw input_error(name, 0, "too large to read");

  std::vector<std::byte> bytes(static_cast<std::size_t>(size));
  const std::size_t got = bytes.empty() ? 0 : std::fread(bytes.data(), 1, bytes.size(), file.get());
  if (got != bytes.size()) throw input_error(name, got, "cannot be read any further");
  return bytes;
}

}  // namespace

input_error::input_error(std::string_view file, std::uint64_t offset_, std::string_view fault)
    : std::runtime_error(std::string(file) + ": offset " + std::to_string(offset_) + ": " + std::string(fault)),
      offset(offset_) {
}

input_file::input_file(const fs::path& path) : name_(printable(path)), bytes_(whole_file(path, name_)) {
}

input_file::input_file(std::string name, std::vector<std::byte> bytes)
    : name_(std::move(name)), bytes_(std::move(bytes)) {
}

void input_file::seek(std::uint64_t offset, std::string_view what) {
  if (offset > size()) {
    fail(offset, std::string(what) + " lies past the end of the file (" + std::to_string(size()) + " bytes)");
  }
  cursor_ = offset;
}

std::uint32_t input_file::read_u32(std::string_view what) {
  return read_one<std::uint32_t>(what);
}
float input_file::read_float(std::string_view what) {
  return read_one<float>(what);
}
glm::vec3 input_file::read_vec3(std::string_view what) {
  return read_one<glm::vec3>(what);
}

std::string input_file::read_text(std::uint64_t length, std::string_view what) {
  require(length, 1, what);
  const auto n = static_cast<std::size_t>(length);
  std::string text(n, '\0');
  if (n > 0) std::memcpy(text.data(), bytes_.data() + cursor_, n);
  cursor_ += length;
  return text;
}

std::vector<std::uint16_t> input_file::read_u16s(std::uint64_t count, std::string_view what) {
  return read_array<std::uint16_t>(count, what);
}
std::vector<float> input_file::read_floats(std::uint64_t count, std::string_view what) {
  return read_array<float>(count, what);
}
std::vector<glm::vec3> input_file::read_vec3s(std::uint64_t count, std::string_view what) {
  return read_array<glm::vec3>(count, what);
}
std::vector<glm::vec4> input_file::read_vec4s(std::uint64_t count, std::string_view what) {
  return read_array<glm::vec4>(count, what);
}

void input_file::require(std::uint64_t count, std::uint64_t element_size, std::string_view what) const {
  const std::uint64_t left = size() - cursor_;
  if (count <= left / element_size) return;
  fail(cursor_, std::string(what) + ": " + std::to_string(count) + " x " + std::to_string(element_size) +
                    " bytes are due, " + std::to_string(left) + " are left");
}

void input_file::require_end() const {
  if (cursor_ != size()) fail(cursor_, std::to_string(size() - cursor_) + " bytes too many");
}

void input_file::fail(std::uint64_t offset, std::string_view fault) const {
  throw input_error(name_, offset, fault);
}

template <class T>
std::vector<T> input_file::read_array(std::uint64_t count, std::string_view what) {
  static_assert(std::is_trivially_copyable_v<T>);
  require(count, sizeof(T), what);
  std::vector<T> values(static_cast<std::size_t>(count));
  const std::size_t byte_count = values.size() * sizeof(T);
  if (byte_count > 0) std::memcpy(values.data(), bytes_.data() + cursor_, byte_count);
  if constexpr (!std::is_integral_v<T>) {
    constexpr std::size_t width = sizeof(T) / sizeof(float);
    for (std::size_t i = 0; i < values.size(); ++i) {
      std::array<float, width> parts;
      std::memcpy(parts.data(), &values[i], sizeof(T));
      check_finite(parts, cursor_ + i * sizeof(T), what);
    }
  }
  cursor_ += byte_count;
  return values;
}

template <class T>
T input_file::read_one(std::string_view what) {
  return read_array<T>(1, what).front();
}

void input_file::check_finite(std::span<const float> values, std::uint64_t first_offset, std::string_view what) const {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isfinite(values[i])) continue;
    const std::string_view kind = std::isnan(values[i]) ? " is not a number" : " is infinite";
    fail(first_offset + i * sizeof(float), std::string(what) + std::string(kind));
  }
}

}  // namespace pelage::frame
