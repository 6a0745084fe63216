// Creases of pictures of triangles: which of two patches goes on over the other, and where its line is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

extern "C" {
#include "draw/mesh_creases.h"
}

namespace {

constexpr double wide[2] = {9, 6};  // lines of creases and of areas
constexpr uint32_t lower = 3, higher = 7;

class Creases {
 public:
  Creases() : nearer_(1000, NO_PATCH), points_(10, 50) {}
  ~Creases() { creases_free(&creases_); }
  Creases(const Creases &) = delete;
  Creases &operator=(const Creases &) = delete;

  // Along x in edges as long as `length`, from vertex to vertex: the lower patch lies where y is negative.
  void add_chain(uint32_t edges, uint32_t first, double length, int painted = 0) {
    for (uint32_t k = 0; k < edges; ++k) {
      crease edge{};
      edge.vertex[0] = first + k;
      edge.vertex[1] = first + k + 1;
      edge.patch[0] = lower;
      edge.patch[1] = higher;
      edge.at[0][0] = length * k;
      edge.at[1][0] = length * (k + 1);
      edge.painted = painted;
      edge.edge = k;
      creases_add(&creases_, &edge);
    }
  }
  void add(const crease &edge) { creases_add(&creases_, &edge); }
  void set_contour(uint32_t vertex, uint32_t patch) { nearer_[vertex] = patch; }
  void set_points(uint32_t patch, uint64_t points) { points_[patch] = points; }
  void choose() { ASSERT_TRUE(creases_choose(&creases_, nearer_.data(), points_.data(), wide)); }
  [[nodiscard]] crease &edge(size_t k) const { return creases_.crease[k]; }
  // How far the edge of the line is on the side of the patch that it goes on over.
  [[nodiscard]] double beyond(size_t k, int end) const {
    const crease &edge = creases_.crease[k];
    const double off = edge.line[end][1] - edge.at[end][1];
    EXPECT_NEAR(edge.line[end][0], edge.at[end][0], 1e-12);
    return wide[0] / 2 + (edge.over == 0 ? off : -off);
  }

 private:
  creases creases_ = CREASES_NONE;
  std::vector<uint32_t> nearer_;
  std::vector<uint64_t> points_;
};

// With no contour at its ends a crease is of what is seen at more points, and ends with the edge of what is painted
// later, which goes on over the other by half of the line around it: more and more from there on.
TEST(MeshCreases, EndWithTheLaterArea) {
  for (const bool more : {false, true}) {
    for (const int painted : {0, 1}) {
      Creases creases;
      creases.add_chain(20, 0, 10, painted);
      creases.set_points(higher, more ? 51 : 50);
      creases.choose();
      const int over = more ? 1 : 0;
      double before = 0;
      for (size_t k = 0; k < 20; ++k) {
        EXPECT_EQ(creases.edge(k).over, over);
        if (k > 0) {
          EXPECT_EQ(creases.beyond(k, 0), before);
        }
        before = creases.beyond(k, 1);
        EXPECT_NEAR(creases.beyond(k, 0), creases.beyond(19 - k, 1), 1e-9);
        if (k < 9) {
          EXPECT_GE(before, creases.beyond(k, 0));
        }
      }
      EXPECT_NEAR(creases.beyond(0, 0), painted == over ? wide[1] / 2 : -wide[1] / 2, 1e-12);
      EXPECT_NEAR(creases.beyond(10, 0), wide[0] / 2, 1e-12);
    }
  }
}

// Where a contour begins its patch is the nearer one, and the line goes on with its width.
TEST(MeshCreases, GoOverIntoContours) {
  for (const uint32_t patch : {lower, higher}) {
    for (const uint32_t vertex : {100U, 120U}) {
      Creases creases;
      creases.add_chain(20, 100, 10);
      creases.set_points(patch == lower ? higher : lower, 1000);
      creases.set_contour(vertex, patch);
      creases.set_contour(vertex == 100 ? 120 : 100, 5);  // of another patch
      creases.choose();
      for (size_t k = 0; k < 20; ++k) EXPECT_EQ(creases.edge(k).over, patch == lower ? 0 : 1);
      EXPECT_NEAR(vertex == 100 ? creases.beyond(0, 0) : creases.beyond(19, 1), wide[0] / 2, 1e-12);
      EXPECT_LT(vertex == 100 ? creases.beyond(19, 1) : creases.beyond(0, 0), wide[0] / 2 - 1);
    }
  }
}

// With contours of either patch it is that of the nearer one, and has no step where this changes.
TEST(MeshCreases, ChangeInTheMiddle) {
  Creases creases;
  creases.add_chain(21, 0, 10);
  creases.set_contour(0, higher);
  creases.set_contour(21, lower);
  creases.choose();
  for (size_t k = 0; k < 21; ++k) {
    if (k == 10) continue;
    EXPECT_EQ(creases.edge(k).over, k < 10 ? 1 : 0) << k;
  }
  const size_t last = creases.edge(10).over == 1 ? 10 : 9;
  EXPECT_NEAR(creases.beyond(last, 1), -creases.beyond(last + 1, 0), 1e-12);
  EXPECT_NEAR(creases.beyond(0, 0), wide[0] / 2, 1e-12);
  EXPECT_NEAR(creases.beyond(20, 1), wide[0] / 2, 1e-12);
}

// Three patches meet in a point: what goes on there with other patches does not belong to it.
TEST(MeshCreases, EndWhereOtherPatchesMeet) {
  Creases creases;
  creases.add_chain(10, 0, 10);
  crease other{};
  other.vertex[0] = 10;
  other.vertex[1] = 11;
  other.patch[0] = lower;
  other.patch[1] = 8;
  other.at[0][0] = 100;
  other.at[1][0] = 110;
  other.known = true;
  creases.add(other);
  creases.set_contour(11, 8);
  creases.choose();
  for (size_t k = 0; k < 11; ++k) EXPECT_EQ(creases.edge(k).over, 0);
  EXPECT_NEAR(creases.beyond(9, 1), wide[1] / 2, 1e-12);
  // The other one is given, and its line has the edge of the area all along.
  EXPECT_NEAR(creases.beyond(10, 0), wide[1] / 2, 1e-12);
  EXPECT_NEAR(creases.beyond(10, 1), wide[1] / 2, 1e-12);
}

// A ring has no ends; with no contour the line lies on it.
TEST(MeshCreases, RingsHaveNoEnds) {
  constexpr uint32_t edges = 30;
  Creases creases;
  for (uint32_t k = 0; k < edges; ++k) {
    crease edge{};
    for (uint32_t end = 0; end < 2; ++end) {
      const double angle = 2 * std::numbers::pi * (k + end) / edges;
      edge.vertex[end] = (k + end) % edges;
      edge.at[end][0] = 40 * std::cos(angle);
      edge.at[end][1] = 40 * std::sin(angle);
    }
    edge.patch[0] = lower;
    edge.patch[1] = higher;
    creases.add(edge);
  }
  creases.set_contour(7, higher);
  creases.choose();
  for (size_t k = 0; k < edges; ++k) {
    EXPECT_EQ(creases.edge(k).over, 1);
    for (int end = 0; end < 2; ++end) {
      for (int axis = 0; axis < 2; ++axis) {
        EXPECT_EQ(creases.edge(k).line[end][axis], creases.edge(k).at[end][axis]) << k;
      }
    }
  }
}

}  // namespace
