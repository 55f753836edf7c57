// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Opening a device.
#include <dlfcn.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "glsl/device_state.hpp"

namespace pelage::test {

namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* count) {
  ++*static_cast<std::uint32_t*>(count);
  std::fprintf(stderr, "validation: %s\n", data->pMessage);
  return VK_FALSE;
}

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

}  // namespace

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string() : std::string(value);
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

void device::state::open_instance() {
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

void device::state::pick_device() {
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

void device::state::open_device() {
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

device::state::~state() {
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
