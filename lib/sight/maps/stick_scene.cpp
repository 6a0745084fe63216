#include "maps/stick_scene.hpp"

namespace hsp {

bool StickScene::name(const MapArc &arc, uint32_t end, CornerName &name) const {
  const ArcEnd &label = arc.end[end];
  const bool of_ball = is_ball(arc.body);
  if (label.kind == MapVertexKind::triple) {
    if (!of_ball || arc.nearer == no_id || !is_ball(arc.nearer) || !is_ball(label.body)) return false;
    name = name_of_triple(arc, end);
    return true;
  }
  if (label.kind != MapVertexKind::tangency) return false;
  const uint32_t other = arc.nearer == no_id ? label.body : arc.nearer;
  if (of_ball && other == no_id) return false;
  if (of_ball && is_ball(other)) {
    name = name_of_tangency(arc, end);
    name.group += balls.size();
    return true;
  }
  const auto ends_at = [&](StickRing ring, uint32_t body, uint32_t point) {
    name = {group_of(ring, stick_of(body)), no_id, no_id, point};
    return true;
  };
  // A half circle goes from the left of the stick to its right: `end` is the side.
  if (arc.nearer != no_id) return ends_at(ring_of(arc.body, arc.nearer), of_ball ? arc.nearer : arc.body, end);
  // Behind a stick's bite the silhouette begins at the right of the stick.
  if (of_ball) return ends_at(StickRing::top, other, 1 - end);
  const bool left = arc.from < 0.0;
  const uint32_t part = part_of(arc.body);
  const bool low = left == (end == 1);
  if (!low && part + 1 == stick_at(arc.body).parts) return false;
  return ends_at(low && part == 0 ? StickRing::foot : StickRing::middle, arc.body, left ? 0 : 1);
}

bool StickScene::may_be_seen(uint32_t body, const Vec3 &p, double margin) const {
  if (is_ball(body)) return BallScene::may_be_seen(body, p, margin);
  const Stick &stick = stick_at(body);
  const double half = stick.radius + margin;
  const double dx = p.x - stick.foot.x;
  const double dy = p.y - stick.foot.y;
  const double along = dx * stick.e[0] + dy * stick.e[1];
  const StickFront front = front_of(stick, p.x, p.y);
  const double above = front.z - p.z;
  return front.beside >= -margin && along >= -half && along <= stick.length * stick.seen + half &&
         !(front.exists && (above < front.beside ? above : front.beside) > margin);
}

// Beside a stick the height of its contour.
double StickScene::front_at(uint32_t body, double x, double y) const {
  if (is_ball(body)) return BallScene::front_at(body, x, y);
  const Stick &stick = stick_at(body);
  const StickFront front = front_of(stick, x, y);
  if (front.beside > 0.0) return front.z;
  const double along = (x - stick.foot.x) * stick.e[0] + (y - stick.foot.y) * stick.e[1];
  return stick.foot.z + along * stick.axis.z / stick.seen;
}

}  // namespace hsp
