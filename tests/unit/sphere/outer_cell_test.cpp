// The polyhedron around what caps leave free, against all points of three planes in long doubles.
#include "sphere/outer_cell.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "random_numbers.hpp"
#include "runnable_targets.hpp"

namespace {

using hsp::OuterCell;
using Random = support::RandomNumbers<support::SplitMix64>;
using Point = std::array<long double, 3>;

struct Plane {
  long double u[3], b;
};

long double depth_of(const Plane &plane, const Point &p) {
  return plane.u[0] * p[0] + plane.u[1] * p[1] + plane.u[2] * p[2] - plane.b;
}

// By Cramer's rule; false if the planes have no common point to speak of.
bool point_of(const Plane &p, const Plane &q, const Plane &r, Point &point) {
  const auto determinant = [](const Point &a, const Point &b, const Point &c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  const Plane *const row[3] = {&p, &q, &r};
  Point columns[4];
  for (size_t k = 0; k < 3; ++k) {
    for (size_t axis = 0; axis < 3; ++axis) columns[axis][k] = row[k]->u[axis];
    columns[3][k] = row[k]->b;
  }
  const long double whole = determinant(columns[0], columns[1], columns[2]);
  if (std::fabs(whole) < 1e-9L) return false;
  point = {determinant(columns[3], columns[1], columns[2]) / whole,
           determinant(columns[0], columns[3], columns[2]) / whole,
           determinant(columns[0], columns[1], columns[3]) / whole};
  return true;
}

std::vector<Plane> sides_of_cube() {
  std::vector<Plane> planes;
  for (size_t axis = 0; axis < 3; ++axis) {
    for (const long double sign : {1.0L, -1.0L}) {
      Plane plane{{0, 0, 0}, 1.125L};
      plane.u[axis] = sign;
      planes.push_back(plane);
    }
  }
  return planes;
}

// All points of three planes that no cap has.
std::vector<Point> vertices_of(const std::vector<Plane> &planes) {
  std::vector<Point> found;
  for (size_t p = 0; p < planes.size(); ++p) {
    for (size_t q = p + 1; q < planes.size(); ++q) {
      for (size_t r = q + 1; r < planes.size(); ++r) {
        Point point;
        if (!point_of(planes[p], planes[q], planes[r], point)) continue;
        const auto outside = [&](const Plane &plane) { return depth_of(plane, point) > 1e-12L; };
        if (std::none_of(planes.begin(), planes.end(), outside)) found.push_back(point);
      }
    }
  }
  return found;
}

Plane random_plane(Random &random, long double least, long double most) {
  Plane plane{};
  long double squared = 0;
  do {
    squared = 0;
    for (long double &u : plane.u) {
      u = 2 * random.fraction() - 1;
      squared += u * u;
    }
  } while (squared < 0.01L || squared > 1);
  for (long double &u : plane.u) u = static_cast<double>(u / std::sqrt(squared));
  plane.b = static_cast<double>(least + (most - least) * static_cast<long double>(random.fraction()));
  return plane;
}

OuterCell::Plane in_doubles(const Plane &p) {
  return {static_cast<double>(p.u[0]), static_cast<double>(p.u[1]), static_cast<double>(p.u[2]),
          static_cast<double>(p.b)};
}

// Each vertex of one is near one of the other.
void expect_same_points(const OuterCell &cell, const std::vector<Point> &expected) {
  ASSERT_EQ(cell.vertices, expected.size());
  for (uint32_t v = 0; v < cell.vertices; ++v) {
    long double nearest = 9;
    for (const Point &p : expected) {
      nearest = std::min(
          nearest, std::hypot(p[0] - static_cast<long double>(cell.x[v]), p[1] - static_cast<long double>(cell.y[v]),
                              p[2] - static_cast<long double>(cell.z[v])));
    }
    EXPECT_LE(nearest, static_cast<long double>(cell.error[v]));
  }
}

TEST(OuterCell, IsTheIntersectionOfHalfSpaces) {
  for (const hsp::Target target : runnable_targets()) {
    Random random(5);
    int cut = 0, missed = 0;
    for (int round = 0; round < 60; ++round) {
      const auto cell = std::make_unique<OuterCell>();
      cell->start();
      std::vector<Plane> planes = sides_of_cube();
      for (uint32_t k = 0; k < 14; ++k) {
        const Plane plane = random_plane(random, 0.2L, 1.2L);
        const OuterCell::Cut answer = cell->cut(target, in_doubles(plane));
        ASSERT_TRUE(answer == OuterCell::Cut::cuts || answer == OuterCell::Cut::misses);
        planes.push_back(plane);
        cut += answer == OuterCell::Cut::cuts;
        missed += answer == OuterCell::Cut::misses;
      }
      expect_same_points(*cell, vertices_of(planes));
    }
    EXPECT_GT(cut, 300);
    EXPECT_GT(missed, 50);
  }
}

TEST(OuterCell, AnswersOfTheCube) {
  for (const hsp::Target target : runnable_targets()) {
    OuterCell cell;
    cell.start();
    EXPECT_EQ(cell.vertices, 8U);
    EXPECT_FALSE(cell.lies_inside_sphere());
    EXPECT_EQ(cell.cut(target, {1, 0, 0, 1.13}), OuterCell::Cut::misses);
    EXPECT_EQ(cell.cut(target, {1, 0, 0, 1.125}), OuterCell::Cut::unsure);  // the side itself
    EXPECT_EQ(cell.cut(target, {1, 0, 0, -1.13}), OuterCell::Cut::buries);
    EXPECT_EQ(cell.cut(target, {1, 0, 0, 0x1p-2}), OuterCell::Cut::cuts);
    EXPECT_EQ(cell.vertices, 8U);
    // A plane so nearly parallel to that one that where they meet is not certain.
    EXPECT_EQ(cell.cut(target, {1, 0x1p-30, 0, 0x1p-2}), OuterCell::Cut::refused);
    EXPECT_EQ(cell.vertices, 8U);
  }
}

// Caps around the polyhedron, many of them near to it: none that floats leave out touches it, few others are left.
TEST(OuterCell, FloatsLeaveOutWhatMisses) {
  for (const hsp::Target target : runnable_targets()) {
    Random random(9);
    uint32_t left_out = 0, missing = 0;
    for (uint32_t round = 0; round < 200; ++round) {
      OuterCell cell;
      cell.start();
      for (uint32_t k = 0; k < 12; ++k) cell.cut(target, in_doubles(random_plane(random, 0.01L, 0.9L)));
      const uint32_t count = 1 + round % 61;
      std::vector<Plane> planes;
      std::vector<float> columns[4];
      for (auto &column : columns) column.assign(count + hsp::FloatCaps::spare, 0.0F);
      for (float &b : columns[3]) b = 4.0F;
      for (uint32_t k = 0; k < count; ++k) {
        Plane plane = random_plane(random, -1, 1);
        if (k % 2 == 0) {  // hardly within it, or hardly not
          long double most = -9;
          for (uint32_t v = 0; v < cell.vertices; ++v) {
            most = std::max(most, depth_of(plane, {cell.x[v], cell.y[v], cell.z[v]}));
          }
          plane.b += most + (random.fraction() < 0.5 ? -1e-6L : 1e-4L) * static_cast<long double>(random.fraction());
        }
        planes.push_back(plane);
        for (size_t axis = 0; axis < 3; ++axis) columns[axis][k] = static_cast<float>(plane.u[axis]);
        columns[3][k] = static_cast<float>(plane.b);
      }
      std::vector<uint32_t> numbers(count + 1, hsp::no_id);
      uint32_t deepest = hsp::no_id;
      const uint32_t found = hsp::float_caps_that_may_cut(
          target, cell, {columns[0].data(), columns[1].data(), columns[2].data(), columns[3].data()}, count,
          numbers.data(), deepest);
      ASSERT_LE(found, count);
      EXPECT_EQ(numbers[count], hsp::no_id);
      long double depth_of_deepest = -9, most_depth = -9;
      for (uint32_t k = 0, next = 0; k < count; ++k) {
        const bool listed = next < found && numbers[next] == k;
        next += listed ? 1U : 0U;
        long double depth = -9;
        for (uint32_t v = 0; v < cell.vertices; ++v) {
          depth = std::max(depth, depth_of(planes[k], {cell.x[v], cell.y[v], cell.z[v]}));
        }
        EXPECT_TRUE(listed || depth < -1e-6L);
        most_depth = std::max(most_depth, depth);
        if (k == deepest) depth_of_deepest = depth;
        left_out += listed ? 0U : 1U;
        missing += depth < -5e-5L ? 1U : 0U;
      }
      EXPECT_TRUE(found == 0 || most_depth - depth_of_deepest < 1e-5L);
    }
    EXPECT_GT(left_out, 1000U);
    EXPECT_GE(left_out, missing);
  }
}

TEST(OuterCell, HasRoomForSoManyFaces) {
  for (const hsp::Target target : runnable_targets()) {
    const auto cell = std::make_unique<OuterCell>();
    cell->start();
    Random random(77);
    uint32_t cut = 0, full = 0;
    for (uint32_t k = 0; k < 4000; ++k) {
      const Plane plane = random_plane(random, 0.9999L, 0.99991L);
      const OuterCell::Cut answer = cell->cut(target, in_doubles(plane));
      cut += answer == OuterCell::Cut::cuts;
      full += answer == OuterCell::Cut::full;
      ASSERT_LE(cell->vertices, OuterCell::most_vertices);
      ASSERT_EQ(cell->vertices + 4, 2 * static_cast<uint32_t>(__builtin_popcountll(cell->faces)));  // three edges each
    }
    EXPECT_GT(cut, 50U);
    EXPECT_GT(full, 100U);
  }
}

TEST(OuterCell, LiesInsideTheSphereWhenCapsCoverIt) {
  for (const hsp::Target target : runnable_targets()) {
    OuterCell cell;
    cell.start();
    for (const double sign : {1.0, -1.0}) {
      EXPECT_FALSE(cell.lies_inside_sphere());
      EXPECT_EQ(cell.cut(target, {sign, 0, 0, 0.57}), OuterCell::Cut::cuts);
      EXPECT_EQ(cell.cut(target, {0, sign, 0, 0.57}), OuterCell::Cut::cuts);
      EXPECT_EQ(cell.cut(target, {0, 0, sign, 0.57}), OuterCell::Cut::cuts);
    }
    EXPECT_TRUE(cell.lies_inside_sphere());  // corners of a cube of half side 0.57 < 1/sqrt(3)
  }
}

// Planes through one point, or hardly beside it: of which it is said that they take a point alone, all that they take
// lies inside the sphere or all outside.
TEST(OuterCell, PartsThatAreAPointAlone) {
  const hsp::Target target = runnable_targets().front();
  Random random(21);
  uint32_t inside = 0, outside = 0, more = 0;
  for (uint32_t round = 0; round < 300; ++round) {
    const auto cell = std::make_unique<OuterCell>();
    cell->start();
    std::vector<Plane> planes = sides_of_cube();
    // At all distances from the sphere's centre, and a third of the points about on the sphere.
    Plane towards = random_plane(random, 0, 1.2L);
    if (round % 3 == 0) towards.b = 1 + 0.01L * static_cast<long double>(random.fraction() - 0.5);
    const Point point = {towards.u[0] * towards.b, towards.u[1] * towards.b, towards.u[2] * towards.b};
    const auto plane_through = [&](long double off) {
      Plane plane = random_plane(random, 0, 0);
      plane.b = static_cast<double>(depth_of(plane, point) + off);
      return plane;
    };
    for (uint32_t k = 0; k < 8; ++k) {
      const Plane plane = plane_through(0);
      if (cell->cut(target, in_doubles(plane)) == OuterCell::Cut::cuts) planes.push_back(plane);
    }
    for (uint32_t k = 0; k < 20; ++k) {
      const long double off[] = {0, 1e-6L, -1e-6L, 1e-10L, -1e-10L};
      const Plane plane = plane_through(off[k % 5]);
      const OuterCell::Taken taken = cell->part_taken(in_doubles(plane));
      if (taken == OuterCell::Taken::more) {
        ++more;
        continue;
      }
      ++(taken == OuterCell::Taken::point_inside_sphere ? inside : outside);
      planes.push_back({{-plane.u[0], -plane.u[1], -plane.u[2]}, -plane.b});
      for (const Point &p : vertices_of(planes)) {
        EXPECT_EQ(std::hypot(p[0], p[1], p[2]) < 1, taken == OuterCell::Taken::point_inside_sphere);
      }
      planes.pop_back();
    }
  }
  EXPECT_GT(inside, 20U);
  EXPECT_GT(outside, 20U);
  EXPECT_GT(more, 1000U);
}

TEST(OuterCell, BatchesOfCapsThatMayCut) {
  for (const hsp::Target target : runnable_targets()) {
    Random random(9);
    const auto cell = std::make_unique<OuterCell>();
    cell->start();
    std::vector<Plane> planes = sides_of_cube();
    for (uint32_t k = 0; k < 8; ++k) {
      planes.push_back(random_plane(random, 0.3L, 0.6L));
      ASSERT_EQ(cell->cut(target, in_doubles(planes.back())), OuterCell::Cut::cuts);
    }
    const std::vector<Point> vertices = vertices_of(planes);
    int cutting = 0, missing = 0;
    for (uint32_t count = 1; count <= hsp::CapBatch::most; ++count) {
      hsp::CapBatch batch{};
      batch.count = count;
      long double most[hsp::CapBatch::most];
      for (uint32_t k = 0; k < count; ++k) {
        const Plane plane = random_plane(random, 0.3L, 0.9L);
        const OuterCell::Plane p = in_doubles(plane);
        batch.ux[k] = p.ux, batch.uy[k] = p.uy, batch.uz[k] = p.uz, batch.b[k] = p.b;
        most[k] = -9;
        for (const Point &v : vertices) most[k] = std::max(most[k], depth_of(plane, v));
      }
      const uint32_t asked = batch.all() & 0xDB6DB6DBU;
      const uint32_t bits = caps_that_may_cut(target, *cell, batch, asked);
      EXPECT_EQ(bits & ~asked, 0U);
      for (uint32_t k = 0; k < count; ++k) {
        if ((asked >> k & 1U) == 0) continue;
        EXPECT_EQ(bits >> k & 1U, most[k] > 0 ? 1U : 0U);
        EXPECT_NEAR(batch.depth[k], static_cast<double>(most[k]), 1e-9);
        ++(most[k] > 0 ? cutting : missing);
      }
    }
    EXPECT_GT(cutting, 50);
    EXPECT_GT(missing, 50);
  }
}

}  // namespace
