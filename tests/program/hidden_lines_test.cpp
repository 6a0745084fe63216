// Lines along edges of triangles against a look at hundreds of points of each: a point is hidden where some triangle
// that is not beside the line lies over it and nearer, by areas and depths in long double.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <vector>

extern "C" {
#include "draw/hidden_lines.h"
#include "draw/seen_triangle.h"
}

namespace {

constexpr double plane = 500;
constexpr int32_t page = 1 << 12;

// Triangle k lies in the depths from 10 k to 10 k + 4, and lines are between those, so that none crosses a line.
constexpr double layer = 10;

struct Scene {
  std::vector<seen_triangle> triangles;
  explicit Scene(std::mt19937 &random, uint32_t count, int32_t size) {
    std::uniform_int_distribution<int32_t> anywhere(-page, page), beside(-size, size);
    std::uniform_real_distribution<double> tilt(0, 4);
    for (uint32_t k = 0; k < count; ++k) {
      seen_triangle triangle{};
      const int32_t middle[2] = {anywhere(random), anywhere(random)};
      for (int corner = 0; corner < 3; ++corner) {
        for (int axis = 0; axis < 2; ++axis) triangle.at[corner][axis] = middle[axis] + beside(random);
        triangle.depth[corner] = layer * k + tilt(random);
      }
      triangle.number = k;
      triangle.whole = k % 3 != 0;
      triangles.push_back(triangle);
    }
  }
};

// The shares of the three corners in a point, by areas; false without an area.
bool shares_of(const seen_triangle &triangle, const std::array<long double, 2> &at, std::array<long double, 3> &share) {
  const auto area = [](const std::array<long double, 2> &a, const std::array<long double, 2> &b,
                       const std::array<long double, 2> &c) {
    return a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1]);
  };
  std::array<std::array<long double, 2>, 3> corner;
  for (size_t k = 0; k < 3; ++k) corner[k] = {triangle.at[k][0] * 1.0L, triangle.at[k][1] * 1.0L};
  const long double whole = area(corner[0], corner[1], corner[2]);
  if (whole == 0) return false;
  for (size_t k = 0; k < 3; ++k) share[k] = area(at, corner[(k + 1) % 3], corner[(k + 2) % 3]) / whole;
  return true;
}

struct Over {
  bool covers, near_border;  // so near to a border, or to the plane, that either answer is good
  long double depth;
};
Over over(const seen_triangle &triangle, const std::array<long double, 2> &at) {
  constexpr long double margin = 1e-9L;
  std::array<long double, 3> share{};
  if (!shares_of(triangle, at, share)) return {false, false, 0};
  Over found{true, false, 0};
  for (size_t k = 0; k < 3; ++k) {
    found.covers = found.covers && share[k] > 0;
    found.near_border = found.near_border || std::fabs(share[k]) < margin;
    found.depth += share[k] * triangle.depth[k];
  }
  if (!triangle.whole) {
    found.covers = found.covers && found.depth < plane;
    found.near_border = found.near_border || std::fabs(found.depth - plane) < margin;
  }
  return found;
}

class HiddenLines : public testing::TestWithParam<int> {};

TEST_P(HiddenLines, AreThoseThatPointsSay) {
  std::mt19937 random(static_cast<unsigned>(GetParam()));
  constexpr std::array<std::array<int32_t, 2>, 5> sizes{{{5, 8000}, {7, 4000}, {40, 900}, {100, 600}, {100, 5000}}};
  const auto [count, size] = sizes[static_cast<size_t>(GetParam()) % sizes.size()];
  const Scene scene(random, static_cast<uint32_t>(count), size);
  hidden_lines lines;
  ASSERT_TRUE(hidden_lines_begin(scene.triangles.data(), static_cast<uint32_t>(count), plane, &lines));
  std::uniform_int_distribution<int32_t> anywhere(-page - 500, page + 500), among(0, count - 1);
  size_t hidden_points = 0;
  for (int trial = 0; trial < 15; ++trial) {
    seen_line line{};
    const double depth = layer * among(random) - layer / 4;
    for (int end = 0; end < 2; ++end) {
      for (int axis = 0; axis < 2; ++axis) line.at[end][axis] = anywhere(random);
      line.depth[end] = depth + 0.5 * end;
      line.beside[end] = static_cast<uint32_t>(among(random) + (count == 1 ? 1 : 0));
    }
    ASSERT_TRUE(hidden_lines_find_seen(&lines, &line));
    for (size_t k = 0; k < lines.spans; ++k) {
      EXPECT_LT(lines.span[k].from, lines.span[k].to);
      if (k == 0) continue;
      EXPECT_LE(lines.span[k - 1].to, lines.span[k].from);
    }
    for (int point = 0; point <= 250; ++point) {
      const long double share = point / 250.0L;
      std::array<long double, 2> at;
      for (size_t axis = 0; axis < 2; ++axis) {
        at[axis] = line.at[0][axis] + share * (static_cast<long double>(line.at[1][axis]) - line.at[0][axis]);
      }
      bool hidden = false, unsure = false;
      for (const seen_triangle &triangle : scene.triangles) {
        if (triangle.number == line.beside[0] || triangle.number == line.beside[1]) continue;
        const Over found = over(triangle, at);
        if (found.depth < depth) continue;
        hidden = hidden || found.covers;
        unsure = unsure || found.near_border;
      }
      bool seen = false;
      for (size_t k = 0; k < lines.spans; ++k) {
        seen = seen || (share > lines.span[k].from && share < lines.span[k].to);
        unsure = unsure || std::fabs(share - lines.span[k].from) < 1e-9L || std::fabs(share - lines.span[k].to) < 1e-9L;
      }
      if (unsure) continue;
      hidden_points += hidden ? 1 : 0;
      EXPECT_NE(seen, hidden) << "line " << trial << ", point " << point;
    }
  }
  EXPECT_GT(hidden_points, 20U);
  hidden_lines_free(&lines);
}

TEST_P(HiddenLines, FrontIsTheNearestOfAll) {
  std::mt19937 random(100 + static_cast<unsigned>(GetParam()));
  const Scene scene(random, 60, 1500);
  hidden_lines lines;
  ASSERT_TRUE(hidden_lines_begin(scene.triangles.data(), 60, plane, &lines));
  std::uniform_real_distribution<double> anywhere(-page - 500, page + 500);
  for (int trial = 0; trial < 800; ++trial) {
    const double at[2] = {anywhere(random), anywhere(random)};
    long double nearest = -std::numeric_limits<long double>::infinity();
    bool unsure = false;
    for (const seen_triangle &triangle : scene.triangles) {
      const Over found = over(triangle, {at[0], at[1]});
      if (found.covers && found.depth > nearest) nearest = found.depth;
      unsure = unsure || found.near_border;
    }
    const double front = hidden_lines_front(&lines, at);
    if (unsure) continue;
    if (std::isinf(nearest)) {
      EXPECT_EQ(front, -std::numeric_limits<double>::infinity());
    } else {
      EXPECT_NEAR(front, static_cast<double>(nearest), 1e-9);
    }
  }
  hidden_lines_free(&lines);
}

INSTANTIATE_TEST_SUITE_P(Scenes, HiddenLines, testing::Range(0, 10));

// On the border of a triangle a line stays seen, and without triangles all of it.
TEST(HiddenLines, TouchedIsSeen) {
  seen_triangle triangle{};
  const int32_t corners[3][2] = {{0, 0}, {100, 0}, {0, 100}};
  for (int k = 0; k < 3; ++k) {
    for (int axis = 0; axis < 2; ++axis) triangle.at[k][axis] = corners[k][axis];
    triangle.depth[k] = 10;
  }
  triangle.whole = true;
  triangle.number = 5;
  seen_line line{};
  line.at[0][0] = -50;
  line.at[1][0] = 150;
  line.beside[0] = line.beside[1] = 7;
  for (const uint32_t count : {0U, 1U}) {
    hidden_lines lines;
    ASSERT_TRUE(hidden_lines_begin(&triangle, count, plane, &lines));
    ASSERT_TRUE(hidden_lines_find_seen(&lines, &line));
    ASSERT_EQ(lines.spans, 1U);
    EXPECT_EQ(lines.span[0].from, 0);
    EXPECT_EQ(lines.span[0].to, 1);
    hidden_lines_free(&lines);
  }
  // One unit inside, a part as long as the triangle is wide there is hidden, unless the triangle is the line's own.
  line.at[0][1] = line.at[1][1] = 1;
  for (const uint32_t own : {7U, 5U}) {
    hidden_lines lines;
    ASSERT_TRUE(hidden_lines_begin(&triangle, 1, plane, &lines));
    line.beside[1] = own;
    ASSERT_TRUE(hidden_lines_find_seen(&lines, &line));
    ASSERT_EQ(lines.spans, own == 5 ? 1U : 2U);
    if (own == 7) {
      EXPECT_DOUBLE_EQ(lines.span[0].to, 50.0 / 200);
      EXPECT_DOUBLE_EQ(lines.span[1].from, 149.0 / 200);
    }
    hidden_lines_free(&lines);
  }
}

}  // namespace
