// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <map>
#include <string>
#include <vector>

/// The words by which the command line chooses a value.
namespace pelage::frame {

/// All words, in alphabetical order.
template <class Value>
[[nodiscard]] std::vector<std::string> names(const std::map<std::string, Value>& all) {
  std::vector<std::string> list;
  for (const auto& [name, value] : all)
    list.push_back(name);
  return list;
}

/// The word of a value that has one.
template <class Value>
[[nodiscard]] std::string name_in(const std::map<std::string, Value>& all, Value wanted) {
  return std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.second == wanted; })->first;
}

}  // namespace pelage::frame
