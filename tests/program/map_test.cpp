// hardsphere map and pick: what is seen, against another program's counts, and the same thing seen from elsewhere.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "json_outcome.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"

namespace {

std::string molecule(const std::string &name) {
  return molecules_folder() + "/" + name;
}

// The first atoms of crambin.
std::string first_atoms(TemporaryFolder &folder, int atoms) {
  const std::string path = folder.path(std::to_string(atoms) + ".pdb");
  std::istringstream lines(read_file(molecule("crambin.pdb")));
  std::ofstream out(path);
  for (std::string line; atoms > 0 && std::getline(lines, line);) {
    if (line.rfind("ATOM", 0) != 0) continue;
    out << line << '\n';
    --atoms;
  }
  return path;
}

// CGAL 5.5, Envelope_3 with Env_sphere_traits_3: the lower envelope along z, which is what is seen from below. It cuts
// circles into pieces, so that its vertices and edges are more.
TEST(Map, HasTheFacesThatCgalCounts) {
  TemporaryFolder folder("map");
  const struct {
    std::string file;
    double faces;
  } known[] = {{molecule("caffeine.pdb"), 29},
               {first_atoms(folder, 24), 25},
               {first_atoms(folder, 48), 53},
               {molecule("crambin.pdb"), 204}};
  for (const auto &[file, faces] : known) {
    EXPECT_EQ(run_json({"map", file, "--view", "0,0,-1"})["faces"].number, faces) << file;
  }
  // The same of crambin upside down.
  EXPECT_EQ(run_json({"map", molecule("crambin.pdb"), "--view", "0,0,1"})["faces"].number, 205);
}

TEST(Map, AreasOfBallsSumUp) {
  for (const char *view : {"0,0,1", "1,2,3", "-1,0,0"}) {
    const Json json = run_json({"map", molecule("crambin.pdb"), "--view", view});
    double sum = 0;
    double before = -1;
    for (const Json &ball : json["balls"].items) {
      EXPECT_GT(ball["visible_area"].number, 0);
      EXPECT_GT(ball["ball"].number, before);
      before = ball["ball"].number;
      sum += ball["visible_area"].number;
    }
    EXPECT_NEAR(sum, json["visible_area"].number, 1e-9 * sum);
    EXPECT_EQ(static_cast<double>(json["balls"].items.size()), json["visible_balls"].number);
    EXPECT_EQ(json["moved"].number, 0);
  }
}

// A ball that covers the view plane does so from behind too, though other balls show there.
TEST(Map, CoversTheSameFromBehind) {
  const Json front = run_json({"map", molecule("caffeine.pdb"), "--probe", "1.4"});
  const Json back = run_json({"map", molecule("caffeine.pdb"), "--probe", "1.4", "--rotate", "0,180,0"});
  EXPECT_NEAR(front["visible_area"].number, back["visible_area"].number, 1e-9);
}

// A point of a ball's front is picked at its place in the file's coordinates, from any side.
TEST(Pick, NamesTheBallAtAPlaceOfTheFile) {
  TemporaryFolder folder("pick");
  const std::string file = folder.path("two.xyzr");
  std::ofstream(file) << "10 20 30 2\n10 20 50 1\n";
  const Json near = run_json({"pick", file, "--at", "10,20", "--view", "0,0,1"});
  EXPECT_EQ(near["ball"].number, 1);
  EXPECT_NEAR(near["depth"].number, 51, 1e-9);
  const Json far = run_json({"pick", file, "--at", "11.2,20", "--view", "0,0,1"});
  EXPECT_EQ(far["ball"].number, 0);
  EXPECT_NEAR(far["depth"].number, 31.6, 1e-9);
  // From the right, z upwards: y grows to the right.
  const Json side = run_json({"pick", file, "--at", "20 50", "--view", "1,0,0", "--up", "0,0,1"});
  EXPECT_EQ(side["ball"].number, 1);
  EXPECT_NEAR(side["depth"].number, 11, 1e-9);
  const Outcome beside = run_program({"pick", file, "--at", "0,0", "--json"});
  EXPECT_EQ(beside.out.rfind("{\"ball\": null, \"depth\": null, \"input\"", 0), 0u) << beside.out;
}

}  // namespace
