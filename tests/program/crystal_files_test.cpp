// .cif files beside those of the Protein Data Bank: crystals of small molecules and frameworks, with fractions of their
// cell, and chemical components with several sets of coordinates.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Words = std::vector<std::string>;

const std::string cell =
    "_cell_length_a 10.0(3)\n_cell_length_b 12\n_cell_length_c 14.00\n_cell_angle_alpha 80\n_cell_angle_beta "
    "95.5(1)\n_cell_angle_gamma 110\n";

std::string sites(const Words &items, const std::string &rows) {
  std::string text = "loop_\n";
  for (const std::string &item : items) text.append("_atom_site_").append(item).append("\n");
  return text + rows;
}

Words column(const Json &found, const std::string &key) {
  Words words;
  for (const Json &ball : found["balls"].items) words.push_back(ball[key].text);
  return words;
}

Json read(const std::string &text, const Words &more = {}) {
  const TemporaryFile file("crystal.cif", "data_one\n" + text);
  Words arguments = {"measure", file.path(), "--per-ball"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_json(arguments);
}

std::string refusal(const std::string &text) {
  const TemporaryFile file("refused.cif", "data_one\n" + text);
  const Outcome outcome = run_program({"measure", file.path()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, "");
  return outcome.err;
}

double length(const Json &a, const Json &b) {
  double square = 0;
  for (size_t k = 0; k < 3; ++k) square += std::pow(a["xyz"].items.at(k).number - b["xyz"].items.at(k).number, 2);
  return std::sqrt(square);
}

// Distances by the metric of the cell, wherever its items stand.
TEST(CrystalFiles, FractionsBecomeAngstrom) {
  const std::string atoms =
      sites({"label", "fract_x", "fract_y", "fract_z"}, "C1 0.1234(5) -0.25 1.5\nC2 0.25(1) 0.3333 .2\nC3 0 1 0\n");
  for (const std::string &text : {cell + atoms, atoms + cell}) {
    const Json found = read(text);
    const std::vector<Json> &balls = found["balls"].items;
    ASSERT_EQ(balls.size(), 3U);
    const double degree = 3.14159265358979323846 / 180;
    const double a = 10, b = 12, c = 14;
    const double bc = b * c * std::cos(80 * degree), ca = c * a * std::cos(95.5 * degree),
                 ab = a * b * std::cos(110 * degree);
    const auto expected = [&](double x, double y, double z) {
      return std::sqrt(x * x * a * a + y * y * b * b + z * z * c * c + 2 * (y * z * bc + z * x * ca + x * y * ab));
    };
    EXPECT_NEAR(length(balls[0], balls[1]), expected(0.1266, 0.25 + 1.0 / 3, -1.3), 1e-7);
    EXPECT_NEAR(length(balls[1], balls[2]), expected(-0.25, 2.0 / 3, -0.2), 1e-7);
    EXPECT_NEAR(length(balls[0], balls[2]), expected(-0.1234, 1.25, -1.5), 1e-7);
    EXPECT_EQ(column(found, "atom"), (Words{"C1", "C2", "C3"}));
    EXPECT_EQ(found["input"]["coordinates"].text, "fract_x");
  }
  // A cell without atoms before it, and one of another block behind, are not theirs.
  const Json found =
      read("_cell_length_a 5\ndata_two\n" + cell + atoms + "data_three\n_cell_length_a 7\n", {"--box", "file"});
  EXPECT_NEAR(found["box"].items.at(0).number, 10, 1e-12);
}

TEST(CrystalFiles, ElementsAreOfSymbolsOrLabels) {
  const std::string symbols =
      sites({"type_symbol", "label", "fract_x", "fract_y", "fract_z"}, "Zn2+ X1 0 0 0\nO2- Y2 0 0 .2\nC CA 0 0 .4\n");
  EXPECT_EQ(column(read(cell + symbols), "element"), (Words{"Zn", "O", "C"}));
  const std::string labels =
      sites({"label", "fract_x", "fract_y", "fract_z"},
            "Zn1 0 0 0\nC12A 0 0 .1\nO2- 0 0 .2\nCl(1) 0 0 .3\nH1W 0 0 .4\nOW 0 0 .5\nN 0 0 .6\nZN2 0 0 .7\n");
  EXPECT_EQ(column(read(cell + labels), "element"), (Words{"Zn", "C", "O", "Cl", "H", "O", "N", "Zn"}));
  EXPECT_NE(refusal(cell + sites({"label", "fract_x", "fract_y", "fract_z"}, "CO1 0 0 0\n"))
                .find("no type_symbol, and the label 'CO1' does not tell the element"),
            std::string::npos);
}

// Atoms without a place, and those of which the file has another place, are left out and counted.
TEST(CrystalFiles, WhatHasNoPlaceIsLeftOut) {
  const Json found =
      read(cell + sites({"label", "fract_x", "fract_y", "fract_z", "disorder_assembly", "disorder_group", "calc_flag"},
                        "C1 0 0 0 . . d\nC2 ? . ? . . d\nC3 0 0 0.2 . . dum\nC4 0 0.5 0 A 1 d\n"
                        "C5 0 0.51 0 A 2 d\nC6 0.5 0 0 B 2 d\nC7 0.5 0 0.1 A 1 d\nC8 0.5 0.1 0 B 1 d\n"));
  EXPECT_EQ(column(found, "atom"), (Words{"C1", "C4", "C6", "C7"}));
  EXPECT_EQ(found["input"]["left_out"]["unplaced"].number, 2);
  EXPECT_EQ(found["input"]["left_out"]["alternate_locations"].number, 2);
  const TemporaryFile file(
      "places.cif", "data_one\n" + cell + sites({"label", "fract_x", "fract_y", "fract_z"}, "C1 0 0 0\nC2 ? ? ?\n"));
  const std::string table = run_program({"measure", file.path()}).out;
  EXPECT_NE(table.find("  left out         1 atom without coordinates\n"), std::string::npos) << table;
  EXPECT_NE(table.find("  coordinates      fract_x\n"), std::string::npos) << table;
}

// The dictionary's value of an angle that is not given, or is said to be the usual one.
TEST(CrystalFiles, AnglesAreRightIfNotGiven) {
  const std::string lengths = "_cell_length_a 10\n_cell_length_b 12\n_cell_length_c 14\n";
  const std::string atoms = sites({"label", "fract_x", "fract_y", "fract_z"}, "C1 0 0 0\nC2 0.5 0.25 0.75\n");
  for (const char *angles : {"", "_cell_angle_alpha 90\n_cell_angle_beta 90\n_cell_angle_gamma 90\n",
                             "_cell_angle_beta 90\n", "_cell_angle_alpha .\n_cell_angle_gamma 90.0(1)\n"}) {
    const Json found = read(lengths + angles + atoms, {"--box", "file"});
    const std::vector<Json> &at = found["balls"].items.at(1)["xyz"].items;
    EXPECT_EQ(at.at(0).number, 5) << angles;
    EXPECT_EQ(at.at(1).number, 3) << angles;
    EXPECT_EQ(at.at(2).number, 10.5) << angles;
    EXPECT_EQ(found["box"].items.at(4).number, 12) << angles;
  }
  const Json oblique = read(lengths + "_cell_angle_beta 120\n" + atoms);
  EXPECT_NEAR(oblique["balls"].items.at(1)["xyz"].items.at(0).number, 5 - 10.5 / 2, 1e-9);
}

TEST(CrystalFiles, WhatIsMissingIsSaid) {
  const std::string atoms = sites({"label", "fract_x", "fract_y", "fract_z"}, "C1 0 0 0\n");
  EXPECT_NE(refusal(atoms).find("fractional coordinates, but no cell"), std::string::npos);
  EXPECT_NE(refusal(cell.substr(cell.find("_cell_length_b")) + atoms).find("no cell"), std::string::npos);
  EXPECT_NE(refusal(cell.substr(0, cell.find("_cell_angle_gamma")) + "_cell_angle_gamma ?\n" + atoms).find("no cell"),
            std::string::npos);
  EXPECT_NE(refusal("_cell_length_a 1\n_cell_length_b 1\n_cell_length_c 1\n_cell_angle_alpha 90\n_cell_angle_beta 90\n"
                    "_cell_angle_gamma 90\n" +
                    atoms)
                .find("the cell is none"),
            std::string::npos);
  EXPECT_NE(refusal(cell + sites({"label", "fract_x", "fract_y", "fract_z"}, "C1 0 east 0\n")).find("fract_y: 'east'"),
            std::string::npos);
  EXPECT_NE(refusal(cell + sites({"label", "fract_x", "fract_z"}, "C1 0 0\n")).find("_atom_site has no fract_y"),
            std::string::npos);
  EXPECT_NE(refusal("_cell_length_a long\n" + atoms).find("a: 'long'"), std::string::npos);
  // Other tables of atoms are none of coordinates.
  EXPECT_EQ(read(cell + "loop_\n_atom_site_aniso_label\n_atom_site_aniso_U_11\nC1 0.1\n" + atoms +
                 "loop_\n_atom_site_label\n_atom_site_occupancy\nC1 1\n")["n"]
                .number,
            1);
}

// mmCIF has Cartesian coordinates, and its cell beside them.
TEST(CrystalFiles, EntriesHaveTheirCell) {
  const std::string entry =
      cell +
      "loop_\n_atom_site.type_symbol\n_atom_site.fract_x\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
      "_atom_site.Cartn_z\nC 0.5 1 2 3\n";
  const Json found = read(entry, {"--box", "file"});
  EXPECT_EQ(found["balls"].items.at(0)["xyz"].items.at(2).number, 3);
  EXPECT_EQ(found["box"].items.at(0).number, 10);
  EXPECT_EQ(found["input"]["coordinates"].text, "Cartn_x");
}

std::string component(const std::string &name, const Words &items, const std::string &rows) {
  std::string text = "loop_\n";
  for (const std::string &item : items) text.append("_chem_comp_atom.").append(item).append("\n");
  std::string all = rows;
  for (size_t at; (at = all.find('@')) != std::string::npos;) all.replace(at, 1, name);
  return text + all;
}

const Words model = {"model_Cartn_x", "model_Cartn_y", "model_Cartn_z"};
const Words ideal = {"pdbx_model_Cartn_x_ideal", "pdbx_model_Cartn_y_ideal", "pdbx_model_Cartn_z_ideal"};

Words joined(std::initializer_list<Words> parts) {
  Words all = {"comp_id", "atom_id", "type_symbol"};
  for (const Words &part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

TEST(CrystalFiles, ComponentsHaveTheirFirstWholeSet) {
  const struct {
    std::string text;
    const char *set;
    double x;
  } cases[] = {
      {component("AB1", joined({model, ideal}), "@ C1 C 1 0 0 11 0 0\n@ FE FE 2 0 0 12 0 0\n"),
       "pdbx_model_Cartn_x_ideal", 12},
      {component("AB1", joined({model, ideal}), "@ C1 C 1 0 0 11 ? 0\n@ FE FE 2 0 0 12 0 0\n"), "model_Cartn_x", 2},
      {component("AB1", joined({model, ideal, {"x", "y", "z"}}),
                 "@ C1 C 1 0 0 ? ? ? 21 0 0\n@ FE FE ? ? ? 1 1 1 22 0 0\n"),
       "x", 22},
      {component("AB1", joined({{"x", "y", "z"}}), "@ C1 C 21 0 0\n@ FE FE 22 0 0\n"), "x", 22},
  };
  for (const auto &it : cases) {
    const Json found = read(it.text);
    EXPECT_EQ(found["input"]["coordinates"].text, it.set);
    ASSERT_EQ(found["balls"].items.size(), 2U);
    EXPECT_EQ(found["balls"].items[1]["xyz"].items.at(0).number, it.x) << it.set;
    EXPECT_EQ(column(found, "element"), (Words{"C", "Fe"}));
    EXPECT_EQ(column(found, "residue"), (Words{"AB1", "AB1"}));
    const TemporaryFile file("component.cif", "data_one\n" + it.text);
    const std::string table = run_program({"measure", file.path()}).out;
    EXPECT_NE(table.find(std::string("  coordinates      ") + it.set + "\n"), std::string::npos) << table;
  }
  EXPECT_NE(refusal(component("AB1", joined({model, ideal}), "@ C1 C 1 0 0 11 ? 0\n@ FE FE ? 0 0 12 0 0\n"))
                .find("a chemical component without a whole set of coordinates"),
            std::string::npos);
}

// In a file with a structure they are its dictionary, before it or behind it; several are models.
TEST(CrystalFiles, StructuresComeBeforeComponents) {
  const std::string one = component("AB1", joined({model}), "@ C1 C 1 0 0\n@ C2 C 2 0 0\n");
  const std::string two = component("CD2", joined({model}), "@ N1 N 3 0 0\n");
  const std::string structure =
      "loop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\nO 7 0 0\n";
  for (const std::string &text : {one + structure, structure + one, one + two + "data_two\n" + structure,
                                  component("AB1", {"comp_id", "atom_id", "type_symbol"}, "@ C1 C\n") + structure}) {
    const Json found = read(text);
    EXPECT_EQ(column(found, "element"), (Words{"O"}));
    EXPECT_EQ(found["input"]["models"].number, 1);
    EXPECT_EQ(found["input"]["left_out"]["other_models"].number, 0);
  }
  const Json second = read(one + "data_two\n" + two, {"--model", "2"});
  EXPECT_EQ(column(second, "element"), (Words{"N"}));
  EXPECT_EQ(second["input"]["left_out"]["other_models"].number, 2);
  EXPECT_EQ(read(one + two)["n"].number, 2);
}

}  // namespace
