// hardsphere draw from outside: its options, what they change in the file, and what is left when something fails.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

const std::string water = "good/water.pdb";

std::string crambin() {
  return molecules_folder() + "/crambin.pdb";
}

Outcome draw_to(const std::string &out, const std::string &file, std::vector<std::string> options = {}) {
  options.insert(options.begin(), {"draw", file, "-o", out});
  return run_program(options);
}

// The bytes of a picture; empty after a failed test.
std::string drawn(const std::string &file, const std::vector<std::string> &options = {},
                  const std::string &extension = ".svg") {
  const TemporaryFile out("drawn" + extension);
  const Outcome outcome = draw_to(out.path(), file, options);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return std::filesystem::exists(out.path()) ? read_file(out.path()) : "";
}

size_t occurrences(const std::string &text, const std::string &part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

TEST(Draw, EveryFormatBeginsWithItsMagicAndEndsWell) {
  for (const std::vector<std::string> &input :
       {std::vector<std::string>{crambin()}, std::vector<std::string>{"good/point.xyzr"},
        std::vector<std::string>{"good/points.xyzr"}}) {
    for (const char *style : {"flat", "headlight", "soft"}) {
      const std::vector<std::string> options = {"--style", style};
      const std::string svg = drawn(input[0], options, ".svg");
      EXPECT_EQ(svg.rfind("<?xml", 0) == 0 || svg.rfind("<svg", 0) == 0, true);
      EXPECT_EQ(svg.substr(svg.size() < 7 ? 0 : svg.size() - 7), "</svg>\n");
      const std::string eps = drawn(input[0], options, ".eps");
      EXPECT_EQ(eps.rfind("%!PS-Adobe-3.", 0), 0u);
      EXPECT_NE(eps.find("\n%%EOF\n"), std::string::npos);
      const std::string pdf = drawn(input[0], options, ".pdf");
      EXPECT_EQ(pdf.rfind("%PDF-1.", 0), 0u);
      EXPECT_NE(pdf.find("\n%%EOF\n"), std::string::npos);
    }
  }
}

TEST(Draw, TheExtensionMayBeInCapitals) {
  EXPECT_EQ(drawn(water, {}, ".SVG"), drawn(water));
  EXPECT_EQ(drawn(water, {}, ".Pdf"), drawn(water, {}, ".pdf"));
}

TEST(Draw, SameBytesTwice) {
  for (const char *extension : {".svg", ".eps", ".pdf"}) {
    EXPECT_TRUE(drawn(crambin(), {}, extension) == drawn(crambin(), {}, extension)) << extension;
  }
}

// The picture of the file in another order, its ids set back, is the same picture.
TEST(Draw, TheOrderOfAtomsChangesNothingButIds) {
  std::istringstream lines(read_file(crambin()));
  std::vector<std::string> atoms;
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("ATOM", 0) == 0) atoms.push_back(line);
  }
  ASSERT_EQ(atoms.size(), 327u);
  std::string reversed;
  std::for_each(atoms.rbegin(), atoms.rend(), [&](const std::string &line) { reversed += line + "\n"; });
  const TemporaryFile other("reversed.pdb", reversed);
  for (const char *style : {"flat", "soft"}) {
    const std::vector<std::string> options = {"--title", "crambin", "--style", style, "--occlusion", "0.7"};
    const std::string expected = drawn(crambin(), options);
    std::string found = drawn(other.path(), options);
    std::string renamed;
    size_t begin = 0;
    int ids = 0;
    const std::string key = "data-ball=\"";
    for (size_t at = found.find(key); at != std::string::npos; at = found.find(key, begin), ++ids) {
      at += key.size();
      renamed += found.substr(begin, at - begin) + std::to_string(326 - std::stoi(found.substr(at)));
      begin = found.find('"', at);
    }
    renamed += found.substr(begin);
    EXPECT_GT(ids, 100);
    EXPECT_TRUE(renamed == expected) << style;
    for (const char *extension : {".eps", ".pdf"}) {
      EXPECT_TRUE(drawn(other.path(), options, extension) == drawn(crambin(), options, extension)) << extension;
    }
  }
}

TEST(Draw, JsonSaysWhatStandsInTheFile) {
  struct Case {
    std::vector<std::string> options;
    double width;
    std::string unit;
  };
  const std::vector<Case> cases = {{{}, 1000, "px"},
                                   {{"--width", "250"}, 250, "px"},
                                   {{"--unit", "mm"}, 170, "mm"},
                                   {{"--width", "80", "--unit", "mm"}, 80, "mm"},
                                   {{"--width", "300", "--height", "500"}, 300, "px"},
                                   {{"--height", "500"}, 0, "px"},
                                   {{"--margin", "0"}, 1000, "px"},
                                   {{"--margin=1.5"}, 1000, "px"}};
  for (const Case &it : cases) {
    const TemporaryFile out("said.svg");
    std::vector<std::string> arguments = {"draw", crambin(), "-o", out.path()};
    arguments.insert(arguments.end(), it.options.begin(), it.options.end());
    const Json json = run_json(arguments);
    EXPECT_EQ(json.keys, (std::vector<std::string>{"n", "pieces", "arcs", "bytes", "style", "palette", "width",
                                                   "height", "occlusion", "input"}));
    const std::string svg = read_file(out.path());
    EXPECT_EQ(json["n"].number, 327);
    EXPECT_EQ(json["bytes"].number, static_cast<double>(svg.size()));
    EXPECT_EQ(json["style"].text, "soft");
    EXPECT_EQ(json["pieces"].number, static_cast<double>(occurrences(svg, "data-ball=")));
    EXPECT_GE(json["arcs"].number, 2 * json["pieces"].number);
    double width = 0;
    double height = 0;
    char unit[2][3] = {};
    ASSERT_EQ(std::sscanf(svg.substr(svg.find(" width=")).c_str(), " width=\"%lf%2[a-z]\" height=\"%lf%2[a-z]\"",
                          &width, unit[0], &height, unit[1]),
              4);
    EXPECT_EQ(unit[0], it.unit);
    EXPECT_EQ(unit[1], it.unit);
    EXPECT_NEAR(json["width"].number, width, 1e-5);
    EXPECT_NEAR(json["height"].number, height, 1e-5);
    if (it.width > 0) {
      EXPECT_EQ(json["width"].number, it.width);
    }
  }
}

// A point and a scale of one's own: the same in every direction, cut off at the edges.
TEST(Draw, FixedFrames) {
  const TemporaryFile file("pair.xyzr", "0 0 0 1\n7 0 0 2\n");
  const std::vector<std::string> scale = {"--scale", "10", "--width", "90", "--style", "flat"};
  const auto with = [&scale](std::vector<std::string> options) {
    options.insert(options.end(), scale.begin(), scale.end());
    return options;
  };
  // The middle of the centres is at 3.5: the first ball reaches from 0 to 20 px, the second from 60 to 100.
  const std::string seen = drawn(file.path(), with({}));
  EXPECT_NE(seen.find(" viewBox=\"0 0 90 90\""), std::string::npos);
  EXPECT_NE(seen.find(" cx=\"10\" cy=\"45\" r=\"10\""), std::string::npos) << seen;
  EXPECT_NE(seen.find(" cx=\"80\" cy=\"45\" r=\"20\""), std::string::npos) << seen;
  EXPECT_TRUE(seen == drawn(file.path(), with({"--centre", "3.5,0,0"})));
  const std::string behind = drawn(file.path(), with({"--centre=7,1,9", "--view", "0,0,-1", "--up", "0,1,0"}));
  EXPECT_NE(behind.find(" cx=\"45\" cy=\"55\" r=\"20\""), std::string::npos) << behind;
  EXPECT_NE(behind.find(" cx=\"115\" cy=\"55\" r=\"10\""), std::string::npos) << behind;
  const TemporaryFile out("pair.eps");
  const Json json = run_json({"draw", file.path(), "-o", out.path(), "--scale", "1", "--height", "50", "--unit", "mm"});
  EXPECT_EQ(json["width"].number, 50);
  EXPECT_EQ(json["height"].number, 50);
  EXPECT_EQ(occurrences(read_file(out.path()), "rectclip"), 0u);
  for (const auto &[options, complaint] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"--centre", "1,2,3"}, "--centre needs --scale"},
           {{"--scale", "0"}, "--scale must be above 0"},
           {{"--scale", "2", "--margin", "0.1"}, "either --margin"},
           {{"--scale", "2", "--centre", "1,2"}, "--centre needs 3 numbers"}}) {
    std::vector<std::string> arguments = {"draw", file.path(), "-o", out.path()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(complaint), std::string::npos) << outcome.err;
  }
  const Outcome far = run_program({"draw", file.path(), "-o", out.path(), "--scale", "1e9"});
  EXPECT_EQ(far.status, 1);
  EXPECT_NE(far.err.find("a value lies beyond"), std::string::npos) << far.err;
}

// One ball: the picture is a square, whatever the margin, with a single piece and at least one arc.
TEST(Draw, TableOfASingleBall) {
  const TemporaryFile out("ball.svg");
  const Outcome outcome = draw_to(out.path(), "good/one.xyzr");
  const std::string size = std::to_string(std::filesystem::file_size(out.path()));
  EXPECT_EQ(outcome.out,
            "good/one.xyzr\n"
            "  balls            1\n"
            "  radii            from the file\n"
            "  probe            none: the van der Waals surface, by the radii as they are\n"
            "\n"
            "  picture          SVG, soft, 1000 x 1000 px\n"
            "  view             (0, 0, 1) towards the viewer, (0, 1, 0) up\n"
            "  palette          soft           by element\n"
            "  occlusion        0              no ball is darkened\n"
            "  pieces           1              painted one over the other, farthest first\n"
            "  arcs             1              of circles and ellipses around them\n"
            "  bytes            " +
                size + "\n");
}

TEST(Draw, NothingToSeeIsAPictureToo) {
  for (const char *file : {"good/point.xyzr", "good/points.xyzr"}) {
    for (const char *extension : {".svg", ".eps", ".pdf"}) {
      const TemporaryFile out(std::string("nothing") + extension);
      for (const char *pieces : {"h", "visible"}) {
        const Json json = run_json({"draw", file, "-o", out.path(), "--pieces", pieces, "--occlusion", "1"});
        EXPECT_EQ(json["pieces"].number, 0);
        EXPECT_EQ(json["arcs"].number, 0);
        EXPECT_EQ(json["bytes"].number, static_cast<double>(std::filesystem::file_size(out.path())));
        EXPECT_GT(json["width"].number, 0);
        EXPECT_GT(json["height"].number, 0);
      }
    }
  }
}

// A ball behind a larger one is left out, unless all are asked for; the larger one comes last.
TEST(Draw, HiddenBalls) {
  const TemporaryFile file("hidden.xyzr", "0 0 9 2\n0.3 0 0 1\n");
  EXPECT_EQ(occurrences(drawn(file.path(), {"--view", "0,0,1"}), "data-ball="), 1u);
  const std::string all = drawn(file.path(), {"--all-balls", "--view", "0,0,1"});
  EXPECT_LT(all.find("data-ball=\"1\""), all.find("data-ball=\"0\""));
  EXPECT_NE(all.find("data-ball=\"0\""), std::string::npos);
  const std::string behind = drawn(file.path(), {"--view", "0,0,-1"});
  EXPECT_LT(behind.find("data-ball=\"0\""), behind.find("data-ball=\"1\""));
}

// With G only the nearer of two crossing balls is cut, with H both are.
TEST(Draw, Pieces) {
  const TemporaryFile file("pair.xyzr", "0 0 0 1\n1 0 0.5 1\n");
  const TemporaryFile out("pair.svg");
  const Json g = run_json({"draw", file.path(), "-o", out.path(), "--view", "0,0,1"});
  const Json h = run_json({"draw", file.path(), "-o", out.path(), "--view", "0,0,1", "--pieces", "h"});
  EXPECT_EQ(g["arcs"].number, 3);
  EXPECT_EQ(h["arcs"].number, 4);
  EXPECT_EQ(h["pieces"].number, 2);
}

// The visible pieces, from a map: a path for each ball that is seen, and the page of other pieces.
TEST(Draw, VisiblePieces) {
  const TemporaryFile out("visible.svg");
  for (const std::vector<std::string> &options :
       {std::vector<std::string>{}, std::vector<std::string>{"--probe", "1.4", "--rotate", "20,40,60"},
        std::vector<std::string>{"--height", "70", "--unit", "mm", "--style", "flat", "--outline", "0"},
        std::vector<std::string>{"--scale", "9", "--centre", "1,2,3"}}) {
    std::vector<std::string> arguments = {"draw", crambin(), "-o", out.path()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Json painted = run_json(arguments);
    arguments.insert(arguments.end(), {"--pieces", "visible"});
    const Json visible = run_json(arguments);
    const std::string svg = read_file(out.path());
    const std::vector<std::string> looking = {"map", crambin(), "--probe", "1.4", "--rotate", "20,40,60"};
    const Json map =
        run_json(options.size() == 4 && options[0] == "--probe" ? looking : std::vector<std::string>{"map", crambin()});
    EXPECT_EQ(visible["pieces"].number, map["visible_balls"].number);
    EXPECT_EQ(visible["arcs"].number, map["edges"].number);
    EXPECT_EQ(visible["bytes"].number, static_cast<double>(svg.size()));
    EXPECT_EQ(visible["pieces"].number, static_cast<double>(occurrences(svg, "data-ball=")));
    EXPECT_NEAR(visible["width"].number, painted["width"].number, 1e-5);
    EXPECT_NEAR(visible["height"].number, painted["height"].number, 1e-5);
  }
  const Outcome both = draw_to(out.path(), crambin(), {"--pieces", "visible", "--all-balls"});
  EXPECT_EQ(both.status, 2);
  EXPECT_NE(both.err.find("either --all-balls"), std::string::npos) << both.err;
}

TEST(Draw, ProbeMakesBallsLarger) {
  const TemporaryFile out("probe.svg");
  const TemporaryFile small("small.xyzr", "0 0 0 1\n3 0 0 1\n");
  const TemporaryFile large("large.xyzr", "0 0 0 2.5\n3 0 0 2.5\n");
  EXPECT_TRUE(drawn(small.path(), {"--probe", "1.5", "--title", "x"}) == drawn(large.path(), {"--title", "x"}));
}

TEST(Draw, TitlesAndBackgrounds) {
  EXPECT_NE(drawn(water).find("<title>water.pdb</title>"), std::string::npos);
  const std::string titled = drawn(water, {"--title", "2 < 3 & \"4\""});
  EXPECT_NE(titled.find("<title>2 &lt; 3 &amp; "), std::string::npos);
  EXPECT_EQ(drawn(water, {"--title", ""}).find("<title>"), std::string::npos);
  const std::string blue = drawn(water, {"--background", "1A2b3C", "--fog", "0"});
  EXPECT_NE(blue.find("1a2b3c"), std::string::npos);
  EXPECT_TRUE(blue == drawn(water, {"--background=#1a2b3c", "--fog", "0"}));
  const std::string none = drawn(water, {"--background", "none", "--fog", "0"});
  EXPECT_TRUE(none.size() < blue.size());
}

// Nothing fades to a colour that is not there; where it is known, balls fade to it as they do to a background.
TEST(Draw, FogAndLinesHaveColours) {
  const TemporaryFile file("far.xyzr", "0 0 0 1\n3 0 -40 1\n");
  const auto flat = [&file](std::vector<std::string> options) {
    options.insert(options.end(), {"--style", "flat", "--view", "0,0,1", "--occlusion", "0"});
    return drawn(file.path(), options);
  };
  const auto without_page = [](const std::string &svg) {
    const size_t page = svg.find("<rect");
    return page == std::string::npos ? svg : svg.substr(0, page) + svg.substr(svg.find("/>\n", page) + 3);
  };
  const std::string none = flat({"--background", "none"});
  EXPECT_EQ(occurrences(none, "<rect"), 0u);
  EXPECT_TRUE(none == flat({"--background", "none", "--fog", "0"}));
  EXPECT_TRUE(none == flat({"--background", "none", "--fog-colour", "000000", "--fog", "0"}));
  EXPECT_EQ(occurrences(none, "fill=\"#d2cdc3\""), 2u) << none;
  const std::string dark = flat({"--background", "none", "--fog-colour", "#101820"});
  EXPECT_TRUE(dark == without_page(flat({"--background", "101820"})));
  EXPECT_EQ(occurrences(dark, "fill=\"#d2cdc3\""), 1u) << dark;
  EXPECT_EQ(occurrences(none, "stroke=\"#23202b\""), 1u) << none;
  EXPECT_EQ(occurrences(flat({"--outline-colour", "FFeedd", "--fog", "0"}), "stroke=\"#ffeedd\""), 1u);
}

TEST(Draw, OptionsThatChangeThePicture) {
  std::vector<std::string> seen = {drawn(crambin())};
  for (const std::vector<std::string> &options :
       {std::vector<std::string>{"--style", "headlight"}, std::vector<std::string>{"--palette", "jmol"},
        std::vector<std::string>{"--palette", "chain"}, std::vector<std::string>{"--fog", "0"},
        std::vector<std::string>{"--outline", "0"}, std::vector<std::string>{"--outline", "4"},
        std::vector<std::string>{"--margin", "0.2"}, std::vector<std::string>{"--occlusion", "0"},
        std::vector<std::string>{"--occlusion", "1"}, std::vector<std::string>{"--width", "200"},
        std::vector<std::string>{"--pieces", "h"}, std::vector<std::string>{"--pieces", "visible"},
        std::vector<std::string>{"--all-balls"}, std::vector<std::string>{"--probe", "1.4"},
        std::vector<std::string>{"--radii", "chem3d"}, std::vector<std::string>{"--background", "none"}}) {
    const std::string picture = drawn(crambin(), options);
    EXPECT_EQ(std::count(seen.begin(), seen.end(), picture), 0) << options.front();
    seen.push_back(picture);
  }
}

void expect_refusal(const Outcome &outcome, const std::string &line) {
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "hardsphere: " + line + "\n");
}

TEST(Draw, NoFileIsLeftAfterAFailure) {
  const TemporaryFile out("left.svg");
  EXPECT_EQ(draw_to(out.path(), "bad/nan.xyzr").status, 1);
  EXPECT_EQ(draw_to(out.path(), water, {"--fog", "2"}).status, 2);
  EXPECT_FALSE(std::filesystem::exists(out.path()));
  const std::string nowhere = out.path() + ".none/out.svg";
  expect_refusal(draw_to(nowhere, water), nowhere + ": No such file or directory");
}

TEST(Draw, AnOlderPictureStaysWhenTheInputIsBad) {
  const TemporaryFile out("older.svg", "old");
  EXPECT_EQ(draw_to(out.path(), "bad/nan.xyzr").status, 1);
  EXPECT_EQ(read_file(out.path()), "old");
  EXPECT_EQ(draw_to(out.path(), water).status, 0);
  EXPECT_EQ(read_file(out.path()).rfind("</svg>\n"), read_file(out.path()).size() - 7);
}

// The link stands for a device that is full, and stays.
TEST(Draw, FullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  for (const std::string &file : {water, crambin()}) {
    const TemporaryFile out("full.svg");
    std::filesystem::create_symlink("/dev/full", out.path());
    expect_refusal(draw_to(out.path(), file), out.path() + ": No space left on device");
    EXPECT_TRUE(std::filesystem::is_symlink(out.path()));
    EXPECT_TRUE(std::filesystem::exists("/dev/full"));
  }
}

// Bonds, halves of two colours, and what is refused.
TEST(Draw, BallsAndSticks) {
  const std::vector<std::string> sticks = {"--as", "ball-and-stick", "--view", "0,0,1"};
  const auto with = [&sticks](std::vector<std::string> more) {
    more.insert(more.begin(), sticks.begin(), sticks.end());
    return more;
  };
  const TemporaryFile out("sticks.svg");
  // Caffeine: 25 bonds, those between carbons in one part.
  const std::string caffeine = molecules_folder() + "/caffeine.pdb";
  const Outcome outcome = draw_to(out.path(), caffeine, with({"--json"}));
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("\"n\": 24, \"pieces\": 60,"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("\"sticks\": 25,"), std::string::npos) << outcome.out;
  const std::string svg = read_file(out.path());
  EXPECT_EQ(occurrences(svg, "<path") + occurrences(svg, "<circle"), 60U);
  EXPECT_EQ(occurrences(svg, "fill=\"url(#"), 24U);
  EXPECT_EQ(drawn(caffeine, sticks), drawn(caffeine, with({"--ball-size", "0.25", "--stick", "0.12"})));
  for (const char *extension : {".svg", ".eps", ".pdf"}) {
    const std::string picture = drawn(crambin(), with({"--style", "flat"}), extension);
    EXPECT_GT(picture.size(), 20000U);
  }
  const auto refusal = [&](const std::vector<std::string> &options) {
    return draw_to(out.path(), caffeine, options).err;
  };
  // Balls that meet, and hide all sticks: what is seen of each.
  const Outcome full = draw_to(out.path(), caffeine, with({"--json", "--ball-size", "1"}));
  EXPECT_NE(full.out.find("\"pieces\": 1"), std::string::npos) << full.out << full.err;
  EXPECT_NE(full.out.find("\"sticks\": 25,"), std::string::npos) << full.out;
  EXPECT_NE(refusal(with({"--stick", "0.4"})).find("is not thicker than its sticks"), std::string::npos);
  EXPECT_NE(
      draw_to(out.path(), crambin(), with({"--ball-size", "0.15", "--stick", "0.22"})).err.find("meet: see --ball"),
      std::string::npos);
  EXPECT_NE(refusal(with({"--probe", "1"})).find("--probe is not for"), std::string::npos);
  EXPECT_NE(refusal(with({"--pieces", "h"})).find("no --pieces but visible"), std::string::npos);
  EXPECT_NE(refusal(with({"--all-balls"})).find("are not for --as"), std::string::npos);
  // Pieces side by side: the same ones, but for what is hidden.
  const Outcome seen = draw_to(out.path(), caffeine, with({"--json", "--pieces", "visible"}));
  EXPECT_NE(seen.out.find("\"n\": 24, \"pieces\": 47,"), std::string::npos) << seen.out << seen.err;
  EXPECT_NE(refusal({"--stick", "0.1"}).find("are for --as"), std::string::npos);
  EXPECT_NE(refusal({"--as", "ribbons"}).find("is neither balls nor ball-and-stick"), std::string::npos);
}

struct Bonded {
  const char *element;
  double x, y, z;
};

// A file of these atoms and of bonds between them, each of two atoms counted from 1 and an order.
std::string sdf(const std::vector<Bonded> &atoms, const std::vector<std::array<int, 3>> &bonds) {
  char line[100];
  std::snprintf(line, sizeof line, "%3zu%3zu  0  0  0  0  0  0  0  0999 V2000\n", atoms.size(), bonds.size());
  std::string text = std::string("m\n  own               3D\n\n") + line;
  for (const Bonded &it : atoms) {
    std::snprintf(line, sizeof line, "%10.4f%10.4f%10.4f %-3s 0  0\n", it.x, it.y, it.z, it.element);
    text += line;
  }
  for (const std::array<int, 3> &it : bonds) {
    std::snprintf(line, sizeof line, "%3d%3d%3d\n", it[0], it[1], it[2]);
    text += line;
  }
  return text + "M  END\n";
}

// A few things that are in each other's way are changed, and a line says so; the rest is drawn as it is.
TEST(Draw, SticksThatRunIntoSomething) {
  const std::string third = "the stick between balls 0 and 1 runs into ball 3; drawn with ";
  const std::string two =
      "the sticks between balls 0 and 1 and balls 2 and 3 meet: see --ball-size and --stick; drawn with ";
  const std::vector<Bonded> beside = {
      {"C", 0, 0, 0}, {"C", 1.54, 0, 0}, {"C", 0.77, 1.5, 0.1}, {"H", 0.77, 0.35, 0}, {"O", 2.2, 1.2, 0.3}};
  std::vector<Bonded> within = beside, past = beside, thin = beside;
  within[3].y = 0.05;
  past[3].y = 0.42;  // too near to a double bond alone
  thin[3].y = 0.2;   // less than a third of the ball would be left
  const std::vector<Bonded> across = {
      {"C", 0, 0, 0}, {"C", 1.5, 0, 0.1}, {"C", 0.7, -0.8, 0}, {"N", 0.8, 0.8, 0.1}, {"N", 2.5, 1, 0}};
  const std::vector<Bonded> sharp = {{"C", 0, 0, 0}, {"C", 1.5, 0, 0}, {"O", 2.6, 1.5, 0}};
  const struct {
    std::string text, said;
    int sticks, pieces;
  } cases[] = {
      {sdf(beside, {{{1, 2, 1}}, {{3, 4, 1}}, {{2, 5, 1}}}), third + "1 ball smaller", 3, 10},
      {sdf(beside, {{{1, 2, 2}}, {{3, 4, 1}}, {{2, 5, 2}}}), third + "1 ball smaller, 1 multiple bond as a single one",
       3, 10},
      {sdf(past, {{{1, 2, 2}}, {{3, 4, 1}}, {{2, 5, 2}}}), "", 3, 10},
      {sdf(within, {{{1, 2, 1}}, {{3, 4, 1}}, {{2, 5, 1}}}), third + "1 bond less", 2, 9},
      {sdf(thin, {{{1, 2, 1}}, {{3, 4, 1}}, {{2, 5, 1}}}), third + "1 bond less", 2, 9},
      // Of two the longer one is left out, which has two colours.
      {sdf(across, {{{1, 2, 1}}, {{3, 4, 1}}, {{2, 5, 2}}}), two + "1 bond less", 2, 8},
      {sdf(sharp, {{{1, 2, 1}}, {{1, 3, 1}}}),
       "the sticks between balls 0 and 1 and balls 0 and 2 meet: see --ball-size and --stick; drawn with 1 bond less",
       1, 4},
  };
  for (const auto &it : cases) {
    for (const std::vector<std::string> &more :
         {std::vector<std::string>{}, {"--pieces", "visible"}, {"--ink"}, {"--spin", "3"}}) {
      const TemporaryFile file("near.sdf", it.text);
      const TemporaryFolder folder("near");
      std::vector<std::string> options = {"--as", "ball-and-stick", "--view", "0,0,1", "--json"};
      options.insert(options.end(), more.begin(), more.end());
      const Outcome outcome = draw_to(folder.path("near.svg"), file.path(), options);
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_EQ(outcome.err, it.said.empty() ? "" : "hardsphere: " + file.path() + ": " + it.said + "\n");
      EXPECT_NE(outcome.out.find("\"sticks\": " + std::to_string(it.sticks) + ","), std::string::npos) << outcome.out;
      if (more.empty()) {
        EXPECT_NE(outcome.out.find("\"pieces\": " + std::to_string(it.pieces) + ","), std::string::npos) << outcome.out;
      }
    }
  }
  // More than a few, or balls that are too thin for all, are refused.
  std::vector<Bonded> many;
  std::vector<std::array<int, 3>> bonds;
  for (int k = 0; k < 8; ++k) {
    for (const Bonded &it : within) many.push_back({it.element, it.x + 10 * k, it.y, it.z});
    bonds.push_back({5 * k + 1, 5 * k + 2, 1});
    bonds.push_back({5 * k + 3, 5 * k + 4, 1});
  }
  const TemporaryFile file("many.sdf", sdf(many, bonds)), out("many.svg");
  const Outcome outcome = draw_to(out.path(), file.path(), {"--as", "ball-and-stick", "--view", "0,0,1"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_NE(outcome.err.find(" runs into ball "), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("drawn with"), std::string::npos) << outcome.err;
}

}  // namespace
