// Patches whose borders touch or run along each other: whatever lies where, the triangles are a surface with the loops
// as its border.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "carved_memory.hpp"
#include "mesh/spherical_patch.hpp"

namespace {

using hsp::PatchState;
using hsp::SphericalPatch;
using hsp::Vec3;

struct Point {
  Vec3 place;
  uint32_t other = hsp::no_id;  // another patch that has it
};
using Loop = std::vector<Point>;

// So many points about the z axis at a height, from an angle on; clockwise from above, if below of it is covered.
Loop circle(double height, int points, bool covered_below, double start = 0.0) {
  Loop loop;
  const double radius = std::sqrt(1 - height * height);
  for (int k = 0; k < points; ++k) {
    const double angle = start + (covered_below ? 1 : -1) * 2 * hsp::pi * k / points;
    loop.push_back({{radius * std::cos(angle), radius * std::sin(angle), height}, hsp::no_id});
  }
  return loop;
}

struct Pinched {
  PatchState state = PatchState::capacity;
  PatchState unpinched = PatchState::capacity;
  uint64_t needed = 0;
  double area = 0.0;
  int64_t euler = 0;
  bool sound = true;
  int between_others = 0;  // edges between two points that another patch has, too, but those of the border

  // Points above this height and below it are covered: by caps that have the same circle.
  explicit Pinched(const std::vector<Loop> &loops, double spacing = 0.5, double caps = 1.0, uint32_t room = 3000) {
    SphericalPatch patch;
    CarvedMemory memory;
    memory.carve(patch, room);
    std::vector<Vec3> vertices;
    std::vector<uint32_t> other;
    std::map<std::pair<uint32_t, uint32_t>, int> open;  // directed edges without another one the other way
    const auto add_loops = [&](bool count) {
      patch.begin(spacing);
      if (caps < 1.0) patch.keep_off({0, 0, 1}, caps);
      if (caps < 1.0) patch.keep_off({0, 0, -1}, -caps);
      uint32_t number = 0;
      for (const Loop &loop : loops) {
        patch.begin_loop(0);
        const auto first = number;
        for (const Point &point : loop) {
          const auto size = static_cast<uint32_t>(loop.size());
          patch.add({point.place, number, 0, {point.other, hsp::no_id}});
          if (count) {
            vertices.push_back(point.place);
            other.push_back(point.other);
            ++open[{first + (number - first + 1) % size, number}];  // what lies beyond the border
          }
          ++number;
        }
      }
    };
    add_loops(true);
    unpinched = patch.triangulate();
    add_loops(false);
    state = patch.triangulate(true);
    needed = patch.needed_points();
    if (state != PatchState::complete) return;
    const auto border = open;
    int64_t triangles = 0;
    patch.emit(
        [&](const Vec3 &direction) {
          vertices.push_back(1.0 / std::sqrt(dot(direction, direction)) * direction);
          other.push_back(hsp::no_id);
          return static_cast<uint32_t>(vertices.size() - 1);
        },
        [&](uint32_t, const uint32_t *c) {
          ++triangles;
          const Vec3 normal = cross(vertices[c[1]] - vertices[c[0]], vertices[c[2]] - vertices[c[0]]);
          area += 0.5 * std::sqrt(dot(normal, normal)) * (dot(normal, vertices[c[0]]) < 0.0 ? -1 : 1);
          for (int k = 0; k < 3; ++k) {
            const std::pair<uint32_t, uint32_t> edge(c[k], c[(k + 1) % 3]);
            const auto back = open.find({edge.second, edge.first});
            if (edge.first == edge.second || open.count(edge) > 0) sound = false;
            if (back != open.end()) {
              open.erase(back);
            } else {
              open[edge] = 1;
            }
            const bool both = other[edge.first] != hsp::no_id && other[edge.first] == other[edge.second];
            if (both && border.count({edge.second, edge.first}) == 0 && border.count(edge) == 0) ++between_others;
          }
        });
    sound = sound && open.empty();
    const auto edges = (3 * triangles + static_cast<int64_t>(border.size())) / 2;
    euler = static_cast<int64_t>(vertices.size()) - edges + triangles;
  }
};

// All checks of a patch that must be there.
void expect_patch(const Pinched &pinched, int64_t loops, double area, double tolerance) {
  ASSERT_EQ(pinched.state, PatchState::complete);
  EXPECT_TRUE(pinched.sound);
  EXPECT_EQ(pinched.euler, 2 - loops);
  EXPECT_NEAR(pinched.area, area, tolerance);
  EXPECT_EQ(pinched.between_others, 0);
}

// A patch that is not pinched comes out as usual.
TEST(PinchedPatch, OfBordersApart) {
  const Pinched cap({circle(0.5, 24, true)}, 0.3);
  EXPECT_EQ(cap.unpinched, PatchState::complete);
  expect_patch(cap, 1, 2 * hsp::pi * 0.5, 0.2);
}

// A belt between two circles that are the same: it has no area. With other points on one of them it seems to be on the
// wrong side of the other, which is noticed.
TEST(PinchedPatch, ABeltWithoutWidth) {
  const Pinched belt({circle(0.5, 24, true), circle(0.5, 24, false)}, 0.5, 0.5);
  EXPECT_EQ(belt.unpinched, PatchState::complete);
  expect_patch(belt, 2, 0.0, 1e-6);
  EXPECT_EQ(Pinched({circle(0.5, 24, true), circle(0.5, 23, false, 0.1)}, 0.5, 0.5).state, PatchState::too_coarse);
}

// Without caps it is all of the sphere but that belt, and in two parts: there is no such face.
TEST(PinchedPatch, NoPatchInTwoParts) {
  EXPECT_EQ(Pinched({circle(0.5, 24, true), circle(0.5, 24, false)}).state, PatchState::too_coarse);
}

// All of a sphere but a slit: the same loops the other way.
TEST(PinchedPatch, ASlit) {
  Loop slit;
  for (int k = 0; k < 6; ++k) slit.push_back({{std::cos(0.1 * k), std::sin(0.1 * k), 0.2}, hsp::no_id});
  for (int k = 4; k > 0; --k) slit.push_back({slit[static_cast<size_t>(k)].place, hsp::no_id});
  expect_patch(Pinched({slit}, 0.3), 1, 4 * hsp::pi, 0.4);
}

// Two caps that touch in a point of both: the patch outside is an annulus, pinched there. With the loops as one it is
// a disc.
TEST(PinchedPatch, CapsThatTouch) {
  const double r = 0.5;
  Loop left, right;
  for (int k = 0; k < 12; ++k) {
    const double angle = -2 * hsp::pi * k / 12;
    const double height = std::sqrt(1 - r * r);
    // Circles about (0.5, 0.866, 0) and (-0.5, 0.866, 0), which touch in (0, 1, 0).
    const double along = height, x = r;
    const Vec3 axis{x, along, 0.0}, u{along, -x, 0.0}, v{0.0, 0.0, 1.0};
    const Vec3 at = height * axis + r * (std::cos(angle) * -1.0) * u + r * std::sin(angle) * v;
    right.push_back({at, hsp::no_id});
    left.push_back({{-at.x, at.y, -at.z}, hsp::no_id});
  }
  const double outside = 4 * hsp::pi - 2 * 2 * hsp::pi * (1 - std::sqrt(1 - r * r));
  const Pinched annulus({right, left}, 0.4);
  EXPECT_EQ(annulus.unpinched, PatchState::complete);
  expect_patch(annulus, 2, outside, 0.8);
  Loop both = right;
  both.insert(both.end(), left.begin(), left.end());
  expect_patch(Pinched({both}, 0.4), 1, outside, 0.8);
}

// Points in one place, one after the other, of which another patch has some.
TEST(PinchedPatch, BordersWithoutLength) {
  for (const uint32_t other : {hsp::no_id, 7U}) {
    Loop loop = circle(0.0, 8, true);
    const Loop corners(3, Point{loop[3].place, other});
    loop.insert(loop.begin() + 3, corners.begin(), corners.end());
    loop[2].other = loop[6].other = other;
    expect_patch(Pinched({loop}), 1, 2 * hsp::pi, 0.8);
  }
}

// Of a ball that is a point: the directions say nothing, how many loops there are says all.
TEST(PinchedPatch, FacesWithoutExtent) {
  const Loop point(6, Point{{0, 0, 0}, hsp::no_id});
  expect_patch(Pinched({point}), 1, 0.0, 1e-9);
  expect_patch(Pinched({point, point}), 2, 0.0, 1e-9);
  expect_patch(Pinched({point, point, point}), 3, 0.0, 1e-9);
}

// Three borders on each other: which one is in the middle nothing tells.
TEST(PinchedPatch, ThreeOnEachOtherAreRefused) {
  EXPECT_EQ(Pinched({circle(0.5, 12, true), circle(0.5, 12, false), circle(0.5, 12, true)}, 0.5, 0.5).state,
            PatchState::too_coarse);
}

TEST(PinchedPatch, SaysHowManyPointsItNeeds) {
  const std::vector<Loop> loops = {circle(0.5, 24, true), circle(0.5, 24, false)};
  const Pinched enough(loops, 0.5, 0.5);
  ASSERT_EQ(enough.state, PatchState::complete);
  EXPECT_EQ(Pinched(loops, 0.5, 0.5, static_cast<uint32_t>(enough.needed)).state, PatchState::complete);
  EXPECT_EQ(Pinched(loops, 0.5, 0.5, static_cast<uint32_t>(enough.needed - 1)).state, PatchState::capacity);
  uint32_t room = 60;
  int retries = 0;
  for (; retries < 20; ++retries) {
    const Pinched with_room(loops, 0.5, 0.5, room);
    if (with_room.state == PatchState::complete) break;
    ASSERT_EQ(with_room.state, PatchState::capacity);
    ASSERT_GT(with_room.needed, room);
    room = static_cast<uint32_t>(with_room.needed);
  }
  EXPECT_LT(retries, 20);
}

}  // namespace
