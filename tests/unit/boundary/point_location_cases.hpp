// On which arc of a circle a point lies, by the azimuths at which other balls cut it; and in which face the highest
// point of a ball and the points of vertical lines lie, for a ring of caps around any of the six directions.
#pragma once

#include <initializer_list>

#include "boundary/point_location.hpp"
#include "small_union.hpp"

namespace cases {

// A ball of radius 7 at the origin and the circle of a ball of radius 7 at (0, 0, 6): 3 high and sqrt(40) wide. A ball
// of radius 6 at distance 10 across z covers 26.7 degrees of it to either side.
enum Compass : uint32_t { east, north, west, south };
constexpr SmallBall cutting[] = {{10, 0, 0, 6}, {0, 10, 0, 6}, {-10, 0, 0, 6}, {0, -10, 0, 6}};

struct Located {
  uint32_t cut_by;       // bits of the balls that are there
  hsp::exact::Vector v;  // the other circle lies in the plane v.x = h / 2
  int64_t h;
  int sign;
  Compass start, end;  // the arc runs clockwise, if there is a ball at all
};
constexpr Located located[] = {
    // Through the axis, at the azimuth of (y, -x), which is v x z, and at the opposite one.
    {15, {-1, 1, 0}, 0, +1, north, east},
    {15, {-1, 1, 0}, 0, -1, south, west},
    {15, {-3, 2, 0}, 0, +1, north, east},
    {15, {1, 1, 0}, 0, +1, east, south},
    {15, {1, 1, 0}, 0, -1, west, north},
    // At x = 4 or x = -4: 51 or 129 degrees to either side.
    {15, {1, 0, 0}, 8, +1, east, south},
    {15, {1, 0, 0}, 8, -1, north, east},
    {15, {1, 0, 0}, -8, +1, south, west},
    {15, {1, 0, 0}, -8, -1, west, north},
    {15, {-1, 0, 0}, 8, +1, west, north},
    // Long arcs, which hold both points or one.
    {3, {-1, 1, 0}, 0, +1, north, east},
    {3, {-1, 1, 0}, 0, -1, east, north},
    {3, {1, 0, 0}, -8, +1, east, north},
    {3, {1, 0, 0}, -8, -1, east, north},
    {5, {-1, 0, 0}, 0, +1, west, east},
    {5, {-1, 0, 0}, 0, -1, east, west},
    {7, {0, 1, 0}, -8, -1, east, west},
    {7, {0, 1, 0}, -8, +1, east, west},
    {1, {-1, 0, 0}, 0, +1, east, east},
    {1, {-1, 0, 0}, 0, -1, east, east},
    // A free circle.
    {0, {-1, 0, 0}, 0, +1, east, east},
    {0, {1, 0, 0}, 8, -1, east, east}};

inline uint32_t points_on_a_circle() {
  return first_failing(located, [](const Located &c) {
    for (const bool reversed : {false, true}) {
      SmallBall balls[6];
      uint32_t number[6], n = 0;  // of own, the other, and those of the compass
      const auto put = [&](const SmallBall &ball, uint32_t which) {
        number[which] = n;
        balls[n++] = ball;
      };
      if (!reversed) put({0, 0, 0, 7}, 0);
      for (uint32_t k = 0; k < 4; ++k) {
        if ((c.cut_by >> k & 1U) != 0) put(cutting[k], 2 + k);
      }
      put({0, 0, 6, 7}, 1);
      if (reversed) put({0, 0, 0, 7}, 0);
      if (!small_union().build(balls, n)) return false;
      const auto id = [&](uint32_t which) { return small_union().grid().grid_index(number[which]); };
      const hsp::Caps &caps = small_union().gathered(number[0]).caps;
      const hsp::Boundary &boundary = small_union().boundary();
      const hsp::LoopElement found = hsp::locate_on_boundary(caps, caps.predicates(), boundary, caps.cap_of(id(1)),
                                                             hsp::exact::virtual_plane(c.v, c.h), c.sign);
      if (found.is_circle() != (c.cut_by == 0) || boundary.neighbour(found) != id(1)) return false;
      if (found.is_circle()) {
        if (boundary.ball_of(found.closed_half_edge()) != id(0)) return false;
        continue;
      }
      const hsp::HalfEdge &half_edge = boundary.half_edge(found.half_edge());
      if (boundary.ball_of(found.half_edge()) != id(0) ||
          boundary.previous_circle(id(0), half_edge) != id(2 + c.start) ||
          boundary.half_edge(half_edge.next).circle != id(2 + c.end)) {
        return false;
      }
    }
    return true;
  });
}

// A sphere of radius 1000 and six caps, 17 degrees wide, 30 degrees from an axis: a hole with one loop. The face around
// the ring has another loop, about a small ball on the far side.
constexpr SmallBall ringed[] = {{0, 0, 0, 1000},       {489, 104, 866, 296},   {155, 476, 866, 296},
                                {-335, 372, 866, 296}, {-489, -104, 866, 296}, {-155, -476, 866, 296},
                                {335, -372, 866, 296}, {600, 0, -800, 150}};

// The axis is x, y, z by `axis` 0, 1, 2, or the opposite one.
struct RingPosition {
  uint32_t axis;
  int32_t sign;
};
constexpr RingPosition ring_positions[] = {{2, 1}, {2, -1}, {0, 1}, {0, -1}, {1, 1}, {1, -1}};

inline void turn_ring(const RingPosition &position, SmallBall (&balls)[8]) {
  for (uint32_t k = 0; k < 8; ++k) {
    const int32_t from[3] = {ringed[k].x, ringed[k].y, position.sign * ringed[k].z};
    int32_t to[3];
    for (uint32_t axis = 0; axis < 3; ++axis) to[(axis + position.axis + 1) % 3] = from[axis];
    balls[k] = {to[0], to[1], to[2], ringed[k].r};
  }
}

inline uint32_t faces_of_highest_points() {
  return first_failing(ring_positions, [](const RingPosition &position) {
    SmallBall balls[8];
    turn_ring(position, balls);
    if (!small_union().build(balls, 8)) return false;
    const hsp::Boundary &boundary = small_union().boundary();
    const uint32_t own = small_union().grid().grid_index(0);
    const uint32_t face = hsp::face_of_top(small_union().balls(), boundary, own);
    const bool in_hole = position.axis == 2 && position.sign > 0;
    return boundary.faces(own).size() == 2 && boundary.face(face).ball == own &&
           boundary.loops_of_face(face).size() == (in_hole ? 1U : 2U);
  });
}

// Lines every 35 steps. The circle 30 degrees from the axis is covered, so a free point is in the
// hole if it is nearer to the axis.
inline uint32_t faces_that_vertical_lines_enter() {
  return first_failing(ring_positions, [](const RingPosition &position) {
    SmallBall balls[8];
    turn_ring(position, balls);
    if (!small_union().build(balls, 8)) return false;
    const hsp::Boundary &boundary = small_union().boundary();
    const uint32_t own = small_union().grid().grid_index(0);
    uint32_t in_holes = 0, outside = 0;
    for (int32_t x = -980; x <= 980; x += 35) {
      for (int32_t y = -980; y <= 980; y += 35) {
        const double square = 1e6 - x * x - y * y;
        if (square < 0.0) continue;
        const double p[3] = {static_cast<double>(x), static_cast<double>(y), -std::sqrt(square)};
        bool is_free = true;
        for (uint32_t k = 1; k < 8; ++k) {
          const double dx = p[0] - balls[k].x, dy = p[1] - balls[k].y, dz = p[2] - balls[k].z;
          is_free = is_free && std::sqrt(dx * dx + dy * dy + dz * dz) > balls[k].r + 1e-6;
        }
        if (!is_free) continue;
        const bool in_hole = position.sign * p[position.axis] > 866.0;
        ++(in_hole ? in_holes : outside);
        const uint32_t face = hsp::face_of_entry(small_union().balls(), boundary, own, x, y);
        if (boundary.face(face).ball != own || boundary.loops_of_face(face).size() != (in_hole ? 1U : 2U)) return false;
      }
    }
    return outside > 500 && (in_holes > 10) == (position.axis != 2 || position.sign < 0);
  });
}

// A ball with one face needs no question: the point need not even be free.
inline uint32_t only_faces() {
  const SmallBall balls[] = {{5, 5, 5, 10}, {12, 5, 5, 10}, {100, 0, 0, 10}};
  if (!small_union().build(balls, 3)) return 0;
  const hsp::Boundary &boundary = small_union().boundary();
  const hsp::CubeGrid &grid = small_union().grid();
  for (uint32_t i = 0; i < 3; ++i) {
    const uint32_t ball = grid.grid_index(i);
    if (hsp::face_of_top(small_union().balls(), boundary, ball) != boundary.faces(ball).first) return 1;
    if (hsp::face_of_entry(small_union().balls(), boundary, ball, balls[i].x, 3) != boundary.faces(ball).first)
      return 2;
  }
  return all_hold;
}

inline constexpr Check boundary_point_location[] = {
    {"points_on_a_circle", points_on_a_circle},
    {"faces_of_highest_points", faces_of_highest_points},
    {"faces_that_vertical_lines_enter", faces_that_vertical_lines_enter},
    {"only_faces", only_faces}};

}  // namespace cases
