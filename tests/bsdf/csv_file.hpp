// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace pelage::test {

/// A table of numbers with named columns, read whole from a comma-separated file. Cells that are not numbers read as
/// NaN; a row with another number of cells than the header is an error, as is a file without rows.
class csv_file {
 public:
  explicit csv_file(const std::string& path) : path_(path) {
    std::ifstream file(path);
    if (!file) {
      throw std::runtime_error(path + ": cannot be opened");
    }
    std::string line;
    std::getline(file, line);
    names_ = cells(line);
    while (std::getline(file, line)) {
      if (line.empty() || line == "\r") {
        continue;
      }
      const std::vector<std::string> texts = cells(line);
      if (texts.size() != names_.size()) {
        throw std::runtime_error(path + ": row " + std::to_string(rows_.size() + 1) + " has " +
                                 std::to_string(texts.size()) + " cells, the header " + std::to_string(names_.size()));
      }
      std::vector<double> row;
      for (const std::string& text : texts) {
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        row.push_back(end == text.c_str() ? std::nan("") : value);
      }
      rows_.push_back(row);
    }
    if (rows_.empty()) {
      throw std::runtime_error(path + ": has no rows");
    }
  }

  [[nodiscard]] std::size_t size() const { return rows_.size(); }

  /// The cell of a row; throws where there is no such column.
  [[nodiscard]] double at(std::size_t row, const std::string& column) const {
    const auto found = std::find(names_.begin(), names_.end(), column);
    if (found == names_.end()) {
      throw std::runtime_error(path_ + ": has no column " + column);
    }
    return rows_[row][static_cast<std::size_t>(found - names_.begin())];
  }

 private:
  static std::vector<std::string> cells(std::string line) {
    if (!line.empty() && line.back() == '\r') {
      line.pop_back();
    }
    std::vector<std::string> all;
    std::stringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) {
      all.push_back(cell);
    }
    return all;
  }

  std::string path_;
  std::vector<std::string> names_;
  std::vector<std::vector<double>> rows_;
};

}  // namespace pelage::test
