#include "maps/map_paths.hpp"

#include "lanes/floating_point.hpp"
#include "maps/stick_scene.hpp"

namespace hsp {
namespace {

constexpr double whole_turn = 2 * pi;

template <class Map>
class SilhouetteWalk {
 public:
  SilhouetteWalk(const Map &map, const SilhouetteVisitor &visitor) : map_(map), visitor_(visitor) {}

  // Walks around a loop of a body. On the other side of its silhouette is another body or the background.
  void walk(uint32_t loop) {
    visit_runs(
        map_, loop, [this](uint32_t h) { return is_silhouette(h); },
        [this](uint32_t before, uint32_t h, uint32_t after, bool begins, bool) { take(before, h, after, begins); });
  }

 private:
  bool is_silhouette(uint32_t h) const { return h % 2 == 0 && map_.edges[h / 2].is_silhouette(); }
  // The body behind a silhouette.
  uint32_t behind(uint32_t h) const {
    const uint32_t owner = map_.faces[map_.face_of(h ^ 1U)].owner;
    return owner == no_id ? no_id : map_.scene.slot_of(owner);
  }
  SilhouetteArc::End end_of(uint32_t h, uint32_t neighbour, uint32_t vertex) const {
    const MapVertex &at = map_.vertices[vertex];
    const bool is_t = at.kind == MapVertexKind::t;
    if (is_silhouette(neighbour)) {
      // The stem is a silhouette or a crease.
      const bool crosses = is_t && at.body[1] == no_id;
      return {true, false, behind(neighbour), crosses ? map_.scene.slot_of(at.body[0]) : no_id};
    }
    // The contour of one half of a stick goes on as that of the other half, before the same body.
    if (at.kind == MapVertexKind::halves) return {true, false, behind(h), no_id};
    if (!is_t) return {false, false, no_id, no_id};
    const uint32_t nearer = map_.scene.slot_of(at.body[2]);
    return {false, true, nearer, nearer};
  }

  void take(uint32_t before, uint32_t h, uint32_t after, bool begins) {
    const MapEdge &edge = map_.edges[h / 2];
    double shift = 0.0;
    while (!begins && edge.from + shift < last_ - pi) shift += whole_turn;
    while (!begins && edge.from + shift > last_ + pi) shift -= whole_turn;
    last_ = edge.to + shift;
    visitor_({edge.from + shift, last_, behind(h), end_of(h, before, edge.vertex[0]), end_of(h, after, edge.vertex[1])},
             begins);
  }

  const Map &map_;
  const SilhouetteVisitor &visitor_;
  double last_ = 0.0;  // the parameter at which the arc before ends
};

template <class Map>
void visit_silhouettes(const void *source, uint32_t body, const SilhouetteVisitor &visitor) {
  const Map &map = *static_cast<const Map *>(source);
  SilhouetteWalk<Map> walk(map, visitor);
  for (uint32_t f = map.first_face[body]; f != no_id; f = map.next_face_of(f)) {
    map.visit_loops(f, [&](uint32_t l) { walk.walk(l); });
  }
}

const StickScene &scene_of(const void *source) {
  return static_cast<const StickMap *>(source)->scene;
}
StraightSilhouette side_of(const Stick &stick, bool left) {
  const StraightCurve line = StickScene::line_of(stick, left);
  const double out = left ? 1.0 : -1.0;
  return {line.start, line.step, {-out * stick.e[1], out * stick.e[0]}, stick.radius};
}
uint32_t ball_of_body(const void *source, uint32_t body) {
  return scene_of(source).ball_of(body);
}
StraightSilhouette side_with(const void *source, uint32_t body, double t) {
  return side_of(scene_of(source).stick_at(body), t < 0.0);
}
StraightSilhouette side_near(const void *source, uint32_t body, double x, double y) {
  return side_of(scene_of(source).stick_at(body), scene_of(source).landing(body, x, y) < 0.0);
}
double front_of_body(const void *source, uint32_t body, double x, double y) {
  return scene_of(source).front_at(body, x, y);
}

constexpr SeenSilhouettes::OtherBodies parts_of_sticks{ball_of_body, side_with, side_near, front_of_body};

}  // namespace

SeenSilhouettes silhouettes_of(const VisibilityMap &map) {
  return {&map, visit_silhouettes<VisibilityMap>};
}

SeenSilhouettes silhouettes_of(const StickMap &map) {
  return {&map, visit_silhouettes<StickMap>, &parts_of_sticks};
}

}  // namespace hsp
