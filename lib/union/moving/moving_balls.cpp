#include "moving/moving_balls.hpp"

#include "measure/tangency.hpp"

namespace hsp {
namespace {

// Balls that are computed together, and how far they reach: what is around them is gathered once for all.
constexpr uint32_t most_in_group = 64;
constexpr int64_t most_sides = 3;

// On a sphere with m caps, at most 6 m - 12 vertices are free (Kedem and others 1986), and m circles. More room is for
// groups: it saves halving them.
BoundaryLimits limits_of_part(const MovingLimits &limits) {
  const uint64_t m = limits.neighbours;
  return {limits.balls, limits.neighbours, clamped_count(6 * m + 16 * most_in_group),
          clamped_count(m + 4 * most_in_group), 0};
}

void stretch(int64_t value, int64_t &low, int64_t &high) {
  low = value < low ? value : low;
  high = value > high ? value : high;
}

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

}  // namespace

void MovingBalls::carve(Workspace &workspace, const MovingLimits &limits) {
  limits_ = limits;
  needed_ = {};
  records_.carve(workspace, limits.balls);
  cells_.carve(workspace, limits.balls);
  components_.carve(workspace, limits.balls);
  sums_.carve(workspace, limits.balls);
  place_ = workspace.take<uint32_t>(limits.balls);
  new_ball_ = workspace.take<exact::LatticeBall>(limits.balls);
  weight_ = workspace.take<double>(limits.balls);
  part_.carve(workspace, limits_of_part(limits));
  near_.carve(workspace, limits.balls);
  near_ball_ = workspace.take<uint32_t>(static_cast<uint64_t>(limits.balls) + 1);
  in_group_ = workspace.take<uint8_t>(limits.balls);
  records_.balls.n = 0;
  may_undo_ = false;
}

Status MovingBalls::set(const CubeGrid &grid, const EnergyTerms &terms) {
  const BallSet &given = grid.balls();
  const uint32_t n = given.n;
  records_.clear(0);
  sums_.resize(0);
  counts_ = {};
  may_undo_ = false;
  needed_ = {};
  if (n > limits_.balls) {
    needed_.balls = n;
    return Status::capacity;
  }
  BallSet &balls = records_.balls;
  records_.clear(n);
  balls.lattice = near_.lattice = given.lattice;
  balls.probe_steps = given.probe_steps;
  cells_.clear(n, grid.side());
  components_.clear(n);
  sums_.resize(n);
  tension_ = terms.tension;
  pressure_ = terms.pressure;
  touching_balls_ = terms.weights.touching_balls;
  weighted_ = terms.weights.weight != nullptr;
  for (uint32_t i = 0; i < n; ++i) {
    const exact::LatticeBall ball = given.ball(i);
    balls.store(i, ball);
    place_[ball.index] = i;
    if (weighted_) weight_[ball.index] = terms.weights.weight[ball.index];
    in_group_[i] = 0;
    cells_.insert(i, ball.centre);
    MovingBall own{};
    own.origin = own.next = own.previous = i;
    records_.ball[i] = own;
    records_.parent[i] = no_id;
    records_.note_moved(i);
    count_ball(own, true, true, counts_);
  }
  components_.span(records_, cells_);
  const Status status = update(n);
  needed_.balls = n;
  if (status != Status::ok) {
    records_.clear(0);
    sums_.resize(0);
    counts_ = {};
    return status;
  }
  records_.begin();
  changed_count_ = 0;
  return Status::ok;
}

Status MovingBalls::move(const BallMoves &moves, uint32_t &first_bad) {
  needed_ = {};
  if (const Status status = stage(moves, first_bad); status != Status::ok) return status;
  records_.begin();
  counts_before_ = counts_;
  for (uint32_t k = 0; k < moves.count; ++k) {
    const uint32_t i = place_[moves.ball[k]];
    if (!stays_put(records_.balls.ball(i), new_ball_[k])) records_.note_moved(i);
  }
  const uint32_t former = moves.count == 1 ? place_one(moves.ball[0]) : place_all(moves);
  const Status status = update(former);
  needed_.balls = size();
  may_undo_ = status == Status::ok;
  if (may_undo_) return status;
  put_back();
  records_.begin();
  changed_count_ = 0;
  return status;
}

Status MovingBalls::undo() {
  if (!may_undo_) return Status::state;
  may_undo_ = false;
  put_back();
  counts_ = counts_before_;
  for (uint32_t k = 0; k < records_.noted(); ++k) {
    const uint32_t i = records_.entry(k).ball;
    sums_.set(records_.balls.caller[i], term_of(i));
  }
  sums_.update();
  return Status::ok;
}

// Rounds the balls that are to move. Nothing of them is stored yet.
Status MovingBalls::stage(const BallMoves &moves, uint32_t &first_bad) {
  first_bad = no_id;
  Status status = Status::ok;
  uint32_t staged = 0;
  for (uint32_t k = 0; k < moves.count && status == Status::ok; ++k) {
    const uint32_t caller = moves.ball[k];
    if (caller >= size() || in_group_[place_[caller]] != 0) {
      status = Status::id;
    } else {
      status = round_move(moves, k);
    }
    if (status != Status::ok) {
      first_bad = k;
    } else {
      in_group_[place_[caller]] = 1;
      staged = k + 1;
    }
  }
  for (uint32_t k = 0; k < staged; ++k) in_group_[place_[moves.ball[k]]] = 0;
  return status;
}

Status MovingBalls::round_move(const BallMoves &moves, uint32_t k) {
  const BallSet &balls = records_.balls;
  const exact::LatticeBall before = balls.ball(place_[moves.ball[k]]);
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
  cells_.insert(i, ball.centre);
}

// Notes what the balls that are noted meet where they are, places all that move anew, and notes what these meet then.
// Returns how many had been noted before that.
uint32_t MovingBalls::place_all(const BallMoves &moves) {
  const uint32_t moved = records_.noted();
  for (uint32_t k = 0; k < moved; ++k) note_meeting(records_.entry(k).placed);
  const uint32_t former = records_.noted();
  for (uint32_t k = 0; k < moves.count; ++k) place_again(place_[moves.ball[k]], new_ball_[k]);
  components_.begin(records_, former);
  for (uint32_t k = 0; k < moved; ++k) note_what_meets(records_.entry(k).ball);
  return former;
}

// The same for the only ball that moves, whose neighbours are looked up once if it does not go far.
uint32_t MovingBalls::place_one(uint32_t caller) {
  const uint32_t i = place_[caller];
  const exact::LatticeBall before = records_.balls.ball(i);
  const exact::Vector &p = before.centre, &q = new_ball_[0].centre;
  const auto is_near = [this](int64_t a, int64_t b) { return a - b < cells_.side() && b - a < cells_.side(); };
  if (records_.noted() == 0 || !is_near(p.x, q.x) || !is_near(p.y, q.y) || !is_near(p.z, q.z))
    return place_all({1, &caller, nullptr, nullptr});
  uint32_t later = 0;
  cells_.visit_meeting(records_.balls, before, new_ball_[0], [&](uint32_t j, bool met_before) {
    if (met_before) {
      records_.note(j);
    } else {
      near_ball_[later++] = j;
    }
  });
  const uint32_t former = records_.noted();
  place_again(i, new_ball_[0]);
  for (const uint32_t j : near_ball_.part(0, later)) records_.note(j);
  components_.begin(records_, former);
  for (uint32_t k = 1; k < records_.noted(); ++k) {
    const uint32_t j = records_.entry(k).ball;
    if (BallCells::is_met(records_.balls, new_ball_[0], j)) components_.connect(records_, i, j);
  }
  return former;
}

void MovingBalls::note_meeting(const exact::LatticeBall &ball) {
  cells_.visit_meeting(records_.balls, ball, [this](uint32_t j) { records_.note(j); });
}

// The same for a ball at its new position.
void MovingBalls::note_what_meets(uint32_t i) {
  cells_.visit_meeting(records_.balls, records_.balls.ball(i), [this, i](uint32_t j) {
    records_.note(j);
    components_.connect(records_, i, j);
  });
}

// What is in the journal is to be computed again. The first `former` balls of it are as for ComponentUpdate.
Status MovingBalls::update(uint32_t former) {
  const uint32_t affected = records_.noted();
  if (const Status status = compute(affected); status != Status::ok) {
    components_.abandon(records_, former);
    return status;
  }
  components_.apply(records_, cells_, former);
  settle(affected);
  flag_inner_contacts(affected);
  return Status::ok;
}

// If there is no room for all neighbours of a ball, the rest is done to learn how many others have.
Status MovingBalls::compute(uint32_t affected) {
  for (uint32_t first = 0; first < affected;) {
    uint32_t count = choose_group(first, affected);
    Status status = compute_group(count);
    // A single ball has room for all of its vertices.
    while (status != Status::ok && count > 1 && part_.needed().neighbours <= limits_.neighbours) {
      count = choose_group(first, first + count / 2);
      status = compute_group(count);
    }
    needed_.neighbours = larger_count(needed_.neighbours, part_.needed().neighbours);
    first += count;
  }
  return needed_.neighbours <= limits_.neighbours ? Status::ok : Status::capacity;
}

Status MovingBalls::compute_group(uint32_t count) {
  gather_around(count);
  const Status status = part_.build(near_, count, centre_, static_cast<double>(cells_.side()));
  if (status == Status::ok) {
    store_group(count);
  }
  return status;
}

// Takes balls of the journal from `first` on into near_, as many as lie together. Returns their number.
uint32_t MovingBalls::choose_group(uint32_t first, uint32_t last) {
  const BallSet &balls = records_.balls;
  const int64_t most = most_sides * cells_.side();
  uint32_t count = 0;
  for (uint32_t k = first; k < last && count < most_in_group; ++k) {
    const uint32_t i = records_.entry(k).ball;
    const exact::LatticeBall ball = balls.ball(i);
    const exact::Vector &c = ball.centre;
    exact::Vector low = count == 0 ? c : low_, high = count == 0 ? c : high_;
    stretch(c.x, low.x, high.x);
    stretch(c.y, low.y, high.y);
    stretch(c.z, low.z, high.z);
    if (high.x - low.x > most || high.y - low.y > most || high.z - low.z > most) break;
    low_ = low;
    high_ = high;
    near_.store(count, ball);
    near_ball_[count++] = i;
  }
  return count;
}

// Behind the group in near_, all balls that meet one of it, and some more.
void MovingBalls::gather_around(uint32_t count) {
  const BallSet &balls = records_.balls;
  const auto middle = [](int64_t a, int64_t b) { return 0.5 * static_cast<double>(a + b); };
  centre_[0] = middle(low_.x, high_.x);
  centre_[1] = middle(low_.y, high_.y);
  centre_[2] = middle(low_.z, high_.z);
  const auto squared_distance = [this](const BallSet &set, uint32_t i) {
    const double dx = set.x[i] - centre_[0], dy = set.y[i] - centre_[1], dz = set.z[i] - centre_[2];
    return dx * dx + dy * dy + dz * dz;
  };
  double reach = 0.0, largest = 0.0;
  for (uint32_t k = 0; k < count; ++k) {
    in_group_[near_ball_[k]] = 1;
    const double own = std::sqrt(squared_distance(near_, k)) + near_.r[k];
    reach = own > reach ? own : reach;
    largest = near_.r[k] > largest ? near_.r[k] : largest;
  }
  // Above all rounding errors.
  reach = reach * (1.0 + 0x1p-40) + 1.0;
  uint32_t n = count;
  const int64_t around = static_cast<int64_t>(largest) + cells_.side() / 2;
  cells_.visit_box({low_.x - around, low_.y - around, low_.z - around},
                   {high_.x + around, high_.y + around, high_.z + around}, [&](uint32_t j) {
                     const double sum = reach + balls.r[j];
                     // No branch, as whether this ball is taken is hard to predict.
                     near_ball_[n] = j;
                     n += static_cast<uint32_t>(squared_distance(balls, j) <= sum * sum) &
                          static_cast<uint32_t>(in_group_[j] == 0);
                   });
  for (uint32_t k = count; k < n; ++k) {
    const uint32_t j = near_ball_[k];
    near_.x[k] = balls.x[j];
    near_.y[k] = balls.y[j];
    near_.z[k] = balls.z[j];
    near_.r[k] = balls.r[j];
    near_.caller[k] = balls.caller[j];
  }
  near_.n = n;
  for (uint32_t k = 0; k < count; ++k) in_group_[near_ball_[k]] = 0;
}

void MovingBalls::store_group(uint32_t count) {
  const Boundary &boundary = part_.boundary();
  const AreaWeights own_weights = weights();
  for (uint32_t k = 0; k < count; ++k) {
    MovingBall &ball = records_.ball[near_ball_[k]];
    ball.own = gradient_of_ball(near_, boundary, own_weights, k);
    ball.half_edges = boundary.half_edges(k).size();
    ball.circles = boundary.circles(k).size();
    ball.loops = boundary.loops(k).size();
    ball.faces = boundary.faces(k).size();
    ball.contained = boundary.is_contained(k);
    ball.one_sided = ball.own.one_sided;
  }
}

// Counts and sums, once everything else is known.
void MovingBalls::settle(uint32_t affected) {
  const BallSet &balls = records_.balls;
  changed_count_ = 0;
  for (uint32_t k = 0; k < records_.noted(); ++k) {
    const JournalEntry &entry = records_.entry(k);
    const uint32_t i = entry.ball;
    MovingBall &ball = records_.ball[i];
    // Terms of the volume are about the component's origin, which may be another one, or elsewhere.
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
  sums_.update();
}

// As before all that is in the journal.
void MovingBalls::put_back() {
  for (uint32_t k = 0; k < records_.noted(); ++k) {
    const JournalEntry &entry = records_.entry(k);
    const uint32_t i = entry.ball;
    if (entry.moved) place_again(i, entry.placed);
    records_.ball[i] = entry.before;
    records_.parent[i] = entry.parent;
  }
}

// A ball inside others that touches one of them at a free point: both have one-sided derivatives. Whether it does
// depends on balls alone that meet either.
void MovingBalls::flag_inner_contacts(uint32_t affected) {
  if (counts_.contained == 0) return;
  for (uint32_t first = 0; first < affected;) {
    const uint32_t count = choose_group(first, affected);
    gather_around(count);
    flag_group(count);
    first += count;
  }
}

void MovingBalls::flag_group(uint32_t count) {
  const CubeBlock everything{{{0, near_.n}}, 1};
  const auto record = [this](uint32_t k) -> MovingBall & { return records_.ball[near_ball_[k]]; };
  const auto touches = [&](uint32_t inner, uint32_t outer) {
    return inner != outer && (near_.r[inner] != near_.r[outer] || record(outer).faces != 0) &&
           touches_freely_from_inside(near_, everything, inner, outer);
  };
  for (uint32_t inner = 0; inner < near_.n; ++inner) {
    if (!record(inner).contained) continue;
    if (inner < count) {
      for (uint32_t outer = 0; outer < near_.n; ++outer) {
        if (touches(inner, outer)) record(inner).one_sided = true;
      }
    }
    for (uint32_t outer = 0; outer < count; ++outer) {
      if (touches(inner, outer)) record(outer).one_sided = true;
    }
  }
}

MovingBalls::Sums::Term MovingBalls::term_of(uint32_t i) const {
  const BallGradient &own = records_.ball[i].own;
  const EnergyTerms energy = terms();
  return {{own.measure.area, energy.weights.of(records_.balls, i) * own.measure.area, own.measure.volume,
           gradient_of_energy(lattice(), energy, own).radius}};
}

Status MovingBalls::write(CubeGrid &grid) const {
  if (size() > grid.capacity()) return Status::capacity;
  grid.build(records_.balls, place_.part(0, size()), cells_.side());
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
