// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/core/lane_moves.hpp>

#include "property.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace pelage::test {

/// Any bits, NaN included, so that a move that computes is found.
template <std::size_t N>
std::array<std::uint32_t, N> any_words() {
  std::array<std::uint32_t, N> all;
  for (std::uint32_t& one : all)
    one = *rc::gen::arbitrary<std::uint32_t>() ^ (*rc::gen::arbitrary<bool>() ? 0x7fc00000u : 0u);
  return all;
}

template <int W>
lanes<W> packed(const std::uint32_t* words) {
  lanes<W> x;
  __builtin_memcpy(&x.lane, words, sizeof(x.lane));
  return x;
}

template <int W>
std::array<std::uint32_t, W> words_of(lanes<W> x) {
  return std::bit_cast<std::array<std::uint32_t, W>>(x.lane);
}

template <int W>
void check_moves_of_one() {
  const auto x = any_words<W>();
  const auto from = any_words<W>();
  const auto numbers = std::bit_cast<typename lanes<W>::integers>(from);
  const std::uint32_t set = *rc::gen::arbitrary<std::uint32_t>() & all_bits<W>();
  std::array<std::uint32_t, W> picks, left{};
  std::size_t count = 0;
  for (std::size_t k = 0; k < W; ++k) {
    picks[k] = x[from[k] % W];
    if ((set >> k & 1u) != 0u) left[count++] = x[k];
  }
  RC_ASSERT(words_of(picked(packed<W>(x.data()), numbers)) == picks);
  const auto same = picked_integers<W>(std::bit_cast<typename lanes<W>::integers>(x), numbers);
  RC_ASSERT((std::bit_cast<std::array<std::uint32_t, W>>(same) == picks));
  std::array<float, W> table;
  std::memcpy(table.data(), x.data(), sizeof(table));
  const auto at = std::bit_cast<typename lanes<W>::integers>(from) & (W - 1);
  RC_ASSERT(words_of(gathered<W>(table.data(), at)) == picks);
  RC_ASSERT(words_of(packed_left(set, packed<W>(x.data()))) == left);
}

TEST_CASE("lanes are picked by number, modulo the width, gathered from memory, and packed to the left in their order") {
  holds("4 lanes", check_moves_of_one<4>);
  holds("8 lanes", check_moves_of_one<8>);
  holds("16 lanes", check_moves_of_one<16>);
}

template <int W>
void check_interleaving() {
  const auto x = any_words<4 * W>();
  const auto part = [&](std::size_t i) { return packed<W>(x.data() + i * W); };
  std::array<std::uint32_t, 2 * W> zipped, found;
  std::array<std::uint32_t, 4 * W> quads, stored;
  for (std::size_t k = 0; k < W; ++k) {
    zipped[2 * k] = x[k];
    zipped[2 * k + 1] = x[W + k];
    for (std::size_t i = 0; i < 4; ++i)
      quads[4 * k + i] = x[i * W + k];
  }
  zip_low(part(0), part(1)).store(reinterpret_cast<float*>(found.data()));
  zip_high(part(0), part(1)).store(reinterpret_cast<float*>(found.data() + W));
  RC_ASSERT(found == zipped);
  store_quads(part(0), part(1), part(2), part(3), reinterpret_cast<float*>(stored.data()));
  RC_ASSERT(stored == quads);
  lanes<W> a, b, c, d;
  load_quads(reinterpret_cast<const float*>(quads.data()), a, b, c, d);
  RC_ASSERT((words_of(a) == words_of(part(0)) && words_of(b) == words_of(part(1))));
  RC_ASSERT((words_of(c) == words_of(part(2)) && words_of(d) == words_of(part(3))));
}

TEST_CASE("two vectors are zipped, four stored lane by lane, and read again") {
  holds("4 lanes", check_interleaving<4>);
  holds("8 lanes", check_interleaving<8>);
  holds("16 lanes", check_interleaving<16>);
}

template <int W>
void check_transposition() {
  const auto x = any_words<static_cast<std::size_t>(W) * W>();
  lanes<W> rows[W];
  for (std::size_t i = 0; i < W; ++i)
    rows[i] = packed<W>(x.data() + i * W);
  transpose(rows);
  for (std::size_t i = 0; i < W; ++i) {
    for (std::size_t k = 0; k < W; ++k)
      RC_ASSERT(words_of(rows[i])[k] == x[k * W + i]);
  }
}

TEST_CASE("rows become columns") {
  holds("4 lanes", check_transposition<4>);
  holds("8 lanes", check_transposition<8>);
  holds("16 lanes", check_transposition<16>);
}

}  // namespace pelage::test
