// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json.hpp>

#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace pelage::bench {

/// What a benchmark measured, in the one shape that bench/bars.py draws: groups of methods with a value each, both in
/// the order of their first add().
class results {
 public:
  explicit results(std::string unit) : json_{{"unit", std::move(unit)}, {"groups", nlohmann::ordered_json::object()}} {}

  void add(const std::string& group, const std::string& method, double value) {
    json_["groups"][group][method] = value;
  }

  /// Throws std::runtime_error if the file cannot be written.
  void write(const std::string& path) const {
    std::ofstream out(path);
    out << json_.dump(1) << '\n';
    if (!out.flush()) throw std::runtime_error(path + ": cannot be written");
  }

 private:
  nlohmann::ordered_json json_;
};

}  // namespace pelage::bench
