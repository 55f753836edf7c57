// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include "concurrency/inserts.hpp"
#include "concurrency/list_faults.hpp"
#include "concurrency/list_program.hpp"
#include "concurrency/slot_program.hpp"

#include <array>
#include <string_view>

namespace pelage::explore {

/// A structure by its name in a schedule to replay.
struct structure {
  std::string_view name;
  program_factory (*test)(const inserts& work);
};

/// A list with a reader that walks it meanwhile.
template <class Algorithm, class Storage = watched_lists>
program_factory list_and_reader(const inserts& work) {
  list_work list;
  list.inserts = work;
  list.readers = Algorithm::sorted ? 1u : 0u;
  list.joined_reader = !Algorithm::sorted;
  return list_test<Algorithm, Storage>(list);
}

/// Lists of blocks of two.
inline program_factory blocks_and_reader(const inserts& work) {
  list_work list;
  list.inserts = work;
  list.joined_reader = true;
  list.block = 2;
  return list_test<block_inserts>(list);
}

template <class Buffer>
program_factory slots_of(const inserts& work) {
  return slot_test<Buffer>()(work);
}

/// What can be drawn at random and replayed by name; the last three with a fault planted, to see one.
inline constexpr std::array structures = {
    structure{"a_buffer", &list_and_reader<unordered_inserts>},
    structure{"unrolled_list", &blocks_and_reader},
    structure{"ordered_list", &list_and_reader<ordered_inserts>},
    structure{"atomic_k_buffer", &slots_of<one_pass<2>>},
    structure{"cascade_k_buffer", &slots_of<cascade<2>>},
    structure{"split_k_buffer", &slots_of<split_slots<2>>},
    structure{"ordered_list-no_retry", &list_and_reader<ordered_inserts, list_variants::no_retry>},
    structure{"ordered_list-keeps_old_successor",
              &list_and_reader<ordered_inserts, list_variants::keeps_old_successor>},
    structure{"ordered_list-publishes_relaxed", &list_and_reader<ordered_inserts, list_variants::publishes_relaxed>},
};

inline const structure* find_structure(std::string_view name) {
  for (const structure& s : structures) {
    if (s.name == name) {
      return &s;
    }
  }
  return nullptr;
}

}  // namespace pelage::explore
