// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/scene/detail.hpp"

#include <pelage/coverage/chord_run.hpp>
#include <pelage/coverage/strand_share.hpp>
#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace pelage::frame {
namespace {

constexpr float least_share = 0.001F;       ///< of the strands
constexpr std::uint64_t frame_bytes = 160;  ///< a point, of the strands and what a frame makes for each of two views

/// How one view measures a point.
struct ruler {
  const view* from;
  float slant;  ///< length of the longest of its rays with a view depth of 1

  explicit ruler(const view& v) : from(&v), slant(1.0F) {
    if (v.perspective) slant = glm::length(v.ray(0.0F, 0.0F).direction);
  }

  [[nodiscard]] float tolerance(float error, const glm::vec3& world) const {
    if (!from->perspective) return error / from->scale;
    return screen_tolerance(error, -from->to_view(world).z, from->near_plane, from->scale, slant);
  }

  /// The world's direction in which view depth falls fastest.
  [[nodiscard]] glm::vec3 toward() const { return from->direction_to_world(glm::vec3(0.0F, 0.0F, 1.0F)); }

  [[nodiscard]] float pixels(float length, const glm::vec3& world) const {
    return length / from->pixel_at(from->to_view(world));
  }
};

/// One copy of the model, and which of its points stay.
class reduction {
 public:
  reduction(const strands& whole, std::span<const std::uint32_t> first_point, std::span<const view> views,
            const detail_errors& errors)
      : whole_(whole),
        first_(first_point),
        rulers_(views.begin(), views.end()),
        errors_(errors),
        stays_(whole.point.size()),
        factor_(first_.size() - 1),
        place_(first_.size(), 0) {
    for (const glm::vec3& p : whole_.point) {
      bounds_.lower = glm::min(bounds_.lower, p);
      bounds_.upper = glm::max(bounds_.upper, p);
    }
    for (const float radius : whole_.radius)
      thickest_ = std::max(thickest_, 2.0F * radius);
  }

  /// Finds what stays of a copy whose first strand has this number among all. The number of points.
  std::uint64_t find(const placement& copy, std::uint32_t first_number) {
    const float most = errors_.strand > 0.0F ? greatest_share(copy) : 1.0F;
    tbb::parallel_for(std::size_t{0}, factor_.size(), [&](std::size_t s) {
      factor_[s] = width_of(copy, s, strand_rank(first_number + static_cast<std::uint32_t>(s)), most);
      place_[s + 1] = factor_[s] > 0.0F ? find_points(copy, s) : 0;
    });
    std::uint64_t points = 0;
    for (std::uint64_t& place : place_)
      place = points += place;
    return points;
  }

  /// Puts it behind what others left.
  void append(const placement& copy, detailed_strands& to) const {
    strands& out = to.fibres;
    const std::size_t points_before = out.point.size();
    const std::size_t segments_before = out.segment.size();
    const std::size_t points = points_before + place_.back();
    std::vector<std::uint64_t> first_segment(place_.size(), segments_before);
    for (std::size_t s = 0; s < factor_.size(); ++s) {
      const std::uint64_t count = place_[s + 1] - place_[s];
      to.count += count > 0 ? 1 : 0;
      first_segment[s + 1] = first_segment[s] + std::max<std::uint64_t>(count, 1) - 1;
    }
    out.point.resize(points);
    out.tangent.resize(points);
    out.radius.resize(points);
    out.opacity.resize(points);
    out.colour.resize(points);
    out.end_of.resize(points, 0);
    out.segment.resize(first_segment.back());
    tbb::parallel_for(std::size_t{0}, factor_.size(), [&](std::size_t s) {
      if (place_[s] == place_[s + 1]) return;
      std::size_t next = points_before + place_[s];
      std::uint64_t segment = first_segment[s];
      for (std::uint32_t i = first_[s]; i < first_[s + 1]; ++i) {
        if (stays_[i] == 0) continue;
        out.point[next] = copy.to_world(whole_.point[i]);
        out.tangent[next] = copy.turned(whole_.tangent[i]);
        out.radius[next] = factor_[s] * whole_.radius[i];
        out.opacity[next] = whole_.opacity[i];
        out.colour[next] = whole_.colour[i];
        out.end_of[next] = whole_.end_of[i];
        if (i + 1 < first_[s + 1]) out.segment[segment++] = static_cast<std::uint32_t>(next);
        ++next;
      }
    });
  }

 private:
  /// At least the share of each strand of a copy.
  [[nodiscard]] float greatest_share(const placement& copy) const {
    if (bounds_.empty()) return 1.0F;
    const glm::vec3 middle = copy.to_world(0.5F * (bounds_.lower + bounds_.upper));
    const float reach = 0.5001F * glm::length(bounds_.upper - bounds_.lower);
    float widest = 0.0F;
    for (const ruler& r : rulers_)
      widest = std::max(widest, r.pixels(thickest_, middle + reach * r.toward()));
    return kept_share(1.001F * widest, errors_.strand, least_share);
  }

  /// The factor of a strand's width. `most`: at least its share; what is not drawn with that is not drawn with less.
  [[nodiscard]] float width_of(const placement& copy, std::size_t strand, float rank, float most) const {
    if (!(errors_.strand > 0.0F)) return 1.0F;
    if (width_factor(rank, most) == 0.0F) return 0.0F;
    float widest = 0.0F;
    for (std::uint32_t i = first_[strand]; i < first_[strand + 1]; ++i) {
      const glm::vec3 at = copy.to_world(whole_.point[i]);
      for (const ruler& r : rulers_)
        widest = std::max(widest, r.pixels(2.0F * whole_.radius[i], at));
    }
    return width_factor(rank, kept_share(widest, errors_.strand, least_share));
  }

  [[nodiscard]] float tolerance_at(const glm::vec3& at) const {
    float least = std::numeric_limits<float>::infinity();
    for (const ruler& r : rulers_)
      least = std::min(least, r.tolerance(errors_.segment, at));
    return least;
  }

  /// Marks the points of a strand that stay. Their number.
  std::uint64_t find_points(const placement& copy, std::size_t strand) {
    const std::uint32_t first = first_[strand];
    const std::uint32_t end = first_[strand + 1];
    if (first == end) return 0;
    const bool all = !(errors_.segment > 0.0F);
    std::fill(stays_.begin() + first, stays_.begin() + end, all ? 1 : 0);
    if (all) return end - first;
    stays_[first] = 1;
    stays_[end - 1] = 1;
    std::uint64_t count = end - first > 1 ? 2 : 1;
    glm::vec3 before = copy.to_world(whole_.point[first]);
    float room_before = tolerance_at(before);
    chord_run<float> run = begin_chord(before, whole_.radius[first], room_before);
    std::uint32_t kept = first;
    for (std::uint32_t i = first + 1; i < end; ++i) {
      const glm::vec3 at = copy.to_world(whole_.point[i]);
      const float room = tolerance_at(at);
      if (!chord_reaches(run, at, whole_.radius[i], room) && i - 1 > kept) {
        kept = i - 1;
        stays_[kept] = 1;
        ++count;
        run = begin_chord(before, whole_.radius[kept], room_before);
      }
      run = pass_point(run, at, whole_.radius[i], room, std::min(errors_.segment * whole_.radius[i], room));
      before = at;
      room_before = room;
    }
    return count;
  }

  const strands& whole_;
  std::span<const std::uint32_t> first_;
  std::vector<ruler> rulers_;
  detail_errors errors_;
  box bounds_;
  float thickest_ = 0.0F;             ///< of all fibres, where they are thickest
  std::vector<std::uint8_t> stays_;   ///< a point; of strands that stay
  std::vector<float> factor_;         ///< a strand: of its width; 0: it does not stay
  std::vector<std::uint64_t> place_;  ///< a strand's first point among those of the copy
};

/// Of what is chosen, or where all copies are alike, of what will be. `done`: copies so far.
void check_room(std::uint64_t points, std::size_t done, std::size_t copies, bool are_alike) {
  const double share = are_alike ? static_cast<double>(copies) / static_cast<double>(done) : 1.0;
  const double expected = share * static_cast<double>(points);
  if (points > std::numeric_limits<std::uint32_t>::max()) {
    throw std::length_error("the strands to draw have more than 2^32 - 1 points: raise the errors of detail");
  }
  const double needed = expected * static_cast<double>(frame_bytes);
  const double has = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
  if (copies > 1 && needed > has) {
    throw std::runtime_error(fmt::format(
        "the crowd would need {:.0f} GB, the machine has {:.0f}: fewer copies, or --segment-error and --strand-error",
        needed / 1e9, has / 1e9));
  }
}

}  // namespace

detailed_strands strands_in_detail(const strands& whole, std::span<const std::uint32_t> first_point,
                                   std::span<const placement> copies, std::span<const view> views,
                                   const detail_errors& errors) {
  detailed_strands found;
  found.fibres.same_opacity = whole.same_opacity;
  reduction one(whole, first_point, views, errors);
  const auto strand_count = static_cast<std::uint32_t>(first_point.size() - 1);
  std::uint64_t points = 0;
  for (std::size_t n = 0; n < copies.size(); ++n) {
    points += one.find(copies[n], static_cast<std::uint32_t>(n) * strand_count);
    check_room(points, n + 1, copies.size(), !errors.any());
    one.append(copies[n], found);
  }
  return found;
}

}  // namespace pelage::frame
