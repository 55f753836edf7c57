// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/explore/reduction.hpp>
#include <pelage/explore/world.hpp>

#include <algorithm>
#include <cstdint>
#include <ostream>
#include <string>

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
};

/// The bound on steps without a completed operation where none is given.
inline constexpr int default_patience = 400;

/// Runs every schedule of a small program, up to equivalence, until one shows a fault. `most`: gives up after so
/// many, 0 for never.
findings explore_all(const program_factory& make, std::uint64_t most = 0, int patience = default_patience);

/// A schedule as a string: the letter of the thread for each step, followed by a number where it read an older
/// store than the latest: how many stores older.
std::string to_string(const world& w);

inline std::ostream& operator<<(std::ostream& out, const findings& f) {
  out << f.schedules << " schedules, " << f.pruned << " pruned, longest " << f.longest << " steps";
  if (!f.fault.empty()) {
    out << "; " << f.fault << " [" << f.schedule << "]";
  }
  return out;
}

// ---------------------------------------------------------------------------------------------------------

/// Adds one run to what was seen.
inline void count(findings& f, ending end, const world& w) {
  f.schedules += end == ending::given_up ? 0u : 1u;
  f.pruned += end == ending::given_up ? 1u : 0u;
  f.longest = std::max(f.longest, static_cast<int>(w.events().size()));
  f.longest_wait = std::max(f.longest_wait, w.longest_wait());
  if (end == ending::faulty) {
    f.fault = w.fault();
    f.schedule = to_string(w);
  }
}

/// Runs schedules of a search that has next() until there is none, one is faulty, or `most` have run.
template <class Search>
findings search(const program_factory& make, Search& choices, std::uint64_t most, int patience) {
  world w;
  findings f;
  do {
    count(f, w.run(make, choices, patience), w);
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

inline std::string to_string(const world& w) {
  std::string text;
  for (const event& e : w.events()) {
    text += letter(e.way.thread);
    text += e.way.age > 0 ? std::to_string(e.way.age) : "";
  }
  return text;
}

}  // namespace pelage::explore
