#include "topology/simple_faces.hpp"

#include "boundary/half_edge_links.hpp"

namespace hsp {
namespace {

class Assembly {
 public:
  Assembly(const BallSet &balls, const BoundaryStructure &boundary, TopologyStructure &topology)
      : balls_(balls), boundary_(boundary), topology_(topology), quads_(topology.quads) {}

  void run() {
    start_vertices();
    number_edges();
    for (uint32_t point = 0; point < topology_.split_points.size(); ++point) {
      const uint32_t carrier = topology_.split_points[point].carrier;
      if (topology_.split_points.first(carrier) == point && carrier < 3 * boundary_.vertices.size()) {
        link_carrier(carrier, boundary_.uses[carrier].vertex, end_of(carrier));
      }
    }
    for (uint32_t c = 0; c < boundary_.circles.size(); ++c) link_circle(c);
    for (uint32_t first = 0; first < topology_.extra_arcs.size();) first = link_extra_arcs(first);
    link_spheres();
    link_loops_and_number_faces();
  }

 private:
  uint32_t end_of(uint32_t use) const { return boundary_.uses[boundary_.uses[use].next].vertex; }
  uint32_t vertex_of_split(uint32_t split) const { return boundary_.vertices.size() + split; }

  // Gives the next edge its source, and no faces yet.
  void add_edge(uint32_t source) {
    const uint32_t q = quarter_edge(quads_.edges);
    topology_.edge_source[quads_.edges++] = source;
    quads_.start[rot(q)] = quads_.start[inverse_rot(q)] = no_id;
  }
  // As many edges as the carrier has pieces; returns the last of them, reversed, with which the walk on the carrier's
  // other side starts.
  uint32_t add_carrier(uint32_t carrier, uint32_t source) {
    topology_.walk_start[carrier] = quarter_edge(quads_.edges);
    add_edge(source);
    for (uint32_t s = topology_.split_points.first(carrier); s != no_id; s = topology_.split_points[s].next) {
      add_edge(source);
    }
    return sym(quarter_edge(quads_.edges - 1));
  }

  // Arcs are numbered by their uses on the first of their balls. Those in one piece get their ends at once.
  void number_edges() {
    quads_.edges = 0;
    uint32_t arcs = 0;
    for (uint32_t i = 0; i < balls_.n; ++i) {
      for (uint32_t use = boundary_.first_use[i]; use < boundary_.first_use[i + 1]; ++use) {
        if (boundary_.uses[use].out < i) continue;
        topology_.carrier_of_arc[arcs] = use;
        topology_.walk_start[twin_use(boundary_, use)] = add_carrier(use, arcs++);
        if (topology_.split_points.first(use) == no_id) {
          set_ends(topology_.walk_start[use], boundary_.uses[use].vertex, end_of(use));
        }
      }
    }
    topology_.first_circle_edge = quads_.edges;
    for (uint32_t c = 0; c < boundary_.circles.size(); ++c) {
      for (uint32_t half = 0; half < 2; ++half) {
        const uint32_t carrier = SplitPoints::half_circle(boundary_, c, half);
        add_carrier(carrier, carrier);
      }
    }
    topology_.first_extra_edge = quads_.edges;
    for (uint32_t k = 0; k < topology_.extra_arcs.size(); ++k) {
      topology_.extra_first_edge[k] = quads_.edges;
      for (uint32_t piece = 0; piece < topology_.extra_arcs[k].pieces(); ++piece) add_edge(k);
    }
    topology_.first_sphere_edge = quads_.edges;
    for (uint32_t i = 0; i < balls_.n; ++i) {
      if (!is_whole_sphere(boundary_, i)) continue;
      add_edge(i);
      add_edge(i);
    }
  }

  void start_vertices() {
    topology_.first_pole = boundary_.vertices.size() + topology_.split_points.size();
    topology_.vertex_count = topology_.first_pole;
  }
  uint32_t add_pole(uint32_t ball, uint32_t lowest) {
    topology_.pole[topology_.vertex_count - topology_.first_pole] = 2 * ball + lowest;
    return topology_.vertex_count++;
  }

  void set_ends(uint32_t q, uint32_t from, uint32_t to) {
    quads_.start[q] = from;
    quads_.start[sym(q)] = to;
    topology_.vertex_edge[from] = q;  // some edge leaves every vertex: loops go on where they arrive
  }

  // The extra arc that leaves a split point into the face on one side, as a quarter-edge away from it; no_id if none.
  uint32_t leaving(const SplitPoint &point, uint32_t side) const {
    if (point.extra[side] == no_id) return no_id;
    const uint32_t arc = point.extra[side] / 2;
    const uint32_t first = topology_.extra_first_edge[arc];
    const uint32_t last = first + topology_.extra_arcs[arc].pieces() - 1;
    return point.extra[side] % 2 == 0 ? quarter_edge(first) : sym(quarter_edge(last));
  }

  // The loop that arrives by `before` and goes on by `after`, both with the face on their left, at a split point: an
  // extra arc into the face comes in between.
  void pass_split(const SplitPoint &point, uint32_t side, uint32_t before, uint32_t after) {
    const uint32_t branch = leaving(point, side);
    if (branch == no_id) {
      quads_.follow(before, after);
    } else {
      quads_.follow(before, branch);
      quads_.follow(sym(branch), after);
    }
  }

  // The edges of one carrier, from vertex `from` to vertex `to` as the loop of its first ball walks it.
  // Returns the last of them.
  uint32_t link_carrier(uint32_t carrier, uint32_t from, uint32_t to) {
    uint32_t q = topology_.walk_start[carrier];
    for (uint32_t s = topology_.split_points.first(carrier); s != no_id; s = topology_.split_points[s].next) {
      const SplitPoint &point = topology_.split_points[s];
      set_ends(q, from, vertex_of_split(s));
      from = vertex_of_split(s);
      const uint32_t following = q + 4;
      pass_split(point, 0, q, following);
      pass_split(point, 1, sym(following), sym(q));
      q = following;
    }
    set_ends(q, from, to);
    return q;
  }

  void link_circle(uint32_t circle) {
    const uint32_t half[2] = {SplitPoints::half_circle(boundary_, circle, 0),
                              SplitPoints::half_circle(boundary_, circle, 1)};
    for (uint32_t h = 0; h < 2; ++h) {
      const uint32_t last = link_carrier(half[h], vertex_of_split(2 * circle + h), vertex_of_split(2 * circle + 1 - h));
      const SplitPoint &end = topology_.split_points[2 * circle + 1 - h];
      const uint32_t following = topology_.walk_start[half[1 - h]];
      pass_split(end, 0, last, following);
      pass_split(end, 1, sym(following), sym(last));
    }
  }

  // A piece of an extra arc that leaves a pole, by its direction in the plane z = 0.
  struct Ray {
    int64_t x, y;
    uint32_t q;
  };
  static bool lies_below(const Ray &a) { return a.y < 0 || (a.y == 0 && a.x < 0); }
  static bool turns_before(const Ray &a, const Ray &b) {
    if (lies_below(a) != lies_below(b)) return lies_below(b);
    return a.x * b.y - a.y * b.x > 0;
  }

  // The extra arcs of one ball, from number `first` on: their vertices, and the order of the pieces about the poles.
  // Returns the number of the first arc of the next ball.
  uint32_t link_extra_arcs(uint32_t first) {
    const FixedVector<ExtraArc> &arcs = topology_.extra_arcs;
    const uint32_t ball = arcs[first].ball;
    uint32_t last = first;
    uint32_t pole_vertex[2] = {no_id, no_id};
    for (; last < arcs.size() && arcs[last].ball == ball; ++last) {
      const ExtraArc &arc = arcs[last];
      if ((arc.poles & ExtraArc::vertex_at_north) != 0 && pole_vertex[0] == no_id) pole_vertex[0] = add_pole(ball, 0);
      if ((arc.poles & ExtraArc::vertex_at_south) != 0 && pole_vertex[1] == no_id) pole_vertex[1] = add_pole(ball, 1);
      uint32_t q = quarter_edge(topology_.extra_first_edge[last]);
      uint32_t from = vertex_of_split(arc.split[0]);
      const bool south_first = (arc.poles & ExtraArc::south_first) != 0;
      for (uint32_t turn = 0; turn < 2; ++turn) {
        const uint32_t lowest = (turn == 0) == south_first ? 1 : 0;
        if ((arc.poles & (lowest == 1 ? ExtraArc::vertex_at_south : ExtraArc::vertex_at_north)) == 0) continue;
        set_ends(q, from, pole_vertex[lowest]);
        from = pole_vertex[lowest];
        q += 4;
      }
      set_ends(q, from, vertex_of_split(arc.split[1]));
    }
    for (uint32_t lowest = 0; lowest < 2; ++lowest) {
      if (pole_vertex[lowest] != no_id) link_pole(arcs.items().part(first, last), first, lowest);
    }
    return last;
  }

  // About the normal m of its plane an extra arc passes the highest point in the direction m x z and the lowest one in
  // the opposite direction. Each arrival is followed, about the face on its left, by the next ray clockwise as seen
  // from outside the ball, which is clockwise in the plane z = 0 above and counter-clockwise below.
  void link_pole(Span<ExtraArc> arcs, uint32_t first, uint32_t lowest) {
    const uint32_t at_vertex = lowest == 1 ? ExtraArc::vertex_at_south : ExtraArc::vertex_at_north;
    const int64_t direction = lowest == 1 ? -1 : 1;
    const auto visit_rays = [&](auto visit) {
      for (uint32_t k = 0; k < arcs.size(); ++k) {
        if ((arcs[k].poles & at_vertex) == 0) continue;
        const exact::Vector m = plane_of_cut(balls_, arcs[k].ball, arcs[k].ball, arcs[k].cap).v;
        const bool second = arcs[k].pieces() == 3 && ((arcs[k].poles & ExtraArc::south_first) != 0) == (lowest == 0);
        const uint32_t arriving = quarter_edge(topology_.extra_first_edge[first + k] + (second ? 1U : 0U));
        visit(Ray{-direction * m.y, direction * m.x, sym(arriving)});
        visit(Ray{direction * m.y, -direction * m.x, arriving + 4});
      }
    };
    // The rays are few; each looks for its predecessor, and the last of all comes before the first.
    visit_rays([&](const Ray &ray) {
      Ray before{0, 0, no_id};
      Ray last = ray;
      visit_rays([&](const Ray &other) {
        if (turns_before(other, ray) && (before.q == no_id || turns_before(before, other))) before = other;
        if (turns_before(last, other)) last = other;
      });
      if (before.q == no_id) before = last;
      if (lowest == 0) {
        quads_.follow(sym(ray.q), before.q);
      } else {
        quads_.follow(sym(before.q), ray.q);
      }
    });
  }

  // Whole spheres: the great circle across x, from the highest point to the lowest and back, counter-clockwise about x.
  void link_spheres() {
    uint32_t q = quarter_edge(topology_.first_sphere_edge);
    for (uint32_t i = 0; i < balls_.n; ++i) {
      if (!is_whole_sphere(boundary_, i)) continue;
      const uint32_t top = add_pole(i, 0);
      const uint32_t bottom = add_pole(i, 1);
      const uint32_t up = q + 4;
      set_ends(q, top, bottom);
      set_ends(up, bottom, top);
      quads_.follow(q, up);
      quads_.follow(up, q);
      quads_.follow(sym(q), sym(up));
      quads_.follow(sym(up), sym(q));
      q += 8;
    }
  }

  // Ball by ball, so that the simple faces of a ball are consecutive: around the end of every arc the walk goes on to
  // that of the next use, and then all rings on the ball are closed.
  void link_loops_and_number_faces() {
    topology_.face_count = 0;
    uint32_t extra = 0;
    uint32_t sphere = quarter_edge(topology_.first_sphere_edge);
    for (uint32_t i = 0; i < balls_.n; ++i) {
      for (uint32_t u = boundary_.first_use[i]; u < boundary_.first_use[i + 1]; ++u) {
        quads_.follow(topology_.end_of_walk(topology_.walk_start[u]), topology_.walk_start[boundary_.uses[u].next]);
      }
      for (uint32_t u = boundary_.first_use[i]; u < boundary_.first_use[i + 1]; ++u) {
        number_walk(topology_.walk_start[u], boundary_.loop_face[boundary_.uses[u].loop]);
      }
      for (uint32_t s = boundary_.first_circle_side[i]; s < boundary_.first_circle_side[i + 1]; ++s) {
        const uint32_t circle = boundary_.circle_side[s] / 2;
        const uint32_t side = boundary_.circle_side[s] % 2;
        // From the circle's first point on either side: ids must have no effect on where a ring starts.
        for (uint32_t turn = 0; turn < 2; ++turn) {
          const uint32_t half = side == 0 ? turn : 1 - turn;
          const uint32_t start = topology_.walk_start[SplitPoints::half_circle(boundary_, circle, half)];
          number_walk(side == 0 ? start : sym(topology_.end_of_walk(start)),
                      boundary_.loop_face[boundary_.circles[circle].loop[side]]);
        }
      }
      for (; extra < topology_.extra_arcs.size() && topology_.extra_arcs[extra].ball == i; ++extra) {
        for (uint32_t piece = 0; piece < topology_.extra_arcs[extra].pieces(); ++piece) {
          const uint32_t q = quarter_edge(topology_.extra_first_edge[extra] + piece);
          number_ring(q, topology_.extra_arcs[extra].face);
          number_ring(sym(q), topology_.extra_arcs[extra].face);
        }
      }
      if (is_whole_sphere(boundary_, i)) {
        number_ring(sphere, boundary_.first_face[i]);
        number_ring(sym(sphere), boundary_.first_face[i]);
        sphere += 8;
      }
    }
  }
  void number_walk(uint32_t start, uint32_t face) {
    number_ring(start, face);
    const uint32_t last = topology_.end_of_walk(start);
    const uint32_t step = start < last ? 4U : 0U - 4U;
    for (uint32_t q = start; q != last;) number_ring(q += step, face);
  }
  void number_ring(uint32_t q, uint32_t face) {
    if (quads_.left(q) != no_id) return;
    SimpleFace &simple = topology_.faces[topology_.face_count];
    simple = {face, q, 0};
    uint32_t at = q;
    do {
      quads_.start[inverse_rot(at)] = topology_.face_count;
      ++simple.edges;
      at = quads_.lnext(at);
    } while (at != q);
    ++topology_.face_count;
  }

  const BallSet &balls_;
  const BoundaryStructure &boundary_;
  TopologyStructure &topology_;
  QuadEdges &quads_;
};

}  // namespace

uint64_t count_uncut_edges(const BallSet &balls, const BoundaryStructure &boundary) {
  uint64_t edges =
      3 * static_cast<uint64_t>(boundary.vertices.size()) / 2 + 2 * static_cast<uint64_t>(boundary.circles.size());
  for (uint32_t i = 0; i < balls.n; ++i) edges += is_whole_sphere(boundary, i) ? 2U : 0U;
  return edges;
}

uint64_t count_edges(const BallSet &balls, const BoundaryStructure &boundary, const TopologyStructure &topology) {
  // Every split point beyond the two of each free circle makes one edge into two.
  uint64_t edges = count_uncut_edges(balls, boundary) + topology.split_points.size() -
                   2 * static_cast<uint64_t>(boundary.circles.size());
  for (const ExtraArc &arc : topology.extra_arcs.items()) edges += arc.pieces();
  return edges;
}

void assemble_simple_faces(const BallSet &balls, const BoundaryStructure &boundary, TopologyStructure &topology) {
  Assembly(balls, boundary, topology).run();
}

}  // namespace hsp
