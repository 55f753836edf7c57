// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once

namespace pelage::truth {

/// Measures small pictures, prints each number beside its bound, and says whether all keep theirs. Some twenty seconds
/// of processor time.
[[nodiscard]] bool check_gates();

}  // namespace pelage::truth
