// Files that mislead readers: beads that look like boron, numbers that may be types, tabs, symbols in wrong columns,
// numbers that touch.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Words = std::vector<std::string>;

std::string refusal(const Words &arguments) {
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.status, 1) << outcome.out;
  EXPECT_EQ(outcome.out, "");
  return outcome.err;
}

std::string atom(const std::string &name, const std::string &residue, const std::string &x,
                 const std::string &behind = "") {
  return "ATOM      1 " + name + " " + residue + " A   1    " + x + "   0.000   0.000" + behind + "\n";
}

// Without columns for elements, and with what other programs guess.
TEST(UnusualFiles, BeadsAreNoElements) {
  for (const std::string guess : {"", "  1.00  0.00           B", "  1.00  0.00           S"}) {
    for (const std::string name : {" BB ", " SC1"}) {
      const TemporaryFile file("cg.pdb", atom(" CA ", "GLY", "   0.000") + atom(name, "LYS", "   5.000", guess));
      EXPECT_EQ(refusal({"measure", file.path()}),
                "hardsphere: " + file.path() + ":2: '" + name.substr(name[0] == ' ' ? 1 : 0, name == " BB " ? 2 : 3) +
                    "' of LYS is no element: looks coarse-grained; give radii by --radii FILE\n");
      const TemporaryFile radii("beads.radii", "LYS BB 2.6\nLYS SC1 2.3\n");
      const Json found = run_json({"measure", file.path(), "--radii", radii.path(), "--per-ball"});
      EXPECT_EQ(found["balls"].items.at(1)["radius"].number, name == " BB " ? 2.6 : 2.3);
      EXPECT_EQ(found["balls"].items.at(1)["element"].text, "");
    }
  }
  const TemporaryFile gro("cg.gro",
                          "beads\n    2\n    1ALA     BB    1   0.000   0.000   0.000\n"
                          "    2DPPC   GL1    2   1.000   0.000   0.000\n   5 5 5\n");
  EXPECT_NE(refusal({"measure", gro.path()}).find(":3: 'BB' of ALA is no element: looks coarse-grained"),
            std::string::npos);
  EXPECT_NE(refusal({"measure", gro.path(), "--hide", "residue:ALA"}).find("no element in the atom name 'GL1'"),
            std::string::npos);
  const TemporaryFile radii("beads.radii", "ALA BB 2.6\nDPPC GL1 2.3\n");
  EXPECT_EQ(run_json({"measure", gro.path(), "--radii", radii.path()})["n"].number, 2);
  const TemporaryFile picture("beads.svg");
  EXPECT_EQ(run_program({"draw", gro.path(), "--radii", radii.path(), "-o", picture.path()}).status, 0);
  const TemporaryFile cif("cg.cif",
                          "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
                          "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\nB BB ALA 0 0 0\n");
  EXPECT_NE(refusal({"measure", cif.path()}).find("looks coarse-grained"), std::string::npos);
  // Sulfur where it belongs, and boron in ligands.
  const TemporaryFile real("real.pdb", atom(" SG ", "CYS", "   0.000") + atom(" SD ", "MET", "   5.000") +
                                           atom(" B  ", "BRC", "   9.000") +
                                           atom(" S1P", " DA", "  19.000", "  1.00  0.00           S"));
  EXPECT_EQ(run_json({"measure", real.path()})["n"].number, 4);
}

TEST(UnusualFiles, NumbersForElementsAreSaid) {
  const TemporaryFile file("types.xyz", "3\n\n1 0 0 0\n2 0 0 5\nC 0 0 9\n");
  EXPECT_EQ(run_json({"measure", file.path()})["input"]["atomic_numbers"].number, 2);
  const std::string table = run_program({"measure", file.path()}).out;
  EXPECT_NE(table.find("  elements         2 numbers, taken as atomic numbers\n"), std::string::npos) << table;
  EXPECT_EQ(run_program({"measure", "good/water.xyz"}).out.find("atomic number"), std::string::npos);
}

TEST(UnusualFiles, WhatWasLeftOutIsNamed) {
  const auto says = [](const std::string &text) {
    const TemporaryFile file("dummies.xyz", text);
    const std::string err = refusal({"measure", file.path()});
    return err.substr(err.find(file.path()) + file.path().size() + 2);
  };
  EXPECT_EQ(says("2\n\nX 0 0 0\nX 0 0 5\n"), "no atoms are left: all 2 are X, dummies\n");
  EXPECT_EQ(says("1\n\nX 0 0 0\n"), "no atoms are left: the only one is X, a dummy\n");
  EXPECT_EQ(says("2\n\nX 0 0 0\nEP 0 0 5\n"), "no atoms are left: all 2 are virtual sites\n");
  EXPECT_EQ(says("2\n\nEP 0 0 0\nEP 0 0 5\n"), "no atoms are left: all 2 are Ep, virtual sites\n");
  const TemporaryFile both("both.pdb", atom(" HA ", "ALA", "   0.000") + atom(" MW ", "SOL", "   5.000"));
  EXPECT_NE(refusal({"measure", both.path(), "--radii", "protor"})
                .find("all are virtual sites, 1, or hydrogens, 1, which heavy atoms stand for"),
            std::string::npos);
}

// Behind the coordinates a tab is a blank; before their end nobody knows how many.
TEST(UnusualFiles, TabsBehindTheCoordinates) {
  const TemporaryFile file("tabs.pdb", atom(" CA ", "GLY", "   0.000", "  1.00  0.00\t          N") +
                                           atom(" CB ", "ALA", "   5.000", "\t\t"));
  const Json found = run_json({"measure", file.path(), "--per-ball"});
  EXPECT_EQ(found["balls"].items.at(0)["element"].text, "N");
  EXPECT_EQ(found["balls"].items.at(1)["element"].text, "C");
  const TemporaryFile before("before.pdb", atom(" CA ", "GLY", "\t  0.000"));
  EXPECT_NE(refusal({"measure", before.path()}).find(":1: a tab in a record of fixed columns"), std::string::npos);
}

TEST(UnusualFiles, SymbolsOfMixedCase) {
  const TemporaryFile file("argon.pdb", atom(" Ar ", "LJ ", "   0.000") + atom(" CA ", "LJ ", "   9.000"));
  const Json found = run_json({"measure", file.path(), "--per-ball"});
  EXPECT_EQ(found["balls"].items.at(0)["element"].text, "Ar");
  EXPECT_EQ(found["balls"].items.at(1)["element"].text, "C");
}

// Numbers of a box may touch; all have as many decimals.
TEST(UnusualFiles, BoxesWhoseNumbersTouch) {
  const std::string head = "box\n    1\n    1UNK      C    1   0.000   0.000   0.000\n";
  const struct {
    const char *box;
    double volume;  // 0: refused
  } cases[] = {{"40000.0000040001.0000040002.00000", 4000.0 * 4000.1 * 4000.2 * 1e6},
               {"   5.00000   6.00000   7.00000", 210e3},
               {"10000.0000010000.0000010000.00000   0.00000   0.00000-1000.00000   0.00000   0.00000   0.00000", 1e15},
               {"40000.0000040000.00000", 0}};
  for (const auto &it : cases) {
    const TemporaryFile file("touching.gro", head + it.box + "\n");
    if (it.volume == 0) {
      EXPECT_NE(refusal({"measure", file.path()}).find("expected the box"), std::string::npos) << it.box;
      continue;
    }
    const Outcome outcome = run_program({"measure", file.path()});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    if (it.volume > 1e12) continue; /* too large for the lattice of a carbon */
    EXPECT_NEAR(run_json({"measure", file.path(), "--box", "file"})["box_volume"].number, it.volume, 1e-3);
  }
  const TemporaryFile small("small.gro", head + "50.0000060.0000070.00000\n");
  EXPECT_NEAR(run_json({"measure", small.path(), "--box", "file"})["box_volume"].number, 210e6, 1e-3);
}

TEST(UnusualFiles, ExtendedXyzByItsName) {
  const TemporaryFile file("frame.extxyz",
                           "1\nLattice=\"0 5 0 6 0 0 0 0 7\" Properties=species:S:1:pos:R:3\nC 0 0 0\n");
  const Json found = run_json({"measure", file.path(), "--box", "file"});
  EXPECT_EQ(found["input"]["format"].text, "xyz");
  EXPECT_NEAR(found["box_volume"].number, 210, 1e-9);
  const double vectors[9] = {0, 5, 0, 6, 0, 0, 0, 0, 7};  // left-handed, and as they are
  for (size_t k = 0; k < 9; ++k) EXPECT_EQ(found["box"].items.at(k).number, vectors[k]);
}

// Two chains whose names begin alike are two: atoms of the second are no other locations of the first one's.
TEST(UnusualFiles, NamesOfChainsAreNotCut) {
  const std::string head =
      "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_alt_id\n"
      "_atom_site.label_comp_id\n_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n_atom_site.Cartn_x\n"
      "_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
  const TemporaryFile fits("fits.cif", head + "C CA A ALA LongChain_1 1 0 0 0\nC CA B ALA LongChain_2 1 9 0 0\n");
  EXPECT_EQ(run_json({"measure", fits.path()})["n"].number, 2);
  const TemporaryFile cif("long.cif", head + "C CA A ALA LongChain_of_1 1 0 0 0\nC CA B ALA LongChain_of_2 1 9 0 0\n");
  EXPECT_EQ(refusal({"measure", cif.path()}),
            "hardsphere: " + cif.path() + ":12: the chain's name 'LongChain_of_1' has more than 11 letters\n");
  const TemporaryFile pqr("long.pqr", "ATOM 1 CA ALA LongChain_of_1 1 0 0 0 0 1\n");
  EXPECT_EQ(refusal({"measure", pqr.path()}),
            "hardsphere: " + pqr.path() + ":1: the chain's name 'LongChain_of_1' has more than 11 letters\n");
}

// Residues whose names were cut to one would be one, or an atom of the one another location of an atom of the other.
TEST(UnusualFiles, NamesOfResiduesAreNotCut) {
  const std::string head =
      "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_alt_id\n"
      "_atom_site.label_comp_id\n_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n_atom_site.pdbx_PDB_ins_code\n"
      "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
  const TemporaryFile two("two.cif", head + "C C1 . LIGAND_001 A . . 0 0 0\nC C2 . LIGAND_002 A . . 9 0 0\n");
  const Json residues = run_json({"measure", two.path(), "--by", "residue"})["residues"];
  ASSERT_EQ(residues.items.size(), 2U);
  EXPECT_EQ(residues.items[0]["name"].text, "LIGAND_001");
  EXPECT_EQ(residues.items[1]["name"].text, "LIGAND_002");
  EXPECT_EQ(run_json({"measure", two.path(), "--only", "residue:LIGAND_002"})["n"].number, 1);
  const std::string mixture =
      "C C1 A LIGAND_001 A 1 . 0 0 0\nC C2 A LIGAND_001 A 1 . 5 0 0\nC C3 B LIGAND_002 A 1 . 9 0 0\n";
  for (const std::string locations : {"first", "occupancy", "A"}) {
    const TemporaryFile file("mixture.cif", head + mixture);
    EXPECT_EQ(run_json({"measure", file.path(), "--altloc", locations})["n"].number, 2) << locations;
  }
  const TemporaryFile picture("two.svg");
  EXPECT_EQ(run_program({"draw", two.path(), "--tooltips", "-o", picture.path()}).status, 0);
  const struct {
    const char *row, *complaint;
  } refused[] = {
      {"C C1 . Residue_of_24_characters A 1 . 0 0 0",
       "the residue's name 'Residue_of_24_characters' has more than 23 letters"},
      {"C C1 . LIG A 123456789012 . 0 0 0", "the residue's number '123456789012' has more than 11 letters"},
      {"C C1 . LIG A 1 AB 0 0 0", "the insertion code 'AB' has more than 1 letter"},
      {"C CARBON_1 A LIG A 1 . 0 0 0", "the atom's name 'CARBON_1' has more than 7 letters"},
  };
  for (const auto &it : refused) {
    const TemporaryFile file("long.cif", head + it.row + "\n");
    EXPECT_EQ(refusal({"measure", file.path()}), "hardsphere: " + file.path() + ":13: " + it.complaint + "\n");
  }
  const TemporaryFile named("named.cif", head + "C CARBON_1 . LIG A 1 . 0 0 0\nC CARBON_2 . LIG A 1 . 9 0 0\n");
  EXPECT_EQ(run_json({"measure", named.path()})["n"].number, 2);
  const TemporaryFile pqr("long.pqr", "ATOM 1 CA Residue_of_24_characters 1 0 0 0 0 1\n");
  EXPECT_EQ(
      refusal({"measure", pqr.path()}),
      "hardsphere: " + pqr.path() + ":1: the residue's name 'Residue_of_24_characters' has more than 23 letters\n");
  const TemporaryFile component("long.cif",
                                "data_a\nloop_\n_chem_comp_atom.comp_id\n_chem_comp_atom.atom_id\n"
                                "_chem_comp_atom.type_symbol\n_chem_comp_atom.x\n_chem_comp_atom.y\n"
                                "_chem_comp_atom.z\nComponent_of_24_letters_ C1 C 0 0 0\n");
  EXPECT_NE(refusal({"measure", component.path()}).find(":9: the component's name 'Component_of_24_letters_' has more"),
            std::string::npos);
}

// Of a name that has no room, and of a long word in a message, whole characters are left.
TEST(UnusualFiles, TextsAreCutBetweenCharacters) {
  const std::string accents = "\u00e9\u00e9\u00e9\u00e9\u00e9";
  const TemporaryFile cif("accents.cif",
                          "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
                          "_atom_site.label_comp_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
                          "C " +
                              accents + " " + accents + " 0 0 0\n");
  const std::string rows = run_program({"measure", cif.path(), "--per-ball", "--csv"}).out;
  EXPECT_NE(rows.find("\n0,\u00e9\u00e9\u00e9,C,," + accents + ","), std::string::npos) << rows;
  const TemporaryFile latin("latin.cif",
                            "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.Cartn_x\n"
                            "_atom_site.Cartn_y\n_atom_site.Cartn_z\nC C\xa9\xa9\xa9\xa9\xa9\xa9\xa9\xa9 0 0 0\n");
  const std::string bytes = run_program({"measure", latin.path(), "--per-ball", "--csv"}).out;
  EXPECT_NE(bytes.find("\n0,C\xa9\xa9\xa9\xa9\xa9\xa9,C,"), std::string::npos) << bytes;
  std::string word = "x";
  for (int k = 0; k < 30; ++k) word += "\u00e9";
  for (const std::string before : {"", "x"}) {
    const TemporaryFile xyz("word.xyz", "1\n\nC " + before + word + " 0 0\n");
    const std::string said = refusal({"measure", xyz.path()});
    const size_t cut = said.find("...'");
    ASSERT_NE(cut, std::string::npos) << said;
    EXPECT_EQ(said.substr(cut - 2, 2), "\u00e9") << said;
  }
}

// A number that is too long for its columns moves or loses what is behind it.
TEST(UnusualFiles, NumbersThatRunOverTheirColumnsAreRefused) {
  const std::string place = "    1.000   2.000";
  for (const std::string z : {"12345.678", " 345.6789", "-345.6789"}) {
    for (const std::string behind : {"", "  1.00  0.00           C"}) {
      const TemporaryFile pdb("long.pdb", "ATOM      1  CA  ALA A   1   " + place + z + behind + "\n");
      EXPECT_EQ(refusal({"measure", pdb.path()}),
                "hardsphere: " + pdb.path() + ":1: z (columns 47-54) goes on in column 55\n");
    }
  }
  const TemporaryFile full("full.pdb", "ATOM      1  CA  ALA A   1   " + place + "1345.678100.00  0.00           C\n");
  EXPECT_EQ(run_json({"measure", full.path(), "--per-ball"})["balls"].items.at(0)["xyz"].items.at(2).number, 1345.678);
  const std::string head = "t\n\n\n  1  0  0  0  0  0  0  0  0  0999 V2000\n    1.0000    2.0000";
  for (const std::string z : {"    3.0000Si  0", "-12345.6789 Si  0", "    3.0000C   0"}) {
    const TemporaryFile sdf("long.sdf", head + z + "  0\nM  END\n");
    EXPECT_EQ(refusal({"measure", sdf.path()}),
              "hardsphere: " + sdf.path() + ":5: column 31, between z and the symbol, is not blank\n");
  }
  const TemporaryFile wide("wide.sdf", head + "-1234.5678 Si  0  0\nM  END\n");
  EXPECT_EQ(run_json({"measure", wide.path(), "--per-ball"})["balls"].items.at(0)["element"].text, "Si");
}

// Without its index the type of a V3000 atom would be its x, an atomic number.
TEST(UnusualFiles, TypesOfV3000AreNoNumbers) {
  const auto table = [](const std::string &atom) {
    return "t\n\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS 1 0 0 0 0\nM  V30 BEGIN "
           "ATOM\n"
           "M  V30 " +
           atom + "\nM  V30 END ATOM\nM  V30 END CTAB\nM  END\n";
  };
  const TemporaryFile right("right.mol", table("1 C 11 22 33 0")), lacks("lacks.mol", table("C 11 22 33 0"));
  EXPECT_EQ(run_json({"measure", right.path()})["n"].number, 1);
  EXPECT_EQ(refusal({"measure", lacks.path()}),
            "hardsphere: " + lacks.path() + ":8: expected M  V30 index type x y z, and the type is a number\n");
}

// Of the properties of extended XYZ species is the element, and Z only where there is none.
TEST(UnusualFiles, SpeciesHavePrecedence) {
  for (const std::string title : {"Z:I:1:species:S:1:pos:R:3", "species:S:1:Z:I:1:pos:R:3"}) {
    const std::string atom = title[0] == 'Z' ? "2 Fe" : "Fe 2";
    const TemporaryFile file("both.xyz", "1\nProperties=" + title + "\n" + atom + " 1 2 3\n");
    const Json ball = run_json({"measure", file.path(), "--per-ball"})["balls"].items.at(0);
    EXPECT_EQ(ball["element"].text, "Fe");
  }
}

// Without the radius, or one coordinate, the chain is no residue number, and the number no coordinate.
TEST(UnusualFiles, MissingFieldsOfPqr) {
  for (const std::string values : {"11.000 22.000 33.000 0.3", "22.000 33.000 0.3 1.5"}) {
    const TemporaryFile file("missing.pqr", "ATOM 1 N ALA A 1 " + values + "\n");
    EXPECT_EQ(refusal({"measure", file.path()}),
              "hardsphere: " + file.path() + ":1: 'A' stands where a residue number should; wrong number of fields?\n");
  }
  const TemporaryFile file("numbers.pqr", "ATOM 1 N ALA ABCD 1 2 3 0 1\nATOM 2 N ALA A A000 9 2 3 0 1\n");
  EXPECT_EQ(run_json({"measure", file.path()})["n"].number, 2);
}

}  // namespace
