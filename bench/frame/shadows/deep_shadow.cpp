// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shadows/deep_shadow.hpp"

#include <algorithm>

namespace pelage::frame {

/// deep_shadow_storage for look-ups.
struct deep_shadow::stored_vertices {
  const deep_shadow_vertex* all;

  [[nodiscard]] std::uint32_t vertex_capacity() const noexcept { return 0xffffffffU; }
  [[nodiscard]] deep_shadow_vertex read_vertex(std::uint32_t n) const noexcept { return all[n]; }
  void write_vertex(std::uint32_t, deep_shadow_vertex) noexcept {}
};

void deep_shadow::fill(int x, int y, std::span<pixel_fragment> all) {
  std::sort(all.begin(), all.end(),
            [](const pixel_fragment& a, const pixel_fragment& b) { return before(fragment_of(a), fragment_of(b)); });
  static thread_local std::vector<deep_shadow_vertex> scratch;
  scratch.resize(2 * all.size());
  span_vertex_storage storage{scratch};
  deep_shadow_builder line = deep_shadow_builder::begin(0, max_error_);
  sum_up(index(x, y), all, [&](const pixel_fragment& f, std::uint32_t) { line.add(storage, f.depth, alpha(f)); });
  line.finish(storage);
  if (line.count == 0) return;
  const std::span<deep_shadow_vertex> kept = vertices_.take(line.count);
  std::copy_n(scratch.begin(), kept.size(), kept.begin());
  texel_[index(x, y)] = kept;
}

float deep_shadow::optical_before(std::size_t t, float depth) const {
  const std::span<const deep_shadow_vertex> line = texel_[t];
  const float passed = deep_shadow_at(stored_vertices{line.data()}, 0, static_cast<std::uint32_t>(line.size()), depth);
  return static_cast<float>(optical_depth(1.0F - passed));
}

std::uint64_t deep_shadow::texel_bytes() const {
  return vertices_.bytes() + texel_.size() * sizeof(texel_[0]);
}

}  // namespace pelage::frame
