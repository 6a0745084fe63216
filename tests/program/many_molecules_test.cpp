// Files of many molecules: a row for each is what --model N says of it, a molecule that fails is a row, and files have
// rows too.
#include <gtest/gtest.h>

#include <cstdarg>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Words = std::vector<std::string>;

// Balls in a row, k + 1 of them, of the molecule k.
double place(size_t molecule, size_t atom) {
  return 1.2 * static_cast<double>(atom) + 0.1 * static_cast<double>(molecule % 7);
}

std::string name_of(size_t molecule) {
  return "lig, \"" + std::to_string(molecule) + "\"";
}

std::string text(const char *format, ...) __attribute__((format(printf, 1, 2)));
std::string text(const char *format, ...) {
  char line[200];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(line, sizeof line, format, arguments);
  va_end(arguments);
  return line;
}

std::string sdf(size_t k) {
  const int atoms = static_cast<int>(k % 9) + 1;
  std::string out = name_of(k) + "\n  made\n\n" + text("%3d  0  0  0  0            999 V2000\n", atoms);
  for (int i = 0; i < atoms; ++i) {
    out += text("%10.4f%10.4f%10.4f %-3s 0  0\n", place(k, static_cast<size_t>(i)), 0.5, 1.0, i % 2 == 0 ? "C" : "Cl");
  }
  return out + "M  END\n>  <SCORE>\n-7.5\n\n$$$$\n";
}

std::string mol2(size_t k) {
  const int atoms = static_cast<int>(k % 9) + 1;
  std::string out =
      "# made\n@<TRIPOS>MOLECULE\n" + name_of(k) + text("\n%d 0 1\nSMALL\nNO_CHARGES\n@<TRIPOS>ATOM\n", atoms);
  for (int i = 0; i < atoms; ++i) {
    out += text("%d X%d %.4f 0.5 1.0 %s 1 LIG 0.0\n", i + 1, i + 1, place(k, static_cast<size_t>(i)),
                i % 2 == 0 ? "C.3" : "Cl");
  }
  return out;
}

std::string pdb_atom(int serial, const char *name, double x, const char *element) {
  return text("HETATM%5d %-4s LIG A   1    %8.3f%8.3f%8.3f  1.00  0.00          %2s\n", serial, name, x, 0.5, 1.0,
              element);
}

std::string pdb(size_t k) {
  const int atoms = static_cast<int>(k % 9) + 1;
  std::string out = text("MODEL     %4d\nREMARK  Name = ", static_cast<int>(k + 1)) + name_of(k) + "\n";
  for (int i = 0; i < atoms; ++i) {
    out += pdb_atom(i + 1, i % 2 == 0 ? " C1" : "CL1", place(k, static_cast<size_t>(i)), i % 2 == 0 ? "C" : "CL");
  }
  return out + "TER\nENDMDL\n";
}

std::string pdbqt(size_t k) {
  std::string out;
  std::istringstream lines(pdb(k));
  for (std::string line; std::getline(lines, line);) {
    const bool atom = line.rfind("HETATM", 0) == 0;
    out += atom ? line.substr(0, 66) + "    +0.000 " + (line[77] == 'C' ? "C\n" : "Cl\n") : line + "\n";
  }
  return out;
}

std::string pqr(size_t k) {
  std::string out = text("MODEL %d\nREMARK  Name = ", static_cast<int>(k + 1)) + name_of(k) + "\n";
  for (size_t i = 0; i < k % 9 + 1; ++i) {
    out +=
        text("ATOM %d C%d LIG 1 %.3f 0.5 1.0 0.1 1.7\n", static_cast<int>(i) + 1, static_cast<int>(i) + 1, place(k, i));
  }
  return out + "ENDMDL\n";
}

std::string xyz(size_t k) {
  std::string out = std::to_string(k % 9 + 1) + "\n" + name_of(k) + "\n";
  for (size_t i = 0; i < k % 9 + 1; ++i) out += text("%s %.4f 0.5 1.0\n", i % 2 == 0 ? "C" : "Cl", place(k, i)) + "\n";
  return out;
}

struct Format {
  const char *extension;
  std::string (*molecule)(size_t k);
};
const std::vector<Format> formats = {{".sdf", sdf},     {".mol2", mol2}, {".pdb", pdb},
                                     {".pdbqt", pdbqt}, {".pqr", pqr},   {".xyz", xyz}};

std::string file_of(const Format &format, size_t molecules) {
  std::string out;
  for (size_t k = 0; k < molecules; ++k) out += format.molecule(k);
  return out;
}

std::vector<std::string> lines_of(const std::string &from) {
  std::vector<std::string> lines;
  std::istringstream in(from);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

Words call(const std::string &path, const Words &more) {
  Words words = {"measure", path, "--models", "all", "--probe", "1.4"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST(ManyMolecules, RowsAreWhatEachModelHas) {
  for (const Format &format : formats) {
    const TemporaryFile file(std::string("many") + format.extension, file_of(format, 11));
    const Outcome csv = run_program(call(file.path(), {"--csv"})), json = run_program(call(file.path(), {"--json"}));
    const Outcome table = run_program(call(file.path(), {}));
    EXPECT_EQ(csv.status + json.status + table.status, 0) << csv.err << json.err << table.err;
    EXPECT_EQ(csv.err + json.err + table.err, "");
    const std::vector<std::string> rows = lines_of(csv.out), objects = lines_of(json.out), shown = lines_of(table.out);
    ASSERT_EQ(rows.size(), 12u) << format.extension;
    ASSERT_EQ(objects.size(), 11u) << format.extension;
    EXPECT_EQ(rows[0], "model,title,atoms,area,volume,fault");
    for (size_t k = 0; k < 11; ++k) {
      const std::string number = std::to_string(k + 1);
      const Json alone = run_json({"measure", file.path(), "--model", number, "--probe", "1.4"});
      const std::string title = "\"lig, \"\"" + std::to_string(k) + "\"\"\"";
      EXPECT_EQ(rows[k + 1], number + "," + title + "," + alone["n"].text + "," + alone["area"].text + "," +
                                 alone["volume"].text + ",")
          << format.extension;
      const Json object = read_json(objects[k]).value();
      EXPECT_EQ(object.keys, (Words{"model", "title", "n", "area", "volume", "input"}));
      EXPECT_EQ(object["title"].text, name_of(k));
      EXPECT_EQ(object["area"].text, alone["area"].text);
      EXPECT_EQ(object["input"]["model"].text, number);
      EXPECT_EQ(object["input"]["models"].kind, Json::Kind::null);
      const std::string &row = shown[shown.size() - 11 + k];
      EXPECT_EQ(row.substr(row.size() - name_of(k).size()), name_of(k)) << row;
    }
  }
}

// However lines end, and wherever blocks of the file do, also with lines of data that begin as a record's end does.
TEST(ManyMolecules, EndsOfLinesChangeNothing) {
  std::string file;
  for (size_t k = 0; k < 700; ++k) {
    std::string one = k % 100 == 99 ? sdf(k).replace(sdf(k).find(" C "), 3, " Zq") : sdf(k);
    const std::string data = "> <NOTE>\n" + std::string(k % 67, 'x') + "\n$$ " + std::string(k % 5, '$') + "\n\n";
    file += one.insert(one.find("$$$$"), data);
  }
  const auto rows_of = [&](const char *ending) {
    std::string text;
    for (const char c : file) c == '\n' ? text += ending : text += c;
    const TemporaryFile written("ends.sdf", text);
    const Outcome outcome = run_program(call(written.path(), {"--csv"}));
    EXPECT_EQ(outcome.status, 1);
    return outcome.out;
  };
  const std::string rows = rows_of("\n");
  EXPECT_EQ(lines_of(rows).size(), 701u);
  EXPECT_EQ(rows_of("\r\n"), rows);
  EXPECT_EQ(rows_of("\r"), rows);
}

// Each command that has rows, by its titles.
TEST(ManyMolecules, OtherCommands) {
  const TemporaryFile file("many.sdf", file_of(formats[0], 3));
  for (const Words &words :
       {Words{"boundary"}, Words{"voids"}, Words{"contacts"}, Words{"pores", "--probe", "1"}, Words{"model"},
        Words{"complex"}, Words{"cells"}, Words{"query", "--point", "0,0.5,1"}, Words{"measure", "--polar"}}) {
    Words arguments = words;
    arguments.insert(arguments.begin() + 1, {file.path(), "--models", "all"});
    const Outcome table = run_program(arguments);
    EXPECT_EQ(table.status, 0) << words[0] << table.err;
    EXPECT_EQ(lines_of(table.out).size(), 9u) << table.out;
    arguments.emplace_back("--json");
    const std::vector<std::string> objects = lines_of(run_program(arguments).out);
    ASSERT_EQ(objects.size(), 3u) << words[0];
    Words alone = words;
    alone.insert(alone.begin() + 1, {file.path(), "--model", "2", "--json"});
    const std::string own = without_input(run_program(alone).out);
    EXPECT_NE(without_input(objects[1]).find(own.substr(1)), std::string::npos) << own;
  }
}

TEST(ManyMolecules, AnyNumberOfThreads) {
  const TemporaryFile file("many.sdf", file_of(formats[0], 300));
  const std::string one = run_program(call(file.path(), {"--csv", "--threads", "1"})).out;
  EXPECT_EQ(lines_of(one).size(), 301u);
  for (const char *threads : {"2", "7"}) {
    EXPECT_EQ(run_program(call(file.path(), {"--csv", "--threads", threads})).out, one) << threads;
  }
}

// Lines of the fault are those of the file, and all others have their rows, whichever comes first.
TEST(ManyMolecules, OneThatFailsIsARow) {
  std::string bad = sdf(2);
  bad.replace(bad.find(" Cl "), 4, " Zq ");
  for (const bool first : {true, false}) {
    const std::string good = sdf(0) + sdf(1);
    const TemporaryFile file("bad.sdf", first ? bad + bad + good : good + bad + sdf(3));
    const size_t line = lines_of(first ? "" : good).size() + 6;
    const std::string reason = "line " + std::to_string(line) + ": unknown element 'Zq' (1 atom); ";
    const Outcome csv = run_program(call(file.path(), {"--csv"}));
    EXPECT_EQ(csv.status, 1);
    EXPECT_EQ(csv.err, "hardsphere: " + file.path() + ": " + (first ? "2" : "1") +
                           " of 4 molecules failed; their rows say why\n");
    const std::vector<std::string> rows = lines_of(csv.out);
    ASSERT_EQ(rows.size(), 5u) << csv.out;
    EXPECT_EQ(rows[0], "model,title,atoms,area,volume,fault");
    const std::string row = rows[first ? 1 : 3];
    EXPECT_NE(row.find("\"\"2\"\"\",,,,\"" + reason), std::string::npos) << row;
    const std::vector<std::string> objects = lines_of(run_program(call(file.path(), {"--json"})).out);
    ASSERT_EQ(objects.size(), 4u);
    const Json object = read_json(objects[first ? 0 : 2]).value();
    EXPECT_EQ(object.keys, (Words{"model", "title", "fault"}));
    EXPECT_EQ(object["fault"].text.rfind(reason, 0), 0u) << object["fault"].text;
    const Outcome table = run_program(call(file.path(), {}));
    EXPECT_EQ(table.status, 1);
    EXPECT_NE(table.out.find(name_of(2) + ": " + reason), std::string::npos) << table.out;
  }
}

TEST(ManyMolecules, NoneThatDoesNotFail) {
  const TemporaryFile bad("bad.sdf", "a\n\n\n  x\n$$$$\nb\n\n\n  y\n$$$$\n"), none("none.sdf", ""),
      binary("binary.sdf", sdf(0) + "a\1b\n");
  const Outcome csv = run_program(call(bad.path(), {"--csv"}));
  EXPECT_EQ(csv.status, 1);
  const std::vector<std::string> rows = lines_of(csv.out);
  ASSERT_EQ(rows.size(), 3u) << csv.out;
  EXPECT_EQ(rows[0], "model,title,fault");
  EXPECT_EQ(rows[2].rfind("2,b,line 9: expected", 0), 0u) << rows[2];
  const Outcome empty = run_program(call(none.path(), {"--csv"}));
  EXPECT_EQ(empty.status, 1);
  EXPECT_NE(empty.out.find("1,,no atoms in the file"), std::string::npos) << empty.out;
  const Outcome broken = run_program(call(binary.path(), {"--csv"}));
  EXPECT_EQ(broken.status, 1);
  EXPECT_EQ(lines_of(broken.out).size(), 3u) << broken.out;
  EXPECT_NE(broken.out.find("2,,,,,line 11: binary data (byte 0x01); expected text"), std::string::npos) << broken.out;
}

// Records before the first MODEL are those of all models; those after the last one are no molecule.
TEST(ManyMolecules, RecordsOfAllModels) {
  const std::string head =
      "TITLE     Some models\nCRYST1   20.000   20.000   20.000  90.00  90.00  90.00 P 1           1\n";
  const std::string tail = "CONECT    1    2\nMASTER\nEND\n";
  const TemporaryFile file("models.pdb", head + file_of(formats[2], 4) + tail);
  const Outcome rows = run_program({"measure", file.path(), "--models", "all", "--box", "file", "--csv"});
  EXPECT_EQ(rows.status, 0) << rows.err;
  const std::vector<std::string> lines = lines_of(rows.out);
  ASSERT_EQ(lines.size(), 5u) << rows.out;
  for (size_t k = 1; k < 5; ++k) {
    EXPECT_EQ(lines[k].rfind(std::to_string(k) + ",Some models,", 0), 0u) << lines[k];
    EXPECT_NE(lines[k].find(",8000,"), std::string::npos) << lines[k];
  }
  std::string bad = pdb(1);
  bad.replace(bad.find("   1.300"), 8, "   x.300");
  const TemporaryFile broken("broken.pdb", head + pdb(0) + bad + pdb(2));
  const Outcome fault = run_program({"measure", broken.path(), "--models", "all", "--csv"});
  const std::string reason = "line " + std::to_string(lines_of(head + pdb(0)).size() + 4) + ": x (columns 31-38): ";
  EXPECT_NE(fault.out.find("\n2,Some models,,,," + reason), std::string::npos) << fault.out;
  EXPECT_NE(fault.out.find("\n3,Some models,3,"), std::string::npos) << fault.out;
  // Without MODEL records each file that was put behind others has its own.
  const std::string atom = pdb_atom(1, " C1", 0, "C");
  const TemporaryFile files("files.pdb", "TITLE     one\n" + atom + "END\nTITLE     two\n" + atom + atom + "END\n");
  const std::string both = run_program(call(files.path(), {"--csv"})).out;
  EXPECT_NE(both.find("\n1,one,1,"), std::string::npos) << both;
  EXPECT_NE(both.find("\n2,two,2,"), std::string::npos) << both;
}

TEST(ManyMolecules, StandardInputAndNotes) {
  Surroundings surroundings;
  std::string flat;
  for (int k = 0; k < 12; ++k) {
    flat += "f\n\n\n  4  0\n";
    for (int i = 0; i < 4; ++i) flat += text("%10.4f%10.4f%10.4f C\n", 1.2 * i, 0.1 * i * i, 0.0);
    flat += "$$$$\n";
  }
  const TemporaryFile file("flat.sdf", flat);
  surroundings.in_path = file.path();
  surroundings.in_is_pipe = true;
  const Outcome outcome = run_program_in(surroundings, {"measure", "-", "--format", "sdf", "--models", "all"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::vector<std::string> notes = lines_of(outcome.err);
  ASSERT_EQ(notes.size(), 9u) << outcome.err;
  EXPECT_EQ(notes[0],
            "hardsphere: standard input, molecule 1: all z are 0: a flat molecule, or a drawing, which says "
            "nothing of space");
  EXPECT_EQ(notes[8], "hardsphere: standard input: notes on 4 more molecules are left out");
  const Outcome first = run_program({"measure", file.path(), "--csv"});
  EXPECT_NE(first.err.find("molecule 1 of 12 is read, and no other; --model N takes another one, --models all each"),
            std::string::npos)
      << first.err;
}

TEST(ManyMolecules, WhatTheyAreNotFor) {
  const TemporaryFile file("many.sdf", file_of(formats[0], 2)), drawing("drawing.svg");
  struct Case {
    Words arguments;
    const char *reason;
  };
  for (const Case &it : std::vector<Case>{
           {{"measure", file.path(), "--models", "all", "--model", "2"}, "--model is one of them, --models all all"},
           {{"measure", file.path(), "--models", "some"}, "'some' is neither merged nor all"},
           {{"measure", "good/water.cif", "--models", "all"}, "--models all has no use here: it is for .pdb"},
           {{"measure", file.path(), file.path(), "--models", "all"}, "--models all takes one file at a time"},
           {{"measure", file.path(), "--models", "all", "--gradient"}, "--gradient has no place in the row"},
           {{"measure", file.path(), "--models", "all", "--csv", "--json"}, "one form of output at a time"},
           {{"measure", "good/water.pdb", "--models", "all", "--assembly", "1"}, "--assembly is of one molecule"},
           {{"measure", "good/water.pdb", "--models", "all", "--pdb-out", "x.pdb"}, "not with --pdb-out"},
           {{"measure", "good/water.pdb", "--models", "all", "--trajectory", "x.xtc"}, "is not for a --trajectory"},
           {{"hessian", file.path(), "--models", "all", "--tension", "1"}, "--models all is not for hessian"},
           {{"draw", file.path(), "-o", drawing.path(), "--models", "all"}, "--models all is not for draw"},
           {{"clash", file.path(), file.path(), "--models", "all"}, "--models all is not for clash"},
           {{"measure", file.path(), "--rows", "--json"}, "--rows are of a table"},
           {{"measure", file.path(), "--rows", "--by", "chain"}, "--by has no"},
       }) {
    const Outcome outcome = run_program(it.arguments);
    EXPECT_EQ(outcome.status, 2) << it.reason;
    EXPECT_EQ(outcome.out, "") << it.reason;
    EXPECT_NE(outcome.err.find(it.reason), std::string::npos) << outcome.err;
  }
}

// A row for each file, as its JSON has it; one that fails has none.
TEST(ManyMolecules, RowsOfFiles) {
  const Words files = {"good/water.pdb", "bad/nan.pdb", "good/water.cif", "good/one.cif"};
  Words arguments = {"measure", "--rows"};
  arguments.insert(arguments.end(), files.begin(), files.end());
  const Outcome table = run_program(arguments);
  EXPECT_EQ(table.status, 1);
  EXPECT_EQ(lines_of(table.err).size(), 1u) << table.err;
  const std::vector<std::string> shown = lines_of(table.out);
  ASSERT_EQ(shown.size(), 9u) << table.out;
  EXPECT_EQ(shown[0], "good/water.pdb and 3 more");
  EXPECT_NE(shown[8].find("  good/one.cif"), std::string::npos);
  arguments.emplace_back("--csv");
  const std::vector<std::string> rows = lines_of(run_program(arguments).out);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0], "file,atoms,area,volume");
  size_t row = 1;
  for (const std::string &file : {files[0], files[2], files[3]}) {
    const Json json = run_json({"measure", file});
    EXPECT_EQ(rows[row++], file + "," + json["n"].text + "," + json["area"].text + "," + json["volume"].text);
  }
  EXPECT_EQ(lines_of(run_program({"measure", "--rows", "good/one.cif"}).out).size(), 7u);
}

// A row of the boundary in a box has its volumes, as those of measure have.
TEST(ManyMolecules, RowsOfBoxes) {
  const Words rows = lines_of(
      run_program({"boundary", "good/crystal.cif", "good/mirror.cif", "--box", "file", "--rows", "--csv"}).out);
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0], "file,atoms,vertices,arcs,circles,faces,shells,components,euler,box_volume,free_volume");
  for (size_t k = 0; k < 2; ++k) {
    const std::string file = k == 0 ? "good/crystal.cif" : "good/mirror.cif";
    const Json json = run_json({"boundary", file, "--box", "file"});
    std::string row = file + "," + json["n"].text;
    for (const char *key :
         {"vertices", "arcs", "circles", "faces", "shells", "components", "euler", "box_volume", "free_volume"}) {
      row += "," + json[key].text;
    }
    EXPECT_EQ(rows[k + 1], row);
  }
}

// The heading is of all files: whatever the first one is, the units of others are not its own.
TEST(ManyMolecules, HeadingsOfFiles) {
  struct Case {
    Words files;
    int status;
    Words heading;  // behind the line of names
  };
  const std::string probe = "  probe            1.4 angstrom, added to every radius: the solvent-accessible surface";
  const std::string unit = "  unit             of lengths angstrom; areas and volumes are its powers";
  const std::string radii = "  radii            bondi";
  const std::string any_probe =
      "  probe            1.4 in the unit of each file, added to every radius: the solvent-accessible surface";
  const std::string any_unit = "  unit             of lengths that of each file; areas and volumes are its powers";
  const std::vector<Case> cases = {
      {{"unknown.extension", "good/water.pdb"}, 1, {radii, probe, unit}},
      {{"good/water.pdb", "good/one.cif"}, 0, {radii, probe, unit}},
      {{"good/water.pqr", "good/water.pdb"}, 0, {radii + ", or from the file", probe, unit}},
      {{"good/one.xyzr", "good/water.pdb"}, 0, {radii + ", or from the file", any_probe, any_unit}},
      {{"good/water.pdb", "good/one.xyzr"}, 0, {radii + ", or from the file", any_probe, any_unit}}};
  for (const Case &each : cases) {
    Words arguments = {"measure", "--rows", "--probe", "1.4"};
    arguments.insert(arguments.end(), each.files.begin(), each.files.end());
    const Outcome table = run_program(arguments);
    EXPECT_EQ(table.status, each.status) << table.err;
    const std::vector<std::string> shown = lines_of(table.out);
    ASSERT_EQ(shown.size(), 8u - static_cast<size_t>(each.status)) << table.out;
    EXPECT_EQ(shown[0], each.files[0] + " and 1 more");
    EXPECT_EQ(Words(shown.begin() + 1, shown.begin() + 4), each.heading);
    EXPECT_EQ(lines_of(table.err).size(), static_cast<size_t>(each.status)) << table.err;
  }
}

}  // namespace
