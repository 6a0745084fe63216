// Bonds of ball-and-stick pictures: by CONECT records, by distances, and of records that make no sense.
#include <gtest/gtest.h>

#include <cstdio>
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

}  // namespace
