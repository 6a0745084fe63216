#include "grid/queries.hpp"

#include "core/sorting.hpp"
#include "exact/exact_predicates.hpp"

namespace hsp {
namespace {

// Whether ball j comes within `radius` of the centre: |c_j - c| <= r_j + radius on the lattice. The differences and the
// sum are exact in double; the squares have a relative error below 4 units, so that only near-ties need integers.
class Reach {
 public:
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
    const double excess = (dx * dx + dy * dy + dz * dz) - s * s;
    const double doubt = 8 * unit_roundoff * s * s;
    if (excess < -doubt) return true;
    if (excess > 2 * doubt) return false;
    return exact::Exact::compare_distance(
               {static_cast<int64_t>(dx), static_cast<int64_t>(dy), static_cast<int64_t>(dz)},
               static_cast<int64_t>(s)) <= 0;
  }

 private:
  const BallSet &balls_;
  double x_, y_, z_, radius_;
};

// Calls visit(j) for every ball that can come within query.radius of the centre, until it returns false.
template <class Visit>
void visit_candidates(const CubeGrid &grid, const LatticeQuery &query, Visit visit) {
  const int64_t reach = query.radius + grid.balls().largest_radius;
  const exact::Vector &c = query.centre;
  const CubeCoordinates low = grid.cube_at({c.x - reach, c.y - reach, c.z - reach});
  const CubeCoordinates high = grid.cube_at({c.x + reach, c.y + reach, c.z + reach});
  const auto visit_range = [&](const BallRange &range) {
    for (uint32_t j = range.first; j < range.last; ++j) {
      if (!visit(j)) return false;
    }
    return true;
  };
  const double within_reach = static_cast<double>(high.x - low.x + 1) * static_cast<double>(high.y - low.y + 1) *
                              static_cast<double>(high.z - low.z + 1);
  if (within_reach > static_cast<double>(grid.cubes())) {
    visit_range({0, grid.balls().n});
    return;
  }
  for (int64_t z = low.z; z <= high.z; ++z) {
    for (int64_t y = low.y; y <= high.y; ++y) {
      for (int64_t x = low.x; x <= high.x; ++x) {
        const uint32_t cube = grid.table().find({x, y, z});
        if (cube != no_id && !visit_range(grid.balls_in(cube))) return;
      }
    }
  }
}

// Hits wait here, so that nothing is written to the caller's array before their number is known to fit. Longer answers
// are found twice.
constexpr uint32_t waiting_room = 128;

void collect(const CubeGrid &grid, const LatticeQuery &query, uint32_t excluded, QueryResult &result) {
  const BallSet &balls = grid.balls();
  const Reach reach(balls, query);
  uint32_t waiting[waiting_room];
  uint32_t hits = 0;
  visit_candidates(grid, query, [&](uint32_t j) {
    if (reach.meets(j) && j != excluded) {
      if (hits < waiting_room) waiting[hits] = balls.caller[j];
      ++hits;
    }
    return true;
  });
  result.hits = hits;
  if (hits > result.capacity) return;
  if (hits <= waiting_room) {
    for (uint32_t k = 0; k < hits; ++k) result.ids[k] = waiting[k];
  } else {
    uint32_t stored = 0;
    visit_candidates(grid, query, [&](uint32_t j) {
      if (reach.meets(j) && j != excluded) result.ids[stored++] = balls.caller[j];
      return true;
    });
  }
  sort_in_place(Span<uint32_t>(result.ids, hits), [](uint32_t a, uint32_t b) { return a < b; });
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
  query.centre = {exact::nearest(steps[0]), exact::nearest(steps[1]), exact::nearest(steps[2])};
  query.radius = exact::nearest(radius_steps);
  return Status::ok;
}

void find_balls_at_point(const CubeGrid &grid, const LatticeQuery &point, QueryResult &result) {
  collect(grid, {point.centre, 0}, no_id, result);
}

void find_balls_at_ball(const CubeGrid &grid, const LatticeQuery &query, QueryResult &result) {
  collect(grid, query, no_id, result);
}

bool any_ball_meets(const CubeGrid &grid, const LatticeQuery &query) {
  const Reach reach(grid.balls(), query);
  bool found = false;
  visit_candidates(grid, query, [&](uint32_t j) {
    found = reach.meets(j);
    return !found;
  });
  return found;
}

void find_neighbours(const CubeGrid &grid, uint32_t place, QueryResult &result) {
  const exact::LatticeBall ball = grid.balls().ball(place);
  collect(grid, {ball.centre, ball.radius}, place, result);
}

}  // namespace hsp
