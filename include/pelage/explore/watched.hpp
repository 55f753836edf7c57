// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/explore/world.hpp>

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

namespace pelage::explore {

/// Stands for std::atomic_thread_fence.
inline void fence(std::memory_order order) {
  world::current().operate({operation_kind::fence, -1, order, std::memory_order_relaxed, false, 0, 0});
}

/// Text is the name of a watched cell, all else its first value.
template <class Name>
concept cell_name = std::convertible_to<const Name&, std::string_view>;

/// Stands for std::atomic<T> and std::atomic_ref<T> in a program under exploration: before each operation the
/// scheduler may let others go first, and a load may read any store that its order leaves visible.
///
/// T is trivially copyable and has at most 8 bytes. Without a name it is "atomic 0", "atomic 1", ... in reports, by its
/// place among the program's atomics.
template <class T>
class watched_atomic {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= 8,
                "watched_atomic<T>: T is trivially copyable and has at most 8 bytes");

 public:
  watched_atomic(T value = T{})
      : watched_atomic("atomic " + std::to_string(world::current().memory().location_count()), value) {}
  /// `show`: how reports print a value; integers in decimal by default.
  template <cell_name Name>
  watched_atomic(const Name& name, T value = T{}, explore::memory::show_value show = &plainly)
      : location_(world::current().add_location(name, raw(value), mask, show)) {}

  [[nodiscard]] T load(std::memory_order order = std::memory_order_seq_cst) const {
    return typed(act(operation_kind::load, order, raw(T{})));
  }
  void store(T value, std::memory_order order = std::memory_order_seq_cst) {
    act(operation_kind::store, order, raw(value));
  }
  T exchange(T value, std::memory_order order = std::memory_order_seq_cst) {
    return typed(act(operation_kind::exchange, order, raw(value)));
  }
  T fetch_add(T value, std::memory_order order = std::memory_order_seq_cst) requires std::integral<T> {
    return typed(act(operation_kind::add, order, raw(value)));
  }
  T fetch_sub(T value, std::memory_order order = std::memory_order_seq_cst) requires std::integral<T> {
    return typed(act(operation_kind::add, order, ~raw(value) + 1));
  }
  T fetch_or(T value, std::memory_order order = std::memory_order_seq_cst) requires std::integral<T> {
    return typed(act(operation_kind::bit_or, order, raw(value)));
  }
  T fetch_min(T value, std::memory_order order = std::memory_order_seq_cst) requires std::unsigned_integral<T> {
    return typed(act(operation_kind::minimum, order, raw(value)));
  }
  T fetch_max(T value, std::memory_order order = std::memory_order_seq_cst) requires std::unsigned_integral<T> {
    return typed(act(operation_kind::maximum, order, raw(value)));
  }

  /// As std::atomic's: `expected` becomes what was found; with one order, a failure takes that without its release.
  bool compare_exchange_strong(T& expected, T desired, std::memory_order success, std::memory_order failure) {
    return compare_exchange(expected, desired, success, failure, false);
  }
  bool compare_exchange_strong(T& expected, T desired, std::memory_order order = std::memory_order_seq_cst) {
    return compare_exchange(expected, desired, order, without_release(order), false);
  }
  /// The same, which may also fail without reason, though never twice in a row in one thread.
  bool compare_exchange_weak(T& expected, T desired, std::memory_order success, std::memory_order failure) {
    return compare_exchange(expected, desired, success, failure, true);
  }
  bool compare_exchange_weak(T& expected, T desired, std::memory_order order = std::memory_order_seq_cst) {
    return compare_exchange(expected, desired, order, without_release(order), true);
  }

  /// Waits for a value as a loop of loads would, but without a schedule for each turn of the loop.
  void await(T value, std::memory_order order = std::memory_order_seq_cst) {
    act(operation_kind::await, order, raw(value));
  }

  /// std::atomic_thread_fence.
  static void fence(std::memory_order order) { explore::fence(order); }

  /// Its number in world::memory().
  [[nodiscard]] int location() const { return location_; }

 private:
  static constexpr std::uint64_t mask = sizeof(T) == 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << sizeof(T) * 8) - 1;

  static std::string plainly(std::uint64_t value) {
    if constexpr (std::integral<T>) {
      return std::to_string(typed(value));
    } else {
      return std::to_string(value);
    }
  }
  static std::uint64_t raw(T value) {
    std::array<unsigned char, 8> bytes{};
    const auto own = std::bit_cast<std::array<unsigned char, sizeof(T)>>(value);
    for (std::size_t i = 0; i < own.size(); ++i) {
      bytes[i] = own[i];
    }
    return std::bit_cast<std::uint64_t>(bytes);
  }
  static T typed(std::uint64_t value) {
    const auto bytes = std::bit_cast<std::array<unsigned char, 8>>(value);
    std::array<unsigned char, sizeof(T)> own{};
    for (std::size_t i = 0; i < own.size(); ++i) {
      own[i] = bytes[i];
    }
    return std::bit_cast<T>(own);
  }
  static constexpr std::memory_order without_release(std::memory_order order) {
    return order == std::memory_order_acq_rel   ? std::memory_order_acquire
           : order == std::memory_order_release ? std::memory_order_relaxed
                                                : order;
  }
  std::uint64_t act(operation_kind kind, std::memory_order order, std::uint64_t operand) const {
    return world::current().operate({kind, location_, order, std::memory_order_relaxed, false, operand, 0});
  }
  bool compare_exchange(T& expected, T desired, std::memory_order success, std::memory_order failure, bool weak) {
    const std::uint64_t wanted = raw(expected);
    const std::uint64_t found = world::current().operate(
        {operation_kind::compare_exchange, location_, success, failure, weak, raw(desired), wanted});
    expected = typed(found);
    return found == wanted && !world::current().failed_spuriously();
  }

  std::int16_t location_;
};

/// Stands for an ordinary field, as plain_field in the program. Two accesses to it, one of them a write, that nothing
/// orders are reported as a race, both of them, whichever came first in the schedule at hand. T is copyable.
template <class T>
class watched_field {
 public:
  watched_field(T value = T{}) : watched_field("field " + std::to_string(world::current().add_field()), value) {}
  template <cell_name Name>
  watched_field(const Name& name, T value = T{}) : name_(name), value_(value) {}

  [[nodiscard]] T read() const {
    check(last_write_, "reads", "written");
    note(last_read_, "read", value_);
    return value_;
  }
  void write(T value) {
    check(last_write_, "writes", "written");
    check(last_read_, "writes", "read");
    note(last_write_, "write", value);
    value_ = value;
  }

  /// The value, for drawings: not an access.
  [[nodiscard]] T peek() const { return value_; }

 private:
  struct access {
    std::uint16_t epoch = 0;  ///< 0: none
    std::uint16_t step = 0;
  };
  using accesses = std::array<access, max_threads>;

  void note(accesses& by_thread, std::string_view does, const T& value) const {
    const world& w = world::current();
    if (w.thread() >= 0) {
      by_thread[static_cast<std::size_t>(w.thread())] =
          access{w.memory().epoch(w.thread()), static_cast<std::uint16_t>(w.events().size())};
    }
    if (w.trace != nullptr && w.thread() >= 0) {
      *w.trace << "   " << letter(w.thread()) << ": " << does << ' ' << name_;
      if constexpr (requires { *w.trace << value; }) {
        *w.trace << ": " << value;
      }
      *w.trace << '\n';
    }
  }
  void check(const accesses& earlier, std::string_view does, std::string_view was) const {
    world& w = world::current();
    for (int other = 0; w.thread() >= 0 && other < max_threads; ++other) {
      const access a = earlier[static_cast<std::size_t>(other)];
      if (a.epoch != 0 && !w.memory().knows(w.thread(), other, a.epoch)) {
        w.fail("race on " + name_ + ": " + letter(w.thread()) + ' ' + std::string(does) + " it after step " +
               std::to_string(w.events().size()) + ", it was " + std::string(was) + " by " + letter(other) +
               " after step " + std::to_string(a.step) + ", and nothing orders the two");
      }
    }
  }

  std::string name_;
  T value_;
  mutable accesses last_read_{};
  mutable accesses last_write_{};
};

/// Waits until all other threads are done, and synchronises with them, as std::thread::join does.
inline void join_others() {
  world::current().operate(
      {operation_kind::join, -1, std::memory_order_acquire, std::memory_order_relaxed, false, 0, 0});
}

}  // namespace pelage::explore
