// One molecule in every format: the same atoms to the last bit. The files are written here, from what the test reads of
// the PDB file by its columns, so that nothing of the program's readers has a part in them.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

struct Atom {
  std::string name, residue, chain, number, insertion, element;
  std::string xyz[3];  // as written
};

std::string trimmed(const std::string &text) {
  const size_t begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') + 1 - begin);
}

std::string crambin() {
  return molecules_folder() + "/crambin.pdb";
}

std::vector<Atom> atoms_of_crambin() {
  std::vector<Atom> atoms;
  const std::string text = read_file(crambin());
  for (size_t begin = 0; begin < text.size(); begin = text.find('\n', begin) + 1) {
    const std::string line = text.substr(begin, text.find('\n', begin) - begin);
    if (line.rfind("ATOM", 0) != 0) continue;
    Atom atom = {trimmed(line.substr(12, 4)),
                 trimmed(line.substr(17, 3)),
                 trimmed(line.substr(21, 1)),
                 trimmed(line.substr(22, 4)),
                 trimmed(line.substr(26, 1)),
                 trimmed(line.substr(76, 2)),
                 {}};
    for (size_t axis = 0; axis < 3; ++axis) atom.xyz[axis] = trimmed(line.substr(30 + 8 * axis, 8));
    atoms.push_back(atom);
  }
  EXPECT_EQ(atoms.size(), 327u);
  return atoms;
}

std::string line_of(const std::vector<std::string> &words) {
  std::string line;
  for (const std::string &word : words) line.append(line.empty() ? "" : " ").append(word);
  line.push_back('\n');
  return line;
}

std::string as_xyz(const std::vector<Atom> &atoms) {
  std::string text = line_of({std::to_string(atoms.size())}) + "crambin\n";
  for (const Atom &atom : atoms) text += line_of({atom.element, atom.xyz[0], atom.xyz[1], atom.xyz[2]});
  return text;
}

// Bondi's radii.
std::string radius_of(const std::string &element) {
  return element == "C" ? "1.70" : element == "N" ? "1.55" : element == "O" ? "1.52" : "1.80";
}

std::string as_pqr(const std::vector<Atom> &atoms) {
  std::string text;
  for (const Atom &atom : atoms) {
    text += line_of({"ATOM", "1", atom.name, atom.residue, atom.chain, atom.number + atom.insertion, atom.xyz[0],
                     atom.xyz[1], atom.xyz[2], "0.0", radius_of(atom.element)});
  }
  return text;
}

std::string as_xyzr(const std::vector<Atom> &atoms) {
  std::string text;
  for (const Atom &atom : atoms) {
    text += line_of({atom.xyz[0], atom.xyz[1], atom.xyz[2], radius_of(atom.element)});
  }
  return text;
}

// The first lines of a block with a loop over _atom_site.
std::string cif_loop(const std::vector<std::string> &items) {
  std::string text = "data_block\nloop_\n";
  for (const std::string &item : items) text += "_atom_site." + item + "\n";
  return text;
}

std::string as_cif(const std::vector<Atom> &atoms) {
  std::string text = cif_loop({"group_PDB", "type_symbol", "label_atom_id", "label_comp_id", "label_asym_id",
                               "auth_seq_id", "auth_asym_id", "pdbx_PDB_ins_code", "Cartn_x", "Cartn_y", "Cartn_z"});
  for (const Atom &atom : atoms) {
    text += line_of({"ATOM", atom.element, "\"" + atom.name + "\"", atom.residue, "X", atom.number, atom.chain,
                     atom.insertion.empty() ? "?" : atom.insertion, atom.xyz[0], atom.xyz[1], atom.xyz[2]});
  }
  return text;
}

// The same digits with the point one place further to the left.
std::string as_nanometres(const std::string &angstrom) {
  const bool negative = angstrom.front() == '-';
  std::string digits;
  for (const char c : angstrom) {
    if (c != '-' && c != '.') digits.push_back(c);
  }
  const size_t zeros = digits.size() < 5 ? 5 - digits.size() : 0;
  std::string result(negative ? "-" : "");
  result.append(zeros, '0').append(digits);
  result.insert(result.end() - 4, '.');
  return result;
}

std::string right(const std::string &text, size_t width) {
  return std::string(width - text.size(), ' ') + text;
}

std::string as_gro(const std::vector<Atom> &atoms) {
  std::string text = "crambin\n" + std::to_string(atoms.size()) + "\n";
  for (const Atom &atom : atoms) {
    text += right(atom.number, 5) + atom.residue + "  " + right(atom.name, 5) + "    1";
    for (const std::string &number : atom.xyz) text += right(as_nanometres(number), 9);
    text += "\n";
  }
  return text + "5 5 5\n";
}

std::string as_sdf(const std::vector<Atom> &atoms) {
  std::string text =
      "crambin\n\n\n" + right(std::to_string(atoms.size()), 3) + "  0  0  0  0  0  0  0  0  0999 V2000\n";
  for (const Atom &atom : atoms) {
    for (const std::string &number : atom.xyz) text += right(number, 10);
    text += " " + atom.element + "\n";
  }
  return text + "M  END\n";
}

std::string as_v3000(const std::vector<Atom> &atoms) {
  std::string text = "crambin\n\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS " +
                     std::to_string(atoms.size()) + " 0 0 0 0\nM  V30 BEGIN ATOM\n";
  for (const Atom &atom : atoms) {
    text += line_of({"M  V30", "1", atom.element, atom.xyz[0], atom.xyz[1], atom.xyz[2], "0"});
  }
  return text + "M  V30 END ATOM\nM  V30 END CTAB\nM  END\n";
}

std::string as_mol2(const std::vector<Atom> &atoms) {
  std::string text = "@<TRIPOS>MOLECULE\ncrambin\n" + std::to_string(atoms.size()) + "\n@<TRIPOS>ATOM\n";
  for (const Atom &atom : atoms) {
    text += line_of(
        {"1", atom.name, atom.xyz[0], atom.xyz[1], atom.xyz[2], atom.element + ".3", "1", atom.residue + atom.number});
  }
  return text;
}

std::string measured(const std::string &file, const std::vector<std::string> &options = {}) {
  std::vector<std::string> arguments = {"measure", file, "--json", "--per-ball", "--probe", "1.4"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return geometry_alone(outcome.out);
}

TEST(Formats, CrambinInAllOfThem) {
  const std::vector<Atom> atoms = atoms_of_crambin();
  const std::string expected = measured(crambin());
  const std::vector<std::pair<std::string, std::string>> files = {
      {"xyz", as_xyz(atoms)}, {"pqr", as_pqr(atoms)}, {"xyzr", as_xyzr(atoms)}, {"cif", as_cif(atoms)},
      {"gro", as_gro(atoms)}, {"sdf", as_sdf(atoms)}, {"mol", as_v3000(atoms)}, {"mol2", as_mol2(atoms)}};
  for (const auto &[extension, text] : files) {
    const TemporaryFile file("crambin." + extension, text);
    EXPECT_EQ(measured(file.path()), expected) << extension;
  }
}

// Lengths are angstrom in .gro files as in .pdb files, once they are read: what is drawn, cut into triangles or listed
// of the same atoms has the same bytes.
TEST(Formats, GroAsPdb) {
  std::string pdb = read_file(crambin());
  for (size_t at = 0; at < pdb.size(); at = pdb.find('\n', at) + 1) {
    if (pdb.compare(at, 4, "ATOM") == 0) pdb[at + 21] = pdb[at + 26] = ' ';  // no chains and insertions in .gro files
  }
  const TemporaryFile files[] = {TemporaryFile("crambin.gro", as_gro(atoms_of_crambin())),
                                 TemporaryFile("crambin.pdb", pdb)};
  const std::vector<std::vector<std::string>> commands = {
      {"mesh", "-o", "-", "--triangles", "ply"},
      {"mesh", "-o", "-", "--triangles", "svg", "--cut", "--probe", "1.4"},
      {"draw", "-o", "-", "--title", "crambin", "--colour", "area", "--legend", "--scale-bar"},
      {"draw", "-o", "-", "--title", "crambin", "--as", "ball-and-stick", "--look", "paper"},
      {"contacts", "--by", "residue", "--map", "-"},
      {"measure", "--csv", "--by", "residue", "--relative", "--probe", "1.4"},
  };
  for (const std::vector<std::string> &command : commands) {
    std::string outputs[2];
    for (size_t i = 0; i < 2; ++i) {
      std::vector<std::string> arguments = {command.front(), files[i].path()};
      arguments.insert(arguments.end(), command.begin() + 1, command.end());
      const Outcome outcome = run_program(arguments);
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      outputs[i] = std::regex_replace(outcome.out, std::regex("<title>.*</title>"), "");
    }
    EXPECT_FALSE(outputs[1].empty());
    EXPECT_TRUE(outputs[0] == outputs[1]) << command.front() << ' ' << command.back();
  }
  for (const char *command : {"voids", "contacts", "boundary", "model", "cells"}) {
    const Outcome gro = run_program({command, files[0].path(), "--probe", "1.4"});
    const Outcome same = run_program({command, files[1].path(), "--probe", "1.4"});
    EXPECT_EQ(gro.status, 0) << gro.err;
    const size_t heading = gro.out.find("\n  radii");
    EXPECT_EQ(gro.out.substr(heading), same.out.substr(same.out.find("\n  radii"))) << command;
  }
}

// Records are models; of a file that is cut off anywhere the first is read as a whole or refused, with one line.
TEST(Formats, RecordsAreModels) {
  const std::string flat = "all z are 0: a flat molecule, or a drawing, which says nothing of space";
  for (const char *name : {"two_records.sdf", "two_records.mol2"}) {
    const std::string file = std::string("good/") + name;
    for (int model = 1; model <= 2; ++model) {
      const Json input = run_json({"measure", file, "--model", std::to_string(model)}, model == 1 ? flat : "")["input"];
      EXPECT_EQ(input["models"].number, 2) << name;
      EXPECT_EQ(input["balls"].number, 5 - model) << name;
      EXPECT_EQ(input["left_out"]["other_models"].number, name[12] == 's' && model == 1 ? 0 : 2 + model) << name;
    }
    EXPECT_EQ(run_program({"measure", file, "--model", "3"}).status, 1) << name;
    const std::string text = read_file(inputs_folder() + "/" + file);
    const std::string whole = measured(file);
    size_t refused = 0;
    for (size_t length = 0; length < text.size(); length += 7) {
      const TemporaryFile cut(name, text.substr(0, length));
      const Outcome outcome = run_program({"measure", cut.path(), "--json", "--per-ball", "--probe", "1.4"});
      refused += outcome.status == 1 ? 1 : 0;
      EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
      EXPECT_TRUE(outcome.status == 1 || geometry_alone(outcome.out) == whole) << length;
    }
    EXPECT_GT(refused, 20u) << name;
  }
}

// Formats with residues agree on these as well.
TEST(Formats, ResiduesOfCrambin) {
  const std::vector<Atom> atoms = atoms_of_crambin();
  for (const char *by : {"residue", "chain"}) {
    const std::string expected = measured(crambin(), {"--by", by});
    const std::vector<std::pair<std::string, std::string>> files = {{"pqr", as_pqr(atoms)}, {"cif", as_cif(atoms)}};
    for (const auto &[extension, text] : files) {
      const TemporaryFile file("crambin." + extension, text);
      EXPECT_EQ(measured(file.path(), {"--by", by}), expected) << extension;
    }
  }
}

// The names that the wwPDB and others give to PDB and mmCIF files.
TEST(Formats, Extensions) {
  const std::string pdb = read_file(inputs_folder() + "/good/water.pdb");
  const std::string cif = read_file(inputs_folder() + "/good/water.cif");
  const std::string expected = measured("good/water.pdb");
  for (const char *name : {"pdb1234.ent", "1abc.pdb1", "1abc.PDB12", "1abc.Ent"}) {
    const TemporaryFile file(name, pdb);
    EXPECT_EQ(measured(file.path()), expected) << name;
    EXPECT_EQ(run_program({"measure", file.path(), "--pdb-out", "-"}).status, 0) << name;
  }
  for (const char *name : {"1abc.cif", "1abc.mmcif", "1abc.CIF"}) {
    const TemporaryFile file(name, cif);
    EXPECT_EQ(measured(file.path()), expected) << name;
  }
  for (const char *name : {"1abc.pd", "1abc.pdbx", "1abc.pdb1a", "1abc.pdb-", "1abc.cif1", "1abc.mm", "1abc.", "pdb"}) {
    const TemporaryFile file(name, pdb);
    EXPECT_EQ(run_program({"measure", file.path()}).status, 1) << name;
  }
}

struct Row {
  const char *label_atom, *auth_atom, *label_chain, *auth_chain, *label_number, *auth_number, *insertion;
  const char *expected;  // atom, element, chain, residue, number, insertion of --csv
};

// The authors' names count, and the labels where the authors are silent.
TEST(Cif, Labels) {
  const std::vector<Row> rows = {
      {"CA", "CB", "A", "H", "1", "100", "A", "CB,C,H,GLY,100,A"},
      {"CA", "?", "A", "?", "1", "?", "?", "CA,C,A,GLY,1,"},
      {"\"C1'\"", ".", "AAA", ".", "-5", ".", ".", "C1',C,AAA,GLY,-5,"},
      {"CA", "'?'", "A", "'.'", "1", "2", "?", "?,C,.,GLY,2,"},
  };
  std::string text =
      cif_loop({"type_symbol", "label_atom_id", "auth_atom_id", "label_asym_id", "auth_asym_id", "label_seq_id",
                "auth_seq_id", "pdbx_PDB_ins_code", "label_comp_id", "Cartn_x", "Cartn_y", "Cartn_z"});
  for (size_t i = 0; i < rows.size(); ++i) {
    const Row &row = rows[i];
    text += line_of({"C", row.label_atom, row.auth_atom, row.label_chain, row.auth_chain, row.label_number,
                     row.auth_number, row.insertion, "GLY", std::to_string(10 * i), "0", "0"});
  }
  const TemporaryFile file("labels.cif", text);
  const std::string csv = run_program({"measure", file.path(), "--csv"}).out;
  for (size_t i = 0; i < rows.size(); ++i) {
    std::string line = "\n";
    line.append(std::to_string(i)).append(",").append(rows[i].expected);
    line.append(",").append(std::to_string(10 * i)).append(",0,0,");
    EXPECT_NE(csv.find(line), std::string::npos) << line << csv;
  }
}

// Each table's models are its own, and --model counts them all.
TEST(Cif, Models) {
  const std::string text =
      cif_loop({"Cartn_x", "Cartn_y", "Cartn_z", "type_symbol", "pdbx_PDB_model_num"}) +
      "0 0 0 C 1\n9 0 0 C 1\n0 0 0 N 2\n0 0 0 O 7\n5 0 0 O 7\n9 0 0 O 7\n" +
      cif_loop({"Cartn_x", "Cartn_y", "Cartn_z", "type_symbol"}) + "0 0 0 S\n" +
      "_atom_site.Cartn_x 1\n_atom_site.type_symbol H\n_atom_site.Cartn_y 1\n_atom_site.Cartn_z 1\n";
  const TemporaryFile file("models.cif", text);
  const std::vector<std::pair<double, double>> expected = {{2, 6}, {1, 7}, {3, 5}, {1, 7}, {1, 7}};
  for (size_t model = 1; model <= expected.size(); ++model) {
    const Json input = run_json({"measure", file.path(), "--model", std::to_string(model)})["input"];
    EXPECT_EQ(input["models"].number, 5);
    EXPECT_EQ(input["balls"].number, expected[model - 1].first) << model;
    EXPECT_EQ(input["left_out"]["other_models"].number, expected[model - 1].second) << model;
  }
  EXPECT_EQ(run_program({"measure", file.path(), "--model", "6"}).status, 1);
}

// Residues that stand there under two names, and chains that only their labels tell apart.
TEST(Cif, AlternateLocations) {
  const std::string head = cif_loop({"type_symbol", "auth_atom_id", "label_alt_id", "auth_comp_id", "label_asym_id",
                                     "auth_asym_id", "auth_seq_id", "Cartn_x", "Cartn_y", "Cartn_z"});
  const TemporaryFile file("alternates.cif", head +
                                                 "N N  . SER A A 1 0 0 0\n"     // kept: no letter
                                                 "C CB B SER A A 1 9 0 0\n"     // kept: the first
                                                 "C CB A THR A A 1 18 0 0\n"    // the other place, under another name
                                                 "C CG A THR A A 1 27 0 0\n"    // nowhere else, but of the other name
                                                 "O OG B SER A A 1 36 0 0\n"    // kept
                                                 "N N  A SER A A 1 45 0 0\n"    // seen without a letter
                                                 "N N  A SER C A 1 54 0 0\n"    // kept: another chain by its label
                                                 "O O  A HOH D A 1 63 0 0\n");  // kept
  const Json input = run_json({"measure", file.path()})["input"];
  EXPECT_EQ(input["balls"].number, 5);
  EXPECT_EQ(input["left_out"]["alternate_locations"].number, 3);
}

// Words for letters of locations differ in any of their characters.
TEST(Cif, WordsForLocations) {
  const std::string head = cif_loop({"type_symbol", "auth_atom_id", "label_alt_id", "auth_comp_id", "label_asym_id",
                                     "auth_asym_id", "auth_seq_id", "Cartn_x", "Cartn_y", "Cartn_z"});
  const TemporaryFile file("words.cif", head +
                                            "N N  .  ALA A A 1 0 0 0\n"
                                            "C CA A1 ALA A A 1 9 0 0\n"
                                            "C CA A2 ALA A A 1 18 0 0\n"  // another place of the atom
                                            "C CB A1 ALA A A 1 27 0 0\n"
                                            "C CB A  ALA A A 1 36 0 0\n"  // and this
                                            "C CA A1 GLY A A 2 45 0 0\n"
                                            "C CA A2 SER A A 2 54 0 0\n"    // under another name
                                            "C CB A2 SER A A 2 63 0 0\n");  // of the other name
  for (const char *location : {"first", "A"}) {
    const Json input = run_json({"measure", file.path(), "--altloc", location})["input"];
    EXPECT_EQ(input["balls"].number, 4) << location;
    EXPECT_EQ(input["left_out"]["alternate_locations"].number, 4) << location;
  }
}

// Rows follow from their values, not from lines: quotes with blanks in them, rows over two lines, two rows on a line,
// comments, and lines with other columns in between.
TEST(Cif, RowsAndLines) {
  const std::string head = cif_loop({"label_atom_id", "type_symbol", "Cartn_x", "Cartn_y", "Cartn_z"});
  const std::string rows =
      "C1 C 0 0 0\n"
      "C2 C 9 0 0\n"
      "'C 3' C 18 0\n0\n"
      "\"C'4\" C 27 0 0\n"
      "'C 5' C 36 0 0 # five\n"
      "C6   C    45.000   -0.0    0 \n"
      "C7   C    54.000   -0.0    0 C8 C 63 0 0\n"
      "\tC9 C 72 0 0\n"
      "'C''' C 81 0 0\n"
      "C11\nC 90 0 0";
  const TemporaryFile file("rows.cif", head + rows);
  const std::string csv = run_program({"measure", file.path(), "--csv"}).out;
  int ball = 0;
  for (const char *name : {"C1", "C2", "C 3", "C'4", "C 5", "C6", "C7", "C8", "C9", "C''", "C11"}) {
    std::string line = "\n";
    line.append(std::to_string(ball)).append(",").append(name).append(",C,,,,,").append(std::to_string(9 * ball));
    EXPECT_NE(csv.find(line + ",0,0,"), std::string::npos) << line << csv;
    ++ball;
  }
  const TemporaryFile broken("broken.cif", head + "C1 C 0 0 0\nC2 C 9 0\n");
  EXPECT_NE(run_program({"measure", broken.path()}).err.find("a row of _atom_site has 4 of 5 values"),
            std::string::npos);
}

// Rows that are lines, in the columns of the row before or with one blank between values: what atoms of a residue share
// is looked at once. They are read like rows of two lines, which are taken value by value.
TEST(Cif, RowsThatGoOnWithAResidue) {
  std::mt19937 random(5);
  const auto one_of = [&](const std::vector<std::string> &texts) { return texts[random() % texts.size()]; };
  const std::string head = cif_loop({"group_PDB", "type_symbol", "auth_atom_id", "label_alt_id", "auth_comp_id",
                                     "label_asym_id", "auth_asym_id", "auth_seq_id", "pdbx_PDB_ins_code", "Cartn_x",
                                     "Cartn_y", "Cartn_z", "pdbx_PDB_model_num"});
  double left_out = 0.0;
  for (int round = 0; round < 40; ++round) {
    std::string in_columns = head, on_two_lines = head;
    std::string group = "ATOM  ", comp = "ALA", label = "A", chain = "A", number = "9 ", insertion = "?", model = "1";
    for (int i = 0; i < 60; ++i) {
      if (random() % 9 == 0) group = one_of({"ATOM  ", "HETATM"});
      if (random() % 9 == 0) comp = one_of({"ALA", "SER", "'S'"});
      if (random() % 9 == 0) label = one_of({"A", "B", "?"});
      if (random() % 9 == 0) chain = one_of({"A", "B", "."});
      if (random() % 5 == 0) number = one_of({"9 ", "10", "1 ", "? "});
      if (random() % 9 == 0) insertion = one_of({"?", "A"});
      if (random() % 20 == 0) model = one_of({"1", "2", "12"});
      const std::string front = group + " C " + one_of({"CA   ", "CB   ", "N    ", "\"C1'\"", "'C'' "}) + " " +
                                one_of({".", ".", ".", ".", "A", "B"}) + " " + comp + " " + label + " " + chain + " " +
                                number + " " + insertion;
      const std::string behind =
          one_of({"1.5     ", "-2.25000", "300     "}) + " 1 2 " + model + (random() % 30 == 0 ? "\n" : " \n");
      in_columns.append(front).append(" ").append(behind);
      on_two_lines.append(front).append("\n").append(behind);
    }
    if (round % 2 == 1) {
      const auto both_blank = [](char one, char other) { return one == ' ' && other == ' '; };
      in_columns.erase(std::unique(in_columns.begin(), in_columns.end(), both_blank), in_columns.end());
    }
    const TemporaryFile file("columns.cif", in_columns), other("lines.cif", on_two_lines);
    for (const char *number_of_model : {"1", "2"}) {
      const Outcome outcome = run_program({"measure", file.path(), "--csv", "--model", number_of_model});
      ASSERT_EQ(outcome.out, run_program({"measure", other.path(), "--csv", "--model", number_of_model}).out) << round;
      if (outcome.status != 0) continue;  // there is one model
      const Json one = run_json({"measure", file.path(), "--model", number_of_model})["input"];
      const Json two = run_json({"measure", other.path(), "--model", number_of_model})["input"];
      for (const char *what : {"other_models", "alternate_locations"}) {
        ASSERT_EQ(one["left_out"][what].number, two["left_out"][what].number) << round;
        left_out += one["left_out"][what].number;
      }
    }
  }
  EXPECT_GT(left_out, 1000.0);
}

// Atoms with items of another table beside theirs, more than there are names for.
TEST(Cif, ItemsOfTheCellAmongThoseOfAtoms) {
  std::string text = cif_loop({"type_symbol", "Cartn_x", "Cartn_y", "Cartn_z"});
  std::string row = "C 0 0 1.5";
  for (int i = 0; i < 80; ++i) {
    text += "_cell.length_a\n";
    row += " 5";
  }
  text.append(row).append("\n").append(row).append("\n");
  const TemporaryFile file("cells.cif", text);
  const std::string csv = run_program({"measure", file.path(), "--csv"}).out;
  EXPECT_NE(csv.find("\n1,,C,,,,,0,0,1.5,"), std::string::npos) << csv;
}

// Symbols with a charge, and deuterium.
TEST(Cif, Elements) {
  const std::string head = cif_loop({"type_symbol", "Cartn_x", "Cartn_y", "Cartn_z"});
  const TemporaryFile file("elements.cif", head + "O2- 0 0 0\nzn2+ 9 0 0\n\"CL\" 18 0 0\nD 27 0 0\nNa1+ 36 0 0\n");
  const std::string csv = run_program({"measure", file.path(), "--csv"}).out;
  for (const char *row : {"\n0,,O,", "\n1,,Zn,", "\n2,,Cl,", "\n3,,H,", "\n4,,Na,"}) {
    EXPECT_NE(csv.find(row), std::string::npos) << row << csv;
  }
}

// Elements and residues by names alone.
TEST(Gro, Names) {
  const std::string csv = run_program({"measure", "good/residues.gro", "--csv"}).out;
  for (const char *row :
       {"\n0,N,N,,ALA,1,,0,0,0,", "\n1,CA,C,,ALA,1,,10,0,0,", "\n2,HB1,H,,ALA,1,,20,0,0,", "\n3,NA,Na,,ION,2,,30,0,0,",
        "\n4,P,P,,POPC,99999,,40,0,0,", "\n5,C210,C,,POPCX,0,,50,0,0,", "\n6,CL,Cl,,CL,0,,-60,0,0,"}) {
    EXPECT_NE(csv.find(row), std::string::npos) << row << csv;
  }
}

TEST(Gro, Models) {
  const std::vector<std::pair<double, double>> expected = {{3, 2}, {1, 4}};
  for (size_t model = 1; model <= expected.size(); ++model) {
    const Json input = run_json({"measure", "good/water_two_models.gro", "--model", std::to_string(model)})["input"];
    EXPECT_EQ(input["models"].number, 3);
    EXPECT_EQ(input["balls"].number, expected[model - 1].first) << model;
    EXPECT_EQ(input["left_out"]["other_models"].number, expected[model - 1].second) << model;
  }
  // The third is broken off.
  EXPECT_EQ(run_program({"measure", "good/water_two_models.gro", "--model", "3"}).status, 1);
}

// Nanometres become angstrom by their digits: 0.1 + 0.2 and the like leave no trace.
TEST(Gro, NothingIsRoundedOnTheWay) {
  std::string text = "digits\n9999\n";
  for (int i = 1; i < 10000; ++i) {
    const std::string digits = std::to_string(i);
    text += "    1LIG      C    1   0." + std::string(4 - digits.size(), '0') + digits + "   1.0000   0.0000\n";
  }
  const TemporaryFile file("digits.gro", text + "1 1 1\n");
  const Outcome outcome = run_program({"measure", file.path(), "--csv", "--radius", "C=0.0001"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  std::string line;
  std::getline(lines, line);
  for (int i = 1; i < 10000; ++i) {
    std::getline(lines, line);
    std::istringstream fields(line);
    std::string field;
    for (int column = 0; column <= 7; ++column) std::getline(fields, field, ',');
    EXPECT_EQ(std::stod(field), i / 1000.0) << line;  // both are correctly rounded
  }
}

}  // namespace
