// The PDB file that --pdb-out writes: areas in columns 61-66, everything else as it was.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

// The file that --pdb-out writes; the rest of the output must not depend on it.
std::string written(const std::string &file, std::vector<std::string> options = {}) {
  const TemporaryFile out("out.pdb");
  options.insert(options.begin(), {"measure", file, "--json"});
  const std::string plain = run_program(options).out;
  options.insert(options.end(), {"--pdb-out", out.path()});
  const Outcome outcome = run_program(options);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(outcome.out, plain);
  return std::filesystem::exists(out.path()) ? read_file(out.path()) : "";
}

std::string written_of_text(const std::string &text, const std::vector<std::string> &options = {}) {
  const TemporaryFile file("in.pdb", text);
  return written(file.path(), options);
}

// An atom record up to column 60, what stands in columns 61-66, and the rest.
const std::string carbon = "ATOM      1  CA  ALA A   1       0.000   0.000   0.000  1.00";
const std::string rest = "      SEGM C  and more";

std::vector<std::string> lines_of(const std::string &text) {
  std::vector<std::string> lines;
  size_t begin = 0;
  for (size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', begin)) {
    lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  EXPECT_EQ(begin, text.size());
  return lines;
}

// Crambin: every line is there, only columns 61-66 of the atoms differ, and they hold what JSON says.
TEST(PdbOutput, CrambinByteForByte) {
  const std::string file = molecules_folder() + "/crambin.pdb";
  for (const char *probe : {"0", "1.4"}) {
    const std::vector<std::string> before = lines_of(read_file(file));
    const std::vector<std::string> after = lines_of(written(file, {"--probe", probe}));
    const Json balls = run_json({"measure", file, "--per-ball", "--probe", probe})["balls"];
    ASSERT_EQ(after.size(), before.size());
    size_t atom = 0;
    for (size_t i = 0; i < before.size(); ++i) {
      if (before[i].rfind("ATOM", 0) != 0 && before[i].rfind("HETATM", 0) != 0) {
        EXPECT_EQ(after[i], before[i]);
        continue;
      }
      ASSERT_EQ(after[i].size(), before[i].size());
      EXPECT_EQ(after[i].substr(0, 60), before[i].substr(0, 60));
      EXPECT_EQ(after[i].substr(66), before[i].substr(66));
      EXPECT_NEAR(std::stod(after[i].substr(60, 6)), balls.items.at(atom++)["area"].number, 0.005 + 1e-12);
      EXPECT_EQ(after[i][63], '.');
    }
    EXPECT_EQ(atom, balls.items.size());
  }
}

// The written file is the same molecule again.
TEST(PdbOutput, IsReadAsTheSameMolecule) {
  for (const char *name :
       {"good/water.pdb", "good/water_alternates.pdb", "good/water_mixed_residue.pdb", "good/water_two_models.pdb",
        "good/water_two_models_no_endmdl.pdb", "good/water_crlf.pdb", "good/water_cr.pdb", "good/water_bom.pdb",
        "good/water_short_records.pdb", "good/water_remarks.pdb", "good/elements.pdb", "good/residues.pdb"}) {
    const TemporaryFile again("again.pdb", written(name));
    EXPECT_EQ(without_input(run_program({"measure", again.path(), "--per-ball", "--json"}).out),
              without_input(run_program({"measure", name, "--per-ball", "--json"}).out))
        << name;
    EXPECT_EQ(written(again.path()), read_file(again.path())) << name;
  }
}

TEST(PdbOutput, FillsShortLinesAndKeepsLongOnes) {
  EXPECT_EQ(written_of_text(carbon + " 99.99" + rest + "\n"), carbon + " 36.32" + rest + "\n");
  EXPECT_EQ(written_of_text(carbon + " 99.99\n"), carbon + " 36.32\n");
  EXPECT_EQ(written_of_text(carbon + " 99"), carbon + " 36.32");
  EXPECT_EQ(written_of_text(carbon), carbon + " 36.32");
  const std::string coordinates = carbon.substr(0, 54);
  EXPECT_EQ(written_of_text(coordinates + "\nEND\n"), coordinates + "       36.32\nEND\n");
  EXPECT_EQ(written_of_text(coordinates + "  0\r\n"), coordinates + "  0    36.32\r\n");
}

TEST(PdbOutput, KeepsLineEndsAndByteOrderMark) {
  const std::string mark = "\xEF\xBB\xBF";
  for (const std::string &end : {std::string("\n"), std::string("\r\n"), std::string("\r")}) {
    const std::string head = "HEADER    A" + end + end + "# note" + end;
    const std::string tail = "TER" + end + "END" + end;
    EXPECT_EQ(written_of_text(mark + head + carbon + "  0.00" + rest + end + tail),
              mark + head + carbon + " 36.32" + rest + end + tail);
  }
  EXPECT_EQ(written_of_text(mark + carbon + "  0.00\n"), mark + carbon + " 36.32\n");
}

// Wide areas lose their decimals before they would leave their columns. The radius is given, the area is 4 pi r^2.
TEST(PdbOutput, WideAreasStayInTheirColumns) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"0", "  0.00"},           {"0.5", "  3.14"}, {"8.9205938", "999.99"},  // 999.994
      {"8.9206027", "1000.0"},                                                // 999.996
      {"28.2093945", "9999.9"},                                               // 9999.94
      {"28.2094228", " 10000"},                                               // 9999.96
      {"282.0947071", "999999"},                                              // 999999.4
  };
  for (const auto &[radius, shown] : cases) {
    EXPECT_EQ(written_of_text(carbon + "  0.00" + rest + "\n", {"--radius", "C=" + radius}),
              carbon + shown + rest + "\n")
        << radius;
  }
}

TEST(PdbOutput, AreasBeyondTheColumnsAreRefused) {
  const TemporaryFile in("wide.pdb", "REMARK\n" + carbon + "  0.00\n");
  const TemporaryFile out("refused.pdb");
  // 999999.6, and an area with more digits than there are columns
  const std::vector<std::pair<std::string, std::string>> cases = {{"282.0947354", "1e+06"}, {"1e30", "1.26e+61"}};
  for (const auto &[radius, area] : cases) {
    const Outcome outcome = run_program({"measure", in.path(), "--radius", "C=" + radius, "--pdb-out", out.path()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err,
              "hardsphere: " + in.path() + ":2: its area, " + area + ", is too large for columns 61-66 of --pdb-out\n");
    EXPECT_FALSE(std::filesystem::exists(out.path()));
  }
}

// Alternate locations that were not read are left out, with the records that follow them.
TEST(PdbOutput, LeavesOutOtherLocations) {
  const std::string a = "ATOM      1  CA AALA A   1       0.000   0.000   0.000  0.50";
  const std::string b = "ATOM      2  CA BALA A   1       5.000   0.000   0.000  0.50";
  const std::string far = "ATOM      3  CB  ALA A   1      50.000   0.000   0.000  0.50";
  const std::string tail = "           C  ";
  EXPECT_EQ(written_of_text(a + "  1.00" + tail + "\nANISOU    1  CA\nSIGATM  A\n" + b + "  2.00" + tail +
                            "\nANISOU    2  CA\nSIGATM  B\nSIGUIJ  B\nREMARK between\n" + far + "  3.00" + tail +
                            "\nANISOU    3  CB\nTER\n"),
            a + " 36.32" + tail + "\nANISOU    1  CA\nSIGATM  A\nREMARK between\n" + far + " 36.32" + tail +
                "\nANISOU    3  CB\nTER\n");
}

// The first model alone; what stands after all models stays.
TEST(PdbOutput, LeavesOutOtherModels) {
  const std::string other = "ATOM      1  CA  ALA A   1       7.000   0.000   0.000  1.00  0.00\n";
  const std::string head = "HEADER    X\nNUMMDL    2\nMODEL        1\n";
  const std::string tail = "CONECT    1    2\nMASTER        0\nEND   \n";
  const std::string expected = head + carbon + " 36.32\nTER\nENDMDL\n" + tail;
  EXPECT_EQ(written_of_text(head + carbon + "  0.00\nTER\nENDMDL\nMODEL        2\nREMARK\n" + other +
                            "ANISOU    1  CA\nTER\nENDMDL\n" + tail + other + "END\n"),
            expected);
  // Without ENDMDL the next MODEL ends the first.
  EXPECT_EQ(written_of_text(head + carbon + "  0.00\nTER\nMODEL        2\n" + other + tail),
            head + carbon + " 36.32\nTER\n" + tail);
  // After END there is nothing.
  EXPECT_EQ(written_of_text(carbon + "  0.00\nEND\n" + other + "REMARK\nCONECT\nEND\n"), carbon + " 36.32\nEND\n");
}

TEST(PdbOutput, GoesWithEveryFormOfOutput) {
  for (const std::vector<std::string> &form :
       {std::vector<std::string>{"--csv"}, std::vector<std::string>{"--gradient"},
        std::vector<std::string>{"--by", "chain"}}) {
    const TemporaryFile out("form.pdb");
    std::vector<std::string> arguments = {"measure", "good/water.pdb", "--pdb-out", out.path()};
    arguments.insert(arguments.end(), form.begin(), form.end());
    EXPECT_EQ(run_program(arguments).status, 0);
    EXPECT_EQ(read_file(out.path()), written("good/water.pdb")) << form.front();
  }
}

// An older file of that name is replaced whole.
TEST(PdbOutput, ReplacesAnOlderFile) {
  const TemporaryFile out("older.pdb", std::string(100000, 'x'));
  EXPECT_EQ(run_program({"measure", "good/water.pdb", "--pdb-out", out.path()}).status, 0);
  EXPECT_EQ(read_file(out.path()), written("good/water.pdb"));
}

void expect_refusal(const std::string &path, const std::string &reason) {
  const Outcome outcome = run_program({"measure", "good/water.pdb", "--pdb-out", path});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "hardsphere: " + path + ": " + reason + "\n");
}

TEST(PdbOutput, SaysWhatCannotBeWritten) {
  const TemporaryFile folder("folder");
  std::filesystem::create_directory(folder.path());
  expect_refusal(folder.path(), "Is a directory");
  expect_refusal(folder.path() + "/none/out.pdb", "No such file or directory");
}

TEST(PdbOutput, FullDevice) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  expect_refusal("/dev/full", "No space left on device");
}

}  // namespace
