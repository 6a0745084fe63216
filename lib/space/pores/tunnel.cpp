#include "pores/tunnel.hpp"

#include "core/disjoint_sets.hpp"

namespace hsp {
namespace {

Vec3 place_of(const exact::Vector &point) {
  return {static_cast<double>(point.x), static_cast<double>(point.y), static_cast<double>(point.z)};
}

}  // namespace

void TunnelFinder::carve(Workspace &workspace, uint32_t maxima, uint32_t points) {
  const uint64_t nodes = static_cast<uint64_t>(maxima) + 1;
  parents_ = workspace.take<uint32_t>(nodes);
  sizes_ = workspace.take<uint32_t>(nodes);
  next_ = workspace.take<uint32_t>(nodes);
  by_ = workspace.take<uint32_t>(nodes);
  route_ = workspace.take<Step>(nodes);
  points_ = FixedVector<TunnelPoint>(workspace.take<TunnelPoint>(points));
  way_ = FixedVector<WayPoint>(workspace.take<WayPoint>(points));
}

// Turns the links of a tree from a node to its root round, so that the node becomes the root.
void TunnelFinder::root_at(uint32_t node) {
  uint32_t before = no_id, gate = no_id;
  while (node != no_id) {
    const uint32_t after = next_[node], by = by_[node];
    next_[node] = before;
    by_[node] = gate;
    before = node;
    gate = by;
    node = after;
  }
}

// Gates from the widest on, until both ends are in one tree.
bool TunnelFinder::connect(const PoresBuilder &pores, const TunnelEnds &ends, uint32_t from, uint32_t to) {
  const uint32_t nodes = pores.maxima().size() + 1;
  DisjointSets sets(parents_.part(0, nodes));
  sets.reset();
  for (uint32_t k = 0; k < nodes; ++k) {
    sizes_[k] = 1;
    next_[k] = by_[k] = no_id;
  }
  const auto is_avoided = [&](uint32_t gate) {
    for (const uint32_t each : ends.avoided) {
      if (each == gate) return true;
    }
    return false;
  };
  for (uint32_t k = 0; k < pores.gates().size() && sets.find(from) != sets.find(to); ++k) {
    const PoreGate &gate = pores.gates()[k];
    uint32_t a = node_of(gate.end[0]), b = node_of(gate.end[1]);
    const uint32_t set_a = sets.find(a), set_b = sets.find(b);
    if (set_a == set_b || is_avoided(k)) continue;
    const uint32_t size = sizes_[set_a] + sizes_[set_b];
    if (sizes_[set_a] > sizes_[set_b]) {
      const uint32_t other = a;
      a = b;
      b = other;
    }
    root_at(a);
    next_[a] = b;
    by_[a] = k;
    sets.join(a, b);
    sizes_[sets.find(a)] = size;
  }
  return sets.find(from) == sets.find(to);
}

void TunnelFinder::take_route(const PoresBuilder &pores, uint32_t from, uint32_t to) {
  root_at(to);
  route_count_ = 0;
  for (uint32_t node = from; node != to; node = next_[node]) {
    const PoreGate &gate = pores.gates()[by_[node]];
    route_[route_count_++] = {by_[node], node_of(gate.end[0]) == node ? 0U : 1U};
  }
}

void TunnelFinder::add_point(const CriticalPoint &point, uint32_t gate, uint32_t maximum) {
  points_.push({point.place, point.level, {point.ball[0], point.ball[1], point.ball[2], point.ball[3]}, gate, maximum});
}

void TunnelFinder::reverse(uint64_t first) {
  if (points_.overflowed()) return;
  for (auto a = static_cast<uint32_t>(first), b = points_.size(); a + 1 < b; ++a) {
    const TunnelPoint other = points_[--b];
    points_[b] = points_[a];
    points_[a] = other;
  }
}

// From a point to its maximum, or outside.
Status TunnelFinder::add_way_up(const CubeGrid &grid, const exact::Vector &start, uint32_t maximum,
                                const PoresBuilder &pores) {
  Ascent way(grid, start);
  const Vec3 origin = place_of(start);
  do {
    points_.push({origin + way.offset(), way.level(), {way.nearest_ball(), no_id, no_id, no_id}, no_id, no_id});
  } while (way.step());
  if (way.is_lost()) return Status::check;
  if (maximum != pore_outside) add_point(pores.maxima()[maximum].point, no_id, maximum);
  return Status::ok;
}

// From a gate to its end.
Status TunnelFinder::add_way(PoresBuilder &pores, uint32_t gate, uint32_t end) {
  way_.clear();
  const Status status = pores.trace(gate, end, way_);
  if (status != Status::ok) return status;
  for (const WayPoint &point : way_.items()) {
    points_.push({point.place, point.level, {point.ball[0], point.ball[1], point.ball[2], no_id}, no_id, no_id});
  }
  points_.set_count(points_.required() + (way_.required() - way_.size()));
  const uint32_t maximum = pores.gates()[gate].end[end];
  if (maximum != pore_outside) add_point(pores.maxima()[maximum].point, no_id, maximum);
  return Status::ok;
}

Status TunnelFinder::find(PoresBuilder &pores, const CubeGrid &grid, const TunnelEnds &ends, TunnelSummary &summary) {
  forget();
  summary = {false, false, 0.0, 0.0, no_id, 0, {}};
  summary.ends[1] = {std::numeric_limits<double>::infinity(), no_id, pore_outside};
  Status status = locate(pores, grid, ends.from, ends.floor, summary.ends[0]);
  if (status == Status::ok && ends.to != nullptr) status = locate(pores, grid, *ends.to, ends.floor, summary.ends[1]);
  if (status != Status::ok) return status;
  const PorePlace &start = summary.ends[0], &end = summary.ends[1];
  if (start.maximum == no_id || end.maximum == no_id) return Status::ok;
  const uint32_t from = node_of(start.maximum), to = node_of(end.maximum);
  if (!connect(pores, ends, from, to)) return Status::ok;
  take_route(pores, from, to);
  summary.there = true;
  summary.gates = route_count_;
  summary.outside = start.maximum == pore_outside;
  status = add_way_up(grid, ends.from, start.maximum, pores);
  bool at_maximum = start.maximum != pore_outside;
  for (uint32_t k = 0; k < route_count_ && status == Status::ok; ++k) {
    const Step &step = route_[k];
    const PoreGate &gate = pores.gates()[step.gate];
    if (summary.gate == no_id || step.gate > summary.gate) summary.gate = step.gate;
    // The way back from the gate begins with the maximum once more.
    if (at_maximum) points_.set_count(points_.required() - 1);
    const uint64_t first = points_.required();
    status = add_way(pores, step.gate, step.end);
    reverse(first);
    add_point(gate.point, step.gate, no_id);
    if (status == Status::ok) status = add_way(pores, step.gate, 1 - step.end);
    at_maximum = gate.end[1 - step.end] != pore_outside;
    summary.outside = summary.outside || !at_maximum;
  }
  if (status == Status::ok && ends.to != nullptr) {
    const uint64_t first = points_.required();
    status = add_way_up(grid, *ends.to, pore_outside, pores);
    reverse(first);
  }
  if (status != Status::ok) return status;
  summary.level = start.level < end.level ? start.level : end.level;
  const double tightest = summary.gate == no_id ? summary.level : pores.gates()[summary.gate].point.level;
  summary.level = tightest < summary.level ? tightest : summary.level;
  needed_ = clamped_count(points_.required());
  if (points_.overflowed()) {
    points_.clear();
    return Status::capacity;
  }
  for (uint32_t k = 1; k < points_.size(); ++k) {
    const Vec3 d = points_[k].place - points_[k - 1].place;
    summary.length += std::sqrt(dot(d, d));
  }
  return Status::ok;
}

}  // namespace hsp
