// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "frame/model/hair_model.hpp"

namespace pelage::frame {

/// Reads a .hair or .tfx file, told apart by what it begins with. Throws input_error (input_file.hpp).
[[nodiscard]] hair_model load_model(const std::string& path);

}  // namespace pelage::frame
