// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/base/method_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <utility>

namespace pelage::frame {
namespace {

/// All of a text as a number.
template <class Number>
std::optional<Number> number_in(const std::string& text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

}  // namespace

method_text::method_text(std::string option, const std::string& text) : option_(std::move(option)), text_(text) {
  const std::size_t colon = text.find(':');
  word_ = text.substr(0, colon);
  if (colon != std::string::npos) argument_ = text.substr(colon + 1);
}

void method_text::without_argument() const {
  if (argument_) fail("nothing follows " + word_);
}

std::uint32_t method_text::one_of(std::span<const std::uint32_t> numbers, const std::string& what) const {
  const auto number = number_in<std::uint32_t>(argument_.value_or(""));
  if (!number || std::find(numbers.begin(), numbers.end(), *number) == numbers.end()) {
    fail(fmt::format("{} must be followed by :N with N {}, one of {}", word_, what, fmt::join(numbers, ", ")));
  }
  return *number;
}

float method_text::share(const std::string& what) const {
  const auto number = number_in<float>(argument_.value_or(""));
  if (!number || !(*number >= 0.0F && *number <= 1.0F)) {
    fail(fmt::format("{} must be followed by :X with X {}, in [0, 1]", word_, what));
  }
  return *number;
}

void method_text::fail(const std::string& wrong) const {
  throw std::invalid_argument(fmt::format("{} '{}': {}", option_, text_, wrong));
}

}  // namespace pelage::frame
