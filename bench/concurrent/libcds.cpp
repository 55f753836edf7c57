// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/order/packed_fragment.hpp>

#include "contender.hpp"

#include <cds/container/lazy_list_hp.h>
#include <cds/container/lazy_list_nogc.h>
#include <cds/container/michael_list_hp.h>
#include <cds/container/michael_list_nogc.h>
#include <cds/gc/hp.h>
#include <cds/init.h>

#include <deque>
#include <functional>

namespace pelage::bench {

namespace {

/// libcds as long as it is used; it asks for hazard pointers for each list that a thread works on.
class library {
 public:
  library() { cds::Initialize(); }
  ~library() { cds::Terminate(); }
};

class hazard_pointers {
 public:
  hazard_pointers() : collector_(16, 64) {}

 private:
  library library_;
  cds::gc::HP collector_;
};

/// The keys are packed fragments: one integer compare a node, no less than what ordered_list does.
struct michael_order : cds::container::michael_list::traits {
  using less = std::less<std::uint64_t>;
};
struct lazy_order : cds::container::lazy_list::traits {
  using less = std::less<std::uint64_t>;
};

template <class List>
class cds_contender : public contender {
 public:
  explicit cds_contender(std::string name) : name_(std::move(name)) {
    static hazard_pointers running;  // before the first list, until the end of the program
    attach();
  }
  [[nodiscard]] std::string name() const override { return name_; }
  void prepare(const workload& work) override {
    lists_.clear();
    for (std::uint32_t i = 0; i < work.list_count; ++i) {
      lists_.emplace_back();
    }
  }
  void insert(const workload& work, std::size_t first, std::size_t last) override {
    for (std::size_t i = first; i < last; ++i) {
      static_cast<void>(lists_[work.offers[i].list].insert(pack(work.offers[i].offered)));
    }
  }
  void enter_thread() override { attach(); }
  void leave_thread() override { cds::threading::Manager::detachThread(); }
  [[nodiscard]] std::uint64_t checksum() const override {
    place_sum sum;
    for (List& list : lists_) {
      sum.begin_list();
      for (const std::uint64_t key : list) {
        sum.add(unpack(key).id);
      }
    }
    return sum.value();
  }

 private:
  static void attach() {
    if (!cds::threading::Manager::isThreadAttached()) {
      cds::threading::Manager::attachThread();
    }
  }
  std::string name_;
  mutable std::deque<List> lists_;  // its iterators hold hazard pointers, so that reading is not const
};

}  // namespace

std::vector<std::unique_ptr<contender>> libcds_contenders() {
  namespace list = cds::container;
  using key = std::uint64_t;
  std::vector<std::unique_ptr<contender>> all;
  all.push_back(std::make_unique<cds_contender<list::MichaelList<cds::gc::HP, key, michael_order>>>(
      "libcds Michael, hazard pointers"));
  all.push_back(std::make_unique<cds_contender<list::MichaelList<cds::gc::nogc, key, michael_order>>>(
      "libcds Michael, no reclamation"));
  all.push_back(
      std::make_unique<cds_contender<list::LazyList<cds::gc::HP, key, lazy_order>>>("libcds lazy, hazard pointers"));
  all.push_back(
      std::make_unique<cds_contender<list::LazyList<cds::gc::nogc, key, lazy_order>>>("libcds lazy, no reclamation"));
  return all;
}

}  // namespace pelage::bench
