// Bonds of ball-and-stick pictures: by CONECT records, by distances, and of records that make no sense.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

std::string carbon(const std::string &serial, double x, double y = 0, double z = 0) {
  char line[100];
  std::snprintf(line, sizeof line, "HETATM%5s  C   LIG A   1    %8.3f%8.3f%8.3f  1.00  0.00           C\n",
                serial.c_str(), x, y, z);
  return line;
}

// Carbons in a row, with these serial numbers.
std::string chain(const std::vector<std::string> &serials, double step = 1.5) {
  std::string text;
  for (size_t k = 0; k < serials.size(); ++k) text += carbon(serials[k], step * static_cast<double>(k));
  return text;
}

// Too far apart to be bonded; no line between two of them passes others.
std::string star(const std::vector<std::string> &serials) {
  return carbon(serials[0], 0) + carbon(serials[1], 3) + carbon(serials[2], 0, 3) + carbon(serials[3], 0, 0, 3) +
         carbon(serials[4], -3);
}

int sticks_of(const std::string &text, const std::vector<std::string> &options = {}) {
  const TemporaryFile file("bonds.pdb", text), out("bonds.svg");
  std::vector<std::string> arguments = {"draw", file.path(),      "-o",      out.path(),
                                        "--as", "ball-and-stick", "--stick", "0.05"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return static_cast<int>(run_json(arguments)["sticks"].number);
}

const std::vector<std::string> four = {"1", "2", "3", "4"};

TEST(Bonds, ByDistancesWhereNothingIsSaid) {
  EXPECT_EQ(sticks_of(chain(four)), 3);
  EXPECT_EQ(sticks_of(chain(four, 2.0)), 0);
}

// The first and the last of three are close enough too, but for the atom between them.
TEST(Bonds, PastNoAtom) {
  EXPECT_EQ(sticks_of(chain({"1", "2", "3"}, 0.9), {"--ball-size", "0.1"}), 2);
  EXPECT_EQ(sticks_of(carbon("1", 0) + carbon("2", 1.5) + carbon("3", 0.75, 1.3)), 3);
}

// Atoms that are named are decided by the records: 1-2 and 3-4 are said, 2-3 is not; 5 is not named, and close to 4.
TEST(Bonds, ByRecords) {
  const std::string records = "CONECT    1    2\nCONECT    2    1\nCONECT    3    4\n";
  EXPECT_EQ(sticks_of(chain(four) + records), 2);
  EXPECT_EQ(sticks_of(records + chain(four)), 2);
  EXPECT_EQ(sticks_of(chain({"1", "2", "3", "4", "5"}) + records), 3);
  // Far apart too; up to four in a record.
  EXPECT_EQ(sticks_of(star({"1", "2", "3", "4", "5"}) + "CONECT    1    2    3    4    5\n"), 4);
}

TEST(Bonds, OfAtomsThatAreDrawn) {
  const std::string water = "HETATM    6  O   HOH A   2       0.000   0.000  -2.000  1.00  0.00           O\n";
  const std::string records = "CONECT    1    2    6\n";
  EXPECT_EQ(sticks_of(star({"1", "2", "3", "4", "5"}) + water + records), 1);
  EXPECT_EQ(sticks_of(star({"1", "2", "3", "4", "5"}) + water + records, {"--water"}), 2);
}

// Columns touch; hybrid numbers are texts.
TEST(Bonds, ByLargeSerialNumbers) {
  EXPECT_EQ(
      sticks_of(star({"99998", "99999", "A0000", "A0001", "A0002"}) + "CONECT99998A0001\nCONECT9999999998A0000\n"), 3);
}

// None of these is a bond, and atoms that only they name are bonded by distances.
TEST(Bonds, WithoutRecordsThatMakeNoSense) {
  for (const char *record :
       {"CONECT", "CONECT\n", "CONECT    1", "CONECT    1    1", "CONECT    9    8", "CONECT    1    9",
        "CONECT         2", "CONECT    1    ", "CONECT  x  y  z", "CONECT   -1   -2", "conect    1    1    9",
        "CONECT    1                        2    3", "CONECT\t1\t2", "CONECTION    1    4"})
    EXPECT_EQ(sticks_of(chain(four) + record + "\n"), 3) << record;
}

TEST(Bonds, SaidMoreThanOnce) {
  std::string many = chain(four);
  for (int k = 0; k < 300; ++k) many += "CONECT    1    2    2    2    2\nCONECT    2    1    1    1    1\n";
  EXPECT_EQ(sticks_of(many), 3);
}

// A number of two atoms names neither; in another model it is another atom's.
TEST(Bonds, OfNumbersThatAreNotUnique) {
  EXPECT_EQ(sticks_of(star({"1", "2", "2", "4", "5"}) + "CONECT    1    2    4\n"), 1);
  const std::string five = star({"1", "2", "3", "4", "5"});
  EXPECT_EQ(
      sticks_of("MODEL        1\n" + five + "ENDMDL\nMODEL        2\n" + five + "ENDMDL\nCONECT    1    2    4\n"), 2);
}

// The program's words on manifold bonds, empty where there is none, and how many strands are drawn more than with one
// for each bond.
struct Multiple {
  std::string said;
  int more = 0;
};
bool operator==(const Multiple &a, const Multiple &b) {
  return a.said == b.said && a.more == b.more;
}
std::ostream &operator<<(std::ostream &out, const Multiple &multiple) {
  return out << multiple.said << ", " << multiple.more;
}

Multiple multiple_in(const std::string &text, const std::string &extension,
                     const std::vector<std::string> &options = {}) {
  const TemporaryFile file("bonds." + extension, text), out("bonds.svg");
  std::vector<std::string> arguments = {"draw", file.path(), "-o", out.path(), "--as", "ball-and-stick"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  Multiple multiple;
  const size_t at = outcome.out.find("radii; ");
  if (at != std::string::npos) multiple.said = outcome.out.substr(at + 7, outcome.out.find('\n', at) - at - 7);
  // Each half of a stick is a path; its strands are loops of it.
  std::ifstream stream(out.path());
  const std::string svg{std::istreambuf_iterator<char>(stream), {}};
  for (size_t path = svg.find(" d=\""); path != std::string::npos; path = svg.find(" d=\"", path + 1)) {
    const size_t end = svg.find('"', path + 4);
    for (size_t k = path + 5; k < end; ++k) multiple.more += svg[k] == 'M' || svg[k] == 'm' ? 1 : 0;
  }
  return multiple;
}

TEST(Bonds, AreAsManifoldAsTheyAreSaid) {
  // Halves of one colour are one path.
  const std::string three = chain({"1", "2", "3"});
  const auto said = [&](const std::string &records) { return multiple_in(three + records, "pdb"); };
  EXPECT_EQ(said("CONECT    1    2\nCONECT    2    1    3\nCONECT    3    2\n"), (Multiple{"", 0}));
  EXPECT_EQ(said("CONECT    1    2    2\nCONECT    2    1    1    3\nCONECT    3    2\n"),
            (Multiple{"1 multiple ones", 1}));
  // By one end alone, in any order, in several records.
  EXPECT_EQ(said("CONECT    3    2\nCONECT    1    2\nCONECT    3    2\nCONECT    3    2\n"),
            (Multiple{"1 multiple ones", 2}));
  // Bonds with more than three lines say nothing, nor do models that say all of it again.
  EXPECT_EQ(said("CONECT    1    2    2    2    2\nCONECT    2    1    1    1    1\n"), (Multiple{"", 0}));
  const std::string again = three + "CONECT    2    3    3\nENDMDL\n";
  EXPECT_EQ(multiple_in("MODEL        1\n" + again + "MODEL        2\n" + again, "pdb"),
            (Multiple{"1 multiple ones", 1}));
}

TEST(Bonds, AreDrawnAsSingleWhereManifoldOnesDoNotFit) {
  const std::string text = chain({"1", "2"}) + "CONECT    1    2    2\n";
  EXPECT_EQ(multiple_in(text, "pdb", {"--stick", "0.28"}), (Multiple{"1 multiple ones", 1}));
  EXPECT_EQ(multiple_in(text, "pdb", {"--stick", "0.29"}), (Multiple{"1 multiple ones, drawn as single", 0}));
}

// Side by side all of a bond is one piece, with lines where its strands begin and end.
TEST(Bonds, HaveLinesBetweenStrandsWhereTheyArePieces) {
  const std::vector<std::string> options = {"--pieces", "visible"};
  const std::string two = chain({"1", "2"});
  const Multiple single = multiple_in(two, "pdb", options);
  EXPECT_EQ(multiple_in(two + "CONECT    1    2    2\n", "pdb", options),
            (Multiple{"1 multiple ones", single.more + 2}));
  EXPECT_EQ(multiple_in(two + "CONECT    1    2    2    2\n", "pdb", options),
            (Multiple{"1 multiple ones", single.more + 4}));
}

// A ring and what is bonded to it, as a component or in the words of a library of monomers.
TEST(Bonds, OfComponents) {
  const std::string atoms =
      "data_BNZ\nloop_\n_chem_comp_atom.comp_id\n_chem_comp_atom.atom_id\n_chem_comp_atom.type_symbol\n"
      "_chem_comp_atom.x\n_chem_comp_atom.y\n_chem_comp_atom.z\n"
      "BNZ C1 C 0.000 1.39 0\nBNZ C2 C 1.204 0.695 0\nBNZ C3 C 1.204 -0.695 0\nBNZ C4 C 0 -1.39 0\n"
      "BNZ C5 C -1.204 -0.695 0\nBNZ C6 C -1.204 0.695 0\nBNZ C7 C 0 2.82 0\nBNZ N1 N 0 3.98 0\n";
  const auto bonds = [](const std::string &name, const std::string &single, const std::string &twice,
                        const std::string &ring, const std::string &triple) {
    return "loop_\n_chem_comp_bond.comp_id\n_chem_comp_bond.atom_id_1\n_chem_comp_bond.atom_id_2\n_chem_comp_bond." +
           name + "\nBNZ C1 C2 " + twice + "\nBNZ C2 C3 " + ring + "\nBNZ C3 C4 " + twice + "\nBNZ C4 C5 " + single +
           "\nBNZ C5 C6 " + twice + "\nBNZ C6 C1 " + single + "\nBNZ C1 C7 " + single + "\nBNZ C7 N1 " + triple +
           "\nXYZ C1 C4 DOUB\n";
  };
  // A double bond has a strand more, an aromatic one four dashes more, a triple one in two halves two each.
  EXPECT_EQ(multiple_in(atoms + bonds("value_order", "SING", "DOUB", "SING", "TRIP"), "cif"),
            (Multiple{"4 multiple ones", 7}));
  EXPECT_EQ(multiple_in(atoms + bonds("type", "single", "double", "aromatic", "triple"), "cif"),
            (Multiple{"5 multiple ones", 11}));
  EXPECT_EQ(multiple_in(atoms + bonds("type", "single", "double", "deloc", "metalc"), "cif"),
            (Multiple{"4 multiple ones", 7}));
}

// Names of up to 6 letters tell which atoms are bonded; bonds of longer ones are found by distance.
TEST(Bonds, OfComponentsWithLongNames) {
  const auto multiple = [](const std::string &one, const std::string &two) {
    return multiple_in(
        "data_LIG\nloop_\n_chem_comp_atom.comp_id\n_chem_comp_atom.atom_id\n_chem_comp_atom.type_symbol\n"
        "_chem_comp_atom.x\n_chem_comp_atom.y\n_chem_comp_atom.z\nLIG " +
            one + " C 0 0 0\nLIG " + two + " C 0 1.34 0\nLIG C3 C 0 2.1 1.2\nloop_\n_chem_comp_bond.comp_id\n" +
            "_chem_comp_bond.atom_id_1\n_chem_comp_bond.atom_id_2\n_chem_comp_bond.value_order\nLIG " + one + " " +
            two + " DOUB\nLIG " + two + " C3 SING\n",
        "cif");
  };
  EXPECT_EQ(multiple("CARB01", "CARB02"), multiple("C1", "C2"));
  EXPECT_EQ(multiple("C1", "C2").said, "1 multiple ones");
  EXPECT_EQ(multiple("CARBON1", "CARBON2").said, "");
}

// One bond needs no loop, and may be before the atoms, as a loop may. Bonds of other components, whose atoms have the
// same names, are not this one's, in whatever block they are.
TEST(Bonds, OfComponentsAreAnywhereInTheirBlock) {
  const auto atoms_of = [](const std::string &name) {
    return "loop_\n_chem_comp_atom.comp_id\n_chem_comp_atom.atom_id\n_chem_comp_atom.type_symbol\n_chem_comp_atom.x\n"
           "_chem_comp_atom.y\n_chem_comp_atom.z\n" +
           name + " C C 0 0 0\n" + name + " O O 1.128 0 0\n";
  };
  const std::vector<std::string> tags = {"comp_id", "atom_id_1", "atom_id_2", "pdbx_stereo_config", "value_order"};
  const auto pairs_of = [&](const std::string &name, const std::string &order) {
    const std::vector<std::string> values = {name, "C", "O", "N", order};
    std::string text;
    for (size_t k = 0; k < tags.size(); ++k) text += "_chem_comp_bond." + tags[k] + "   " + values[k] + "\n";
    return text;
  };
  const auto loop_of = [&](const std::string &rows) {
    std::string text = "loop_\n";
    for (const std::string &tag : tags) text += "_chem_comp_bond." + tag + "\n";
    return text + rows;
  };
  const std::string data = "data_CMO\n", atoms = atoms_of("CMO"), pairs = pairs_of("CMO", "TRIP");
  const std::string loop = loop_of("CMO C O N TRIP\n"), other = loop_of("XYZ C O N DOUB\n");
  const std::string of_other = pairs_of("XYZ", "DOUB"), block = "data_XYZ\n";
  const Multiple triple = {"1 multiple ones", 4}, twice = {"1 multiple ones", 2};
  const auto said = [](const std::string &text, const std::vector<std::string> &options = {}) {
    return multiple_in(text, "cif", options);
  };
  EXPECT_EQ(said(data + atoms), (Multiple{"", 0}));
  for (const std::string &bonds : {pairs, loop, "_chem_comp_bond.type ?\n" + pairs}) {
    EXPECT_EQ(said(data + atoms + bonds), triple);
    EXPECT_EQ(said(data + bonds + atoms), triple);
    EXPECT_EQ(said(data + "_chem_comp.id CMO\n" + bonds + "_chem_comp.name CO\n" + atoms), triple);
    EXPECT_EQ(said(data + other + bonds + atoms), triple);
    EXPECT_EQ(said(data + bonds + atoms + block + of_other + atoms_of("XYZ")), triple);
    EXPECT_EQ(said(data + bonds + atoms + block + of_other + atoms_of("XYZ"), {"--model", "2"}), twice);
    EXPECT_EQ(said(block + of_other + atoms_of("XYZ") + other + data + atoms + bonds, {"--model", "2"}), triple);
  }
  for (const std::string &bonds : {other, of_other}) {
    EXPECT_EQ(said(data + bonds + atoms), (Multiple{"", 0}));
    EXPECT_EQ(said(data + atoms + bonds), (Multiple{"", 0}));
    EXPECT_EQ(said(data + atoms + bonds + atoms_of("XYZ"), {"--model", "2"}), twice);
  }
  // A structure has bonds by distances, whatever its dictionary has, and says so.
  const std::string site =
      "loop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.Cartn_x\n"
      "_atom_site.Cartn_y\n_atom_site.Cartn_z\nC C CMO 0 0 0\nO O CMO 1.128 0 0\n";
  for (const std::string &text : {pairs + site, site + pairs, loop + site, pairs + atoms + site}) {
    const TemporaryFile file("site.cif", data + text), out("site.svg");
    const Outcome outcome = run_program({"draw", file.path(), "-o", out.path(), "--as", "ball-and-stick"});
    EXPECT_NE(outcome.out.find("bonds by covalent radii\n"), std::string::npos) << outcome.out;
  }
}

// Dashes are nearer to the middle of the ring than the strand beside them, from wherever it is seen.
TEST(Bonds, HaveTheirDashesWithinTheRing) {
  const std::string ring =
      "data_BNZ\nloop_\n_chem_comp_atom.comp_id\n_chem_comp_atom.atom_id\n_chem_comp_atom.type_symbol\n"
      "_chem_comp_atom.x\n_chem_comp_atom.y\n_chem_comp_atom.z\n"
      "BNZ C1 C 0.000 1.39 0\nBNZ C2 C 1.204 0.695 0\nBNZ C3 C 1.204 -0.695 0\nBNZ C4 C 0 -1.39 0\n"
      "BNZ C5 C -1.204 -0.695 0\nBNZ C6 C -1.204 0.695 0\n"
      "loop_\n_chem_comp_bond.comp_id\n_chem_comp_bond.atom_id_1\n_chem_comp_bond.atom_id_2\n"
      "_chem_comp_bond.value_order\nBNZ C1 C2 AROM\nBNZ C3 C2 AROM\nBNZ C3 C4 AROM\nBNZ C5 C4 AROM\n"
      "BNZ C5 C6 AROM\nBNZ C6 C1 AROM\n";
  const TemporaryFile file("ring.cif", ring), out("ring.svg");
  for (const char *view : {"0,0,1", "0,0,-1"}) {
    ASSERT_EQ(run_program(
                  {"draw", file.path(), "-o", out.path(), "--as", "ball-and-stick", "--style", "flat", "--view", view})
                  .status,
              0);
    std::ifstream stream(out.path());
    const std::string svg{std::istreambuf_iterator<char>(stream), {}};
    double width = 0, height = 0;
    ASSERT_EQ(std::sscanf(svg.c_str() + svg.find("viewBox=\"0 0 "), "viewBox=\"0 0 %lf %lf", &width, &height), 2);
    int sticks = 0;
    for (size_t at = svg.find(" d=\"M"); at != std::string::npos; at = svg.find(" d=\"M", at + 1)) {
      std::vector<double> middles;  // how far out loops begin
      for (size_t k = at + 4; svg[k] != '"'; ++k) {
        double x = 0, y = 0;
        if (svg[k] == 'M' && std::sscanf(svg.c_str() + k, "M%lf %lf", &x, &y) == 2)
          middles.push_back(std::hypot(x - width / 2, y - height / 2));
      }
      if (middles.size() == 1) continue;  // a ball
      ++sticks;
      ASSERT_EQ(middles.size(), 5U);
      const auto farthest = std::max_element(middles.begin(), middles.end()) - middles.begin();
      EXPECT_TRUE(farthest == 0 || farthest == 4) << view;  // the whole strand, first or last
    }
    EXPECT_EQ(sticks, 6);
  }
}

// The kinds of bonds of .sdf, .mol and .mol2 files: of a benzene's ring, of two and three strands. Bonds that name no
// atom, and hydrogen bonds, are none.
TEST(Bonds, KindsInFilesOfSmallMolecules) {
  for (const char *file : {"good/two_records.sdf", "good/two_records.mol2"}) {
    for (const char *model : {"1", "2"}) {
      const TemporaryFile out("kinds.svg");
      const Outcome outcome = run_program({"draw", file, "-o", out.path(), "--as", "ball-and-stick", "--model", model});
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_NE(outcome.out.find("bonds by the file, else by covalent radii; 1 multiple ones"), std::string::npos)
          << outcome.out;
    }
  }
  const std::string places[] = {"1.39 0 0",  "0.695 1.204 0",   "-0.695 1.204 0",
                                "-1.39 0 0", "-0.695 -1.204 0", "0.695 -1.204 0"};
  std::string atoms, bonds;
  for (size_t k = 0; k < 6; ++k) {
    const std::string number = std::to_string(k + 1);
    atoms += number + " C" + number + " " + places[k] + " C.ar\n";
    bonds += number + " " + number + " " + std::to_string((k + 1) % 6 + 1) + " ar\n";
  }
  const std::string head = "@<TRIPOS>MOLECULE\nring\n6 6\n@<TRIPOS>ATOM\n" + atoms + "@<TRIPOS>BOND\n" + bonds;
  EXPECT_EQ(multiple_in(head, "mol2").said.substr(0, 2), "6 ");
  for (const char *more : {"", "7 1 9 2\n8 1 4 nc\n9 1 1 2\n10 1\n"}) {
    const TemporaryFile file("ring.mol2", head + more), out("ring.svg");
    const Json drawn = run_json({"draw", file.path(), "-o", out.path(), "--as", "ball-and-stick"},
                                "all z are 0: a flat molecule, or a drawing, which says nothing of space");
    EXPECT_EQ(drawn["sticks"].number, 6) << more;
  }
}

}  // namespace
