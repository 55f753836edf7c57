// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/device.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <cstring>

#include "frame/vulkan/device_frame.hpp"

namespace pelage::frame::vulkan {
namespace {

constexpr std::uint32_t bindings = 24;  ///< of shaders/scene.glsl and what includes it
constexpr std::uint32_t push_bytes = 16;
constexpr VkDeviceSize staging_bytes = VkDeviceSize{16} << 20U;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

device::device() : buffers_(bindings) {
  try {
    instance_ = vk_.open();
    pick();
    open();
  } catch (...) {
    close();
    throw;
  }
}

device::~device() {
  close();
}

void device::close() {
  if (device_ != VK_NULL_HANDLE) {
    for (buffer& b : buffers_)
      free(b);
    free(staging_);
    for (const auto& [name, p] : pipelines_)
      vk_.vkDestroyPipeline(device_, p, nullptr);
    vk_.vkDestroyQueryPool(device_, queries_, nullptr);
    vk_.vkDestroyDescriptorPool(device_, sets_, nullptr);
    vk_.vkDestroyPipelineLayout(device_, layout_, nullptr);
    vk_.vkDestroyDescriptorSetLayout(device_, set_layout_, nullptr);
    vk_.vkDestroyCommandPool(device_, commands_, nullptr);
    vk_.vkDestroyDevice(device_, nullptr);
  }
  if (instance_ != VK_NULL_HANDLE && vk_.vkDestroyInstance != nullptr) vk_.vkDestroyInstance(instance_, nullptr);
}

void device::pick() {
  std::uint32_t count = 0;
  vk_.vkEnumeratePhysicalDevices(instance_, &count, nullptr);
  std::vector<VkPhysicalDevice> all(count);
  vk_.vkEnumeratePhysicalDevices(instance_, &count, all.data());
  const char* given = std::getenv("PELAGE_DEVICE");
  const std::string wanted = lower(given == nullptr ? "" : given);
  for (const bool gpu_only : {true, false}) {
    for (VkPhysicalDevice one : all) {
      vk_.vkGetPhysicalDeviceProperties(one, &properties_);
      const bool gpu = properties_.deviceType != VK_PHYSICAL_DEVICE_TYPE_CPU;
      const bool fits =
          wanted.empty() ? gpu || !gpu_only : lower(properties_.deviceName).find(wanted) != std::string::npos;
      if (!fits || properties_.apiVersion < VK_API_VERSION_1_2) continue;
      physical_ = one;
      name_ = properties_.deviceName;
      VkPhysicalDeviceSubgroupProperties subgroups{};
      subgroups.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
      VkPhysicalDeviceProperties2 all_properties{};
      all_properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
      all_properties.pNext = &subgroups;
      vk_.vkGetPhysicalDeviceProperties2(one, &all_properties);
      subgroup_ = subgroups.subgroupSize;
      // Mesa's lavapipe loses invocations at a barrier in a loop when a workgroup is larger than a subgroup.
      workgroup_ = gpu ? 256 : subgroup_;
      check_subgroups(subgroups);
      return;
    }
  }
  throw no_device(wanted.empty() ? "--device vulkan: there is no Vulkan 1.2 device"
                                 : fmt::format("--device vulkan: no device is called '{}'", wanted));
}

/// Throws for what the kernels cannot do without; a subgroup of any size up to 64 will do.
void device::check_subgroups(const VkPhysicalDeviceSubgroupProperties& has) const {
  constexpr VkSubgroupFeatureFlags needed = VK_SUBGROUP_FEATURE_BASIC_BIT | VK_SUBGROUP_FEATURE_VOTE_BIT |
                                            VK_SUBGROUP_FEATURE_ARITHMETIC_BIT | VK_SUBGROUP_FEATURE_BALLOT_BIT |
                                            VK_SUBGROUP_FEATURE_SHUFFLE_BIT;
  if ((has.supportedStages & VK_SHADER_STAGE_COMPUTE_BIT) == 0 || (has.supportedOperations & needed) != needed) {
    throw std::runtime_error("--device vulkan: " + name_ + " lacks subgroup vote, arithmetic, ballot or shuffle");
  }
  if (subgroup_ > 64) {  // the pixels of a block: shaders/opaque.comp
    throw std::runtime_error(
        fmt::format("--device vulkan: {} has subgroups of {} invocations, at most 64 will do", name_, subgroup_));
  }
  const std::uint32_t most =
      std::min(properties_.limits.maxComputeWorkGroupInvocations, properties_.limits.maxComputeWorkGroupSize[0]);
  if (most < workgroup_) {
    throw std::runtime_error(fmt::format("--device vulkan: {} has workgroups of at most {} invocations, {} are needed",
                                         name_, most, workgroup_));
  }
}

void device::open() {
  std::uint32_t count = 0;
  vk_.vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vk_.vkGetPhysicalDeviceQueueFamilyProperties(physical_, &count, families.data());
  const auto computes = [](const VkQueueFamilyProperties& f) {
    return (f.queueFlags & VK_QUEUE_COMPUTE_BIT) != 0 && f.timestampValidBits != 0;
  };
  const auto found = std::find_if(families.begin(), families.end(), computes);
  if (found == families.end()) throw std::runtime_error("--device vulkan: " + name_ + " has no compute queue");
  family_ = static_cast<std::uint32_t>(found - families.begin());

  VkPhysicalDeviceVulkan12Features has12{};
  has12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
  VkPhysicalDeviceFeatures2 has{};
  has.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  has.pNext = &has12;
  vk_.vkGetPhysicalDeviceFeatures2(physical_, &has);
  has_64_bit_atomics_ = has.features.shaderInt64 == VK_TRUE && has12.shaderBufferInt64Atomics == VK_TRUE;
  VkPhysicalDeviceVulkan12Features want12{};
  want12.sType = has12.sType;
  want12.shaderBufferInt64Atomics = has12.shaderBufferInt64Atomics;
  VkPhysicalDeviceFeatures2 want{};
  want.sType = has.sType;
  want.pNext = &want12;
  want.features.shaderInt64 = has.features.shaderInt64;
  const float priority = 1.0F;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueFamilyIndex = family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.pNext = &want;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  check(vk_.vkCreateDevice(physical_, &info, nullptr, &device_), "opening " + name_);
  vk_.load(device_);
  vk_.vkGetDeviceQueue(device_, family_, 0, &queue_);

  VkCommandPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool.queueFamilyIndex = family_;
  check(vk_.vkCreateCommandPool(device_, &pool, nullptr, &commands_), "vkCreateCommandPool");
  VkCommandBufferAllocateInfo request{};
  request.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  request.commandPool = commands_;
  request.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  request.commandBufferCount = 1;
  check(vk_.vkAllocateCommandBuffers(device_, &request, &record_), "vkAllocateCommandBuffers");
  VkQueryPoolCreateInfo queries{};
  queries.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
  queries.queryType = VK_QUERY_TYPE_TIMESTAMP;
  queries.queryCount = most_steps + 1;
  check(vk_.vkCreateQueryPool(device_, &queries, nullptr, &queries_), "vkCreateQueryPool");
  make_layout();
  staging_ = make_buffer(staging_bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                         VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
  check(vk_.vkMapMemory(device_, staging_.memory, 0, VK_WHOLE_SIZE, 0, &mapped_), "vkMapMemory");
}

void device::make_layout() {
  std::array<VkDescriptorSetLayoutBinding, bindings> slots{};
  for (std::uint32_t i = 0; i < bindings; ++i) {
    slots[i].binding = i;
    slots[i].descriptorType = i == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    slots[i].descriptorCount = 1;
    slots[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
  }
  VkDescriptorSetLayoutCreateInfo set{};
  set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  set.bindingCount = bindings;
  set.pBindings = slots.data();
  check(vk_.vkCreateDescriptorSetLayout(device_, &set, nullptr, &set_layout_), "vkCreateDescriptorSetLayout");
  const VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0, push_bytes};
  VkPipelineLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &set_layout_;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &range;
  check(vk_.vkCreatePipelineLayout(device_, &layout, nullptr, &layout_), "vkCreatePipelineLayout");
  const std::array<VkDescriptorPoolSize, 2> sizes{
      {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1}, {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, bindings - 1}}};
  VkDescriptorPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  pool.maxSets = 1;
  pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  pool.pPoolSizes = sizes.data();
  check(vk_.vkCreateDescriptorPool(device_, &pool, nullptr, &sets_), "vkCreateDescriptorPool");
  VkDescriptorSetAllocateInfo allocation{};
  allocation.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  allocation.descriptorPool = sets_;
  allocation.descriptorSetCount = 1;
  allocation.pSetLayouts = &set_layout_;
  check(vk_.vkAllocateDescriptorSets(device_, &allocation, &set_), "vkAllocateDescriptorSets");
}

buffer device::make_buffer(std::uint64_t bytes, VkBufferUsageFlags usage, VkMemoryPropertyFlags kind) {
  const std::string what =
      fmt::format("this model and size on {}: a buffer of {:.0f} MB", name_, static_cast<double>(bytes) / 1e6);
  if (bytes > properties_.limits.maxStorageBufferRange) {
    throw std::runtime_error(fmt::format("--device vulkan: too large for {}: a buffer of {:.0f} MB, at most {:.0f}",
                                         name_, static_cast<double>(bytes) / 1e6,
                                         static_cast<double>(properties_.limits.maxStorageBufferRange) / 1e6));
  }
  buffer b;
  b.bytes = bytes;
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = bytes;
  info.usage = usage;
  check(vk_.vkCreateBuffer(device_, &info, nullptr, &b.handle), what);
  VkMemoryRequirements needs{};
  vk_.vkGetBufferMemoryRequirements(device_, b.handle, &needs);
  VkPhysicalDeviceMemoryProperties memory{};
  vk_.vkGetPhysicalDeviceMemoryProperties(physical_, &memory);
  VkMemoryAllocateInfo allocation{};
  allocation.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  allocation.allocationSize = needs.size;
  const auto fits = [&](std::uint32_t type) {
    return (needs.memoryTypeBits >> type & 1U) != 0 && (memory.memoryTypes[type].propertyFlags & kind) == kind;
  };
  while (allocation.memoryTypeIndex < memory.memoryTypeCount && !fits(allocation.memoryTypeIndex))
    ++allocation.memoryTypeIndex;
  VkResult result = VK_ERROR_OUT_OF_DEVICE_MEMORY;
  if (allocation.memoryTypeIndex < memory.memoryTypeCount) {
    result = vk_.vkAllocateMemory(device_, &allocation, nullptr, &b.memory);
  }
  if (result == VK_SUCCESS) result = vk_.vkBindBufferMemory(device_, b.handle, b.memory, 0);
  if (result != VK_SUCCESS) free(b);
  check(result, what);
  return b;
}

void device::free(buffer& b) {
  vk_.vkDestroyBuffer(device_, b.handle, nullptr);
  vk_.vkFreeMemory(device_, b.memory, nullptr);
  b = buffer{};
}

std::uint64_t device::bytes() const {
  std::uint64_t sum = 0;
  for (const buffer& b : buffers_)
    sum += b.bytes;
  return sum;
}

void device::resize(std::uint32_t binding, std::uint64_t bytes) {
  buffer& b = buffers_.at(binding);
  free(b);
  const VkBufferUsageFlags kind =
      binding == 0 ? VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT : VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;
  b = make_buffer((std::max<std::uint64_t>(bytes, 64) + 3) / 4 * 4,
                  kind | VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                  VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  const VkDescriptorBufferInfo bound{b.handle, 0, VK_WHOLE_SIZE};
  VkWriteDescriptorSet write{};
  write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  write.dstSet = set_;
  write.dstBinding = binding;
  write.descriptorCount = 1;
  write.descriptorType = binding == 0 ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
  write.pBufferInfo = &bound;
  vk_.vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
}

void device::upload(std::uint32_t binding, std::span<const std::byte> from) {
  for (std::size_t done = 0; done < from.size(); done += staging_bytes) {
    const VkDeviceSize size = std::min<VkDeviceSize>(staging_bytes, from.size() - done);
    std::memcpy(mapped_, from.data() + done, size);
    begin();
    const VkBufferCopy part{0, done, size};
    vk_.vkCmdCopyBuffer(record_, staging_.handle, buffers_.at(binding).handle, 1, &part);
    submit("an upload");
  }
}

void device::download(std::uint32_t binding, std::span<std::byte> to) {
  for (std::size_t done = 0; done < to.size(); done += staging_bytes) {
    const VkDeviceSize size = std::min<VkDeviceSize>(staging_bytes, to.size() - done);
    begin();
    const VkBufferCopy part{done, 0, size};
    vk_.vkCmdCopyBuffer(record_, buffers_.at(binding).handle, staging_.handle, 1, &part);
    submit("a download");
    std::memcpy(to.data() + done, mapped_, size);
  }
}

}  // namespace pelage::frame::vulkan
