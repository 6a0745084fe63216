#include "visibility/map_paths.hpp"

#include "core/sorting.hpp"
#include "view/depth_order.hpp"
#include "visibility/edge_geometry.hpp"

namespace hsp {
namespace {

bool is_own(uint32_t half_edge) {
  return half_edge % 2 == 0;
}

const MapPaths &paths_behind(const void *source) {
  return *static_cast<const MapPaths *>(source);
}

uint32_t ball_of_path(const void *source, uint32_t path) {
  return paths_behind(source).ball_of(path);
}

void visit_path(const void *source, const BallSet &, uint32_t path, const ArcVisitor &visitor) {
  paths_behind(source).visit_outline(path, visitor);
}

void visit_lines_of_path(const void *source, const BallSet &, uint32_t path, const ArcVisitor &visitor) {
  paths_behind(source).visit_lines(path, visitor);
}

constexpr PaintedPaths::Functions of_map{ball_of_path, visit_path, visit_lines_of_path};

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

// Euler's formula and a vertex at least for each connected part of the edges: there are no more faces with balls than
// edges, and no more balls with faces.
MapPaths::MapPaths(const BallSet &balls, const VisibilityMap &map, Span<uint32_t> scratch) : map_(map) {
  uint32_t count = 0;
  for (uint32_t f = 1; f < map.faces.size(); ++f) {
    if (map.faces[f].owner != no_id) scratch[count++] = f;
  }
  faces_ = scratch.part(0, count);
  sort_in_place(faces_, [&](uint32_t f, uint32_t g) {
    const uint32_t a = map.faces[f].owner;
    const uint32_t b = map.faces[g].owner;
    return a == b ? f < g : is_farther(balls, map.frame.direction, map.balls[a].ball, map.balls[b].ball);
  });
  uint32_t paths = 0;
  for (uint32_t k = 0; k < count; ++k) {
    if (k == 0 || map.faces[faces_[k]].owner != map.faces[faces_[k - 1]].owner) scratch[count + paths++] = k;
  }
  first_ = scratch.part(count, count + paths);
}

// Calls visit(first half-edge) for each loop.
template <class Visit>
void MapPaths::visit_loops(uint32_t path, Visit visit) const {
  const uint32_t end = path + 1 < first_.size() ? first_[path + 1] : faces_.size();
  for (uint32_t k = first_[path]; k < end; ++k) {
    for (uint32_t l = map_.faces[faces_[k]].first_loop; l != no_id; l = map_.loops[l].next_of_face) {
      visit(map_.loops[l].first_half_edge);
    }
  }
}

void MapPaths::visit_outline(uint32_t path, const ArcVisitor &visitor) const {
  visit_loops(path, [&](uint32_t first) {
    uint32_t h = first;
    do {
      const uint32_t next = map_.half_edges[h].next;
      visitor(arc_of(map_, h), h == first, next == first);
      h = next;
    } while (h != first);
  });
}

// A loop with edges of others is entered behind one of these, so that no run is cut in two.
void MapPaths::visit_lines(uint32_t path, const ArcVisitor &visitor) const {
  visit_loops(path, [&](uint32_t first) {
    uint32_t h = first;
    while (is_own(h) && map_.half_edges[h].next != first) h = map_.half_edges[h].next;
    const bool whole = is_own(h);
    const uint32_t start = map_.half_edges[h].next;
    bool begins = true;
    h = start;
    do {
      const uint32_t next = map_.half_edges[h].next;
      if (is_own(h)) visitor(arc_of(map_, h), begins, whole && next == start);
      begins = !is_own(h);
      h = next;
    } while (h != start);
  });
}

PaintedPaths MapPaths::paths() const {
  return {map_.frame, size(), this, of_map};
}

}  // namespace hsp
