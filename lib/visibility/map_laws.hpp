// The invariants of map_check.hpp, for maps of whatever bodies: with records like those of a VisibilityMap, and
// put_ends(map, edge, ends), the points where an edge's parameters begin and end.
#pragma once

#include <cmath>

#include "visibility/edge_geometry.hpp"
#include "visibility/map_check.hpp"

namespace hsp {

// How a map is checked: how many bodies it is of, and the largest radius, or how long the longest stick is.
struct MapBodies {
  uint32_t count;
  double largest;
};

// scratch [2 edges + 1].
template <class Map>
class MapLaws {
 public:
  MapLaws(const Map &map, const MapBodies &bodies, Span<uint32_t> scratch)
      : map_(map), bodies_(bodies), count_(scratch) {}

  MapViolation run() {
    if (!vertices() || !edges() || !successors() || !loops() || !faces() || !euler() || !positions() || !areas()) {
      return violation_;
    }
    return {};
  }

 private:
  bool fail(MapInvariant invariant, uint32_t id) {
    violation_ = {invariant, id};
    return false;
  }
  // Points of nearly touching curves are that uncertain, and a T may miss its arc by 2^-24.
  double position_tolerance() const { return 0x1p-18 * bodies_.largest; }
  static bool agree(double area, double other, double of) { return std::fabs(area - other) <= 0x1p-30 * of; }
  uint32_t target(uint32_t half_edge) const { return map_.origin(half_edge ^ 1U); }
  bool is_body(uint32_t body) const { return body < bodies_.count; }
  void clear_counts(uint32_t n) {
    for (uint32_t k = 0; k < n; ++k) count_[k] = 0;
  }

  bool vertices() {
    const uint32_t n = map_.vertices.size();
    if (n > map_.edges.size() || map_.half_edges.size() != 2 * map_.edges.size()) {
      return fail(MapInvariant::vertices, no_id);
    }
    clear_counts(n);
    for (uint32_t h = 0; h < map_.half_edges.size(); ++h) {
      if (map_.origin(h) >= n) return fail(MapInvariant::vertices, map_.origin(h));
      ++count_[map_.origin(h)];
    }
    for (uint32_t v = 0; v < n; ++v) {
      const MapVertex &vertex = map_.vertices[v];
      const bool good = count_[v] == degree_of(vertex.kind) && vertex.leaving < map_.half_edges.size() &&
                        map_.origin(vertex.leaving) == v && is_body(vertex.ball[0]);
      if (!good) return fail(MapInvariant::vertices, v);
    }
    return true;
  }

  // Whether a vertex names the bodies of an edge: one for a silhouette, two for a crease.
  bool names(const MapVertex &vertex, const MapEdge &edge) const {
    const auto has = [&](uint32_t body) {
      return vertex.ball[0] == body || vertex.ball[1] == body || vertex.ball[2] == body;
    };
    return has(edge.ball) && (edge.is_silhouette() || has(edge.nearer));
  }

  bool edges() {
    for (uint32_t e = 0; e < map_.edges.size(); ++e) {
      const MapEdge &edge = map_.edges[e];
      const bool good = is_body(edge.ball) && (edge.is_silhouette() || is_body(edge.nearer)) &&
                        edge.ball != edge.nearer && edge.from <= edge.to && edge.to - edge.from <= 2 * pi + 1e-6 &&
                        names(map_.vertices[edge.vertex[0]], edge) && names(map_.vertices[edge.vertex[1]], edge);
      if (!good) return fail(MapInvariant::edges, e);
    }
    return true;
  }

  bool successors() {
    const uint32_t n = map_.half_edges.size();
    clear_counts(n);
    for (uint32_t h = 0; h < n; ++h) {
      const uint32_t next = map_.half_edges[h].next;
      if (next >= n || map_.origin(next) != target(h) || count_[next] != 0) return fail(MapInvariant::successors, h);
      count_[next] = 1;
    }
    return true;
  }

  bool loops() {
    clear_counts(map_.loops.size());
    for (uint32_t h = 0; h < map_.half_edges.size(); ++h) {
      const MapHalfEdge &half_edge = map_.half_edges[h];
      if (half_edge.loop >= map_.loops.size() || map_.half_edges[half_edge.next].loop != half_edge.loop) {
        return fail(MapInvariant::loops, half_edge.loop);
      }
      const MapLoop &loop = map_.loops[half_edge.loop];
      if (loop.first_half_edge == h) count_[half_edge.loop] = 1;
      const MapEdge &edge = map_.edges[h / 2];
      const bool names_owner = h % 2 == 0 || !edge.is_silhouette();
      const uint32_t left = edge.is_silhouette() || h % 2 == 1 ? edge.ball : edge.nearer;
      if (names_owner && left != loop.owner) return fail(MapInvariant::loops, half_edge.loop);
    }
    for (uint32_t l = 0; l < map_.loops.size(); ++l) {
      if (count_[l] == 0) return fail(MapInvariant::loops, l);
    }
    return true;
  }

  bool faces() {
    if (map_.faces.size() == 0) return fail(MapInvariant::faces, 0);
    uint32_t seen = 0;
    for (uint32_t f = 0; f < map_.faces.size(); ++f) {
      const MapFace &face = map_.faces[f];
      if (f == 0 ? face.owner != no_id : face.first_loop == no_id) return fail(MapInvariant::faces, f);
      if (face.owner != no_id && !is_body(face.owner)) return fail(MapInvariant::faces, f);
      const bool begins = f == 0 || face.owner != map_.faces[f - 1].owner;
      if (begins && map_.first_face_of(face.owner) != f) return fail(MapInvariant::faces, f);
      for (uint32_t l = face.first_loop; l != no_id; l = map_.loops[l].next_of_face) {
        if (l >= map_.loops.size() || seen++ == map_.loops.size()) return fail(MapInvariant::faces, f);
        const MapLoop &loop = map_.loops[l];
        const bool outer = f != 0 && l == face.first_loop;
        if (loop.face != f || loop.owner != face.owner || outer != (loop.area > 0.0)) {
          return fail(MapInvariant::faces, f);
        }
      }
    }
    return seen == map_.loops.size() || fail(MapInvariant::faces, no_id);
  }

  bool euler() {
    const auto signed_size = [](uint32_t size) { return static_cast<int64_t>(size); };
    const bool good =
        signed_size(map_.vertices.size()) - map_.edges.size() + map_.faces.size() == 1 + signed_size(map_.components);
    return good || fail(MapInvariant::euler, no_id);
  }

  bool positions() {
    const double tolerance = position_tolerance();
    for (uint32_t e = 0; e < map_.edges.size(); ++e) {
      double ends[2][2];
      put_ends(map_, e, ends);
      for (int end = 0; end < 2; ++end) {
        const MapVertex &vertex = map_.vertices[map_.edges[e].vertex[end]];
        const double dx = ends[end][0] - vertex.x;
        const double dy = ends[end][1] - vertex.y;
        if (!(dx * dx + dy * dy <= tolerance * tolerance)) return fail(MapInvariant::positions, e);
      }
    }
    return true;
  }

  bool areas() {
    double inside = 0.0;
    for (uint32_t f = 1; f < map_.faces.size(); ++f) {
      const MapFace &face = map_.faces[f];
      double area = 0.0;
      for (uint32_t l = face.first_loop; l != no_id; l = map_.loops[l].next_of_face) area += map_.loops[l].area;
      if (!agree(area, face.area, map_.loops[face.first_loop].area)) return fail(MapInvariant::areas, f);
      inside += area;
    }
    double outline = 0.0;
    for (uint32_t l = map_.faces[0].first_loop; l != no_id; l = map_.loops[l].next_of_face) {
      outline -= map_.loops[l].area;
    }
    return agree(inside, outline, outline > 0.0 ? outline : 1.0) || fail(MapInvariant::areas, no_id);
  }

  const Map &map_;
  MapBodies bodies_;
  Span<uint32_t> count_;
  MapViolation violation_;
};

}  // namespace hsp
