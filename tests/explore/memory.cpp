// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// The memory model against the litmus tests of the literature: what C++ allows is reached, what it forbids is not.
#include <pelage/explore/explore.hpp>

#include "explore/bodies.hpp"

#include <doctest/doctest.h>

#include <array>
#include <set>

namespace {

using namespace pelage::explore;
constexpr auto relaxed = std::memory_order_relaxed;
constexpr auto acquire = std::memory_order_acquire;
constexpr auto release = std::memory_order_release;
constexpr auto acq_rel = std::memory_order_acq_rel;
constexpr auto seq_cst = std::memory_order_seq_cst;

struct cells {
  watched_atomic<int> x{"x"};
  watched_atomic<int> y{"y"};
  watched_atomic<unsigned> n{"n"};
  watched_field<int> plain{"plain"};
  std::array<int, 4> r{};
};
using body = void (*)(cells&);
using outcome = std::array<int, 4>;

std::set<outcome>* seen = nullptr;

/// Every outcome that some schedule reaches; a fault, such as a race, where one was found.
struct result {
  std::set<outcome> outcomes;
  findings found;
};

result outcomes(std::vector<body> threads) {
  result all;
  seen = &all.outcomes;
  all.found = explore_all(of_bodies<cells>(std::move(threads), [](cells& c) { seen->insert(c.r); }));
  return all;
}

bool reached(const result& all, outcome o) {
  return all.outcomes.count(o) != 0;
}

bool has_race(const result& all) {
  return all.found.fault.rfind("race on plain", 0) == 0;
}

TEST_CASE("a message passed by release and acquire arrives whole") {
  const auto all = outcomes({[](cells& c) {
                               c.plain.write(1);
                               c.x.store(1, relaxed);
                               c.y.store(1, release);
                             },
                             [](cells& c) {
                               c.r[0] = c.y.load(acquire);
                               if (c.r[0] == 1) {
                                 c.r[1] = c.x.load(relaxed);
                                 c.r[2] = c.plain.read();
                               }
                             }});
  CHECK(all.found.fault.empty());
  CHECK(all.outcomes == std::set<outcome>{{0, 0, 0, 0}, {1, 1, 1, 0}});
}

TEST_CASE("without release, or without acquire, the message's flag arrives before it") {
  const auto no_release = outcomes({[](cells& c) {
                                      c.x.store(1, relaxed);
                                      c.y.store(1, relaxed);
                                    },
                                    [](cells& c) {
                                      c.r[0] = c.y.load(acquire);
                                      c.r[1] = c.x.load(relaxed);
                                    }});
  CHECK(reached(no_release, {1, 0, 0, 0}));
  const auto no_acquire = outcomes({[](cells& c) {
                                      c.x.store(1, relaxed);
                                      c.y.store(1, release);
                                    },
                                    [](cells& c) {
                                      c.r[0] = c.y.load(relaxed);
                                      c.r[1] = c.x.load(relaxed);
                                    }});
  CHECK(reached(no_acquire, {1, 0, 0, 0}));
}

TEST_CASE("a field read without an acquire is reported as a race with both accesses") {
  const auto all = outcomes({[](cells& c) {
                               c.plain.write(1);
                               c.y.store(1, release);
                             },
                             [](cells& c) {
                               if (c.y.load(relaxed) == 1) {
                                 c.r[0] = c.plain.read();
                               }
                             }});
  CHECK(all.found.fault ==
        "race on plain: b reads it after step 2, it was written by a after step 0, and nothing orders the two");
}

TEST_CASE("a race is found also where the write comes after the read in every schedule that runs") {
  const auto all = outcomes({[](cells& c) { c.r[0] = c.plain.read(); },
                             [](cells& c) {
                               c.x.store(1, relaxed);
                               c.plain.write(1);
                             }});
  CHECK(has_race(all));
}

TEST_CASE("fences around relaxed accesses pass a message, and each of the two is needed") {
  const body with_fence = [](cells& c) {
    c.plain.write(1);
    fence(release);
    c.y.store(1, relaxed);
  };
  const body fence_too_late = [](cells& c) {
    c.plain.write(1);
    c.y.store(1, relaxed);
    fence(release);
  };
  const body reads_with_fence = [](cells& c) {
    if (c.y.load(relaxed) == 1) {
      fence(acquire);
      c.r[0] = c.plain.read();
    }
  };
  const body reads_without = [](cells& c) {
    if (c.y.load(relaxed) == 1) {
      c.r[0] = c.plain.read();
    }
  };
  CHECK(outcomes({with_fence, reads_with_fence}).found.fault.empty());
  CHECK(has_race(outcomes({with_fence, reads_without})));
  CHECK(has_race(outcomes({fence_too_late, reads_with_fence})));
}

TEST_CASE("a release sequence goes on through read-modify-writes of other threads, not through their stores") {
  const body publishes = [](cells& c) {
    c.plain.write(1);
    c.n.store(1, release);
  };
  const body reads = [](cells& c) {
    if (c.n.load(acquire) == 2) {
      c.r[0] = c.plain.read();
    }
  };
  const auto added = outcomes({publishes, [](cells& c) { c.n.fetch_add(1, relaxed); }, reads});
  CHECK(added.found.fault.empty());
  CHECK(reached(added, {1, 0, 0, 0}));
  const auto stored = outcomes({publishes, [](cells& c) { c.n.store(2, relaxed); }, reads});
  CHECK(has_race(stored));
}

TEST_CASE("one cell never runs backwards for a reader") {
  const auto all = outcomes({[](cells& c) {
                               c.x.store(1, relaxed);
                               c.x.store(2, relaxed);
                             },
                             [](cells& c) {
                               c.r[0] = c.x.load(relaxed);
                               c.r[1] = c.x.load(relaxed);
                             }});
  CHECK(all.outcomes.size() == 6);
  CHECK_FALSE(reached(all, {2, 1, 0, 0}));
  CHECK_FALSE(reached(all, {1, 0, 0, 0}));
}

TEST_CASE("store buffering is there under release and acquire, gone under seq_cst") {
  const auto weak = outcomes({[](cells& c) {
                                c.x.store(1, release);
                                c.r[0] = c.y.load(acquire);
                              },
                              [](cells& c) {
                                c.y.store(1, release);
                                c.r[1] = c.x.load(acquire);
                              }});
  CHECK(reached(weak, {0, 0, 0, 0}));
  const auto strong = outcomes({[](cells& c) {
                                  c.x.store(1, seq_cst);
                                  c.r[0] = c.y.load(seq_cst);
                                },
                                [](cells& c) {
                                  c.y.store(1, seq_cst);
                                  c.r[1] = c.x.load(seq_cst);
                                }});
  CHECK_FALSE(reached(strong, {0, 0, 0, 0}));
  CHECK(strong.outcomes.size() == 3);
  const auto fenced = outcomes({[](cells& c) {
                                  c.x.store(1, relaxed);
                                  fence(seq_cst);
                                  c.r[0] = c.y.load(relaxed);
                                },
                                [](cells& c) {
                                  c.y.store(1, relaxed);
                                  fence(seq_cst);
                                  c.r[1] = c.x.load(relaxed);
                                }});
  CHECK_FALSE(reached(fenced, {0, 0, 0, 0}));
  CHECK(fenced.outcomes.size() == 3);
}

TEST_CASE("two readers may see independent stores in different orders, but not under seq_cst") {
  const body weak_x = [](cells& c) {
    c.r[0] = c.x.load(acquire);
    c.r[1] = c.y.load(acquire);
  };
  const body weak_y = [](cells& c) {
    c.r[2] = c.y.load(acquire);
    c.r[3] = c.x.load(acquire);
  };
  CHECK(reached(
      outcomes({[](cells& c) { c.x.store(1, release); }, [](cells& c) { c.y.store(1, release); }, weak_x, weak_y}),
      {1, 0, 1, 0}));
  const body strong_x = [](cells& c) {
    c.r[0] = c.x.load(seq_cst);
    c.r[1] = c.y.load(seq_cst);
  };
  const body strong_y = [](cells& c) {
    c.r[2] = c.y.load(seq_cst);
    c.r[3] = c.x.load(seq_cst);
  };
  const auto strong =
      outcomes({[](cells& c) { c.x.store(1, seq_cst); }, [](cells& c) { c.y.store(1, seq_cst); }, strong_x, strong_y});
  CHECK_FALSE(reached(strong, {1, 0, 1, 0}));
  CHECK(strong.outcomes.size() == 15);
}

TEST_CASE("additions never lose one another, loads and stores in their place do") {
  const body adds = [](cells& c) { c.n.fetch_add(1, relaxed); };
  const body counts = [](cells& c) { c.r[0] = static_cast<int>(c.n.load()); };
  findings sound = explore_all(of_bodies<cells>({adds, adds, adds}, [](cells& c) { expect(c.n.load() == 3, "lost"); }));
  CHECK(sound.fault.empty());
  CHECK(sound.schedules == 6);
  const body adds_badly = [](cells& c) { c.n.store(c.n.load(seq_cst) + 1, seq_cst); };
  findings unsound =
      explore_all(of_bodies<cells>({adds_badly, adds_badly}, [](cells& c) { expect(c.n.load() == 2, "lost"); }));
  CHECK(unsound.fault == "lost");
  CHECK(outcomes({adds, counts}).outcomes.size() == 2);
}

TEST_CASE("a compare-exchange takes place only on the latest store") {
  const body takes = [](cells& c) {
    int expected = 0;
    c.r[0] += c.x.compare_exchange_strong(expected, 1, acq_rel, relaxed) ? 1 : 0;
  };
  const auto all = outcomes({takes, takes, takes});
  CHECK(all.outcomes == std::set<outcome>{{1, 0, 0, 0}});
  CHECK(all.found.schedules == 3);
}

TEST_CASE("a failed compare-exchange may have read a store that is not the latest") {
  const auto all = outcomes({[](cells& c) {
                               c.x.store(1, relaxed);
                               c.x.store(2, relaxed);
                             },
                             [](cells& c) {
                               int expected = 0;
                               c.x.compare_exchange_strong(expected, 7, relaxed, relaxed);
                               c.r[0] = expected;
                             }});
  CHECK(all.outcomes == std::set<outcome>{{0, 0, 0, 0}, {1, 0, 0, 0}, {2, 0, 0, 0}});
}

constexpr auto takes_strongly = [](cells& c, std::memory_order order) {
  int expected = 0;
  return c.x.compare_exchange_strong(expected, 1, order);
};
constexpr auto takes_weakly = [](cells& c, std::memory_order order) {
  int expected = 0;
  return c.x.compare_exchange_weak(expected, 1, order);
};

TEST_CASE("a weak compare-exchange may fail on what it expects, a strong one may not") {
  CHECK(outcomes({[](cells& c) { c.r[0] = takes_strongly(c, relaxed) ? 1 : 2; }}).outcomes ==
        std::set<outcome>{{1, 0, 0, 0}});
  CHECK(outcomes({[](cells& c) { c.r[0] = takes_weakly(c, relaxed) ? 1 : 2; }}).outcomes ==
        std::set<outcome>{{1, 0, 0, 0}, {2, 0, 0, 0}});
}

TEST_CASE("a loop around a weak compare-exchange comes to its end, and one try in its place is found") {
  const body adds = [](cells& c) {
    unsigned held = c.n.load(relaxed);
    while (!c.n.compare_exchange_weak(held, held + 1u, relaxed)) {
    }
  };
  const body tries = [](cells& c) {
    unsigned held = c.n.load(relaxed);
    c.n.compare_exchange_weak(held, held + 1u, relaxed);
  };
  const auto finish = [](cells& c) { expect(c.n.load() == 1 || c.n.load() == 2, "lost"); };
  const findings sound = explore_all(of_bodies<cells>({adds, adds}, [](cells& c) { expect(c.n.load() == 2, "lost"); }));
  CHECK_MESSAGE(sound.fault.empty(), sound);
  CHECK(sound.all);
  CHECK(explore_all(of_bodies<cells>({adds}, finish)).fault.empty());
  const findings unsound = explore_all(of_bodies<cells>({tries}, finish));
  CHECK(unsound.fault == "lost");
  CHECK(unsound.schedule == "aa!");
  CHECK(unsound.trace.find("2  a: weak compare-exchange n, relaxed: fails without reason, finds 0\n") !=
        std::string::npos);
}

TEST_CASE("a compare-exchange with one order acquires also where it fails, and releases only where it succeeds") {
  const body publishes = [](cells& c) {
    c.plain.write(1);
    c.x.store(1, release);
  };
  static constexpr auto reads = [](cells& c, std::memory_order order, auto takes) {
    if (!takes(c, order) && c.x.load(relaxed) == 1) {
      c.r[0] = c.plain.read();
    }
  };
  CHECK(outcomes({publishes, [](cells& c) { reads(c, acq_rel, takes_strongly); }}).found.fault.empty());
  CHECK(outcomes({publishes, [](cells& c) { reads(c, acquire, takes_strongly); }}).found.fault.empty());
  CHECK(has_race(outcomes({publishes, [](cells& c) { reads(c, release, takes_strongly); }})));
  CHECK(has_race(outcomes({publishes, [](cells& c) { reads(c, relaxed, takes_strongly); }})));
  const body takes_and_reads = [](cells& c) {
    if (c.x.load(acquire) == 1) {
      c.r[0] = c.plain.read();
    }
  };
  const body writes_and_takes = [](cells& c) {
    c.plain.write(1);
    (void)takes_strongly(c, release);
  };
  const body writes_and_takes_relaxed = [](cells& c) {
    c.plain.write(1);
    (void)takes_strongly(c, acquire);
  };
  CHECK(outcomes({writes_and_takes, takes_and_reads}).found.fault.empty());
  CHECK(has_race(outcomes({writes_and_takes_relaxed, takes_and_reads})));
}

TEST_CASE("threads that all wait are a deadlock") {
  const auto all = outcomes({[](cells& c) {
                               c.x.await(1, acquire);
                               c.y.store(1, release);
                             },
                             [](cells& c) {
                               c.y.await(1, acquire);
                               c.x.store(1, release);
                             }});
  CHECK(all.found.fault == "deadlock: every thread waits");
}

TEST_CASE("a thread that spins on one that is suspended makes no progress") {
  const auto all = outcomes({[](cells& c) { c.x.store(1, release); },
                             [](cells& c) {
                               while (c.x.load(acquire) == 0) {
                               }
                             }});
  CHECK(all.found.fault.rfind("no progress: 400 steps and no operation has completed; ", 0) == 0);
  CHECK(all.found.fault.find("await()") != std::string::npos);
}

TEST_CASE("a join orders all that the joined threads did") {
  const auto all = outcomes({[](cells& c) { c.plain.write(1); }, [](cells& c) { c.x.store(1, relaxed); },
                             [](cells& c) {
                               join_others();
                               c.r[0] = c.plain.read();
                               c.r[1] = c.x.load(relaxed);
                             }});
  CHECK(all.found.fault.empty());
  CHECK(all.outcomes == std::set<outcome>{{1, 1, 0, 0}});
}

}  // namespace
