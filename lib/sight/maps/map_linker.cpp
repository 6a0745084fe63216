#include "maps/map_linker.hpp"

#include <initializer_list>

#include "core/sorting.hpp"
#include "maps/curves.hpp"

namespace hsp {
namespace {

// A common vertex by its balls, ascending, and which of the two points with these balls it is.
struct Name {
  uint32_t first, middle, last, point;
};

// Along a crease the triple point where it enters the third ball has one sign of the determinant of the balls and the
// point, the one where it leaves has the other; exchanging two of the balls changes the sign.
Name name_of_triple(const MapArc &arc, uint32_t end) {
  uint32_t id[3] = {arc.ball, arc.nearer, arc.end[end].ball};
  uint32_t point = end;
  const auto order = [&](int a, int b) {
    if (id[a] <= id[b]) return;
    const uint32_t other = id[a];
    id[a] = id[b];
    id[b] = other;
    point ^= 1U;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return {id[0], id[1], id[2], point};
}

// The crease ends where the silhouette of the nearer ball begins, and the other way round: both have that ball on their
// left.
Name name_of_tangency(const MapArc &arc, uint32_t end) {
  const bool silhouette = arc.nearer == no_id;
  const uint32_t far = silhouette ? arc.end[end].ball : arc.ball;
  const uint32_t nearer = silhouette ? arc.ball : arc.nearer;
  const uint32_t point = silhouette ? 1 - end : end;
  return {far < nearer ? far : nearer, far < nearer ? nearer : far, no_id, point};
}

bool is_common(const ArcEnd &end) {
  return end.kind == MapVertexKind::triple || end.kind == MapVertexKind::tangency;
}
Name name_of(const MapArc &arc, uint32_t end) {
  return arc.end[end].kind == MapVertexKind::triple ? name_of_triple(arc, end) : name_of_tangency(arc, end);
}

// From numbers per place, counted one place too far, to where each begins.
void sum_up_counts(Span<uint32_t> first) {
  for (uint32_t k = 1; k < first.size(); ++k) first[k] += first[k - 1];
}

// The ball on the left, no_id where the labels do not tell.
uint32_t left_of(const VisibilityMap &map, uint32_t half_edge) {
  const MapEdge &edge = map.edges[half_edge / 2];
  if (edge.is_silhouette()) return half_edge % 2 == 0 ? edge.ball : no_id;
  return half_edge % 2 == 0 ? edge.nearer : edge.ball;
}

}  // namespace

void MapLinker::carve(Workspace &workspace, const MapLimits &limits) {
  const uint64_t edges = limits.edges;
  first_named_ = workspace.take<uint32_t>(static_cast<uint64_t>(limits.balls) + 1);
  first_landing_ = workspace.take<uint32_t>(static_cast<uint64_t>(limits.balls) + 1);
  named_ = workspace.take<NamedEnd>(2 * edges);
  landing_ = workspace.take<Landing>(2 * edges);
  vertex_at_ = workspace.take<uint32_t>(2 * edges);
  first_edge_ = workspace.take<uint32_t>(edges);
  last_edge_ = workspace.take<uint32_t>(edges);
  end_at_ = workspace.take<uint32_t>(3 * edges);
  before_ = workspace.take<uint32_t>(edges);
  after_ = workspace.take<uint32_t>(edges);
}

// Every T cuts an arc in two, but the first one on a closed arc.
uint64_t MapLinker::count_edges(Span<const MapArc> arcs, uint32_t balls) {
  arcs_ = arcs;
  for (Span<uint32_t> first : {first_named_, first_landing_}) {
    for (uint32_t k = 0; k <= balls; ++k) first[k] = 0;
  }
  uint64_t edges = arcs.size();
  for (const MapArc &arc : arcs) {
    for (uint32_t end = 0; end < 2; ++end) {
      if (arc.end[end].kind == MapVertexKind::t) {
        ++first_landing_[arc.end[end].ball + 1];
        ++edges;
      } else if (is_common(arc.end[end])) {
        ++first_named_[name_of(arc, end).first + 1];
      }
    }
  }
  for (const MapArc &arc : arcs) {
    if (arc.closed && arc.nearer == no_id && first_landing_[arc.ball + 1] > 0) --edges;
  }
  sum_up_counts(first_named_.part(0, balls + 1));
  sum_up_counts(first_landing_.part(0, balls + 1));
  return edges;
}

Vec3 MapLinker::position_of(uint32_t end, const VisibilityMap &map) const {
  const MapArc &arc = arcs_[end / 2];
  const double t = end % 2 == 0 ? arc.from : arc.to;
  if (arc.nearer == no_id) return silhouette_point(map.balls[arc.ball], t);
  return Crease(map.balls[arc.ball], map.balls[arc.nearer]).at(t);
}

// A counting sort by the first ball, then the ends of each ball among themselves.
void MapLinker::sort_named_ends(uint32_t balls) {
  const uint32_t total = first_named_[balls];
  for (uint32_t a = arcs_.size(); a-- > 0;) {
    for (uint32_t end = 2; end-- > 0;) {
      if (!is_common(arcs_[a].end[end])) continue;
      const Name name = name_of(arcs_[a], end);
      named_[--first_named_[name.first + 1]] = {name.middle, name.last, name.point, 2 * a + end};
    }
  }
  // Each count has become where its ball begins, one place too far.
  for (uint32_t k = 0; k < balls; ++k) first_named_[k] = first_named_[k + 1];
  first_named_[balls] = total;
  for (uint32_t k = 0; k < balls; ++k) {
    sort_in_place(named_.part(first_named_[k], first_named_[k + 1]), [](const NamedEnd &a, const NamedEnd &b) {
      if (a.middle != b.middle) return a.middle < b.middle;
      if (a.last != b.last) return a.last < b.last;
      if (a.point != b.point) return a.point < b.point;
      return a.end < b.end;
    });
  }
}

// Three creases, each ended by the ball of the other two; or one crease and one silhouette.
bool MapLinker::add_common_vertex(Span<const NamedEnd> ends, uint32_t first_ball, VisibilityMap &map) {
  const NamedEnd &name = ends[0];
  const bool triple = name.last != no_id;
  if (ends.size() != (triple ? 3U : 2U)) return false;
  const auto arc_of = [&](uint32_t k) -> const MapArc & { return arcs_[ends[k].end / 2]; };
  const auto ended_by = [&](uint32_t k) { return arc_of(k).end[ends[k].end % 2].ball; };
  if (triple) {
    if (ended_by(0) == ended_by(1) || ended_by(1) == ended_by(2) || ended_by(0) == ended_by(2)) return false;
  } else if ((arc_of(0).nearer == no_id) == (arc_of(1).nearer == no_id)) {
    return false;
  }
  const uint32_t v = map.vertices.size();
  const Vec3 at = position_of(name.end, map);
  MapVertex vertex{at.x, at.y, at.z, MapVertexKind::triple, no_id, {first_ball, name.middle, name.last}};
  if (!triple) {
    const MapArc &crease = arc_of(arc_of(0).nearer == no_id ? 1 : 0);
    vertex.kind = MapVertexKind::tangency;
    vertex.ball[0] = crease.ball;
    vertex.ball[1] = crease.nearer;
  }
  map.vertices.push(vertex);
  for (uint32_t k = 0; k < ends.size(); ++k) {
    end_at_[3 * v + k] = ends[k].end;
    vertex_at_[ends[k].end] = v;
  }
  return true;
}

bool MapLinker::add_common_vertices(VisibilityMap &map) {
  for (uint32_t ball = 0; ball < map.balls.size(); ++ball) {
    const Span<const NamedEnd> ends = named_.part(first_named_[ball], first_named_[ball + 1]);
    for (uint32_t first = 0, last = 0; first < ends.size(); first = last) {
      const auto same = [&](const NamedEnd &other) {
        return other.middle == ends[first].middle && other.last == ends[first].last && other.point == ends[first].point;
      };
      while (last < ends.size() && same(ends[last])) ++last;
      if (!add_common_vertex(ends.part(first, last), ball, map)) return false;
    }
  }
  return true;
}

// Vertices at ends on silhouettes, by the balls of these.
void MapLinker::add_landings(VisibilityMap &map) {
  const uint32_t balls = map.balls.size();
  const uint32_t total = first_landing_[balls];
  for (uint32_t end = 2 * arcs_.size(); end-- > 0;) {
    const MapArc &arc = arcs_[end / 2];
    const ArcEnd &what = arc.end[end % 2];
    if (what.kind != MapVertexKind::t) continue;
    const uint32_t v = map.vertices.size();
    const Vec3 at = position_of(end, map);
    map.vertices.push({at.x, at.y, at.z, MapVertexKind::t, no_id, {arc.ball, arc.nearer, what.ball}});
    const SeenBall &ball = map.balls[what.ball];
    landing_[--first_landing_[what.ball + 1]] = {arc_tangent(at.y - ball.y, at.x - ball.x), v, what.ball};
    end_at_[3 * v] = end;
    vertex_at_[end] = v;
  }
  for (uint32_t k = 0; k < balls; ++k) first_landing_[k] = first_landing_[k + 1];
  first_landing_[balls] = total;
}

uint32_t MapLinker::add_edge(const MapArc &arc, double from, double to, uint32_t v, uint32_t w, VisibilityMap &map) {
  const uint32_t e = map.edges.size();
  map.edges.push({from, to, arc.ball, arc.nearer, {v, w}});
  return e;
}

// The edge of an arc that nothing cuts.
void MapLinker::add_whole_edge(uint32_t a, VisibilityMap &map) {
  const MapArc &arc = arcs_[a];
  uint32_t v = vertex_at_[2 * a];
  uint32_t w = vertex_at_[2 * a + 1];
  if (arc.closed) {
    v = w = map.vertices.size();
    const Vec3 at = position_of(2 * a, map);
    map.vertices.push({at.x, at.y, at.z, MapVertexKind::plain, no_id, {arc.ball, arc.nearer, no_id}});
  }
  first_edge_[a] = last_edge_[a] = add_edge(arc, arc.from, arc.to, v, w, map);
}

// A whole circle: each edge goes from one T to the next.
void MapLinker::cut_circle(uint32_t a, Span<const Landing> landings, VisibilityMap &map) {
  const MapArc &arc = arcs_[a];
  const uint32_t n = landings.size();
  const uint32_t first = map.edges.size();
  for (uint32_t k = 0; k < n; ++k) {
    const bool wraps = k + 1 == n;
    const Landing &next = landings[wraps ? 0 : k + 1];
    const uint32_t e =
        add_edge(arc, landings[k].t, next.t + (wraps ? 2 * pi : 0.0), landings[k].vertex, next.vertex, map);
    after_[landings[k].vertex] = e;
    before_[next.vertex] = e;
  }
  first_edge_[a] = last_edge_[a] = first;
}

// Arcs first .. last - 1 of a silhouette, cut where stems end.
bool MapLinker::cut_silhouette(uint32_t first, uint32_t last, Span<Landing> landings, VisibilityMap &map) {
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
    // What lies in the gap behind the arc belongs to the nearer side of it.
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

// False if a stem ends on a silhouette that is not seen there.
bool MapLinker::add_edges(VisibilityMap &map) {
  uint32_t landed = 0;
  for (uint32_t a = 0; a < arcs_.size();) {
    if (arcs_[a].nearer != no_id) {
      add_whole_edge(a++, map);
      continue;
    }
    const uint32_t ball = arcs_[a].ball;
    uint32_t last = a + 1;
    while (last < arcs_.size() && arcs_[last].ball == ball && arcs_[last].nearer == no_id) ++last;
    const Span<Landing> landings = landing_.part(first_landing_[ball], first_landing_[ball + 1]);
    if (!cut_silhouette(a, last, landings, map)) return false;
    landed += landings.size();
    a = last;
  }
  return landed == first_landing_[map.balls.size()];
}

// What leaves a triple vertex next has the same ball on its left.
bool MapLinker::link_triple(uint32_t v, VisibilityMap &map) {
  for (uint32_t k = 0; k < 3; ++k) {
    const uint32_t arriving = leaving(end_at_[3 * v + k]) ^ 1U;
    uint32_t found = 0;
    for (uint32_t other = 0; other < 3; ++other) {
      const uint32_t out = leaving(end_at_[3 * v + other]);
      if (other == k || left_of(map, out) != left_of(map, arriving)) continue;
      map.half_edges[arriving].next = out;
      ++found;
    }
    if (found != 1) return false;
  }
  return true;
}

bool MapLinker::link_half_edges(VisibilityMap &map) {
  for (uint32_t h = 0; h < 2 * map.edges.size(); ++h) map.half_edges.push({no_id, no_id});
  const auto follow = [&](uint32_t arriving, uint32_t out) { map.half_edges[arriving].next = out; };
  // On a closed curve without other vertices the only half-edge of either side follows itself.
  for (uint32_t e = 0; e < map.edges.size(); ++e) {
    const uint32_t v = map.edges[e].vertex[0];
    if (map.vertices[v].kind != MapVertexKind::plain) continue;
    follow(2 * e, 2 * e);
    follow(2 * e + 1, 2 * e + 1);
    map.vertices[v].leaving = 2 * e;
  }
  for (uint32_t v = 0; v < map.vertices.size(); ++v) {
    MapVertex &vertex = map.vertices[v];
    if (vertex.kind == MapVertexKind::plain) continue;
    vertex.leaving = leaving(end_at_[3 * v]);
    if (vertex.kind == MapVertexKind::triple) {
      if (!link_triple(v, map)) return false;
    } else if (vertex.kind == MapVertexKind::tangency) {
      const uint32_t other = leaving(end_at_[3 * v + 1]);
      follow(vertex.leaving ^ 1U, other);
      follow(other ^ 1U, vertex.leaving);
    } else {
      // The silhouette has its ball on the left; the stem arrives from the right.
      follow(2 * before_[v], 2 * after_[v]);
      follow(2 * after_[v] + 1, vertex.leaving);
      follow(vertex.leaving ^ 1U, 2 * before_[v] + 1);
    }
  }
  return true;
}

// Whether all open arcs end at vertices. A silhouette that is seen from where angles begin is joined with what is seen
// up to there, unless roundings have hidden that.
bool MapLinker::all_end_at_vertices() const {
  for (const MapArc &arc : arcs_) {
    if (!arc.closed && (arc.end[0].kind == MapVertexKind::plain || arc.end[1].kind == MapVertexKind::plain))
      return false;
  }
  return true;
}

bool MapLinker::link(Span<const MapArc> arcs, VisibilityMap &map) {
  arcs_ = arcs;
  if (!all_end_at_vertices()) return false;
  sort_named_ends(map.balls.size());
  if (!add_common_vertices(map)) return false;
  add_landings(map);
  return add_edges(map) && link_half_edges(map);
}

}  // namespace hsp
