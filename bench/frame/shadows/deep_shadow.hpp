// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/visibility/deep_shadow_map.hpp>

#include <span>
#include <vector>

#include "frame/base/array_pool.hpp"
#include "frame/shadows/list_shadow.hpp"

namespace pelage::frame {

/// Per texel the transmittance as a line from vertex to vertex, nowhere farther than a given error from the truth. 8
/// bytes a vertex and 16 a texel.
class deep_shadow final : public list_shadow {
 public:
  /// `max_error`: [0, 1]; 0 keeps two vertices a fragment.
  deep_shadow(const raster& from, const solids& opaque, bool translucent, float max_error)
      : list_shadow(from, opaque, translucent), max_error_(max_error) {}

  void fill(int x, int y, std::span<pixel_fragment> all) override;

 private:
  struct stored_vertices;

  [[nodiscard]] float optical_before(std::size_t texel, float depth) const override;
  [[nodiscard]] std::uint64_t texel_bytes() const override;

  float max_error_;
  array_pool<deep_shadow_vertex> vertices_;
  std::vector<std::span<const deep_shadow_vertex>> texel_{texels()};
};

}  // namespace pelage::frame
