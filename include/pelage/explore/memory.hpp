// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/explore/operation.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pelage::explore {

/// What happens before a point of a thread: of each cell the oldest store that may still be read there, and of each
/// thread how many of its steps.
struct view {
  std::array<std::uint16_t, max_locations> seen{};
  std::array<std::uint16_t, max_threads> known{};

  void join(const view& other) {
    for (std::size_t i = 0; i < seen.size(); ++i) {
      seen[i] = std::max(seen[i], other.seen[i]);
    }
    for (std::size_t i = 0; i < known.size(); ++i) {
      known[i] = std::max(known[i], other.known[i]);
    }
  }
};

/// A store as the memory keeps it: a place in its cell's modification order, and what whoever acquires it learns.
struct message {
  std::uint64_t value;
  std::int32_t event;  ///< the step that stored it, -1 for the first value
  view released;
};

/// C++20's atomics with relaxed, acquire, release and acq_rel orders and with fences, by views: each cell keeps all
/// its stores, each thread a front below which stores are hidden from it. A load may read any store that is not
/// hidden, and which one is a choice of the explorer. [Kang17 §2, without promises]
///
/// A read-modify-write takes the latest store; a compare-exchange that fails may have read any store that is not
/// hidden and differs from what it expected. A weak one may also fail on a store that does not differ, but not twice
/// in a row in one thread, or a loop around it would have no last schedule. seq_cst operations also join one common
/// view before and after, which is at least as strong as C++ asks.
///
/// Not modelled, hence not found: modification orders that contradict the order of execution (2+2W) and loads of
/// stores that run later (load buffering). Compilers and processors that the library knows of show neither between
/// an atomic and the one that depends on it.
class memory {
 public:
  using show_value = std::string (*)(std::uint64_t);

  void reset() {
    location_count_ = 0;
    total_ = view{};
    threads_.fill(thread_state{});
    for (thread_state& t : threads_) {
      t.current.known.fill(0);
    }
    for (std::size_t i = 0; i < threads_.size(); ++i) {
      threads_[i].current.known[i] = 1;
    }
  }

  /// A new cell with its first value, which every thread knows. `mask`: the bits that its type has.
  std::int16_t add_location(std::string_view name, std::uint64_t value, std::uint64_t mask, show_value show);

  [[nodiscard]] int location_count() const { return location_count_; }
  [[nodiscard]] const std::string& name(int location) const { return locations_[index(location)].name; }
  [[nodiscard]] std::string show(int location, std::uint64_t value) const {
    return locations_[index(location)].show(value);
  }
  [[nodiscard]] const std::vector<message>& stores(int location) const { return locations_[index(location)].stores; }
  [[nodiscard]] std::uint64_t latest(int location) const { return stores(location).back().value; }

  /// Adds every way in which a thread may carry out an operation, the one that reads the latest store first.
  void add_ways(int thread, const operation& op, std::vector<action>& ways) const;

  /// Carries it out as `way`, one of those, says. Returns the value read, 0 for stores and fences.
  std::uint64_t perform(const operation& op, const action& way, std::int32_t event);

  /// A thread learns all that another one knows at its end.
  void join(int thread, int finished) { threads_[index(thread)].current.join(threads_[index(finished)].current); }

  /// The number that stands for a thread's accesses to plain fields since its last step.
  [[nodiscard]] std::uint16_t epoch(int thread) const { return threads_[index(thread)].current.known[index(thread)]; }

  /// True if another thread's plain access at that epoch happens before this thread's next one.
  [[nodiscard]] bool knows(int thread, int other, std::uint16_t epoch) const {
    return thread == other || epoch <= threads_[index(thread)].current.known[index(other)];
  }

 private:
  struct location {
    std::string name;
    std::uint64_t mask;
    show_value show;
    std::vector<message> stores;
  };
  struct thread_state {
    view current;                    ///< what happens before the thread's next step
    view acquired;                   ///< what an acquire fence would add: the views of all stores read
    view released;                   ///< current at the last release fence: what relaxed stores pass on
    bool failed_spuriously = false;  ///< its last compare-exchange
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static std::uint64_t apply(const operation& op, std::uint64_t old);

  void fence(thread_state& t, std::memory_order order);
  std::uint64_t read(thread_state& t, int cell, std::size_t store, std::memory_order order);
  void write(thread_state& t, int cell, std::uint64_t value, std::memory_order order, std::int32_t event,
             const view* continued);

  std::array<thread_state, max_threads> threads_;
  view total_;  ///< what all seq_cst operations so far have in common
  std::vector<location> locations_;
  int location_count_ = 0;
};

// ---------------------------------------------------------------------------------------------------------

inline std::int16_t memory::add_location(std::string_view name, std::uint64_t value, std::uint64_t mask,
                                         show_value show) {
  if (index(location_count_) == locations_.size()) {
    locations_.emplace_back();
  }
  location& added = locations_[index(location_count_)];
  added.name = name;
  added.mask = mask;
  added.show = show;
  added.stores.clear();
  added.stores.push_back(message{value, -1, view{}});
  return static_cast<std::int16_t>(location_count_++);
}

inline void memory::add_ways(int thread, const operation& op, std::vector<action>& ways) const {
  action way{static_cast<std::int16_t>(thread), always_writes(op.kind), is_total(op), false, op.location, 0, 0};
  const bool chooses = op.kind == operation_kind::load || op.kind == operation_kind::await ||
                       op.kind == operation_kind::compare_exchange;
  if (!chooses) {
    ways.push_back(way);
    return;
  }
  const std::vector<message>& stores = locations_[index(op.location)].stores;
  const auto last = static_cast<std::int32_t>(stores.size()) - 1;
  std::uint16_t front = threads_[index(thread)].current.seen[index(op.location)];
  if (way.total) {
    front = std::max(front, total_.seen[index(op.location)]);
  }
  for (std::int32_t store = last; store >= static_cast<std::int32_t>(front); --store) {
    const std::uint64_t value = stores[index(store)].value;
    way.store = store;
    way.age = last - store;
    if (op.kind == operation_kind::compare_exchange) {
      way.writes = store == last && value == op.expected;
      way.spurious = false;
      if (value == op.expected) {
        if (way.writes) {
          ways.push_back(way);
        }
        if (!op.weak || threads_[index(thread)].failed_spuriously) {
          continue;
        }
        way.writes = false;
        way.spurious = true;
      }
    } else if (op.kind == operation_kind::await && value != op.operand) {
      continue;
    }
    ways.push_back(way);
  }
}

inline std::uint64_t memory::apply(const operation& op, std::uint64_t old) {
  switch (op.kind) {
    case operation_kind::add:
      return old + op.operand;
    case operation_kind::minimum:
      return std::min(old, op.operand);
    case operation_kind::maximum:
      return std::max(old, op.operand);
    case operation_kind::bit_or:
      return old | op.operand;
    default:
      return op.operand;
  }
}

inline void memory::fence(thread_state& t, std::memory_order order) {
  if (acquires(order)) {
    t.current.join(t.acquired);
  }
  if (order == std::memory_order_seq_cst) {
    t.current.join(total_);
    total_ = t.current;
  }
  if (releases(order)) {
    t.released = t.current;
  }
}

inline std::uint64_t memory::read(thread_state& t, int cell, std::size_t store, std::memory_order order) {
  const message& m = locations_[index(cell)].stores[store];
  std::uint16_t& front = t.current.seen[index(cell)];
  front = std::max(front, static_cast<std::uint16_t>(store));
  if (acquires(order)) {
    t.current.join(m.released);
  }
  t.acquired.join(m.released);
  return m.value;
}

inline void memory::write(thread_state& t, int cell, std::uint64_t value, std::memory_order order, std::int32_t event,
                          const view* continued) {
  location& l = locations_[index(cell)];
  const auto place = static_cast<std::uint16_t>(l.stores.size());
  t.current.seen[index(cell)] = place;
  message m{value & l.mask, event, releases(order) ? t.current : t.released};
  m.released.seen[index(cell)] = place;
  if (continued != nullptr) {
    m.released.join(*continued);  // a read-modify-write goes on with the release sequence that it reads
  }
  l.stores.push_back(m);
}

inline std::uint64_t memory::perform(const operation& op, const action& way, std::int32_t event) {
  thread_state& t = threads_[index(way.thread)];
  const bool total = is_total(op);
  if (op.kind == operation_kind::fence || total) {
    fence(t, op.order);
  }
  std::uint64_t value = 0;
  if (op.kind == operation_kind::store) {
    write(t, op.location, op.operand, op.order, event, nullptr);
  } else if (op.location >= 0) {
    const bool takes_latest = way.writes;
    const std::vector<message>& stores = locations_[index(op.location)].stores;
    const std::size_t store = takes_latest ? stores.size() - 1 : index(way.store);
    const bool failed = op.kind == operation_kind::compare_exchange && !way.writes;
    if (op.kind == operation_kind::compare_exchange) {
      t.failed_spuriously = way.spurious;
    }
    value = read(t, op.location, store, failed ? op.failure_order : op.order);
    if (way.writes) {
      const view continued = stores[store].released;
      write(t, op.location, apply(op, value), op.order, event, &continued);
    }
  }
  if (total) {
    total_.join(t.current);
  }
  ++t.current.known[index(way.thread)];
  return value;
}

}  // namespace pelage::explore
