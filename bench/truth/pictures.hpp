// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "truth/subjects.hpp"

namespace pelage::truth {

/// Writes FOLDER/NAME-rays.png, NAME-frame.png and NAME-error.png: the difference of sRGB values, white is 0.1 or more.
/// The folder is made. Throws std::runtime_error for what cannot be written.
void save_pictures(const subject& s, const std::string& folder, const std::string& name);

}  // namespace pelage::truth
