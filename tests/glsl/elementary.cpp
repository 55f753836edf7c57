// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/azimuthal.hpp>
#include <pelage/bsdf/bessel.hpp>
#include <pelage/bsdf/fresnel.hpp>
#include <pelage/bsdf/hair_parameters.hpp>
#include <pelage/bsdf/interface.hpp>
#include <pelage/bsdf/kajiya_kay_highlights.hpp>
#include <pelage/bsdf/longitudinal.hpp>
#include <pelage/core/vector_math.hpp>

#include <bit>
#include <cmath>

#include "glsl/double_comparison.hpp"
#include "glsl/kernels.hpp"
#include "property.hpp"

namespace pelage::test {

using words = rc::Gen<std::uint32_t>;

TEST_CASE("Elementary functions keep their stated errors on every device") {
  const words part = between(-10.0F, 10.0F);
  holds("elementary", [&] {
    compare_with_double(
        kernels::elementary,
        {between(-87.0F, 88.0F), magnitude(-100, 6), magnitude(-126, 127), between(0.01F, 1.0F), between(0.0F, 8.0F),
         rc::gen::oneOf(part, magnitude(-30, 30)), part, between(-1.0F, 1.0F), between(-100.0F, 100.0F),
         magnitude(-20, 16), part, part, part, part, part, between(1.1F, 3.0F)},
        [](row in, row, wanted& out) {
          out.put(std::exp(in.d(0)));
          out.put(std::expm1(in.d(0) / 256.0));
          out.put(-std::expm1(-in.d(1)));
          out.put(std::log(in.d(2)));
          out.put(std::pow(in.d(3), in.d(4)));
          out.put(std::atan2(std::abs(in.d(5)), in.d(6)));
          out.put(std::atan2(in.d(5), in.d(6)));
          out.put(std::asin(in.d(7)));
          out.put(std::cos(in.d(8)));
          out.put(std::sin(in.d(8)));
          const bessel_i0_parts<double> bessel = bessel_i0(in.d(9));
          out.put(bessel.value * std::exp(bessel.growth - (in.d(9) < 6.0 ? 0.0 : in.d(9))));
          out.put(log_bessel_i0(in.d(9)));
          const interface_shares<double> surface = dielectric_interface(in.d(3), in.d(15));
          out.put(surface.reflected);
          out.put(surface.transmitted);
          const auto inclined = bravais_interface(in.d(3), std::abs(in.d(7)), in.d(15), 1.25 * in.d(15));
          out.put(inclined.reflected);
          out.put(inclined.transmitted);
          out.put(fresnel_dielectric(in.d(3), in.d(15)));
          const glm::dvec3 a = in.d3(9);
          const glm::dvec3 b = in.d3(12);
          out.put(dot_product(a, b));
          out.put(cross_product(a, b));
          out.put(0.0);
          out.put(vector_length(b));
          out.put(unit_vector(b));
        },
        {{"exponential", 1, 5e-7},
         {"small_exponential", 1, 5e-7},
         {"one_minus_exponential", 1, 5e-7},
         {"natural_logarithm", 1, 2e-7, 1.0},
         {"power_of_share", 1, 6e-6},
         {"unsigned_angle", 1, 5e-7},
         {"angle_of", 1, 5e-7},
         {"angle_of_sine", 1, 1e-6},
         {"rotation_by", 2, 2e-7, 1.0},
         {"bessel_i0", 1, 6e-7},
         {"log_bessel_i0", 1, 1.5e-6},
         {"dielectric_interface", 2, 2e-6, 1e-4},
         {"bravais_interface", 2, 2e-6, 1e-3},
         {"fresnel_dielectric", 1, 2e-6, 1e-4},
         {"dot_product", 1, 1e-6, 1e6},
         {"cross_product", 3, 1e-6, 1e6},
         {"cross_product of a vector with itself", 1, 0.0},
         {"vector_length", 1, 5e-7},
         {"unit_vector", 3, 5e-7, 1.0}});
  });
}

TEST_CASE("Elementary functions of zeros, infinities, NaN and anything else have the CPU's bits on lavapipe") {
  // A GPU's driver may take bounds for minima and maxima, which drop a NaN, and may divide by more than 2^126 to 0.
  const words number = rc::gen::map(any_normal_float(), [cpu = the_device()->is_cpu()](std::uint32_t w) {
    const float size = std::abs(std::bit_cast<float>(w));
    return cpu || size <= 0x1p126F || std::isinf(size) ? w : 0U;
  });
  holds("special values", [&] {
    compare(kernels::special_values, {any_normal_float(), number, number},
            [](row in, results& out) {
              const float x = in.f(0);
              const float u = in.f(1);
              const float v = in.f(2);
              out.put(absolute(x));
              out.put(least(u, v));
              out.put(greatest(u, v));
              out.put(exponential(u));
              out.put(one_minus_exponential(absolute(u)));
              out.put(natural_logarithm(x));
              out.put(rotation_by(x).cosine);
              out.put(rotation_by(x).sine);
              out.put(unsigned_angle(v, u));
              out.put(angle_of(v, u));
              out.put(angle_of_sine(u));
              const bessel_i0_parts<float> bessel = bessel_i0(absolute(u));
              out.put(bessel.value);
              out.put(bessel.growth);
            },
            {{"absolute", 1, 0, 0},
             {"least", 1, 0, 0},
             {"greatest", 1, 0, 0},
             {"exponential of anything", 1, 0, 0},
             {"one_minus_exponential of anything", 1, 0, 0},
             {"natural_logarithm of anything", 1, 0, 0},
             {"rotation_by of anything", 2, 0, 0},
             {"unsigned_angle of anything", 1, 0, 8},
             {"angle_of of anything", 1, 0, 8},
             {"angle_of_sine of anything", 1, 0, 8},
             {"bessel_i0 of anything", 2, 0, 8}});
  });
}

TEST_CASE("Lobes and their parameters are within 2e-5 of double on every device") {
  const words part = between(-1.0F, 1.0F);
  const words unit = between(0.0F, 1.0F);
  holds("lobes", [&] {
    compare_with_double(
        kernels::lobes,
        {between(0.08F, 1.0F), between(0.08F, 1.0F), between(0.01F, 0.9F), part, part, part, part,
         between(0.01F, 0.999F), unit, between(0.0F, 3.1415926F), between(0.0F, 8.0F), between(0.0F, 8.0F)},
        [](row in, row, wanted& out) {
          const double variance = longitudinal_variance(in.d(0));
          const double scale = azimuthal_scale(in.d(1));
          out.put(variance);
          out.put(scale);
          out.put(roughness_of_width(in.d(2)));
          const auto along = make_longitudinal_lobe(variance);
          out.put(along.height);
          const auto light = fibre_direction_of(in.d(3), in.d(5), in.d(6));
          const auto eye = fibre_direction_of(glm::dvec3(in.d(4), in.d(6), in.d(5)));
          out.put(light.cosine);
          out.put(evaluate_longitudinal(along, light.sine, light.cosine, eye.sine, eye.cosine));
          const rotation<double> inclination = sample_longitudinal(along, eye.sine, eye.cosine, in.d(7), in.d(8));
          out.put(inclination.cosine);
          out.put(inclination.sine);
          const auto around = make_azimuthal_lobe(scale);
          out.put(around.height);
          out.put(evaluate_azimuthal(around, in.d(9)));
          out.put(sample_azimuthal(around, in.d(7)));
          out.put(absorption_of(melanin<double>{in.d(10), in.d(11)}));
          const auto pigment = melanin_from_controls(in.d(7), in.d(8));
          out.put(pigment.eumelanin);
          out.put(pigment.pheomelanin);
          out.put(absorption_from_albedo(in.d(7), in.d(1)));
          out.put(albedo_from_absorption(in.d(10), in.d(1)));
          const auto brown = melanin_of<double>(hair_colour::brown);
          out.put(brown.eumelanin);
          out.put(brown.pheomelanin);
          out.put(sine_of_sum(light.sine, light.cosine, eye.sine, eye.cosine));
          out.put(2.0 * std::pow(std::sin(0.5 * in.d(9)), 2.0));
          out.put(light.y);
          out.put(light.z);
        },
        {{"longitudinal_variance", 1, 1e-6},
         {"azimuthal_scale", 1, 1e-6},
         {"roughness_of_width", 1, 1e-6},
         {"make_longitudinal_lobe", 1, 2e-6},
         {"fibre_direction_of", 1, 5e-7},
         {"evaluate_longitudinal", 1, 2e-5, 1e-6},
         {"sample_longitudinal", 2, 2e-5, 1.0},
         {"make_azimuthal_lobe", 1, 2e-6},
         {"evaluate_azimuthal", 1, 2e-5, 1e-6},
         {"sample_azimuthal", 1, 2e-6, 1.0},
         {"absorption_of", 3, 1e-6},
         {"melanin_from_controls", 2, 1e-6, 1.0},
         {"absorption_from_albedo", 1, 2e-6, 1e-3},
         {"albedo_from_absorption", 1, 2e-5, 1e-6},
         {"melanin_of", 2, 1e-7},
         {"sine_of_sum", 1, 1e-6, 1e-3},
         {"versine", 1, 1e-6},
         {"fibre_direction_of azimuth", 2, 0.0}});
  });
}

TEST_CASE("Double highlights have the CPU's bits on lavapipe and differ by the stated ulps on a GPU") {
  const auto part = between(-0.577F, 0.577F);
  const auto exponent = between(0.0F, 80.0F);
  const auto shift = between(-0.3F, 0.3F);
  holds("highlights", [&] {
    compare(kernels::highlights,
            {part, part, part, part, part, part, part, part, part, exponent, shift, exponent, shift},
            [](row in, results& out) {
              const double_highlight both =
                  kajiya_kay_double(in.v3(0), in.v3(3), in.v3(6), {in.f(9), in.f(10)}, {in.f(11), in.f(12)});
              out.put(both.primary);
              out.put(both.secondary);
              out.put(shifted_tangent(in.v3(0), in.v3(3), in.f(10)));
              out.put(normalised_fibre_diffuse(in.f(11)));
            },
            {{"kajiya_kay_double primary", 1, 0, 80, 0.01F},
             {"kajiya_kay_double secondary", 1, 0, 80, 0.01F},
             {"shifted_tangent", 3, 0, 4},
             {"normalised_fibre_diffuse", 1, 0, 0}});
  });
}

}  // namespace pelage::test
