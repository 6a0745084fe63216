// Every atom the same element in every file: names, labels, symbols and types in all formats that they can stand in, as
// the Protein Data Bank, CHARMM, Amber, GROMACS, SYBYL, AutoDock and the crystallographers' dictionary have them.
#include <gtest/gtest.h>

#include <cctype>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

extern "C" {
#include "read/read_molecule.h"
}

namespace {

using Words = std::vector<std::string>;

std::string text(const char *format, ...) __attribute__((format(printf, 1, 2)));
std::string text(const char *format, ...) {
  char line[200];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  return line;
}

// An atom as a row of a table: with its residue or without, and what the file states of it.
struct Atom {
  std::string residue;
  std::string name;
  std::string element;        // "-": it is none, and is left out
  std::string stated = "";    // a symbol or type
  std::string column13 = "";  // the element of a name that begins there, if another one
};

// A file of a format with atoms far apart, each a residue of its own.
using Writer = std::string(const std::vector<Atom> &);

std::string pdb_records(const std::vector<Atom> &atoms, size_t first_column, bool autodock = false) {
  std::string out;
  int number = 0;
  for (const Atom &atom : atoms) {
    const std::string name = std::string(first_column - 13, ' ') + atom.name;
    ++number;
    out += text("HETATM%5d %-4.4s %3s A%4d    %8.3f%8.3f%8.3f  1.00  0.00    ", number, name.c_str(),
                atom.residue.c_str(), number, 9.0 * (number % 50), 9.0 * (number / 50), 0.0);
    out += autodock ? text("%6.3f %-2s\n", 0.1, atom.stated.c_str()) : text("      %2s\n", atom.stated.c_str());
  }
  return out;
}

std::string in_column_13(const std::vector<Atom> &atoms) {
  return pdb_records(atoms, 13);
}
std::string in_column_14(const std::vector<Atom> &atoms) {
  return pdb_records(atoms, 14);
}
std::string as_pdbqt(const std::vector<Atom> &atoms) {
  return "ROOT\n" + pdb_records(atoms, 14, true) + "ENDROOT\nTORSDOF 0\n";
}

std::string as_gro(const std::vector<Atom> &atoms) {
  std::string out = text("names\n%5d\n", static_cast<int>(atoms.size()));
  int number = 0;
  for (const Atom &atom : atoms) {
    ++number;
    out += text("%5d%-5s%5s%5d%8.3f%8.3f%8.3f\n", number, atom.residue.c_str(), atom.name.c_str(), number,
                0.9 * (number % 50), 0.9 * (number / 50), 0.0);
  }
  return out + "   9.0 9.0 9.0\n";
}

std::string as_pqr(const std::vector<Atom> &atoms) {
  std::string out;
  int number = 0;
  for (const Atom &atom : atoms) {
    ++number;
    out += text("ATOM %d %s %s %d %d %d 0 0.5 1.5 %s\n", number, atom.name.c_str(), atom.residue.c_str(), number,
                9 * (number % 50), 9 * (number / 50), atom.stated.c_str());
  }
  return out;
}

std::string as_mol2(const std::vector<Atom> &atoms) {
  std::string out =
      text("@<TRIPOS>MOLECULE\nx\n%d 0\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n", static_cast<int>(atoms.size()));
  int number = 0;
  for (const Atom &atom : atoms) {
    ++number;
    out += text("%d %s %d.0 %d.0 0.0 %s %d %s 0.0\n", number, atom.name.c_str(), 9 * (number % 50), 9 * (number / 50),
                atom.stated.empty() ? "1" : atom.stated.c_str(), number,
                atom.residue.empty() ? "<0>" : atom.residue.c_str());
  }
  return out;
}

std::string as_mmcif(const std::vector<Atom> &atoms) {
  std::string out =
      "data_x\nloop_\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.label_seq_id\n"
      "_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
  int number = 0;
  for (const Atom &atom : atoms) {
    ++number;
    out += text("\"%s\" %s %d %s %d %d 0\n", atom.name.c_str(), atom.residue.empty() ? "." : atom.residue.c_str(),
                number, atom.stated.empty() ? "?" : atom.stated.c_str(), 9 * (number % 50), 9 * (number / 50));
  }
  return out;
}

std::string as_sites(const std::vector<Atom> &atoms, const std::string &coordinates, bool symbols) {
  std::string out = "data_x\n";
  for (const char *edge : {"a", "b", "c"}) out += text("_cell_length_%s 1000\n", edge);
  for (const char *angle : {"alpha", "beta", "gamma"}) out += text("_cell_angle_%s 90\n", angle);
  out += "loop_\n_atom_site_label\n";
  if (symbols) out += "_atom_site_type_symbol\n";
  for (const char *axis : {"x", "y", "z"}) out += "_atom_site_" + coordinates + "_" + axis + "\n";
  int number = 0;
  for (const Atom &atom : atoms) {
    ++number;
    const double scale = coordinates == "fract" ? 0.009 : 9.0;
    const std::string symbol = !symbols ? "" : atom.stated.empty() ? " ?" : " " + atom.stated;
    out += text("%s%s %.3f %.3f 0\n", atom.name.c_str(), symbol.c_str(), scale * (number % 50), scale * (number / 50));
  }
  return out;
}

std::string as_fractions(const std::vector<Atom> &atoms) {
  return as_sites(atoms, "fract", true);
}
std::string as_cartesian(const std::vector<Atom> &atoms) {
  return as_sites(atoms, "Cartn", true);
}
std::string as_fractions_alone(const std::vector<Atom> &atoms) {
  return as_sites(atoms, "fract", false);
}
std::string as_cartesian_alone(const std::vector<Atom> &atoms) {
  return as_sites(atoms, "Cartn", false);
}

std::string as_xyz(const std::vector<Atom> &atoms) {
  std::string out = text("%d\n\n", static_cast<int>(atoms.size()));
  int number = 0;
  for (const Atom &atom : atoms) {
    ++number;
    out += text("%s %d %d 0\n", atom.stated.c_str(), 9 * (number % 50), 9 * (number / 50));
  }
  return out;
}

std::string as_sdf(const std::vector<Atom> &atoms) {
  std::string out = text("x\n\n\n%3d  0  0  0  0  0  0  0  0  0999 V2000\n", static_cast<int>(atoms.size()));
  int number = 0;
  for (const Atom &atom : atoms) {
    ++number;
    out += text("%10.4f%10.4f%10.4f %-3s 0  0\n", 9.0 * (number % 50), 9.0 * (number / 50), 0.5, atom.stated.c_str());
  }
  return out + "M  END\n";
}

std::string as_v3000(const std::vector<Atom> &atoms) {
  std::string out = text(
      "x\n\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS %d 0 0 0 0\nM  V30 BEGIN "
      "ATOM\n",
      static_cast<int>(atoms.size()));
  int number = 0;
  for (const Atom &atom : atoms) {
    ++number;
    out += text("M  V30 %d %s %d %d 0.5 0\n", number, atom.stated.c_str(), 9 * (number % 50), 9 * (number / 50));
  }
  return out + "M  V30 END ATOM\nM  V30 END CTAB\nM  END\n";
}

struct Format {
  const char *what;
  const char *extension;
  Writer *write;
};

// The column `element` of the program's table of all balls; what it said on stderr.
Words elements_of(const std::string &contents, const char *extension, std::string *said = nullptr) {
  const TemporaryFile file(std::string("names.") + extension, contents);
  const Outcome outcome = run_program({"measure", file.path(), "--per-ball", "--csv"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  if (said != nullptr) *said = outcome.err;
  Words elements;
  for (size_t at = outcome.out.find('\n'); at != std::string::npos && at + 1 < outcome.out.size();) {
    const size_t end = outcome.out.find('\n', at + 1);
    const std::string line = outcome.out.substr(at + 1, end - at - 1);
    // ball, atom and element; formats without names have the element alone
    const size_t first = line.find(','), second = line.find(',', first + 1);
    const std::string header = outcome.out.substr(0, outcome.out.find('\n'));
    const bool named = header.find(",atom,") != std::string::npos;
    elements.push_back(named ? line.substr(second + 1, line.find(',', second + 1) - second - 1)
                             : line.substr(first + 1, second - first - 1));
    at = end;
  }
  return elements;
}

// The same of a .pqr file, whose elements no table has: the file states radii, and what it calls an atom is a ball.
Words elements_of_pqr(const std::string &contents) {
  const TemporaryFile file("names.pqr", contents);
  failure why = {};
  molecule atoms;
  Words elements;
  const file_choice first = FILE_CHOICE_FIRST;
  EXPECT_TRUE(
      read_molecule(file.path().c_str(), file_format_of(file.path().c_str(), &why), &first, KEEP_NO_MORE, &atoms, &why))
      << why.reason;
  for (uint32_t i = 0; i < atoms.atoms; ++i) elements.emplace_back(atoms.label[i].element.text);
  molecule_free(&atoms);
  return elements;
}

// Each atom is what the table says in each of the formats. Those that are none are left out, and a line says so.
void expect_elements(const std::vector<Atom> &all, const std::vector<Format> &formats) {
  for (const Format &format : formats) {
    std::string said;
    std::vector<Atom> atoms = all;
    // In .mol2 digits at the end are the residue's number.
    if (format.write == as_mol2)
      std::erase_if(atoms, [](const Atom &atom) { return atom.residue == "B12" || atom.residue == "F43"; });
    const bool radii = format.write == as_pqr;
    const Words found =
        radii ? elements_of_pqr(as_pqr(atoms)) : elements_of(format.write(atoms), format.extension, &said);
    size_t at = 0, dummies = 0;
    for (const Atom &atom : atoms) {
      if (atom.element == "-" && !radii) {
        ++dummies;
        continue;
      }
      const bool other = !atom.column13.empty() && format.write == in_column_13;
      const std::string expected = other ? atom.column13 : atom.element == "-" ? "" : atom.element;
      EXPECT_EQ(at < found.size() ? found[at] : "nothing", expected)
          << format.what << ": " << atom.residue << ' ' << atom.name << ' ' << atom.stated;
      ++at;
    }
    EXPECT_EQ(found.size(), at) << format.what;
    const std::string counted =
        std::to_string(dummies) + (dummies == 1 ? " dummy or virtual site is left out: it is no atom"
                                                : " dummies or virtual sites are left out: they are no atoms");
    EXPECT_EQ(said.find(counted) != std::string::npos, dummies > 0) << format.what << ": " << said;
  }
}

const Format pdb_13 = {"column 13", "pdb", in_column_13}, pdb_14 = {"column 14", "pdb", in_column_14},
             gro = {"gro", "gro", as_gro}, mmcif = {"mmCIF", "cif", as_mmcif}, pqr = {"pqr", "pqr", as_pqr},
             mol2 = {"mol2", "mol2", as_mol2}, pdbqt = {"pdbqt", "pdbqt", as_pdbqt}, xyz = {"xyz", "xyz", as_xyz},
             sdf = {"V2000", "sdf", as_sdf}, v3000 = {"V3000", "mol", as_v3000},
             fractions = {"fractions", "cif", as_fractions}, cartesian = {"Cartesian", "cif", as_cartesian},
             fractions_alone = {"fractions alone", "cif", as_fractions_alone},
             cartesian_alone = {"Cartesian alone", "cif", as_cartesian_alone};

// ---- names of macromolecules ----

TEST(Elements, OfNamesWithoutSymbols) {
  expect_elements(
      {
          // Metals of cofactors and clusters, with the atoms around them that other metals could be.
          {"HEM", "FE", "Fe"},
          {"HEM", "NA", "N"},
          {"HEM", "NB", "N"},
          {"HEM", "NC", "N"},
          {"HEM", "ND", "N"},
          {"HEM", "CHA", "C"},
          {"HEM", "HHB", "H"},
          {"HEC", "FE", "Fe"},
          {"HEA", "FE", "Fe"},
          {"HEB", "FE", "Fe"},
          {"B12", "CO", "Co"},
          {"CNC", "CO", "Co"},
          {"COB", "CO", "Co"},
          {"NCO", "CO", "Co"},
          {"B12", "CM1", "C"},
          {"B12", "P", "P"},
          {"CUA", "CU", "Cu"},
          {"CUA", "CU1", "Cu"},
          {"C2O", "CU2", "Cu"},
          {"CUZ", "CU4", "Cu"},
          {"CLA", "MG", "Mg"},
          {"BCL", "MG", "Mg"},
          {"CHL", "MG", "Mg"},
          {"CLA", "NA", "N"},
          {"CLA", "CHA", "C"},
          {"OEX", "MN1", "Mn"},
          {"OEX", "MN4", "Mn"},
          {"OEX", "CA1", "Ca"},
          {"OEX", "O5", "O"},
          {"OEC", "MN", "Mn"},
          {"F43", "NI", "Ni"},
          {"HNI", "NI", "Ni"},
          {"NFU", "NI", "Ni"},
          {"NFU", "FE", "Fe"},
          {"SF4", "FE1", "Fe"},
          {"SF4", "S1", "S"},
          {"CFN", "MO1", "Mo"},
          {"CFN", "FE7", "Fe"},
          {"MMC", "HG", "Hg"},
          {"EMC", "HG", "Hg"},
          {"OHX", "OS", "Os"},
          {"OHX", "N1", "N"},
          {"CPT", "PT1", "Pt"},
          {"BEF", "BE", "Be"},
          {"BEF", "F1", "F"},
          {"ALF", "AL", "Al"},
          {"CAC", "AS", "As"},
          {"MOO", "MO", "Mo"},
          {"VO4", "V", "V"},
          {"WO4", "W", "W"},
          // Others where two letters can be nothing else.
          {"LIG", "BR", "Br"},
          {"LIG", "BR1", "Br"},
          {"LIG", "CL", "Cl"},
          {"LIG", "CL1", "Cl"},
          {"LIG", "SI", "Si"},
          {"LIG", "SI1", "Si"},
          {"LIG", "PT", "Pt"},
          {"LIG", "CU", "Cu"},
          {"LIG", "ZN", "Zn"},
          {"LIG", "SE", "Se"},
          {"LIG", "AS", "As"},
          {"LIG", "AU1", "Au"},
          {"LIG", "AG", "Ag"},
          {"LIG", "RU", "Ru"},
          {"LIG", "RH1", "Rh"},
          {"LIG", "RE", "Re"},
          {"LIG", "IR", "Ir"},
          {"LIG", "GD", "Gd"},
          {"LIG", "TE", "Te"},
          {"LIG", "TI", "Ti"},
          {"LIG", "LI", "Li"},
          {"LIG", "GA", "Ga"},
          {"LIG", "ZR", "Zr"},
          {"LIG", "YB", "Yb"},
          {"LIG", "KR", "Kr"},
          {"UNK", "CL1", "Cl"},
          {"UNK", "BR", "Br"},
          {"UNK", "FE", "Fe"},
          {"UNK", "CB", "C"},
          {"UNK", "SG", "S"},
          // And where they are the usual name of an atom.
          {"LIG", "C1", "C"},
          {"LIG", "N1", "N"},
          {"LIG", "O2", "O"},
          {"LIG", "S1", "S"},
          {"LIG", "P1", "P"},
          {"LIG", "F3", "F"},
          {"LIG", "I1", "I"},
          {"LIG", "B1", "B"},
          {"LIG", "H1", "H"},
          {"LIG", "D2", "H"},
          {"LIG", "CA", "C", "", "Ca"},
          {"LIG", "CD", "C", "", "Cd"},
          {"LIG", "CO", "C", "", "Co"},
          {"LIG", "CS", "C", "", "Cs"},
          {"LIG", "NB", "N", "", "Nb"},
          {"LIG", "NA", "N", "", "Na"},
          {"LIG", "HG", "H", "", "Hg"},
          {"LIG", "HO", "H", "", "Ho"},
          {"LIG", "OS", "O", "", "Os"},
          {"ATP", "PB", "P", "", "Pb"},
          {"LIG", "SB", "S", "", "Sb"},
          {"LIG", "PA", "P", "", "Pa"},
          // Residues and ions.
          {"GLY", "CA", "C"},
          {"LYS", "CD", "C"},
          {"LYS", "CE", "C"},
          {"TRP", "CH2", "C"},
          {"ARG", "NE", "N"},
          {"HIS", "ND1", "N"},
          {"SER", "HG", "H"},
          {"TYR", "HE1", "H"},
          {"CYS", "SG", "S"},
          {"MSE", "SE", "Se"},
          {"DA", "P", "P"},
          {"G", "N9", "N"},
          {"HOH", "O", "O"},
          {"SOL", "OW", "O"},
          {"SOL", "HW1", "H"},
          {"DOD", "D1", "H"},
          {"NA", "NA", "Na"},
          {"CA", "CA", "Ca"},
          {"CL", "CL", "Cl"},
          {"CLA", "CLA", "Cl"},
          {"SOD", "SOD", "Na"},
          {"POT", "POT", "K"},
          {"CAL", "CAL", "Ca"},
          {"CES", "CES", "Cs"},
          {"K", "K", "K"},
          {"ZN", "ZN", "Zn"},
          {"FE2", "FE", "Fe"},
          {"CD", "CD", "Cd"},
          {"HG", "HG", "Hg"},
          {"CO", "CO", "Co"},
          {"NI", "NI", "Ni"},
          {"CU", "CU", "Cu"},
          {"MN", "MN", "Mn"},
          {"SM", "SM", "Sm"},
          {"HO3", "HO", "Ho"},
          {"PB", "PB", "Pb"},
          {"BA", "BA", "Ba"},
          {"ION", "CS", "Cs"},
          // Mixed case is as good as a symbol.
          {"LIG", "Cl1", "Cl"},
          {"LIG", "Br2", "Br"},
          {"LIG", "Co", "Co"},
          {"LIG", "Cd1", "Cd"},
          {"GLY", "Ca", "C"},
          // Dummies and virtual sites; the zinc among them is none.
          {"ZNM", "ZN", "Zn"},
          {"ZNM", "DM1", "-"},
          {"ZNM", "DM6", "-"},
          {"LIG", "DU", "-"},
          {"LIG", "DU1", "-"},
          {"LIG", "DUM", "-"},
          {"DUM", "N", "-"},
          {"DUM", "O", "-"},
          {"DUM", "DU", "-"},
          {"LIG", "EP", "-"},
          {"LIG", "LP1", "-"},
          {"SOL", "MW", "-"},
          {"LIG", "MW1", "-"},
          {"WAT", "EPW", "-"},
          {"LIG", "EP2", "-"},
      },
      {pdb_13, pdb_14, gro, mmcif, pqr, mol2, pdbqt});
}

// A carbon of three letters begins in column 14; in 13 it would be chlorine.
TEST(Elements, OfCarbonsWithLetters) {
  std::vector<Atom> atoms;
  for (const char *name : {"CLA", "CLB", "CLC", "CLD", "CLE", "CLF", "CLG", "CLP"}) atoms.push_back({"LIP", name, "C"});
  for (const char *name : {"CL", "CLP", "CR", "CRP", "CB"}) atoms.push_back({"ALAD", name, "C"});
  atoms.push_back({"CLA", "CLA", "Cl"});
  expect_elements(atoms, {gro, mmcif, pqr, mol2});
  for (Atom &atom : atoms) atom.residue = atom.residue.substr(0, 3);
  atoms.resize(8);
  expect_elements(atoms, {pdb_14, gro, mmcif, pqr, mol2, pdbqt});
}

TEST(Elements, OfFourLetters) {
  expect_elements({{"LIG", "CLAA", "Cl"},
                   {"LIG", "BRAB", "Br"},
                   {"LIG", "CAA1", "C"},
                   {"LIG", "CL12", "Cl"},
                   {"LIG", "HG11", "H"},
                   {"LIG", "FE12", "Fe"},
                   {"LIG", "1HB2", "H"},
                   {"HEM", "HHA1", "H"},
                   {"LIG", "CLA1", "C"},
                   {"LIG", "SIAA", "Si"}},
                  {pdb_13, gro, mmcif, pqr, mol2});
}

// CL alone is chlorine, unless the residue shows that its letters say left and right.
TEST(Elements, OfAResidueThatTells) {
  const auto gro_of = [](const Words &names) {
    std::string out = text("x\n%5d\n", static_cast<int>(names.size()));
    for (size_t i = 0; i < names.size(); ++i)
      out +=
          text("%5d%-5s%5s%5d%8.3f%8.3f%8.3f\n", 1, "LIG", names[i].c_str(), 1, 0.9 * static_cast<double>(i), 0.0, 0.0);
    return out + "9 9 9\n";
  };
  EXPECT_EQ(elements_of(gro_of({"CL", "HL1", "HL2", "NL"}), "gro"), (Words{"C", "H", "H", "N"}));
  EXPECT_EQ(elements_of(gro_of({"CLP", "OL", "CL"}), "gro"), (Words{"C", "O", "C"}));
  EXPECT_EQ(elements_of(gro_of({"BR", "CL"}), "gro"), (Words{"Br", "Cl"}));
  EXPECT_EQ(elements_of(gro_of({"CL1", "HL1", "CL"}), "gro"), (Words{"Cl", "H", "C"}));
  // A stated symbol is not touched.
  std::string stated;
  for (const Words &row : {Words{"CL ", "CL", "0"}, Words{"HL1", " H", "9"}}) {
    stated += "HETATM    1  " + row[0] + " LIG A   1       0.000   0.000   " + row[2] + ".000  1.00  0.00          " +
              row[1] + "\n";
  }
  EXPECT_EQ(elements_of(stated, "pdb"), (Words{"Cl", "H"}));
}

// ---- labels of crystals ----

TEST(Elements, OfLabels) {
  const std::vector<Atom> atoms = {
      {"", "Co1", "Co"}, {"", "Cu1", "Cu"}, {"", "Cd1", "Cd"},  {"", "Cr1", "Cr"},  {"", "Ca1", "Ca"},
      {"", "Ni1", "Ni"}, {"", "Nb2", "Nb"}, {"", "Na1", "Na"},  {"", "Si1", "Si"},  {"", "Sc3", "Sc"},
      {"", "Hg1", "Hg"}, {"", "Ho1", "Ho"}, {"", "Pb2", "Pb"},  {"", "In1", "In"},  {"", "Ir1", "Ir"},
      {"", "Os1", "Os"}, {"", "C1", "C"},   {"", "C12A", "C"},  {"", "N2", "N"},    {"", "O1W", "O"},
      {"", "H1A", "H"},  {"", "Zn1", "Zn"}, {"", "Cl1A", "Cl"}, {"", "S1", "S"},    {"", "Ow1", "O"},
      {"", "Ow", "O"},   {"", "OW2", "O"},  {"", "Hw", "H"},    {"", "Hw1", "H"},   {"", "HW1", "H"},
      {"", "Dw", "H"},   {"", "D1", "H"},   {"", "Wat1", "O"},  {"", "WatOW", "O"}, {"", "WAT", "O"},
      {"", "Oa1", "O"},  {"", "Ob", "O"},   {"", "Hn1", "H"},   {"", "Hc2", "H"},   {"", "Cb1", "C"},
      {"", "CL1", "Cl"}, {"", "BR2", "Br"}, {"", "FE1", "Fe"},  {"", "ZN1", "Zn"},  {"", "SI4", "Si"},
      {"", "W1", "W"},   {"", "K1", "K"},   {"", "Du1", "-"},   {"", "Fe3+", "Fe"}, {"", "U1", "U"},
      {"", "V2", "V"},   {"", "La1", "La"}};
  expect_elements(atoms, {fractions, cartesian, fractions_alone, cartesian_alone});
  // Names of macromolecules are none, whatever the coordinates.
  std::string named = as_fractions_alone({{"", "CA", "C"}, {"", "CD", "C"}, {"", "NE", "N"}});
  named.replace(named.find("_atom_site_label"), std::strlen("_atom_site_label"), "_atom_site.label_atom_id");
  EXPECT_EQ(elements_of(named, "cif"), (Words{"C", "C", "N"}));
  for (const char *label : {"CO1", "NI1", "CA1", "Kk", "max", "T1", "M1", "Xx", "1C", "CLA"}) {
    for (Writer *const write : {as_fractions, as_cartesian_alone}) {
      const TemporaryFile file("label.cif", write({{"", label, "", ""}}));
      const Outcome outcome = run_program({"measure", file.path()});
      EXPECT_EQ(outcome.status, 1) << label;
      EXPECT_NE(
          outcome.err.find("no type_symbol, and the label '" + std::string(label) + "' does not tell the element"),
          std::string::npos)
          << outcome.err;
    }
  }
}

// ---- stated symbols ----

// All elements there are, deuterium and tritium, whatever the name beside them.
TEST(Elements, OfSymbols) {
  std::vector<Atom> atoms;
  for (const char *symbol :
       {"H",  "He", "Li", "Be", "B",  "C",  "N",  "O",  "F",  "Ne", "Na", "Mg", "Al", "Si", "P",  "S",
        "Cl", "Ar", "K",  "Ca", "Sc", "Ti", "V",  "Cr", "Mn", "Fe", "Co", "Ni", "Cu", "Zn", "Ga", "Ge",
        "As", "Se", "Br", "Kr", "Rb", "Sr", "Y",  "Zr", "Nb", "Mo", "Tc", "Ru", "Rh", "Pd", "Ag", "Cd",
        "In", "Sn", "Sb", "Te", "I",  "Xe", "Cs", "Ba", "La", "Ce", "Pr", "Nd", "Pm", "Sm", "Eu", "Gd",
        "Tb", "Dy", "Ho", "Er", "Tm", "Yb", "Lu", "Hf", "Ta", "Re", "Os", "Ir", "Pt", "Au", "Hg", "Tl",
        "Pb", "Bi", "Po", "At", "Rn", "Fr", "Ra", "Ac", "Th", "Pa", "U",  "Np", "Pu", "Am", "Cm"}) {
    atoms.push_back({"LIG", "Q9", symbol, symbol});
  }
  for (const char *symbol : {"D", "T"}) atoms.push_back({"LIG", "Q9", "H", symbol});
  expect_elements(atoms, {pdb_14, mmcif, fractions, cartesian, xyz, sdf, v3000, mol2, pqr, pdbqt});
  expect_elements({{"LIG", "Q9", "W", "W"}}, {pdb_14, mmcif, fractions, xyz, sdf, v3000, mol2, pqr});
  // A symbol counts before the name, and an unknown atom stays one.
  expect_elements(
      {{"HEM", "FE", "C", "C"}, {"GLY", "CA", "Ca", "Ca"}, {"UNX", "UNK", "X", "X"}, {"CLA", "CLA", "C", "C"}},
      {pdb_14, mmcif});
}

TEST(Elements, OfDummiesByTheirSymbols) {
  std::vector<Atom> atoms = {{"LIG", "C1", "C", "C"}};
  for (const char *symbol : {"Du", "EP", "LP", "MW", "X"}) atoms.push_back({"LIG", "C2", "-", symbol});
  expect_elements(atoms, {xyz, sdf, v3000, mol2});
  for (const char *symbol : {"A", "Q", "L", "*", "R", "R#", "M", "Pol"}) atoms.push_back({"LIG", "C2", "-", symbol});
  expect_elements(atoms, {sdf, v3000, mol2});
  for (const char *symbol : {"R1", "AH", "Mod"}) atoms.push_back({"LIG", "C2", "-", symbol});
  expect_elements(atoms, {sdf, v3000});
  std::vector<Atom> stated = {{"LIG", "C1", "C", "C"}, {"DUM", "N", "-", "N"}, {"dum", "O", "-", "O"}};
  expect_elements(stated, {pdb_14, mmcif});
  for (const char *symbol : {"Du", "EP", "LP", "MW"}) stated.push_back({"LIG", "C2", "-", symbol});
  stated.push_back({"LIG", "C2", "X", "X"});
  expect_elements(stated, {pdb_14, mmcif});
  // A radius of the user's makes balls of them.
  const TemporaryFile file("query.sdf", as_sdf({{"", "", "", "C"}, {"", "", "", "A"}, {"", "", "", "*"}}));
  EXPECT_EQ(run_json({"measure", file.path(), "--radius", "A=1,X=1"})["n"].number, 3);
}

// ---- types ----

TEST(Elements, OfTypesOfSybyl) {
  std::vector<Atom> atoms;
  for (const char *type : {"C.3", "C.2", "C.1", "C.ar", "C.cat", "c.3"}) atoms.push_back({"", "X1", "C", type});
  for (const char *type : {"N.3", "N.2", "N.1", "N.ar", "N.am", "N.pl3", "N.4"}) atoms.push_back({"", "C1", "N", type});
  for (const char *type : {"O.3", "O.2", "O.co2", "O.spc", "O.t3p"}) atoms.push_back({"", "1", "O", type});
  for (const char *type : {"S.3", "S.2", "S.O", "S.O2", "S.o2"}) atoms.push_back({"", "CA", "S", type});
  for (const char *type : {"H", "H.spc", "H.t3p", "D"}) atoms.push_back({"", "OS", "H", type});
  for (const char *type :
       {"P.3", "F",  "I",  "K",  "Cl",    "Br",    "Si",    "Se", "Ca", "Na", "Li", "Al", "Mg",  "Fe",
        "Cu",  "Zn", "Sn", "Mo", "Cr.th", "Cr.oh", "Co.oh", "Mn", "CL", "BR", "ZN", "FE", "Na+", "Zn2+"}) {
    std::string element(1, type[0]);
    if (type[1] != '\0' && type[1] != '.') element += static_cast<char>(std::tolower(type[1]));
    atoms.push_back({"", "X1", element, type});
  }
  for (const char *type : {"Du", "Du.C", "LP", "Any", "Hal", "Het", "Hev"}) atoms.push_back({"", "C1", "-", type});
  expect_elements(atoms, {mol2});
}

TEST(Elements, OfTypesOfForceFields) {
  std::vector<Atom> atoms;
  for (const char *type :
       {"c",  "c1", "c2", "c3", "ca", "cc", "cd", "ce", "cf", "cg", "ch", "cp", "cq", "cs",     "cu",      "cv",
        "cx", "cy", "cz", "CA", "CB", "CD", "CM", "CR", "CS", "CT", "CU", "CO", "2C", "CG2R61", "opls_135"}) {
    atoms.push_back({"LIG", "C7", "C", type});
  }
  for (const char *type : {"n", "na", "nb", "nc", "nd", "ne", "nf", "nh", "ni", "no", "np", "n4", "NA", "NB", "N*"}) {
    atoms.push_back({"LIG", "N1A", "N", type});
  }
  for (const char *type : {"o", "oh", "os", "op", "OS", "OH", "OW", "O2"}) atoms.push_back({"LIG", "O3'", "O", type});
  for (const char *type : {"h1", "ha", "hc", "hn", "ho", "hp", "hs", "HO", "HS", "HA", "HC", "HP"}) {
    atoms.push_back({"LIG", "H12", "H", type});
  }
  for (const char *type : {"pb", "pc", "pd", "p5"}) atoms.push_back({"LIG", "P1", "P", type});
  for (const char *type : {"s", "s2", "ss", "sh", "sy"}) atoms.push_back({"LIG", "S1", "S", type});
  for (const char *type : {"cl", "Cl", "CL"}) atoms.push_back({"LIG", "CLA", "Cl", type});
  for (const char *type : {"br", "f", "i"}) {
    std::string element = type;
    element[0] = static_cast<char>(std::toupper(element[0]));
    atoms.push_back({"LIG", element + "1", element, type});
  }
  for (const char *type : {"Y1", "M1", "X1"}) atoms.push_back({"LIG", "ZN", "Zn", type});
  for (const char *type : {"1", "2", "6", "53"}) atoms.push_back({"LIG", "C1", "C", type});
  atoms.push_back({"HEM", "FE", "Fe", "fe"});
  atoms.push_back({"GLY", "CA", "C", "CX"});
  atoms.push_back({"CA", "CA", "Ca", "C0"});
  expect_elements(atoms, {mol2});
  for (const Words &row :
       {Words{"12", "1"}, Words{"A1", "ca"}, Words{"?", "6"}, Words{"Z1", "Z.3"}, Words{"C1", "31.74"}}) {
    const TemporaryFile file("types.mol2", as_mol2({{"LIG", row[0], "", row[1]}}));
    const Outcome outcome = run_program({"measure", file.path()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_NE(outcome.err.find("the type '" + row[1] + "'"), std::string::npos) << outcome.err;
  }
}

// Blanks in an atom's name shift no column.
TEST(Elements, OfNamesWithBlanks) {
  const auto table = [](const std::string &name, const std::string &more) {
    const TemporaryFile file("blanks.mol2", "@<TRIPOS>MOLECULE\nx\n1 0\nSMALL\nUSER_CHARGES\n@<TRIPOS>ATOM\n1 " + name +
                                                " 3.5 4.5 31.745 " + more + "\n");
    const Json balls = run_json({"measure", file.path(), "--per-ball"})["balls"];
    if (balls.items.empty()) return std::string("none");
    const Json &ball = balls.items[0];
    return ball["atom"].text + "|" + ball["element"].text + "|" + ball["residue"].text + "|" +
           std::to_string(ball["xyz"].items[0].number) + "|" + std::to_string(ball["xyz"].items[2].number);
  };
  const std::string at = "|3.500000|31.745000";
  EXPECT_EQ(table("N1 1", "N.3 1 LIG1 0.1"), "N1 1|N|LIG" + at);
  EXPECT_EQ(table("N 1 a", "N.3 1 LIG1 0.1"), "N 1 a|N|LIG" + at);
  EXPECT_EQ(table("C A", "C.3"), "C A|C|" + at);
  EXPECT_EQ(table("O 1.5", "O.3 1"), "O 1.5|O|" + at);
  EXPECT_EQ(table("S1 2", "ss 1 LIG"), "S1 2|S|LIG" + at);
}

TEST(Elements, OfTypesOfAutoDock) {
  std::vector<Atom> atoms;
  for (const char *type : {"C", "A", "G", "GA", "J", "Q", "CG0", "CG1"}) atoms.push_back({"LIG", "N1", "C", type});
  for (const char *type : {"N", "NA", "NS"}) atoms.push_back({"LIG", "C1", "N", type});
  for (const char *type : {"O", "OA", "OS"}) atoms.push_back({"LIG", "C1", "O", type});
  for (const char *type : {"S", "SA"}) atoms.push_back({"LIG", "C1", "S", type});
  for (const char *type : {"H", "HD", "HS"}) atoms.push_back({"LIG", "C1", "H", type});
  for (const char *type : {"P",  "F",  "I",  "Cl", "CL", "Br", "BR", "Zn", "ZN", "Mg", "MG", "Ca", "CA",
                           "Mn", "MN", "Fe", "FE", "Si", "Na", "K",  "Cu", "Co", "Ni", "Cd", "Hg", "B"}) {
    std::string element = type;
    if (element.size() == 2) element[1] = static_cast<char>(std::tolower(element[1]));
    atoms.push_back({"LIG", "Q1", element, type});
  }
  for (const char *type : {"W", "Z", "TZ", "G0", "G1"}) atoms.push_back({"LIG", "C1", "-", type});
  expect_elements(atoms, {pdbqt});
  // Two letters in columns 78-79 say what they are, whatever the file is called.
  for (Atom &atom : atoms) {
    if (atom.stated.size() == 1 || atom.stated[1] < 'A') atom.stated = "OA", atom.element = "O";
  }
  expect_elements(atoms, {{"as pdb", "pdb", as_pdbqt}});
  // The charge is none of a segment.
  const TemporaryFile file("charges.pdbqt", as_pdbqt({{"LIG", "C1", "", "A"}, {"LIG", "CL", "", "Cl"}})),
      out("charges.svg");
  EXPECT_EQ(run_program({"draw", file.path(), "-o", out.path(), "--colour", "charge"}).status, 0);
  const TemporaryFile poses("poses.pdbqt", "MODEL 1\nREMARK VINA RESULT\n" + as_pdbqt({{"LIG", "C1", "", "A"}}) +
                                               "ENDMDL\nMODEL 2\n" + as_pdbqt({{"LIG", "O1", "", "OA"}}) + "ENDMDL\n");
  const Json second = run_json({"measure", poses.path(), "--model", "2", "--per-ball"});
  ASSERT_EQ(second["balls"].items.size(), 1U);
  EXPECT_EQ(second["balls"].items[0]["element"].text, "O");
  EXPECT_EQ(second["input"]["models"].number, 2);
}

// ---- contradictions ----

TEST(Elements, OfNamesThatContradict) {
  for (const char *element : {"Ca", "Cs", "Cd", "Cu", "Co"}) {
    const std::vector<Atom> atoms = {
        {"LIG", "C1", element, element}, {"LIG", "C2", element, element}, {"LIG", "O1", "O", "O"}};
    for (const Format &format : {pdb_14, mmcif, fractions, mol2, pdbqt}) {
      std::string said;
      EXPECT_EQ(elements_of(format.write(atoms), format.extension, &said), (Words{element, element, "O"}))
          << format.what;
      EXPECT_NE(said.find("'C1' is " + std::string(element) +
                          " by what the file states, which counts, and another element by its name; 2 such atoms\n"),
                std::string::npos)
          << format.what << ": " << said;
      EXPECT_EQ(said.find('\n'), said.size() - 1) << said;
    }
  }
  std::string said;
  elements_of(
      in_column_14({{"CA", "CA", "", "CA"}, {"LIG", "CL1", "", "CL"}, {"LIG", "C1", "", "C"}, {"LIG", "N1", "", "C"}}),
      "pdb", &said);
  EXPECT_EQ(said, "");
}

}  // namespace
