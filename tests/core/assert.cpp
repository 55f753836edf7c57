// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
namespace {
int failures = 0;
}
#define PELAGE_ASSERT(condition) ((condition) ? void() : void(++failures))
#include <pelage/core/assert.hpp>

#include "property.hpp"

TEST_CASE("a PELAGE_ASSERT defined before the library takes its failures") {
  PELAGE_ASSERT(1 + 1 == 2);
  CHECK(failures == 0);
  PELAGE_ASSERT(1 + 1 == 3);
  CHECK(failures == 1);
}
