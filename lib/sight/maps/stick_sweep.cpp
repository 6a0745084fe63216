#include "maps/stick_sweep.hpp"

#include <utility>

#include "core/first_index.hpp"
#include "core/sorting.hpp"

namespace hsp {
namespace {

// A fraction of a radius. If a point is closer to a contour than that, or two fronts to each other, rounding may
// decide.
constexpr double doubtful = 0x1p-30;

double squared_distance(const Vec3 &a, const Vec3 &b) {
  const Vec3 d = b - a;
  return dot(d, d);
}

}  // namespace

void StickSweep::carve(Workspace &workspace, const StickLimits &limits) {
  items_ = FixedVector<SweptBox>(workspace.take<SweptBox>(limits.balls + 2 * static_cast<uint64_t>(limits.sticks)));
}

void StickSweep::refuse(StickConflict conflict, uint32_t first, uint32_t second) {
  violation_ = {conflict, first < second ? first : second, first < second ? second : first};
  if (conflict == StickConflict::stick_in_ball) violation_ = {conflict, first, second};
}

void StickSweep::add(bool second_is_above, uint32_t a, uint32_t b) {
  pairs_->push(second_is_above ? StickPair{a, b} : StickPair{b, a});
}

// Balls of equal depths are paired in any fixed order: if they are disjoint, their discs are disjoint, too.
void StickSweep::compare_balls(uint32_t a, uint32_t b) {
  const PlacedBall &one = view_->balls[a];
  const PlacedBall &two = view_->balls[b];
  const double sum = one.r + two.r;
  if (squared_distance(one.centre, two.centre) < sum * sum) {
    if (meeting_.conflict == StickConflict::none) {
      const bool ascending = caller_[a] < caller_[b];
      meeting_ = {StickConflict::balls_meet, caller_[ascending ? a : b], caller_[ascending ? b : a]};
    }
    add(true, a, b);
    add(false, a, b);
    return;
  }
  const double dx = two.centre.x - one.centre.x;
  const double dy = two.centre.y - one.centre.y;
  if (dx * dx + dy * dy < sum * sum) add(two.centre.z > one.centre.z, a, b);
}

void StickSweep::compare_ball_and_part(uint32_t ball, uint32_t body) {
  const Stick &stick = stick_of(body);
  if (stick.ball[0] == ball || stick.ball[1] == ball) return;
  const PlacedBall &placed = view_->balls[ball];
  const Segment axis = stick.axis_of(part_of(body));
  const Vec3 &centre = placed.centre;
  const double sum = stick.radius + placed.r;
  if (closest_points(axis, centre).squared < sum * sum) {
    return refuse(StickConflict::stick_in_ball, stick.caller, caller_[ball]);
  }
  const ClosestPoints seen = closest_points(axis.flat(), Vec3{centre.x, centre.y, 0.0});
  if (seen.squared < sum * sum) add(axis.at(seen.first).z > centre.z, ball, body);
}

void StickSweep::compare_parts(uint32_t a, uint32_t b) {
  const Stick &one = stick_of(a);
  const Stick &two = stick_of(b);
  if (one.caller == two.caller) return;
  // How many ends they share, and both axes from a shared end.
  int shared = 0;
  Vec3 u{}, v{};
  double r = 0.0;
  for (int end = 0; end < 2; ++end) {
    for (int other = 0; other < 2; ++other) {
      if (one.ball[end] != two.ball[other]) continue;
      ++shared;
      u = end == 0 ? one.axis : -one.axis;
      v = other == 0 ? two.axis : -two.axis;
      r = view_->balls[one.ball[end]].r;
    }
  }
  if (shared == 2) return refuse(StickConflict::same_ends, one.caller, two.caller);
  const Segment first = one.axis_of(part_of(a));
  const Segment second = two.axis_of(part_of(b));
  const double sum = one.radius + two.radius;
  if (shared == 1) {
    // sin^2(angle / 2) is a quarter of |u - v|^2.
    const double twice = 2.0 * (one.radius > two.radius ? one.radius : two.radius);
    if (r * r * squared_distance(u, v) < twice * twice) {
      return refuse(StickConflict::sharp_angle, one.caller, two.caller);
    }
  } else if (closest_points(first, second).squared < sum * sum) {
    return refuse(StickConflict::sticks_meet, one.caller, two.caller);
  }
  const ClosestPoints seen = closest_points(first.flat(), second.flat());
  if (seen.squared >= sum * sum) return;
  add(shared == 1 ? v.z > u.z : second.at(seen.second).z > first.at(seen.first).z, a, b);
}

void StickSweep::compare(uint32_t a, uint32_t b) {
  if (a > b) std::swap(a, b);
  if (b < balls_) {
    compare_balls(a, b);
  } else if (a < balls_) {
    compare_ball_and_part(a, b);
  } else {
    compare_parts(a, b);
  }
}

void StickSweep::add_items() {
  items_.clear();
  for (uint32_t i = 0; i < balls_; ++i) {
    const PlacedBall &ball = view_->balls[i];
    if (!(ball.r > 0.0)) continue;
    const Vec3 &c = ball.centre;
    items_.push({c.x - ball.r, c.x + ball.r, c.y - ball.r, c.y + ball.r, i});
  }
  for (uint32_t k = 0; k < view_->sticks.size(); ++k) {
    const Stick &stick = view_->sticks[k];
    for (uint32_t part = 0; part < stick.parts; ++part) {
      const Segment axis = stick.axis_of(part);
      const bool right = axis.to.x > axis.from.x;
      const bool up = axis.to.y > axis.from.y;
      items_.push({(right ? axis.from.x : axis.to.x) - stick.radius, (right ? axis.to.x : axis.from.x) + stick.radius,
                   (up ? axis.from.y : axis.to.y) - stick.radius, (up ? axis.to.y : axis.from.y) + stick.radius,
                   balls_ + 2 * k + part});
    }
  }
  sort_in_place(items_.items(), [](const SweptBox &a, const SweptBox &b) {
    return a.left != b.left ? a.left < b.left : a.body < b.body;
  });
}

StickViolation StickSweep::find(const StickView &view, Span<const uint32_t> caller, FixedVector<StickPair> &pairs,
                                Patience &patience) {
  view_ = &view;
  caller_ = caller;
  pairs_ = &pairs;
  balls_ = caller.size();
  violation_ = {};
  meeting_ = {};
  pairs.clear();
  for (uint32_t k = 0; k < view.sticks.size(); ++k) {
    const Stick &stick = view.sticks[k];
    if (stick.parts == 0) continue;
    const uint32_t first = balls_ + 2 * k;
    pairs.push({stick.ball[0], first});
    if (stick.parts == 2) pairs.push({first, first + 1});
    pairs.push({first + stick.parts - 1, stick.ball[1]});
  }
  add_items();
  if (!patience.allows(500 * uint64_t{items_.size()})) return violation_;
  const Span<const SweptBox> items = items_.items();
  for (uint32_t i = 0; i < items.size() && patience.allows(3000); ++i) {
    for (uint32_t j = i + 1; j < items.size() && items[j].left < items[i].right; ++j) {
      if (items[j].bottom >= items[i].top || items[j].top <= items[i].bottom) continue;
      compare(items[i].body, items[j].body);
      if (violation_.conflict != StickConflict::none) return violation_;
    }
  }
  return violation_;
}

BodySight::BodySight(const StickScene &scene, Span<const SweptBox> items) : scene_(scene), items_(items) {
  for (const SweptBox &item : items) {
    const double width = item.right - item.left;
    widest_ = width > widest_ ? width : widest_;
  }
  largest_ = scene.BallScene::largest();
}

BodySight::Front BodySight::front_at(uint32_t body, double x, double y) const {
  if (scene_.is_ball(body)) {
    const SeenBall &ball = scene_.balls[body];
    if (ball.inside != 0) return {false, true, 0.0};
    const double squared = ball.squared_height(x, y);
    const bool certain = std::fabs(squared) > doubtful * ball.r * ball.r;
    return {squared > 0.0, certain, squared > 0.0 ? ball.z + std::sqrt(squared) : 0.0};
  }
  const Stick &stick = scene_.stick_at(body);
  const uint32_t part = scene_.part_of(body);
  if (part >= stick.parts) return {false, true, 0.0};
  const StickFront front = front_of(stick, x, y);
  bool certain = std::fabs(front.beside) > doubtful * stick.radius;
  if (!front.exists) return {false, certain, 0.0};
  const bool beyond = stick.parts == 2 && front.s >= stick.middle();
  if (stick.parts == 2 && std::fabs(front.s - stick.middle()) < doubtful * stick.length) certain = false;
  return {beyond == (part == 1), certain, front.z};
}

HighestBody BodySight::highest_at(double x, double y, uint32_t except) const {
  const double from = x - widest_;
  uint32_t k = first_index(0, items_.size(), [&](uint32_t i) { return items_[i].left >= from; });
  HighestBody highest{no_id, true};
  double first = 0.0, second = 0.0;
  uint32_t found = 0;
  for (; k < items_.size() && items_[k].left <= x; ++k) {
    const SweptBox &item = items_[k];
    if (item.right < x || item.bottom > y || item.top < y) continue;
    const bool excepted =
        item.body == except || (except != no_id && !scene_.is_ball(except) && !scene_.is_ball(item.body) &&
                                scene_.stick_of(except) == scene_.stick_of(item.body));
    if (excepted) continue;
    const Front front = front_at(item.body, x, y);
    if (!front.certain) highest.certain = false;
    if (!front.exists) continue;
    if (found == 0 || front.z > first) {
      second = first;
      first = front.z;
      highest.body = item.body;
    } else if (found == 1 || front.z > second) {
      second = front.z;
    }
    ++found;
  }
  if (found > 1 && first - second < doubtful * largest_) highest.certain = false;
  return highest;
}

void DrawingOrder::carve(Workspace &workspace, const StickLimits &limits) {
  const uint64_t bodies = limits.balls + 2 * static_cast<uint64_t>(limits.sticks);
  above_.carve(workspace, limits);
  waiting_ = workspace.take<uint32_t>(bodies);
  heap_ = workspace.take<uint32_t>(bodies);
}

uint32_t DrawingOrder::sort(Span<const StickPair> pairs, Span<const double> depth, Span<uint32_t> order) {
  const uint32_t bodies = depth.size();
  for (uint32_t k = 0; k < bodies; ++k) waiting_[k] = 0;
  for (const StickPair &pair : pairs) ++waiting_[pair.above];
  above_.sort(pairs, bodies);

  const auto after = [depth](uint32_t a, uint32_t b) { return depth[a] != depth[b] ? depth[a] > depth[b] : a > b; };
  uint32_t ready = 0;
  const auto push = [&](uint32_t body) {
    heap_[ready] = body;
    sift_up(heap_, ready++, after);
  };
  for (uint32_t k = 0; k < bodies; ++k) {
    if (waiting_[k] == 0) push(k);
  }
  uint32_t placed = 0;
  while (ready > 0) {
    const uint32_t body = heap_[0];
    heap_[0] = heap_[--ready];
    if (ready > 0) sift_down(heap_.part(0, ready), 0, after);
    order[placed++] = body;
    for (const uint32_t above : above_.of(body)) {
      if (--waiting_[above] == 0) push(above);
    }
  }
  return placed;
}

// Every body without a rank lies over another one without a rank. A walk down of as many steps as there are bodies ends
// in a cycle.
DrawingOrder::Cycle DrawingOrder::find_cycle(Span<const StickPair> pairs, uint32_t bodies) {
  for (uint32_t k = 0; k < bodies; ++k) heap_[k] = no_id;
  uint32_t body = no_id;
  for (const StickPair &pair : pairs) {
    if (waiting_[pair.below] == 0 || waiting_[pair.above] == 0) continue;
    heap_[pair.above] = pair.below;
    body = pair.above;
  }
  if (body == no_id) return {no_id, 0};
  for (uint32_t k = 0; k < bodies; ++k) body = heap_[body];
  Cycle cycle{body, 1};
  for (uint32_t other = heap_[body]; other != body; other = heap_[other]) {
    cycle.last = other > cycle.last ? other : cycle.last;
    ++cycle.length;
  }
  return cycle;
}

}  // namespace hsp
