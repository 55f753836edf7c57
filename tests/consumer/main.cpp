// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/tail.hpp>
#include <pelage/core/fragment.hpp>

int main() {
  const pelage::fragment near{1.0f, 7};
  const pelage::fragment far{2.0f, 3};
  return pelage::before(near, far) && !pelage::before(far, near) ? 0 : 1;
}
