// Where vertices and edges of small topologies lie: on the spheres of the faces beside them and in no ball, each edge
// an arc about its axis from its first vertex to its second; and the same bits for balls given in the opposite order.
#pragma once

#include <initializer_list>

#include "small_topology.hpp"
#include "topology/positions.hpp"

namespace cases {

inline hsp::Vec3 centre_of(const hsp::BallSet &balls, uint32_t i) {
  return {balls.x[i], balls.y[i], balls.z[i]};
}
inline hsp::Vec3 point_of(const hsp::BallSet &balls, const hsp::Position &position) {
  return centre_of(balls, position.ball) + position.offset;
}
inline double length_of(const hsp::Vec3 &a) {
  return std::sqrt(dot(a, a));
}

inline hsp::Vec3 point_of_vertex(SmallTopology &built, uint32_t vertex) {
  return point_of(built.balls(), hsp::position_of_point(built.balls(), built.boundary(), built.topology(), vertex));
}

struct DrawnEdge {
  hsp::Vec3 from, to, centre, axis;
  double radius, angle;

  // At a part of the way.
  hsp::Vec3 at(double part) const {
    const hsp::Vec3 arm = from - centre;
    return centre + combine(std::cos(part * angle), arm, std::sin(part * angle), cross(axis, arm));
  }
};
inline DrawnEdge drawn_edge(SmallTopology &built, uint32_t edge) {
  const hsp::Topology &topology = built.topology();
  const hsp::EdgeGeometry geometry = hsp::geometry_of_edge(built.balls(), built.boundary(), topology, edge);
  const uint32_t q = hsp::quarter_edge(edge);
  return {point_of_vertex(built, topology.quads.origin(q)),
          point_of_vertex(built, topology.quads.origin(hsp::sym(q))),
          point_of(built.balls(), geometry.centre),
          geometry.axis,
          geometry.radius,
          geometry.angle};
}

// With the balls as they are, or in the opposite order.
inline bool build(const Scene &c, bool reversed) {
  SmallBall backwards[8];
  for (uint32_t i = 0; i < c.n; ++i) backwards[c.n - 1 - i] = c.ball[i];
  return small_topology().build(reversed ? backwards : c.ball, c.n);
}
// Whether holds(c) is true of all of them in both orders.
template <class Holds>
uint32_t first_failing_either_way(Holds holds) {
  return first_failing_scene([&](const Scene &c) { return build(c, false) && holds(c) && build(c, true) && holds(c); });
}

inline constexpr double point_tolerance = 1e-9;

inline uint32_t edges_are_arcs_between_their_vertices() {
  return first_failing_either_way([](const Scene &c) {
    const hsp::BallSet &balls = small_topology().balls();
    const hsp::Topology &topology = small_topology().topology();
    for (uint32_t edge = 0; edge < topology.quads.edges; ++edge) {
      const DrawnEdge drawn = drawn_edge(small_topology(), edge);
      const hsp::Vec3 arm = drawn.from - drawn.centre;
      if (!near(length_of(arm), drawn.radius, point_tolerance) || !near(length_of(drawn.axis), 1.0, 1e-14) ||
          !near(dot(arm, drawn.axis), 0.0, point_tolerance) ||
          !near(length_of(drawn.at(1.0) - drawn.to), 0.0, point_tolerance) || drawn.angle < 0.0 ||
          drawn.angle > 2 * hsp::pi) {
        return false;
      }
      const uint32_t q = hsp::quarter_edge(edge);
      const uint32_t left = topology.ball_of(small_topology().boundary(), topology.quads.left(q));
      const uint32_t right = topology.ball_of(small_topology().boundary(), topology.quads.left(hsp::sym(q)));
      for (const double part : {0.0, 0.25, 0.5, 1.0}) {
        for (uint32_t ball = 0; ball < c.n; ++ball) {
          const double beyond = length_of(drawn.at(part) - centre_of(balls, ball)) - balls.r[ball];
          if (ball == left || ball == right ? !near(beyond, 0.0, point_tolerance) : beyond < -point_tolerance)
            return false;
        }
      }
    }
    return true;
  });
}

// An edge between two balls has the face of one of them on its left. That face lies away from the other ball, and the
// edge runs counter-clockwise about its axis: so the axis points from the ball on the right to the one on the left.
inline uint32_t faces_lie_on_the_left() {
  return first_failing_either_way([](const Scene &) {
    const hsp::BallSet &balls = small_topology().balls();
    const hsp::Topology &topology = small_topology().topology();
    for (uint32_t edge = 0; edge < topology.first_cut_edge; ++edge) {
      const DrawnEdge drawn = drawn_edge(small_topology(), edge);
      const uint32_t q = hsp::quarter_edge(edge);
      const uint32_t left = topology.ball_of(small_topology().boundary(), topology.quads.left(q));
      const uint32_t right = topology.ball_of(small_topology().boundary(), topology.quads.left(hsp::sym(q)));
      if (dot(drawn.axis, centre_of(balls, left) - centre_of(balls, right)) <= 0.0) return false;
    }
    return true;
  });
}

// The position between two balls is computed from that of lower rank.
inline uint32_t lower_ranks_are_the_frames() {
  return first_failing_either_way([](const Scene &) {
    const hsp::BallSet &balls = small_topology().balls();
    const hsp::Boundary &boundary = small_topology().boundary();
    const hsp::Topology &topology = small_topology().topology();
    for (uint32_t edge = 0; edge < topology.first_cut_edge; ++edge) {
      const hsp::HostBalls pair = hsp::balls_of_host(boundary, topology.host_of_edge(edge));
      const uint32_t lower = balls.ranks_before(pair.a, pair.b) ? pair.a : pair.b;
      if (hsp::geometry_of_edge(balls, boundary, topology, edge).centre.ball != lower) return false;
      const uint32_t end = topology.quads.origin(hsp::quarter_edge(edge));
      if (topology.kind_of_vertex(boundary, end) == hsp::VertexKind::subdivision_vertex &&
          hsp::position_of_point(balls, boundary, topology, end).ball != lower) {
        return false;
      }
    }
    return true;
  });
}

// How many edges of a kind have a radius and an angle that follow from the balls.
struct KnownEdges {
  uint32_t n;
  SmallBall ball[4];
  hsp::EdgeKind kind;
  uint32_t edges;
  double radius, angle;
};
inline const double cosine_three_fifths = std::acos(0.6), bump_width = std::acos(1 - 81.0 / 20000);
inline const KnownEdges known_edges[] = {
    {1, {{1, 2, 3, 4}}, hsp::EdgeKind::whole_sphere, 2, 4, hsp::pi},
    {2, {{0, 0, 0, 5}, {8, 0, 0, 5}}, hsp::EdgeKind::circle, 2, 3, hsp::pi},
    {2, {{0, 0, 0, 5}, {10, 0, 0, 5}}, hsp::EdgeKind::circle, 2, 0, hsp::pi},
    {3, {{0, 0, 0, 50}, {60, 0, 0, 50}, {120, 0, 0, 50}}, hsp::EdgeKind::circle, 4, 40, hsp::pi},
    {3,
     {{0, 0, 0, 50}, {60, 0, 0, 50}, {120, 0, 0, 50}},
     hsp::EdgeKind::cut_arc,
     2,
     50,
     hsp::pi - 2 * cosine_three_fifths},
    {3, {{0, 0, 0, 100}, {100, 0, 0, 9}, {0, 100, 0, 9}}, hsp::EdgeKind::cut_arc, 4, 100, hsp::pi / 2 - bump_width},
    {3, {{0, 0, 0, 100}, {100, 0, 0, 9}, {0, 100, 0, 9}}, hsp::EdgeKind::cut_arc, 2, 100, hsp::pi},
    {3, {{0, 0, 0, 100}, {0, 0, 100, 9}, {0, 0, -100, 9}}, hsp::EdgeKind::cut_arc, 2, 100, hsp::pi - 2 * bump_width},
    // An octant of a sphere.
    {4, {{0, 0, 0, 3}, {4, 0, 0, 5}, {0, 4, 0, 5}, {0, 0, 4, 5}}, hsp::EdgeKind::arc, 3, 3, hsp::pi / 2}};

inline uint32_t edges_in_closed_form() {
  return first_failing(known_edges, [](const KnownEdges &c) {
    if (!small_topology().build(c.ball, c.n)) return false;
    uint32_t found = 0;
    for (uint32_t edge = 0; edge < small_topology().topology().quads.edges; ++edge) {
      const DrawnEdge drawn = drawn_edge(small_topology(), edge);
      found += small_topology().topology().kind_of_edge(edge) == c.kind && near(drawn.radius, c.radius, 1e-13) &&
                       near(drawn.angle, c.angle, 1e-13)
                   ? 1U
                   : 0U;
    }
    return found == c.edges;
  });
}

// Every vertex and every edge is among those of the balls in their own order.
inline uint32_t same_bits_in_reverse() {
  return first_failing_scene([](const Scene &c) {
    hsp::Vec3 vertices[30];
    double angles[30], radii[30];
    for (const bool again : {false, true}) {
      if (!build(c, again)) return false;
      const hsp::Topology &topology = small_topology().topology();
      if (topology.vertex_count != c.cut.vertices || topology.quads.edges != c.cut.edges || c.cut.edges > 30)
        return false;
      for (uint32_t vertex = 0; vertex < c.cut.vertices; ++vertex) {
        const hsp::Vec3 at = point_of_vertex(small_topology(), vertex);
        if (!again) vertices[vertex] = at;
        bool found = !again;
        for (uint32_t k = 0; again && k < c.cut.vertices; ++k) {
          found = found || (vertices[k].x == at.x && vertices[k].y == at.y && vertices[k].z == at.z);
        }
        if (!found) return false;
      }
      for (uint32_t edge = 0; edge < c.cut.edges; ++edge) {
        const DrawnEdge drawn = drawn_edge(small_topology(), edge);
        if (!again) {
          angles[edge] = drawn.angle;
          radii[edge] = drawn.radius;
        }
        bool found = !again;
        for (uint32_t k = 0; again && k < c.cut.edges; ++k) {
          found = found || (angles[k] == drawn.angle && radii[k] == drawn.radius);
        }
        if (!found) return false;
      }
    }
    return true;
  });
}

inline constexpr Check topology_positions[] = {
    {"edges_are_arcs_between_their_vertices", edges_are_arcs_between_their_vertices},
    {"faces_lie_on_the_left", faces_lie_on_the_left},
    {"lower_ranks_are_the_frames", lower_ranks_are_the_frames},
    {"edges_in_closed_form", edges_in_closed_form},
    {"same_bits_in_reverse", same_bits_in_reverse}};

}  // namespace cases
