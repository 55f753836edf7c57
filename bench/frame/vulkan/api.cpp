// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/api.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "frame/vulkan/device_frame.hpp"

namespace pelage::frame::vulkan {
namespace {

template <class Function>
void set(Function& f, PFN_vkVoidFunction found, const char* name) {
  f = reinterpret_cast<Function>(found);
  if (f == nullptr) throw std::runtime_error(fmt::format("--device vulkan: the driver lacks {}", name));
}

}  // namespace

void check(VkResult result, const std::string& what) {
  if (result == VK_SUCCESS) return;
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY) {
    throw std::runtime_error(fmt::format("--device vulkan: not enough memory for {}", what));
  }
  if (result == VK_ERROR_DEVICE_LOST) {
    throw std::runtime_error(fmt::format("--device vulkan: the device was lost at {}", what));
  }
  throw std::runtime_error(fmt::format("--device vulkan: {} failed with VkResult {}", what, static_cast<int>(result)));
}

VkInstance api::open() {
  // The loader stays open: drivers leave threads and exit handlers behind.
  void* loader = dlopen("libvulkan.so.1", RTLD_NOW | RTLD_LOCAL);
  if (loader == nullptr) throw no_device("--device vulkan: there is no Vulkan loader, libvulkan.so.1");
  vkGetInstanceProcAddr = reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(loader, "vkGetInstanceProcAddr"));
  if (vkGetInstanceProcAddr == nullptr) throw std::runtime_error("--device vulkan: libvulkan.so.1 is no Vulkan loader");
  PFN_vkCreateInstance create = nullptr;
  set(create, vkGetInstanceProcAddr(nullptr, "vkCreateInstance"), "vkCreateInstance");

  VkApplicationInfo app{};
  app.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  app.pApplicationName = "pelage-frame";
  app.apiVersion = VK_API_VERSION_1_2;
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &app;
  VkInstance instance = VK_NULL_HANDLE;
  if (create(&info, nullptr, &instance) != VK_SUCCESS) {
    throw no_device("--device vulkan: there is no Vulkan 1.2 driver");
  }
#define X(name) set(name, vkGetInstanceProcAddr(instance, #name), #name);
  PELAGE_FRAME_INSTANCE_FUNCTIONS(X)
#undef X
  return instance;
}

void api::load(VkDevice device) {
#define X(name) set(name, vkGetDeviceProcAddr(device, #name), #name);
  PELAGE_FRAME_DEVICE_FUNCTIONS(X)
#undef X
}

}  // namespace pelage::frame::vulkan
