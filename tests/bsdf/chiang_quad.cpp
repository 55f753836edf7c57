// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/bsdf/chiang_quad.hpp>
#include <bsdf/sphere.hpp>

#include <property.hpp>

using namespace pelage;

TEST_CASE("four lanes give the kernel's bits") {
  test::holds("value and density are those of the kernel in float",
              [](std::int16_t h, std::int16_t theta_o, std::int16_t theta_i, std::int16_t phi, std::uint16_t rough,
                 std::uint16_t sigma, std::int8_t tilt) {
                auto fibre = make_chiang_fibre<float>(
                    {1.55f, {sigma / 20000.0f, 0.0f, 1.0f}, rough / 65535.0f, 1.0f - rough / 65535.0f, tilt / 700.0f});
                fibre.tints = {1.0f, 0.5f, 0.25f, 0.9f};
                const auto eye = fibre_direction_of(test::unit_vector<float>(theta_o / 32768.0 * 1.5707, 1.0));
                const auto light = fibre_direction_of(test::unit_vector<float>(theta_i / 32768.0 * 1.5707, phi * 1e-4));
                const auto view = view_chiang(fibre, h / 32767.0f, eye);
                const chiang_quad_fibre quad = make_chiang_quad_fibre(fibre);
                const chiang_quad_view quad_view = view_chiang(quad, h / 32767.0f, eye);
                const auto expected = evaluate_chiang(fibre, view, light);
                const auto found = evaluate_chiang(quad, quad_view, light);
                RC_ASSERT(found.value == expected.value);
                RC_ASSERT(found.density == expected.density);
                const auto at_once = evaluate_chiang(fibre, h / 32767.0f, eye, light);
                RC_ASSERT(at_once.value == expected.value);
                RC_ASSERT(at_once.density == expected.density);
                RC_ASSERT(chiang_density(quad, quad_view, light) == chiang_density(fibre, view, light));
              });
}

TEST_CASE("four lanes draw the kernel's directions") {
  test::holds("direction, lobe, value and density are those of sample_chiang()",
              [](std::uint16_t a, std::uint16_t b, std::uint16_t c, std::uint16_t d, std::int8_t h, std::int8_t theta) {
                const auto fibre = make_chiang_fibre<float>({1.55f, {0.1f, 0.2f, 0.3f}, 0.4f, 0.2f, 0.1f});
                const auto eye = fibre_direction_of(test::unit_vector<float>(theta / 128.0 * 1.5707, 2.0));
                const auto number = [](std::uint16_t x) { return static_cast<float>(x) / 65536.0f; };
                const std::array<float, 4> u = {number(a), number(b), number(c), number(d)};
                const auto expected = sample_chiang(fibre, view_chiang(fibre, h / 127.0f, eye), u);
                const chiang_quad_fibre quad = make_chiang_quad_fibre(fibre);
                const auto found = sample_chiang(quad, view_chiang(quad, h / 127.0f, eye), u);
                RC_ASSERT(found.direction == expected.direction);
                RC_ASSERT(found.lobe == expected.lobe);
                RC_ASSERT(found.result.value == expected.result.value);
                RC_ASSERT(found.result.density == expected.result.density);
              });
}
