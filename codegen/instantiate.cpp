// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
/// What the mirror holds. Of every header included here: all that is no template, and the instantiations below, at
/// float. A template with a size appears twice: the first size is the macro's default, the second one shows that the
/// translation does not depend on it.
///
/// Left out is what has no meaning in a shader: headers that do for a whole span on a CPU, in vectors, what a mirrored
/// one does for one pixel or fibre (core/lanes, order/k_select, nearest_keys, lane_network, vector_lanes, slice_sort,
/// visibility/occupancy_batch, bsdf/chiang_batch, chiang_quad), and core/assert and core/fetch_minimum, which stand for
/// what GLSL lacks and for what it has.
#include <pelage/bsdf/fresnel.hpp>
#include <pelage/bsdf/kajiya_kay.hpp>
#include <pelage/composite/atomic_tail.hpp>
#include <pelage/composite/depth_peeling.hpp>
#include <pelage/composite/optical_depth.hpp>
#include <pelage/composite/order_weighted.hpp>
#include <pelage/composite/over.hpp>
#include <pelage/composite/radiance.hpp>
#include <pelage/composite/stochastic.hpp>
#include <pelage/composite/tail.hpp>
#include <pelage/composite/transmittance.hpp>
#include <pelage/composite/weighted_average.hpp>
#include <pelage/composite/weighted_blended.hpp>
#include <pelage/composite/weighted_sum.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/core/math.hpp>
#include <pelage/core/mixed_bits.hpp>
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/disc_strip.hpp>
#include <pelage/coverage/line_width.hpp>
#include <pelage/coverage/ray_cone.hpp>
#include <pelage/coverage/segment_quad.hpp>
#include <pelage/order/a_buffer.hpp>
#include <pelage/order/atomic_k_buffer.hpp>
#include <pelage/order/k_buffer.hpp>
#include <pelage/order/list_storage.hpp>
#include <pelage/order/ordered_list.hpp>
#include <pelage/order/slice_pieces.hpp>
#include <pelage/order/slot_storage.hpp>
#include <pelage/order/sorting_network.hpp>
#include <pelage/order/split_slot_storage.hpp>
#include <pelage/order/two_pass_k_buffer.hpp>
#include <pelage/visibility/cell_storage.hpp>
#include <pelage/visibility/deep_shadow_map.hpp>
#include <pelage/visibility/deep_shadow_vertex.hpp>
#include <pelage/visibility/density_clusters.hpp>
#include <pelage/visibility/depth_range.hpp>
#include <pelage/visibility/layer_position.hpp>
#include <pelage/visibility/lookup_jitter.hpp>
#include <pelage/visibility/occupancy_map.hpp>
#include <pelage/visibility/opacity_map.hpp>

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
template fragment atomic_k_buffer::insert<16u>(atomic_slot_storage&, std::uint32_t, fragment) noexcept;
template fragment atomic_k_buffer::insert<13u>(atomic_slot_storage&, std::uint32_t, fragment) noexcept;
template fragment atomic_k_buffer::at<16u>(const atomic_slot_storage&, std::uint32_t, std::uint32_t) noexcept;
template fragment atomic_k_buffer::at<13u>(const atomic_slot_storage&, std::uint32_t, std::uint32_t) noexcept;
template void two_pass_k_buffer::offer_depth<16u>(atomic_split_slot_storage&, std::uint32_t, fragment) noexcept;
template void two_pass_k_buffer::offer_depth<13u>(atomic_split_slot_storage&, std::uint32_t, fragment) noexcept;
template fragment two_pass_k_buffer::insert<16u>(atomic_split_slot_storage&, std::uint32_t, fragment) noexcept;
template fragment two_pass_k_buffer::insert<13u>(atomic_split_slot_storage&, std::uint32_t, fragment) noexcept;
template fragment two_pass_k_buffer::at<16u>(const atomic_split_slot_storage&, std::uint32_t, std::uint32_t) noexcept;
template fragment two_pass_k_buffer::at<13u>(const atomic_split_slot_storage&, std::uint32_t, std::uint32_t) noexcept;

// visibility
using cells = atomic_cell_storage;
template void set_bits(cells&, std::uint32_t, std::uint32_t) noexcept;
template void lower_cell(cells&, std::uint32_t, std::uint32_t) noexcept;
template void raise_cell(cells&, std::uint32_t, std::uint32_t) noexcept;
template void add_to_cell(cells&, std::uint32_t, std::uint32_t) noexcept;
template void extend_depth_range(cells&, std::uint32_t, float) noexcept;
template depth_range load_depth_range(const cells&, std::uint32_t) noexcept;
template struct occupancy_map<128u, 4u>;
template struct occupancy_map<96u, 12u>;
template void add_to_occupancy_map<occupancy_map<128u, 4u>>(cells&, std::uint32_t, float, std::uint32_t) noexcept;
template void add_to_occupancy_map<occupancy_map<96u, 12u>>(cells&, std::uint32_t, float, std::uint32_t) noexcept;
template occupancy_map<128u, 4u> load_occupancy_map(const cells&, std::uint32_t) noexcept;
template occupancy_map<96u, 12u> load_occupancy_map(const cells&, std::uint32_t) noexcept;
template struct opacity_map<16u>;
template struct opacity_map<13u>;
template void add_to_opacity_map<16u>(cells&, std::uint32_t, float, std::uint32_t) noexcept;
template void add_to_opacity_map<13u>(cells&, std::uint32_t, float, std::uint32_t) noexcept;
template opacity_map<16u> load_opacity_map(const cells&, std::uint32_t) noexcept;
template opacity_map<13u> load_opacity_map(const cells&, std::uint32_t) noexcept;
template struct density_clusters<4u>;
template struct density_clusters<3u>;
template void add_to_density_clusters<4u>(cells&, std::uint32_t, float) noexcept;
template void add_to_density_clusters<3u>(cells&, std::uint32_t, float) noexcept;
template density_clusters<4u> load_density_clusters(const cells&, std::uint32_t) noexcept;
template density_clusters<3u> load_density_clusters(const cells&, std::uint32_t) noexcept;
template void deep_shadow_builder::add(span_vertex_storage&, float, float) noexcept;
template void deep_shadow_builder::finish(span_vertex_storage&) noexcept;
template float deep_shadow_at(const span_vertex_storage&, std::uint32_t, std::uint32_t, float) noexcept;

// composite
template vec3 transmittance(const vec3&, float) noexcept;
template float transmittance(float, float) noexcept;
template glm::vec4 premultiply(const vec3&, float) noexcept;
template glm::vec4 over(const glm::vec4&, const glm::vec4&) noexcept;
template pixel_radiance<float> empty_pixel() noexcept;
template pixel_radiance<float> add_fibre(const pixel_radiance<float>&, const vec3&, const vec3&, float) noexcept;
template vec3 resolve(const pixel_radiance<float>&, const vec3&) noexcept;
template void atomic_tail::add(atomic_tail_storage&, std::uint32_t, const tail&) noexcept;
template tail atomic_tail::load(const atomic_tail_storage&, std::uint32_t) noexcept;
template void add_to_tail(cells&, std::uint32_t, const tail&) noexcept;
template tail load_tail(const cells&, std::uint32_t) noexcept;
template struct stochastic_depths<16u>;
template struct stochastic_depths<13u>;
template void add_to_stochastic_depths<16u>(cells&, std::uint32_t, fragment, float, std::uint32_t) noexcept;
template void add_to_stochastic_depths<13u>(cells&, std::uint32_t, fragment, float, std::uint32_t) noexcept;
template stochastic_depths<16u> load_stochastic_depths(const cells&, std::uint32_t) noexcept;
template stochastic_depths<13u> load_stochastic_depths(const cells&, std::uint32_t) noexcept;

// bsdf
template float fresnel_dielectric(float, float) noexcept;
template float fibre_attenuation(float, float) noexcept;

}  // namespace pelage
