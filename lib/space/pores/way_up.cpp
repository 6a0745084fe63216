#include "pores/way_up.hpp"

#include <initializer_list>

#include "core/extremes.hpp"
#include "core/sorting.hpp"

namespace hsp {
namespace {

constexpr uint32_t most_steps = 100000;
constexpr int most_windows = 400;
constexpr uint32_t most_passed = 16;
constexpr uint32_t most_tied_tried = 8;
constexpr uint32_t known_ends = 256;  // a power of two

bool is_of_curve(const TangentCurve &curve, uint32_t ball) {
  return ball == curve.base || ball == curve.second || (!curve.in_plane && ball == curve.third);
}

}  // namespace

void WayUp::carve(Workspace &workspace, uint32_t near, uint32_t balls) {
  near_balls_.carve(workspace, near, balls);
  near_ = FixedVector<uint32_t>(workspace.take<uint32_t>(near));
  known_ = workspace.take<KnownEnd>(known_ends);
  passed_ = workspace.take<Passed>(most_passed);
  tied_ = FixedVector<uint32_t>(workspace.take<uint32_t>(near));
  lines_ = workspace.make<TangentLines>(1);
  directions_ = workspace.take<Vec3>(near);
}

void WayUp::prepare(PoreBalls &all) {
  all_ = &all;
  balls_ = all.box() == nullptr ? &all.set() : &near_balls_.set();
  for (KnownEnd &known : known_) known.vertex.name.ball[0] = no_id;
  steps_ = 0;
  needed_near_ = 0;
  near_balls_.reset(all);
  beyond_reach_ = false;
  all.find_box(low_, high_);
  const Vec3 size = high_ - low_;
  extent_ = std::sqrt(dot(size, size)) * (1.0 + 0x1p-50) + 4.0;
}

uint32_t WayUp::number_of(uint32_t ball, const BoxShift &shift) {
  return all_->box() == nullptr ? ball : near_balls_.add(ball, shift);
}

bool WayUp::is_tied(uint32_t ball) const {
  for (const uint32_t each : tied_.items()) {
    if (each == ball) return true;
  }
  return false;
}

// The first of the nearest balls that gets nearer at once on a way; no_id if there is none. from_lowest: whether the
// way begins at the lowest point of its curve, in the plane of the centres.
uint32_t WayUp::find_nearer(const Way &way, bool from_lowest) const {
  for (const uint32_t ball : tied_.items()) {
    if (is_of_curve(way.curve, ball)) continue;
    const int departure = from_lowest ? departure_from_lowest(*balls_, way.curve, way.side, ball)
                                      : point_.departure(way.curve, way.side, ball);
    if (departure < 0) return ball;
  }
  return no_id;
}

// Begins with three balls whose triangle has the gate in its inside. If another ball gets nearer on their curve, it
// takes the place of one of them, so that f is lower on the new curve. Ends with three balls on whose curve no other
// ball gets nearer. False if the gate is on a side of one of the triangles.
bool WayUp::find_lowest(const TangentCurve &named, int side, Way &way) {
  way = {named, side};
  bool on_side = false;
  if (!is_in_triangle(*balls_, point_, named.base, named.second, named.third, on_side) || on_side) return false;
  for (uint32_t turn = 0; turn < tied_.size(); ++turn) {
    const uint32_t nearer = find_nearer(way, true);
    if (nearer == no_id) return true;
    const TangentCurve before = way.curve;
    for (uint32_t corner = 0; corner < 3; ++corner) {
      way.curve = {corner == 0 ? nearer : before.base, corner == 1 ? nearer : before.second,
                   corner == 2 ? nearer : before.third};
      const auto &[base, second, third, in_plane] = way.curve;
      if (!are_collinear(*balls_, base, second, third) &&
          is_in_triangle(*balls_, point_, base, second, third, on_side)) {
        break;
      }
      if (corner == 2) return false;
    }
    if (on_side) return false;
    way.side = turn_alike(*balls_, named, way.curve) ? side : -side;
  }
  return false;
}

// Finds the way up from a gate on the given side of the plane of its first three balls. Of many tied balls only those
// that stay as near as the lowest three are on the way.
bool WayUp::leave_gate(const TangentCurve &named, int side, Way &way) {
  const bool many = tied_.size() > most_tied_tried, known = many && find_lowest(named, side, way);
  near_.clear();
  for (uint32_t k = 0; many && k < tied_.size(); ++k) {
    const uint32_t ball = tied_[k];
    if (!known || is_of_curve(way.curve, ball) || departure_from_lowest(*balls_, way.curve, way.side, ball) == 0) {
      near_.push(ball);
    }
  }
  const Span<const uint32_t> tied = many ? near_.items() : tied_.items();
  for (uint32_t a = 0; a < tied.size(); ++a) {
    for (uint32_t b = a + 1; b < tied.size(); ++b) {
      for (uint32_t c = b + 1; c < tied.size(); ++c) {
        way.curve = {tied[a], tied[b], tied[c]};
        bool on_side = false;
        if (tied_.size() > 3 && (are_collinear(*balls_, tied[a], tied[b], tied[c]) ||
                                 !is_in_triangle(*balls_, point_, tied[a], tied[b], tied[c], on_side))) {
          continue;
        }
        way.side = tied_.size() == 3 || turn_alike(*balls_, named, way.curve) ? side : -side;
        if (is_open(way, true)) return true;
      }
    }
  }
  return false;
}

// Finds the way up from the point where the last one has ended. False at a maximum, which has none.
bool WayUp::leave(Way &way) {
  const TangentCurve before = way.curve;
  const Span<const uint32_t> tied = tied_.items();
  TiedDirections directions(*balls_, point_, tied, directions_);
  if (directions.surround() ||
      (tied.size() > most_tied_tried && kind_of(*balls_, point_, tied, directions) == PointKind::maximum)) {
    return false;
  }
  // If many balls tie, most of them, and most pairs, are on no curve that leads up. Those that may be are noted in
  // near_, as the balls near the way are no longer needed.
  const bool many = tied.size() > most_tied_tried;
  bool in_one_plane = true;
  near_.clear();
  for (uint32_t k = 0; many && k < tied.size(); ++k) {
    const bool inner = directions.is_inner(k);
    in_one_plane = in_one_plane && !inner;
    if (!inner) near_.push(k);
  }
  const uint32_t count = many ? near_.size() : tied.size();
  const auto outer = [&](uint32_t k) { return many ? near_[k] : k; };
  const auto is_inner = [&](uint32_t a, uint32_t b) { return many && directions.is_inner(a, b); };
  // Inside a triangle of balls in one plane with the point no way up has a positive slope at first.
  const bool level = many && directions.surround_in_plane(in_one_plane);
  for (uint32_t i = 0; i < count && !level; ++i) {
    for (uint32_t j = i + 1; j < count; ++j) {
      const uint32_t a = outer(i), b = outer(j);
      if (is_inner(a, b)) {
        in_one_plane = false;
        continue;
      }
      for (uint32_t k = j + 1; k < count; ++k) {
        const uint32_t c = outer(k);
        if (directions.is_known_in_plane(a, b, c)) continue;
        if (directions.is_closed(a, b, c)) {
          in_one_plane = false;
          continue;
        }
        way.curve = {tied[a], tied[b], tied[c]};
        way.side = directions.side_of_plane(a, b, c);
        if (way.side == 0) continue;
        in_one_plane = false;
        if (!directions.is_closed(a, b, c, way.side) && is_open(way, false)) return true;
      }
    }
  }
  // The point may be like a gate that is closed on one side: in a triangle, and in its plane.
  for (uint32_t i = 0; i < count; ++i) {
    for (uint32_t j = i + 1; j < count; ++j) {
      const uint32_t a = outer(i), b = outer(j);
      if (is_inner(a, b)) continue;
      for (uint32_t k = j + 1; k < count; ++k) {
        const uint32_t c = outer(k);
        way.curve = {tied[a], tied[b], tied[c]};
        bool on_side = false;
        if (directions.is_off_plane(a, b, c) || directions.is_closed(a, b, c) ||
            directions.side_of_plane(a, b, c) != 0 || are_collinear(*balls_, tied[a], tied[b], tied[c]) ||
            !is_in_triangle(*balls_, point_, tied[a], tied[b], tied[c], on_side)) {
          continue;
        }
        for (const int side : {1, -1}) {
          way.side = side;
          if (is_open(way, true)) return true;
        }
      }
    }
  }
  return in_one_plane && leave_in_plane(before, way);
}

bool WayUp::leave_in_plane(const TangentCurve &before, Way &way) {
  const Span<const uint32_t> tied = tied_.items();
  for (uint32_t a = 0; a < tied.size(); ++a) {
    for (uint32_t b = a + 1; b < tied.size(); ++b) {
      // The third ball of the plane: a tied ball that is not on the line of the two; else that of the curve before.
      uint32_t third = before.third;
      for (const uint32_t ball : tied) {
        if (ball != tied[a] && ball != tied[b] && !are_collinear(*balls_, tied[a], tied[b], ball)) third = ball;
      }
      if (are_collinear(*balls_, tied[a], tied[b], third)) continue;
      way.curve = {tied[a], tied[b], third, true};
      const int here = point_.side_of_curve(way.curve);
      for (const int side : {1, -1}) {
        way.side = side;
        if ((here == side || here == 0) && is_open(way, here == 0)) return true;
      }
    }
  }
  return false;
}

// Gathers in near_ the balls that can be nearest somewhere on a piece of a curve: from z = `from` up to the level `to`.
Status WayUp::gather(const CurveShape &shape, const TangentCurve &curve, double from, int64_t to) {
  const BallSet &balls = *balls_;
  const uint32_t base = curve.base;
  const double level = static_cast<double>(to), z = 2.0 * (balls.r[base] + level);
  const double error = shape.error_up_to(z);
  LatticeQuery query{balls.ball(base).centre, 0};
  // At first around the base's centre, from which no point is farther than z / 2.
  double reach = 0.5 * z;
  if (error < 0.25 * z) {
    const CurvePiece piece(shape, from, z);
    const double low = piece.low, high = piece.high;
    const double along = 0.5 * (z - from) * std::sqrt(dot(shape.q, shape.q)), across = 0.5 * (high - low);
    const double half = 0.5 * (std::sqrt(along * along + across * across) * (1.0 + 1e-9) + 2.0 * error) + 2.0;
    if (half < reach) {
      reach = half;
      const Vec3 y = combine(0.5, shape.p + 0.5 * (from + z) * shape.q, 0.25 * (low + high), shape.e);
      query.centre = {query.centre.x + nearest(y.x), query.centre.y + nearest(y.y), query.centre.z + nearest(y.z)};
    }
  }
  reach += level + 2.0;
  if (!(reach < exact::query_radius_limit)) return Status::range;
  query.radius = reach > 0.0 ? static_cast<int64_t>(reach) + 1 : 0;
  near_.clear();
  bool room = true;
  room = all_->visit_near(query, [&](uint32_t ball, const BoxShift &shift) {
    const uint32_t k = number_of(ball, shift);
    room = room && k != no_id;
    if (k != no_id) near_.push(k);
  }) && room;
  needed_near_ = larger_count(needed_near_, all_->needed_near());
  return room ? Status::ok : Status::capacity;
}

// Finds the first point of a curve above point_ at which one of the gathered balls is as near. False if there is none.
bool WayUp::first_event(const Way &way, const CurvePiece &whole, TangentPoint &event) {
  bool any = false;
  CurvePiece piece = whole;
  for (const uint32_t ball : near_.items()) {
    if (is_of_curve(way.curve, ball) || piece.is_far_from(*balls_, way.curve.base, ball)) continue;
    TangentPoint at[2] = {TangentPoint(lines_[0]), TangentPoint(lines_[0])};
    bool there[2], above[2], certain[2];
    TangentPoint::find_both(*balls_, way.curve, ball, at, there);
    for (const uint32_t root : {0U, 1U}) {
      const double difference = at[root].level_estimate() - point_.level_estimate();
      const double error = at[root].level_error() + point_.level_error();
      certain[root] = !there[root] || std::fabs(difference) > error;
      above[root] = there[root] && difference > error;
    }
    // If the ball is tied at point_, one of the two points is point_ itself.
    const bool known = is_tied(ball) && (certain[0] || certain[1]);
    for (const uint32_t root : {0U, 1U}) {
      if (!certain[root]) above[root] = !known && at[root].compare_levels(point_) > 0;
      if (!above[root]) continue;
      if (any && at[root].level_estimate() - at[root].level_error() > event.level_estimate() + event.level_error())
        continue;
      if (at[root].side_of_curve(way.curve) != way.side) continue;
      // If the ball is tied at `event`, it meets the curve there: in this root, if the other one is not near the event.
      const auto is_near_event = [&](uint32_t which) {
        return there[which] && std::fabs(at[which].level_estimate() - event.level_estimate()) <=
                                   at[which].level_error() + event.level_error();
      };
      const bool beside = any && is_near_event(root) && !is_near_event(1 - root);
      const bool tied = beside && event.nearness(ball) == 0;
      const bool later = any && !tied && at[root].compare_levels(event) >= 0;
      if (tied || later) continue;
      event = at[root];
      any = true;
      // The piece ends at the event: balls that the curve meets later do not matter.
      const double to = 2.0 * (balls_->r[way.curve.base] + event.level_estimate() + event.level_error() + 1.0);
      if (to > piece.from && to < piece.to) piece = CurvePiece(*piece.shape, piece.from, to);
    }
  }
  return any;
}

bool WayUp::is_beyond_box(const CurveShape &shape, uint32_t base, double z) const {
  const BallSet &balls = *balls_;
  if (0.5 * z > extent_) return true;
  const double error = 0.5 * shape.error_at(z) + 2.0;
  if (!(error < extent_)) return false;
  const Vec3 y = combine(0.5, shape.p + z * shape.q, 0.5 * shape.height(z), shape.e);
  const Vec3 x{balls.x[base] + y.x, balls.y[base] + y.y, balls.z[base] + y.z};
  return x.x > high_.x + error || x.x < low_.x - error || x.y > high_.y + error || x.y < low_.y - error ||
         x.z > high_.z + error || x.z < low_.z - error;
}

// Follows a way to its next point, and finds all balls that are nearest there. Sets `outside` if it leads outside.
Status WayUp::follow(const Way &way, bool &outside) {
  const BallSet &balls = *balls_;
  CurveShape shape(balls, way.curve);
  const bool unbounded = is_unbounded(balls, way.curve, shape);
  TangentPoint top(lines_[0]);
  if (!unbounded && !top.find(balls, way.curve, no_id, true)) return Status::check;
  if (way.side < 0) shape.e = -shape.e;
  const double radius = balls.r[way.curve.base];
  Vec3 position{};
  double start = point_.level_estimate(), error = point_.level_error();
  if (trace_ != nullptr || !(error < 4.0)) error = point_.refine(position, start);
  const double from = 2.0 * (radius + start - error);
  double window = larger_of(0.12 * (radius + start), 16.0);
  for (int turn = 0; turn < most_windows; ++turn, window *= 1.7) {
    const double reached = start + window;
    if (!(reached < 0x1p50)) return Status::range;
    const int64_t to = nearest(reached);
    const bool whole = !unbounded && top.level_against(to) <= 0;
    if (const Status status = gather(shape, way.curve, from > 0.0 ? from : 0.0, to); status != Status::ok)
      return status;
    const CurvePiece piece(shape, from > 0.0 ? from : 0.0, 2.0 * (radius + static_cast<double>(to)));
    TangentPoint event(lines_[0]);
    bool met = first_event(way, piece, event);
    if (met && event.level_against(to) > 0) met = false;
    if (!met && !whole) {
      if (!unbounded || all_->box() != nullptr ||
          !is_beyond_box(shape, way.curve.base, 2.0 * (radius + static_cast<double>(to))))
        continue;
      outside = true;
      if (trace_ != nullptr) trace(way, shape, {start, error}, {static_cast<double>(to), 0.0});
      return Status::ok;
    }
    point_ = met ? event : top;
    if (trace_ != nullptr) {
      double end = 0.0;
      const double end_error = point_.refine(position, end);
      // At the top of a curve no error counts: behind it the curve goes down again, and no other ball is nearer there.
      trace(way, shape, {start, error}, {end, met ? end_error : 0.0});
    }
    tied_.clear();
    for (uint32_t k = 0; k < near_.size(); ++k) {
      const bool far = piece.is_far_from(balls, way.curve.base, near_[k]);
      if (!far && point_.nearness(near_[k]) == 0) tied_.push(near_[k]);
    }
    sort_in_place(tied_.items(), [&](uint32_t a, uint32_t b) { return balls.ranks_before(a, b); });
    return beyond_reach_ ? Status::range : Status::ok;
  }
  return Status::check;
}

// Appends points of a curve: at least 1 / longest_part of them, at distances of at most `apart` times that of the
// centres of its balls. A point is left out if doubles know it no better than to some steps. Near the lowest and the
// highest point of a curve the level changes with the square of the way. So between two levels that may be the same the
// curve may seem long though it has no length. And a point that is not certainly between the two levels may be far
// behind the end of the curve, where another ball is nearer.
void WayUp::trace(const Way &way, const CurveShape &shape, const RoundedLevel &from, const RoundedLevel &to) {
  constexpr double longest_part = 0x1p-3, shortest_part = 0x1p-16, apart = 1.0 / 12.0;
  const BallSet &balls = *balls_;
  const TangentCurve &curve = way.curve;
  const Vec3 centre{balls.x[curve.base], balls.y[curve.base], balls.z[curve.base]};
  const uint32_t nearest[3] = {curve.base, curve.second, curve.third};
  const uint32_t count = curve.in_plane ? 2 : 3;
  double least_radius = balls.r[curve.base];
  for (uint32_t b = 1; b < count; ++b) least_radius = smaller_of(least_radius, balls.r[nearest[b]]);
  WayPoint point{};
  for (uint32_t b = 0; b < 3; ++b) {
    point.ball[b] = no_id;
    if (b >= count) continue;
    const BoxShift shift = shift_of(nearest[b]);
    beyond_reach_ = beyond_reach_ || !SmallShift::fits(shift);
    point.ball[b] = ball_of(nearest[b]);
    point.shift[b] = SmallShift::of(shift);
  }
  const auto level_at = [&](double u) { return from.level + u * u * (3.0 - 2.0 * u) * (to.level - from.level); };
  const auto z_at = [&](double u) { return 2.0 * (balls.r[curve.base] + level_at(u)); };
  const auto from_base = [&](double z) { return 0.5 * combine(1.0, shape.p + z * shape.q, shape.height(z), shape.e); };
  Vec3 last = from_base(z_at(0.0));
  double part = longest_part;
  for (double u = 0.0; u < 1.0;) {
    const double z = z_at(u + part);
    const Vec3 y = from_base(z), step = y - last;
    const double most = apart * (level_at(u) + least_radius);
    if (dot(step, step) > most * most && part > shortest_part) {
      part *= 0.5;
      continue;
    }
    u += part;
    last = y;
    const double pairs = 0.5 * u / part;
    if (part < longest_part && pairs == static_cast<double>(static_cast<uint32_t>(pairs))) part *= 2.0;
    point.level = level_at(u);
    const bool between = point.level - from.level > from.error && to.level - point.level >= to.error;
    const double off = between ? 0.0 : 2.0 * larger_of(from.error, to.error);
    if (!(shape.error_at(z, off) < 64.0)) continue;
    point.position = centre + y;
    trace_->push(point);
  }
}

Status WayUp::climb(const CriticalPoint &gate, Span<const uint32_t> tied, Span<const SmallShift> shifts,
                    bool other_side, End &end) {
  end = {};
  needed_near_ = larger_count(needed_near_, tied.size());
  if (tied.size() > near_.capacity()) return Status::capacity;
  near_balls_.begin();
  tied_.clear();
  for (uint32_t k = 0; k < tied.size(); ++k) tied_.push(number_of(tied[k], shifts[k].shift()));
  const auto number = [&](uint32_t k) { return number_of(gate.ball[k], gate.shift[k].shift()); };
  const TangentCurve named{number(0), number(1), number(2)};
  point_ = TangentPoint(lines_[0]);
  if (!point_.find(*balls_, named, no_id, false)) return Status::check;
  Way way;
  if (!leave_gate(named, other_side ? -1 : 1, way)) return beyond_reach_ ? Status::range : Status::check;
  uint32_t count = 0;
  Status status = Status::check;
  for (uint32_t step = 0; step < most_steps; ++step) {
    ++steps_;
    status = follow(way, end.outside);
    if (status != Status::ok || end.outside) break;
    if (trace_ == nullptr && count < passed_.size() && name_vertex(passed_[count].vertex)) {
      Passed &passed = passed_[count];
      passed.shift = shift_of(tied_[0]);
      const KnownEnd &known = known_end(passed.vertex);
      if (known.vertex == passed.vertex) {
        end = known.end;
        end.shift = end.shift + passed.shift;
        break;
      }
      ++count;
    }
    status = Status::check;  // after the last step
    if (leave(way)) continue;
    status = name_end(end);
    break;
  }
  for (uint32_t k = 0; status == Status::ok && k < count; ++k) {
    const Passed &passed = passed_[k];
    KnownEnd &known = known_end(passed.vertex);
    known = {passed.vertex, end};
    known.end.shift = end.shift - passed.shift;
  }
  return status;
}

// Names point_ if four balls tie there and no more. False if that is not known.
bool WayUp::name_vertex(Vertex &vertex) const {
  vertex.rising = point_.is_rising();
  return tied_.size() == 4 && point_.is_of_four() && put_name(tied_.items().data(), vertex.name);
}

// Names a point by four balls, with shifts relative to the first. False if an image is too many boxes away from it.
bool WayUp::put_name(const uint32_t *four, PointName &name) const {
  const BoxShift first = shift_of(four[0]);
  for (uint32_t k = 0; k < 4; ++k) {
    const BoxShift shift = shift_of(four[k]) - first;
    if (!SmallShift::fits(shift)) return false;
    name.ball[k] = ball_of(four[k]);
    name.shift[k] = SmallShift::of(shift);
  }
  return true;
}

WayUp::KnownEnd &WayUp::known_end(const Vertex &vertex) {
  uint32_t hash = vertex.rising ? 1 : 0;
  for (const uint32_t ball : vertex.name.ball) hash = hash * 31 + ball;
  return known_[hash % known_.size()];
}

Status WayUp::name_end(End &end) {
  if (beyond_reach_) return Status::range;
  uint32_t four[4];
  name_of(*balls_, point_, tied_.items(), PointKind::maximum, directions_, four);
  end.shift = shift_of(four[0]);
  return put_name(four, end.name) ? Status::ok : Status::range;
}

}  // namespace hsp
