// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/fresnel.hpp>
#include <pelage/bsdf/kajiya_kay.hpp>
#include <pelage/composite/divided_pixel.hpp>
#include <pelage/composite/over.hpp>
#include <pelage/composite/radiance.hpp>
#include <pelage/composite/sliced_tail.hpp>
#include <pelage/composite/tail.hpp>
#include <pelage/composite/transmittance.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/core/math.hpp>
#include <pelage/core/vector_math.hpp>
#include <pelage/coverage/chord_run.hpp>
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/disc_strip.hpp>
#include <pelage/coverage/joint.hpp>
#include <pelage/coverage/line_width.hpp>
#include <pelage/coverage/ray_cone.hpp>
#include <pelage/coverage/segment_quad.hpp>
#include <pelage/coverage/strand_share.hpp>

#include <cmath>

#include "glsl/comparison.hpp"
#include "glsl/kernels.hpp"
#include "property.hpp"

namespace pelage::test {

TEST_CASE("+, - and * are exact on every device, / and sqrt on lavapipe and within 3 ulp on a GPU") {
  const auto number = rc::gen::oneOf(magnitude(-30, 30), between(-100.0F, 100.0F));
  holds("arithmetic", [&] {
    compare(kernels::arithmetic, {number, number},
            [](row in, results& out) {
              out.put(in.f(0) + in.f(1));
              out.put(in.f(0) - in.f(1));
              out.put(in.f(0) * in.f(1));
              out.put(in.f(0) / in.f(1));
              out.put(std::sqrt(in.f(0)));
            },
            {{"a + b", 1, 0, 0}, {"a - b", 1, 0, 0}, {"a * b", 1, 0, 0}, {"a / b", 1, 0, 3}, {"sqrt(a)", 1, 0, 3}});
  });
}

TEST_CASE("The order of fragments and the polynomials of core have the same bits on every device") {
  const auto depth = rc::gen::oneOf(any_float(), few_words());
  const auto exponent = rc::gen::oneOf(between(-130.0F, 130.0F), any_float());
  holds("core", [&] {
    compare(kernels::core, {depth, few_words(), depth, few_words(), any_float(), exponent},
            [](row in, results& out) {
              const fragment a{in.f(0), in.u(1)};
              const fragment b{in.f(2), in.u(3)};
              out.put(is_fragment(a));
              out.put(before(a, b));
              out.put(same(a, b));
              out.put(depth_key(a.depth));
              out.put(depth_from_key(in.u(1)));
              out.put(saturate(in.f(0)));
              out.put(sqr(in.f(4)));
              out.put(safe_sqrt(in.f(4)));
              out.put(fast_log2(in.f(4)));
              out.put(fast_exp2(in.f(5)));
              out.put(power_of_cosine(saturate(in.f(4)), std::abs(in.f(5))));
              out.put(no_fragment().depth);
              out.put(no_fragment().id);
            },
            {{"is_fragment", 1, bits(), bits()},
             {"before", 1, bits(), bits()},
             {"same", 1, bits(), bits()},
             {"depth_key", 1, bits(), bits()},
             {"depth_from_key", 1, 0, 0},
             {"saturate", 1, 0, 0},
             {"sqr", 1, 0, 0},
             {"safe_sqrt", 1, 0, 3},
             {"fast_log2", 1, 0, 0},
             {"fast_exp2", 1, 0, 0},
             {"power_of_cosine", 1, 0, 0},
             {"no_fragment", 1, 0, 0},
             {"no_fragment id", 1, bits(), bits()}});
  });
}

TEST_CASE("Coverage agrees within the stated ulps") {
  const auto place = between(-4.0F, 4.0F);
  const auto ahead = between(-20.0F, -1.0F);
  const auto radius = magnitude(-12, 1);
  holds("coverage", [&] {
    compare(kernels::coverage,
            {place, place, place, place, place, ahead, place, place, ahead, place, place, ahead, radius, radius,
             between(0.0F, 2.5F), magnitude(-3, 1)},
            [](row in, results& out) {
              const closest_pair<float> pair = closest_points(in.v3(0), in.v3(3), in.v3(6), in.v3(9));
              out.put(pair.along_ray);
              out.put(pair.along_segment);
              out.put(pair.distance);
              out.put(offset_across(in.v3(0), in.v3(3), in.v3(6), in.v3(9), pair, 4.0F));
              const glm::vec2 extent(in.f(6), in.f(7));
              out.put(cap_share(in.f(14)));
              out.put(disc_strip_share(in.f(14), in.f(12), in.f(13)));
              out.put(diagonal_ratio(extent));
              out.put(line_width_share(extent, in.f(12), in.f(13)));
              const ray_cone<float> cone = perspective_cone(in.f(15), 1080, pixel_footprint::inscribed);
              const ray_cone<float> cylinder = orthographic_cone(in.f(15), 512, pixel_footprint::equal_area);
              out.put(cone.slope);
              out.put(cylinder.base);
              out.put(radius_at(cone, in.f(14)));
              out.put(reach_at(in.f(14), in.f(12), cone, 2.0F));
              out.put(any_normal(unit_vector(in.v3(3))));
              const segment_quad<float> quad = expand_segment(in.v3(6), in.v3(9), in.f(12), cone, 0.1F, 2.0F);
              out.put(quad.visible);
              for (const glm::vec3& corner : quad.corner)
                out.put(corner);
              out.put(cone.base);
              out.put(cylinder.slope);
              out.put(tangent_stretch(0.5F * in.f(14)));
              const strand_joint<float> first{{in.f(0), in.f(1)}, {in.f(3), in.f(4)}};
              const strand_joint<float> second{{in.f(6), in.f(7)}, {in.f(9), in.f(10)}};
              const glm::vec2 pixel(in.f(14), in.f(12));
              out.put(past_joint(first, pixel));
              out.put(owned_by_segment(first, second, pixel));
              out.put(mean_line_width_share(in.f(12), in.f(13)));
              const chord_run<float> begun = begin_chord(in.v3(6), in.f(12), 1.0F);
              const chord_run<float> run = pass_point(begun, in.v3(9), in.f(13), 0.5F, 0.25F);
              out.put(run.along);
              out.put(run.side);
              out.put(run.least_slope);
              out.put(run.greatest_slope);
              out.put(run.reach);
              out.put(chord_reaches(run, in.v3(9) + (in.v3(9) - in.v3(6)) + 0.25F * in.v3(3), in.f(13), 0.5F));
              out.put(screen_tolerance(in.f(12), -in.f(8), 2.0F, 300.0F, 1.25F));
              const float share = kept_share(in.f(12), in.f(13), 0.01F);
              out.put(share);
              out.put(width_factor(0.4F * in.f(14), share));
              out.put(strand_rank(in.u(12)));
            },
            {{"closest_points along_ray", 1, 0, 80, 1.0F},
             {"closest_points along_segment", 1, 0, 80, 1.0F},
             {"closest_points distance", 1, 0, 64, 4.0F},
             {"offset_across", 1, 0, 64, 1.0F},
             {"cap_share", 1, 0, 8},
             {"disc_strip_share", 1, 0, 64, 0.1F},
             {"diagonal_ratio", 1, 0, 4},
             {"line_width_share", 1, 0, 8},
             {"perspective_cone", 1, 0, 3},
             {"orthographic_cone", 1, 0, 3},
             {"radius_at", 1, 0, 4},
             {"reach_at", 1, 0, 4},
             {"any_normal", 3, 0, 16},
             {"expand_segment visible", 1, bits(), bits()},
             {"expand_segment corners", 12, 0, 80},
             {"perspective_cone base", 1, 0, 0},
             {"orthographic_cone slope", 1, 0, 0},
             {"tangent_stretch", 1, 0, 8},
             {"past_joint", 1, 0, 0},
             {"owned_by_segment", 1, 0, 0},
             {"mean_line_width_share", 1, 0, 8},
             {"pass_point along and side", 6, 0, 16},
             {"pass_point slopes", 6, 0, 64, 1.0F},
             {"pass_point reach", 1, 0, 8},
             {"chord_reaches", 1, bits(), bits()},
             {"screen_tolerance", 1, 0, 4},
             {"kept_share", 1, 0, 4},
             {"width_factor", 1, 0, 64, 1.0F},
             {"strand_rank", 1, 0, 0}});
  });
}

TEST_CASE("Tails have the same bits on every device, blending differs by the stated ulps") {
  const auto share = rc::gen::weightedOneOf<std::uint32_t>({{6, between(0.0F, 1.0F)}, {1, any_float()}});
  const auto unit = between(0.0F, 1.0F);
  holds("composite", [&] {
    compare(kernels::composite,
            {unit, unit, unit, share, unit, unit, unit, unit, any_word(), any_word(), any_word(), any_word()},
            [](row in, results& out) {
              const glm::vec3 colour = in.v3(0);
              const float alpha = in.f(3);
              const glm::vec4 back = in.v4(4);
              out.put(transmittance(colour, alpha));
              out.put(transmittance(colour.x, alpha));
              out.put(premultiply(colour, alpha));
              out.put(over(premultiply(colour, alpha), back));
              out.put(optical_depth(alpha));
              out.put(add_saturating(in.u(8), in.u(9)));
              out.put(transmittance_of(in.u(8)));
              tail t = empty_tail();
              t = add_fragment(t, alpha, colour);
              t = add_fragment(t, in.f(7), glm::vec3(back));
              t = merge(t, tail{in.u(8), in.u(9), in.u(10), in.u(11), 1U});
              out.put(t.optical);
              out.put(t.weight);
              out.put(t.red);
              out.put(t.green);
              out.put(t.blue);
              out.put(to_fixed(in.f(0)));
              out.put(transmittance_of(t));
              out.put(mean_colour(t));
              pixel_radiance<float> pixel = empty_pixel<float>();
              pixel = add_fibre(pixel, colour, glm::vec3(back), alpha);
              pixel = add_fibre(pixel, glm::vec3(back), colour, in.f(7));
              out.put(pixel.transmittance);
              out.put(resolve(pixel, colour));
              out.put(resolve(add_tail(add_fibre(empty_pixel<float>(), colour, glm::vec3(back), in.f(7)), t), colour));
              out.put(transmittance_of(in.f(8)));
              out.put(clamp_keeping_hue(glm::vec3(200.0F, 1.0F, in.f(9)) * colour));
              out.put(parting_depth(1.0F + colour.x, 1.0F + colour.y));
              divided_pixel<float> divided =
                  add_fibre(empty_divided_pixel<float>(), true, colour, glm::vec3(back), alpha);
              divided = add_fibre(divided, false, glm::vec3(back), colour, in.f(7));
              const divided_backdrop<float> backdrop{1.0F, alpha, alpha * colour, glm::vec3(back)};
              out.put(resolve(add_tails(divided, empty_tail(), t), backdrop));
              auto sliced = sliced_tail<16>::empty();
              sliced.add(16.0F * back.x, alpha, colour);
              auto rest = sliced_tail<16>::empty();
              rest.add(16.0F * back.y, in.f(7), glm::vec3(back));
              sliced.merge(rest);
              const tail slice = sliced.slice[layer_at(16.0F * back.x, 16U)];
              out.put(slice.optical);
              out.put(slice.weight);
              out.put(slice.red);
              out.put(slice.green);
              out.put(slice.blue);
              out.put(resolve(add_sliced_tail(empty_pixel<float>(), sliced), colour));
            },
            {{"transmittance", 3, 0, 0},
             {"transmittance, grey", 1, 0, 0},
             {"premultiply", 4, 0, 0},
             {"over", 4, 0, 0},
             {"optical_depth", 1, bits(), bits()},
             {"add_saturating", 1, bits(), bits()},
             {"transmittance_of", 1, 0, 0},
             {"add_fragment, merge", 5, bits(), bits()},
             {"to_fixed", 1, bits(), bits()},
             {"transmittance_of a tail", 1, 0, 0},
             {"mean_colour", 3, 0, 3},
             {"add_fibre", 3, 0, 0},
             {"resolve", 3, 0, 0},
             {"add_tail", 3, 0, 4},
             {"transmittance_of a float", 1, 0, 0},
             {"clamp_keeping_hue", 3, 0, 0},
             {"parting_depth", 1, 0, 4},
             {"divided pixel", 3, 0, 8, 1.0F},
             {"sliced_tail add, merge", 5, bits(), bits()},
             {"add_sliced_tail", 3, 0, 4}});
  });
}

TEST_CASE("Scattering agrees within the stated ulps") {
  const auto part = between(-0.577F, 0.577F);
  holds("bsdf", [&] {
    compare(kernels::bsdf,
            {part, part, part, part, part, part, part, part, part, between(0.0F, 1.5F), between(0.0F, 80.0F)},
            [](row in, results& out) {
              out.put(fresnel_dielectric(in.f(0), 1.0F + in.f(9)));
              out.put(fibre_attenuation(1.0F + in.f(9), in.f(0)));
              out.put(fibre_opacity(1.0F + in.f(9), in.f(0)));
              const kajiya_kay_lobes lobes = kajiya_kay(in.v3(0), in.v3(3), in.v3(6), in.f(10));
              out.put(lobes.diffuse);
              out.put(lobes.specular);
            },
            {{"fresnel_dielectric", 1, 0, 64, 0.01F},
             {"fibre_attenuation", 1, 0, 64, 0.01F},
             {"fibre_opacity", 1, 0, 64, 0.01F},
             {"kajiya_kay diffuse", 1, 0, 16},
             {"kajiya_kay specular", 1, 0, 80, 0.01F}});
  });
}

TEST_CASE("Without `precise` a GPU may differ; the table shows by how much") {
  const double any = std::numeric_limits<double>::infinity();
  holds("contraction", [&] {
    compare(kernels::contraction, {magnitude(-30, 30), between(-126.0F, 127.0F), between(0.0F, 1.0F)},
            [](row in, results& out) {
              out.put(fast_log2(in.f(0)));
              out.put(fast_exp2(in.f(1)));
              out.put(power_of_cosine(in.f(2), 20.0F));
              out.put(disc_strip_share(in.f(2), 0.01F, 0.5F));
              out.put(fresnel_dielectric(in.f(2), 1.55F));
            },
            {{"fast_log2, not precise", 1, any, any},
             {"fast_exp2, not precise", 1, any, any},
             {"power_of_cosine, not precise", 1, any, any},
             {"disc_strip_share, not precise", 1, any, any, 0.01F},
             {"fresnel_dielectric, not precise", 1, any, any, 0.01F}});
  });
}

TEST_CASE("The comparison finds a reference that is one bit off") {
  const rc::detail::TestMetadata nothing;
  const auto result = rc::detail::checkTestable(
      [] {
        compare(kernels::arithmetic, {between(1.0F, 2.0F), between(1.0F, 2.0F)},
                [](row in, results& out) {
                  out.put(std::nextafter(in.f(0) + in.f(1), 9.0F));
                  out.put(in.f(0) - in.f(1));
                  out.put(in.f(0) * in.f(1));
                  out.put(in.f(0) / in.f(1));
                  out.put(std::sqrt(in.f(0)));
                },
                {{"a + b, wrong", 1, 0, 0}, {"", 1, 3, 3}, {"", 1, 3, 3}, {"", 1, 3, 3}, {"", 1, 3, 3}});
      },
      nothing);
  CHECK(result.is<rc::detail::FailureResult>());
}

}  // namespace pelage::test
