#include "model/queries.hpp"

#include "core/sorting.hpp"

namespace hsp {
namespace {

template <class Visit>
bool visit_range(const BallRange &range, Visit &visit) {
  for (uint32_t j = range.first; j < range.last; ++j) {
    if (!visit(j)) return false;
  }
  return true;
}

// Calls visit(j) for every ball that can contain the point, until it returns false. Such a ball's centre is at most
// r_max away, half the side of a cube. So along each axis it lies in the point's cube or in the neighbour beyond the
// nearer wall.
template <class Visit>
void visit_point_candidates(const CubeGrid &grid, const exact::Vector &point, Visit visit) {
  const CubeCoordinates own = grid.cube_at(point);
  const int64_t half = grid.side() - grid.balls().largest_radius;
  const auto lower_neighbour = [&grid, half](int64_t value, int64_t cube) {
    return value - cube * grid.side() < half ? int64_t{1} : int64_t{0};
  };
  const int64_t x = own.x - lower_neighbour(point.x, own.x);
  const int64_t y = own.y - lower_neighbour(point.y, own.y);
  const int64_t z = own.z - lower_neighbour(point.z, own.z);
  for (int row = 0; row < 4; ++row) {
    if (!visit_range(grid.balls_in_row(x, x + 1, y + (row & 1), z + (row >> 1)), visit)) return;
  }
}

// Calls visit(j) for every ball that can come within query.radius of the centre, until it returns false.
template <class Visit>
void visit_ball_candidates(const CubeGrid &grid, const LatticeQuery &query, Visit visit) {
  const int64_t reach = query.radius + grid.balls().largest_radius;
  const exact::Vector &c = query.centre;
  const CubeCoordinates low = grid.cube_at({c.x - reach, c.y - reach, c.z - reach});
  const CubeCoordinates high = grid.cube_at({c.x + reach, c.y + reach, c.z + reach});
  const double within_reach = static_cast<double>(high.x - low.x + 1) * static_cast<double>(high.y - low.y + 1) *
                              static_cast<double>(high.z - low.z + 1);
  if (within_reach > 27.0 && within_reach > static_cast<double>(grid.cubes())) {
    visit_range({0, grid.balls().n}, visit);
    return;
  }
  for (int64_t z = low.z; z <= high.z; ++z) {
    for (int64_t y = low.y; y <= high.y; ++y) {
      if (!visit_range(grid.balls_in_row(low.x, high.x, y, z), visit)) return;
    }
  }
}

// Hits are buffered, so that nothing is written to the caller's array before it is known that all fit. More hits than
// the buffer holds are found a second time.
constexpr uint32_t hit_buffer_size = 128;
constexpr uint32_t few_hits = 24;

// candidates(visit) calls visit(j) for all balls that may be hits.
template <class Candidates>
void collect(const BallSet &balls, const LatticeQuery &query, uint32_t excluded, Candidates candidates,
             QueryResult &result) {
  const Reach reach(balls, query);
  uint32_t hit_buffer[hit_buffer_size + 1];
  uint32_t hits = 0;
  candidates([&](uint32_t j) {
    // Always stored, but kept only if it is a hit: a branch here could not be predicted.
    hit_buffer[hits < hit_buffer_size ? hits : hit_buffer_size] = balls.caller[j];
    hits += static_cast<uint32_t>(reach.meets(j)) & static_cast<uint32_t>(j != excluded);
    return true;
  });
  result.hits = hits;
  if (hits > result.capacity) return;
  if (hits <= few_hits) {
    // The position of a hit is the number of smaller ones: a loop without branches on the values.
    for (uint32_t k = 0; k < hits; ++k) {
      uint32_t smaller = 0;
      for (uint32_t other = 0; other < hits; ++other) smaller += hit_buffer[other] < hit_buffer[k] ? 1U : 0U;
      result.ids[smaller] = hit_buffer[k];
    }
    return;
  }
  if (hits <= hit_buffer_size) {
    for (uint32_t k = 0; k < hits; ++k) result.ids[k] = hit_buffer[k];
  } else {
    uint32_t stored = 0;
    candidates([&](uint32_t j) {
      if (reach.meets(j) && j != excluded) result.ids[stored++] = balls.caller[j];
      return true;
    });
  }
  sort_in_place(Span<uint32_t>(result.ids, hits), [](uint32_t a, uint32_t b) { return a < b; });
}

void collect_at_ball(const CubeGrid &grid, const LatticeQuery &query, uint32_t excluded, QueryResult &result) {
  collect(
      grid.balls(), query, excluded, [&](auto visit) { visit_ball_candidates(grid, query, visit); }, result);
}

}  // namespace

Status round_query(const BallSet &balls, const double *xyz, double radius, LatticeQuery &query) {
  double steps[3];
  if (!is_finite(radius)) return Status::not_finite;
  for (int axis = 0; axis < 3; ++axis) {
    if (!is_finite(xyz[axis])) return Status::not_finite;
  }
  if (radius < 0.0) return Status::negative;
  for (int axis = 0; axis < 3; ++axis) {
    steps[axis] = balls.lattice.steps(xyz[axis]);
    if (!(steps[axis] <= exact::coordinate_limit && steps[axis] >= -exact::coordinate_limit)) return Status::range;
  }
  const double radius_steps = balls.lattice.steps(radius);
  if (!(radius_steps <= exact::query_radius_limit)) return Status::range;
  query.centre = {nearest(steps[0]), nearest(steps[1]), nearest(steps[2])};
  query.radius = nearest(radius_steps);
  return Status::ok;
}

void find_balls_at_point(const CubeGrid &grid, const LatticeQuery &point, QueryResult &result) {
  collect(
      grid.balls(), {point.centre, 0}, no_id, [&](auto visit) { visit_point_candidates(grid, point.centre, visit); },
      result);
}

void find_balls_at_ball(const CubeGrid &grid, const LatticeQuery &query, QueryResult &result) {
  collect_at_ball(grid, query, no_id, result);
}

bool any_ball_meets(const CubeGrid &grid, const LatticeQuery &query) {
  const Reach reach(grid.balls(), query);
  bool found = false;
  visit_ball_candidates(grid, query, [&](uint32_t j) {
    found = reach.meets(j);
    return !found;
  });
  return found;
}

void find_neighbours(const CubeGrid &grid, uint32_t place, QueryResult &result) {
  const exact::LatticeBall ball = grid.balls().ball(place);
  collect_at_ball(grid, {ball.centre, ball.radius}, place, result);
}

}  // namespace hsp
