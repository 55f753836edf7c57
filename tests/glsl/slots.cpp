// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/atomic_k_buffer.hpp>
#include <pelage/order/split_k_buffer.hpp>

#include <algorithm>
#include <bit>
#include <vector>

#include "glsl/device.hpp"
#include "glsl/kernels.hpp"
#include "glsl/offers.hpp"
#include "property.hpp"

namespace pelage::test {

namespace {

constexpr std::uint32_t k = 8;  ///< as in the kernels

/// What fell out of all inserts, in an order of its own.
std::vector<std::uint64_t> packed(const std::vector<std::uint32_t>& words) {
  std::vector<std::uint64_t> all;
  for (std::size_t i = 0; i < words.size(); i += 2)
    all.push_back(pack(fragment{std::bit_cast<float>(words[i]), words[i + 1]}));
  std::sort(all.begin(), all.end());
  return all;
}

std::vector<std::uint64_t> packed(const std::vector<fragment>& fragments) {
  std::vector<std::uint64_t> all;
  for (const fragment& f : fragments)
    all.push_back(pack(f));
  std::sort(all.begin(), all.end());
  return all;
}

/// K-buffers that 65536 invocations build: many pixels, few, and one where every insert meets every other.
template <typename Check>
void for_all_frames(Check check) {
  for (const std::uint32_t pixels : {4096U, 64U, 1U}) {
    CAPTURE(pixels);
    for (std::uint32_t seed = 0; seed < 3; ++seed) {
      CAPTURE(seed);
      check(pixels, many(seed, 65536U, 5000U));
    }
  }
}

}  // namespace

/// What a device holds and hands back equals what atomic_k_buffer does here, one fragment after another.
void check_wide_slots(const kernel& insert, const kernel& read) {
  if (!the_device()->has_atomic_int64()) {
    MESSAGE("not run: " << the_device()->name() << " has no 64-bit atomics");
    return;
  }
  for_all_frames([&](std::uint32_t pixels, const std::vector<fragment>& fragments) {
    std::vector<std::uint64_t> slots(pixels * k, pack(no_fragment()));
    atomic_cells<std::uint64_t> storage{slots};
    std::vector<fragment> expected_lost;
    for (std::uint32_t i = 0; i < fragments.size(); ++i)
      expected_lost.push_back(atomic_k_buffer::insert<k>(storage, i % pixels, fragments[i]));
    std::vector<std::uint32_t> expected;
    for (std::uint32_t pixel = 0; pixel < pixels; ++pixel) {
      for (const fragment f : atomic_k_buffer::load<k>(storage, pixel)) {
        expected.push_back(std::bit_cast<std::uint32_t>(f.depth));
        expected.push_back(f.id);
      }
    }

    std::vector<std::uint32_t> offers = offers_of(0U, pixels, fragments);
    std::vector<std::uint32_t> built(expected.size(), 0xffffffffU);
    for (std::size_t i = 1; i < built.size(); i += 2)
      built[i] = static_cast<std::uint32_t>(pack(no_fragment()) >> 32U);
    std::vector<std::uint32_t> lost(2 * fragments.size());
    std::vector<std::uint32_t> nearest(expected.size());
    const auto pass = [&](const kernel& program, std::uint32_t invocations, std::vector<std::uint32_t>& result) {
      std::vector<std::uint32_t>* const buffers[] = {&offers, &built, &result};
      the_device()->run(program, invocations, buffers);
    };
    pass(insert, static_cast<std::uint32_t>(fragments.size()), lost);
    pass(read, pixels, nearest);
    CHECK(nearest == expected);
    CHECK(packed(lost) == packed(expected_lost));
  });
}

TEST_CASE("K-buffers of 64-bit slots that 65536 invocations build at once equal those built one by one") {
  check_wide_slots(kernels::atomic_k_buffer, kernels::atomic_k_buffer_read);
  check_wide_slots(kernels::cascade_k_buffer, kernels::cascade_k_buffer_read);
}

TEST_CASE("K-buffers of 32-bit slots that 65536 invocations build in two passes equal those built one by one") {
  for_all_frames([](std::uint32_t pixels, const std::vector<fragment>& fragments) {
    std::vector<std::uint32_t> cells(2 * pixels * k, 0xffffffffU);
    atomic_cells<std::uint32_t> storage{cells};
    std::vector<std::uint32_t> built = cells;
    std::vector<fragment> expected_lost;
    std::vector<fragment> expected_slots;
    for (std::uint32_t i = 0; i < fragments.size(); ++i)
      split_k_buffer::offer_depth<k>(storage, i % pixels, fragments[i]);
    for (std::uint32_t i = 0; i < fragments.size(); ++i)
      expected_lost.push_back(split_k_buffer::insert<k>(storage, i % pixels, fragments[i]));
    for (std::uint32_t i = 0; i < k * pixels; ++i)
      expected_slots.push_back(split_k_buffer::at<k>(storage, i / k, i % k));

    std::vector<std::uint32_t> offers = offers_of(0U, pixels, fragments);
    std::vector<std::uint32_t> lost(2 * fragments.size());
    std::vector<std::uint32_t> slots(2 * fragments.size());
    const auto pass = [&](const kernel& program, std::vector<std::uint32_t>& result) {
      std::vector<std::uint32_t>* const buffers[] = {&offers, &built, &result};
      the_device()->run(program, static_cast<std::uint32_t>(fragments.size()), buffers);
    };
    pass(kernels::split_depths, lost);
    pass(kernels::split_ids, lost);
    pass(kernels::split_read, slots);
    slots.resize(2 * expected_slots.size());
    CHECK(built == cells);
    CHECK(packed(lost) == packed(expected_lost));
    CHECK(packed(slots) == packed(expected_slots));
  });
}

}  // namespace pelage::test
