// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// How to test a structure of your own: include/pelage/explore/README.md with a planted fault for each memory order.
#include <pelage/explore/explore.hpp>
#include <pelage/explore/plain_field.hpp>

#include <doctest/doctest.h>

#include <atomic>
#include <memory>
#include <sstream>
#include <string>
#include <thread>

struct mailbox_orders {
  std::memory_order claim = std::memory_order_acquire;    // (1) pairs with (4): the last message has been read
  std::memory_order publish = std::memory_order_release;  // (2) pairs with (3): the message is there
  std::memory_order look = std::memory_order_acquire;     // (3) pairs with (2)
  std::memory_order clear = std::memory_order_release;    // (4) pairs with (1)
};

// Holds one message at most: put() and take() succeed or say at once that they cannot. The orders are a parameter only
// so that the test can weaken them.
template <template <class> class Atomic, template <class> class Field>
struct mailbox {
  Atomic<int> state{0};  // 0 empty, 1 being filled, 2 full
  Field<int> message{0};
  mailbox_orders order{};

  bool put(int m) {
    int expected = 0;
    if (!state.compare_exchange_strong(expected, 1, order.claim)) {  // (1)
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

  void wait_and_take() {
    pelage::explore::await(state, 2, order.look);
    (void)take();
  }
};

using plain_mailbox = mailbox<std::atomic, pelage::explore::plain_field>;
using watched_mailbox = mailbox<pelage::explore::watched_atomic, pelage::explore::watched_field>;

class mailbox_program : public pelage::explore::program {
 public:
  explicit mailbox_program(mailbox_orders order) : box_{.state{"state"}, .message{"message"}, .order = order} {}

  [[nodiscard]] int threads() const override { return 3; }

  void thread(int t) override {
    if (t == 2) {
      for (int& m : taken_) {
        m = box_.take();
        pelage::explore::completed();
      }
    } else {
      put_[t] = box_.put(7 + t);
      pelage::explore::completed();
    }
  }

  void finish() override {
    using pelage::explore::expect;
    for (const int m : taken_) {
      expect(m == 0 || (m == 7 && put_[0]) || (m == 8 && put_[1]), "a message is taken that nobody put");
    }
    expect(taken_[0] == 0 || taken_[0] != taken_[1], "a message is taken twice");
  }

 private:
  watched_mailbox box_;
  bool put_[2] = {false, false};
  int taken_[2] = {0, 0};
};

pelage::explore::program_factory program_of(mailbox_orders order) {
  return [=] { return std::make_unique<mailbox_program>(order); };
}

TEST_CASE("a mailbox passes whole messages under every schedule") {
  const pelage::explore::findings found = pelage::explore::explore_all(program_of({}));
  CHECK_MESSAGE(found.fault.empty(), found);
  CHECK(found.all);
  CHECK(found.schedules > 10);
  CHECK(found.trace.empty());
}

TEST_CASE("each order of the mailbox is needed") {
  constexpr auto relaxed = std::memory_order_relaxed;
  for (const mailbox_orders& weak : {mailbox_orders{.claim = relaxed}, mailbox_orders{.publish = relaxed},
                                     mailbox_orders{.look = relaxed}, mailbox_orders{.clear = relaxed}}) {
    CHECK(pelage::explore::explore_all(program_of(weak)).fault.rfind("race on message", 0) == 0);
  }
}

TEST_CASE("a fault comes with its steps, the accesses to fields among them, and what shows them again") {
  const auto make = program_of({.publish = std::memory_order_relaxed});
  const pelage::explore::findings found = pelage::explore::explore_all(make);
  CHECK(found.trace ==
        "1  a: compare-exchange state, acquire: 0 becomes 1\n"
        "   a: write message: 7\n"
        "2  a: store state, relaxed: 2\n"
        "3  b: compare-exchange state, acquire: fails, finds 2\n"
        "4  c: load state, acquire: 2\n"
        "   c: read message: 7\n"
        "fault: race on message: c reads it after step 4, it was written by a after step 1, and nothing orders the "
        "two\n");
  std::ostringstream printed;
  printed << found;
  CHECK(printed.str().find('\n' + found.trace + "again: replay(make, \"" + found.schedule + "\", std::cout)\n") !=
        std::string::npos);
  std::ostringstream replayed;
  CHECK_FALSE(pelage::explore::replay(make, found.schedule, replayed));
  CHECK(replayed.str() == found.trace);
}

TEST_CASE("the same mailbox over std::atomic and plain fields is the program's own") {
  plain_mailbox box;
  std::thread writer([&] { CHECK(box.put(7)); });
  box.wait_and_take();
  writer.join();
  CHECK(box.take() == 0);
  CHECK(box.put(8));
  CHECK_FALSE(box.put(9));
  CHECK(box.take() == 8);
}
