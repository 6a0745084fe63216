// Boxes on the lattice: places in them, images near them, and what is refused.
#include "periodic/periodic_box.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <set>

#include "random_balls.hpp"

namespace {

using Point = std::array<int64_t, 3>;

Point sum_of(const double (&box)[9], const hsp::BoxShift &shift) {
  Point sum{0, 0, 0};
  for (size_t row = 0; row < 3; ++row) {
    for (size_t axis = 0; axis < 3; ++axis) sum[axis] += shift.k[row] * static_cast<int64_t>(box[3 * row + axis]);
  }
  return sum;
}

// Some with vectors that point to the other side of their axes.
struct RandomBox {
  explicit RandomBox(oracle::RandomSource &random) {
    for (size_t row = 0; row < 3; ++row) {
      for (size_t axis = 0; axis < 3; ++axis) {
        vector[3 * row + axis] = static_cast<double>(axis > row    ? 0
                                                     : axis == row ? random.in(20, 60)
                                                                   : random.in(-150, 150));
      }
      if (random.one_in(3)) vector[4 * row] = -vector[4 * row];
    }
    EXPECT_EQ(box.set(hsp::exact::Lattice::with_step(1.0), vector), hsp::Status::ok);
  }
  double vector[9];
  hsp::PeriodicBox box;
};

TEST(PeriodicBox, HasOnePlaceForAllCopiesOfAPoint) {
  oracle::RandomSource random(301);
  for (int set = 0; set < 200; ++set) {
    const RandomBox any(random);
    const hsp::exact::Vector first{random.in(-500, 500), random.in(-500, 500), random.in(-500, 500)};
    hsp::exact::Vector place = first;
    hsp::BoxShift home;
    ASSERT_EQ(any.box.wrap(place, home), hsp::Status::ok);
    const Point back = sum_of(any.vector, any.box.in_given_vectors(home));
    EXPECT_EQ(place.x + back[0], first.x);
    EXPECT_EQ(place.y + back[1], first.y);
    EXPECT_EQ(place.z + back[2], first.z);
    const hsp::exact::Vector t = any.box.translation(home);
    EXPECT_EQ(place.x + t.x, first.x);
    EXPECT_EQ(place.y + t.y, first.y);
    EXPECT_EQ(place.z + t.z, first.z);
    for (int copy = 0; copy < 10; ++copy) {
      hsp::BoxShift shift;
      for (int32_t &k : shift.k) k = static_cast<int32_t>(random.in(-9, 9));
      const Point moved = sum_of(any.vector, shift);
      hsp::exact::Vector same{first.x + moved[0], first.y + moved[1], first.z + moved[2]};
      hsp::BoxShift other;
      ASSERT_EQ(any.box.wrap(same, other), hsp::Status::ok);
      EXPECT_EQ(same.x, place.x);
      EXPECT_EQ(same.y, place.y);
      EXPECT_EQ(same.z, place.z);
      EXPECT_EQ(any.box.in_given_vectors(other - home), shift);
    }
  }
}

// Reduced: no vector is longer than half of those before it, along their axes.
TEST(PeriodicBox, ReducesItsVectors) {
  oracle::RandomSource random(302);
  for (int set = 0; set < 200; ++set) {
    const RandomBox any(random);
    const hsp::exact::Vector b = any.box.translation({{0, 1, 0}});
    const hsp::exact::Vector c = any.box.translation({{0, 0, 1}});
    const double side[3] = {std::fabs(any.vector[0]), std::fabs(any.vector[4]), std::fabs(any.vector[8])};
    EXPECT_EQ(static_cast<double>(b.y), side[1]);
    EXPECT_EQ(static_cast<double>(c.z), side[2]);
    EXPECT_LE(std::fabs(static_cast<double>(b.x)), side[0] / 2);
    EXPECT_LE(std::fabs(static_cast<double>(c.x)), side[0] / 2);
    EXPECT_LE(std::fabs(static_cast<double>(c.y)), side[1] / 2);
    EXPECT_EQ(any.box.volume(), side[0] * side[1] * side[2]);
  }
}

// Against all images of a point in the box that are near any of many points of the box.
TEST(PeriodicBox, VisitsAllImagesNearIt) {
  oracle::RandomSource random(303);
  uint32_t near = 0;
  for (int set = 0; set < 60; ++set) {
    const RandomBox any(random);
    const auto place = [&] {
      hsp::exact::Vector p{random.in(-500, 500), random.in(-500, 500), random.in(-500, 500)};
      hsp::BoxShift ignored;
      EXPECT_EQ(any.box.wrap(p, ignored), hsp::Status::ok);
      return p;
    };
    const hsp::exact::Vector point = place();
    const int64_t reach = random.in(0, 70);
    std::set<std::array<int32_t, 3>> visited;
    hsp::BoxShift last{{0, 0, -1000}};
    any.box.visit_images(point, reach, [&](const hsp::BoxShift &shift) {
      EXPECT_TRUE(hsp::visited_before(last, shift));
      EXPECT_FALSE(shift.is_zero());
      last = shift;
      visited.insert({shift.k[0], shift.k[1], shift.k[2]});
    });
    for (int other = 0; other < 40; ++other) {
      const hsp::exact::Vector from = place();
      hsp::BoxShift shift;
      for (shift.k[0] = -7; shift.k[0] <= 7; ++shift.k[0]) {
        for (shift.k[1] = -7; shift.k[1] <= 7; ++shift.k[1]) {
          for (shift.k[2] = -7; shift.k[2] <= 7; ++shift.k[2]) {
            const hsp::exact::Vector t = any.box.translation(shift);
            const hsp::exact::Vector v{point.x + t.x - from.x, point.y + t.y - from.y, point.z + t.z - from.z};
            if (shift.is_zero() || dot(v, v) > reach * reach) continue;
            ++near;
            EXPECT_EQ(visited.count({shift.k[0], shift.k[1], shift.k[2]}), 1U);
          }
        }
      }
    }
  }
  EXPECT_GT(near, 5000U);
}

// By the turn of a triangle of 3, 4 and 5, of multiples of 25, everything stays on the lattice.
TEST(PeriodicBox, IsTheSameTurned) {
  oracle::RandomSource random(304);
  for (int set = 0; set < 100; ++set) {
    const RandomBox any(random);
    double vector[9];
    for (int row = 0; row < 3; ++row) {
      const double *const v = any.vector + 3 * row;
      const double x = 3 * v[0] - 4 * v[1], y = 4 * v[0] + 3 * v[1], z = 5 * v[2];  // 5 v, turned about z
      vector[3 * row] = 3 * x - 4 * z;                                              // 25 v, turned about y
      vector[3 * row + 1] = 5 * y;
      vector[3 * row + 2] = 4 * x + 3 * z;
    }
    hsp::PeriodicBox box, large;
    double multiple[9];
    for (int k = 0; k < 9; ++k) multiple[k] = 25 * any.vector[k];
    ASSERT_EQ(large.set(hsp::exact::Lattice::with_step(1.0), multiple), hsp::Status::ok);
    ASSERT_EQ(box.set(hsp::exact::Lattice::with_step(1.0), vector), hsp::Status::ok);
    EXPECT_TRUE(box.frame().turns());
    // a points along x then, which reverses it if it did not before, and turns the others with it.
    EXPECT_EQ(box.volume(), large.volume());
    for (int row = 0; row < 3; ++row) {
      const hsp::exact::Vector &own = box.given(static_cast<uint32_t>(row));
      const hsp::exact::Vector &other = large.given(static_cast<uint32_t>(row));
      EXPECT_EQ(std::abs(own.x), std::abs(other.x));
      EXPECT_EQ(std::abs(own.y), std::abs(other.y));
      EXPECT_EQ(std::abs(own.z), std::abs(other.z));
    }
    EXPECT_GT(box.given(0).x, 0);
    EXPECT_GT(box.given(1).y, 0);
    // Its handedness is that of the vectors.
    EXPECT_EQ(box.given(2).z > 0, any.vector[0] * any.vector[4] * any.vector[8] > 0);
    const double odd[3] = {1e9, -2e9, 3e9};
    const hsp::Vec3 there = box.frame().turned_in(odd), back = box.frame().turned_back(there);
    EXPECT_NEAR(back.x, odd[0], 1e-5);
    EXPECT_NEAR(back.y, odd[1], 1e-5);
    EXPECT_NEAR(back.z, odd[2], 1e-5);
  }
}

TEST(PeriodicBox, RefusesWhatIsNoBoxHere) {
  const hsp::exact::Lattice lattice = hsp::exact::Lattice::with_step(0.5);
  const double good[9] = {10, 0, 0, 3, 12, 0, -4, 5, 9};
  const auto with = [&](int k, double value) {
    double vector[9];
    for (int at = 0; at < 9; ++at) vector[at] = at == k ? value : good[at];
    hsp::PeriodicBox box;
    return box.set(lattice, vector);
  };
  EXPECT_EQ(with(0, 10), hsp::Status::ok);
  for (int k = 0; k < 9; ++k) {
    EXPECT_EQ(with(k, std::numeric_limits<double>::quiet_NaN()), hsp::Status::not_finite);
    EXPECT_EQ(with(k, -std::numeric_limits<double>::infinity()), hsp::Status::not_finite);
  }
  for (const int k : {1, 2, 5}) {
    EXPECT_EQ(with(k, 1e-300), hsp::Status::ok);
    EXPECT_EQ(with(k, 2.0), hsp::Status::ok);
    EXPECT_EQ(with(k, 0x1p44), hsp::Status::range);
  }
  for (const int k : {0, 4, 8}) {
    EXPECT_EQ(with(k, 0.0), hsp::Status::range);
    EXPECT_EQ(with(k, -3.0), hsp::Status::ok);
    EXPECT_EQ(with(k, -0.2), hsp::Status::range);
    EXPECT_EQ(with(k, 0.2), hsp::Status::range);  // no step long
    EXPECT_EQ(with(k, 0x1p44), hsp::Status::range);
  }
  for (const int k : {3, 6, 7}) {
    EXPECT_EQ(with(k, 5000.0), hsp::Status::range);
    EXPECT_EQ(with(k, -0x1p60), hsp::Status::range);
  }
  hsp::PeriodicBox box;
  // Three in a plane, two along a line, and a vector of 0.
  const double in_plane[9] = {10, 2, -3, 4, -5, 6, 14, -3, 3}, along[9] = {10, 2, -3, -20, -4, 6, 1, 1, 1};
  const double none[9] = {0, 0, 0, 1, 2, 3, 9, 2, 4}, nearly[9] = {10, 2, -3, 4, -5, 6, 14, -3, 3.3};
  for (const double *const vector : {in_plane, along, none, nearly})
    EXPECT_EQ(box.set(lattice, vector), hsp::Status::range);
  ASSERT_EQ(box.set(lattice, good), hsp::Status::ok);
  EXPECT_TRUE(box.suits(495));
  EXPECT_FALSE(box.suits(496));  // the height is 18 steps
  for (const hsp::exact::Vector &far :
       {hsp::exact::Vector{0, 0, INT64_C(1) << 50}, {0, -(INT64_C(1) << 50), 0}, {INT64_C(1) << 50, 0, 0}}) {
    hsp::exact::Vector point = far;
    hsp::BoxShift shift;
    EXPECT_EQ(box.wrap(point, shift), hsp::Status::range);
  }
}

}  // namespace
