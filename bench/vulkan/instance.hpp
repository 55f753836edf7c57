// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

#include "vulkan/api.hpp"

namespace pelage::vulkan {

/// A driver's device, not opened yet.
struct physical_device {
  VkPhysicalDevice handle;
  VkPhysicalDeviceProperties properties;
  VkPhysicalDeviceSubgroupProperties subgroups;

  [[nodiscard]] bool is_cpu() const { return properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU; }
};

/// An instance of Vulkan 1.2.
class instance {
 public:
  /// `validate`: with the validation layer, if it is installed; what it says goes to stderr and is counted.
  /// Throws no_device; std::runtime_error, one line.
  instance(const std::string& caller, const char* application, bool validate);
  ~instance();
  instance(const instance&) = delete;
  instance& operator=(const instance&) = delete;

  [[nodiscard]] const api& functions() const { return vk_; }
  [[nodiscard]] bool validated() const { return validated_; }
  [[nodiscard]] std::uint32_t complaints() const { return complaints_; }  ///< of the validation layer, so far

  /// The device that has PELAGE_DEVICE in its name; without that variable the first GPU, else the first device.
  /// Throws no_device.
  [[nodiscard]] physical_device choose() const;

 private:
  void open(const char* application, bool validate);
  [[nodiscard]] bool has_validation_layer() const;
  void close();

  api vk_;
  VkInstance handle_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  bool validated_ = false;
  std::uint32_t complaints_ = 0;
};

}  // namespace pelage::vulkan
