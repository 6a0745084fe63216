// Molecules in periodic boxes as the program has them: values of another program, boxes of every kind of file, what
// adds up, and what is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

std::string crambin() {
  return molecules_folder() + "/crambin.pdb";
}

double sum_of(const Json &list, const std::string &key) {
  double sum = 0.0;
  for (const Json &item : list.items) sum += key.empty() ? item.number : item[key].number;
  return sum;
}

TEST(Box, HasTheValuesOfAnotherProgram) {
  const Json found = run_json({"measure", crambin(), "--probe", "1.4", "--box", "25,0,0,7,18,0,-9,5,20", "--per-ball"});
  EXPECT_NEAR(found["area"].number, 1547.1613633888, 1e-9);
  EXPECT_NEAR(found["volume"].number, 7051.4068173166, 1e-9);
  EXPECT_EQ(found["box_volume"].number, 9000.0);
  EXPECT_NEAR(found["free_volume"].number, 9000.0 - 7051.4068173166, 1e-9);
  EXPECT_NEAR(sum_of(found["balls"], "area"), 1547.1613633888, 1e-8);
  ASSERT_EQ(found["windings"].items.size(), 1U);
  const Json &winding = found["windings"].items[0];
  EXPECT_EQ(winding["balls"].number, 327);
  EXPECT_EQ(winding["directions"].number, 3);
  EXPECT_EQ(winding["copies"].number, 1);
  EXPECT_EQ(winding["rows"].items.size(), 3U);
  // The trace of the volume's: 3 V - sum of r A.
  const std::vector<Json> &strain = found["strain_volume"].items;
  ASSERT_EQ(strain.size(), 9U);
  double radii = 0.0;
  for (const Json &ball : found["balls"].items) radii += (ball["radius"].number + 1.4) * ball["area"].number;
  const double trace = strain[0].number + strain[4].number + strain[8].number;
  EXPECT_NEAR(trace, 3 * 7051.4068173166 - radii, 1e-7);
}

TEST(Box, CountsTheBoundaryAndContacts) {
  const Json boundary = run_json({"boundary", crambin(), "--box", "40.96,18.65,22.52"});
  EXPECT_EQ(boundary["vertices"].number, 900);
  EXPECT_EQ(boundary["arcs"].number, 1350);
  EXPECT_EQ(boundary["circles"].number, 34);
  EXPECT_EQ(boundary["faces"].number, 444);
  EXPECT_EQ(boundary["euler"].number, -76);
  EXPECT_EQ(boundary["windings"].items.at(0)["directions"].number, 2);
  const std::vector<std::string> contacts{"contacts", crambin(), "--probe", "1.4", "--box", "30 30 30"};
  const Json listed = run_json(contacts);
  EXPECT_EQ(listed["contacts"].number, 1993);
  EXPECT_NEAR(listed["area"].number, 6617.3802848779, 1e-9);
  EXPECT_NEAR(sum_of(listed["pairs"], "area"), 6617.3802848779, 1e-8);
  bool across = false;
  for (const Json &pair : listed["pairs"].items) {
    ASSERT_EQ(pair["shift"].items.size(), 3U);
    for (const Json &shift : pair["shift"].items) across = across || shift.number != 0.0;
  }
  EXPECT_TRUE(across);
  std::vector<std::string> by = contacts, cells = contacts;
  by.insert(by.end(), {"--by", "residue"});
  cells.push_back("--cells");
  const Json between = run_json(by);
  EXPECT_GT(between["pairs"].items.size(), 100U);
  EXPECT_LT(sum_of(between["pairs"], "area"), 6617.3802848779);
  const Json of_cells = run_json(cells);
  EXPECT_NEAR(sum_of(of_cells["cells"], "volume"), 8354.6306000178, 1e-8);
  EXPECT_NEAR(sum_of(of_cells["cells"], "contact"), 2 * 6617.3802848779, 1e-8);
}

// Reference values as above.
TEST(Box, HasTheCurvatureOfWhatIsInIt) {
  const Json found =
      run_json({"measure", crambin(), "--probe", "1.4", "--curvature", "--box", "25,0,0,7,18,0,-9,5,20"});
  EXPECT_NEAR(found["mean_curvature"].number, -94.510929797134, 1e-8);
  EXPECT_NEAR(found["gauss_curvature"].number, -4 * 3.14159265358979323846, 1e-12);
}

// One ball, which may meet its images along the third vector, in files of every format that has boxes.
TEST(Box, IsThatOfTheFile) {
  struct {
    const char *name, *text;
    double volume;
    int directions;
  } const files[] = {
      {"box.pdb",
       "CRYST1   10.000   12.000    3.000  90.00  90.00  90.00 P 1           1\n"
       "ATOM      1  C   UNK A   1       0.000   0.000   0.000  1.00  0.00           C\n",
       360.0, 1},
      {"skew.pdb",
       "CRYST1   10.000   12.000    3.000  90.00  90.00 120.00 P 1           1\n"
       "ATOM      1  C   UNK A   1       0.000   0.000   0.000  1.00  0.00           C\n",
       360.0 * 0.86602540378443865, 1},
      {"box.gro", "one ball\n    1\n    1UNK      C    1   0.000   0.000   0.000\n   1.00000   1.20000   0.30000\n",
       360.0, 1},
      {"skew.gro",
       "one ball\n    1\n    1UNK      C    1   0.000   0.000   0.000\n"
       "   1.00000   1.20000   0.30000 0 0 0.5 0 0.25 0.125\n",
       360.0, 0},
      {"box.xyz", "1\nLattice=\"10 0 0 5 12 0 1 2 3\" Properties=species:S:1:pos:R:3\nC 0 0 0\n", 360.0, 0},
  };
  for (const auto &file : files) {
    const TemporaryFile written(file.name, file.text);
    const Json found = run_json({"measure", written.path(), "--box", "file"});
    EXPECT_NEAR(found["box_volume"].number, file.volume, 1e-6) << file.name;
    EXPECT_EQ(found["windings"].items.at(0)["directions"].number, file.directions) << file.name;
    EXPECT_EQ(found["box"].items.size(), 9U) << file.name;
    EXPECT_NEAR(found["free_volume"].number, found["box_volume"].number - found["volume"].number, 1e-9);
  }
}

TEST(Box, FollowsTheFrames) {
  const std::string atom = "ATOM      1  C   UNK A   1       0.000   0.000   0.000  1.00  0.00           C\n";
  const std::string frames =
      "CRYST1   10.000   10.000   10.000  90.00  90.00  90.00 P 1           1\nMODEL        1\n" + atom +
      "ENDMDL\nMODEL        2\n" + atom +
      "ENDMDL\nCRYST1   10.000   10.000    3.000  90.00  90.00  90.00 P 1           1\nMODEL        3\n" + atom +
      "ENDMDL\n";
  const TemporaryFile written("frames.pdb", frames);
  const Outcome table = run_program({"measure", written.path(), "--box", "file", "--trajectory", written.path()});
  EXPECT_EQ(table.status, 0) << table.err;
  EXPECT_NE(
      table.out.find("frame,time,step,atoms,area,volume,box_volume,free_volume,mass,density,total_area_m2_per_cm3,"
                     "total_area_m2_per_g,total_volume_fraction,total_volume_cm3_per_g\n"),
      std::string::npos)
      << table.out;
  EXPECT_NE(table.out.find("\n1,"), std::string::npos);
  size_t large = 0, small = 0;
  for (size_t at = 0; (at = table.out.find(",1000,", at)) != std::string::npos; ++at) ++large;
  for (size_t at = 0; (at = table.out.find(",300,", at)) != std::string::npos; ++at) ++small;
  EXPECT_EQ(large, 2U) << table.out;
  EXPECT_EQ(small, 1U) << table.out;
}

TEST(Box, IsRefusedWhereItHasNoMeaning) {
  struct {
    std::vector<std::string> arguments;
    int status;
    const char *says;
  } const calls[] = {
      {{"measure", "good/two.xyzr", "--box", "10,10"}, 2, "--box needs AX,BY,CZ, nine numbers, 'file' or 'p1'"},
      {{"measure", "good/two.xyzr", "--box", "10,10,"}, 2, "--box needs"},
      {{"measure", "good/two.xyzr", "--box", "10,ten,10"}, 2, "'ten' is not a decimal number"},
      {{"measure", "good/two.xyzr", "--box"}, 2, "--box needs"},
      {{"measure", "good/two.xyzr", "--box", "10,10,0"}, 2, "must be larger than 0"},
      {{"measure", "good/two.xyzr", "--box", "10,0,1,0,10,0,10,10,1"}, 1, "the box is flat"},
      {{"measure", "good/two.xyzr", "--box", "9,9,9", "--box", "9,9,9"}, 2, "given twice"},
      {{"measure", "good/two.xyzr", "--box", "9,9,9", "--probe", "1", "--surface", "ses"}, 2, "not for a --box"},
      {{"boundary", "good/two.xyzr", "--box", "9,9,9", "--shells"}, 2, "--shells is not for a --box"},
      {{"voids", "good/two.xyzr", "--box", "9,9,9"}, 2, "unknown option '--box'"},
      {{"measure", "good/two.xyzr", "--box", "file"}, 1, "the file has no box"},
      {{"measure", "good/two.xyzr", "--box", "9,9,0.001"}, 1, "too thin"},
  };
  for (const auto &call : calls) {
    const Outcome outcome = run_program(call.arguments);
    EXPECT_EQ(outcome.status, call.status) << call.says;
    EXPECT_NE(outcome.err.find(call.says), std::string::npos) << outcome.err;
    EXPECT_TRUE(outcome.out.empty()) << outcome.out;
  }
}

}  // namespace
