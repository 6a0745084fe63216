// Frameworks in the units of papers: radii of UFF, areas and volumes by gram and by cm^3, densities, a table of files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Words = std::vector<std::string>;

struct Atom {
  std::string element;
  double x, y, z;
};

// A crystal without symmetry, by fractions of a cell of right angles.
std::string cif(const std::vector<Atom> &atoms, double a, double b, double c) {
  char line[200];
  std::snprintf(line, sizeof line, "data_x\n_cell_length_a %.6f\n_cell_length_b %.6f\n_cell_length_c %.6f\n", a, b, c);
  std::string text = line;
  text +=
      "_cell_angle_alpha 90\n_cell_angle_beta 90\n_cell_angle_gamma 90\n_symmetry_space_group_name_H-M 'P 1'\nloop_\n"
      "_symmetry_equiv_pos_as_xyz\n'x, y, z'\nloop_\n"
      "_atom_site_label\n_atom_site_type_symbol\n_atom_site_fract_x\n_atom_site_fract_y\n_atom_site_fract_z\n";
  for (const Atom &atom : atoms) {
    std::snprintf(line, sizeof line, "%s1 %s %.9f %.9f %.9f\n", atom.element.c_str(), atom.element.c_str(), atom.x,
                  atom.y, atom.z);
    text += line;
  }
  return text;
}

Json pores(const std::string &path, const std::string &probe, const Words &more = {}) {
  Words words = {"pores", path, "--box", "file", "--regions", "--probe", probe};
  words.insert(words.end(), more.begin(), more.end());
  return run_json(words);
}

// One argon atom in a cube of 6 angstrom: its numbers by hand.
TEST(Frameworks, ASimpleCube) {
  const TemporaryFile file("cube.cif", cif({{"Ar", 0, 0, 0}}, 6, 6, 6));
  const double pi = 3.14159265358979323846, avogadro = 6.02214076e23, mass = 39.95;
  const double radius = 1.723 + 1.0, sphere = 4 * pi * radius * radius, ball = 4 * pi * std::pow(radius, 3) / 3;
  const Json json = pores(file.path(), "1.0", {"--radii", "uff"});
  const double gram = mass / avogadro, cube = 216e-24;  // g and cm^3
  EXPECT_NEAR(json["density"].number, gram / cube, 1e-9);
  EXPECT_EQ(json["mass"].text, "39.95");
  EXPECT_NEAR(json["accessible_area"].number, sphere, 1e-6);
  EXPECT_NEAR(json["accessible_area_m2_per_g"].number, sphere * 1e-20 / gram, 1e-4);
  EXPECT_NEAR(json["accessible_area_m2_per_cm3"].number, sphere * 1e-20 / cube, 1e-4);
  EXPECT_NEAR(json["accessible_volume_cm3_per_g"].number, (216 - ball) * 1e-24 / gram, 1e-8);
  EXPECT_NEAR(json["accessible_volume_fraction"].number, 1 - ball / 216, 1e-9);
  EXPECT_EQ(json["blocked_area_m2_per_g"].number, 0.0);
  EXPECT_EQ(json["total_area"].text, json["accessible_area"].text);
  EXPECT_EQ(json["total_volume_fraction"].text, json["accessible_volume_fraction"].text);
  const Outcome table =
      run_program({"pores", file.path(), "--box", "file", "--regions", "--probe", "1", "--radii", "uff"});
  EXPECT_NE(table.out.find("  density          0.3071         g/cm^3"), std::string::npos) << table.out;
  EXPECT_NE(table.out.find("ASA of Zeo++"), std::string::npos) << table.out;
}

// A cage of touching balls has blocked space, and all of it is what `measure` finds in the box by another way.
TEST(Frameworks, TotalsAreThoseOfMeasure) {
  std::vector<Atom> atoms;
  for (int k = 0; k < 26; ++k) {
    const int x = k / 9 - 1, y = k / 3 % 3 - 1, z = (k + (k >= 13 ? 1 : 0)) % 3 - 1;
    atoms.push_back({k % 3 == 0 ? "Si" : "O", 0.5 + x * 0.13, 0.5 + y * 0.13, 0.5 + z * 0.13});
  }
  const TemporaryFile file("cage.cif", cif(atoms, 15, 15, 15));
  for (const char *probe : {"0.2", "0.9"}) {
    const Json json = pores(file.path(), probe);
    const Json box = run_json({"measure", file.path(), "--box", "file", "--probe", probe});
    EXPECT_NEAR(json["total_area"].number, box["area"].number, 1e-6 * box["area"].number) << probe;
    EXPECT_NEAR(json["total_volume"].number, box["free_volume"].number, 1e-6 * box["free_volume"].number) << probe;
    EXPECT_EQ(json["total_area"].number, json["accessible_area"].number + json["blocked_area"].number);
    EXPECT_NEAR(json["accessible_volume_fraction"].number + json["blocked_volume_fraction"].number,
                json["total_volume_fraction"].number, 1e-12);
    EXPECT_NEAR(json["total_area_m2_per_cm3"].number, 1e4 * json["total_area"].number / 3375, 1e-6);
  }
}

// Measure has the same totals of a box, and the density, without finding pores; of a part of the atoms no area of all.
TEST(Frameworks, MeasureHasTotalsToo) {
  const TemporaryFile file("cube.cif", cif({{"Ar", 0, 0, 0}, {"O", 0.5, 0.5, 0.5}}, 7, 6, 6));
  const Words words = {"measure", file.path(), "--box", "file", "--probe", "0.5"};
  const Json measured = run_json(words), found = pores(file.path(), "0.5");
  EXPECT_NEAR(measured["mass"].number, 55.949, 1e-9);
  EXPECT_EQ(measured["density"].text, found["density"].text);
  for (const char *key :
       {"total_area_m2_per_cm3", "total_area_m2_per_g", "total_volume_fraction", "total_volume_cm3_per_g"}) {
    EXPECT_NEAR(measured[key].number, found[key].number, 1e-9 * found[key].number) << key;
  }
  EXPECT_EQ(measured["total_volume_fraction"].number, measured["free_volume"].number / measured["box_volume"].number);
  Words arguments = words;
  arguments.insert(arguments.end(), {"--of", "element:O"});
  const Json part = run_json(arguments);
  EXPECT_EQ(part["total_area_m2_per_g"].kind, Json::Kind::null);
  EXPECT_EQ(part["density"].text, found["density"].text);
  const std::string table = run_program(words).out;
  EXPECT_NE(table.find("\n  void fraction    0.6389 of the cell"), std::string::npos) << table;
  EXPECT_NE(table.find("\n  area by mass     "), std::string::npos) << table;
  const std::string unknown = run_program({"measure", "good/two.xyzr", "--box", "9,9,9"}).out;
  EXPECT_NE(unknown.find("\n  void fraction    "), std::string::npos) << unknown;
  EXPECT_EQ(unknown.find("by mass"), std::string::npos) << unknown;
  EXPECT_EQ(unknown.find("density"), std::string::npos) << unknown;
}

// Atoms that take turns at places count whole, all of them, and a line says how many: of those that are chosen, and of
// one group where they belong to groups.
TEST(Frameworks, OccupanciesAreTold) {
  const std::string plain = cif({{"Si", 0, 0, 0}, {"O", 0.5, 0, 0}, {"O", 0.6, 0, 0}}, 9, 9, 9);
  const auto with_column = [&](const std::string &tags, const std::vector<std::string> &values) {
    std::string text = plain;
    text.insert(text.find("_atom_site_fract_z\n") + 19, tags);
    size_t at = text.find("Si1 ");
    for (const std::string &value : values) {
      at = text.find('\n', at);
      text.insert(at, " " + value);
      at += value.size() + 2;
    }
    return text;
  };
  const auto note_of = [](const std::string &text, const Words &more) {
    const TemporaryFile file("parts.cif", text);
    Words words = {"measure", file.path(), "--box", "file"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run_program(words);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const size_t begin = outcome.err.rfind(": ");
    return begin == std::string::npos ? "" : outcome.err.substr(begin + 2);
  };
  const std::string occupied = "_atom_site_occupancy\n";
  EXPECT_EQ(note_of(plain, {}), "");
  EXPECT_EQ(note_of(with_column(occupied, {"1", "1.0(3)", "?"}), {}), "");
  const std::string halves = with_column(occupied, {"1", "0.5(1)", "0.5"});
  EXPECT_EQ(note_of(halves, {}), "2 atoms of an occupancy below 1 count whole, as if always there\n");
  EXPECT_EQ(note_of(halves, {"--only", "element:Si"}), "");
  const std::string groups = with_column(occupied + "_atom_site_disorder_group\n", {"1 .", "0.4 1", "0.6 2"});
  EXPECT_EQ(note_of(groups, {}), "1 atom of an occupancy below 1 counts whole, as if always there\n");
  EXPECT_EQ(note_of(groups, {"--altloc", "occupancy"}),
            "1 atom of an occupancy below 1 counts whole, as if always there\n");
}

// Rock salt: 2.163 g/cm^3; twice the cell is as dense; an element without a weight has no density, and areas by volume.
TEST(Frameworks, Densities) {
  const std::vector<Atom> salt = {{"Na", 0, 0, 0},  {"Na", 0, .5, .5},  {"Na", .5, 0, .5}, {"Na", .5, .5, 0},
                                  {"Cl", .5, 0, 0}, {"Cl", .5, .5, .5}, {"Cl", 0, 0, .5},  {"Cl", 0, .5, 0}};
  std::vector<Atom> twice;
  for (const Atom &atom : salt) {
    for (const double shift : {0.0, 0.5}) twice.push_back({atom.element, atom.x / 2 + shift, atom.y, atom.z});
  }
  const TemporaryFile one("salt.cif", cif(salt, 5.6402, 5.6402, 5.6402)),
      two("salts.cif", cif(twice, 11.2804, 5.6402, 5.6402)), polonium("polonium.cif", cif({{"Po", 0, 0, 0}}, 6, 6, 6));
  const Json single = pores(one.path(), "0.2", {"--radii", "uff"}), twin = pores(two.path(), "0.2", {"--radii", "uff"});
  EXPECT_NEAR(single["density"].number, 2.1634, 1e-4);
  EXPECT_EQ(single["mass"].text, "233.76");
  EXPECT_NEAR(twin["density"].number, single["density"].number, 1e-12);
  for (const char *key :
       {"total_area_m2_per_g", "total_area_m2_per_cm3", "total_volume_cm3_per_g", "total_volume_fraction"}) {
    EXPECT_NEAR(twin[key].number, single[key].number, 1e-6 * single[key].number) << key;
  }
  const Json none = pores(polonium.path(), "1");
  EXPECT_EQ(none["density"].kind, Json::Kind::null);
  EXPECT_EQ(none["accessible_area_m2_per_g"].kind, Json::Kind::null);
  EXPECT_GT(none["accessible_area_m2_per_cm3"].number, 0.0);
  EXPECT_GT(none["accessible_volume_fraction"].number, 0.0);
}

// Coordinates in anybody's unit have fractions alone, and without a box there is no cell to divide by.
TEST(Frameworks, WithoutAUnit) {
  const Json json = run_json({"pores", "good/two.xyzr", "--box", "9,9,9", "--regions", "--probe", "0.1"});
  EXPECT_EQ(json["density"].kind, Json::Kind::null);
  EXPECT_EQ(json["total_area_m2_per_cm3"].kind, Json::Kind::null);
  EXPECT_GT(json["total_volume_fraction"].number, 0.0);
  EXPECT_EQ(run_json({"pores", "good/two.xyzr", "--regions", "--probe", "0.1"})["density"].kind, Json::Kind::null);
  const Words keys = run_json({"pores", "good/two.xyzr", "--regions", "--probe", "0.1"}).keys;
  EXPECT_EQ(std::count(keys.begin(), keys.end(), "density"), 0);
}

// A table over many files in one call: rows are the keys of each file's JSON.
TEST(Frameworks, RowsOfManyFiles) {
  const TemporaryFile first("one.cif", cif({{"Ar", 0, 0, 0}}, 6, 6, 6)),
      second("two.cif", cif({{"Kr", 0, 0, 0}}, 7, 6, 6));
  const Words files = {first.path(), second.path()};
  const Words options = {"--box", "file", "--regions", "--probe", "1", "--radii", "uff", "--rows"};
  Words arguments = {"pores", files[0], files[1]};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome table = run_program(arguments);
  EXPECT_EQ(table.status, 0) << table.err;
  EXPECT_NE(table.out.find("density   ASA, m^2/cm^3      ASA, m^2/g      AV, cm^3/g"), std::string::npos) << table.out;
  arguments.emplace_back("--csv");
  std::istringstream lines(run_program(arguments).out);
  std::string line;
  std::vector<Words> cells;
  while (std::getline(lines, line)) {
    cells.emplace_back();
    std::istringstream parts(line);
    for (std::string part; std::getline(parts, part, ',');) cells.back().push_back(part);
  }
  ASSERT_EQ(cells.size(), 3u);
  for (size_t file = 0; file < 2; ++file) {
    const Json json = pores(files[file], "1", {"--radii", "uff"});
    for (size_t k = 0; k < cells[0].size(); ++k) {
      const Json &value = json[cells[0][k]];
      if (value.kind != Json::Kind::number) continue;
      EXPECT_EQ(cells[file + 1][k], value.text) << cells[0][k];
    }
    const auto at = static_cast<size_t>(std::find(cells[0].begin(), cells[0].end(), "pore_limiting_diameter_3d") -
                                        cells[0].begin());
    ASSERT_LT(at, cells[0].size());
    EXPECT_EQ(cells[file + 1][at], json["pore_limiting_diameter"].items[2].text);
  }
}

}  // namespace
