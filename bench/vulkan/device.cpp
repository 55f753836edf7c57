// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "vulkan/device.hpp"

#include <algorithm>
#include <array>

namespace pelage::vulkan {

device::device(device_options options)
    : options_(std::move(options)),
      instance_(options_.caller, options_.application, options_.validate),
      vk_(instance_.functions()),
      physical_(instance_.choose()),
      name_(physical_.properties.deviceName),
      // Mesa's lavapipe loses invocations at a barrier in a loop when a workgroup is larger than a subgroup.
      workgroup_(physical_.is_cpu() ? physical_.subgroups.subgroupSize : options_.gpu_workgroup),
      buffers_(options_.bindings) {
  try {
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
  if (device_ == VK_NULL_HANDLE) return;
  for (buffer& b : buffers_)
    free(b);
  free(staging_);
  for (const auto& [key, p] : pipelines_)
    vk_.vkDestroyPipeline(device_, p, nullptr);
  vk_.vkDestroyQueryPool(device_, queries_, nullptr);
  vk_.vkDestroyDescriptorPool(device_, sets_, nullptr);
  vk_.vkDestroyPipelineLayout(device_, layout_, nullptr);
  vk_.vkDestroyDescriptorSetLayout(device_, set_layout_, nullptr);
  vk_.vkDestroyCommandPool(device_, commands_, nullptr);
  vk_.vkDestroyDevice(device_, nullptr);
}

void device::open() {
  open_queue();
  VkCommandPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool.queueFamilyIndex = family_;
  vk_.check(vk_.vkCreateCommandPool(device_, &pool, nullptr, &commands_), "vkCreateCommandPool");
  VkCommandBufferAllocateInfo request{};
  request.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  request.commandPool = commands_;
  request.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  request.commandBufferCount = 1;
  vk_.check(vk_.vkAllocateCommandBuffers(device_, &request, &record_), "vkAllocateCommandBuffers");
  VkQueryPoolCreateInfo queries{};
  queries.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO;
  queries.queryType = VK_QUERY_TYPE_TIMESTAMP;
  queries.queryCount = most_steps + 1;
  if (options_.timed) vk_.check(vk_.vkCreateQueryPool(device_, &queries, nullptr, &queries_), "vkCreateQueryPool");
  make_layout();
  staging_ = make_buffer(VkDeviceSize{16} << 20U, VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                         VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
  vk_.check(vk_.vkMapMemory(device_, staging_.memory, 0, VK_WHOLE_SIZE, 0, &mapped_), "vkMapMemory");
}

void device::open_queue() {
  std::uint32_t count = 0;
  vk_.vkGetPhysicalDeviceQueueFamilyProperties(physical_.handle, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vk_.vkGetPhysicalDeviceQueueFamilyProperties(physical_.handle, &count, families.data());
  const auto computes = [&](const VkQueueFamilyProperties& f) {
    return (f.queueFlags & VK_QUEUE_COMPUTE_BIT) != 0 && (!options_.timed || f.timestampValidBits != 0);
  };
  const auto found = std::find_if(families.begin(), families.end(), computes);
  if (found == families.end()) throw vk_.error(name_ + " has no compute queue");
  family_ = static_cast<std::uint32_t>(found - families.begin());

  VkPhysicalDeviceVulkan12Features has12{};
  has12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
  VkPhysicalDeviceFeatures2 has{};
  has.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
  has.pNext = &has12;
  vk_.vkGetPhysicalDeviceFeatures2(physical_.handle, &has);
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
  vk_.check(vk_.vkCreateDevice(physical_.handle, &info, nullptr, &device_), "opening " + name_);
  vk_.load(device_);
  vk_.vkGetDeviceQueue(device_, family_, 0, &queue_);
}

void device::make_layout() {
  const std::uint32_t bindings = options_.bindings;
  std::vector<VkDescriptorSetLayoutBinding> slots(bindings);
  for (std::uint32_t i = 0; i < bindings; ++i) {
    slots[i].binding = i;
    slots[i].descriptorType = type_of(i);
    slots[i].descriptorCount = 1;
    slots[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
  }
  VkDescriptorSetLayoutCreateInfo set{};
  set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  set.bindingCount = bindings;
  set.pBindings = slots.data();
  vk_.check(vk_.vkCreateDescriptorSetLayout(device_, &set, nullptr, &set_layout_), "vkCreateDescriptorSetLayout");
  const VkPushConstantRange range{VK_SHADER_STAGE_COMPUTE_BIT, 0, options_.push_bytes};
  VkPipelineLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &set_layout_;
  layout.pushConstantRangeCount = options_.push_bytes == 0 ? 0 : 1;
  layout.pPushConstantRanges = &range;
  vk_.check(vk_.vkCreatePipelineLayout(device_, &layout, nullptr, &layout_), "vkCreatePipelineLayout");
  const std::array<VkDescriptorPoolSize, 2> sizes{
      {{VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER, 1}, {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, bindings}}};
  VkDescriptorPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  pool.maxSets = 1;
  pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  pool.pPoolSizes = sizes.data();
  vk_.check(vk_.vkCreateDescriptorPool(device_, &pool, nullptr, &sets_), "vkCreateDescriptorPool");
  VkDescriptorSetAllocateInfo allocation{};
  allocation.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  allocation.descriptorPool = sets_;
  allocation.descriptorSetCount = 1;
  allocation.pSetLayouts = &set_layout_;
  vk_.check(vk_.vkAllocateDescriptorSets(device_, &allocation, &set_), "vkAllocateDescriptorSets");
}

}  // namespace pelage::vulkan
