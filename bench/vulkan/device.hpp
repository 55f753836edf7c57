// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "vulkan/api.hpp"
#include "vulkan/instance.hpp"
#include "vulkan/kernel.hpp"

namespace pelage::vulkan {

/// What a program wants of a device.
struct device_options {
  std::string caller;           ///< how every message begins
  const char* application;      ///< the program's name, for the driver
  std::uint32_t bindings;       ///< that a kernel sees at most
  bool has_uniforms;            ///< binding 0 is uniform
  std::uint32_t push_bytes;     ///< of push constants
  std::uint32_t gpu_workgroup;  ///< invocations in a workgroup; on a CPU it is a subgroup
  bool timed;                   ///< run() reads the device's clock
  bool validate;                ///< with the validation layer, if it is installed
  std::uint32_t variant = 0;    ///< of all kernels: their constant 2
};

/// Memory of the device, bound to one buffer.
struct buffer {
  VkBuffer handle = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkDeviceSize bytes = 0;
};

/// A kernel over some number of invocations, or without one the filling of a buffer.
struct step {
  const kernel* program = nullptr;  ///< null: fill
  std::uint32_t binding = 0;        ///< of the buffer to fill
  std::uint32_t value = 0;          ///< to fill it with
  std::uint64_t invocations = 0;
  std::uint32_t layers = 1;           ///< of workgroups
  std::uint32_t workgroup = 0;        ///< invocations in each; 0: the device's
  std::vector<std::uint32_t> push{};  ///< the push constants
  bool beside = false;                ///< it need not wait for the step before, and shares its time
};

/// A Vulkan device without a screen, and the buffers that all kernels see: buffer i is bound to binding i. In a kernel
/// constant 0 is the workgroup's size, constant 1 the subgroup's and constant 2 the variant. Every call throws
/// std::runtime_error with one line that says what failed.
class device {
 public:
  /// Opens instance::choose(). Throws no_device.
  explicit device(device_options options);
  ~device();
  device(const device&) = delete;
  device& operator=(const device&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const physical_device& physical() const { return physical_; }
  [[nodiscard]] bool has_64_bit_atomics() const { return has_64_bit_atomics_; }  ///< on words of buffers
  [[nodiscard]] std::uint32_t workgroup() const { return workgroup_; }
  [[nodiscard]] std::uint32_t subgroup() const { return physical_.subgroups.subgroupSize; }
  [[nodiscard]] const instance& driver() const { return instance_; }
  [[nodiscard]] std::uint64_t bytes() const;  ///< of all buffers

  /// Gives a binding a buffer in which kernels see that many bytes, rounded up to words, 1 at least; its content is
  /// undefined.
  void resize(std::uint32_t binding, std::uint64_t bytes);
  void upload(std::uint32_t binding, std::span<const std::byte> from);
  void download(std::uint32_t binding, std::span<std::byte> to);

  /// Runs the steps, most_steps at most, one after another. Milliseconds of each by the device's clock, if it is timed.
  std::vector<double> run(std::span<const step> steps);
  static constexpr std::uint32_t most_steps = 4095;

 private:
  void open();
  void open_queue();
  void make_layout();
  void close();
  [[nodiscard]] VkDescriptorType type_of(std::uint32_t binding) const {
    return options_.has_uniforms && binding == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER
                                                 : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  }
  buffer make_buffer(std::uint64_t bytes, VkBufferUsageFlags usage, VkMemoryPropertyFlags kind);
  void free(buffer& b);
  [[nodiscard]] std::uint32_t workgroup_of(const step& s) const { return s.workgroup == 0 ? workgroup_ : s.workgroup; }
  VkPipeline pipeline(const kernel& program, std::uint32_t workgroup);
  void begin();
  void submit(const std::string& what);
  void record(const step& s);
  [[nodiscard]] std::vector<double> read_clock(std::span<const step> steps, std::uint32_t ticks);

  device_options options_;
  instance instance_;
  api vk_;
  physical_device physical_;
  std::string name_;
  bool has_64_bit_atomics_ = false;
  std::uint32_t workgroup_;
  std::uint32_t family_ = 0;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkCommandPool commands_ = VK_NULL_HANDLE;
  VkCommandBuffer record_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkDescriptorPool sets_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
  VkQueryPool queries_ = VK_NULL_HANDLE;
  buffer staging_;
  void* mapped_ = nullptr;  ///< of staging_
  std::vector<buffer> buffers_;
  std::map<std::pair<const std::uint32_t*, std::uint32_t>, VkPipeline> pipelines_;  ///< by SPIR-V and workgroup
};

}  // namespace pelage::vulkan
