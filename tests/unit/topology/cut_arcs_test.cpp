// How faces with several loops are cut: all their loops are joined, by one great circle a loop at most, no cut arc is
// a bridge, and the poles that the arcs pass are those that lie between their ends.
#include "topology/cut_arcs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <vector>

#include "boundary/boundary_check.hpp"
#include "built_topology.hpp"
#include "long_vectors.hpp"
#include "random_balls.hpp"

namespace {

using hsp::CutArc;
using long_vectors::Vector;
using oracle::Balls;

struct Seen {
  int faces = 0, arcs = 0, poles = 0, through_poles = 0, both_poles = 0, pole_vertices = 0;
};

// Sets of numbers, joined.
class Partition {
 public:
  explicit Partition(uint32_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }
  uint32_t find(uint32_t k) {
    while (parent_[k] != k) k = parent_[k];
    return k;
  }
  bool join(uint32_t a, uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[b] = a;
    return a != b;
  }

 private:
  std::vector<uint32_t> parent_;
};

// The arcs of one face.
void check_face(const hsp::Boundary &boundary, uint32_t face, const std::vector<CutArc> &arcs, Seen &seen) {
  const uint32_t loops = boundary.loops_of_face(face).size();
  if (loops < 2) {
    ASSERT_TRUE(arcs.empty());
    return;
  }
  ++seen.faces;
  const uint32_t ball = boundary.face(face).ball;
  const uint32_t first = boundary.loops(ball).first;
  const uint32_t count = boundary.loops(ball).size();
  // Poles where arcs meet join as loops do.
  Partition joined(count + 2);
  std::set<uint32_t> circles;
  int passing[2] = {0, 0};
  for (const CutArc &arc : arcs) {
    ASSERT_EQ(arc.ball, ball);
    for (uint32_t end = 0; end < 2; ++end) ASSERT_EQ(boundary.face_of(arc.end[end]), face);
    circles.insert(arc.cap);
    passing[0] += (arc.poles & CutArc::passes_north) != 0 ? 1 : 0;
    passing[1] += (arc.poles & CutArc::passes_south) != 0 ? 1 : 0;
  }
  for (const CutArc &arc : arcs) {
    const bool north = (arc.poles & CutArc::passes_north) != 0;
    const bool south = (arc.poles & CutArc::passes_south) != 0;
    ASSERT_EQ((arc.poles & CutArc::vertex_at_north) != 0, north && passing[0] > 1);
    ASSERT_EQ((arc.poles & CutArc::vertex_at_south) != 0, south && passing[1] > 1);
    ASSERT_EQ(arc.pieces(), 1U + (north && passing[0] > 1) + (south && passing[1] > 1));
  }
  for (const CutArc &arc : arcs) {
    joined.join(boundary.loop_of(arc.end[0]) - first, boundary.loop_of(arc.end[1]) - first);
    if ((arc.poles & CutArc::passes_north) != 0) joined.join(boundary.loop_of(arc.end[0]) - first, count);
    if ((arc.poles & CutArc::passes_south) != 0) joined.join(boundary.loop_of(arc.end[0]) - first, count + 1);
  }
  std::set<uint32_t> parts;
  for (uint32_t loop = first; loop < first + count; ++loop) {
    if (boundary.face_of_loop(loop) == face) parts.insert(joined.find(loop - first));
  }
  ASSERT_EQ(parts.size(), 1U) << "loops that no arc joins";
  ASSERT_LE(circles.size(), loops);
  // Without a vertex at a pole it takes loops - 1 arcs; with one, an arc through it stands for two.
  ASSERT_GE(2 * arcs.size(), loops);
  seen.through_poles += passing[0] > 1 || passing[1] > 1 ? 1 : 0;
}

// Which poles lie on the way from one end to the other, by positions.
void check_poles(BuiltTopology &built, uint32_t k, const Balls &balls, Seen &seen) {
  const hsp::Topology &topology = built.structure();
  const CutArc &arc = topology.cut_arcs[k];
  const Vector centre = long_vectors::centre(built.balls(), arc.ball);
  const Vector axis = long_vectors::centre(built.balls(), arc.cap) - centre;
  const Vector normal =
      axis.x != 0 || axis.y != 0 ? Vector{-axis.y, axis.x, 0} : Vector{axis.z > 0 ? 1.0L : -1.0L, 0, 0};
  const auto position = [&](uint32_t q) {
    return long_vectors::position(built.balls(), hsp::position_of_point(built.balls(), built.boundary(), topology,
                                                                        topology.quads.origin(q))) -
           centre;
  };
  const uint32_t q = hsp::quarter_edge(topology.cut_first_edge[k]);
  const Vector from = position(q);
  const long double whole = long_vectors::turn(normal, from, position(hsp::sym(q + 4 * (arc.pieces() - 1))));
  const long double north = long_vectors::turn(normal, from, {0, 0, 1});
  const long double south = long_vectors::turn(normal, from, {0, 0, -1});
  ASSERT_EQ((arc.poles & CutArc::passes_north) != 0, north < whole) << oracle::to_text(balls);
  ASSERT_EQ((arc.poles & CutArc::passes_south) != 0, south < whole) << oracle::to_text(balls);
  const bool both = north < whole && south < whole;
  ASSERT_EQ((arc.poles & CutArc::south_first) != 0, both && south < north) << oracle::to_text(balls);
  seen.poles += north < whole || south < whole ? 1 : 0;
  seen.both_poles += both ? 1 : 0;
}

// Positions tell only where there are no ties.
void check(const Balls &balls, bool without_ties, Seen &seen) {
  BuiltTopology built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const hsp::Boundary &boundary = built.boundary();
  const hsp::Topology &topology = built.structure();
  std::vector<std::vector<CutArc>> arcs_of_face(boundary.face_count());
  for (uint32_t k = 0; k < topology.cut_arcs.size(); ++k) {
    const CutArc &arc = topology.cut_arcs[k];
    arcs_of_face[arc.face].push_back(arc);
    if (k > 0) {
      ASSERT_LE(topology.cut_arcs[k - 1].ball, arc.ball);
    }
    for (uint32_t piece = 0; piece < arc.pieces(); ++piece) {
      const uint32_t q = hsp::quarter_edge(topology.cut_first_edge[k] + piece);
      ASSERT_NE(topology.quads.left(q), topology.quads.left(hsp::sym(q))) << "a bridge: " << oracle::to_text(balls);
    }
    seen.pole_vertices += arc.pieces() > 1 ? 1 : 0;
    ++seen.arcs;
    if (without_ties) {
      ASSERT_NO_FATAL_FAILURE(check_poles(built, k, balls, seen));
    }
  }
  for (uint32_t face = 0; face < boundary.face_count(); ++face) {
    ASSERT_NO_FATAL_FAILURE(check_face(boundary, face, arcs_of_face[face], seen)) << oracle::to_text(balls);
  }
}

TEST(CutArcs, CutBallsWithRings) {
  oracle::RandomSource random(1);
  Seen seen;
  for (int k = 0; k < 150; ++k) {
    ASSERT_NO_FATAL_FAILURE(
        check(oracle::belted_balls(random, static_cast<std::size_t>(random.in(12, 40))), true, seen));
  }
  EXPECT_GT(seen.faces, 100);
  EXPECT_GT(seen.arcs, 200);
}

// Bumps that do not meet: a face with as many loops as there are bumps.
Balls bumps(oracle::RandomSource &random, std::size_t n, std::int64_t largest) {
  Balls balls = {{0, 0, 0, 1000000}};
  for (std::size_t k = 1; k < n; ++k) {
    const double u = static_cast<double>(random.in(-1000, 1000)) / 1000;
    const double angle = static_cast<double>(random.in(0, 1000000)) / 1000000 * 2 * std::numbers::pi;
    const double across = std::sqrt(1 - u * u);
    balls.push_back({std::llround(1e6 * across * std::cos(angle)), std::llround(1e6 * across * std::sin(angle)),
                     std::llround(1e6 * u), random.in(1000, largest)});
  }
  return balls;
}

TEST(CutArcs, CutBallsWithBumps) {
  oracle::RandomSource random(2);
  Seen seen;
  for (int k = 0; k < 300; ++k) {
    ASSERT_NO_FATAL_FAILURE(
        check(bumps(random, static_cast<std::size_t>(random.in(3, 30)), k % 2 == 0 ? 50000 : 300000), true, seen));
  }
  EXPECT_GT(seen.faces, 200);
  EXPECT_GT(seen.poles, 500);
  EXPECT_GT(seen.both_poles, 50);
  EXPECT_GT(seen.through_poles, 20);
  EXPECT_GT(seen.pole_vertices, 50);
}

// Arcs of so many loops are not looked for one after the other, and many pass a pole.
TEST(CutArcs, CutBallsWithHundredsOfBumps) {
  oracle::RandomSource random(4);
  Seen seen;
  for (int k = 0; k < 6; ++k) {
    ASSERT_NO_FATAL_FAILURE(check(bumps(random, 300, k % 2 == 0 ? 5000 : 60000), true, seen));
  }
  EXPECT_GT(seen.arcs, 500);
  EXPECT_GT(seen.pole_vertices, 50);
}

// Of thousands of loops most circles are left out: those that would join nothing, and no others, so that the arcs are
// those of a search that tries all.
TEST(CutArcs, AreThoseOfACircleForEachLoop) {
  oracle::RandomSource random(5);
  for (const auto &[least, largest, arcs, faces] :
       {std::array<uint32_t, 4>{1000, 9000, 2093, 999}, {4000, 60000, 3061, 944}, {45000, 70000, 743, 1011}}) {
    const Balls balls = oracle::studded_ball(random, 1000, {3, 5, 8}, 1000000, least, largest);
    Seen seen;
    ASSERT_NO_FATAL_FAILURE(check(balls, true, seen));
    BuiltTopology built(balls);
    EXPECT_EQ(built.structure().cut_arcs.size(), arcs);
    EXPECT_EQ(built.boundary().face_count(), faces);
    EXPECT_EQ(hsp::check_boundary(built.balls(), built.boundary(), built.marks()).invariant,
              hsp::BoundaryInvariant::none);
    // Joins on one ball say nothing of the next.
    Balls two = balls;
    for (const oracle::LatticeBall &ball : balls) two.push_back({ball.x + 9000000, ball.y, ball.z, ball.radius});
    EXPECT_EQ(BuiltTopology(two).structure().cut_arcs.size(), 2 * arcs);
  }
}

// A belt parts a ball in two faces, each with hundreds of loops: those of one are none of the other.
TEST(CutArcs, CutBothFacesOfABallWithABelt) {
  oracle::RandomSource random(6);
  Balls balls = oracle::studded_ball(random, 1000, {3, 5, 8}, 1000000, 1000, 9000);
  for (int k = 0; k < 12; ++k) {
    const double angle = k * std::numbers::pi / 6;
    balls.push_back({std::llround(1e6 * std::cos(angle)), std::llround(1e6 * std::sin(angle)), 0, 300000});
  }
  Seen seen;
  ASSERT_NO_FATAL_FAILURE(check(balls, true, seen));
  BuiltTopology built(balls);
  const uint32_t large = built.grid_index(0);
  uint32_t with_many = 0;
  for (const uint32_t face : built.boundary().faces(large))
    with_many += built.boundary().loops_of_face(face).size() > 200;
  EXPECT_EQ(with_many, 2U);
}

// A cap that reaches into many sectors is looked at before others, whatever its number.
TEST(CutArcs, CutAStuddedBallWithALargeCap) {
  oracle::RandomSource random(7);
  Balls balls = oracle::studded_ball(random, 100, {0, 0, 0}, 1000000, 1000, 9000);
  balls.push_back({900000, 100000, 20000, 700000});
  balls.push_back({-1000000, 0, 0, 5000});
  Seen seen;
  ASSERT_NO_FATAL_FAILURE(check(balls, true, seen));
  EXPECT_GT(seen.arcs, 50);
}

// A belt of a hundred caps along a meridian, open at one place: of all that this crosses two bound what is free.
TEST(CutArcs, CutABallWithAnOpenBelt) {
  for (int gap = 0; gap < 8; ++gap) {
    Balls balls = {{0, 0, 0, 1000000}, {0, 1000000, 1000, 5000}};
    for (int k = 0; k < 100; ++k) {
      const double angle = (gap * 45 + 30 + 3 * k) * std::numbers::pi / 180;
      balls.push_back({std::llround(1e6 * std::cos(angle)), 0, std::llround(1e6 * std::sin(angle)), 60000 + k});
    }
    Seen seen;
    ASSERT_NO_FATAL_FAILURE(check(balls, true, seen));
    EXPECT_GE(seen.arcs, 1);
  }
}

TEST(CutArcs, CutFacesInSetsWithTies) {
  oracle::RandomSource random(3);
  Seen seen;
  for (int k = 0; k < 100; ++k) {
    ASSERT_NO_FATAL_FAILURE(
        check(oracle::crowned_balls(random, static_cast<std::size_t>(random.in(9, 30))), false, seen));
  }
  for (int k = 0; k < 600; ++k) {
    ASSERT_NO_FATAL_FAILURE(
        check(oracle::degenerate_balls(random, static_cast<std::size_t>(random.in(2, 12))), false, seen));
  }
  EXPECT_GT(seen.faces, 100);
  EXPECT_GT(seen.through_poles, 5);
}

// Balls close to each other on a line that is not a lattice axis: a belt of each is free, and two of its many caps
// bound it.
TEST(CutArcs, CutSweptBallsByFewCaps) {
  Balls balls;
  for (std::int64_t k = 0; k < 260; ++k) balls.push_back({30 * k, 10 * k, 2 * k, 10000});
  Seen seen;
  ASSERT_NO_FATAL_FAILURE(check(balls, true, seen));
  EXPECT_EQ(seen.faces, 258);
  const BuiltGrid built(oracle::in_lengths(balls, 1));
  const auto n = static_cast<uint32_t>(balls.size());
  CarvedMemory memory;
  hsp::GatheredBall gathered;
  memory.carve(gathered, n);
  uint32_t most = 0;
  for (uint32_t i = 0; i < n; ++i) {
    gathered.gather(built.grid(), i);
    ASSERT_EQ(gathered.caps.met, n - 1);
    most = std::max(most, gathered.caps.count);
  }
  EXPECT_LE(most, 8U);
}

// Two bumps, each at the level of the other or above it, joined directly or by way of a pole.
TEST(CutArcs, JoinTwoBumpsAsTheyLie) {
  struct Case {
    Balls balls;
    uint32_t arcs, pole_vertices;
  };
  const std::vector<Case> cases = {
      // One upright great circle through both: two arcs, one over each side.
      {{{0, 0, 0, 100}, {60, 0, 80, 9}, {60, 0, -80, 9}}, 2, 0},
      {{{0, 0, 0, 100}, {100, 0, 0, 9}, {-100, 0, 0, 9}}, 2, 0},
      // Two circles that meet in both poles: each closes on its own bump, an arc around the ball in three pieces.
      {{{0, 0, 0, 100}, {100, 0, 0, 9}, {0, 100, 0, 9}}, 2, 2},
      // The first circle meets one bump alone, the second one both: the first is not needed.
      {{{0, 0, 0, 100}, {-100, 0, 0, 60}, {96, 28, 0, 9}}, 2, 0},
      // A bump over each pole: the circle across x.
      {{{0, 0, 0, 100}, {0, 0, 100, 9}, {0, 0, -100, 9}}, 2, 0},
  };
  for (const Case &one : cases) {
    SCOPED_TRACE(oracle::to_text(one.balls));
    Seen seen;
    ASSERT_NO_FATAL_FAILURE(check(one.balls, false, seen));
    BuiltTopology built(one.balls);
    const hsp::Topology &topology = built.structure();
    EXPECT_EQ(topology.cut_arcs.size(), one.arcs);
    EXPECT_EQ(topology.vertex_count - topology.first_pole, one.pole_vertices);
  }
}

}  // namespace
