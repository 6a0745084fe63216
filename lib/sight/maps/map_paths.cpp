#include "maps/map_paths.hpp"

#include "core/sorting.hpp"
#include "maps/edge_geometry.hpp"
#include "maps/loop_runs.hpp"
#include "view/depth_order.hpp"

namespace hsp {
namespace {

const MapPaths &paths_behind(const void *source) {
  return *static_cast<const MapPaths *>(source);
}

uint32_t ball_of_face(const void *source, uint32_t path) {
  return paths_behind(source).ball_of(path);
}

void visit_face(const void *source, const BallSet &, uint32_t path, const ArcVisitor &visitor) {
  paths_behind(source).visit_outline(path, visitor);
}

void visit_lines_of_face(const void *source, const BallSet &, uint32_t path, const ArcVisitor &visitor) {
  paths_behind(source).visit_lines(path, visitor);
}

constexpr PaintedPaths::Functions of_map{ball_of_face, visit_face, visit_lines_of_face};

}  // namespace

// A crease's parameter counts from its steepest direction, which appears shortened; that of a projected ellipse from
// the end of its major axis, a quarter turn ahead.
ProjectedArc arc_of(const VisibilityMap &map, uint32_t half_edge) {
  const MapEdge &edge = map.edges[half_edge / 2];
  const EdgeEllipse on(map.balls, edge);
  const MapVertex &start = map.vertices[map.origin(half_edge)];
  const MapVertex &end = map.vertices[map.origin(half_edge ^ 1U)];
  const uint32_t from_end = half_edge % 2;
  ProjectedArc arc{{{on.centre[0], on.centre[1]}, {on.first[0], on.first[1]}, {on.second[0], on.second[1]}},
                   from_end == 0 ? edge.from : edge.to,
                   from_end == 0 ? edge.to : edge.from,
                   {start.x, start.y},
                   {end.x, end.y},
                   no_id};
  if (edge.is_silhouette()) return arc;
  arc.other_ball = map.balls[edge.ball].ball;
  for (int k = 0; k < 2; ++k) {
    arc.ellipse.major[k] = on.second[k];
    arc.ellipse.minor[k] = -on.first[k];
  }
  arc.from -= pi / 2;
  arc.to -= pi / 2;
  return arc;
}

MapPaths::MapPaths(const BallSet &balls, const VisibilityMap &map, Span<uint32_t> scratch) : map_(map) {
  uint32_t count = 0;
  for (uint32_t k = 0; k < map.balls.size(); ++k) {
    const uint32_t first = map.first_face_of(k);
    if (first != no_id) scratch[count++] = first;
  }
  first_face_ = scratch.part(0, count);
  sort_in_place(first_face_, [&](uint32_t f, uint32_t g) {
    return is_farther(balls, map.frame.direction, map.balls[map.faces[f].owner].ball,
                      map.balls[map.faces[g].owner].ball);
  });
}

// Calls visit(first half-edge) for each loop.
template <class Visit>
void MapPaths::visit_loops(uint32_t path, Visit visit) const {
  for (uint32_t f = first_face_[path]; f != no_id; f = map_.next_face_of(f)) {
    for (uint32_t l = map_.faces[f].first_loop; l != no_id; l = map_.loops[l].next_of_face) {
      visit(map_.loops[l].first_half_edge);
    }
  }
}

void MapPaths::visit_outline(uint32_t path, const ArcVisitor &visitor) const {
  visit_loops(path, [&](uint32_t first) {
    visit_loop(first, successor(),
               [&](uint32_t h, bool begins, bool closes) { visitor(arc_of(map_, h), begins, closes); });
  });
}

void MapPaths::visit_lines(uint32_t path, const ArcVisitor &visitor) const {
  visit_loops(path, [&](uint32_t first) {
    visit_own_runs(first, successor(),
                   [&](uint32_t h, bool begins, bool closes) { visitor(arc_of(map_, h), begins, closes); });
  });
}

PaintedPaths MapPaths::paths() const {
  return {map_.frame, size(), this, of_map};
}

}  // namespace hsp
