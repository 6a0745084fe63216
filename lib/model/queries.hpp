// Intersection queries (Section 3): the balls that contain a point, and the balls that meet a ball.
#pragma once

#include "exact/exact_predicates.hpp"
#include "model/cube_grid.hpp"

namespace hsp {

// A query position on the grid's lattice. Distances to it are decided exactly.
struct LatticeQuery {
  exact::Vector centre;
  int64_t radius;  // at most 2^51
};

// Whether ball j comes within `radius` of the centre: |c_j - c| <= r_j + radius on the lattice. The differences and the
// sum are exact as doubles; the squares have a relative error below 4 units of 2^-53, so that only near-ties need
// integers.
class Reach {
 public:
  // Of ball i.
  Reach(const BallSet &balls, uint32_t i)
      : balls_(balls), x_(balls.x[i]), y_(balls.y[i]), z_(balls.z[i]), radius_(balls.r[i]) {}
  Reach(const BallSet &balls, const LatticeQuery &query)
      : balls_(balls),
        x_(static_cast<double>(query.centre.x)),
        y_(static_cast<double>(query.centre.y)),
        z_(static_cast<double>(query.centre.z)),
        radius_(static_cast<double>(query.radius)) {}

  bool meets(uint32_t j) const {
    const double dx = balls_.x[j] - x_;
    const double dy = balls_.y[j] - y_;
    const double dz = balls_.z[j] - z_;
    const double s = balls_.r[j] + radius_;
    const double within = s * s;
    const double excess = (dx * dx + dy * dy + dz * dz) - within;
    // This branch is nearly always taken. The sign itself cannot be predicted, so there must be no branch on it.
    if (std::fabs(excess) > 16 * unit_roundoff * within) [[likely]]
      return excess < 0.0;
    return exact::Exact::compare_distance(
               {static_cast<int64_t>(dx), static_cast<int64_t>(dy), static_cast<int64_t>(dz)},
               static_cast<int64_t>(s)) <= 0;
  }

 private:
  const BallSet &balls_;
  double x_, y_, z_, radius_;
};

// Hits in ascending order of the caller's indices. With more hits than capacity only their number is stored.
struct QueryResult {
  uint32_t *ids;
  uint32_t capacity;
  uint32_t hits;
};

// Rounds a position and radius to the lattice of the balls.
Status round_query(const BallSet &balls, const double *xyz, double radius, LatticeQuery &query);

// The balls that contain the point. Looks at 8 cubes at most.
void find_balls_at_point(const CubeGrid &grid, const LatticeQuery &point, QueryResult &result);

// The balls that meet the query ball. Looks at 27 cubes for radii up to r_max; for larger ones at all cubes within
// reach or at all balls.
void find_balls_at_ball(const CubeGrid &grid, const LatticeQuery &query, QueryResult &result);

// Whether any ball meets the query ball.
bool any_ball_meets(const CubeGrid &grid, const LatticeQuery &query);

// The balls other than itself that meet ball `place` of the grid's order.
void find_neighbours(const CubeGrid &grid, uint32_t place, QueryResult &result);

}  // namespace hsp
