// Radii by residue and atom: the published sets, files of a user, and what comes before what.
#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Words = std::vector<std::string>;

struct Atom {
  const char *residue;
  const char *name;  // columns 13-16
};

// One atom after the other, each a residue of its own, far apart.
std::string pdb(const std::vector<Atom> &atoms) {
  std::string text;
  for (size_t i = 0; i < atoms.size(); ++i) {
    char line[100];
    std::snprintf(line, sizeof line, "ATOM  %5zu %-4s %-4sA%4zu    %8.3f%8.3f%8.3f\n", i + 1, atoms[i].name,
                  atoms[i].residue, i + 1, 10.0 * static_cast<double>(i), 0.0, 0.0);
    text += line;
  }
  return text;
}

// The radii in the table of balls.
std::vector<double> radii_of(const std::vector<Atom> &atoms, const Words &options) {
  const TemporaryFile file("atoms.pdb", pdb(atoms));
  Words arguments = {"measure", file.path(), "--csv"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  std::vector<double> radii;
  std::istringstream lines(outcome.out);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    const size_t area = line.rfind(',');
    radii.push_back(std::stod(line.substr(line.rfind(',', area - 1) + 1)));
  }
  return radii;
}

struct Published {
  Atom atom;
  double protor;
  double naccess;
};

// One atom of each class at least: bonds and hydrogens in the one set, trigonal or tetrahedral in the other.
TEST(RadiiSets, AsPublished) {
  const std::vector<Published> published = {
      {{"ALA", " N"}, 1.64, 1.65},   {{"ALA", " CA"}, 1.88, 1.87},  {{"GLY", " CA"}, 1.88, 1.87},
      {{"VAL", " C"}, 1.61, 1.76},   {{"VAL", " O"}, 1.42, 1.40},   {{"VAL", " OXT"}, 1.46, 1.40},
      {{"PRO", " N"}, 1.64, 1.65},   {{"ILE", " CB"}, 1.88, 1.87},  {{"LEU", " CG"}, 1.88, 1.87},
      {{"MET", " SD"}, 1.77, 1.85},  {{"CYS", " SG"}, 1.77, 1.85},  {{"PHE", " CG"}, 1.61, 1.76},
      {{"PHE", " CZ"}, 1.76, 1.76},  {{"TYR", " CZ"}, 1.61, 1.76},  {{"TYR", " OH"}, 1.46, 1.40},
      {{"TRP", " CD1"}, 1.76, 1.76}, {{"TRP", " CD2"}, 1.61, 1.76}, {{"TRP", " CE2"}, 1.61, 1.76},
      {{"TRP", " CE3"}, 1.76, 1.76}, {{"TRP", " NE1"}, 1.64, 1.65}, {{"HIS", " CG"}, 1.61, 1.76},
      {{"HIS", " CD2"}, 1.76, 1.76}, {{"HIS", " CE1"}, 1.76, 1.76}, {{"HSD", " ND1"}, 1.64, 1.65},
      {{"LYS", " NZ"}, 1.64, 1.50},  {{"LYS", " CE"}, 1.88, 1.87},  {{"ARG", " CZ"}, 1.61, 1.76},
      {{"ARG", " NH2"}, 1.64, 1.65}, {{"ASN", " CG"}, 1.61, 1.76},  {{"ASN", " OD1"}, 1.42, 1.40},
      {{"ASN", " ND2"}, 1.64, 1.65}, {{"GLN", " CG"}, 1.88, 1.87},  {{"GLN", " CD"}, 1.61, 1.76},
      {{"ASP", " OD2"}, 1.46, 1.40}, {{"GLU", " OE2"}, 1.46, 1.40}, {{"SER", " OG"}, 1.46, 1.40},
      {{"THR", " OG1"}, 1.46, 1.40}, {{"THR", " CG2"}, 1.88, 1.87}, {{"HOH", " O"}, 1.46, 1.52},
      {{"LIG", " O"}, 1.52, 1.52},   {{"DA", " C8"}, 1.76, 1.70},   {{"DT", " C7"}, 1.88, 1.70},
      {{"THY", " C5M"}, 1.88, 1.70}, {{"RU5", " O4"}, 1.42, 1.52},  {{"G", " O1P"}, 1.42, 1.52},
      {{"SOL", " OW"}, 1.46, 1.52},
  };
  std::vector<Atom> atoms;
  std::vector<double> protor, naccess;
  for (const Published &of : published) {
    atoms.push_back(of.atom);
    protor.push_back(of.protor);
    naccess.push_back(of.naccess);
  }
  EXPECT_EQ(radii_of(atoms, {"--radii", "protor"}), protor);
  EXPECT_EQ(radii_of(atoms, {"--radii=naccess"}), naccess);
}

// Every heavy atom of the 20 amino acids: as many as they have, with the oxygen at the end of a chain.
TEST(RadiiSets, AreComplete) {
  const std::vector<std::pair<const char *, int>> heavy_atoms = {
      {"ALA", 5}, {"ARG", 11}, {"ASN", 8}, {"ASP", 8},  {"CYS", 6},  {"GLN", 9}, {"GLU", 9},
      {"GLY", 4}, {"HIS", 10}, {"ILE", 8}, {"LEU", 8},  {"LYS", 9},  {"MET", 8}, {"PHE", 11},
      {"PRO", 7}, {"SER", 6},  {"THR", 7}, {"TRP", 14}, {"TYR", 12}, {"VAL", 7}};
  const std::string list = run_program({"measure", "--radii", "list"}).out;
  for (const char *set : {"\nprotor, in angstrom", "\nnaccess, in angstrom"}) {
    const size_t begin = list.find(set);
    ASSERT_NE(begin, std::string::npos);
    for (const auto &[residue, count] : heavy_atoms) {
      const size_t at = list.find(std::string("\n  ") + residue, begin);
      ASSERT_NE(at, std::string::npos) << residue;
      std::istringstream words(list.substr(at + 6, list.find('\n', at + 1) - at - 6));
      int found = 0;
      for (std::string word; words >> word;) ++found;
      // Each has its radius behind it. OXT has two other names in CHARMM, and so has an atom of ILE.
      EXPECT_EQ(found / 2, count + 3 + (std::string(residue) == "ILE" ? 1 : 0)) << residue;
    }
  }
  for (const char *set : {"protor", "naccess"}) {
    const Json input = run_json({"measure", molecules_folder() + "/crambin.pdb", "--radii", set})["input"];
    EXPECT_EQ(input["radii"].text, set);
    EXPECT_EQ(input["radius_by_element"].number, 0);
  }
}

// The radius of each residue and atom by one of the sets, as the program lists them: "ALA CB".
std::map<std::string, double> listed(const std::string &set) {
  const std::string list = run_program({"--radii", "list"}).out;
  std::istringstream lines(list.substr(list.find("\n" + set + ", in angstrom") + 1));
  std::map<std::string, double> radii;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line) && !line.empty()) {
    std::istringstream words(line);
    std::string residue, atom;
    words >> residue;
    for (double radius = 0; words >> atom >> radius;) radii[residue + ' ' + atom] = radius;
  }
  return radii;
}

// Every atom that FreeSASA's own configuration has, where it is installed; FREESASA_SHARE names another folder.
TEST(RadiiSets, ProtorIsThatOfFreeSasa) {
  const char *folder = std::getenv("FREESASA_SHARE");
  std::ifstream file(std::string(folder != nullptr ? folder : "/usr/share/freesasa") + "/protor.config");
  if (!file) GTEST_SKIP() << "no configuration of FreeSASA is installed";
  const std::map<std::string, double> ours = listed("protor");
  std::map<std::string, double> types;
  std::string section;
  int compared = 0;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string first, second, third;
    if (!(words >> first >> second)) {
      if (!first.empty()) section = first;
    } else if (section == "types:") {
      types[first] = std::stod(second);
    } else if (section == "atoms:" && words >> third) {
      const auto found = ours.find(first + ' ' + second);
      ASSERT_TRUE(types.count(third) == 1) << line;
      ++compared;
      EXPECT_TRUE(found != ours.end() && found->second == types[third]) << line;
    }
  }
  EXPECT_GT(compared, 400);
}

TEST(RadiiSets, ListShowsWhatThereIs) {
  const Outcome list = run_program({"measure", "--radii", "list"});
  EXPECT_EQ(list.status, 0);
  EXPECT_NE(list.out.find("\n  C            1.70      1.52    1.7155\n"), std::string::npos) << list.out;
  EXPECT_NE(list.out.find("\n  Zn           1.39      1.39*   1.2310\n"), std::string::npos);
  EXPECT_NE(list.out.find("\n  Fe           2.00*     2.00*   1.2970\n"), std::string::npos);
  EXPECT_EQ(run_program({"draw", "--radii=list"}).out, list.out);
  EXPECT_EQ(run_program({"--radii", "list"}).out, list.out);
  EXPECT_EQ(run_program({"--radii=list"}).out, list.out);
  EXPECT_EQ(run_program({"--radii", "bondi"}).status, 2);
  EXPECT_EQ(run_program({"--radii=list", "more"}).status, 2);
  EXPECT_EQ(run_program({"query", "good/water.pdb", "--radii=list"}).out, list.out);
}

const std::vector<Atom> few = {{"ALA", " CB"}, {"GLY", " CA"}, {"ALA", " N"}, {"LIG", " C1"}, {"ZN", "ZN"}};

TEST(RadiiFiles, PlainForm) {
  const TemporaryFile file("my.radii", "# mine\nALA CB 1.9\n\nany ca 2.5  # everywhere\n*  N  0.5\nALA N 1.25\n");
  EXPECT_EQ(radii_of(few, {"--radii", file.path()}), (std::vector<double>{1.9, 2.5, 1.25, 1.7, 1.39}));
  // A residue of its own comes before ANY; --radius before both, whatever the residue.
  EXPECT_EQ(radii_of(few, {"--radii", file.path(), "--radius", "C=3,ZN=4"}), (std::vector<double>{3, 3, 1.25, 3, 4}));
}

// No table has a longer name than 7 letters, and a residue's longer name is none of them.
TEST(RadiiFiles, LongNamesOfResidues) {
  const TemporaryFile file("my.radii", "LIGANDX C1 1.9\nANY C2 2.5\n");
  const TemporaryFile cif("long.cif",
                          "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
                          "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\nC C1 LIGANDX 0 0 0\n"
                          "C C1 LIGANDXYZ 9 0 0\nC C2 LIGANDXYZ 19 0 0\nC C1 LIGANDXY 29 0 0\n");
  std::vector<double> radii;
  for (const Json &ball : run_json({"measure", cif.path(), "--radii", file.path(), "--per-ball"})["balls"].items)
    radii.push_back(ball["radius"].number);
  EXPECT_EQ(radii, (std::vector<double>{1.9, 1.7, 2.5, 1.7}));
}

TEST(RadiiFiles, FreeSasaForm) {
  const TemporaryFile file("my.config",
                           "# comment\nname: Mine or another's\n\ntypes:\nC_ALI 2.00 apolar # class\nN 1.55\n\natoms:\n"
                           "ANY CA C_ALI\nALA CB C_LATE\nALA N n\n\ntypes:\nC_LATE 1.5 polar\n");
  EXPECT_EQ(radii_of(few, {"--radii", file.path()}), (std::vector<double>{1.5, 2, 1.55, 1.7, 1.39}));
}

// A residue of the plain form may be called so; nucleotides are filled up, and names of a haem were once broken in two.
TEST(RadiiFiles, NaccessForm) {
  const TemporaryFile file("vdw.radii",
                           "# comment\nRESIDUE ATOM ALA  5\nATOM  N   1.25 1\nATOM  CB  1.9 0 \nRESIDUE ATOM GLY\n"
                           "ATOM  CA  2.5\nRESIDUE NUCL __A  21\nATOM  P   1.75 0\nRESIDUE HETATM HEM 43\n"
                           "ATOM FE   1.47 0\nATOM  N A 1.5 1\nATOM  N B 1.625\nRESIDUE WATER HOH 1\nATOM  O 1.1 1\n");
  EXPECT_EQ(radii_of(few, {"--radii", file.path()}), (std::vector<double>{1.9, 2.5, 1.25, 1.7, 1.39}));
  const std::vector<Atom> others = {{"A", " P"}, {"HEM", "FE"}, {"HEM", " NA"}, {"HEM", " NB"}, {"HOH", " O"}};
  EXPECT_EQ(radii_of(others, {"--radii", file.path()}), (std::vector<double>{1.75, 1.47, 1.5, 1.625, 1.1}));
  // Heavy atoms stand for hydrogens there.
  EXPECT_EQ(radii_of({{"ALA", " N"}, {"ALA", " H"}}, {"--radii", file.path()}), (std::vector<double>{1.25}));
  const TemporaryFile plain("plain.radii", "RESIDUE CB 1.9\nATOM CA 2\n");
  EXPECT_EQ(radii_of(few, {"--radii", plain.path()}), radii_of(few, {}));
}

TEST(RadiiFiles, AreNamedInTheResults) {
  const TemporaryFile file("named.radii", "ALA CB 1.9\n");
  const TemporaryFile atoms("named.pdb", pdb(few));
  const Json input = run_json({"measure", atoms.path(), "--radii", file.path()})["input"];
  EXPECT_EQ(input["radii"].text, file.path());
  EXPECT_EQ(input["radius_by_element"].number, 4);
  const std::string table = run_program({"measure", atoms.path(), "--radii", file.path()}).out;
  EXPECT_NE(table.find("  radii            " + file.path() + " (a file)\n  by element       4 atoms"),
            std::string::npos)
      << table;
}

// In residues that the table names heavy atoms stand for their hydrogens, unless it has radii for hydrogens or the user
// gives one.
TEST(RadiiSets, Hydrogens) {
  const std::vector<Atom> atoms = {{"ALA", " CA"}, {"ALA", " HA"}, {"ALA", "1HB"}};
  EXPECT_EQ(radii_of(atoms, {"--radii", "protor"}), (std::vector<double>{1.88}));
  EXPECT_EQ(radii_of(atoms, {"--radii", "protor", "--radius", "H=1"}), (std::vector<double>{1.88, 1, 1}));
  const TemporaryFile with("with.radii", "ALA CA 1.5\nALA HA 0.5\n");
  EXPECT_EQ(radii_of(atoms, {"--radii", with.path()}), (std::vector<double>{1.5, 0.5, 1.1}));
  const TemporaryFile file("hydrogens.pdb", pdb(atoms));
  EXPECT_EQ(run_json({"measure", file.path(), "--radii=naccess"})["input"]["left_out"]["hydrogens_of_set"].number, 2);
  EXPECT_EQ(radii_of({{"LIG", " C1"}, {"LIG", " H1"}}, {"--radii", "protor"}), (std::vector<double>{1.7, 1.1}));
  const TemporaryFile any("any.radii", "ANY CA 1.5\n");
  EXPECT_EQ(radii_of(atoms, {"--radii", any.path()}), (std::vector<double>{1.5, 1.1, 1.1}));
  const TemporaryFile alone("alone.pdb", pdb({{"ALA", " HA"}}));
  EXPECT_EQ(run_program({"measure", alone.path(), "--radii=naccess"}).err,
            "hardsphere: " + alone.path() +
                ": no atoms are left: the only one is a hydrogen, which its heavy atom stands for\n");
}

void expect_refusal(const std::string &text, const std::string &reason) {
  const TemporaryFile file("refused.radii", text);
  const Outcome outcome = run_program({"measure", "good/water.pdb", "--radii", file.path()});
  EXPECT_EQ(outcome.status, 1) << text;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "hardsphere: " + file.path() + ":" + reason + "\n");
}

TEST(RadiiFiles, ThatAreRefused) {
  expect_refusal("", " no radii in the file");
  expect_refusal("# nothing\n\n", " no radii in the file");
  expect_refusal("ALA CB\n", "1: expected a residue, an atom and its radius");
  expect_refusal("ALA CB 1.9 2\n", "1: expected a residue, an atom and its radius");
  expect_refusal("ALA CB 1,9\n", "1: radius: '1,9' is not a decimal number");
  expect_refusal("\nALA CB -1\n", "2: radius: '-1' is negative");
  expect_refusal("ALA CB 1\nGLY CA 2\nala cb 1.5\n", "3: ALA CB has another radius above");
  expect_refusal("ALANINES CB 1\n", "1: a name of more than 7 characters");
  expect_refusal("types:\nC 1 2 3\n", "2: expected a type and its radius");
  expect_refusal("types:\nC nan\n", "2: radius: 'nan' is not finite");
  expect_refusal("atoms:\nALA CB\n", "2: expected a residue, an atom and its type");
  expect_refusal("types:\nC 1\natoms:\nALA CB D\n", "4: there is no type 'D'");
  const std::string naccess = "RESIDUE ATOM ALA 5\n";
  expect_refusal(naccess, " no radii in the file");
  expect_refusal(naccess + "ALA CB 1\n", "2: expected ATOM or RESIDUE");
  expect_refusal(naccess + "types:\n", "2: expected ATOM or RESIDUE");
  for (const char *line : {"ATOM", "ATOM CB", "ATOM N A", "ATOM CB 1 0 0", "ATOM CBCBCBCB 1"}) {
    expect_refusal(naccess + line + "\n", "2: expected ATOM, an atom and its radius");
  }
  expect_refusal(naccess + "ATOM N A B 1\n", "2: radius: 'B' is not a decimal number");
  expect_refusal(naccess + "ATOM CB -1 0\n", "2: radius: '-1' is negative");
  expect_refusal(naccess + "ATOM CB 1.0 0\nATOM CB 1.5 0\n", "3: ALA CB has another radius above");
  expect_refusal("RESIDUE ATOM ALANINES 5\n", "1: a name of more than 7 characters");
  expect_refusal("radii:\n", "1: expected name:, types: or atoms:");
  expect_refusal("types: C 1\n", "1: expected name:, types: or atoms:");
  EXPECT_EQ(run_program({"measure", "good/water.pdb", "--radii", "none/at.all"}).err,
            "hardsphere: none/at.all: No such file or directory\n");
}

// The same atom twice with one radius is no contradiction.
TEST(RadiiFiles, MayRepeatThemselves) {
  const TemporaryFile file("twice.radii", "ALA CB 1.9\nALA CB 1.90\n");
  EXPECT_EQ(radii_of({{"ALA", " CB"}}, {"--radii", file.path()}), (std::vector<double>{1.9}));
}

TEST(RadiiFiles, AreNotWrittenOver) {
  const TemporaryFile file("mine.pdb", "HOH O 1.9\n");
  EXPECT_EQ(run_program({"measure", "good/water.pdb", "--radii", file.path(), "--pdb-out", file.path()}).err,
            "hardsphere: --pdb-out would write over the file that is read\n");
  EXPECT_EQ(read_file(file.path()), "HOH O 1.9\n");
}

TEST(IndexFiles, AreNotWrittenOver) {
  const TemporaryFile file("mine.cif", "[ all ]\n1 2 3\n");
  EXPECT_EQ(
      run_program({"pores", "good/water.pdb", "--index", file.path(), "--only", "group:all", "--points", file.path()})
          .err,
      "hardsphere: --points would write over the file that is read\n");
  EXPECT_EQ(read_file(file.path()), "[ all ]\n1 2 3\n");
}

}  // namespace
