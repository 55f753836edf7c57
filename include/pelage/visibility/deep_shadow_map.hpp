// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <pelage/core/assert.hpp>
#include <pelage/core/exact_begin.hpp>
#include <pelage/core/math.hpp>
#include <pelage/visibility/deep_shadow_vertex.hpp>

#include <concepts>
#include <cstdint>
#include <span>

namespace pelage::inline PELAGE_ABI {

/// Where the vertices of deep shadow maps live, one array for all texels.
template <class Storage>
concept deep_shadow_storage = requires(Storage& s, const Storage& c, std::uint32_t n, deep_shadow_vertex v) {
  { c.vertex_capacity() } -> std::same_as<std::uint32_t>;
  { c.read_vertex(n) } -> std::same_as<deep_shadow_vertex>;
  { s.write_vertex(n, v) } -> std::same_as<void>;
};

/// deep_shadow_storage over the caller's memory. 8 bytes a vertex.
struct span_vertex_storage {
  std::span<deep_shadow_vertex> vertices;  ///< at most 2^32 - 1

  [[nodiscard]] std::uint32_t vertex_capacity() const noexcept { return static_cast<std::uint32_t>(vertices.size()); }
  [[nodiscard]] deep_shadow_vertex read_vertex(std::uint32_t n) const noexcept { return vertices[n]; }
  void write_vertex(std::uint32_t n, deep_shadow_vertex v) noexcept { vertices[n] = v; }
};

static_assert(deep_shadow_storage<span_vertex_storage>);

namespace detail {

/// A depth as the map knows it.
[[nodiscard]] constexpr float clamped_depth(float depth) noexcept {
  const float magnitude = depth < 0.0f ? -depth : depth;
  if (!(magnitude >= 7.88860905e-31f)) {
    return 0.0f;
  }
  const float held = magnitude < 1.26765060e30f ? magnitude : 1.26765060e30f;
  return depth < 0.0f ? -held : held;
}

}  // namespace detail

/// Turns the sorted fragments of a texel into its transmittance as a function of depth, in one pass: a line from
/// vertex to vertex that is nowhere farther than a given error from the truth. [Lokovic & Veach 2000, §4.2]
///
/// The truth at a depth is the product of 1 - alpha over all fragments strictly before it: 1 up to the nearest, and
/// constant behind the farthest. The result never rises. With an error of 0 it is the truth itself, within 2e-7 for up
/// to 2²⁰ fragments, in 2 vertices a depth. Begin, add() every fragment nearest first, finish(); `count` is then the
/// number of vertices, at most 2 a fragment. O(1) a fragment. One thread builds a texel.
///
/// Depths, of look-ups too, are clamped to [-2¹⁰⁰, 2¹⁰⁰], and those nearer to 0 than 2⁻¹⁰⁰ count as 0: no slope
/// then leaves a float's range.
struct deep_shadow_builder {
  std::uint32_t first;      ///< of the texel's vertices in the storage
  std::uint32_t count;      ///< vertices written so far
  float tolerance;          ///< the error allowed, less what rounding may add to it
  float transmittance;      ///< the truth behind all fragments so far, within 2e-7
  float remainder;          ///< what the truth is more than that, at most half an ulp of it
  float pending;            ///< depth of the last fragment
  deep_shadow_vertex from;  ///< the last vertex written: the line's origin
  float last;               ///< depth to which the line keeps within the error, >= from.depth
  float low;                ///< the least transmittance that the line's end may have there
  float high;               ///< and the greatest
  float least_slope;        ///< the least slope that the line may have, per unit of depth
  float greatest_slope;     ///< and the greatest

  /// A builder for the vertices from `first` on. `max_error`: [0, 1], of up to 2²⁰ fragments; below 1e-6, or NaN: as 0.
  [[nodiscard]] static constexpr deep_shadow_builder begin(std::uint32_t first, float max_error) noexcept {
    // The truth, slopes, their product with a length and the look-up round to less than 1e-6 together.
    const float tolerance = saturate(max_error - 1e-6f);
    return deep_shadow_builder{first, 0u,   tolerance, 1.0f, 0.0f, 0.0f, deep_shadow_vertex{0.0f, 1.0f},
                               0.0f,  1.0f, 1.0f,      0.0f, 0.0f};
  }

  /// Adds the next fragment; `depth`: at or behind the last one's; NaN is left out. `alpha`: clamped to [0, 1].
  template <deep_shadow_storage Storage>
  constexpr void add(Storage& storage, float depth, float alpha) noexcept;

  /// Writes what is still open.
  template <deep_shadow_storage Storage>
  constexpr void finish(Storage& storage) noexcept {
    if (count == 0u) {
      return;
    }
    pass(storage, pending, transmittance);
    if (last > from.depth) {
      end_line(storage);
    }
  }

  /// For add() and finish(): the line must pass `depth` within the tolerance of `truth`.
  template <deep_shadow_storage Storage>
  constexpr void pass(Storage& storage, float depth, float truth) noexcept;

  /// For pass() and finish(): ends the line at `last` with its middle slope.
  template <deep_shadow_storage Storage>
  constexpr void end_line(Storage& storage) noexcept {
    const float slope = 0.5f * (least_slope + greatest_slope);
    const float end = from.transmittance + slope * (last - from.depth);
    const float raised = end > low ? end : low;
    const float held = raised < high ? raised : high;
    begin_line(storage, deep_shadow_vertex{last, held < from.transmittance ? held : from.transmittance});
  }

  /// Writes a vertex and begins a line there.
  template <deep_shadow_storage Storage>
  constexpr void begin_line(Storage& storage, deep_shadow_vertex at) noexcept {
    PELAGE_ASSERT(first + count < storage.vertex_capacity());
    storage.write_vertex(first + count, at);
    ++count;
    from = at;
    last = at.depth;
    low = at.transmittance;
    high = at.transmittance;
    least_slope = -3.40282347e38f;
    greatest_slope = 0.0f;
  }
};

/// The transmittance that `count` vertices from `first` on give at a depth, [0, 1]; 1 without vertices. Never rises
/// with depth. NaN counts as 0. O(log count).
template <deep_shadow_storage Storage>
[[nodiscard]] constexpr float deep_shadow_at(const Storage& storage, std::uint32_t first, std::uint32_t count,
                                             float depth) noexcept {
  const float at = detail::clamped_depth(depth);
  std::uint32_t before = 0u;  // vertices known to lie before the depth
  std::uint32_t rest = count;
  while (rest > 0u) {
    const std::uint32_t middle = rest / 2u;
    if (storage.read_vertex(first + before + middle).depth < at) {
      before += middle + 1u;
      rest -= middle + 1u;
    } else {
      rest = middle;
    }
  }
  if (before == 0u) {
    return 1.0f;
  }
  const deep_shadow_vertex a = storage.read_vertex(first + before - 1u);
  if (before == count) {
    return a.transmittance;
  }
  const deep_shadow_vertex b = storage.read_vertex(first + before);
  const float along = (at - a.depth) / (b.depth - a.depth);
  const float on_line = a.transmittance + (b.transmittance - a.transmittance) * along;
  return on_line > b.transmittance ? on_line : b.transmittance;
}

// ---------------------------------------------------------------------------------------------------------

template <deep_shadow_storage Storage>
constexpr void deep_shadow_builder::add(Storage& storage, float depth, float alpha) noexcept {
  if (depth != depth) {
    return;
  }
  const float held = detail::clamped_depth(depth);
  if (count == 0u) {
    begin_line(storage, deep_shadow_vertex{held, 1.0f});
  } else {
    PELAGE_ASSERT(held >= pending);
    if (held > pending) {
      pass(storage, pending, transmittance);
      pass(storage, held, transmittance);
    }
  }
  pending = held;
  // What a product by an exact factor or a difference loses goes into the remainder.
  const float stopped = saturate(alpha);
  const float passed = 1.0f - stopped;
  const bool falls_far = stopped > 0.5f;  // where the factor is exact
  const float kept = falls_far ? transmittance * passed : transmittance;
  const float change = falls_far ? remainder * passed : remainder - transmittance * stopped;
  transmittance = kept + change;
  remainder = change - (transmittance - kept);
}

template <deep_shadow_storage Storage>
constexpr void deep_shadow_builder::pass(Storage& storage, float depth, float truth) noexcept {
  const float least = saturate(truth - tolerance);
  const float most = saturate(truth + tolerance);
  if (depth > from.depth) {
    const float down = (least - from.transmittance) / (depth - from.depth);
    const float up = (most - from.transmittance) / (depth - from.depth);
    const bool falls = tolerance == 0.0f && truth < from.transmittance;  // however small
    if (falls || up < least_slope || down > greatest_slope) {
      end_line(storage);
    }
  }
  if (depth > from.depth) {
    const float down = (least - from.transmittance) / (depth - from.depth);
    const float up = (most - from.transmittance) / (depth - from.depth);
    least_slope = down > least_slope ? down : least_slope;
    greatest_slope = up < greatest_slope ? up : greatest_slope;
    low = depth > last ? least : low;  // at one depth the truth falls: the first is the higher
    high = most;
    last = depth;
  } else if (from.transmittance > most) {
    begin_line(storage, deep_shadow_vertex{depth, truth});
  }
}

}  // namespace pelage
#include <pelage/core/exact_end.hpp>
