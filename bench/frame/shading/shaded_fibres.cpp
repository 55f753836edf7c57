// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shading/shaded_fibres.hpp"

#include <pelage/core/lane_moves.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "frame/raster/occluder.hpp"

namespace pelage::frame {
namespace {

constexpr std::uint32_t most_intervals = 64;
constexpr std::uint64_t most_places = 0x7fffffffU / 3;  ///< whose members a signed index numbers
constexpr std::uint32_t block = 512;                    ///< segments that one task shades

}  // namespace

shaded_fibres::shaded_fibres(const scene& world, const raster& from, std::span<const float> limit, float spacing)
    : world_(world), from_(from) {
  if (spacing == 0.0F) return;
  const strands& fibres = from_.fibres();
  const std::uint32_t segments = fibres.segment_count();
  const occluder hidden(from_, limit);
  first_.assign(fibres.point.size() + 1, 0);
  tbb::parallel_for(0U, segments, [&](std::uint32_t s) {
    const pixel_rect bounds = from_.bounds(s);
    const bool empty = bounds.x0 >= bounds.x1 || bounds.y0 >= bounds.y1;
    if (!empty && !hidden.hides(s, bounds)) first_[fibres.segment[s]] = intervals(s, spacing);
  });
  std::uint64_t next = 0;
  std::uint32_t before = 0;  // intervals of the segment that ends here
  for (std::uint32_t& first : first_) {
    const std::uint32_t after = std::exchange(first, static_cast<std::uint32_t>(next));
    next += after == 0 && before > 0 ? 1 : after;
    before = after;
  }
  if (next > most_places) throw std::runtime_error("the model has too many places to shade: raise --shading-spacing");
  place_.resize(next);
  tbb::parallel_for(0U, (segments + block - 1) / block,
                    [&](std::uint32_t b) { shade(b * block, std::min((b + 1) * block, segments)); });
}

void shaded_fibres::shade(std::uint32_t begin, std::uint32_t end) {
  std::vector<lit_place> asked;
  std::uint32_t first = 0;
  for_each_place(begin, end, [&](std::uint32_t place, std::uint32_t segment, float along) {
    if (asked.empty()) first = place;
    asked.push_back(place_on(segment, along));
  });
  world_.fibre_radiance(asked, std::span(place_).subspan(first, asked.size()));
}

template <class Visit>
void shaded_fibres::for_each_place(std::uint32_t begin, std::uint32_t end, Visit&& visit) const {
  const strands& fibres = from_.fibres();
  for (std::uint32_t s = begin; s < end; ++s) {
    const std::uint32_t point = fibres.segment[s];
    const std::uint32_t first = first_[point];
    const std::uint32_t count = first_[point + 1] - first;
    for (std::uint32_t i = 0; i < count; ++i)
      visit(first + i, s, static_cast<float>(i) / static_cast<float>(count));
    const bool ends = (fibres.end_of[point + 1] & strands::last) != 0;
    if (ends && first_[point + 2] > first_[point + 1]) visit(first + count, s, 1.0F);
  }
}

std::uint32_t shaded_fibres::intervals(std::uint32_t segment, float spacing) const {
  const float count = std::ceil(from_.length_on_screen(segment) / spacing);
  return count > 1.0F ? static_cast<std::uint32_t>(std::min(count, static_cast<float>(most_intervals))) : 1;
}

lit_place shaded_fibres::place_on(std::uint32_t segment, float along) const {
  const view& eye = from_.from();
  const glm::vec3 way = eye.eye - world_.fibres.mix(world_.fibres.point, segment, along);
  const float length2 = glm::dot(way, way);
  const bool has_direction = eye.perspective && length2 > 0.0F;
  return {segment, along,
          has_direction ? way / std::sqrt(length2) : eye.direction_to_world(glm::vec3(0.0F, 0.0F, 1.0F))};
}

glm::vec3 shaded_fibres::at(std::uint32_t segment, float along) const {
  if (first_.empty()) {
    const lit_place alone = place_on(segment, along);
    return world_.fibre_radiance(segment, along, alone.to_eye);
  }
  const std::uint32_t point = from_.fibres().segment[segment];
  const std::uint32_t first = first_[point];
  const std::uint32_t count = first_[point + 1] - first;
  const float position = along * static_cast<float>(count);
  const std::uint32_t before = std::min(static_cast<std::uint32_t>(position), count - 1);
  return glm::mix(place_[first + before], place_[first + before + 1], position - static_cast<float>(before));
}

lane_vector<fragment_lanes::width> shaded_fibres::at(const fragment_lanes& all) const {
  using pack = fragment_lanes::pack;
  using integers = fragment_lanes::integers;
  if (first_.empty()) {
    lane_vector<fragment_lanes::width> found;
    for (int k = 0; k < fragment_lanes::width; ++k) {
      const glm::vec3 one = at(static_cast<std::uint32_t>(all.id[k]), all.along.lane[k]);
      found.x.lane[k] = one.x;
      found.y.lane[k] = one.y;
      found.z.lane[k] = one.z;
    }
    return found;
  }
  const auto look_up = [](std::span<const std::uint32_t> table, integers at) {
    return reinterpret_cast<integers>(
        gathered<fragment_lanes::width>(reinterpret_cast<const float*>(table.data()), at).lane);
  };
  const integers point = look_up(from_.fibres().segment, all.id);
  const integers first = look_up(first_, point);
  const integers count = look_up(first_, point + 1) - first;
  const pack position = all.along * pack(__builtin_convertvector(count, pack::vector));
  const integers whole = __builtin_convertvector(position.lane, integers);
  const integers before = whole < count - 1 ? whole : count - 1;
  const pack after_share = position - pack(__builtin_convertvector(before, pack::vector));
  const pack before_share = pack(1.0F) - after_share;
  const integers member = (first + before) * 3;
  const float* const radiance = &place_.data()->x;
  const auto mixed = [&](int channel) {
    return gathered<fragment_lanes::width>(radiance, member + channel) * before_share +
           gathered<fragment_lanes::width>(radiance, member + (channel + 3)) * after_share;
  };
  return {mixed(0), mixed(1), mixed(2)};
}

std::size_t shaded_fibres::bytes() const {
  return first_.capacity() * sizeof(std::uint32_t) + place_.capacity() * sizeof(glm::vec3);
}

}  // namespace pelage::frame
