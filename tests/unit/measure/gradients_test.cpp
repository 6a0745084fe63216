// Rows of the areas' Jacobian: an entry for each ball, sorted, and sums of their parts.
#include "measure/gradients.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "built_boundary.hpp"

namespace {

struct Entry {
  double centre[3];
  double radius, angle;
  uint32_t ball, flags;
};

std::vector<Entry> row_of(BuiltBoundary &built, uint32_t caller) {
  const uint32_t i = built.grid_index(caller);
  std::vector<Entry> row(hsp::area_row_length(built.boundary(), i));
  for (Entry &entry : row) entry = {{9, 9, 9}, 9, 9, 9, 9};  // whatever was there does not matter
  hsp::gather_area_row(built.balls(), built.boundary(), i, hsp::TouchingBalls::meet,
                       hsp::Span<Entry>(row.data(), static_cast<uint32_t>(row.size())));
  return row;
}

// Two small balls at opposite ends of the circle of two large ones leave two arcs of it: one entry for both.
TEST(AreaRow, MergesTheArcsOfOneCircle) {
  BuiltBoundary built({{500, -866, 0, 300}, {0, 0, 0, 1000}, {500, 866, 0, 300}, {1000, 0, 0, 1000}});
  ASSERT_EQ(built.status(), hsp::Status::ok);
  const std::vector<Entry> row = row_of(built, 1);
  ASSERT_EQ(row.size(), 4U);
  for (uint32_t k = 0; k < 4; ++k) {
    EXPECT_EQ(row[k].ball, k);
    EXPECT_EQ(row[k].flags, 0U);
  }
  double sum[3] = {0, 0, 0};
  for (const Entry &entry : row) {
    for (int axis = 0; axis < 3; ++axis) sum[axis] += entry.centre[axis];
  }
  for (const double total : sum) EXPECT_NEAR(total, 0.0, 1e-9);
  // The parts of ball 3, added by hand.
  const uint32_t own = built.grid_index(1);
  hsp::AreaDerivative merged;
  uint32_t parts = 0;
  const hsp::AreaDerivative by_itself = hsp::visit_area_row(
      built.balls(), built.boundary(), own, hsp::TouchingBalls::meet, [&](uint32_t j, const hsp::AreaDerivative &part) {
        if (built.balls().caller[j] != 3) return;
        merged.radius += part.radius;
        merged.angle += part.angle;
        ++parts;
      });
  EXPECT_EQ(parts, 2U);
  EXPECT_EQ(row[3].radius, merged.radius);
  EXPECT_EQ(row[3].angle, merged.angle);
  EXPECT_GT(row[3].angle, 0.0);
  EXPECT_EQ(row[1].radius, by_itself.radius);
  EXPECT_EQ(row[1].angle, 0.0);
}

TEST(AreaRow, FlagsTouchingBallsAndTheBallItself) {
  BuiltBoundary built({{1000, 0, 0, 500}, {-900, 0, 0, 500}, {0, 0, 0, 500}});
  const std::vector<Entry> row = row_of(built, 2);
  ASSERT_EQ(row.size(), 3U);
  EXPECT_EQ(row[0].flags, hsp::one_sided_flag);
  EXPECT_EQ(row[1].flags, 0U);
  EXPECT_EQ(row[2].flags, hsp::one_sided_flag);
}

TEST(AreaRow, IsEmptyWithoutFaces) {
  BuiltBoundary built({{0, 0, 0, 1000}, {0, 0, 0, 100}});
  EXPECT_TRUE(row_of(built, 1).empty());
  const std::vector<Entry> row = row_of(built, 0);
  ASSERT_EQ(row.size(), 1U);
  EXPECT_EQ(row[0].ball, 0U);
  EXPECT_NEAR(row[0].radius, 8 * hsp::pi * 1000, 1e-9);
}

}  // namespace
