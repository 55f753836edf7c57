// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// Prints a hash of what the float kernels give over many inputs: the same under whatever flags this is compiled with.
// Exits 1 where a kernel gives other bits at another call, or a pack other bits than the scalar kernel.
#include <pelage/bsdf/chiang_batch.hpp>
#include <pelage/bsdf/chiang_quad.hpp>
#include <pelage/bsdf/dual_scattering.hpp>
#include <pelage/bsdf/kajiya_kay_highlights.hpp>
#include <pelage/bsdf/marschner.hpp>
#include <pelage/composite/order_weighted.hpp>
#include <pelage/composite/over.hpp>
#include <pelage/composite/power_moments.hpp>
#include <pelage/composite/radiance.hpp>
#include <pelage/composite/tail_lanes.hpp>
#include <pelage/composite/trigonometric_moments.hpp>
#include <pelage/composite/weighted_blended.hpp>
#include <pelage/core/exact_begin.hpp>  // for the sums and products below, too
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/curve_basis.hpp>
#include <pelage/coverage/disc_strip.hpp>
#include <pelage/coverage/flatten_curve.hpp>
#include <pelage/coverage/joint.hpp>
#include <pelage/coverage/line_width.hpp>
#include <pelage/coverage/segment_quad.hpp>
#include <pelage/visibility/depth_range.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <initializer_list>
#include <span>
#include <vector>

using namespace pelage;

namespace {

class draws {
 public:
  float operator()(float low, float high) {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    const auto top = static_cast<std::uint32_t>(state_ >> 40u);
    return low + static_cast<float>(top) * (1.0f / 16777216.0f) * (high - low);
  }
  glm::vec3 point(float size) {
    const float x = (*this)(-size, size);
    const float y = (*this)(-size, size);
    return {x, y, (*this)(-size, size)};
  }
  glm::vec3 direction() { return unit_vector(point(1.0f) + glm::vec3(0.0f, 0.0f, 2.0f)); }

 private:
  std::uint64_t state_ = 88172645463325252u;
};

/// The results of one kernel, in order.
using results = std::vector<float>;

void put(results& out, std::initializer_list<float> numbers) {
  out.insert(out.end(), numbers);
}
void put(results& out, const glm::vec3& v) {
  put(out, {v.x, v.y, v.z});
}
void put(results& out, std::span<const float> numbers) {
  out.insert(out.end(), numbers.begin(), numbers.end());
}

bool same_bits(const results& a, const results& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
}

/// All kernels of one input. Called as it is and inlined into a loop: two places that a compiler may treat differently.
[[gnu::always_inline]] inline void evaluate(draws& draw, results& out) {
  const glm::vec3 a = draw.point(3.0f);
  const glm::vec3 b = draw.point(3.0f);
  const glm::vec3 c = draw.point(3.0f) - glm::vec3(0.0f, 0.0f, 9.0f);
  const glm::vec3 d = draw.point(3.0f) - glm::vec3(0.0f, 0.0f, 9.0f);
  const float radius = draw(0.0f, 0.3f);
  const float unit = draw(0.0f, 1.0f);
  put(out, cross_product(a, a));
  put(out, {dot_product(a, b), vector_length(a), exponential(a.x), one_minus_exponential(unit),
            natural_logarithm(unit + 1e-6f), unsigned_angle(a.y, a.x), angle_of_sine(unit),
            rotation_by(10.0f * b.x).sine, power_of_cosine(unit, 30.0f * radius)});
  const auto pair = closest_points(a, b, c, d);
  put(out, {pair.along_ray, pair.along_segment, pair.distance, disc_strip_share(unit, radius, 0.5f),
            offset_across(a, b, c, d, pair, 4.0f)});
  const strand_joint<float> first{{a.x, a.y}, {b.x, b.y}};
  const strand_joint<float> second{{c.x, c.y}, {d.x, d.y}};
  put(out, {past_joint(first, {d.x, c.y}), owned_by_segment(first, second, {d.x, c.y}),
            line_width_share(glm::vec2(a.x, a.y), radius, 0.5f), mean_line_width_share(radius, 0.5f)});
  for (const glm::vec3& corner : expand_segment(c, d, radius, perspective_cone(0.3f, 640), 0.1f, 2.0f).corner)
    put(out, corner);
  for (const curve_basis basis : {curve_basis::bezier, curve_basis::b_spline, curve_basis::catmull_rom}) {
    const segment_vertices whole = vertices_of_segment(basis, curve_wrap::nonperiodic, 4u, 0u);
    const auto curve = bezier_of(
        basis, whole, std::array{glm::vec4(a, unit), glm::vec4(b, radius), glm::vec4(c, 1.0f), glm::vec4(d, unit)});
    const std::uint32_t pieces = pieces_within(curve, 0.01f + 0.1f * unit, radius);
    put(out, glm::vec3(point_of_piece(curve, pieces / 3u, pieces)));
    put(out, {static_cast<float>(pieces), piece_error(curve, pieces), radius_piece_error(curve, pieces),
              greatest_piece_length(unit, radius), error_on_screen(curve, 0.01f, 0.1f)});
  }

  const glm::vec3 tangent = draw.direction();
  const glm::vec3 light = draw.direction();
  const glm::vec3 eye = draw.direction();
  const auto lobes = kajiya_kay(tangent, light, eye, 40.0f * unit);
  const auto shifted = kajiya_kay_double(tangent, light, eye, {80.0f, 0.1f}, {20.0f, -0.15f});
  put(out, {lobes.diffuse, lobes.specular, shifted.primary, shifted.secondary});
  const auto fibre = make_chiang_fibre<float>({1.55f, {unit, 0.3f, radius}, 0.1f + 0.8f * unit, 0.3f, -0.035f});
  const auto view = view_chiang(fibre, 2.0f * unit - 1.0f, fibre_direction_of(eye));
  const auto seen = evaluate_chiang(fibre, view, fibre_direction_of(light));
  const auto sampled = sample_chiang(fibre, view, {unit, radius, 0.4f, 0.7f});
  put(out, seen.value);
  put(out, sampled.direction);
  put(out, {seen.density, sampled.result.density});
  const auto quad = make_chiang_quad_fibre(fibre);
  put(out,
      evaluate_chiang(quad, view_chiang(quad, 2.0f * unit - 1.0f, fibre_direction_of(eye)), fibre_direction_of(light))
          .value);
  put(out,
      evaluate_marschner(common_marschner_parameters<float>({unit, 0.3f, radius}), a.x / 3.0f, b.x / 3.0f, c.x, 0.0f)
          .scattering);

  const tail behind = add_fragment(add_fragment(empty_tail(), unit, glm::abs(a)), radius, glm::abs(b));
  put(out, mean_colour(behind));
  put(out, {transmittance_of(behind), order_weight(unit, 9.0f * radius), distance_weight(unit, radius, 6.0f)});
  put(out, clamp_keeping_hue(1e4f * a));
  put(out,
      resolve(add_tail(add_fibre(empty_pixel<float>(), glm::abs(a), glm::vec3(unit), radius), behind), glm::abs(b)));
  put(out, glm::vec3(over(premultiply(a, unit), premultiply(b, radius))));
  auto powers = power_moments<6>::empty();
  auto angles = trigonometric_moments<3>::empty();
  for (const glm::vec3& each : {a, b, c, d}) {
    powers.add(glm::abs(each.x) / 3.0f, optical_depth(glm::abs(each.y) / 3.0f));
    angles.add(glm::abs(each.x) / 3.0f, optical_depth(glm::abs(each.y) / 3.0f));
  }
  put(out, {powers.visibility().amount_before(unit), angles.visibility().amount_before(unit)});
  depth_range range = depth_range::empty();
  range.extend(-c.z);
  range.extend(-d.z);
  put(out, {range.relative(9.0f + a.z), detail::dual_lobe(a.x, radius, unit, 0.5f)});
}

[[gnu::noinline]] void evaluate_apart(draws& draw, results& out) {
  evaluate(draw, out);
}

/// The kernels that run on packs, beside their scalar results.
template <int W>
bool packs_agree(draws& draw) {
  constexpr std::size_t n = W;
  std::array<std::array<float, n>, 12> in;
  for (std::array<float, n>& each : in) {
    for (float& x : each)
      x = draw(-1.0f, 1.0f);
  }
  const auto number = [&](std::size_t i) { return lanes<W>::load(in[i].data()); };
  const auto vector = [&](std::size_t i) { return lane_vector<W>(number(i), number(i + 1), number(i + 2)); };
  const auto one = [&](std::size_t i, std::size_t k) { return glm::vec3(in[i][k], in[i + 1][k], in[i + 2][k]); };
  results packed;
  results single;
  const auto keep = [&](const lanes<W>& x) {
    float all[n];
    x.store(all);
    put(packed, all);
  };
  const auto pair = closest_points(vector(0), vector(3), vector(6), vector(9));
  keep(pair.along_ray);
  keep(pair.distance);
  keep(disc_strip_share(number(0), number(1), number(2)));
  keep(offset_across(vector(0), vector(3), vector(6), vector(9), pair, lanes<W>(4.0f)));
  keep(kajiya_kay(vector(0), vector(3), vector(6), lanes<W>(8.0f)).specular);
  for (std::size_t k = 0; k < n; ++k)
    put(single, {closest_points(one(0, k), one(3, k), one(6, k), one(9, k)).along_ray});
  for (std::size_t k = 0; k < n; ++k)
    put(single, {closest_points(one(0, k), one(3, k), one(6, k), one(9, k)).distance});
  for (std::size_t k = 0; k < n; ++k)
    put(single, {disc_strip_share(in[0][k], in[1][k], in[2][k])});
  for (std::size_t k = 0; k < n; ++k) {
    const auto alone = closest_points(one(0, k), one(3, k), one(6, k), one(9, k));
    put(single, {offset_across(one(0, k), one(3, k), one(6, k), one(9, k), alone, 4.0f)});
  }
  for (std::size_t k = 0; k < n; ++k)
    put(single, {kajiya_kay(one(0, k), one(3, k), one(6, k), 8.0f).specular});

  std::array<std::array<float, n>, 6> unit;
  std::array<std::array<float, n>, 4> out;
  for (std::size_t k = 0; k < n; ++k) {
    const glm::vec3 eye = draw.direction();
    const glm::vec3 light = draw.direction();
    for (int i = 0; i < 3; ++i) {
      unit[static_cast<std::size_t>(i)][k] = eye[i];
      unit[static_cast<std::size_t>(i + 3)][k] = light[i];
    }
  }
  const auto fibre = make_chiang_fibre<float>({1.55f, {0.2f, 0.4f, 0.9f}, 0.3f, 0.25f, -0.035f});
  evaluate_chiang_batch<W>(fibre, {in[0], {unit[0], unit[1], unit[2]}, {unit[3], unit[4], unit[5]}},
                           {{out[0], out[1], out[2]}, out[3]});
  for (const std::array<float, n>& each : out)
    put(packed, each);
  std::array<std::array<float, n>, 4> expected;
  for (std::size_t k = 0; k < n; ++k) {
    const auto seen = evaluate_chiang(
        fibre, view_chiang(fibre, in[0][k], fibre_direction_of(glm::vec3(unit[0][k], unit[1][k], unit[2][k]))),
        fibre_direction_of(glm::vec3(unit[3][k], unit[4][k], unit[5][k])));
    for (std::size_t c = 0; c < 3; ++c)
      expected[c][k] = seen.value[static_cast<int>(c)];
    expected[3][k] = seen.density;
  }
  for (const std::array<float, n>& each : expected)
    put(single, each);

  std::array<tail, 3> behind;
  behind.fill(empty_tail());
  std::array<tail, 3> alone = behind;
  std::array<std::uint32_t, n> place;
  for (std::size_t k = 0; k < n; ++k) {
    place[k] = static_cast<std::uint32_t>(k % 3);
    alone[place[k]] = add_fragment(alone[place[k]], in[0][k], one(1, k));
  }
  add_fragments(number(0), vector(1), all_bits<W>(), place, std::span<tail>(behind));
  return same_bits(packed, single) && std::memcmp(behind.data(), alone.data(), sizeof(behind)) == 0;
}

}  // namespace

int main() {
  std::uint64_t hash = 14695981039346656037u;
  draws here;
  draws there;
  int wrong = 0;
  for (int i = 0; i < 20000; ++i) {
    results inlined;
    results apart;
    evaluate(here, inlined);
    evaluate_apart(there, apart);
    wrong += same_bits(inlined, apart) ? 0 : 1;
    wrong += inlined[0] == 0.0f && inlined[1] == 0.0f && inlined[2] == 0.0f ? 0 : 1;  // a × a
    for (const float x : inlined)
      hash = (hash ^ std::bit_cast<std::uint32_t>(x)) * 1099511628211u;
  }
  for (int i = 0; i < 4000; ++i)
    wrong += (packs_agree<4>(here) ? 0 : 1) + (packs_agree<lane_width()>(here) ? 0 : 1);
  std::printf("%016llx\n", static_cast<unsigned long long>(hash));
  if (wrong > 0) std::fprintf(stderr, "%d draws have other bits in a pack or at another call\n", wrong);
  return wrong == 0 ? 0 : 1;
}
