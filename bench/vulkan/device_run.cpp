// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Running kernels.
#include <algorithm>
#include <array>
#include <stdexcept>

#include "vulkan/device.hpp"

namespace pelage::vulkan {
namespace {

constexpr std::uint32_t most_groups = 65535;  ///< along one axis, on any device

/// Whether all has to be done before the step that follows.
bool ends_alone(std::span<const step> steps, std::size_t i) {
  return i + 1 == steps.size() || !steps[i + 1].beside;
}

}  // namespace

void device::begin() {
  vk_.check(vk_.vkResetCommandPool(device_, commands_, 0), "vkResetCommandPool");
  VkCommandBufferBeginInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  vk_.check(vk_.vkBeginCommandBuffer(record_, &info), "vkBeginCommandBuffer");
}

void device::submit(const std::string& what) {
  VkMemoryBarrier to_host{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, VK_ACCESS_TRANSFER_WRITE_BIT,
                          VK_ACCESS_HOST_READ_BIT};
  vk_.vkCmdPipelineBarrier(record_, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &to_host, 0,
                           nullptr, 0, nullptr);
  vk_.check(vk_.vkEndCommandBuffer(record_), "vkEndCommandBuffer");
  VkSubmitInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  info.commandBufferCount = 1;
  info.pCommandBuffers = &record_;
  vk_.check(vk_.vkQueueSubmit(queue_, 1, &info, VK_NULL_HANDLE), what);
  vk_.check(vk_.vkQueueWaitIdle(queue_), what);
}

VkPipeline device::pipeline(const kernel& program, std::uint32_t workgroup) {
  VkPipeline& p = pipelines_[{program.spirv.data(), workgroup}];
  if (p != VK_NULL_HANDLE) return p;
  const std::string name(program.name);
  VkShaderModuleCreateInfo module{};
  module.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  module.codeSize = program.spirv.size_bytes();
  module.pCode = program.spirv.data();
  VkShaderModule shader = VK_NULL_HANDLE;
  vk_.check(vk_.vkCreateShaderModule(device_, &module, nullptr, &shader), name);
  const std::array<std::uint32_t, 3> constants{workgroup, subgroup(), options_.variant};
  const std::array<VkSpecializationMapEntry, 3> entries{{{0, 0, 4}, {1, 4, 4}, {2, 8, 4}}};
  const VkSpecializationInfo special{3, entries.data(), sizeof constants, constants.data()};
  VkComputePipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
  info.stage.module = shader;
  info.stage.pName = "main";
  info.stage.pSpecializationInfo = &special;
  info.layout = layout_;
  const VkResult result = vk_.vkCreateComputePipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &p);
  vk_.vkDestroyShaderModule(device_, shader, nullptr);
  vk_.check(result, "compiling " + name + " on " + name_);
  return p;
}

void device::record(const step& s) {
  if (s.program == nullptr) {
    vk_.vkCmdFillBuffer(record_, buffers_.at(s.binding).handle, 0, VK_WHOLE_SIZE, s.value);
    return;
  }
  vk_.vkCmdBindPipeline(record_, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline(*s.program, workgroup_of(s)));
  if (!s.push.empty()) {
    vk_.vkCmdPushConstants(record_, layout_, VK_SHADER_STAGE_COMPUTE_BIT, 0,
                           static_cast<std::uint32_t>(s.push.size() * sizeof(std::uint32_t)), s.push.data());
  }
  const std::uint64_t groups = std::max<std::uint64_t>((s.invocations + workgroup_of(s) - 1) / workgroup_of(s), 1);
  const std::uint64_t across = std::min<std::uint64_t>(groups, most_groups);
  vk_.vkCmdDispatch(record_, static_cast<std::uint32_t>(across),
                    static_cast<std::uint32_t>((groups + across - 1) / across), s.layers);
}

std::vector<double> device::run(std::span<const step> steps) {
  if (steps.size() > most_steps) throw std::invalid_argument(options_.caller + ": too many steps");
  for (const step& s : steps) {
    if (s.program != nullptr) (void)pipeline(*s.program, workgroup_of(s));  // compiled before the clock starts
  }
  begin();
  if (options_.timed) vk_.vkCmdResetQueryPool(record_, queries_, 0, most_steps + 1);
  vk_.vkCmdBindDescriptorSets(record_, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &set_, 0, nullptr);
  constexpr VkPipelineStageFlags stages = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT;
  VkMemoryBarrier all{VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr,
                      VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT,
                      VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_READ_BIT |
                          VK_ACCESS_TRANSFER_WRITE_BIT | VK_ACCESS_UNIFORM_READ_BIT};
  vk_.vkCmdPipelineBarrier(record_, stages, stages, 0, 1, &all, 0, nullptr, 0, nullptr);
  std::uint32_t ticks = 0;
  const auto note_time = [&] {
    if (options_.timed) vk_.vkCmdWriteTimestamp(record_, VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, queries_, ticks++);
  };
  note_time();
  for (std::size_t i = 0; i < steps.size(); ++i) {
    record(steps[i]);
    if (!ends_alone(steps, i)) continue;
    vk_.vkCmdPipelineBarrier(record_, stages, stages, 0, 1, &all, 0, nullptr, 0, nullptr);
    note_time();
  }
  submit(steps.size() == 1 && steps[0].program != nullptr ? std::string(steps[0].program->name) : "a frame");
  return options_.timed ? read_clock(steps, ticks) : std::vector<double>();
}

std::vector<double> device::read_clock(std::span<const step> steps, std::uint32_t count) {
  std::vector<std::uint64_t> ticks(count);
  vk_.check(vk_.vkGetQueryPoolResults(device_, queries_, 0, count, ticks.size() * sizeof(std::uint64_t), ticks.data(),
                                      sizeof(std::uint64_t), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
            "reading the clock");
  std::vector<double> milliseconds(steps.size());
  for (std::size_t i = 0, t = 0; i < steps.size(); ++i) {
    if (!ends_alone(steps, i)) continue;
    milliseconds[i] = static_cast<double>(ticks[t + 1] - ticks[t]) *
                      static_cast<double>(physical_.properties.limits.timestampPeriod) * 1e-6;
    ++t;
  }
  return milliseconds;
}

}  // namespace pelage::vulkan
