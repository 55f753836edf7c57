// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/explore/reduction.hpp>
#include <pelage/explore/schedule.hpp>
#include <pelage/explore/watched.hpp>
#include <pelage/explore/world.hpp>

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>

namespace pelage::explore {

/// What an exploration saw.
struct findings {
  std::uint64_t schedules = 0;  ///< run to the end, no two of them equivalent if the search reduces
  std::uint64_t pruned = 0;     ///< given up: equivalent to one that ran
  int longest = 0;              ///< steps of the longest
  int longest_wait = 0;         ///< most steps of all threads between two completed operations
  bool all = false;             ///< nothing was left out
  std::string fault;            ///< empty: none found
  std::string schedule;         ///< that shows the fault, to replay
  std::string trace;            ///< of that schedule, as replay() prints it
};

/// The bound on steps without a completed operation where none is given.
inline constexpr int default_patience = 400;

/// Runs every schedule of a small program, up to equivalence, until one shows a fault. `most`: gives up after so
/// many, 0 for never.
///
/// Schedules grow exponentially with threads and steps: three threads of a handful of steps each are thousands, a
/// second runs some hundred thousand. Memory: as long as the longest schedule.
findings explore_all(const program_factory& make, std::uint64_t most = 0, int patience = default_patience);

/// One schedule of one program.
findings run_once(const program_factory& make, strategy& choices, int patience = default_patience);

/// Runs a schedule and prints each step with the accesses to fields behind it and the state after it, then the fault
/// if there is one, then how many steps of the schedule were not possible if any. True if there is no fault.
bool replay(const program_factory& make, std::string_view schedule, std::ostream& out, int patience = default_patience);

/// One line: the numbers, the fault, and its schedule.
std::string summary(const findings& f);

/// Prints the summary; of a fault each step, too, and how to see them again.
inline std::ostream& operator<<(std::ostream& out, const findings& f) {
  out << summary(f);
  return f.fault.empty() ? out : out << '\n' << f.trace << "again: replay(make, \"" << f.schedule << "\", std::cout)\n";
}

// ---------------------------------------------------------------------------------------------------------

/// Adds one run to what was seen; shows a fault.
inline void count(findings& f, ending end, const world& w, const program_factory& make, int patience) {
  f.schedules += end == ending::given_up ? 0u : 1u;
  f.pruned += end == ending::given_up ? 1u : 0u;
  f.longest = std::max(f.longest, static_cast<int>(w.events().size()));
  f.longest_wait = std::max(f.longest_wait, w.longest_wait());
  if (end == ending::faulty) {
    f.fault = w.fault();
    f.schedule = to_string(w);
    std::ostringstream steps;
    replay(make, f.schedule, steps, patience);
    f.trace = steps.str();
  }
}

/// Runs schedules of a search that has next() until there is none, one is faulty, or `most` have run.
template <class Search>
findings search(const program_factory& make, Search& choices, std::uint64_t most, int patience) {
  world w;
  findings f;
  do {
    count(f, w.run(make, choices, patience), w, make, patience);
    if (!f.fault.empty() || (most != 0 && f.schedules + f.pruned >= most)) {
      return f;
    }
  } while (choices.next());
  f.all = true;
  return f;
}

inline findings explore_all(const program_factory& make, std::uint64_t most, int patience) {
  reduction choices;
  return search(make, choices, most, patience);
}

inline findings run_once(const program_factory& make, strategy& choices, int patience) {
  world w;
  findings f;
  count(f, w.run(make, choices, patience), w, make, patience);
  f.schedule = to_string(w);
  return f;
}

inline bool replay(const program_factory& make, std::string_view schedule, std::ostream& out, int patience) {
  world w;
  w.trace = &out;
  scripted choices(schedule);
  const ending end = w.run(make, choices, patience);
  out << (end == ending::faulty ? "fault: " + w.fault() : "no fault") << '\n';
  if (const int steps = choices.passed_over(); steps > 0) {
    out << "not this program's schedule: " << steps << " of its steps are not possible\n";
  }
  return end != ending::faulty;
}

inline std::string summary(const findings& f) {
  std::string text = std::to_string(f.schedules) + " schedules, " + std::to_string(f.pruned) + " pruned, longest " +
                     std::to_string(f.longest) + " steps";
  return f.fault.empty() ? text : text + "; " + f.fault + " [" + f.schedule + ']';
}

}  // namespace pelage::explore
