// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shadows/layer_layout.hpp"

#include <pelage/visibility/depth_range.hpp>

#include <algorithm>

#include "frame/order/list_pass.hpp"

namespace pelage::frame {

layer_layout layers_of_model(const raster& from) {
  depth_range whole = depth_range::empty();
  for (const glm::vec3& point : from.fibres().point)
    whole.extend(std::max(-from.from().to_view(point).z, from.from().near_plane));
  return {{whole.nearest_depth()}, whole.farthest_depth() - whole.nearest_depth(), layer_widths::equal};
}

layer_layout layers_of_texels(const raster& from, std::span<const float> limit,
                              std::span<const std::uint32_t> drawing_order, order_report& report) {
  const std::size_t width = static_cast<std::size_t>(from.from().width);
  std::vector<depth_range> ranges(width * static_cast<std::size_t>(from.from().height), depth_range::empty());
  report = run_list_pass(from, limit, drawing_order, [&](int x, int y, std::span<pixel_fragment> all) {
    for (const pixel_fragment& f : all)
      ranges[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)].extend(f.depth);
  });
  layer_layout layout{{}, 0.0F, layer_widths::equal};
  std::vector<float> extents;
  for (const depth_range& range : ranges) {
    layout.first.push_back(range.nearest_depth());
    if (!range.is_empty()) extents.push_back(range.farthest_depth() - range.nearest_depth());
  }
  if (!extents.empty()) {
    const auto most = extents.begin() + static_cast<std::ptrdiff_t>(extents.size() * 9 / 10);
    std::nth_element(extents.begin(), most, extents.end());
    layout.extent = *most;
  }
  return layout;
}

}  // namespace pelage::frame
