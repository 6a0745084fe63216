// Visible parts as paths to be painted. All faces of a body are one path; paths do not overlap.
#pragma once

#include <cstdint>

#include "core/sorting.hpp"
#include "maps/ball_scene.hpp"
#include "maps/edge_geometry.hpp"
#include "picture/painted_paths.hpp"
#include "view/depth_order.hpp"

namespace hsp {

// Calls visit(half-edge before, half-edge, half-edge after, begins, closes) for the half-edges of a loop that are
// members. Consecutive members make up a run. begins: it is the first of a run; closes: the run is the whole loop, and
// this is its last one. The walk starts behind a half-edge that is no member, if there is one: so no run is cut in two.
template <class IsMember, class Visit>
void visit_runs(const MapRecords &map, uint32_t loop, IsMember is_member, Visit visit) {
  const auto next = [&map](uint32_t half_edge) { return map.half_edges[half_edge].next; };
  const uint32_t first = map.loops[loop].first_half_edge;
  uint32_t h = first;
  while (is_member(h) && next(h) != first) h = next(h);
  const bool whole = is_member(h);
  const uint32_t start = next(h);
  uint32_t before = h;
  bool begins = true;
  h = start;
  do {
    const uint32_t following = next(h);
    if (is_member(h)) visit(before, h, following, begins, whole && following == start);
    begins = !is_member(h);
    before = h;
    h = following;
  } while (h != start);
}

// A half-edge as an arc of the view plane, from vertex to vertex. The parameter of a curve that is no silhouette counts
// from the steepest direction, which appears shortened. That of a projected ellipse counts from an end of its major
// axis, a quarter turn ahead.
template <class Map>
ProjectedArc arc_of(const Map &map, uint32_t half_edge) {
  const MapEdge &edge = map.edges[half_edge / 2];
  const MapVertex &v = map.vertices[map.origin(half_edge)];
  const MapVertex &w = map.vertices[map.origin(half_edge ^ 1U)];
  const double start[2] = {v.x, v.y};
  const double end[2] = {w.x, w.y};
  if (map.scene.is_straight(edge)) return line_between(start, end, no_id);
  const EdgeEllipse on = curve_of(map, half_edge / 2).ellipse;
  const bool along = half_edge % 2 == 0;
  ProjectedArc arc{{{on.centre[0], on.centre[1]}, {on.first[0], on.first[1]}, {on.second[0], on.second[1]}},
                   along ? edge.from : edge.to,
                   along ? edge.to : edge.from,
                   {start[0], start[1]},
                   {end[0], end[1]},
                   no_id};
  if (edge.is_silhouette()) return arc;
  arc.other_ball = map.scene.ball_of(edge.body);
  for (int k = 0; k < 2; ++k) {
    arc.ellipse.major[k] = on.second[k];
    arc.ellipse.minor[k] = -on.first[k];
  }
  arc.from -= pi / 2;
  arc.to -= pi / 2;
  return arc;
}

// The functions of PaintedPaths for a source of paths. A source has map(), owner_of(path), and visit_path(path, visit),
// which calls visit(loop) for each loop.
template <class Source>
struct MapPathFunctions {
  static const Source &source_at(const void *source) { return *static_cast<const Source *>(source); }

  static uint32_t ball_of(const void *source, uint32_t path) {
    return source_at(source).map().scene.ball_of(source_at(source).owner_of(path));
  }
  static uint32_t body_of(const void *source, const BallSet &, uint32_t path) {
    return source_at(source).map().scene.slot_of(source_at(source).owner_of(path));
  }
  static void visit_outline(const void *source, const BallSet &, uint32_t path, const ArcVisitor &visitor) {
    const auto &map = source_at(source).map();
    source_at(source).visit_path(path, [&](uint32_t loop) {
      const uint32_t first = map.loops[loop].first_half_edge;
      map.visit_loop(loop, [&](uint32_t h) { visitor(arc_of(map, h), h == first, map.half_edges[h].next == first); });
    });
  }
  // The lines of a path are the edges that are the body's own: its contour, and the creases whose nearer body it is. So
  // each edge of the map belongs to one path, that of the half-edge along it. Consecutive ones make up a run.
  static void visit_lines(const void *source, const BallSet &, uint32_t path, const ArcVisitor &visitor) {
    const auto &map = source_at(source).map();
    source_at(source).visit_path(path, [&](uint32_t loop) {
      visit_runs(
          map, loop, [](uint32_t half_edge) { return half_edge % 2 == 0; },
          [&](uint32_t, uint32_t h, uint32_t, bool begins, bool closes) { visitor(arc_of(map, h), begins, closes); });
    });
  }

  static constexpr PaintedPaths::Functions functions{ball_of, visit_outline, visit_lines, Source::is_plain, body_of};
};

// The silhouettes of a map, as runs of arcs along each body. The map has to outlive the result.
SeenSilhouettes silhouettes_of(const VisibilityMap &map);

// The balls that are seen, farthest first, with their faces.
class MapPaths {
 public:
  // scratch: as many numbers as balls are seen, which is no more than there are edges. scratch and the map have to
  // outlive this object. O(n + m log m) if m of n balls are seen.
  MapPaths(const BallSet &balls, const VisibilityMap &map, Span<uint32_t> scratch) : map_(map) {
    uint32_t count = 0;
    for (uint32_t k = 0; k < map.scene.bodies(); ++k) {
      const uint32_t first = map.first_face_of(k);
      if (first != no_id) scratch[count++] = first;
    }
    first_face_ = scratch.part(0, count);
    sort_in_place(first_face_, [&](uint32_t f, uint32_t g) {
      return is_farther(balls, map.frame.direction, map.scene.ball_of(map.faces[f].owner),
                        map.scene.ball_of(map.faces[g].owner));
    });
  }
  MapPaths(const MapPaths &) = delete;  // paths() points here
  MapPaths &operator=(const MapPaths &) = delete;

  uint32_t size() const { return first_face_.size(); }
  const VisibilityMap &map() const { return map_; }
  uint32_t owner_of(uint32_t path) const { return map_.faces[first_face_[path]].owner; }
  template <class Visit>
  void visit_path(uint32_t path, Visit visit) const {
    for (uint32_t f = first_face_[path]; f != no_id; f = map_.next_face_of(f)) map_.visit_loops(f, visit);
  }
  static constexpr bool (*is_plain)(const void *, uint32_t) = nullptr;

  PaintedPaths paths() const { return {map_.frame, size(), this, MapPathFunctions<MapPaths>::functions}; }

 private:
  const VisibilityMap &map_;
  Span<uint32_t> first_face_;  // [path]
};

}  // namespace hsp
