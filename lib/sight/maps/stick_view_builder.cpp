#include "maps/stick_view_builder.hpp"

#include <initializer_list>

#include "core/elementary.hpp"
#include "core/sorting.hpp"

namespace hsp {
namespace {

// Finds how a stick cuts the disc of the ball at its nearer end. At the angle t the junction circle is by
// radius h sin t - u_z d higher than the ball's centre, d the distance of the circle's plane from that centre. False if
// the circle is lower everywhere, or if the stick is inside its balls.
bool find_bite(const Stick &stick, StickBite &bite) {
  if (stick.parts == 0) return false;
  const double d = stick.length - stick.last;
  const double sine = stick.axis.z * d;
  const double most = stick.radius * stick.seen;
  if (sine >= most) return false;
  const double cosine = std::sqrt((most - sine) * (most + sine));
  bite.from = arc_tangent(sine, cosine);
  bite.middle = arc_tangent(-stick.e[1], -stick.e[0]);
  // Half the chord is radius cos t, and its distance from the centre d / h.
  bite.half = arc_tangent(cosine, d);
  return true;
}

}  // namespace

void StickViewBuilder::carve(Workspace &workspace, const StickLimits &limits) {
  limit(limits);
  const uint64_t bodies = limits.balls + 2 * static_cast<uint64_t>(limits.sticks);
  view_.carve(workspace, limits);
  sweep_.carve(workspace, limits);
  sorter_.carve(workspace, limits);
  pairs_ = FixedVector<StickPair>(workspace.take<StickPair>(limits.pairs));
  grid_of_ = workspace.take<uint32_t>(limits.balls);
  depth_ = workspace.take<double>(bodies);
  order_ = workspace.take<uint32_t>(bodies);
  map_.carve(workspace, limits);
}

Status StickViewBuilder::refuse(StickConflict conflict, uint32_t first, uint32_t second) {
  violation_ = {conflict, first, second};
  return Status::conflict;
}

Status StickViewBuilder::begin(const BallSet &balls, const ViewDirection &direction, uint32_t count) {
  needed_ = {};
  violation_ = {};
  view_.clear();
  map_.clear();
  if (const Status status = look_from(direction, view_.frame); status != Status::ok) return status;
  needed_.balls = balls.n;
  needed_.sticks = count;
  if (balls.n > limits_.balls || count > limits_.sticks) return Status::capacity;
  balls_ = balls.n;
  centre_on(balls, view_.frame);
  for (uint32_t i = 0; i < balls_; ++i) {
    view_.balls[i] = {view_.frame.centre_of(balls, i), balls.r[i]};
    grid_of_[balls.caller[i]] = i;
  }
  return Status::ok;
}

Status StickViewBuilder::add_stick(const BallSet &balls, uint32_t k, const StickEnds &ends, double radius) {
  if (ends.first >= balls_) return refuse(StickConflict::no_ball, k, ends.first);
  if (ends.second >= balls_) return refuse(StickConflict::no_ball, k, ends.second);
  if (ends.first == ends.second) return refuse(StickConflict::same_ends, k, k);
  const uint32_t one = grid_of_[ends.first];
  const uint32_t other = grid_of_[ends.second];
  if (ends.strands != StickStrands::one) radius *= radius_of_several;
  for (const uint32_t ball : {one, other}) {
    if (!(view_.balls[ball].r > radius)) return refuse(StickConflict::thin_ball, k, balls.caller[ball]);
  }
  Stick stick = make_stick(one, other, radius, k, ends.whole);
  stick.strands = ends.strands;
  view_.sticks.push(stick);
  return Status::ok;
}

// The stick between two balls, numbered in grid order. The first one owns it if it is whole.
Stick StickViewBuilder::make_stick(uint32_t one, uint32_t other, double radius, uint32_t caller, bool whole) const {
  const double foot_z = view_.balls[one].centre.z;
  const double top_z = view_.balls[other].centre.z;
  const bool swapped = foot_z != top_z ? foot_z > top_z : one > other;
  const uint32_t foot = swapped ? other : one;
  const uint32_t top = swapped ? one : other;
  const Vec3 d = view_.balls[top].centre - view_.balls[foot].centre;
  Stick stick{};
  if (dot(d, d) > 0.0) stick = stick_between(view_.balls[foot], view_.balls[top], radius);
  stick.ball[0] = foot;
  stick.ball[1] = top;
  stick.caller = caller;
  stick.owner[0] = whole ? one : foot;
  stick.owner[1] = whole ? one : top;
  stick.turned = swapped ? 1 : 0;
  stick.radius = radius;
  stick.inside = !(stick.first < stick.last);
  stick.parts = stick.inside ? 0 : whole ? 1 : 2;
  return stick;
}

// Finds the bites, sorted by balls, and those of a ball by angles.
void StickViewBuilder::find_bites() {
  const Span<uint32_t> first = view_.first_bite;
  StickBite bite{};
  view_.bites.set_count(sort_to_rows(
      first, balls_, view_.sticks.size(),
      [&](uint32_t k) { return find_bite(view_.sticks[k], bite) ? view_.sticks[k].ball[1] : balls_; },
      [&](uint32_t at, uint32_t k) {
        bite.stick = k;
        view_.bites.room()[at] = bite;
      }));
  for (uint32_t i = 0; i < balls_; ++i) {
    sort_in_place(view_.bites.items().part(first[i], first[i + 1]), [](const StickBite &a, const StickBite &b) {
      return a.middle != b.middle ? a.middle < b.middle : a.stick < b.stick;
    });
  }
}

StickPath StickViewBuilder::path_of(uint32_t body) const {
  if (body < balls_) return {body, no_id, 0};
  const uint32_t k = (body - balls_) / 2;
  const uint32_t part = (body - balls_) % 2;
  return {view_.sticks[k].owner[part], k, part};
}

void StickViewBuilder::add_paths(uint32_t bodies) {
  for (const uint32_t body : order_.part(0, bodies)) {
    const StickPath path = path_of(body);
    if (path.stick == no_id) {
      if (view_.balls[body].r > 0.0) view_.paths.push(path);
      continue;
    }
    const Stick &stick = view_.sticks[path.stick];
    if (path.part < stick.parts && !hidden_by_top(stick, path.part, view_.balls[stick.ball[1]].r)) {
      view_.paths.push(path);
    }
  }
}

void StickViewBuilder::find_depths() {
  for (uint32_t i = 0; i < balls_; ++i) depth_[i] = view_.balls[i].centre.z;
  for (uint32_t k = 0; k < view_.sticks.size(); ++k) {
    const Stick &stick = view_.sticks[k];
    for (uint32_t part = 0; part < 2; ++part) {
      const bool real = part < stick.parts;
      const double s = real ? 0.5 * (stick.begin_of(part) + stick.end_of(part)) : stick.last;
      depth_[balls_ + 2 * k + part] = stick.on_axis(s).z;
    }
  }
}

Status StickViewBuilder::find_pairs(const BallSet &balls, Patience &patience) {
  violation_ = sweep_.find(view_, balls.caller.part(0, balls_), pairs_, patience);
  if (!patience.allows(0)) return Status::stopped;
  if (violation_.conflict != StickConflict::none) return Status::conflict;
  needed_.pairs = larger_count(needed_.pairs, clamped_count(pairs_.required()));
  return pairs_.overflowed() ? Status::capacity : Status::ok;
}

Status StickViewBuilder::finish(const BallSet &balls, bool as_map, Patience &patience) {
  if (const Status status = find_pairs(balls, patience); status != Status::ok) return status;
  find_depths();
  violation_ = sweep_.meeting();
  if (violation_.conflict != StickConflict::none) return find_map(balls, patience);
  const uint32_t bodies = balls_ + 2 * view_.sticks.size();
  const uint32_t placed = sorter_.sort(pairs_.items(), depth_.part(0, bodies), order_.part(0, bodies));
  if (placed < bodies) {
    const DrawingOrder::Cycle cycle = sorter_.find_cycle(pairs_.items(), bodies);
    // A cycle contains a stick, as balls alone have none; the last body of a cycle is one, as balls have lower numbers.
    violation_ = {StickConflict::cycle, view_.sticks[path_of(cycle.last).stick].caller, cycle.length};
    return find_map(balls, patience);
  }
  if (!patience.allows(500 * uint64_t{bodies})) return Status::stopped;
  if (as_map) return find_map(balls, patience);
  find_bites();
  add_paths(bodies);
  return Status::ok;
}

// Moves all balls, and makes the sticks again. A stick that was inside its balls stays out: the sweep knows nothing of
// it.
void StickViewBuilder::move(const BallSet &balls, const Perturbation &perturbation) {
  for (uint32_t i = 0; i < balls_; ++i) {
    view_.balls[i].centre = moved_centre(balls, i, view_.frame.centre_of(balls, i), perturbation);
  }
  for (Stick &stick : view_.sticks.items()) {
    const bool whole = stick.owner[0] == stick.owner[1];
    const bool inside = stick.inside;
    const StickStrands strands = stick.strands;
    stick = make_stick(stick.ball[stick.turned], stick.ball[1 - stick.turned], stick.radius, stick.caller, whole);
    stick.inside = inside;
    stick.strands = strands;
    if (inside) stick.parts = 0;
  }
}

// If rounding decides one and the same question in two ways, or if moved bodies meet that only touched, all balls are
// moved a little more.
Status StickViewBuilder::find_map(const BallSet &balls, Patience &patience) {
  const StickViolation reason = violation_;
  for (const Perturbation &perturbation : perturbations) {
    Status status = Status::ok;
    if (perturbation.size > 0.0) {
      move(balls, perturbation);
      status = find_pairs(balls, patience);
      if (status == Status::conflict) continue;
    }
    if (status == Status::ok) status = find_moved_map(balls, perturbation, patience);
    if (status == Status::check) continue;
    violation_ = reason;
    return status;
  }
  violation_ = {};
  map_.clear();
  return Status::degenerate;
}

// A stick that the ball at its top hides as a whole is left out: that ball hides all that the stick would hide.
Status StickViewBuilder::find_moved_map(const BallSet &balls, const Perturbation &perturbation, Patience &patience) {
  for (Stick &stick : view_.sticks.items()) {
    if (stick.parts > 0 && hidden_by_top(stick, 0, view_.balls[stick.ball[1]].r)) stick.parts = 0;
  }
  find_bites();
  const uint32_t bodies = balls_ + 2 * view_.sticks.size();
  const Status status = map_.build(view_, pairs_.items(), sweep_.boxes(), depth_.part(0, bodies), patience);
  needed_.edges = larger_count(needed_.edges, map_.needed_edges());
  if (status != Status::ok) return status;
  map_.set_frame(view_.frame, perturbation.size * static_cast<double>(balls.largest_radius));
  view_.paths.clear();
  const StickMap &map = map_.structure();
  for (uint32_t p = 0; p < map.owners; ++p) view_.paths.push(path_of(map.owner_of(p)));
  return Status::ok;
}

}  // namespace hsp
