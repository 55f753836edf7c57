// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "truth/pictures.hpp"

#include <filesystem>

#include "truth/measure.hpp"

namespace pelage::truth {

void save_pictures(const subject& s, const std::string& folder, const std::string& name) {
  std::filesystem::create_directories(folder);
  const auto path = [&](const char* what) { return std::filesystem::path(folder) / (name + what); };
  const frame::image rays = mean_of(judge(s).truth());
  const frame::image drawn = draw(s, s.settings).picture;
  frame::save_png(path("-rays.png"), rays);
  frame::save_png(path("-frame.png"), drawn);
  frame::save_png(path("-error.png"), frame::error_map(drawn, rays));
}

}  // namespace pelage::truth
