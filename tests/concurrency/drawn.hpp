// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/explore/explore.hpp>

#include "concurrency/inserts.hpp"
#include "concurrency/structures.hpp"
#include "property.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace pelage::explore {

/// A workload and a schedule, both drawn, both shrunk.
struct drawn_case {
  inserts work;
  std::vector<std::uint8_t> choices;  ///< see `drawn`
};

/// Up to eight fragments over three threads, of so few depths that ties abound; half of the choices go on with the
/// thread that runs. Shrinks by fewer fragments, fewer threads, and a schedule that is shorter and calmer.
inline rc::Gen<drawn_case> any_case() {
  using offer = std::tuple<std::uint8_t, std::uint8_t>;  // thread, depth
  const auto offers =
      rc::gen::resize(8, rc::gen::container<std::vector<offer>>(rc::gen::tuple(
                             rc::gen::element<std::uint8_t>(0, 1, 2), rc::gen::element<std::uint8_t>(0, 1, 2))));
  const auto choice = rc::gen::oneOf(rc::gen::just<std::uint8_t>(0),
                                     rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint8_t>()));
  const auto choices = rc::gen::container<std::vector<std::uint8_t>>(choice);
  return rc::gen::map(rc::gen::tuple(offers, choices, rc::gen::arbitrary<bool>()),
                      [](const std::tuple<std::vector<offer>, std::vector<std::uint8_t>, bool>& drawn) {
                        const auto& [offered, numbers, falling] = drawn;
                        inserts work(3);
                        std::uint32_t id = 0;
                        for (const auto& [thread, depth] : offered) {
                          work[thread].push_back(fragment{static_cast<float>(depth), falling ? 9u - id : id});
                          ++id;
                        }
                        std::erase_if(work, [](const std::vector<fragment>& of_one) { return of_one.empty(); });
                        return drawn_case{work, numbers};
                      });
}

/// What to give to pelage-replay to see the case.
inline std::string replay_string(const structure& tested, const drawn_case& made, const findings& f) {
  return std::string(tested.name) + ' ' + to_text(made.work) + ' ' + f.schedule;
}

inline findings run_drawn(const structure& tested, const drawn_case& made) {
  drawn choices(made.choices);
  return run_once(tested.test(made.work), choices);
}

/// A case that fails, and how.
struct counterexample {
  drawn_case made;
  findings found;
};

/// Draws cases of a structure until one fails, then shrinks it; none if all hold. A case takes microseconds, so there
/// are fifty times as many as RC_PARAMS asks for.
inline std::optional<counterexample> sample(const structure& tested) {
  std::optional<counterexample> smallest;
  rc::detail::TestParams parameters = rc::detail::configuration().testParams;
  parameters.maxSuccess *= 50;
  rc::detail::checkTestable(
      [&] {
        const drawn_case made = *any_case();
        RC_PRE(!made.work.empty());
        const findings f = run_drawn(tested, made);
        if (!f.fault.empty()) {
          smallest = counterexample{made, f};  // while it shrinks, each case that fails replaces the last one
        }
        RC_ASSERT(f.fault.empty());
      },
      rc::detail::TestMetadata(), parameters);
  return smallest;
}

}  // namespace pelage::explore
