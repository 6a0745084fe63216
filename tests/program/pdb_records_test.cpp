// Which records of a .pdb file are atoms of their own, and of which element: alternate locations that differ in one
// part of their label alone, and elements where columns 77-78 and the atom name leave room for doubt.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

// The parts of an ATOM record that tell atoms apart, as they stand in their columns.
struct Record {
  const char *name = " CA ";     // columns 13-16
  char letter = ' ';             // 17: alternate location
  const char *residue = "ALA";   // 18-20
  const char *place = "A  52 ";  // 22-27: chain, number, insertion code
  const char *segment = "    ";  // 73-76
  const char *element = " C";    // 77-78
};

// One record after the other, 10 angstrom apart along x.
std::string pdb(const std::vector<Record> &records) {
  std::string text;
  for (size_t i = 0; i < records.size(); ++i) {
    const Record &r = records[i];
    char line[100];
    std::snprintf(line, sizeof line, "ATOM  %5d %4s%c%3s %6s   %8.3f%8.3f%8.3f  1.00  0.00      %4s%2s\n",
                  static_cast<int>(i) + 1, r.name, r.letter, r.residue, r.place, 10.0 * static_cast<double>(i), 0.0,
                  0.0, r.segment, r.element);
    text += line;
  }
  return text;
}

// Which of the records are read, and the element of each.
struct Atoms {
  std::vector<int> records;
  std::vector<std::string> elements;
};

Atoms atoms_of(const std::vector<Record> &records) {
  const TemporaryFile file("records.pdb", pdb(records));
  const Outcome outcome = run_program({"measure", file.path(), "--per-ball", "--csv"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  Atoms atoms;
  std::istringstream lines(outcome.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "ball,atom,element,chain,residue,number,insertion,x,y,z,radius,area");
  while (std::getline(lines, line)) {
    std::vector<std::string> fields;
    std::istringstream parts(line);
    for (std::string part; std::getline(parts, part, ',');) fields.push_back(part);
    if (fields.size() != 12) {
      ADD_FAILURE() << line;
      break;
    }
    atoms.records.push_back(static_cast<int>(std::stod(fields[7]) / 10.0 + 0.5));
    atoms.elements.push_back(fields[2]);
  }
  return atoms;
}

Record with_letter(Record record, char letter) {
  record.letter = letter;
  return record;
}

// Programs go on with five digits past 9999, in the column of the insertion code: in records that are read column by
// column as in those that are read at once.
TEST(PdbRecords, ResidueNumbersOfFiveDigits) {
  for (const char letter : {' ', 'A'}) {
    const char *const places[] = {"B1000 ", "B1000A", "B10000", "B10001", "B 9991", "BA0000", "B-9990"};
    std::vector<Record> records;
    for (const char *place : places) {
      Record record = with_letter({}, letter);
      record.place = place;
      records.push_back(record);
    }
    const TemporaryFile file("numbers.pdb", pdb(records));
    const Outcome outcome = run_program({"measure", file.path(), "--per-ball", "--csv"});
    std::string numbers, line;
    std::istringstream lines(outcome.out);
    for (std::getline(lines, line); std::getline(lines, line);) {
      std::vector<std::string> fields;
      std::istringstream parts(line);
      for (std::string part; std::getline(parts, part, ',');) fields.push_back(part);
      ASSERT_EQ(fields.size(), 12U) << line;
      numbers += fields[5] + "/" + fields[6] + " ";
    }
    EXPECT_EQ(numbers, "1000/ 1000/A 10000/ 10001/ 999/1 A000/0 -999/0 ") << letter;
    const Outcome one = run_program({"measure", file.path(), "--per-ball", "--csv", "--only", "residue:10001"});
    EXPECT_EQ(std::count(one.out.begin(), one.out.end(), '\n'), 2) << one.out;
  }
}

// Two atoms with locations A and B, then B and C: the first of each counts if they differ in any part of their label.
// If a part were left out, the second atom would be an alternate of the first one, which has location A.
TEST(PdbRecords, AlternatesOfAtomsThatDifferInOnePart) {
  Record name, chain, number, insertion, segment;
  name.name = " CB ";
  chain.place = "B  52 ";
  number.place = "A  53 ";
  insertion.place = "A  52A";
  segment.segment = "SEGB";
  for (const Record &other : {name, chain, number, insertion, segment}) {
    const std::string label = std::string(other.name) + other.place + other.segment;
    EXPECT_EQ(atoms_of({with_letter({}, 'A'), with_letter({}, 'B'), with_letter(other, 'B'), with_letter(other, 'C')})
                  .records,
              (std::vector<int>{0, 2}))
        << label;
    // the other way round, and in turn
    EXPECT_EQ(atoms_of({with_letter(other, 'A'), with_letter(other, 'B'), with_letter({}, 'B'), with_letter({}, 'C')})
                  .records,
              (std::vector<int>{0, 2}))
        << label;
    EXPECT_EQ(atoms_of({with_letter({}, 'A'), with_letter(other, 'B'), with_letter({}, 'B'), with_letter(other, 'C')})
                  .records,
              (std::vector<int>{0, 1}))
        << label;
  }
}

// Alternates of one atom in residues of different names: what counts is the location of the residue's first record.
TEST(PdbRecords, AlternatesOfAResidueWithTwoNames) {
  Record serine;
  serine.residue = "SER";
  EXPECT_EQ(atoms_of({with_letter({}, 'A'), with_letter(serine, 'B')}).records, (std::vector<int>{0}));
  Record beta = serine;
  beta.name = " OG ";
  beta.element = " O";
  EXPECT_EQ(atoms_of({with_letter({}, 'A'), with_letter(beta, 'B')}).records, (std::vector<int>{0}));
  beta.segment = "SEGB";
  EXPECT_EQ(atoms_of({with_letter({}, 'A'), with_letter(beta, 'B')}).records, (std::vector<int>{0, 1}));
  beta.segment = serine.segment;
  beta.place = "A  52A";
  EXPECT_EQ(atoms_of({with_letter({}, 'A'), with_letter(beta, 'B')}).records, (std::vector<int>{0, 1}));
}

// The three rules of alternate_locations.h, by a search through all records before.
std::vector<int> kept_by_search(const std::vector<Record> &records) {
  std::vector<int> kept;
  for (size_t i = 0; i < records.size(); ++i) {
    const auto same_residue = [&](const Record &r) {
      return std::string(r.place) + r.segment == std::string(records[i].place) + records[i].segment;
    };
    const auto same_name = [&](const Record &r) { return std::string(r.name) == records[i].name; };
    const auto first_atom =
        std::find_if(records.begin(), records.end(), [&](const Record &r) { return same_residue(r) && same_name(r); });
    const auto first_lettered = std::find_if(records.begin(), records.end(),
                                             [&](const Record &r) { return same_residue(r) && r.letter != ' '; });
    const char letter = records[i].letter;
    const bool keeps =
        letter == ' ' || (first_atom->letter == letter && (std::string(first_lettered->residue) == records[i].residue ||
                                                           first_lettered->letter == letter));
    if (keeps) kept.push_back(static_cast<int>(i));
  }
  return kept;
}

TEST(PdbRecords, AlternatesAmongAtomsWithoutLetters) {
  std::mt19937 random(20);
  const auto one_of = [&](const std::vector<const char *> &texts) { return texts[random() % texts.size()]; };
  int dropped = 0;
  for (int round = 0; round < 60; ++round) {
    std::vector<Record> records;
    Record record;
    for (int i = 0; i < 60; ++i) {
      if (random() % 4 == 0) record.place = one_of({"A  52 ", "A  53 ", "A  52A", "B  52 "});
      if (random() % 8 == 0) record.segment = one_of({"    ", "SEGB"});
      if (random() % 8 == 0) record.residue = one_of({"ALA", "SER"});
      record.name = one_of({" N  ", " CA ", " CB ", " C  "});
      record.letter = "      AB"[random() % 8];
      records.push_back(record);
    }
    const std::vector<int> expected = kept_by_search(records);
    ASSERT_EQ(atoms_of(records).records, expected) << round;
    dropped += static_cast<int>(records.size() - expected.size());
  }
  EXPECT_GT(dropped, 60);
}

std::string element_of(const char *name, const char *element) {
  Record record;
  record.residue = "LIG";  // no residue whose atoms are known
  record.name = name;
  record.element = element;
  const std::vector<std::string> elements = atoms_of({record}).elements;
  return elements.size() == 1 ? elements[0] : "";
}

// Columns 77-78 decide, wherever the symbol stands in them; the name would say calcium, mercury, or nothing.
TEST(PdbRecords, ElementsByTheirColumns) {
  EXPECT_EQ(element_of("CA  ", " C"), "C");
  EXPECT_EQ(element_of("CA  ", "C "), "C");
  EXPECT_EQ(element_of("CA  ", "C1"), "C");  // a charge
  EXPECT_EQ(element_of("HG  ", "H "), "H");
  EXPECT_EQ(element_of("CA  ", "CA"), "Ca");
  EXPECT_EQ(element_of(" CA ", "CA"), "Ca");
  EXPECT_EQ(element_of("1234", "N "), "N");
  EXPECT_EQ(element_of("CA  ", "  "), "Ca");
  EXPECT_EQ(element_of(" CA ", "  "), "C");
}

// Names of four characters that begin with D are deuterium, though dubnium, darmstadtium and dysprosium are elements
// too; likewise with H, which begins hafnium, mercury, holmium, hassium and helium.
TEST(PdbRecords, HydrogensByTheirNames) {
  for (const char *name : {"DB11", "DS12", "DY21", "DD21", "db11", "HF11", "HG11", "HO11", "HS12", "HE21", "HH22"}) {
    EXPECT_EQ(element_of(name, "  "), "H") << name;
  }
  EXPECT_EQ(element_of("HG  ", "  "), "Hg");
  EXPECT_EQ(element_of("CL12", "  "), "Cl");
  EXPECT_EQ(element_of("CAA1", "  "), "C");
}

}  // namespace
