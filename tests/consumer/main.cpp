// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/tail.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/glsl.hpp>

// The mirror's strings: whole files, each include in its place and once.
constexpr bool stands_once(std::string_view text, std::string_view part) {
  const auto at = text.find(part);
  return at != text.npos && text.find(part, at + 1) == text.npos;
}
constexpr std::string_view k_buffer = pelage::glsl::order::k_buffer;
static_assert(k_buffer.find("#include") == k_buffer.npos && k_buffer.back() == '\n');
static_assert(stands_once(k_buffer, "struct pelage_fragment {") && stands_once(k_buffer, "struct pelage_k_buffer {"));
static_assert(k_buffer.find("struct pelage_fragment {") < k_buffer.find("struct pelage_k_buffer {"));
static_assert(!pelage::glsl::bsdf::chiang_sampling.empty() && !pelage::glsl::visibility::occupancy_map.empty());

int main() {
  const pelage::fragment near{1.0f, 7};
  const pelage::fragment far{2.0f, 3};
  return pelage::before(near, far) && !pelage::before(far, near) ? 0 : 1;
}
