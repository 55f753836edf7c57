// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
#pragma once
#include <doctest/doctest.h>
#include <rapidcheck.h>
#include <sstream>
#include <string>
#include <utility>

namespace pelage::test {

/// Checks a rapidcheck property as one doctest check.
///
///     TEST_CASE("before is a strict order") {
///       holds("no fragment stands before itself", [](float depth, std::uint32_t id) {
///         RC_ASSERT(!before(fragment{depth, id}, fragment{depth, id}));
///       });
///     }
///
/// The arguments are drawn at random, or inside by `*rc::gen::inRange(0, 8)`. RC_ASSERT states what must hold,
/// RC_PRE drops a draw that the claim is not about. A failure shows the smallest counterexample, and at the end of
/// the run the setting that repeats it: `RC_PARAMS="reproduce=..." build/dev/tests/test_core_fragment`. `claim` is
/// the property's key there, so no other of the file has its name. RC_PARAMS="seed=7 max_success=10000" draws
/// other and more cases.
template <typename Property>
void holds(const std::string& claim, Property&& property) {
  rc::detail::TestMetadata metadata;
  metadata.id = claim;
  metadata.description = claim;
  const auto result = rc::detail::checkTestable(std::forward<Property>(property), metadata);
  std::ostringstream message;
  rc::detail::printResultMessage(result, message);
  const bool claim_holds = result.template is<rc::detail::SuccessResult>();
  CHECK_MESSAGE(claim_holds, claim, "\n", message.str());
}

}  // namespace pelage::test
