// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/vulkan/bsdf_block.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

namespace pelage::frame::vulkan {
namespace {

using triple = glm::vec4;  ///< std430 aligns a vec3 as a vec4

triple triple_of(const glm::vec3& v) {
  return {v, 0.0F};
}

struct row {
  triple residual, passage, backward;
};
struct averages_of {
  triple forward, backward, forward_shift, backward_shift, forward_variance, backward_variance;
};
struct lobes {
  triple reflected, transmitted, returned;
};

struct head {
  chiang_fibre<float> chiang;
  float alpha;
  float beta;
  float unused;
  std::array<row, azimuthal_table::rows> azimuthal;
  std::array<averages_of, fibre_bsdf::inclinations> averages;
};
static_assert(offsetof(head, alpha) == 116 && offsetof(head, azimuthal) == 128 &&
              sizeof(head) == 128 + 48 * azimuthal_table::rows + 96 * fibre_bsdf::inclinations);

averages_of block_of(const dual_averages<float>& a) {
  return {triple_of(a.forward),        triple_of(a.backward),         triple_of(a.forward_shift),
          triple_of(a.backward_shift), triple_of(a.forward_variance), triple_of(a.backward_variance)};
}

head head_of(const fibre_bsdf& bsdf, const azimuthal_table& table) {
  head first{bsdf.chiang(), bsdf.marschner().alpha, bsdf.marschner().beta, 0.0F, {}, {}};
  for (std::uint32_t i = 0; i < azimuthal_table::rows; ++i)
    first.azimuthal[i] = {triple_of(table.residual()[i]), triple_of(table.passage()[i]),
                          triple_of(table.backward()[i])};
  const std::span<const dual_averages<float>> averages = bsdf.averages();
  std::transform(averages.begin(), averages.end(), first.averages.begin(), block_of);
  return first;
}

std::vector<lobes> lobes_of(const marschner_table<float>& n) {
  std::vector<lobes> all(n.reflected.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = {triple_of(n.reflected[i]), triple_of(n.transmitted[i]), triple_of(n.returned[i])};
  return all;
}

}  // namespace

void upload_bsdf(device& to, const fibre_bsdf& bsdf) {
  std::vector<std::byte> block;
  if (const azimuthal_table* const table = bsdf.table()) {
    const head first = head_of(bsdf, *table);
    const std::span<const std::byte> bytes = std::as_bytes(std::span(&first, 1));
    block.assign(bytes.begin(), bytes.end());
    const std::vector<lobes> rest = lobes_of(table->lobes());
    const std::span<const std::byte> more = std::as_bytes(std::span(rest));
    block.insert(block.end(), more.begin(), more.end());
  }
  to.resize(bsdf_buffer, block.size());
  to.upload(bsdf_buffer, block);
}

}  // namespace pelage::frame::vulkan
