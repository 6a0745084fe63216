// Links visible arcs to vertices, edges and half-edges, for bodies of any kind.
//
// Ends of arcs are identified by labels, never by their positions. The three ends at a triple vertex have the names of
// its three balls and the side of their plane on which it lies; the two ends at a tangency have its two balls and which
// end of the crease it is; the ends of a half circle have the stick and its side. An end on a contour is a vertex of
// its own, a T. It is put in order among the visible arcs of that contour. No angles need to be sorted: the labels also
// tell which half-edge follows another one.
//
// The labels contradict each other if a triple vertex has not three ends, a tangency not two, if a T misses all arcs,
// or if an end has no label. That shows that rounding has decided one and the same question in two ways: there is no
// map.
#pragma once

#include "core/patience.hpp"
#include "core/rows.hpp"
#include "core/sorting.hpp"
#include "maps/ball_scene.hpp"
#include "maps/hidden_intervals.hpp"

namespace hsp {

// How far a T may be off its arc, as a parameter: an angle, or a fraction of the length of a stick. A T may lie at the
// very end of an arc: if two balls have centres of equal height, the T of the one is the tangency of the other; or if a
// half circle is seen edge on.
inline constexpr double landing_tolerance = 0x1p-24;

// Where a stem ends on a contour.
struct Landing {
  double t;         // parameter on the contour
  uint32_t vertex;  // the T
};

// Sorts the landings on one contour. contour: its visible arcs, ascending. Whole turns are added to parameters so that
// they fit the arcs. A landing in a gap between two arcs belongs to the nearer one of them, also in the gap between the
// last arc and the first.
inline void sort_landings(Span<const MapArc> contour, Span<Landing> landings) {
  const MapArc &first = contour[0];
  const MapArc &last = contour[contour.size() - 1];
  const double begin = first.closed ? first.from - landing_tolerance : 0.5 * (last.to - 2 * pi + first.from);
  for (Landing &landing : landings) {
    while (landing.t >= begin + 2 * pi) landing.t -= 2 * pi;
    while (landing.t < begin) landing.t += 2 * pi;
  }
  sort_in_place(landings,
                [](const Landing &a, const Landing &b) { return a.t != b.t ? a.t < b.t : a.vertex < b.vertex; });
}

template <class Scene>
class MapLinker {
 public:
  using Map = SceneMap<Scene>;

  void carve(Workspace &workspace, const MapSizes &most) {
    const uint64_t edges = most.edges;
    first_named_ = workspace.take<uint32_t>(most.groups + 1);
    first_landing_ = workspace.take<uint32_t>(most.bodies + 1);
    named_ = workspace.take<NamedEnd>(2 * edges);
    landing_ = workspace.take<Landing>(edges);
    vertex_at_ = workspace.take<uint32_t>(2 * edges);
    first_edge_ = workspace.take<uint32_t>(edges);
    last_edge_ = workspace.take<uint32_t>(edges);
    end_at_ = workspace.take<uint32_t>(3 * edges);
    before_ = workspace.take<uint32_t>(edges);
    after_ = workspace.take<uint32_t>(edges);
  }

  // Takes the arcs and returns how many edges their map has; link() needs room for as many. Every T cuts an arc in two,
  // except the first T on a closed arc.
  uint64_t count_edges(Span<const MapArc> arcs, const Scene &scene) {
    arcs_ = arcs;
    bodies_ = scene.bodies();
    groups_ = scene.groups();
    for (uint32_t &count : first_named_.part(0, groups_ + 1)) count = 0;
    for (uint32_t &count : first_landing_.part(0, bodies_ + 1)) count = 0;
    all_named_ = true;
    uint64_t edges = arcs.size();
    for (const MapArc &arc : arcs) {
      if (arc.closed) continue;
      for (uint32_t end = 0; end < 2; ++end) {
        CornerName name;
        if (arc.end[end].kind == MapVertexKind::t) {
          ++first_landing_[arc.end[end].body];
          ++edges;
        } else if (scene.name(arc, end, name)) {
          ++first_named_[name.group];
        } else {
          all_named_ = false;
        }
      }
    }
    for (const MapArc &arc : arcs) {
      if (arc.closed && arc.nearer == no_id && first_landing_[arc.body] > 0) --edges;
    }
    end_rows(first_named_, groups_);
    end_rows(first_landing_, bodies_);
    return edges;
  }

  // Fills the vertices, the edges and `next` of the half-edges of the map, from the arcs that were counted. False if
  // ends do not match, or if patience ends.
  bool link(Map &map, Patience &patience) {
    if (!all_named_) return false;
    const uint64_t of_a_step = 100 * uint64_t{arcs_.size()};
    sort_named_ends(map.scene);
    if (!patience.allows(of_a_step) || !add_corners(map, patience)) return false;
    add_landings(map);
    return patience.allows(of_a_step) && add_edges(map, patience) &&
           patience.allows(100 * uint64_t{map.vertices.size()}) && link_half_edges(map);
  }

 private:
  // An end of an arc with its name, but for the group. end: 2 a where arc a begins, 2 a + 1 where it ends.
  struct NamedEnd {
    uint32_t middle, last, point;
    uint32_t end;

    bool same(const NamedEnd &other) const {
      return middle == other.middle && last == other.last && point == other.point;
    }
  };

  // Sorts named ends by their groups, and the ends of each group by the rest of the name.
  void sort_named_ends(const Scene &scene) {
    for (uint32_t end = 2 * arcs_.size(); end-- > 0;) {
      const MapArc &arc = arcs_[end / 2];
      CornerName name;
      if (arc.closed || arc.end[end % 2].kind == MapVertexKind::t || !scene.name(arc, end % 2, name)) continue;
      named_[--first_named_[name.group]] = {name.middle, name.last, name.point, end};
    }
    for (uint32_t k = 0; k < groups_; ++k) {
      sort_in_place(named_.part(first_named_[k], first_named_[k + 1]), [](const NamedEnd &a, const NamedEnd &b) {
        if (a.middle != b.middle) return a.middle < b.middle;
        if (a.last != b.last) return a.last < b.last;
        if (a.point != b.point) return a.point < b.point;
        return a.end < b.end;
      });
    }
  }

  // Adds a vertex at an end of an arc. It names the bodies of the arc, and a third one.
  uint32_t add_vertex(uint32_t end, MapVertexKind kind, uint32_t third, Map &map) {
    const MapArc &arc = arcs_[end / 2];
    const Vec3 at = map.scene.at(arc.body, arc.nearer, end % 2 == 0 ? arc.from : arc.to);
    const uint32_t v = map.vertices.size();
    map.vertices.push({at.x, at.y, at.z, kind, no_id, {arc.body, arc.nearer, third}});
    end_at_[3 * v] = end;
    return v;
  }

  // Adds the vertex at which ends of one name meet. Triple: three creases, each of which ends at the body that the
  // other two have in common. Else one crease, and one contour or, between the halves of a stick, two.
  bool add_corner(Span<const NamedEnd> ends, uint32_t group, Map &map) {
    const NamedEnd &name = ends[0];
    const auto arc_of = [&](uint32_t k) -> const MapArc & { return arcs_[ends[k].end / 2]; };
    const auto ended_by = [&](uint32_t k) { return arc_of(k).end[ends[k].end % 2]; };
    const MapVertexKind kind = map.scene.kind_of(ended_by(0), {group, name.middle, name.last, name.point});
    const uint32_t count = degree_of(kind);
    if (ends.size() != count) return false;
    uint32_t crease = no_id;
    uint32_t creases = 0;
    for (uint32_t k = 0; k < count; ++k) {
      if (arc_of(k).nearer == no_id) continue;
      crease = ends[k].end;
      ++creases;
    }
    const bool triple = kind == MapVertexKind::triple;
    if (creases != (triple ? 3U : 1U)) return false;
    if (triple) {
      const uint32_t ball[3] = {ended_by(0).body, ended_by(1).body, ended_by(2).body};
      if (ball[0] == ball[1] || ball[1] == ball[2] || ball[0] == ball[2]) return false;
    }
    const MapArc &arc = arcs_[crease / 2];
    const uint32_t v = add_vertex(name.end, kind, no_id, map);
    MapVertex &vertex = map.vertices[v];
    vertex.body[0] = triple ? group : arc.body;
    vertex.body[1] = triple ? name.middle : arc.nearer;
    vertex.body[2] = name.last;
    for (uint32_t k = 0; k < count; ++k) {
      end_at_[3 * v + k] = ends[k].end;
      vertex_at_[ends[k].end] = v;
    }
    return true;
  }

  bool add_corners(Map &map, Patience &patience) {
    for (uint32_t group = 0; group < groups_; ++group) {
      if (!patience.allows(2000)) return false;
      const Span<const NamedEnd> ends = named_.part(first_named_[group], first_named_[group + 1]);
      for (uint32_t first = 0, last = 0; first < ends.size(); first = last) {
        while (last < ends.size() && ends[last].same(ends[first])) ++last;
        if (!add_corner(ends.part(first, last), group, map)) return false;
      }
    }
    return true;
  }

  // Adds a vertex for each end on a contour, behind the corners. From the last arc to the first, as rows fill up from
  // their ends.
  void add_landings(Map &map) {
    for (uint32_t end = 2 * arcs_.size(); end-- > 0;) {
      const ArcEnd &label = arcs_[end / 2].end[end % 2];
      if (label.kind != MapVertexKind::t) continue;
      const uint32_t v = add_vertex(end, MapVertexKind::t, label.body, map);
      const MapVertex &at = map.vertices[v];
      landing_[--first_landing_[label.body]] = {map.scene.landing(label.body, at.x, at.y), v};
      vertex_at_[end] = v;
    }
  }

  uint32_t add_edge(const MapArc &arc, double from, double to, uint32_t v, uint32_t w, Map &map) {
    const uint32_t e = map.edges.size();
    map.edges.push({from, to, arc.body, arc.nearer, {v, w}});
    return e;
  }

  // The edge of an arc that nothing cuts.
  void add_whole_edge(uint32_t a, Map &map) {
    const MapArc &arc = arcs_[a];
    uint32_t v = vertex_at_[2 * a];
    uint32_t w = vertex_at_[2 * a + 1];
    if (arc.closed) v = w = add_vertex(2 * a, MapVertexKind::plain, no_id, map);
    first_edge_[a] = last_edge_[a] = add_edge(arc, arc.from, arc.to, v, w, map);
  }

  // Cuts a whole circle: each edge goes from one T to the next.
  void cut_circle(uint32_t a, Span<const Landing> landings, Map &map) {
    const uint32_t n = landings.size();
    first_edge_[a] = last_edge_[a] = map.edges.size();
    for (uint32_t k = 0; k < n; ++k) {
      const bool wraps = k + 1 == n;
      const Landing &next = landings[wraps ? 0 : k + 1];
      const uint32_t e =
          add_edge(arcs_[a], landings[k].t, next.t + (wraps ? 2 * pi : 0.0), landings[k].vertex, next.vertex, map);
      after_[landings[k].vertex] = e;
      before_[next.vertex] = e;
    }
  }

  // Cuts arcs first .. last - 1 of a contour where stems end. The parameters on a stick span less than a turn, too.
  bool cut_contour(uint32_t first, uint32_t last, Span<Landing> landings, Map &map) {
    sort_landings(arcs_.part(first, last), landings);
    if (arcs_[first].closed && !landings.empty()) {
      cut_circle(first, landings, map);
      return true;
    }
    uint32_t next = 0;
    for (uint32_t a = first; a < last; ++a) {
      const MapArc &arc = arcs_[a];
      if (arc.closed) {
        add_whole_edge(a, map);
        continue;
      }
      // Landings in the gap behind the arc belong to it up to the middle of the gap.
      const double reach = a + 1 < last ? 0.5 * (arc.to + arcs_[a + 1].from) : arc.to + 2 * pi;
      double from = arc.from;
      uint32_t v = vertex_at_[2 * a];
      first_edge_[a] = map.edges.size();
      for (; next < landings.size() && landings[next].t < reach; ++next) {
        const Landing &landing = landings[next];
        if (landing.t < arc.from - landing_tolerance || landing.t > arc.to + landing_tolerance) return false;
        const double at = landing.t < from ? from : landing.t > arc.to ? arc.to : landing.t;
        const uint32_t e = add_edge(arc, from, at, v, landing.vertex, map);
        before_[landing.vertex] = e;
        after_[landing.vertex] = e + 1;
        from = at;
        v = landing.vertex;
      }
      last_edge_[a] = add_edge(arc, from, arc.to, v, vertex_at_[2 * a + 1], map);
    }
    return next == landings.size();
  }

  // False if a stem ends on a contour that is not seen there.
  bool add_edges(Map &map, Patience &patience) {
    uint32_t landed = 0;
    for (uint32_t a = 0; a < arcs_.size();) {
      if (!patience.allows(300)) return false;
      if (arcs_[a].nearer != no_id) {
        add_whole_edge(a++, map);
        continue;
      }
      const uint32_t body = arcs_[a].body;
      uint32_t last = a + 1;
      while (last < arcs_.size() && arcs_[last].body == body && arcs_[last].nearer == no_id) ++last;
      const Span<Landing> landings = landing_.part(first_landing_[body], first_landing_[body + 1]);
      if (!cut_contour(a, last, landings, map)) return false;
      landed += landings.size();
      a = last;
    }
    return landed == first_landing_[bodies_];
  }

  uint32_t leaving(uint32_t end) const { return end % 2 == 0 ? 2 * first_edge_[end / 2] : 2 * last_edge_[end / 2] + 1; }

  // At a vertex of three ends the half-edge that follows an arriving one has the same body on its left.
  bool link_three(uint32_t v, Map &map) {
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t arriving = leaving(end_at_[3 * v + k]) ^ 1U;
      uint32_t found = 0;
      for (uint32_t other = 0; other < 3; ++other) {
        const uint32_t out = leaving(end_at_[3 * v + other]);
        if (other == k || map.left_of(out) != map.left_of(arriving)) continue;
        map.half_edges[arriving].next = out;
        ++found;
      }
      if (found != 1) return false;
    }
    return true;
  }

  bool link_half_edges(Map &map) {
    map.half_edges.set_count(2 * static_cast<uint64_t>(map.edges.size()));
    for (MapHalfEdge &half_edge : map.half_edges.items()) half_edge = {no_id, no_id};
    const auto follow = [&](uint32_t arriving, uint32_t out) { map.half_edges[arriving].next = out; };
    for (uint32_t v = 0; v < map.vertices.size(); ++v) {
      MapVertex &vertex = map.vertices[v];
      const uint32_t out = leaving(end_at_[3 * v]);
      vertex.leaving = out;
      if (vertex.kind == MapVertexKind::plain) {
        // On a closed curve without other vertices the only half-edge of either side follows itself.
        follow(out, out);
        follow(out ^ 1U, out ^ 1U);
      } else if (vertex.kind == MapVertexKind::t) {
        // The contour has its body on the left; the stem arrives from the right.
        follow(2 * before_[v], 2 * after_[v]);
        follow(2 * after_[v] + 1, out);
        follow(out ^ 1U, 2 * before_[v] + 1);
      } else if (vertex.kind == MapVertexKind::tangency) {
        const uint32_t other = leaving(end_at_[3 * v + 1]);
        follow(out ^ 1U, other);
        follow(other ^ 1U, out);
      } else if (!link_three(v, map)) {
        return false;
      }
    }
    return true;
  }

  Span<const MapArc> arcs_;
  uint32_t bodies_ = 0, groups_ = 0;
  bool all_named_ = false;
  Span<uint32_t> first_named_;             // [groups + 1]
  Span<uint32_t> first_landing_;           // [bodies + 1] by the body on whose contour they are
  Span<NamedEnd> named_;                   // [2 edges]
  Span<Landing> landing_;                  // [edges]
  Span<uint32_t> vertex_at_;               // [2 edges] the vertex at each end of an arc
  Span<uint32_t> first_edge_, last_edge_;  // [edges] the edges of each arc
  Span<uint32_t> end_at_;                  // [3 edges] of each vertex up to three ends of arcs there
  Span<uint32_t> before_, after_;          // [edges] of each T the edges before and behind it along the contour
};

}  // namespace hsp
