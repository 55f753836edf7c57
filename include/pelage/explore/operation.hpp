// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace pelage::explore {

inline constexpr int max_threads = 8;
inline constexpr int max_locations = 64;  ///< atomics of a program
inline constexpr std::size_t longest_schedule = 65534;

/// What a logical thread is about to do where the scheduler may hand control to another.
enum class operation_kind : std::uint8_t {
  load,
  store,
  exchange,
  add,
  minimum,
  maximum,
  bit_or,
  compare_exchange,
  fence,
  await,  ///< waits until the cell may be read as `operand`, as a loop of loads would
  join,   ///< waits until every other thread is done, and synchronises with all of them
};

/// One such step, whole: the memory model carries it out from this alone.
struct operation {
  operation_kind kind;
  std::int16_t location;  ///< of the cell; -1 for fence and join
  std::memory_order order;
  std::memory_order failure_order;  ///< of a compare-exchange that finds something else
  bool weak;                        ///< a compare-exchange that may fail without reason
  std::uint64_t operand;            ///< stored, added, compared with for minimum, maximum and await
  std::uint64_t expected;           ///< of a compare-exchange
};

/// One way to go on: which thread, and which of the stores that it may read. Equal numbers mean the same way for as
/// long as the thread has not moved.
struct action {
  std::int16_t thread;
  bool writes;            ///< takes a place in the cell's modification order
  bool total;             ///< takes a place in the order of all seq_cst operations
  bool spurious;          ///< a weak compare-exchange that fails though it finds what it expects
  std::int16_t location;  ///< -1 for fences and joins
  std::int32_t store;     ///< the place in the cell's modification order that is read; 0 where nothing is chosen
  std::int32_t age;       ///< how many stores older than the latest that is
};

constexpr bool same_way(const action& a, const action& b) {
  return a.thread == b.thread && a.store == b.store && a.writes == b.writes;
}

/// True if the two, of different threads, end in the same state in either order. A load of a store that is there
/// already does not mind a later store: it may read the old one afterwards too.
constexpr bool independent(const action& a, const action& b) {
  const bool both_write_a_cell = a.writes && b.writes && a.location == b.location;
  return !both_write_a_cell && !(a.total && b.total);
}

constexpr bool acquires(std::memory_order order) {
  return order == std::memory_order_acquire || order == std::memory_order_consume ||
         order == std::memory_order_acq_rel || order == std::memory_order_seq_cst;
}

constexpr bool releases(std::memory_order order) {
  return order == std::memory_order_release || order == std::memory_order_acq_rel || order == std::memory_order_seq_cst;
}

constexpr bool is_total(const operation& op) {
  return op.order == std::memory_order_seq_cst && op.kind != operation_kind::join;
}

constexpr bool always_writes(operation_kind kind) {
  return kind == operation_kind::store || kind == operation_kind::exchange || kind == operation_kind::add ||
         kind == operation_kind::minimum || kind == operation_kind::maximum || kind == operation_kind::bit_or;
}

constexpr std::string_view name_of(operation_kind kind) {
  constexpr std::string_view names[] = {
      "load", "store", "exchange", "add", "minimum", "maximum", "bit or", "compare-exchange", "fence", "await", "join"};
  return names[static_cast<int>(kind)];
}

constexpr std::string_view name_of(std::memory_order order) {
  constexpr std::string_view names[] = {"relaxed", "consume", "acquire", "release", "acq_rel", "seq_cst"};
  return names[static_cast<int>(order)];
}

}  // namespace pelage::explore
