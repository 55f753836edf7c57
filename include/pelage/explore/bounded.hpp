// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/explore/explore.hpp>
#include <pelage/explore/schedule.hpp>

#include <span>
#include <vector>

namespace pelage::explore {

/// Every schedule with few surprises, for programs too large to explore whole. A surprise is what a run on one
/// processor would not do by itself: taking control from a thread that could go on, letting a thread read a store
/// that is not the latest, and letting a weak compare-exchange fail without reason. Most faults need two or three.
/// [Musuvathi07 §4, with old stores counted as well]
class bounded : public strategy {
 public:
  explicit bounded(int surprises) : surprises_(surprises) {}

  bool choose(std::span<const action> ways, action& chosen) override;

  /// Prepares the next schedule; false when all within the bound have run.
  bool next();

 private:
  struct node {
    std::vector<action> ways;  ///< those within the bound
    std::vector<int> costs;
    std::size_t taken;
  };

  int surprises_;
  std::vector<node> nodes_;
  std::size_t depth_ = 0;
  int spent_ = 0;
  int last_thread_ = -1;
};

/// Runs all schedules of a program with at most so many surprises, until one shows a fault.
inline findings explore_bounded(const program_factory& make, int surprises, int patience = default_patience) {
  bounded choices(surprises);
  return search(make, choices, 0, patience);
}

// ---------------------------------------------------------------------------------------------------------

inline bool bounded::choose(std::span<const action> ways, action& chosen) {
  if (depth_ == 0) {
    spent_ = 0;
    last_thread_ = -1;
  }
  if (depth_ == nodes_.size()) {
    node n{{}, {}, 0};
    bool could_go_on = false;
    for (const action& way : ways) {
      could_go_on = could_go_on || way.thread == last_thread_;
    }
    for (const action& way : ways) {
      const bool takes_control = could_go_on && way.thread != last_thread_;
      const int cost = (takes_control ? 1 : 0) + (way.age > 0 ? 1 : 0) + (way.spurious ? 1 : 0);
      if (spent_ + cost <= surprises_) {
        n.ways.push_back(way);
        n.costs.push_back(cost);
      }
    }
    // An await may have only old stores to read.
    if (n.ways.empty()) {
      n.ways.push_back(go_on(ways, last_thread_));
      n.costs.push_back(0);
    }
    nodes_.push_back(n);
  }
  const node& n = nodes_[depth_++];
  chosen = n.ways[n.taken];
  spent_ += n.costs[n.taken];
  last_thread_ = chosen.thread;
  return true;
}

inline bool bounded::next() {
  depth_ = 0;
  for (; !nodes_.empty(); nodes_.pop_back()) {
    if (++nodes_.back().taken < nodes_.back().ways.size()) {
      return true;
    }
  }
  return false;
}

}  // namespace pelage::explore
