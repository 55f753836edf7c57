// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/raster/view_opacity.hpp"

#include "bsdf/surfaces.hpp"
#include "frame/fibres.hpp"
#include "frame/frame.hpp"
#include "frame/model/built_in.hpp"
#include "frame/shadows/k_buffer_shadow.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace pelage::test {

using namespace frame;

constexpr int side = 16;

/// 1 - A by Fresnel's equations, at the inclination of a fibre along `tangent` to a ray, in double.
double stopped(const glm::dvec3& tangent, const glm::dvec3& ray, double eta) {
  const double cosine = glm::length(glm::cross(tangent, ray)) / (glm::length(tangent) * glm::length(ray));
  const shares_by_angles surface = fresnel_by_angles(cosine, eta);
  return 1.0 - std::pow(1.0 - surface.reflected, 2.0);
}

/// Straight fibres before an orthographic view, each with an inclination of its own, and what lies in a pixel.
struct straight_fibres {
  float eta = any_float(1.05F, 3.0F);
  std::vector<std::vector<glm::vec3>> lines;
  strands fibres;
  view from = flat_view(side);

  straight_fibres() {
    for (int count = *rc::gen::inRange(1, 12); count > 0; --count) {
      const glm::vec3 middle = any_vec3(-6.0F, 6.0F);
      const glm::vec3 half = any_vec3(-4.0F, 4.0F);
      lines.push_back({middle - half, middle + half});
    }
    fibres = fibres_of(lines, any_float(0.05F, 1.0F), any_float(0.0F, 1.0F));
  }

  /// The product of A C + 1 - C over the fragments of a pixel [Yu12 Eq. 3].
  [[nodiscard]] double passed(const raster& fragments, int x, int y) const {
    double product = 1.0;
    for (std::uint32_t s = 0; s < fibres.segment_count(); ++s) {
      const double opacity = stopped(glm::dvec3(lines[s][1] - lines[s][0]), {0.0, 0.0, -1.0}, static_cast<double>(eta));
      product *= 1.0 - opacity * static_cast<double>(fragments.at(s, x, y).coverage);
    }
    return product;
  }
};

TEST_CASE("a fibre's opacity is Fresnel's at its points, by its own inclination to the view's ray") {
  holds("perspective and orthographic views", [] {
    const strands fibres = fibres_of(any_lines(4, glm::vec3(0.0F), 2.0F), 0.1F, any_float(0.0F, 1.0F));
    const bool perspective = *rc::gen::arbitrary<bool>();
    const view from = perspective ? any_perspective(any_float(3.0F, 9.0F), 0.1F) : flat_view(side);
    const float eta = any_float(1.05F, 3.0F);
    const view_opacity opacity(fibres, from, eta);
    for (std::uint32_t s = 0; s < fibres.segment_count(); ++s) {
      for (const std::uint32_t end : {0U, 1U}) {
        const std::uint32_t i = fibres.segment[s] + end;
        const glm::dvec3 tangent(fibres.tangent[i]);
        const glm::dvec3 ray = perspective ? glm::dvec3(fibres.point[i] - from.eye) : glm::dvec3(0.0, 0.0, -1.0);
        const double right = stopped(tangent, ray, static_cast<double>(eta));
        const double cosine = glm::length(glm::cross(tangent, ray)) / glm::length(ray);
        const double found = static_cast<double>(opacity.at(s, static_cast<float>(end)));
        RC_ASSERT(std::abs(found - right) < 2e-6 + 2e-6 / cosine);  // a sine near 1 has lost its cosine
      }
    }
  });
}

TEST_CASE("mixed between a strand's points, it is that of the mixed tangent within 0.02 RMS and 1 % of the mean") {
  const strands fibres = prepare_strands(make_built_in(500, 48, 1), {});
  for (const bool perspective : {false, true}) {
    const view from = perspective ? perspective_view({1.0F, 2.0F, 8.0F}, glm::vec3(0.0F), 0.3F, side, side, 0.1F)
                                  : orthographic_view(glm::vec3(0.0F), {0.9F, -1.3F, 2.0F}, 4.0F, side);
    const view_opacity opacity(fibres, from, 1.55F);
    double squares = 0.0;
    double sum = 0.0;
    double right_sum = 0.0;
    for (std::uint32_t s = 0; s < fibres.segment_count(); ++s) {
      for (const float along : {0.25F, 0.5F, 0.75F}) {
        const glm::dvec3 place(fibres.mix(fibres.point, s, along));
        const glm::dvec3 tangent(fibres.mix(fibres.tangent, s, along));
        const glm::dvec3 ahead(from.direction_to_world(glm::vec3(0.0F, 0.0F, -1.0F)));
        const double right = stopped(tangent, perspective ? place - glm::dvec3(from.eye) : ahead, 1.55);
        const double found = static_cast<double>(opacity.at(s, along));
        squares += (found - right) * (found - right);
        sum += found;
        right_sum += right;
      }
    }
    CHECK(std::sqrt(squares / (3.0 * fibres.segment_count())) < 0.02);
    CHECK(sum == doctest::Approx(right_sum).epsilon(0.01));
  }
}

TEST_CASE("behind fibres arrives the product of A C + 1 - C, each A at the occluder's own inclination") {
  holds("straight fibres in a directional light", [] {
    const straight_fibres s;
    const raster fragments(s.fibres, s.from, true, s.eta);
    k_buffer_shadow map(fragments, {});
    run_order_pass(fragments, map.limit(), {order_method::k_buffer, 64, {}}, map);
    for (int y = 0; y + 1 < side; ++y) {
      for (int x = 0; x + 1 < side; ++x) {
        const view_ray ray = s.from.ray(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
        const glm::vec3 behind = s.from.eye + s.from.direction_to_world(ray.origin + 100.0F * ray.direction);
        RC_ASSERT(std::abs(static_cast<double>(map.transmittance_to(behind, 0.0F)) - s.passed(fragments, x, y)) < 1e-4);
      }
    }
  });
}

TEST_CASE("through fibres without light of their own the eye sees that product of the background") {
  holds("black straight fibres", [] {
    straight_fibres s;
    for (glm::vec3& colour : s.fibres.colour)
      colour = glm::vec3(0.0F);
    const raster fragments(s.fibres, s.from, true, s.eta);
    const scene world{s.fibres, {}, {}, {glm::vec3(0.0F), 20.0F}, glm::vec3(1.0F), fibre_bsdf({}, glm::vec3(0.0F))};
    const backdrop behind(s.from, world, true);
    const shaded_fibres shades(world, fragments, behind.limit(), 0.0F);
    camera_film film(fragments, behind, shades, components::translucency);
    run_order_pass(fragments, film.limit(), {order_method::k_buffer, 4, {}}, film);
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const auto seen = static_cast<double>(film.picture().at(x, y).g);
        const auto all = static_cast<double>(behind.picture().at(x, y).g);
        RC_ASSERT(std::abs(seen - all * s.passed(fragments, x, y)) < 1e-4);
      }
    }
  });
}

const hair_model& small_hair() {
  static const hair_model model = make_built_in(200, 12, 1);
  return model;
}

frame_settings small_frame() {
  frame_settings s;
  s.width = s.height = 64;
  s.k = 4;
  s.fibre_radius = 0.02F;
  s.on_bust = true;
  s.look.passing = attenuation::fresnel;
  return s;
}

image draw(const frame_settings& settings, int threads = 2) {
  const auto silent = [](const std::string&, double) {};
  return on_threads(threads, [&] { return draw_frame(small_hair(), settings, silent).picture; });
}

TEST_CASE("neither threads nor drawing order nor structure change a bit, and the index of refraction does") {
  for (const bsdf_model model : {bsdf_model::kajiya_kay, bsdf_model::marschner, bsdf_model::chiang}) {
    CAPTURE(static_cast<int>(model));
    frame_settings settings = small_frame();
    settings.look.model = model;
    const image first = draw(settings, 1);
    for (const order_method order : {order_method::k_buffer, order_method::a_buffer, order_method::unrolled_list,
                                     order_method::ordered_list, order_method::atomic_k_buffer}) {
      settings.order = order;
      settings.shuffle += 1;
      CHECK(same_bits(draw(settings, static_cast<int>(settings.shuffle)).pixels, first.pixels));
    }
    settings.look.eta = 2.0F;
    CHECK(compare(draw(settings), first).rms > 0.001);
  }
}

TEST_CASE("fibres without a change of index are not seen, and leave no shadow") {
  frame_settings settings = small_frame();
  settings.look.eta = 1.0F;
  const image clear = draw(settings);
  settings.look.passing = attenuation::constant;
  settings.opacity = 0.0F;
  CHECK(same_bits(clear.pixels, draw(settings).pixels));
}

TEST_CASE("a fibre scatters of a light what the product leaves, in every colour alike") {
  holds("models of one scattering", [] {
    fibre_look look;
    look.model = *rc::gen::element(bsdf_model::kajiya_kay, bsdf_model::marschner, bsdf_model::chiang);
    look.passing = attenuation::fresnel;
    const fibre_bsdf bsdf(look, glm::vec3(0.6F, 0.3F, 0.1F));
    const fibre_place at{glm::vec3(0.0F, 1.0F, 0.0F), glm::normalize(any_vec3(0.1F, 1.0F)), glm::vec3(0.5F), 0.3F};
    const glm::vec3 to_light = glm::normalize(any_vec3(-1.0F, -0.1F));
    const float transmittance = any_float(0.0F, 1.0F);
    const glm::vec3 found = bsdf.scatter(at, to_light, {transmittance, 3.0F, 1.0F});
    const glm::vec3 right = transmittance * bsdf.scatter(at, to_light, {1.0F, 0.0F, 1.0F});
    RC_ASSERT(glm::length(found - right) <= 1e-6F * (1.0F + glm::length(right)));
  });
}

TEST_CASE("an opacity of its own, and dual scattering, do not go with Fresnel's attenuation") {
  frame_settings settings = small_frame();
  settings.opacity = 0.5F;
  CHECK_THROWS_AS(draw(settings), std::invalid_argument);
  settings = small_frame();
  settings.look.model = bsdf_model::dual_scattering;
  CHECK_THROWS_AS(draw(settings), std::invalid_argument);
}

}  // namespace pelage::test
