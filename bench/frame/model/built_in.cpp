// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/model/built_in.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "frame/base/random.hpp"

namespace pelage::frame {

namespace {

using glm::vec3;

constexpr float pi = 3.14159265F;

float smooth(float lower, float upper, float x) {
  const float t = std::clamp((x - lower) / (upper - lower), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

vec3 unit_or(vec3 v, vec3 otherwise) {
  const float squared = glm::dot(v, v);
  return squared > 1e-12F ? v / std::sqrt(squared) : otherwise;
}

// ---- the scalp
// ----------------------------------------------------------------------------------------------

constexpr const ellipsoid& cranium = bust[0];

/// The hair parts along this x on top of the head, from the forehead back to the whorl.
constexpr float parting_x = 0.24F;
constexpr float parting_front_z = 0.80F;
constexpr float whorl_z = -0.34F;

/// Height of the hairline on the cranium's unit sphere, for the azimuth from the face in [0, π].
float hairline(float azimuth) {
  const float to_temple = smooth(0.45F, 1.05F, azimuth);
  const float to_ear = smooth(1.05F, 1.60F, azimuth);
  const float to_nape = smooth(1.75F, 2.60F, azimuth);
  return 0.60F - 0.22F * to_temple - 0.42F * to_ear - 0.50F * to_nape;
}

/// A point of the cranium's unit sphere in the scalp, which ends in a fringe rather than in a line.
vec3 random_root(random_stream& random) {
  for (int attempt = 0; attempt < 64; ++attempt) {
    const float y = random.between(-0.75F, 1.0F);
    const float angle = random.between(-pi, pi);
    const float fringe = random.unit();
    const float radius = std::sqrt(1.0F - y * y);
    const vec3 n(radius * std::sin(angle), y, radius * std::cos(angle));
    if (y > hairline(std::abs(angle)) + 0.07F * fringe * fringe) return n;
  }
  return {0.0F, 1.0F, 0.0F};
}

vec3 on_scalp(vec3 n) {
  return cranium.centre + cranium.radii * n;
}

// ---- growth
// -------------------------------------------------------------------------------------------------

/// The body that hair slides over: the bust, and a zone before the face that hair is combed out of.
constexpr int obstacle_count = bust_parts + 1;
constexpr ellipsoid face_zone{{0.0F, -0.30F, 0.78F}, {0.50F, 0.92F, 0.62F}};
constexpr float bust_margin = 0.012F;

/// Moves p out of every part of the bust by `lift` (a length), and out of the face zone by `combed` in [0,
/// 1].
vec3 pushed_out(vec3 p, float lift, float combed) {
  for (int pass = 0; pass < 4; ++pass) {
    bool moved = false;
    for (int i = 0; i < obstacle_count; ++i) {
      const bool is_face = i == bust_parts;
      if (is_face && combed <= 0.0F) continue;
      const ellipsoid& part = is_face ? face_zone : bust[static_cast<std::size_t>(i)];
      const vec3 radii = is_face ? part.radii * combed : part.radii + lift;
      const vec3 q = (p - part.centre) / radii;
      const float squared = glm::dot(q, q);
      if (squared >= 1.0F) continue;
      const vec3 out = unit_or(q, vec3(0.0F, 1.0F, 0.0F)) * radii;
      p = part.centre + out;
      moved = true;
    }
    if (!moved) break;
  }
  return p;
}

/// What a strand does on its way down, apart from where it starts.
struct habit {
  float lift;       ///< the layer of hair it lies in: its distance from the body
  float stiffness;  ///< [0, 1): how slowly it turns
  float lean;       ///< sideways, x
  float sweep;      ///< back from the face, -z
  float cut_y;      ///< it ends at this height
  float longest;    ///< or at this length
};

constexpr float step = 0.05F;
constexpr int most_steps = 88;

/// A strand before it is waved: points at equal steps of length.
struct path {
  std::array<vec3, most_steps + 1> points;
  int count = 0;

  [[nodiscard]] float length() const { return step * static_cast<float>(count - 1); }

  /// The point at a fraction t of the length, t in [0, 1].
  [[nodiscard]] vec3 at(float t) const {
    const float x = t * static_cast<float>(count - 1);
    const int i = std::min(static_cast<int>(x), count - 2);
    const float f = x - static_cast<float>(i);
    const vec3 a = points[static_cast<std::size_t>(i)];
    return a + (points[static_cast<std::size_t>(i) + 1] - a) * f;
  }
};

/// Where the hair is combed to at a root: away from the parting, or from the whorl behind it.
vec3 combing(vec3 root, vec3 normal) {
  const float side = root.x < parting_x ? -1.0F : 1.0F;
  const float parting_z = std::clamp(root.z, whorl_z, parting_front_z);
  const vec3 away(root.x - parting_x, 0.0F, root.z - parting_z);
  const vec3 direction = unit_or(away, vec3(side, 0.0F, 0.0F)) + vec3(0.0F, 0.0F, -0.45F * smooth(0.0F, 0.8F, root.z));
  return unit_or(direction - normal * glm::dot(direction, normal), vec3(side, 0.0F, 0.0F));
}

path grow(vec3 n, const habit& h) {
  path strand;
  const vec3 root = on_scalp(n) + unit_or(n / cranium.radii, n) * bust_margin;
  const vec3 normal = cranium.normal(root);
  vec3 p = root;
  vec3 direction = glm::normalize(combing(root, normal) + normal * 0.75F);
  strand.points[0] = p;
  strand.count = 1;

  const int steps = std::min(most_steps, static_cast<int>(h.longest / step));
  for (int i = 1; i <= steps; ++i) {
    const float s = step * static_cast<float>(i);
    const float hanging = smooth(0.2F, -0.5F, p.y);
    vec3 pull(h.lean * (1.0F - hanging), -0.55F - 0.6F * hanging, -h.sweep * (1.0F - hanging));
    pull.x -= 0.16F * hanging * p.x;
    pull.z -= 0.16F * hanging * (p.z + 0.1F);
    direction = unit_or(direction * (0.55F + 0.4F * h.stiffness) + pull * 0.28F, direction);

    const float lift = bust_margin + h.lift * smooth(0.0F, 0.45F, s);
    const vec3 next = pushed_out(p + direction * step, lift, smooth(0.05F, 0.5F, s));
    direction = unit_or(next - p, direction);
    p += direction * step;
    strand.points[static_cast<std::size_t>(i)] = p;
    strand.count = i + 1;
    if (p.y < h.cut_y && i >= 2) break;
  }
  return strand;
}

// ---- locks
// --------------------------------------------------------------------------------------------------

/// Hair falls in locks: the strands that start near one root bend to its path and share its waves and colour.
struct lock {
  vec3 n;
  path guide;
  habit ways;
  float gather;  ///< [0, 1]: how far its strands draw together at the tips
  float wave;    ///< amplitude of the waves
  float wave_length;
  float wave_phase;
  float curl;   ///< amplitude of the curl of the tips
  float shade;  ///< factor of the colour
};

constexpr std::size_t lock_count = 340;
constexpr std::uint64_t lock_stream = std::uint64_t{1} << 40U;

lock make_lock(std::uint64_t seed, std::size_t index) {
  random_stream random(seed, lock_stream + index);
  lock l;
  l.n = random_root(random);
  const float layer = random.unit();
  l.ways.lift = 0.02F + 0.15F * smooth(-0.5F, 1.0F, l.n.y) * (0.45F + 0.55F * layer);
  l.ways.stiffness = random.between(0.45F, 0.75F);
  l.ways.lean = 0.05F * random.bell();
  l.ways.sweep = 0.10F + 0.05F * random.bell();
  l.ways.cut_y = -1.46F + 0.08F * random.bell();
  l.ways.longest = step * static_cast<float>(most_steps);
  l.gather = random.between(0.50F, 0.90F);
  l.wave = random.between(0.025F, 0.060F);
  l.wave_length = random.between(0.55F, 0.85F);
  l.wave_phase = random.between(0.0F, 2.0F * pi);
  l.curl = random.between(0.02F, 0.08F);
  l.shade = std::exp(0.16F * random.bell());
  l.guide = grow(l.n, l.ways);
  return l;
}

std::vector<lock> make_locks(std::uint64_t seed) {
  std::vector<lock> locks(lock_count);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, lock_count), [&](const tbb::blocked_range<std::size_t>& r) {
    for (std::size_t i = r.begin(); i != r.end(); ++i)
      locks[i] = make_lock(seed, i);
  });
  return locks;
}

bool left_of_parting(vec3 n) {
  return cranium.centre.x + cranium.radii.x * n.x < parting_x;
}

/// The lock whose root is nearest, on the same side of the parting.
const lock& nearest_lock(const std::vector<lock>& locks, vec3 n) {
  const lock* nearest = &locks.front();
  float largest_cosine = -4.0F;
  const bool left = left_of_parting(n);
  for (const lock& l : locks) {
    const float other_side = left_of_parting(l.n) == left ? 0.0F : 2.0F;
    const float cosine = glm::dot(n, l.n) - other_side;
    if (cosine > largest_cosine) {
      largest_cosine = cosine;
      nearest = &l;
    }
  }
  return *nearest;
}

// ---- strands
// ------------------------------------------------------------------------------------------------

struct strand_place {
  std::size_t first;
  std::uint32_t points;
};

void make_strand(hair_model& model, const std::vector<lock>& locks, std::uint64_t seed, std::uint64_t index,
                 strand_place place) {
  random_stream random(seed, index);
  const vec3 n = random_root(random);
  const lock& l = nearest_lock(locks, n);
  const float flyaway = random.unit() < 0.03F ? random.between(0.2F, 1.0F) : 0.0F;

  habit h = l.ways;
  h.lift = std::max(0.0F, h.lift + 0.02F * random.bell()) + 0.03F * flyaway;
  h.stiffness = std::clamp(h.stiffness + 0.05F * random.bell() + 0.05F * flyaway, 0.0F, 0.95F);
  h.lean += 0.02F * random.bell() + 0.06F * flyaway * random.bell();
  h.sweep += 0.02F * random.bell() + 0.06F * flyaway * random.bell();
  h.cut_y += 0.07F * random.bell();
  const float layered = random.unit();
  h.cut_y += 0.55F * layered * layered * layered * layered;
  const path own = grow(n, h);

  const float apart = glm::length(own.at(1.0F) - l.guide.at(1.0F));
  const float gather = l.gather * random.between(0.7F, 1.0F) * (1.0F - flyaway) * smooth(0.7F, 0.3F, apart);
  const float wave = l.wave * random.between(0.8F, 1.2F);
  const float phase = l.wave_phase + 0.22F * random.bell();
  const float curl = l.curl * random.between(0.6F, 1.4F);
  const float curl_phase = l.wave_phase * 1.7F + 0.3F * random.bell();
  const float fuzz = 0.002F + 0.020F * flyaway;
  const float fuzz_phase = random.between(0.0F, 2.0F * pi);
  const float fuzz_length = random.between(0.25F, 0.6F);
  const float shade = l.shade * std::exp(0.10F * random.bell());
  const float length = own.length();
  const float reach = std::min(1.0F, length / l.guide.length());

  vec3 previous_side(1.0F, 0.0F, 0.0F);
  for (std::uint32_t i = 0; i < place.points; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(place.points - 1);
    const float s = t * length;
    vec3 p = own.at(t);
    const vec3 ahead = own.at(std::min(1.0F, t + 0.04F));
    const vec3 behind = own.at(std::max(0.0F, t - 0.04F));
    const vec3 along = unit_or(ahead - behind, vec3(0.0F, -1.0F, 0.0F));
    const vec3 side = unit_or(previous_side - along * glm::dot(previous_side, along), vec3(0.0F, 0.0F, 1.0F));
    previous_side = side;
    const vec3 up = glm::cross(along, side);

    p += (l.guide.at(t * reach) - p) * (gather * smooth(0.15F, 1.0F, t));

    const float grown = smooth(0.1F, 1.6F, s);
    const float turn = 2.0F * pi * s / l.wave_length + phase;
    p += (side * std::sin(turn) + up * (0.6F * std::cos(turn))) * (wave * grown);
    const float tip = smooth(0.6F, 1.0F, t);
    const float curl_turn = 2.0F * pi * s / (0.55F * l.wave_length) + curl_phase;
    p += (side * std::cos(curl_turn) + up * std::sin(curl_turn)) * (curl * tip);
    const float fuzz_turn = 2.0F * pi * s / fuzz_length + fuzz_phase;
    p += (side * std::sin(fuzz_turn) + up * std::cos(0.7F * fuzz_turn)) * (fuzz * smooth(0.0F, 0.8F, s));

    const std::size_t at = place.first + i;
    model.points[at] = pushed_out(p, bust_margin, 0.96F * smooth(0.05F, 0.5F, s));
    model.thickness[at] = 0.0013F * (1.0F - 0.6F * smooth(0.5F, 1.0F, t));
    model.colour[at] = model.default_colour * (shade * (0.8F + 0.5F * t));
  }
}

}  // namespace

hair_model make_built_in(std::uint32_t strands, std::uint32_t segments_per_strand, std::uint64_t seed) {
  if (segments_per_strand == 0) throw std::invalid_argument("a strand of the built-in hair has 1 segment or more");
  const std::uint64_t points_per_strand = std::uint64_t{segments_per_strand} + 1;
  if (strands > std::numeric_limits<std::uint32_t>::max() / points_per_strand) {
    throw std::length_error("the built-in hair would have more than 2^32 - 1 points");
  }
  hair_model model;
  if (strands == 0) return model;

  const auto per_strand = static_cast<std::uint32_t>(points_per_strand);
  const std::size_t points = std::size_t{strands} * per_strand;
  model.points.resize(points);
  model.thickness.resize(points);
  model.colour.resize(points);
  model.first_point.resize(std::size_t{strands} + 1);
  for (std::uint32_t s = 1; s <= strands; ++s)
    model.first_point[s] = s * per_strand;

  const std::vector<lock> locks = make_locks(seed);
  tbb::parallel_for(tbb::blocked_range<std::uint32_t>(0, strands, 64), [&](const tbb::blocked_range<std::uint32_t>& r) {
    for (std::uint32_t s = r.begin(); s != r.end(); ++s) {
      make_strand(model, locks, seed, s, {std::size_t{s} * per_strand, per_strand});
    }
  });
  return model;
}

}  // namespace pelage::frame
