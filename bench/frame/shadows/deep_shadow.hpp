// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/visibility/deep_shadow_map.hpp>
#include <tbb/concurrent_vector.h>

#include <vector>

#include "frame/shadows/list_shadow.hpp"

namespace pelage::frame {

/// Per texel the transmittance as a line from vertex to vertex, nowhere farther than a given error from the truth. 8
/// bytes a vertex and 8 a texel.
class deep_shadow final : public list_shadow {
 public:
  /// `max_error`: [0, 1]; 0 keeps two vertices a fragment.
  deep_shadow(const raster& from, const solids& opaque, bool translucent, float max_error)
      : list_shadow(from, opaque, translucent), max_error_(max_error) {}

  void fill(int x, int y, std::span<seen_fragment> all) override;
  void settle() override;

 private:
  struct texel {
    std::uint32_t first = 0;  ///< vertex
    std::uint32_t count = 0;
  };
  struct stored_vertices;

  [[nodiscard]] float optical_before(std::size_t texel, float depth) const override;
  [[nodiscard]] std::uint64_t texel_bytes() const override;

  float max_error_;
  std::vector<texel> texel_ = std::vector<texel>(texels());
  tbb::concurrent_vector<deep_shadow_vertex> arrived_;  ///< texels as threads finish them, until settle()
  std::vector<deep_shadow_vertex> vertex_;              ///< in the texels' order
};

}  // namespace pelage::frame
