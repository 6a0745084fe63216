#include "maps/region_linker.hpp"

#include <initializer_list>

#include "core/sorting.hpp"

namespace hsp {

void RegionLinker::carve(Workspace &workspace, const StickLimits &limits) {
  const uint64_t edges = limits.edges;
  named_ = FixedVector<NamedEnd>(workspace.take<NamedEnd>(2 * edges));
  landing_ = FixedVector<Landing>(workspace.take<Landing>(edges));
  vertex_at_ = workspace.take<uint32_t>(2 * edges);
  first_edge_ = workspace.take<uint32_t>(edges);
  last_edge_ = workspace.take<uint32_t>(edges);
  end_at_ = workspace.take<uint32_t>(3 * edges);
  ends_ = workspace.take<uint8_t>(edges);
  before_ = workspace.take<uint32_t>(edges);
  after_ = workspace.take<uint32_t>(edges);
}

// Along a crease the triple point where it enters the third ball has one sign of the determinant of the balls and the
// point, the one where it leaves has the other; exchanging two of the balls changes the sign.
RegionLinker::NamedEnd RegionLinker::name_of_triple(uint32_t end) const {
  const MapArc &arc = arcs_[end / 2];
  NamedEnd named{Corner::triple, arc.ball, arc.nearer, arc.end[end % 2].ball, end % 2, end};
  const auto order = [&named](uint32_t &a, uint32_t &b) {
    if (a <= b) return;
    const uint32_t other = a;
    a = b;
    b = other;
    named.point ^= 1U;
  };
  order(named.first, named.second);
  order(named.second, named.third);
  order(named.first, named.second);
  return named;
}

// False for an end that is none.
bool RegionLinker::name(uint32_t end, NamedEnd &named) const {
  const MapArc &arc = arcs_[end / 2];
  const uint32_t last = end % 2;
  const ArcEnd &label = arc.end[last];
  const bool of_ball = scene_.is_ball(arc.ball);
  if (label.kind == MapVertexKind::triple) {
    if (!of_ball || arc.nearer == no_id || !scene_.is_ball(arc.nearer) || !scene_.is_ball(label.ball)) return false;
    named = name_of_triple(end);
    return true;
  }
  if (label.kind != MapVertexKind::tangency) return false;
  if (arc.nearer == no_id && of_ball) {
    const uint32_t other = label.ball;
    if (other == no_id) return false;
    if (scene_.is_ball(other)) {
      // The crease ends where the silhouette of the nearer ball begins, and the other way round.
      const bool less = other < arc.ball;
      named = {Corner::tangency, less ? other : arc.ball, less ? arc.ball : other, no_id, 1 - last, end};
    } else {
      // Behind a stick's bite the silhouette begins at the right of the stick.
      named = {Corner::top, scene_.stick_of(other), no_id, no_id, 1 - last, end};
    }
    return true;
  }
  if (arc.nearer == no_id) {
    const bool left = arc.from < 0.0;
    const uint32_t part = scene_.part_of(arc.ball);
    const bool low = left ? last == 1 : last == 0;
    if (!low && part + 1 == scene_.stick_at(arc.ball).parts) return false;
    const Corner corner = low && part == 0 ? Corner::foot : Corner::middle;
    named = {corner, scene_.stick_of(arc.ball), no_id, no_id, left ? 0U : 1U, end};
    return true;
  }
  if (of_ball && scene_.is_ball(arc.nearer)) {
    const bool less = arc.ball < arc.nearer;
    named = {Corner::tangency, less ? arc.ball : arc.nearer, less ? arc.nearer : arc.ball, no_id, last, end};
    return true;
  }
  // From the left to the right.
  const StickRing ring = scene_.ring_of(arc.ball, arc.nearer);
  const Corner corner = ring == StickRing::foot ? Corner::foot : ring == StickRing::top ? Corner::top : Corner::middle;
  named = {corner, scene_.stick_of(of_ball ? arc.nearer : arc.ball), no_id, no_id, last, end};
  return true;
}

uint32_t RegionLinker::add_vertex(uint32_t end, MapVertexKind kind, uint32_t third, StickRegions &regions) {
  const MapArc &arc = arcs_[end / 2];
  const Vec3 at = scene_.at(arc.ball, arc.nearer, end % 2 == 0 ? arc.from : arc.to);
  const uint32_t v = regions.vertices.size();
  regions.vertices.push({at.x, at.y, at.z, kind, no_id, {arc.ball, arc.nearer, third}});
  return v;
}

bool RegionLinker::add_corner(Span<const NamedEnd> ends, StickRegions &regions) {
  const Corner corner = ends[0].corner;
  const MapVertexKind kind = corner == Corner::triple   ? MapVertexKind::triple
                             : corner == Corner::middle ? MapVertexKind::halves
                                                        : MapVertexKind::tangency;
  const uint32_t count = degree_of(kind);
  if (ends.size() != count) return false;
  // Of a crease or half circle, whose bodies are those of all that meet there.
  uint32_t named = ends[0].end;
  for (const NamedEnd &each : ends) named = arcs_[each.end / 2].nearer != no_id ? each.end : named;
  const uint32_t third = corner == Corner::triple ? arcs_[named / 2].end[named % 2].ball : no_id;
  const uint32_t v = add_vertex(named, kind, third, regions);
  ends_[v] = static_cast<uint8_t>(count);
  for (uint32_t k = 0; k < count; ++k) {
    end_at_[3 * v + k] = ends[k].end;
    vertex_at_[ends[k].end] = v;
  }
  return true;
}

bool RegionLinker::add_vertices(StickRegions &regions) {
  named_.clear();
  landing_.clear();
  for (uint32_t end = 0; end < 2 * arcs_.size(); ++end) {
    const MapArc &arc = arcs_[end / 2];
    if (arc.closed) continue;
    const ArcEnd &label = arc.end[end % 2];
    if (label.kind == MapVertexKind::t) {
      const uint32_t v = add_vertex(end, MapVertexKind::t, label.ball, regions);
      const MapVertex &at = regions.vertices[v];
      landing_.push({scene_.landing(label.ball, at.x, at.y), v, label.ball});
      ends_[v] = 1;
      end_at_[3 * v] = end;
      vertex_at_[end] = v;
      continue;
    }
    NamedEnd named{};
    if (!name(end, named)) return false;
    named_.push(named);
  }
  const Span<NamedEnd> named = named_.items();
  sort_in_place(named, [](const NamedEnd &a, const NamedEnd &b) {
    if (a.corner != b.corner) return a.corner < b.corner;
    if (a.first != b.first) return a.first < b.first;
    if (a.second != b.second) return a.second < b.second;
    if (a.third != b.third) return a.third < b.third;
    return a.point != b.point ? a.point < b.point : a.end < b.end;
  });
  for (uint32_t first = 0, last = 0; first < named.size(); first = last) {
    while (last < named.size() && named[last].same(named[first])) ++last;
    if (!add_corner(named.part(first, last), regions)) return false;
  }
  sort_in_place(landing_.items(), [](const Landing &a, const Landing &b) {
    return a.body != b.body ? a.body < b.body : a.vertex < b.vertex;
  });
  return true;
}

uint32_t RegionLinker::add_edge(const MapArc &arc, double from, double to, uint32_t v, uint32_t w,
                                StickRegions &regions) {
  const uint32_t e = regions.edges.size();
  regions.edges.push({from, to, arc.ball, arc.nearer, {v, w}});
  return e;
}

// The edge of an arc that nothing cuts.
void RegionLinker::add_whole_edge(uint32_t a, StickRegions &regions) {
  const MapArc &arc = arcs_[a];
  uint32_t v = vertex_at_[2 * a];
  uint32_t w = vertex_at_[2 * a + 1];
  if (arc.closed) {
    v = w = add_vertex(2 * a, MapVertexKind::plain, no_id, regions);
    ends_[v] = 0;
    end_at_[3 * v] = 2 * a;
  }
  first_edge_[a] = last_edge_[a] = add_edge(arc, arc.from, arc.to, v, w, regions);
}

// A whole circle: each edge goes from one T to the next.
void RegionLinker::cut_circle(uint32_t a, Span<const Landing> landings, StickRegions &regions) {
  const uint32_t n = landings.size();
  first_edge_[a] = last_edge_[a] = regions.edges.size();
  for (uint32_t k = 0; k < n; ++k) {
    const bool wraps = k + 1 == n;
    const Landing &next = landings[wraps ? 0 : k + 1];
    const uint32_t e =
        add_edge(arcs_[a], landings[k].t, next.t + (wraps ? 2 * pi : 0.0), landings[k].vertex, next.vertex, regions);
    after_[landings[k].vertex] = e;
    before_[next.vertex] = e;
  }
}

// Arcs first .. last - 1 of a contour, cut where stems end. Parameters on sticks are less than a turn too.
bool RegionLinker::cut_contour(uint32_t first, uint32_t last, Span<Landing> landings, StickRegions &regions) {
  sort_landings(arcs_.part(first, last), landings);
  if (arcs_[first].closed && !landings.empty()) {
    cut_circle(first, landings, regions);
    return true;
  }
  uint32_t next = 0;
  for (uint32_t a = first; a < last; ++a) {
    const MapArc &arc = arcs_[a];
    if (arc.closed) {
      add_whole_edge(a, regions);
      continue;
    }
    // What lies in the gap behind the arc belongs to the nearer side of it.
    const double reach = a + 1 < last ? 0.5 * (arc.to + arcs_[a + 1].from) : arc.to + 2 * pi;
    double from = arc.from;
    uint32_t v = vertex_at_[2 * a];
    first_edge_[a] = regions.edges.size();
    for (; next < landings.size() && landings[next].t < reach; ++next) {
      const Landing &landing = landings[next];
      if (landing.t < arc.from - landing_tolerance || landing.t > arc.to + landing_tolerance) return false;
      const double at = landing.t < from ? from : landing.t > arc.to ? arc.to : landing.t;
      const uint32_t e = add_edge(arc, from, at, v, landing.vertex, regions);
      before_[landing.vertex] = e;
      after_[landing.vertex] = e + 1;
      from = at;
      v = landing.vertex;
    }
    last_edge_[a] = add_edge(arc, from, arc.to, v, vertex_at_[2 * a + 1], regions);
  }
  return next == landings.size();
}

// False if a stem ends on a contour that is not seen there.
bool RegionLinker::add_edges(StickRegions &regions) {
  uint32_t landed = 0;
  for (uint32_t a = 0; a < arcs_.size();) {
    if (arcs_[a].nearer != no_id) {
      add_whole_edge(a++, regions);
      continue;
    }
    const uint32_t body = arcs_[a].ball;
    uint32_t last = a + 1;
    while (last < arcs_.size() && arcs_[last].ball == body && arcs_[last].nearer == no_id) ++last;
    while (landed < landing_.size() && landing_[landed].body < body) return false;
    uint32_t end = landed;
    while (end < landing_.size() && landing_[end].body == body) ++end;
    if (!cut_contour(a, last, landing_.items().part(landed, end), regions)) return false;
    landed = end;
    a = last;
  }
  return landed == landing_.size();
}

bool RegionLinker::link_half_edges(StickRegions &regions) {
  regions.half_edges.set_count(2 * static_cast<uint64_t>(regions.edges.size()));
  for (MapHalfEdge &half_edge : regions.half_edges.items()) half_edge = {no_id, no_id};
  const auto follow = [&](uint32_t arriving, uint32_t out) { regions.half_edges[arriving].next = out; };
  for (uint32_t v = 0; v < regions.vertices.size(); ++v) {
    const uint32_t out = leaving(end_at_[3 * v]);
    regions.vertices[v].leaving = out;
    if (ends_[v] == 0) {
      follow(out, out);
      follow(out ^ 1U, out ^ 1U);
    } else if (ends_[v] == 1) {
      // The contour has its body on the left; the stem arrives from the right.
      follow(2 * before_[v], 2 * after_[v]);
      follow(2 * after_[v] + 1, out);
      follow(out ^ 1U, 2 * before_[v] + 1);
    } else if (ends_[v] == 2) {
      const uint32_t other = leaving(end_at_[3 * v + 1]);
      follow(out ^ 1U, other);
      follow(other ^ 1U, out);
    } else {
      // What leaves next has the same body on its left.
      for (uint32_t k = 0; k < 3; ++k) {
        const uint32_t arriving = leaving(end_at_[3 * v + k]) ^ 1U;
        uint32_t found = 0;
        for (uint32_t other = 0; other < 3; ++other) {
          const uint32_t next = leaving(end_at_[3 * v + other]);
          if (other == k || regions.left_of(next) != regions.left_of(arriving)) continue;
          follow(arriving, next);
          ++found;
        }
        if (found != 1) return false;
      }
    }
  }
  return true;
}

bool RegionLinker::link(Span<const MapArc> arcs, StickRegions &regions) {
  scene_ = regions.scene;
  arcs_ = arcs;
  return add_vertices(regions) && add_edges(regions) && link_half_edges(regions);
}

}  // namespace hsp
