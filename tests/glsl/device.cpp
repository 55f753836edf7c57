// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "glsl/device.hpp"

#include <cstdlib>

namespace pelage::test {
namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

vulkan::device_options wanted() {
  const std::string name = environment("PELAGE_DEVICE");
  return {
      .caller = "device PELAGE_DEVICE=" + (name.empty() ? "(any)" : name),
      .application = "pelage tests",
      .bindings = 8,
      .has_uniforms = false,
      .push_bytes = 0,
      .gpu_workgroup = 64,
      .timed = false,
      .validate = true,
  };
}

}  // namespace

device::device() : device_(wanted()), workgroup_(device_.workgroup()) {
  const std::string given = environment("PELAGE_WORKGROUP");
  if (!given.empty()) workgroup_ = static_cast<std::uint32_t>(std::stoul(given));
}

void device::run(const kernel& k, std::uint32_t invocations, std::span<std::vector<std::uint32_t>* const> buffers,
                 std::uint32_t workgroup) {
  for (std::uint32_t i = 0; i < buffers.size(); ++i) {
    device_.resize(i, buffers[i]->size() * sizeof(std::uint32_t));
    device_.upload(i, std::as_bytes(std::span(*buffers[i])));
  }
  vulkan::step one;
  one.program = &k;
  one.invocations = invocations;
  one.workgroup = workgroup == 0 ? workgroup_ : workgroup;
  device_.run({&one, 1});
  for (std::uint32_t i = 0; i < buffers.size(); ++i)
    device_.download(i, std::as_writable_bytes(std::span(*buffers[i])));
}

}  // namespace pelage::test
