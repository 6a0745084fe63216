#include "pores/pores_builder.hpp"

#include <initializer_list>

#include "core/sorting.hpp"

namespace hsp {
namespace {

bool is_inside(const exact::LatticeBall &inner, const exact::LatticeBall &outer) {
  const int64_t room = outer.radius - inner.radius;
  const int64_t x = inner.centre.x - outer.centre.x, y = inner.centre.y - outer.centre.y,
                z = inner.centre.z - outer.centre.z;
  if (x > room || y > room || z > room || -x > room || -y > room || -z > room) return false;
  const int64_t squared = x * x + y * y + z * z;
  if (squared == 0 && room == 0) return exact::ranks_before(outer, inner);
  return squared <= room * room;
}

TangentCurve curve_of(const CriticalPoint &point) {
  return {point.ball[0], point.ball[1], point.ball[2]};
}

}  // namespace

void PoresBuilder::carve(Workspace &workspace, const PoreLimits &limits) {
  limits_ = limits;
  balls_.carve(workspace, limits.balls);
  callers_ = workspace.take<uint32_t>(limits.balls);
  grid_.carve(workspace, limits.balls);
  critical_.carve(workspace, {limits.balls, limits.maxima, limits.gates, limits.tied, limits.candidates, limits.near});
  ways_.carve(workspace, limits.near);
  names_.carve(workspace, limits.maxima);
  maxima_ = workspace.take<PoreMaximum>(limits.maxima);
  gates_ = workspace.take<PoreGate>(limits.gates);
  near_ = workspace.take<uint32_t>(limits.near);
  parents_ = workspace.take<uint32_t>(static_cast<uint64_t>(limits.maxima) + 1);
}

PoreLimits PoresBuilder::retry_limits() const {
  // Scratch memory is known only as far as it was needed, so that it grows by a half.
  const auto step = [](uint32_t limit, uint32_t needed) {
    return needed > limit ? clamped_count(static_cast<uint64_t>(needed) + needed / 2) : limit;
  };
  return {larger_count(limits_.balls, needed_.balls),   larger_count(limits_.maxima, needed_.maxima),
          larger_count(limits_.gates, needed_.gates),   larger_count(limits_.tied, needed_.tied),
          step(limits_.candidates, needed_.candidates), step(limits_.near, needed_.near)};
}

Status PoresBuilder::build(const CubeGrid &grid, int64_t floor) {
  maximum_count_ = gate_count_ = 0;
  balls_.n = 0;
  needed_ = {grid.balls().n, 0, 0, 0, 0, 0};
  if (grid.balls().n > limits_.balls) return Status::capacity;
  if (const Status status = take_outer_balls(grid); status != Status::ok) return status;
  Status status = critical_.find(balls_, floor);
  const CriticalLimits &needed = critical_.needed();
  needed_.maxima = needed.maxima;
  needed_.gates = needed.gates;
  needed_.tied = needed.tied;
  needed_.candidates = needed.candidates;
  needed_.near = larger_count(needed_.near, needed.near);
  if (status != Status::ok) return status;
  sort_points();
  status = climb_from_gates();
  if (status != Status::ok) {
    maximum_count_ = gate_count_ = 0;
    return status;
  }
  merge();
  name_callers_balls();
  return Status::ok;
}

// Balls inside another one are nowhere nearest. The others in order of positions, so that nothing depends on the order
// in which they are given.
Status PoresBuilder::take_outer_balls(const CubeGrid &grid) {
  const BallSet &all = grid.balls();
  uint32_t count = 0;
  for (uint32_t i = 0; i < all.n; ++i) {
    const exact::LatticeBall ball = all.ball(i);
    QueryResult result{near_.data(), near_.size(), 0};
    find_balls_at_ball(grid, {ball.centre, ball.radius}, result);
    needed_.near = larger_count(needed_.near, result.hits);
    if (result.hits > near_.size()) return Status::capacity;
    bool hidden = false;
    for (uint32_t k = 0; k < result.hits && !hidden; ++k) {
      const uint32_t other = grid.grid_index(near_[k]);
      hidden = other != i && is_inside(ball, all.ball(other));
    }
    if (!hidden) callers_[count++] = i;
  }
  sort_in_place(callers_.part(0, count), [&](uint32_t a, uint32_t b) { return all.ranks_before(a, b); });
  balls_.n = count;
  balls_.lattice = all.lattice;
  balls_.probe_steps = all.probe_steps;
  balls_.largest_radius = all.largest_radius;
  for (uint32_t k = 0; k < count; ++k) {
    exact::LatticeBall ball = all.ball(callers_[k]);
    callers_[k] = ball.index;
    ball.index = k;
    balls_.store(k, ball);
  }
  grid_.build(balls_, count);
  return Status::ok;
}

// In doubles, where they are certain; by integers, and by names.
bool PoresBuilder::is_higher(const CriticalPoint &a, const CriticalPoint &b) const {
  const double difference = a.level - b.level;
  if (std::fabs(difference) > a.doubt + b.doubt) return difference > 0.0;
  TangentPoint p(critical_.lines()), q(critical_.lines());
  p.find(balls_, curve_of(a), a.ball[3], false);
  q.find(balls_, curve_of(b), b.ball[3], false);
  const int sign = p.compare_levels(q);
  if (sign != 0) return sign > 0;
  for (uint32_t k = 0; k < 4; ++k) {
    if (a.ball[k] != b.ball[k]) return a.ball[k] < b.ball[k];
  }
  return false;
}

void PoresBuilder::sort_points() {
  const auto higher = [&](const CriticalPoint &a, const CriticalPoint &b) { return is_higher(a, b); };
  sort_in_place(critical_.maxima().items(), higher);
  sort_in_place(critical_.gates().items(), higher);
  tied_ = critical_.tied().items();
  maximum_count_ = critical_.maxima().size();
  gate_count_ = critical_.gates().size();
  names_.clear();
  for (uint32_t k = 0; k < maximum_count_; ++k) {
    maxima_[k] = {critical_.maxima()[k], no_id, no_id};
    names_.add(maxima_[k].point.ball, k);
  }
  for (uint32_t k = 0; k < gate_count_; ++k) gates_[k] = {critical_.gates()[k], {no_id, no_id}, false};
}

Status PoresBuilder::climb_from_gates() {
  ways_.prepare(balls_, grid_);
  for (uint32_t k = 0; k < gate_count_; ++k) {
    PoreGate &gate = gates_[k];
    for (const uint32_t side : {0U, 1U}) {
      uint32_t name[4] = {no_id, no_id, no_id, no_id};
      bool outside = false;
      const Status status = ways_.climb(gate.point, tied(gate.point), side == 1, name, outside);
      needed_.near = larger_count(needed_.near, ways_.needed_near());
      if (status != Status::ok) return status;
      gate.end[side] = outside ? pore_outside : names_.find(name);
      if (gate.end[side] == no_id) return Status::check;
    }
  }
  return Status::ok;
}

// From the widest gate on. Numbers of classes are ages: 0 is the outside, the lowest of a set its oldest.
void PoresBuilder::merge() {
  DisjointSets classes(parents_.part(0, maximum_count_ + 1));
  classes.reset();
  for (uint32_t k = 0; k < gate_count_; ++k) {
    PoreGate &gate = gates_[k];
    const auto class_at = [&](uint32_t end) { return classes.find(end == pore_outside ? 0 : end + 1); };
    const uint32_t a = class_at(gate.end[0]), b = class_at(gate.end[1]);
    if (a == b) continue;
    gate.merges = true;
    const uint32_t older = a < b ? a : b, younger = a < b ? b : a;
    maxima_[younger - 1].gate = k;
    maxima_[younger - 1].into = older == 0 ? pore_outside : older - 1;
    classes.join(a, b);
  }
}

void PoresBuilder::name_callers_balls() {
  const auto rename = [&](CriticalPoint &point) {
    for (uint32_t &ball : point.ball) ball = ball == no_id ? no_id : callers_[ball];
  };
  for (uint32_t k = 0; k < maximum_count_; ++k) rename(maxima_[k].point);
  for (uint32_t k = 0; k < gate_count_; ++k) rename(gates_[k].point);
  for (uint32_t &ball : critical_.tied().items()) ball = callers_[ball];
}

}  // namespace hsp
