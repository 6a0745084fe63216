#include "paths/widest_probe.hpp"

#include "cells/cell_location.hpp"
#include "core/sorting.hpp"
#include "paths/free_segments.hpp"

namespace hsp {
namespace {

using exact::Vector;
double distance_to(const BallSet &balls, uint32_t ball, const Vector &x) {
  return distance(balls.ball(ball).centre, x);
}

// The most that a ball can grow so that the point stays outside; negative if it is inside now.
int64_t most_growth(const BallSet &balls, uint32_t ball, const Vector &x) {
  exact::LatticeBall grown = balls.ball(ball);
  int64_t most = nearest(distance_to(balls, ball, x)) - grown.radius + 2;
  for (grown.radius += most; most >= 0 && sign_of_power(grown, x) <= 0; --grown.radius) --most;
  return most;
}

}  // namespace

void WidestProbeFinder::carve(Workspace &workspace, const ProbeLimits &limits) {
  limits_ = limits;
  xyz_ = workspace.take<double>(3 * static_cast<uint64_t>(limits.balls));
  radius_ = workspace.take<double>(limits.balls);
  grid_.carve(workspace, limits.balls);
  builder_.carve(workspace, limits.cells);
}

ProbeLimits WidestProbeFinder::retry_limits() const {
  const auto step = [](uint32_t limit, uint32_t needed) {
    return needed > limit ? clamped_count(static_cast<uint64_t>(needed) + needed / 2) : limit;
  };
  return {each_limit(limits_.cells, needed_.cells, step), larger_count(limits_.balls, needed_.balls)};
}

// Whether a probe passes, whose radius leaves both points outside the grown balls.
Status WidestProbeFinder::pass(int64_t probe, bool &passes) {
  uint32_t bad = 0;
  Status status = grid_.build({n_, xyz_.data(), radius_.data(), static_cast<double>(probe), 1.0}, bad);
  if (status != Status::ok) return status;
  status = builder_.build(grid_);
  needed_.cells = covering(needed_.cells, builder_.needed());
  if (status != Status::ok) return status;
  ++builds_;
  const FreeSpace &space = builder_.structure();
  const auto region_at = [&](const Vector &point) {
    const uint32_t cell = cell_at(grid_.balls(), space, point);
    return cell == no_id ? no_id : space.cell(cell).region;
  };
  const uint32_t here = region_at(from_), there = to_outside_ ? 0 : region_at(to_);
  passes = here != no_id && here == there;
  return Status::ok;
}

// A point beyond all centres along an axis gets away from all of them along it, to the outside, with every probe that
// it is outside the balls for.
bool WidestProbeFinder::is_beyond_centres(const BallSet &balls, const Vector &x) const {
  const double at[3] = {static_cast<double>(x.x), static_cast<double>(x.y), static_cast<double>(x.z)};
  const Span<double> centres[3] = {balls.x, balls.y, balls.z};
  for (uint32_t axis = 0; axis < 3; ++axis) {
    bool above = true, below = true;
    for (uint32_t i = 0; i < n_ && (above || below); ++i) {
      above = above && at[axis] >= centres[axis][i];
      below = below && at[axis] <= centres[axis][i];
    }
    if (above || below) return true;
  }
  return false;
}

Status WidestProbeFinder::find(const BallSet &balls, const Vector &from, const Vector *to, WidestProbe &widest) {
  bool open = false;
  const Status status = begin(balls, from, to, widest, open);
  return status == Status::ok && open ? narrow(balls, -1.0, widest) : status;
}

Status WidestProbeFinder::begin(const BallSet &balls, const Vector &from, const Vector *to, WidestProbe &widest,
                                bool &open) {
  open = false;
  widest = {false, 0.0, {no_id, no_id, no_id}};
  builds_ = 0;
  needed_ = {{}, balls.n};
  if (balls.n > limits_.balls) return Status::capacity;
  n_ = balls.n;
  from_ = from;
  to_outside_ = to == nullptr;
  to_ = to_outside_ ? from : *to;
  if (n_ == 0) {
    widest = {true, std::numeric_limits<double>::infinity(), {no_id, no_id, no_id}};
    return Status::ok;
  }
  most_ = INT64_MAX;
  for (uint32_t i = 0; i < n_; ++i) {
    const uint32_t caller = balls.caller[i];
    xyz_[3 * caller] = balls.x[i];
    xyz_[3 * caller + 1] = balls.y[i];
    xyz_[3 * caller + 2] = balls.z[i];
    radius_[caller] = balls.r[i];
    const int64_t here = most_growth(balls, i, from_), there = most_growth(balls, i, to_);
    most_ = here < most_ ? here : most_;
    most_ = there < most_ ? there : most_;
  }
  if (most_ < 0) return Status::ok;
  if (is_beyond_centres(balls, from_) && (to_outside_ || is_beyond_centres(balls, to_))) {
    widest.passes = true;
    touched_ball(balls, widest);
    return Status::ok;
  }
  if (const Status status = pass(0, open); status != Status::ok || !open) return status;
  widest.passes = true;
  return Status::ok;
}

// Passages are narrow as a rule, and grown balls cost much: beside the guess, then doubled steps from below, then
// halved ones.
Status WidestProbeFinder::narrow(const BallSet &balls, double guess, WidestProbe &widest) {
  const int64_t room = static_cast<int64_t>(exact::radius_limit) - 1 - balls.largest_radius;
  const int64_t widest_tried = most_ < room ? most_ : room;
  int64_t open = 0, closed = widest_tried + 1;
  bool passes = false;
  for (int64_t beside = 0; beside < 2 && guess >= 0.0; ++beside) {
    const double below = static_cast<double>(widest_tried - beside);
    const int64_t probe = static_cast<int64_t>(guess < below ? guess : below) + beside;
    if (probe <= open || probe >= closed) continue;
    if (const Status status = pass(probe, passes); status != Status::ok) return status;
    (passes ? open : closed) = probe;
  }
  for (int64_t step = balls.largest_radius / 4 + 1; open < widest_tried && closed > widest_tried; step *= 2) {
    const int64_t probe = step < widest_tried - open ? open + step : widest_tried;
    if (const Status status = pass(probe, passes); status != Status::ok) return status;
    (passes ? open : closed) = probe;
  }
  if (open == most_) {
    touched_ball(balls, widest);
    return Status::ok;
  }
  if (open == room) return Status::range;
  while (closed - open > 1) {
    const int64_t probe = open + (closed - open) / 2;
    if (const Status status = pass(probe, passes); status != Status::ok) return status;
    (passes ? open : closed) = probe;
  }
  widest.radius = static_cast<double>(open);
  find_gate(open, widest);
  return Status::ok;
}

// The ball that is nearest to one of the points; of several the one with the lowest index.
void WidestProbeFinder::touched_ball(const BallSet &balls, WidestProbe &widest) const {
  double least = std::numeric_limits<double>::infinity();
  for (uint32_t i = 0; i < n_; ++i) {
    const double here = distance_to(balls, i, from_), there = distance_to(balls, i, to_);
    const double gap = (here < there ? here : there) - balls.r[i];
    if (gap < least || (gap == least && balls.caller[i] < widest.gate[0])) {
      least = gap;
      widest.gate[0] = balls.caller[i];
    }
  }
  widest.radius = least;
}

// Whether the passage between three balls closes for a probe of `probe` + `beyond`, within one step, and where its
// centre is then, from that of ball i.
bool WidestProbeFinder::closes(uint32_t i, uint32_t j, uint32_t k, int64_t probe, double &beyond, Vec3 &at) const {
  const BallSet &balls = grid_.balls();
  const double grown = static_cast<double>(probe - balls.probe_steps);
  const double r = balls.r[i] + grown, rj = balls.r[j] + grown, rk = balls.r[k] + grown;
  const Vec3 v = balls.difference(i, j), s = balls.difference(i, k);
  const double vv = dot(v, v), vs = dot(v, s), ss = dot(s, s), area = vv * ss - vs * vs;
  if (!(area > 1e-12 * vv * ss)) return false;
  // y.v = a, y.s = b with y = alpha v + beta s.
  const auto in_plane = [&](double a, double b, double &alpha, double &beta) {
    alpha = (a * ss - b * vs) / area;
    beta = (b * vv - a * vs) / area;
  };
  double alpha_0, beta_0, alpha_1, beta_1;
  in_plane(0.5 * (vv + (r - rj) * (r + rj)), 0.5 * (ss + (r - rk) * (r + rk)), alpha_0, beta_0);
  in_plane(r - rj, r - rk, alpha_1, beta_1);
  const Vec3 y_0 = combine(alpha_0, v, beta_0, s), y_1 = combine(alpha_1, v, beta_1, s);
  // (|y_1|^2 - 1) q^2 + 2 (y_0.y_1 - r) q + |y_0|^2 - r^2 = 0, of whose roots the small one is wanted.
  const double length = std::sqrt(dot(y_0, y_0));
  const double c = (length - r) * (length + r), half = dot(y_0, y_1) - r, square = dot(y_1, y_1) - 1.0;
  const double root = half * half - square * c;
  if (!(root >= 0.0)) return false;
  const double divisor = -half + (half <= 0.0 ? std::sqrt(root) : -std::sqrt(root));
  if (divisor == 0.0) return false;
  beyond = c / divisor;
  if (!(beyond >= -0.01 && beyond <= 1.01)) return false;
  const double alpha = alpha_0 + beyond * alpha_1, beta = beta_0 + beyond * beta_1;
  if (!(alpha >= -1e-9 && beta >= -1e-9 && alpha + beta <= 1.0 + 1e-9)) return false;
  at = y_0 + beyond * y_1;
  return true;
}

// Whether another ball, grown by the probe, covers the point at which three close.
bool WidestProbeFinder::is_covered(uint32_t i, uint32_t j, uint32_t k, const Vec3 &at, double probe) const {
  const BallSet &balls = grid_.balls();
  const double grown = probe - static_cast<double>(balls.probe_steps);
  for (uint32_t l = 0; l < n_; ++l) {
    if (l == i || l == j || l == k) continue;
    const Vec3 d = balls.difference(i, l) - at;
    const double reach = balls.r[l] + grown - 4.0;
    if (reach > 0.0 && dot(d, d) < reach * reach) return true;
  }
  return false;
}

// Of the triples that close between `probe` and the next step the one that does last. The grid still has the balls
// grown by one of the two.
void WidestProbeFinder::find_gate(int64_t probe, WidestProbe &widest) const {
  const BallSet &balls = grid_.balls();
  const double grown = static_cast<double>(probe + 1 - balls.probe_steps);
  const auto meet = [&](uint32_t i, uint32_t j) {
    const Vec3 d = balls.difference(i, j);
    const double sum = balls.r[i] + balls.r[j] + 2.0 * grown + 2.0;
    return dot(d, d) <= sum * sum;
  };
  double last = -1.0;
  for (uint32_t i = 0; i < n_; ++i) {
    const CubeBlock block = grid_.block_around(grid_.cube_at(balls.ball(i).centre));
    const auto for_each_met = [&](uint32_t first, auto visit) {
      for (uint32_t range = 0; range < block.ranges; ++range) {
        const BallRange &row = block.range[range];
        for (uint32_t j = row.first > first ? row.first : first; j < row.last; ++j) {
          if (meet(i, j)) visit(j);
        }
      }
    };
    for_each_met(i + 1, [&](uint32_t j) {
      for_each_met(j + 1, [&](uint32_t k) {
        double beyond = 0.0;
        Vec3 at{};
        if (!meet(j, k) || !closes(i, j, k, probe, beyond, at) || beyond <= last) return;
        if (is_covered(i, j, k, at, static_cast<double>(probe) + beyond)) return;
        last = beyond;
        widest.radius = static_cast<double>(probe) + beyond;
        uint32_t *const gate = widest.gate;
        gate[0] = balls.caller[i];
        gate[1] = balls.caller[j];
        gate[2] = balls.caller[k];
        sort_three(gate[0], gate[1], gate[2]);
      });
    });
  }
}

}  // namespace hsp
