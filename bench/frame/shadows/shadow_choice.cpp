// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/shadows/shadow_choice.hpp"

#include <utility>

#include "frame/base/compiled_sizes.hpp"
#include "frame/base/method_text.hpp"
#include "frame/shadows/deep_shadow.hpp"
#include "frame/shadows/k_buffer_shadow.hpp"
#include "frame/shadows/layered_shadow.hpp"
#include "frame/shadows/occupancy_shadow.hpp"

namespace pelage::frame {
namespace {

/// What all methods need.
struct caster {
  const raster& from;
  const solids& opaque;
  const order_options& order;
  bool translucent;

  /// The K nearest or, with a method that keeps all, all fragments.
  [[nodiscard]] cast_shadow in_order(order_method method) const {
    auto map = std::make_unique<k_buffer_shadow>(from, opaque, translucent);
    order_options options = order;
    options.method = method;
    const order_report report = run_order_pass(from, map->limit(), options, *map);
    return {std::move(map), report};
  }

  [[nodiscard]] cast_shadow filled(std::unique_ptr<list_shadow> map) const {
    const order_report report =
        run_list_pass(from, map->limit(), order.drawing_order,
                      [&map](int x, int y, std::span<pixel_fragment> all) { map->fill(x, y, all); });
    return {std::move(map), report};
  }

  [[nodiscard]] cast_shadow layered(std::uint32_t layers, const layer_layout& layout) const {
    std::unique_ptr<list_shadow> map;
    with_size_of<compiled_layers>("layers", layers, [&]<std::uint32_t Layers>() {
      map = std::make_unique<layered_shadow<Layers>>(from, opaque, translucent, layout);
    });
    return filled(std::move(map));
  }

  /// The first pass finds where the layers begin.
  [[nodiscard]] cast_shadow deep_layered(std::uint32_t layers, layer_widths widths) const {
    order_report first;
    layer_layout layout = layers_of_texels(from, opaque_depths(from.from(), opaque), order.drawing_order, first);
    layout.widths = widths;
    cast_shadow made = layered(layers, layout);
    made.report.bin_seconds += first.bin_seconds;
    made.report.build_seconds += first.build_seconds;
    return made;
  }
};

}  // namespace

shadow_choice parse_shadow(const std::string& text) {
  const method_text given("--shadow", text);
  const auto plain = [&](shadow_method method) {
    given.without_argument();
    return shadow_choice{method};
  };
  const auto layered = [&](shadow_method method) {
    return shadow_choice{method, given.one_of(compiled_layers, "layers")};
  };
  if (given.word() == "k_buffer") return plain(shadow_method::k_buffer);
  if (given.word() == "occupancy") return plain(shadow_method::occupancy);
  if (given.word() == "opacity") return layered(shadow_method::opacity);
  if (given.word() == "deep_opacity") return layered(shadow_method::deep_opacity);
  if (given.word() == "deep_opacity_growing") return layered(shadow_method::deep_opacity_growing);
  if (given.word() == "deep") return {shadow_method::deep, 0, given.share("the greatest error")};
  if (given.word() == "exact") return plain(shadow_method::exact);
  given.fail("not k_buffer, occupancy, opacity:N, deep_opacity:N, deep_opacity_growing:N, deep:ERR or exact");
}

cast_shadow cast(const shadow_choice& choice, const raster& from, const solids& opaque, const order_options& order,
                 bool translucent) {
  const caster light{from, opaque, order, translucent};
  switch (choice.method) {
    case shadow_method::k_buffer:
      return light.in_order(order.method);
    case shadow_method::occupancy:
      return light.filled(std::make_unique<occupancy_shadow>(from, opaque, translucent));
    case shadow_method::opacity:
      return light.layered(choice.layers, layers_of_model(from));
    case shadow_method::deep_opacity:
      return light.deep_layered(choice.layers, layer_widths::equal);
    case shadow_method::deep_opacity_growing:
      return light.deep_layered(choice.layers, layer_widths::growing);
    case shadow_method::deep:
      return light.filled(std::make_unique<deep_shadow>(from, opaque, translucent, choice.max_error));
    case shadow_method::exact:
      break;
  }
  return light.in_order(order_method::full_sort);
}

}  // namespace pelage::frame
