// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/chiang.hpp>
#include <pelage/bsdf/fibre_hit.hpp>
#include <pelage/coverage/closest_points.hpp>

#include <glm/geometric.hpp>
#include <property.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace pelage;

namespace {

constexpr double pi = std::numbers::pi;

double number(double low, double high) {
  return low + (high - low) * *rc::gen::inRange(0, 1 << 20) / static_cast<double>(1 << 20);
}

glm::dvec3 any_direction() {
  const double z = number(-1.0, 1.0);
  const double angle = number(-pi, pi);
  const double across = std::sqrt(1.0 - z * z);
  return {across * std::cos(angle), across * std::sin(angle), z};
}

/// A hit made from what fibre_hit_of() is asked for.
struct made_hit {
  glm::dvec3 x, y, z;  ///< the frame, by Gram and Schmidt
  glm::dvec3 eye, normal, axis_point, hit;
  double gamma, theta, radius;
};

made_hit draw_hit(double steepest) {
  made_hit m;
  m.x = any_direction();
  const glm::dvec3 other = std::abs(m.x.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 first = glm::normalize(other - glm::dot(other, m.x) * m.x);
  const double turn = number(-pi, pi);
  m.y = std::cos(turn) * first + std::sin(turn) * glm::cross(m.x, first);
  m.z = glm::cross(m.x, m.y);
  m.theta = number(-steepest, steepest);
  m.gamma = number(-1.57, 1.57);
  m.radius = number(0.001, 2.0);
  m.eye = std::sin(m.theta) * m.x + std::cos(m.theta) * m.y;
  m.normal = std::cos(m.gamma) * m.y - std::sin(m.gamma) * m.z;
  m.axis_point = number(0.0, 2.0) * any_direction();
  m.hit = m.axis_point + m.radius * m.normal;
  return m;
}

template <class Real>
glm::vec<3, Real> rounded(const glm::dvec3& v) {
  return glm::vec<3, Real>(v);
}

template <class Real>
void check_made_hits(double tolerance) {
  const made_hit m = draw_hit(1.5);
  const auto scale = static_cast<Real>(number(0.1, 10.0));
  const auto is = fibre_hit_of(rounded<Real>(m.hit - m.axis_point), scale * rounded<Real>(-m.eye),
                               scale * rounded<Real>(m.x), static_cast<Real>(m.radius));
  const double within = tolerance / std::cos(m.theta);
  RC_ASSERT(std::abs(double{is.h} - std::sin(m.gamma)) < within);
  RC_ASSERT(std::abs(std::sin(double{is.gamma}) - double{is.h}) < tolerance);
  RC_ASSERT(std::abs(double{is.theta} - m.theta) < tolerance);
  RC_ASSERT(glm::length(glm::dvec3(is.frame.x) - m.x) < tolerance);
  RC_ASSERT(glm::length(glm::dvec3(is.frame.y) - m.y) < within);
  RC_ASSERT(glm::length(glm::dvec3(is.frame.z) - m.z) < within);
  const glm::vec<3, Real> eye = into_frame(is.frame, rounded<Real>(m.eye));
  RC_ASSERT(std::abs(double{eye.x - is.eye.sine}) < tolerance && std::abs(double{eye.z}) < within);
  RC_ASSERT(std::abs(double{eye.y - is.eye.cosine}) < tolerance);
  const glm::dvec3 w = any_direction();
  RC_ASSERT(glm::length(glm::dvec3(out_of_frame(is.frame, into_frame(is.frame, rounded<Real>(w)))) - w) < tolerance);
}

/// v refracted at a normal against it, `eta` the index behind over that before.
glm::dvec3 refracted(const glm::dvec3& v, const glm::dvec3& normal, double eta) {
  const double cosine = -glm::dot(v, normal);
  return v / eta + (cosine / eta - std::sqrt(1.0 - (1.0 - cosine * cosine) / (eta * eta))) * normal;
}

/// The angle between a direction's azimuth in the frame and a lobe's middle.
double off_middle(const glm::dvec3& in_frame, const rotation<double>& middle) {
  return std::abs(
      std::remainder(std::atan2(in_frame.z, in_frame.y) - std::atan2(middle.sine, middle.cosine), 2.0 * pi));
}

}  // namespace

TEST_CASE("a hit made from h, inclination and frame gives them back") {
  test::holds("in float", [] { check_made_hits<float>(3e-6); });
  test::holds("in double", [] { check_made_hits<double>(1e-12); });
}

TEST_CASE("rays that the cylinder's surface reflects and refracts leave in the middle of R, TT and TRT") {
  test::holds("the sign of h is the model's", [] {
    const made_hit m = draw_hit(1.4);
    const double eta = number(1.2, 2.0);
    const auto is = fibre_hit_of(m.hit - m.axis_point, -m.eye, m.x, m.radius);
    const auto fibre = make_chiang_fibre<double>({eta, {0.1, 0.1, 0.1}, 0.3, 0.3, 0.0});
    const auto view = view_chiang(fibre, is.h, is.eye);

    const glm::dvec3 reflected = 2.0 * glm::dot(m.normal, m.eye) * m.normal - m.eye;
    RC_ASSERT(off_middle(into_frame(is.frame, reflected), view.towards[0]) < 1e-9);

    // Through the cylinder in space: a chord from normal to normal, its reflection inside, and out.
    glm::dvec3 way = refracted(-m.eye, m.normal, eta);
    glm::dvec3 normal = m.normal;
    for (std::size_t p = 1; p < 3; ++p) {
      const glm::dvec3 across = way - glm::dot(way, m.x) * m.x;
      normal -= 2.0 * glm::dot(normal, across) / glm::dot(across, across) * across;
      RC_ASSERT(off_middle(into_frame(is.frame, refracted(way, -normal, 1.0 / eta)), view.towards[p]) < 1e-6);
      way -= 2.0 * glm::dot(way, normal) * normal;
    }
  });
}

TEST_CASE("on a segment h is offset_across() of the ray, with the radius that the taper has there") {
  test::holds("a ray that hits between the ends", [] {
    const made_hit m = draw_hit(1.3);
    const double before = number(0.1, 3.0), after = number(0.1, 3.0);
    const glm::dvec3 start = m.axis_point - before * m.x, end = m.axis_point + after * m.x;
    const double taper = number(-0.2, 0.2) * m.radius;
    const double start_radius = m.radius - before * taper, end_radius = m.radius + after * taper;
    RC_PRE(start_radius > 0.0 && end_radius > 0.0);
    const auto is = fibre_hit_on_segment(m.hit, -m.eye, start, end, start_radius, end_radius);
    RC_ASSERT(std::abs(is.h - std::sin(m.gamma)) < 1e-9);
    RC_ASSERT(glm::length(is.frame.y - m.y) < 1e-9);

    // Where the closest point lies between the ends too, the older way to h agrees.
    const glm::dvec3 origin = m.hit + 5.0 * m.eye;
    const auto pair = closest_points(origin, -m.eye, start, end);
    RC_PRE(pair.along_segment > 0.0 && pair.along_segment < 1.0);
    RC_ASSERT(std::abs(is.h - offset_across(origin, -m.eye, start, end, pair, m.radius)) < 1e-9);
  });
}

TEST_CASE("on the cap of a swept sphere h is the ray's distance from the axis over the end's radius") {
  test::holds("a hit on the sphere beyond an end", [] {
    const made_hit m = draw_hit(1.3);
    const bool at_end = *rc::gen::arbitrary<bool>();
    const glm::dvec3 start = m.axis_point, end = m.axis_point + number(0.5, 3.0) * m.x;
    const double start_radius = m.radius, end_radius = m.radius * number(0.5, 2.0);
    glm::dvec3 normal = any_direction();
    const double out = glm::dot(normal, m.x);
    if ((out > 0.0) != at_end) normal -= 2.0 * out * m.x;
    const double radius = at_end ? end_radius : start_radius;
    const glm::dvec3 centre = at_end ? end : start;
    const auto is = fibre_hit_on_segment(centre + radius * normal, -m.eye, start, end, start_radius, end_radius);
    RC_ASSERT(std::abs(is.h + glm::dot(normal, m.z)) < 1e-9);
  });
}

TEST_CASE("a ray along the fibre, a segment that is a point, no radius and NaN give a frame or 0, as documented") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto is_frame = [](const fibre_frame<float>& f) {
    const auto near = [](float a, float b) { return std::abs(a - b) < 1e-5f; };
    return near(glm::dot(f.x, f.x), 1) && near(glm::dot(f.y, f.y), 1) && near(glm::dot(f.x, f.y), 0) &&
           glm::length(glm::cross(f.x, f.y) - f.z) < 1e-5f;
  };
  for (const glm::vec3& along : {glm::vec3(1, 0, 0), glm::vec3(0, -2, 0), glm::vec3(0.3f, 0.4f, -0.5f)}) {
    for (const float sign : {1.0f, -1.0f}) {
      const auto hit = fibre_hit_of(glm::vec3(0.1f, 0.2f, 0.3f), sign * along, along, 0.5f);
      CHECK(hit.h == 0.0f);
      CHECK(is_frame(hit.frame));
      CHECK(hit.eye.sine == doctest::Approx(-sign));
      CHECK(hit.theta == doctest::Approx(static_cast<double>(-sign) * pi / 2));
    }
    const auto point = fibre_hit_on_segment(along, along, glm::vec3(0.0f), glm::vec3(0.0f), 0.5f, 0.7f);
    CHECK(point.h == 0.0f);
    CHECK(is_frame(point.frame));
    CHECK(std::abs(point.theta) < 1e-6f);
    CHECK(std::isfinite(point.gamma));
  }
  const glm::vec3 x(1, 0, 0), onward(0, 0, -1);
  CHECK(fibre_hit_of(glm::vec3(0.0f, 0.1f, 0.0f), onward, x, 0.0f).h == 1.0f);
  CHECK(fibre_hit_of(glm::vec3(0.0f, -0.1f, 0.0f), onward, x, 0.0f).h == -1.0f);
  CHECK(fibre_hit_of(glm::vec3(0.0f, 0.0f, 0.0f), onward, x, 0.0f).h == 0.0f);
  CHECK(fibre_hit_of(glm::vec3(0.0f, 3.0f, 0.0f), onward, x, 0.5f).h == 1.0f);
  CHECK(fibre_hit_of(glm::vec3(0.0f, nan, 0.0f), onward, x, 0.5f).h == 0.0f);
  CHECK(fibre_hit_of(glm::vec3(0.0f, 0.1f, 0.0f), onward, x, nan).h == 0.0f);
  // Seen from +z, on the side of +y.
  CHECK(fibre_hit_of(glm::vec3(0.0f, 0.1f, 0.0f), onward, x, 0.2f).h == doctest::Approx(0.5));

  test::holds("whatever the vectors, a frame", [&] {
    const auto hit = fibre_hit_of(rounded<float>(any_direction()), rounded<float>(any_direction()),
                                  rounded<float>(any_direction()), 0.5f);
    RC_ASSERT(is_frame(hit.frame));
    RC_ASSERT(hit.h >= -1.0f && hit.h <= 1.0f);
    const auto nearly =
        fibre_hit_of(rounded<float>(any_direction()), glm::vec3(1.0f, static_cast<float>(number(-1e-5, 1e-5)), 0.0f),
                     glm::vec3(1.0f, 0.0f, static_cast<float>(number(-1e-5, 1e-5))), 0.5f);
    RC_ASSERT(is_frame(nearly.frame));
  });
}
