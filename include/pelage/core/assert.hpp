// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once

/// PELAGE_ASSERT(condition) checks a caller's contract: on in debug builds, gone under NDEBUG.
/// Define it before the first include of the library to send failures elsewhere.
#ifndef PELAGE_ASSERT
#include <cassert>
#define PELAGE_ASSERT(condition) assert(condition)
#endif
