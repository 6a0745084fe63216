// Balls in cubes, for balls that come and go: those of a cube are a chain in a hash table. A chain belongs to all cubes
// with its hash; each ball keeps the linear form of its cube, by which those of one cube are told from others.
#pragma once

#include "core/workspace.hpp"
#include "model/ball_set.hpp"
#include "model/grid_order.hpp"

namespace hsp {

class BallCells {
 public:
  void carve(Workspace &workspace, uint32_t balls);
  // No balls, of at most so many; cubes of such a side.
  void clear(uint32_t balls, int64_t side);

  void insert(uint32_t ball, const exact::Vector &centre);
  void remove(uint32_t ball);  // that is there
  int64_t side() const { return side_; }

  // Calls visit(ball) for every ball of the cubes that a box meets, each once, and maybe for a few others.
  template <class Visit>
  void visit_box(const exact::Vector &low, const exact::Vector &high, Visit visit) const {
    const CubeAxis axis(side_);
    const CubeCoordinates first = axis.cube_at(low), last = axis.cube_at(high);
    // Linear forms of different cubes are different as long as these are not far from each other.
    const int64_t cubes = (last.x - first.x + 1) * (last.y - first.y + 1) * (last.z - first.z + 1);
    if (cubes > balls_ || cubes > most_cubes) {
      for (uint32_t bucket = 0; bucket < used_; ++bucket) {
        for (uint32_t ball = first_[bucket]; ball != no_id; ball = next_[ball]) visit(ball);
      }
      return;
    }
    const uint64_t along_x = linear_hash({1, 0, 0});
    for (int64_t z = first.z; z <= last.z; ++z) {
      for (int64_t y = first.y; y <= last.y; ++y) {
        uint64_t linear = linear_hash({first.x, y, z});
        for (int64_t x = first.x; x <= last.x; ++x, linear += along_x) {
          for (uint32_t ball = first_[bucket_of(linear)]; ball != no_id; ball = next_[ball]) {
            if (linear_[ball] == linear) visit(ball);
          }
        }
      }
    }
  }

  // The same for every ball that may meet or touch the given one.
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
  // The same for two balls at once, which cost less than one after the other if they are near each other:
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
    // Certainly disjoint or certainly not, with the bound of caps.cpp; the others are asked exactly.
    const double squared = dx * dx + dy * dy + dz * dz, within = sum * sum;
    if (squared > within * (1.0 + 8 * unit_roundoff)) return false;
    return squared < within * (1.0 - 8 * unit_roundoff) ||
           exact::pair_relation(ball, balls.ball(j)) != exact::PairRelation::disjoint;
  }

 private:
  // Boxes that are asked for have at most seven cubes along each axis.
  static constexpr int64_t most_cubes = 512;
  uint32_t bucket_of(uint64_t linear) const { return CubeProbe(linear, used_).slot; }

  Span<uint32_t> first_;  // [buckets]
  Span<uint32_t> next_;   // [balls]
  Span<uint64_t> linear_;
  uint32_t used_ = 1;
  uint32_t balls_ = 0;
  int64_t side_ = 1;
};

}  // namespace hsp
