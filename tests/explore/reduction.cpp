// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// The searches against the plainest one, which runs every schedule, on programs that rapidcheck draws.
#include <pelage/explore/reduction.hpp>

#include <pelage/explore/bounded.hpp>
#include <pelage/explore/explore.hpp>
#include <pelage/explore/watched.hpp>

#include "property.hpp"

#include <array>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

using namespace pelage::explore;

/// A step of a drawn program: an operation on one of two cells, or a fence.
struct step {
  operation_kind kind;
  int cell;
  std::memory_order order;
  unsigned operand;
  bool weak;
};
using steps = std::vector<std::vector<step>>;

std::ostream& operator<<(std::ostream& out, const step& s) {
  return out << name_of(s.kind) << ' ' << s.cell << ' ' << name_of(s.order) << ' ' << s.operand
             << (s.weak ? " weak" : "");
}

/// Runs such steps, and writes down which class of equivalent schedules this was: what each thread read, and the
/// order of each cell's stores.
class drawn_program : public program {
 public:
  drawn_program(const steps& all, std::multiset<std::string>& classes) : all_(all), classes_(classes) {}

  [[nodiscard]] int threads() const override { return static_cast<int>(all_.size()); }

  void thread(int t) override {
    for (const step& s : all_[static_cast<std::size_t>(t)]) {
      watched_atomic<unsigned>& cell = cells_[static_cast<std::size_t>(s.cell)];
      switch (s.kind) {
        case operation_kind::load:
          (void)cell.load(s.order);
          break;
        case operation_kind::store:
          cell.store(s.operand, s.order);
          break;
        case operation_kind::add:
          cell.fetch_add(s.operand, s.order);
          break;
        case operation_kind::fence:
          fence(s.order);
          break;
        default: {
          unsigned expected = s.operand;
          (void)(s.weak ? cell.compare_exchange_weak(expected, s.operand + 1u, s.order, std::memory_order_relaxed)
                        : cell.compare_exchange_strong(expected, s.operand + 1u, s.order, std::memory_order_relaxed));
        }
      }
    }
  }

  void finish() override {
    std::ostringstream name;
    const world& w = world::current();
    for (int t = 0; t < threads(); ++t) {
      for (const event& e : w.events()) {
        if (e.way.thread == t) {
          name << e.way.store << (e.way.writes ? "w" : "r");
        }
      }
      name << '|';
    }
    // Of the total order of seq_cst operations too, which the model treats as one more cell.
    for (const auto& cell : {-1, 0, 1}) {
      for (const event& e : w.events()) {
        if (cell < 0 ? e.way.total : e.way.writes && e.way.location == cell) {
          name << letter(e.way.thread);
        }
      }
      name << '|';
    }
    classes_.insert(name.str());
  }

 private:
  const steps& all_;
  std::multiset<std::string>& classes_;
  std::array<watched_atomic<unsigned>, 2> cells_{watched_atomic<unsigned>{"x"}, watched_atomic<unsigned>{"y"}};
};

rc::Gen<step> any_step() {
  const auto kind = rc::gen::element(operation_kind::load, operation_kind::store, operation_kind::add,
                                     operation_kind::compare_exchange, operation_kind::fence);
  return rc::gen::map(
      rc::gen::tuple(kind, rc::gen::inRange(0, 2), rc::gen::inRange(0, 5), rc::gen::inRange(0u, 3u),
                     rc::gen::arbitrary<bool>()),
      [](const std::tuple<operation_kind, int, int, unsigned, bool>& drawn) {
        const auto [kind, cell, order, operand, weak] = drawn;
        constexpr std::array orders = {std::memory_order_relaxed, std::memory_order_relaxed, std::memory_order_acquire,
                                       std::memory_order_release, std::memory_order_seq_cst};
        std::memory_order o = orders[static_cast<std::size_t>(order)];
        o = kind == operation_kind::load && o == std::memory_order_release ? std::memory_order_acquire : o;
        o = kind == operation_kind::store && o == std::memory_order_acquire ? std::memory_order_release : o;
        return step{kind, cell, o, operand, weak && kind == operation_kind::compare_exchange};
      });
}

rc::Gen<steps> any_program() {
  return rc::gen::mapcat(rc::gen::inRange<std::size_t>(2, 4), [](std::size_t threads) {
    const std::size_t longest = threads == 2 ? 6 : 4;
    return rc::gen::container<steps>(threads,
                                     rc::gen::mapcat(rc::gen::inRange<std::size_t>(2, longest), [](std::size_t length) {
                                       return rc::gen::container<std::vector<step>>(length, any_step());
                                     }));
  });
}

template <class Search>
std::multiset<std::string> classes(const steps& all, Search search_all) {
  std::multiset<std::string> found;
  search_all([&] { return std::make_unique<drawn_program>(all, found); });
  return found;
}

std::set<std::string> distinct(const std::multiset<std::string>& all) {
  return {all.begin(), all.end()};
}

TEST_CASE("the reduced search meets every class of equivalent schedules, and each once") {
  pelage::test::holds("reduced search meets each class once", [] {
    const steps all = *rc::gen::resize(rc::kNominalSize, any_program());
    const auto reduced = classes(all, [](const program_factory& make) { explore_all(make); });
    const auto plain = classes(all, [](const program_factory& make) {
      reduction everything(false);
      search(make, everything, 0, default_patience);
    });
    RC_ASSERT(distinct(reduced) == distinct(plain));
    RC_ASSERT(reduced.size() == distinct(reduced).size());
  });
}

TEST_CASE("the bounded search meets nothing else, more with each surprise, and everything in the end") {
  pelage::test::holds("bounded search grows to all classes", [] {
    const steps all = *rc::gen::resize(rc::kNominalSize, any_program());
    const auto reduced = distinct(classes(all, [](const program_factory& make) { explore_all(make); }));
    std::set<std::string> last;
    for (int surprises = 0; surprises <= 2; ++surprises) {
      const auto some = distinct(classes(all, [=](const program_factory& make) { explore_bounded(make, surprises); }));
      RC_ASSERT(std::includes(reduced.begin(), reduced.end(), some.begin(), some.end()));
      RC_ASSERT(std::includes(some.begin(), some.end(), last.begin(), last.end()));
      last = some;
    }
    RC_ASSERT(distinct(classes(all, [](const program_factory& make) { explore_bounded(make, 100); })) == reduced);
  });
}

}  // namespace
