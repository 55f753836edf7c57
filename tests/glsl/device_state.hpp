// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#define VK_NO_PROTOTYPES
#include <vulkan/vulkan.h>

#include <cstdint>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "glsl/device.hpp"

// Every Vulkan function that the harness calls, each named once.
// clang-format off
#define PELAGE_INSTANCE_FUNCTIONS(X) \
  X(vkDestroyInstance) X(vkEnumeratePhysicalDevices) X(vkGetPhysicalDeviceProperties) \
  X(vkGetPhysicalDeviceMemoryProperties) X(vkGetPhysicalDeviceQueueFamilyProperties) X(vkCreateDevice) \
  X(vkGetPhysicalDeviceFeatures2) X(vkGetDeviceProcAddr)
#define PELAGE_DEVICE_FUNCTIONS(X) \
  X(vkDestroyDevice) X(vkGetDeviceQueue) X(vkCreateBuffer) X(vkDestroyBuffer) X(vkGetBufferMemoryRequirements) \
  X(vkAllocateMemory) X(vkFreeMemory) X(vkBindBufferMemory) X(vkMapMemory) X(vkUnmapMemory) X(vkCreateShaderModule) \
  X(vkDestroyShaderModule) X(vkCreateDescriptorSetLayout) X(vkDestroyDescriptorSetLayout) X(vkCreatePipelineLayout) \
  X(vkDestroyPipelineLayout) X(vkCreateComputePipelines) X(vkDestroyPipeline) X(vkCreateDescriptorPool) \
  X(vkDestroyDescriptorPool) X(vkAllocateDescriptorSets) X(vkUpdateDescriptorSets) X(vkCreateCommandPool) \
  X(vkDestroyCommandPool) X(vkAllocateCommandBuffers) X(vkBeginCommandBuffer) X(vkEndCommandBuffer) \
  X(vkCmdBindPipeline) X(vkCmdBindDescriptorSets) X(vkCmdDispatch) X(vkCmdPipelineBarrier) X(vkCmdCopyBuffer) \
  X(vkQueueSubmit) X(vkQueueWaitIdle) X(vkResetDescriptorPool) X(vkResetCommandPool)
// clang-format on

namespace pelage::test {

/// An environment variable, empty if it is not set.
[[nodiscard]] std::string environment(const char* name);

/// Which device was asked for: how every message begins.
[[nodiscard]] std::string selection();

/// Throws where a call did not succeed.
void check(VkResult result, const std::string& where);

/// What a device holds open.
struct device::state {
  void* loader = nullptr;
  PFN_vkGetInstanceProcAddr vkGetInstanceProcAddr = nullptr;
#define X(name) PFN_##name name = nullptr;
  PELAGE_INSTANCE_FUNCTIONS(X)
  PELAGE_DEVICE_FUNCTIONS(X)
#undef X
  VkInstance instance = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
  VkPhysicalDevice physical = VK_NULL_HANDLE;
  VkPhysicalDeviceProperties properties{};
  VkPhysicalDeviceMemoryProperties memory{};
  std::string name;
  VkDevice handle = VK_NULL_HANDLE;
  VkQueue queue = VK_NULL_HANDLE;
  std::uint32_t family = 0;
  VkCommandPool commands = VK_NULL_HANDLE;
  VkDescriptorPool descriptors = VK_NULL_HANDLE;
  std::uint32_t workgroup = 0;
  std::uint32_t complaints = 0;
  bool validated = false;
  bool atomic_int64 = false;

  struct pipeline {
    VkDescriptorSetLayout set = VK_NULL_HANDLE;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    VkPipeline handle = VK_NULL_HANDLE;
  };
  std::map<std::pair<const void*, std::uint32_t>, pipeline> pipelines;

  struct buffer {
    VkBuffer handle = VK_NULL_HANDLE;
    VkDeviceMemory memory = VK_NULL_HANDLE;
  };

  template <typename Function>
  void load(Function& f, const char* what) {
    f = reinterpret_cast<Function>(vkGetInstanceProcAddr(instance, what));
    if (f == nullptr) throw std::runtime_error(selection() + ": the Vulkan loader lacks " + what);
  }

  // device.cpp
  void open_instance();
  void pick_device();
  void open_device();
  ~state();

  // device_run.cpp
  buffer make_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage, VkMemoryPropertyFlags kind);
  void free_buffer(const buffer& b);
  const pipeline& pipeline_for(const kernel& k, std::uint32_t bindings, std::uint32_t group);
  void run(const kernel& k, std::uint32_t invocations, std::span<std::vector<std::uint32_t>* const> words,
           std::uint32_t group);
};

}  // namespace pelage::test
