// Great circles on the spheres of random sets: what of them is free, with what ends, and on which free arc the poles
// lie. The oracle answers in integers of any size, and finds the order of the ends by other means.
#include "sphere/great_circles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "built_topology.hpp"
#include "bumps.hpp"
#include "circle_order.hpp"
#include "random_balls.hpp"

namespace {

using oracle::Balls;
using oracle::Cap;
using oracle::FreePieces;
using oracle::TiedBalls;

struct Seen {
  int covered = 0, whole = 0, one_arc = 0, more_arcs = 0, poles_on_arcs = 0, poles_off_arcs = 0;
};

// Memory for the caps of one ball.
struct Gathered {
  explicit Gathered(uint32_t neighbours) { memory.carve(ball, neighbours); }
  CarvedMemory memory;
  hsp::GatheredBall ball;
};

using Arc = std::pair<uint32_t, uint32_t>;  // the balls it leaves and comes to

std::vector<Arc> sorted(std::vector<Arc> arcs) {
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

// Whether the highest (+1) or lowest (-1) point of ball a's sphere is free, and on which arc of an upright great circle
// it lies then; -1 if on none.
int arc_of_pole(const TiedBalls &set, uint32_t a, const std::vector<Cap> &caps, const FreePieces &pieces, int pole) {
  // The plane across the circle that contains the direction z meets it in the poles: the lowest point is the crossing
  // of side +1, as (-y, x, 0) x (x, y, 0) points down.
  const oracle::Vector &m = pieces.circle().normal;
  const Cap across{{m[1], -m[0], 0}, oracle::no_ball};
  const oracle::Crossing point{pieces.circle(), across, -pole};
  for (const Cap &cap : caps) {
    if (set.crossing_inside(a, point, cap)) return -1;
  }
  return static_cast<int>(pieces.arc_with_crossing(across, -pole));
}

void check_circle(const Balls &balls, const TiedBalls &set, hsp::GatheredBall &gathered, const BuiltTopology &built,
                  const hsp::exact::Plane &circle, Seen &seen) {
  const hsp::Caps &caps = gathered.caps;
  const hsp::exact::Predicates predicates = caps.predicates();
  const auto caller = [&](uint32_t cap) { return built.balls().caller[caps.ball[cap]]; };
  const uint32_t a = built.balls().caller[caps.origin];
  std::vector<Cap> all;
  for (uint32_t k = 0; k < caps.count; ++k) all.push_back(set.cap(a, caller(k)));
  const FreePieces pieces(set, a, {{circle.v.x, circle.v.y, circle.v.z}, oracle::no_ball}, all);

  gathered.intervals.find(gathered.caps, predicates, circle);
  std::vector<hsp::FreeInterval> intervals;
  gathered.intervals.visit([&](const hsp::FreeInterval &interval) { intervals.push_back(interval); });
  EXPECT_EQ(gathered.intervals.empty(), intervals.empty());
  std::vector<Arc> found, expected;
  for (const hsp::FreeInterval &arc : intervals) found.emplace_back(caller(arc.exit_cap), caller(arc.entry_cap));
  for (const oracle::FreeArc &arc : pieces.arcs()) expected.emplace_back(arc.exit.ball, arc.entry.ball);
  ASSERT_EQ(sorted(found), sorted(expected)) << "on ball " << a << ": " << oracle::to_text(balls);
  if (found.empty()) {
    ++(pieces.kind() == FreePieces::Kind::whole ? seen.whole : seen.covered);
    return;
  }
  ++(found.size() == 1 ? seen.one_arc : seen.more_arcs);
  for (const int pole : {-1, +1}) {
    const int holder = arc_of_pole(set, a, all, pieces, pole);
    for (const hsp::FreeInterval &arc : intervals) {
      const Arc name{caller(arc.exit_cap), caller(arc.entry_cap)};
      const bool holds = holder >= 0 && expected[static_cast<size_t>(holder)] == name;
      ASSERT_EQ(contains_pole(caps, predicates, circle, arc, pole), holds)
          << "pole " << pole << ", arc from " << name.first << " to " << name.second << " on ball " << a << ": "
          << oracle::to_text(balls);
      ++(holds ? seen.poles_on_arcs : seen.poles_off_arcs);
    }
  }
}

// Upright circles through the axes of caps, and through points of the lattice.
void check_set(const Balls &balls, oracle::RandomSource &random, Seen &seen) {
  BuiltTopology built(balls);
  ASSERT_EQ(built.status(), hsp::Status::ok);
  Gathered gathered(static_cast<uint32_t>(balls.size()));
  const TiedBalls set(balls);
  for (uint32_t i = 0; i < built.balls().n; ++i) {
    if (built.boundary().is_contained(i)) continue;
    gathered.ball.gather(built.grid(), i);
    const hsp::Caps &caps = gathered.ball.caps;
    for (uint32_t k = 0; k < caps.count; k += 1 + caps.count / 6) {
      const hsp::exact::Plane circle = hsp::meridian_through(caps.plane(k).v);
      // It contains the axis and the direction z, and tells the axis from its opposite.
      ASSERT_EQ(dot(circle.v, caps.plane(k).v), 0);
      ASSERT_EQ(circle.v.z, 0);
      ASSERT_EQ(circle.h, 0);
      ASSERT_FALSE(is_zero(circle.v));
      ASSERT_NO_FATAL_FAILURE(check_circle(balls, set, gathered.ball, built, circle, seen));
    }
    // As short as it may be, and as long as the radius.
    const int64_t reach = std::max<int64_t>(1, static_cast<int64_t>(built.balls().r[i]) * 7 / 10);
    for (const int64_t size : {int64_t{1}, reach}) {
      const hsp::exact::Vector normal{random.in(-size, size), random.in(-size, size), 0};
      if (is_zero(normal)) continue;
      ASSERT_NO_FATAL_FAILURE(
          check_circle(balls, set, gathered.ball, built, hsp::exact::virtual_plane(normal, 0), seen));
    }
  }
}

TEST(GreatCircles, OfRandomSets) {
  oracle::RandomSource random(1);
  Seen seen;
  for (int k = 0; k < 200; ++k) {
    ASSERT_NO_FATAL_FAILURE(
        check_set(oracle::any_balls(random, static_cast<std::size_t>(random.in(2, 14))), random, seen));
  }
  EXPECT_GT(seen.covered, 100);
  EXPECT_GT(seen.whole, 100);
  EXPECT_GT(seen.one_arc, 100);
  EXPECT_GT(seen.more_arcs, 100);
  EXPECT_GT(seen.poles_on_arcs, 100);
  EXPECT_GT(seen.poles_off_arcs, 100);
}

TEST(GreatCircles, OfDegenerateSets) {
  oracle::RandomSource random(2);
  Seen seen;
  for (int k = 0; k < 800; ++k) {
    ASSERT_NO_FATAL_FAILURE(
        check_set(oracle::degenerate_balls(random, static_cast<std::size_t>(random.in(2, 9))), random, seen));
  }
  EXPECT_GT(seen.covered, 100);
  EXPECT_GT(seen.whole, 100);
  EXPECT_GT(seen.one_arc, 100);
  EXPECT_GT(seen.more_arcs, 100);
  EXPECT_GT(seen.poles_on_arcs, 100);
}

// Ties at the largest size, and one step off them: there doubles cannot tell.
TEST(GreatCircles, OfLargeSetsNextToTies) {
  oracle::RandomSource random(5);
  Seen seen;
  for (int k = 0; k < 400; ++k) {
    Balls balls = oracle::degenerate_balls(random, static_cast<std::size_t>(random.in(2, 8)));
    int64_t largest = 1;
    for (const oracle::LatticeBall &ball : balls) largest = std::max(largest, ball.radius);
    const int64_t scale = ((int64_t{1} << 30) - 2) / largest;
    const int64_t off = random.in(0, 1);
    for (oracle::LatticeBall &ball : balls) {
      ball = {ball.x * scale + random.in(-off, off), ball.y * scale + random.in(-off, off),
              ball.z * scale + random.in(-off, off), ball.radius * scale + random.in(0, off)};
    }
    ASSERT_NO_FATAL_FAILURE(check_set(balls, random, seen));
  }
  EXPECT_GT(seen.covered, 100);
  EXPECT_GT(seen.one_arc, 100);
  EXPECT_GT(seen.more_arcs, 100);
}

TEST(GreatCircles, OfBallsWithRings) {
  oracle::RandomSource random(3);
  Seen seen;
  for (int k = 0; k < 12; ++k) {
    ASSERT_NO_FATAL_FAILURE(
        check_set(oracle::crowned_balls(random, static_cast<std::size_t>(random.in(9, 20))), random, seen));
    ASSERT_NO_FATAL_FAILURE(
        check_set(oracle::belted_balls(random, static_cast<std::size_t>(random.in(9, 20))), random, seen));
  }
  EXPECT_GT(seen.more_arcs, 100);
}

// So many caps that they have an index, of which a meridian crosses so many that their ends are compared by place; and
// the same intervals in the same order without the index.
TEST(GreatCircles, OfBallsWithVeryManyCaps) {
  oracle::RandomSource random(6);
  Seen seen;
  int by_place = 0;
  for (const auto &[least, most] : {std::pair{0.004, 0.05}, std::pair{0.02, 0.02}, std::pair{0.001, 0.3}}) {
    Balls balls = bumps(random, 260, least, most);
    for (int k = 0; k < 60; ++k) {  // along one meridian
      const double angle = 0.1 * k;
      balls.push_back({std::llround(8e5 * std::sin(angle)), std::llround(6e5 * std::sin(angle)),
                       std::llround(1e6 * std::cos(angle)), std::llround(1e6 * (least + most) / 2)});
    }
    BuiltTopology built(balls);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    Gathered gathered(static_cast<uint32_t>(balls.size()));
    const TiedBalls set(balls);
    for (uint32_t i = 0; i < built.balls().n; ++i) {
      if (built.balls().r[i] < 1e6) continue;
      gathered.ball.gather(built.grid(), i);
      const hsp::Caps &caps = gathered.ball.caps;
      ASSERT_GE(caps.count, hsp::MeridianSectors::fewest);
      for (const hsp::exact::Vector &axis : {hsp::exact::Vector{4, 3, 0}, {123456, 654321, 0}}) {
        const hsp::exact::Plane circle = hsp::meridian_through(axis);
        std::vector<Arc> arcs[2];
        for (uint32_t indexed = 0; indexed < 2; ++indexed) {
          gathered.ball.intervals.start(caps, indexed == 0 ? 1 : 1000);
          ASSERT_NO_FATAL_FAILURE(check_circle(balls, set, gathered.ball, built, circle, seen));
          gathered.ball.intervals.visit(
              [&](const hsp::FreeInterval &each) { arcs[indexed].emplace_back(each.exit_cap, each.entry_cap); });
        }
        EXPECT_EQ(arcs[0], arcs[1]);
        by_place += arcs[0].size() > 16;
      }
    }
  }
  EXPECT_GE(by_place, 2);
}

// Caps all along a meridian but for one gap, whose two ends alone are free.
TEST(GreatCircles, OfAChainOfCaps) {
  oracle::RandomSource random(7);
  Seen seen;
  for (int round = 0; round < 6; ++round) {
    Balls balls = {{0, 0, 0, 1000000}};
    const int first = static_cast<int>(random.in(0, 59));
    for (int k = first; k < first + 56; ++k) {
      const double angle = std::numbers::pi / 30 * k;
      balls.push_back({std::llround(8e5 * std::sin(angle)), std::llround(6e5 * std::sin(angle)),
                       std::llround(1e6 * std::cos(angle)), 90000});
    }
    BuiltTopology built(balls);
    ASSERT_EQ(built.status(), hsp::Status::ok);
    Gathered gathered(static_cast<uint32_t>(balls.size()));
    gathered.ball.gather(built.grid(), built.grid_index(0));
    ASSERT_NO_FATAL_FAILURE(
        check_circle(balls, TiedBalls(balls), gathered.ball, built, hsp::meridian_through({4, 3, 0}), seen));
  }
  EXPECT_EQ(seen.one_arc, 6);
}

// Every way in which two caps can lie to the poles: two balls on the upright great circle across y, at all pairs of
// directions of a compass that knows the poles, the equator and all between.
TEST(GreatCircles, TwoCapsInAllDirections) {
  oracle::RandomSource random(4);
  Seen seen;
  const std::vector<std::pair<int64_t, int64_t>> compass = {{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                                                            {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
  for (const auto &first : compass) {
    for (const auto &second : compass) {
      for (const int64_t radius : {100, 300}) {
        const Balls balls = {{0, 0, 0, 500},
                             {100 * first.first, 0, 100 * first.second, radius},
                             {100 * second.first, 0, 100 * second.second, 200}};
        ASSERT_NO_FATAL_FAILURE(check_set(balls, random, seen));
      }
    }
  }
  EXPECT_GT(seen.poles_on_arcs, 500);
  EXPECT_GT(seen.poles_off_arcs, 500);
}

// A great circle through the axis names its plane's sides by the axis: opposite axes give opposite planes.
TEST(GreatCircles, MeridiansAreOddInTheAxis) {
  for (int64_t x = -2; x <= 2; ++x) {
    for (int64_t y = -2; y <= 2; ++y) {
      for (int64_t z = -2; z <= 2; ++z) {
        if (x == 0 && y == 0 && z == 0) continue;
        const hsp::exact::Plane plane = hsp::meridian_through({x, y, z});
        const hsp::exact::Plane opposite = hsp::meridian_through({-x, -y, -z});
        EXPECT_EQ(plane.v.x, -opposite.v.x);
        EXPECT_EQ(plane.v.y, -opposite.v.y);
        EXPECT_EQ(plane.perturbed, 0);
        if (x == 0 && y == 0) {
          EXPECT_EQ(plane.v.y, 0);  // across x, as the header says
        }
      }
    }
  }
}

}  // namespace
