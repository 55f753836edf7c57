// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The comparison's own main: without a device there is nothing to compare, and one line says why.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "glsl/device.hpp"

namespace pelage::test {

device* the_device() {
  static const std::unique_ptr<device> one = [] {
    try {
      return std::make_unique<device>();
    } catch (const std::runtime_error& e) {
      std::fprintf(stderr, "tests/glsl/kernels not run: %s\n", e.what());
      return std::unique_ptr<device>();
    }
  }();
  return one.get();
}

}  // namespace pelage::test

int main(int argc, char** argv) {
  doctest::Context context(argc, argv);
  if (context.shouldExit()) return context.run();
  const pelage::test::device* device = pelage::test::the_device();
  // 77 tells CTest that the test was skipped; where a device is a must, PELAGE_DEVICE_REQUIRED makes it a failure.
  if (device == nullptr) return std::getenv("PELAGE_DEVICE_REQUIRED") == nullptr ? 77 : 1;
  std::printf("device %s, workgroups of %u, validation layer %s\n", device->name().c_str(), device->workgroup(),
              device->validated() ? "on" : "not installed");
  const int failures = context.run();
  if (device->complaints() != 0) {
    std::fprintf(stderr, "the validation layer spoke %u times\n", device->complaints());
    return 1;
  }
  return failures;
}
