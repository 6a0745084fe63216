// Where rays enter balls, in integers and in order, against arithmetic of any length.
#include "exact/ray_order.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "brute_queries.hpp"
#include "random_balls.hpp"

namespace {

using oracle::LatticeBall;
using oracle::LatticePoint;

constexpr int64_t most_direction = (int64_t{1} << 53) - 1;
constexpr int64_t farthest = int64_t{1} << 50;
constexpr int64_t largest_radius = (int64_t{1} << 30) - 1;

hsp::exact::LatticeRay ray_of(const LatticePoint &origin, const LatticePoint &direction) {
  return {{origin[0], origin[1], origin[2]}, {direction[0], direction[1], direction[2]}};
}
hsp::exact::RayCut cut(const LatticeBall &ball, const LatticePoint &origin, const LatticePoint &direction) {
  return {ray_of(origin, direction), {{ball.x, ball.y, ball.z}, ball.radius, 0}};
}
bool contains(const LatticeBall &ball, const LatticePoint &point) {
  return oracle::balls_meeting({ball}, oracle::ball_around(point, 0)).size() == 1;
}

struct Seen {
  int misses = 0, hits = 0, order[3] = {0, 0, 0};
};

void check(const LatticeBall &a, const LatticeBall &b, const LatticePoint &origin, const LatticePoint &direction,
           Seen &seen) {
  if (contains(a, origin) || contains(b, origin)) return;
  const auto cut_a = cut(a, origin, direction), cut_b = cut(b, origin, direction);
  const bool meets = oracle::first_on_ray({a}, origin, direction) == 0;
  const std::string scene = oracle::to_text({a, b, oracle::ball_around(origin, 0), oracle::ball_around(direction, 0)});
  ASSERT_EQ(cut_a.meets(), meets) << scene;
  ++(meets ? seen.hits : seen.misses);
  if (!meets || !cut_b.meets()) return;
  const int order = oracle::compare_entries(a, b, origin, direction);
  ASSERT_EQ(hsp::exact::compare_entries(cut_a, cut_b), order) << scene;
  ASSERT_EQ(hsp::exact::compare_entries(cut_b, cut_a), -order) << scene;
  ++seen.order[order + 1];
}

LatticePoint random_point(oracle::RandomSource &random, int64_t most) {
  const int64_t x = random.in(-most, most);
  const int64_t y = random.in(-most, most);
  return {x, y, random.in(-most, most)};
}
// Of any size, with some components 0.
LatticePoint random_direction(oracle::RandomSource &random) {
  for (;;) {
    LatticePoint direction{};
    const int64_t most = most_direction >> random.in(0, 52);
    for (int64_t &component : direction) component = random.one_in(4) ? 0 : random.in(-most, most);
    if (direction != LatticePoint{}) return direction;
  }
}

TEST(RayOrder, OfSmallNumbersWithManyTies) {
  oracle::RandomSource random(1);
  Seen seen;
  for (int k = 0; k < 15000; ++k) {
    const LatticeBall a = oracle::ball_in_box(random, 6, 0, 5);
    const LatticeBall b = random.one_in(8) ? a : oracle::ball_in_box(random, 6, 0, 5);
    const LatticePoint origin = random_point(random, 12);
    LatticePoint direction = random_point(random, random.one_in(2) ? 1 : 3);
    if (random.one_in(2))
      for (size_t axis = 0; axis < 3; ++axis) direction[axis] += centre_of(a)[axis] - origin[axis];
    if (direction == LatticePoint{}) direction[0] = 1;
    check(a, b, origin, direction, seen);
  }
  EXPECT_GT(seen.misses, 3000);
  EXPECT_GT(seen.hits, 1000);
  for (const int times : seen.order) EXPECT_GT(times, 50);
}

// Balls that are entered in one point of a ray with long integers, and others just before and behind it.
TEST(RayOrder, OfLongVectors) {
  oracle::RandomSource random(2);
  Seen seen;
  for (int k = 0; k < 4000; ++k) {
    const LatticePoint direction = random_direction(random);
    // The ray comes from before both balls and goes through about where they are.
    const int64_t most = farthest >> random.in(1, 40);
    const LatticePoint place = random_point(random, most);
    double largest = 0;
    for (const int64_t component : direction) largest = std::fmax(largest, std::fabs(static_cast<double>(component)));
    const double back = 0.25 * static_cast<double>(most) / largest;
    LatticePoint origin = place;
    for (size_t axis = 0; axis < 3; ++axis) origin[axis] -= std::llround(back * static_cast<double>(direction[axis]));
    const int64_t radius = largest_radius >> random.in(0, 29);
    const LatticeBall a = oracle::ball_around(place, radius);
    LatticeBall b = a;
    b.x += random.in(-2, 2);
    b.radius += random.one_in(2) ? 0 : random.in(-1, 0);
    check(a, b, origin, direction, seen);
  }
  EXPECT_GT(seen.hits, 500);
  for (const int times : seen.order) EXPECT_GT(times, 50);
}

// Entries of a ray through the centres: numbers at the ends of their ranges.
TEST(RayOrder, OfTheLargestNumbers) {
  Seen seen;
  for (const int64_t side : {int64_t{-1}, int64_t{1}}) {
    const int64_t far = side * farthest;
    const LatticePoint origin = {-far, -far, -far};
    for (const int64_t off : {int64_t{0}, int64_t{1}, int64_t{2}}) {
      const LatticePoint direction = {side * most_direction, side * (most_direction - off), side * most_direction};
      for (const int64_t radius : {int64_t{0}, int64_t{1}, largest_radius - 1, largest_radius}) {
        const LatticeBall a = {far, far, far, largest_radius};
        check(a, {far, far, far, radius}, origin, direction, seen);
        check({far, far, far, radius}, {far - side, far - side, far - side, radius}, origin, direction, seen);
        check(a, {far - side * 1000, far, far, radius}, origin, direction, seen);
        check(a, {-far, -far, -far + side * largest_radius + side, largest_radius}, origin, direction, seen);
        check(a, {0, 0, 0, radius}, origin, direction, seen);
      }
    }
  }
  EXPECT_GT(seen.hits, 50);
  EXPECT_GT(seen.order[0], 10);
  EXPECT_GT(seen.order[2], 10);
}

TEST(RayOrder, EntriesOfKnownRays) {
  // The sphere of radius 5 around 100 0 0 is entered at 95, 96 or 100 along x, whatever the length of the direction.
  for (const int64_t length : {int64_t{1}, int64_t{3}, most_direction}) {
    for (const auto &[y, expected] : {std::pair{0, 95}, {3, 96}, {4, 97}, {5, 100}}) {
      const auto one = cut({100, y, 0, 5}, {0, 0, 0}, {length, 0, 0});
      EXPECT_TRUE(one.meets());
      EXPECT_NEAR(one.entry() * static_cast<double>(length), expected, 1e-13);
    }
    EXPECT_FALSE(cut({100, 6, 0, 5}, {0, 0, 0}, {length, 0, 0}).meets());
    EXPECT_FALSE(cut({-100, 0, 0, 5}, {0, 0, 0}, {length, 0, 0}).meets());
  }
  // One step before a large ball: nothing cancels.
  EXPECT_DOUBLE_EQ(cut({largest_radius + 1, 0, 0, largest_radius}, {0, 0, 0}, {1, 0, 0}).entry(), 1.0);
}

}  // namespace
