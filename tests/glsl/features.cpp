// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "codegen/features.hpp"

#include <bit>

#include "glsl/comparison.hpp"
#include "glsl/kernels.hpp"
#include "property.hpp"

namespace pelage::test {

TEST_CASE("Every feature of the subset means the same in GLSL") {
  const auto number = rc::gen::oneOf(between(-3.0F, 3.0F), magnitude(-8, 8));
  holds("features", [&] {
    compare(kernels::features,
            {number, number, number, number, number, any_float(), number, number, few_words(), any_word(), any_word(),
             any_word()},
            [](row in, results& out) {
              const glm::vec4 a = in.v4(0);
              const glm::vec4 b = in.v4(4);
              out.put(features::switched(static_cast<features::kind>(in.u(8)), in.u(9)));
              out.put(features::loops(in.u(9)));
              out.put(features::ranges({a.x, a.y, a.z, a.w}));
              out.put(features::bit_counts(in.u(10), b.x));
              out.put(static_cast<std::uint32_t>(
                  features::choices(std::bit_cast<int>(in.u(10)), std::bit_cast<int>(in.u(11)))));
              out.put(features::vectors(glm::vec3(a), b));
              std::uint32_t quotient = 0U;
              std::uint32_t rest = 0U;
              features::divide(in.u(10), in.u(9) % 0xffffffffU + 1U, quotient, rest);
              out.put(quotient);
              out.put(rest);
              out.put(features::members(a.x, a.y));
              out.put(features::wide(in.u(10), in.u(11)));
              out.put(features::limits(b.y));
              features::ring<6> ring = features::empty_ring<6>();
              for (std::size_t i = 0; i < 12; ++i)
                ring.push(in.u(i));
              out.put(features::fold(ring));
              out.put(static_cast<std::uint32_t>(features::kind::frizzy));
              out.put(features::sample_pair::of(a.x, a.y).sum());
              out.put(features::weights[1]);
              out.put(features::half_pi<float>);
              out.put(features::folded(a.x));
              out.put(features::operators(features::sample_pair::of(a.x, a.y), a.z));
              out.put(features::by_type(a.x));
            },
            {{"switch", 1, bits(), bits()},
             {"loops", 1, bits(), bits()},
             {"range-for, min, max, clamp", 1, 0, 0},
             {"bits", 1, bits(), bits()},
             {"signed", 1, bits(), bits()},
             {"vectors", 3, 4, 16, 4.0F},
             {"references", 2, bits(), bits()},
             {"members", 1, 0, 0},
             {"64 bits", 1, bits(), bits()},
             {"limits", 1, 0, 0},
             {"sizes", 1, bits(), bits()},
             {"enumerations", 1, bits(), bits()},
             {"static members", 1, 0, 0},
             {"tables", 1, 0, 0},
             {"variable templates", 1, 0, 0},
             {"folded constants", 1, 0, 0},
             {"operators", 1, 0, 0},
             {"branches by type", 1, 0, 0}});
  });
}

}  // namespace pelage::test
