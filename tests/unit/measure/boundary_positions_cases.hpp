// Positions of vertices, arcs and circles: on their spheres, the same for every order of the balls, and the same from
// either side.
#pragma once

#include <cmath>

#include "measure/boundary_positions.hpp"
#include "small_union.hpp"

namespace cases {

// Three balls that meet in two points, and a fourth that cuts a whole circle out of the first.
constexpr SmallBall three_and_one[] = {{0, 0, 0, 1000}, {1000, 0, 0, 900}, {500, 800, 0, 800}, {-1500, 0, 0, 600}};

inline void vertex_coordinates(uint32_t vertex, double (&xyz)[3]) {
  const hsp::BallSet &balls = small_union().balls();
  hsp::to_coordinates(balls, hsp::position_of_vertex(balls, small_union().boundary(), vertex), xyz);
}

inline uint32_t vertices_lie_on_their_spheres() {
  if (!small_union().build(three_and_one, 4) || small_union().boundary().vertex_count() != 2) return 0;
  double xyz[2][3];
  for (uint32_t v = 0; v < 2; ++v) {
    vertex_coordinates(v, xyz[v]);
    for (const uint32_t ball : small_union().boundary().vertex(v).ball) {
      const SmallBall &own = three_and_one[small_union().balls().caller[ball]];
      const double dx = xyz[v][0] - own.x, dy = xyz[v][1] - own.y, dz = xyz[v][2] - own.z;
      if (!near(std::sqrt(dx * dx + dy * dy + dz * dz), own.r, 1e-9)) return 1 + v;
    }
  }
  return xyz[0][2] == -xyz[1][2] ? all_hold : 3;
}

// All that does not depend on ids, sorted.
struct PositionBits {
  static constexpr uint32_t all = 2 * 3 + 6 + 4;
  double value[all];
  uint32_t count = 0;
  bool holds = true;

  void insert(double added) {
    holds = holds && count < all;
    if (!holds) return;
    uint32_t k = count++;
    for (; k > 0 && value[k - 1] > added; --k) value[k] = value[k - 1];
    value[k] = added;
  }

  explicit PositionBits(const SmallBall (&balls)[4]) {
    holds = small_union().build(balls, 4);
    const hsp::Boundary &boundary = small_union().boundary();
    for (uint32_t v = 0; v < boundary.vertex_count(); ++v) {
      double xyz[3];
      vertex_coordinates(v, xyz);
      for (const double coordinate : xyz) insert(coordinate);
    }
    for (uint32_t e = 0; e < boundary.half_edge_count(); ++e) {
      const double angle = hsp::angle_of_arc(small_union().balls(), boundary, e);
      holds = holds && angle == hsp::angle_of_arc(small_union().balls(), boundary, boundary.twin(e));
      insert(angle);
    }
    for (uint32_t c = 0; c < boundary.circle_count(); ++c) {
      const uint32_t(&ball)[2] = boundary.circle(c).ball;
      const hsp::CirclePosition from[2] = {hsp::position_of_circle(small_union().balls(), ball[0], ball[1]),
                                           hsp::position_of_circle(small_union().balls(), ball[1], ball[0])};
      double centre[2][3];
      for (int side = 0; side < 2; ++side) {
        hsp::to_coordinates(small_union().balls(), from[side].centre, centre[side]);
      }
      holds = holds && from[0].radius == from[1].radius;
      insert(from[0].radius);
      for (int k = 0; k < 3; ++k) {
        holds = holds && centre[0][k] == centre[1][k];
        insert(centre[0][k]);
      }
    }
    holds = holds && count == all;
  }
};

// The same bits for all orders of the input, and angles that are those of the twins.
inline uint32_t same_bits_in_every_order() {
  const PositionBits expected(three_and_one);
  for (uint32_t order = 0; order < 24; ++order) {
    // The digits of the number say which of those left comes next.
    SmallBall left[] = {three_and_one[0], three_and_one[1], three_and_one[2], three_and_one[3]};
    SmallBall permuted[4];
    for (uint32_t k = 0, rest = order; k < 4; ++k) {
      const uint32_t chosen = rest % (4 - k);
      rest /= 4 - k;
      permuted[k] = left[chosen];
      left[chosen] = left[3 - k];
    }
    const PositionBits found(permuted);
    if (!expected.holds || !found.holds) return order;
    for (uint32_t k = 0; k < PositionBits::all; ++k) {
      if (found.value[k] != expected.value[k]) return order;
    }
  }
  return all_hold;
}

// Circles that lie across x, whose centre and radius are integers.
struct FromEitherSide {
  SmallBall ball[2];
  double x, radius;
};
constexpr FromEitherSide from_either_side[] = {{{{0, 0, 0, 500}, {600, 0, 0, 500}}, 300, 400},
                                               {{{0, 0, 0, 500}, {-600, 0, 0, 500}}, -300, 400},
                                               {{{0, 0, 0, 5}, {4, 0, 0, 3}}, 4, 3},
                                               {{{11, 0, 0, 13}, {-13, 0, 0, 13}}, -1, 5}};

inline uint32_t circles_from_either_side() {
  return first_failing(from_either_side, [](const FromEitherSide &c) {
    if (!small_union().build(c.ball, 2) || small_union().boundary().circle_count() != 1) return false;
    const hsp::CircleRecord &circle = small_union().boundary().circle(0);
    for (uint32_t side = 0; side < 2; ++side) {
      const hsp::CirclePosition position =
          hsp::position_of_circle(small_union().balls(), circle.ball[side], circle.ball[1 - side]);
      double centre[3];
      hsp::to_coordinates(small_union().balls(), position.centre, centre);
      const hsp::Span<double> x = small_union().balls().x;
      const double towards_other = x[circle.ball[1 - side]] > x[circle.ball[side]] ? 1 : -1;
      if (centre[0] != c.x || centre[1] != 0 || centre[2] != 0 || position.radius != c.radius) return false;
      if (position.axis.x != towards_other || position.axis.y != 0 || position.axis.z != 0) return false;
    }
    return true;
  });
}

inline constexpr Check measure_boundary_positions[] = {{"vertices_lie_on_their_spheres", vertices_lie_on_their_spheres},
                                                       {"same_bits_in_every_order", same_bits_in_every_order},
                                                       {"circles_from_either_side", circles_from_either_side}};

}  // namespace cases
