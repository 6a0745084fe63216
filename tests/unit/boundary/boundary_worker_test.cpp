// The shares of workers are all cubes, each once and in order, and about equally many balls. Several together find what
// one finds: also with hardly any room, where it shows how many there are.
#include "boundary/boundary_worker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include "boundary/boundary_builder.hpp"
#include "built_boundary.hpp"
#include "built_grid.hpp"
#include "carved_memory.hpp"
#include "lattice_lengths.hpp"
#include "molecule_file.hpp"
#include "random_balls.hpp"

namespace {

TEST(BallShare, CoversAllCubesInOrder) {
  oracle::RandomSource random(3);
  for (const size_t n : {size_t{0}, size_t{1}, size_t{2}, size_t{7}, size_t{60}}) {
    const BuiltBoundary built(oracle::loose_balls(random, n));
    const hsp::CubeGrid &grid = built.grid();
    uint32_t largest_cube = 0;
    for (uint32_t cube = 0; cube < grid.cubes(); ++cube) {
      largest_cube = std::max(largest_cube, grid.balls_in(cube).last - grid.balls_in(cube).first);
    }
    for (uint32_t workers = 1; workers <= 70; ++workers) {
      uint32_t cube = 0, ball = 0;
      for (uint32_t w = 0; w < workers; ++w) {
        const hsp::BallShare share = hsp::share_of(grid, w, workers);
        EXPECT_EQ(share.first_cube, cube);
        EXPECT_EQ(share.balls.first, ball);
        cube = share.last_cube;
        ball = share.balls.last;
        const uint32_t balls = ball - share.balls.first;
        EXPECT_LE(balls, n / workers + 1 + largest_cube);
        uint32_t in_cubes = 0;
        for (uint32_t k = share.first_cube; k < share.last_cube; ++k) {
          in_cubes += grid.balls_in(k).last - grid.balls_in(k).first;
        }
        EXPECT_EQ(balls, in_cubes);
      }
      EXPECT_EQ(cube, grid.cubes());
      EXPECT_EQ(ball, n);
    }
  }
}

template <class T>
void expect_same(hsp::Span<T> a, hsp::Span<T> b, uint32_t count, const char *what) {
  ASSERT_TRUE(count <= a.size() && count <= b.size());
  EXPECT_TRUE(count == 0 || std::memcmp(a.data(), b.data(), count * sizeof(T)) == 0) << what;
}

void expect_same_arrays(const hsp::BoundaryArrays &a, const hsp::BoundaryArrays &b) {
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  ASSERT_EQ(a.circles.size(), b.circles.size());
  ASSERT_EQ(a.loop_count, b.loop_count);
  ASSERT_EQ(a.face_count, b.face_count);
  EXPECT_EQ(a.shell_count, b.shell_count);
  EXPECT_EQ(a.component_count, b.component_count);
  ASSERT_EQ(a.balls, b.balls);
  const uint32_t vertices = a.vertices.size(), circles = a.circles.size(), n = a.balls;
  expect_same(a.vertices.items(), b.vertices.items(), vertices, "vertices");
  expect_same(a.circles.items(), b.circles.items(), circles, "circles");
  expect_same(a.root_discriminant, b.root_discriminant, vertices, "root_discriminant");
  expect_same(a.first, b.first, n + 1, "first");
  expect_same(a.half_edges, b.half_edges, 3 * vertices, "half_edges");
  expect_same(a.half_edge_at, b.half_edge_at, 3 * vertices, "half_edge_at");
  expect_same(a.closed_half_edge, b.closed_half_edge, 2 * circles, "closed_half_edge");
  expect_same(a.loop_start, b.loop_start, a.loop_count, "loop_start");
  expect_same(a.loop_face, b.loop_face, a.loop_count, "loop_face");
  expect_same(a.faces, b.faces, a.face_count, "faces");
  expect_same(a.ball_state, b.ball_state, n, "ball_state");
  expect_same(a.component_origin, b.component_origin, n, "component_origin");
  expect_same(a.component, b.component, n, "component");
}

bool last_first(void *, uint32_t tasks, hsp::Executor::Task *task, void *data) {
  while (tasks-- > 0) task(data, tasks);
  return true;
}

void expect_same_for_all_splits(const support::BallList &balls, double probe, const hsp::BoundaryLimits &limits) {
  const BuiltGrid built(balls, probe, 0.0);
  CarvedMemory alone_memory;
  hsp::BoundaryBuilder alone;
  alone_memory.carve(alone, limits);
  const hsp::Status expected = alone.build(built.grid());
  for (uint32_t workers = 1; workers <= 8; ++workers) {
    SCOPED_TRACE(workers);
    hsp::BoundaryLimits for_all = limits;
    for_all.workers = workers;
    CarvedMemory memory;
    hsp::BoundaryBuilder several;
    memory.carve(several, for_all);
    EXPECT_EQ(several.build(built.grid(), hsp::Executor(workers, last_first, nullptr)), expected);
    EXPECT_EQ(several.needed().workers, workers);
    EXPECT_EQ(several.needed().balls, alone.needed().balls);
    EXPECT_EQ(several.needed().neighbours, alone.needed().neighbours);
    EXPECT_EQ(several.needed().vertices, alone.needed().vertices);
    EXPECT_EQ(several.needed().circles, alone.needed().circles);
    if (expected == hsp::Status::ok) expect_same_arrays(alone.arrays(), several.arrays());
  }
}

// Once a ball has more neighbours than there is room for, the others are only counted, and mostly not exactly.
TEST(BoundaryWorker, MostNeighboursAreKnownWithRoomForFewer) {
  const support::BallList balls =
      with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
  const uint32_t n = balls.size();
  for (const double probe : {0.0, 1.4}) {
    const BuiltGrid built(balls, probe, 0.0);
    const auto needed = [&](uint32_t room) {
      CarvedMemory memory;
      hsp::BoundaryBuilder builder;
      memory.carve(builder, hsp::BoundaryLimits{n, room, 8 * n, 2 * n, 0});
      builder.build(built.grid());
      return builder.needed().neighbours;
    };
    const uint32_t most = needed(200);
    ASSERT_GT(most, 10U);
    for (uint32_t room = 0; room < most; ++room) EXPECT_EQ(needed(room), most) << room;
  }
}

TEST(BoundaryWorker, SplitMolecules) {
  for (const char *file : {"caffeine.pdb", "crambin.pdb", "felix_model.pdb"}) {
    const support::BallList balls =
        with_radii(support::read_atoms(support::own_molecule(file)), support::Radii::van_der_waals);
    const uint32_t n = balls.size();
    for (const double probe : {0.0, 1.4}) {
      SCOPED_TRACE(file);
      expect_same_for_all_splits(balls, probe, {n, 200, 8 * n, 2 * n, 0});
      expect_same_for_all_splits(balls, probe, {n, 200, n / 8, 2 * n, 0});
      expect_same_for_all_splits(balls, probe, {n, 7, n, n, 0});
      expect_same_for_all_splits(balls, probe, {n - 1, 200, 8 * n, 2 * n, 0});
    }
  }
}

TEST(BoundaryWorker, SplitRandomSets) {
  oracle::RandomSource random(5);
  for (size_t n = 0; n < 40; n = n < 4 ? n + 1 : n + 7) {
    for (const oracle::Balls &balls : {oracle::loose_balls(random, n), oracle::dense_balls(random, n),
                                       oracle::clustered_balls(random, n), oracle::balls_in_box(random, n, 5, 0, 4)}) {
      const auto count = static_cast<uint32_t>(n);
      expect_same_for_all_splits(oracle::in_lengths(balls, 1), 0.0, {count, count, 24 * count, 4 * count, 0});
    }
  }
}

// All that is found, by the caller's numbers of balls.
std::vector<std::array<uint32_t, 4>> records_of(const BuiltBoundary &built) {
  const hsp::Boundary &boundary = built.boundary();
  const auto caller = [&](uint32_t ball) { return built.balls().caller[ball]; };
  std::vector<std::array<uint32_t, 4>> records;
  for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
    const auto &[a, b, c] = boundary.vertex(v).ball;
    records.push_back({caller(a), caller(b), caller(c), boundary.vertex(v).code});
  }
  for (uint32_t c = 0; c < boundary.circle_count(); ++c) {
    records.push_back({caller(boundary.circle(c).ball[0]), caller(boundary.circle(c).ball[1]), 0, 0});
  }
  for (uint32_t f = 0; f < boundary.face_count(); ++f) {
    records.push_back({caller(boundary.face(f).ball), boundary.loops_of_face(f).size(), 0, 0});
  }
  records.push_back({boundary.shell_count(), boundary.component_count(), 0, 0});
  return records;
}

// Copies of some of the balls, and smaller balls with their centres, few or so many that cubes are crowded: the same is
// found as without.
TEST(BoundaryWorker, CopiesAndConcentricBallsChangeNothing) {
  oracle::RandomSource random(33);
  size_t records = 0;
  for (int k = 0; k < 120 && !HasFailure(); ++k) {
    const size_t n = static_cast<size_t>(random.in(2, 24));
    const oracle::Balls once = k % 3 == 0 ? oracle::dense_balls(random, n) : oracle::any_balls(random, n);
    oracle::Balls copied = once;
    const int64_t most = k % 2 == 0 ? 3 : 30;
    for (const oracle::LatticeBall &ball : once) {
      for (int64_t copies = random.in(0, most); copies > 0; --copies) {
        copied.push_back(ball);
        if (random.in(0, 3) == 0) copied.back().radius -= std::min(ball.radius, random.in(0, 5));
      }
    }
    const BuiltBoundary plain(once), with_copies(copied);
    ASSERT_EQ(with_copies.status(), hsp::Status::ok);
    const auto expected = records_of(plain);
    EXPECT_EQ(records_of(with_copies), expected) << oracle::to_text(copied);
    records += expected.size();
    for (uint32_t i = 0; i < copied.size(); ++i) {
      const uint32_t ball = with_copies.grid_index(i);
      const bool contained = i >= once.size() || plain.boundary().is_contained(plain.grid_index(i));
      EXPECT_EQ(with_copies.boundary().is_contained(ball), contained) << oracle::to_text(copied) << " ball " << i;
      EXPECT_TRUE(!contained || !with_copies.boundary().is_exposed(ball));
    }
  }
  EXPECT_GT(records, 2000U);
}

// Wide cubes of small balls, as there are a few large ones: levels of radii, and the boundary, contacts' caps and all
// records are those without.
TEST(BoundaryWorker, FewLargeBallsChangeNothing) {
  oracle::RandomSource random(34);
  for (const size_t large : {size_t{1}, size_t{3}, size_t{40}}) {
    oracle::Balls balls;
    for (size_t k = 0; k < large; ++k) balls.push_back({random.in(-9000, 9000), random.in(-9000, 9000), 0, 20000});
    while (balls.size() < 2600) {
      const oracle::LatticeBall ball = oracle::ball_in_box(random, 26000, 300, 1400);
      if (balls.size() % 4 == 0 || std::hypot(ball.x, ball.y, ball.z) > 21000) balls.push_back(ball);
      if (balls.size() % 50 == 0) balls.push_back(ball);
    }
    const BuiltBoundary by_levels(balls), by_cubes(balls, false);
    ASSERT_EQ(by_levels.status(), hsp::Status::ok);
    ASSERT_EQ(by_cubes.status(), hsp::Status::ok);
    ASSERT_NE(by_levels.grid().levels(), nullptr);
    ASSERT_EQ(by_cubes.grid().levels(), nullptr);
    const auto expected = records_of(by_cubes);
    EXPECT_EQ(records_of(by_levels), expected);
    EXPECT_GT(expected.size(), 1200U);
    EXPECT_EQ(by_levels.neighbours(), by_cubes.neighbours());
  }
}

}  // namespace
