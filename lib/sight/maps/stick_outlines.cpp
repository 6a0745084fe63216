#include "maps/stick_outlines.hpp"

namespace hsp {
namespace {

const StickView &as_view(const void *source) {
  return *static_cast<const StickView *>(source);
}
uint32_t ball_of_path(const void *view, uint32_t path) {
  return as_view(view).paths[path].ball;
}
void visit_path(const void *view, const BallSet &, uint32_t path, const ArcVisitor &visitor) {
  visit_outline(as_view(view), path, visitor);
}
uint32_t body_of_path(const void *view, const BallSet &balls, uint32_t path) {
  const StickPath &record = as_view(view).paths[path];
  return record.stick == no_id ? record.ball : balls.n + 2 * record.stick + record.part;
}
bool is_stick(const void *view, uint32_t path) {
  return as_view(view).paths[path].stick != no_id;
}

constexpr PaintedPaths::Functions of_sticks{ball_of_path, visit_path, nullptr, is_stick, body_of_path};

}  // namespace

PaintedPaths paths_of(const StickView &view) {
  return {view.frame, view.paths.size(), &view, of_sticks};
}

// Under the other part the overlap is at most as long as that part. Under the ball the overlap is hidden: the ball's
// front is over the stick wherever the axis is beyond the junction circle, except in the caps inside other sticks. All
// points of such a cap are within `reach` of the middle of its circle.
double overlap_of(const StickView &view, const Stick &stick, uint32_t part) {
  if (part + 1 < stick.parts) {
    const double half = 0.5 * (stick.last - stick.middle());
    return half < stick.radius ? half : stick.radius;
  }
  const double inside = stick.length - stick.last;
  const double overlap = 0.25 * inside;
  const Segment axis = stick.axis_between(stick.last, stick.last + overlap).flat();
  for (const StickBite &bite : view.bites_of(stick.ball[1])) {
    const Stick &other = view.sticks[bite.stick];
    if (other.caller == stick.caller) continue;
    const double height = view.balls[stick.ball[1]].r - (other.length - other.last);
    const double reach = stick.radius + std::sqrt(other.radius * other.radius + height * height);
    const Vec3 middle = other.on_axis(other.last);
    if (closest_points(axis, Vec3{middle.x, middle.y, 0.0}).squared < reach * reach) return 0.0;
  }
  return overlap;
}

}  // namespace hsp
