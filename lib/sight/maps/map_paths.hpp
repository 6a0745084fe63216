// What is seen as paths to be painted: all faces of a ball are one, and no two overlap.
#pragma once

#include "maps/visibility_map.hpp"
#include "view/painted_paths.hpp"

namespace hsp {

// A directed edge as an arc of the view plane, from vertex to vertex.
ProjectedArc arc_of(const VisibilityMap &map, uint32_t half_edge);

// The balls that are seen, farthest first, with their faces.
class MapPaths {
 public:
  // scratch: as many as balls are seen, which are no more than edges; it and the map have to outlive this.
  // O(n + m log m) for m of n balls.
  MapPaths(const BallSet &balls, const VisibilityMap &map, Span<uint32_t> scratch);
  MapPaths(const MapPaths &) = delete;  // those who paint point here
  MapPaths &operator=(const MapPaths &) = delete;

  uint32_t size() const { return first_face_.size(); }
  // Grid order.
  uint32_t ball_of(uint32_t path) const { return map_.balls[map_.faces[first_face_[path]].owner].ball; }

  // Calls visitor(arc, first, closes) for the loops around the faces of a path.
  void visit_outline(uint32_t path, const ArcVisitor &visitor) const;
  // The same for the edges of these loops that are the ball's own: its silhouette, and creases where it is the nearer
  // one. So each edge of the map belongs to one path. A run is as long as such edges follow each other.
  void visit_lines(uint32_t path, const ArcVisitor &visitor) const;

  PaintedPaths paths() const;

 private:
  auto successor() const {
    return [this](uint32_t h) { return map_.half_edges[h].next; };
  }
  template <class Visit>
  void visit_loops(uint32_t path, Visit visit) const;

  const VisibilityMap &map_;
  Span<uint32_t> first_face_;  // of each path
};

}  // namespace hsp
