// After any sequence of moves every number of every ball is, bit for bit, what a new model of the same balls has: on
// random and degenerate sets and on a molecule, with moves taken back in between. A refused call changes nothing.
#include "moving/moving_balls.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "molecule_file.hpp"
#include "random_moves.hpp"
#include "stopped_at.hpp"
#include "sweep_length.hpp"

namespace {

using hsp::Status;

TEST(MovingBalls, AreAsIfComputedAnew) {
  EXPECT_EQ(complaint_about_moves(1, oracle::sets(3000), 40), "");
}

// All of a molecule's atoms are in one component; some moves pull one out, or bring it back.
TEST(MovingBalls, OfAMolecule) {
  const support::BallList atoms =
      support::with_radii(support::read_atoms(support::own_molecule("crambin.pdb")), support::Radii::van_der_waals);
  oracle::RandomSource random(2);
  for (const double probe : {0.0, 1.4}) {
    MovedUnion moved(atoms, 2.0, 128, {{}, 1.0, 0.25}, probe, 0.0);
    ASSERT_EQ(moved.status(), Status::ok);
    ASSERT_EQ(moved.complaint(), "");
    for (int k = 0; k < oracle::sets(60); ++k) {
      const uint32_t i = random.below(atoms.size());
      const double far = random.one_in(10) ? 60.0 : 1.2;
      support::BallList to;
      const double dx = far * (random.fraction() - 0.5);
      const double dy = far * (random.fraction() - 0.5);
      to.add(atoms.xyz[3 * i] + dx, atoms.xyz[3 * i + 1] + dy, atoms.xyz[3 * i + 2], atoms.radius[i]);
      ASSERT_EQ(moved.move({i}, to), Status::ok);
      ASSERT_EQ(moved.complaint(), "") << k;
      if (k % 3 != 0) continue;
      ASSERT_EQ(moved.undo(), Status::ok);
      ASSERT_EQ(moved.complaint(), "") << k;
    }
  }
}

// A chain that comes apart in the middle: the longer piece is not searched to its end.
TEST(MovingBalls, OfAChainThatBreaks) {
  support::BallList chain;
  for (int k = 0; k < 60; ++k) chain.add(15.0 * k, k % 3, 0, 10);
  MovedUnion moved(chain, 10.0, 8);
  ASSERT_EQ(moved.status(), Status::ok);
  EXPECT_EQ(moved.moving().counts().components, 1U);
  const auto move = [&](uint32_t i, double x, double y) {
    support::BallList to;
    to.add(x, y, 0, 10);
    ASSERT_EQ(moved.move({i}, to), Status::ok);
    ASSERT_EQ(moved.complaint(), "") << i;
  };
  move(20, 0, 500);  // two pieces, and the ball
  EXPECT_EQ(moved.moving().counts().components, 3U);
  move(40, 300, 3);  // in the gap
  EXPECT_EQ(moved.moving().counts().components, 3U);
  move(0, -1000, 0);  // the origin of the first piece
  move(0, 0, 0);
  move(20, 600, 2);
  EXPECT_EQ(moved.moving().counts().components, 1U);
}

// Small balls beside one far larger are in cubes of their own. They grow, and shrink again, and the large one moves.
TEST(MovingBalls, BesideALargeBall) {
  oracle::RandomSource random(9);
  support::BallList balls;
  const auto place = [&] { return 600.0 * random.fraction(); };
  balls.add(300, 300, 300, 200);
  for (int k = 0; k < 1500; ++k) balls.add(place(), place(), place(), 10 * random.fraction());
  MovedUnion moved(balls, 200.0, 1501);
  ASSERT_EQ(moved.status(), Status::ok);
  ASSERT_EQ(moved.complaint(), "");
  for (int k = 0; k < oracle::sets(30); ++k) {
    std::vector<uint32_t> ids;
    support::BallList to;
    for (uint32_t count = 1 + random.below(3); ids.size() < count;) {
      const uint32_t i = random.one_in(8) ? 0 : random.below(balls.size());
      if (std::find(ids.begin(), ids.end(), i) != ids.end()) continue;
      ids.push_back(i);
      to.add(place(), place(), place(), random.one_in(6) ? 200 * random.fraction() : 10 * random.fraction());
    }
    ASSERT_EQ(moved.move(ids, to), Status::ok);
    ASSERT_EQ(moved.complaint(), "") << k;
    if (k % 3 != 0) continue;
    ASSERT_EQ(moved.undo(), Status::ok);
    ASSERT_EQ(moved.complaint(), "") << k;
  }
}

// Everything but the balls themselves is known of few or none.
TEST(MovingBalls, FewOrNone) {
  MovedUnion none(support::BallList{}, 1.0, 1);
  EXPECT_EQ(none.status(), Status::ok);
  EXPECT_EQ(none.moving().energy().value, 0.0);
  EXPECT_EQ(none.move({}, {}), Status::ok);
  support::BallList one;
  one.add(3, 4, 5, 0);
  MovedUnion point(one, 0.0, 0);
  ASSERT_EQ(point.status(), Status::ok);
  EXPECT_EQ(point.complaint(), "");
  one.xyz[0] = -7;
  EXPECT_EQ(point.move({0}, one), Status::ok);
  EXPECT_EQ(point.complaint(), "");
}

TEST(MovingBalls, KeepCentresOrRadii) {
  support::BallList two;
  two.add(0, 0, 0, 10);
  two.add(15, 0, 0, 10);
  MovedUnion moved(two, 10.0, 1);
  const uint32_t ids[] = {1};
  const double radius = 4.0, centre[] = {1, 2, 3};
  uint32_t first_bad = 0;
  ASSERT_EQ(moved.moving().move({1, ids, nullptr, &radius}, first_bad), Status::ok);
  EXPECT_EQ(moved.moving().placed(1).centre.x, 15);
  EXPECT_EQ(moved.moving().placed(1).radius, 4);
  ASSERT_EQ(moved.moving().move({1, ids, centre, nullptr}, first_bad), Status::ok);
  EXPECT_EQ(moved.moving().placed(1).centre.z, 3);
  EXPECT_EQ(moved.moving().placed(1).radius, 4);
  EXPECT_EQ(moved.moving().changed_count(), 2U);
  // A ball that stays where it is changes nothing.
  ASSERT_EQ(moved.moving().move({1, ids, centre, nullptr}, first_bad), Status::ok);
  EXPECT_EQ(moved.moving().changed_count(), 0U);
}

TEST(MovingBalls, RefusedMovesChangeNothing) {
  support::BallList balls;
  for (int k = 0; k < 6; ++k) balls.add(15.0 * k, 0, 0, 10);
  MovedUnion moved(balls, 10.0, 2);
  ASSERT_EQ(moved.status(), Status::ok);
  const UnionNumbers before = moved.moved_numbers();
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  struct Case {
    std::vector<uint32_t> ids;
    double x, radius;
    Status status;
    uint32_t first_bad;
  };
  const Case cases[] = {{{0, 6}, 1, 1, Status::id, 1},
                        {{2, 3, 2}, 1, 1, Status::id, 2},
                        {{1}, nan, 1, Status::not_finite, 0},
                        {{1}, infinity, 1, Status::not_finite, 0},
                        {{1}, 1, nan, Status::not_finite, 0},
                        {{1}, 1, infinity, Status::not_finite, 0},
                        {{1}, 1, -1, Status::negative, 0},
                        {{1}, 0x1p51, 1, Status::range, 0},
                        {{1}, 1, 0x1p31, Status::range, 0},
                        {{1}, 1, 11, Status::range, 0},
                        // Near the first two: both have their neighbours already.
                        {{5}, 7, 10, Status::capacity, hsp::no_id}};
  for (const Case &c : cases) {
    support::BallList to;
    for (size_t k = 0; k < c.ids.size(); ++k) to.add(c.x, 0, 0, c.radius);
    uint32_t first_bad = 77;
    EXPECT_EQ(moved.moving().move({static_cast<uint32_t>(c.ids.size()), c.ids.data(), to.xyz.data(), to.radius.data()},
                                  first_bad),
              c.status);
    EXPECT_EQ(first_bad, c.first_bad);
    EXPECT_EQ(difference(moved.moved_numbers(), before), "");
    EXPECT_EQ(moved.moving().needed().neighbours, c.status == Status::capacity ? 3U : 0U);
    EXPECT_EQ(moved.complaint(), "");
  }
  support::BallList to;
  to.add(70, 14, 0, 9);
  ASSERT_EQ(moved.move({5}, to), Status::ok);
  EXPECT_EQ(moved.complaint(), "");
}

// Links of a component change where others join it; what is known of those balls does not.
TEST(MovingBalls, ListWhatHasChanged) {
  support::BallList chain;
  for (int k = 0; k < 9; ++k) chain.add(15.0 * k, 0, 0, 10);
  chain.add(-400, 0, 0, 10);
  MovedUnion moved(chain, 10.0, 4);
  const auto changed = [&] {
    std::vector<uint32_t> list;
    moved.moving().visit_changed([&](uint32_t ball) { list.push_back(ball); });
    EXPECT_EQ(list.size(), moved.moving().changed_count());
    std::sort(list.begin(), list.end());
    return list;
  };
  EXPECT_EQ(changed(), std::vector<uint32_t>{});
  support::BallList to;
  to.add(120, 15, 0, 10);  // the ball apart comes to the end of the chain
  ASSERT_EQ(moved.move({9}, to), Status::ok);
  EXPECT_EQ(changed(), (std::vector<uint32_t>{8, 9}));
  to.xyz[0] = -15;  // to its begin, where it is the origin of all
  to.xyz[1] = 0;
  ASSERT_EQ(moved.move({9}, to), Status::ok);
  EXPECT_EQ(changed().size(), 10U);
  to.xyz[0] = -15.5;  // and as such elsewhere
  ASSERT_EQ(moved.move({9}, to), Status::ok);
  EXPECT_EQ(changed().size(), 10U);
  EXPECT_EQ(moved.complaint(), "");
}

// A grid without room stays as it is.
TEST(MovingBalls, WriteAGrid) {
  support::BallList three;
  for (int k = 0; k < 3; ++k) three.add(15.0 * k, 0, 0, 10);
  MovedUnion moved(three, 10.0, 2);
  CarvedMemory memory;
  hsp::CubeGrid small;
  memory.carve(small, 2U);
  const double centre[3] = {1, 2, 3}, radius = 4;
  uint32_t first_bad = 0;
  ASSERT_EQ(small.build({1, centre, &radius}, first_bad), Status::ok);
  EXPECT_EQ(moved.moving().write(small), Status::capacity);
  EXPECT_EQ(small.balls().n, 1U);
  EXPECT_EQ(moved.complaint(), "");
}

// A move that is refused before anything is computed can still be taken back; one that fails later cannot.
TEST(MovingBalls, TooFewNeighbours) {
  support::BallList balls;
  for (int k = 0; k < 6; ++k) balls.add(k, k * k, 0, 10);
  MovedUnion moved(balls, 10.0, 4);
  EXPECT_EQ(moved.status(), Status::capacity);
  EXPECT_EQ(moved.moving().needed().neighbours, 5U);
  EXPECT_EQ(moved.moving().size(), 0U);
}

// Pairs that become fours; wherever that is stopped they are pairs again, and other fours can be made of them.
TEST(MovingBalls, StopAndAreAsBefore) {
  constexpr uint32_t n = 4400;
  support::BallList pairs, fours, others;
  std::vector<uint32_t> all;
  for (uint32_t k = 0; k < n; ++k) {
    pairs.add(15.0 * k + 10.0 * (k / 2), k % 3, 0, 10);
    fours.add(15.0 * k + 10.0 * (k / 4), k % 3, 0, 10);
    others.add(15.0 * k + 10.0 * ((k + 2) / 4), k % 3, 0, 10);
    all.push_back(k);
  }
  MovedUnion moved(pairs, 10.0, 8);
  ASSERT_EQ(moved.status(), Status::ok);
  const auto components = [&] { return moved.moving().counts().components; };
  expect_stops_at_questions(10, 16, [&](const hsp::Executor &executor) {
    EXPECT_EQ(moved.move(all, pairs), Status::ok);
    uint32_t first_bad = 0;
    const Status status = moved.moving().move({n, all.data(), fours.xyz.data(), fours.radius.data()}, first_bad,
                                              hsp::Patience(&executor));
    EXPECT_EQ(components(), status == Status::ok ? n / 4 : n / 2);
    EXPECT_EQ(moved.move(all, others), Status::ok);
    EXPECT_EQ(moved.complaint(), "");
    return status;
  });
}

}  // namespace
