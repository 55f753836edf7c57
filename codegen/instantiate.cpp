// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
/// What the mirror holds. Of every header included here: all that is no template, and the instantiations below, at
/// float. A template with a size appears twice: the first size is the macro's default, the second one shows that the
/// translation does not depend on it.
///
/// Left out is what has no meaning in a shader: headers that do for a whole span on a CPU, in vectors or blocks, what a
/// mirrored one does for one pixel or fibre (core/lanes, lane_moves, composite/tail_lanes, order/block_list_storage,
/// k_select, long_list, nearest_keys, lane_network, slice_sort, visibility/occupancy_batch, bsdf/chiang_batch,
/// chiang_quad), and core/assert, exact_begin and exact_end, which stand for what GLSL lacks or has in another form;
/// and explore/, which is for tests.
#include <pelage/bsdf/azimuthal.hpp>
#include <pelage/bsdf/bessel.hpp>
#include <pelage/bsdf/chiang.hpp>
#include <pelage/bsdf/chiang_far_field.hpp>
#include <pelage/bsdf/chiang_sampling.hpp>
#include <pelage/bsdf/dual_scattering.hpp>
#include <pelage/bsdf/dual_scattering_table.hpp>
#include <pelage/bsdf/fibre_albedo.hpp>
#include <pelage/bsdf/fibre_hit.hpp>
#include <pelage/bsdf/fresnel.hpp>
#include <pelage/bsdf/hair_parameters.hpp>
#include <pelage/bsdf/interface.hpp>
#include <pelage/bsdf/kajiya_kay.hpp>
#include <pelage/bsdf/kajiya_kay_highlights.hpp>
#include <pelage/bsdf/longitudinal.hpp>
#include <pelage/bsdf/marschner.hpp>
#include <pelage/bsdf/marschner_table.hpp>
#include <pelage/bsdf/passage.hpp>
#include <pelage/bsdf/renderer_parameters.hpp>
#include <pelage/bsdf/scattering_roots.hpp>
#include <pelage/composite/alpha_layers.hpp>
#include <pelage/composite/atomic_tail.hpp>
#include <pelage/composite/depth_peeling.hpp>
#include <pelage/composite/divided_pixel.hpp>
#include <pelage/composite/moment_bounds.hpp>
#include <pelage/composite/optical_depth.hpp>
#include <pelage/composite/order_weighted.hpp>
#include <pelage/composite/over.hpp>
#include <pelage/composite/power_moments.hpp>
#include <pelage/composite/radiance.hpp>
#include <pelage/composite/sliced_tail.hpp>
#include <pelage/composite/stochastic.hpp>
#include <pelage/composite/tail.hpp>
#include <pelage/composite/transmittance.hpp>
#include <pelage/composite/trigonometric_moments.hpp>
#include <pelage/composite/weighted_average.hpp>
#include <pelage/composite/weighted_blended.hpp>
#include <pelage/composite/weighted_sum.hpp>
#include <pelage/core/atomic_cells.hpp>
#include <pelage/core/elementary.hpp>
#include <pelage/core/fragment.hpp>
#include <pelage/core/lane_group.hpp>
#include <pelage/core/math.hpp>
#include <pelage/core/mixed_bits.hpp>
#include <pelage/core/real_number.hpp>
#include <pelage/core/vector_math.hpp>
#include <pelage/coverage/chord_run.hpp>
#include <pelage/coverage/closest_points.hpp>
#include <pelage/coverage/curve_basis.hpp>
#include <pelage/coverage/disc_strip.hpp>
#include <pelage/coverage/flatten_curve.hpp>
#include <pelage/coverage/joint.hpp>
#include <pelage/coverage/line_width.hpp>
#include <pelage/coverage/ray_cone.hpp>
#include <pelage/coverage/segment_quad.hpp>
#include <pelage/coverage/strand_share.hpp>
#include <pelage/order/a_buffer.hpp>
#include <pelage/order/atomic_k_buffer.hpp>
#include <pelage/order/cascade_k_buffer.hpp>
#include <pelage/order/group_select.hpp>
#include <pelage/order/k_buffer.hpp>
#include <pelage/order/lane_sort.hpp>
#include <pelage/order/list_storage.hpp>
#include <pelage/order/ordered_list.hpp>
#include <pelage/order/packed_fragment.hpp>
#include <pelage/order/slice_pieces.hpp>
#include <pelage/order/sorting_network.hpp>
#include <pelage/order/split_k_buffer.hpp>
#include <pelage/order/unrolled_list.hpp>
#include <pelage/order/unrolled_walk.hpp>
#include <pelage/visibility/deep_shadow_map.hpp>
#include <pelage/visibility/deep_shadow_vertex.hpp>
#include <pelage/visibility/density_clusters.hpp>
#include <pelage/visibility/depth_range.hpp>
#include <pelage/visibility/layer_position.hpp>
#include <pelage/visibility/lookup_jitter.hpp>
#include <pelage/visibility/occupancy_map.hpp>
#include <pelage/visibility/opacity_map.hpp>
#include <pelage/visibility/receiver.hpp>

namespace pelage {

using vec3 = glm::vec3;
using cells = atomic_cells<std::uint32_t>;
using wide_cells = atomic_cells<std::uint64_t>;
using colour = std::array<float, 3>;

// core
template void set_bits(cells&, std::uint32_t, std::uint32_t) noexcept;
template void lower_cell(cells&, std::uint32_t, std::uint32_t) noexcept;
template void raise_cell(cells&, std::uint32_t, std::uint32_t) noexcept;
template void add_to_cell(cells&, std::uint32_t, std::uint32_t) noexcept;
template void add_and_mark(cells&, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t) noexcept;
template std::uint32_t load_marked(const cells&, std::uint32_t, std::uint32_t, std::uint32_t) noexcept;
template float sqr(float) noexcept;
template float safe_sqrt(float) noexcept;
template float saturate(float) noexcept;
template std::uint32_t add_saturating(std::uint32_t, std::uint32_t) noexcept;
template float fast_log2(float) noexcept;
template float fast_exp2(float) noexcept;
template float power_of_cosine(float, float) noexcept;
template float dot_product(const vec3&, const vec3&) noexcept;
template vec3 cross_product(const vec3&, const vec3&) noexcept;
template float vector_length(const vec3&) noexcept;
template vec3 unit_vector(const vec3&) noexcept;
template float select(bool, float, float) noexcept;
template float square_root(float) noexcept;
template float whole_part(float) noexcept;
template exponent_parts<float> split_exponent(float) noexcept;
template float absolute(float) noexcept;
template float least(float, float) noexcept;
template float greatest(float, float) noexcept;
template float small_exponential(float) noexcept;
template float exponential(float) noexcept;
template float one_minus_exponential(float) noexcept;
template float natural_logarithm(float) noexcept;
template float power_of_share(float, float) noexcept;
template float unsigned_angle(float, float) noexcept;
template float angle_of(float, float) noexcept;
template float angle_of_sine(float) noexcept;
template rotation<float> rotation_by(float) noexcept;
template rotation<float> turned_by(const rotation<float>&, const rotation<float>&) noexcept;
template rotation<float> turned_back(const rotation<float>&, const rotation<float>&) noexcept;

// coverage
template closest_pair<float> closest_points(const vec3&, const vec3&, const vec3&, const vec3&) noexcept;
template float offset_across(const vec3&, const vec3&, const vec3&, const vec3&, const closest_pair<float>&,
                             float) noexcept;
template float disc_strip_share(float, float, float) noexcept;
template float cap_share(float) noexcept;
template float owned_by_segment(const strand_joint<float>&, const strand_joint<float>&, const glm::vec2&) noexcept;
template float past_joint(const strand_joint<float>&, const glm::vec2&) noexcept;
template bezier_segment<float> straight_segment(const glm::vec4&, const glm::vec4&) noexcept;
template bezier_segment<float> bezier_of(curve_basis, const segment_vertices&,
                                         const std::array<glm::vec4, 4>&) noexcept;
template bezier_segment<float> with_varying(const bezier_segment<float>&, float, float) noexcept;
template glm::vec4 detail::third_of_way(const glm::vec4&, const glm::vec4&) noexcept;
template glm::vec4 detail::b_spline_knot(const glm::vec4&, const glm::vec4&, const glm::vec4&) noexcept;
template std::uint32_t pieces_within(const bezier_segment<float>&, float, float) noexcept;
template float piece_error(const bezier_segment<float>&, std::uint32_t) noexcept;
template float radius_piece_error(const bezier_segment<float>&, std::uint32_t) noexcept;
template float greatest_piece_length(float, float) noexcept;
template glm::vec4 point_of_piece(const bezier_segment<float>&, std::uint32_t, std::uint32_t) noexcept;
template float error_on_screen(const bezier_segment<float>&, float, float) noexcept;
template glm::vec2 detail::second_differences(const bezier_segment<float>&) noexcept;
template bool detail::leave_more(std::uint32_t, float, float) noexcept;
template glm::vec2 line_depth_slope(const vec3&, const vec3&, float) noexcept;
template glm::vec2 plane_depth_slope(const vec3&, const vec3&, float) noexcept;
template glm::vec2 detail::limited_slope(float, float, float, float) noexcept;
template float diagonal_ratio(const glm::vec2&) noexcept;
template float line_width_share(const glm::vec2&, float, float) noexcept;
template float mean_diagonal_ratio(float) noexcept;
template float mean_line_width_share(float, float) noexcept;
template float disc_radius(pixel_footprint) noexcept;
template ray_cone<float> perspective_cone(float, int, pixel_footprint) noexcept;
template ray_cone<float> orthographic_cone(float, int, pixel_footprint) noexcept;
template float radius_at(ray_cone<float>, float) noexcept;
template segment_quad<float> expand_segment(const vec3&, const vec3&, float, ray_cone<float>, float, float) noexcept;
template float reach_at(float, float, ray_cone<float>, float) noexcept;
template chord_run<float> begin_chord(const vec3&, float, float) noexcept;
template bool chord_reaches(const chord_run<float>&, const vec3&, float, float) noexcept;
template chord_run<float> pass_point(const chord_run<float>&, const vec3&, float, float, float) noexcept;
template vec3 detail::across_run(const chord_run<float>&, const vec3&, float) noexcept;
template float screen_tolerance(float, float, float, float, float) noexcept;
template float kept_share(float, float, float) noexcept;
template float width_factor(float, float) noexcept;
template float tangent_stretch(float) noexcept;
template vec3 any_normal(const vec3&) noexcept;

// order
template struct k_buffer<16u>;
template struct k_buffer<13u>;
template struct group_select<2u>;
template struct group_select<3u>;
template void group_select<2u>::limit(const subgroup&) noexcept;
template void group_select<2u>::insert(subgroup&, fragment, std::uint32_t) noexcept;
template void group_select<2u>::finish(subgroup&) noexcept;
template std::uint32_t group_select<2u>::held(const subgroup&) const noexcept;
template placed_fragment group_select<2u>::at(const subgroup&, std::uint32_t) const noexcept;
template void group_select<3u>::limit(const subgroup&) noexcept;
template void group_select<3u>::insert(subgroup&, fragment, std::uint32_t) noexcept;
template void group_select<3u>::finish(subgroup&) noexcept;
template std::uint32_t group_select<3u>::held(const subgroup&) const noexcept;
template placed_fragment group_select<3u>::at(const subgroup&, std::uint32_t) const noexcept;
template void sort_network<16u>(std::array<fragment, 16>&) noexcept;
template void sort_network<13u>(std::array<fragment, 13>&) noexcept;
template std::uint32_t take_node(atomic_list_storage&) noexcept;
template std::uint32_t link_of(const atomic_list_storage&, std::uint32_t) noexcept;
template fragment a_buffer::push(atomic_list_storage&, std::uint32_t, fragment) noexcept;
template std::uint32_t a_buffer::first(const atomic_list_storage&, std::uint32_t) noexcept;
template std::uint32_t a_buffer::next(const atomic_list_storage&, std::uint32_t) noexcept;
template unrolled_list::node_block unrolled_list::take(atomic_list_storage&, std::uint32_t) noexcept;
template void unrolled_list::push(atomic_list_storage&, std::uint32_t, node_block) noexcept;
template std::uint32_t unrolled_list::first(const atomic_list_storage&, std::uint32_t) noexcept;
template std::uint32_t unrolled_list::next(const atomic_list_storage&, std::uint32_t) noexcept;
template void unrolled_walk::go_to(const atomic_list_storage&, const subgroup&, std::uint32_t) noexcept;
template fragment ordered_list::insert(atomic_list_storage&, std::uint32_t, fragment, std::uint32_t) noexcept;
template std::uint32_t ordered_list::first(const atomic_list_storage&, std::uint32_t) noexcept;
template std::uint32_t ordered_list::next(const atomic_list_storage&, std::uint32_t) noexcept;
template fragment atomic_k_buffer::insert<16u>(wide_cells&, std::uint32_t, fragment) noexcept;
template fragment atomic_k_buffer::insert<13u>(wide_cells&, std::uint32_t, fragment) noexcept;
template std::array<fragment, 16u> atomic_k_buffer::load<16u>(const wide_cells&, std::uint32_t) noexcept;
template std::array<fragment, 13u> atomic_k_buffer::load<13u>(const wide_cells&, std::uint32_t) noexcept;
template fragment cascade_k_buffer::insert<16u>(wide_cells&, std::uint32_t, fragment) noexcept;
template fragment cascade_k_buffer::insert<13u>(wide_cells&, std::uint32_t, fragment) noexcept;
template fragment cascade_k_buffer::at<16u>(const wide_cells&, std::uint32_t, std::uint32_t) noexcept;
template fragment cascade_k_buffer::at<13u>(const wide_cells&, std::uint32_t, std::uint32_t) noexcept;
template void split_k_buffer::offer_depth<16u>(cells&, std::uint32_t, fragment) noexcept;
template void split_k_buffer::offer_depth<13u>(cells&, std::uint32_t, fragment) noexcept;
template fragment split_k_buffer::insert<16u>(cells&, std::uint32_t, fragment) noexcept;
template fragment split_k_buffer::insert<13u>(cells&, std::uint32_t, fragment) noexcept;
template fragment split_k_buffer::at<16u>(const cells&, std::uint32_t, std::uint32_t) noexcept;
template fragment split_k_buffer::at<13u>(const cells&, std::uint32_t, std::uint32_t) noexcept;

// visibility
template void atomic_depth_range::extend(cells&, std::uint32_t, float) noexcept;
template depth_range atomic_depth_range::load(const cells&, std::uint32_t) noexcept;
template struct occupancy_map<128u, 4u>;
template struct occupancy_map<96u, 12u>;
template void atomic_occupancy_map::add<occupancy_map<128u, 4u>>(cells&, std::uint32_t, float, std::uint32_t) noexcept;
template void atomic_occupancy_map::add<occupancy_map<96u, 12u>>(cells&, std::uint32_t, float, std::uint32_t) noexcept;
template occupancy_map<128u, 4u> atomic_occupancy_map::load(const cells&, std::uint32_t) noexcept;
template occupancy_map<96u, 12u> atomic_occupancy_map::load(const cells&, std::uint32_t) noexcept;
template struct opacity_map<16u>;
template struct opacity_map<13u>;
template void atomic_opacity_map::add<opacity_map<16u>>(cells&, std::uint32_t, float, std::uint32_t) noexcept;
template void atomic_opacity_map::add<opacity_map<13u>>(cells&, std::uint32_t, float, std::uint32_t) noexcept;
template opacity_map<16u> atomic_opacity_map::load(const cells&, std::uint32_t) noexcept;
template opacity_map<13u> atomic_opacity_map::load(const cells&, std::uint32_t) noexcept;
template void layer_sums::add(cells&, std::uint32_t, std::uint32_t, float, std::uint32_t) noexcept;
template void layer_sums::accumulate(cells&, std::uint32_t, std::uint32_t) noexcept;
template float layer_sums::accumulated_before(const cells&, std::uint32_t, std::uint32_t, float,
                                              std::uint32_t) noexcept;
template struct density_clusters<4u>;
template struct density_clusters<3u>;
template void atomic_density_clusters::add<density_clusters<4u>>(cells&, std::uint32_t, float) noexcept;
template void atomic_density_clusters::add<density_clusters<3u>>(cells&, std::uint32_t, float) noexcept;
template density_clusters<4u> atomic_density_clusters::load(const cells&, std::uint32_t) noexcept;
template density_clusters<3u> atomic_density_clusters::load(const cells&, std::uint32_t) noexcept;
template void deep_shadow_builder::add(span_vertex_storage&, float, float) noexcept;
template void deep_shadow_builder::finish(span_vertex_storage&) noexcept;
template float deep_shadow_at(const span_vertex_storage&, std::uint32_t, std::uint32_t, float) noexcept;

// composite
template std::uint32_t optical_depth(float) noexcept;
template std::uint32_t to_fixed(float) noexcept;
template vec3 transmittance(const vec3&, float) noexcept;
template float transmittance(float, float) noexcept;
template glm::vec4 premultiply(const vec3&, float) noexcept;
template glm::vec4 over(const glm::vec4&, const glm::vec4&) noexcept;
template pixel_radiance<float> empty_pixel() noexcept;
template pixel_radiance<float> add_fibre(const pixel_radiance<float>&, const vec3&, const vec3&, float) noexcept;
template vec3 resolve(const pixel_radiance<float>&, const vec3&) noexcept;
template float parting_depth(float, float) noexcept;
template divided_pixel<float> empty_divided_pixel() noexcept;
template divided_pixel<float> add_fibre(const divided_pixel<float>&, bool, const vec3&, const vec3&, float) noexcept;
template vec3 resolve(const divided_pixel<float>&, const divided_backdrop<float>&) noexcept;
template void atomic_tail::add(cells&, std::uint32_t, const tail&) noexcept;
template tail atomic_tail::load(const cells&, std::uint32_t) noexcept;
template struct sliced_tail<16u>;
template struct sliced_tail<13u>;
template pixel_radiance<float> add_sliced_tail(const pixel_radiance<float>&, const sliced_tail<16u>&) noexcept;
template pixel_radiance<float> add_sliced_tail(const pixel_radiance<float>&, const sliced_tail<13u>&) noexcept;
template struct stochastic_depths<16u>;
template struct stochastic_depths<13u>;
template void atomic_stochastic_depths::add<stochastic_depths<16u>>(cells&, std::uint32_t, fragment, float,
                                                                    std::uint32_t) noexcept;
template void atomic_stochastic_depths::add<stochastic_depths<13u>>(cells&, std::uint32_t, fragment, float,
                                                                    std::uint32_t) noexcept;
template stochastic_depths<16u> atomic_stochastic_depths::load(const cells&, std::uint32_t) noexcept;
template stochastic_depths<13u> atomic_stochastic_depths::load(const cells&, std::uint32_t) noexcept;
template struct alpha_layers<4u>;
template struct alpha_layers<3u>;
template struct power_moments<4u>;
template struct power_moments<6u>;
template void atomic_power_moments::add<power_moments<4u>>(cells&, std::uint32_t, const power_moments<4u>&) noexcept;
template void atomic_power_moments::add<power_moments<6u>>(cells&, std::uint32_t, const power_moments<6u>&) noexcept;
template power_moments<4u> atomic_power_moments::load(const cells&, std::uint32_t) noexcept;
template power_moments<6u> atomic_power_moments::load(const cells&, std::uint32_t) noexcept;
template struct trigonometric_moments<2u>;
template struct trigonometric_moments<3u>;
template void atomic_trigonometric_moments::add<trigonometric_moments<2u>>(cells&, std::uint32_t,
                                                                           const trigonometric_moments<2u>&) noexcept;
template void atomic_trigonometric_moments::add<trigonometric_moments<3u>>(cells&, std::uint32_t,
                                                                           const trigonometric_moments<3u>&) noexcept;
template trigonometric_moments<2u> atomic_trigonometric_moments::load(const cells&, std::uint32_t) noexcept;
template trigonometric_moments<3u> atomic_trigonometric_moments::load(const cells&, std::uint32_t) noexcept;

// bsdf
template kajiya_kay_lobes<float> kajiya_kay(const vec3&, const vec3&, const vec3&, float) noexcept;
template float fresnel_dielectric(float, float) noexcept;
template float fibre_attenuation(float, float) noexcept;
template float fibre_opacity(float, float) noexcept;
template interface_shares<float> dielectric_interface(float, float) noexcept;
template interface_shares<float> bravais_interface(float, float, float, float) noexcept;
template bessel_i0_parts<float> bessel_i0(float) noexcept;
template float log_bessel_i0(float) noexcept;
template fibre_direction<float> fibre_direction_of(float, float, float) noexcept;
template fibre_direction<float> fibre_direction_of(const vec3&) noexcept;
template longitudinal_lobe<float> make_longitudinal_lobe(float) noexcept;
template float evaluate_longitudinal(const longitudinal_lobe<float>&, inclination_pair<float>) noexcept;
template float evaluate_longitudinal(const longitudinal_lobe<float>&, float, float, float, float) noexcept;
template float versine(rotation<float>) noexcept;
template rotation<float> sample_longitudinal(const longitudinal_lobe<float>&, float, float, float, float) noexcept;
template azimuthal_lobe<float> make_azimuthal_lobe(float) noexcept;
template float evaluate_azimuthal(const azimuthal_lobe<float>&, float) noexcept;
template azimuthal_band<float> make_azimuthal_band(const azimuthal_lobe<float>&, float) noexcept;
template float evaluate_azimuthal(const azimuthal_band<float>&, float) noexcept;
template float sample_azimuthal(const azimuthal_lobe<float>&, float) noexcept;
template melanin<float> melanin_of(hair_colour) noexcept;
template colour absorption_of(melanin<float>) noexcept;
template melanin<float> melanin_from_controls(float, float) noexcept;
template float absorption_from_albedo(float, float) noexcept;
template float albedo_from_absorption(float, float) noexcept;
template float longitudinal_variance(float) noexcept;
template float azimuthal_scale(float) noexcept;
template float roughness_of_width(float) noexcept;
template chiang_fibre<float> make_chiang_fibre(const chiang_parameters<float>&) noexcept;
template chiang_view<float> view_chiang(const chiang_fibre<float>&, float, const fibre_direction<float>&) noexcept;
template chiang_result<float> evaluate_chiang(const chiang_fibre<float>&, const chiang_view<float>&,
                                              const fibre_direction<float>&) noexcept;
template float chiang_density(const chiang_fibre<float>&, const chiang_view<float>&,
                              const fibre_direction<float>&) noexcept;
template chiang_bsdf<float> evaluate_chiang_bsdf(const chiang_fibre<float>&, float, const vec3&, const vec3&) noexcept;
template chiang_sample<float> sample_chiang(const chiang_fibre<float>&, const chiang_view<float>&,
                                            const std::array<float, 4>&) noexcept;
template width_node<float> fibre_width_node(int, int) noexcept;
template chiang_far_azimuths<float> chiang_far_lobes(const chiang_fibre<float>&, float, float,
                                                     const rotation<float>&) noexcept;
template chiang_result<float> evaluate_chiang_far(const chiang_fibre<float>&, const fibre_direction<float>&,
                                                  const fibre_direction<float>&) noexcept;
template chiang_sample<float> sample_chiang_far(const chiang_fibre<float>&, const fibre_direction<float>&,
                                                const std::array<float, 4>&) noexcept;
template fibre_hit<float> fibre_hit_of(const vec3&, const vec3&, const vec3&, float) noexcept;
template fibre_hit<float> fibre_hit_on_segment(const vec3&, const vec3&, const vec3&, const vec3&, float,
                                               float) noexcept;
template vec3 into_frame(const fibre_frame<float>&, const vec3&) noexcept;
template vec3 out_of_frame(const fibre_frame<float>&, const vec3&) noexcept;
template vec3 axial_passage(float, const colour&, float) noexcept;
template vec3 mean_passage<4>(float, const colour&, float) noexcept;
template vec3 mean_passage<3>(float, const colour&, float) noexcept;
template float fibre_albedo(float, float, float) noexcept;
template float absorption_from_fibre_albedo(float, float) noexcept;
template chiang_parameters<float> chiang_from_pbrt(const pbrt_hair<float>&) noexcept;
template pbrt_hair<float> pbrt_from_chiang(const chiang_parameters<float>&) noexcept;
template std::array<materialx_lobe<float>, 3> materialx_roughness(float, float, float, float) noexcept;
template colour materialx_absorption_from_melanin(float, float) noexcept;
template float materialx_absorption_from_colour(float, float) noexcept;
template chiang_fibre<float> chiang_from_materialx(const materialx_hair<float>&) noexcept;
template materialx_hair<float> materialx_from_chiang(const chiang_parameters<float>&) noexcept;
template float cycles_roughness(float, float, float) noexcept;
template colour cycles_absorption_from_melanin(float, float, float, float) noexcept;
template float cycles_absorption_from_colour(float, float) noexcept;
template chiang_fibre<float> chiang_from_cycles(const cycles_hair<float>&) noexcept;
template cycles_hair<float> cycles_from_chiang(const chiang_parameters<float>&) noexcept;
template scattering_roots<float> find_scattering_roots(int, float, float) noexcept;
template caustic_point<float> find_caustic(float) noexcept;
template float azimuth_derivative(int, float, float) noexcept;
template marschner_parameters<float> common_marschner_parameters(const colour&) noexcept;
template fibre_section<float> make_fibre_section(float, float) noexcept;
template float path_attenuation(const fibre_section<float>&, int, float, float, float) noexcept;
template vec3 bare_azimuthal(const fibre_section<float>&, int, float, const colour&) noexcept;
template vec3 smooth_trt(const fibre_section<float>&, float, const colour&, const caustic_treatment<float>&) noexcept;
template float eccentric_index(float, float, float) noexcept;
template float gaussian(float, float) noexcept;
template marschner_result<float> evaluate_marschner(const marschner_parameters<float>&, float, float, float,
                                                    float) noexcept;
template float table_coordinate(float, std::uint32_t) noexcept;
template marschner_table_place<float> marschner_table_place_of(float, float, std::uint32_t, std::uint32_t) noexcept;
template marschner_lobes<float> azimuthal_lobes(const fibre_section<float>&, const marschner_parameters<float>&,
                                                float) noexcept;
template dual_local<float> dual_local_scattering(const dual_averages<float>&, const dual_density<float>&) noexcept;
template dual_global<float> dual_unshadowed() noexcept;
template dual_global<float> dual_global_scattering(const dual_averages<float>&, const dual_density<float>&, float,
                                                   float) noexcept;
template dual_global<float> dual_pass_fibre(const dual_global<float>&, const dual_averages<float>&,
                                            const dual_density<float>&) noexcept;
template vec3 dual_scattering(const dual_averages<float>&, const dual_local<float>&, const dual_global<float>&,
                              const dual_density<float>&, const vec3&, float, float, float) noexcept;
template float detail::dual_lobe(float, float, float, float) noexcept;
template dual_table_place<float> dual_table_place_of(float, std::uint32_t) noexcept;
template dual_averages<float> blend_dual_averages(const dual_averages<float>&, const dual_averages<float>&,
                                                  float) noexcept;

}  // namespace pelage
