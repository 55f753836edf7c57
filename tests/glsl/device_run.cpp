// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Running a kernel.
#include <cstring>

#include "glsl/device_state.hpp"

namespace pelage::test {

device::state::buffer device::state::make_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage,
                                                 VkMemoryPropertyFlags kind) {
  buffer b;
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = bytes;
  info.usage = usage;
  check(vkCreateBuffer(handle, &info, nullptr, &b.handle), "vkCreateBuffer");
  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(handle, b.handle, &needs);
  VkMemoryAllocateInfo allocation{};
  allocation.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
  allocation.allocationSize = needs.size;
  while (allocation.memoryTypeIndex < memory.memoryTypeCount &&
         ((needs.memoryTypeBits >> allocation.memoryTypeIndex & 1U) == 0U ||
          (memory.memoryTypes[allocation.memoryTypeIndex].propertyFlags & kind) != kind)) {
    ++allocation.memoryTypeIndex;
  }
  check(vkAllocateMemory(handle, &allocation, nullptr, &b.memory), "vkAllocateMemory");
  check(vkBindBufferMemory(handle, b.handle, b.memory, 0), "vkBindBufferMemory");
  return b;
}

void device::state::free_buffer(const buffer& b) {
  vkDestroyBuffer(handle, b.handle, nullptr);
  vkFreeMemory(handle, b.memory, nullptr);
}

const device::state::pipeline& device::state::pipeline_for(const kernel& k, std::uint32_t bindings,
                                                           std::uint32_t group) {
  pipeline& p = pipelines[{k.spirv.data(), group}];
  if (p.handle != VK_NULL_HANDLE) return p;
  std::vector<VkDescriptorSetLayoutBinding> slots(bindings);
  for (std::uint32_t i = 0; i < bindings; ++i) {
    slots[i].binding = i;
    slots[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    slots[i].descriptorCount = 1;
    slots[i].stageFlags = VK_SHADER_STAGE_COMPUTE_BIT;
  }
  VkDescriptorSetLayoutCreateInfo set{};
  set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  set.bindingCount = bindings;
  set.pBindings = slots.data();
  check(vkCreateDescriptorSetLayout(handle, &set, nullptr, &p.set), k.path);
  VkPipelineLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &p.set;
  check(vkCreatePipelineLayout(handle, &layout, nullptr, &p.layout), k.path);
  VkShaderModuleCreateInfo module{};
  module.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  module.codeSize = k.spirv.size_bytes();
  module.pCode = k.spirv.data();
  VkShaderModule shader = VK_NULL_HANDLE;
  check(vkCreateShaderModule(handle, &module, nullptr, &shader), k.path);
  const VkSpecializationMapEntry entry{0, 0, sizeof group};
  const VkSpecializationInfo special{1, &entry, sizeof group, &group};
  VkComputePipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = shader;
  info.stage.pName = "main";
  info.stage.pSpecializationInfo = &special;
  info.layout = p.layout;
  check(vkCreateComputePipelines(handle, VK_NULL_HANDLE, 1, &info, nullptr, &p.handle),
        std::string("compiling ") + k.path + " on " + name);
  vkDestroyShaderModule(handle, shader, nullptr);
  return p;
}

void device::state::run(const kernel& k, std::uint32_t invocations, std::span<std::vector<std::uint32_t>* const> words,
                        std::uint32_t group) {
  const auto count = static_cast<std::uint32_t>(words.size());
  const pipeline& p = pipeline_for(k, count, group);
  check(vkResetDescriptorPool(handle, descriptors, 0), "vkResetDescriptorPool");
  check(vkResetCommandPool(handle, commands, 0), "vkResetCommandPool");
  VkDescriptorSetAllocateInfo allocation{};
  allocation.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  allocation.descriptorPool = descriptors;
  allocation.descriptorSetCount = 1;
  allocation.pSetLayouts = &p.set;
  VkDescriptorSet set = VK_NULL_HANDLE;
  check(vkAllocateDescriptorSets(handle, &allocation, &set), "vkAllocateDescriptorSets");
  VkCommandBufferAllocateInfo request{};
  request.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  request.commandPool = commands;
  request.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  request.commandBufferCount = 1;
  VkCommandBuffer record = VK_NULL_HANDLE;
  check(vkAllocateCommandBuffers(handle, &request, &record), "vkAllocateCommandBuffers");
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  check(vkBeginCommandBuffer(record, &begin), "vkBeginCommandBuffer");

  std::vector<buffer> near(count);
  std::vector<buffer> far(count);
  const auto barrier = [&](VkPipelineStageFlags from, VkAccessFlags wrote, VkPipelineStageFlags to,
                           VkAccessFlags reads) {
    VkMemoryBarrier all{};
    all.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER;
    all.srcAccessMask = wrote;
    all.dstAccessMask = reads;
    vkCmdPipelineBarrier(record, from, to, 0, 1, &all, 0, nullptr, 0, nullptr);
  };
  for (std::uint32_t i = 0; i < count; ++i) {
    const VkDeviceSize bytes = words[i]->size() * sizeof(std::uint32_t);
    near[i] = make_buffer(bytes, VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                          VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
    far[i] = make_buffer(
        bytes, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
        VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
    void* mapped = nullptr;
    check(vkMapMemory(handle, near[i].memory, 0, VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory");
    std::memcpy(mapped, words[i]->data(), bytes);
    vkUnmapMemory(handle, near[i].memory);
    const VkBufferCopy whole{0, 0, bytes};
    vkCmdCopyBuffer(record, near[i].handle, far[i].handle, 1, &whole);
    const VkDescriptorBufferInfo bound{far[i].handle, 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet write{};
    write.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    write.dstSet = set;
    write.dstBinding = i;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    write.pBufferInfo = &bound;
    vkUpdateDescriptorSets(handle, 1, &write, 0, nullptr);
  }
  barrier(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
          VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT);
  vkCmdBindPipeline(record, VK_PIPELINE_BIND_POINT_COMPUTE, p.handle);
  vkCmdBindDescriptorSets(record, VK_PIPELINE_BIND_POINT_COMPUTE, p.layout, 0, 1, &set, 0, nullptr);
  vkCmdDispatch(record, (invocations + group - 1) / group, 1, 1);
  barrier(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT,
          VK_ACCESS_TRANSFER_READ_BIT);
  for (std::uint32_t i = 0; i < count; ++i) {
    const VkBufferCopy whole{0, 0, words[i]->size() * sizeof(std::uint32_t)};
    vkCmdCopyBuffer(record, far[i].handle, near[i].handle, 1, &whole);
  }
  barrier(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
          VK_ACCESS_HOST_READ_BIT);
  check(vkEndCommandBuffer(record), "vkEndCommandBuffer");
  VkSubmitInfo submit{};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &record;
  check(vkQueueSubmit(queue, 1, &submit, VK_NULL_HANDLE), std::string("submitting ") + k.path + " on " + name);
  check(vkQueueWaitIdle(queue), std::string("running ") + k.path + " on " + name);
  for (std::uint32_t i = 0; i < count; ++i) {
    void* mapped = nullptr;
    check(vkMapMemory(handle, near[i].memory, 0, VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory");
    std::memcpy(words[i]->data(), mapped, words[i]->size() * sizeof(std::uint32_t));
    vkUnmapMemory(handle, near[i].memory);
    free_buffer(near[i]);
    free_buffer(far[i]);
  }
}

}  // namespace pelage::test
