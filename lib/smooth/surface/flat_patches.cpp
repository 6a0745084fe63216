#include "surface/flat_patches.hpp"

#include "core/elementary.hpp"
#include "core/sorting.hpp"
#include "surface/covered_gaps.hpp"

namespace hsp {
namespace {

// In (-pi, pi].
double within_half_turn(double angle) {
  if (angle > pi) return angle - 2 * pi;
  return angle <= -pi ? angle + 2 * pi : angle;
}

}  // namespace

bool is_flat(const BallSet &balls, const Boundary &boundary, const Position &position, uint32_t vertex, Vec3 &normal) {
  const VertexRecord &record = boundary.vertex(vertex);
  const Vec3 n =
      cross(balls.difference(record.ball[0], record.ball[1]), balls.difference(record.ball[0], record.ball[2]));
  const double length = std::sqrt(dot(n, n));
  if (!(length > 0.0)) return false;
  normal = (record.positive() ? 1.0 : -1.0) / length * n;
  const double above = dot(normal, balls.difference(position.ball, record.ball[0]) - position.offset);
  return 2 * std::fabs(above) < coincident_distance * static_cast<double>(balls.probe_steps);
}

bool FlatPatches::find(uint32_t vertex) {
  vertex_ = vertex;
  count_ = 0;
  if (!look(vertex)) return false;
  // The balls in the order of their directions, after the widest gap between two.
  uint32_t order[3] = {0, 1, 2};
  sort_three(order[0], order[1], order[2], [this](uint32_t a, uint32_t b) { return angle_[a] < angle_[b]; });
  uint32_t first = 0;
  double widest = 0.0;
  for (uint32_t k = 0; k < 3; ++k) {
    const double gap = angle_[order[k]] - angle_[order[(k + 2) % 3]] + (k == 0 ? 2 * pi : 0.0);
    if (gap > widest) {
      widest = gap;
      first = k;
    }
  }
  const uint32_t a = order[first];
  const uint32_t m = order[(first + 1) % 3];
  const uint32_t b = order[(first + 2) % 3];
  const double at_a = angle_[a];
  const double at_m = angle_[m] + (angle_[m] < at_a ? 2 * pi : 0.0);
  const double at_b = angle_[b] + (angle_[b] < at_a ? 2 * pi : 0.0);
  Chain by_m;
  if (!add_side(a, m, at_a, at_m, by_m) || !add_side(m, b, at_m, at_b, by_m)) return false;
  if (widest < pi - 1e-9) {
    return add_side(b, a, at_b, at_a + 2 * pi, by_m) && find_ring(by_m) && count_ <= most_arcs;
  }
  Chain direct;
  if (!add_side(a, b, at_a, at_b, direct)) return false;
  // Around a vertex on the positive side the sides lead from ball 0 to 1 to 2, as counted in its record.
  const bool positive = boundary_.vertex(vertex).positive();
  const bool direct_forwards = ((b + 3 - a) % 3 == 1) == positive;
  return (direct_forwards ? find_strips(direct, by_m) : find_strips(by_m, direct)) && count_ <= most_arcs;
}

bool FlatPatches::look(uint32_t vertex) {
  const VertexRecord &record = boundary_.vertex(vertex);
  const Position at = grid_.position(vertex);
  if (!is_flat(balls_, boundary_, at, vertex, normal_)) return false;
  Vec3 to[3];
  for (uint32_t t = 0; t < 3; ++t) to[t] = balls_.difference(at.ball, record.ball[t]) - at.offset;
  x_ = combine(1.0, to[0], -dot(normal_, to[0]), normal_);
  const double arm = std::sqrt(dot(x_, x_));
  if (!(arm > 0.0)) return false;
  x_ = (1.0 / arm) * x_;
  y_ = cross(normal_, x_);
  for (uint32_t t = 0; t < 3; ++t) angle_[t] = direction_of(to[t]);
  return true;
}

double FlatPatches::direction_of(const Vec3 &v) const {
  const double angle = arc_tangent(dot(v, y_), dot(v, x_));
  return angle < 0.0 ? angle + 2 * pi : angle;
}

// From the ball at one direction to that at another, with its cusps.
bool FlatPatches::add_side(uint32_t from, uint32_t to, double from_angle, double to_angle, Chain &chain) {
  const VertexRecord &record = boundary_.vertex(vertex_);
  const uint32_t slot = 3 - from - to;
  const uint32_t lower = from < to ? from : to;
  const uint32_t upper = from < to ? to : from;
  if (cusped_.of_arc(record.ball[lower], record.ball[upper]) == no_id) {
    chain.item[chain.count++] = {slot, false, from_angle, to_angle};
    return true;
  }
  const CirclePosition circle = position_of_circle(balls_, record.ball[from], record.ball[to]);
  const double half = half_way_between_cusps(balls_, circle.radius);
  const Position at = grid_.position(vertex_);
  const Vec3 middle = balls_.difference(at.ball, circle.centre.ball) + (circle.centre.offset - at.offset);
  const double start = within_half_turn(direction_of(combine(1.0, middle, -half, circle.axis)) - angle_[from]);
  const double end = within_half_turn(direction_of(combine(1.0, middle, half, circle.axis)) - angle_[to]);
  const double first = from_angle + (start > 0.0 ? start : 0.0);
  const double last = to_angle + (end < 0.0 ? end : 0.0);
  if (!(first < last)) return false;
  chain.item[chain.count++] = {slot, false, from_angle, first};
  chain.item[chain.count++] = {slot, true, first, last};
  chain.item[chain.count++] = {slot, false, last, to_angle};
  return true;
}

uint32_t FlatPatches::across_side(uint32_t slot) const {
  uint32_t e = boundary_.half_edge_at(vertex_, (slot + 1) % 3);
  if (boundary_.half_edge(e).circle == boundary_.vertex(vertex_).ball[slot]) {
    e = boundary_.half_edge_at(vertex_, (slot + 2) % 3);
  }
  return gap_behind(balls_, boundary_, chosen_, boundary_.ball_of(e), e).vertex;
}

// The vertex across must be at the same position on the other side of the plane.
bool FlatPatches::add_crease(uint32_t across, double angle) {
  if (across == no_id || across == vertex_) return false;
  const Vec3 to = grid_.difference(balls_, vertex_, across);
  const double most = coincident_distance * static_cast<double>(balls_.probe_steps);
  Vec3 normal;
  if (!(dot(to, to) < most * most)) return false;
  if (!is_flat(balls_, boundary_, grid_.position(across), across, normal) || !(dot(normal, normal_) < -0.5))
    return false;
  add(across, angle);
  return true;
}

// The part of a chain between two directions, in its order or backwards.
bool FlatPatches::add_between(const Chain &chain, double first, double last, bool backwards) {
  for (uint32_t step = 0; step < chain.count; ++step) {
    const Item &item = chain.item[backwards ? chain.count - 1 - step : step];
    const double from = item.from > first ? item.from : first;
    const double to = item.to < last ? item.to : last;
    if (item.is_gap) {
      if (from < to && !add_crease(across_side(item.slot), to - from)) return false;
    } else if (item.from >= first && item.to <= last) {
      add(PatchArc::side(item.slot), to - from);
    }
  }
  return true;
}

// A strip ends where gaps of both chains begin to overlap. If both begin there, or end there, the crease from one
// cusp to the other has no length, but it is there.
bool FlatPatches::find_strips(const Chain &forwards, const Chain &backwards) {
  const double last = forwards.item[forwards.count - 1].to;
  double at = forwards.item[0].from;
  uint32_t tie_behind = no_id;
  for (;;) {
    double end = last;
    double next = last;
    uint32_t tie = no_id;
    uint32_t next_tie = no_id;
    for (uint32_t f = 0; f < forwards.count; ++f) {
      for (uint32_t b = 0; b < backwards.count; ++b) {
        const Item &one = forwards.item[f];
        const Item &other = backwards.item[b];
        if (!one.is_gap || !other.is_gap) continue;
        const double from = one.from > other.from ? one.from : other.from;
        const double to = one.to < other.to ? one.to : other.to;
        if (!(from < to) || from < at || from >= end) continue;
        end = from;
        next = to;
        tie = one.from == other.from ? one.slot : no_id;
        next_tie = one.to == other.to ? one.slot : no_id;
      }
    }
    if (!add_between(forwards, at, end, false)) return false;
    if (tie != no_id && !add_crease(across_side(tie), 0.0)) return false;
    if (!add_between(backwards, at, end, true)) return false;
    if (tie_behind != no_id && !add_crease(across_side(tie_behind), 0.0)) return false;
    end_loop(true);
    if (next >= last && next_tie == no_id && end >= last) return true;
    at = next;
    tie_behind = next_tie;
  }
}

// Sides all around, and the crease opposite to them.
bool FlatPatches::find_ring(const Chain &around) {
  uint32_t first = 0;
  while (first < around.count && !around.item[first].is_gap) ++first;
  if (first == around.count) {
    for (uint32_t k = 0; k < around.count; ++k) add(PatchArc::side(around.item[k].slot), 0.0);
    end_loop(false);
    if (!add_crease(across_side(around.item[0].slot), 2 * pi)) return false;
    end_loop(true);
    return true;
  }
  double angle = 0.0;
  for (uint32_t k = 1; k <= around.count; ++k) {
    const Item &item = around.item[(first + k) % around.count];
    if (!item.is_gap) {
      add(PatchArc::side(item.slot), item.to - item.from);
      angle += item.to - item.from;
      continue;
    }
    if (!add_crease(across_side(item.slot), angle)) return false;
    end_loop(true);
    angle = 0.0;
  }
  return true;
}

void FlatPatches::store(CutPatches &cut) const {
  bool begins = true;
  for (uint32_t k = 0; k < count_; ++k) {
    if (begins) cut.begin_piece(vertex_, 0.0, 0.0);
    begins = arc_[k].last_of_piece;
    cut.add_arc(arc_[k].across, arc_[k].angle, arc_[k].last_of_loop);
  }
}

}  // namespace hsp
