// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// Shows a schedule step by step:
//
//     pelage-replay --replay 'ordered_list 2:7,1:8/2:3 aaab1b'
//
// The string is what a failing test prints: the structure, what each thread inserts as depth:id, and the schedule: a
// letter a step for the thread that takes it, and a number behind it where it reads an older store than the latest.
#include <pelage/explore/explore.hpp>

#include "concurrency/inserts.hpp"
#include "concurrency/structures.hpp"

#include <algorithm>
#include <iostream>
#include <string_view>

namespace {

int wrong(std::string_view what) {
  std::cerr << "pelage-replay: " << what << "\nusage: pelage-replay --replay 'STRUCTURE INSERTS SCHEDULE'\nstructures:";
  for (const auto& s : pelage::explore::structures) {
    std::cerr << ' ' << s.name;
  }
  std::cerr << '\n';
  return 2;
}

}  // namespace

int main(int count, char** arguments) {
  using namespace pelage::explore;
  if (count != 3 || std::string_view(arguments[1]) != "--replay") {
    return wrong("one schedule is needed");
  }
  std::string_view text = arguments[2];
  const structure* tested = find_structure(take_until(text, ' '));
  if (tested == nullptr) {
    return wrong("no such structure");
  }
  const auto work = inserts_of(take_until(text, ' '));
  if (!work) {
    return wrong("inserts are depth:id, fragments separated by commas, threads by slashes");
  }
  const bool is_schedule = std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c < 'a' + max_threads) || (c >= '0' && c <= '9') || c == '!';
  });
  if (!is_schedule || work->size() + 1 > max_threads) {
    return wrong("a schedule is letters of threads, each with a number and a ! behind it or none");
  }
  return replay(tested->test(*work), text, std::cout) ? 0 : 1;
}
