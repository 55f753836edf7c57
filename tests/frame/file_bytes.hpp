// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "frame/base/input_file.hpp"
#include "frame/model/hair_model.hpp"
#include "property.hpp"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace pelage::test {

using bytes = std::vector<std::byte>;

/// The file with another value at an offset.
template <class T>
bytes with(bytes file, std::size_t offset, T value) {
  REQUIRE(offset + sizeof(T) <= file.size());
  std::memcpy(file.data() + offset, &value, sizeof(T));
  return file;
}

using file_reader = frame::hair_model (*)(bytes);

/// A reader of "x.KIND" must refuse the file at an offset, and say so.
inline void check_refused_at(file_reader read, const std::string& kind, const bytes& file, std::uint64_t offset) {
  CAPTURE(offset);
  try {
    static_cast<void>(read(file));
    FAIL_CHECK("the file was accepted");
  } catch (const frame::input_error& error) {
    CHECK(error.offset == offset);
    const std::string line = error.what();
    CHECK(line.starts_with("x." + kind + ": offset " + std::to_string(offset) + ": "));
    CHECK(line.find('\n') == std::string::npos);
  }
}

/// It must refuse the first 0, 1, 2… bytes of a file, at an offset within them.
inline void check_truncations_refused(file_reader read, const bytes& file) {
  for (std::size_t length = 0; length < file.size(); ++length) {
    CAPTURE(length);
    try {
      static_cast<void>(read(bytes(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(length))));
      FAIL_CHECK("the file was accepted");
    } catch (const frame::input_error& error) {
      CHECK(error.offset <= length);
    }
  }
}

}  // namespace pelage::test
