// From visible arcs to vertices, edges and half-edges.
//
// Arc ends are identified by labels, never by their positions: the three ends at a triple vertex by its balls and the
// side of their plane on which it lies, the two at a tangency by its balls and which end of the crease it is. An end on
// a silhouette is a vertex of its own, the stem of a T, which is put in its place among the visible arcs of that
// silhouette. Then no angles need to be sorted: what follows a half-edge is known from labels too.
//
// A triple that is not three, a tangency that is not two, a T that misses all arcs or an end without a label shows that
// roundings have decided differently about one and the same thing. Then there is no map.
#pragma once

#include "maps/arc_finder.hpp"
#include "maps/landings.hpp"

namespace hsp {

class MapLinker {
 public:
  void carve(Workspace &workspace, const MapLimits &limits);

  // How many edges the map of these arcs has. Not more than limits.edges may be linked.
  uint64_t count_edges(Span<const MapArc> arcs, uint32_t balls);
  // Fills the vertices, the edges and the next half-edges of the map. False if ends do not match.
  bool link(Span<const MapArc> arcs, VisibilityMap &map);

 private:
  // Ends of arcs: 2 arc where it begins and 2 arc + 1 where it ends. The name of a common vertex: the ids of its balls,
  // ascending, with no_id if there are two only, and which of two points it is.
  struct NamedEnd {
    uint32_t middle, last, point;
    uint32_t end;
  };

  bool all_end_at_vertices() const;
  void sort_named_ends(uint32_t balls);
  bool add_common_vertices(VisibilityMap &map);
  bool add_common_vertex(Span<const NamedEnd> ends, uint32_t first_ball, VisibilityMap &map);
  void add_landings(VisibilityMap &map);
  bool add_edges(VisibilityMap &map);
  bool cut_silhouette(uint32_t first, uint32_t last, Span<Landing> landings, VisibilityMap &map);
  void cut_circle(uint32_t arc, Span<const Landing> landings, VisibilityMap &map);
  void add_whole_edge(uint32_t arc, VisibilityMap &map);
  uint32_t add_edge(const MapArc &arc, double from, double to, uint32_t v, uint32_t w, VisibilityMap &map);
  bool link_half_edges(VisibilityMap &map);
  bool link_triple(uint32_t v, VisibilityMap &map);
  Vec3 position_of(uint32_t end, const VisibilityMap &map) const;
  uint32_t leaving(uint32_t end) const { return end % 2 == 0 ? 2 * first_edge_[end / 2] : 2 * last_edge_[end / 2] + 1; }

  Span<const MapArc> arcs_;
  Span<uint32_t> first_named_;             // [balls + 1] by the first of their balls
  Span<uint32_t> first_landing_;           // [balls + 1] by the ball on which they are
  Span<NamedEnd> named_;                   // [2 edges]
  Span<Landing> landing_;                  // [2 edges]
  Span<uint32_t> vertex_at_;               // [2 edges] of the ends of arcs
  Span<uint32_t> first_edge_, last_edge_;  // [edges] of arcs
  Span<uint32_t> end_at_;                  // [3 edges] of a vertex the ends of arcs there
  Span<uint32_t> before_, after_;          // [edges] of a T the edges on either side along the silhouette
};

}  // namespace hsp
