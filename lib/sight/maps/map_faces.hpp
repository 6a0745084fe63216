// Finds loops and faces from linked half-edges, for bodies of any kind, and checks that they fit together.
#pragma once

#include <initializer_list>

#include "core/disjoint_sets.hpp"
#include "maps/edge_geometry.hpp"
#include "maps/map_linker.hpp"

namespace hsp {

// The body seen behind an edge on a contour. Asks at up to four points of the edge, until the answer is certain.
// `sight` in this file answers sight.highest_at(x, y, except): which body has the highest front at a point, body
// `except` left out.
template <class Map, class Sight>
HighestBody sight_behind(const Map &map, const MapEdge &edge, const Sight &sight) {
  HighestBody behind{no_id, false};
  for (const double part : {0.3819660112501051, 0.7639320225002103, 0.1458980337503154, 0.5278640450004206}) {
    const Vec3 at = map.scene.at(edge.body, edge.nearer, edge.from + part * (edge.to - edge.from));
    behind = sight.highest_at(at.x, at.y, edge.body);
    if (behind.certain) break;
  }
  return behind;
}

// If several ends of arcs on a contour are so close that rounding decides their order, the edges between them are
// short.
inline bool is_short(const MapEdge &edge) {
  return edge.to - edge.from < 0x1p-18;
}

// Whether the owners of loops may be right along the far sides of contours. At the middle of each edge the owner shall
// have a front that is not before the edge, up to rounding; and if the loop shows the background, there shall not be
// certainly some body.
template <class Map, class Sight>
bool fits_behind_contours(const Map &map, const Sight &sight, Patience &patience) {
  const double margin = position_tolerance(map);
  for (uint32_t e = 0; e < map.edges.size(); ++e) {
    const MapEdge &edge = map.edges[e];
    if (!edge.is_silhouette() || is_short(edge)) continue;
    if (!patience.allows(500)) return false;
    const uint32_t owner = map.loops[map.half_edges[2 * e + 1].loop].owner;
    const Vec3 middle = map.scene.middle_of(edge, map.vertices[edge.vertex[0]], map.vertices[edge.vertex[1]]);
    if (owner != no_id) {
      if (!map.scene.may_be_seen(owner, middle, margin)) return false;
    } else {
      const auto highest = sight.highest_at(middle.x, middle.y, edge.body);
      if (highest.certain && highest.body != no_id) return false;
    }
  }
  return true;
}

// Whether the owners of loops are what is seen behind the edges next to a short one on a contour. A loop that is linked
// wrongly at a short edge has the owner of another loop further on.
template <class Map, class Sight>
bool fits_beside_short_edges(const Map &map, const Sight &sight, Patience &patience) {
  for (const MapEdge &edge : map.edges.items()) {
    if (!is_short(edge)) continue;
    if (!patience.allows(10000)) return false;
    for (const uint32_t v : edge.vertex) {
      uint32_t h = map.vertices[v].leaving;
      do {
        const MapEdge &beside = map.edges[h / 2];
        if (beside.is_silhouette() && !is_short(beside)) {
          const HighestBody behind = sight_behind(map, beside, sight);
          if (behind.certain && behind.body != map.loops[map.half_edges[h | 1U].loop].owner) return false;
        }
        h = map.half_edges[h ^ 1U].next;
      } while (h != map.vertices[v].leaving);
    }
  }
  return true;
}

// How many loops are compared with the body seen behind the contours along them. all_arcs: only loops without labels.
// labels: an arc may be missing, so that the middles of all edges on contours are tested, too. nothing: both for all
// loops.
enum class MapTrust { all_arcs, labels, nothing };

template <class Scene>
class MapFaceFinder {
 public:
  using Map = SceneMap<Scene>;

  void carve(Workspace &workspace, const MapSizes &most) {
    parent_ = workspace.take<uint32_t>(most.edges);
    first_face_ = workspace.take<uint32_t>(most.bodies);
    order_ = workspace.take<uint32_t>(2 * most.edges);
    scratch_ = workspace.take<uint32_t>(2 * most.edges + 1);
  }

  // Fills loops, faces and components. False if patience ends, or if something does not fit:
  //   half-edges do not chain up to loops;
  //   the labels of a loop's edges name two bodies;
  //   a loop has no labels, and nowhere along it is it certain which body is behind;
  //   labels are not trusted, and certainly another body is behind than they say;
  //   an edge ends elsewhere than at its vertices;
  //   the body that a side of an edge shows has no front at the middle of the edge, or one before it;
  //   beside a short edge another body is behind a contour than the loop says;
  //   an arc may be missing, and the body that a loop says cannot be behind the middle of some contour;
  //   the numbers contradict Euler's formula;
  //   a hole lies in no face of its owner;
  //   the visible part of a body has no area;
  //   the middle of a body is seen, but the body has no face.
  template <class Sight>
  bool find(const Sight &sight, MapTrust trust, Map &map, Patience &patience) {
    if (!trace_loops(map, patience) || !name_owners(sight, trust, map, patience)) return false;
    if (!patience.allows(500 * uint64_t{map.edges.size()})) return false;
    // A vertex has the position of one end: that of the half-edge `leaving`. The other ends are looked at.
    const auto has_end = [&map](uint32_t h) { return map.vertices[map.edges[h / 2].vertex[h % 2]].leaving != h; };
    if (first_edge_off_its_vertices(map, has_end) != no_id || first_side_without_front(map) != no_id) return false;
    if (!fits_beside_short_edges(map, sight, patience)) return false;
    if (trust != MapTrust::all_arcs && !fits_behind_contours(map, sight, patience)) return false;
    if (!patience.allows(50 * uint64_t{map.edges.size()}) || !fits_euler(map)) return false;
    order_loops(map);
    add_outer_loops(map);
    return add_holes(map) && owners_have_areas(map) && middles_have_faces(sight, map, patience);
  }

  // Memory that is free between calls; [2 edges + 1] and [edges].
  Span<uint32_t> scratch() { return scratch_; }
  Span<uint32_t> more_scratch() { return parent_; }

 private:
  // Follows a loop from a half-edge, and sums its area. Areas are swept about the loop's first vertex, so that no large
  // terms cancel.
  bool trace_loop(uint32_t first, Map &map) {
    const uint32_t id = map.loops.size();
    MapLoop loop{first, no_id, no_id, no_id, 0.0};
    const MapVertex &origin = map.vertices[map.origin(first)];
    double twice = 0.0;
    uint32_t h = first;
    do {
      MapHalfEdge &half_edge = map.half_edges[h];
      if (half_edge.next == no_id || half_edge.loop != no_id) return false;
      half_edge.loop = id;
      if (map.origin(half_edge.next) != map.origin(h ^ 1U)) return false;
      const uint32_t owner = map.left_of(h);
      if (owner != no_id) {
        if (loop.owner != no_id && loop.owner != owner) return false;
        loop.owner = owner;
      }
      const double swept = swept_twice(map, h / 2, origin.x, origin.y);
      twice += h % 2 == 0 ? swept : -swept;
      h = half_edge.next;
    } while (h != first);
    loop.area = 0.5 * twice;
    map.loops.push(loop);
    return true;
  }

  bool trace_loops(Map &map, Patience &patience) {
    for (uint32_t h = 0; h < map.half_edges.size(); ++h) {
      if (map.half_edges[h].loop == no_id && (!patience.allows(2000) || !trace_loop(h, map))) return false;
    }
    return true;
  }

  // Names the owner of a loop: the body seen behind the longest of its edges on the far side of a contour, or checks it
  // by that. False if this contradicts the labels, or if it is not certain and there are no labels.
  template <class Sight>
  static bool name_owner(const Sight &sight, uint32_t l, Map &map) {
    MapLoop &loop = map.loops[l];
    uint32_t best = no_id;
    double longest = -1.0;
    map.visit_loop(l, [&](uint32_t h) {
      if (map.left_of(h) != no_id) return;
      const MapEdge &edge = map.edges[h / 2];
      const double length = (edge.to - edge.from) * map.scene.contour_length(edge.body);
      if (length > longest) {
        longest = length;
        best = h;
      }
    });
    if (best == no_id) return true;
    const HighestBody behind = sight_behind(map, map.edges[best / 2], sight);
    if (!behind.certain) return loop.owner != no_id;
    if (loop.owner != no_id && loop.owner != behind.body) return false;
    loop.owner = behind.body;
    return true;
  }

  template <class Sight>
  static bool name_owners(const Sight &sight, MapTrust trust, Map &map, Patience &patience) {
    for (uint32_t l = 0; l < map.loops.size(); ++l) {
      if (!patience.allows(500)) return false;
      if ((map.loops[l].owner == no_id || trust == MapTrust::nothing) && !name_owner(sight, l, map)) return false;
    }
    return true;
  }

  // A counting sort of loops by owners: in the order of the scene, the background last.
  void order_loops(Map &map) {
    const Scene &scene = map.scene;
    for (uint32_t &count : first_face_) count = 0;
    for (const MapLoop &loop : map.loops.items()) {
      if (loop.owner != no_id) ++first_face_[scene.slot_of(loop.owner)];
    }
    uint32_t owned = 0;
    for (uint32_t k = 0; k < scene.bodies(); ++k) {
      uint32_t &begin = first_face_[scene.slot_of(scene.body_in_order(k))];
      const uint32_t count = begin;
      begin = owned;
      owned += count;
    }
    for (uint32_t l = 0; l < map.loops.size(); ++l) {
      const uint32_t owner = map.loops[l].owner;
      order_[owner == no_id ? owned++ : first_face_[scene.slot_of(owner)]++] = l;
    }
    map.loop_order = order_.part(0, map.loops.size());
  }

  bool fits_euler(Map &map) {
    DisjointSets parts(parent_.part(0, map.vertices.size()));
    parts.reset();
    map.components = map.vertices.size();
    for (const MapEdge &edge : map.edges.items()) {
      if (parts.join(edge.vertex[0], edge.vertex[1])) --map.components;
    }
    return static_cast<uint64_t>(map.vertices.size()) + map.loops.size() ==
           static_cast<uint64_t>(map.edges.size()) + 2 * static_cast<uint64_t>(map.components);
  }

  // Makes a face of each outer loop: first those of the background, then in the order of loops.
  void add_outer_loops(Map &map) {
    for (uint32_t &first : first_face_) first = no_id;
    map.first_face = first_face_;
    map.faces.push({no_id, no_id, 0.0});
    for (const bool background : {true, false}) {
      for (const uint32_t l : map.loop_order) {
        MapLoop &loop = map.loops[l];
        if ((loop.owner == no_id) != background || !(loop.area > 0.0)) continue;
        loop.face = map.faces.size();
        map.faces.push({loop.owner, l, loop.area});
        if (background) continue;
        uint32_t &first = first_face_[map.scene.slot_of(loop.owner)];
        if (first != no_id) continue;
        first = loop.face;
        ++map.owners;
      }
    }
  }

  static bool owners_have_areas(const Map &map) {
    double area = 0.0;
    for (uint32_t f = 1; f < map.faces.size(); ++f) {
      const MapFace &face = map.faces[f];
      area += face.area;
      if (map.next_face_of(f) != no_id) continue;
      if (face.owner != no_id && !(area > 0.0)) return false;
      area = 0.0;
    }
    return true;
  }

  // When curves coincide, all of them may be lost, so that a body whose middle is seen has no face.
  template <class Sight>
  static bool middles_have_faces(const Sight &sight, const Map &map, Patience &patience) {
    return map.scene.all_middles([&](uint32_t body, double x, double y) {
      if (!patience.allows(500)) return false;
      if (map.first_face_of(body) != no_id) return true;
      const auto highest = sight.highest_at(x, y, no_id);
      return !(highest.certain && highest.body == body);
    });
  }

  Span<uint32_t> parent_;      // [edges] for vertices
  Span<uint32_t> first_face_;  // [bodies] that of the map
  Span<uint32_t> order_;       // [2 edges] that of the map
  Span<uint32_t> scratch_;     // [2 edges + 1]
};

}  // namespace hsp
