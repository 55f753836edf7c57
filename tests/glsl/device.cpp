// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "glsl/device.hpp"

#define VK_NO_PROTOTYPES
#include <dlfcn.h>
#include <vulkan/vulkan.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <stdexcept>
#include <utility>

namespace pelage::test {

namespace {

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
}

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

std::string selection() {
  const std::string wanted = environment("PELAGE_DEVICE");
  return "device PELAGE_DEVICE=" + (wanted.empty() ? std::string("(any)") : wanted);
}

void check(VkResult result, const std::string& where) {
  if (result != VK_SUCCESS) {
    throw std::runtime_error(selection() + ": " + where + " failed with VkResult " + std::to_string(result));
  }
}

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* count) {
  ++*static_cast<std::uint32_t*>(count);
  std::fprintf(stderr, "validation: %s\n", data->pMessage);
  return VK_FALSE;
}

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

}  // namespace

/// Every Vulkan function that the harness calls, X-macro so that each is named once.
#define PELAGE_INSTANCE_FUNCTIONS(X)                                                                   \
  X(vkDestroyInstance)                                                                                 \
  X(vkEnumeratePhysicalDevices)                                                                        \
  X(vkGetPhysicalDeviceProperties)                                                                     \
  X(vkGetPhysicalDeviceMemoryProperties) X(vkGetPhysicalDeviceQueueFamilyProperties) X(vkCreateDevice) \
      X(vkGetPhysicalDeviceFeatures2) X(vkGetDeviceProcAddr)
#define PELAGE_DEVICE_FUNCTIONS(X)                                                                                     \
  X(vkDestroyDevice)                                                                                                   \
  X(vkGetDeviceQueue)                                                                                                  \
  X(vkCreateBuffer)                                                                                                    \
  X(vkDestroyBuffer) X(vkGetBufferMemoryRequirements) X(vkAllocateMemory) X(vkFreeMemory) X(vkBindBufferMemory)        \
      X(vkMapMemory) X(vkUnmapMemory) X(vkCreateShaderModule) X(vkDestroyShaderModule) X(vkCreateDescriptorSetLayout)  \
          X(vkDestroyDescriptorSetLayout) X(vkCreatePipelineLayout) X(vkDestroyPipelineLayout)                         \
              X(vkCreateComputePipelines) X(vkDestroyPipeline) X(vkCreateDescriptorPool) X(vkDestroyDescriptorPool)    \
                  X(vkAllocateDescriptorSets) X(vkUpdateDescriptorSets) X(vkCreateCommandPool) X(vkDestroyCommandPool) \
                      X(vkAllocateCommandBuffers) X(vkBeginCommandBuffer) X(vkEndCommandBuffer) X(vkCmdBindPipeline)   \
                          X(vkCmdBindDescriptorSets) X(vkCmdDispatch) X(vkCmdPipelineBarrier) X(vkCmdCopyBuffer)       \
                              X(vkQueueSubmit) X(vkQueueWaitIdle) X(vkResetDescriptorPool) X(vkResetCommandPool)

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

  void open_instance() {
    loader = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
    if (loader == nullptr) throw std::runtime_error(selection() + ": no Vulkan loader, " + dlerror());
    vkGetInstanceProcAddr = reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(loader, "vkGetInstanceProcAddr"));
    PFN_vkCreateInstance vkCreateInstance = nullptr;
    PFN_vkEnumerateInstanceLayerProperties vkEnumerateInstanceLayerProperties = nullptr;
    load(vkCreateInstance, "vkCreateInstance");
    load(vkEnumerateInstanceLayerProperties, "vkEnumerateInstanceLayerProperties");
    std::uint32_t count = 0;
    vkEnumerateInstanceLayerProperties(&count, nullptr);
    std::vector<VkLayerProperties> layers(count);
    vkEnumerateInstanceLayerProperties(&count, layers.data());
    for (const VkLayerProperties& l : layers)
      validated |= std::strcmp(l.layerName, validation_layer) == 0;

    VkApplicationInfo app{};
    app.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    app.pApplicationName = "pelage tests";
    app.apiVersion = VK_API_VERSION_1_2;
    VkDebugUtilsMessengerCreateInfoEXT messages{};
    messages.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
    messages.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    messages.messageType =
        VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
    messages.pfnUserCallback = on_message;
    messages.pUserData = &complaints;
    const char* extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
    VkInstanceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    info.pApplicationInfo = &app;
    if (validated) {
      info.pNext = &messages;
      info.enabledLayerCount = 1;
      info.ppEnabledLayerNames = &validation_layer;
      info.enabledExtensionCount = 1;
      info.ppEnabledExtensionNames = &extension;
    }
    check(vkCreateInstance(&info, nullptr, &instance), "vkCreateInstance, is there a driver?");
#define X(f) load(f, #f);
    PELAGE_INSTANCE_FUNCTIONS(X)
#undef X
    if (validated) {
      PFN_vkCreateDebugUtilsMessengerEXT create = nullptr;
      load(create, "vkCreateDebugUtilsMessengerEXT");
      check(create(instance, &messages, nullptr, &messenger), "vkCreateDebugUtilsMessengerEXT");
    }
  }

  void pick_device() {
    std::uint32_t count = 0;
    vkEnumeratePhysicalDevices(instance, &count, nullptr);
    std::vector<VkPhysicalDevice> all(count);
    vkEnumeratePhysicalDevices(instance, &count, all.data());
    const std::string wanted = lower(environment("PELAGE_DEVICE"));
    std::string seen;
    for (const bool gpu_only : {true, false}) {
      for (VkPhysicalDevice one : all) {
        vkGetPhysicalDeviceProperties(one, &properties);
        if (gpu_only) seen += (seen.empty() ? "" : ", ") + std::string(properties.deviceName);
        const bool gpu = properties.deviceType != VK_PHYSICAL_DEVICE_TYPE_CPU;
        const bool fits =
            wanted.empty() ? gpu || !gpu_only : lower(properties.deviceName).find(wanted) != std::string::npos;
        if (fits && properties.apiVersion >= VK_API_VERSION_1_2) {
          physical = one;
          name = properties.deviceName;
          return;
        }
      }
    }
    throw std::runtime_error(selection() + ": no Vulkan 1.2 device of that name" +
                             (seen.empty() ? ", no driver at all" : " among " + seen));
  }

  void open_device() {
    vkGetPhysicalDeviceMemoryProperties(physical, &memory);
    std::uint32_t count = 0;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
    std::vector<VkQueueFamilyProperties> families(count);
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
    while (family < count && (families[family].queueFlags & VK_QUEUE_COMPUTE_BIT) == 0)
      ++family;

    VkPhysicalDeviceVulkan12Features has12{};
    has12.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES;
    VkPhysicalDeviceFeatures2 has{};
    has.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2;
    has.pNext = &has12;
    vkGetPhysicalDeviceFeatures2(physical, &has);
    VkPhysicalDeviceVulkan12Features want12{};
    want12.sType = has12.sType;
    want12.shaderBufferInt64Atomics = has12.shaderBufferInt64Atomics;
    VkPhysicalDeviceFeatures2 want{};
    want.sType = has.sType;
    want.pNext = &want12;
    want.features.shaderInt64 = has.features.shaderInt64;
    atomic_int64 = has.features.shaderInt64 == VK_TRUE && has12.shaderBufferInt64Atomics == VK_TRUE;

    const float priority = 1.0F;
    VkDeviceQueueCreateInfo queues{};
    queues.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queues.queueFamilyIndex = family;
    queues.queueCount = 1;
    queues.pQueuePriorities = &priority;
    VkDeviceCreateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    info.pNext = &want;
    info.queueCreateInfoCount = 1;
    info.pQueueCreateInfos = &queues;
    check(vkCreateDevice(physical, &info, nullptr, &handle), "vkCreateDevice on " + name);
#define X(f)                                                      \
  f = reinterpret_cast<PFN_##f>(vkGetDeviceProcAddr(handle, #f)); \
  if (f == nullptr) throw std::runtime_error(selection() + ": no " + #f);
    PELAGE_DEVICE_FUNCTIONS(X)
#undef X
    vkGetDeviceQueue(handle, family, 0, &queue);

    VkCommandPoolCreateInfo pool{};
    pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
    pool.queueFamilyIndex = family;
    check(vkCreateCommandPool(handle, &pool, nullptr, &commands), "vkCreateCommandPool");
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 8};
    VkDescriptorPoolCreateInfo sets{};
    sets.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
    sets.maxSets = 1;
    sets.poolSizeCount = 1;
    sets.pPoolSizes = &size;
    check(vkCreateDescriptorPool(handle, &sets, nullptr, &descriptors), "vkCreateDescriptorPool");

    const std::string wanted = environment("PELAGE_WORKGROUP");
    const bool cpu = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
    workgroup = wanted.empty() ? (cpu ? 8U : 64U) : static_cast<std::uint32_t>(std::stoul(wanted));
  }

  buffer make_buffer(VkDeviceSize bytes, VkBufferUsageFlags usage, VkMemoryPropertyFlags kind) {
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

  void free_buffer(const buffer& b) {
    vkDestroyBuffer(handle, b.handle, nullptr);
    vkFreeMemory(handle, b.memory, nullptr);
  }

  const pipeline& pipeline_for(const kernel& k, std::uint32_t bindings, std::uint32_t group) {
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

  void run(const kernel& k, std::uint32_t invocations, std::span<std::vector<std::uint32_t>* const> words,
           std::uint32_t group);

  ~state() {
    if (handle != VK_NULL_HANDLE) {
      for (const auto& [key, p] : pipelines) {
        vkDestroyPipeline(handle, p.handle, nullptr);
        vkDestroyPipelineLayout(handle, p.layout, nullptr);
        vkDestroyDescriptorSetLayout(handle, p.set, nullptr);
      }
      vkDestroyDescriptorPool(handle, descriptors, nullptr);
      vkDestroyCommandPool(handle, commands, nullptr);
      vkDestroyDevice(handle, nullptr);
    }
    if (messenger != VK_NULL_HANDLE) {
      PFN_vkDestroyDebugUtilsMessengerEXT destroy = nullptr;
      load(destroy, "vkDestroyDebugUtilsMessengerEXT");
      destroy(instance, messenger, nullptr);
    }
    if (instance != VK_NULL_HANDLE) vkDestroyInstance(instance, nullptr);
    // The loader stays open: drivers leave threads and exit handlers behind.
  }
};

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

device::device() : state_(std::make_unique<state>()) {
  state_->open_instance();
  state_->pick_device();
  state_->open_device();
}

device::~device() = default;

const std::string& device::name() const {
  return state_->name;
}
bool device::is_cpu() const {
  return state_->properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
}
bool device::has_atomic_int64() const {
  return state_->atomic_int64;
}
std::uint32_t device::workgroup() const {
  return state_->workgroup;
}
bool device::validated() const {
  return state_->validated;
}
std::uint32_t device::complaints() const {
  return state_->complaints;
}

void device::run(const kernel& k, std::uint32_t invocations, std::span<std::vector<std::uint32_t>* const> buffers,
                 std::uint32_t workgroup) {
  state_->run(k, invocations, buffers, workgroup == 0 ? state_->workgroup : workgroup);
}

}  // namespace pelage::test
