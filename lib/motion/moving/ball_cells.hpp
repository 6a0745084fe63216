// Balls sorted by cubes, for balls that come and go. The balls of a cube are a chain. The first balls of cubes with the
// same hash are a digital search tree (cube_slots.hpp), as a rule of one cube. So for any choice of cubes the way to a
// chain is no longer than the number of bits of a cube's coordinates.
//
// Cubes are as wide as the largest ball. Where most balls are far smaller, these are in smaller cubes of their own.
#pragma once

#include "core/extremes.hpp"
#include "core/small_code.hpp"
#include "core/workspace.hpp"
#include "model/ball_set.hpp"
#include "model/grid_order.hpp"
#include "model/meeting.hpp"

namespace hsp {

class BallCells {
 public:
  void carve(Workspace &workspace, uint32_t balls);
  // Removes all balls. From now on there are at most so many, with ids below that. Cubes have this side, which is at
  // least twice the radius of each ball; balls of radii up to largest_small are in cubes of twice that radius. 0: all
  // cubes are alike.
  void clear(uint32_t balls, int64_t side, int64_t largest_small);

  void insert(uint32_t ball, const exact::LatticeBall &placed);
  void remove(uint32_t ball);  // a ball that is there
  int64_t side() const { return side_[0]; }
  // The side of the cubes that have the balls of a radius.
  int64_t side_for(int64_t radius) const { return side_[size_of(radius)]; }
  bool has_small_cubes() const { return !small_code && side_[1] != 0; }

  // Calls visit(ball) once for every ball that may meet or touch a ball of radius `reach`, or less, whose centre is in
  // a box. If there are more cubes to look in than balls, calls it for every ball of that size.
  template <class Visit>
  void visit_near(const exact::Vector &low, const exact::Vector &high, int64_t reach, Visit visit) const {
    for (uint32_t size = 0; size < sizes; ++size) {
      if (count_[size] != 0) visit_size(size, low, high, reach + side_[size] / 2, visit);
    }
  }
  // Calls visit(other) for all balls of the cube of a ball, itself among them.
  template <class Visit>
  void visit_cube_of(uint32_t ball, Visit visit) const {
    for (uint32_t other = first_in(cube_[ball], linear_hash(cube_[ball])); other != no_id; other = next_[other])
      visit(other);
  }
  // The largest number of first balls that are looked at on the way to the chain of a cube.
  uint32_t longest_way() const;

  // Calls visit(other) for every ball that may meet or touch the given one.
  template <class Visit>
  void visit_around(const exact::LatticeBall &ball, Visit visit) const {
    visit_near(ball.centre, ball.centre, ball.radius, visit);
  }
  // Calls visit(other) for every ball of the set that meets or touches the given one; it may itself be among them.
  template <class Visit>
  void visit_meeting(const BallSet &balls, const exact::LatticeBall &ball, Visit visit) const {
    visit_around(ball, [&](uint32_t j) {
      if (is_met(balls, ball, j)) visit(j);
    });
  }
  // The same for two balls at once, which costs less than one after the other if they are near each other. Calls
  // visit(other, whether it meets the first one).
  template <class Visit>
  void visit_meeting(const BallSet &balls, const exact::LatticeBall &a, const exact::LatticeBall &b,
                     Visit visit) const {
    const exact::Vector &p = a.centre, &q = b.centre;
    visit_near({smaller_of(p.x, q.x), smaller_of(p.y, q.y), smaller_of(p.z, q.z)},
               {larger_of(p.x, q.x), larger_of(p.y, q.y), larger_of(p.z, q.z)}, larger_of(a.radius, b.radius),
               [&](uint32_t j) {
                 if (is_met(balls, a, j)) {
                   visit(j, true);
                 } else if (is_met(balls, b, j)) {
                   visit(j, false);
                 }
               });
  }

  // Whether ball j meets or touches the given one.
  static bool is_met(const BallSet &balls, const exact::LatticeBall &ball, uint32_t j) {
    const exact::Vector &c = ball.centre;
    const double dx = balls.x[j] - static_cast<double>(c.x), dy = balls.y[j] - static_cast<double>(c.y),
                 dz = balls.z[j] - static_cast<double>(c.z), sum = balls.r[j] + static_cast<double>(ball.radius);
    return meet(dx, dy, dz, sum);
  }

 private:
  // Sizes of cubes: 0 those as wide as the largest ball, 1 small ones. Small cubes are counted from here on along x, so
  // that no cube of another size has their coordinates. Small code makes none.
  static constexpr uint32_t sizes = small_code ? 1 : 2;
  static constexpr int64_t first_small = INT64_C(1) << 60;

  uint32_t size_of(int64_t radius) const { return has_small_cubes() && 2 * radius <= side_[1] ? 1 : 0; }
  static uint32_t size_of(const CubeCoordinates &cube) { return !small_code && cube.x >= first_small / 2 ? 1 : 0; }
  CubeCoordinates cube_at(uint32_t size, const exact::Vector &point) const {
    CubeCoordinates cube = CubeAxis(side_[size]).cube_at(point);
    if (!small_code && size != 0) cube.x += first_small;
    return cube;
  }
  template <class Visit>
  void visit_size(uint32_t size, const exact::Vector &low, const exact::Vector &high, int64_t around,
                  Visit visit) const {
    const CubeCoordinates first = cube_at(size, {low.x - around, low.y - around, low.z - around}),
                          last = cube_at(size, {high.x + around, high.y + around, high.z + around});
    const double cubes = static_cast<double>(last.x - first.x + 1) * static_cast<double>(last.y - first.y + 1) *
                         static_cast<double>(last.z - first.z + 1);
    if (cubes > static_cast<double>(balls_)) {
      for (uint32_t ball = 0; ball < balls_; ++ball) {
        if (is_there(ball) && size_of(cube_[ball]) == size) visit(ball);
      }
      return;
    }
    const uint64_t along_x = linear_hash({1, 0, 0});
    for (int64_t z = first.z; z <= last.z; ++z) {
      for (int64_t y = first.y; y <= last.y; ++y) {
        uint64_t linear = linear_hash({first.x, y, z});
        for (int64_t x = first.x; x <= last.x; ++x, linear += along_x) {
          for (uint32_t ball = first_in({x, y, z}, linear); ball != no_id; ball = next_[ball]) visit(ball);
        }
      }
    }
  }
  uint32_t bucket_of(uint64_t linear) const { return CubeProbe(linear, used_).slot; }
  uint32_t first_in(const CubeCoordinates &cube, uint64_t linear) const {
    uint32_t ball = first_[bucket_of(linear)];
    for (CubePath path(cube); ball != no_id && !(cube_[ball] == cube);) ball = link_[path.link_of(ball)];
    return ball;
  }
  uint32_t &link_to(const CubeCoordinates &cube);
  bool is_there(uint32_t ball) const { return next_[ball] != ball; }

  Span<uint32_t> first_;  // [buckets] the root of the tree
  Span<uint32_t> link_;   // [2 balls] of the first ball of a cube: both balls below it in the tree
  Span<uint32_t> next_;   // [balls] the next ball of the same cube; the ball itself if it is in none
  Span<CubeCoordinates> cube_;
  uint32_t used_ = 1;
  uint32_t balls_ = 0;
  uint32_t count_[2] = {};    // how many balls there are
  int64_t side_[2] = {1, 0};  // 0: there are no small cubes
};

}  // namespace hsp
