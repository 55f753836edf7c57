// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/order/atomic_k_buffer.hpp>
#include <pelage/order/cascade_k_buffer.hpp>
#include <pelage/order/split_k_buffer.hpp>

#include "concurrency/inserts.hpp"
#include "concurrency/watched_barrier.hpp"
#include "concurrency/watched_slots.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pelage::explore {

/// The library's atomic_k_buffer as a slot test calls it: one pass.
template <std::uint32_t K, class Storage = watched_slots>
struct one_pass {
  using storage = Storage;
  static constexpr std::uint32_t slots = K;
  static constexpr int passes = 1;
  static void first_pass(Storage&, fragment) {}
  static fragment insert(Storage& s, fragment f) { return atomic_k_buffer::insert<K>(s, 0u, f); }
  static std::array<fragment, K> load(const Storage& s) { return atomic_k_buffer::load<K>(s, 0u); }
};

/// The same of a cascade_k_buffer.
template <std::uint32_t K, class Storage = watched_slots>
struct cascade {
  using storage = Storage;
  static constexpr std::uint32_t slots = K;
  static constexpr int passes = 1;
  static void first_pass(Storage&, fragment) {}
  static fragment insert(Storage& s, fragment f) { return cascade_k_buffer::insert<K>(s, 0u, f); }
  static std::array<fragment, K> load(const Storage& s) {
    std::array<fragment, K> slots;
    for (std::uint32_t i = 0; i < K; ++i) {
      slots[i] = cascade_k_buffer::at<K>(s, 0u, i);
    }
    return slots;
  }
};

/// The same of a split_k_buffer.
template <std::uint32_t K, class Storage = watched_depths_and_ids>
struct split_slots {
  using storage = Storage;
  static constexpr std::uint32_t slots = K;
  static constexpr int passes = 2;
  static void first_pass(Storage& s, fragment f) { split_k_buffer::offer_depth<K>(s, 0u, f); }
  static fragment insert(Storage& s, fragment f) { return split_k_buffer::insert<K>(s, 0u, f); }
  static std::array<fragment, K> load(const Storage& s) {
    std::array<fragment, K> slots;
    for (std::uint32_t i = 0; i < K; ++i) {
      slots[i] = split_k_buffer::at<K>(s, 0u, i);
    }
    return slots;
  }
};

/// Inserts into one pixel, a barrier between the passes, a reader behind another barrier, and all that the library
/// promises: the K nearest in order, and everything else handed back once.
template <class Buffer, class BetweenPasses = sound_barrier, class BeforeReading = sound_barrier>
class slot_program : public program {
 public:
  slot_program(const inserts& work, bool reads) : work_(work), reads_(reads), back_(work.size()) {}

  [[nodiscard]] int threads() const override { return inserters() + (reads_ ? 1 : 0); }

  void thread(int t) override {
    if (t == inserters()) {
      before_reading_.wait(inserters());
      check_slots();
      return;
    }
    if (Buffer::passes == 2) {
      for (const fragment f : work_[static_cast<std::size_t>(t)]) {
        Buffer::first_pass(storage_, f);
        completed();
      }
      between_passes_.arrive();
      between_passes_.wait(inserters());
    }
    for (const fragment f : work_[static_cast<std::size_t>(t)]) {
      const fragment back = Buffer::insert(storage_, f);
      if (is_fragment(back)) {
        back_[static_cast<std::size_t>(t)].push_back(back);
      }
      completed();
    }
    if (reads_) {
      before_reading_.arrive();
    }
  }

  void finish() override {
    check_slots();
    std::vector<fragment> rest = in_order(back_);
    const std::vector<fragment> all = in_order(work_);
    const std::size_t kept = std::min<std::size_t>(Buffer::slots, all.size());
    expect(rest.size() == all.size() - kept, "a fragment is lost, or there twice");
    for (std::size_t i = 0; i < rest.size() && kept + i < all.size(); ++i) {
      expect(same(rest[i], all[kept + i]), "what came back is not what is behind the K nearest");
    }
  }

  [[nodiscard]] std::string draw() const override { return storage_.draw(); }

 private:
  [[nodiscard]] int inserters() const { return static_cast<int>(work_.size()); }

  static std::vector<fragment> in_order(const inserts& some) {
    std::vector<fragment> all;
    for (const auto& of_one : some) {
      all.insert(all.end(), of_one.begin(), of_one.end());
    }
    std::sort(all.begin(), all.end(), [](fragment a, fragment b) { return before(a, b); });
    return all;
  }

  void check_slots() const {
    const std::array<fragment, Buffer::slots> held = Buffer::load(storage_);
    const std::vector<fragment> all = in_order(work_);
    for (std::size_t i = 0; i < held.size(); ++i) {
      expect(same(held[i], i < all.size() ? all[i] : no_fragment()), "the slots are not the K nearest in order");
    }
  }

  inserts work_;
  bool reads_;
  typename Buffer::storage storage_{Buffer::slots};
  BetweenPasses between_passes_{"passes"};
  BeforeReading before_reading_{"arrived"};
  inserts back_;
};

/// Makes a program_factory of inserts; `reads`: with a reader behind the barrier.
template <class Buffer, class BetweenPasses = sound_barrier, class BeforeReading = sound_barrier>
auto slot_test(bool reads = false) {
  return [reads](const inserts& work) -> program_factory {
    return [=] { return std::make_unique<slot_program<Buffer, BetweenPasses, BeforeReading>>(work, reads); };
  };
}

}  // namespace pelage::explore
