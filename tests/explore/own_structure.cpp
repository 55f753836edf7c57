// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// How to test a structure of your own, from its first line to a planted fault. The README shows this file.
#include <pelage/explore/explore.hpp>
#include <pelage/explore/watched.hpp>

#include <doctest/doctest.h>

#include <memory>

// 1. Write the structure over its cells' types, as Pelage's are written over a storage. In the program these are
//    std::atomic<int> and int; under test they are watched_atomic<int> and watched_field<int>. The orders are a
//    parameter here only so that the test can weaken them.
struct mailbox_orders {
  std::memory_order claim = std::memory_order_acquire;    // (1) pairs with (4): the last message has been read
  std::memory_order publish = std::memory_order_release;  // (2) pairs with (3): the message is there
  std::memory_order look = std::memory_order_acquire;     // (3) pairs with (2)
  std::memory_order clear = std::memory_order_release;    // (4) pairs with (1)
};

// Holds one message at most: put() and take() succeed or say at once that they cannot.
template <class Atomic, class Field>
struct mailbox {
  Atomic state;  // 0 empty, 1 being filled, 2 full
  Field message;
  mailbox_orders order;

  bool put(int m) {
    int expected = 0;
    if (!state.compare_exchange_strong(expected, 1, order.claim, std::memory_order_relaxed)) {  // (1)
      return false;
    }
    message.write(m);
    state.store(2, order.publish);  // (2)
    return true;
  }

  int take() {
    if (state.load(order.look) != 2) {  // (3)
      return 0;
    }
    const int m = message.read();
    state.store(0, order.clear);  // (4)
    return m;
  }
};

// 2. A program says what the threads do and what must hold. It is built anew for each schedule. A thread's body keeps
//    nothing on its stack that needs destruction: results go to members.
class mailbox_program : public pelage::explore::program {
 public:
  explicit mailbox_program(mailbox_orders order)
      : box_{pelage::explore::watched_atomic<int>("state"), pelage::explore::watched_field<int>("message"), order} {}

  [[nodiscard]] int threads() const override { return 3; }

  void thread(int t) override {
    if (t == 2) {
      for (int& m : taken_) {
        m = box_.take();
        pelage::explore::completed();  // what progress is counted by: leave it out where threads may wait
      }
    } else {
      put_[t] = box_.put(7 + t);
      pelage::explore::completed();
    }
  }

  void finish() override {  // all threads are done
    using pelage::explore::expect;
    for (const int m : taken_) {
      expect(m == 0 || (m == 7 && put_[0]) || (m == 8 && put_[1]), "a message is taken that nobody put");
    }
    expect(taken_[0] == 0 || taken_[0] != taken_[1], "a message is taken twice");
  }

 private:
  mailbox<pelage::explore::watched_atomic<int>, pelage::explore::watched_field<int>> box_;
  bool put_[2] = {false, false};
  int taken_[2] = {0, 0};
};

pelage::explore::findings explore_mailbox(mailbox_orders order) {
  return pelage::explore::explore_all([=] { return std::make_unique<mailbox_program>(order); });
}

// 3. Explore every schedule. What is found tells how many there were, what went wrong, and in which schedule.
TEST_CASE("a mailbox passes whole messages under every schedule") {
  const pelage::explore::findings found = explore_mailbox({});
  CHECK_MESSAGE(found.fault.empty(), found);
  CHECK(found.all);
  CHECK(found.schedules > 10);
}

// 4. Then test the test: weaken each order that you think you need, and demand that it is found. An order whose
//    weakening is never found is one that you do not need, or a case that you have not written down.
TEST_CASE("each order of the mailbox is needed") {
  constexpr auto relaxed = std::memory_order_relaxed;
  for (const mailbox_orders& weak : {mailbox_orders{.claim = relaxed}, mailbox_orders{.publish = relaxed},
                                     mailbox_orders{.look = relaxed}, mailbox_orders{.clear = relaxed}}) {
    CHECK(explore_mailbox(weak).fault.rfind("race on message", 0) == 0);
  }
}
