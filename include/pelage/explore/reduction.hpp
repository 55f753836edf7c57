// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/explore/world.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace pelage::explore {

/// Depth-first search over schedules by running again and again, each class of equivalent ones once: source sets
/// with sleep sets. [Abdulla14, Algorithm 1]
///
/// Two schedules are equivalent when each thread reads the same stores and each cell has the same modification
/// order. So the reversals worth trying are: two stores to one cell; a load and a store that it could have waited
/// for; a compare-exchange that failed and the store that came before it. A load after a store need not be tried
/// before it: what it would read there, it may read here as well.
class reduction : public strategy {
 public:
  /// `reduce` false: every schedule, equivalent or not. For tests of the reduction itself.
  explicit reduction(bool reduce = true) : reduce_(reduce) {}

  bool choose(std::span<const action> ways, action& chosen) override;
  void performed(const event& e, const memory& cells) override;

  /// Prepares the next schedule; false when all have run.
  bool next();

 private:
  using clock = std::array<std::uint16_t, max_threads>;

  struct node {
    std::vector<action> ways;
    std::vector<action> asleep;  ///< what was tried here, or before and would end in a state seen
    std::uint32_t threads = 0;   ///< those to try here, a bit each
    action chosen{};
  };
  struct footprint {
    action way;
    std::uint16_t number;  ///< among the steps of its thread, from 1
    clock before;          ///< which steps of each thread stand before it, itself included
  };
  struct cell_history {
    std::vector<std::uint32_t> reads;  ///< steps that read without writing
    std::int32_t last_write = -1;
  };

  static constexpr int total_order = max_locations;  ///< stands for the order of seq_cst operations

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static std::uint32_t bit(int thread) { return 1u << thread; }
  static bool holds(const std::vector<action>& set, const action& a) {
    return std::any_of(set.begin(), set.end(), [&](const action& other) { return same_way(a, other); });
  }
  static void join(clock& to, const clock& from) {
    for (std::size_t i = 0; i < to.size(); ++i) {
      to[i] = std::max(to[i], from[i]);
    }
  }
  [[nodiscard]] bool before(std::uint32_t step, const clock& c) const {
    return c[index(steps_[step].way.thread)] >= steps_[step].number;
  }

  void forget();
  /// The steps that come directly before one, by what it reads and by the orders that it takes a place in; -1: none.
  using sources = std::array<std::int32_t, 3>;

  void reverse_with_writes(const cell_history& cell, int thread, const sources& from);
  void reverse(std::uint32_t earlier, int later_thread, const sources& from);

  bool reduce_;
  std::vector<node> nodes_;
  std::size_t used_ = 0;   ///< nodes that the present schedule shares with the last one, the changed one included
  std::size_t depth_ = 0;  ///< steps of the present schedule
  std::vector<action> child_asleep_;
  std::vector<std::uint32_t> between_;  ///< of reverse(): the steps that need not come after the earlier one

  std::vector<footprint> steps_;
  std::array<clock, max_threads> threads_{};
  std::array<cell_history, max_locations + 1> cells_;
};

// ---------------------------------------------------------------------------------------------------------

inline void reduction::forget() {
  steps_.clear();
  threads_.fill(clock{});
  for (cell_history& c : cells_) {
    c.reads.clear();
    c.last_write = -1;
  }
}

inline bool reduction::choose(std::span<const action> ways, action& chosen) {
  if (depth_ == 0) {
    forget();
  }
  if (depth_ == used_) {
    if (used_ == nodes_.size()) {
      nodes_.emplace_back();
    }
    node& n = nodes_[used_];
    n.ways.assign(ways.begin(), ways.end());
    n.asleep = depth_ == 0 || !reduce_ ? std::vector<action>{} : child_asleep_;
    const action* pick = nullptr;
    for (const action& way : n.ways) {
      const bool goes_on = !steps_.empty() && steps_.back().way.thread == way.thread;
      if (!holds(n.asleep, way) && (pick == nullptr || (goes_on && pick->thread != way.thread))) {
        pick = &way;
      }
    }
    if (pick == nullptr) {
      return false;
    }
    n.threads = reduce_ ? bit(pick->thread) : ~0u;
    n.chosen = *pick;
    ++used_;
  }
  chosen = nodes_[depth_].chosen;
  return true;
}

inline void reduction::performed(const event& e, const memory& cells) {
  node& n = nodes_[depth_];
  const int thread = e.way.thread;
  const bool at_cell = e.what.location >= 0;
  cell_history* const cell = at_cell ? &cells_[index(e.what.location)] : nullptr;
  cell_history* const total = e.way.total ? &cells_[total_order] : nullptr;
  const sources from = {at_cell && e.way.writes ? cell->last_write : -1,
                        at_cell && !e.way.writes ? cells.stores(e.what.location)[index(e.way.store)].event : -1,
                        total != nullptr ? total->last_write : -1};
  if (reduce_ && depth_ + 1 == used_) {
    if (at_cell && e.way.writes) {
      reverse_with_writes(*cell, thread, from);
    } else if (at_cell && e.what.kind == operation_kind::compare_exchange && cell->last_write >= 0) {
      reverse(static_cast<std::uint32_t>(cell->last_write), thread, from);
    }
    if (total != nullptr) {
      reverse_with_writes(*total, thread, from);
    }
  }

  clock& mine = threads_[index(thread)];
  for (const std::int32_t source : from) {
    if (source >= 0) {
      join(mine, steps_[index(source)].before);
    }
  }
  if (e.what.kind == operation_kind::join) {
    for (const clock& other : threads_) {
      join(mine, other);
    }
  }
  ++mine[index(thread)];
  steps_.push_back(footprint{e.way, mine[index(thread)], mine});
  if (at_cell && !e.way.writes) {
    cell->reads.push_back(static_cast<std::uint32_t>(depth_));
  } else if (at_cell) {
    cell->last_write = static_cast<std::int32_t>(depth_);
  }
  if (total != nullptr) {
    total->last_write = static_cast<std::int32_t>(depth_);
  }
  ++depth_;
  if (depth_ == used_) {
    child_asleep_.clear();
    for (const action& a : n.asleep) {
      if (a.thread != thread && independent(a, e.way)) {
        child_asleep_.push_back(a);
      }
    }
  }
}

inline void reduction::reverse_with_writes(const cell_history& cell, int thread, const sources& from) {
  for (const std::uint32_t read : cell.reads) {
    const bool by_way_of_a_write = cell.last_write >= 0 && before(read, steps_[index(cell.last_write)].before);
    if (!by_way_of_a_write) {
      reverse(read, thread, from);
    }
  }
  if (cell.last_write >= 0) {
    reverse(static_cast<std::uint32_t>(cell.last_write), thread, from);
  }
}

/// Unless the step of `later_thread` at hand must come after step `earlier`: has some thread tried in place of the
/// earlier one, such that the later one can come before it.
inline void reduction::reverse(std::uint32_t earlier, int later_thread, const sources& from) {
  if (before(earlier, threads_[index(later_thread)])) {
    return;
  }
  // What the later step still comes after, once it need not come after the earlier one.
  clock past = threads_[index(later_thread)];
  for (const std::int32_t source : from) {
    if (source >= 0 && !before(earlier, steps_[index(source)].before)) {
      join(past, steps_[index(source)].before);
    }
  }
  between_.clear();
  std::uint32_t met = 0;
  std::uint32_t first = 0;
  const auto can_be_first = [&](int thread, const clock& c) {
    return (met & bit(thread)) == 0 &&
           std::none_of(between_.begin(), between_.end(), [&](std::uint32_t step) { return before(step, c); });
  };
  for (std::uint32_t k = earlier + 1; k < steps_.size(); ++k) {
    if (!before(earlier, steps_[k].before)) {
      const int thread = steps_[k].way.thread;
      first |= can_be_first(thread, steps_[k].before) ? bit(thread) : 0u;
      met |= bit(thread);
      between_.push_back(k);
    }
  }
  first |= can_be_first(later_thread, past) ? bit(later_thread) : 0u;
  node& n = nodes_[earlier];
  if ((n.threads & first) == 0) {
    n.threads |= (first & bit(later_thread)) != 0 ? bit(later_thread) : first & (~first + 1);
  }
}

inline bool reduction::next() {
  depth_ = 0;
  for (; used_ > 0; --used_) {
    node& n = nodes_[used_ - 1];
    n.asleep.push_back(n.chosen);
    for (const action& way : n.ways) {
      if ((n.threads & bit(way.thread)) != 0 && !holds(n.asleep, way)) {
        n.chosen = way;
        return true;
      }
    }
  }
  return false;
}

}  // namespace pelage::explore
