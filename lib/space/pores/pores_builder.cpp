#include "pores/pores_builder.hpp"

#include <initializer_list>

#include "core/sorting.hpp"

namespace hsp {

void PoresBuilder::carve(Workspace &workspace, const PoreLimits &limits) {
  limits_ = limits;
  balls_.carve(workspace, limits.balls, limits.near);
  critical_.carve(workspace, limits);
  ways_.carve(workspace, limits.near, limits.balls);
  compared_.carve(workspace, 8, limits.balls);
  maxima_ = critical_.maxima().room();
  gates_ = critical_.gates().room();
  tied_ = critical_.tied().room();
  parents_ = workspace.take<uint32_t>(static_cast<uint64_t>(limits.maxima) + 1);
  winding_gates_ = workspace.take<uint32_t>(limits.maxima);
  windings_.carve(workspace, clamped_count(static_cast<uint64_t>(limits.maxima) + 1));
}

PoreLimits PoresBuilder::retry_limits() const {
  PoreLimits limits = covering(limits_, needed_);
  // The need of scratch memory is known only up to where the work ended, so that it grows by a half more.
  for (uint32_t PoreLimits::*scratch : {&PoreLimits::candidates, &PoreLimits::near}) {
    const uint32_t limit = limits.*scratch;
    if (limit > limits_.*scratch) limits.*scratch = clamped_count(static_cast<uint64_t>(limit) + limit / 2);
  }
  return limits;
}

void PoresBuilder::begin(uint32_t balls) {
  maximum_count_ = gate_count_ = merger_count_ = 0;
  needed_ = {balls, 0, 0, 0, 0, 0};
  passages_ = {};
}

Status PoresBuilder::build(const CubeGrid &grid, int64_t floor, Patience patience, const PoresBuilder *before) {
  begin(grid.balls().n);
  const Status status = balls_.take(grid, patience);
  needed_.near = balls_.needed_near();
  if (status != Status::ok) return status;
  int64_t grown = 0;
  const bool helps =
      before != nullptr && balls_.compare(grid, before->balls_, grown) && before->critical_.floor() <= floor + grown;
  return build_from(floor, patience, helps ? before : nullptr);
}

Status PoresBuilder::build(const PeriodicImages &images, int64_t floor, Patience patience) {
  begin(images.balls());
  const Status status = balls_.take(images, patience);
  needed_.near = balls_.needed_near();
  return status == Status::ok ? build_from(floor, patience, nullptr) : status;
}

Status PoresBuilder::build_from(int64_t floor, Patience &patience, const PoresBuilder *before) {
  Status status = critical_.find(balls_, floor, patience, before);
  needed_ = covering(needed_, critical_.needed());
  needed_.balls = larger_count(needed_.balls, balls_.needed_balls());
  if (status != Status::ok) return status;
  status = climb_from_gates(patience);
  if (status == Status::ok) sort_points(patience);
  if (status == Status::ok && !patience.allows(0)) status = Status::stopped;
  if (status == Status::ok) put_gates_below_their_ends();
  if (status == Status::ok) status = balls_.box() != nullptr ? merge_in_box() : merge();
  if (status != Status::ok) {
    maximum_count_ = gate_count_ = 0;
    return status;
  }
  name_callers_balls();
  return Status::ok;
}

namespace {

// Whether two sets of three or four balls are certainly congruent: one is the other moved, turned by right angles or
// mirrored. Then their points have the same level.
bool are_congruent(const BallSet &balls, const uint32_t *a, const uint32_t *b, uint32_t count) {
  const auto alike = [&](uint32_t i, uint32_t j, uint32_t k, uint32_t l) {
    Vec3 d[2] = {balls.difference(a[i], a[j]), balls.difference(b[k], b[l])};
    for (Vec3 &v : d) {
      v = {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)};
      sort_three(v.x, v.y, v.z, [](double p, double q) { return p < q; });
    }
    return d[0].x == d[1].x && d[0].y == d[1].y && d[0].z == d[1].z;
  };
  // turned[k]: which ball of b corresponds to a[k]. Found by backtracking, k after all before it.
  uint32_t turned[4] = {0, 0, 0, 0};
  for (uint32_t k = 0;;) {
    bool fits = balls.r[a[k]] == balls.r[b[turned[k]]];
    for (uint32_t m = 0; fits && m < k; ++m) fits = turned[m] != turned[k] && alike(m, k, turned[m], turned[k]);
    if (fits && k + 1 == count) return true;
    if (fits) {
      turned[++k] = 0;
      continue;
    }
    while (++turned[k] == count) {
      if (k-- == 0) return false;
    }
  }
}

}  // namespace

// +1 if a is higher, -1 if b is, 0 for the same level; in doubles if they are certain, else by integers.
int PoresBuilder::compare_levels(const CriticalPoint &a, const CriticalPoint &b) {
  const double difference = a.level - b.level;
  if (std::fabs(difference) > a.error + b.error) return difference > 0.0 ? 1 : -1;
  const bool in_box = balls_.box() != nullptr;
  compared_.begin();
  uint32_t ball[2][4];
  for (const uint32_t which : {0U, 1U}) {
    const CriticalPoint &record = which == 0 ? a : b;
    for (uint32_t c = 0; c < 4; ++c) {
      ball[which][c] =
          in_box && record.ball[c] != no_id ? compared_.add(record.ball[c], record.shift[c].shift()) : record.ball[c];
    }
  }
  const BallSet &set = in_box ? compared_.set() : balls_.set();
  if (are_congruent(set, ball[0], ball[1], ball[0][3] == no_id ? 3 : 4)) return 0;
  TangentPoint point[2] = {TangentPoint(critical_.lines()), TangentPoint(critical_.lines())};
  for (const uint32_t which : {0U, 1U}) {
    const uint32_t *const k = ball[which];
    point[which].find(set, {k[0], k[1], k[2]}, k[3], false);
  }
  return point[0].compare_levels(point[1]);
}

// The order of points: by level, and for equal levels by name.
bool PoresBuilder::is_higher(const CriticalPoint &a, const CriticalPoint &b) {
  if (const int sign = compare_levels(a, b); sign != 0) return sign > 0;
  for (uint32_t k = 0; k < 4; ++k) {
    if (a.ball[k] != b.ball[k]) return balls_.set().ranks_before(a.ball[k], b.ball[k]);
    if (!(a.shift[k] == b.shift[k])) return visited_before(a.shift[k].shift(), b.shift[k].shift());
  }
  return false;
}

void PoresBuilder::sort_points(Patience &patience) {
  const auto higher = [&](const auto &a, const auto &b) { return patience.allows(200) && is_higher(a.point, b.point); };
  compared_.reset(balls_);
  for (uint32_t k = 0; k < maximum_count_; ++k) maxima_[k].gate = k;
  // In linear time if there is scratch memory and levels are spread.
  const auto by_level = [](const auto &record) { return -record.point.level; };
  sort_by_number(critical_.maxima().items(), critical_.scratch(), by_level, higher);
  sort_by_number(critical_.gates().items(), critical_.scratch(), by_level, higher);
  for (uint32_t k = 0; k < maximum_count_; ++k) maxima_[maxima_[k].gate].into = k;
  for (uint32_t k = 0; k < gate_count_; ++k) {
    for (uint32_t &end : gates_[k].end) end = end == pore_outside ? end : maxima_[end].into;
  }
  for (uint32_t k = 0; k < maximum_count_; ++k) maxima_[k].gate = maxima_[k].into = no_id;
}

// A gate is below its ends, and below the maximum whose class dies there. If the rounded levels say otherwise, the one
// with the larger error is set to the other.
void PoresBuilder::put_gate_below(CriticalPoint &gate, CriticalPoint &top) {
  if (!(gate.level > top.level)) return;
  if (top.error > gate.error) {
    top.level = gate.level;
  } else {
    gate.level = top.level;
  }
}

void PoresBuilder::put_gates_below_their_ends() {
  for (uint32_t k = 0; k < gate_count_; ++k) {
    for (const uint32_t end : gates_[k].end) {
      if (end != pore_outside) put_gate_below(gates_[k].point, maxima_[end].point);
    }
  }
}

// Gates are taken in the order in which they were found, which is that of positions: consecutive gates are near each
// other, and their ways meet.
Status PoresBuilder::climb_from_gates(Patience &patience) {
  tied_shifts_ = critical_.tied_shifts().items();
  maximum_count_ = critical_.maxima().size();
  gate_count_ = critical_.gates().size();
  ways_.prepare(balls_);
  WayUp::End end[2];
  uint32_t first = 0;
  for (uint32_t k = 0; k < gate_count_; ++k) {
    PoreGate &gate = gates_[k];
    const uint32_t moved = gate.translation;
    gate.directions = 0;
    if (moved == 0) first = k;
    for (const uint32_t side : {0U, 1U}) {
      if (moved == 0) {
        if (!patience.allows(10000)) return Status::stopped;
        const Status status = ways_.climb(gate.point, tied(gate.point), tied_shifts(gate.point), side == 1, end[side]);
        needed_.near = larger_count(needed_.near, ways_.needed_near());
        if (status != Status::ok) return status;
      }
      const WayUp::End here = moved == 0 ? end[side] : moved_end(end[side], gates_[first].point.ball[0], moved);
      gate.end[side] = here.outside ? pore_outside : critical_.maximum_names().find(here.name, critical_.maxima());
      if (gate.end[side] == no_id) return Status::check;
      if (!SmallShift::fits(here.shift)) return Status::range;
      gate.end_shift[side] = SmallShift::of(here.shift);
    }
  }
  return Status::ok;
}

// The end of a way up from a gate after a translation. Its shift is relative to the gate's first ball.
WayUp::End PoresBuilder::moved_end(const WayUp::End &end, uint32_t gates_ball, uint32_t translation) {
  WayUp::End moved = end;
  moved.name = critical_.moved_name(end.name, translation);
  moved.shift = balls_.moved_image(end.name.ball[0], end.shift, translation).shift -
                balls_.moved_image(gates_ball, BoxShift{}, translation).shift;
  return moved;
}

// The younger of two classes becomes a part of the older one. A class with a lower number is older. Maximum m has the
// class first + m; a number below `first` is the outside. Returns the number of the older class.
uint32_t PoresBuilder::note_merger(uint32_t gate, uint32_t a, uint32_t b, uint32_t first) {
  if (a == b) return a;
  const uint32_t older = a < b ? a : b, younger = a < b ? b : a;
  gates_[gate].merges = true;
  ++merger_count_;
  maxima_[younger - first].gate = gate;
  maxima_[younger - first].into = older < first ? pore_outside : older - first;
  put_gate_below(gates_[gate].point, maxima_[younger - first].point);
  return older;
}

// Merges classes, from the widest gate on. Class 0 is the outside, the oldest one.
Status PoresBuilder::merge() {
  DisjointSets classes(parents_.part(0, maximum_count_ + 1));
  classes.reset();
  for (uint32_t k = 0; k < gate_count_; ++k) {
    const auto class_at = [&](uint32_t end) { return classes.find(node_of(end)); };
    const uint32_t a = class_at(gates_[k].end[0]), b = class_at(gates_[k].end[1]);
    static_cast<void>(note_merger(k, a, b, 1));
    classes.join(a, b);
  }
  return Status::ok;
}

// The same in a periodic box, which has no outside. Classes remember which of their copies meet. A passage is a
// property of the class below its gates. So all gates of one level are merged before passages are noted, as the order
// of these gates is only one of names. `passing`: the first gate of the level at which a class goes on in more
// directions than any class above; no_id if there is none so far.
Status PoresBuilder::merge_in_box() {
  windings_.reset(maximum_count_);
  for (uint32_t k = 0; k < maximum_count_; ++k) winding_gates_[k] = no_id;
  uint32_t passing = no_id;
  for (uint32_t k = 0; k < gate_count_; ++k) {
    PoreGate &gate = gates_[k];
    const uint32_t older = note_merger(k, windings_.set_of(gate.end[0]), windings_.set_of(gate.end[1]), 0);
    const WindingLattice &lattice = windings_.lattice_of_set(older);
    const uint32_t rank = lattice.rank;
    const uint64_t copies = lattice.copies();
    if (!windings_.join(gate.end[0], gate.end[1], gate.way())) {
      return Status::range;
    }
    gate.directions = lattice.rank;
    gate.winds = lattice.rank != rank || lattice.copies() != copies;
    if (lattice.rank > 0 && winding_gates_[older] == no_id) winding_gates_[older] = k;
    note_ways_along(k, lattice);
    if (passing == no_id && lattice.rank > 0 && passages_.gate[lattice.rank - 1] == no_id) passing = k;
    if (passing == no_id) continue;
    if (k + 1 < gate_count_ && compare_levels(gate.point, gates_[k + 1].point) == 0) continue;
    note_passages(passing, k + 1);
    passing = no_id;
  }
  return Status::ok;
}

// Notes the passages by the gates of one level. If several classes go on there, the one of the widest cavity counts.
void PoresBuilder::note_passages(uint32_t first, uint32_t end) {
  for (uint32_t d = 0; d < 3; ++d) {
    if (passages_.gate[d] != no_id) continue;
    for (uint32_t k = first; k < end; ++k) {
      if (gates_[k].directions <= d) continue;
      const uint32_t maximum = windings_.set_of(gates_[k].end[0]);
      if (passages_.gate[d] != no_id && maximum >= passages_.maximum[d]) continue;
      passages_.gate[d] = k;
      passages_.maximum[d] = maximum;
      passages_.lattice[d] = windings_.lattice_of_set(maximum);
    }
  }
}

void PoresBuilder::note_ways_along(uint32_t gate, const WindingLattice &lattice) {
  for (uint32_t d = 0; d < lattice.rank; ++d) {
    const auto &row = lattice.row[d];
    const BoxShift given = balls_.box()->in_given_vectors({{row[0], row[1], row[2]}});
    for (int k = 0; k < 3; ++k) {
      if (given.k[k] != 0 && passages_.gate_along[k] == no_id) passages_.gate_along[k] = gate;
    }
  }
}

// The maxima and gates above a level are the first ones. join() cannot fail: it did not for all gates.
uint32_t PoresBuilder::join_above(double level, Patience patience) {
  uint32_t fitting = 0;
  while (fitting < maximum_count_ && maxima_[fitting].point.level > level) ++fitting;
  windings_.reset(fitting + 1);
  if (!patience.allows(50 * uint64_t{fitting})) return 0;
  for (uint32_t k = 0; k < gate_count_ && gates_[k].point.level > level; ++k) {
    if (!patience.allows(200)) return 0;
    const PoreGate &gate = gates_[k];
    static_cast<void>(windings_.join(node_of(gate.end[0]), node_of(gate.end[1]), gate.way()));
  }
  return windings_.number();
}

void PoresBuilder::name_callers_balls() {
  const auto rename = [&](CriticalPoint &point) {
    for (uint32_t &ball : point.ball) ball = ball == no_id ? no_id : balls_.callers(ball);
  };
  for (uint32_t k = 0; k < maximum_count_; ++k) rename(maxima_[k].point);
  for (uint32_t k = 0; k < gate_count_; ++k) rename(gates_[k].point);
  for (uint32_t &ball : critical_.tied().items()) ball = balls_.callers(ball);
}

Status PoresBuilder::trace(uint32_t gate, uint32_t end, FixedVector<WayPoint> &points) {
  const auto first = points.size();
  const bool listed = gates_[gate].point.tied > 3;
  CriticalPoint point = gates_[gate].point;
  for (uint32_t k = 0; k < 3; ++k) point.ball[k] = balls_.own_ball(point.ball[k]);
  const Span<uint32_t> list = listed ? tied_.part(point.first_tied, point.first_tied + point.tied) : Span<uint32_t>();
  for (uint32_t &ball : list) ball = balls_.own_ball(ball);
  const Span<const uint32_t> nearest = listed ? Span<const uint32_t>(list) : Span<const uint32_t>(point.ball, 3);
  WayUp::End ended;
  ways_.trace_into(&points);
  const Status status = ways_.climb(point, nearest, tied_shifts(gates_[gate].point), end == 1, ended);
  ways_.trace_into(nullptr);
  needed_.near = larger_count(needed_.near, ways_.needed_near());
  for (uint32_t &ball : list) ball = balls_.callers(ball);
  for (uint32_t k = first; k < points.size(); ++k) {
    for (uint32_t &ball : points[k].ball) ball = ball == no_id ? no_id : balls_.callers(ball);
  }
  return status;
}

}  // namespace hsp
