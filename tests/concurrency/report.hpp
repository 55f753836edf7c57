// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/explore/explore.hpp>

#include <doctest/doctest.h>

#include <chrono>
#include <iostream>
#include <string>
#include <string_view>

namespace pelage::explore {

/// Runs a search and prints what it saw in one line under a name.
template <class Search>
findings report(std::string_view name, Search run) {
  const auto start = std::chrono::steady_clock::now();
  const findings f = run();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  std::cout << name << ": " << summary(f) << ", " << took.count() << " s" << std::endl;
  return f;
}

/// The whole space of a correct program holds no fault.
inline findings expect_sound(std::string_view name, const program_factory& make) {
  const findings f = report(name, [&] { return explore_all(make); });
  CHECK_MESSAGE(f.fault.empty(), name, ": ", f);
  CHECK_MESSAGE(f.all, name, ": not everything was explored");
  return f;
}

/// A planted fault is found, and is the one that was planted: `as` is how its report begins.
inline void expect_found(std::string_view name, std::string_view as, const program_factory& make,
                         int patience = default_patience) {
  const findings f = report("planted: " + std::string(name), [&] { return explore_all(make, 0, patience); });
  CHECK_MESSAGE((!as.empty() && f.fault.rfind(as, 0) == 0), name, ": expected \"", as, "\", found \"", f.fault, "\"");
}

}  // namespace pelage::explore
