// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/atomic_k_buffer.hpp>
#include <pelage/order/k_buffer.hpp>

#include "contender.hpp"

#include <atomic>

namespace pelage::bench {

namespace {

template <std::uint32_t K>
class exchanged : public contender {
 public:
  [[nodiscard]] std::string name() const override { return "atomic_k_buffer"; }
  void prepare(const workload& work) override {
    slots_.assign(std::size_t{work.list_count} * K, pack(no_fragment()));
    storage_ = atomic_cells<std::uint64_t>{slots_};
  }
  void insert(const workload& work, std::size_t first, std::size_t last) override {
    atomic_cells<std::uint64_t> storage = storage_;
    for (std::size_t i = first; i < last; ++i) {
      static_cast<void>(atomic_k_buffer::insert<K>(storage, work.offers[i].list, work.offers[i].offered));
    }
  }
  [[nodiscard]] std::uint64_t checksum() const override {
    place_sum sum;
    for (std::uint32_t pixel = 0; pixel < storage_.size() / K; ++pixel) {
      sum.begin_list();
      for (const fragment f : atomic_k_buffer::load<K>(storage_, pixel)) {
        sum.add(f.id);
      }
    }
    return sum.value();
  }

 private:
  std::vector<std::uint64_t> slots_;
  atomic_cells<std::uint64_t> storage_{};
};

/// The lock that a shader's spinlock is: one word a pixel, taken by exchange, watched by loads.
template <std::uint32_t K>
class spinlock : public contender {
 public:
  [[nodiscard]] std::string name() const override { return "spinlock + k_buffer"; }
  void prepare(const workload& work) override {
    pixels_ = std::vector<guarded>(work.list_count);
    for (guarded& pixel : pixels_) {
      pixel.buffer = k_buffer<K>::empty();
    }
  }
  void insert(const workload& work, std::size_t first, std::size_t last) override {
    for (std::size_t i = first; i < last; ++i) {
      guarded& pixel = pixels_[work.offers[i].list];
      while (pixel.lock.exchange(1u, std::memory_order_acquire) != 0u) {
        while (pixel.lock.load(std::memory_order_relaxed) != 0u) {
        }
      }
      static_cast<void>(pixel.buffer.insert(work.offers[i].offered));
      pixel.lock.store(0u, std::memory_order_release);
    }
  }
  [[nodiscard]] std::uint64_t checksum() const override {
    place_sum sum;
    for (const guarded& pixel : pixels_) {
      k_buffer<K> sorted = pixel.buffer;
      sorted.sort();
      sum.begin_list();
      for (const fragment f : sorted.slot) {
        sum.add(f.id);
      }
    }
    return sum.value();
  }

 private:
  struct guarded {
    std::atomic<std::uint32_t> lock{0u};
    k_buffer<K> buffer{};
  };
  std::vector<guarded> pixels_;
};

template <std::uint32_t K>
std::vector<std::unique_ptr<contender>> contenders_of() {
  std::vector<std::unique_ptr<contender>> all;
  all.push_back(std::make_unique<exchanged<K>>());
  all.push_back(std::make_unique<spinlock<K>>());
  return all;
}

}  // namespace

std::vector<std::unique_ptr<contender>> slot_contenders(std::uint32_t k) {
  switch (k) {
    case 8u:
      return contenders_of<8u>();
    case 16u:
      return contenders_of<16u>();
    case 32u:
      return contenders_of<32u>();
    default:
      return {};
  }
}

}  // namespace pelage::bench
