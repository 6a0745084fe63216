// Steps 1 and 2 in lanes of every target against those one by one: the same vertices in the
// same order, circles, half-edges, faces, components and needed limits, with every stage left out in turn.
#include "sphere/lane_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include "boundary/boundary_builder.hpp"
#include "built_grid.hpp"
#include "degenerate_set.hpp"
#include "gridless_balls.hpp"
#include "lattice_lengths.hpp"
#include "molecule_file.hpp"
#include "random_balls.hpp"
#include "runnable_targets.hpp"

#if HSP_LANES
namespace {

struct Stages {
  bool enabled, floats, doubles;
};
constexpr Stages scalar{false, false, false};
constexpr Stages all_stages{true, true, true};
constexpr Stages ways[] = {all_stages, {true, false, true}, {true, true, false}, {true, false, false}};

template <class T>
void append_bytes(std::string &bytes, const T *items, size_t count) {
  bytes.append(reinterpret_cast<const char *>(items), count * sizeof(T));
}

// A builder with limits, for one grid after the other.
class Builder {
 public:
  explicit Builder(const hsp::BoundaryLimits &limits) {
    memory_.carve(builder_, limits);
    has_room_ = builder_.lanes().enabled;
  }

  // All that the stages find, as bytes.
  std::string result(const hsp::CubeGrid &grid, const Stages &stages, hsp::Target target) {
    builder_.use(target, stages.enabled);
    builder_.lanes().floats = stages.floats;
    builder_.lanes().doubles = stages.doubles;
    status = builder_.build(grid);
    const hsp::BoundaryArrays &a = builder_.arrays();
    std::string bytes;
    append_bytes(bytes, a.vertices.items().data(), a.vertices.size());
    append_bytes(bytes, a.circles.items().data(), a.circles.size());
    append_bytes(bytes, &builder_.needed(), 1);
    // But for clusters: whether they are few enough to be counted depends on which caps were left out.
    for (uint32_t i = 0; i < a.balls; ++i) {
      bytes.push_back(static_cast<char>(a.ball_state[i] % hsp::BoundaryArrays::one_cluster));
    }
    if (status != hsp::Status::ok) return bytes;
    append_bytes(bytes, a.root_discriminant.data(), a.vertices.size());
    append_bytes(bytes, a.half_edges.data(), builder_.boundary().half_edge_count());
    append_bytes(bytes, a.half_edge_at.data(), builder_.boundary().half_edge_count());
    append_bytes(bytes, a.loop_start.data(), a.loop_count);
    append_bytes(bytes, a.loop_face.data(), a.loop_count);
    append_bytes(bytes, a.first.data(), a.balls + 1);
    append_bytes(bytes, a.component.data(), a.balls);
    for (uint32_t i = 0; i < a.balls; ++i) {
      const uint32_t root = builder_.boundary().component_origin(i);
      append_bytes(bytes, &root, 1);
    }
    return bytes;
  }

  hsp::Status status = hsp::Status::ok;
  uint32_t vertices() const { return builder_.boundary().vertex_count(); }
  bool has_room() const { return has_room_; }

 private:
  CarvedMemory memory_;
  hsp::BoundaryBuilder builder_;
  bool has_room_ = false;
};

// Limits from such that hardly anything fits to ample ones.
uint32_t expect_same_results(const std::string &name, const support::BallList &balls, double probe, double step) {
  const uint32_t n = balls.size();
  const BuiltGrid built(balls, probe, step);
  EXPECT_EQ(built.status(), hsp::Status::ok);
  uint32_t vertices = 0;
  for (const hsp::BoundaryLimits &limits :
       {hsp::BoundaryLimits{n, 1, 2, 1}, hsp::BoundaryLimits{n, 7, 10, 3}, hsp::BoundaryLimits{n, n, 3, n},
        hsp::BoundaryLimits{n, n, 24 * n, 4 * n}}) {
    Builder builder(limits);
    EXPECT_TRUE(builder.has_room());
    const std::string expected = builder.result(built.grid(), scalar, hsp::Target::baseline);
    vertices = builder.vertices();
    for (const hsp::Target target : runnable_targets()) {
      for (const Stages &stages : ways) {
        EXPECT_EQ(expected == builder.result(built.grid(), stages, target), true)
            << name << ", probe " << probe << ", neighbours " << limits.neighbours << ", floats " << stages.floats
            << ", doubles " << stages.doubles << ", target " << static_cast<int>(target);
      }
    }
  }
  return vertices;
}

TEST(LaneSearch, DegenerateSets) {
  uint32_t vertices = 0;
  std::vector<degenerate::DegenerateSet> sets = degenerate::read_sets(HSP_DEGENERATE_SETS);
  for (degenerate::DegenerateSet &set : degenerate::made_sets()) sets.push_back(std::move(set));
  for (const degenerate::DegenerateSet &set : sets) {
    if (set.balls.size() > 2000) continue;
    vertices += expect_same_results(set.name, oracle::in_lengths(set.balls, 1), 0.0, 1.0);
  }
  EXPECT_GT(vertices, 1000U);
}

// So many pairs are left to integers that lanes give up, some after they have found vertices.
TEST(LaneSearch, SpheresThroughOnePoint) {
  oracle::RandomSource random(29);
  for (const size_t n : {40U, 60U, 90U, 140U}) {
    const oracle::Balls balls = oracle::balls_through_point(random, n);
    EXPECT_GT(expect_same_results("through one point", oracle::in_lengths(balls, 1), 0.0, 1.0), 20U);
  }
}

TEST(LaneSearch, Molecules) {
  for (const char *file : {"caffeine.pdb", "crambin.pdb"}) {
    const support::BallList balls =
        with_radii(support::read_atoms(support::own_molecule(file)), support::Radii::van_der_waals);
    for (const double probe : {0.0, 0.3, 0.7, 1.4, 2.5}) expect_same_results(file, balls, probe, 0.0);
  }
}

// In boxes that leave from one to hundreds of neighbours; radii alike and as different as can be.
TEST(LaneSearch, RandomSets) {
  oracle::RandomSource random(811);
  for (int k = 0; k < 60; ++k) {
    constexpr double spreads[] = {0.0, 0.1, 0.5, 3.0, 50.0, 1e6};
    const double spread = spreads[k % 6];
    const double box = (1.0 + spread / 3.0) * (1.0 + k % 5);
    const double shift = k % 7 == 0 ? 1e5 : 0.0;
    support::BallList balls;
    for (int i = 0; i < 20 + 12 * (k % 9); ++i) {
      const double x = random.fraction(), y = random.fraction(), z = random.fraction(), r = random.fraction();
      balls.add(shift + box * x, box * y, box * z - shift, 1.0 + spread * r * r * r * r);
    }
    expect_same_results("random " + std::to_string(k), balls, k % 4 == 0 ? 0.5 : 0.0, 0.0);
  }
}

// So many caps a ball that those which may touch its free part are looked for first (exposed_caps).
TEST(LaneSearch, CrowdedSets) {
  oracle::RandomSource random(812);
  for (const double box : {0.5, 1.2}) {
    support::BallList balls;
    for (int i = 0; i < 220; ++i) {
      const double x = random.fraction(), y = random.fraction(), z = random.fraction();
      balls.add(box * x, box * y, box * z, 1.0 + 0.2 * random.fraction());
    }
    EXPECT_GT(expect_same_results("crowded", balls, 0.0, 0.0), 20U);
  }
}

// Balls around a circle and on a line that each have an arc on one beside them: with all of its caps lanes find it, or
// give up, and boxes are for the rest (cap_boxes).
TEST(LaneSearch, ManyLargeCapsThatAllMatter) {
  constexpr int n = 200;
  for (const bool around : {true, false}) {
    support::BallList balls;
    for (int k = 0; k < n; ++k) {
      const double turn = 2 * std::numbers::pi * k / n;
      if (around) {
        balls.add(0.9 * std::cos(turn), 0.9 * std::sin(turn), 0.1, 0.5);
      } else {
        balls.add(0.001 * (k - n / 2), 1.1, 0.0, 1.0);
      }
    }
    balls.add(0.0, 0.0, 0.0, 1.0);
    EXPECT_GT(expect_same_results(around ? "around" : "beside", balls, 0.0, 0.0), 390U);
  }
}

// Whole numbers: balls that touch, contain and equal each other, points among them.
TEST(LaneSearch, SmallIntegers) {
  oracle::RandomSource random(812);
  for (int k = 0; k < 40; ++k) {
    support::BallList balls;
    const int side = 4 + k % 9;
    for (int i = 0; i < 40 + k; ++i) {
      const auto whole = [&random](int below) { return std::floor(random.fraction() * below); };
      const double x = whole(side), y = whole(side), z = whole(side);
      balls.add(x, y, z, whole(2 + k % 4));
    }
    expect_same_results("integers " + std::to_string(k), balls, 0.0, 1.0);
  }
}

// Balls of the largest radii there are, that touch or nearly do.
TEST(LaneSearch, LargestRadii) {
  constexpr double most = 0x1p30 - 1;
  for (const double radius : {most, 0x1p30 - 0x1p14 - 1, 0x1p29}) {
    for (const double gap : {-1.0, 0.0, 1.0, 1e3}) {
      for (const double origin : {-0x1p50, 0x1p49 + 1}) {
        support::BallList balls;
        balls.add(origin, 0, 0, radius);
        balls.add(origin + radius + most + gap, 0, 0, most);
        balls.add(origin + 0x1p30, 0x1p29, 1, most);
        expect_same_results("largest radii", balls, 0.0, 1.0);
      }
    }
  }
}

// Candidates may be farther away than the sum of their radii by what floats leave in doubt. From 2^31 on the difference
// of their words is another.
TEST(LaneSearch, WordsOfTheLargestRadii) {
  constexpr int64_t most = (1 << 30) - 1;
  for (const hsp::Target target : runnable_targets()) {
    for (const int64_t below : {0, 1, 1 << 13, 1 << 14, 1 << 15, 1 << 20}) {
      for (int64_t gap = -(1 << 15); gap < 1 << 12; gap += 97) {
        GridlessBalls<2> balls;
        balls.add(0, 0, 0, most - below);
        balls.add(-(2 * most - below + gap), 0, 0, most);
        uint32_t near[1 + hsp::spare_ids] = {1};
        float x[16], y[16], z[16], b[16];
        const bool is_sure = make_float_caps(target, hsp::arrays_of(balls.set()), 0, near, 1, {x, y, z, b});
        const bool may_be = gap < 0 && below >= 1 << 14, must_be = may_be && gap < -(1 << 12);
        EXPECT_TRUE(is_sure ? may_be : !must_be) << below << ", " << gap;
      }
    }
  }
}

// One large ball among small ones: blocks of cubes with more balls than there is room for.
TEST(LaneSearch, MoreCandidatesThanRoom) {
  oracle::RandomSource random(813);
  support::BallList balls;
  balls.add(0, 0, 0, 30);
  for (int i = 0; i < 700; ++i) {
    const double x = random.fraction(), y = random.fraction(), z = random.fraction();
    balls.add(60 * x - 30, 60 * y - 30, 60 * z - 30, 0.9);
  }
  expect_same_results("one large", balls, 0.0, 0.0);
}

}  // namespace
#endif
