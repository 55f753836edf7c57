// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
//
// Density clusters: any positions in their range, any number of fragments.
#include <pelage/visibility/density_clusters.hpp>

#include "visibility.hpp"

#include <cstdint>
#include <vector>

namespace {

using namespace pelage;
using fuzz::law;

constexpr std::uint32_t bins = 4;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::input in(data, size);
  std::vector<float> positions;
  for (std::uint32_t left = in.below(65); left > 0; --left) {
    positions.push_back(slice_position(in.unit(), bins));
  }
  auto clusters = density_clusters<bins>::empty();
  std::vector<std::uint32_t> cells(density_clusters<bins>::cells, 0u);
  atomic_cells<std::uint32_t> storage{cells};
  for (std::size_t i = 0; i < positions.size(); ++i) {
    clusters.add(positions[i]);
    atomic_density_clusters::add<density_clusters<bins>>(storage, 0u, positions[positions.size() - 1 - i]);
  }
  law(fuzz::same_bits(clusters, atomic_density_clusters::load<density_clusters<bins>>(storage, 0u)),
      "clusters depend on no order");

  const auto before = [&](std::uint32_t bin) {
    std::uint32_t number = 0;
    for (const float position : positions) {
      number += layer_at(position, bins) < bin ? 1u : 0u;
    }
    return static_cast<float>(number);
  };
  for (std::uint32_t bin = 0; bin <= bins; ++bin) {
    law(clusters.count_before(static_cast<float>(bin)) == before(bin), "ends of bins are exact");
  }
  std::vector<float> look_ups;
  while (!in.empty() && look_ups.size() < 64) {
    look_ups.push_back(slice_position(in.unit(), bins));
  }
  std::sort(look_ups.begin(), look_ups.end());
  float last = 0.0f;
  for (const float position : look_ups) {
    const float count = clusters.count_before(position);
    const std::uint32_t bin = layer_at(position, bins);
    law(count >= last, "the count never falls");
    law(count >= before(bin) && count <= before(bin + 1), "a count in a bin lies between those of its ends");
    last = count;
  }
  return 0;
}
