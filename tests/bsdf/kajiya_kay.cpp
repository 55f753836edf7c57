// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/kajiya_kay.hpp>
#include <pelage/core/lanes.hpp>

#include "lane_bits.hpp"
#include "property.hpp"
#include "sweep.hpp"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <limits>

namespace pelage::test {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

struct lit_tangent {
  glm::dvec3 tangent, to_light, to_eye;
};

/// Calls see(lit_tangent) for directions all over the sphere, a third with the eye about the cone of mirrored light
/// and a third with the light about the tangent.
template <class See>
void for_each_lighting(See see) {
  for (int i = 0; i < 30'000; ++i) {
    const auto [a, b, c, d, e, f] = even_point<6>(i);
    const lit_tangent in{on_sphere(a, b), on_sphere(c, d), on_sphere(e, f)};
    see(in);
    const double near = on_log_scale(a, 1e-6, 1.0);
    const glm::dvec3 mirrored = in.to_light - 2.0 * glm::dot(in.to_light, in.tangent) * in.tangent;
    see(lit_tangent{in.tangent, in.to_light, glm::normalize(mirrored + near * in.to_eye)});
    see(lit_tangent{in.tangent, glm::normalize(in.tangent + near * in.to_light), in.to_eye});
  }
}

kajiya_kay_lobes<float> lobes_of(const lit_tangent& in, float exponent) {
  return kajiya_kay(glm::vec3(in.tangent), glm::vec3(in.to_light), glm::vec3(in.to_eye), exponent);
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// The angle by which the eye lies off the cone of mirrored light: the tangent's angles with the two add up to 180°.
double off_the_mirror(const lit_tangent& in) {
  const double half_turn = 3.141592653589793;
  return half_turn - angle_between(in.tangent, in.to_light) - angle_between(in.tangent, in.to_eye);
}

TEST_CASE("the diffuse lobe is the sine of tangent and light within 4e-7") {
  worst_case worst;
  for_each_lighting([&](const lit_tangent& in) {
    const double sine = std::sin(angle_between(in.tangent, in.to_light));
    worst.see(std::abs(lobes_of(in, 1.0f).diffuse - sine), {sine});
  });
  CHECK_MESSAGE(worst.error < 4e-7, worst);
}

TEST_CASE("the specular lobe is the power of the angles' cosine within 4e-7 (1 + p)") {
  worst_case worst;
  for (const double exponent : {1.0, 2.0, 10.0, 100.0, 1000.0, 10000.0}) {
    for_each_lighting([&](const lit_tangent& in) {
      const double cosine = std::cos(off_the_mirror(in));
      const double specular = cosine > 0.0 ? std::pow(cosine, exponent) : 0.0;
      worst.see(std::abs(lobes_of(in, static_cast<float>(exponent)).specular - specular) / (1.0 + exponent),
                {exponent, cosine});
    });
  }
  CHECK_MESSAGE(worst.error < 4e-7, worst);
}

TEST_CASE("no eye sees more than the one on the cone of mirrored light, which sees 1") {
  worst_case worst;
  int brighter = 0;
  for_each_lighting([&](const lit_tangent& in) {
    lit_tangent mirrored = in;
    mirrored.to_eye = in.to_light - 2.0 * glm::dot(in.to_light, in.tangent) * in.tangent;
    worst.see(std::abs(lobes_of(mirrored, 100.0f).specular - 1.0), {});
    brighter += lobes_of(in, 100.0f).specular > 1.0f;
  });
  CHECK_MESSAGE(worst.error < 1e-4, worst);
  CHECK(brighter == 0);
}

TEST_CASE("an exponent of 0 lights all of the mirror's side alike, and nothing beyond 90 degrees of it") {
  int wrong = 0;
  for_each_lighting([&](const lit_tangent& in) {
    const double cosine = std::cos(off_the_mirror(in));
    const float specular = lobes_of(in, 0.0f).specular;
    if (cosine > 1e-6) wrong += specular != 1.0f;
    if (cosine < -1e-6) wrong += specular != 0.0f;
  });
  CHECK(wrong == 0);
}

TEST_CASE("beyond 90 degrees off the mirror the specular lobe is 0, not NaN") {
  int wrong = 0;
  for_each_lighting([&](const lit_tangent& in) {
    if (std::cos(off_the_mirror(in)) < -1e-6) wrong += lobes_of(in, 0.5f).specular != 0.0f;
  });
  CHECK(wrong == 0);
}

TEST_CASE("neither the tangent's sign nor which of light and eye is which matters to the highlight") {
  int wrong = 0;
  for_each_lighting([&](const lit_tangent& in) {
    const float specular = lobes_of(in, 30.0f).specular;
    wrong += lobes_of(lit_tangent{-in.tangent, in.to_light, in.to_eye}, 30.0f).specular != specular;
    wrong += lobes_of(lit_tangent{in.tangent, in.to_eye, in.to_light}, 30.0f).specular != specular;
  });
  CHECK(wrong == 0);
}

TEST_CASE("both lobes stay in [0, 1] for vectors off unit length") {
  int outside = 0;
  for_each_lighting([&](const lit_tangent& in) {
    const lit_tangent longer{1.3 * in.tangent, 0.7 * in.to_light, 5.0 * in.to_eye};
    const kajiya_kay_lobes lobes = lobes_of(longer, 3.0f);
    outside += !(lobes.diffuse >= 0.0f && lobes.diffuse <= 1.0f && lobes.specular >= 0.0f && lobes.specular <= 1.0f);
  });
  CHECK(outside == 0);
}

TEST_CASE("a NaN or zero vector gives no light") {
  const glm::vec3 tangent(1.0f, 0.0f, 0.0f);
  const glm::vec3 out(0.0f, 0.0f, 1.0f);
  for (const glm::vec3& bad : {glm::vec3(nan), glm::vec3(0.0f)}) {
    CHECK(kajiya_kay(bad, out, out, 10.0f).diffuse == 0.0f);
    CHECK(kajiya_kay(bad, out, out, 10.0f).specular == 0.0f);
    CHECK(kajiya_kay(tangent, bad, out, 10.0f).diffuse == 0.0f);
    CHECK(kajiya_kay(tangent, bad, out, 10.0f).specular == 0.0f);
    CHECK(kajiya_kay(tangent, out, bad, 10.0f).specular == 0.0f);
  }
}

TEST_CASE("lobes of lanes are those of single fibres, bit for bit") {
  const auto at_every_width = [](float exponent) {
    return same_bits_at_every_width(floats_in(-1.0f, 1.0f), [exponent](auto x, auto y) {
      using vector = glm::vec<3, decltype(x), glm::defaultp>;
      const vector tangent = unit_vector(vector(x, y, x * y));
      const vector to_light = unit_vector(vector(y, x + y, x));
      const vector to_eye = unit_vector(vector(x - y, y, y));
      const auto lobes = kajiya_kay(tangent, to_light, to_eye, decltype(x)(exponent));
      return lobes.diffuse + decltype(x)(3.0f) * lobes.specular;
    });
  };
  for (const float exponent : {0.0f, 1.0f, 60.0f})
    CHECK(at_every_width(exponent));
}

}  // namespace pelage::test
