// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The program's options for Kajiya-Kay's lobes, ambient light and interpolated strands.
#include "frame/terminal.hpp"

#include <string>

namespace pelage::test {

TEST_CASE("Kajiya-Kay's numbers and ambient light: the defaults are what is drawn without them, others draw another") {
  const terminal t;
  REQUIRE(t.run(tiny + "--out a.png") == 0);
  const std::string first = text_of(t.folder / "a.png");
  REQUIRE(t.run(tiny + "--out b.png --diffuse 0.55 --specular 0.22 --exponent 60 --ambient 0") == 0);
  CHECK(text_of(t.folder / "b.png") == first);
  std::set<std::string> pictures{first};
  for (const std::string options : {"--diffuse 0.2", "--specular 0.9", "--exponent 5", "--ambient 0.4",
                                    "--ambient 0.4,0.1,0", "--bsdf chiang", "--bsdf chiang --ambient 0.4"}) {
    CAPTURE(options);
    REQUIRE(t.run(tiny + "--out b.png " + options) == 0);
    CHECK(pictures.insert(text_of(t.folder / "b.png")).second);
  }
  REQUIRE(t.run(tiny + "--out b.png --ambient 0.4,0.4,0.4") == 0);
  CHECK_FALSE(pictures.insert(text_of(t.folder / "b.png")).second);
}

TEST_CASE("numbers beyond their ranges, and options that have no meaning, are refused in one line") {
  const terminal t;
  for (const std::string options :
       {"--diffuse -1", "--diffuse 101", "--diffuse much", "--specular -0.1", "--specular 101", "--exponent -1",
        "--exponent 10001", "--ambient -1", "--ambient 1,2", "--ambient 1,2,3,4", "--ambient 2e6", "--ambient light"}) {
    t.check_refused(tiny + "--out a.png " + options, options.substr(0, options.find(' ')));
  }
  t.check_refused(tiny + "--out a.png --diffuse nan", "the diffuse weight must be in [0, 100]");
  t.check_refused(tiny + "--out a.png --specular nan", "the specular weight must be in [0, 100]");
  t.check_refused(tiny + "--out a.png --exponent nan", "the highlight's exponent must be in [0, 10000]");
  t.check_refused(tiny + "--out a.png --ambient nan", "ambient light must be in [0, 1e6]");
  for (const std::string lobe : {"--diffuse 0.5", "--specular 0.2", "--exponent 60"})
    t.check_refused("--out a.png --bsdf marschner " + lobe, "needs --bsdf kajiya_kay");

  t.write("a.tfx", tfx_bytes());
  const std::string file = "--hair a.tfx --size 24 --out a.png ";
  t.check_refused("--out a.png --interpolate 3", "--interpolate");
  t.check_refused(file + "--clump 0.5", "--clump");
  t.check_refused(file + "--interpolate -1", "--interpolate");
  t.check_refused(file + "--interpolate 4097", "--interpolate");
  t.check_refused(file + "--interpolate 3 --clump 1.5", "--clump");
  t.check_refused(file + "--interpolate 3 --clump nan", "the clump of strands is not in [0, 1]");
}

TEST_CASE("strands between guides are drawn as many as asked for, followed if there should be some") {
  const terminal t;
  t.write("a.hair", hair_bytes());
  REQUIRE(t.run("--hair a.hair --interpolate 4 --size 24 --out a.png") == 0);
  CHECK(t.printed().starts_with("a.png: 100 strands, 400 segments, "));
  REQUIRE(t.run("--hair a.hair --interpolate 4 --clump 1 --size 24 --out b.png") == 0);
  CHECK(text_of(t.folder / "a.png") != text_of(t.folder / "b.png"));
  REQUIRE(t.run("--hair a.hair --interpolate 4 --follow 1 --size 24 --out c.png") == 0);
  CHECK(t.printed().starts_with("c.png: 200 strands, 800 segments, "));
}

}  // namespace pelage::test
