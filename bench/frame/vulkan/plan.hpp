// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "frame/frame.hpp"

namespace pelage::frame::vulkan {

/// What a pass has an invocation for; `subgroups`: a subgroup for each pixel.
enum class over { segments, points, stamps, pixels, subgroups };

/// How the fragments of a view become a map or a picture: which kernels run, and what memory they ask for.
struct plan {
  struct clearing {
    std::string what;  ///< under which its time is reported
    std::uint32_t binding;
    std::uint32_t value;
  };
  struct pass {
    std::string kernel;
    over what;
  };
  std::vector<clearing> clear;
  std::vector<pass> build;   ///< puts fragments into the structure, before the camera's fibres are lit
  std::vector<pass> layer;   ///< then, as many times as the deepest pixel has fragments
  std::vector<pass> slice;   ///< or as many times as there are slices with segments; `segments` are the slice's
  std::vector<pass> finish;  ///< last: takes them out
  bool pool;                 ///< the structure holds each fragment
  bool runs;                 ///< in runs, and its passes work for several views at once
  bool records;              ///< the camera's fragments are records
  bool whole;                ///< a light's texels keep all of theirs
  std::uint32_t lists;       ///< a pixel; 0: the pool is cut into runs
  std::uint32_t slots;       ///< of 8 bytes a pixel
  bool maps;                 ///< a pixel has an occupancy map
  std::uint32_t layers;      ///< of a pixel's opacity map; 0: it has none
  std::uint32_t blended;     ///< words that a pixel is blended in
  bool covered;              ///< a light's texel has the sum of its fibres' coverage
};

/// The plan of the camera or of the lights.
/// Throws std::runtime_error, one line, for what the shaders do not have.
[[nodiscard]] plan plan_of(const frame_settings& settings, bool camera);

/// Refuses before any work what no shader has, in the same way.
void check_settings(const frame_settings& settings);

/// The kernel that lights the fibres' points, of several variants by what the lights' maps are.
[[nodiscard]] std::string shading_kernel(const fibre_look& look);

/// True if the frame needs 64-bit atomics.
[[nodiscard]] bool needs_64_bit_atomics(const frame_settings& settings);

}  // namespace pelage::frame::vulkan
