// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/blends/blend_choice.hpp"

#include <pelage/composite/depth_peeling.hpp>

#include <map>
#include <vector>

#include "frame/base/compiled_sizes.hpp"
#include "frame/base/method_text.hpp"
#include "frame/blends/deep_opacity.hpp"
#include "frame/blends/moments.hpp"
#include "frame/blends/sliced.hpp"
#include "frame/blends/unordered.hpp"
#include "frame/order/list_pass.hpp"

namespace pelage::frame {
namespace {

order_report draw_in_order(camera_film& film, const raster& from, const order_options& order, order_method method) {
  order_options options = order;
  options.method = method;
  return run_order_pass(from, film.limit(), options, film);
}

/// `blend(layers, background, x, y)` gives the pixel's colour.
template <class Blend>
order_report draw_unordered(camera_film& film, const raster& from, const order_options& order, const Blend& blend) {
  return run_list_pass(from, film.limit(), order.drawing_order, [&](int x, int y, std::span<pixel_fragment> all) {
    film.finish_by(
        [&](std::span<const layer> layers, const glm::vec3& background) { return blend(layers, background, x, y); }, x,
        y, all);
  });
}

order_report draw_unordered(camera_film& film, const raster& from, const order_options& order,
                            glm::vec3 (*blend)(std::span<const layer>, const glm::vec3&)) {
  return draw_unordered(film, from, order, [&](std::span<const layer> layers, const glm::vec3& background, int, int) {
    return blend(layers, background);
  });
}

order_report draw_stochastic(camera_film& film, const raster& from, const order_options& order,
                             const blend_choice& choice) {
  order_report report;
  with_size_of<compiled_samples>("samples", choice.size, [&]<std::uint32_t Samples>() {
    const auto blend = [&](std::span<const layer> layers, const glm::vec3& background, int x, int y) {
      const auto pixel = static_cast<std::uint32_t>(y * from.from().width + x);
      return blend_stochastic<Samples>(layers, background, stochastic_stream(choice.seed, pixel));
    };
    report = draw_unordered(film, from, order, blend);
  });
  return report;
}

order_report draw_by_deep_opacity(camera_film& film, const raster& from, const order_options& order,
                                  const blend_choice& choice) {
  order_report report;
  const bool is_corrected = choice.method == blend_method::deep_opacity_corrected;
  with_size_of<blended_layers>("layers", choice.size, [&]<std::uint32_t Layers>() {
    report = draw_unordered(film, from, order, [&](std::span<const layer> all, const glm::vec3& behind, int, int) {
      return blend_deep_opacity<Layers>(all, behind, is_corrected);
    });
  });
  return report;
}

/// Of the two sizes that either kind of moments has.
template <class Few, class Many>
order_report draw_by_moments(camera_film& film, const raster& from, const order_options& order, bool are_many) {
  return draw_unordered(film, from, order, are_many ? blend_moments<Many> : blend_moments<Few>);
}

order_report draw_by_layers(camera_film& film, const raster& from, const order_options& order, std::uint32_t size) {
  order_report report;
  with_size_of<compiled_alpha_layers>(
      "layers", size, [&]<std::uint32_t N>() { report = draw_unordered(film, from, order, blend_layers<N>); });
  return report;
}

/// Every layer costs a pass over the pixel's fragments: the square of the longest list in time, nothing in memory.
order_report draw_by_peeling(camera_film& film, const raster& from, const order_options& order) {
  return run_list_pass(from, film.limit(), order.drawing_order, [&](int x, int y, std::span<pixel_fragment> all) {
    static thread_local std::vector<pixel_fragment> peeled;
    peeled.clear();
    depth_peeling peeling = depth_peeling::begin();
    for (;;) {
      for (const pixel_fragment& f : all)
        peeling.offer(fragment_of(f));
      const fragment next = peeling.layer();
      if (!is_fragment(next)) break;
      peeled.push_back(from.at(next.id, x, y));
      peeling.advance();
    }
    film.finish(x, y, peeled, {});
  });
}

}  // namespace

blend_choice parse_blend(const std::string& text) {
  static const std::map<std::string, blend_method> plain{{"exact", blend_method::exact},
                                                         {"k_buffer", blend_method::k_buffer},
                                                         {"order_weighted", blend_method::order_weighted},
                                                         {"weighted_average", blend_method::weighted_average},
                                                         {"weighted_blended", blend_method::weighted_blended},
                                                         {"depth_peeling", blend_method::depth_peeling}};
  const method_text given("--blend", text);
  if (given.word() == "stochastic") return {blend_method::stochastic, given.one_of(compiled_samples, "samples")};
  if (given.word() == "sliced" || given.word() == "sliced_clipped") {
    return {given.word() == "sliced" ? blend_method::sliced : blend_method::sliced_clipped,
            text == given.word() ? 256 : given.one_of(slice_counts, "slices")};
  }
  if (given.word() == "deep_opacity") return {blend_method::deep_opacity, given.one_of(blended_layers, "layers")};
  if (given.word() == "deep_opacity_corrected") {
    return {blend_method::deep_opacity_corrected, given.one_of(blended_layers, "layers")};
  }
  if (given.word() == "moments") return {blend_method::moments, given.one_of(compiled_moments, "moments")};
  if (given.word() == "trigonometric") {
    return {blend_method::trigonometric, given.one_of(compiled_trigonometric, "moments")};
  }
  if (given.word() == "layers") return {blend_method::layers, given.one_of(compiled_alpha_layers, "layers")};
  const auto found = plain.find(given.word());
  if (found == plain.end()) {
    given.fail(
        "not exact, k_buffer, order_weighted, weighted_average, weighted_blended, deep_opacity:N, "
        "deep_opacity_corrected:N, depth_peeling, stochastic:N, sliced:N, sliced_clipped:N, moments:N, "
        "trigonometric:N or layers:N");
  }
  given.without_argument();
  return {found->second};
}

std::uint32_t parse_tail(const std::string& text) {
  const method_text given("--tail", text);
  if (given.word() == "sliced") return given.one_of(tail_slices, "slices");
  if (given.word() != "none" && given.word() != "mean") given.fail("not none, mean or sliced:N");
  given.without_argument();
  return given.word() == "none" ? 0 : 1;
}

order_report draw_on(camera_film& film, const blend_choice& choice, const raster& from, const order_options& order,
                     const slice_order& slices) {
  switch (choice.method) {
    case blend_method::exact:
      break;
    case blend_method::k_buffer:
      return draw_in_order(film, from, order, order.method);
    case blend_method::order_weighted:
      return draw_unordered(film, from, order, blend_order_weighted);
    case blend_method::weighted_average:
      return draw_unordered(film, from, order, blend_weighted_average);
    case blend_method::weighted_blended:
      return draw_unordered(film, from, order, blend_weighted_blended);
    case blend_method::deep_opacity:
    case blend_method::deep_opacity_corrected:
      return draw_by_deep_opacity(film, from, order, choice);
    case blend_method::depth_peeling:
      return draw_by_peeling(film, from, order);
    case blend_method::stochastic:
      return draw_stochastic(film, from, order, choice);
    case blend_method::sliced:
    case blend_method::sliced_clipped:
      return draw_sliced(film, from, slices,
                         choice.method == blend_method::sliced ? at_planes::whole : at_planes::clipped);
    case blend_method::moments:
      return draw_by_moments<power_moments<4>, power_moments<6>>(film, from, order, choice.size == 6);
    case blend_method::trigonometric:
      return draw_by_moments<trigonometric_moments<2>, trigonometric_moments<3>>(film, from, order, choice.size == 3);
    case blend_method::layers:
      return draw_by_layers(film, from, order, choice.size);
  }
  return draw_in_order(film, from, order, order_method::full_sort);
}

}  // namespace pelage::frame
