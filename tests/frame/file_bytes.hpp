// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "frame/base/input_file.hpp"
#include "property.hpp"

#include <cstddef>
#include <cstring>
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

/// `read(bytes)` must refuse the first 0, 1, 2… bytes of a file, at an offset within them.
template <class Read>
void check_truncations_refused(const bytes& file, Read&& read) {
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
