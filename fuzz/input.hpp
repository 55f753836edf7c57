// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>
#include <vector>

namespace pelage::fuzz {

/// What a fuzzer hands over, taken from the front. Behind its end there are zeros.
class input {
 public:
  input(const std::uint8_t* data, std::size_t size) : at_(data), end_(data + size) {}

  [[nodiscard]] bool empty() const { return at_ == end_; }

  /// A number or a float of any bits.
  template <class Value>
  [[nodiscard]] Value take() {
    Value value{};
    const std::size_t size = std::min(sizeof value, static_cast<std::size_t>(end_ - at_));
    if (size != 0) {
      std::memcpy(&value, at_, size);
    }
    at_ += size;
    return value;
  }

  /// A number in [0, bound).
  [[nodiscard]] std::uint32_t below(std::uint32_t bound) { return take<std::uint8_t>() % bound; }

  /// A float in [0, 1] of any of 2^32 values, most of them not tiny.
  [[nodiscard]] float unit() { return static_cast<float>(take<std::uint32_t>()) * 0x1p-32f; }

 private:
  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

/// Ends the run as a crash that says which law is broken, if it is.
inline void law(bool holds, const char* what) {
  if (!holds) {
    std::fprintf(stderr, "law broken: %s\n", what);
    std::abort();
  }
}

/// Up to `most` fragments: depths of any bits, each id once, at times the id that no primitive has.
inline std::vector<fragment> take_fragments(input& in, std::size_t most) {
  std::vector<fragment> all;
  std::set<std::uint32_t> ids;
  while (!in.empty() && all.size() < most) {
    const auto depth = in.take<float>();
    const std::uint32_t id = in.take<std::uint8_t>() - 1u;  // 0xffffffff comes from 0
    if (ids.insert(id).second) {
      all.push_back(fragment{depth, id});
    }
  }
  return all;
}

/// What a structure may hold, in the total order, said without the library: no NaN, and not the id of none.
inline std::vector<fragment> sorted(std::vector<fragment> all) {
  std::erase_if(all, [](fragment f) { return f.depth != f.depth || f.id == 0xffffffffu; });
  std::sort(all.begin(), all.end(),
            [](fragment a, fragment b) { return a.depth < b.depth || (a.depth == b.depth && a.id < b.id); });
  return all;
}

/// Equal ids, and equal depths where -0 equals +0; a NaN is none of that.
inline bool equal(const std::vector<fragment>& a, const std::vector<fragment>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](fragment f, fragment g) { return f.depth == g.depth && f.id == g.id; });
}

}  // namespace pelage::fuzz
