#include "maps/map_silhouettes.hpp"

#include "lanes/floating_point.hpp"
#include "maps/loop_runs.hpp"

namespace hsp {
namespace {

constexpr double whole_turn = 2 * pi;

class SilhouetteWalk {
 public:
  SilhouetteWalk(const VisibilityMap &map, const SilhouetteVisitor &visitor) : map_(map), visitor_(visitor) {}

  // Around a loop of a ball: what lies on the other side of its silhouette is another ball's or the background.
  void walk(uint32_t first) {
    visit_runs(
        first, [this](uint32_t h) { return map_.half_edges[h].next; }, [this](uint32_t h) { return is_silhouette(h); },
        [this](uint32_t before, uint32_t h, uint32_t after, bool begins, bool) { take(before, h, after, begins); });
  }

 private:
  bool is_silhouette(uint32_t h) const { return h % 2 == 0 && map_.edges[h / 2].is_silhouette(); }
  // The ball behind a silhouette.
  uint32_t behind(uint32_t h) const {
    const uint32_t owner = map_.faces[map_.face_of(h ^ 1U)].owner;
    return owner == no_id ? no_id : map_.scene.ball_of(owner);
  }
  SilhouetteArc::End end_of(uint32_t neighbour, uint32_t vertex) const {
    const MapVertex &at = map_.vertices[vertex];
    const bool is_t = at.kind == MapVertexKind::t;
    if (is_silhouette(neighbour)) {
      // The stem is a silhouette or a crease.
      const bool crosses = is_t && at.ball[1] == no_id;
      return {true, false, behind(neighbour), crosses ? map_.scene.ball_of(at.ball[0]) : no_id};
    }
    if (!is_t) return {false, false, no_id, no_id};
    const uint32_t nearer = map_.scene.ball_of(at.ball[2]);
    return {false, true, nearer, nearer};
  }

  void take(uint32_t before, uint32_t h, uint32_t after, bool begins) {
    const MapEdge &edge = map_.edges[h / 2];
    double shift = 0.0;
    while (!begins && edge.from + shift < last_ - pi) shift += whole_turn;
    while (!begins && edge.from + shift > last_ + pi) shift -= whole_turn;
    last_ = edge.to + shift;
    visitor_({edge.from + shift, last_, behind(h), end_of(before, edge.vertex[0]), end_of(after, edge.vertex[1])},
             begins);
  }

  const VisibilityMap &map_;
  const SilhouetteVisitor &visitor_;
  double last_ = 0.0;  // where the arc before ends
};

void visit_silhouettes(const void *source, uint32_t ball, const SilhouetteVisitor &visitor) {
  const VisibilityMap &map = *static_cast<const VisibilityMap *>(source);
  SilhouetteWalk walk(map, visitor);
  for (uint32_t f = map.first_face[ball]; f != no_id; f = map.next_face_of(f)) {
    map.visit_loops(f, [&](uint32_t l) { walk.walk(map.loops[l].first_half_edge); });
  }
}

}  // namespace

SeenSilhouettes silhouettes_of(const VisibilityMap &map) {
  return {&map, visit_silhouettes};
}

}  // namespace hsp
