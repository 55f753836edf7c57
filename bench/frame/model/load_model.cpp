// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/load_model.hpp"

#include <cstring>

#include "frame/base/input_file.hpp"
#include "frame/model/hair_file.hpp"
#include "frame/model/tfx_file.hpp"

namespace pelage::frame {
namespace {

/// A .tfx has a version number there.
bool begins_as_hair(const std::string& path) {
  const input_file file(path);
  return file.size() < 4 || std::memcmp(file.bytes().data(), "HAIR", 4) == 0;
}

}  // namespace

hair_model load_model(const std::string& path) {
  return begins_as_hair(path) ? load_hair(path) : load_tfx(path);
}

}  // namespace pelage::frame
