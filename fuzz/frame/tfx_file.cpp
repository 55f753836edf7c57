// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// Any bytes as a .tfx file: refused with an error, or read as a sound model.
#include "frame/model/tfx_file.hpp"

#include "model.hpp"

#include <cstddef>
#include <cstring>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace pelage;
  std::vector<std::byte> bytes(size);
  if (size != 0) {
    std::memcpy(bytes.data(), data, size);
  }
  try {
    frame::input_file file("fuzz.tfx", bytes);
    fuzz::check_model(frame::read_tfx(file));
  } catch (const frame::input_error& error) {
    fuzz::law(error.offset <= size, "an error lies in the file");
  }
  return 0;
}
