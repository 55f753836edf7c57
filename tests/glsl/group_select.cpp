// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/group_select.hpp>

#include <bit>
#include <limits>
#include <vector>

#include "glsl/device.hpp"
#include "glsl/kernels.hpp"
#include "property.hpp"

namespace pelage::test {

namespace {

constexpr std::size_t result_words = 196;  ///< of a list, as in the kernel

/// Lists of very different lengths, one behind the other, and how each is selected from.
struct lists {
  std::vector<fragment> pool;
  std::vector<std::uint32_t> words;  ///< of each: begin, end, K, two passes or one

  void add(std::uint32_t n, std::uint32_t k, bool two_passes, std::uint32_t depths, std::uint32_t seed) {
    const auto begin = static_cast<std::uint32_t>(pool.size());
    std::uint32_t state = seed * 2654435761U + 12345U;
    for (std::uint32_t i = 0; i < n; ++i) {
      state = state * 1664525U + 1013904223U;
      const std::uint32_t drawn = (state >> 8U) * 0x9e3779b9U;
      const float depth = depths == 0 ? std::bit_cast<float>(drawn) : static_cast<float>(drawn % depths) - 5.0F;
      pool.push_back({i % 97 == 5 ? std::numeric_limits<float>::infinity() : depth, i ^ 0x155U});
    }
    for (const std::uint32_t word : {begin, begin + n, k, two_passes ? 1U : 0U})
      words.push_back(word);
  }
};

void put(std::vector<std::uint32_t>& words, placed_fragment f) {
  for (const std::uint32_t word : {f.key, f.id, f.place})
    words.push_back(word);
}

/// What one lane alone makes of a list: fragments held, K slots, the last of them, and for each fragment if it lies
/// behind.
std::vector<std::uint32_t> alone(const lists& all, std::size_t list) {
  const std::uint32_t* of = &all.words[4 * list];
  std::vector<std::uint32_t> words(6);
  subgroup group{words};
  group_select<64> nearest;
  nearest.clear(of[2]);
  for (std::uint32_t i = of[0]; i < of[1]; ++i)
    nearest.insert(group, all.pool[i], i);
  nearest.finish(group);
  std::vector<std::uint32_t> result{nearest.held(group)};
  for (std::uint32_t i = 0; i < of[2]; ++i)
    put(result, nearest.slot[i]);
  put(result, nearest.at(group, of[2] - 1));
  for (std::uint32_t i = of[0]; i < of[1]; ++i)
    result.push_back(nearest.is_behind(all.pool[i]) ? 1 : 0);
  return result;
}

}  // namespace

TEST_CASE("A subgroup's slots, and what lies behind them, are those of one lane alone") {
  lists all;
  const std::uint32_t sizes[]{0, 1, 7, 8, 9, 31, 33, 64, 100, 257, 3000};
  const std::uint32_t ks[]{1, 4, 5, 8, 16, 17, 32, 63, 64};
  for (const std::uint32_t n : sizes) {
    for (const std::uint32_t k : ks) {
      for (const std::uint32_t depths : {0U, 1U, 20U, 100000U})
        all.add(n, k, depths != 20U, depths, n + k);
    }
  }
  const std::size_t count = all.words.size() / 4;
  std::vector<std::uint32_t> pool;
  for (const fragment& f : all.pool) {
    pool.push_back(std::bit_cast<std::uint32_t>(f.depth));
    pool.push_back(f.id);
  }
  std::vector<std::uint32_t> behind(all.pool.size());
  std::vector<std::uint32_t> results(result_words * count);
  std::vector<std::uint32_t>* const buffers[]{&pool, &all.words, &behind, &results};
  device& gpu = *the_device();
  gpu.run(kernels::group_select, static_cast<std::uint32_t>(count) * gpu.subgroup(), buffers);
  for (std::size_t list = 0; list < count; ++list) {
    CAPTURE(list);
    const std::uint32_t* of = &all.words[4 * list];
    const auto slots = results.begin() + static_cast<std::ptrdiff_t>(result_words * list);
    std::vector<std::uint32_t> got(slots, slots + 1 + 3 * static_cast<std::ptrdiff_t>(of[2]));
    got.insert(got.end(), slots + 193, slots + 196);
    got.insert(got.end(), behind.begin() + of[0], behind.begin() + of[1]);
    CHECK(got == alone(all, list));
  }
}

}  // namespace pelage::test
