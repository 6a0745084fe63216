// Finds the balls at a point, or at a ball, in the cubes that can hold them.
//
// As an example cubes of side 10 and a largest radius of 5, along one axis. A ball that contains a point has its centre
// at most 5 away:
//   point   its cube   in it at      centres from    cubes
//     13        1          3         8 to 18         0 and 1      3 < 10 - 5: the lower neighbour
//     17        1          7         12 to 22        1 and 2      7 >= 5: the upper one
// So a point has two cubes along each axis, eight in all. They are in four rows, for each of which the hash table is
// asked.
#include "model/queries.hpp"

#include "core/extremes.hpp"
#include "core/small_code.hpp"
#include "core/sorting.hpp"

namespace hsp {
namespace {

// The cubes from `low` to `high`.
struct CubeBox {
  CubeCoordinates low, high;
};

// The cubes of every ball that can contain the point. Such a ball's centre is at most r_max away, half the side of a
// cube. So along each axis it lies in the point's cube or in the neighbour beyond the nearer wall.
CubeBox cubes_at_point(const CubeGrid &grid, const exact::Vector &point) {
  const CubeCoordinates own = grid.cube_at(point);
  const int64_t half = grid.side() - grid.balls().largest_radius;
  const auto lower_neighbour = [&grid, half](int64_t value, int64_t cube) {
    return static_cast<int64_t>(value - cube * grid.side() < half);
  };
  const int64_t x = own.x - lower_neighbour(point.x, own.x);
  const int64_t y = own.y - lower_neighbour(point.y, own.y);
  const int64_t z = own.z - lower_neighbour(point.z, own.z);
  return {{x, y, z}, {x + 1, y + 1, z + 1}};
}

// The cubes of every ball that can come within query.radius of the centre.
CubeBox cubes_at_ball(const CubeGrid &grid, const LatticeQuery &query) {
  const int64_t reach = query.radius + grid.balls().largest_radius;
  const exact::Vector &c = query.centre;
  return {grid.cube_at({c.x - reach, c.y - reach, c.z - reach}), grid.cube_at({c.x + reach, c.y + reach, c.z + reach})};
}

// The box of a query up to the size of the largest ball has no more rows.
constexpr uint32_t few_rows = 9;

bool has_few_rows(const CubeBox &box) {
  const int64_t y = box.high.y - box.low.y, z = box.high.z - box.low.z;
  return y < 3 && z < 3;
}

// Calls visit(range) for all balls of the box, until it returns false. The hash table is asked for each row. If the box
// has more cubes than the grid, all balls are one range.
template <class Visit>
void visit_rows(const CubeGrid &grid, const CubeBox &box, Visit visit) {
  const CubeCoordinates &low = box.low, &high = box.high;
  const double cubes = static_cast<double>(high.x - low.x + 1) * static_cast<double>(high.y - low.y + 1) *
                       static_cast<double>(high.z - low.z + 1);
  if (cubes > 27.0 && cubes > static_cast<double>(grid.cubes())) {
    visit(BallRange{0, grid.balls().n});
    return;
  }
  for (int64_t z = low.z; z <= high.z; ++z) {
    for (int64_t y = low.y; y <= high.y; ++y) {
      if (!visit(grid.balls_in_row(low.x, high.x, y, z))) return;
    }
  }
}

// Calls visit(part) for parts of a range with no more balls than there is room for hits, until it returns false.
template <class Visit>
bool visit_parts(const BallRange &range, Visit visit) {
  for (uint32_t first = range.first; first < range.last;) {
    const uint32_t last = range.last - first > QueryHits::room ? first + QueryHits::room : range.last;
    if (!visit(BallRange{first, last})) return false;
    first = last;
  }
  return true;
}

// The cubes of a box that are also in the box around all cubes of the grid.
CubeBox common_cubes(const CubeGrid &grid, const CubeBox &box) {
  if (grid.cubes() == 0) return {{0, 0, 0}, {-1, -1, -1}};
  const CubeCoordinates &low = grid.cube_list().low(), &high = grid.cube_list().high();
  return {{larger_of(box.low.x, low.x), larger_of(box.low.y, low.y), larger_of(box.low.z, low.z)},
          {smaller_of(box.high.x, high.x), smaller_of(box.high.y, high.y), smaller_of(box.high.z, high.z)}};
}

QueryBall as_doubles(const LatticeQuery &query, uint32_t excluded) {
  return {static_cast<double>(query.centre.x), static_cast<double>(query.centre.y), static_cast<double>(query.centre.z),
          static_cast<double>(query.radius), excluded};
}

// Writes the hits to the result; they are complete, and there is room for them.
void write_ascending(const CubeGrid &grid, const QueryHits &hits, QueryResult &result) {
  if constexpr (has_lanes) {
    if (grid.in_lanes()) return write_ascending_in_lanes(grid.target(), hits, result.ids, result.capacity);
  }
  write_ascending(hits, result.ids);
}

class HitFinder {
 public:
  HitFinder(const CubeGrid &grid, const LatticeQuery &query, uint32_t excluded)
      : grid_(grid), balls_(query_arrays(grid.balls())), query_(as_doubles(query, excluded)) {
    hits_.count = 0;
  }

  // Adds the hits in the box.
  void find(const CubeBox &box) {
    if (!grid_.rows().is_there()) {
      visit_rows(grid_, box, [this](const BallRange &row) {
        if (!row.empty()) find(&row, 1);
        return true;
      });
      return;
    }
    BallRange rows[few_rows];
    if (has_few_rows(box)) return find(rows, grid_.rows().find(box.low, box.high, {rows, few_rows}));
    const auto [low, high] = common_cubes(grid_, box);
    for (int64_t z = low.z; z <= high.z; ++z) {
      for (int64_t y = low.y; y <= high.y; y += few_rows) {
        const CubeCoordinates last{high.x, smaller_of(y + few_rows - 1, high.y), z};
        const uint32_t count = grid_.rows().find({low.x, y, z}, last, {rows, few_rows});
        if (count > 0) find(rows, count);
      }
    }
  }
  const QueryHits &hits() const { return hits_; }
  // The hits of this range alone.
  const QueryHits &hits_among(const BallRange &range) {
    hits_.count = 0;
    find(&range, 1);
    return hits_;
  }

 private:
  void find(const BallRange *ranges, uint32_t count) {
    if constexpr (has_lanes) {
      if (grid_.in_lanes()) return add_hits_in_lanes(grid_.target(), balls_, query_, ranges, count, hits_);
    }
    add_hits(balls_, query_, ranges, count, hits_);
  }

  const CubeGrid &grid_;
  const QueryArrays balls_;
  const QueryBall query_;
  QueryHits hits_;
};

// Finds the hits by the index of levels. False if there are more hits than QueryHits has room for. Out of line, as most
// sets have no such index.
[[gnu::noinline, gnu::cold]] bool collect_by_levels(const CubeGrid &grid, const LatticeQuery &query, uint32_t excluded,
                                                    QueryResult &result) {
  QueryHits hits;
  if (!find_by_levels(grid, as_doubles(query, excluded), hits)) return false;
  result.hits = hits.count;
  if (result.hits <= result.capacity) write_ascending(grid, hits, result);
  return true;
}

// More hits than there is room for are found a second time, straight into the caller's array.
[[gnu::cold]] void store_by_parts(const CubeGrid &grid, const CubeBox &box, HitFinder &finder, QueryResult &result) {
  uint32_t stored = 0;
  visit_rows(grid, box, [&](const BallRange &row) {
    return visit_parts(row, [&](const BallRange &part) {
      const QueryHits &hits = finder.hits_among(part);
      for (uint32_t k = 0; k < hits.count; ++k) result.ids[stored++] = hits.ids[k];
      return true;
    });
  });
  sort_ascending(Span<uint32_t>(result.ids, result.hits));
}

// Writes nothing to the caller's array before it is known that all hits fit. Not inlined, so that the hits of both ways
// to search do not lie on the stack together.
[[gnu::noinline]] void collect_by_cubes(const CubeGrid &grid, const LatticeQuery &query, uint32_t excluded,
                                        const CubeBox &box, QueryResult &result) {
  HitFinder finder(grid, query, excluded);
  finder.find(box);
  result.hits = finder.hits().count;
  if (result.hits > result.capacity) return;
  if (result.hits <= QueryHits::room) return write_ascending(grid, finder.hits(), result);
  store_by_parts(grid, box, finder, result);
}

void collect(const CubeGrid &grid, const LatticeQuery &query, uint32_t excluded, const CubeBox &box,
             QueryResult &result) {
  if (grid.levels() != nullptr && collect_by_levels(grid, query, excluded, result)) return;
  collect_by_cubes(grid, query, excluded, box, result);
}

// 0 if no ball meets the query; no_id if the index does not tell; else some number above 0.
[[gnu::noinline, gnu::cold]] uint32_t hits_by_levels(const CubeGrid &grid, const LatticeQuery &query) {
  return grid.levels()->find(as_doubles(query, no_id), nullptr, 0);
}

// Why a query is refused: not finite comes before negative, and negative before too large.
Status why_refused(const double *xyz, double radius) {
  if (!is_finite(radius)) return Status::not_finite;
  for (int axis = 0; axis < 3; ++axis) {
    if (!is_finite(xyz[axis])) return Status::not_finite;
  }
  return radius < 0.0 ? Status::negative : Status::range;
}

}  // namespace

Status round_query(const BallSet &balls, const double *xyz, double radius, LatticeQuery &query) {
  const double radius_steps = balls.lattice.steps(radius);
  // False for NaN, too.
  const bool good = (radius >= 0.0) & (radius_steps <= exact::query_radius_limit);
  if (!balls.lattice.round(xyz, query.centre) || !good) return why_refused(xyz, radius);
  query.radius = nearest(radius_steps);
  return Status::ok;
}

bool find_by_levels(const CubeGrid &grid, const QueryBall &query, QueryHits &hits) {
  const RadiusLevels *const levels = grid.levels();
  if (levels == nullptr) return false;
  QueryBall own = query;
  if (query.excluded != no_id) own.excluded = grid.grid_index(query.excluded);
  hits.count = levels->find(own, hits.ids, QueryHits::room);
  if (hits.count > QueryHits::room) return false;
  for (uint32_t k = 0; k < hits.count; ++k) hits.ids[k] = grid.balls().caller[hits.ids[k]];
  return true;
}

void find_balls_at_point(const CubeGrid &grid, const LatticeQuery &point, QueryResult &result) {
  collect(grid, {point.centre, 0}, no_id, cubes_at_point(grid, point.centre), result);
}

void find_balls_at_ball(const CubeGrid &grid, const LatticeQuery &query, QueryResult &result) {
  collect(grid, query, no_id, cubes_at_ball(grid, query), result);
}

Status find_balls(const CubeGrid &grid, const double *xyz, double radius, QueryResult &result) {
  if constexpr (has_lanes) {
    if (grid.in_lanes() && find_balls_in_lanes(grid.target(), *grid.queries(), query_arrays(grid.balls()), xyz, radius,
                                               result.ids, result.capacity, result.hits)) {
      return Status::ok;
    }
  }
  LatticeQuery query;
  if (const Status status = round_query(grid.balls(), xyz, radius, query); status != Status::ok) return status;
  if (!small_code && query.radius == 0) {
    find_balls_at_point(grid, query, result);
  } else {
    find_balls_at_ball(grid, query, result);
  }
  return Status::ok;
}

bool any_ball_meets(const CubeGrid &grid, const LatticeQuery &query) {
  if (grid.levels() != nullptr) {
    const uint32_t hits = hits_by_levels(grid, query);
    if (hits != no_id) return hits > 0;
  }
  HitFinder finder(grid, query, no_id);
  bool found = false;
  visit_rows(grid, cubes_at_ball(grid, query), [&](const BallRange &row) {
    found = !visit_parts(row, [&](const BallRange &part) { return finder.hits_among(part).count == 0; });
    return !found;
  });
  return found;
}

void find_neighbours(const CubeGrid &grid, uint32_t rank, QueryResult &result) {
  if constexpr (has_lanes) {
    if (grid.in_lanes() && find_neighbours_in_lanes(grid.target(), *grid.queries(), query_arrays(grid.balls()), rank,
                                                    result.ids, result.capacity, result.hits)) {
      return;
    }
  }
  const exact::LatticeBall ball = grid.balls().ball(rank);
  const LatticeQuery query{ball.centre, ball.radius};
  collect(grid, query, ball.index, cubes_at_ball(grid, query), result);
}

void find_neighbours_by_cubes(const CubeGrid &grid, uint32_t rank, QueryResult &result) {
  const exact::LatticeBall ball = grid.balls().ball(rank);
  const LatticeQuery query{ball.centre, ball.radius};
  collect_by_cubes(grid, query, ball.index, cubes_at_ball(grid, query), result);
}

}  // namespace hsp
