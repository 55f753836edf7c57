// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#define VK_NO_PROTOTYPES
#include <vulkan/vulkan.h>

#include <stdexcept>
#include <string>

namespace pelage::vulkan {

// Every Vulkan function that is called, named once.
#define PELAGE_VULKAN_INSTANCE_FUNCTIONS(X)   \
  X(vkDestroyInstance)                        \
  X(vkEnumeratePhysicalDevices)               \
  X(vkGetPhysicalDeviceProperties)            \
  X(vkGetPhysicalDeviceProperties2)           \
  X(vkGetPhysicalDeviceMemoryProperties)      \
  X(vkGetPhysicalDeviceQueueFamilyProperties) \
  X(vkGetPhysicalDeviceFeatures2)             \
  X(vkCreateDevice)                           \
  X(vkGetDeviceProcAddr)
#define PELAGE_VULKAN_DEVICE_FUNCTIONS(X) \
  X(vkDestroyDevice)                      \
  X(vkGetDeviceQueue)                     \
  X(vkCreateBuffer)                       \
  X(vkDestroyBuffer)                      \
  X(vkGetBufferMemoryRequirements)        \
  X(vkAllocateMemory)                     \
  X(vkFreeMemory)                         \
  X(vkBindBufferMemory)                   \
  X(vkMapMemory)                          \
  X(vkUnmapMemory)                        \
  X(vkCreateShaderModule)                 \
  X(vkDestroyShaderModule)                \
  X(vkCreateDescriptorSetLayout)          \
  X(vkDestroyDescriptorSetLayout)         \
  X(vkCreatePipelineLayout)               \
  X(vkDestroyPipelineLayout)              \
  X(vkCreateComputePipelines)             \
  X(vkDestroyPipeline)                    \
  X(vkCreateDescriptorPool)               \
  X(vkDestroyDescriptorPool)              \
  X(vkAllocateDescriptorSets)             \
  X(vkUpdateDescriptorSets)               \
  X(vkCreateCommandPool)                  \
  X(vkDestroyCommandPool)                 \
  X(vkResetCommandPool)                   \
  X(vkAllocateCommandBuffers)             \
  X(vkBeginCommandBuffer)                 \
  X(vkEndCommandBuffer)                   \
  X(vkCmdBindPipeline)                    \
  X(vkCmdBindDescriptorSets)              \
  X(vkCmdPushConstants)                   \
  X(vkCmdDispatch)                        \
  X(vkCmdPipelineBarrier)                 \
  X(vkCmdFillBuffer)                      \
  X(vkCmdCopyBuffer)                      \
  X(vkCmdResetQueryPool)                  \
  X(vkCmdWriteTimestamp)                  \
  X(vkCreateQueryPool)                    \
  X(vkDestroyQueryPool)                   \
  X(vkGetQueryPoolResults)                \
  X(vkQueueSubmit)                        \
  X(vkQueueWaitIdle)

/// Vulkan without linking to it: the loader is opened at run time, so that the program starts on any machine.
struct api {
  std::string caller;  ///< how every message begins
  PFN_vkGetInstanceProcAddr vkGetInstanceProcAddr = nullptr;
#define X(name) PFN_##name name = nullptr;
  PELAGE_VULKAN_INSTANCE_FUNCTIONS(X)
  PELAGE_VULKAN_DEVICE_FUNCTIONS(X)
#undef X

  /// Opens the loader, for find() without an instance. Throws no_device.
  void open();
  /// Loads what an instance's or a device's calls need. Throws std::runtime_error for what the driver lacks.
  void load(VkInstance instance);
  void load(VkDevice device);

  /// One function that the list above does not name. Throws std::runtime_error if there is none.
  template <class Function>
  void find(VkInstance instance, Function& f, const char* name) const {
    set(f, vkGetInstanceProcAddr(instance, name), name);
  }

  /// Throws std::runtime_error, one line, unless the call went well.
  void check(VkResult result, const std::string& what) const;

  /// What to throw.
  [[nodiscard]] std::runtime_error error(const std::string& what) const {
    return std::runtime_error(caller + ": " + what);
  }

 private:
  template <class Function>
  void set(Function& f, PFN_vkVoidFunction found, const char* name) const {
    f = reinterpret_cast<Function>(found);
    if (f == nullptr) throw error(std::string("the driver lacks ") + name);
  }
};

}  // namespace pelage::vulkan
