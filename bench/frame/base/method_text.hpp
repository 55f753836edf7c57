// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace pelage::frame {

/// "word" or "word:argument", as the command line names a method that may have a parameter.
class method_text {
 public:
  /// `option`: what the text is for, as faults name it.
  method_text(std::string option, const std::string& text);

  [[nodiscard]] const std::string& word() const { return word_; }

  // All throw std::invalid_argument, one line that names the option, its text and what is wrong.

  /// There must be no argument.
  void without_argument() const;

  /// The argument as one of some whole numbers. `what` they are: "layers".
  [[nodiscard]] std::uint32_t one_of(std::span<const std::uint32_t> numbers, const std::string& what) const;

  /// The argument as a number in [0, 1].
  [[nodiscard]] float share(const std::string& what) const;

  [[noreturn]] void fail(const std::string& wrong) const;

 private:
  std::string option_, text_, word_;
  std::optional<std::string> argument_;
};

}  // namespace pelage::frame
