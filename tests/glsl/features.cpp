// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include "codegen/features.hpp"

#include <pelage/core/mixed_bits.hpp>

#include <algorithm>
#include <bit>
#include <vector>

#include "codegen/storage.hpp"
#include "glsl/comparison.hpp"
#include "glsl/kernels.hpp"
#include "property.hpp"

namespace pelage::test {

TEST_CASE("Every feature of the subset means the same in GLSL") {
  const auto number = rc::gen::oneOf(between(-3.0F, 3.0F), magnitude(-8, 8));
  holds("features", [&] {
    compare(kernels::features,
            {number, number, number, number, number, number, number, number, few_words(), any_word(), any_word(),
             any_word(), any_normal_float()},
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
              out.put(features::limits(in.f(12)));
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
              out.put(features::conversions(a.x, a.y, static_cast<int>(in.u(10) % 7U) - 3));
              out.put(features::copies(glm::vec3(a), glm::vec3(b), features::turn{a.w, b.w}));
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
             {"branches by type", 1, 0, 0},
             {"conversions", 1, 0, 0},
             {"copies", 1, 0, 0}});
  });
}

TEST_CASE("Atomics of both widths leave the same cells when 65536 invocations use them at once") {
  if (!the_device()->has_atomic_int64()) {
    MESSAGE("not run: " << the_device()->name() << " has no 64-bit atomics");
    return;
  }
  const std::uint32_t count = 65536U;
  const std::uint32_t bins = features::histogram<6>::bins;
  std::vector<std::uint32_t> given(count);
  for (std::uint32_t i = 0; i < count; ++i)
    given[i] = mixed_bits(i) | 0x100U;
  std::vector<std::uint32_t> built(2 + 8 + bins * count);
  std::vector<std::uint32_t> built_wide(8);
  built[2 + 1] = built[2 + 4] = built_wide[4] = built_wide[5] = 0xffffffffU;  // where a conjunction or minimum goes

  std::vector<std::uint32_t> expected(built.begin() + 2, built.end());
  std::vector<std::uint64_t> expected_wide = {0U, 0U, 0xffffffffffffffffU, 0U};
  std::uint32_t total = 0U;
  features::cells storage{expected, expected_wide, &total};
  for (std::uint32_t i = 0; i < count; ++i) {
    features::use(storage, i, given[i]);
    features::tally::add<6>(storage, given[i]);
    features::histogram<6> held{};
    for (std::uint32_t bin = 0; bin < bins; ++bin)
      held.held[bin] = features::place_in<6>(storage, given[i] + bin);
    held.store(storage, 8U + i * bins);
  }
  std::vector<std::uint32_t>* const buffers[] = {&given, &built, &built_wide};
  the_device()->run(kernels::storage, count, buffers);
  CHECK(built[0] == total);
  CHECK(built[1] == 0U);
  const std::uint32_t claimed = built[2 + 5];  // by whoever came first
  CHECK(claimed >= 1U);
  CHECK(claimed <= count);
  built[2 + 5] = expected[5];
  CHECK(std::equal(expected.begin(), expected.end(), built.begin() + 2));
  for (std::size_t i = 0; i < expected_wide.size(); ++i)
    CHECK((static_cast<std::uint64_t>(built_wide[2 * i + 1]) << 32U | built_wide[2 * i]) == expected_wide[i]);
}

}  // namespace pelage::test
