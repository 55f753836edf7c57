// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/a_buffer.hpp>
#include <pelage/order/block_list_storage.hpp>
#include <pelage/order/ordered_list.hpp>

#include "contender.hpp"

#include <algorithm>
#include <mutex>
#include <span>

namespace pelage::bench {

namespace {

/// Memory for the storages, with room for what threads leave of their blocks.
class pool_contender : public contender {
 public:
  void prepare(const workload& work) override {
    const std::size_t capacity = work.offers.size() + 64u * block_list_storage::block_size();
    links_.assign(work.list_count + capacity, 0u);
    nodes_.assign(capacity, no_fragment());
    storage_ = atomic_list_storage{links_, nodes_, &taken_, &refused_};
    storage_.clear();
  }

 protected:
  atomic_list_storage storage_{};

 private:
  std::vector<std::uint32_t> links_;
  std::vector<fragment> nodes_;
  std::uint32_t taken_ = 0;
  std::uint32_t refused_ = 0;
};

class unordered : public pool_contender {
 public:
  [[nodiscard]] std::string name() const override { return "a_buffer"; }
  void insert(const workload& work, std::size_t first, std::size_t last) override {
    block_list_storage storage(storage_);
    for (std::size_t i = first; i < last; ++i) {
      static_cast<void>(a_buffer::push(storage, work.offers[i].list, work.offers[i].offered));
    }
  }
  [[nodiscard]] std::uint64_t checksum() const override { return 0; }
};

class ordered : public pool_contender {
 public:
  [[nodiscard]] std::string name() const override { return "ordered_list"; }
  void insert(const workload& work, std::size_t first, std::size_t last) override {
    block_list_storage storage(storage_);
    for (std::size_t i = first; i < last; ++i) {
      static_cast<void>(
          ordered_list::insert(storage, work.offers[i].list, work.offers[i].offered, ordered_list::unlimited()));
    }
  }
  [[nodiscard]] std::uint64_t checksum() const override {
    place_sum sum;
    for (std::uint32_t list = 0; list < storage_.list_count(); ++list) {
      sum.begin_list();
      for (std::uint32_t n = ordered_list::first(storage_, list); n != no_node(); n = ordered_list::next(storage_, n)) {
        sum.add(storage_.read_node(n).id);
      }
    }
    return sum.value();
  }
};

class mutex_vector : public contender {
 public:
  [[nodiscard]] std::string name() const override { return "mutex + sorted vector"; }
  void prepare(const workload& work) override {
    lists_ = std::vector<guarded>(work.list_count);
    for (guarded& list : lists_) {
      list.fragments.reserve(work.length);
    }
  }
  void insert(const workload& work, std::size_t first, std::size_t last) override {
    for (std::size_t i = first; i < last; ++i) {
      const auto& [list, offered] = work.offers[i];
      guarded& to = lists_[list];
      const std::scoped_lock lock(to.mutex);
      to.fragments.insert(std::upper_bound(to.fragments.begin(), to.fragments.end(), offered,
                                           [](fragment a, fragment b) { return before(a, b); }),
                          offered);
    }
  }
  [[nodiscard]] std::uint64_t checksum() const override {
    place_sum sum;
    for (const guarded& list : lists_) {
      sum.begin_list();
      for (const fragment f : list.fragments) {
        sum.add(f.id);
      }
    }
    return sum.value();
  }

 private:
  struct guarded {
    std::mutex mutex;
    std::vector<fragment> fragments;
  };
  std::vector<guarded> lists_;
};

}  // namespace

std::vector<std::unique_ptr<contender>> list_contenders() {
  std::vector<std::unique_ptr<contender>> all;
  all.push_back(std::make_unique<ordered>());
  all.push_back(std::make_unique<unordered>());
  all.push_back(std::make_unique<mutex_vector>());
  return all;
}

}  // namespace pelage::bench
