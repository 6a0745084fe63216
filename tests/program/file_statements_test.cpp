// Statements of files about themselves: directions in which a box repeats, lines that go on, marks of drawings, more
// molecules than the one that is read. They are used, or one line on stderr has them, or the file is refused by name.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

const std::string nine = "10 0 0 0 10 0 0 0 10";

std::string xyz(const std::string &title) {
  return "3\n" + title + "\nO 0 0 0\nH 1 0 0\nH 0 0 9.9\n";
}

// The volume of the box of a file, or what is said where it is refused.
std::string box_of(const std::string &title) {
  const TemporaryFile file("box.xyz", xyz(title));
  const Outcome outcome = run_program({"measure", file.path(), "--box", "file", "--json"});
  if (outcome.status != 0) return outcome.err.substr(outcome.err.find(": --box") + 2);
  const std::optional<Json> found = read_json(outcome.out);
  return found ? std::to_string(std::lround((*found)["box_volume"].number)) : outcome.out;
}

TEST(FileStatements, BoxesThatRepeatInSomeDirections) {
  const std::string lattice = "Lattice=\"" + nine + "\" ", none = "--box file: the file has no box";
  const std::string two = none + " that can be taken: by pbc it is periodic in two directions alone\n",
                    one = none + " that can be taken: by pbc it is periodic in one direction alone\n";
  for (const char *pbc : {"pbc=\"T T F\"", "pbc=\"F T T\"", "pbc=[T, F, T]", "pbc = {T T F}", "pbc='1 0 1'"}) {
    EXPECT_EQ(box_of(lattice + pbc), two) << pbc;
    EXPECT_EQ(box_of(pbc + (" " + lattice)), two) << pbc;
  }
  EXPECT_EQ(box_of(lattice + "pbc=\"F T F\""), one);
  EXPECT_EQ(box_of(lattice + "pbc=[false, false, true]"), one);
  EXPECT_EQ(box_of("Lattice=\"9 0 0 0 9 0 0 0 0\" pbc=\"T T F\""), two);
  EXPECT_EQ(box_of(lattice + "pbc=\"F F F\""), none + "\n");
  EXPECT_EQ(box_of(lattice + "pbc=F"), none + "\n");
  EXPECT_EQ(box_of("pbc=\"T T T\""), none + "\n");
  for (const char *pbc : {"", "pbc=\"T T T\"", "pbc=[True, true, TRUE]", "pbc=T", "mypbc=\"T T F\"", "pbc"}) {
    EXPECT_EQ(box_of(lattice + pbc), "1000") << pbc;
  }
  for (const char *pbc : {"pbc=\"T T\"", "pbc=\"T T X\"", "pbc=\"T T T T\"", "pbc=\"\""}) {
    EXPECT_EQ(box_of(lattice + pbc), none + " that can be taken: pbc is not of the form \"T T T\"\n") << pbc;
  }
  // Without a box that is asked for nothing is refused, and one of the user's own is taken.
  const TemporaryFile slab("slab.xyz", xyz(lattice + "pbc=\"T T F\""));
  EXPECT_EQ(run_json({"measure", slab.path()})["n"].number, 3);
  EXPECT_EQ(run_json({"measure", slab.path(), "--box", "10,10,40"})["box_volume"].number, 4000);
  EXPECT_EQ(run_program({"pores", slab.path(), "--box", "file"}).status, 1);
  const TemporaryFile run("run.xyz", xyz(lattice) + xyz(lattice + "pbc=\"T T F\""));
  const Outcome frames = run_program({"measure", run.path(), "--trajectory", run.path(), "--box", "file"});
  EXPECT_EQ(frames.status, 1);
  EXPECT_NE(frames.err.find("the frame has no box that can be taken: by pbc it is periodic in two directions alone"),
            std::string::npos)
      << frames.err;
}

TEST(FileStatements, LatticesOfAnyForm) {
  for (const std::string &lattice :
       {"Lattice=\"" + nine + "\"", "Lattice = \"" + nine + "\"", "Lattice='" + nine + "'", "Lattice={" + nine + "}",
        "time=3, Lattice=[" + nine + "]", std::string("Lattice=[[10,0,0],[0,10,0],[0,0,10]]"),
        std::string("Lattice=\"10, 0, 0, 0, 10, 0, 0, 0, 10\""),
        std::string("Lattice=[ [10, 0, 0], [0,10,0],[0,0,10] ]"), std::string("Lattice=\"10 10 10\""),
        std::string("Lattice=[10,10,10] Properties=species:S:1:pos:R:3"),
        std::string("it's name='Lattice=\"1 2 3\"' Lattice=[10,10,10]"), "quote=\\\" Lattice=\"" + nine + "\""}) {
    EXPECT_EQ(box_of(lattice), "1000") << lattice;
  }
  const std::string none = "--box file: the file has no box";
  for (const char *lattice : {"Lattice=\"1 2\"", "Lattice=\"10 0 0 0 10 0 0 0 x\"", "Lattice=\"10 0 0 0 10 0 0 0 10",
                              "Lattice=\"10 0 0 0 10 0 0 0 10 0\"", "Lattice="}) {
    EXPECT_EQ(box_of(lattice), none + " that can be taken: Lattice is not of the form \"a_x a_y a_z b_x .. c_z\"\n")
        << lattice;
  }
  for (const char *title : {"", "My_Lattice=\"10 10 10\"", "Lattice of nothing", "name=\"Lattice=[10,10,10]\""}) {
    EXPECT_EQ(box_of(title), none + "\n") << title;
  }
}

TEST(FileStatements, PropertiesInAnyQuotes) {
  for (const char *quoted :
       {"Properties=pos:R:3:species:S:1", "Properties = \"pos:R:3:species:S:1\"",
        "Properties='pos:R:3:species:S:1' pbc=F", "note={Properties=x} Properties=pos:R:3:Z:I:1"}) {
    const TemporaryFile file("columns.xyz", std::string("1\n") + quoted + "\n1 2 3 17\n");
    EXPECT_EQ(run_json({"measure", file.path(), "--per-ball"})["balls"].items.at(0)["element"].text, "Cl") << quoted;
  }
}

// ---- .sdf

std::string v3000(const std::string &atoms, const std::string &bonds = "", int count = 2) {
  return "m\n  x\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN CTAB\nM  V30 COUNTS " +
         std::to_string(count) + " 1 0 0 0\nM  V30 BEGIN ATOM\n" + atoms + "M  V30 END ATOM\nM  V30 BEGIN BOND\n" +
         bonds + "M  V30 END BOND\nM  V30 END CTAB\nM  END\n";
}

// Rows of a table that go on anywhere, in words as well, over as many lines as it takes.
TEST(FileStatements, LinesOfV3000GoOn) {
  const std::string tail = "M  V30 2 O 0 1.2 0.5 0\n", bond = "M  V30 1 2 1 2\n";
  const auto measured = [](const std::string &text) {
    const TemporaryFile file("m.sdf", text);
    const Outcome outcome = run_program({"measure", file.path(), "--json", "--per-ball"});
    return outcome.status == 0 ? geometry_alone(outcome.out) : outcome.err.substr(outcome.err.rfind(".sdf:") + 5);
  };
  const std::string whole = measured(v3000("M  V30 1 C 2.5 9.25 0.125 0\n" + tail, bond));
  EXPECT_NE(whole.find("0.125"), std::string::npos) << whole;
  for (const char *rows :
       {"M  V30 1 C 2.5 9.25 -\nM  V30 0.125 0\n", "M  V30 1 C 2.5 9.-\nM  V30 25 0.1-\nM  V30 25 0\n",
        "M  V30 -\nM  V30 1 C 2.5 9.25 0.125 0\n", "M  V30 1 C 2.5 9.25 0.125 0 CHG=-\nM  V30 1\n",
        "M  V30 1 C 2.5 9.25 0.125 0 -  \nM  V30 CHG=1 -\nM  V30 \n", "M  V30 1 C 2.5 9.2-\nM  V30 5 0.125 0\n"}) {
    EXPECT_EQ(measured(v3000(rows + tail, bond)), whole) << rows;
  }
  EXPECT_EQ(measured(v3000("M  V30 1 C 2.5 9.25 0.125 0\n" + tail, "M  V30 1 2 -\nM  V30 1 2\n")), whole);
  EXPECT_EQ(measured(v3000("M  V30 1 C 2.5 9.25 -\nM  V30 -0.125 0\n" + tail, bond)),
            measured(v3000("M  V30 1 C 2.5 9.25 -0.125 0\n" + tail, bond)));
  const TemporaryFile drawn("m.sdf", v3000("M  V30 1 C 0 0 0 0\n" + tail, "M  V30 1 2 -\nM  V30 1 2\n")), out("m.svg");
  EXPECT_NE(run_program({"draw", drawn.path(), "-o", out.path(), "--as", "ball-and-stick"}).out.find("1 multiple"),
            std::string::npos);
  EXPECT_EQ(measured(v3000("M  V30 1 C 2.5 9.25 0.1x-\nM  V30 2 0\n" + tail)),
            "9: z: '0.1x2' is not a decimal number\n");
  EXPECT_EQ(measured(v3000("M  V30 1 C 2.5 9.25 -\n0.125 0\n" + tail)),
            "9: the line before ends in '-', but M  V30 does not go on\n");
  EXPECT_EQ(measured("m\n\n\n  0  0  0     0  0            999 V3000\nM  V30 BEGIN ATOM\nM  V30 1 C 0 0 -\n"),
            "6: the line before ends in '-', but M  V30 does not go on\n");
}

// Lines of .mol2 that end in a backslash go on, where numbers, atoms or bonds are.
TEST(FileStatements, LinesOfMol2GoOn) {
  const auto measured = [](const std::string &counts, const std::string &atoms, const std::string &bonds) {
    const TemporaryFile file("m.mol2", "@<TRIPOS>MOLECULE\nname\\\n" + counts +
                                           "SMALL\nUSER_CHARGES\n@<TRIPOS>ATOM\n# none \\\n" + atoms +
                                           "@<TRIPOS>BOND\n" + bonds);
    const TemporaryFile out("m.svg");
    const Outcome outcome = run_program({"measure", file.path(), "--json", "--per-ball"});
    if (outcome.status != 0) return outcome.err.substr(outcome.err.rfind(".mol2:") + 6);
    const Outcome drawn = run_program({"draw", file.path(), "-o", out.path(), "--as", "ball-and-stick"});
    const bool twofold = drawn.out.find("1 multiple") != std::string::npos;
    return geometry_alone(outcome.out) + (twofold ? " with a double bond" : "");
  };
  const std::string tail = "2 O 0 1.2 0.5 O.2 1 FOR 0.5\n", bond = "1 1 2 2\n";
  const std::string whole = measured("2 1\n", "1 C 0.25 0 0.125 C.2 1 FOR 0.5\n" + tail, bond);
  EXPECT_NE(whole.find("0.125"), std::string::npos) << whole;
  EXPECT_NE(whole.find("with a double bond"), std::string::npos) << whole;
  for (const char *rows : {"1 C 0.25 0 \\\n0.125 C.2 1 FOR 0.5\n", "1 C 0.25 0\\  \n 0.1\\\n25 C.2 1 \\\n\\\nFOR 0.5\n",
                           "\\\n1 C 0.25 0 0.125 C.2 1 FOR 0.5\n"}) {
    EXPECT_EQ(measured("2 1\n", rows + tail, bond), whole) << rows;
  }
  EXPECT_EQ(measured("2\\\n 1\n", "1 C 0.25 0 0.125 C.2 1 FOR 0.5\n" + tail, "1 1\\\n 2 2\n"), whole);
  EXPECT_EQ(measured("2 1\n", "1 C 0.25 0 \\\n" + tail, ""), "3: 2 atoms announced, 1 found\n");
  EXPECT_EQ(measured("2 1\n", "1 C 0.25 0 0.125 C.2 1 FOR 0.5 \\\n", bond),
            "9: the line before ends in '\\', but does not go on\n");
}

// A table may be the last thing in a file, but all of it.
TEST(FileStatements, TablesOfV3000ThatEndWithTheFile) {
  const std::string text = v3000("M  V30 1 C 0 0 1 0\nM  V30 2 O 0 1.2 0.5 0\n", "M  V30 1 2 1 2\n");
  const size_t whole = text.find("M  V30 END CTAB") + 15;
  for (size_t length = 0; length <= text.size(); ++length) {
    const TemporaryFile file("cut.sdf", text.substr(0, length));
    const Outcome outcome = run_program({"measure", file.path(), "--csv"});
    EXPECT_EQ(outcome.status, length < whole ? 1 : 0) << length << outcome.err;
    EXPECT_EQ(outcome.err.empty(), length >= whole);
  }
  const TemporaryFile cut("cut.sdf", text.substr(0, text.find("M  V30 END ATOM")));
  EXPECT_EQ(run_program({"measure", cut.path()}).err,
            "hardsphere: " + cut.path() + ":4: the table ends before M  V30 END CTAB\n");
}

std::string sdf(const std::string &mark, const std::vector<std::string> &z) {
  std::string text = "hand made\n  by hand 0101010000" + mark + "\n\n  " + std::to_string(z.size()) +
                     "  0  0  0  0  0            999 V2000\n";
  for (size_t i = 0; i < z.size(); ++i) {
    text += "    " + std::to_string(i) + ".0000    0.0000    " + z[i] + " C   0  0  0\n";
  }
  return text + "M  END\n";
}

const std::string flat = "0.0000", high = "0.5000";

// The z's decide what is a drawing, and not the mark alone.
TEST(FileStatements, DrawingsAndMolecules) {
  const std::string note = "all z are 0: a flat molecule, or a drawing, which says nothing of space",
                    solid = "marked 2D, but not all z are 0: taken as a molecule in space";
  const auto told = [](const std::string &text, const std::string &name) {
    const TemporaryFile file(name, text);
    const std::string head = "hardsphere: " + file.path() + ": ";
    const Outcome json = run_program({"measure", file.path(), "--json"}),
                  csv = run_program({"measure", file.path(), "--csv"});
    EXPECT_EQ(csv.err, json.err);
    EXPECT_EQ(csv.status, json.status);
    return json.err.starts_with(head) ? json.err.substr(head.size()) : json.err;
  };
  for (const char *mark : {"", "  ", "3D"}) {
    EXPECT_EQ(told(sdf(mark, {flat, flat, flat, flat}), "m.sdf"), note + "\n") << mark;
    EXPECT_EQ(told(sdf(mark, {flat, flat, flat}), "m.sdf"), "") << mark;
    EXPECT_EQ(told(sdf(mark, {flat, flat, flat, high}), "m.mol"), "") << mark;
  }
  EXPECT_EQ(told(sdf("2D", {flat, flat, flat, high}), "m.sdf"), solid + "\n");
  EXPECT_EQ(told(sdf("2D", {high}), "m.mol"), solid + "\n");
  const TemporaryFile file("drawn.mol", sdf("2D", {flat, flat, flat}));
  EXPECT_EQ(run_program({"measure", file.path()}).err,
            "hardsphere: " + file.path() + ":2: a drawing in two dimensions, 2D: it says nothing of space\n");
  // It stays a drawing whatever else is wrong with it.
  const TemporaryFile strange("drawn.mol",
                              sdf("2D", {flat, flat}).replace(sdf("2D", {flat, flat}).rfind(" C "), 3, " R#"));
  EXPECT_EQ(run_program({"measure", strange.path()}).err,
            "hardsphere: " + strange.path() + ":2: a drawing in two dimensions, 2D: it says nothing of space\n");
  std::string table = v3000("M  V30 1 C 0 0 0 0\nM  V30 2 C 1 0 0.5 0\n");
  EXPECT_EQ(told(table.replace(2, 3, "  by hand 01010100002D"), "m.sdf"), solid + "\n");
  const std::string atoms = "1 C1 0 0 0 C.3\n2 C2 1 0 0 C.3\n3 C3 2 0 0 C.3\n4 C4 3 0 0 C.3\n";
  EXPECT_EQ(told("@<TRIPOS>MOLECULE\nm\n4\n@<TRIPOS>ATOM\n" + atoms, "m.mol2"), note + "\n");
}

TEST(FileStatements, OtherThingsThanMolecules) {
  const std::string counts = "  1  0  0  0  0  0            999 V2000\n    0.0       0.0       0.0    C   0\nM  END\n";
  const struct {
    const char *name;
    std::string text;
    const char *said;
  } files[] = {
      {"a.mol", "$RXN\n\n  x\n\n  1  1\n$MOL\n", "1: a reaction ($RXN), and no molecule"},
      {"a.sdf", "$RXN V3000\n\n  x\n" + counts, "1: a reaction ($RXN), and no molecule"},
      {"a.mol", "$RDFILE 1\n$DATM 1\n$RFMT\n$RXN\n\n", "1: a file of reactions ($RDFILE), and no molecule"},
      {"a.mol", "$MDL  REV  1 01-JAN-01\n$MOL\n$HDR\n\n  x\n\n$END HDR\n$CTAB\n",
       "1: a molecule with R groups ($MDL), and no molecule"},
      {"a.mol", "{\n \"root\": {\n},\n\"x\": 1\n}\n",
       "4: expected the numbers of atoms and bonds in columns 1 to 6: this looks like JSON"},
      {"a.mol", "[{}]\n", "1: the file ends before the numbers of atoms and bonds: this looks like JSON"},
      {"a.cif", "# remark\n\n{'_ref': 1}\ndata_a\n", "3: no CIF file: '{'_ref':' stands before data_"},
      {"a.cif", "loop_\n_a\n1\n", "1: no CIF file: 'loop_' stands before data_"},
      {"a.pdb.gz", "\x1f", " compressed; for instance: gunzip -c FILE | hardsphere measure - --format pdb"},
      {"a.sdf.Z", "\x1f", " compressed; for instance: gunzip -c FILE | hardsphere measure - --format pdb"},
      {"a.sdf.bz2", "B", " compressed; for instance: bunzip2 -c FILE | hardsphere measure - --format pdb"},
      {"a.xz", "x", " compressed; for instance: unxz -c FILE | hardsphere measure - --format pdb"},
      {"a.cif.ZST", "x", " compressed; for instance: unzstd -c FILE | hardsphere measure - --format pdb"},
  };
  for (const auto &file : files) {
    const TemporaryFile written(file.name, file.text);
    const Outcome outcome = run_program({"measure", written.path()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "hardsphere: " + written.path() + ":" + file.said + "\n");
  }
  // The kind of one record says nothing of others.
  const TemporaryFile second("two.sdf", "{m}\n\n\n" + counts + "$$$$\n$RXN\n\n\n" + counts);
  EXPECT_EQ(run_json({"measure", second.path()})["n"].number, 1);
  EXPECT_NE(run_program({"measure", second.path(), "--model", "2"}).err.find(":8: a reaction"), std::string::npos);
}

// ---- all formats

TEST(FileStatements, ModelsThatAreNotRead) {
  const std::string record = sdf("", {flat, high}) + "$$$$\n",
                    note = " 1 of 3 is read, and no other; --model N takes another one", all = ", --models all each";
  const struct {
    const char *name;
    std::string text, said;
  } files[] = {{"m.sdf", record + record + record, "molecule" + note},
               {"m.xyz", "1\n\nC 1 0 0\n1\n\nC 2 0 0\n1\n\nC 3 0 0\n", "model" + note},
               {"one.sdf", record, ""}};
  for (const auto &file : files) {
    const TemporaryFile written(file.name, file.text);
    const std::string few = file.said.empty() ? "" : "hardsphere: " + written.path() + ": " + file.said;
    const std::string said = few.empty() ? "" : few + all + "\n", other = few.empty() ? "" : few + "\n";
    for (const std::vector<std::string> &more : {std::vector<std::string>{}, {"--csv"}, {"--per-ball"}}) {
      std::vector<std::string> arguments = {"measure", written.path()};
      arguments.insert(arguments.end(), more.begin(), more.end());
      EXPECT_EQ(run_program(arguments).err, said);
      arguments.insert(arguments.end(), {"--model", "1"});
      EXPECT_EQ(run_program(arguments).err, "");
    }
    const TemporaryFile out("m.svg");
    EXPECT_EQ(run_program({"draw", written.path(), "-o", out.path()}).err, other);
    EXPECT_EQ(run_program({"measure", written.path(), written.path(), "--csv"}).err, other + other);
    EXPECT_EQ(run_program({"clash", written.path(), written.path()}).err, other + other);
    run_json({"measure", written.path()});  // its object has both numbers
  }
  const TemporaryFile frames("m.xyz", files[1].text);
  EXPECT_EQ(run_program({"measure", frames.path(), "--trajectory", frames.path()}).err, "");
}

TEST(FileStatements, AtomsWithoutCoordinates) {
  const std::string note = " atoms stand in one point, 0 0 0: they may have no coordinates";
  const auto told = [](const std::string &name, const std::string &text, const std::string &said) {
    const TemporaryFile file(name, text);
    run_json({"measure", file.path()}, said);
  };
  told("m.xyz", "3\n\nC 1 2 3\nH 0 0 0\nH 0.0 -0 0e3\n", "2" + note);
  told("m.sdf", sdf("", {"0.0000", "0.0000"}).replace(sdf("", {flat, flat}).rfind("1.0000"), 6, "0.0000"), "2" + note);
  told("m.xyz", "4\n\nC 0 0 0\nH 0 0 0\nH 0 0 0\nH 0 0 0\n", "4" + note);
  told("m.xyz", "3\n\nC 0 0 0\nH 0 0 1e-9\nH 0 1 0\n", "");
  told("m.xyzr", "0 0 0 1\n0 0 0 2\n", "");
}

}  // namespace
