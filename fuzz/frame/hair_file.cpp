// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// Any bytes as a .hair file: refused with an error, or read as a sound model that is written and read back the same.
#include "frame/model/hair_file.hpp"

#include "model.hpp"

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <vector>

namespace {

using namespace pelage;

std::vector<std::byte> encoded(const frame::hair_model& model) {
  try {
    return frame::encode_hair(model);
  } catch (const std::invalid_argument&) {
    return {};  // what the format cannot hold, such as a strand without points
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::vector<std::byte> bytes(size);
  if (size != 0) {
    std::memcpy(bytes.data(), data, size);
  }
  try {
    frame::input_file file("fuzz.hair", bytes);
    const frame::hair_model model = frame::read_hair(file);
    fuzz::check_model(model);
    const std::vector<std::byte> once = encoded(model);
    if (!once.empty()) {
      frame::input_file again("again.hair", once);
      fuzz::law(encoded(frame::read_hair(again)) == once, "a model survives being written and read");
    }
  } catch (const frame::input_error& error) {
    fuzz::law(error.offset <= size, "an error lies in the file");
  }
  return 0;
}
