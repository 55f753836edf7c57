// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/explore/explore.hpp>

#include <cstdint>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace pelage::explore {

/// The thread that ran last, on the latest store that it may read; another one where that one cannot go on.
inline action go_on(std::span<const action> ways, int last_thread) {
  for (const action& way : ways) {
    if (way.thread == last_thread) {
      return way;
    }
  }
  return ways.front();
}

/// Follows a schedule as to_string() writes it, then goes on as go_on() does. Steps that are not possible, as after
/// a change of the code, are passed over.
class scripted : public strategy {
 public:
  explicit scripted(std::string_view schedule) : schedule_(schedule) {}

  bool choose(std::span<const action> ways, action& chosen) override {
    chosen = go_on(ways, last_thread_);
    for (bool found = false; !found && at_ < schedule_.size();) {
      const auto [thread, age] = next_step();
      for (const action& way : ways) {
        if (way.thread == thread && way.age == age) {
          chosen = way;
          found = true;
        }
      }
    }
    last_thread_ = chosen.thread;
    return true;
  }

 private:
  std::pair<int, int> next_step() {
    const int thread = schedule_[at_++] - 'a';
    int age = 0;
    for (; at_ < schedule_.size() && schedule_[at_] >= '0' && schedule_[at_] <= '9'; ++at_) {
      age = age * 10 + (schedule_[at_] - '0');
    }
    return {thread, age};
  }

  std::string schedule_;
  std::size_t at_ = 0;
  int last_thread_ = -1;
};

/// Follows numbers that a random source drew: 0 goes on, others pick some way. When they run out, it goes on, so
/// that a shorter list, or one of smaller numbers, is a calmer schedule: what shrinking needs.
class drawn : public strategy {
 public:
  explicit drawn(std::span<const std::uint8_t> numbers) : numbers_(numbers) {}

  bool choose(std::span<const action> ways, action& chosen) override {
    const std::size_t number = at_ < numbers_.size() ? numbers_[at_++] : 0u;
    chosen = number == 0 ? go_on(ways, last_thread_) : ways[(number - 1) % ways.size()];
    last_thread_ = chosen.thread;
    return true;
  }

 private:
  std::span<const std::uint8_t> numbers_;
  std::size_t at_ = 0;
  int last_thread_ = -1;
};

/// One schedule of one program.
inline findings run_once(const program_factory& make, strategy& choices, int patience = default_patience) {
  world w;
  findings f;
  count(f, w.run(make, choices, patience), w);
  f.schedule = to_string(w);
  return f;
}

/// Runs a schedule and prints each step with the state after it, then the fault if there is one. True if not.
inline bool replay(const program_factory& make, std::string_view schedule, std::ostream& out,
                   int patience = default_patience) {
  world w;
  w.after_step = [&out](const world& now) {
    out << now.events().size() << "  " << now.describe(now.events().back()) << "\n     " << now.tested().draw() << '\n';
  };
  scripted choices(schedule);
  const ending end = w.run(make, choices, patience);
  out << (end == ending::faulty ? "fault: " + w.fault() : "no fault") << '\n';
  return end != ending::faulty;
}

}  // namespace pelage::explore
