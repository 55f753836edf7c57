// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// Watched cells against std::atomic, their names, and what they say of programs that are too large.
#include <pelage/explore/explore.hpp>

#include <pelage/explore/plain_field.hpp>

#include "explore/bodies.hpp"
#include "property.hpp"

#include <array>
#include <atomic>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace pelage::explore;

/// What a structure over either kind of cells does in one thread, and what it holds in the end.
template <template <class> class Atomic, template <class> class Field, class T>
std::vector<T> run_steps(const std::vector<std::pair<int, T>>& steps) {
  Atomic<T> cell{T{1}};
  Field<T> last{T{0}};
  std::vector<T> seen;
  for (const auto& [kind, value] : steps) {
    T expected = last.read();
    switch (kind) {
      case 0:
        last.write(cell.fetch_add(value));
        break;
      case 1:
        last.write(cell.fetch_sub(value));
        break;
      case 2:
        last.write(cell.fetch_or(value));
        break;
      case 3:
        last.write(cell.exchange(value));
        break;
      case 4:
        seen.push_back(static_cast<T>(cell.compare_exchange_strong(expected, value)));
        last.write(expected);
        break;
      default:
        while (!cell.compare_exchange_weak(expected, value, std::memory_order_release)) {
        }
        last.write(expected);
    }
    seen.push_back(last.read());
  }
  seen.push_back(cell.load());
  return seen;
}

/// Runs a body as the only thread of a program whose state is State; its only schedule unless it asks for more.
template <class State>
findings run_alone(void (*body)(State&)) {
  drawn goes_on({});
  return run_once(of_bodies<State>({body}), goes_on);
}

template <class T>
void expect_same_as_std(const char* name) {
  pelage::test::holds(name, [] {
    struct nothing {};
    static std::vector<std::pair<int, T>> steps;
    static std::vector<T> seen;
    steps = *rc::gen::container<std::vector<std::pair<int, T>>>(
        rc::gen::pair(rc::gen::inRange(0, 6), rc::gen::arbitrary<T>()));
    const findings f = run_alone<nothing>([](nothing&) { seen = run_steps<watched_atomic, watched_field>(steps); });
    RC_ASSERT(f.fault.empty());
    RC_ASSERT((seen == run_steps<std::atomic, plain_field>(steps)));
  });
}

TEST_CASE("in one thread watched cells do what std::atomic and plain fields do, signed and narrow ones too") {
  expect_same_as_std<int>("watched int");
  expect_same_as_std<std::uint8_t>("watched byte");
  expect_same_as_std<std::int16_t>("watched short");
  expect_same_as_std<std::uint64_t>("watched 64 bits");
}

struct slots {
  std::array<watched_atomic<int>, 2> head;
  std::array<watched_field<int>, 2> payload;
  watched_atomic<bool> named{"ready"};
  watched_atomic<int> valued{-3};
  watched_field<int> field{std::string("last")};
};

TEST_CASE("cells without a name are numbered, text is a name, all else a value") {
  const auto make = of_bodies<slots>({[](slots& s) {
    s.payload[1].write(5);
    s.head[1].store(s.payload[1].read());
    s.named.store(true);
    s.valued.fetch_sub(2);
    s.field.write(1);
  }});
  std::ostringstream steps;
  CHECK(replay(make, "", steps));
  CHECK(steps.str() ==
        "   a: write field 1: 5\n"
        "   a: read field 1: 5\n"
        "1  a: store atomic 1, seq_cst: 5\n"
        "2  a: store ready, seq_cst: 1\n"
        "3  a: add atomic 3, seq_cst: finds -3, operand -2\n"
        "   a: write last: 1\n"
        "no fault\n");
}

template <int Count>
struct many_atomics {
  std::array<watched_atomic<int>, Count> cells;
};

TEST_CASE("a program of too many atomics or threads is a fault that says so, not a crash") {
  const auto adds = []<int Count>(many_atomics<Count>& m) { m.cells.back().store(1); };
  CHECK(run_alone<many_atomics<max_locations>>(adds).fault.empty());
  CHECK(run_alone<many_atomics<max_locations + 1>>(adds).fault == "a program has more than 64 atomics");
  using body = void (*)(many_atomics<1>&);
  CHECK(explore_all(of_bodies<many_atomics<1>>(std::vector<body>(max_threads + 1, body(adds)))).fault ==
        "threads() is 9, not in [1, 8]");
  CHECK(explore_all(of_bodies<many_atomics<1>>({})).fault == "threads() is 0, not in [1, 8]");
}

TEST_CASE("a program without end is a fault, even if operations complete") {
  const findings f = run_alone<many_atomics<1>>([](many_atomics<1>& m) {
    for (;;) {
      (void)m.cells[0].load();
      completed();
    }
  });
  CHECK(f.fault == "a schedule is longer than 65534 steps");
}

TEST_CASE("a change outside of thread() is a fault") {
  const auto make =
      of_bodies<many_atomics<1>>({[](many_atomics<1>&) {}}, [](many_atomics<1>& m) { m.cells[0].store(1); });
  CHECK(explore_all(make).fault ==
        "outside of thread() atomics may be loaded and not changed: fill a structure in a thread that the others "
        "await()");
}

TEST_CASE("fence and await are the program's own over std::atomic, the explorer's over watched cells") {
  struct message {
    watched_atomic<int> ready;
    watched_field<int> text{"text"};
  };
  using body = void (*)(message&);
  constexpr auto relaxed = std::memory_order_relaxed;
  const body sends = [](message& m) {
    m.text.write(1);
    fence<watched_atomic<int>>(std::memory_order_release);
    m.ready.store(1, relaxed);
  };
  const body receives = [](message& m) {
    await(m.ready, 1, std::memory_order_acquire);
    expect(m.text.read() == 1, "not the text");
  };
  const body too_early = [](message& m) {
    await(m.ready, 1, relaxed);
    (void)m.text.read();
  };
  const findings sound = explore_all(of_bodies<message>({sends, receives}));
  CHECK_MESSAGE(sound.fault.empty(), sound);
  CHECK(sound.schedules == 1);
  CHECK(explore_all(of_bodies<message>({sends, too_early})).fault.rfind("race on text", 0) == 0);
  std::atomic<int> own{1};
  fence<std::atomic<int>>(std::memory_order_seq_cst);
  await(own, 1);
}

TEST_CASE("a replay says how many steps it passed over") {
  void (*const adds)(many_atomics<1>&) = [](many_atomics<1>& m) { m.cells[0].fetch_add(1); };
  const auto make = of_bodies<many_atomics<1>>({adds, adds});
  for (const auto& [schedule, said] : {std::pair{"ab", 0}, {"ba", 0}, {"aa2zb", 2}, {"abb!a", 2}}) {
    std::ostringstream steps;
    CHECK(replay(make, schedule, steps));
    const std::string line =
        "not this program's schedule: " + std::to_string(said) + " of its steps are not possible\n";
    CHECK_MESSAGE((steps.str().find(said > 0 ? line : "not this") != std::string::npos) == (said > 0), steps.str());
  }
}

TEST_CASE("any text is a schedule: what it asks for and cannot be had is passed over") {
  pelage::test::holds("any text is a schedule", [] {
    const auto text = *rc::gen::container<std::string>(rc::gen::elementOf(std::string("abc09!z ")));
    void (*const adds)(many_atomics<1>&) = [](many_atomics<1>& m) {
      int held = m.cells[0].load();
      while (!m.cells[0].compare_exchange_weak(held, held + 1)) {
      }
    };
    const auto make = of_bodies<many_atomics<1>>({adds, adds});
    scripted first(text);
    const findings f = run_once(make, first);
    RC_ASSERT(f.fault.empty());
    scripted again(f.schedule);
    RC_ASSERT(run_once(make, again).schedule == f.schedule);
  });
}

}  // namespace
