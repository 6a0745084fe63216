// Files that state more than one molecule, and the choice among these: locations, names of chains, assemblies, models.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

constexpr double carbon = 4 * std::numbers::pi * 1.70 * 1.70;

// A record of columns; `site` is columns 17 to 27: location, residue, chain, number, insertion code.
std::string atom(const char *name, const char *site, double x, double y, double z, double occupancy = 1.0,
                 const char *element = "C") {
  char line[96];
  std::snprintf(line, sizeof line, "ATOM      1 %-4s%-11s   %8.3f%8.3f%8.3f%6.2f%6.2f          %2s\n", name, site, x, y,
                z, occupancy, 0.0, element);
  return line;
}

std::string biomt(int number, const std::vector<double> &rows) {
  std::string text;
  for (size_t row = 0; row < 3; ++row) {
    char line[96];
    std::snprintf(line, sizeof line, "REMARK 350   BIOMT%zu %3d%10.6f%10.6f%10.6f     %10.5f\n", row + 1, number,
                  rows[4 * row], rows[4 * row + 1], rows[4 * row + 2], rows[4 * row + 3]);
    text += line;
  }
  return text;
}

const std::vector<double> unmoved = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
// A third of a turn about x = y = z, then a step along z.
const std::vector<double> turned = {0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 20};

// x, y and z of the balls, in their order.
std::vector<double> places(const Json &json) {
  std::vector<double> all;
  for (const Json &ball : json["balls"].items) {
    for (const Json &number : ball["xyz"].items) all.push_back(number.number);
  }
  return all;
}

std::vector<std::string> texts(const Json &list, const std::string &key) {
  std::vector<std::string> all;
  for (const Json &item : list.items) all.push_back(item[key].text);
  return all;
}

using Texts = std::vector<std::string>;

std::vector<double> xs(const Json &json) {
  const std::vector<double> all = places(json);
  std::vector<double> x;
  for (size_t k = 0; k < all.size(); k += 3) x.push_back(all[k]);
  return x;
}

const std::string mmcif_tags =
    "loop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_alt_id\n"
    "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n"
    "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.occupancy\n"
    "_atom_site.pdbx_PDB_model_num\n";

// ---- locations ----

// Residue 1 has B more often; atom CG of it has A and C alone. Residue 2 is a mixture, with as much of either name.
// Residue 3 has a location without a number for its occupancy.
struct Location {
  const char *name, *location, *residue, *number;
  double x;
  const char *occupancy;
};
const std::vector<Location> locations = {
    {"CA", "A", "SER", "1", 0, "0.40"},
    {"CA", "B", "SER", "1", 6, "0.60"},
    {"CB", "A", "SER", "1", 12, "0.40"},
    {"CB", "B", "SER", "1", 18, "0.60"},
    {"CG", "A", "SER", "1", 24, "0.20"},
    {"CG", "C", "SER", "1", 30, "0.35"},
    {"CA", "B", "THR", "2", 36, "0.50"},
    {"CB", "B", "THR", "2", 42, "0.50"},
    {"CA", "A", "ASN", "2", 48, "0.50"},
    {"CA", "A", "GLY", "3", 54, "0.90"},
    {"CA", "B", "GLY", "3", 60, ""},
    {"CA", "", "GLY", "4", 66, "0.10"},
    // One location without a letter: of this atom, but not of the others of its residue.
    {"N", "", "GLY", "5", 72, "1.00"},
    {"CA", "", "GLY", "5", 78, "0.40"},
    {"C", "", "GLY", "5", 84, "1.00"},
    {"CA", "B", "GLY", "5", 90, "0.60"},
    {"C", "", "GLY", "6", 96, "1.00"}};

std::string as_pdb(const std::vector<Location> &all) {
  std::string text;
  for (const Location &one : all) {
    char line[96];
    std::snprintf(line, sizeof line, "ATOM      1  %-3s%1s%3s A%4s    %8.3f%8.3f%8.3f%6s%6.2f           C\n", one.name,
                  one.location, one.residue, one.number, one.x, 0.0, 0.0, one.occupancy, 0.0);
    text += line;
  }
  return text;
}

std::string as_cif(const std::vector<Location> &all) {
  std::string text = "data_a\n" + mmcif_tags;
  for (const Location &one : all) {
    const auto said = [](const char *value) { return std::string(value[0] == '\0' ? "?" : value); };
    text += std::string("ATOM C ") + one.name + " " + said(one.location) + " " + one.residue + " A A " + one.number +
            " " + std::to_string(one.x) + " 0 0 " + said(one.occupancy) + " 1\n";
  }
  return text;
}

TEST(Locations, FirstByOccupancyOrByLetter) {
  using X = std::vector<double>;
  const TemporaryFile pdb("locations.pdb", as_pdb(locations)), cif("locations.cif", as_cif(locations));
  for (const std::string &file : {pdb.path(), cif.path()}) {
    SCOPED_TRACE(file);
    const auto read = [&](const char *which) {
      return xs(run_json({"measure", file, "--per-ball", "--altloc", which}));
    };
    const X first = {0, 12, 24, 36, 42, 54, 66, 72, 78, 84, 96};
    EXPECT_EQ(xs(run_json({"measure", file, "--per-ball"})), first);
    EXPECT_EQ(read("first"), first);
    EXPECT_EQ(read("occupancy"), X({6, 18, 30, 36, 42, 60, 66, 72, 84, 90, 96}));
    EXPECT_EQ(read("A"), X({0, 12, 24, 48, 54, 66, 72, 78, 84, 96}));
    EXPECT_EQ(read("B"), X({6, 18, 24, 36, 42, 60, 66, 72, 84, 90, 96}));
    EXPECT_EQ(read("C"), X({0, 12, 30, 36, 42, 54, 66, 72, 78, 84, 96}));
    const Json json = run_json({"measure", file, "--altloc", "B"});
    EXPECT_EQ(json["input"]["left_out"]["alternate_locations"].number, 6);
    const Outcome none = run_program({"measure", file, "--altloc", "Z", "--csv"});
    EXPECT_EQ(none.status, 0);
    EXPECT_NE(none.err.find("nothing matches --altloc Z\n"), std::string::npos) << none.err;
  }
}

// Frames of a trajectory have the choice, too.
TEST(Locations, OfFrames) {
  const TemporaryFile pdb("locations.pdb", as_pdb(locations));
  for (const char *which : {"first", "A", "B", "C", "occupancy"}) {
    const auto areas = [&](const std::vector<std::string> &more) {
      std::vector<std::string> arguments = {"measure", pdb.path(), "--altloc", which, "--per-ball", "--json"};
      arguments.insert(arguments.end(), more.begin(), more.end());
      return xs(run_json(arguments));
    };
    EXPECT_EQ(areas({"--trajectory", pdb.path()}), areas({})) << which;
  }
}

// Groups of disordered atoms are locations, each assembly for itself; a letter is the name of a group.
TEST(Locations, GroupsOfCrystals) {
  const TemporaryFile file(
      "groups.cif",
      "data_a\n_cell_length_a 100\n_cell_length_b 100\n_cell_length_c 100\n_cell_angle_alpha 90\n"
      "_cell_angle_beta 90\n_cell_angle_gamma 90\nloop_\n_atom_site_label\n_atom_site_type_symbol\n"
      "_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n_atom_site_occupancy\n"
      "_atom_site_disorder_assembly\n_atom_site_disorder_group\n"
      "C1 C 0.1 0 0 1 . .\nC2A C 0.2 0 0 0.4(1) A 1\nC2B C 0.3 0 0 0.6(1) A 2\n"
      "C3A C 0.4 0 0 0.7 B 1\nC3B C 0.5 0 0 0.3 B 2\nC4B C 0.6 0 0 0.6 A 2\n");
  const auto read = [&](const char *which, const std::string &below_one) {
    std::vector<double> x = xs(run_json({"measure", file.path(), "--per-ball", "--altloc", which},
                                        below_one + " atoms of an occupancy below 1 count whole, as if always there"));
    for (double &it : x) it = std::round(it);
    return x;
  };
  EXPECT_EQ(read("first", "2"), std::vector<double>({10, 20, 40}));
  EXPECT_EQ(read("occupancy", "3"), std::vector<double>({10, 30, 40, 60}));
  EXPECT_EQ(read("2", "3"), std::vector<double>({10, 30, 50, 60}));
}

// ---- names of chains ----

TEST(Chains, ByAuthorsOrByLabels) {
  const TemporaryFile file("chains.cif", "data_a\n" + mmcif_tags +
                                             "ATOM C CA . GLY A X 1 0 0 0 1 1\nATOM C CA . GLY B Y 1 9 0 0 1 1\n"
                                             "HETATM C C1 . LIG C X 9 18 0 0 1 1\nATOM C CA . GLY ? Z 1 27 0 0 1 1\n");
  const auto chains = [&](const std::vector<std::string> &more) {
    std::vector<std::string> arguments = {"measure", file.path(), "--by", "chain"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return texts(run_json(arguments)["chains"], "chain");
  };
  EXPECT_EQ(chains({}), Texts({"X", "Y", "Z"}));
  EXPECT_EQ(chains({"--chains", "auth"}), Texts({"X", "Y", "Z"}));
  EXPECT_EQ(chains({"--chains", "label"}), Texts({"A", "B", "C", "Z"}));
  EXPECT_EQ(chains({"--chains", "label", "--only", "chain:C"}), Texts({"C"}));
}

// ---- assemblies ----

const std::string two_chains = atom(" CA", " GLY A   1", 1, 2, 3) + atom(" CB", " GLY A   1", 1, 2, 9) +
                               atom(" CA", " GLY B   1", 7, 2, 3) + atom(" ZN", " ZN  A 101", 9, 9, 9, 1, "ZN");

TEST(Assemblies, OfRemark350) {
  const std::string remarks =
      "REMARK 350 BIOMOLECULE: 1\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: A,\n"
      "REMARK 350                    AND CHAINS: B\n" +
      biomt(1, unmoved) + biomt(2, turned) +
      "REMARK 350 BIOMOLECULE: 2\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: B\n" + biomt(1, turned) +
      "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A, B\n" + biomt(1, unmoved);
  const TemporaryFile file("two.pdb", remarks + two_chains);
  const Json one = run_json({"measure", file.path(), "--per-ball", "--by", "chain", "--assembly", "1"});
  EXPECT_EQ(places(one), std::vector<double>({1, 2, 3,  1, 2, 9,  7, 2, 3,  9, 9, 9,  //
                                              3, 1, 22, 9, 1, 22, 3, 7, 22, 9, 9, 29}));
  EXPECT_EQ(texts(one["chains"], "chain"), Texts({"A", "B", "A-2", "B-2"}));
  EXPECT_EQ(one["input"]["assembly"].text, "1");
  EXPECT_EQ(one["input"]["assembly_operators"].number, 2);
  // Chains that come several times, in parts with operators of their own.
  const Json two = run_json({"measure", file.path(), "--per-ball", "--by", "chain", "--assembly", "2"});
  EXPECT_EQ(places(two), std::vector<double>({3, 7, 22, 1, 2, 3, 1, 2, 9, 7, 2, 3, 9, 9, 9}));
  EXPECT_EQ(texts(two["chains"], "chain"), Texts({"B", "A", "B-2"}));
  // Selections take copies of a chain by their names; groups of an index file have all copies of their atoms.
  EXPECT_EQ(places(run_json({"measure", file.path(), "--per-ball", "--assembly", "1", "--only", "chain:B-2"})),
            std::vector<double>({3, 7, 22}));
  const Outcome table = run_program({"measure", file.path(), "--assembly", "1", "--interface", "A,A-2"});
  EXPECT_EQ(table.status, 0) << table.err;
  EXPECT_NE(table.out.find("  assembly         1, by 2 operators\n"), std::string::npos) << table.out;
  const TemporaryFile index("two.ndx", "[ second ]\n2\n");
  EXPECT_EQ(
      run_json({"measure", file.path(), "--index", index.path(), "--only", "group:second", "--assembly", "1"})["n"]
          .number,
      2);
}

// Operators for further chains do not go to the chains before, and a line that announces some in other words is no line
// to step over.
TEST(Assemblies, OperatorsForFurtherChains) {
  const std::string first =
      "REMARK 350 BIOMOLECULE: 1\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n" + biomt(1, unmoved);
  const auto read = [&](const std::string &line) {
    return TemporaryFile("further.pdb", first + "REMARK 350 " + line + "\n" + biomt(1, turned) + two_chains);
  };
  const std::vector<double> parts = {1, 2, 3, 1, 2, 9, 9, 9, 9, 3, 7, 22};
  for (const char *line : {"APPLY THE FOLLOWING TO CHAINS: B", "IN ADDITION APPLY THE FOLLOWING TO CHAINS: B"}) {
    const TemporaryFile file = read(line);
    const Json json = run_json({"measure", file.path(), "--per-ball", "--by", "chain", "--assembly", "1"});
    EXPECT_EQ(texts(json["chains"], "chain"), Texts({"A", "B"})) << line;
    EXPECT_EQ(places(json), parts) << line;
  }
  for (const char *line : {"THEN APPLY THE FOLLOWING TO CHAINS: B", "AND APPLY THE FOLLOWING TO CHAINS: B",
                           "APPLY THE FOLLOWING TO CHAINS B", "IN ADDITION APPLY THE FOLLOWING TO CHAINS"}) {
    const TemporaryFile file = read(line);
    const Outcome outcome = run_program({"measure", file.path(), "--assembly", "1"});
    EXPECT_EQ(outcome.status, 1) << line;
    EXPECT_EQ(outcome.err, "hardsphere: " + file.path() + ": the operators of the file's assemblies cannot be read\n");
  }
}

// A list of chains goes on in the next line, with and without words.
TEST(Assemblies, ChainsOnTheNextLine) {
  const auto read = [](const std::string &lines) {
    const TemporaryFile file("chains.pdb", "REMARK 350 BIOMOLECULE: 1\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: B\n" +
                                               biomt(1, unmoved) + lines + biomt(1, turned) + two_chains);
    const Outcome outcome = run_program({"measure", file.path(), "--per-ball", "--assembly", "1", "--json"});
    return outcome.status == 0 ? places(*read_json(outcome.out)) : std::vector<double>();
  };
  const std::vector<double> both = read("REMARK 350 APPLY THE FOLLOWING TO CHAINS: A, B\n");
  EXPECT_EQ(both, std::vector<double>({7, 2, 3, 3, 1, 22, 9, 1, 22, 3, 7, 22, 9, 9, 29}));
  for (const char *lines :
       {"REMARK 350 APPLY THE FOLLOWING TO CHAINS: A,\nREMARK 350                    B   \n",
        "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A\nREMARK 350 B\n",
        "REMARK 350 APPLY THE FOLLOWING TO CHAINS:\nREMARK 350 A, B\n",
        "REMARK 350 APPLY THE FOLLOWING TO CHAINS\nREMARK 350 A, B\n",
        "REMARK 350 APPLY THE FOLLOWING TO\nREMARK 350 CHAINS: A, B\n",
        "REMARK 350 IN ADDITION APPLY THE FOLLOWING TO\nREMARK 350 CHAINS: A,\nREMARK 350 AND CHAINS: B\n",
        "REMARK 350 IN ADDITION APPLY THE FOLLOWING\nREMARK 350 TO CHAINS: A,\nREMARK 350 B\n"}) {
    EXPECT_EQ(read(lines), both) << lines;
  }
  for (const char *lines :
       {"REMARK 350 APPLY THE FOLLOWING TO\n", "REMARK 350 APPLY THE FOLLOWING TO CHAINS: A,\nREMARK 350 AND OTHERS\n",
        "REMARK 350 APPLY THE FOLLOWING TO\nREMARK 350 ALL OF THEM\n"}) {
    EXPECT_EQ(read(lines), std::vector<double>()) << lines;
  }
}

// The lists of mmCIF: groups in parentheses are applied from right to left, and chains go by label_asym_id.
TEST(Assemblies, OfMmcif) {
  const auto operators = [](const std::string &rows) {
    std::string text = "loop_\n_pdbx_struct_oper_list.id\n";
    for (const char *row : {"1", "2", "3"}) {
      for (const char *column : {"1", "2", "3"}) {
        text += std::string("_pdbx_struct_oper_list.matrix[") + row + "][" + column + "]\n";
      }
      text += std::string("_pdbx_struct_oper_list.vector[") + row + "]\n";
    }
    return text + rows;
  };
  const std::string rows =
      "1 1 0 0 0 0 1 0 0 0 0 1 0\n2 0 0 1 0 1 0 0 0 0 1 0 20\nP 1 0 0 100 0 1 0 0 0 0 1 0\n"
      "3 1 0 0 0 0 1 0 200 0 0 1 0\n";
  const std::string lists =
      "loop_\n_pdbx_struct_assembly_gen.assembly_id\n_pdbx_struct_assembly_gen.oper_expression\n"
      "_pdbx_struct_assembly_gen.asym_id_list\n1 1-2 A,C\n2 (1,3)(P,2) B\n3 (1-3)\n;A,\nB\n;\nPAU P 'A, B'\n";
  const std::string atoms = mmcif_tags +
                            "ATOM C CA . GLY A X 1 1 2 3 1 1\nATOM C CA . GLY B X 1 4 5 6 1 1\n"
                            "HETATM C C1 . LIG C X 9 7 8 9 1 1\n";
  for (const std::string &text : {lists + operators(rows) + atoms, atoms + operators(rows) + lists}) {
    const TemporaryFile file("lists.cif", "data_a\n" + text);
    const auto read = [&](const char *assembly) {
      return run_json({"measure", file.path(), "--per-ball", "--by", "chain", "--assembly", assembly});
    };
    const Json one = read("1");
    EXPECT_EQ(places(one), std::vector<double>({1, 2, 3, 7, 8, 9, 3, 1, 22, 9, 7, 28}));
    EXPECT_EQ(texts(one["chains"], "chain"), Texts({"X", "X-2"}));
    EXPECT_EQ(one["input"]["left_out"]["others"].number, 1);
    EXPECT_EQ(places(read("2")), std::vector<double>({104, 5, 6, 6, 4, 25, 104, 205, 6, 6, 204, 25}));
    EXPECT_EQ(read("3")["n"].number, 6);
    EXPECT_EQ(xs(read("PAU")), std::vector<double>({101, 104}));
  }
  // Single items in place of loops.
  std::string single =
      "data_a\n_pdbx_struct_assembly_gen.assembly_id 1\n_pdbx_struct_assembly_gen.oper_expression P\n"
      "_pdbx_struct_assembly_gen.asym_id_list A,B,C\n_pdbx_struct_oper_list.id P\n";
  for (int row = 1; row <= 3; ++row) {
    for (int column = 1; column <= 3; ++column) {
      single += "_pdbx_struct_oper_list.matrix[" + std::to_string(row) + "][" + std::to_string(column) + "] " +
                (row == column ? "1" : "0") + "\n";
    }
    single += "_pdbx_struct_oper_list.vector[" + std::to_string(row) + "] 50\n";
  }
  const TemporaryFile file("single.cif", single + atoms);
  EXPECT_EQ(xs(run_json({"measure", file.path(), "--per-ball", "--assembly", "1"})), std::vector<double>({51, 54, 57}));
}

// One line says that there are others than the atoms as they stand; nothing is said where there are none.
TEST(Assemblies, AreNotedWhereTheyDiffer) {
  struct Told {
    std::string remarks, note;
  };
  const auto biomolecule = [](const std::string &name, const std::string &chains, const std::string &operators) {
    return "REMARK 350 BIOMOLECULE: " + name + "\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: " + chains + "\n" +
           operators;
  };
  const std::string plain = biomt(1, unmoved);
  const std::vector<Told> cases = {
      {"", ""},
      {biomolecule("1", "A, B", plain), ""},
      {biomolecule("1", "B, A, C", plain), ""},
      {biomolecule("1", "A", plain) + "REMARK 350 APPLY THE FOLLOWING TO CHAINS: B\n" + plain, ""},
      {biomolecule("1", "A, B", plain) + "REMARK 350 APPLY THE FOLLOWING TO CHAINS: B\n" + plain,
       "assembly 1 of the file is not what is read; --assembly 1 makes it\n"},
      {biomolecule("1", "A", plain), "assembly 1 of the file is not what is read; --assembly 1 makes it\n"},
      {biomolecule("1", "A", plain) + biomolecule("2", "B", plain),
       "assemblies 1, 2 of the file are not what is read; --assembly N makes one\n"},
      {biomolecule("1", "A, B", plain) + biomolecule("2", "A, B", plain + biomt(2, turned)),
       "assembly 2 of the file is not what is read; --assembly 2 makes it\n"},
      {biomolecule("1", "A, B", biomt(1, turned)),
       "assembly 1 of the file is not what is read; --assembly 1 makes it\n"},
      {biomolecule("1", "A, B", "REMARK 350   BIOMT1   1  1.0 0.0 0.0 x\n"),
       "assembly 1 of the file is not what is read; --assembly 1 makes it\n"}};
  for (const Told &told : cases) {
    SCOPED_TRACE(told.remarks);
    const TemporaryFile file("told.pdb", told.remarks + two_chains);
    for (const char *form : {"--json", "--csv"}) {
      const Outcome outcome = run_program({"measure", file.path(), form});
      EXPECT_EQ(outcome.status, 0);
      EXPECT_EQ(outcome.err, told.note.empty() ? "" : "hardsphere: " + file.path() + ": " + told.note);
    }
  }
}

// ---- all models ----

// Every format, and residues of one name on both sides of the border between two models.
TEST(Models, AllAsOne) {
  struct Models {
    std::string name, text;
    Texts chains;
  };
  const std::string one = atom(" CA", " GLY A   1", 0, 0, 0), two = atom(" CA", " GLY A   1", 9, 0, 0);
  const std::string third = atom(" CA", " GLY A   1", 18, 0, 0);
  const std::string mol2_head = "@<TRIPOS>MOLECULE\nm\n1 0\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n";
  const std::string sdf_end = "\nM  END\n$$$$\n";
  const std::string sdf_head = "m\n\n\n  1  0  0  0  0  0  0  0  0  0999 V2000\n";
  const std::vector<Models> cases = {
      {"m.pdb1",
       "MODEL        1\n" + one + "ENDMDL\nMODEL        2\n" + two + "ENDMDL\nMODEL 3\n" + third + "ENDMDL\n",
       {"A", "A-2", "A-3"}},
      {"m.pdb", one + "END\n" + two + "END\n" + third, {"A", "A-2", "A-3"}},
      {"m.cif",
       "data_a\n" + mmcif_tags +
           "ATOM C CA . GLY A A 1 0 0 0 1 1\nATOM C CA . GLY A A 1 9 0 0 1 2\n"
           "ATOM C CA . GLY A A 1 18 0 0 1 7\n",
       {"A", "A-2", "A-3"}},
      {"m.pqr",
       "MODEL 1\nATOM 1 CA GLY A 1 0 0 0 0 1.7\nENDMDL\nMODEL 2\nATOM 1 CA GLY A 1 9 0 0 0 1.7\nENDMDL\n"
       "MODEL 3\nATOM 1 CA GLY A 1 18 0 0 0 1.7\nENDMDL\n",
       {"A", "A-2", "A-3"}},
      {"m.gro",
       "t\n1\n    1GLY     CA    1   0.000   0.000   0.000\n 9 9 9\nt\n1\n"
       "    1GLY     CA    1   0.900   0.000   0.000\n 9 9 9\nt\n1\n"
       "    1GLY     CA    1   1.800   0.000   0.000\n 9 9 9\n",
       {"", "-2", "-3"}},
      {"m.mol2",
       mol2_head + "1 CA 0 0 0 C.3 1 GLY1\n" + mol2_head + "1 CA 9 0 0 C.3 1 GLY1\n" + mol2_head +
           "1 CA 18 0 0 C.3 1 GLY1\n",
       {"", "-2", "-3"}},
      {"m.xyz", "1\n\nC 0 0 0\n1\n\nC 9 0 0\n1\n\nC 18 0 0\n", {}},
      {"m.sdf",
       sdf_head + "    0.0000    0.0000    0.0000 C   0  0" + sdf_end + sdf_head +
           "    9.0000    0.0000    0.0000 C   0  0" + sdf_end + sdf_head + "   18.0000    0.0000    0.0000 C   0  0" +
           sdf_end,
       {}}};
  for (const Models &models : cases) {
    SCOPED_TRACE(models.name);
    const TemporaryFile file(models.name, models.text);
    const Json json = run_json({"measure", file.path(), "--per-ball", "--models", "merged"});
    EXPECT_EQ(xs(json), std::vector<double>({0, 9, 18}));
    EXPECT_EQ(json["input"]["model"].kind, Json::Kind::null);
    EXPECT_EQ(json["input"]["models"].number, 3);
    EXPECT_EQ(json["input"]["left_out"]["other_models"].number, 0);
    EXPECT_NEAR(json["area"].number, 3 * carbon, 1e-12 * carbon);
    if (models.chains.empty()) continue;
    EXPECT_EQ(texts(run_json({"measure", file.path(), "--by", "chain", "--models", "merged"})["chains"], "chain"),
              models.chains);
    EXPECT_EQ(run_json({"measure", file.path(), "--by", "residue", "--models", "merged"})["residues"].items.size(), 3u);
  }
}

// Two copies, 3 A apart, with a probe: two spheres of 3.1 A that meet.
TEST(Models, CopiesOfAnAssembly) {
  const TemporaryFile file("assembly.pdb1", "MODEL 1\n" + atom(" CA", " GLY A   1", 0, 0, 0) + "ENDMDL\nMODEL 2\n" +
                                                atom(" CA", " GLY A   1", 3, 0, 0) + "ENDMDL\n");
  const double r = 3.1, both = 2 * (4 * std::numbers::pi * r * r - 2 * std::numbers::pi * r * (r - 1.5));
  EXPECT_NEAR(run_json({"measure", file.path(), "--probe", "1.4", "--models", "merged"})["area"].number, both, 1e-9);
}

// A model of mmCIF is its number, whatever stands between its rows.
TEST(Models, MixedInMmcif) {
  std::string text = "data_a\n" + mmcif_tags;
  for (int i = 0; i < 60; ++i) {
    text += "ATOM C CA . GLY A A " + std::to_string(i) + " " + std::to_string(9 * i) + " 0 0 1 " +
            std::to_string(i * 7 % 4 == 0 ? 30 : i * 7 % 4) + "\n";
  }
  const TemporaryFile file("mixed.cif", text);
  const std::vector<std::vector<int>> first = {{0}, {3}, {2}, {1}};  // of models 30, 3, 2, 1 in their order
  for (size_t model = 0; model < 4; ++model) {
    const Json json = run_json({"measure", file.path(), "--per-ball", "--model", std::to_string(model + 1)});
    ASSERT_EQ(json["n"].number, 15);
    EXPECT_EQ(json["input"]["models"].number, 4);
    EXPECT_EQ(json["input"]["left_out"]["other_models"].number, 45);
    EXPECT_EQ(xs(json)[1] - xs(json)[0], 36);
    EXPECT_EQ(xs(json)[0], 9.0 * static_cast<double>(model));
  }
}

// ---- what is refused ----

TEST(Choices, AreRefusedBySentences) {
  const std::string remarks =
      "REMARK 350 BIOMOLECULE: 1\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: A\n" + biomt(1, unmoved) +
      "REMARK 350 BIOMOLECULE: 2\nREMARK 350 APPLY THE FOLLOWING TO CHAINS: Q\n" + biomt(1, unmoved);
  const TemporaryFile file("a.pdb", two_chains), listed("b.pdb", remarks + two_chains), xyz("c.xyz", "1\n\nC 0 0 0\n");
  const TemporaryFile broken("d.cif",
                             "data_a\n_pdbx_struct_assembly_gen.assembly_id 1\n"
                             "_pdbx_struct_assembly_gen.oper_expression (1-3)\n"
                             "_pdbx_struct_assembly_gen.asym_id_list A\n" +
                                 mmcif_tags + "ATOM C CA . GLY A A 1 0 0 0 1 1\n");
  const TemporaryFile backwards("g.cif",
                                "data_a\n_pdbx_struct_assembly_gen.assembly_id 1\n"
                                "_pdbx_struct_assembly_gen.oper_expression 3-1\n"
                                "_pdbx_struct_assembly_gen.asym_id_list A\n" +
                                    mmcif_tags + "ATOM C CA . GLY A A 1 0 0 0 1 1\n");
  const TemporaryFile blocks("e.cif", "data_a\n" + mmcif_tags + "ATOM C CA . GLY A A 1 0 0 0 1 1\ndata_b\n" +
                                          mmcif_tags + "ATOM C CA . GLY A A 1 0 0 0 1 1\n");
  const TemporaryFile chain("f.pqr",
                            "ATOM 1 CA GLY LONGCHAIN1 1 0 0 0 0 1\nEND\nATOM 1 CA GLY LONGCHAIN1 1 9 0 0 0 1\n");
  struct Refused {
    std::vector<std::string> arguments;
    int status;
    std::string reason;
  };
  const std::vector<Refused> cases = {
      {{file.path(), "--altloc"}, 2, "--altloc needs first, occupancy or a letter"},
      {{file.path(), "--altloc", "AB"}, 2, "--altloc: 'AB' is not first, occupancy or a letter"},
      {{file.path(), "--altloc", ""}, 2, "--altloc: '' is not first, occupancy or a letter"},
      {{file.path(), "--altloc", "A", "--altloc", "B"}, 2, "--altloc is given twice"},
      {{xyz.path(), "--altloc", "A"}, 2, "--altloc has no use here: it is for .pdb and .cif files"},
      {{file.path(), "--chains", "label"},
       2,
       "--chains has no use here: it is for .cif files, which have two names of a chain"},
      {{blocks.path(), "--chains", "both"},
       2,
       "--chains: 'both' is neither auth nor label; did you mean --only chain:both?"},
      {{file.path(), "--models", "some"}, 2, "--models: 'some' is neither merged nor all"},
      {{file.path(), "--models", "merged", "--model", "2"},
       2,
       "--model is one of them, --models merged all: either the one or the other"},
      {{xyz.path(), "--assembly", "1"}, 2, "--assembly has no use here: it is for .pdb and .cif files"},
      {{listed.path(), "--assembly", "1", "--box", "9,9,9"}, 2, "--assembly is not for a --box: both make copies"},
      {{listed.path(), "--assembly", "1", "--models", "merged"},
       2,
       "copies are either those of --assembly or those of --models merged"},
      {{listed.path(), "--assembly", "1", "--pdb-out", "x.pdb"},
       2,
       "--pdb-out has the atoms of the file, each once: not with --assembly"},
      {{listed.path(), "--models", "merged", "--trajectory", "x.xtc"},
       2,
       "--trajectory has the atoms of the file, each once: not with --models merged"},
      {{file.path(), "--assembly", "1"}, 1, file.path() + ": the file states no assemblies: not with --assembly"},
      {{listed.path(), "--assembly", "3"}, 1, listed.path() + ": no assembly '3': the file has 1, 2"},
      {{listed.path(), "--assembly", "2"}, 1, listed.path() + ": assembly '2' has none of the chains that are read"},
      {{broken.path(), "--assembly", "1"}, 1, broken.path() + ": _pdbx_struct_assembly_gen: there is no operator '1'"},
      {{backwards.path(), "--assembly", "1"},
       1,
       backwards.path() + ": _pdbx_struct_assembly_gen: there is no operator '3-1'"},
      {{blocks.path(), "--models", "merged"},
       1,
       blocks.path() + ":32: --models merged is of one structure: here begins another block or component"},
      {{chain.path(), "--models", "merged"},
       1,
       chain.path() + ": a chain's name is too long for its copy's: 'LONGCHAIN1-2'"}};
  for (const Refused &refused : cases) {
    std::vector<std::string> arguments = {"measure"};
    arguments.insert(arguments.end(), refused.arguments.begin(), refused.arguments.end());
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.status, refused.status) << refused.reason;
    EXPECT_EQ(outcome.err, "hardsphere: " + refused.reason + "\n");
    EXPECT_EQ(outcome.out, "");
  }
}

// Crystals name it in several ways, of which the symbol of Hermann and Mauguin counts, then its full form, then that of
// Hall, and then the number, whatever their order.
TEST(Choices, SymmetriesOfCrystalsHaveSeveralNames) {
  struct Name {
    std::string items, shown;
  };
  const std::string hall = "_symmetry_space_group_name_Hall '-P 2ybc'\n",
                    full = "_space_group_name_H-M_full 'P 1 21/c 1'\n",
                    symbol = "_symmetry_space_group_name_H-M 'P 21/c'\n", number = "_space_group_IT_number 14\n";
  const std::vector<Name> names = {{hall, "-P 2ybc"},
                                   {"_space_group_name_Hall '-P 1'\n", "-P 1"},
                                   {"_space_group.name_Hall '-P 2ybc'\n", "-P 2ybc"},
                                   {"_space_group.name_H-M_full 'P 1 21/c 1'\n", "P 1 21/c 1"},
                                   {number, "No. 14"},
                                   {number + hall, "-P 2ybc"},
                                   {hall + number, "-P 2ybc"},
                                   {hall + full, "P 1 21/c 1"},
                                   {full + hall, "P 1 21/c 1"},
                                   {symbol + full + hall + number, "P 21/c"},
                                   {number + hall + full + symbol, "P 21/c"},
                                   {"_symmetry_space_group_name_H-M ''\n" + hall, "-P 2ybc"},
                                   {hall + "_symmetry_space_group_name_H-M ?\n", "-P 2ybc"},
                                   {"_space_group_name_Hall 'P 1'\n", ""},
                                   {"_space_group_name_H-M_full 'P 1'\n", ""},
                                   {"_space_group_IT_number 1\n", ""},
                                   {"_symmetry_space_group_name_H-M 'P 1'\n" + hall, ""}};
  for (const Name &name : names) {
    const TemporaryFile file("named.cif",
                             "data_a\n_cell_length_a 10\n_cell_length_b 10\n_cell_length_c 10\n_cell_angle_alpha 90\n"
                             "_cell_angle_beta 90\n_cell_angle_gamma 90\n" +
                                 name.items +
                                 "loop_\n_atom_site_label\n_atom_site_type_symbol\n_atom_site_fract_x\n"
                                 "_atom_site_fract_y\n_atom_site_fract_z\nC1 C 0.1 0.2 0.3\n");
    const std::string note = "hardsphere: " + file.path() + ": space group " + name.shown +
                             ": copies by symmetry are not made, the file has no operators\n";
    EXPECT_EQ(run_program({"measure", file.path(), "--box", "file", "--csv"}).err, name.shown.empty() ? "" : note)
        << name.items;
  }
}

// A symmetry that is only named fills no box, and stderr says so beside every form.
TEST(Choices, ASymmetryThatIsOnlyNamedIsNoted) {
  const TemporaryFile named("named.pdb", "CRYST1   30.000   30.000   30.000  90.00  90.00  90.00 P 21 21 21    4\n" +
                                             atom(" CA", " GLY A   1", 5, 5, 5));
  const TemporaryFile plain("plain.pdb", "CRYST1   30.000   30.000   30.000  90.00  90.00  90.00 P 1           1\n" +
                                             atom(" CA", " GLY A   1", 5, 5, 5));
  const std::string note = ": space group P 21 21 21: copies by symmetry are not made, the file has no operators\n";
  for (const char *form : {"--json", "--csv", "--per-ball"}) {
    EXPECT_EQ(run_program({"measure", named.path(), "--box", "file", form}).err, "hardsphere: " + named.path() + note);
    EXPECT_EQ(run_program({"measure", named.path(), "--box", "p1", form}).err, "");
    EXPECT_EQ(run_program({"measure", plain.path(), "--box", "file", form}).err, "");
    EXPECT_EQ(run_program({"measure", named.path(), form}).err, "");
  }
}

}  // namespace
