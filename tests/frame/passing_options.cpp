// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The program's options for what fibres let pass, and for how they read the lights' maps.
#include "frame/terminal.hpp"

#include <set>
#include <string>

namespace pelage::test {

TEST_CASE("constant attenuation and filtered look-ups are what is drawn without a word, others draw another") {
  const terminal t;
  REQUIRE(t.run(tiny + "--out a.png") == 0);
  const std::string first = text_of(t.folder / "a.png");
  REQUIRE(t.run(tiny + "--out b.png --attenuation constant --lookup filtered") == 0);
  CHECK(text_of(t.folder / "b.png") == first);
  std::set<std::string> pictures{first};
  for (const std::string options :
       {"--lookup jittered", "--attenuation fresnel", "--attenuation fresnel --eta 2.5",
        "--attenuation fresnel --bsdf marschner --eta 2.5", "--attenuation fresnel --bsdf chiang"}) {
    CAPTURE(options);
    REQUIRE(t.run(tiny + "--out b.png " + options) == 0);
    CHECK(pictures.insert(text_of(t.folder / "b.png")).second);
  }
}

TEST_CASE("words that no option has, and options that have no meaning together, are refused in one line") {
  const terminal t;
  t.check_refused(tiny + "--out a.png --attenuation half", "--attenuation");
  t.check_refused(tiny + "--out a.png --lookup sharp", "--lookup");
  t.check_refused(tiny + "--out a.png --attenuation fresnel --alpha 0.5", "--alpha needs --attenuation constant");
  t.check_refused(tiny + "--out a.png --attenuation fresnel --bsdf dual_scattering",
                  "--bsdf dual_scattering needs --attenuation constant");
  t.check_refused(tiny + "--out a.png --eta 1.5", "or --attenuation fresnel");
  t.check_refused(tiny + "--out a.png --attenuation fresnel --tilt 3", "--tilt");
}

TEST_CASE("a turn is a number of degrees, which may be 0, and a line that refuses one says so") {
  const terminal t;
  t.check_refused(tiny + "--out a.png --turn nan", "--turn must be in [-360, 360]");
  t.check_refused(tiny + "--out a.png --turn nan --frames 3", "--turn must be in [-360, 360]");
  t.check_refused(tiny + "--out a.png --from=nan,0", "azimuth");
  REQUIRE(t.run(tiny + "--out a.png") == 0);
  REQUIRE(t.run(tiny + "--out b.png --turn 0 --frames 3") == 0);
  CHECK(text_of(t.folder / "a.png") == text_of(t.folder / "b.png"));
}

TEST_CASE(
    "a wind leaves the picture of its last frame, of amplitude 0 that of rest, and what it cannot do is refused") {
  const terminal t;
  REQUIRE(t.run(tiny + "--out a.png") == 0);
  const std::string rest = text_of(t.folder / "a.png");
  REQUIRE(t.run(tiny + "--out b.png --sway 0 --frames 9") == 0);
  CHECK(text_of(t.folder / "b.png") == rest);
  std::set<std::string> pictures{rest};
  for (const std::string options :
       {"--sway 0.2", "--sway 0.2 --frames 9", "--sway 0.2 --frames 9 --crowd 2",
        "--sway 0.2 --frames 9 --segment-error 1 --strand-error 4", "--sway 0.4 --frames 9"}) {
    CAPTURE(options);
    REQUIRE(t.run(tiny + "--out b.png --report r.json " + options) == 0);
    CHECK(pictures.insert(text_of(t.folder / "b.png")).second);
  }
  CHECK(text_of(t.folder / "r.json").find("\"sway\": 0.4") != std::string::npos);
  for (const std::string amplitude : {"-0.1", "1.1", "nan", "much"})
    t.check_refused(tiny + "--out a.png --sway " + amplitude, "--sway");
  t.check_refused(tiny + "--out a.png --sway 0.1 --turn 5 --frames 3", "--sway");
  t.check_refused(tiny + "--out a.png --sway 0.1 --blend sliced", "--sway: --blend sliced");
  t.check_refused(tiny + "--out a.png --sway 0.1 --blend sliced_clipped:16", "--sway: --blend sliced");
}

}  // namespace pelage::test
