// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The end of what exact_begin.hpp begins.
#if defined(__clang__) && !defined(PELAGE_ALLOW_CONTRACTION)
#pragma float_control(pop)
#endif
