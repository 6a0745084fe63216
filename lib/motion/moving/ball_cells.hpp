// Balls sorted by cubes, for balls that come and go. The balls of a cube are a chain. The first balls of cubes with the
// same hash are a digital search tree (cube_slots.hpp), as a rule of one cube. So for any choice of cubes the way to a
// chain is no longer than the number of bits of a cube's coordinates.
#pragma once

#include "core/workspace.hpp"
#include "model/ball_set.hpp"
#include "model/grid_order.hpp"
#include "model/meeting.hpp"

namespace hsp {

class BallCells {
 public:
  void carve(Workspace &workspace, uint32_t balls);
  // Removes all balls. From now on there are at most so many, with ids below that, and cubes of this side.
  void clear(uint32_t balls, int64_t side);

  void insert(uint32_t ball, const exact::Vector &centre);
  void remove(uint32_t ball);  // a ball that is there
  int64_t side() const { return side_; }

  // Calls visit(ball) once for every ball in the cubes that a box meets. If the box has more cubes than there are
  // balls, calls it for every ball.
  template <class Visit>
  void visit_box(const exact::Vector &low, const exact::Vector &high, Visit visit) const {
    const CubeAxis axis(side_);
    const CubeCoordinates first = axis.cube_at(low), last = axis.cube_at(high);
    const int64_t cubes = (last.x - first.x + 1) * (last.y - first.y + 1) * (last.z - first.z + 1);
    if (cubes > balls_) {
      for (uint32_t ball = 0; ball < balls_; ++ball) {
        if (is_there(ball)) visit(ball);
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
  // The largest number of first balls that are looked at on the way to the chain of a cube.
  uint32_t longest_way() const;

  // Calls visit(other) for every ball that may meet or touch the given one.
  template <class Visit>
  void visit_around(const exact::LatticeBall &ball, Visit visit) const {
    const int64_t reach = ball.radius + side_ / 2;
    const exact::Vector &c = ball.centre;
    visit_box({c.x - reach, c.y - reach, c.z - reach}, {c.x + reach, c.y + reach, c.z + reach}, visit);
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
    const int64_t reach = (a.radius > b.radius ? a.radius : b.radius) + side_ / 2;
    const auto low = [reach](int64_t p, int64_t q) { return (p < q ? p : q) - reach; };
    const auto high = [reach](int64_t p, int64_t q) { return (p > q ? p : q) + reach; };
    const exact::Vector &p = a.centre, &q = b.centre;
    visit_box({low(p.x, q.x), low(p.y, q.y), low(p.z, q.z)}, {high(p.x, q.x), high(p.y, q.y), high(p.z, q.z)},
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
  int64_t side_ = 1;
};

}  // namespace hsp
