// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "vulkan/device.hpp"
#include "vulkan/kernel.hpp"

namespace pelage::test {

using vulkan::kernel;

/// A Vulkan device for one kernel at a time. A machine without one still starts the tests and reads what is missing.
///
/// PELAGE_WORKGROUP sets the invocations in a workgroup; without it 64, on a CPU a subgroup.
class device {
 public:
  device();  ///< throws std::runtime_error with one line that says what failed

  [[nodiscard]] const std::string& name() const { return device_.name(); }
  [[nodiscard]] bool is_cpu() const { return device_.physical().is_cpu(); }
  [[nodiscard]] bool has_atomic_int64() const { return device_.has_64_bit_atomics(); }
  [[nodiscard]] std::uint32_t workgroup() const { return workgroup_; }
  [[nodiscard]] std::uint32_t subgroup() const { return device_.subgroup(); }
  [[nodiscard]] bool validated() const { return device_.driver().validated(); }
  [[nodiscard]] std::uint32_t complaints() const { return device_.driver().complaints(); }

  /// Runs at least `invocations` of a kernel, `workgroup` at a time, 0 for workgroup(). Buffer i is bound to binding i
  /// and comes back as the kernel left it; the last one is filled by the kernel alone.
  void run(const kernel& k, std::uint32_t invocations, std::span<std::vector<std::uint32_t>* const> buffers,
           std::uint32_t workgroup = 0);

 private:
  vulkan::device device_;
  std::uint32_t workgroup_;
};

/// The device of this process, or null after one line on stderr if there is none.
[[nodiscard]] device* the_device();

}  // namespace pelage::test
