// Small unions in class Boundary, of balls without a free part too: ids of one ball are consecutive, all parts of a
// ball know it, and the state of every ball is that found by hand.
#pragma once

#include <initializer_list>

#include "small_scenes.hpp"

namespace cases {

inline uint32_t states_of_balls() {
  return first_failing_scene([](const Scene &c) {
    if (!small_union().build(c.ball, c.n)) return false;
    const hsp::Boundary &boundary = small_union().boundary();
    const int64_t euler = static_cast<int64_t>(c.cut.vertices) - c.cut.edges + c.cut.faces();
    if (boundary.ball_count() != c.n || boundary.euler() != euler) return false;
    if (boundary.vertex_count() != c.vertices || boundary.circle_count() != c.circles) return false;
    for (uint32_t i = 0; i < c.n; ++i) {
      const uint32_t ball = small_union().grid().grid_index(i);
      const char state = c.states[i];
      const bool whole = state == 'w';
      if (boundary.is_contained(ball) != (state == 'c') || boundary.is_whole_sphere(ball) != whole ||
          boundary.is_free_of_caps(ball) != whole || boundary.is_exposed(ball) != (whole || state == 'e') ||
          boundary.loops(ball).empty() != (state != 'e') || (whole && boundary.faces(ball).size() != 1)) {
        return false;
      }
    }
    return true;
  });
}

// Ids run ball by ball, those of loops face by face, and lead back to the ball and the face.
inline uint32_t parts_know_their_ball() {
  return first_failing_scene([](const Scene &c) {
    if (!small_union().build(c.ball, c.n)) return false;
    const hsp::Boundary &boundary = small_union().boundary();
    uint32_t half_edges = 0, loops = 0, faces = 0, sides = 0, loops_by_face = 0;
    for (uint32_t ball = 0; ball < c.n; ++ball) {
      if (boundary.half_edges(ball).first != half_edges || boundary.loops(ball).first != loops ||
          boundary.faces(ball).first != faces) {
        return false;
      }
      half_edges += boundary.half_edges(ball).size();
      loops += boundary.loops(ball).size();
      faces += boundary.faces(ball).size();
      for (const uint32_t e : boundary.half_edges(ball)) {
        const hsp::LoopElement element = hsp::LoopElement::arc(e);
        if (boundary.ball_of(e) != ball || boundary.neighbour(element) != boundary.half_edge(e).circle ||
            boundary.loop_of(element) != boundary.half_edge(e).loop || boundary.face_of(element) != boundary.face_of(e))
          return false;
      }
      for (const hsp::ClosedHalfEdge e : boundary.circles(ball)) {
        const uint32_t loop = boundary.loop_of(e);
        const hsp::CircleRecord &circle = boundary.circle(e.circle());
        ++sides;
        if (boundary.ball_of(e) != ball || boundary.neighbour(e) == ball || circle.loop[e.side()] != loop ||
            boundary.neighbour(hsp::LoopElement::circle(e)) != boundary.neighbour(e) ||
            boundary.loop_start(loop) != hsp::LoopElement::circle(e) ||
            boundary.face(boundary.face_of_loop(loop)).ball != ball) {
          return false;
        }
      }
      for (const uint32_t face : boundary.faces(ball)) {
        if (boundary.face(face).ball != ball || boundary.loops_of_face(face).first != loops_by_face) return false;
        bool circles_begun = false;
        uint32_t last_start = 0;
        for (const uint32_t loop : boundary.loops_of_face(face)) {
          const hsp::LoopElement start = boundary.loop_start(loop);
          ++loops_by_face;
          if (boundary.face_of_loop(loop) != face || boundary.loop_of(start) != loop) return false;
          if (!start.is_circle() && (circles_begun || start.half_edge() < last_start)) return false;
          circles_begun = start.is_circle();
          if (!circles_begun) last_start = start.half_edge();
        }
      }
      if (loops_by_face != loops) return false;
    }
    return half_edges == boundary.half_edge_count() && loops == boundary.loop_count() &&
           faces == boundary.face_count() && sides == 2 * boundary.circle_count() &&
           2 * boundary.arc_count() == half_edges;
  });
}

// The three half-edges of a vertex start there, one on each of its balls; each ends on the same two spheres.
inline uint32_t vertices_start_half_edges() {
  return first_failing_scene([](const Scene &c) {
    if (!small_union().build(c.ball, c.n)) return false;
    const hsp::Boundary &boundary = small_union().boundary();
    for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
      for (uint32_t slot = 0; slot < 3; ++slot) {
        const uint32_t e = boundary.half_edge_at(v, slot);
        if (boundary.half_edge(e).vertex != v || boundary.ball_of(e) != boundary.vertex(v).ball[slot]) return false;
        const hsp::VertexRecord &end = boundary.vertex(boundary.end_vertex(e));
        for (const uint32_t ball : {boundary.ball_of(e), boundary.half_edge(e).circle}) {
          if (end.ball[end.slot_of(ball)] != ball) return false;
        }
      }
    }
    return true;
  });
}

inline uint32_t components_have_their_lowest_rank() {
  return first_failing_scene([](const Scene &c) {
    if (!small_union().build(c.ball, c.n)) return false;
    const hsp::Boundary &boundary = small_union().boundary();
    const hsp::CubeGrid &grid = small_union().grid();
    for (uint32_t i = 0; i < c.n; ++i) {
      uint32_t lowest = i;
      for (uint32_t j = 0; j < c.n; ++j) {
        if (boundary.component(grid.grid_index(i)) != boundary.component(grid.grid_index(j))) continue;
        const SmallBall &a = c.ball[j], &b = c.ball[lowest];
        const int32_t difference[] = {a.x - b.x, a.y - b.y, a.z - b.z, a.r - b.r, j < lowest ? -1 : 1};
        uint32_t first = 0;
        while (difference[first] == 0) ++first;
        if (difference[first] < 0) lowest = j;
      }
      if (boundary.component_origin(grid.grid_index(i)) != grid.grid_index(lowest)) return false;
    }
    return true;
  });
}

inline uint32_t elements_are_told_apart() {
  using hsp::ClosedHalfEdge, hsp::LoopElement;
  const LoopElement arc = LoopElement::arc(7), circle = LoopElement::circle(ClosedHalfEdge(3, 1));
  const bool conditions[] = {
      ClosedHalfEdge(3, 1).circle() == 3, ClosedHalfEdge(3, 1).side() == 1,
      ClosedHalfEdge::from_id(ClosedHalfEdge(5, 0).id()).circle() == 5,
      ClosedHalfEdge::from_id(ClosedHalfEdge(5, 0).id()).side() == 0, !arc.is_circle(), arc.half_edge() == 7,
      circle.is_circle(), circle.closed_half_edge().circle() == 3, circle.closed_half_edge().side() == 1, arc != circle,
      circle == LoopElement::circle(ClosedHalfEdge(3, 1)), circle != LoopElement::circle(ClosedHalfEdge(3, 0)),
      // The largest of either kind.
      !LoopElement::arc(3 * hsp::max_count).is_circle(),
      LoopElement::circle(ClosedHalfEdge(hsp::max_count, 1)).closed_half_edge().circle() == hsp::max_count};
  return first_false(conditions);
}

// Status::range as soon as a limit would be larger than max_count, and nothing is stored then.
inline uint32_t default_limits_of_boundaries() {
  constexpr uint32_t most = (hsp::max_count - 64) / 8;
  hsp::BoundaryLimits none, few, many, all;
  const bool fits = default_limits(0, none) == hsp::Status::ok && default_limits(255, few) == hsp::Status::ok &&
                    default_limits(1000, many) == hsp::Status::ok && default_limits(most, all) == hsp::Status::ok;
  const bool conditions[] = {fits,
                             none.balls == 0 && none.neighbours == 0 && none.vertices == 64 && none.circles == 16,
                             few.balls == 255 && few.neighbours == 255,
                             many.balls == 1000 && many.neighbours == 256,
                             many.vertices == 8064 && many.circles == 2016,
                             all.vertices <= hsp::max_count && all.vertices + 8 > hsp::max_count,
                             all.circles <= hsp::max_count,
                             default_limits(most + 1, many) == hsp::Status::range,
                             default_limits(UINT32_MAX, many) == hsp::Status::range,
                             many.balls == 1000 && many.vertices == 8064};
  return first_false(conditions);
}

inline constexpr Check boundary_boundary[] = {{"states_of_balls", states_of_balls},
                                              {"parts_know_their_ball", parts_know_their_ball},
                                              {"vertices_start_half_edges", vertices_start_half_edges},
                                              {"components_have_their_lowest_rank", components_have_their_lowest_rank},
                                              {"elements_are_told_apart", elements_are_told_apart},
                                              {"default_limits_of_boundaries", default_limits_of_boundaries}};

}  // namespace cases
