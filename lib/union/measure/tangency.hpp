// Balls that touch another ball from inside. Such a ball counts as inside, so that the boundary holds nothing of the
// touching; but moved outward it would poke out.
//
// As an example a ball of radius 2 at (3,0,0) and one of radius 5 at 0: the first touches the second from inside, at
// (5,0,0). It has no face, but gets one if it moves along x, and none if it moves back: its derivatives are one-sided.
#pragma once

#include "boundary/boundary.hpp"
#include "exact/power.hpp"

namespace hsp {

// Which balls one ball touches from inside, in a point that lies inside no third ball; or is equal to.
//
// They all have that point in common: each ball that contains `inner` contains the point, but not in its interior, and
// so touches `inner` there. Hence third balls are looked at once for each ball, not for each two that touch.
class InnerTouch {
 public:
  InnerTouch(const BallSet &balls, const CubeBlock &block, uint32_t inner)
      : balls_(balls), block_(block), inner_(inner) {}

  // Whether the ball touches ball `outer` so.
  bool is_free_with(uint32_t outer);

 private:
  bool no_third_covers(const exact::LatticeBall &container, const exact::Vector &v, int64_t D) const;

  const BallSet &balls_;
  const CubeBlock &block_;
  uint32_t inner_;
  bool point_is_known_ = false, point_is_free_ = false;
};

// Whether a ball lies inside another one, for balls of which the boundary does not know it.
bool lies_inside_another(const CubeGrid &grid, uint32_t i);

// Calls visit(j) for every ball j that ball i touches so.
template <class Visit>
void visit_balls_touched_from_inside(const CubeGrid &grid, uint32_t i, Visit visit) {
  const BallSet &balls = grid.balls();
  const CubeBlock block = grid.block_around(grid.cube_at(balls.ball(i).centre));
  InnerTouch touch(balls, block, i);
  for (uint32_t k = 0; k < block.ranges; ++k) {
    for (uint32_t j = block.range[k].first; j < block.range[k].last; ++j) {
      if (j != i && touch.is_free_with(j)) visit(j);
    }
  }
}

// Calls visit(i, j) for every ball i inside others and every ball j that it touches freely from inside, if moving one
// of them would bare a part of it. Of equal balls at most one has faces; if it has none, moving another bares nothing.
// A ball that is left out counts as if it had faces.
template <class Visit>
void visit_free_inner_contacts(const CubeGrid &grid, const Boundary &boundary, Visit visit) {
  const BallSet &balls = grid.balls();
  for (uint32_t i = 0; i < balls.n; ++i) {
    bool is_inside = boundary.is_contained(i);
    if (!is_inside && !boundary.is_left_out(i)) continue;
    visit_balls_touched_from_inside(grid, i, [&](uint32_t j) {
      is_inside = is_inside || lies_inside_another(grid, i);
      if (!is_inside) return;
      if (balls.r[i] != balls.r[j] || boundary.is_exposed(j) || boundary.is_left_out(j)) visit(i, j);
    });
  }
}

// Sets a flag of both balls of each such pair. flags [n], in the caller's order.
inline void flag_free_inner_contacts(const CubeGrid &grid, const Boundary &boundary, uint32_t flag, uint32_t *flags) {
  const BallSet &balls = grid.balls();
  visit_free_inner_contacts(grid, boundary, [&](uint32_t inner, uint32_t outer) {
    flags[balls.caller[inner]] |= flag;
    flags[balls.caller[outer]] |= flag;
  });
}

}  // namespace hsp
