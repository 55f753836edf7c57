// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
/// What the mirror holds. Of every header included here: all that is no template, and the instantiations below, at
/// float. A template with a size appears twice: the first size is the macro's default, the second one shows that the
/// translation does not depend on it.
#include <pelage/bsdf/fresnel.hpp>
#include <pelage/bsdf/kajiya_kay.hpp>
#include <pelage/composite/optical_depth.hpp>
#include <pelage/composite/over.hpp>
#include <pelage/composite/radiance.hpp>
#include <pelage/composite/tail.hpp>
#include <pelage/composite/transmittance.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/core/math.hpp>
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/disc_strip.hpp>
#include <pelage/coverage/line_width.hpp>
#include <pelage/coverage/ray_cone.hpp>
#include <pelage/coverage/segment_quad.hpp>
#include <pelage/order/a_buffer.hpp>
#include <pelage/order/k_buffer.hpp>
#include <pelage/order/list_storage.hpp>
#include <pelage/order/ordered_list.hpp>
#include <pelage/order/sorting_network.hpp>

namespace pelage {

using vec3 = glm::vec3;

// core
template float sqr(float) noexcept;
template float safe_sqrt(float) noexcept;
template float saturate(float) noexcept;

// coverage
template closest_pair<float> closest_points(const vec3&, const vec3&, const vec3&, const vec3&) noexcept;
template float disc_strip_share(float, float, float) noexcept;
template float cap_share(float) noexcept;
template float diagonal_ratio(const glm::vec2&) noexcept;
template float line_width_share(const glm::vec2&, float, float) noexcept;
template ray_cone<float> perspective_cone(float, int) noexcept;
template ray_cone<float> orthographic_cone(float, int) noexcept;
template float radius_at(ray_cone<float>, float) noexcept;
template segment_quad<float> expand_segment(const vec3&, const vec3&, float, ray_cone<float>, float, float) noexcept;
template float reach_at(float, float, ray_cone<float>, float) noexcept;
template float tangent_stretch(float) noexcept;
template vec3 any_normal(const vec3&) noexcept;

// order
template struct k_buffer<16u>;
template struct k_buffer<13u>;
template void sort_network<16u>(std::array<fragment, 16>&) noexcept;
template void sort_network<13u>(std::array<fragment, 13>&) noexcept;
template std::uint32_t take_node(atomic_list_storage&) noexcept;
template std::uint32_t link_of(const atomic_list_storage&, std::uint32_t) noexcept;
template fragment a_buffer::push(atomic_list_storage&, std::uint32_t, fragment) noexcept;
template std::uint32_t a_buffer::first(const atomic_list_storage&, std::uint32_t) noexcept;
template std::uint32_t a_buffer::next(const atomic_list_storage&, std::uint32_t) noexcept;
template fragment ordered_list::insert(atomic_list_storage&, std::uint32_t, fragment, std::uint32_t) noexcept;
template std::uint32_t ordered_list::first(const atomic_list_storage&, std::uint32_t) noexcept;
template std::uint32_t ordered_list::next(const atomic_list_storage&, std::uint32_t) noexcept;

// composite
template vec3 transmittance(const vec3&, float) noexcept;
template float transmittance(float, float) noexcept;
template glm::vec4 premultiply(const vec3&, float) noexcept;
template glm::vec4 over(const glm::vec4&, const glm::vec4&) noexcept;
template pixel_radiance<float> empty_pixel() noexcept;
template pixel_radiance<float> add_fibre(const pixel_radiance<float>&, const vec3&, const vec3&, float) noexcept;
template vec3 resolve(const pixel_radiance<float>&, const vec3&) noexcept;

// bsdf
template float fresnel_dielectric(float, float) noexcept;
template float fibre_attenuation(float, float) noexcept;

}  // namespace pelage
