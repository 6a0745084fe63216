#include "moving/moving_balls.hpp"

namespace hsp {
namespace {

bool stays_put(const exact::LatticeBall &a, const exact::LatticeBall &b) {
  return a.centre.x == b.centre.x && a.centre.y == b.centre.y && a.centre.z == b.centre.z && a.radius == b.radius;
}

void count_ball(const MovingBall &ball, bool is_origin, bool add, MovingCounts &counts) {
  const auto change = [add](auto &count, auto by) { count = add ? count + by : count - by; };
  change(counts.exposed, uint32_t{ball.faces != 0});
  change(counts.contained, uint32_t{ball.contained});
  change(counts.components, uint32_t{is_origin});
  change(counts.half_edges, uint64_t{ball.half_edges});
  change(counts.circle_sides, uint64_t{ball.circles});
  change(counts.loops, uint64_t{ball.loops});
  change(counts.faces, uint64_t{ball.faces});
}

// The largest of the radii for which the cubes of all balls are far too large; 0 if there are none: twice the mean.
int64_t largest_small_radius(const CubeGrid &grid) {
  if (small_code || grid.levels() == nullptr) return 0;
  const BallSet &balls = grid.balls();
  double sum = 0.0;
  for (uint32_t i = 0; i < balls.n; ++i) sum += balls.r[i];
  const auto radius = static_cast<int64_t>(2.0 * sum / balls.n);
  return 4 * radius <= grid.side() ? radius : 0;
}

}  // namespace

void MovingBalls::carve(Workspace &workspace, const MovingLimits &limits) {
  limit(limits);
  records_.carve(workspace, limits.balls);
  cells_.carve(workspace, limits.balls);
  components_.carve(workspace, limits.balls);
  sums_.carve(workspace, limits.balls);
  workspace.take_each(limits.balls, slot_, new_ball_, weight_);
  group_.carve(workspace, limits.balls, limits.neighbours);
  records_.balls.n = 0;
  may_undo_ = false;
}

Status MovingBalls::set(const CubeGrid &grid, const EnergyTerms &terms, Patience patience) {
  const BallSet &given = grid.balls();
  const uint32_t n = given.n;
  may_undo_ = false;
  needed_ = {};
  if (n > limits_.balls) {
    needed_.balls = n;
    return forget(Status::capacity);
  }
  counts_ = {};
  BallSet &balls = records_.balls;
  records_.clear(n);
  balls.lattice = given.lattice;
  balls.probe_steps = given.probe_steps;
  group_.clear(given.lattice, n);
  cells_.clear(n, grid.side(), largest_small_radius(grid));
  components_.clear(n);
  sums_.resize(n);
  tension_ = terms.tension;
  pressure_ = terms.pressure;
  touching_balls_ = terms.weights.touching_balls;
  weighted_ = terms.weights.weight != nullptr;
  for (uint32_t i = 0; i < n; ++i) {
    if (!patience.allows(500)) return forget(Status::stopped);
    const exact::LatticeBall ball = given.ball(i);
    balls.store(i, ball);
    slot_[ball.index] = i;
    if (weighted_) weight_[ball.index] = terms.weights.weight[ball.index];
    cells_.insert(i, ball);
    MovingBall own{};
    own.origin = own.next = own.previous = i;
    records_.ball[i] = own;
    records_.parent[i] = no_id;
    count_ball(own, true, true, counts_);
  }
  note_all();
  components_.span(records_, cells_, patience);
  const Status status = update(n, patience);
  needed_.balls = n;
  if (status != Status::ok) return forget(status);
  records_.begin();
  changed_count_ = 0;
  return Status::ok;
}

// Notes all balls so that those close together follow each other: in grid order, or by their small cubes.
void MovingBalls::note_all() {
  for (uint32_t i = 0; i < size(); ++i) {
    if (!cells_.has_small_cubes()) {
      records_.note_moved(i);
    } else if (!records_.is_noted(i)) {
      cells_.visit_cube_of(i, [this](uint32_t j) { records_.note_moved(j); });
    }
  }
}

// Forgets all balls, and returns the status.
Status MovingBalls::forget(Status status) {
  records_.clear(0);
  sums_.resize(0);
  counts_ = {};
  return status;
}

Status MovingBalls::move(const BallMoves &moves, uint32_t &first_bad, Patience patience) {
  needed_ = {};
  if (const Status status = stage(moves, first_bad); status != Status::ok) return status;
  records_.begin();
  counts_before_ = counts_;
  for (uint32_t k = 0; k < moves.count; ++k) {
    const uint32_t i = slot_[moves.ball[k]];
    if (!stays_put(records_.balls.ball(i), new_ball_[k])) records_.note_moved(i);
  }
  const uint32_t former = moves.count == 1 ? place_one(moves.ball[0]) : place_all(moves);
  const Status status = update(former, patience);
  needed_.balls = size();
  may_undo_ = status == Status::ok;
  if (may_undo_) return status;
  take_back();
  records_.begin();
  changed_count_ = 0;
  return status;
}

Status MovingBalls::undo() {
  if (!may_undo_) return Status::state;
  may_undo_ = false;
  take_back();
  return Status::ok;
}

// Rounds the balls that are to move. Nothing of them is stored yet.
Status MovingBalls::stage(const BallMoves &moves, uint32_t &first_bad) {
  first_bad = no_id;
  Status status = Status::ok;
  uint32_t staged = 0;
  for (uint32_t k = 0; k < moves.count && status == Status::ok; ++k) {
    const uint32_t caller = moves.ball[k];
    if (caller >= size() || group_.mark(slot_[caller]) != 0) {
      status = Status::id;
    } else {
      status = round_move(moves, k);
    }
    if (status != Status::ok) {
      first_bad = k;
    } else {
      group_.mark(slot_[caller]) = 1;
      staged = k + 1;
    }
  }
  for (uint32_t k = 0; k < staged; ++k) group_.mark(slot_[moves.ball[k]]) = 0;
  return status;
}

Status MovingBalls::round_move(const BallMoves &moves, uint32_t k) {
  const BallSet &balls = records_.balls;
  const exact::LatticeBall before = balls.ball(slot_[moves.ball[k]]);
  exact::LatticeBall &ball = new_ball_[k];
  ball = before;
  const double here[3] = {0.0, 0.0, 0.0};
  const double *const xyz = moves.xyz != nullptr ? moves.xyz + 3 * static_cast<size_t>(k) : here;
  const double radius = moves.radius != nullptr ? moves.radius[k] : 0.0;
  if (!is_finite(radius)) return Status::not_finite;
  if (radius < 0.0) return Status::negative;
  const Status status = round_ball(balls.lattice, balls.probe_steps, xyz, radius, before.index, ball);
  if (status != Status::ok) return status;
  if (moves.xyz == nullptr) ball.centre = before.centre;
  if (moves.radius == nullptr) ball.radius = before.radius;
  return ball.radius <= largest_radius() ? Status::ok : Status::range;
}

void MovingBalls::place_again(uint32_t i, const exact::LatticeBall &ball) {
  cells_.remove(i);
  records_.balls.store(i, ball);
  cells_.insert(i, ball);
}

// Notes the balls that those noted meet at their old places; moves the balls; and notes the balls that these meet at
// their new places. Returns how many were noted before the last step.
uint32_t MovingBalls::place_all(const BallMoves &moves) {
  const uint32_t moved = records_.noted();
  for (uint32_t k = 0; k < moved; ++k) {
    cells_.visit_meeting(records_.balls, records_.entry(k).placed, [this](uint32_t j) { records_.note(j); });
  }
  const uint32_t former = records_.noted();
  for (uint32_t k = 0; k < moves.count; ++k) place_again(slot_[moves.ball[k]], new_ball_[k]);
  components_.begin(records_, former);
  for (uint32_t k = 0; k < moved; ++k) note_what_meets(records_.entry(k).ball);
  return former;
}

// The same for a single ball that moves. If it does not go far, its neighbours are searched once for both places.
uint32_t MovingBalls::place_one(uint32_t caller) {
  const uint32_t i = slot_[caller];
  const exact::LatticeBall before = records_.balls.ball(i);
  const exact::Vector &p = before.centre, &q = new_ball_[0].centre;
  const int64_t side = cells_.side_for(new_ball_[0].radius);
  const auto is_near = [side](int64_t a, int64_t b) { return a - b < side && b - a < side; };
  if (records_.noted() == 0 || !is_near(p.x, q.x) || !is_near(p.y, q.y) || !is_near(p.z, q.z))
    return place_all({1, &caller, nullptr, nullptr});
  const Span<uint32_t> later = group_.scratch();
  uint32_t count = 0;
  cells_.visit_meeting(records_.balls, before, new_ball_[0], [&](uint32_t j, bool met_before) {
    if (met_before) {
      records_.note(j);
    } else {
      later[count++] = j;
    }
  });
  const uint32_t former = records_.noted();
  place_again(i, new_ball_[0]);
  for (const uint32_t j : later.part(0, count)) records_.note(j);
  components_.begin(records_, former);
  for (uint32_t k = 1; k < records_.noted(); ++k) {
    const uint32_t j = records_.entry(k).ball;
    if (BallCells::is_met(records_.balls, new_ball_[0], j)) components_.connect(records_, i, j);
  }
  return former;
}

// Notes the balls that ball i meets at its new place.
void MovingBalls::note_what_meets(uint32_t i) {
  cells_.visit_meeting(records_.balls, records_.balls.ball(i), [this, i](uint32_t j) {
    records_.note(j);
    components_.connect(records_, i, j);
  });
}

// Computes the balls in the journal again. former: as for ComponentUpdate.
Status MovingBalls::update(uint32_t former, Patience &patience) {
  const uint32_t affected = records_.noted();
  needed_.neighbours = group_.compute(records_, cells_, affected, weights(), patience);
  const bool stopped = !patience.allows(0);
  if (stopped || needed_.neighbours > limits_.neighbours) {
    components_.abandon(records_, former);
    return stopped ? Status::stopped : Status::capacity;
  }
  components_.apply(records_, cells_, former, patience);
  sum_up(affected, patience);
  if (!patience.allows(0)) return Status::stopped;
  if (counts_.contained != 0) group_.flag_inner_contacts(records_, cells_, affected);
  return Status::ok;
}

// Updates counts and sums, after everything else.
void MovingBalls::sum_up(uint32_t affected, Patience &patience) {
  const BallSet &balls = records_.balls;
  changed_count_ = 0;
  for (uint32_t k = 0; k < records_.noted(); ++k) {
    if (!patience.allows(500)) return;
    const JournalEntry &entry = records_.entry(k);
    const uint32_t i = entry.ball;
    MovingBall &ball = records_.ball[i];
    // The term of the volume is about the component's origin: that may be another ball, or may have moved.
    if (k < affected || ball.origin != entry.before.origin || records_.is_moved(ball.origin)) {
      records_.list(k);
      ++changed_count_;
    }
    ball.own.measure.volume = ball.faces == 0 ? 0.0
                                              : volume_term(balls.r[i], ball.own.measure.area,
                                                            balls.difference(ball.origin, i), ball.own.vector_area);
    count_ball(entry.before, entry.before.origin == i, false, counts_);
    count_ball(ball, ball.origin == i, true, counts_);
    sums_.set(balls.caller[i], term_of(i));
  }
  if (patience.allows(50 * uint64_t{records_.noted()})) sums_.update();
}

// Restores the balls of the journal, counts and sums.
void MovingBalls::take_back() {
  counts_ = counts_before_;
  for (uint32_t k = 0; k < records_.noted(); ++k) {
    const JournalEntry &entry = records_.entry(k);
    const uint32_t i = entry.ball;
    if (entry.moved) place_again(i, entry.placed);
    records_.ball[i] = entry.before;
    records_.parent[i] = entry.parent;
    sums_.set(records_.balls.caller[i], term_of(i));
  }
  sums_.update();
}

MovingBalls::Sums::Term MovingBalls::term_of(uint32_t i) const {
  const BallGradient &own = records_.ball[i].own;
  const EnergyTerms energy = terms();
  return {{own.measure.area, energy.weights.of(records_.balls, i) * own.measure.area, own.measure.volume,
           gradient_of_energy(lattice(), energy, own).radius}};
}

Status MovingBalls::write(CubeGrid &grid) const {
  if (size() > grid.capacity()) return Status::capacity;
  grid.build(records_.balls, slot_.part(0, size()), cells_.side());
  return Status::ok;
}

BallMeasure MovingBalls::totals() const {
  const Sums::Term total = sums_.total();
  return in_caller_units(lattice(), {total.of[0], total.of[2]});
}

Energy MovingBalls::energy() const {
  const Sums::Term total = sums_.total();
  return energy_of({total.of[1], total.of[2], total.of[3]}, lattice(), tension_, pressure_);
}

BallMeasure MovingBalls::measure(uint32_t caller) const {
  return in_caller_units(lattice(), record(caller).own.measure);
}

EnergyGradient MovingBalls::gradient(uint32_t caller) const {
  const MovingBall &ball = record(caller);
  EnergyGradient gradient = gradient_of_energy(lattice(), terms(), ball.own);
  gradient.one_sided = ball.one_sided;
  return gradient;
}

}  // namespace hsp
