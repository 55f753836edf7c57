// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace pelage::test {

/// A compute shader, compiled when the tests were built.
struct kernel {
  const char* path;  ///< of its source, for messages
  std::span<const std::uint32_t> spirv;
};

/// A Vulkan device without a screen. The loader is opened at run time, so a machine without one still starts the
/// tests and reads what is missing.
///
/// PELAGE_DEVICE picks the device by a part of its name (`nvidia`, `llvmpipe`); without it the first GPU, else the
/// first device. PELAGE_WORKGROUP sets the invocations in a workgroup; without it 64, on a CPU 8.
class device {
 public:
  device();  ///< throws std::runtime_error with one line that says what failed
  ~device();
  device(const device&) = delete;
  device& operator=(const device&) = delete;

  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] bool is_cpu() const;
  [[nodiscard]] bool has_atomic_int64() const;  ///< on 64-bit words of buffers
  [[nodiscard]] std::uint32_t workgroup() const;
  [[nodiscard]] bool validated() const;            ///< the validation layer is on
  [[nodiscard]] std::uint32_t complaints() const;  ///< messages of the validation layer so far

  /// Runs at least `invocations` of a kernel, `workgroup` at a time, 0 for workgroup(). Buffer i is bound to binding i
  /// and comes back as the kernel left it; the last one is filled by the kernel alone.
  void run(const kernel& k, std::uint32_t invocations, std::span<std::vector<std::uint32_t>* const> buffers,
           std::uint32_t workgroup = 0);

 private:
  struct state;
  std::unique_ptr<state> state_;
};

/// The device of this process, or null after one line on stderr if there is none.
[[nodiscard]] device* the_device();

}  // namespace pelage::test
