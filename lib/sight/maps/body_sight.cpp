#include "maps/body_sight.hpp"

#include "core/first_index.hpp"

namespace hsp {
namespace {

// Of a radius: what is closer to a contour, or two fronts that are closer to each other, roundings may decide.
constexpr double doubtful = 0x1p-30;

}  // namespace

BodySight::BodySight(const StickScene &scene, Span<const SweptBox> items) : scene_(scene), items_(items) {
  for (const SweptBox &item : items) {
    const double width = item.right - item.left;
    widest_ = width > widest_ ? width : widest_;
  }
  largest_ = BallScene{scene.balls}.largest();
}

BodySight::Front BodySight::front_at(uint32_t body, double x, double y) const {
  if (scene_.is_ball(body)) {
    const SeenBall &ball = scene_.balls[body];
    if (ball.inside != 0) return {false, true, 0.0};
    const double dx = x - ball.x;
    const double dy = y - ball.y;
    const double squared = ball.r * ball.r - dx * dx - dy * dy;
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

BodySight::Highest BodySight::highest_at(double x, double y, uint32_t except) const {
  const double from = x - widest_;
  uint32_t k = first_index(0, items_.size(), [&](uint32_t i) { return items_[i].left >= from; });
  Highest highest{no_id, true};
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

}  // namespace hsp
