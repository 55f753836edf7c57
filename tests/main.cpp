// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#define DOCTEST_CONFIG_IMPLEMENT
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN  // alone it is read too late, the header being precompiled
#include <doctest/doctest.h>
