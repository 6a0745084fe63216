// Links the quad-edges of the boundary around their faces.
//
// As an example two balls that meet in one free circle, which two subdivision vertices halve:
//        0 ---- e0 ---> 1         quarter-edge 0 is e0 with the face of the first ball on its left, sym(0) = 2 is the
//        ^              |         same edge with that of the second ball on its left; 4 and 6 are those of e1
//        +----- e1 -----+
//   on the first ball     lnext(0) = 4, lnext(4) = 0
//   on the second ball    lnext(6) = 2, lnext(2) = 6, the other way round
//   vertices - edges + faces = 2 - 2 + 2 = 2
#include "topology/simple_faces.hpp"

#include "core/small_code.hpp"

namespace hsp {
namespace {

class SimpleFaceBuilder {
 public:
  SimpleFaceBuilder(const BallSet &balls, const Boundary &boundary, Patience &patience, Topology &topology)
      : balls_(balls), boundary_(boundary), patience_(patience), topology_(topology), quads_(topology.quads) {}

  void run() {
    start_vertices();
    if (!number_edges()) return;
    const Subdivision &points = topology_.subdivision;
    for (uint32_t point = points.first_inner(); point < points.size() && patience_.allows(200); ++point) {
      const uint32_t host = points.host(point);
      if (points.first(host) == point && !Subdivision::is_half_circle(boundary_, host)) {
        link_host(host, boundary_.half_edge(host).vertex, end_of(host));
      }
    }
    for (uint32_t c = 0; c < boundary_.circle_count() && patience_.allows(200); ++c) link_circle(c);
    for (uint32_t k = 0; k < topology_.cut_arcs.size() && patience_.allows(200); ++k) branch_off(k);
    for (uint32_t first = 0; first < topology_.cut_arcs.size() && patience_.allows(5000);) first = link_cut_arcs(first);
    link_spheres();
    link_loops_and_number_faces();
  }

 private:
  uint32_t end_of(uint32_t half_edge) const { return boundary_.end_vertex(half_edge); }
  uint32_t vertex_of_subdivision(uint32_t split) const { return boundary_.vertex_count() + split; }

  // Adds an edge with its source, without faces yet.
  void add_edge(uint32_t source) {
    const uint32_t q = quarter_edge(quads_.edges);
    topology_.edge_source[quads_.edges++] = source;
    quads_.start[rot(q)] = quads_.start[inverse_rot(q)] = no_id;
  }
  // Adds an edge for each piece of the host edge; returns its chain in the other direction, that of the twin.
  uint32_t add_host(uint32_t host, uint32_t source) {
    const uint32_t first = quarter_edge(quads_.edges);
    add_edge(source);
    for (uint32_t s = topology_.subdivision.first(host); s != no_id; s = topology_.subdivision.next(s)) {
      add_edge(source);
    }
    const uint32_t last = quarter_edge(quads_.edges - 1);
    const uint32_t cut = first != last ? 1U : 0U;
    topology_.chain[host] = first | cut;
    return sym(last) | cut;
  }

  // Arcs are numbered by their half-edges on the first of their balls.
  bool number_edges() {
    quads_.edges = 0;
    uint32_t arcs = 0;
    in_parts(patience_, BallRange{0, balls_.n}, 500, [&](BallRange some) {
      for (uint32_t i = some.first; i < some.last; ++i) {
        for (const uint32_t half_edge : boundary_.half_edges(i)) {
          if (boundary_.half_edge(half_edge).circle < i) continue;
          topology_.host_of_arc[arcs] = half_edge;
          topology_.vertex_edge[boundary_.half_edge(half_edge).vertex] = quarter_edge(quads_.edges);
          topology_.chain[boundary_.twin(half_edge)] = add_host(half_edge, arcs++);
        }
      }
    });
    if (!patience_.allows(1000 * uint64_t{balls_.n})) return false;
    topology_.first_circle_edge = quads_.edges;
    for (uint32_t c = 0; c < boundary_.circle_count(); ++c) {
      for (uint32_t half = 0; half < 2; ++half) {
        const uint32_t host = Subdivision::half_circle(boundary_, c, half);
        add_host(host, host);
      }
    }
    topology_.first_cut_edge = quads_.edges;
    for (uint32_t k = 0; k < topology_.cut_arcs.size(); ++k) {
      topology_.cut_first_edge[k] = quads_.edges;
      for (uint32_t piece = 0; piece < topology_.cut_arcs[k].pieces(); ++piece) add_edge(k);
    }
    topology_.first_sphere_edge = quads_.edges;
    for (uint32_t i = 0; i < balls_.n; ++i) {
      if (!boundary_.is_whole_sphere(i)) continue;
      add_edge(i);
      add_edge(i);
    }
    return true;
  }

  void start_vertices() {
    topology_.first_pole = boundary_.vertex_count() + topology_.subdivision.size();
    topology_.vertex_count = topology_.first_pole;
  }
  uint32_t add_pole(uint32_t ball, uint32_t lowest) {
    topology_.pole[topology_.vertex_count - topology_.first_pole] = Pole(ball, lowest == 1);
    return topology_.vertex_count++;
  }

  void set_ends(uint32_t q, uint32_t from, uint32_t to) {
    quads_.start[q] = from;
    quads_.start[sym(q)] = to;
    topology_.vertex_edge[from] = q;  // an edge starts at every vertex, as loops go on from where they arrive
  }

  // Links `before` to `after` at a subdivision vertex, along the loop of ball a, and back along the loop of ball b.
  void pass_subdivision_vertex(uint32_t before, uint32_t after) {
    quads_.link_lnext(before, after);
    quads_.link_lnext(sym(after), sym(before));
  }

  // Links the edges of one host edge, from vertex `from` to vertex `to` in the direction of the loop of its first ball.
  // Returns the last of them.
  uint32_t link_host(uint32_t host, uint32_t from, uint32_t to) {
    uint32_t q = topology_.chain_start(host);
    for (uint32_t s = topology_.subdivision.first(host); s != no_id; s = topology_.subdivision.next(s)) {
      set_ends(q, from, vertex_of_subdivision(s));
      from = vertex_of_subdivision(s);
      pass_subdivision_vertex(q, q + 4);
      q += 4;
    }
    set_ends(q, from, to);
    return q;
  }

  void link_circle(uint32_t circle) {
    const uint32_t half[2] = {Subdivision::half_circle(boundary_, circle, 0),
                              Subdivision::half_circle(boundary_, circle, 1)};
    for (uint32_t h = 0; h < 2; ++h) {
      const uint32_t last =
          link_host(half[h], vertex_of_subdivision(2 * circle + h), vertex_of_subdivision(2 * circle + 1 - h));
      pass_subdivision_vertex(last, topology_.chain_start(half[1 - h]));
    }
  }

  // At each of its ends a cut arc is linked between the two edges that meet there on its side. Here the vertex_edge of
  // these vertices is still the edge along the loop of ball a.
  void branch_off(uint32_t cut_arc) {
    const CutArc &arc = topology_.cut_arcs[cut_arc];
    const uint32_t first = topology_.cut_first_edge[cut_arc];
    const uint32_t leaving[2] = {quarter_edge(first), sym(quarter_edge(first + arc.pieces() - 1))};
    for (uint32_t end = 0; end < 2; ++end) {
      const uint32_t along = topology_.vertex_edge[vertex_of_subdivision(arc.ends[end].point())];
      const uint32_t after = arc.ends[end].side() == 0 ? along : quads_.next_on_face(sym(along));
      const uint32_t before = sym(quads_.next[after]);
      quads_.link_lnext(before, leaving[end]);
      quads_.link_lnext(sym(leaving[end]), after);
    }
  }

  // A piece q of a cut arc that leaves a pole, and its direction seen from above. An arc whose plane has the normal m
  // passes the highest point in the direction m x z. It passes the lowest point in the opposite direction; but this
  // turns all rays of that pole by half a turn, and their cyclic order stays.
  struct Ray {
    int64_t x, y;
    uint32_t q;
  };
  Ray ray_of(uint32_t q) const {
    const CutArc &arc = topology_.cut_arcs[topology_.edge_source[edge_of(q)]];
    const exact::Vector m = plane_of_cut(balls_, arc.ball, arc.ball, arc.cap).v;
    const bool arrives = (q & 2U) != 0;
    return arrives ? Ray{-m.y, m.x, q} : Ray{m.y, -m.x, q};
  }
  static bool lies_below(const Ray &a) { return a.y < 0 || (a.y == 0 && a.x < 0); }
  static bool turns_before(const Ray &a, const Ray &b) {
    if (lies_below(a) != lies_below(b)) return lies_below(b);
    return a.x * b.y - a.y * b.x > 0;
  }
  // The rays of a pole are a list. Its links are stored in place of the numbers of faces, which come later.
  uint32_t &next_ray(uint32_t q) { return quads_.start[rot(q)]; }
  // Sorts the list counter-clockwise, by merging runs of one, two, four rays (Knuth, TAOCP 3, section 5.2.4).
  uint32_t sorted_rays(uint32_t list) {
    for (uint32_t length = 1, runs = 2; runs > 1; length *= 2) {
      uint32_t rest = list, last = no_id;
      list = no_id;
      for (runs = 0; rest != no_id; ++runs) {
        uint32_t run[2] = {rest, rest}, left[2] = {0, length};
        for (; left[0] < length && run[1] != no_id; ++left[0]) run[1] = next_ray(run[1]);
        for (;;) {
          if (run[1] == no_id) left[1] = 0;
          if (left[0] + left[1] == 0) break;
          const uint32_t from = left[0] == 0 || (left[1] > 0 && turns_before(ray_of(run[1]), ray_of(run[0]))) ? 1 : 0;
          (last == no_id ? list : next_ray(last)) = run[from];
          last = run[from];
          run[from] = next_ray(last);
          --left[from];
        }
        rest = run[1];
      }
      next_ray(last) = no_id;
    }
    return list;
  }

  // Links the cut arcs of one ball, from number `first` on: sets the ends of their pieces and links these about the
  // poles. Returns the number of the next ball's first cut arc.
  uint32_t link_cut_arcs(uint32_t first) {
    const FixedVector<CutArc> &arcs = topology_.cut_arcs;
    const uint32_t ball = arcs[first].ball;
    uint32_t last = first;
    uint32_t pole_vertex[2] = {no_id, no_id};
    for (; last < arcs.size() && arcs[last].ball == ball; ++last) {
      const CutArc &arc = arcs[last];
      if ((arc.poles & CutArc::vertex_at_north) != 0 && pole_vertex[0] == no_id) pole_vertex[0] = add_pole(ball, 0);
      if ((arc.poles & CutArc::vertex_at_south) != 0 && pole_vertex[1] == no_id) pole_vertex[1] = add_pole(ball, 1);
      uint32_t q = quarter_edge(topology_.cut_first_edge[last]);
      uint32_t from = vertex_of_subdivision(arc.ends[0].point());
      const bool south_first = (arc.poles & CutArc::south_first) != 0;
      for (uint32_t turn = 0; turn < 2; ++turn) {
        const uint32_t lowest = (turn == 0) == south_first ? 1 : 0;
        if ((arc.poles & (lowest == 1 ? CutArc::vertex_at_south : CutArc::vertex_at_north)) == 0) continue;
        set_ends(q, from, pole_vertex[lowest]);
        from = pole_vertex[lowest];
        q += 4;
      }
      set_ends(q, from, vertex_of_subdivision(arc.ends[1].point()));
    }
    for (uint32_t lowest = 0; lowest < 2; ++lowest) {
      if (pole_vertex[lowest] != no_id) link_pole(arcs.items().part(first, last), first, lowest);
    }
    return last;
  }

  // A piece that arrives at a pole is followed, about the face on its left, by the next ray clockwise as seen from
  // outside the ball. Seen from above, this is clockwise at the highest point and counter-clockwise at the lowest.
  void link_pole(Span<const CutArc> arcs, uint32_t first, uint32_t lowest) {
    const uint32_t at_vertex = lowest == 1 ? CutArc::vertex_at_south : CutArc::vertex_at_north;
    uint32_t list = no_id;
    for (uint32_t k = 0; k < arcs.size(); ++k) {
      if ((arcs[k].poles & at_vertex) == 0) continue;
      const bool second = arcs[k].pieces() == 3 && ((arcs[k].poles & CutArc::south_first) != 0) == (lowest == 0);
      const uint32_t arriving = quarter_edge(topology_.cut_first_edge[first + k] + (second ? 1U : 0U));
      next_ray(sym(arriving)) = list;
      next_ray(arriving + 4) = sym(arriving);
      list = arriving + 4;
    }
    list = sorted_rays(list);
    for (uint32_t before = list; before != no_id;) {
      const uint32_t following = next_ray(before), ray = following != no_id ? following : list;
      if (lowest == 0) {
        quads_.link_lnext(sym(ray), before);
      } else {
        quads_.link_lnext(sym(before), ray);
      }
      next_ray(before) = no_id;
      before = following;
    }
  }

  // Whole spheres: the great circle across x, from the highest point to the lowest and back, counter-clockwise about x.
  void link_spheres() {
    if (topology_.first_sphere_edge == quads_.edges) return;
    uint32_t q = quarter_edge(topology_.first_sphere_edge);
    for (uint32_t i = 0; i < balls_.n; ++i) {
      if (!boundary_.is_whole_sphere(i)) continue;
      const uint32_t top = add_pole(i, 0);
      const uint32_t bottom = add_pole(i, 1);
      const uint32_t up = q + 4;
      set_ends(q, top, bottom);
      set_ends(up, bottom, top);
      quads_.link_lnext(q, up);
      quads_.link_lnext(up, q);
      quads_.link_lnext(sym(q), sym(up));
      quads_.link_lnext(sym(up), sym(q));
      q += 8;
    }
  }

  // Ball by ball, so that the simple faces of a ball are consecutive.
  void link_loops_and_number_faces() {
    topology_.face_count = 0;
    uint32_t cut = 0;
    uint32_t sphere = quarter_edge(topology_.first_sphere_edge);
    in_parts(patience_, BallRange{0, balls_.n}, 1000, [&](BallRange some) { number_faces_of(some, cut, sphere); });
  }
  // cut, sphere: the first cut arc and the first edge of a whole sphere that no ball before has. Out of line, so that
  // the loop keeps its registers.
  HSP_APART_UNLESS_SMALL void number_faces_of(BallRange some, uint32_t &cut, uint32_t &sphere) {
    for (uint32_t i = some.first; i < some.last; ++i) {
      const uint32_t first_cut = cut;
      while (cut < topology_.cut_arcs.size() && topology_.cut_arcs[cut].ball == i) ++cut;
      if (cut != first_cut) {
        cut_faces(i, first_cut, cut);
      } else {
        for (const uint32_t loop : boundary_.loops(i)) face_of_loop(loop);
      }
      if (boundary_.is_whole_sphere(i)) {
        number_ring(sphere, boundary_.faces(i).first);
        number_ring(sym(sphere), boundary_.faces(i).first);
        sphere += 8;
      }
    }
  }

  // Numbers the faces of a ball with cut arcs first .. last - 1. First links the chain of every half-edge to that of
  // the next half-edge; then all rings on the ball are closed.
  void cut_faces(uint32_t ball, uint32_t first, uint32_t last) {
    for (const uint32_t u : boundary_.half_edges(ball)) {
      quads_.link_lnext(topology_.chain_end(u), topology_.chain_start(boundary_.half_edge(u).next));
      quads_.start[topology_.chain_start(u)] = boundary_.half_edge(u).vertex;
    }
    for (const uint32_t u : boundary_.half_edges(ball)) {
      number_chain(topology_.chain_start(u), topology_.chain_end(u), boundary_.face_of(u));
    }
    for (const ClosedHalfEdge closed : boundary_.circles(ball)) number_circle(closed);
    for (uint32_t k = first; k < last; ++k) {
      for (uint32_t piece = 0; piece < topology_.cut_arcs[k].pieces(); ++piece) {
        const uint32_t q = quarter_edge(topology_.cut_first_edge[k] + piece);
        number_ring(q, topology_.cut_arcs[k].face);
        number_ring(sym(q), topology_.cut_arcs[k].face);
      }
    }
  }

  // Numbers the face of a loop on a ball without cut arcs, where the loop is the whole border of its face. Links its
  // chains on the way.
  void face_of_loop(uint32_t loop) {
    const LoopElement start = boundary_.loop_start(loop);
    if (start.is_circle()) {
      number_circle(start.closed_half_edge());
      return;
    }
    const uint32_t id = topology_.face_count++;
    uint32_t edges = 0;
    uint32_t u = start.half_edge();
    uint32_t q = topology_.chain_start(u);
    const SimpleFace face{boundary_.face_of_loop(loop), q, 0};
    do {
      const HalfEdge &half_edge = boundary_.half_edge(u);
      quads_.start[q] = half_edge.vertex;
      if (topology_.chain_is_cut(u)) {
        const uint32_t last = topology_.chain_end(u);
        for (; q != last; q = quads_.next_on_face(q)) {
          quads_.start[dual_on_left(q)] = id;
          ++edges;
        }
      }
      const uint32_t following = topology_.chain_start(half_edge.next);
      quads_.start[dual_on_left(q)] = id;
      quads_.link_lnext(q, following);
      ++edges;
      u = half_edge.next;
      q = following;
    } while (q != face.q);
    topology_.faces[id] = {face.face, face.q, edges};
  }

  // Numbers the faces at a free circle on one side, from the circle's first point on: ids must have no effect on where
  // a ring starts.
  void number_circle(ClosedHalfEdge closed) {
    const uint32_t side = closed.side();
    const uint32_t face = boundary_.face_of_loop(boundary_.loop_of(closed));
    for (uint32_t turn = 0; turn < 2; ++turn) {
      const uint32_t host = Subdivision::half_circle(boundary_, closed.circle(), side == 0 ? turn : 1 - turn);
      const uint32_t first = topology_.chain_start(host);
      const uint32_t last = topology_.chain_end(host);
      number_chain(side == 0 ? first : sym(last), side == 0 ? last : sym(first), face);
    }
  }
  void number_chain(uint32_t first, uint32_t last, uint32_t face) {
    number_ring(first, face);
    const uint32_t step = first < last ? 4U : 0U - 4U;
    for (uint32_t q = first; q != last;) number_ring(q += step, face);
  }
  void number_ring(uint32_t q, uint32_t face) {
    if (quads_.face_on_left(q) != no_id) return;
    const uint32_t id = topology_.face_count++;
    uint32_t edges = 0;
    uint32_t at = q;
    do {
      quads_.start[dual_on_left(at)] = id;
      ++edges;
      at = quads_.next_on_face(at);
    } while (at != q);
    topology_.faces[id] = {face, q, edges};
  }

  const BallSet &balls_;
  const Boundary &boundary_;
  Patience &patience_;
  Topology &topology_;
  QuadEdges &quads_;
};

}  // namespace

uint64_t count_uncut_edges(const BallSet &balls, const Boundary &boundary) {
  uint64_t edges =
      3 * static_cast<uint64_t>(boundary.vertex_count()) / 2 + 2 * static_cast<uint64_t>(boundary.circle_count());
  for (uint32_t i = 0; i < balls.n; ++i) edges += boundary.is_whole_sphere(i) ? 2U : 0U;
  return edges;
}

uint64_t count_edges(const BallSet &balls, const Boundary &boundary, const Topology &topology) {
  // Every subdivision vertex beyond the two of each free circle makes one edge into two.
  uint64_t edges =
      count_uncut_edges(balls, boundary) + (topology.subdivision.size() - topology.subdivision.first_inner());
  for (const CutArc &arc : topology.cut_arcs.items()) edges += arc.pieces();
  return edges;
}

void assemble_simple_faces(const BallSet &balls, const Boundary &boundary, Patience &patience, Topology &topology) {
  SimpleFaceBuilder(balls, boundary, patience, topology).run();
}

}  // namespace hsp
