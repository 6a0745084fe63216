// From visible arcs to edges and half-edges that follow each other around what is seen.
//
// As in a visibility map (map_linker.hpp) labels tell what belongs together: a triple point is known by its balls and
// the side of their plane, the ends of half circles by the stick and the side of it. An end on a contour is a vertex of
// its own, the stem of a T, and is put in its place among the visible arcs of that contour. The half circle in the
// middle of a stick ends between the contours of the halves, where three curves meet.
//
// What finds no partners, or misses all arcs, shows that roundings have decided differently about one and the same
// thing.
#pragma once

#include "maps/landings.hpp"
#include "maps/stick_regions.hpp"

namespace hsp {

class RegionLinker {
 public:
  void carve(Workspace &workspace, const StickLimits &limits);

  // Fills vertices, edges and next half-edges. Arcs and their ends on contours shall be no more than limits.edges: each
  // of these ends cuts an arc in two, but the first one on a closed arc. False if something does not fit.
  bool link(Span<const MapArc> arcs, StickRegions &regions);

  // Memory that is free between calls; [2 edges].
  Span<uint32_t> scratch() { return vertex_at_; }

 private:
  enum class Corner : uint32_t { triple, tangency, foot, middle, top };

  // A common vertex by what meets there, and an end of an arc: 2 arc where it begins, 2 arc + 1 where it ends.
  struct NamedEnd {
    Corner corner;
    uint32_t first, second, third, point;
    uint32_t end;

    bool same(const NamedEnd &other) const {
      return corner == other.corner && first == other.first && second == other.second && third == other.third &&
             point == other.point;
    }
  };

  bool name(uint32_t end, NamedEnd &named) const;
  NamedEnd name_of_triple(uint32_t end) const;
  // At the end of an arc, whose bodies it names, and a third one.
  uint32_t add_vertex(uint32_t end, MapVertexKind kind, uint32_t third, StickRegions &regions);
  bool add_vertices(StickRegions &regions);
  bool add_corner(Span<const NamedEnd> ends, StickRegions &regions);
  bool add_edges(StickRegions &regions);
  bool cut_contour(uint32_t first, uint32_t last, Span<Landing> landings, StickRegions &regions);
  void cut_circle(uint32_t arc, Span<const Landing> landings, StickRegions &regions);
  void add_whole_edge(uint32_t arc, StickRegions &regions);
  uint32_t add_edge(const MapArc &arc, double from, double to, uint32_t v, uint32_t w, StickRegions &regions);
  bool link_half_edges(StickRegions &regions);
  uint32_t leaving(uint32_t end) const { return end % 2 == 0 ? 2 * first_edge_[end / 2] : 2 * last_edge_[end / 2] + 1; }

  StickScene scene_;
  Span<const MapArc> arcs_;
  FixedVector<NamedEnd> named_;            // [2 edges]
  FixedVector<Landing> landing_;           // [edges]
  Span<uint32_t> vertex_at_;               // [2 edges] of the ends of arcs
  Span<uint32_t> first_edge_, last_edge_;  // [edges] of arcs
  Span<uint32_t> end_at_;                  // [3 edges] of a vertex the ends of arcs there
  Span<uint8_t> ends_;                     // [edges] of a vertex: how many; 0 on a closed curve without others
  Span<uint32_t> before_, after_;          // [edges] of a T the edges on either side along the contour
};

}  // namespace hsp
