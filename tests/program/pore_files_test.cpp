// The files that `pores` writes for viewers and for other programs: they hold what it prints, and what their formats
// ask for.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Words = std::vector<std::string>;

std::string crambin() {
  return molecules_folder() + "/crambin.pdb";
}

struct Point {
  std::string atom, list;
  double number, xyz[3], radius;
  bool joined;
};

Point point_of(const std::string &atom, const std::string &list, double number, const Json &at, bool joined = false) {
  Point point = {atom, list, number, {}, at["radius"].number, joined};
  for (size_t axis = 0; axis < 3; ++axis) point.xyz[axis] = at["xyz"].items.at(axis).number;
  return point;
}

// All that is listed, as the results in JSON have it.
std::vector<Point> listed_points(const Json &json, bool gates) {
  std::vector<Point> points;
  const std::vector<Json> &maxima = json["maximum_list"].items;
  if (gates) {
    for (const Json &gate : json["gate_list"].items)
      points.push_back(point_of("GAT", "GAT", gate["gate"].number, gate));
  }
  for (const Json &pocket : json["pocket_list"].items) {
    const double number = pocket["pocket"].number;
    // Maxima of a pocket are not in JSON: the widest one and mouths are.
    points.push_back(point_of("MAX", "PKT", number, maxima.at(static_cast<size_t>(pocket["maximum"].number))));
    for (const Json &mouth : pocket["mouths"].items) {
      points.push_back(point_of("GAT", "PKT", number, json["gate_list"].items.at(static_cast<size_t>(mouth.number))));
    }
  }
  double before = 0;
  for (const Json &step : json["tunnel_points"].items) {
    const std::string atom = step["maximum"].text != "none" ? "MAX" : step["gate"].text != "none" ? "GAT" : "WAY";
    points.push_back(point_of(atom, "TUN", step["tunnel"].number, step, step["tunnel"].number == before));
    before = step["tunnel"].number;
  }
  return points;
}

std::vector<Point> points_of_pdb(const std::string &text) {
  std::vector<Point> points;
  std::istringstream lines(text);
  std::set<std::pair<int, int>> bonds;
  for (std::string line; std::getline(lines, line);) {
    const auto number = [&](size_t first, size_t count) { return std::stod(line.substr(first, count)); };
    if (line.rfind("CONECT", 0) == 0) {
      std::istringstream fields(line.substr(6));
      int from = 0;
      fields >> from;
      for (int to = 0; fields >> to;) bonds.emplace(from, to);
    }
    if (line.rfind("HETATM", 0) != 0) continue;
    EXPECT_EQ(line.size(), 78u);
    EXPECT_EQ(number(6, 5), static_cast<double>(points.size() + 1));
    EXPECT_EQ(line.substr(76), " X");
    points.push_back({line.substr(13, 3),
                      line.substr(17, 3),
                      number(22, 4),
                      {number(30, 8), number(38, 8), number(46, 8)},
                      number(60, 6),
                      false});
  }
  for (const auto &[from, to] : bonds) {
    EXPECT_EQ(std::abs(from - to), 1);
    EXPECT_TRUE(bonds.contains({to, from}));
    points.at(static_cast<size_t>(std::max(from, to)) - 1).joined = true;
  }
  return points;
}

// The loops of a .cif file, each by its category: rows of values by the names of items.
using Rows = std::vector<std::map<std::string, std::string>>;

std::map<std::string, Rows> loops_of(const std::string &text, std::map<std::string, Words> *items = nullptr) {
  Words words;
  for (size_t at = 0; at < text.size();) {
    const char c = text[at];
    size_t end = text.find_first_of(" \n", at);
    if (c == ' ' || c == '\n') {
      ++at;
      continue;
    }
    if (c == '#') {
      at = text.find('\n', at);
      continue;
    }
    if (c == '\'' || c == '"') {
      end = text.find(std::string(1, c) + " ", at + 1);
      words.push_back(text.substr(at + 1, end - at - 1));
      at = end + 1;
      continue;
    }
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  std::map<std::string, Rows> loops;
  for (size_t k = 0; k < words.size();) {
    if (words[k++] != "loop_") continue;
    Words names;
    std::string category;
    for (; words[k][0] == '_'; ++k) {
      category = words[k].substr(1, words[k].find('.') - 1);
      names.push_back(words[k].substr(words[k].find('.') + 1));
    }
    if (items != nullptr) (*items)[category] = names;
    while (k < words.size() && words[k] != "loop_") {
      std::map<std::string, std::string> &row = loops[category].emplace_back();
      for (const std::string &name : names) row[name] = words.at(k++);
    }
  }
  return loops;
}

std::vector<Point> points_of_cif(const std::string &text) {
  std::vector<Point> points;
  std::map<std::string, Rows> loops = loops_of(text);
  for (auto &row : loops["atom_site"]) {
    points.push_back({row["label_atom_id"],
                      row["label_comp_id"],
                      std::stod(row["auth_seq_id"]),
                      {std::stod(row["Cartn_x"]), std::stod(row["Cartn_y"]), std::stod(row["Cartn_z"])},
                      std::stod(row["B_iso_or_equiv"]),
                      false});
  }
  return points;
}

void expect_same(const std::vector<Point> &found, const std::vector<Point> &expected, double digit, double of_radius,
                 bool bonds) {
  ASSERT_EQ(found.size(), expected.size());
  for (size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].atom, expected[i].atom) << i;
    EXPECT_EQ(found[i].list, expected[i].list) << i;
    EXPECT_EQ(found[i].number, expected[i].number) << i;
    if (bonds) {
      EXPECT_EQ(found[i].joined, expected[i].joined) << i;
    }
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(found[i].xyz[axis], expected[i].xyz[axis], digit) << i;
    EXPECT_NEAR(found[i].radius, expected[i].radius, of_radius) << i;
  }
}

// Of maxima of a pocket all but the widest are not in JSON; they are wider than the narrow probe.
std::vector<Point> without_further_maxima(const std::vector<Point> &points) {
  std::vector<Point> kept;
  for (const Point &point : points) {
    const bool further = !kept.empty() && point.list == "PKT" && point.atom == "MAX" && kept.back().list == "PKT" &&
                         kept.back().atom == "MAX" && kept.back().number == point.number;
    if (further) {
      EXPECT_LE(point.radius, kept.back().radius);
      EXPECT_GE(point.radius, 0.8);
    } else {
      kept.push_back(point);
    }
  }
  return kept;
}

TEST(PoreFiles, PointsAreWhatIsListed) {
  const std::vector<Words> lists = {{"--probe", "1", "--gates"},
                                    {"--probe", "0.8", "--pockets", "3"},
                                    {"--tunnels-from", "9.6,12.8,5.7"},
                                    {"--probe", "0.8", "--pockets", "2", "--gates", "--tunnels-from", "9.6,12.8,5.7"}};
  for (const Words &list : lists) {
    const TemporaryFile pdb("points.pdb"), cif("points.cif");
    Words words = {"pores", crambin()};
    words.insert(words.end(), list.begin(), list.end());
    const std::vector<Point> expected = listed_points(run_json(words), list.back() == "--gates" || list.size() > 5);
    EXPECT_GT(expected.size(), 20u);
    words.insert(words.end(), {"--points", pdb.path()});
    EXPECT_EQ(run_program(words).status, 0);
    words.back() = cif.path();
    EXPECT_EQ(run_program(words).status, 0);
    expect_same(without_further_maxima(points_of_pdb(read_file(pdb.path()))), expected, 5.01e-4, 5.01e-3, true);
    expect_same(without_further_maxima(points_of_cif(read_file(cif.path()))), expected, 5.01e-6, 5.01e-5, false);
  }
}

TEST(PoreFiles, PocketsHaveAllTheirMaxima) {
  const TemporaryFile file("points.cif");
  const Json json = run_json({"pores", crambin(), "--probe", "0.8", "--pockets", "3", "--points", file.path()});
  std::map<double, double> maxima;
  for (const Point &point : points_of_cif(read_file(file.path()))) maxima[point.number] += point.atom == "MAX" ? 1 : 0;
  EXPECT_EQ(
      run_program({"pores", crambin(), "--probe", "0.8", "--pockets", "3", "--least", "0.1", "--points", file.path()})
          .status,
      0);
  std::set<double> listed, deep;
  for (const Point &point : points_of_cif(read_file(file.path()))) listed.insert(point.number);
  for (const Json &pocket : json["pocket_list"].items) {
    if (pocket["radius"].number - pocket["mouth_radius"].number >= 0.1) deep.insert(pocket["pocket"].number);
  }
  EXPECT_EQ(listed, deep);
  EXPECT_LT(deep.size(), json["pocket_list"].items.size());
  ASSERT_GT(json["pocket_list"].items.size(), 5u);
  for (const Json &pocket : json["pocket_list"].items) {
    EXPECT_EQ(maxima[pocket["pocket"].number], pocket["maxima"].number);
  }
}

// A room in each box, with windows of 2 sqrt(2) - 2.5 to the next ones: a pocket for what does not pass them.
TEST(PoreFiles, PocketsOfACrystal) {
  const TemporaryFile ball("ball.xyzr", "0 0 0 2.5\n"), file("points.pdb");
  for (const auto &[wide, pockets] : std::vector<std::pair<std::string, double>>{{"0.32", 0}, {"0.33", 1}}) {
    const Json json = run_json({"pores", ball.path(), "--box", "4,4,4", "--pockets", wide, "--points", file.path()});
    EXPECT_EQ(json["pockets"].number, pockets);
    const std::vector<Point> points = points_of_pdb(read_file(file.path()));
    ASSERT_EQ(points.size(), static_cast<size_t>(pockets));
    if (pockets == 0) continue;
    EXPECT_NEAR(points[0].radius, 2 * std::sqrt(3.0) - 2.5, 0.006);
    EXPECT_EQ(json["pocket_list"].items.at(0)["gate"].text, "none");
  }
}

// The box of the file is turned, but not its atoms: each point is as far from their nearest image as its probe is wide.
TEST(PoreFiles, PointsOfATurnedBoxLieAmongTheAtomsOfTheFile) {
  const double atoms[3][4] = {{1, 2, 3, 1.7}, {5, 1, 7, 1.7}, {4, 6, 2, 1.52}};
  const TemporaryFile turned("turned.xyz", "3\nLattice=\"0 9 0 0 0 10 8 0 0\"\nC 1 2 3\nC 5 1 7\nO 4 6 2\n"),
      file("points.cif");
  const Json json =
      run_json({"pores", turned.path(), "--box", "file", "--probe", "1", "--gates", "--points", file.path()});
  const std::vector<Point> points = points_of_cif(read_file(file.path()));
  ASSERT_EQ(points.size(), json["gate_list"].items.size());
  ASSERT_GT(points.size(), 10u);
  const double length[3] = {8, 9, 10};
  for (const Point &point : points) {
    double least = 1e9;
    for (const auto &atom : atoms) {
      double square = 0;
      for (int axis = 0; axis < 3; ++axis) {
        square += std::pow(std::remainder(point.xyz[axis] - atom[axis], length[axis]), 2);
      }
      least = std::min(least, std::sqrt(square) - atom[3]);
    }
    EXPECT_NEAR(least, point.radius, 1e-4);
  }
}

// And so do the tunnels and what a user gives: points of such a file can be given back.
TEST(PoreFiles, TunnelsOfATurnedBoxLieAmongTheAtomsOfTheFile) {
  const TemporaryFile turned("turned.xyz", "3\nLattice=\"0 9 0 0 0 10 8 0 0\"\nC 1 2 3\nC 5 1 7\nO 4 6 2\n"),
      upright("upright.xyz", "3\nLattice=\"8 0 0 0 9 0 0 0 10\"\nC 1 2 3\nC 5 1 7\nO 4 6 2\n"), cif("tunnels.cif"),
      points("points.cif"), expected("expected.cif");
  const auto call = [&](const TemporaryFile &molecule, const Words &more) {
    Words words = {"pores", molecule.path(), "--box", "file", "--tunnels", "1", "--tunnels-from", "2,4,6"};
    words.insert(words.end(), more.begin(), more.end());
    return run_json(words);
  };
  const Json json = call(turned, {"--tunnels-to", "6,4,5", "--points", points.path(), "--tunnels-out", cif.path()});
  const Json other = call(upright, {"--tunnels-to", "6,4,5", "--points", expected.path()});
  EXPECT_NEAR(json["from_radius"].number, other["from_radius"].number, 1e-9);
  ASSERT_EQ(json["tunnel_list"].items.size(), 1u);
  EXPECT_NEAR(json["tunnel_list"].items[0]["radius"].number, other["tunnel_list"].items.at(0)["radius"].number, 1e-9);
  const std::vector<Point> there = points_of_cif(read_file(points.path()));
  ASSERT_GT(there.size(), 3u);
  const double start[3] = {2, 4, 6};
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(there[0].xyz[axis], start[axis], 1e-4);
  std::map<std::string, Rows> loops = loops_of(read_file(cif.path()));
  Rows &rows = loops["sb_ncbr_channel_profile"];
  ASSERT_EQ(rows.size(), there.size());
  const char *const names[3] = {"x", "y", "z"};
  for (size_t i = 0; i < rows.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(std::stod(rows[i][names[axis]]), there[i].xyz[axis], 1.1e-4) << i;
  }
  const double expected_atoms[3][3] = {{1, 2, 3}, {5, 1, 7}, {4, 6, 2}};
  Rows &atoms = loops["atom_site"];
  ASSERT_EQ(atoms.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    for (size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(std::stod(atoms[i][std::string("Cartn_") + names[axis]]), expected_atoms[i][axis], 1e-4);
    }
  }
}

// A way up ends in ever smaller steps, of which a list shows none.
TEST(PoreFiles, NoPointOfATunnelComesTwice) {
  const TemporaryFile two("two.xyzr", "0 0 0 1\n3 0 0 1\n"), file("points.pdb");
  for (const char *from : {"2,2,2", "maximum:0"}) {
    const Json json = run_json(
        {"pores", two.path(), "--box", "4,4,4", "--tunnels", "1", "--tunnels-from", from, "--points", file.path()});
    const std::vector<Point> points = points_of_pdb(read_file(file.path()));
    ASSERT_GT(points.size(), 2u);
    for (size_t i = 1; i < points.size(); ++i) {
      double square = 0;
      for (int axis = 0; axis < 3; ++axis) square += std::pow(points[i].xyz[axis] - points[i - 1].xyz[axis], 2);
      EXPECT_GT(square, 0) << from << " " << i;
    }
  }
}

TEST(PoreFiles, LeastLeavesOutPoints) {
  const TemporaryFile file("points.pdb");
  const Words words = {"pores", crambin(), "--probe", "1", "--least", "0.1"};
  const Json json = run_json(words);
  Words writing = words;
  writing.insert(writing.end(), {"--points", file.path()});
  EXPECT_EQ(run_program(writing).status, 0);
  std::vector<Point> expected;
  for (const Json &maximum : json["maximum_list"].items) {
    if (maximum["radius"].number - maximum["death"].number < 0.1) continue;
    expected.push_back(point_of("MAX", "MAX", maximum["maximum"].number, maximum));
  }
  EXPECT_GT(expected.size(), 3u);
  expect_same(points_of_pdb(read_file(file.path())), expected, 5.01e-4, 5.01e-3, true);
}

// The largest probe between six large balls: its radius has six columns.
TEST(PoreFiles, PointsThatTheColumnsHaveNoRoomFor) {
  for (const std::string away : {"900000", "2000000"}) {
    std::string balls;
    for (const std::string sign : {"", "-"}) {
      for (const std::string &place : {sign + away + " 0 0", "0 " + sign + away + " 0", "0 0 " + sign + away}) {
        balls += place + " " + std::to_string(std::stod(away) / 2) + "\n";
      }
    }
    const TemporaryFile file("far.xyzr", balls), pdb("points.pdb"), cif("points.cif");
    const Outcome outcome = run_program({"pores", file.path(), "--points", pdb.path()});
    EXPECT_EQ(run_program({"pores", file.path(), "--points", cif.path()}).status, 0);
    EXPECT_NEAR(points_of_cif(read_file(cif.path())).at(0).radius, std::stod(away) / 2, 1e-3);
    EXPECT_EQ(outcome.status, away == "900000" ? 0 : 1) << outcome.err;
    if (outcome.status == 1) {
      EXPECT_NE(outcome.err.find("a .cif file has room"), std::string::npos);
    }
  }
}

const std::map<std::string, Words> items_of_the_dictionary = {
    {"sb_ncbr_channel", {"id", "type", "method", "software", "auto", "cavity"}},
    {"sb_ncbr_channel_profile", {"channel_id", "radius", "free_radius", "distance", "T", "x", "y", "z", "charge"}},
    {"sb_ncbr_channel_layer",
     {"channel_id", "order", "min_radius", "min_free_radius", "start_distance", "end_distance", "local_minimum",
      "bottleneck", "charge", "numPositives", "numNegatives", "hydrophobicity", "hydropathy", "polarity",
      "mutability"}},
    {"sb_ncbr_channel_residue", {"channel_id", "order", "sequence_number", "chain_id", "backbone"}},
    {"sb_ncbr_channel_layer_residue", {"channel_id", "layer_id", "order", "residue_id"}}};

struct Atom {
  double xyz[3], radius;
  bool backbone;
  std::string residue;
};

std::vector<Atom> atoms_of(const std::string &file) {
  std::vector<Atom> atoms;
  const Json json = run_json({"measure", file, "--per-ball"});
  for (const Json &ball : json["balls"].items) {
    const std::vector<Json> &xyz = ball["xyz"].items;
    const std::string &name = ball["atom"].text;
    atoms.push_back({{xyz[0].number, xyz[1].number, xyz[2].number},
                     ball["radius"].number,
                     name == "N" || name == "CA" || name == "C" || name == "O" || name == "OXT",
                     ball["chain"].text + ":" + ball["number"].text});
  }
  return atoms;
}

double room(const std::vector<Atom> &atoms, const double at[3], bool backbone) {
  double least = std::numeric_limits<double>::infinity();
  for (const Atom &atom : atoms) {
    if (backbone && !atom.backbone) continue;
    least = std::min(least, std::hypot(at[0] - atom.xyz[0], at[1] - atom.xyz[1], at[2] - atom.xyz[2]) - atom.radius);
  }
  return least;
}

// Digits of the file, and points that are as far from it as half a digit in each coordinate.
constexpr double digits = 2e-4;

TEST(PoreFiles, TunnelsAsProgramsExchangeThem) {
  const TemporaryFile file("tunnels.cif");
  const std::vector<Atom> atoms = atoms_of(crambin());
  const Json json = run_json({"pores", crambin(), "--tunnels-from", "9.6,12.8,5.7", "--tunnels-out", file.path()});
  std::map<std::string, Words> items;
  std::map<std::string, Rows> loops = loops_of(read_file(file.path()), &items);
  items.erase("atom_site");
  EXPECT_EQ(items, items_of_the_dictionary);
  EXPECT_EQ(loops["atom_site"].size(), atoms.size());
  const std::vector<Json> &tunnels = json["tunnel_list"].items;
  ASSERT_EQ(tunnels.size(), 3u);
  ASSERT_EQ(loops["sb_ncbr_channel"].size(), 3u);
  int both = 0;  // residues that line a tunnel with their backbone and with other atoms
  for (const Json &tunnel : tunnels) {
    const std::string id = std::to_string(static_cast<int>(tunnel["tunnel"].number));
    const double length = tunnel["length"].number;
    double least = 1e9, before = -1;
    for (auto &row : loops["sb_ncbr_channel_profile"]) {
      if (row["channel_id"] != id) continue;
      const double at[3] = {std::stod(row["x"]), std::stod(row["y"]), std::stod(row["z"])};
      EXPECT_NEAR(std::stod(row["radius"]), room(atoms, at, false), digits);
      EXPECT_NEAR(std::stod(row["free_radius"]), room(atoms, at, true), digits);
      EXPECT_NEAR(std::stod(row["T"]) * length, std::stod(row["distance"]), digits);
      EXPECT_GT(std::stod(row["T"]), before);
      before = std::stod(row["T"]);
      least = std::min(least, std::stod(row["radius"]));
    }
    EXPECT_NEAR(least, tunnel["radius"].number, digits);
    EXPECT_EQ(before, 1.0);
    // Residues that are there, in the order of the way.
    std::map<std::string, std::pair<std::string, bool>> residues;
    for (auto &row : loops["sb_ncbr_channel_residue"]) {
      if (row["channel_id"] != id) continue;
      EXPECT_EQ(row["order"], std::to_string(residues.size() + 1));
      residues[row["order"]] = {row["chain_id"] + ":" + row["sequence_number"], row["backbone"] == "True"};
    }
    // Layers follow each other, and each has atoms of its residues near.
    double end = 0;
    int order = 0, bottlenecks = 0;
    for (auto &row : loops["sb_ncbr_channel_layer"]) {
      if (row["channel_id"] != id) continue;
      EXPECT_EQ(row["order"], std::to_string(++order));
      EXPECT_NEAR(std::stod(row["start_distance"]), end, 1e-9);
      end = std::stod(row["end_distance"]);
      EXPECT_TRUE(std::stod(row["start_distance"]) < end || end > length - digits);  // the mouth may be a layer
      if (row["bottleneck"] == "True") {
        ++bottlenecks;
        EXPECT_NEAR(std::stod(row["min_radius"]), tunnel["radius"].number, digits);
      }
      EXPECT_GE(std::stod(row["min_radius"]), tunnel["radius"].number - digits);
      EXPECT_EQ(std::stoi(row["charge"]), std::stoi(row["numPositives"]) - std::stoi(row["numNegatives"]));
      size_t lining = 0;
      std::set<std::string> different;
      for (auto &near : loops["sb_ncbr_channel_layer_residue"]) {
        if (near["channel_id"] != id || near["layer_id"] != row["order"]) continue;
        ++lining;
        EXPECT_TRUE(different.insert(near["residue_id"]).second);
        ASSERT_TRUE(residues.contains(near["residue_id"]));
        const auto &[residue, backbone] = residues[near["residue_id"]];
        for (auto &point : loops["sb_ncbr_channel_profile"]) {
          const double distance = std::stod(point["distance"]);
          if (point["channel_id"] != id || distance < std::stod(row["start_distance"]) || distance >= end) continue;
          const double at[3] = {std::stod(point["x"]), std::stod(point["y"]), std::stod(point["z"])};
          double nearest = 1e9;
          for (const Atom &atom : atoms) {
            if (atom.residue != residue || atom.backbone != backbone) continue;
            nearest = std::min(nearest,
                               std::hypot(at[0] - atom.xyz[0], at[1] - atom.xyz[1], at[2] - atom.xyz[2]) - atom.radius);
          }
          EXPECT_NEAR(nearest, std::stod(point["radius"]), 2 * digits);
        }
      }
      EXPECT_GE(lining, 1u);
      EXPECT_LE(lining, 4u);
    }
    EXPECT_EQ(bottlenecks, 1);
    const std::set<std::pair<std::string, bool>> all = [&] {
      std::set<std::pair<std::string, bool>> rows;
      for (const auto &[row, residue] : residues) rows.insert(residue);
      return rows;
    }();
    EXPECT_EQ(all.size(), residues.size());
    for (const auto &[residue, backbone] : all) both += !backbone && all.contains({residue, true}) ? 1 : 0;
    EXPECT_NEAR(end, length, digits);
  }
  EXPECT_GT(both, 0);
  // The atoms are those of the molecule, for this program too.
  const TemporaryFile again("again.cif", read_file(file.path()));
  EXPECT_NEAR(run_json({"measure", again.path()})["area"].number, run_json({"measure", crambin()})["area"].number,
              1e-6);
}

// Two rings of a tube lie so close to each other that the bottlenecks in them and the maximum between have the same
// share of the length, which is the key of a row.
TEST(PoreFiles, PointsOfATunnelWithOneKeyHaveOneRow) {
  std::ostringstream balls;
  balls.precision(17);
  for (const double z : {-1e-6, 1e-6, 3.0, 6.0, 9.0}) {
    for (int k = 0; k < 6; ++k)
      balls << 2.4 * std::cos(k * std::numbers::pi / 3) << " " << 2.4 * std::sin(k * std::numbers::pi / 3) << " " << z
            << " 1.5\n";
  }
  balls << "0 0 11 1.5\n";
  const TemporaryFile tube("tube.xyzr", balls.str()), file("tunnels.cif");
  const Json json =
      run_json({"pores", tube.path(), "--tunnels-from", "0,0,7.5", "--tunnels", "1", "--tunnels-out", file.path()});
  std::set<std::string> keys;
  for (const Json &point : json["tunnel_points"].items) {
    const double share = point["length"].number / json["tunnel_list"].items.at(0)["length"].number;
    keys.insert(std::to_string(std::lround(1e6 * share)));
  }
  EXPECT_EQ(keys.size() + 2, json["tunnel_points"].items.size());
  std::map<std::string, Rows> loops = loops_of(read_file(file.path()));
  EXPECT_EQ(loops["sb_ncbr_channel_profile"].size(), keys.size());
}

void expect_charges_of_layers(const char *name_of_lysine) {
  std::string atoms = "cage\n6\n";
  const char *const residues[] = {"    1LYSH ", "    2ASP  ", "    1LYSH ", "    3HISE ", "    4HOH  ", "    5MSE  "};
  const char *const names[] = {"   CB", "   CB", name_of_lysine, "   CB", "    O", "   CB"};
  const char *const places[] = {"   0.100   0.000   0.000", "  -0.100   0.000   0.000", "   0.000   0.100   0.000",
                                "   0.000  -0.100   0.000", "   0.000   0.000   0.100", "   0.000   0.000  -0.100"};
  for (int k = 0; k < 6; ++k) {
    atoms += residues[k] + std::string(names[k]) + "    " + std::to_string(k + 1) + places[k] + "\n";
  }
  const TemporaryFile cage("cage.gro", atoms + "   9.00000   9.00000   9.00000\n"), file("tunnels.cif");
  ASSERT_EQ(run_program({"pores", cage.path(), "--radius", "C=0.7,O=0.7", "--tunnels-from", "0,0,0", "--tunnels", "8",
                         "--tunnels-out", file.path()})
                .status,
            0);
  std::map<std::string, Rows> loops = loops_of(read_file(file.path()));
  const std::map<std::string, std::pair<int, double>> known = {
      {"1", {1, -3.9}}, {"2", {-1, -3.5}}, {"3", {0, -3.2}}, {"5", {0, 1.9}}};
  const bool backbone = name_of_lysine == std::string("   CA");
  size_t rows = 0, twice = 0;
  for (auto &row : loops["sb_ncbr_channel_layer"]) {
    int charge = 0, positive = 0;
    double hydropathy = 0;
    std::set<std::string> counted;
    for (auto &near : loops["sb_ncbr_channel_layer_residue"]) {
      if (near["channel_id"] != row["channel_id"] || near["layer_id"] != row["order"]) continue;
      for (auto &residue : loops["sb_ncbr_channel_residue"]) {
        if (residue["channel_id"] != row["channel_id"] || residue["order"] != near["residue_id"]) continue;
        EXPECT_TRUE(residue["backbone"] == "False" || (backbone && residue["sequence_number"] == "1"));
        const auto one = known.find(residue["sequence_number"]);
        if (one == known.end()) continue;
        if (!counted.insert(one->first).second) {
          ++twice;
          continue;
        }
        positive += one->second.first > 0 ? 1 : 0;
        charge += one->second.first;
        hydropathy += one->second.second;
      }
    }
    ++rows;
    EXPECT_EQ(row["charge"], std::to_string(charge));
    EXPECT_EQ(row["numPositives"], std::to_string(positive));
    EXPECT_EQ(row["min_free_radius"] == "?", !backbone);
    if (counted.empty()) {
      EXPECT_EQ(row["hydropathy"], "?");
    } else {
      EXPECT_NEAR(std::stod(row["hydropathy"]), hydropathy / static_cast<double>(counted.size()), 1e-4);
    }
  }
  EXPECT_GE(rows, 8u);
  EXPECT_EQ(twice > 0, backbone);
  EXPECT_LE(loops["sb_ncbr_channel_residue"].size(), 8u * (backbone ? 6u : 5u));
  for (auto &row : loops["sb_ncbr_channel_profile"]) EXPECT_LE(std::abs(std::stoi(row["charge"])), 1);
}

// Known charges and hydropathies: a cage of a lysine, an aspartate, a histidine and a selenomethionine by the names of
// MD programs. A residue counts once, though it may be near with its backbone and with other atoms, which stand apart.
TEST(PoreFiles, ChargesOfLayers) {
  expect_charges_of_layers("   CB");
  expect_charges_of_layers("   CA");
}

// Names that need quotes, or a line of their own.
TEST(PoreFiles, NamesWithQuotes) {
  const TemporaryFile gro("names.gro",
                          "names\n4\n    1A'B   O5'    1   0.000   0.000   0.000\n"
                          "    1A'B  'C\"1    2   0.300   0.000   0.000\n    2_X     \"N    3   0.000   0.300   0.000\n"
                          "    3LIG     'N    4   0.000   0.000   0.300\n"
                          "   1.00000   1.00000   1.00000\n");
  const TemporaryFile cif("names.cif");
  ASSERT_EQ(run_program({"pores", gro.path(), "--radius", "O=1,C=1,N=1", "--tunnels-from", "0,0,9", "--tunnels-out",
                         cif.path()})
                .status,
            0);
  const Json written = run_json({"measure", cif.path(), "--per-ball"}),
             read = run_json({"measure", gro.path(), "--per-ball"});
  ASSERT_EQ(written["balls"].items.size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    const Json &one = written["balls"].items[i], &other = read["balls"].items[i];
    for (const char *key : {"atom", "residue", "number"}) EXPECT_EQ(one[key].text, other[key].text) << key;
  }
}

TEST(PoreFiles, AreRefusedWhereTheyHaveNoPlace) {
  const std::vector<std::pair<Words, std::string>> calls = {
      {{"--points", "points.xyz"}, "--points writes a .pdb or .cif file, and its name says so"},
      {{"--points", "points.p"}, "--points writes a .pdb or .cif file, and its name says so"},
      {{"--points", ".pdb"}, "--points writes a .pdb or .cif file, and its name says so"},
      {{"--tunnels-from", "0,0,0", "--tunnels-out", "out.pdb"},
       "--tunnels-out writes a .cif file, and its name says so"},
      {{"--tunnels-out", "out.cif"}, "--tunnels-out needs --tunnels-from"},
      {{"--points", "-", "--json"}, "--points and --json would both go to standard output"},
      {{"--tunnels-from", "0,0,0", "--tunnels-out", "out.cif", "--points", "out.cif"},
       "--points and --tunnels-out would write the same file"},
      {{"--tunnels-from", "0,0,0", "--tunnels-out", "out.cif", "--points", "./good/../out.cif"},
       "--points and --tunnels-out would write the same file"},
      {{"--tunnels-from", "0,0,0", "--tunnels-out", "-", "--points", "/dev/stdout"},
       "--points and --tunnels-out would write the same file"},
      {{"good/two.xyzr", "--points", "points.pdb"}, "--points takes one file at a time"}};
  for (const auto &[words, reason] : calls) {
    Words call = {"pores", "good/cage.xyzr"};
    call.insert(call.end(), words.begin(), words.end());
    const Outcome outcome = run_program(call);
    EXPECT_EQ(outcome.status, 2) << reason;
    EXPECT_EQ(outcome.err, "hardsphere: " + reason + "\n");
  }
  EXPECT_EQ(run_program({"pores", "good/cage.xyzr", "--points", "nowhere/points.pdb"}).status, 1);
  const TemporaryFolder folder("points");
  for (const char *name : {"POINTS.PDB", "POINTS.CIF"}) {
    EXPECT_EQ(run_program({"pores", "good/cage.xyzr", "--points", folder.path(name)}).status, 0) << name;
  }
  EXPECT_EQ(read_file(folder.path("POINTS.PDB")).rfind("REMARK", 0), 0u);
  EXPECT_EQ(read_file(folder.path("POINTS.CIF")).rfind("data_", 0), 0u);
  const Outcome printed = run_program({"pores", "good/cage.xyzr", "--points", "-"});
  EXPECT_EQ(printed.status, 0);
  EXPECT_EQ(printed.out.rfind("REMARK", 0), 0u);
  EXPECT_EQ(points_of_pdb(printed.out).size(), 1u);
}

}  // namespace
