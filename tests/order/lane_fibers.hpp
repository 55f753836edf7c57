// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/lane_group.hpp>
#include <pelage/explore/fiber.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace pelage::test {

/// A lane_group of any size whose lanes are fibers in one thread. It finds what a device would not forgive: a call of
/// the group that some lanes make and others do not, and a word that two lanes touch, one of them storing, without a
/// barrier between.
class lane_fibers {
 public:
  enum class call : std::uint8_t { shuffle, count, barrier };

  /// One lane's view: a lane_group.
  class view {
   public:
    view(lane_fibers& all, std::uint32_t lane) : all_(&all), lane_(lane) {}
    [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(all_->lanes_.size()); }
    [[nodiscard]] std::uint32_t lane() const { return lane_; }
    [[nodiscard]] std::uint32_t shuffle(std::uint32_t value, std::uint32_t from) const {
      all_->meet(lane_, call::shuffle, value);
      if (from >= size()) all_->fail("a lane that is none");
      return from < size() ? all_->lanes_[from].met : 0U;
    }
    [[nodiscard]] std::uint32_t shuffle_xor(std::uint32_t value, std::uint32_t bits) const {
      return shuffle(value, lane_ ^ bits);
    }
    [[nodiscard]] lane_count count(bool holds) const {
      all_->meet(lane_, call::count, holds ? 1U : 0U);
      lane_count sum{};
      for (std::uint32_t l = 0; l < size(); ++l) {
        sum.all += all_->lanes_[l].met;
        sum.below += l < lane_ ? all_->lanes_[l].met : 0U;
      }
      return sum;
    }
    [[nodiscard]] std::uint32_t load(std::uint32_t word) const { return all_->touch(lane_, word, false).value; }
    void store(std::uint32_t word, std::uint32_t value) { all_->touch(lane_, word, true).value = value; }
    void barrier() {
      all_->meet(lane_, call::barrier, 0U);
      if (lane_ == 0 && all_->barriers_++ != all_->missing_) ++all_->epoch_;
    }

   private:
    lane_fibers* all_;
    std::uint32_t lane_;
  };

  /// `missing`: the number of a barrier that is left out, to see that the lack is found.
  lane_fibers(std::uint32_t size, std::uint32_t words, std::uint32_t missing = 0xffffffffU)
      : lanes_(size), words_(words), missing_(missing) {}

  /// Runs body(view) in each lane, which owns nothing that needs destruction. Returns the fault, or nothing.
  template <class Body>
  std::string run(Body body) {
    struct entry {
      lane_fibers* self;
      Body* body;
      std::uint32_t lane;
    };
    std::vector<entry> entries;
    for (std::uint32_t l = 0; l < lanes_.size(); ++l)
      entries.push_back({this, &body, l});
    for (std::uint32_t l = 0; l < lanes_.size(); ++l) {
      lanes_[l].fiber.start(
          [](void* argument) {
            const entry e = *static_cast<entry*>(argument);
            view mine(*e.self, e.lane);
            (*e.body)(mine);
          },
          &entries[l]);
    }
    std::uint32_t finished = 0;
    while (fault_.empty() && finished == 0) {
      for (lane& l : lanes_) {
        l.fiber.resume();
        finished += l.fiber.finished() ? 1 : 0;
      }
      for (lane& l : lanes_) {
        if (finished > 0 && !l.fiber.finished()) fail("some lanes have ended, others call the group");
        if (finished == 0 && l.what != lanes_[0].what) fail("lanes make different calls");
        l.met = l.value;
      }
    }
    return fault_;
  }

  /// Barriers that were met.
  [[nodiscard]] std::uint32_t barriers() const { return barriers_; }

 private:
  struct lane {
    explore::fiber fiber;
    call what = call::barrier;
    std::uint32_t value = 0;  ///< passed to the call that it waits in
    std::uint32_t met = 0;    ///< passed to the one that all have met in
  };
  struct word {
    std::uint32_t value = 0xdeadbeefU;
    std::uint64_t epoch = 0;  ///< of the last access: what follows is of this one alone
    std::uint32_t first = 0;  ///< lane
    bool by_several = false;
    bool stored = false;
  };

  void meet(std::uint32_t l, call what, std::uint32_t value) {
    lanes_[l].what = what;
    lanes_[l].value = value;
    lanes_[l].fiber.pause();
  }

  word& touch(std::uint32_t l, std::uint32_t i, bool stores) {
    if (i >= words_.size()) {
      fail("a word that the group has not");
      i = 0;
    }
    word& w = words_[i];
    const bool again = w.epoch == epoch_;
    if (again && (w.stored || stores) && (w.first != l || w.by_several)) fail("a race");
    w.by_several = again && (w.by_several || w.first != l);
    w.stored = stores || (again && w.stored);
    w.first = again ? w.first : l;
    w.epoch = epoch_;
    return w;
  }

  void fail(const char* what) {
    if (fault_.empty()) fault_ = what;
  }

  std::vector<lane> lanes_;
  std::vector<word> words_;
  std::string fault_;
  std::uint64_t epoch_ = 1;
  std::uint32_t missing_;
  std::uint32_t barriers_ = 0;
};

static_assert(lane_group<lane_fibers::view>);

}  // namespace pelage::test
