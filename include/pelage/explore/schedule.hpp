// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/explore/world.hpp>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace pelage::explore {

/// A schedule as a string: the letter of the thread for each step, followed by a number where it read an older
/// store than the latest: how many stores older; and by a ! where a weak compare-exchange failed without reason.
std::string to_string(const world& w);

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
/// a change of the code, are passed over and counted.
class scripted : public strategy {
 public:
  explicit scripted(std::string_view schedule) : schedule_(schedule) {}

  bool choose(std::span<const action> ways, action& chosen) override {
    chosen = go_on(ways, last_thread_);
    for (bool found = false; !found && at_ < schedule_.size();) {
      const step next = next_step();
      for (const action& way : ways) {
        if (way.thread == next.thread && way.age == next.age && way.spurious == next.spurious) {
          chosen = way;
          found = true;
        }
      }
      passed_over_ += found ? 0 : 1;
    }
    last_thread_ = chosen.thread;
    return true;
  }

  /// The steps that were not possible, those after the program's end among them.
  [[nodiscard]] int passed_over() {
    for (; at_ < schedule_.size(); ++passed_over_) {
      next_step();
    }
    return passed_over_;
  }

 private:
  struct step {
    int thread;
    int age;
    bool spurious;
  };
  step next_step();

  std::string schedule_;
  std::size_t at_ = 0;
  int passed_over_ = 0;
  int last_thread_ = -1;
};

/// Follows numbers that a random source drew: 0 goes on, others pick some way. When they run out, it goes on, so
/// that a shorter list, or one of smaller numbers, is a calmer schedule: what shrinking needs.
class drawn : public strategy {
 public:
  /// `numbers` outlive it.
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

// ---------------------------------------------------------------------------------------------------------

inline std::string to_string(const world& w) {
  std::string text;
  for (const event& e : w.events()) {
    text += letter(e.way.thread);
    text += e.way.age > 0 ? std::to_string(e.way.age) : "";
    text += e.way.spurious ? "!" : "";
  }
  return text;
}

inline scripted::step scripted::next_step() {
  step next{schedule_[at_++] - 'a', 0, false};
  for (; at_ < schedule_.size() && schedule_[at_] >= '0' && schedule_[at_] <= '9'; ++at_) {
    next.age = std::min(next.age * 10 + (schedule_[at_] - '0'), static_cast<int>(longest_schedule));
  }
  if (at_ < schedule_.size() && schedule_[at_] == '!') {
    next.spurious = true;
    ++at_;
  }
  return next;
}

}  // namespace pelage::explore
