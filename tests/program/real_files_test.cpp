// Files as other programs write them: names without columns, ions and virtual sites, segments, PQR whose columns touch,
// extended XYZ. All are made for the purpose.
#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Words = std::vector<std::string>;

// A record of the PDB format, x in tens.
std::string record(const char *kind, const char *name, const char *residue, const char *chain, int number, double x,
                   const char *tail = "") {
  char line[120];
  std::snprintf(line, sizeof line, "%-6s%5d %-4s %-4s%s%4d    %8.3f%8.3f%8.3f  1.00  0.00%s\n", kind, number, name,
                residue, chain, number, x, 0.0, 0.0, tail);
  return line;
}

// One column of the table of balls.
Words column(const std::string &path, const std::string &name, const Words &options = {}) {
  Words arguments = {"measure", path, "--csv"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  Words values;
  size_t wanted = 0;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    Words fields;
    std::istringstream parts(line);
    for (std::string part; std::getline(parts, part, ',');) fields.push_back(part);
    if (values.empty()) {
      while (wanted < fields.size() && fields[wanted] != name) ++wanted;
    }
    EXPECT_LT(wanted, fields.size()) << line;
    values.push_back(wanted < fields.size() ? fields[wanted] : "");
  }
  if (!values.empty()) values.erase(values.begin());
  return values;
}

// Left-justified names, as CHARMM and X-PLOR write them, without columns for elements.
TEST(RealFiles, LeftJustifiedNames) {
  const TemporaryFile file("left.pdb",
                           record("ATOM", "CA", "MET", "A", 1, 0) + record("ATOM", "CE", "LYS", "A", 2, 10) +
                               record("ATOM", "HG", "SER", "A", 3, 20) + record("HETATM", "CA", "CA", "A", 4, 30) +
                               record("HETATM", "CLA", "CLA", "A", 5, 40) + record("HETATM", " NA", "NA", "A", 6, 50));
  EXPECT_EQ(column(file.path(), "element"), (Words{"C", "C", "H", "Ca", "Cl", "Na"}));
}

TEST(RealFiles, VirtualSitesAreLeftOut) {
  const TemporaryFile file("tip4p.pdb", record("ATOM", " OW", "SOL", "A", 1, 0) +
                                            record("ATOM", " MW", "SOL", "A", 1, 1) +
                                            record("ATOM", "EPW", "WAT", "A", 2, 10) +
                                            record("ATOM", " EP", "LIG", "A", 3, 20, "          EP") +
                                            record("ATOM", " O", "HOH", "A", 4, 30));
  EXPECT_EQ(column(file.path(), "element"), (Words{"O", "O"}));
  const auto sites = [](const TemporaryFile &of) {
    return run_json({"measure", of.path()},
                    " dummies or virtual sites are left out: they are no atoms")["input"]["left_out"]["virtual_sites"]
        .number;
  };
  EXPECT_EQ(sites(file), 3);
  // Callers that give them a radius want them.
  EXPECT_EQ(column(file.path(), "element", {"--radius", "EP=0.5"}), (Words{"O", "Ep", "Ep", "O"}));
  EXPECT_EQ(column(file.path(), "element", {"--radius", "M=0.5"}), (Words{"O", "M", "O"}));
  const TemporaryFile alone("sites.pdb", record("ATOM", " MW", "SOL", "A", 1, 0));
  EXPECT_EQ(run_program({"measure", alone.path()}).err,
            "hardsphere: " + alone.path() + ": no atoms are left: the only one is M, a virtual site\n");
  const TemporaryFile xyz("tip4p.xyz", "3\n\nO 0 0 0\nEP 0 0 1\nM 0 0 2\n");
  EXPECT_EQ(sites(xyz), 2);
}

// All symbols that no element has, in one run; metals are elements.
TEST(RealFiles, UnknownElementsAreNamedAtOnce) {
  const TemporaryFile file("unknown.xyz", "5\n\nXx 0 0 0\nFe 0 0 5\nQq 0 0 9\nXx 0 9 0\nMo 9 0 0\n");
  EXPECT_EQ(run_program({"measure", file.path()}).err,
            "hardsphere: " + file.path() +
                ":3: unknown elements 'Xx' (2 atoms), 'Qq' (1 atom); give radii with --radius "
                "Xx=R,Qq=R, or leave out such atoms with --hide element:Xx,Qq\n");
  const Json input = run_json({"measure", file.path(), "--hide", "element:Xx,Qq"})["input"];
  ASSERT_EQ(input["substitutes"].items.size(), 2u);
  EXPECT_EQ(input["substitutes"].items[0].keys, (Words{"element", "radius", "atoms"}));
  EXPECT_EQ(input["substitutes"].items[0]["element"].text, "Fe");
  EXPECT_EQ(input["substitutes"].items[0]["radius"].number, 2);
  EXPECT_EQ(input["substitutes"].items[1]["element"].text, "Mo");
  EXPECT_EQ(input["substitutes"].items[1]["atoms"].number, 1);
  EXPECT_TRUE(
      run_json({"measure", file.path(), "--radius=Xx=1,Qq=1,Fe=1.3,Mo=1.5"})["input"]["substitutes"].items.empty());
}

// The value of input.substitutes: "X 2 (3)" for three atoms.
std::string substitutes(const Json &input) {
  std::string list;
  for (const Json &one : input["substitutes"].items) {
    char text[80];
    std::snprintf(text, sizeof text, "%s%s %g (%g)", list.empty() ? "" : ", ", one["element"].text.c_str(),
                  one["radius"].number, one["atoms"].number);
    list += text;
  }
  return list;
}

// X of the Protein Data Bank is an atom that somebody saw in the density: it takes up room, as elements without a
// radius do, and is named like them. Its column decides, whatever the name is, and else a name without a known element.
TEST(RealFiles, UnknownAtomsHaveASubstituteRadius) {
  const std::string text = record("HETATM", " UNK", "UNX", "A", 1, 0, "           X") +
                           record("HETATM", " X", "UNX", "A", 2, 10) +
                           record("ATOM", " AD1", "ASX", "A", 3, 20, "           X") +
                           record("ATOM", " AE1", "GLX", "A", 6, 25, "           A") +
                           record("HETATM", "FE", "FE", "A", 4, 30, "          FE") +
                           record("HETATM", " O", "HOH", "A", 5, 40, "           O");
  const TemporaryFile file("unx.pdb", text);
  EXPECT_EQ(column(file.path(), "element"), (Words{"X", "X", "X", "X", "Fe", "O"}));
  EXPECT_EQ(column(file.path(), "radius"), (Words{"2", "2", "2", "2", "2", "1.52"}));
  EXPECT_EQ(substitutes(run_json({"measure", file.path()})["input"]), "Fe 2 (1), X 2 (4)");
  EXPECT_EQ(substitutes(run_json({"measure", file.path(), "--radii", "chem3d"})["input"]), "Fe 2 (1), X 2 (4)");
  EXPECT_NE(
      run_program({"measure", file.path()}).out.find("substitutes      Fe 2 (1 atom), X 2 (4 atoms): not in bondi"),
      std::string::npos);
  // A user's radius is no substitute, and selections know the symbol.
  EXPECT_EQ(column(file.path(), "radius", {"--radius", "X=1.7"}), (Words{"1.7", "1.7", "1.7", "1.7", "2", "1.52"}));
  EXPECT_EQ(substitutes(run_json({"measure", file.path(), "--radius", "X=1.7"})["input"]), "Fe 2 (1)");
  EXPECT_EQ(column(file.path(), "element", {"--hide", "element:X"}), (Words{"Fe", "O"}));
  const TemporaryFile cif("unx.cif",
                          "data_x\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.Cartn_x\n"
                          "_atom_site.Cartn_y\n_atom_site.Cartn_z\nX UNK 0 0 0\nO O 9 0 0\n");
  EXPECT_EQ(column(cif.path(), "radius"), (Words{"2", "1.52"}));
}

// In .xyz, from programs that take internal coordinates, X is a dummy: a point to define an angle by.
TEST(RealFiles, DummiesInXyzAreLeftOut) {
  const TemporaryFile file("dummy.xyz", "3\n\nO 0 0 0\nX 0 0 1\nx2 0 0 2\n");
  EXPECT_EQ(column(file.path(), "element"), Words{"O"});
  const Json input =
      run_json({"measure", file.path()}, "2 dummies or virtual sites are left out: they are no atoms")["input"];
  EXPECT_EQ(input["left_out"]["virtual_sites"].number, 2);
  EXPECT_EQ(substitutes(input), "");
  EXPECT_EQ(column(file.path(), "radius", {"--radius", "X=0.5"}), (Words{"1.52", "0.5", "0.5"}));
}

// More of them than a line has room for.
TEST(RealFiles, ManyUnknownElements) {
  std::string text = "20\n\n";
  for (int i = 0; i < 20; ++i)
    text += std::string("Q") + static_cast<char>('a' + i) + " 0 0 " + std::to_string(9 * i) + "\n";
  const TemporaryFile file("many.xyz", text);
  const Outcome outcome = run_program({"measure", file.path()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("'Qh' (1 atom) and more; give radii"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.substr(outcome.err.size() - 4), ",Qh\n");
}

// Segments stand for chains where there are none; the entry's name and the number of the line do not.
TEST(RealFiles, Segments) {
  const TemporaryFile file("segments.pdb", record("ATOM", " CA", "ALA", " ", 1, 0, "      PROA C") +
                                               record("ATOM", " CA", "ALA", " ", 1, 10, "      PROB C") +
                                               record("ATOM", " CA", "ALA", "X", 1, 20, "      PROB C") +
                                               record("ATOM", " CA", "ALA", " ", 1, 30, "      1ABC  31") +
                                               record("ATOM", " CA", "ALA", " ", 2, 40, "      SEGA"));
  EXPECT_EQ(column(file.path(), "chain"), (Words{"PROA", "PROB", "X", "", "SEGA"}));
  EXPECT_EQ(run_json({"measure", file.path(), "--by", "chain"})["chains"].items.size(), 5u);
}

// Names of records are whole words: files of other formats are not PDB files without atoms.
TEST(RealFiles, OtherFormatsAreNotPdb) {
  for (const char *text : {"@<TRIPOS>MOLECULE\nx\nUSER_CHARGES\n", "TURN_P 1\n", "SITEMAP\n", "HETEROATOM x\n"}) {
    const TemporaryFile file("other.pdb", text);
    EXPECT_EQ(run_program({"measure", file.path()}).err,
              "hardsphere: " + file.path() + ": no PDB record in the file\n");
  }
  for (const char *text :
       {"HETNAM     X\n", "ORIGX1   1 0 0\n", "CRYST1 1 1 1\n", "TER\n", "DBREF1 x\n", "TER   12\n"}) {
    const TemporaryFile file("records.pdb", text);
    EXPECT_EQ(run_program({"measure", file.path()}).err, "hardsphere: " + file.path() + ": no atoms in the file\n");
  }
}

// The columns of PDB2PQR, where numbers touch.
TEST(RealFiles, PqrWhoseColumnsTouch) {
  const TemporaryFile file("touch.pqr",
                           "ATOM      1  N   ALA A1001    -100.000-200.000-300.000  0.1000 1.5500\n"
                           "ATOM      2  CA  ALA A1002A   1000.0002000.0003000.000 -0.1000 1.7000 C\n"
                           "ATOM      3  CB  ALA  1003       0.000   0.000   0.000  0.0000 1.8000\n");
  EXPECT_EQ(column(file.path(), "x"), (Words{"-100", "1000", "0"}));
  EXPECT_EQ(column(file.path(), "z"), (Words{"-300", "3000", "0"}));
  EXPECT_EQ(column(file.path(), "chain"), (Words{"A", "A", ""}));
  EXPECT_EQ(column(file.path(), "number"), (Words{"1001", "1002", "1003"}));
  EXPECT_EQ(column(file.path(), "insertion"), (Words{"", "A", ""}));
  EXPECT_EQ(column(file.path(), "area").size(), 3u);
  for (const char *bad : {"ATOM      1  N   ALA A1001    -100.000-200.000-300.000  0.1000\n",
                          "ATOM      1  N   ALA A1001    -100.000-200.000-30a.000  0.1000 1.5500\n",
                          "ATOM      1  N   ALA A1001    -100.000-200.000-300.000  0.1000-1.5500\n",
                          "ATOM      1  N   ALA A1001        -100    -200-3000000  0.1000 1.5500 C 7\n"}) {
    const TemporaryFile refused("refused.pqr", bad);
    EXPECT_EQ(run_program({"measure", refused.path()}).status, 1) << bad;
  }
}

TEST(RealFiles, PqrWithElementsAndJoinedChains) {
  const TemporaryFile file("parmed.pqr",
                           "ATOM 1 CA CA 1 0 0 0 2 2.3 CA\nATOM 2 N ALA A1001 10 0 0 -0.4 1.55 N\n"
                           "ATOM 3 C1 LIG B12345A 20 0 0 0 1.7\nHETATM4 O HOH 7 30 0 0 0 1.5 O\n"
                           "ATOM 5 C ALA A000 40 0 0 0 1.7\n");
  EXPECT_EQ(column(file.path(), "chain"), (Words{"", "A", "B", "", ""}));
  EXPECT_EQ(column(file.path(), "number"), (Words{"1", "1001", "12345", "7", "A000"}));
  EXPECT_EQ(column(file.path(), "radius").size(), 5u);
  EXPECT_EQ(column(file.path(), "atom", {"--only", "element:Ca,O"}), (Words{"CA", "O"}));
  EXPECT_EQ(column("good/water.pqr", "atom", {"--no-hydrogens"}), (Words{"O"}));
}

TEST(RealFiles, LabelsAndNumbersInXyz) {
  const TemporaryFile file("labels.xyz", "6\n\n8 0 0 0\n26 10 0 0\nC12 20 0 0\nCa2+ 30 0 0\nO-1 40 0 0\n1 50 0 0\n");
  EXPECT_EQ(column(file.path(), "element"), (Words{"O", "Fe", "C", "Ca", "O", "H"}));
  for (const char *bad : {"0", "119", "-1", "Abc", "1.5", "+"}) {
    const TemporaryFile refused("refused.xyz", std::string("1\n\n") + bad + " 0 0 0\n");
    EXPECT_EQ(run_program({"measure", refused.path()}).err, "hardsphere: " + refused.path() + ":3: unknown element '" +
                                                                bad +
                                                                "'; expected a symbol such as C or Cl, or a number\n");
  }
  const TemporaryFile tinker("tinker.xyz", "2\n1 O 0.0 0.0 0.1 63 2\n2 H 0.0 0.0 1.0 64 1\n");
  EXPECT_EQ(run_program({"measure", tinker.path()}).status, 1);
  const TemporaryFile titled("titled.xyz", "1\n\n1 O 0.0 0.0 0.1 63 2\n");
  EXPECT_EQ(run_program({"measure", titled.path()}).err,
            "hardsphere: " + titled.path() + ":3: this looks like Tinker's format, not like XYZ\n");
}

void expect_x(const std::string &title, const std::string &line, const char *x) {
  const TemporaryFile file("extended.xyz", "1\n" + title + "\n" + line + "\n");
  EXPECT_EQ(column(file.path(), "x"), Words{x}) << title;
  EXPECT_EQ(column(file.path(), "element"), Words{"Cl"}) << title;
}

TEST(RealFiles, PropertiesOfExtendedXyz) {
  expect_x("Properties=species:S:1:pos:R:3", "Cl 7 0 0", "7");
  expect_x("Properties=species:S:1:forces:R:3:pos:R:3 pbc=\"T T T\"", "Cl 1 2 3 7 0 0", "7");
  expect_x("Lattice=\"1 0 0 0 1 0 0 0 1\" Properties=\"pos:R:3:species:S:1\"", "7 0 0 Cl", "7");
  expect_x("time=3 Properties=id:I:1:Z:I:1:pos:R:3:mass:R:1", "12 17 7 0 0 35.5", "7");
  expect_x("myProperties=pos:R:3:species:S:1", "Cl 7 0 0", "7");
  expect_x("Properties of something", "Cl 7 0 0", "7");
  const auto refused = [](const std::string &title, const std::string &reason) {
    const TemporaryFile file("refused.xyz", "1\n" + title + "\nCl 7 0 0\n");
    EXPECT_EQ(run_program({"measure", file.path()}).err, "hardsphere: " + file.path() + ":" + reason + "\n") << title;
  };
  refused("Properties=species:S:1:forces:R:3", "2: Properties has no pos:R:3");
  refused("Properties=pos:R:3", "2: Properties has no species:S:1");
  refused("Properties=", "2: Properties has no species:S:1");
  refused("Properties=species:S:one:pos:R:3", "2: Properties is not of the form name:type:count:...");
  refused("Properties=species:S", "2: Properties is not of the form name:type:count:...");
  refused("Properties=species:S:1:pos:R:3:a:R:60:b:R:9", "2: Properties has too many columns");
  refused("Properties=species:S:1:forces:R:3:pos:R:3", "3: expected the columns of Properties, found 4 of 7 columns");
}

}  // namespace
