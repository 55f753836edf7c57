// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The memory of a device.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "vulkan/device.hpp"

namespace pelage::vulkan {
namespace {

std::string megabytes(std::uint64_t bytes) {
  return std::to_string(std::llround(static_cast<double>(bytes) / 1e6));
}

}  // namespace

buffer device::make_buffer(std::uint64_t bytes, VkBufferUsageFlags usage, VkMemoryPropertyFlags kind) {
  const std::string size = "a buffer of " + megabytes(bytes) + " MB";
  const std::string what = size + " on " + name_;
  const std::uint64_t most = physical_.properties.limits.maxStorageBufferRange;
  if (bytes > most) throw vk_.error("too large for " + name_ + ": " + size + ", at most " + megabytes(most));
  buffer b;
  b.bytes = bytes;
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = bytes;
  info.usage = usage;
  vk_.check(vk_.vkCreateBuffer(device_, &info, nullptr, &b.handle), what);
  VkMemoryRequirements needs{};
  vk_.vkGetBufferMemoryRequirements(device_, b.handle, &needs);
  VkPhysicalDeviceMemoryProperties memory{};
  vk_.vkGetPhysicalDeviceMemoryProperties(physical_.handle, &memory);
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
  vk_.check(result, what);
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
  const bool uniform = type_of(binding) == VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
  const std::uint64_t seen = (std::max<std::uint64_t>(bytes, 4) + 3) / 4 * 4;
  b = make_buffer(std::max<std::uint64_t>(seen, 64),
                  (uniform ? VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT : VK_BUFFER_USAGE_STORAGE_BUFFER_BIT) |
                      VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                  VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  const VkDescriptorBufferInfo bound{b.handle, 0, seen};
  VkWriteDescriptorSet write{};
  write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
  write.dstSet = set_;
  write.dstBinding = binding;
  write.descriptorCount = 1;
  write.descriptorType = type_of(binding);
  write.pBufferInfo = &bound;
  vk_.vkUpdateDescriptorSets(device_, 1, &write, 0, nullptr);
}

void device::upload(std::uint32_t binding, std::span<const std::byte> from) {
  for (std::size_t done = 0; done < from.size(); done += staging_.bytes) {
    const VkDeviceSize size = std::min<VkDeviceSize>(staging_.bytes, from.size() - done);
    std::memcpy(mapped_, from.data() + done, size);
    begin();
    const VkBufferCopy part{0, done, size};
    vk_.vkCmdCopyBuffer(record_, staging_.handle, buffers_.at(binding).handle, 1, &part);
    submit("an upload");
  }
}

void device::download(std::uint32_t binding, std::span<std::byte> to) {
  for (std::size_t done = 0; done < to.size(); done += staging_.bytes) {
    const VkDeviceSize size = std::min<VkDeviceSize>(staging_.bytes, to.size() - done);
    begin();
    const VkBufferCopy part{done, 0, size};
    vk_.vkCmdCopyBuffer(record_, buffers_.at(binding).handle, staging_.handle, 1, &part);
    submit("a download");
    std::memcpy(to.data() + done, mapped_, size);
  }
}

}  // namespace pelage::vulkan
