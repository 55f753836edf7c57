// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/explore/fiber.hpp>
#include <pelage/explore/memory.hpp>
#include <pelage/explore/operation.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pelage::explore {

/// What is explored: a few threads over watched cells (watched.hpp), built anew for every schedule.
///
/// The same schedule must do the same: no clocks, no random numbers, no addresses in what is stored. A thread's
/// body owns nothing that needs destruction (see fiber); results go to members.
class program {
 public:
  virtual ~program() = default;

  /// Threads, [1, max_threads].
  [[nodiscard]] virtual int threads() const = 0;

  /// What thread `t` does, t in [0, threads()).
  virtual void thread(int t) = 0;

  /// Checks at the end, when every thread is done; loads read the latest stores.
  virtual void finish() {}

  /// The state as a person wants to see it, after a step of a replay.
  [[nodiscard]] virtual std::string draw() const { return {}; }
};

using program_factory = std::function<std::unique_ptr<program>()>;

/// A step that was carried out.
struct event {
  operation what;
  action way;
  std::uint64_t value;  ///< read
};

/// Who goes on, and with which of the stores that it may read.
class strategy {
 public:
  virtual ~strategy() = default;

  /// Picks one of `ways`, which is not empty and holds each thread's in one run, the latest store first. Returns
  /// false to give the schedule up.
  virtual bool choose(std::span<const action> ways, action& chosen) = 0;

  /// Is told of each step.
  virtual void performed(const event&, const memory&) {}
};

enum class ending : std::uint8_t { complete, given_up, faulty };

/// One schedule of one program: hands control from fiber to fiber before each atomic operation and fence.
class world {
 public:
  world() = default;
  world(const world&) = delete;
  world& operator=(const world&) = delete;
  ~world() { active = active == this ? nullptr : active; }

  /// Runs a program under a strategy. `patience`: so many steps of all threads together without one that calls
  /// completed() are a fault, the one that a structure with locks shows when the holder is suspended.
  ending run(const program_factory& make, strategy& choices, int patience);

  /// The one that runs, or ran last. Watched cells live in one: they are members of a program, made by its factory.
  static world& current() {
    PELAGE_ASSERT(active != nullptr);
    return *active;
  }

  /// A new atomic; more than max_locations are a fault.
  std::int16_t add_location(std::string_view name, std::uint64_t value, std::uint64_t mask,
                            explore::memory::show_value show);

  /// The number of a new field, from 0.
  int add_field() { return field_count_++; }

  /// Carries an operation out: in a thread, when the scheduler lets it; elsewhere at once, on the latest stores.
  std::uint64_t operate(const operation& op);

  /// True if the operation that the running thread has just carried out was a compare-exchange that failed on what it
  /// expected.
  [[nodiscard]] bool failed_spuriously() const { return running_ >= 0 && events_.back().way.spurious; }

  /// Declares a fault; the first one counts. The schedule ends with the step.
  void fail(std::string what) {
    if (fault_.empty()) {
      fault_ = std::move(what);
    }
  }

  /// A thread has completed one of its operations on the structure.
  void completed() { last_completion_ = static_cast<int>(events_.size()); }

  /// The most steps of the last run without a completed one.
  [[nodiscard]] int longest_wait() const { return longest_wait_; }

  /// Where a run prints each step, each access to a field, and the state after a step; nullptr: nowhere.
  std::ostream* trace = nullptr;

  [[nodiscard]] const std::string& fault() const { return fault_; }
  [[nodiscard]] const std::vector<event>& events() const { return events_; }
  [[nodiscard]] explore::memory& memory() { return memory_; }
  [[nodiscard]] const explore::memory& memory() const { return memory_; }

  /// The thread that runs now, -1 outside of threads.
  [[nodiscard]] int thread() const { return running_; }

  /// A step in words: "b: load next of node 0, acquire: none".
  [[nodiscard]] std::string describe(const event& e) const;

 private:
  struct logical_thread {
    explore::fiber fiber;
    operation next;        ///< announced, not yet carried out
    action chosen;         ///< how to carry it out
    std::uint64_t result;  ///< what that read
  };

  static void enter(void* self) {
    world& w = *static_cast<world*>(self);
    w.program_->thread(w.running_);
  }
  void resume(int t);
  void collect_ways();

  static inline thread_local world* active = nullptr;

  explore::memory memory_;
  std::array<logical_thread, max_threads> threads_;
  std::unique_ptr<program> program_;
  std::vector<event> events_;
  std::vector<action> ways_;
  std::string fault_;
  int thread_count_ = 0;
  int field_count_ = 0;
  int running_ = -1;
  int last_completion_ = 0;
  int longest_wait_ = 0;
};

/// States what must hold, from a thread or from finish().
inline void expect(bool condition, std::string_view claim) {
  if (!condition) {
    world::current().fail(std::string(claim));
  }
}

/// Tells the explorer that an operation of this thread is complete: what its test of progress counts.
inline void completed() {
  world::current().completed();
}

/// The letter by which schedules and reports call a thread.
constexpr char letter(int thread) {
  return static_cast<char>('a' + thread);
}

// ---------------------------------------------------------------------------------------------------------

inline std::int16_t world::add_location(std::string_view name, std::uint64_t value, std::uint64_t mask,
                                        explore::memory::show_value show) {
  if (memory_.location_count() == max_locations) {
    fail("a program has more than " + std::to_string(max_locations) + " atomics");
    return 0;
  }
  return memory_.add_location(name, value, mask, show);
}

inline std::uint64_t world::operate(const operation& op) {
  if (running_ < 0) {
    const bool changes = always_writes(op.kind) || op.kind == operation_kind::compare_exchange;
    if (changes) {
      fail(
          "outside of thread() atomics may be loaded and not changed: fill a structure in a thread that the others "
          "await()");
    }
    return op.location < 0 ? 0 : memory_.latest(op.location);
  }
  logical_thread& self = threads_[static_cast<std::size_t>(running_)];
  self.next = op;
  self.fiber.pause();
  return self.result;
}

inline void world::resume(int t) {
  running_ = t;
  threads_[static_cast<std::size_t>(t)].fiber.resume();
  running_ = -1;
}

inline void world::collect_ways() {
  ways_.clear();
  int unfinished = 0;
  for (int t = 0; t < thread_count_; ++t) {
    unfinished += threads_[static_cast<std::size_t>(t)].fiber.finished() ? 0 : 1;
  }
  for (int t = 0; t < thread_count_; ++t) {
    const logical_thread& logical = threads_[static_cast<std::size_t>(t)];
    const bool waits_for_others = logical.next.kind == operation_kind::join && unfinished > 1;
    if (!logical.fiber.finished() && !waits_for_others) {
      memory_.add_ways(t, logical.next, ways_);
    }
  }
  if (ways_.empty() && unfinished > 0) {
    fail("deadlock: every thread waits");
  }
}

inline ending world::run(const program_factory& make, strategy& choices, int patience) {
  active = this;
  program_.reset();
  memory_.reset();
  events_.clear();
  fault_.clear();
  running_ = -1;
  field_count_ = 0;
  last_completion_ = 0;
  longest_wait_ = 0;
  program_ = make();
  thread_count_ = program_->threads();
  if (thread_count_ < 1 || thread_count_ > max_threads) {
    fail("threads() is " + std::to_string(thread_count_) + ", not in [1, " + std::to_string(max_threads) + "]");
    thread_count_ = 0;
  }
  for (int t = 0; t < thread_count_; ++t) {
    threads_[static_cast<std::size_t>(t)].fiber.start(&world::enter, this);
    resume(t);
  }
  for (collect_ways(); fault_.empty() && !ways_.empty(); collect_ways()) {
    action chosen;
    if (!choices.choose(ways_, chosen)) {
      return ending::given_up;
    }
    logical_thread& logical = threads_[static_cast<std::size_t>(chosen.thread)];
    logical.result = memory_.perform(logical.next, chosen, static_cast<std::int32_t>(events_.size()));
    if (logical.next.kind == operation_kind::join) {
      for (int t = 0; t < thread_count_; ++t) {
        memory_.join(chosen.thread, t);
      }
    }
    events_.push_back(event{logical.next, chosen, logical.result});
    choices.performed(events_.back(), memory_);
    if (trace != nullptr) {
      *trace << events_.size() << "  " << describe(events_.back()) << '\n';
    }
    resume(chosen.thread);
    if (trace != nullptr) {
      const std::string state = program_->draw();
      *trace << (state.empty() ? "" : "     " + state + '\n');
    }
    longest_wait_ = std::max(longest_wait_, static_cast<int>(events_.size()) - last_completion_);
    if (longest_wait_ > patience) {
      fail("no progress: " + std::to_string(patience) +
           " steps and no operation has completed; a loop that waits for another thread is an await() here, and each "
           "operation ends with completed()");
    }
    if (events_.size() == longest_schedule) {
      fail("a schedule is longer than " + std::to_string(longest_schedule) + " steps");
    }
  }
  if (fault_.empty()) {
    program_->finish();
  }
  return fault_.empty() ? ending::complete : ending::faulty;
}

inline std::string world::describe(const event& e) const {
  std::string text = {letter(e.way.thread), ':', ' '};
  text += e.what.weak ? "weak " : "";
  text += name_of(e.what.kind);
  if (e.what.location >= 0) {
    text += ' ' + memory_.name(e.what.location);
  }
  if (e.what.kind != operation_kind::join) {
    text += ", " + std::string(name_of(e.what.order));
  }
  if (e.what.location < 0) {
    return text;
  }
  const std::string read = memory_.show(e.what.location, e.value);
  const std::string operand = memory_.show(e.what.location, e.what.operand);
  switch (e.what.kind) {
    case operation_kind::load:
    case operation_kind::await:
      return text + ": " + read;
    case operation_kind::store:
      return text + ": " + operand;
    case operation_kind::compare_exchange:
      return text + ": " +
             (e.way.writes ? read + " becomes " + operand
                           : (e.way.spurious ? "fails without reason, finds " : "fails, finds ") + read);
    default:
      return text + ": finds " + read + ", operand " + operand;
  }
}

}  // namespace pelage::explore
