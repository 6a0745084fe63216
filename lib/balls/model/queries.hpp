// Intersection queries (Section 3): the balls that contain a point, and the balls that meet a ball.
#pragma once

#include "model/cube_grid.hpp"
#include "model/query_hits.hpp"

namespace hsp {

// A query position on the grid's lattice. Distances to it are decided exactly.
struct LatticeQuery {
  exact::Vector centre;
  int64_t radius;  // at most 2^51
};

inline QueryArrays query_arrays(const BallSet &balls) {
  return {balls.x.data(), balls.y.data(), balls.z.data(), balls.r.data(), balls.caller.data()};
}

// Hits in ascending order of the caller's indices. With more hits than capacity only their number is stored.
struct QueryResult {
  uint32_t *ids;
  uint32_t capacity;
  uint32_t hits;
};

// Rounds a position and a radius, in the caller's unit, to the lattice of the balls.
Status round_query(const BallSet &balls, const double *xyz, double radius, LatticeQuery &query);

// The balls that meet a query, by the levels of radii of a grid. False, and hits are of no use, if the grid has no
// levels, if there is not room for all hits, or if others than levels find them sooner.
bool find_by_levels(const CubeGrid &grid, const QueryBall &query, QueryHits &hits);

// The balls that contain the point. Looks at 8 cubes at most.
void find_balls_at_point(const CubeGrid &grid, const LatticeQuery &point, QueryResult &result);

// The balls that meet the query ball. Looks at 27 cubes for radii up to r_max; for larger ones at all cubes within
// reach or at all balls.
void find_balls_at_ball(const CubeGrid &grid, const LatticeQuery &query, QueryResult &result);

// Rounds a position and a radius, in the caller's unit, and finds the balls that meet that ball; a point has radius 0.
Status find_balls(const CubeGrid &grid, const double *xyz, double radius, QueryResult &result);

// Whether any ball meets the query ball.
bool any_ball_meets(const CubeGrid &grid, const LatticeQuery &query);

// The other balls that meet the ball with index `rank` in grid order.
void find_neighbours(const CubeGrid &grid, uint32_t rank, QueryResult &result);
// The same without the index of levels.
void find_neighbours_by_cubes(const CubeGrid &grid, uint32_t rank, QueryResult &result);

}  // namespace hsp
