// Pores that take points of other pores: to the last bit what is found without these, whatever the further balls do.
#include <gtest/gtest.h>

#include <algorithm>

#include "built_pores.hpp"
#include "pore_sets.hpp"

namespace {

using hsp::no_id;

// Of both the same bits, and the same limits but those of scratch memory.
void expect_same(const hsp::PoresBuilder &a, const hsp::PoresBuilder &b) {
  ASSERT_EQ(a.maxima().size(), b.maxima().size());
  ASSERT_EQ(a.gates().size(), b.gates().size());
  const auto same = [&](const hsp::CriticalPoint &p, const hsp::CriticalPoint &q) {
    ASSERT_EQ(p.level, q.level);
    ASSERT_EQ(p.error, q.error);
    ASSERT_EQ(p.position.x, q.position.x);
    ASSERT_EQ(p.position.y, q.position.y);
    ASSERT_EQ(p.position.z, q.position.z);
    ASSERT_EQ(p.tied, q.tied);
    for (uint32_t k = 0; k < 4; ++k) ASSERT_EQ(p.ball[k], q.ball[k]);
    for (uint32_t k = 0; k < p.tied; ++k) ASSERT_EQ(a.tied(p)[k], b.tied(q)[k]);
  };
  for (uint32_t k = 0; k < a.maxima().size(); ++k) {
    ASSERT_NO_FATAL_FAILURE(same(a.maxima()[k].point, b.maxima()[k].point));
    ASSERT_EQ(a.maxima()[k].gate, b.maxima()[k].gate);
    ASSERT_EQ(a.maxima()[k].into, b.maxima()[k].into);
  }
  for (uint32_t k = 0; k < a.gates().size(); ++k) {
    ASSERT_NO_FATAL_FAILURE(same(a.gates()[k].point, b.gates()[k].point));
    for (const uint32_t side : {0U, 1U}) ASSERT_EQ(a.gates()[k].end[side], b.gates()[k].end[side]);
    ASSERT_EQ(a.gates()[k].merges, b.gates()[k].merges);
  }
}

struct Seen {
  uint64_t cubes_anew = 0, cubes = 0, points = 0, before = 0;
};

void compare(const oracle::Balls &few, const oracle::Balls &more, int64_t few_floor, int64_t floor, Seen &seen) {
  const BuiltPores before(few, few_floor);
  const BuiltPores anew(more, floor);
  ASSERT_EQ(before.status(), hsp::Status::ok);
  ASSERT_EQ(anew.status(), hsp::Status::ok);
  const uint64_t cubes_anew = anew.builder().work().cubes;
  BuiltPores taking(more, floor);
  ASSERT_EQ(taking.build(anew.builder().needed(), floor, &before.builder()), hsp::Status::ok);
  ASSERT_NO_FATAL_FAILURE(expect_same(anew.builder(), taking.builder()));
  seen.cubes_anew += cubes_anew;
  seen.cubes += taking.builder().work().cubes;
  seen.points += anew.maxima().size() + anew.gates().size();
  seen.before += before.maxima().size() + before.gates().size();
}

oracle::Balls grown(oracle::Balls balls, int64_t by) {
  for (auto &ball : balls) ball.radius += by;
  return balls;
}

// A further ball: anywhere, around or inside one that is there, at a point where many tie, or just beside them.
oracle::LatticeBall further(oracle::RandomSource &random, const oracle::Balls &balls, const BuiltPores &pores,
                            int kind) {
  const oracle::LatticeBall &one = balls[static_cast<size_t>(random.in(0, static_cast<int64_t>(balls.size()) - 1))];
  const auto near = [&](int64_t x) { return x + random.in(-one.radius - 1, one.radius + 1); };
  if (kind == 0) return {near(one.x), near(one.y), near(one.z), random.in(0, one.radius)};
  if (kind == 1) return {one.x, one.y, one.z, one.radius + random.in(-1, 1)};
  if (kind == 2) return {near(one.x), near(one.y), near(one.z), 4 * one.radius};
  if (pores.gates().empty()) return one;
  const hsp::CriticalPoint &point =
      pores.gates()[static_cast<uint32_t>(random.in(0, int64_t{pores.gates().size()} - 1))].point;
  const auto at = [](double x) { return static_cast<int64_t>(std::nearbyint(x)); };
  const oracle::LatticeBall plug{at(point.position.x), at(point.position.y), at(point.position.z), one.radius / 4};
  // As far from the point as the others are, where that is on the lattice.
  if (kind == 3) return plug;
  return {plug.x + at(point.level) + one.radius, plug.y, plug.z, one.radius};
}

TEST(KnownPoints, AreWhatIsFoundWithoutThem) {
  oracle::RandomSource random(1);
  Seen seen;
  for (int turn = 0; turn < oracle::sets(120); ++turn) {
    const bool tied = turn % 2 == 0;
    oracle::Balls few = tied ? pore_sets::tied_set(random, 20, turn / 2 % pore_sets::tied_kinds)
                             : pore_sets::general_set(random, 24, turn / 2 % pore_sets::general_kinds);
    const int64_t by = random.one_in(3) ? random.in(0, few[0].radius) : 0;
    oracle::Balls more = grown(few, by);
    // Some of those that tie are new.
    if (random.one_in(2)) few.resize(few.size() - static_cast<size_t>(random.in(1, 4)));
    const BuiltPores pores(few);
    for (int64_t k = random.in(0, 3); k > 0; --k) {
      more.push_back(further(random, more, pores, static_cast<int>(random.in(0, 4))));
    }
    const int64_t lowest = BuiltPores::lowest(few), floor = random.one_in(2) ? 0 : lowest - by;
    ASSERT_NO_FATAL_FAILURE(compare(few, more, random.one_in(2) ? lowest : floor + by, floor, seen));
  }
  EXPECT_GT(seen.points, 200U);
  EXPECT_LT(seen.cubes, seen.cubes_anew);
}

// Shells whose last balls are new: these tie with others at points that are known.
TEST(KnownPoints, TieWithNewBalls) {
  Seen seen;
  for (const int64_t square : {3, 6, 9, 26}) {
    for (uint32_t left_out = 1; left_out < 4; ++left_out) {
      const oracle::Balls more = pore_sets::shell(100000, 60000, square);
      oracle::Balls few = more;
      few.resize(few.size() - left_out);
      const int64_t lowest = std::min(BuiltPores::lowest(few), BuiltPores::lowest(more));
      ASSERT_NO_FATAL_FAILURE(compare(few, more, lowest, lowest, seen));
    }
  }
  EXPECT_GT(seen.points, 12U);
}

// One far away costs hardly anything, and none at all nothing but the cubes that have all balls.
TEST(KnownPoints, NothingIsSearchedWhereNothingIsNew) {
  oracle::RandomSource random(2);
  Seen seen;
  for (int turn = 0; turn < oracle::sets(10); ++turn) {
    const oracle::Balls few = pore_sets::general_set(random, 60, 0);
    ASSERT_NO_FATAL_FAILURE(compare(few, grown(few, 7), BuiltPores::lowest(few), 0, seen));
  }
  EXPECT_GT(seen.points, 40U);
  EXPECT_LT(8 * seen.cubes, seen.cubes_anew);
}

// Others are of no use, and no harm: of moved balls, of one that is missing, of one that has grown more, of a floor
// that is too high.
TEST(KnownPoints, OfOtherBallsAreNotTaken) {
  oracle::RandomSource random(3);
  for (int turn = 0; turn < oracle::sets(40); ++turn) {
    const oracle::Balls balls = pore_sets::general_set(random, 24, turn / 4 % pore_sets::general_kinds);
    oracle::Balls others = balls;
    const auto one = static_cast<size_t>(random.in(0, 23));
    int64_t floor = BuiltPores::lowest(balls);
    if (turn % 4 == 0) others[one].x += 1;
    if (turn % 4 == 1) others.push_back({others[one].x, others[one].y, others[one].z, 2 * others[one].radius});
    if (turn % 4 == 2) others[one].radius += others[one].radius / 2 + 1;
    if (turn % 4 == 3) floor += balls[0].radius;
    Seen seen;
    ASSERT_NO_FATAL_FAILURE(compare(others, balls, floor, BuiltPores::lowest(balls), seen));
    // A ball that is hidden may be any other one.
    if (turn % 4 == 3) {
      EXPECT_EQ(seen.cubes, seen.cubes_anew);
    }
  }
}

}  // namespace
