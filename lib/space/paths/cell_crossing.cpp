#include "paths/cell_crossing.hpp"

#include "paths/free_segments.hpp"

namespace hsp {
namespace {

constexpr double unreached = std::numeric_limits<double>::infinity();

bool is_outside_all(const BallSet &balls, Span<const uint32_t> members, const exact::Vector &a,
                    const exact::Vector &b) {
  for (const uint32_t ball : members) {
    if (!is_outside_ball(balls, ball, a, b)) return false;
  }
  return true;
}

}  // namespace

void CellCrossing::carve(Workspace &workspace, uint32_t cube_balls) {
  power_cell_.carve(workspace, cube_balls);
  stops_ = workspace.take<Stop>(PowerPolytope::most_vertices(cube_balls));
}

void CellCrossing::add(const BallSet &balls, const FreeSpace &space, uint32_t cell, const exact::Vector &from,
                       const exact::Vector &to, FixedVector<exact::Vector> &points) {
  const FreeCell &record = space.cell(cell);
  if (record.kind != CellKind::at_ball) return;
  const Span<const uint32_t> members = space.cover.balls(record.cube);
  const bool is_straight = is_outside_ball(balls, record.ball, from, to);
  if (is_straight && is_outside_all(balls, members, from, to)) return;
  uint32_t member = 0;
  while (members[member] != record.ball) ++member;
  power_cell_.enter(balls, CubeFrame(space.cover.cube(record.cube), space.side), members);
  power_cell_.drop_dominated();
  power_cell_.build(member);
  power_cell_.find_free_parts();
  for (uint32_t v = 0; v < power_cell_.polytope().size(); ++v) {
    stops_[v].at = power_cell_.frame().rounded(power_cell_.position(v));
  }

  const uint32_t part = part_of_cell(space, cell);
  uint32_t stop = first_stop(balls, members, part, Ends::outside_all, from, to);
  if (stop == no_id && !is_straight) stop = first_stop(balls, members, part, Ends::outside_ball, from, to);
  if (stop == no_id && !is_straight) stop = first_stop(balls, members, part, Ends::least_deep, from, to);
  for (; stop != no_id; stop = stops_[stop].next) points.push(stops_[stop].at);
}

// The part is found by one of its vertices.
uint32_t CellCrossing::part_of_cell(const FreeSpace &space, uint32_t cell) const {
  const IdRange landmarks = space.landmarks_of(cell);
  if (landmarks.empty()) return 0;
  const uint32_t *const code = space.landmarks[landmarks.first].code;
  const PowerPolytope &polytope = power_cell_.polytope();
  const auto is_one = [&](uint32_t plane) {
    const uint32_t own = power_cell_.code_of(plane);
    return own == code[0] || own == code[1] || own == code[2];
  };
  for (uint32_t v = 0; v < polytope.size(); ++v) {
    const uint32_t *const plane = polytope[v].plane;
    if (is_one(plane[0]) && is_one(plane[1]) && is_one(plane[2])) return power_cell_.part_of(v);
  }
  return 0;  // not reached
}

// The search goes from the last point backwards, so that `next` leads along the way.
uint32_t CellCrossing::first_stop(const BallSet &balls, Span<const uint32_t> members, uint32_t part, Ends ends,
                                  const exact::Vector &from, const exact::Vector &to) {
  const PowerPolytope &polytope = power_cell_.polytope();
  const uint32_t size = polytope.size(), ball = power_cell_.ball();
  for (uint32_t v = 0; v < size; ++v) {
    stops_[v] = {stops_[v].at, unreached, no_id, power_cell_.part_of(v) == no_id};
  }
  const auto nearest_in_part = [&](const exact::Vector &end) {
    uint32_t best = no_id;
    double most = -unreached;
    for (uint32_t v = 0; v < size; ++v) {
      if (power_cell_.part_of(v) != part) continue;
      const double clearance = clearance_of_ball(balls, ball, end, stops_[v].at);
      if (!(clearance > most)) continue;
      most = clearance;
      best = v;
    }
    return best;
  };
  const bool rounded = ends == Ends::least_deep;
  const auto is_outside = [&](const exact::Vector &a, const exact::Vector &b) {
    return is_outside_ball(balls, ball, a, b) && (ends == Ends::outside_ball || is_outside_all(balls, members, a, b));
  };
  const uint32_t begin = rounded ? nearest_in_part(from) : no_id, end = rounded ? nearest_in_part(to) : no_id;
  for (uint32_t v = 0; v < size; ++v) {
    Stop &stop = stops_[v];
    const bool is_last = rounded ? v == end : !stop.done && is_outside(stop.at, to);
    if (is_last) stop.way = distance(stop.at, to);
  }
  uint32_t best = no_id;
  double least = unreached;
  for (;;) {
    uint32_t here = no_id;
    for (uint32_t v = 0; v < size; ++v) {
      if (!stops_[v].done && stops_[v].way < unreached && (here == no_id || stops_[v].way < stops_[here].way)) here = v;
    }
    if (here == no_id || stops_[here].way >= least) break;
    stops_[here].done = true;
    const double whole = stops_[here].way + distance(from, stops_[here].at);
    if (whole < least && (rounded ? here == begin : is_outside(from, stops_[here].at))) {
      least = whole;
      best = here;
    }
    for (uint32_t k = 0; k < 3; ++k) {
      Stop &there = stops_[polytope[here].neighbour(k)];
      const double way = stops_[here].way + distance(stops_[here].at, there.at);
      if (there.done || !power_cell_.is_free_edge(here, k) || !(way < there.way)) continue;
      there.way = way;
      there.next = here;
    }
  }
  return best;
}

}  // namespace hsp
