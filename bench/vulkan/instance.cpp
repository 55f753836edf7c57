// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "vulkan/instance.hpp"

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "vulkan/no_device.hpp"

namespace pelage::vulkan {
namespace {

constexpr const char* validation_layer = "VK_LAYER_KHRONOS_validation";

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

VKAPI_ATTR VkBool32 VKAPI_CALL on_message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                          const VkDebugUtilsMessengerCallbackDataEXT* data, void* count) {
  ++*static_cast<std::uint32_t*>(count);
  std::fprintf(stderr, "validation: %s\n", data->pMessage);
  return VK_FALSE;
}

}  // namespace

instance::instance(const std::string& caller, const char* application, bool validate) {
  vk_.caller = caller;
  try {
    open(application, validate);
  } catch (...) {
    close();
    throw;
  }
}

instance::~instance() {
  close();
}

bool instance::has_validation_layer() const {
  PFN_vkEnumerateInstanceLayerProperties enumerate = nullptr;
  vk_.find(VK_NULL_HANDLE, enumerate, "vkEnumerateInstanceLayerProperties");
  std::uint32_t count = 0;
  enumerate(&count, nullptr);
  std::vector<VkLayerProperties> layers(count);
  enumerate(&count, layers.data());
  return std::any_of(layers.begin(), layers.end(), [](const VkLayerProperties& layer) {
    return std::string_view(layer.layerName) == validation_layer;
  });
}

void instance::open(const char* application, bool validate) {
  vk_.open();
  validated_ = validate && has_validation_layer();
  VkApplicationInfo app{};
  app.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  app.pApplicationName = application;
  app.apiVersion = VK_API_VERSION_1_2;
  VkDebugUtilsMessengerCreateInfoEXT messages{};
  messages.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT;
  messages.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messages.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  messages.pfnUserCallback = on_message;
  messages.pUserData = &complaints_;
  const char* extension = VK_EXT_DEBUG_UTILS_EXTENSION_NAME;
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &app;
  if (validated_) {
    info.pNext = &messages;
    info.enabledLayerCount = 1;
    info.ppEnabledLayerNames = &validation_layer;
    info.enabledExtensionCount = 1;
    info.ppEnabledExtensionNames = &extension;
  }
  PFN_vkCreateInstance create = nullptr;
  vk_.find(VK_NULL_HANDLE, create, "vkCreateInstance");
  if (create(&info, nullptr, &handle_) != VK_SUCCESS) {
    throw no_device(vk_.caller + ": there is no Vulkan 1.2 driver");
  }
  vk_.load(handle_);
  if (validated_) {
    PFN_vkCreateDebugUtilsMessengerEXT listen = nullptr;
    vk_.find(handle_, listen, "vkCreateDebugUtilsMessengerEXT");
    vk_.check(listen(handle_, &messages, nullptr, &messenger_), "vkCreateDebugUtilsMessengerEXT");
  }
}

void instance::close() {
  if (handle_ == VK_NULL_HANDLE || vk_.vkDestroyInstance == nullptr) return;
  if (messenger_ != VK_NULL_HANDLE) {
    const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
        vk_.vkGetInstanceProcAddr(handle_, "vkDestroyDebugUtilsMessengerEXT"));
    if (destroy != nullptr) destroy(handle_, messenger_, nullptr);
  }
  vk_.vkDestroyInstance(handle_, nullptr);
}

physical_device instance::choose() const {
  std::uint32_t count = 0;
  vk_.vkEnumeratePhysicalDevices(handle_, &count, nullptr);
  std::vector<VkPhysicalDevice> all(count);
  vk_.vkEnumeratePhysicalDevices(handle_, &count, all.data());
  const char* given = std::getenv("PELAGE_DEVICE");
  const std::string wanted = lower(given == nullptr ? "" : given);
  std::string seen;
  for (const bool gpu_only : {true, false}) {
    for (VkPhysicalDevice one : all) {
      physical_device d{one, {}, {}};
      d.subgroups.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES;
      vk_.vkGetPhysicalDeviceProperties(one, &d.properties);
      const std::string name = d.properties.deviceName;
      if (gpu_only) seen += (seen.empty() ? "" : ", ") + name;
      const bool fits = wanted.empty() ? !d.is_cpu() || !gpu_only : lower(name).find(wanted) != std::string::npos;
      if (!fits || d.properties.apiVersion < VK_API_VERSION_1_2) continue;
      VkPhysicalDeviceProperties2 more{};
      more.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
      more.pNext = &d.subgroups;
      vk_.vkGetPhysicalDeviceProperties2(one, &more);
      return d;
    }
  }
  throw no_device(vk_.caller + ": there is no Vulkan 1.2 device" + (wanted.empty() ? "" : " called '" + wanted + "'") +
                  (seen.empty() ? ", no driver at all" : " among " + seen));
}

}  // namespace pelage::vulkan
