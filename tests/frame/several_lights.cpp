// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "frame/fibres.hpp"
#include "frame/frame.hpp"
#include "frame/model/built_in.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace pelage::test {

using namespace frame;

image lit_by(const std::vector<std::string>& lights, blend_method method) {
  static const hair_model model = make_built_in(200, 12, 1);
  frame_settings s;
  s.width = s.height = 48;
  s.k = 8;
  s.opacity = 0.4F;
  s.fibre_radius = 0.015F;
  s.on_bust = true;
  s.blend.method = method;
  for (const std::string& text : lights)
    s.lights.push_back(parse_light(text));
  return draw_frame(model, s, [](const std::string&, double) {}).picture;
}

TEST_CASE("Svoboda §2.5.3: what two lights add to a picture they add together, and alpha counts once") {
  const std::string key = "spot:1.5,4.3,5.6:1.5,1.25,1:90";
  const std::string rim = "directional:-0.9,1.3,-2:0.5,0.75,1";
  const std::string none = "directional:1,0,0:0,0,0";  // the sky alone
  for (const blend_method method : {blend_method::exact, blend_method::k_buffer, blend_method::order_weighted}) {
    const image both = lit_by({key, rim}, method);
    const image by_key = lit_by({key}, method);
    const image by_rim = lit_by({rim}, method);
    const image dark = lit_by({none}, method);
    float most = 0.0F;
    float brightest = 0.0F;
    for (std::size_t i = 0; i < both.pixels.size(); ++i) {
      const glm::vec3 error =
          (both.pixels[i] - dark.pixels[i]) - (by_key.pixels[i] - dark.pixels[i]) - (by_rim.pixels[i] - dark.pixels[i]);
      const glm::vec3 of_rim = by_rim.pixels[i] - dark.pixels[i];
      for (int c = 0; c < 3; ++c) {
        most = std::max(most, glm::abs(error[c]));
        brightest = std::max(brightest, of_rim[c]);
      }
    }
    CAPTURE(static_cast<int>(method));
    CHECK(most < 2e-5F);
    CHECK(brightest > 0.2F);
  }
}

}  // namespace pelage::test
