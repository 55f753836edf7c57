// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include <charconv>
#include <cstdint>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace pelage::explore {

/// What each of some threads inserts, in its order.
using inserts = std::vector<std::vector<fragment>>;

/// The same as text: depth:id, fragments separated by commas, threads by slashes: "1:0,2:1/1:2".
inline std::string to_text(const inserts& work) {
  std::ostringstream text;
  for (std::size_t t = 0; t < work.size(); ++t) {
    text << (t > 0 ? "/" : "");
    for (std::size_t i = 0; i < work[t].size(); ++i) {
      text << (i > 0 ? "," : "") << work[t][i].depth << ':' << work[t][i].id;
    }
  }
  return text.str();
}

/// Takes what stands before a mark, and the mark itself, off the front of a text; all of it where the mark is not.
inline std::string_view take_until(std::string_view& text, char mark) {
  const std::size_t end = text.find(mark);
  const std::string_view taken = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  return taken;
}

/// The inserts that to_text() wrote; none where the text is not of that form.
inline std::optional<inserts> inserts_of(std::string_view text) {
  inserts work;
  do {
    work.emplace_back();
    std::string_view of_one = take_until(text, '/');
    while (!of_one.empty()) {
      std::string_view one = take_until(of_one, ',');
      const std::string_view depth = take_until(one, ':');
      fragment f{};
      const auto end_of_depth = std::from_chars(depth.data(), depth.data() + depth.size(), f.depth);
      const auto end_of_id = std::from_chars(one.data(), one.data() + one.size(), f.id);
      if (end_of_depth.ec != std::errc{} || end_of_depth.ptr != depth.data() + depth.size() ||
          end_of_id.ec != std::errc{} || end_of_id.ptr != one.data() + one.size() || !is_fragment(f)) {
        return std::nullopt;
      }
      work.back().push_back(f);
    }
  } while (!text.empty());
  return work;
}

}  // namespace pelage::explore
