// The body seen behind edges on contours, and whether loops say the same where they may be linked wrongly. For maps of
// whatever bodies; sight.highest_at(x, y, except) is the body with the highest front there but one, and whether that is
// certain.
#pragma once

#include <initializer_list>

#include "maps/edge_geometry.hpp"
#include "maps/landings.hpp"

namespace hsp {

struct SightBehind {
  uint32_t body;
  bool certain;
};

// At a point of the edge where that is certain, if one of four is.
template <class Map, class Sight>
SightBehind sight_behind(const Map &map, const MapEdge &edge, const Sight &sight) {
  SightBehind behind{no_id, false};
  for (const double part : {0.3819660112501051, 0.7639320225002103, 0.1458980337503154, 0.5278640450004206}) {
    const Vec3 at = map.scene.at(edge.ball, edge.nearer, edge.from + part * (edge.to - edge.from));
    const auto highest = sight.highest_at(at.x, at.y, edge.ball);
    behind = {highest.body, highest.certain};
    if (behind.certain) break;
  }
  return behind;
}

// Where more ends of arcs meet on a contour than roundings tell apart, the edges between them are so short.
inline bool is_short(const MapEdge &edge) {
  return edge.to - edge.from < 0x1p-18;
}

// Whether the loops along the far sides of contours may be there: what a loop shows is not before the middles of its
// edges and has a front there, up to roundings, and where it shows the background there is nothing for certain.
template <class Map, class Sight>
bool fits_behind_contours(const Map &map, const Sight &sight) {
  const double margin = position_tolerance(map);
  for (uint32_t e = 0; e < map.edges.size(); ++e) {
    const MapEdge &edge = map.edges[e];
    if (!edge.is_silhouette() || is_short(edge)) continue;
    const uint32_t owner = map.loops[map.half_edges[2 * e + 1].loop].owner;
    const Vec3 middle = map.scene.middle_of(edge, map.vertices[edge.vertex[0]], map.vertices[edge.vertex[1]]);
    if (owner != no_id) {
      if (!map.scene.may_be_seen(owner, middle, margin)) return false;
    } else {
      const auto highest = sight.highest_at(middle.x, middle.y, edge.ball);
      if (highest.certain && highest.body != no_id) return false;
    }
  }
  return true;
}

// Whether loops say of all edges on contours that begin or end at a short one what is seen behind these. A loop goes
// wrong at a short edge, and further on what it says is another loop's.
template <class Map, class Sight>
bool fits_beside_short_edges(const Map &map, const Sight &sight) {
  for (const MapEdge &edge : map.edges.items()) {
    if (!is_short(edge)) continue;
    for (const uint32_t v : edge.vertex) {
      uint32_t h = map.vertices[v].leaving;
      do {
        const MapEdge &beside = map.edges[h / 2];
        if (beside.is_silhouette() && !is_short(beside)) {
          const SightBehind behind = sight_behind(map, beside, sight);
          if (behind.certain && behind.body != map.loops[map.half_edges[h | 1U].loop].owner) return false;
        }
        h = map.half_edges[h ^ 1U].next;
      } while (h != map.vertices[v].leaving);
    }
  }
  return true;
}

}  // namespace hsp
