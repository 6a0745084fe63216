// Pores as the program lists them: closed forms, distances from all balls, and the answers of voids and gate.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <limits>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "json_outcome.hpp"
#include "molecule_file.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

using Words = std::vector<std::string>;

// Six balls of radius 0.7 at distance 1 from the origin: a room with eight windows, each between three of them.
const std::string cage_with_windows = "1 0 0 0.7\n-1 0 0 0.7\n0 1 0 0.7\n0 -1 0 0.7\n0 0 1 0.7\n0 0 -1 0.7\n";

std::string crambin() {
  return molecules_folder() + "/crambin.pdb";
}

struct Ball {
  double xyz[3];
  double radius;
};

std::vector<Ball> balls_of_crambin() {
  std::vector<Ball> balls;
  const Json json = run_json({"measure", crambin(), "--per-ball"});
  for (const Json &ball : json["balls"].items) {
    const std::vector<Json> &xyz = ball["xyz"].items;
    balls.push_back({{xyz.at(0).number, xyz.at(1).number, xyz.at(2).number}, ball["radius"].number});
  }
  return balls;
}

double room(const Ball &ball, const Json &xyz) {
  double square = 0;
  for (size_t axis = 0; axis < 3; ++axis) square += std::pow(xyz.items.at(axis).number - ball.xyz[axis], 2);
  return std::sqrt(square) - ball.radius;
}

// No ball is nearer than the radius says, those that are listed are as near, and if it is all of them no others.
void expect_largest_probe(const std::vector<Ball> &balls, const Json &place, bool all) {
  constexpr double rounding = 1e-7;
  const double radius = place["radius"].number;
  std::set<double> listed;
  for (const Json &ball : place["balls"].items) listed.insert(ball.number);
  for (size_t i = 0; i < balls.size(); ++i) {
    const double more = room(balls[i], place["xyz"]) - radius;
    EXPECT_GE(more, -rounding);
    const bool among = listed.contains(static_cast<double>(i));
    if (among || all) {
      EXPECT_EQ(among, more <= rounding);
    }
  }
}

TEST(Pores, ARoomWithEightWindows) {
  const TemporaryFile file("open.xyzr", cage_with_windows);
  const double window = std::sqrt(2.0 / 3) - 0.7;
  const Json json = run_json({"pores", file.path(), "--pockets", "0.2", "--tunnels-from", "atom:4", "--tunnels", "9"});
  EXPECT_EQ(json.keys, (Words{"n", "largest_cavity_diameter", "maxima", "gates", "merges", "cavities", "maximum_list",
                              "gate_list", "pockets", "smaller", "pocket_list", "from", "to", "from_radius", "tunnels",
                              "tunnel_list", "tunnel_points", "input"}));
  EXPECT_NEAR(json["largest_cavity_diameter"].number, 0.6, 1e-8);
  EXPECT_EQ(json["maxima"].number, 1);
  EXPECT_EQ(json["gates"].number, 8);
  EXPECT_EQ(json["merges"].number, 1);
  EXPECT_EQ(json["cavities"].number, 0);
  const Json &maximum = json["maximum_list"].items.at(0);
  EXPECT_NEAR(maximum["death"].number, window, 1e-8);
  EXPECT_EQ(maximum["parent"].text, "outside");
  EXPECT_EQ(maximum["balls"].items.size(), 6u);
  std::set<std::vector<bool>> sides;
  for (const Json &gate : json["gate_list"].items) {
    EXPECT_NEAR(gate["radius"].number, window, 1e-8);
    std::vector<bool> side;
    for (const Json &coordinate : gate["xyz"].items) {
      EXPECT_NEAR(std::abs(coordinate.number), 1.0 / 3, 1e-8);
      side.push_back(coordinate.number > 0);
    }
    sides.insert(side);
    ASSERT_EQ(gate["balls"].items.size(), 3u);
  }
  EXPECT_EQ(sides.size(), 8u);
  const Json &pocket = json["pocket_list"].items.at(0);
  EXPECT_EQ(json["pockets"].number, 1);
  EXPECT_NEAR(pocket["radius"].number, 0.3, 1e-8);
  EXPECT_NEAR(pocket["mouth_radius"].number, window, 1e-8);
  EXPECT_EQ(pocket["mouths"].items.size(), 8u);
  EXPECT_EQ(pocket["balls"].items.size(), 6u);
  EXPECT_EQ(pocket["closed"].number, 1);
  EXPECT_EQ(pocket["volume"].kind, Json::Kind::number);
  EXPECT_NEAR(json["from_radius"].number, 0.3, 1e-8);
  EXPECT_EQ(json["tunnels"].number, 8);  // there is no ninth window
  for (const Json &tunnel : json["tunnel_list"].items) {
    EXPECT_NEAR(tunnel["radius"].number, window, 1e-8);
    EXPECT_GT(tunnel["length"].number, std::sqrt(1.0 / 3));
    EXPECT_NEAR(tunnel["cost"].number, std::sqrt(1.0 / 3) / (0.3 * window), 1e-6);
  }
  // A window is so far away, and behind it the way goes on along its axis.
  int windows = 0;
  for (const Json &point : json["tunnel_points"].items) {
    if (point["gate"].kind != Json::Kind::number) continue;
    ++windows;
    EXPECT_NEAR(point["length"].number, std::sqrt(1.0 / 3), 1e-7);
  }
  EXPECT_EQ(windows, 8);
}

// A class that lives for just as long as is asked for is listed.
TEST(Pores, TheLeastPersistence) {
  const TemporaryFile file("open.xyzr", cage_with_windows);
  const Json maximum = run_json({"pores", file.path()})["maximum_list"].items.at(0);
  const double life = maximum["radius"].number - maximum["death"].number;
  for (const auto &[least, listed] : {std::pair{life, 1U}, std::pair{std::nextafter(life, 1.0), 0U}}) {
    std::ostringstream text;
    text.precision(17);
    text << least;
    EXPECT_EQ(run_json({"pores", file.path(), "--least", text.str()})["maximum_list"].items.size(), listed);
  }
}

// The probe that asks does not grow the balls: it leaves out what is narrower.
TEST(Pores, TheNarrowestProbe) {
  const TemporaryFile file("open.xyzr", cage_with_windows);
  const Json open = run_json({"pores", file.path(), "--probe", "0.1"});
  EXPECT_EQ(open["gates"].number, 8);
  EXPECT_NEAR(open["largest_cavity_diameter"].number, 0.6, 1e-8);
  const Json closed = run_json({"pores", file.path(), "--probe", "0.2", "--tunnels-from", "0,0,0"});
  EXPECT_NEAR(closed["largest_cavity_diameter"].number, 0.6, 1e-8);
  EXPECT_EQ(closed["gates"].number, 0);
  EXPECT_EQ(closed["cavities"].number, 1);
  EXPECT_EQ(closed["maximum_list"].items.at(0)["gate"].text, "none");
  EXPECT_EQ(closed["tunnels"].number, 0);
  const Json wide = run_json({"pores", file.path(), "--probe", "0.31"});
  EXPECT_EQ(wide["maxima"].number, 0);
  EXPECT_EQ(wide["largest_cavity_diameter"].kind, Json::Kind::null);
}

// Probes that touch balls so far apart have no place on the usual lattice.
TEST(Pores, BallsFarApart) {
  for (const std::string away : {"50", "500000"}) {
    std::string balls;
    for (const std::string sign : {"", "-"}) {
      for (const std::string &place : {sign + away + " 0 0", "0 " + sign + away + " 0", "0 0 " + sign + away}) {
        balls += place + " 1\n";
      }
    }
    const TemporaryFile far("far.xyzr", balls);
    const double distance = std::stod(away);
    EXPECT_NEAR(run_json({"pores", far.path()})["largest_cavity_diameter"].number, 2 * (distance - 1), 2e-7 * distance);
  }
}

TEST(Pores, AllOfCrambinAreAsFarFromTheBallsAsTheySay) {
  const std::vector<Ball> balls = balls_of_crambin();
  const Json json = run_json({"pores", crambin(), "--tunnels-from", "9.5887,12.7803,5.7178"});
  const std::vector<Json> &maxima = json["maximum_list"].items, &gates = json["gate_list"].items;
  ASSERT_EQ(static_cast<double>(maxima.size()), json["maxima"].number);
  ASSERT_EQ(static_cast<double>(gates.size()), json["gates"].number);
  ASSERT_GT(maxima.size(), 100u);
  for (const Json &maximum : maxima) {
    expect_largest_probe(balls, maximum, true);
    const auto gate = static_cast<size_t>(maximum["gate"].number);
    EXPECT_EQ(gates.at(gate)["radius"].number, maximum["death"].number);
    EXPECT_GT(maximum["radius"].number, maximum["death"].number);
  }
  for (const Json &gate : gates) expect_largest_probe(balls, gate, true);
  const std::vector<Json> &tunnels = json["tunnel_list"].items;
  ASSERT_EQ(tunnels.size(), 3u);
  std::vector<double> narrowest(3, std::numeric_limits<double>::infinity()), length(3, 0);
  std::set<double> bottlenecks;
  for (const Json &point : json["tunnel_points"].items) {
    expect_largest_probe(balls, point, false);
    const auto tunnel = static_cast<size_t>(point["tunnel"].number) - 1;
    narrowest.at(tunnel) = std::min(narrowest.at(tunnel), point["radius"].number);
    EXPECT_GE(point["length"].number, length.at(tunnel));
    length.at(tunnel) = point["length"].number;
  }
  for (size_t k = 0; k < 3; ++k) {
    EXPECT_EQ(tunnels[k]["radius"].number, narrowest[k]);
    EXPECT_NEAR(tunnels[k]["length"].number, length[k], 1e-9);
    bottlenecks.insert(tunnels[k]["gate"].number);
    if (k > 0) {
      EXPECT_LE(narrowest[k], narrowest[k - 1]);
    }
  }
  EXPECT_EQ(bottlenecks.size(), 3u);
}

// The widest tunnel has the bottleneck that gate finds from one pair of points alone.
TEST(Pores, TheWidestTunnelIsThatOfGate) {
  for (const std::string from : {"9.5887,12.7803,5.7178", "14.3991,14.5115,8.4161"}) {
    const Json gate = run_json({"gate", crambin(), "--from", from});
    const Json json = run_json({"pores", crambin(), "--tunnels-from", from, "--tunnels", "1"});
    ASSERT_EQ(json["tunnels"].number, 1);
    const Json &tunnel = json["tunnel_list"].items.at(0);
    EXPECT_NEAR(tunnel["radius"].number, gate["widest_probe"].number, 2e-8);
    const Json &narrow = json["gate_list"].items.at(static_cast<size_t>(tunnel["gate"].number));
    ASSERT_EQ(narrow["balls"].items.size(), gate["gate"].items.size());
    for (size_t k = 0; k < 3; ++k) EXPECT_EQ(narrow["balls"].items[k].number, gate["gate"].items[k].number);
  }
}

// Pockets of one probe that no wider one is asked about are the voids of balls grown by it.
TEST(Pores, PocketsOfOneProbeAreItsVoids) {
  for (const std::string probe : {"0.7", "0.9", "1.1", "1.4"}) {
    const Json json = run_json({"pores", crambin(), "--probe", probe, "--pockets", probe});
    const std::vector<Json> voids = run_json({"voids", crambin(), "--probe", probe})["voids"].items;
    const std::vector<Json> &pockets = json["pocket_list"].items;
    ASSERT_EQ(pockets.size(), voids.size()) << probe;
    EXPECT_GT(pockets.size(), 0u) << probe;
    std::vector<double> clearance;
    std::map<double, double> volumes;
    for (const Json &each : voids) {
      clearance.push_back(each["clearance"].number);
      volumes[each["clearance"].number] = each["volume"].number;
    }
    for (size_t k = 0; k < pockets.size(); ++k) {
      EXPECT_EQ(pockets[k]["gate"].text, "none");
      EXPECT_NEAR(pockets[k]["radius"].number - std::stod(probe), clearance[k], 1e-4) << probe;
      EXPECT_EQ(pockets[k]["closed"].number, 1);
      EXPECT_NEAR(pockets[k]["volume"].number, volumes[clearance[k]], 1e-9);
    }
  }
}

// In crambin all pockets are closed by plugs, some of them in leaks; in a box much larger than it they are the same.
TEST(Pores, SizesOfPockets) {
  const Json json = run_json({"pores", crambin(), "--probe", "0.5", "--pockets", "2"});
  const Json boxed = run_json({"pores", crambin(), "--probe", "0.5", "--pockets", "2", "--box", "80,90,100"});
  const std::vector<Json> &pockets = json["pocket_list"].items, &same = boxed["pocket_list"].items;
  ASSERT_EQ(pockets.size(), same.size());
  EXPECT_GT(pockets.size(), 20u);
  double volume = 0.0;
  for (size_t k = 0; k < pockets.size(); ++k) {
    EXPECT_EQ(pockets[k]["closed"].number, 1);
    EXPECT_EQ(pockets[k]["volume"].number > 0.0, pockets[k]["area"].number > 0.0);
    EXPECT_NEAR(pockets[k]["volume"].number, same[k]["volume"].number, 1e-9);
    EXPECT_NEAR(pockets[k]["area"].number, same[k]["area"].number, 1e-9);
    volume += pockets[k]["volume"].number;
  }
  EXPECT_GT(volume, 50.0);
  // In a crystal that the probe goes on in for ever there is one that no plug closes.
  const TemporaryFile file("one.xyzr", "1 2 3 2\n");
  const Json open = run_json({"pores", file.path(), "--pockets", "50", "--box", "6,6,6"});
  ASSERT_EQ(open["pocket_list"].items.size(), 1u);
  EXPECT_EQ(open["pocket_list"].items[0]["closed"].number, 0);
  EXPECT_EQ(open["pocket_list"].items[0]["volume"].kind, Json::Kind::null);
  EXPECT_EQ(open["pocket_list"].items[0]["area"].kind, Json::Kind::null);
  const Outcome rows = run_program({"pores", file.path(), "--pockets", "50", "--box", "6,6,6", "--csv"});
  EXPECT_NE(rows.out.find(",,,0\n"), std::string::npos);
}

TEST(Pores, ThoseThatLastLong) {
  const Json all = run_json({"pores", crambin(), "--probe", "0.9", "--pockets", "1.5"});
  const Json few = run_json({"pores", crambin(), "--probe", "0.9", "--pockets", "1.5", "--least", "0.1"});
  struct Case {
    std::string list, number, narrow;
  };
  for (const Case &each : {Case{"maximum_list", "maximum", "death"}, Case{"pocket_list", "pocket", "mouth_radius"}}) {
    std::vector<double> expected, found;
    for (const Json &one : all[each.list].items) {
      if (one["radius"].number - one[each.narrow].number >= 0.1) expected.push_back(one[each.number].number);
    }
    for (const Json &one : few[each.list].items) found.push_back(one[each.number].number);
    EXPECT_EQ(found, expected);
    EXPECT_GT(found.size(), 1u);
    EXPECT_LT(found.size(), all[each.list].items.size());
  }
  const Outcome rows =
      run_program({"pores", crambin(), "--probe", "0.9", "--pockets", "1.5", "--least", "0.1", "--balls"});
  size_t lists = 0;
  for (size_t at = 0; (at = rows.out.find("balls around pocket", at)) != std::string::npos; ++at) ++lists;
  EXPECT_EQ(lists, few["pocket_list"].items.size());
}

// Each table of --csv holds the numbers of JSON.
TEST(Pores, TablesOfCommaSeparatedValues) {
  struct Case {
    Words options;
    std::string list;
    Words titles;
  };
  const std::vector<Case> cases = {
      {{}, "maximum_list", {"maximum", "x", "y", "z", "radius", "death", "gate", "parent"}},
      {{"--gates"}, "gate_list", {"gate", "x", "y", "z", "radius", "end", "other_end", "merges"}},
      {{"--pockets", "3"},
       "pocket_list",
       {"pocket", "x", "y", "z", "radius", "mouth_radius", "maximum", "gate", "maxima", "mouths", "balls", "volume",
        "area", "closed"}},
      {{"--tunnels-from", "9.5,12.7,5.7"},
       "tunnel_points",
       {"tunnel", "length", "x", "y", "z", "radius", "gate", "maximum"}}};
  for (const Case &each : cases) {
    Words arguments = {"pores", crambin(), "--probe", "0.5"};
    arguments.insert(arguments.end(), each.options.begin(), each.options.end());
    const std::vector<Json> rows = run_json(arguments)[each.list].items;
    arguments.push_back("--csv");
    std::istringstream table(run_program(arguments).out);
    size_t row = 0;
    std::string line, cell;
    Words titles;
    std::getline(table, line);
    for (std::istringstream cells(line); std::getline(cells, cell, ',');) titles.push_back(cell);
    EXPECT_EQ(titles, each.titles);
    for (; std::getline(table, line); ++row) {
      size_t column = 0;
      ASSERT_LT(row, rows.size());
      for (std::istringstream cells(line); std::getline(cells, cell, ','); ++column) {
        const std::string &title = titles.at(column);
        if (title.size() == 1) {
          const size_t axis = static_cast<size_t>(title[0] - 'x');
          EXPECT_EQ(rows[row]["xyz"].items.at(axis).text, cell);
        } else if (rows[row][title].kind == Json::Kind::array) {
          EXPECT_EQ(std::to_string(rows[row][title].items.size()), cell);
        } else {
          EXPECT_EQ(rows[row][title].text, cell);
        }
      }
      EXPECT_EQ(column, titles.size());
    }
    EXPECT_EQ(row, rows.size());
    EXPECT_GT(row, 0u);
  }
}

// The sums in the row of a molecule or of a file: of all pockets, and of the largest one by its number in the list.
TEST(Pores, PocketsInARow) {
  const Words pores = {"pores", crambin(), "--probe", "1", "--pockets", "3"};
  const std::vector<Json> pockets = run_json(pores)["pocket_list"].items;
  ASSERT_GT(pockets.size(), 1u);
  double sum = 0.0;
  for (const Json &pocket : pockets) sum += pocket["volume"].number;
  EXPECT_GT(pockets[0]["volume"].number, 0.0);
  for (const Words &options : {Words{"--rows"}, Words{"--models", "all"}}) {
    Words arguments = pores;
    arguments.insert(arguments.end(), options.begin(), options.end());
    arguments.emplace_back("--csv");
    const Outcome rows = run_program(arguments);
    ASSERT_EQ(rows.status, 0) << rows.err;
    std::istringstream table(rows.out);
    std::string line, title, cell;
    std::getline(table, line);
    std::istringstream titles(line);
    std::getline(table, line);
    std::map<std::string, std::string> row;
    for (std::istringstream cells(line); std::getline(titles, title, ',');) {
      std::getline(cells, cell, ',');
      row[title] = cell;
    }
    EXPECT_NEAR(std::stod(row["pocket_volume"]), sum, 1e-9) << rows.out;
    EXPECT_EQ(row["largest_pocket"], pockets[0]["pocket"].text);
    EXPECT_EQ(row["largest_pocket_volume"], pockets[0]["volume"].text);
  }
}

void expect_diameters(const Json &found, const std::vector<double> &known) {
  ASSERT_EQ(found.items.size(), known.size());
  for (size_t k = 0; k < known.size(); ++k) {
    EXPECT_EQ(found.items[k].kind == Json::Kind::null, std::isnan(known[k]));
    if (!std::isnan(known[k])) {
      EXPECT_NEAR(found.items[k].number, known[k], 1e-6);
    }
  }
}

// Rods along z in a box of 8 x 10 x 3: closed in the other directions as soon as their balls are large enough.
TEST(Pores, ABox) {
  const double closed = std::nan("");
  for (const double radius : {1.6, 4.5, 6.5}) {
    const TemporaryFile file("rod.xyzr", "3 2 1 " + std::to_string(radius) + "\n");
    const auto diameter = [&](double square) {
      return std::sqrt(square) > radius ? 2 * (std::sqrt(square) - radius) : closed;
    };
    const Json json = run_json({"pores", file.path(), "--box", "8,10,3"});
    EXPECT_EQ(json.keys, (Words{"n", "box", "largest_cavity_diameter", "pore_limiting_diameter",
                                "included_cavity_diameter", "pore_limiting_diameter_along", "channel_list", "maxima",
                                "gates", "merges", "cavities", "maximum_list", "gate_list", "input"}));
    EXPECT_NEAR(json["largest_cavity_diameter"].number, diameter(43.25), 1e-7);
    expect_diameters(json["pore_limiting_diameter"], {diameter(41), diameter(27.25), diameter(18.25)});
    expect_diameters(json["pore_limiting_diameter_along"], {diameter(27.25), diameter(18.25), diameter(41)});
    const Json &channel = json["channel_list"].items.at(0);
    EXPECT_EQ(json["channel_list"].items.size(), 1u);
    EXPECT_EQ(channel["directions"].number, radius == 1.6 ? 3 : radius == 4.5 ? 2 : 0);
    EXPECT_EQ(channel["rows"].items.size(), channel["directions"].number);
    for (const Json &gate : json["gate_list"].items) {
      int apart = 0;
      for (size_t axis = 0; axis < 3; ++axis) {
        apart += std::abs(
            static_cast<int>(gate["end_shift"].items.at(axis).number - gate["other_end_shift"].items.at(axis).number));
      }
      EXPECT_EQ(apart, 1);
    }
  }
  const TemporaryFile file("rod.xyzr", "3 2 1 1.6\n");
  const std::string table = run_program({"pores", file.path(), "--box", "8,10,3", "--gates", "--csv"}).out;
  EXPECT_NE(table.find("end_shift_x"), std::string::npos);
}

// Rods once more: of the probe that fits between them what it gets to, of wider ones what they do not; volumes add up
// to those of the box that `measure` has. Of a cage the same as its void.
TEST(Pores, Regions) {
  const TemporaryFile file("rod.xyzr", "3 2 1 1.6\n");
  for (const char *probe : {"0", "2.9", "3.5", "4.95"}) {
    const Words box = {file.path(), "--box", "8,10,3", "--probe", probe};
    Words pores = {"pores", "--regions"}, measure = {"measure"};
    pores.insert(pores.end(), box.begin(), box.end());
    measure.insert(measure.end(), box.begin(), box.end());
    const Json found = run_json(pores), whole = run_json(measure);
    const double open = found["accessible_volume"].number, blocked = found["blocked_volume"].number;
    EXPECT_NEAR(open + blocked, whole["free_volume"].number, 1e-9);
    EXPECT_NEAR(found["accessible_area"].number + found["blocked_area"].number, whole["area"].number, 1e-8);
    const Json &region = found["region_list"].items.at(0);
    const bool narrow = std::string(probe) != "4.95";
    EXPECT_EQ(found["region_list"].items.size(), 1u);
    EXPECT_EQ(found["accessible_regions"].number, narrow ? 1 : 0);
    EXPECT_EQ(found["blocked_regions"].number, narrow ? 0 : 1);
    EXPECT_EQ(region["access"].text, narrow ? "accessible" : "blocked");
    EXPECT_EQ((narrow ? open : blocked), region["volume"].number);
    EXPECT_NEAR(region["radius"].number, std::sqrt(43.25) - 1.6, 1e-7);
    EXPECT_NEAR(region["xyz"].items.at(0).number, 7, 1e-7);
    pores.push_back("--csv");
    const std::string table = run_program(pores).out;
    EXPECT_EQ(table.substr(0, table.find('\n')),
              "region,x,y,z,radius,access,area,volume,directions,maxima,shells,along");
    pores.back() = "--tunnels-from=7,7,2.5";
    EXPECT_EQ(run_json(pores)["tunnels"].number > 0, narrow);  // of the box itself, as ever
  }
  const Json cage = run_json({"pores", "good/cage.xyzr", "--regions"});
  const Json inside = run_json({"voids", "good/cage.xyzr"})["voids"].items.at(0);
  EXPECT_EQ(cage["accessible_volume"].kind, Json::Kind::null);
  EXPECT_EQ(cage["region_list"].items.at(0)["xyz"].kind, Json::Kind::null);
  EXPECT_NEAR(cage["blocked_volume"].number, inside["volume"].number, 1e-12);
  EXPECT_NEAR(cage["blocked_area"].number, inside["area"].number, 1e-12);
  EXPECT_EQ(cage["largest_cavity_diameter"].number, 0.2);
}

// Between rods, tunnels to a copy lead along each vector in turn; to another point they end at the best copy of it.
TEST(Pores, TunnelsInABox) {
  const TemporaryFile file("rod.xyzr", "3 2 1 1.6\n");
  const Words box = {"pores", file.path(), "--box", "8,10,3"};
  const auto asked = [&](const Words &more) {
    Words words = box;
    words.insert(words.end(), more.begin(), more.end());
    return run_json(words);
  };
  for (const std::string way : {"--tunnels-from=-1,7,2.5", "--tunnels-from=maximum:0", "--tunnels-from=atom:0"}) {
    const Json json = asked({way, "--tunnels", "9"});
    EXPECT_EQ(json["to"].kind, Json::Kind::null);
    const std::vector<Json> &tunnels = json["tunnel_list"].items;
    ASSERT_EQ(tunnels.size(), 3u);
    const double squares[] = {41, 27.25, 18.25}, lengths[] = {3, 8, 10};
    const size_t along[] = {2, 0, 1};
    for (size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(tunnels[k]["radius"].number, std::sqrt(squares[k]) - 1.6, 1e-7);
      EXPECT_NEAR(tunnels[k]["length"].number, lengths[k], 1e-7);
      EXPECT_NEAR(tunnels[k]["cost"].number, lengths[k] / ((std::sqrt(43.25) - 1.6) * (std::sqrt(squares[k]) - 1.6)),
                  1e-7);
      for (size_t axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(std::abs(tunnels[k]["shift"].items.at(axis).number), axis == along[k] ? 1 : 0);
      }
    }
    const Json &first = json["tunnel_points"].items.front(), &last = json["tunnel_points"].items.back();
    EXPECT_NEAR(std::abs(first["xyz"].items.at(1).number - last["xyz"].items.at(1).number), 10, 1e-7);
  }
  // In the middle of the window along y, two boxes away.
  const Json to = asked({"--tunnels-from", "maximum:0", "--tunnels-to", "-17,2,2.5", "--cheapest"});
  EXPECT_EQ(to["to"].items.at(0).number, -17);
  ASSERT_EQ(to["tunnels"].number, 1);
  EXPECT_EQ(to["tunnel_list"].items.at(0)["gates"].number, 0);
  EXPECT_EQ(to["tunnel_list"].items.at(0)["cost"].number, 0);
}

// Through a wide detour or a narrow window: by width or by cost.
TEST(Pores, CheapestTunnels) {
  const Words place = {"pores", crambin(), "--tunnels-from", "maximum:5", "--tunnels", "5"};
  const auto tunnels = [&](const Words &more) {
    Words words = place;
    words.insert(words.end(), more.begin(), more.end());
    return run_json(words)["tunnel_list"].items;
  };
  const std::vector<Json> wide = tunnels({}), cheap = tunnels({"--cheapest"});
  ASSERT_EQ(wide.size(), cheap.size());
  EXPECT_LT(cheap[0]["cost"].number, wide[0]["cost"].number);
  EXPECT_LT(cheap[0]["radius"].number, wide[0]["radius"].number);
  for (size_t k = 1; k < cheap.size(); ++k) EXPECT_GE(cheap[k]["cost"].number, cheap[k - 1]["cost"].number);
  // Between two maxima: as wide as the tunnel back.
  const std::string ends[2] = {"maximum:1", "maximum:5"};
  std::vector<double> radius;
  for (const size_t k : {0u, 1u}) {
    const Json json = run_json({"pores", crambin(), "--tunnels-from", ends[k], "--tunnels-to", ends[1 - k]});
    radius.push_back(json["tunnel_list"].items.at(0)["radius"].number);
    EXPECT_EQ(json["to"].items.at(0).text, json["maximum_list"].items.at(k == 0 ? 5 : 1)["xyz"].items.at(0).text);
  }
  EXPECT_EQ(radius[0], radius[1]);
}

// Radii are half of UFF's sigma; what other codes print differs in the third or second digit.
struct Framework {
  const char *name;
  double box[3];
  double largest;
  std::vector<double> through;

  std::string sides() const {
    return std::to_string(box[0]) + "," + std::to_string(box[1]) + "," + std::to_string(box[2]);
  }
};

const Framework frameworks[] = {{"irmof1", {25.832, 25.832, 25.832}, 15.044817, {7.770973, 7.770973, 7.770973}},
                                {"hkust1", {26.28791, 26.28791, 26.28791}, 13.004338, {6.337657, 6.337657, 6.337657}},
                                {"mil47", {27.272, 32.286, 27.878}, 7.617532, {7.150077, 1.450825, 1.450825}}};

TEST(Pores, Frameworks) {
  for (const Framework &framework : frameworks) {
    const auto file = support::further_molecule("frameworks/" + std::string(framework.name) + ".xyzr");
    if (!file.has_value()) GTEST_SKIP() << framework.name;
    const Json json = run_json({"pores", file->string(), "--box", framework.sides()});
    EXPECT_NEAR(json["largest_cavity_diameter"].number, framework.largest, 1e-6);
    expect_diameters(json["pore_limiting_diameter"], framework.through);
    EXPECT_NEAR(json["included_cavity_diameter"].items.at(0).number, framework.largest, 1e-6);
  }
}

// A path at one probe, certified in integers, gets out of the middle of 27 cells if the probe is a little narrower, and
// no path if it is a little wider. The channels of MIL-47 along x are walled up at both ends where two directions are
// asked for.
TEST(Pores, FrameworksFromBothSides) {
  for (const Framework &framework : frameworks) {
    const auto file = support::further_molecule("frameworks/" + std::string(framework.name) + ".xyzr");
    if (!file.has_value()) GTEST_SKIP() << framework.name;
    const Json json = run_json({"pores", file->string(), "--box", framework.sides()});
    const std::vector<Json> &middle = json["maximum_list"].items.at(0)["xyz"].items;
    std::ifstream balls(*file);
    std::ostringstream cells, walls;
    for (std::string line; std::getline(balls, line);) {
      std::istringstream words(line);
      double xyz[3], radius = 0;
      if (!(words >> xyz[0] >> xyz[1] >> xyz[2] >> radius)) continue;
      for (int cell = 0; cell < 27; ++cell) {
        const int at[3] = {cell % 3 - 1, cell / 3 % 3 - 1, cell / 9 - 1};
        for (int axis = 0; axis < 3; ++axis) {
          const double side = framework.box[axis];
          cells << std::setprecision(12) << xyz[axis] - std::floor(xyz[axis] / side) * side + at[axis] * side << " ";
        }
        cells << radius << "\n";
      }
    }
    for (double y = -framework.box[1]; y < 2 * framework.box[1]; y += 2) {
      for (double z = -framework.box[2]; z < 2 * framework.box[2]; z += 2) {
        walls << -framework.box[0] << " " << y << " " << z << " 3\n";
        walls << 2 * framework.box[0] << " " << y << " " << z << " 3\n";
      }
    }
    for (size_t d = 0; d < (framework.through[0] == framework.through[1] ? 1 : 2); ++d) {
      const TemporaryFile around("cells.xyzr", cells.str() + (d > 0 ? walls.str() : ""));
      const double radius = json["pore_limiting_diameter"].items.at(d).number / 2;
      for (const double aside : {-2e-6, 2e-6}) {
        std::ostringstream probe;
        probe << std::setprecision(12) << radius + aside;
        const Json path = run_json({"path", around.path(), "--probe", probe.str(), "--from", middle.at(0).text,
                                    middle.at(1).text, middle.at(2).text, "--to", "-200", "-200", "-200"});
        EXPECT_EQ(path["connected"].boolean, aside < 0) << framework.name << " " << d;
        EXPECT_EQ(path["certified"].boolean, aside < 0) << framework.name << " " << d;
      }
    }
  }
}

// The balls of a cube of n x n x n points, `apart` from each other: all of them, or those of its walls.
std::string cube_of_balls(int n, bool walls, double apart, double radius) {
  std::ostringstream balls;
  for (int i = 0; i < n * n * n; ++i) {
    const int at[3] = {i / (n * n), i / n % n, i % n};
    const bool in_wall = std::any_of(at, at + 3, [n](int k) { return k == 0 || k == n - 1; });
    if (walls && !in_wall) continue;
    for (const int k : at) balls << k * apart << " ";
    balls << radius << "\n";
  }
  return balls.str();
}

// Pockets are measured, and spheres in voids found, in further memory: where that is short, too, the program says so.
// It has once listed them with an unknown volume, or without a point.
TEST(Pores, MemoryThatIsShort) {
  const TemporaryFile full("full.xyzr", cube_of_balls(8, false, 2.0, 0.9));
  const TemporaryFile hollow("hollow.xyzr", cube_of_balls(16, true, 1.0, 0.8));
  const std::vector<Words> commands = {{"pores", full.path(), "--probe", "0.4", "--pockets", "0.6"},
                                       {"voids", hollow.path()}};
  for (Words words : commands) {
    words.insert(words.end(), {"--csv", "--threads", "1"});
    const Outcome all = run_program(words);
    ASSERT_EQ(all.status, 0) << all.err;
    for (rlim_t kilobytes = 4000; kilobytes <= 12000; kilobytes += 500) {
      Surroundings narrow;
      narrow.before = [kilobytes] {
        const struct rlimit limit = {1024 * kilobytes, 1024 * kilobytes};
        (void)setrlimit(RLIMIT_AS, &limit);
      };
      const Outcome outcome = run_program_in(narrow, words);
      EXPECT_EQ(outcome.out, outcome.status == 0 ? all.out : "") << words.at(0) << ", " << kilobytes << " KiB";
    }
  }
}

}  // namespace
