#include "pockets/tunnel.hpp"

#include <initializer_list>
#include <utility>

#include "core/extremes.hpp"
#include "core/rows.hpp"
#include "core/sorting.hpp"

namespace hsp {
namespace {

// The vector of a shift. Without a box the shift is 0.
Vec3 translation(const PoresBuilder &pores, const BoxShift &shift) {
  return shift.is_zero() ? Vec3{0.0, 0.0, 0.0} : to_double(pores.box()->translation(shift));
}

bool is_near_enough(const BoxShift &shift) {
  bool near = true;
  for (const int64_t k : shift.k) near = near && k <= PeriodicBox::farthest_copy && -k <= PeriodicBox::farthest_copy;
  return near;
}

}  // namespace

void TunnelFinder::carve(Workspace &workspace, uint32_t maxima, uint32_t gates, uint32_t points) {
  const uint64_t nodes = static_cast<uint64_t>(maxima) + 1;
  nodes_ = workspace.take<Node>(nodes);
  first_ = workspace.take<uint32_t>(nodes + 1);
  heap_ = workspace.take<uint32_t>(nodes);
  steps_ = workspace.take<Step>(2 * static_cast<uint64_t>(gates));
  first_alike_ = workspace.take<uint32_t>(gates);
  route_ = workspace.take<Step>(2 * nodes + 1);
  points_ = FixedVector<TunnelPoint>(workspace.take<TunnelPoint>(points));
  way_ = FixedVector<WayPoint>(workspace.take<WayPoint>(points));
}

// Lists the steps that begin at each node; and finds the gates that are equally wide.
void TunnelFinder::list_steps(const PoresBuilder &pores) {
  for (uint32_t k = 0; k < pores.gates().size(); ++k) {
    const bool alike = k > 0 && pores.gates()[k].point.level == pores.gates()[k - 1].point.level;
    first_alike_[k] = alike ? first_alike_[k - 1] : k;
  }
  const uint32_t nodes = pores.maxima().size() + 1;
  for (uint32_t k = 0; k < nodes; ++k) first_[k] = 0;
  for (const PoreGate &gate : pores.gates()) {
    for (const uint32_t end : gate.end) ++first_[node_of(end)];
  }
  end_rows(first_, nodes);
  for (uint32_t k = pores.gates().size(); k-- > 0;) {
    for (const uint32_t end : {1U, 0U}) steps_[--first_[node_of(pores.gates()[k].end[end])]] = {2 * k + end};
  }
}

// The cost of the straight line from a gate to the maximum at one of its ends; the outside costs nothing.
double TunnelFinder::cost_of_half(const PoresBuilder &pores, uint32_t gate, uint32_t end, bool by_length) const {
  const PoreGate &passed = pores.gates()[gate];
  if (passed.end[end] == pore_outside) return 0.0;
  const CriticalPoint &top = pores.maxima()[passed.end[end]].point;
  const Vec3 d = top.position + translation(pores, passed.end_shift[end].shift()) - passed.point.position;
  const double length = std::sqrt(dot(d, d));
  if (by_length) return length;
  return passed.point.level > 0.0 ? length / (passed.point.level * top.level) : std::numeric_limits<double>::infinity();
}

// Grows the tree until `to` is in it, or until a step closes it; `to` is no_id then.
bool TunnelFinder::search(const PoresBuilder &pores, const TunnelEnds &ends, uint32_t from, uint32_t to,
                          Patience &patience, Step &closing) {
  const uint32_t nodes = pores.maxima().size() + 1;
  for (uint32_t k = 0; k < nodes; ++k) nodes_[k].slot = no_id;
  list_steps(pores);
  // The widths are ranks in the list of gates, not levels, which are rounded.
  struct Rank {
    uint32_t width;
    double cost;
    uint32_t gate;
  };
  const auto rank_of = [&](Step by, double cost) {
    return Rank{ends.by_cost ? 0 : first_alike_[by.gate()], cost, by.gate()};
  };
  const auto is_better = [](const Rank &a, const Rank &b) {
    return a.width != b.width ? a.width < b.width : a.cost != b.cost ? a.cost < b.cost : a.gate < b.gate;
  };
  const auto rank_of_node = [&](uint32_t node) { return rank_of(nodes_[node].by, nodes_[node].cost); };
  const auto later = [&](uint32_t a, uint32_t b) { return is_better(rank_of_node(b), rank_of_node(a)); };
  const auto placed = [&](uint32_t node, uint32_t slot) { nodes_[node].slot = slot; };
  const auto is_avoided = [&](uint32_t gate) {
    for (const uint32_t each : ends.avoided) {
      if (each == gate) return true;
    }
    return false;
  };
  uint32_t waiting = 0, node = from;
  bool closes = false;
  Rank best{0, 0.0, no_id};  // the rank of the step that closes the path
  nodes_[from] = {0.0, {no_id}, in_tree, {}};
  while (node != to) {
    if (!patience.allows(2000)) return false;
    for (uint32_t k = first_[node]; k < first_[node + 1]; ++k) {
      const Step step = steps_[k];
      const PoreGate &gate = pores.gates()[step.gate()];
      const uint32_t other = node_of(gate.end[1 - step.end()]);
      if (is_avoided(step.gate())) continue;
      const BoxShift way = step.end() == 0 ? gate.way() : BoxShift{} - gate.way();
      const BoxShift shift = nodes_[node].shift + way;
      const double cost = nodes_[node].cost + cost_of_half(pores, step.gate(), 0, !ends.by_cost) +
                          cost_of_half(pores, step.gate(), 1, !ends.by_cost);
      Node &reached = nodes_[other];
      if (!(cost < std::numeric_limits<double>::infinity())) continue;
      if (!is_near_enough(shift)) {
        too_far_ = true;
        continue;
      }
      if (reached.slot == in_tree) {
        const Rank rank = rank_of(step, cost + reached.cost);
        if (to != no_id || shift == reached.shift || (closes && !is_better(rank, best))) continue;
        closes = true;
        closing = step;
        best = rank;
      } else if (reached.slot == no_id || is_better(rank_of(step, cost), rank_of_node(other))) {
        const uint32_t slot = reached.slot == no_id ? waiting++ : reached.slot;
        reached = {cost, step, slot, shift};
        heap_[slot] = other;
        sift_up(heap_.part(0, waiting), slot, later, placed);
      }
    }
    if (closes && (waiting == 0 || !is_better(rank_of_node(heap_[0]), best))) return true;
    if (waiting == 0) return false;
    node = heap_[0];
    nodes_[node].slot = in_tree;
    if (--waiting == 0) continue;
    heap_[0] = heap_[waiting];
    sift_down(heap_.part(0, waiting), 0, later, placed);
  }
  return true;
}

// Makes the route from the root of the tree to a node.
void TunnelFinder::take_route(const PoresBuilder &pores, uint32_t from, uint32_t to) {
  for (uint32_t node = to; node != from;) {
    const Step by = nodes_[node].by;
    route_[route_count_++] = by;
    node = node_of(pores.gates()[by.gate()].end[by.end()]);
  }
  for (uint32_t a = 0, b = route_count_; a + 1 < b; ++a) std::swap(route_[a], route_[--b]);
}

// Makes a closed route: from the root to the node at which a step begins, by that step, and back to the root.
void TunnelFinder::close_route(const PoresBuilder &pores, uint32_t from, Step closing) {
  const PoreGate &gate = pores.gates()[closing.gate()];
  take_route(pores, from, node_of(gate.end[closing.end()]));
  route_[route_count_++] = closing;
  for (uint32_t node = node_of(gate.end[1 - closing.end()]); node != from;) {
    const Step by = nodes_[node].by;
    route_[route_count_++] = by.back();
    node = node_of(pores.gates()[by.gate()].end[by.end()]);
  }
}

void TunnelFinder::add_point(const PoresBuilder &pores, const CriticalPoint &point, const BoxShift &copy, uint32_t gate,
                             uint32_t maximum) {
  points_.push({point, point.position + translation(pores, copy), point.level, copy, gate, maximum});
}

void TunnelFinder::reverse(uint64_t first) {
  if (points_.overflowed()) return;
  for (auto a = static_cast<uint32_t>(first), b = points_.size(); a + 1 < b; ++a) std::swap(points_[a], points_[--b]);
}

// The last points of a way up are close together; and a maximum that is given as an end would be there twice.
void TunnelFinder::leave_out_near_points() {
  const auto is_named = [](const TunnelPoint &point) { return point.gate != no_id || point.maximum != no_id; };
  const uint32_t count = points_.size();
  uint32_t kept = 0;
  for (uint32_t k = 0; k < count; ++k) {
    const TunnelPoint point = points_[k];
    const bool named = is_named(point), last = k + 1 == count;
    const auto is_within = [&](double distance) {
      const Vec3 d = point.position - points_[kept - 1].position;
      return dot(d, d) < distance * distance;
    };
    const double near = nearness * std::fabs(point.level);
    while ((named || last) && kept > 1 && !is_named(points_[kept - 1]) && is_within(near)) --kept;
    if (kept == 1 && named && !is_named(points_[0]) && is_within(rounding)) {
      const Vec3 start = points_[0].position;
      points_[0] = point;
      points_[0].position = start;
    } else if (kept > 0 && last && is_named(points_[kept - 1]) && is_within(rounding)) {
      points_[kept - 1].position = point.position;
    } else if (kept == 0 || named || last || !is_within(near)) {
      points_[kept++] = point;
    }
  }
  points_.set_count(kept);
}

// Adds the points of a way up from a point to near its maximum, or to the outside; all moved by the vector `by` of a
// copy. A step is a straight line. Points are added on it if it is long beside the distance to the centres of its
// nearest balls: in equal parts; or, if these would be too many beside a ball far smaller than the length of the step,
// in parts that are shorter near that ball.
Status TunnelFinder::add_way_up(const BallsAround &balls, const exact::Vector &start, const Vec3 &by,
                                const BoxShift &copy, Patience &patience) {
  constexpr double apart = 1.0 / 12.0, shortest = 32.0;
  constexpr uint32_t most_parts = 256;
  struct Place {
    Vec3 position;
    double level;
    NearImage near;
  };
  const auto place_of = [](const Ascent &at, const Vec3 &position) {
    return Place{position, at.level(), at.nearest_ball()};
  };
  const auto reach_of = [&](const Place &at) {
    return at.near.ball == no_id ? at.level : at.level + static_cast<double>(balls.ball(at.near).radius);
  };
  const auto put = [&](const Place &at) {
    const PointName name{{at.near.ball, no_id, no_id, no_id}, {}};
    points_.push({name, at.position, at.level, at.near.shift + copy, no_id, no_id});
  };
  Ascent way(balls, start);
  const Vec3 origin = to_double(start) + by;
  Place here = place_of(way, origin + way.offset());
  put(here);
  for (;;) {
    const Vec3 before = way.offset();
    const double reach_before = reach_of(here);
    if (!patience.allows(50000)) return Status::stopped;
    if (!way.step()) break;
    here = place_of(way, origin + way.offset());
    const Vec3 step = way.offset() - before;
    const double length = std::sqrt(dot(step, step));
    const auto between = [&](double share) {
      const Vec3 off = before + share * step;
      const exact::Vector at{start.x + nearest(off.x), start.y + nearest(off.y), start.z + nearest(off.z)};
      return place_of(Ascent(balls, at), to_double(at) + by);
    };
    double reach = smaller_of(reach_before, reach_of(here));
    const uint64_t first = points_.required();
    uint32_t parts = 1;
    while (parts < most_parts && length > parts * apart * reach) {
      while (parts < most_parts && length > parts * apart * reach) ++parts;
      points_.set_count(first);
      if (length > parts * apart * reach) break;
      for (uint32_t k = 1; k < parts && patience.allows(10000); ++k) {
        const Place at = between(k / static_cast<double>(parts));
        put(at);
        reach = smaller_of(reach, reach_of(at));
      }
    }
    if (length > parts * apart * reach) {
      points_.set_count(first);
      double share = 0.0, part = 1.0;
      reach = reach_before;
      while (patience.allows(10000)) {
        const bool ends = part >= 1.0 - share;
        const Place at = ends ? here : between(share + part);
        if (part * length > larger_of(apart * smaller_of(reach, reach_of(at)), shortest)) {
          part *= 0.5;
          continue;
        }
        if (ends) break;
        put(at);
        reach = reach_of(at);
        share += part;
        part = smaller_of(2.0 * part, 1.0 - share);
      }
    }
    put(here);
  }
  return way.is_lost() ? Status::check : Status::ok;
}

// Adds the points of the way up from a copy of a gate to its end.
Status TunnelFinder::add_way(PoresBuilder &pores, uint32_t gate, uint32_t end, const BoxShift &copy) {
  way_.clear();
  const Status status = pores.trace(gate, end, way_);
  if (status != Status::ok) return status;
  const Vec3 by = translation(pores, copy);
  for (const WayPoint &point : way_.items()) {
    const PointName name{{point.ball[0], point.ball[1], point.ball[2], no_id},
                         {point.shift[0], point.shift[1], point.shift[2], {}}};
    points_.push({name, point.position + by, point.level, copy, no_id, no_id});
  }
  points_.set_count(points_.required() + (way_.required() - way_.size()));
  const PoreGate &passed = pores.gates()[gate];
  if (passed.end[end] == pore_outside) return Status::ok;
  add_point(pores, pores.maxima()[passed.end[end]].point, copy + passed.end_shift[end].shift(), no_id, passed.end[end]);
  return Status::ok;
}

Status TunnelFinder::follow_route(PoresBuilder &pores, const BallsAround &balls, const TunnelEnds &ends,
                                  Patience &patience) {
  const PoreLocation &start = summary_.ends[0], &end = summary_.ends[1];
  bool at_maximum = start.maximum != pore_outside;
  BoxShift copy = start.maximum_shift;
  Status status = add_way_up(balls, ends.from, {0.0, 0.0, 0.0}, {}, patience);
  if (at_maximum) add_point(pores, pores.maxima()[start.maximum].point, copy, no_id, start.maximum);
  for (uint32_t k = 0; k < route_count_ && status == Status::ok; ++k) {
    const uint32_t passed = route_[k].gate(), side = route_[k].end();
    const PoreGate &gate = pores.gates()[passed];
    if (!patience.allows(200000 + 50 * uint64_t{pores.outer_balls()})) return Status::stopped;
    if (summary_.gate == no_id || passed > summary_.gate) summary_.gate = passed;
    summary_.cost += cost_of_half(pores, passed, 0, false) + cost_of_half(pores, passed, 1, false);
    copy = copy - gate.end_shift[side].shift();
    if (!is_near_enough(copy)) return Status::range;
    // The way back from the gate begins with the maximum once more.
    if (at_maximum) points_.set_count(points_.required() - 1);
    const uint64_t first = points_.required();
    status = add_way(pores, passed, side, copy);
    reverse(first);
    add_point(pores, gate.point, copy, passed, no_id);
    if (status == Status::ok) status = add_way(pores, passed, 1 - side, copy);
    copy = copy + gate.end_shift[1 - side].shift();
    at_maximum = gate.end[1 - side] != pore_outside;
    summary_.outside = summary_.outside || !at_maximum;
  }
  summary_.shift = copy - end.maximum_shift;
  const bool to_copy = ends.to == nullptr && pores.box() != nullptr && !balls.are_none();
  const exact::Vector *const last = to_copy ? &ends.from : ends.to;
  if (status != Status::ok || last == nullptr) return status;
  const uint64_t first = points_.required();
  status = add_way_up(balls, *last, translation(pores, summary_.shift), summary_.shift, patience);
  reverse(first);
  return status;
}

Status TunnelFinder::find(PoresBuilder &pores, const BallsAround &balls, const TunnelEnds &ends, TunnelSummary &summary,
                          Patience patience) {
  forget();
  route_count_ = 0;
  too_far_ = false;
  TunnelSummary &found = summary_;
  found.gate = no_id;
  summary = found;
  const bool to_copy = ends.to == nullptr && pores.box() != nullptr && !balls.are_none();
  found.ends[1] = {std::numeric_limits<double>::infinity(), no_id, pore_outside, {}, {}};
  Status status = locate(pores, balls, ends.from, ends.floor, found.ends[0]);
  if (to_copy) found.ends[1] = found.ends[0];
  if (status == Status::ok && ends.to != nullptr) status = locate(pores, balls, *ends.to, ends.floor, found.ends[1]);
  const PoreLocation start = found.ends[0], end = found.ends[1];
  Step closing{};
  if (status == Status::ok && start.maximum != no_id && end.maximum != no_id) {
    const uint32_t from = node_of(start.maximum), to = to_copy ? no_id : node_of(end.maximum);
    found.there = search(pores, ends, from, to, patience, closing);
    if (found.there && to_copy) close_route(pores, from, closing);
    if (found.there && !to_copy) take_route(pores, from, to);
  }
  if (!found.there && too_far_) status = Status::range;
  if (!patience.allows(0)) status = Status::stopped;

  if (found.there && status == Status::ok) {
    found.gates = route_count_;
    found.outside = start.maximum == pore_outside;
    status = follow_route(pores, balls, ends, patience);
    needed_ = clamped_count(points_.required());
    if (status == Status::ok && points_.overflowed()) status = Status::capacity;
    if (status == Status::ok) leave_out_near_points();
  }
  if (status != Status::ok || !found.there) {
    const uint32_t needed = needed_;
    if (status == Status::ok) summary = found;
    forget();
    needed_ = needed;
    return status;
  }
  found.level = start.level < end.level ? start.level : end.level;
  const double tightest = found.gate == no_id ? found.level : pores.gates()[found.gate].point.level;
  found.level = tightest < found.level ? tightest : found.level;
  for (uint32_t k = 1; k < points_.size(); ++k) {
    const Vec3 d = points_[k].position - points_[k - 1].position;
    found.length += std::sqrt(dot(d, d));
  }
  summary = found;
  return Status::ok;
}

}  // namespace hsp
