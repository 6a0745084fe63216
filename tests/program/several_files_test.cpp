// One command on several files: what each gives alone, one after the other, and what a bad one changes.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

const std::vector<std::string> files = {"good/water.pdb", "good/water.cif", "good/one.cif", "good/residues.pdb"};

std::vector<std::string> call(const std::string &command, const std::vector<std::string> &names,
                              const std::vector<std::string> &options = {}) {
  std::vector<std::string> arguments = {command};
  arguments.insert(arguments.end(), names.begin(), names.end());
  arguments.insert(arguments.end(), options.begin(), options.end());
  return arguments;
}

TEST(SeveralFiles, TablesAndJson) {
  for (const std::string command : {"model", "boundary", "measure", "voids"}) {
    for (const bool json : {false, true}) {
      const std::vector<std::string> options = json ? std::vector<std::string>{"--json"} : std::vector<std::string>{};
      std::string expected;
      for (const std::string &file : files) {
        if (!json && !expected.empty()) expected += '\n';
        expected += run_program(call(command, {file}, options)).out;
      }
      const Outcome outcome = run_program(call(command, files, options));
      EXPECT_EQ(outcome.status, 0);
      EXPECT_EQ(outcome.err, "");
      EXPECT_EQ(outcome.out, expected) << command;
    }
  }
  EXPECT_EQ(run_program(call("query", {"good/water.pdb", "good/one.cif"}, {"--json", "--point", "0", "0", "0"})).status,
            0);
}

std::vector<std::string> lines_of(const std::string &text) {
  std::vector<std::string> lines;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = text.find('\n', begin);
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

TEST(SeveralFiles, OneTableOfCsv) {
  for (const std::vector<std::string> &options :
       {std::vector<std::string>{"--csv"}, std::vector<std::string>{"--csv", "--by", "residue"}}) {
    std::string expected;
    for (const std::string &file : files) {
      std::string prefix = "file";
      for (const std::string &line : lines_of(run_program(call("measure", {file}, options)).out)) {
        if (prefix != "file" || expected.empty()) expected.append(prefix).append(",").append(line).append("\n");
        prefix = file;
      }
    }
    EXPECT_EQ(run_program(call("measure", files, options)).out, expected);
  }
}

// Names are quoted where they must be, and a line end within a field begins no row.
TEST(SeveralFiles, CsvOfOddNames) {
  const std::string atoms =
      "data_x\n_atom_site.type_symbol C\n_atom_site.Cartn_x 0\n_atom_site.Cartn_y 0\n"
      "_atom_site.Cartn_z 0\n_atom_site.label_asym_id\n;A\nB\n;\n";
  const TemporaryFile odd("a,b.cif", atoms);
  const Outcome outcome = run_program({"measure", odd.path(), odd.path(), "--csv"});
  const std::string alone = run_program({"measure", odd.path(), "--csv"}).out;
  const size_t header = alone.find('\n') + 1;
  EXPECT_NE(alone.find("\"A\nB\""), std::string::npos) << alone;
  std::string row = "\"";
  row.append(odd.path()).append("\",").append(alone.substr(header));
  std::string expected = "file,";
  expected.append(alone.substr(0, header)).append(row).append(row);
  EXPECT_EQ(outcome.out, expected);
}

TEST(SeveralFiles, ABadOneStopsNoOther) {
  const std::vector<std::string> mixed = {"bad/nan.pdb", "good/water.pdb", "bad/molecule.gz",
                                          "none.pdb",    "good/water.cif", "bad/no_block.cif"};
  const Outcome outcome = run_program(call("measure", mixed, {"--json"}));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, run_program({"measure", "good/water.pdb", "--json"}).out +
                             run_program({"measure", "good/water.cif", "--json"}).out);
  std::string expected;
  for (const std::string &file : mixed) expected += run_program({"measure", file, "--json"}).err;
  EXPECT_EQ(outcome.err, expected);
  EXPECT_EQ(lines_of(outcome.err).size(), 4u);
  EXPECT_EQ(run_program({"measure", "good/water.pdb", "bad/nan.pdb"}).status, 1);
}

// Tables of other columns cannot be one table.
TEST(SeveralFiles, TablesMustAgree) {
  const Outcome outcome = run_program({"measure", "good/water.pdb", "good/three.xyzr", "good/one.cif", "--csv"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "hardsphere: good/three.xyzr: its table has other columns than that of the first file\n");
  EXPECT_EQ(outcome.out, run_program({"measure", "good/water.pdb", "good/one.cif", "--csv"}).out);
}

// A command line at fault stops all of them, wherever the file stands that it does not go with.
TEST(SeveralFiles, UsageComesFirst) {
  for (const std::vector<std::string> &arguments :
       {std::vector<std::string>{"measure", "good/water.pdb", "good/water.xyz", "--by", "chain"},
        std::vector<std::string>{"measure", "good/water.pdb", "bad/molecule.gz", "good/three.xyzr", "--radii", "bondi"},
        std::vector<std::string>{"measure", "good/water.pdb", "good/one.cif", "--bogus"},
        std::vector<std::string>{"measure", "-", "-", "--format", "pdb"}}) {
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.status, 2) << arguments.back();
    EXPECT_EQ(outcome.out, "") << arguments.back();
    EXPECT_EQ(lines_of(outcome.err).size(), 1u) << outcome.err;
  }
}

TEST(SeveralFiles, StandardInputAmongThem) {
  Surroundings surroundings;
  surroundings.in_path = inputs_folder() + "/good/water.pdb";
  surroundings.in_is_pipe = true;
  const Outcome outcome =
      run_program_in(surroundings, {"measure", "good/one.pdb", "-", "good/water.pdb", "--format", "pdb"});
  EXPECT_EQ(outcome.status, 1);
  const std::string table = run_program({"measure", "good/water.pdb"}).out;
  EXPECT_EQ(outcome.out, "standard input" + table.substr(table.find('\n')) + "\n" + table);
}

TEST(SeveralFiles, FullOutputIsSaidOnce) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  const Outcome outcome = run_program(call("measure", files), "/dev/full");
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err, "hardsphere: standard output: No space left on device\n");
}

}  // namespace
