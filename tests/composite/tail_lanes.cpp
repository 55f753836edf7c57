// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#include <pelage/composite/tail_lanes.hpp>

#include "property.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace pelage::test {

/// Any bits, mostly of ordinary alphas and colours.
float any_amount() {
  return *rc::gen::inRange(0, 8) == 0 ? std::bit_cast<float>(*rc::gen::arbitrary<std::uint32_t>())
                                      : static_cast<float>(*rc::gen::inRange(0, 3000)) / 2000.0f;
}

bool same_tail(const tail& a, const tail& b) {
  return a.optical == b.optical && a.weight == b.weight && a.red == b.red && a.green == b.green && a.blue == b.blue;
}

template <int W>
void check_fragments() {
  std::array<float, W> alpha, red, green, blue;
  std::array<std::uint32_t, std::size_t{W}> tail_of;
  std::vector<tail> together(3, empty_tail());
  together[1] = tail{0xfffff000u, 0xffffff00u, 0u, 0xffffffffu, 0xfffffff0u};  // about to saturate
  std::vector<tail> alone = together;
  const std::uint32_t set = *rc::gen::arbitrary<std::uint32_t>() & all_bits<W>();
  for (std::size_t k = 0; k < W; ++k) {
    alpha[k] = any_amount();
    red[k] = any_amount();
    green[k] = any_amount();
    blue[k] = any_amount();
    tail_of[k] = *rc::gen::inRange(0u, 3u);
    if ((set >> k & 1u) != 0u) {
      alone[tail_of[k]] = add_fragment(alone[tail_of[k]], alpha[k], glm::vec3(red[k], green[k], blue[k]));
    }
  }
  const lane_vector<W> colour{lanes<W>::load(red.data()), lanes<W>::load(green.data()), lanes<W>::load(blue.data())};
  add_fragments(lanes<W>::load(alpha.data()), colour, set, tail_of, together);
  for (std::size_t i = 0; i < 3; ++i)
    RC_ASSERT(same_tail(together[i], alone[i]));
}

TEST_CASE("fragments of lanes end in the tails that they would make one by one") {
  holds("4 lanes", check_fragments<4>);
  holds("8 lanes", check_fragments<8>);
  holds("16 lanes", check_fragments<16>);
}

}  // namespace pelage::test
