// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/fragment.hpp>

#include <rapidcheck.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ostream>
#include <utility>
#include <vector>

namespace pelage {

/// How a counterexample shows a fragment: its depth, the depth's bits and its id.
inline std::ostream& operator<<(std::ostream& out, fragment f) {
  return out << '{' << f.depth << " (" << std::bit_cast<std::uint32_t>(f.depth) << "), " << f.id << '}';
}

}  // namespace pelage

namespace pelage::test {

/// A fragment's bits: unlike ==, they tell -0 from +0, and a NaN equals itself.
constexpr std::uint64_t bits(fragment f) {
  return std::bit_cast<std::uint64_t>(f);
}

template <class Fragments>
std::vector<std::uint64_t> bits(const Fragments& fragments) {
  std::vector<std::uint64_t> all;
  for (const fragment f : fragments) {
    all.push_back(bits(f));
  }
  return all;
}

/// What every structure refuses, said without pelage::is_fragment.
inline bool refusable(fragment f) {
  return std::isnan(f.depth) || f.id == 0xffffffffu;
}

/// The total order, said without pelage::before. For fragments that are not refusable.
inline bool nearer(fragment a, fragment b) {
  return std::pair(a.depth, a.id) < std::pair(b.depth, b.id);
}

/// The oracle of every structure here: all that it may hold, sorted at once.
inline std::vector<fragment> in_order(std::vector<fragment> fragments) {
  std::erase_if(fragments, refusable);
  std::sort(fragments.begin(), fragments.end(), nearer);
  return fragments;
}

/// The slots [from, from + count) of what in_order() gives, filled up with no_fragment().
inline std::vector<fragment> in_order(std::vector<fragment> fragments, std::size_t from, std::size_t count) {
  fragments = in_order(std::move(fragments));
  fragments.resize(std::max(fragments.size(), from + count), no_fragment());
  const auto first = fragments.begin() + static_cast<std::ptrdiff_t>(from);
  return std::vector<fragment>(first, first + static_cast<std::ptrdiff_t>(count));
}

template <class Fragments>
std::vector<fragment> joined(std::vector<fragment> all, const Fragments& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// Depths of any bits; half of them are one of a few, so that ties abound.
inline rc::Gen<float> any_depth() {
  return rc::gen::map(
      rc::gen::oneOf(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint32_t>()),
                     rc::gen::element<std::uint32_t>(0x00000000u, 0x80000000u,    // +0, -0
                                                     0x00000001u, 0x80000001u,    // the smallest denormals
                                                     0x3f800000u, 0xbf800000u,    // 1, -1
                                                     0x3f800001u, 0x7f7fffffu,    // next to 1, the largest
                                                     0x7f800000u, 0xff800000u,    // infinities
                                                     0x7fc00000u, 0xff800001u)),  // a quiet NaN, a signalling one
      [](std::uint32_t depth) { return std::bit_cast<float>(depth); });
}

/// Up to 200 fragments in no order, each id given once; at times the first has the id that no primitive has.
inline rc::Gen<std::vector<fragment>> any_fragments() {
  const auto depths = rc::gen::scale(2.0, rc::gen::container<std::vector<float>>(any_depth()));
  const auto first_id = rc::gen::element<std::uint32_t>(0u, 0x12345678u, 0xfffffffeu, 0xffffffffu);
  return rc::gen::map(rc::gen::pair(depths, first_id), [](const std::pair<std::vector<float>, std::uint32_t>& drawn) {
    std::vector<fragment> all;
    std::uint32_t id = drawn.second;
    for (const float depth : drawn.first) {
      all.push_back(fragment{depth, id});
      id += 0x9e3779b9u;  // odd, so no id comes twice
    }
    return all;
  });
}

/// Calls law.operator()<K>() for each K of the sequence.
template <std::uint32_t... K, class Law>
void for_each_k(std::integer_sequence<std::uint32_t, K...>, Law law) {
  (law.template operator()<K>(), ...);
}

}  // namespace pelage::test
