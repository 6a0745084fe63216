// Crystals whose files have one asymmetric unit: the cell is filled by the operators of the file. Volumes of simple
// lattices are closed forms; of crambin points are counted.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Point = std::array<double, 3>;

constexpr double pi = 3.14159265358979323846;

double ball(double r) {
  return 4.0 / 3.0 * pi * r * r * r;
}

// The common volume of two balls at a distance.
double lens(double r, double s, double d) {
  const double sum = r + s - d;
  return pi * sum * sum * (d * d + 2 * d * (r + s) - 3 * (r - s) * (r - s)) / (12 * d);
}

std::string cif(const std::string &cell, const std::vector<std::string> &operators, const std::string &atoms) {
  static const char *const names[] = {"length_a", "length_b", "length_c", "angle_alpha", "angle_beta", "angle_gamma"};
  std::istringstream numbers(cell);
  std::string text = "data_crystal\n_symmetry_space_group_name_H-M 'F d -3 m'\n", number;
  for (const char *name : names) {
    numbers >> number;
    text.append("_cell_").append(name).append(" ").append(number).append("\n");
  }
  text += "loop_\n_symmetry_equiv_pos_site_id\n_symmetry_equiv_pos_as_xyz\n";
  for (const std::string &it : operators) text.append("1 '").append(it).append("'\n");
  return text + "loop_\n_atom_site_label\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n" + atoms;
}

const std::vector<std::string> centred = {"x,y,z", "X, Y+1/2, Z+1/2", "1/2+x,y,.5+z", "x+0.5,y+1/2,z"};

// The operators of the list, and each with coordinates exchanged all around, and each of those with its mirror image
// in a point.
std::vector<std::string> all_around(const std::vector<std::string> &list, const std::string &centre) {
  std::vector<std::string> all;
  for (const std::string &one : list) {
    std::array<std::string, 3> part;
    std::istringstream parts(one);
    for (std::string &it : part) std::getline(parts, it, ',');
    for (size_t turn = 0; turn < 3; ++turn) {
      std::string even, odd;
      for (size_t k = 0; k < 3; ++k) {
        std::string sum = part[(k + turn) % 3], mirrored;
        std::erase(sum, ' ');
        for (const char c : sum) {
          if (std::string("xyzXYZ").find(c) != std::string::npos) mirrored += '-';
          mirrored += c;
        }
        for (size_t at; (at = mirrored.find("+-")) != std::string::npos;) mirrored.erase(at, 1);
        even += (k == 0 ? "" : ",") + sum;
        odd += (k == 0 ? "" : ",") + mirrored + centre;
      }
      all.push_back(even);
      all.push_back(odd);
    }
  }
  return all;
}

TEST(UnitCell, SimpleLatticesHaveTheVolumeOfClosedForms) {
  const struct {
    const char *name;
    std::string text;
    const char *radii;
    int balls, special;
    double volume, cell;
  } crystals[] = {
      {"bcc", cif("3 3 3 90 90 90", {"x,y,z", "x+1/2,y+1/2,z+1/2"}, "C1 0.1 0.2 0.3\n"), "C=1.4", 2, 0,
       2 * ball(1.4) - 8 * lens(1.4, 1.4, std::sqrt(6.75)), 27},
      {"fcc", cif("4 4 4 90 90 90", centred, "C1 0.1(2) 0.2 -0.3\n"), "C=1.5", 4, 0,
       4 * ball(1.5) - 24 * lens(1.5, 1.5, std::sqrt(8.0)), 64},
      // All atoms of the box are in the file, and its operators too.
      {"whole fcc", cif("4 4 4 90 90 90", centred, "C1 0.1 0.2 -0.3\nC2 0.1 0.7 .2\nC3 -0.4 0.2 1.2\nC4 0.6 0.7 0.7\n"),
       "C=1.5", 4, 12, 4 * ball(1.5) - 24 * lens(1.5, 1.5, std::sqrt(8.0)), 64},
      {"diamond", cif("3.567 3.567 3.567 90 90 90", all_around(centred, "+1/4"), "C1 0 0 0\n"), "C=0.8", 8, 16,
       8 * ball(0.8) - 16 * lens(0.8, 0.8, 3.567 * std::sqrt(3.0) / 4), 3.567 * 3.567 * 3.567},
      {"salt", cif("5.64 5.64 5.64 90 90 90", all_around(centred, ""), "Na1 0.0000 0 0\nCl1 0.5 0.5 0.5\n"),
       "Na=1.5,Cl=1.6", 8, 40, 4 * ball(1.5) + 4 * ball(1.6) - 24 * lens(1.5, 1.6, 2.82), 5.64 * 5.64 * 5.64},
      // An atom is not doubled by an operator before the identity either.
      {"centre", cif("9 9 9 90 90 90", {"-x,-y,-z", "x,y,z"}, "C1 0.5 0 0\n"), "C=1.5", 1, 1, ball(1.5), 729},
      // Thirds, rounded as files have them, on axes of a skew cell.
      {"hcp",
       cif("3 3 5 90 90 120", {"x,y,z", "-y,x-y,z", "-x+y,-x,z", "-x,-y,z+1/2", "y,-x+y,z+1/2", "x-y,x,z+1/2"},
           "C1 0.3333 0.6667 .25\n"),
       "C=1.6", 2, 4, 2 * ball(1.6) - 6 * lens(1.6, 1.6, 3) - 6 * lens(1.6, 1.6, std::sqrt(3 + 6.25)),
       45 * std::sqrt(0.75)},
  };
  for (const auto &crystal : crystals) {
    const TemporaryFile file("crystal.cif", crystal.text);
    const Json found = run_json({"measure", file.path(), "--box", "file", "--radius", crystal.radii});
    EXPECT_EQ(found["n"].number, crystal.balls) << crystal.name;
    EXPECT_NEAR(found["volume"].number, crystal.volume, 1e-6) << crystal.name;
    EXPECT_NEAR(found["box_volume"].number, crystal.cell, 1e-6) << crystal.name;
    EXPECT_EQ(found["symmetry"].keys,
              (std::vector<std::string>{"space_group", "operators", "filled", "special_positions", "matrices"}));
    EXPECT_EQ(found["symmetry"]["special_positions"].number, crystal.special) << crystal.name;
    EXPECT_TRUE(found["symmetry"]["filled"].boolean) << crystal.name;
    EXPECT_EQ(found["input"]["coordinates"].text, "fract_x");
    EXPECT_LT(run_json({"measure", file.path(), "--box", "p1", "--radius", crystal.radii})["n"].number, 5);
  }
}

// All 192 operators of F m -3 m: axes in any order, with any signs, and the centring.
std::vector<std::string> cubic_operators() {
  const std::array<std::array<int, 3>, 6> orders = {{{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  std::vector<std::string> all;
  for (unsigned k = 0; k < 192; ++k) {
    std::string text;
    for (unsigned row = 0; row < 3; ++row) {
      const unsigned centring = k / 48;  // none, or halves but for one row
      text += (row == 0 ? "" : ",") + std::string((k % 8 >> row & 1) != 0 ? "-" : "") + "xyz"[orders[k / 8 % 6][row]];
      if (centring != 0 && row + 1 != centring) text += "+1/2";
    }
    all.push_back(text);
  }
  return all;
}

// Atoms on special positions count as often as the International Tables say, however many digits each number has and
// whichever atom has most; but what is elsewhere by more than the digits explain is another atom.
TEST(UnitCell, MultiplicitiesDoNotDependOnDigits) {
  const std::string hexagonal = "13 13 14 90 90 120", cube = "20 20 20 90 90 90",
                    other = "Si1 0.01021 0.3000 0.6123456789\n";
  const std::vector<std::string> trigonal = {"x,y,z", "-y,x-y,z", "-x+y,-x,z", "-y,-x,z", "-x+y,y,z", "x,x-y,z"};
  const struct {
    const char *xyz;
    int balls;
    bool cubic;
  } sites[] = {
      {"0 0 0", 4, true},
      {"0.1194 0 0", 24, true},
      {"0.1194000001 0.0000001 0", 24, true},
      {"0.05361 0.0536 0.053612", 32, true},
      {"0 0.171 0.17", 48, true},
      {"0.00001 0.1712 0.17119999", 48, true},
      {"0 0.2031 0.0940", 96, true},
      {"0.33 0.333 0.0940", 96, true},
      {"0.11 0.25001 0.3", 192, true},
      {"0.0008 0 0", 24, true},
      {"0.02 0.04 0.00", 96, true},
      {"0.2293 0.4585 0.25", 3, false},
      {"0.22926 0.4585 0.25", 3, false},
      {"0.23 0.46 0.1", 3, false},
      {"0.333 0.667 0.25", 1, false},
      {"0.333333333 0.66667 0.25", 1, false},
      {"0.33 0.67 0.25", 1, false},
      {"0.2293 0.4605 0.25", 6, false},
  };
  for (const auto &site : sites) {
    for (const char *rest : {"", "more digits"}) {
      const bool more = rest[0] != '\0';
      const std::string atoms = std::string("C1 ") + site.xyz + "\n" + (more ? other : "");
      const TemporaryFile file("site.cif",
                               cif(site.cubic ? cube : hexagonal, site.cubic ? cubic_operators() : trigonal, atoms));
      const Json found = run_json({"measure", file.path(), "--box", "file"});
      EXPECT_EQ(found["n"].number, site.balls + (more ? (site.cubic ? 192 : 6) : 0)) << site.xyz << rest;
      EXPECT_EQ(found["symmetry"]["special_positions"].number, (site.cubic ? 192 : 6) - site.balls) << site.xyz << rest;
    }
  }
}

std::string crambin() {
  return molecules_folder() + "/crambin.pdb";
}

// The cell of crambin, a b c and beta, whose axis b stands upright to both others.
struct Cell {
  double a = 40.96, b = 18.65, c = 22.52, beta = 90.77 * pi / 180;
  // The shortest way from p to q and its images.
  [[nodiscard]] double between(const Point &p, const Point &q) const {
    Point d = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
    d[1] -= b * std::round(d[1] / b);
    const double up = std::round(d[2] / (c * std::sin(beta)));
    d[2] -= up * c * std::sin(beta);
    d[0] -= up * c * std::cos(beta);
    d[0] -= a * std::round(d[0] / a);
    return std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  }
};

// By the operator -x, y + 1/2, -z.
Point turned(const Point &p, const Cell &cell) {
  return {-p[0], p[1] + cell.b / 2, -p[2]};
}

struct Atom {
  Point centre;
  double radius;
};

std::vector<Atom> atoms_of(const Json &found) {
  std::vector<Atom> atoms;
  for (const Json &it : found["balls"].items) {
    atoms.push_back({{it["xyz"].items.at(0).number, it["xyz"].items.at(1).number, it["xyz"].items.at(2).number},
                     it["radius"].number});
  }
  return atoms;
}

TEST(UnitCell, CrambinHasTwoMolecules) {
  const Cell cell;
  const std::vector<Atom> alone = atoms_of(run_json({"measure", crambin(), "--per-ball"}));
  const Json found = run_json({"measure", crambin(), "--box", "file", "--per-ball"});
  const std::vector<Atom> all = atoms_of(found);
  ASSERT_EQ(alone.size(), 327U);
  ASSERT_EQ(all.size(), 654U);
  EXPECT_EQ(found["symmetry"]["space_group"].text, "P 1 21 1");
  EXPECT_EQ(found["symmetry"]["operators"].number, 2);
  Point mean = {};
  for (size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(all[i].centre, alone[i].centre);
    EXPECT_EQ(all[i + 327].radius, alone[i].radius);
    EXPECT_LT(cell.between(all[i + 327].centre, turned(alone[i].centre, cell)), 1e-3);
    EXPECT_LT(cell.between(all[i].centre, turned(all[i + 327].centre, cell)), 1e-3);
    for (size_t k = 0; k < 3; ++k) mean[k] += all[i + 327].centre[k] / 327;
  }
  EXPECT_TRUE(mean[1] > 0 && mean[1] < cell.b && mean[2] > 0 && mean[2] < cell.c) << "it stands in the box";

  // Points of the asymmetric unit and its images, counted without the program's copies. Balls of less than half the
  // shortest edge: of each atom one image is near enough.
  std::mt19937 random(11);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const int points = 5000;
  int covered = 0;
  for (int i = 0; i < points; ++i) {
    const double up = share(random) * cell.c;
    const Point p = {share(random) * cell.a + up * std::cos(cell.beta), share(random) * cell.b,
                     up * std::sin(cell.beta)};
    bool inside = false;
    for (const Atom &atom : alone) {
      inside = inside || cell.between(p, atom.centre) < atom.radius ||
               cell.between(p, turned(atom.centre, cell)) < atom.radius;
    }
    covered += inside ? 1 : 0;
  }
  const double volume = cell.a * cell.b * cell.c * std::sin(cell.beta);
  const double part = static_cast<double>(covered) / points;
  EXPECT_NEAR(found["box_volume"].number, volume, 1e-5);
  EXPECT_NEAR(found["volume"].number / volume, part, 4 * std::sqrt(part * (1 - part) / points));
  // By Matthews two molecules of 4730 units at 1.23 A^3 each leave 32 % to the solvent; of the rest two thirds to
  // three quarters are within atoms.
  const Json heavy = run_json({"measure", crambin(), "--box", "file", "--radii", "protor"});
  const double protein = 2 * 4730 * 1.23;
  EXPECT_NEAR(1 - protein / volume, 0.324, 0.01);
  EXPECT_NEAR(heavy["volume"].number / protein, 0.70, 0.06);
}

const std::string cryst1 = "CRYST1   10.000   12.000   14.000  90.00  90.00  90.00 P 1 2 1       2\n";

std::string axis(const std::string &last_row = "0.000000  0.000000 -1.000000        0.00000") {
  return "REMARK 290   SMTRY1   1  1.000000  0.000000  0.000000        0.00000\n"
         "REMARK 290   SMTRY2   1  0.000000  1.000000  0.000000        0.00000\n"
         "REMARK 290   SMTRY3   1  0.000000  0.000000  1.000000        0.00000\n"
         "REMARK 290   SMTRY1   2 -1.000000  0.000000  0.000000        0.00000\n"
         "REMARK 290   SMTRY2   2  0.000000  1.000000  0.000000        0.00000\n"
         "REMARK 290   SMTRY3   2  " +
         last_row + "\n";
}

std::string water(const std::string &xyz) {
  return "HETATM    1  O   HOH A   1    " + xyz + "  0.50  0.00           O\n";
}

// An atom on an axis is its own image, by as many digits as the file has; half an angstrom beside it there are two.
TEST(UnitCell, AtomsOnAnAxisCountOnce) {
  const struct {
    const char *xyz;
    int balls;
  } cases[] = {{"   0.000   3.000   0.000", 1}, {"   5.000   3.000   7.000", 1}, {"   0.001   3.000   0.000", 1},
               {"   0.004   3.000   0.000", 1}, {"   0.010   3.000   0.000", 2}, {"   0.250   3.000   0.000", 2},
               {"  10.000   3.000 -14.000", 1}};
  for (const auto &it : cases) {
    const TemporaryFile file("axis.pdb", axis() + cryst1 + water(it.xyz));
    const Json found = run_json({"measure", file.path(), "--box", "file"});
    EXPECT_EQ(found["n"].number, it.balls) << it.xyz;
    EXPECT_EQ(found["symmetry"]["special_positions"].number, 2 - it.balls) << it.xyz;
  }
}

TEST(UnitCell, TheTableSaysWhatWasMade) {
  const std::string at = "   1.000   3.000   2.000";
  const std::string p1 = "CRYST1   10.000   12.000   14.000  90.00  90.00  90.00 P 1           1\n";
  const struct {
    std::string text;
    const char *box, *row;  // empty: there is none
  } cases[] = {
      {axis() + cryst1 + water(at), "file", "P 1 2 1: the box is filled by 2 operators\n"},
      {axis() + cryst1 + water("   0.000   3.000   0.000"), "file",
       "P 1 2 1: the box is filled by 2 operators; images on special positions that count once: 1\n"},
      {axis() + cryst1 + water(at), "p1", "P 1 2 1: copies by symmetry are not made\n"},
      {cryst1 + water(at), "file", "P 1 2 1: copies by symmetry are not made, the file has no operators\n"},
      {axis("0.000000  zero     -1.000000        0.00000") + cryst1 + water(at), "file",
       "P 1 2 1: copies by symmetry are not made, the file's operators cannot be read\n"},
      {p1 + water(at), "file", ""},
      {p1.substr(0, 55) + "\n" + water(at), "file", ""},
      {"data_a\n_cell.length_a 9\n_cell.length_b 9\n_cell.length_c 9\n_cell.angle_alpha 90\n_cell.angle_beta 90\n"
       "_cell.angle_gamma 90\n_symmetry.space_group_name_H-M 'P 21 21 21'\n"
       "_atom_site.type_symbol O\n_atom_site.Cartn_x 1\n_atom_site.Cartn_y 1\n_atom_site.Cartn_z 1\n",
       "file", "P 21 21 21: copies by symmetry are not made, the file has no operators\n"},
  };
  for (const auto &it : cases) {
    const TemporaryFile file(it.text[0] == 'd' ? "row.cif" : "row.pdb", it.text);
    for (const char *command : {"measure", "boundary", "contacts"}) {
      const Outcome outcome = run_program({command, file.path(), "--box", it.box});
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      const size_t at_row = outcome.out.find("  space group      ");
      ASSERT_EQ(at_row == std::string::npos, it.row[0] == '\0') << outcome.out;
      if (it.row[0] == '\0') continue;
      EXPECT_EQ(outcome.out.substr(at_row + 19, std::string(it.row).size()), it.row);
    }
    // Tables of numbers have no such row, and a line has what is missing.
    const Outcome csv = run_program({"measure", file.path(), "--box", it.box, "--csv"});
    const bool missing = it.box[0] == 'f' && std::string(it.row).find("not made") != std::string::npos;
    EXPECT_EQ(csv.err.find("copies by symmetry are not made") != std::string::npos, missing) << csv.err;
    EXPECT_EQ(run_program({"measure", file.path(), "--csv"}).err.find("symmetry"), std::string::npos);
    // Without a box nothing is filled.
    EXPECT_EQ(run_json({"measure", file.path()})["n"].number, 1);
  }
}

TEST(UnitCell, OperatorsThatDoNotFitAreRefused) {
  const TemporaryFile file(
      "unfit.pdb", axis("0.000000  0.500000 -0.866025        0.00000") + cryst1 + water("   1.000   3.000   2.000"));
  const Outcome outcome = run_program({"measure", file.path(), "--box", "file"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("does not fit its box; --box p1"), std::string::npos) << outcome.err;
  EXPECT_EQ(run_json({"measure", file.path(), "--box", "p1"})["n"].number, 1);
  const TemporaryFile cubic("cubic.cif", cif("9 9.2 9 90 90 90", {"x,y,z", "z,x,y"}, "C1 0 0 0\n"));
  EXPECT_NE(run_program({"measure", cubic.path(), "--box", "file"}).err.find("does not fit its box"),
            std::string::npos);
  const TemporaryFile words("words.cif", cif("9 9 9 90 90 90", {"x,y,z", "x,y"}, "C1 0 0 0\n"));
  const std::string note = "copies by symmetry are not made, the file's operators cannot be read";
  EXPECT_FALSE(run_json({"measure", words.path(), "--box", "file"}, note)["symmetry"]["filled"].boolean);
}

// The coordinates of an atom record, each less by so much.
std::string shifted(std::string line, const Point &by) {
  for (size_t k = 0; k < 3; ++k) {
    char text[16];
    std::snprintf(text, sizeof text, "%8.3f", std::stod(line.substr(30 + 8 * k, 8)) - by[k]);
    line.replace(30 + 8 * k, 8, text);
  }
  return line;
}

// The same crystal in a frame of its own, which SCALE tells: y, z and x in the places of x, y and z; and with an origin
// of its own, where REMARK 290 has matrices that do not know it.
TEST(UnitCell, EntriesHaveFramesOfTheirOwn) {
  const std::string head =
      "REMARK 290   SMTRY1   1  1.000000  0.000000  0.000000        0.00000\n"
      "REMARK 290   SMTRY2   1  0.000000  1.000000  0.000000        0.00000\n"
      "REMARK 290   SMTRY3   1  0.000000  0.000000  1.000000        0.00000\n";
  const std::string standard = head +
                               "REMARK 290   SMTRY1   2 -1.000000  0.000000  0.000000        0.00000\n"
                               "REMARK 290   SMTRY2   2  0.000000  1.000000  0.000000        9.32505\n"
                               "REMARK 290   SMTRY3   2  0.000000  0.000000 -1.000000        0.00000\n";
  const std::string own = head +
                          "REMARK 290   SMTRY1   2  1.000000  0.000000  0.000000        9.32505\n"
                          "REMARK 290   SMTRY2   2  0.000000 -1.000000  0.000000        0.00000\n"
                          "REMARK 290   SMTRY3   2  0.000000  0.000000 -1.000000        0.00000\n";
  const std::string cell = "CRYST1   40.960   18.650   22.520  90.00  90.77  90.00 P 1 21 1      2\n";
  const std::string scale =
      "SCALE1      0.000000  0.000328  0.024414        0.00000\n"
      "SCALE2      0.053619  0.000000  0.000000        0.00000\n"
      "SCALE3      0.000000  0.044409  0.000000        0.00000\n";
  const std::string identity =
      "SCALE1      1.000000  0.000000  0.000000        0.00000\n"
      "SCALE2      0.000000  1.000000  0.000000        0.00000\n"
      "SCALE3      0.000000  0.000000  1.000000        0.00000\n";
  const std::string distant =
      "SCALE1      0.000000  0.000328  0.024414        0.07390\n"
      "SCALE2      0.053619  0.000000  0.000000        0.05362\n"
      "SCALE3      0.000000  0.044409  0.000000        0.08882\n";
  const std::string written = "REMARK 290       1555   X,Y,Z\nREMARK 290       2555   -X,Y+1/2,-Z\nREMARK 290\n";
  std::string atoms, moved, elsewhere;
  std::istringstream lines(read_file(crambin()));
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("ATOM", 0) != 0) continue;
    atoms += line + "\n";
    const std::string own_line = line.substr(0, 30) + line.substr(38, 16) + line.substr(30, 8) + line.substr(54) + "\n";
    moved += own_line;
    elsewhere += shifted(own_line, {1, 2, 3});
  }
  const TemporaryFile first("standard.pdb", standard + cell + identity + atoms);
  const TemporaryFile second("own.pdb", own + cell + scale + moved), none("none.pdb", own + cell + moved);
  const TemporaryFile third("origin.pdb", written + own + cell + distant + elsewhere);
  for (const char *box : {"file", "p1"}) {
    const Json expected = run_json({"measure", first.path(), "--probe", "1.4", "--box", box});
    EXPECT_EQ(expected["box"].items.at(1).number, 0);
    for (const std::string &path : {second.path(), third.path()}) {
      const Json found = run_json({"measure", path, "--probe", "1.4", "--box", box});
      EXPECT_EQ(found["n"].number, expected["n"].number);
      // SCALE has six decimals: angles of 1e-5, and atoms of different copies that much elsewhere.
      EXPECT_NEAR(found["volume"].number, expected["volume"].number, 0.5) << box;
      EXPECT_NEAR(found["area"].number, expected["area"].number, 1) << box;
      EXPECT_EQ(found["box_volume"].number, expected["box_volume"].number);
      EXPECT_NEAR(found["box"].items.at(2).number, expected["box"].items.at(0).number, 1e-3);
    }
  }
  EXPECT_NE(run_program({"measure", none.path(), "--box", "file"}).err.find("does not fit its box"), std::string::npos);
}

// Copies by other matrices are not made, but counted: a 1 in column 60 says that the file has one.
TEST(UnitCell, MatricesAreCounted) {
  const std::string row = "  0.600223  0.189076  0.777164       -6.37893    ";
  const std::string text = axis() + cryst1 + "MTRIX1   1" + row + "1\nMTRIX1   2" + row + "\nMTRIX2   2" + row +
                           "\nMTRIX1   3" + row + "\n" + water("   1.000   3.000   2.000");
  const TemporaryFile file("matrices.pdb", text);
  EXPECT_EQ(run_json({"measure", file.path(), "--box", "file"})["symmetry"]["matrices"].number, 2);
  const std::string table = run_program({"measure", file.path(), "--box", "file"}).out;
  EXPECT_NE(table.find("filled by 2 operators; copies by MTRIX that are not made: 2\n"), std::string::npos) << table;
}

// Sums over residues and contacts are of all copies.
TEST(UnitCell, ContactsReachTheCopies) {
  const Json alone = run_json({"contacts", crambin(), "--probe", "1.4", "--box", "p1"});
  const Json filled = run_json({"contacts", crambin(), "--probe", "1.4", "--box", "file"});
  EXPECT_GT(filled["contacts"].number, 2 * alone["contacts"].number - 500);
  bool between = false;
  for (const Json &pair : filled["pairs"].items) {
    between = between || (pair["balls"].items.at(0).number < 327 && pair["balls"].items.at(1).number >= 327);
  }
  EXPECT_TRUE(between);
}

}  // namespace
