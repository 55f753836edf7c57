// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/elementary.hpp>
#include <pelage/core/lanes.hpp>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <bit>
#include <cstdint>

/// Numbers and vectors of as many places as one instruction of this build handles.
namespace pelage::frame {

inline constexpr int wide_width = lane_width();
using wide = lanes<wide_width>;
using wide2 = glm::vec<2, wide>;
using wide3 = lane_vector<wide_width>;

/// The same vector in all lanes; of a plain float's, itself.
template <class Real>
[[nodiscard]] glm::vec<3, Real> filled(const glm::vec3& v) {
  return {Real(v.x), Real(v.y), Real(v.z)};
}

/// 0, 1, 2…
[[nodiscard]] inline wide::integers counted_lanes() {
  wide::integers numbers;
  for (int k = 0; k < wide_width; ++k)
    numbers[k] = k;
  return numbers;
}

/// x, x + 1, x + 2…
[[nodiscard]] inline wide counted_from(float x) {
  return wide(x) + wide(__builtin_convertvector(counted_lanes(), wide::vector));
}

using pelage::select;

/// a where the condition holds, else b.
template <class Condition, class Real>
[[nodiscard]] glm::vec<3, Real> select(Condition condition, const glm::vec<3, Real>& a, const glm::vec<3, Real>& b) {
  return {select(condition, a.x, b.x), select(condition, a.y, b.y), select(condition, a.z, b.z)};
}

/// What one lane holds.
[[nodiscard]] inline glm::vec3 lane_of(const wide3& v, int k) {
  return {v.x.lane[k], v.y.lane[k], v.z.lane[k]};
}

/// Calls `visit(k)` for the lanes whose bit is set, k from 0 up.
template <class Visit>
void for_each_lane(std::uint32_t set, Visit&& visit) {
  for (; set != 0; set &= set - 1U)
    visit(std::countr_zero(set));
}

/// The mask with these bits: what bits() undoes.
[[nodiscard]] inline lane_mask<wide_width> mask_of(std::uint32_t set) {
  return {((static_cast<int>(set) >> counted_lanes()) & 1) != 0};
}

/// Vectors lane by lane.
class wide3_builder {
 public:
  void set(int k, const glm::vec3& v) {
    x_[k] = v.x;
    y_[k] = v.y;
    z_[k] = v.z;
  }
  [[nodiscard]] wide3 done() const { return {wide::load(x_), wide::load(y_), wide::load(z_)}; }

 private:
  alignas(sizeof(wide)) float x_[wide_width] = {};
  alignas(sizeof(wide)) float y_[wide_width] = {};
  alignas(sizeof(wide)) float z_[wide_width] = {};
};

}  // namespace pelage::frame
