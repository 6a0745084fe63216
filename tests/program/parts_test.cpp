// Groups of an index file, and parts of a molecule that the rest blocks, against the table of all its balls.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "json_outcome.hpp"
#include "json_reader.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Lines = std::vector<std::string>;

Json json_of(const Lines &arguments) {
  Lines call = arguments;
  call.emplace_back("--json");
  const Outcome outcome = run_program(call);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return read_json(outcome.out).value_or(Json{});
}

class Parts : public testing::Test {
 protected:
  const std::string crambin = molecules_folder() + "/crambin.pdb";
  const TemporaryFile index{
      "parts.ndx",
      "; comment\n[ Begin ]\n   3 1 2\n2 1 ; again\n\n[Empty]\n[ A & B ]\n9 8 7\n[ Begin ]\n5\n[ A_&_CA ]\n2 9\n"};
  const std::vector<Json> whole = json_of({"measure", crambin, "--probe", "1.4", "--per-ball"})["balls"].items;
};

// Areas of a part are those of the whole molecule, bit for bit.
TEST_F(Parts, ArePartsOfTheWhole) {
  for (const char *part : {"residue:7-9", "element:S", "atom:CA&residue:1-20", "group:Begin", "group:2", "group:A_&_CA",
                           "group:A_&_CA&residue:1"}) {
    const Json found =
        json_of({"measure", crambin, "--probe", "1.4", "--per-ball", "--of", part, "--index", index.path()});
    double sum = 0;
    ASSERT_GT(found["balls"].items.size(), 0U) << part;
    EXPECT_EQ(found["measured"].number, static_cast<double>(found["balls"].items.size()));
    EXPECT_EQ(found["n"].number, 327);
    EXPECT_EQ(found["volume"].kind, Json::Kind::null);
    for (const Json &ball : found["balls"].items) {
      const Json &same = whole[static_cast<size_t>(ball["ball"].number)];
      EXPECT_EQ(ball["area"].number, same["area"].number) << part;
      sum += same["area"].number;
    }
    EXPECT_NEAR(found["area"].number, sum, 1e-10);
  }
}

// Two --of are a union; --only leaves out what then blocks nothing.
TEST_F(Parts, OfWhatIsRead) {
  const auto measured = [&](const Lines &more) {
    Lines all = {"measure", crambin, "--probe", "1.4"};
    all.insert(all.end(), more.begin(), more.end());
    return json_of(all);
  };
  const double both = measured({"--of", "residue:3", "--of", "residue:5"})["area"].number;
  EXPECT_NEAR(both, measured({"--of", "residue:3"})["area"].number + measured({"--of", "residue:5"})["area"].number,
              1e-10);
  EXPECT_GT(measured({"--only", "residue:3", "--of", "residue:3"})["area"].number,
            measured({"--of", "residue:3"})["area"].number);
  EXPECT_EQ(measured({"--only", "residue:3", "--of", "residue:3"})["area"].number,
            measured({"--only", "residue:3"})["area"].number);
  const Json polar = measured({"--of", "element:N", "--polar"});
  EXPECT_EQ(polar["apolar_area"].number, 0);
  EXPECT_NEAR(polar["polar_area"].number, polar["area"].number, 1e-10);
}

// In a box that cuts through the molecule, too, as areas of balls there are those of a molecule in one piece.
TEST_F(Parts, AreasInABox) {
  const Lines boxed = {"measure", crambin, "--probe", "1.4", "--box", "22,21,20", "--per-ball", "--polar"};
  const auto with = [&boxed](const Lines &more) {
    Lines call = boxed;
    call.insert(call.end(), more.begin(), more.end());
    return json_of(call);
  };
  const Json all = with({}), found = with({"--of", "residue:7-20"});
  double sum = 0, by_residue = 0;
  ASSERT_EQ(found["measured"].number, static_cast<double>(found["balls"].items.size()));
  for (const Json &ball : found["balls"].items) {
    EXPECT_EQ(ball["area"].number, all["balls"].items[static_cast<size_t>(ball["ball"].number)]["area"].number);
    sum += ball["area"].number;
  }
  const Json residues = with({"--of", "residue:7-20", "--by", "residue"})["residues"];
  EXPECT_EQ(residues.items.size(), 14U);
  for (const Json &residue : residues.items) by_residue += residue["area"].number;
  EXPECT_GT(sum, 10);
  EXPECT_LT(sum, all["area"].number - 10);
  EXPECT_NEAR(found["area"].number, sum, 1e-9);
  EXPECT_NEAR(by_residue, sum, 1e-9);
  EXPECT_NEAR(found["polar_area"].number + found["apolar_area"].number + found["other_area"].number, sum, 1e-9);
  EXPECT_EQ(found["volume"].kind, Json::Kind::null);
  EXPECT_EQ(found["free_volume"].number, all["free_volume"].number);
}

// Two parts that make up a molecule have its curvatures, gradients and weighted areas in all.
TEST_F(Parts, AddUp) {
  const TemporaryFile weights("weights.txt", [] {
    std::string text;
    for (int k = 0; k < 327; ++k) text += std::to_string(k % 7 - 3) + "\n";
    return text;
  }());
  for (const Lines &box : {Lines{}, Lines{"--box", "22,21,20"}}) {
    const auto with = [&](const Lines &more) {
      Lines call = {"measure", crambin, "--probe", "1.4", "--curvature", "--gradient", "--weights", weights.path()};
      call.insert(call.end(), box.begin(), box.end());
      call.insert(call.end(), more.begin(), more.end());
      return json_of(call);
    };
    const Json all = with({}), one = with({"--of", "residue:1-21"}), other = with({"--of", "residue:22-46"});
    for (const char *of : {"area", "mean_curvature", "gauss_curvature", "weighted_area"}) {
      EXPECT_GT(std::abs(one[of].number), 1) << of;
      EXPECT_NEAR(one[of].number + other[of].number, all[of].number, 1e-9) << of;
    }
    ASSERT_EQ(one["balls"].items.size(), 327U);
    EXPECT_EQ(one["balls"].items[0]["volume_gradient"].kind, Json::Kind::null);
    EXPECT_EQ(one["balls"].items[0]["volume_dr"].kind, Json::Kind::null);
    for (size_t i = 0; i < 327; ++i) {
      const Json &a = one["balls"].items[i], &b = other["balls"].items[i], &both = all["balls"].items[i];
      for (const char *of : {"area", "area_dr", "weighted_dr"}) {
        EXPECT_NEAR(a[of].number + b[of].number, both[of].number, 1e-9) << of << i;
      }
      for (const char *of : {"area_gradient", "weighted_gradient"}) {
        for (size_t k = 0; k < 3; ++k) {
          EXPECT_NEAR(a[of].items[k].number + b[of].items[k].number, both[of].items[k].number, 1e-9) << of << i;
        }
      }
      for (const char *of : {"area", "weight"}) EXPECT_EQ((i < 153 ? b : a)[of].kind, Json::Kind::null) << of << i;
    }
    for (size_t k = 0; k < 9 && !box.empty(); ++k) {
      EXPECT_NEAR(one["strain_area"].items[k].number + other["strain_area"].items[k].number,
                  all["strain_area"].items[k].number, 1e-8);
    }
  }
}

// The derivatives of a part's area by an atom of it and by one that only blocks, as difference quotients.
TEST_F(Parts, GradientOfAPart) {
  const auto atom_at = [](double x) {
    char line[400];
    std::snprintf(line, sizeof line, "ATOM      2  C   GLY B   2    %8.3f%8.3f%8.3f  1.00  0.00           C  \n", x,
                  0.5, 0.25);
    return std::string("ATOM      1  C   GLY A   1       0.000   0.000   0.000  1.00  0.00           C  \n") + line;
  };
  const struct {
    Lines box;
    double x;
  } cases[] = {{{}, 2}, {{"--box", "8,9,9"}, 6}};  // the second one across a face of the box
  for (const auto &[box, at] : cases) {
    const auto measured = [&, &box = box](double x) {
      const TemporaryFile file("two.pdb", atom_at(x));
      Lines call = {"measure", file.path(), "--of", "chain:A", "--gradient"};
      call.insert(call.end(), box.begin(), box.end());
      return json_of(call);
    };
    const Json here = measured(at);
    const double quotient = (measured(at + 0.001)["area"].number - measured(at - 0.001)["area"].number) / 0.002;
    const double by_blocking = here["balls"].items[1]["area_gradient"].items[0].number;
    EXPECT_GT(std::abs(quotient), 1);
    EXPECT_NEAR(by_blocking, quotient, 1e-4);
    EXPECT_NEAR(here["balls"].items[0]["area_gradient"].items[0].number, -by_blocking, 1e-10);
  }
}

TEST_F(Parts, GroupsOfAnIndexFile) {
  const Json found =
      json_of({"measure", crambin, "--probe", "1.4", "--by", "group", "--index", index.path(), "--hide", "atom:CA"});
  const struct {
    const char *name;
    std::set<size_t> balls;
  } groups[] = {{"Begin", {0, 2}}, {"Empty", {}}, {"A & B", {6, 7}}, {"Begin", {4}}, {"A_&_CA", {}}};
  // Atoms by their place in the file: 1 is a CA, which is left out, as is another CA, 8.
  const std::vector<Json> balls =
      json_of({"measure", crambin, "--probe", "1.4", "--per-ball", "--hide", "atom:CA"})["balls"].items;
  ASSERT_EQ(found["groups"].items.size(), std::size(groups));
  for (size_t k = 0; k < std::size(groups); ++k) {
    const Json &group = found["groups"].items[k];
    EXPECT_EQ(group["name"].text, groups[k].name);
    double sum = 0;
    for (const size_t place : groups[k].balls) {
      // One CA stands before those up to 7, none before 0.
      sum += balls[place == 0 ? 0 : place - 1]["area"].number;
    }
    EXPECT_EQ(group["atoms"].number, static_cast<double>(groups[k].balls.size())) << k;
    EXPECT_NEAR(group["area"].number, sum, 1e-10) << k;
  }
  EXPECT_EQ(json_of({"measure", crambin, "--only", "group:Begin", "--index", index.path()})["n"].number, 3);
  const Json shifted = json_of(
      {"measure", crambin, "--hide", "atom:N", "--of", "group:2", "--per-ball", "--index", index.path()})["balls"];
  ASSERT_EQ(shifted.items.size(), 2U);
  EXPECT_EQ(shifted.items[0]["atom"].text, "CG2");
  EXPECT_EQ(json_of({"measure", crambin, "--hide", "group:2", "--index", index.path()})["n"].number, 324);
  EXPECT_EQ(json_of({"contacts", crambin, "--only", "group:2&atom:CG2", "--index", index.path()})["n"].number, 1);
}

// Atoms are counted as the file has them, also those of other locations and without coordinates, which are left out.
TEST(IndexFiles, CountAllAtomsOfTheFile) {
  std::string pdb, cif =
                       "data_x\nloop_\n_atom_site.id\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
                       "_atom_site.label_alt_id\n_atom_site.label_comp_id\n_atom_site.label_asym_id\n"
                       "_atom_site.label_seq_id\n_atom_site.occupancy\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
                       "_atom_site.Cartn_z\n";
  const struct {
    const char *name;
    char location, element;
    double occupancy;
  } atoms[] = {
      {"N", ' ', 'N', 1}, {"CA", 'A', 'C', 0.4}, {"CA", 'B', 'C', 0.6}, {"O", ' ', 'O', 1}, {"SG", ' ', 'S', 1}};
  int number = 0;
  for (const auto &atom : atoms) {
    char line[100];
    ++number;
    std::snprintf(line, sizeof line, "ATOM  %5d  %-3s%cCYS A   1    %8.3f   0.000   0.000%6.2f  0.00           %c\n",
                  number, atom.name, atom.location, 3.0 * number, atom.occupancy, atom.element);
    pdb += line;
    std::snprintf(line, sizeof line, "%d %c %s %c CYS A 1 %.2f %.3f 0 0\n", number, atom.element, atom.name,
                  atom.location == ' ' ? '.' : atom.location, atom.occupancy, 3.0 * number);
    cif += line;
  }
  const std::string crystal =
      "data_x\n_cell_length_a 20\n_cell_length_b 20\n_cell_length_c 20\n_cell_angle_alpha 90\n_cell_angle_beta 90\n"
      "_cell_angle_gamma 90\nloop_\n_atom_site_label\n_atom_site_type_symbol\n_atom_site_fract_x\n_atom_site_fract_y\n"
      "_atom_site_fract_z\nN1 N 0.1 0.1 0.1\nH1 H ? ? ?\nH2 H ? ? ?\nO1 O 0.3 0.3 0.3\nS1 S 0.6 0.6 0.6\n";
  const TemporaryFile index("alt.ndx", "[ oxygen ]\n4\n[ sulfur ]\n5\n[ nitrogen ]\n1\n"),
      beyond("beyond.ndx", "[ far ]\n6\n"), of_pdb("alt.pdb", pdb), of_cif("alt.cif", cif),
      of_crystal("crystal.cif", crystal);
  for (const TemporaryFile *const file : {&of_pdb, &of_cif, &of_crystal}) {
    for (const Lines &choice : {Lines{}, Lines{"--altloc", "B"}, Lines{"--altloc", "occupancy"}}) {
      if (file == &of_crystal && !choice.empty()) continue;
      for (const std::string group : {"oxygen", "sulfur", "nitrogen"}) {
        Lines call = {"measure", file->path(), "--per-ball", "--only", "group:" + group, "--index", index.path()};
        call.insert(call.end(), choice.begin(), choice.end());
        const std::vector<Json> balls = json_of(call)["balls"].items;
        ASSERT_EQ(balls.size(), 1U) << file->path() << group;
        EXPECT_EQ(balls[0]["element"].text, std::string(1, static_cast<char>(std::toupper(group[0]))));
      }
      Lines call = {"measure", file->path(), "--index", beyond.path()};
      call.insert(call.end(), choice.begin(), choice.end());
      const Outcome outcome = run_program(call);
      EXPECT_EQ(outcome.status, 1);
      EXPECT_NE(outcome.err.find("group far has atom 6, and the molecule has 5"), std::string::npos) << outcome.err;
    }
  }
  // Frames of a trajectory have the atoms that are read, and no others.
  const TemporaryFile frame("frame.xyz", "4\n\nN 0 0 0\nC 3 0 0\nO 6 0 0\nS 9.1 0 0\n");
  const Outcome frames = run_program({"measure", of_pdb.path(), "--trajectory", frame.path(), "--altloc", "B", "--by",
                                      "group", "--index", index.path(), "--json"});
  ASSERT_EQ(frames.status, 0) << frames.err;
  const Json one = read_json(frames.out).value();
  ASSERT_EQ(one["groups"].items.size(), 3U);
  double sum = 0.0;
  for (const Json &group : one["groups"].items) {
    EXPECT_EQ(group["atoms"].number, 1);
    sum += group["area"].number;
  }
  EXPECT_LT(sum, one["area"].number);
}

TEST_F(Parts, Refused) {
  const TemporaryFile beyond("beyond.ndx", "[ far ]\n328\n"), zero("zero.ndx", "[ z ]\n0\n"),
      nameless("nameless.ndx", "[ ]\n1\n"), open("open.ndx", "[ open\n1\n"), before("before.ndx", "1 2\n"),
      word("word.ndx", "[ a ]\n1 two\n"), nothing("nothing.ndx", "; nothing\n");
  const struct {
    Lines options;
    int status;
    const char *reason;
  } cases[] = {{{"--of", "group:Begin"}, 2, "it needs --index"},
               {{"--by", "group"}, 2, "it needs --index"},
               {{"--only", "group:Tail", "--index", index.path()}, 2, "no group 'Tail'"},
               {{"--only", "group:5", "--index", index.path()}, 2, "no group '5'"},
               {{"--of", "group:Empty", "--index", index.path()}, 1, "--of names no atom"},
               {{"--of", "residue:3", "--surface", "ses"}, 2, "--surface ses is of all atoms"},
               {{"--of", "residue:3", "--interface", "A,B"}, 2, "--interface is of all atoms"},
               {{"--of", "residue:3", "--pdb-out", "x.pdb"}, 2, "--pdb-out is of all atoms"},
               {{"--index", beyond.path()}, 1, "group far has atom 328, and the molecule has 327"},
               {{"--index", zero.path()}, 1, "'0' is not the number of an atom"},
               {{"--index", word.path()}, 1, "'two' is not the number of an atom"},
               {{"--index", nameless.path()}, 1, "a group without a name"},
               {{"--index", open.path()}, 1, "a heading without ']'"},
               {{"--index", before.path()}, 1, "atoms before the first [ group ]"},
               {{"--index", nothing.path()}, 1, "no [ group ] in the file"},
               {{"--index", "not_there.ndx"}, 1, "not_there.ndx"}};
  for (const auto &refused : cases) {
    Lines call = {"measure", crambin, "--probe", "1.4"};
    call.insert(call.end(), refused.options.begin(), refused.options.end());
    const Outcome outcome = run_program(call);
    EXPECT_EQ(outcome.status, refused.status) << refused.reason;
    EXPECT_NE(outcome.err.find(refused.reason), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

}  // namespace
