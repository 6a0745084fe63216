// Names of atoms and residues and what they tell: the element, that an atom is an ion, or that it is none. The cases
// are from the nomenclature of the Protein Data Bank, CHARMM, GROMACS and Amber.
#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <string>
#include <vector>

extern "C" {
#include "read/atom_elements.h"
#include "read/residue_kinds.h"
}

namespace {

// The element, "virtual", "bead" or "unknown".
std::string finding_of(const atom_label &label) {
  if (label.virtual_site) return "virtual";
  if (label.bead) return "bead";
  return label.element.text[0] == '\0' ? "unknown" : label.element.text;
}

residue_label residue_named(const std::string &name) {
  residue_label residue = RESIDUE_LABEL_NONE;
  std::strncpy(residue.name, name.c_str(), sizeof residue.name - 1);
  return residue;
}

std::string found(const std::string &name, const std::string &residue, bool in_columns,
                  const std::string &stated = "") {
  const residue_label of_residue = residue_named(residue);
  atom_label label = ATOM_LABEL_NONE;
  label.residue = &of_residue;
  const atom_evidence evidence = {
      in_columns ? ATOM_COLUMNS : ATOM_NAMES, {name.data(), name.size()}, {stated.data(), stated.size()}};
  EXPECT_TRUE(atom_take_element(&evidence, &label)) << name;
  return finding_of(label);
}

struct Case {
  const char *residue;
  const char *name;  // four columns
  const char *element;
};

// Trailing and leading blanks say nothing without columns.
std::string stripped(const std::string &name) {
  const size_t begin = name.find_first_not_of(' ');
  return begin == std::string::npos ? "" : name.substr(begin, name.find_last_not_of(' ') - begin + 1);
}

// In a known residue it does not matter in which columns a name stands.
TEST(AtomNames, InKnownResidues) {
  for (const Case &it : {
           Case{"MET", "CA  ", "C"},  Case{"ARG", " CA ", "C"},  Case{"LYS", "CE  ", "C"},  Case{"LYS", "NZ  ", "N"},
           Case{"ARG", "NH1 ", "N"},  Case{"LEU", "CD1 ", "C"},  Case{"HIS", "HE2 ", "H"},  Case{"SER", "HG  ", "H"},
           Case{"CYS", "SG  ", "S"},  Case{"CYS", "HG  ", "H"},  Case{"THR", "1HG2", "H"},  Case{"PHE", "2HB ", "H"},
           Case{"hsd", "nd1 ", "N"},  Case{"HSE", "CE1 ", "C"},  Case{"CYX", "CB  ", "C"},  Case{"NALA", "CA  ", "C"},
           Case{"CLYS", "OXT ", "O"}, Case{"GLY", "DA2 ", "H"},  Case{"ALA", "DB1 ", "H"},  Case{"TYR", "DH  ", "H"},
           Case{"MSE", "SE  ", "Se"}, Case{"MSE", "CE  ", "C"},  Case{"SEC", "SE  ", "Se"}, Case{"ACE", "CH3 ", "C"},
           Case{"NME", "HH31", "H"},  Case{"DA", "O5' ", "O"},   Case{"DT", "C7  ", "C"},   Case{"G", "N9  ", "N"},
           Case{"U", "P   ", "P"},    Case{"C", "OP1 ", "O"},    Case{"A", "O1P ", "O"},    Case{"DG5", "HO5'", "H"},
           Case{"URA", "DO2'", "H"},  Case{"DC", "CO3*", "C"},   Case{"HOH", "O   ", "O"},  Case{"SOL", "OW  ", "O"},
           Case{"SOL", "HW1 ", "H"},  Case{"TIP3", "OH2 ", "O"}, Case{"WAT", "1HW ", "H"},  Case{"DOD", "D1  ", "H"},
           Case{"SEP", "P   ", "P"},  Case{"UNK", "CB  ", "C"},  Case{"ASX", "XD1 ", "X"},  Case{"GLX", "AE2 ", "X"},
           Case{"ASN", "AD1 ", "X"},  Case{"ASX", "CA  ", "C"},  Case{"DG", "S2P ", "S"},   Case{"A", " S1P", "S"},
           Case{"DT", "S5' ", "S"},   Case{"U", " S4*", "S"},
       }) {
    EXPECT_EQ(found(it.name, it.residue, true), it.element) << it.residue << " " << it.name;
    EXPECT_EQ(found(stripped(it.name), it.residue, true), it.element) << it.residue << " " << it.name;
    EXPECT_EQ(found(stripped(it.name), it.residue, false), it.element) << it.residue << " " << it.name;
    EXPECT_EQ(found(std::string(" ").append(stripped(it.name)), it.residue, true), it.element)
        << it.residue << " " << it.name;
  }
}

TEST(AtomNames, Ions) {
  for (const Case &it : {
           Case{"NA", " NA ", "Na"},  Case{"NA", "NA  ", "Na"},  Case{"CL", " CL ", "Cl"},  Case{"CL-", "Cl- ", "Cl"},
           Case{"Na+", "Na+ ", "Na"}, Case{"CLA", " CLA", "Cl"}, Case{"POT", " POT", "K"},  Case{"SOD", "SOD ", "Na"},
           Case{"CAL", "CAL ", "Ca"}, Case{"CES", "CES ", "Cs"}, Case{"CA", " CA ", "Ca"},  Case{"ca", " Ca ", "Ca"},
           Case{"K", " K  ", "K"},    Case{"MG", "MG  ", "Mg"},  Case{"ZN2", "ZN  ", "Zn"}, Case{"ZN", "ZN2+", "Zn"},
           Case{"FE2", "FE  ", "Fe"}, Case{"3CO", "CO  ", "Co"}, Case{"ION", "NA  ", "Na"}, Case{"ION", "CLA ", "Cl"},
           Case{"LIT", "LIT ", "Li"}, Case{"CD", " CD ", "Cd"},  Case{"HG", " HG ", "Hg"},  Case{"U1", " U  ", "U"},
       }) {
    EXPECT_EQ(found(it.name, it.residue, true), it.element) << it.residue << " " << it.name;
    EXPECT_EQ(found(stripped(it.name), it.residue, false), it.element) << it.residue << " " << it.name;
  }
  // Chlorophyll is CLA too, and no atom of it has that name; nor is an alpha carbon calcium because of its ligand.
  EXPECT_EQ(found("MG  ", "CLA", true), "Mg");
  EXPECT_EQ(found(" CHA", "CLA", true), "C");
  EXPECT_EQ(found(" CA ", "CAL", true), "C");
}

TEST(AtomNames, VirtualSites) {
  for (const Case &it : {
           Case{"SOL", "MW  ", "virtual"},
           Case{"HOH", " M  ", "virtual"},
           Case{"WAT", "EPW ", "virtual"},
           Case{"WAT", "EP1 ", "virtual"},
           Case{"TIP4", " OM ", "virtual"},
           Case{"TP5", "LP1 ", "virtual"},
           Case{"SWM4", "DOH2", "virtual"},
           Case{"SWM4", "LP  ", "virtual"},
           Case{"LYS", "DNZ ", "virtual"},
           Case{"ALA", "DCA ", "virtual"},
           Case{"GLY", "DO  ", "virtual"},
           Case{"VAL", "QG1 ", "virtual"},
           Case{"ALA", "MCB1", "virtual"},
           Case{"LIG", "LP1 ", "virtual"},
           Case{"LIG", "EP  ", "virtual"},
       }) {
    EXPECT_EQ(found(it.name, it.residue, true), it.element) << it.residue << " " << it.name;
    EXPECT_EQ(found(stripped(it.name), it.residue, false), it.element) << it.residue << " " << it.name;
  }
}

// Amino acids and nucleotides have no boron, and most of them no sulfur: coarse-grained models call beads so.
TEST(AtomNames, Beads) {
  for (const Case &it : {
           Case{"ALA", " BB ", "bead"}, Case{"LYS", " SC1", "bead"}, Case{"TRP", " SC5", "bead"},
           Case{"CYS", " BB ", "bead"}, Case{"CYS", " SC1", "bead"}, Case{"NALA", "BB  ", "bead"},
           Case{"DA", " BB1", "bead"},  Case{"DG", " SC4", "bead"},  Case{"SER", " SG ", "bead"},
           Case{"DA", " S1 ", "bead"},  Case{"DA", " S1B", "bead"},  Case{"SER", " S1P", "bead"},
           Case{"NCYS", " SG ", "S"},   Case{"CMET", " SD ", "S"},   Case{"CYX", " SG ", "S"},
           Case{"CSO", " SG ", "S"},    Case{"UNK", " SG ", "S"},    Case{"LIG", " SC1", "S"},
           Case{"LIG", " B1 ", "B"},
       }) {
    EXPECT_EQ(found(it.name, it.residue, true), it.element) << it.residue << " " << it.name;
    EXPECT_EQ(found(stripped(it.name), it.residue, false), it.element) << it.residue << " " << it.name;
  }
}

// Elsewhere columns tell calcium from carbon; without columns carbon is the better guess.
TEST(AtomNames, InOtherResidues) {
  EXPECT_EQ(found("CA  ", "LIG", true), "Ca");
  EXPECT_EQ(found(" CA ", "LIG", true), "C");
  EXPECT_EQ(found("CA", "LIG", false), "C");
  EXPECT_EQ(found(" Ar ", "LIG", true), "Ar");
  EXPECT_EQ(found(" Cl1", "LIG", true), "Cl");
  EXPECT_EQ(found(" Oxt", "LIG", true), "O");
  EXPECT_EQ(found(" Ca ", "ALA", true), "C");
  EXPECT_EQ(found(" Zy ", "LIG", true), "Z");
  EXPECT_EQ(found("CL1 ", "LIG", true), "Cl");
  EXPECT_EQ(found("CL1", "LIG", false), "Cl");
  EXPECT_EQ(found("Br2", "LIG", false), "Br");
  EXPECT_EQ(found("FE  ", "HEM", true), "Fe");
  EXPECT_EQ(found("FE", "HEM", false), "Fe");
  EXPECT_EQ(found("HG11", "LIG", true), "H");
  EXPECT_EQ(found("HG", "LIG", false), "H");
  EXPECT_EQ(found("D2", "LIG", false), "H");
  EXPECT_EQ(found("LI1", "XYZ", false), "Li");
  EXPECT_EQ(found("GA", "XYZ", false), "Ga");
  EXPECT_EQ(found("123", "LIG", false), "unknown");
  EXPECT_EQ(found("", "LIG", false), "unknown");
  EXPECT_EQ(found("    ", "ALA", true), "unknown");
  EXPECT_EQ(found("A1", "LIG", false), "unknown");
}

// The table is searched by halves: every name must be found, and no other.
TEST(AtomNames, KindsOfResidues) {
  const auto all = [](const std::vector<const char *> &names, residue_kind kind) {
    for (const char *name : names) EXPECT_EQ(residue_kind_of(name), kind) << name;
  };
  all({"ALA", "ARG", "ASN", "ASP", "CYS",  "GLN",  "GLU",  "GLY",  "HIS", "ILE", "LEU", "LYS",
       "MET", "PHE", "PRO", "SER", "THR",  "TRP",  "TYR",  "VAL",  "HID", "HIE", "HIP", "HSD",
       "HSE", "HSP", "CYX", "CYM", "ALAD", "ASH",  "GLH",  "LYN",  "MSE", "SEC", "ACE", "NME",
       "NMA", "NH2", "UNK", "ala", "NGLY", "CPRO", "LYSH", "HISE", "TYM", "TPO", "PCA"},
      RESIDUE_AMINO_ACID);
  all({"A",  "C",  "G",   "U",   "T",   "I",   "DA",  "DC",  "DG",  "DT",  "DU", "DI", "RA", "RC",
       "RG", "RU", "ADE", "CYT", "GUA", "THY", "URA", "DA5", "DT3", "RU3", "G5", "U3", "DGN"},
      RESIDUE_NUCLEOTIDE);
  all({"HOH", "WAT", "H2O", "D2O", "DOD", "SOL", "TIP", "TIP2", "TIP3", "TIP4", "TIP5",
       "TP3", "TP4", "TP5", "T3P", "T4P", "T5P", "SPC", "SPCE", "OPC",  "SWM4", "hoh"},
      RESIDUE_WATER);
  all({"", "HEM", "LIG", "CLA", "NAG", "ALAX", "AL", "ZZZ", "0AA", "NLIG", "XALA", "NALAA"}, RESIDUE_OTHER);
}

// Names that were found before are found again after any others.
TEST(AtomNames, FoundAgain) {
  static const char *const residues[] = {"ALA", "GLY", "HOH", "SOL",  "MSE", "CYS",  "DA",  "NAG",
                                         "",    "SOD", "CLA", "NALA", "LIG", "TIP3", "ala", "ALAX"};
  elements_seen seen = {};
  std::mt19937 random(12);
  for (int round = 0; round < 60000; ++round) {
    std::string name;
    for (size_t i = 0, length = random() % 5; i < length; ++i) name += "CHNOSABDMEP1X2'cL"[random() % 17];
    if (round % 50 == 0) name = residues[random() % 16];
    const std::string residue = residues[random() % 16];
    const residue_label of_residue = residue_named(residue);
    atom_label label = ATOM_LABEL_NONE;
    label.residue = &of_residue;
    const std::string behind = name + "CA      ";
    atom_take_element_again(&seen, {behind.data(), name.size()}, &label);
    ASSERT_EQ(finding_of(label), found(name, residue, false)) << residue << ' ' << name;
    ASSERT_EQ(&of_residue, label.residue);
  }
}

TEST(AtomNames, SymbolsThatNoElementHas) {
  for (const char *text : {"EP", "Lp", "m", "MW", "Du", "DU"}) EXPECT_EQ(found("C1", "LIG", false, text), "virtual");
  EXPECT_EQ(found("C1", "LIG", false, "X"), "X");
  for (const char *text : {"Er", "Mn", "Lu", "Xx"}) EXPECT_EQ(found("C1", "LIG", false, text), text);
}

}  // namespace
