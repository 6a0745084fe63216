// The boxes of frames: what the numbers of a .dcd file's cell mean, cells that stand for none, and frames that have
// none.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "json_reader.hpp"
#include "program_runner.hpp"
#include "temporary_file.hpp"
#include "trajectory_writers.hpp"

namespace {

using trajectories::Bytes;
using trajectories::DcdOptions;
using trajectories::Floats;
using trajectories::XtcOptions;
using Vector = std::array<double, 3>;
using Box = std::array<Vector, 3>;

Bytes dcd_of(const std::array<double, 6> &numbers, uint32_t version, const Floats &atoms) {
  DcdOptions options;
  options.cell = true;
  options.numbers = numbers;
  options.version = version;
  options.frames = 1;
  return trajectories::dcd_header(static_cast<uint32_t>(atoms.size()), options) +
         trajectories::dcd_frame(atoms, true, options);
}

Json frame_of(const std::string &molecule, const Bytes &frames, const std::string &name) {
  const TemporaryFile first("molecule.xyz", molecule), run(name, frames);
  const Outcome outcome =
      run_program({"measure", first.path(), "--trajectory", run.path(), "--box", "file", "--radius", "C=1", "--json"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  return read_json(outcome.out).value_or(Json{});
}

double dot(const Vector &a, const Vector &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double volume_of(const Box &v) {
  const Vector cross = {v[1][1] * v[2][2] - v[1][2] * v[2][1], v[1][2] * v[2][0] - v[1][0] * v[2][2],
                        v[1][0] * v[2][1] - v[1][1] * v[2][0]};
  return dot(v[0], cross);
}

std::array<double, 6> written(const Box &v) {
  return {v[0][0], v[0][1], v[1][1], v[0][2], v[1][2], v[2][2]};
}

// The vectors are as they were written, in the frame of the atoms, and so is the least distance of two of these.
TEST(TrajectoryBoxes, NewerVersionsOfCharmmWriteVectors) {
  const struct {
    Box box;
    uint32_t version;
  } cases[] = {
      {{{{4.1099, 0.575, 0.2819}, {0.575, 4.7071, 0.2688}, {0.2819, 0.2688, 10.9932}}}, 46},
      {{{{4.1099, -0.575, 0.2819}, {-0.575, 4.7071, -0.2688}, {0.2819, -0.2688, 10.9932}}}, 25},
      {{{{40.0, 12.5, 7.25}, {12.5, 38.0, 9.0}, {7.25, 9.0, 44.0}}}, 46},
      {{{{40.0, 0.0, 0.0}, {0.0, 38.0, 0.0}, {0.0, 0.0, 44.0}}}, 46},
      // Neither angles nor cosines, whatever program wrote them.
      {{{{40.0, -10.7, 0.0}, {-10.7, 40.0, 0.0}, {0.0, 0.0, 44.0}}}, 24},
      {{{{40.0, 10.7, 0.0}, {10.7, 40.0, 0.0}, {0.0, 0.0, 44.0}}}, 24},
  };
  for (const auto &it : cases) {
    const Box &v = it.box;
    Vector second = {};
    for (size_t k = 0; k < 3; ++k) second[k] = 0.5 * v[0][k] + 0.45 * v[1][k] + 0.05 * v[2][k];
    const Floats atoms = {
        {0, 0, 0}, {static_cast<float>(second[0]), static_cast<float>(second[1]), static_cast<float>(second[2])}};
    const Json frame = frame_of("2\n\nC 0 0 0\nC 0 0 9\n", dcd_of(written(v), it.version, atoms), "vectors.dcd");
    EXPECT_NEAR(frame["box_volume"].number, volume_of(v), 1e-6);
    ASSERT_EQ(frame["box"].items.size(), 9U);
    Box found;
    for (size_t k = 0; k < 9; ++k) found[k / 3][k % 3] = frame["box"].items[k].number;
    for (size_t a = 0; a < 3; ++a) {
      for (size_t b = 0; b < 3; ++b) EXPECT_NEAR(dot(found[a], found[b]), dot(v[a], v[b]), 1e-9);
    }
    for (size_t k = 0; k < 9; ++k) EXPECT_EQ(found[k / 3][k % 3], v[k / 3][k % 3]);
    // All images by brute force: the balls share what pairs share, as long as no three meet.
    double volume = 2 * 4.0 / 3.0 * 3.14159265358979323846;
    for (int i = -3; i <= 3; ++i) {
      for (int j = -3; j <= 3; ++j) {
        for (int k = -3; k <= 3; ++k) {
          Vector way = {};
          for (size_t axis = 0; axis < 3; ++axis) {
            way[axis] = static_cast<double>(atoms[1][axis]) + i * v[0][axis] + j * v[1][axis] + k * v[2][axis];
          }
          const double d = std::sqrt(dot(way, way));
          if (d < 2) volume -= 3.14159265358979323846 * (4 + d) * (2 - d) * (2 - d) / 12;
        }
      }
    }
    EXPECT_NEAR(frame["volume"].number, volume, 1e-6);
  }
  const Box sample = cases[0].box;
  EXPECT_NEAR(std::sqrt(dot(sample[0], sample[0])), 4.1595, 1e-4);
  EXPECT_NEAR(std::sqrt(dot(sample[2], sample[2])), 11.0001, 1e-4);
}

TEST(TrajectoryBoxes, OthersWriteAnglesOrCosines) {
  const double sixty = std::sqrt(0.75);
  const struct {
    std::array<double, 6> numbers;
    uint32_t version;
    double volume;
  } cases[] = {
      {{50, 90, 60, 90, 90, 70}, 24, 210000},        {{50, 0, 60, 0, 0, 70}, 24, 210000},
      {{50, 0.5, 60, 0, 0, 70}, 24, 210000 * sixty}, {{50, 60, 60, 90, 90, 70}, 24, 210000 * sixty},
      {{50, 90, 60, 90, 90, 70}, 46, 210000},        {{50, 60, 60, 90, 90, 70}, 30, 210000 * sixty},
  };
  for (const auto &it : cases) {
    const Json frame = frame_of("1\n\nC 0 0 0\n", dcd_of(it.numbers, it.version, {{0, 0, 0}}), "angles.dcd");
    EXPECT_NEAR(frame["box_volume"].number, it.volume, 1e-4);
  }
}

const std::string bare = "1\n\nC 0 0 0\n";
const std::string boxed = "1\nLattice=\"9 0 0 0 9 0 0 0 9\"\nC 0 0 0\n";

std::string cryst1(const std::string &side) {
  return "CRYST1" + side + side + side + "  90.00  90.00  90.00 P 1           1\n";
}
const std::string pdb_model =
    "MODEL        1\nATOM      1  C   UNK A   1       0.000   0.000   0.000  1.00  0.00           C\nENDMDL\n";

std::string gro(const std::string &box) {
  return "frame\n    1\n    1UNK      C    1   0.000   0.000   0.000\n" + box + "\n";
}

// Rows that are printed before a frame without a box, and the number of that; 0: there is none.
TEST(TrajectoryBoxes, FramesWithoutABox) {
  std::mt19937 random(3);
  XtcOptions none, tiny, plain;
  none.box = 0;
  tiny.box = 0.1F;
  plain.box = 2;
  DcdOptions without;
  without.frames = 1;
  const auto xtc = [&random](const XtcOptions &options) {
    return trajectories::xtc_frame({{0, 0, 0}}, options, random);
  };
  const struct {
    const char *what;
    std::string molecule;
    const char *name;
    Bytes frames;
    size_t refused;
  } cases[] = {
      {"placeholder", boxed, "a.dcd", dcd_of({1, 90, 1, 90, 90, 1}, 24, {{0, 0, 0}}), 1},
      {"placeholder as cosines", boxed, "b.dcd", dcd_of({1, 0, 1, 0, 0, 1}, 24, {{0, 0, 0}}), 1},
      {"placeholder as vectors", boxed, "c.dcd", dcd_of({1, 0, 1, 0, 0, 1}, 46, {{0, 0, 0}}), 1},
      {"nothing", boxed, "d.dcd", dcd_of({0, 0, 0, 0, 0, 0}, 24, {{0, 0, 0}}), 1},
      {"nothing as vectors", boxed, "e.dcd", dcd_of({0, 0, 0, 0, 0, 0}, 46, {{0, 0, 0}}), 1},
      {"no cells at all", boxed, "f.dcd",
       trajectories::dcd_header(1, without) + trajectories::dcd_frame({{0, 0, 0}}, true, without), 0},
      {"no cells at all, nor in the molecule", bare, "g.dcd",
       trajectories::dcd_header(1, without) + trajectories::dcd_frame({{0, 0, 0}}, true, without), 1},
      {"placeholder", boxed, "h.xtc", xtc(tiny), 1},
      {"none behind one", bare, "i.xtc", xtc(plain) + xtc(none), 2},
      {"none behind one", bare, "j.xyz", boxed + boxed + bare + boxed, 3},
      {"none behind one, but one in the molecule", boxed, "k.xyz", boxed + bare, 2},
      {"none, but one in the molecule", boxed, "l.xyz", bare + bare, 0},
      {"placeholder", boxed, "m.xyz", boxed + "1\nLattice=\"1 0 0 0 1 0 0 0 1\"\nC 0 0 0\n", 2},
      {"none behind one", bare, "n.gro", gro("2 2 2") + gro("0 0 0"), 2},
      {"placeholder", bare, "o.gro", gro("2 2 2") + gro("0.1 0.1 0.1"), 2},
      {"one for all", bare, "p.pdb", cryst1("    9.000") + pdb_model + pdb_model, 0},
      {"placeholder behind one", boxed, "q.pdb", cryst1("    9.000") + pdb_model + cryst1("    1.000") + pdb_model, 2},
  };
  for (const auto &it : cases) {
    const TemporaryFile molecule("molecule.xyz", it.molecule), run(it.name, it.frames);
    const Outcome outcome = run_program({"measure", molecule.path(), "--trajectory", run.path(), "--box", "file"});
    EXPECT_EQ(outcome.status, it.refused > 0 ? 1 : 0) << it.name << ": " << it.what << "\n" << outcome.err;
    const auto lines = static_cast<size_t>(std::count(outcome.out.begin(), outcome.out.end(), '\n'));
    if (it.refused == 0) continue;
    EXPECT_EQ(lines, it.refused == 1 ? 0 : it.refused) << it.name << ": " << it.what;
    EXPECT_NE(outcome.err.find("frame " + std::to_string(it.refused) + ": --box file: the frame has no box"),
              std::string::npos)
        << it.name << ": " << outcome.err;
    // Without a box they are measured.
    EXPECT_EQ(run_program({"measure", molecule.path(), "--trajectory", run.path()}).status, 0);
  }
}

// Boxes of frames that are stepped over are known: a record that is for all models behind it, and that a file has any.
TEST(TrajectoryBoxes, OfFramesThatAreSteppedOver) {
  const TemporaryFile molecule("molecule.xyz", boxed), run("run.pdb", cryst1("   20.000") + pdb_model + pdb_model);
  const Outcome second =
      run_program({"measure", molecule.path(), "--trajectory", run.path(), "--frames", "2", "--box", "file", "--json"});
  ASSERT_EQ(second.status, 0) << second.err;
  EXPECT_EQ(read_json(second.out).value_or(Json{})["box_volume"].number, 8000);
  const TemporaryFile mixed("run.xyz", boxed + bare);
  const Outcome refused =
      run_program({"measure", molecule.path(), "--trajectory", mixed.path(), "--frames", "2", "--box", "file"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("frame 2"), std::string::npos) << refused.err;
}

// A single model has its own box or none.
TEST(TrajectoryBoxes, OfASingleModel) {
  const TemporaryFile xyz("models.xyz", boxed + bare + boxed);
  EXPECT_EQ(run_program({"measure", xyz.path(), "--box", "file"}).status, 0);
  EXPECT_NE(run_program({"measure", xyz.path(), "--box", "file", "--model", "2"}).err.find("the file has no box"),
            std::string::npos);
  EXPECT_EQ(run_program({"measure", xyz.path(), "--box", "file", "--model", "3"}).status, 0);
  const TemporaryFile pdb("none.pdb", cryst1("    1.000") + pdb_model);
  EXPECT_NE(run_program({"measure", pdb.path(), "--box", "file"}).err.find("the file has no box"), std::string::npos);
}

}  // namespace
