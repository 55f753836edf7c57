// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/version.hpp>

#include <concepts>
#include <cstdint>
#include <span>

namespace pelage::inline PELAGE_ABI {

/// For how many lanes something holds.
struct lane_count {
  std::uint32_t all;    ///< of the group's
  std::uint32_t below;  ///< of those with a smaller number than this lane's
};

/// Lanes that run one program on data of their own, see into each other's, and share words of memory: in a shader a
/// subgroup. size() is a power of two; lane() is this lane's number, [0, size()).
///
/// shuffle() and shuffle_xor() give what another lane passes, the one of a given number or of this lane's number with
/// bits flipped, [0, size()); count() tells for how many lanes something holds. All lanes call each of these, and
/// barrier(), together: a branch or a loop round such a call is taken by all of them or by none. None of these orders
/// memory; a word that one lane stored is loaded or stored by another one only when both have met at a barrier() since.
template <class Group>
concept lane_group = requires(Group& g, const Group& c, std::uint32_t n, bool holds) {
  { c.size() } -> std::same_as<std::uint32_t>;
  { c.lane() } -> std::same_as<std::uint32_t>;
  { c.shuffle(n, n) } -> std::same_as<std::uint32_t>;
  { c.shuffle_xor(n, n) } -> std::same_as<std::uint32_t>;
  { c.count(holds) } -> std::same_as<lane_count>;
  { c.load(n) } -> std::same_as<std::uint32_t>;
  { g.store(n, n) } -> std::same_as<void>;
  { g.barrier() } -> std::same_as<void>;
};

/// In a shader its subgroup, of PELAGE_SUBGROUP_SIZE lanes: gl_SubgroupSize unless the shader defines it, all of them
/// active. In C++ a group of one lane.
struct subgroup {
  std::span<std::uint32_t> words;  ///< shared by the lanes, and by no other group; in any state at first

  [[nodiscard]] std::uint32_t size() const noexcept { return 1u; }
  [[nodiscard]] std::uint32_t lane() const noexcept { return 0u; }
  [[nodiscard]] std::uint32_t shuffle(std::uint32_t value, [[maybe_unused]] std::uint32_t from) const noexcept {
    return value;
  }
  [[nodiscard]] std::uint32_t shuffle_xor(std::uint32_t value, [[maybe_unused]] std::uint32_t bits) const noexcept {
    return value;
  }
  [[nodiscard]] lane_count count(bool holds) const noexcept { return lane_count{holds ? 1u : 0u, 0u}; }
  [[nodiscard]] std::uint32_t load(std::uint32_t word) const noexcept { return words[word]; }
  void store(std::uint32_t word, std::uint32_t value) noexcept { words[word] = value; }
  void barrier() noexcept {}
};

static_assert(lane_group<subgroup>);

}  // namespace pelage
