// Pieces are what the header says: invariants of their records, the balls' points that belong to them, their order,
// areas.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <ostream>

#include "exact_depth.hpp"
#include "long_reals.hpp"
#include "smallest_failing.hpp"
#include "sweep_length.hpp"
#include "view_complaints.hpp"
#include "view_sets.hpp"

namespace {

using oracle::Balls;

using Invariant = std::string (*)(const Balls &, const Direction &);
struct NamedInvariant {
  const char *name;
  Invariant invariant;
};
void PrintTo(const NamedInvariant &invariant, std::ostream *stream) {
  *stream << invariant.name;
}

std::string records(const Balls &balls, const Direction &towards) {
  return view_invariant_broken(balls, towards);
}
std::string regions(const Balls &balls, const Direction &towards) {
  return view_regions_disagree(balls, 50, towards);
}

void expect_invariant(Invariant invariant, const Balls &balls, const std::vector<Direction> &directions,
                      const std::string &name) {
  for (const Direction &towards : directions)
    ASSERT_EQ(complaint_about_smallest(balls, [&](const Balls &set) { return invariant(set, towards); }), "") << name;
}

class Pieces : public testing::TestWithParam<NamedInvariant> {};

TEST_P(Pieces, OfSmallSetsAndLattices) {
  for (const auto &views : {small_views(), lattice_views()})
    for (const oracle::NamedBalls &view : views) {
      expect_invariant(GetParam().invariant, view.balls, even_directions(), view.name);
      expect_invariant(GetParam().invariant, view.balls, {uneven_directions()[0], uneven_directions()[2]}, view.name);
    }
}

TEST_P(Pieces, OfDegenerateSets) {
  for (const oracle::NamedBalls &view : degenerate_views(60)) {
    expect_invariant(GetParam().invariant, view.balls, {even_directions()[0], even_directions()[4]}, view.name);
    expect_invariant(GetParam().invariant, view.balls, {uneven_directions()[0]}, view.name);
  }
}

TEST_P(Pieces, OfRandomSets) {
  oracle::RandomSource random(94);
  for (int k = 0; k < oracle::sets(4); ++k)
    for (const auto make : {oracle::loose_balls, oracle::dense_balls, oracle::clustered_balls, oracle::belted_balls,
                            sparse_balls, mixed_balls, flat_balls})
      expect_invariant(GetParam().invariant, make(random, 50), {{0, 0, 1}, uneven_directions()[1]}, "");
}

// So many caps on each ball that those that matter are looked for first.
TEST_P(Pieces, OfBallsThatAllMeet) {
  oracle::RandomSource random(97);
  Balls balls;
  for (int k = 0; k < 180; ++k)
    balls.push_back({random.in(-400, 400), random.in(-400, 400), random.in(-400, 400), random.in(900, 1000)});
  expect_invariant(GetParam().invariant, balls, {uneven_directions()[1]}, "");
}

TEST_P(Pieces, OfRandomDegenerateSets) {
  oracle::RandomSource random(95);
  for (int k = 0; k < oracle::sets(400); ++k) {
    const Balls balls = oracle::degenerate_balls(random, static_cast<size_t>(random.in(2, 16)));
    expect_invariant(GetParam().invariant, balls, {even_directions()[static_cast<size_t>(random.in(0, 4))]}, "");
  }
}

std::string name_of(const testing::TestParamInfo<NamedInvariant> &info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(All, Pieces,
                         testing::Values(NamedInvariant{"KeepTheInvariants", records},
                                         NamedInvariant{"DoNotDependOnTheOrder", view_orders_disagree},
                                         NamedInvariant{"HoldTheirPoints", regions},
                                         NamedInvariant{"HaveEqualBackAreas", opposite_areas_disagree}),
                         name_of);

// Centres as far apart as the lattice allows, of which pairs differ in depth by a few units of the integer direction
// or not at all.
TEST(DepthOrder, IsThatOfIntegers) {
  oracle::RandomSource random(96);
  constexpr int64_t largest = int64_t{1} << 28;
  for (int k = 0; k < oracle::sets(200); ++k) {
    // Of the largest component, so that the direction stays as it is.
    const std::array<int64_t, 3> v = {largest, largest - random.in(1, 9), random.in(1, 3)};
    Balls balls;
    for (int pair = 0; pair < 15; ++pair) {
      const oracle::LatticeBall ball = {random.in(-largest, largest) * (largest >> 10),
                                        random.in(-largest, largest) * (largest >> 10), random.in(-50, 50),
                                        random.in(1, 5)};
      balls.push_back(ball);
      const int64_t times = random.in(1, 1000);  // along a vector whose product with v is 0
      balls.push_back({ball.x + times * v[1], ball.y - times * v[0], ball.z + random.in(-1, 1), random.in(1, 5)});
    }
    const Direction towards = {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
    ASSERT_EQ(integer_direction(towards), v);
    ASSERT_EQ(depths_disagree(balls, towards), "") << oracle::to_text(balls);
    const LibraryScene scene(balls);
    for (const ViewChoice &choice : all_choices(towards)) {
      const ViewRecords view = view_of(scene, choice);
      ASSERT_TRUE((choice.flags & HSP_VIEW_ALL_BALLS) == 0 || view.pieces.size() == balls.size());
    }
  }
}

// A large ball about the origin and small ones at an integer point of it, all spheres through that point: arcs without
// length, whose parameters rounding puts to either side of it.
Balls balls_at_a_point(oracle::RandomSource &random, const std::array<int64_t, 3> &point, int64_t radius) {
  Balls balls = {{0, 0, 0, radius}};
  for (int64_t k = random.in(3, 6); k > 0; --k) {
    const oracle::LatticeBall v = oracle::integer_length_vector(random);
    const int64_t times = random.in(100, 20000);
    balls.push_back({point[0] + times * v.x, point[1] + times * v.y, point[2] + times * v.z, times * v.radius});
  }
  return balls;
}

TEST(ViewArcs, OfNoLengthAreNoWholeTurns) {
  oracle::RandomSource random(97);
  for (int k = 0; k < oracle::sets(100); ++k) {
    const Balls balls = balls_at_a_point(random, {3000000, 4000000, 0}, 5000000);
    for (const Invariant invariant : {records, opposite_areas_disagree}) {
      expect_invariant(invariant, balls, {{0, 0, 1}, {0, 1, 1}, uneven_directions()[0]}, "");
    }
  }
}

// Ties on the silhouette from a direction whose integers are much larger than those of the balls: the point is at a
// right angle to it.
TEST(ViewArcs, MeetInAPointOfTheSilhouette) {
  oracle::RandomSource random(98);
  constexpr int64_t largest = int64_t{1} << 28;
  for (int k = 0; k < oracle::sets(100); ++k) {
    const int64_t z = 2 * random.in(0, 3000000) + 1;
    const int64_t y = 3 * (largest / 4) + 3 * z;  // 3 x - 4 y + 12 z = 0
    const Direction towards = {static_cast<double>(largest), static_cast<double>(y), static_cast<double>(z)};
    ASSERT_EQ(integer_direction(towards)[1], y);
    const int64_t times = random.in(1000, 400000);
    const Balls balls = balls_at_a_point(random, {3 * times, -4 * times, 12 * times}, 13 * times);
    for (const Invariant invariant : {records, view_orders_disagree, opposite_areas_disagree})
      expect_invariant(invariant, balls, {towards}, "");
  }
}

// A circle that the silhouette nearly touches: vertices are as exact as elsewhere, however close to each other they
// are. Such a vertex is (h / v_x, +-sqrt(r^2 - x^2)) with h = v.c / 2, seen from the ball's centre.
TEST(ViewArcs, StartAtPreciseVertices) {
  if (!oracle::has_long_reals) GTEST_SKIP() << "long doubles are doubles here";
  for (const int64_t closer : {1, 2, 7, 100, 12345, 1000000}) {
    constexpr int64_t unit = int64_t{1} << 24;
    const oracle::LatticeBall other = {32 * unit, 0, -24 * unit + closer, 25 * unit};
    const LibraryScene scene({{0, 0, 0, 25 * unit}, other});
    const ViewRecords view = view_of(scene, {HSP_PIECES_OUTSIDE_FARTHER, HSP_VIEW_ALL_BALLS, false, {}, {}});
    const long double r = 25 * unit;
    const long double x =
        static_cast<long double>(oracle::dot({other.x, other.y, other.z}, {other.x, other.y, other.z})) /
        (2 * static_cast<long double>(other.x));
    const long double y = std::sqrt((r - x) * (r + x));
    int starts = 0;
    for (const hsp_view_arc &arc : view.arcs) {
      const hsp_view_piece &piece = view.pieces[arc.piece];
      if (piece.ball != 0) continue;
      ++starts;
      const double error = std::hypot(static_cast<double>(arc.start[0] - piece.centre[0] - x),
                                      static_cast<double>(std::fabs(arc.start[1] - piece.centre[1]) - y));
      EXPECT_LE(error, 200 * 0x1p-53 * static_cast<double>(r)) << closer;
    }
    EXPECT_EQ(starts, 2) << closer;
  }
}

}  // namespace
