// Copyright (c) 2026 The Pelage authors
// SPDX-License-Identifier: MIT
// The program pelage-frame from outside: exit status, what it says, and what it leaves behind.
#include <nlohmann/json.hpp>

#include "frame/fibres.hpp"
#include "frame/image/image.hpp"
#include "frame/terminal.hpp"

#include <algorithm>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace pelage::test {

TEST_CASE("a frame is a picture of the size that was asked for, in the folder that was asked for") {
  const terminal t;
  REQUIRE(t.run("--strands 60 --segments 6 --size 24x16 --out new/folder/a.png") == 0);
  CHECK(t.complaint().empty());
  CHECK(t.files() == std::set<std::string>{"new", "new/folder", "new/folder/a.png"});
  CHECK(t.printed().starts_with("new/folder/a.png: 60 strands, 360 segments, "));
  const image picture = load_png(t.folder / "new/folder/a.png");
  CHECK(picture.width == 24);
  CHECK(picture.height == 16);
}

TEST_CASE("the report has every pass with its fragments, longest list, memory and losses") {
  const terminal t;
  REQUIRE(t.run(tiny + "--out a.png --report r.json --threads 3") == 0);
  CHECK(t.files() == std::set<std::string>{"a.png", "r.json"});
  const nlohmann::json report = nlohmann::json::parse(text_of(t.folder / "r.json"));
  CHECK(report["strands"] == 60);
  CHECK(report["segments"] == 360);
  CHECK(report["width"] == 24);
  CHECK(report["k"] == 4);
  CHECK(report["order"] == "k_buffer");
  CHECK(report["shadow"] == "k_buffer");
  CHECK(report["blend"] == "k_buffer");
  CHECK(report["components"] == "full");
  CHECK(report["threads"] == 3);
  CHECK(report["seconds"] > 0.0);
  CHECK(report["peak_bytes"] > 0);
  REQUIRE(report["passes"].size() == 3);
  CHECK(report["passes"][2]["name"] == "camera");
  for (const nlohmann::json& pass : report["passes"]) {
    CHECK(pass["fragments"] > 0);
    CHECK(pass["longest_list"] > 0);
    CHECK(pass["longest_list"] <= pass["fragments"]);
    CHECK(pass["structure_bytes"] > 0);
    CHECK(pass["result_bytes"] > 0);
    CHECK(pass["refused"] == 0);
    for (const char* time : {"prepare_seconds", "bin_seconds", "build_seconds", "resolve_seconds"})
      CHECK(pass[time] >= 0.0);
  }
}

TEST_CASE("errors of detail and a crowd say how much is drawn, and without them the file is the same") {
  const terminal t;
  REQUIRE(t.run(tiny + "--out a.png --report a.json") == 0);
  CHECK(t.printed().find(" drawn, ") == std::string::npos);
  REQUIRE(t.run(tiny + "--out b.png --segment-error 0 --strand-error 0 --crowd 1") == 0);
  CHECK(text_of(t.folder / "a.png") == text_of(t.folder / "b.png"));
  const nlohmann::json full = nlohmann::json::parse(text_of(t.folder / "a.json"));
  CHECK(full["strands_drawn"] == 60);
  CHECK(full["segments_drawn"] == 360);
  CHECK(full["detail_seconds"] == 0.0);
  REQUIRE(t.run(tiny + "--out c.png --segment-error 2 --strand-error 4 --crowd 3 --report c.json") == 0);
  CHECK(t.printed().find(" drawn, ") != std::string::npos);
  const nlohmann::json few = nlohmann::json::parse(text_of(t.folder / "c.json"));
  CHECK(few["strands"] == 60);
  CHECK(few["crowd"] == 3);
  CHECK(few["strands_drawn"] > 0);
  CHECK(few["strands_drawn"] < 180);
  CHECK(few["segments_drawn"] < 1080);
  CHECK(few["detail_seconds"] > 0.0);
}

TEST_CASE("structures, threads and drawing orders leave the same file; other options leave another") {
  const terminal t;
  REQUIRE(t.run(tiny + "--out a.png") == 0);
  const std::string first = text_of(t.folder / "a.png");
  for (const std::string options : {"--order a_buffer --threads 4", "--order unrolled_list --threads 3",
                                    "--order ordered_list --shuffle 5", "--threads 1 --shuffle 6"}) {
    CAPTURE(options);
    REQUIRE(t.run(tiny + "--out b.png " + options) == 0);
    CHECK(text_of(t.folder / "b.png") == first);
  }
  for (const std::string options :
       {"--aa off", "--components single", "--alpha 0.1", "--fibre-radius 0.05", "--seed 2", "--from 90,10",
        "--map-size 5", "--order full_sort --alpha 0.1", "--lights point:3,3,3:1,1,1 spot:-4,1,0:2,0,0:30"}) {
    CAPTURE(options);
    REQUIRE(t.run(tiny + "--out b.png " + options) == 0);
    CHECK(text_of(t.folder / "b.png") != first);
  }
}

TEST_CASE("each model, colour, index, roughness and tilt leaves a picture of its own") {
  const terminal t;
  std::set<std::string> pictures;
  std::size_t runs = 0;
  for (const std::string options :
       {"", "--bsdf marschner", "--bsdf chiang", "--bsdf dual_scattering", "--hair-colour blond",
        "--bsdf chiang --hair-colour red", "--bsdf chiang --melanin 0.2", "--bsdf chiang --melanin 0.2,1.1",
        "--bsdf chiang --eta 1.3", "--bsdf chiang --beta 0.4", "--bsdf chiang --beta 0.2,0.6",
        "--bsdf marschner --tilt -10"}) {
    CAPTURE(options);
    REQUIRE(t.run(tiny + "--out a.png --report r.json " + options) == 0);
    CHECK(pictures.insert(text_of(t.folder / "a.png")).second);
    ++runs;
  }
  CHECK(nlohmann::json::parse(text_of(t.folder / "r.json"))["bsdf"] == "marschner");
  // Presets are names for pigments.
  REQUIRE(t.run(tiny + "--out a.png --bsdf chiang --melanin 0.05,0.8 --beta 0.2,0.3 --eta 1.55 --tilt 2") == 0);
  CHECK_FALSE(pictures.insert(text_of(t.folder / "a.png")).second);
  CHECK(pictures.size() == runs);
}

TEST_CASE("a picture compared with itself differs by nothing, and with another by something") {
  const terminal t;
  REQUIRE(t.run(tiny + "--out a.png") == 0);
  REQUIRE(t.run(tiny + "--out b.png --compare a.png --report r.json") == 0);
  CHECK(t.files() == std::set<std::string>{"a.png", "b.png", "b.error.png", "r.json"});
  const nlohmann::json same = nlohmann::json::parse(text_of(t.folder / "r.json"));
  CHECK(same["rms"] == 0.0);
  CHECK(same["maximum"] == 0.0);
  CHECK(t.printed().find("b.error.png: RMS 0.00000, maximum 0.00000 of a.png\n") != std::string::npos);
  const image map = load_png(t.folder / "b.error.png");
  CHECK(std::all_of(map.pixels.begin(), map.pixels.end(), [](glm::vec3 p) { return p == glm::vec3(0.0F); }));

  // In place: the other picture is read before it is written over.
  REQUIRE(t.run(tiny + "--alpha 0.05 --out a.png --compare a.png --report r.json") == 0);
  CHECK(nlohmann::json::parse(text_of(t.folder / "r.json"))["rms"] > 0.0);
}

TEST_CASE("hair files are drawn, with follow strands if there should be some") {
  const terminal t;
  t.write("a.hair", hair_bytes());
  t.write("a.tfx", tfx_bytes());
  REQUIRE(t.run("--hair a.hair --size 24 --out a.png") == 0);
  CHECK(t.printed().starts_with("a.png: 20 strands, 80 segments, "));
  REQUIRE(t.run("--hair a.tfx --size 24 --out b.png") == 0);
  CHECK(t.printed().starts_with("b.png: 2 strands, 2 segments, "));
  REQUIRE(t.run("--hair a.tfx --follow 4 --size 24 --out c.png") == 0);
  CHECK(t.printed().starts_with("c.png: 10 strands, 10 segments, "));
  CHECK(text_of(t.folder / "c.png") != text_of(t.folder / "b.png"));
}

TEST_CASE("a file that is not whole and sound is refused in one line, and nothing is written") {
  const terminal t;
  std::vector<std::byte> bytes = hair_bytes();
  t.write("short.hair", std::span(bytes).first(bytes.size() - 1));
  const float not_a_number = std::numeric_limits<float>::quiet_NaN();
  std::copy_n(std::as_bytes(std::span(&not_a_number, 1)).begin(), 4, bytes.begin() + 128 + 20 * 2 + 16);
  t.write("nan.hair", bytes);
  bytes = tfx_bytes();
  bytes.resize(bytes.size() + 64);  // what belongs to no array
  t.write("long.tfx", bytes);
  bytes.resize(bytes.size() / 2);
  t.write("short.tfx", bytes);

  t.check_refused("--out a.png --hair short.hair", "short.hair: offset ");
  t.check_refused("--out a.png --hair nan.hair", "nan.hair: offset 184: ");
  t.check_refused("--out a.png --hair long.tfx", "long.tfx: offset 224: ");
  t.check_refused("--out a.png --hair short.tfx", "short.tfx: offset ");
  t.check_refused("--out a.png --hair missing.hair", "missing.hair: offset 0: ");
  t.check_refused("--out a.png --hair 'two\nlines.hair'", "lines.hair: offset 0: ");
  t.check_refused("--out a.png --hair .", ".: offset 0: not a regular file");
}

TEST_CASE("an option that cannot be is refused in one line, and nothing is written") {
  const terminal t;
  for (const std::string size : {"0", "16385", "-4", "24x", "x24", "24x24x24", "24.5", "wide", "''"}) {
    t.check_refused("--out a.png --size " + size, "--size");
  }
  for (const std::string k : {"0", "3", "128", "many"})
    t.check_refused("--out a.png --k " + k, "--k");
  t.check_refused("--out a.png --order bubble_sort", "--order");
  t.check_refused("--out a.png --shadow opacity:0", "--shadow 'opacity:0': opacity must be followed by :N");
  t.check_refused("--out a.png --shadow deep:nan", "--shadow 'deep:nan'");
  t.check_refused("--out a.png --tail sliced:5", "--tail 'sliced:5': sliced must be followed by :N");
  for (const std::string error : {"-1", "65", "x"}) {
    t.check_refused("--out a.png --segment-error " + error, "--segment-error");
    t.check_refused("--out a.png --strand-error " + error, "--strand-error");
  }
  t.check_refused(tiny + "--out a.png --segment-error nan", "errors of detail");
  t.check_refused("--out a.png --crowd 0", "--crowd");
  t.check_refused("--out a.png --crowd 4096 --strands 20000 --segments 48 --size 24", "the crowd would need ");
  t.check_refused("--out a.png --tail none --blend exact", "--tail needs --blend k_buffer");
  t.check_refused("--out a.png --tail sliced:16 --device vulkan", "--tail: --device vulkan keeps the mean");
  t.check_refused("--out a.png --blend stochastic:x", "--blend 'stochastic:x': stochastic must be followed by :N");
  t.check_refused("--out a.png --components most", "--components");
  t.check_refused("--out a.png --aa maybe", "--aa");
  t.check_refused("--out a.png --alpha 1.5", "--alpha");
  t.check_refused(tiny + "--out a.png --alpha nan", "alpha");
  t.check_refused("--out a.png --fibre-radius -1", "--fibre-radius");
  t.check_refused(tiny + "--out a.png --fibre-radius nan", "radius");
  t.check_refused("--out a.png --threads -1", "--threads");
  t.check_refused("--out a.png --strands -1", "--strands");
  t.check_refused("--out a.png --segments 0", "1 segment");
  t.check_refused(tiny + "--out a.png --map-size -1", "map");
  t.check_refused(tiny + "--out a.png --from 0,90", "elevation");
  t.check_refused("--out a.png --lights moon:1,1,1:1,1,1", "light 'moon:1,1,1:1,1,1'");
  t.check_refused("--out a.png --lights 'point:1,1\n,1:1,1,1:'", "light 'point");
  t.check_refused(tiny + "--out a.png --lights point:0.1,0,0:1,1,1", "inside the model");
  t.check_refused("--out a.png --bsdf lambert", "--bsdf");
  t.check_refused("--out a.png --hair-colour green", "--hair-colour");
  t.check_refused("--out a.png --hair-colour red --melanin 1", "--melanin");
  for (const std::string melanin : {"-1", "101", "1,-1", "1,2,3", "much"})
    t.check_refused(tiny + "--out a.png --melanin " + melanin, "--melanin");
  for (const std::string physical :
       {"--eta 0.9", "--eta 3.1", "--beta 0", "--beta 1.1", "--beta 0.3,0", "--tilt 21", "--tilt -21"})
    t.check_refused("--out a.png --bsdf chiang " + physical, physical.substr(0, physical.find(' ')));
  for (const std::string unknown : {"--melanin nan", "--eta nan", "--beta nan", "--beta 0.3,nan", "--tilt nan"})
    t.check_refused(tiny + "--out a.png --bsdf chiang " + unknown, " must be in [");
  t.check_refused("--out a.png --bsdf marschner --beta 0.3,0.4", "--beta");
  for (const std::string physical : {"--eta 1.5", "--beta 0.2", "--tilt 3"})
    t.check_refused("--out a.png " + physical, "needs --bsdf marschner, chiang or dual_scattering");
  for (const std::string spacing : {"0", "4", "nan"})
    t.check_refused("--out a.png --device vulkan --shading-spacing " + spacing, "--shading-spacing: --device vulkan");
  t.check_refused("--out a.png --device vulkan --bsdf chiang --shading-spacing inf", "pelage-frame: --device vulkan: ");
  t.check_refused(tiny + "--out a.png --frames 1", "--frames needs --device vulkan");

  t.check_refused("--out a.png --unheard-of", "--unheard-of");
  t.check_refused("--out a.png stray", "stray");

  t.write("a.tfx", tfx_bytes());
  t.check_refused("--out a.png --hair a.tfx --follow -1", "--follow");
  t.check_refused("--out a.png --hair a.tfx --follow 1 --follow-radius nan", "radius");
}

TEST_CASE("an output that cannot be written, or nothing to compare with, leaves no other output behind") {
  const terminal t;
  fs::create_directory(t.folder / "folder.png");
  t.write("file", hair_bytes());
  t.check_refused(tiny + "--out folder.png", "folder.png: is not a regular file");
  t.check_refused(tiny + "--out file/a.png", "file");
  t.check_refused(tiny + "--out /proc/none/a.png", "/proc/none");
  t.check_refused(tiny + "--out a.png --report file/r.json", "file/r.json: cannot be written");
  t.check_refused(tiny + "--out a.png --compare missing.png", "missing.png: offset 0: ");
  t.check_refused(tiny + "--out a.png --compare file", "file: offset 0: ");

  REQUIRE(t.run("--strands 60 --segments 6 --size 24x16 --out wide.png") == 0);
  t.check_refused(tiny + "--out a.png --compare wide.png", "wide.png: 24 x 16 pixels, but the frame has 24 x 24");
  REQUIRE(t.run(tiny + "--out good.png") == 0);
  t.check_refused(tiny + "--out a.png --compare good.png --report file/r.json", "file/r.json: cannot be written");
}

TEST_CASE("help is no failure") {
  const terminal t;
  CHECK(t.run("--help") == 0);
  CHECK(t.complaint().empty());
  for (const char* option :
       {"--hair",    "--follow", "--strands",    "--segments", "--seed",         "--size",   "--k",
        "--order",   "--shadow", "--components", "--aa",       "--alpha",        "--bsdf",   "--hair-colour",
        "--melanin", "--eta",    "--beta",       "--tilt",     "--fibre-radius", "--lights", "--threads",
        "--out",     "--report", "--compare"}) {
    CHECK(t.printed().find(option) != std::string::npos);
  }
}

}  // namespace pelage::test
