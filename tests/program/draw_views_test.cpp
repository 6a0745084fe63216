// From where hardsphere draw looks: views, turns, principal axes, and the pictures of a whole turn.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "drawn_colours.hpp"
#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

const std::string water = "good/water.pdb";

Outcome draw_to(const std::string &out, const std::string &file, std::vector<std::string> options = {}) {
  options.insert(options.begin(), {"draw", file, "-o", out});
  return run_program(options);
}

// Turns are counter-clockwise seen from the positive end of the axis: a quarter turn about y brings what was at -x to
// the front, one about x what was at y, and one about z lays x upwards.
TEST(DrawViews, ViewsAndTurnsMeet) {
  const std::string plain = drawn(crambin(), {"--view", "0,0,1"});
  EXPECT_TRUE(drawn(crambin(), {"--view=0,0,12.5", "--up", "0,1,0"}) == plain);
  EXPECT_TRUE(drawn(crambin(), {"--view", "0,0,1", "--rotate", "0,0,0"}) == plain);
  EXPECT_TRUE(drawn(crambin(), {"--rotate", "360,-720,0", "--view=0,0,5"}) == plain);
  struct Case {
    std::string rotate, view, up;
  };
  for (const Case &it :
       {Case{"0,90,0", "-1,0,0", "0,1,0"}, Case{"90,0,0", "0,1,0", "0,0,-1"}, Case{"0,0,90", "0,0,1", "1,0,0"},
        Case{"90,90,0", "-1,0,0", "0,0,-1"}, Case{"0,180,0", "0,0,-1", "0,1,0"}, Case{"0,-90,0", "2,0,0", "0,5,0"}}) {
    const std::string turned = drawn(crambin(), {"--view", "0,0,1", "--rotate", it.rotate});
    EXPECT_TRUE(turned == drawn(crambin(), {"--view", it.view, "--up", it.up})) << it.rotate;
    EXPECT_FALSE(turned == plain) << it.rotate;
  }
}

// The view is turned, whichever it is: what was on the left, at -x, comes to the front.
TEST(DrawViews, TurnsBeginAtTheView) {
  const std::vector<std::string> view = {"--view", "1,0,0", "--up", "0,0,1"}; /* y on the right */
  const auto with = [&view](std::vector<std::string> options) {
    options.insert(options.end(), view.begin(), view.end());
    return options;
  };
  EXPECT_TRUE(drawn(water, with({"--rotate", "0,90,0"})) == drawn(water, {"--view", "0,-1,0", "--up", "0,0,1"}));
  EXPECT_TRUE(drawn(water, with({"--rotate", "90,0,0"})) == drawn(water, {"--view", "0,0,1", "--up", "-1,0,0"}));
  EXPECT_TRUE(drawn(crambin()) == drawn(crambin(), {"--view", "auto"}));
  EXPECT_TRUE(drawn(crambin()) == drawn(crambin(), {"--rotate", "0,0,0", "--view=auto"}));
  EXPECT_FALSE(drawn(crambin()) == drawn(crambin(), {"--view", "0,0,1"}));
}

// Without --up y is up, and z where y is towards the viewer.
TEST(DrawViews, UpwardsByDefault) {
  EXPECT_TRUE(drawn(water, {"--view", "-1,0,0"}) == drawn(water, {"--view", "0,0,1", "--rotate", "0,90,0"}));
  EXPECT_TRUE(drawn(water, {"--view", "0,1,0"}) == drawn(water, {"--view", "0,1,0", "--up", "0,0,1"}));
}

struct Spread {
  double along[3];    // how far points are from their middle along three axes
  double axis[3][3];  // these
};

// Six balls of a file, on both sides along each axis; noise: of every coordinate, at most.
void write_spread(const std::string &path, const Spread &spread, double noise = 0, unsigned seed = 1) {
  std::ofstream file(path);
  file.precision(17);
  for (int k = 0; k < 3; ++k) {
    for (const double side : {-1.0, 1.0}) {
      for (int c = 0; c < 3; ++c) {
        seed = 1664525 * seed + 1013904223;
        const double shift = noise * ((seed >> 8) / 8388608.0 - 1.0);
        file << 100 + side * spread.along[k] * spread.axis[k][c] + shift << ' ';
      }
      file << "1\n";
    }
  }
}

// The longest axis goes across, the next one upwards; the viewer is where z is, else x, else y, and upwards is where y
// is, else z, else x. A molecule that spreads alike in two directions stands upright, one that does so in all is seen
// along z.
TEST(DrawViews, AlongPrincipalAxes) {
  struct Case {
    Spread spread;
    std::string view;  // as the table says it
  };
  constexpr double a = 0.6;
  constexpr double b = 0.8;
  for (const Case &it :
       {Case{{{5, 4, 3}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, "(0, 0, 1) towards the viewer, (0, 1, 0) up"},
        Case{{{3, 4, 5}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, "(1, 0, 0) towards the viewer, (0, 1, 0) up"},
        Case{{{3, 5, 4}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, "(1, 0, 0) towards the viewer, (0, 0, 1) up"},
        Case{{{5, 3, 4}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, "(0, 1, 0) towards the viewer, (0, 0, 1) up"},
        Case{{{5, 4, 3}, {{a, b, 0}, {-b, a, 0}, {0, 0, 1}}}, "(0, 0, 1) towards the viewer, (-0.8, 0.6, 0) up"},
        Case{{{5, 3, 4}, {{0, 0, 1}, {-b, a, 0}, {a, b, 0}}}, "(0.8, -0.6, 0) towards the viewer, (0.6, 0.8, 0) up"},
        Case{{{0, 4, 5}, {{a, 0, b}, {-b, 0, a}, {0, 1, 0}}}, "(0.6, 0, 0.8) towards the viewer, (-0.8, 0, 0.6) up"},
        Case{{{4, 4.01, 3}, {{a, b, 0}, {-b, a, 0}, {0, 0, 1}}}, "(0, 0, 1) towards the viewer, (0, 1, 0) up"},
        Case{{{4, 4.01, 3}, {{a, 0, b}, {0, 1, 0}, {-b, 0, a}}}, "(-0.8, 0, 0.6) towards the viewer, (0, 1, 0) up"},
        Case{{{5, 3, 3.01}, {{a, b, 0}, {-b, a, 0}, {0, 0, 1}}}, "(0.8, -0.6, 0) towards the viewer, (0, 0, 1) up"},
        Case{{{5, 0, 0}, {{b, a, 0}, {-a, b, 0}, {0, 0, 1}}}, "(0, 0, 1) towards the viewer, (-0.6, 0.8, 0) up"},
        Case{{{4, 4.01, 4.02}, {{a, b, 0}, {-b, a, 0}, {0, 0, 1}}}, "(0, 0, 1) towards the viewer, (0, 1, 0) up"},
        Case{{{4, 4, 4}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, "(0, 0, 1) towards the viewer, (0, 1, 0) up"},
        Case{{{0, 0, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, "(0, 0, 1) towards the viewer, (0, 1, 0) up"}}) {
    const TemporaryFile points("points.xyzr");
    write_spread(points.path(), it.spread);
    const TemporaryFile out("drawn.svg");
    const Outcome outcome = draw_to(out.path(), points.path(), {"--view", "auto"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find(" " + it.view + "\n"), std::string::npos) << it.view << " in\n" << outcome.out;
  }
}

// Noise moves the view as little as the atoms where molecules are symmetric, flat, or along the file's axes.
TEST(DrawViews, PrincipalAxesDoNotHangOnNoise) {
  const auto view_of = [](const Spread &spread, double noise, unsigned seed) {
    const TemporaryFile points("points.xyzr");
    write_spread(points.path(), spread, noise, seed);
    const TemporaryFile out("drawn.svg");
    const std::string table = draw_to(out.path(), points.path()).out;
    std::array<double, 6> view{};
    EXPECT_EQ(std::sscanf(table.substr(table.find("  view ")).c_str(),
                          " view (%lf, %lf, %lf) towards the viewer, (%lf, %lf, %lf) up", &view[0], &view[1], &view[2],
                          &view[3], &view[4], &view[5]),
              6);
    return view;
  };
  const double half = std::sqrt(0.5);
  for (const Spread &spread :
       {Spread{{5, 4, 3}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, Spread{{5, 4, 0}, {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}},
        Spread{{5, 4, 3}, {{half, -half, 0}, {half, half, 0}, {0, 0, 1}}},
        Spread{{5, 4, 3}, {{0, half, -half}, {1, 0, 0}, {0, half, half}}},
        Spread{{4, 4, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
        Spread{{4, 4, 0}, {{0, half, -half}, {1, 0, 0}, {0, half, half}}},
        Spread{{5, 3, 3}, {{half, -half, 0}, {half, half, 0}, {0, 0, 1}}},
        Spread{{5, 0, 0}, {{half, -half, 0}, {half, half, 0}, {0, 0, 1}}},
        Spread{{4, 4, 4}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}) {
    const auto plain = view_of(spread, 0, 1);
    for (unsigned seed = 1; seed <= 8; ++seed) {
      const auto noisy = view_of(spread, 1e-3, seed);
      for (size_t k = 0; k < 6; ++k) EXPECT_NEAR(noisy[k], plain[k], 2e-3) << seed;
    }
  }
}

// Far from the origin, where a middle between coordinates is none, and where they are hardly numbers any more.
TEST(DrawViews, AtTheEndsOfNumbers) {
  for (const char *text :
       {"9007199254740992 0 0 1e10\n9007199254740994 1 0 1e10\n9007199254740994 0 2 1e10\n",
        "1e30 0 0 1e25\n1.0000000000000002e30 0 1e13 1e25\n", "0 0 0 1\n5e-324 0 0 1\n0 1e-323 0 1\n"}) {
    const TemporaryFile file("ends.xyzr", text);
    const TemporaryFile out("ends.svg");
    const Outcome outcome = draw_to(out.path(), file.path());
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(outcome.out.find("nan"), std::string::npos) << outcome.out;
  }
}

// Water has no say in where one looks from, so that pictures with and without it agree, and map with both.
TEST(DrawViews, WaterDoesNotTurnThePicture) {
  std::string text = read_file(crambin());
  text = text.substr(0, text.find("\nTER") + 1);
  for (int i = 0; i < 60; ++i) {
    char line[100];
    std::snprintf(line, sizeof line, "HETATM%5d  O   HOH A%4d    %8.3f%8.3f%8.3f  1.00  0.00           O\n", 400 + i,
                  100 + i, 12.0 + i, 10.0 + 0.5 * i, 20.0 + i);
    text += line;
  }
  const TemporaryFile file("wet.pdb", text);
  const TemporaryFile out("wet.svg");
  const auto view_of = [&](const std::vector<std::string> &options) {
    const std::string table = draw_to(out.path(), file.path(), options).out;
    const size_t row = table.find("  view ");
    return row == std::string::npos ? table : table.substr(row, table.find('\n', row) - row);
  };
  const std::string view = view_of({});
  EXPECT_NE(view.find("towards the viewer"), std::string::npos) << view;
  EXPECT_EQ(view_of({"--water"}), view);
  EXPECT_NE(view_of({"--only", "water"}), view);
  const Json seen = run_json({"draw", file.path(), "-o", out.path(), "--water", "--pieces", "visible"});
  const Json map = run_json({"map", file.path()});
  EXPECT_EQ(seen["n"].number, 387);
  EXPECT_EQ(map["n"].number, 387);
  EXPECT_EQ(map["edges"].number, seen["arcs"].number);
  EXPECT_NE(run_json({"map", file.path(), "--view", "0,0,1"})["edges"].number, map["edges"].number);
}

// The whole turn in one frame: one picture after the other, numbered, in which nothing but the balls moves.
TEST(DrawViews, ATurnInPictures) {
  TemporaryFolder folder("turn");
  const TemporaryFile file("pair.xyzr", "0 0 0 1\n7 0 0 2\n");
  const std::string out = folder.path("turn.svg");
  const auto numbered = [&folder](const std::string &number) { return folder.path("turn-" + number + ".svg"); };
  // Seen along z, turning about y: from -1 to 9 across, hence about 4; 2 upwards. So 8 from the farther one's middle.
  const std::vector<std::string> flat = {"draw",    file.path(), "-o",    out, "--view",   "0,0,1", "--spin",  "4",
                                         "--style", "flat",      "--fog", "0", "--margin", "0.1",   "--width", "120"};
  const Json json = run_json(flat);
  EXPECT_EQ(json["pictures"].number, 4);
  EXPECT_EQ(json["width"].number, 120);
  EXPECT_EQ(json["height"].number, 60);
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"turn-000.svg", "turn-001.svg", "turn-002.svg", "turn-003.svg"}));
  double bytes = 0;
  for (const char *number : {"000", "001", "002", "003"}) {
    const std::string svg = read_file(numbered(number));
    bytes += static_cast<double>(svg.size());
    EXPECT_NE(svg.find(" viewBox=\"0 0 120 60\""), std::string::npos) << number;
  }
  EXPECT_EQ(json["bytes"].number, bytes);
  // 10 across and as much again for margins makes 10 px a unit.
  EXPECT_NE(read_file(numbered("000")).find(" cx=\"20\" cy=\"30\" r=\"10\""), std::string::npos)
      << read_file(numbered("000"));
  EXPECT_NE(read_file(numbered("000")).find(" cx=\"90\" cy=\"30\" r=\"20\""), std::string::npos);
  // A quarter of a turn brings the left end to the front, three of them put it behind the larger ball.
  EXPECT_NE(read_file(numbered("001")).find(" cx=\"60\" cy=\"30\" r=\"10\""), std::string::npos)
      << read_file(numbered("001"));
  EXPECT_NE(read_file(numbered("001")).find(" cx=\"60\" cy=\"30\" r=\"20\""), std::string::npos);
  EXPECT_NE(read_file(numbered("002")).find(" cx=\"100\" cy=\"30\" r=\"10\""), std::string::npos)
      << read_file(numbered("002"));
  EXPECT_EQ(read_file(numbered("003")).find(" cx=\"60\" cy=\"30\" r=\"10\""), std::string::npos);
}

// Any other picture of a turn is the one by --rotate in the same frame; probes and balls with sticks make their frame.
TEST(DrawViews, ATurnIsMadeOfTurnedViews) {
  TemporaryFolder folder("turn");
  for (const std::vector<std::string> &options :
       {std::vector<std::string>{}, std::vector<std::string>{"--probe", "1.4", "--pieces", "visible"},
        std::vector<std::string>{"--as", "ball-and-stick"}}) {
    std::vector<std::string> arguments = {"draw", crambin(), "-o", folder.path("c.svg"), "--spin", "3", "--scale",
                                          "20",   "--title", "c"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(run_program(arguments).status, 0);
    std::vector<std::string> turned = {"--rotate", "0,120,0", "--scale", "20", "--title", "c"};
    turned.insert(turned.end(), options.begin(), options.end());
    EXPECT_TRUE(read_file(folder.path("c-001.svg")) == drawn(crambin(), turned));
    turned[1] = "0,240,0";
    EXPECT_TRUE(read_file(folder.path("c-002.svg")) == drawn(crambin(), turned));
  }
  // All that is seen lies within the frame, from every side: nothing is cut off.
  const std::string caffeine = molecules_folder() + "/caffeine.pdb";
  for (const std::vector<std::string> &options :
       {std::vector<std::string>{"--probe", "0"}, std::vector<std::string>{"--probe", "3", "--pieces", "visible"},
        std::vector<std::string>{"--as", "ball-and-stick", "--ball-size", "1"}}) {
    std::vector<std::string> arguments = {"draw",   caffeine, "-o",       folder.path("f.eps"),
                                          "--spin", "5",      "--margin", "0.001"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    for (int k = 0; k < 5 && outcome.status == 0; ++k) {
      const std::string eps = read_file(folder.path("f-00" + std::to_string(k) + ".eps"));
      EXPECT_EQ(eps.find("rectclip"), std::string::npos) << options[0] << k;
    }
  }
}

TEST(DrawViews, ATurnNeverWritesOverItsInput) {
  TemporaryFolder folder("turn");
  const std::string file = folder.path("in-001.svg");
  std::ofstream(file) << "0 0 0 1\n";
  const Outcome outcome = run_program({"draw", file, "--format", "xyzr", "-o", folder.path("in.svg"), "--spin", "3"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("would write over the file that is read"), std::string::npos) << outcome.err;
  EXPECT_EQ(read_file(file), "0 0 0 1\n");
  const std::string nowhere = folder.path("none/a.svg");
  const Outcome failed = run_program({"draw", file, "--format", "xyzr", "-o", nowhere, "--spin", "3"});
  EXPECT_EQ(failed.err, "hardsphere: " + folder.path("none/a-000.svg") + ": No such file or directory\n");
}

// The size that follows from the other side is whole, so that no row is covered in part; a given size is kept.
TEST(DrawViews, SidesThatFollowAreWhole) {
  const TemporaryFile pair("pair.xyzr", "0 0 0 1\n7 0 0 2\n");  // 10 by 4 and a margin of .3
  const auto size_of = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--view", "0,0,1", "--style", "flat"});
    const std::string svg = drawn(pair.path(), options);
    const size_t at = svg.find(" width=");
    return svg.substr(at, svg.find(" viewBox") - at);
  };
  EXPECT_EQ(size_of({}), " width=\"1000px\" height=\"434px\"");
  EXPECT_EQ(size_of({"--height", "100"}), " width=\"231px\" height=\"100px\"");
  EXPECT_EQ(size_of({"--width", "100.5", "--height", "44.25"}), " width=\"100.5px\" height=\"44.25px\"");
  EXPECT_EQ(size_of({"--unit", "mm", "--width", "106"}), " width=\"106mm\" height=\"46mm\"");
}

// A part of a picture is where it was, less what is to the left of it and above.
TEST(DrawViews, Crops) {
  const TemporaryFile pair("pair.xyzr", "0 0 0 1\n7 0 0 2\n");
  const std::vector<std::string> whole = {"--view", "0,0,1", "--style", "flat", "--width", "106", "--height", "46"};
  const auto with = [&whole](std::vector<std::string> options) {
    options.insert(options.end(), whole.begin(), whole.end());
    return options;
  };
  EXPECT_NE(drawn(pair.path(), with({})).find(" cx=\"13\" cy=\"23\" r=\"10\""), std::string::npos);
  const std::string part = drawn(pair.path(), with({"--crop", "50,10,60,30"}));
  EXPECT_NE(part.find(" width=\"60px\" height=\"30px\" viewBox=\"0 0 60 30\""), std::string::npos) << part;
  EXPECT_NE(part.find(" cx=\"-37\" cy=\"13\" r=\"10\""), std::string::npos) << part;
  EXPECT_NE(part.find(" cx=\"33\" cy=\"13\" r=\"20\""), std::string::npos) << part;
  // Of a fixed frame: 10 px an angstrom about 3.5, 45 by 45.
  const std::string fixed = drawn(
      pair.path(), {"--view", "0,0,1", "--style", "flat", "--width", "45", "--scale", "10", "--crop", "1,2,30,40"});
  EXPECT_NE(fixed.find(" cx=\"-13.5\" cy=\"20.5\" r=\"10\""), std::string::npos) << fixed;
  for (const char *as : {"balls", "ball-and-stick"}) {
    for (const char *view : {"1,2,3", "auto"}) {
      const std::vector<std::string> looks = {"--as",    as,     "--view",    view, "--width", "600",
                                              "--style", "flat", "--outline", "1",  "--fog",   "0"};
      std::vector<std::string> cropped = looks;
      cropped.insert(cropped.end(), {"--crop=0,0,600,300"});
      const std::string top = drawn(molecules_folder() + "/caffeine.pdb", cropped);
      const std::string all = drawn(molecules_folder() + "/caffeine.pdb", looks);
      // The same paths, but for roundings.
      const size_t from = all.find(" d=\"M") + 5;
      const size_t at = top.find(" d=\"M") + 5;
      EXPECT_NEAR(std::stod(top.substr(at)), std::stod(all.substr(from)), 0.011) << as << view;
      EXPECT_NEAR(std::stod(top.substr(top.find(' ', at))), std::stod(all.substr(all.find(' ', from))), 0.011);
    }
  }
  for (const auto &[value, complaint] :
       std::vector<std::pair<std::string, std::string>>{{"1,2,3", "--crop needs 4 numbers"},
                                                        {"1,2,0,4", "W and H must be above 0"},
                                                        {"1,2,3,-4", "W and H must be above 0"},
                                                        {"1,2,3,4e6", "between -1000000 and 1000000"}}) {
    const Outcome outcome = run_program({"draw", pair.path(), "-o", "out.svg", "--crop=" + value});
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.err.find(complaint), std::string::npos) << outcome.err;
  }
}

}  // namespace
