// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "frame/vulkan/api.hpp"
#include "frame/vulkan/kernels.hpp"

namespace pelage::frame::vulkan {

/// Memory of the device, bound to one buffer.
struct buffer {
  VkBuffer handle = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkDeviceSize bytes = 0;
};

/// One step of a frame: a kernel over some number of invocations, or without one the filling of a buffer.
struct step {
  std::string view;
  std::string pass;           ///< both: under what its time is reported
  std::string kernel;         ///< empty: fill
  std::uint32_t binding;      ///< of the buffer to fill
  std::uint32_t value;        ///< to fill it with
  std::uint64_t invocations;  ///< or subgroups, of a kernel that works in these
  bool by_subgroup;
  std::uint32_t views;              ///< layers of workgroups
  std::vector<std::uint32_t> push;  ///< the push constants
  bool beside = false;              ///< it need not wait for the step before, and shares its time
};

/// A Vulkan device without a screen, and the buffers that all kernels see: buffer i is bound to binding i, and
/// binding 0 is uniform. Every call throws std::runtime_error with one line that says what failed.
///
/// PELAGE_DEVICE picks the device by a part of its name; without it the first GPU, else the first device.
class device {
 public:
  device();
  ~device();
  device(const device&) = delete;
  device& operator=(const device&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] bool has_64_bit_atomics() const { return has_64_bit_atomics_; }
  [[nodiscard]] std::uint64_t bytes() const;  ///< of all buffers

  /// Gives a binding a buffer of that size, at least 64 bytes; its content is undefined.
  void resize(std::uint32_t binding, std::uint64_t bytes);
  void upload(std::uint32_t binding, std::span<const std::byte> from);
  void download(std::uint32_t binding, std::span<std::byte> to);

  /// Runs the steps, most_steps at most, one after another. Milliseconds of each, by the device's clock.
  [[nodiscard]] std::vector<double> run(std::span<const step> steps);
  static constexpr std::uint32_t most_steps = 4095;

 private:
  void pick();
  void check_subgroups(const VkPhysicalDeviceSubgroupProperties& has) const;
  void open();
  void make_layout();
  void close();
  buffer make_buffer(std::uint64_t bytes, VkBufferUsageFlags usage, VkMemoryPropertyFlags kind);
  void free(buffer& b);
  VkPipeline pipeline(const std::string& kernel);
  void begin();
  void submit(const std::string& what);
  void record(const step& s);

  api vk_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkPhysicalDeviceProperties properties_{};
  std::string name_;
  bool has_64_bit_atomics_ = false;
  std::uint32_t family_ = 0;
  std::uint32_t workgroup_ = 256;
  std::uint32_t subgroup_ = 32;
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
  std::map<std::string, VkPipeline> pipelines_;
};

}  // namespace pelage::frame::vulkan
