// Products of lattice vectors, and the ranks of planes against those of the balls behind them.
#pragma once

#include "cases.hpp"
#include "exact/lattice_ball.hpp"

namespace cases {

struct LatticeProduct {
  hsp::exact::Vector a, b;
  int64_t dot;
  hsp::exact::Vector cross;
};
constexpr LatticeProduct lattice_products[] = {
    {{1, 0, 0}, {0, 1, 0}, 0, {0, 0, 1}},
    {{2, 3, 5}, {7, 11, 13}, 112, {-16, 9, 1}},
    {{-1, 4, 2}, {-2, 8, 4}, 42, {0, 0, 0}},
    {{1073741824, 0, 1}, {0, 1073741824, -1}, -1, {-1073741824, 1073741824, 1152921504606846976}}};

inline uint32_t products_of_lattice_vectors() {
  return first_failing(lattice_products, [](const LatticeProduct &c) {
    const hsp::exact::Vector n = cross(c.a, c.b);
    return dot(c.a, c.b) == c.dot && n.x == c.cross.x && n.y == c.cross.y && n.z == c.cross.z &&
           is_zero(n) == (c.cross.x == 0 && c.cross.y == 0 && c.cross.z == 0) && !is_zero(c.a);
  });
}

// All pairs of these as seen from the first: the order of their planes is that of the balls.
constexpr hsp::exact::LatticeBall ranked_balls[] = {{{0, 0, 0}, 10, 5}, {{6, 0, 0}, 10, 0}, {{0, 6, 0}, 10, 1},
                                                    {{0, 0, 6}, 10, 2}, {{0, 0, 6}, 9, 3},  {{0, 0, 6}, 9, 4},
                                                    {{-6, 0, 0}, 8, 6}, {{0, -6, 1}, 7, 7}, {{0, -6, -1}, 7, 8}};

inline uint32_t planes_rank_as_their_balls() {
  return first_failing(ranked_balls, [](const hsp::exact::LatticeBall &a) {
    const hsp::exact::LatticeBall &origin = ranked_balls[0];
    const hsp::exact::Plane p = plane_of(origin, a);
    for (const hsp::exact::LatticeBall &b : ranked_balls) {
      if (ranks_before(p, plane_of(origin, b)) != ranks_before(a, b)) return false;
    }
    const hsp::exact::Plane none = hsp::exact::virtual_plane({-9, 0, 0}, 0);
    return ranks_before(p, none) && !ranks_before(none, p) &&
           ranks_before(p, origin_plane(sphere_of(origin))) == ranks_before(a, origin);
  });
}

inline constexpr Check exact_plane[] = {{"products_of_lattice_vectors", products_of_lattice_vectors},
                                        {"planes_rank_as_their_balls", planes_rank_as_their_balls}};

}  // namespace cases
