// Sums of areas by `measure`: polar and apolar atoms, parts of what residues can have, what an interface buries.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "molecule_file.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

constexpr double pi = std::numbers::pi;

// A line of a .pdb file.
std::string atom(int serial, const char *name, const char *residue, char chain, int number, double x,
                 const char *element) {
  char line[100];
  std::snprintf(line, sizeof line, "ATOM  %5d  %-3s %3s %c%4d    %8.3f%8.3f%8.3f%6.2f%6.2f          %2s\n", serial,
                name, residue, chain, number, x, 0.0, 0.0, 1.0, 0.0, element);
  return line;
}

// The area that a sphere of radius r loses to an equal one at distance d.
double cap(double r, double d) {
  return 2 * pi * r * (r - d / 2);
}

TEST(AreaSums, PolarAndApolar) {
  const Json json = run_json({"measure", "good/residues.pdb", "--polar", "--per-ball", "--probe", "1.4"});
  double polar = 0;
  double apolar = 0;
  double other = 0;
  for (const Json &ball : json["balls"].items) {
    const std::string element = ball["element"].text;
    double &sum = element == "N" || element == "O" ? polar : element == "C" || element == "S" ? apolar : other;
    sum += ball["area"].number;
  }
  EXPECT_GT(polar, 0);
  EXPECT_GT(apolar, 0);
  EXPECT_NEAR(json["polar_area"].number, polar, 1e-9);
  EXPECT_NEAR(json["apolar_area"].number, apolar, 1e-9);
  EXPECT_NEAR(json["other_area"].number, other, 1e-9);
  EXPECT_NEAR(polar + apolar + other, json["area"].number, 1e-9);
  EXPECT_EQ(run_program({"measure", "good/three.xyzr", "--polar"}).status, 2);
}

struct Place {
  const char *element;
  double x, y, z;
  char kind;  // p: polar, a: apolar, o: other
};

// The three sums of a file against those over its balls, whose kinds are known.
void expect_kinds(const std::string &name, const std::string &text, const std::vector<Place> &places,
                  const std::vector<std::string> &more = {}) {
  const TemporaryFile file(name, text);
  std::vector<std::string> arguments = {"measure", file.path(), "--polar", "--per-ball"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Json json = run_json(arguments);
  double sum[3] = {0, 0, 0};
  for (size_t i = 0; i < json["balls"].items.size(); ++i) {
    const char kind = places[i % places.size()].kind;
    sum[kind == 'p' ? 0 : kind == 'a' ? 1 : 2] += json["balls"].items[i]["area"].number;
  }
  EXPECT_NEAR(json["polar_area"].number, sum[0], 1e-9) << text;
  EXPECT_NEAR(json["apolar_area"].number, sum[1], 1e-9) << text;
  EXPECT_NEAR(json["other_area"].number, sum[2], 1e-9) << text;
}

std::string xyz(const std::vector<Place> &places, const std::string &title = "") {
  std::string text = std::to_string(places.size()) + "\n" + title + "\n";
  for (const Place &it : places) {
    text += std::string(it.element) + " " + std::to_string(it.x) + " " + std::to_string(it.y) + " " +
            std::to_string(it.z) + "\n";
  }
  return text;
}

// One hydrogen of ethanol is polar, that of the hydroxyl group.
TEST(AreaSums, HydrogensAreAsWhatTheyAreBoundTo) {
  const std::vector<Place> ethanol = {{"C", 1.1879, -0.3829, 0, 'a'},       {"C", 0, 0.5526, 0, 'a'},
                                      {"O", -1.1867, -0.2472, 0, 'p'},      {"H", -1.9237, 0.385, 0, 'p'},
                                      {"H", 2.0985, 0.2306, 0, 'a'},        {"H", 1.1184, -1.0093, 0.8869, 'a'},
                                      {"D", 1.1184, -1.0093, -0.8869, 'a'}, {"H", -0.0227, 1.1812, 0.8852, 'a'},
                                      {"H", -0.0227, 1.1812, -0.8852, 'a'}};
  expect_kinds("m.xyz", xyz(ethanol), ethanol);
  expect_kinds("m.xyz", xyz(ethanol), ethanol, {"--surface", "ses", "--probe", "1.4"});
  expect_kinds("m.xyz", xyz(ethanol, "Lattice=\"9 0 0 0 9 0 0 0 9\""), ethanol, {"--box", "file"});
  const std::vector<Place> others = {{"N", 0, 0, 0, 'p'},    {"H", 1, 0, 0, 'p'},   {"S", 9, 0, 0, 'a'},
                                     {"H", 10.3, 0, 0, 'a'}, {"Si", 0, 9, 0, 'o'},  {"H", 1.5, 9, 0, 'o'},
                                     {"H", 0, 0, 9, 'o'},    {"H", 0.7, 0, 9, 'o'}, {"H", 0, 20, 0, 'o'},
                                     {"B", 0, 0, 20, 'o'},   {"H", 1.2, 0, 20, 'o'}};
  expect_kinds("m.xyz", xyz(others), others);
  // Between two atoms it is with the nearer one, whichever comes first; a bond of the file comes before distances.
  const std::vector<Place> bridge = {{"C", 0, 0, 0, 'a'}, {"H", 1.4, 0, 0, 'p'}, {"O", 2.7, 0, 0, 'p'}};
  expect_kinds("m.xyz", xyz(bridge), bridge);
  const std::vector<Place> back = {{"O", 2.7, 0, 0, 'p'}, {"H", 1.4, 0, 0, 'p'}, {"C", 0, 0, 0, 'a'}};
  expect_kinds("m.xyz", xyz(back), back);
  const std::vector<Place> stated = {{"C", 0, 0, 0, 'a'}, {"H", 1.4, 0, 0, 'a'}, {"O", 2.7, 0, 0, 'p'}};
  expect_kinds("m.mol2",
               "@<TRIPOS>MOLECULE\nm\n3 2\n@<TRIPOS>ATOM\n1 C1 0 0 0 C.3\n2 H1 1.4 0 0 H\n3 O1 2.7 0 0 O.3\n"
               "@<TRIPOS>BOND\n1 1 2 1\n2 1 3 1\n",
               stated);
  // Copies by symmetry are what their atoms are.
  const std::vector<Place> pair = {{"O", 1, 1, 1, 'p'}, {"H", 2, 1, 1, 'p'}, {"C", 5, 5, 5, 'a'}};
  expect_kinds("m.cif",
               "data_a\n_cell_length_a 20\n_cell_length_b 20\n_cell_length_c 20\n_cell_angle_alpha 90\n"
               "_cell_angle_beta 90\n_cell_angle_gamma 90\nloop_\n_symmetry_equiv_pos_as_xyz\nx,y,z\n-x,-y,-z\nloop_\n"
               "_atom_site_type_symbol\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n"
               "O 0.05 0.05 0.05\nH 0.1 0.05 0.05\nC 0.25 0.25 0.25\n",
               pair, {"--box", "file"});
  // Of frames, by the bonds of the file.
  const TemporaryFile file("m.xyz", xyz(ethanol)), run("run.xyz", xyz(ethanol) + xyz(ethanol));
  const Json whole = run_json({"measure", file.path(), "--polar"});
  const Outcome frames = run_program({"measure", file.path(), "--polar", "--trajectory", run.path()});
  char wanted[64];
  std::snprintf(wanted, sizeof wanted, "%.4f", whole["polar_area"].number);
  EXPECT_EQ(frames.err, "");
  EXPECT_NE(frames.out.find("," + std::string(wanted).substr(0, 6)), std::string::npos) << frames.out << wanted;
}

// Crambin's solvent-excluded surface. The values are those of an independent program, checked by lines through the
// definition; MSROLL has 2319.065 and 4664.897.
TEST(AreaSums, SolventExcludedSurface) {
  const std::string crambin = support::own_molecule("crambin.pdb").string();
  struct Known {
    const char *probe;
    double area, volume, convex, saddle, concave;
  };
  constexpr Known known[] = {{"1", 2653.999024201, 4368.192803430, 1142.157188, 948.779605, 563.062230},
                             {"1.4", 2319.064883323, 4664.897270837, 860.388078879, 896.522219402, 562.154585041},
                             {"3", 2091.274679908, 5207.368683474, 427.302757, 826.304128, 837.667795},
                             {"6", 2022.630997030, 5798.829886572, 217.529117, 716.857773, 1088.244106}};
  for (const Known &k : known) {
    const Json json = run_json({"measure", crambin, "--surface", "ses", "--probe", k.probe, "--per-ball"});
    EXPECT_EQ(json["surface"].text, "ses");
    EXPECT_NEAR(json["area"].number, k.area, 1e-8) << k.probe;
    EXPECT_NEAR(json["volume"].number, k.volume, 1e-8) << k.probe;
    EXPECT_NEAR(json["convex_area"].number, k.convex, 1e-6) << k.probe;
    EXPECT_NEAR(json["saddle_area"].number, k.saddle, 1e-6) << k.probe;
    EXPECT_NEAR(json["concave_area"].number, k.concave, 1e-6) << k.probe;
    double sum = 0;
    for (const Json &ball : json["balls"].items) sum += ball["area"].number;
    EXPECT_NEAR(sum, k.area, 1e-8) << k.probe;
  }
  const Json plain = run_json({"measure", crambin, "--probe", "1.4"});
  const Json accessible = run_json({"measure", crambin, "--probe", "1.4", "--surface", "sas"});
  EXPECT_EQ(plain["area"].number, accessible["area"].number);
  EXPECT_EQ(accessible["convex_area"].kind, Json::Kind::null);
  const Outcome table = run_program({"measure", crambin, "--probe", "1.4", "--surface", "ses"});
  EXPECT_NE(table.out.find("solvent-excluded"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("saddle area"), std::string::npos) << table.out;
}

// Balls that leave room for a probe between them. The part that it reaches there does not belong to the outer surface.
TEST(AreaSums, OuterSurface) {
  const std::vector<std::string> whole = {"measure", "good/cage.xyzr", "--probe", "0.09", "--surface", "ses"};
  std::vector<std::string> outer = whole;
  outer.emplace_back("--outer");
  const Json all = run_json(whole), outside = run_json(outer);
  EXPECT_EQ(all["outer"].kind, Json::Kind::null);
  EXPECT_EQ(outside["outer"].kind, Json::Kind::boolean);
  EXPECT_LT(outside["convex_area"].number, all["convex_area"].number);
  EXPECT_GT(outside["volume"].number, all["volume"].number);
  // Without a void they are the same.
  const std::string crambin = support::own_molecule("crambin.pdb").string();
  const Json open = run_json({"measure", crambin, "--probe", "6", "--surface", "ses", "--outer"});
  EXPECT_NEAR(open["area"].number, 2022.630997030, 1e-8);
  const Outcome table = run_program(outer);
  EXPECT_NE(table.out.find("from outside"), std::string::npos) << table.out;
}

TEST(AreaSums, WeightedSharesOfTheExcludedSurface) {
  const Json json = run_json({"measure", "good/water.pdb", "--probe", "1.4", "--surface", "ses", "--per-ball",
                              "--weights", "good/water.weights"});
  const std::vector<Json> &balls = json["balls"].items;
  ASSERT_EQ(balls.size(), 3u);
  EXPECT_NEAR(json["weighted_area"].number,
              balls[0]["area"].number - 0.5 * balls[1]["area"].number + 2 * balls[2]["area"].number, 1e-9);
}

TEST(AreaSums, SurfacesThatAreRefused) {
  const std::string crambin = support::own_molecule("crambin.pdb").string();
  const std::vector<std::vector<std::string>> refused = {
      {"--surface", "ses"},
      {"--probe", "1.4", "--surface", "vdw"},
      {"--probe", "1.4", "--surface"},
      {"--probe", "1.4", "--surface", "ses", "--surface", "ses"},
      {"--probe", "1.4", "--surface", "ses", "--weights", "weights.txt", "--gradient"},
      {"--probe", "1.4", "--surface", "sas", "--outer"},
      {"--probe", "1.4", "--outer"},
      {"--probe", "1.4", "--surface", "ses", "--by", "residue", "--relative"},
      {"--probe", "1.4", "--surface", "ses", "--interface", "A,B"}};
  for (const std::vector<std::string> &options : refused) {
    std::vector<std::string> arguments = {"measure", crambin};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(run_program(arguments).status, 2) << options.back();
  }
}

// An atom alone in each of three residues: glycine, what is no amino acid, and tryptophan.
TEST(AreaSums, RelativeToTheLargest) {
  const TemporaryFile file("far.pdb", atom(1, "CA", "GLY", 'A', 1, 0, "C") + atom(2, "C1", "LIG", 'A', 2, 20, "C") +
                                          atom(3, "CA", "TRP", 'A', 3, 40, "C"));
  const double sphere = 4 * pi * 3.1 * 3.1;  // 1.7 and the probe of 1.4
  const Json json = run_json({"measure", file.path(), "--by", "residue", "--relative", "--probe", "1.4"});
  const std::vector<Json> &residues = json["residues"].items;
  ASSERT_EQ(residues.size(), 3u);
  EXPECT_NEAR(residues[0]["relative"].number, sphere / 104, 1e-12);
  EXPECT_EQ(residues[1]["relative"].kind, Json::Kind::null);
  EXPECT_NEAR(residues[2]["relative"].number, sphere / 285, 1e-12);
  const Outcome csv = run_program({"measure", file.path(), "--by", "residue", "--relative", "--probe", "1.4", "--csv"});
  EXPECT_EQ(csv.out.rfind("chain,residue,number,insertion,atoms,area,relative\n", 0), 0u) << csv.out;
  const Outcome table = run_program({"measure", file.path(), "--by", "residue", "--relative", "--probe", "1.4"});
  EXPECT_NE(table.out.find("Tien"), std::string::npos) << table.out;
  EXPECT_EQ(run_program({"measure", file.path(), "--relative", "--probe", "1.4"}).status, 2);
  EXPECT_EQ(run_program({"measure", file.path(), "--by", "chain", "--relative", "--probe", "1.4"}).status, 2);
  EXPECT_EQ(run_program({"measure", file.path(), "--by", "residue", "--relative"}).status, 2);
}

// All of crambin's residues are among the twenty, and none shows more than all there can be by much.
TEST(AreaSums, RelativeAreasOfAProtein) {
  const std::string crambin = support::own_molecule("crambin.pdb").string();
  const Json json = run_json({"measure", crambin, "--by", "residue", "--relative", "--probe", "1.4"});
  for (const Json &residue : json["residues"].items) {
    ASSERT_EQ(residue["relative"].kind, Json::Kind::number);
    EXPECT_LT(residue["relative"].number, 1.1);
  }
}

// Spheres in a row, one a chain: A meets B, B meets C, and D is far away.
TEST(AreaSums, InterfaceOfChains) {
  const double r = 1.7;
  const TemporaryFile file("row.pdb", atom(1, "CA", "GLY", 'A', 1, 0, "C") + atom(2, "CA", "GLY", 'B', 1, 2, "C") +
                                          atom(3, "CA", "GLY", 'C', 1, 4.5, "C") +
                                          atom(4, "CA", "GLY", 'D', 1, 30, "C"));
  const double sphere = 4 * pi * r * r;
  struct Case {
    const char *groups;
    double alone[2], together[2];
  };
  const std::vector<Case> cases = {
      {"A,B", {sphere, sphere}, {sphere - cap(r, 2), sphere - cap(r, 2)}},
      {"B,C", {sphere, sphere}, {sphere - cap(r, 2.5), sphere - cap(r, 2.5)}},
      {"A,C", {sphere, sphere}, {sphere, sphere}},
      {"A+C,B", {2 * sphere, sphere}, {2 * sphere - cap(r, 2) - cap(r, 2.5), sphere - cap(r, 2) - cap(r, 2.5)}},
      {"D,C+B", {sphere, 2 * sphere - 2 * cap(r, 2.5)}, {sphere, 2 * sphere - 2 * cap(r, 2.5)}}};
  for (const Case &it : cases) {
    const Json json = run_json({"measure", file.path(), "--interface", it.groups});
    const Json &interface = json["interface"];
    ASSERT_EQ(interface["groups"].items.size(), 2u) << it.groups;
    double buried = 0;
    for (size_t side = 0; side < 2; ++side) {
      EXPECT_NEAR(interface["groups"].items[side]["alone"].number, it.alone[side], 1e-7) << it.groups;
      EXPECT_NEAR(interface["groups"].items[side]["together"].number, it.together[side], 1e-7) << it.groups;
      buried += it.alone[side] - it.together[side];
    }
    EXPECT_NEAR(interface["buried"].number, buried, 1e-7) << it.groups;
    EXPECT_NEAR(interface["together"].number, it.together[0] + it.together[1], 1e-7) << it.groups;
    // The union as a whole is what it is without the option.
    EXPECT_EQ(json["area"].text, run_json({"measure", file.path()})["area"].text);
  }
  const Outcome table = run_program({"measure", file.path(), "--interface", "A+C,B"});
  EXPECT_EQ(table.status, 0);
  EXPECT_NE(table.out.find("interface of A+C,B"), std::string::npos) << table.out;
}

TEST(AreaSums, InterfacesThatAreNone) {
  for (const char *groups : {"A", ",B", "A,", "A++B,C", "A,A", "A+B,B", ""}) {
    const Outcome outcome = run_program({"measure", "good/residues.pdb", "--interface", groups});
    EXPECT_EQ(outcome.status, 2) << groups;
    EXPECT_EQ(outcome.out, "") << groups;
  }
  EXPECT_EQ(run_program({"measure", "good/residues.pdb", "--interface", "A,Z"}).status, 1);
  EXPECT_EQ(run_program({"measure", "good/three.xyzr", "--interface", "A,B"}).status, 2);
  EXPECT_EQ(run_program({"measure", "good/residues.pdb", "--interface", "A,B", "--csv"}).status, 2);
}

}  // namespace
