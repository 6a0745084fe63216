// The invariants of a visibility map of any bodies, checked from its records and its scene alone. For fuzzers, careful
// callers, and those who change the code.
//
// Bounds of the visible area of a body, up to rounding. The area of a loop is a sum over its edges: the area that each
// sweeps about a point x on its way from vertex to vertex along its ellipse. If every end P of a curve were at its
// vertex V, the sum would be the area within a closed curve that does not leave the silhouette of the body. If P is at
// a distance d from V, the closed curve goes on straight from P to V, at most d outside the silhouette. The sum
// contains the area swept by this step but for (m - P) x (V - P) / 2, at most a d / 2, where m is the centre of the
// ellipse and a its longer half axis. Rounding: an edge adds at most 5 (a + 3 b + 2 d)^2, with b the largest of all
// bodies, as x is within 3 b + d of P; a sum of n such terms is wrong by at most (n + 8) 2^-52 times the sum of these
// bounds. Let s be the sum of both errors. Then the visible area is at least -s, and at most s more than that of the
// silhouette grown by the largest d.
#pragma once

#include "core/violation.hpp"
#include "maps/edge_geometry.hpp"

namespace hsp {

// Numbered as in hardsphere.h.
enum class MapInvariant : uint32_t {
  none = 0,
  vertices = 1,    // each has as many edges as its kind says, and names a half-edge that leaves it
  edges = 2,       // parameters ascend by a whole turn at most, and the vertices at both ends name the edge's balls
  successors = 3,  // every half-edge has one successor, which begins where it ends, and one predecessor
  loops = 4,       // a ball on the left of a half-edge of a loop is the loop's owner
  faces = 5,       // each but the unbounded one has one outer loop, of a positive area; holes have negative areas;
                   // faces of one owner follow each other; the unbounded face has holes if there are balls
  euler = 6,       // V - E + F = 1 + C
  positions = 7,   // edges end at their vertices, and every T lies on its silhouette
  areas = 8,       // a face has the area of its loops, all faces together that within the outermost edges; the visible
                   // area of a ball is at least 0 and at most that of its disc
  sides = 9,       // the ball that a side of an edge shows has a front at the middle of the edge, and not before it
};

// `where` is the id of a vertex, edge, half-edge, loop or face.
using MapViolation = Violation<MapInvariant>;

template <class Map>
class MapChecker : FirstViolation<MapInvariant> {
 public:
  MapChecker(const Map &map, Span<uint32_t> scratch)
      : map_(map), largest_(map.scene.largest()), bodies_(map.scene.bodies()), count_(scratch) {}

  MapViolation run() {
    if (vertices() && edges() && successors() && loops() && faces() && euler() && positions() && areas() &&
        seen_areas()) {
      sides();
    }
    return violation_;
  }

 private:
  static bool agree(double area, double other, double of) { return std::fabs(area - other) <= 0x1p-30 * of; }
  uint32_t target(uint32_t half_edge) const { return map_.origin(half_edge ^ 1U); }
  bool is_body(uint32_t body) const { return body < bodies_; }
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
                        map_.origin(vertex.leaving) == v && is_body(vertex.body[0]);
      if (!good) return fail(MapInvariant::vertices, v);
    }
    return true;
  }

  // Whether a vertex names the bodies of an edge: one for a silhouette, two for a crease.
  bool names(const MapVertex &vertex, const MapEdge &edge) const {
    const auto has = [&](uint32_t body) {
      return vertex.body[0] == body || vertex.body[1] == body || vertex.body[2] == body;
    };
    return has(edge.body) && (edge.is_silhouette() || has(edge.nearer));
  }

  bool edges() {
    for (uint32_t e = 0; e < map_.edges.size(); ++e) {
      const MapEdge &edge = map_.edges[e];
      const bool good = is_body(edge.body) && (edge.is_silhouette() || is_body(edge.nearer)) &&
                        edge.body != edge.nearer && edge.from <= edge.to && edge.to - edge.from <= 2 * pi + 1e-6 &&
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
      const uint32_t left = map_.left_of(h);
      if (left != no_id && left != loop.owner) return fail(MapInvariant::loops, half_edge.loop);
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
    if (largest_ > 0.0 && map_.faces[0].first_loop == no_id) return fail(MapInvariant::faces, 0);
    return seen == map_.loops.size() || fail(MapInvariant::faces, no_id);
  }

  bool euler() {
    const auto signed_size = [](uint32_t size) { return static_cast<int64_t>(size); };
    const bool good =
        signed_size(map_.vertices.size()) - map_.edges.size() + map_.faces.size() == 1 + signed_size(map_.components);
    return good || fail(MapInvariant::euler, no_id);
  }

  bool positions() {
    const uint32_t e = first_edge_off_its_vertices(map_, [](uint32_t) { return true; });
    return e == no_id || fail(MapInvariant::positions, e);
  }

  bool areas() {
    double inside = 0.0;
    for (uint32_t f = 1; f < map_.faces.size(); ++f) {
      const MapFace &face = map_.faces[f];
      double area = 0.0;
      map_.visit_loops(f, [&](uint32_t l) { area += map_.loops[l].area; });
      if (!agree(area, face.area, map_.loops[face.first_loop].area)) return fail(MapInvariant::areas, f);
      inside += area;
    }
    double outline = 0.0;
    map_.visit_loops(0, [&](uint32_t l) { outline -= map_.loops[l].area; });
    return agree(inside, outline, outline > 0.0 ? outline : 1.0) || fail(MapInvariant::areas, no_id);
  }

  // The sums of the two errors of the area of some loops; see the top of this file.
  struct Slack {
    double missing = 0.0, terms = 0.0, farthest = 0.0, count = 0.0;

    double all() const { return missing + (count + 8) * 0x1p-52 * terms; }
  };
  void add_slack(uint32_t loop, Slack &slack) const {
    map_.visit_loop(loop, [&](uint32_t h) {
      const double a = curve_of(map_, h / 2).ellipse.longer_half_axis();
      const double off[2] = {end_off_vertex(map_, h / 2, 0), end_off_vertex(map_, h / 2, 1)};
      const double farther = off[0] > off[1] ? off[0] : off[1];
      const double reach = a + 3 * largest_ + 2 * farther;
      slack.missing += 0.5 * a * (off[0] + off[1]);
      slack.terms += 5 * reach * reach;
      slack.farthest = farther > slack.farthest ? farther : slack.farthest;
      slack.count += 1.0;
    });
  }

  bool seen_areas() {
    double area = 0.0;
    Slack slack;
    for (uint32_t f = 1; f < map_.faces.size(); ++f) {
      const MapFace &face = map_.faces[f];
      if (face.owner == no_id) continue;
      area += face.area;
      map_.visit_loops(f, [&](uint32_t l) { add_slack(l, slack); });
      if (map_.next_face_of(f) != no_id) continue;
      const double most = map_.scene.silhouette_area(face.owner, slack.farthest) + slack.all();
      if (!(area >= -slack.all() && area <= most)) return fail(MapInvariant::areas, map_.first_face_of(face.owner));
      area = 0.0;
      slack = {};
    }
    return true;
  }

  bool sides() {
    const uint32_t h = first_side_without_front(map_);
    return h == no_id || fail(MapInvariant::sides, h);
  }

  const Map &map_;
  double largest_;
  uint32_t bodies_;
  Span<uint32_t> count_;
};

// scratch [2 edges + 1]. O(size).
template <class Map>
MapViolation check_map(const Map &map, Span<uint32_t> scratch) {
  return MapChecker<Map>(map, scratch).run();
}

}  // namespace hsp
