// Balls that touch another ball from inside. Such a ball counts as inside, so that the boundary does not show that they
// touch; but if the ball moved outward it would poke out.
//
// As an example a ball of radius 2 at (3,0,0) and one of radius 5 at 0: the first touches the second from inside, at
// (5,0,0). It has no face, but gets one if it moves along x, and none if it moves back: its derivatives are one-sided.
#pragma once

#include "boundary/boundary.hpp"
#include "core/small_code.hpp"
#include "exact/power.hpp"

namespace hsp {

// A set of balls that has all balls that meet a given one: those of a block of cubes; or exactly these, if the grid has
// levels of radii and these are few. A block may be the whole set, if one ball is far larger than the rest.
class BallsThatMayMeet {
 public:
  explicit BallsThatMayMeet(const CubeBlock &block) : block_(block) {}
  [[gnu::cold]] BallsThatMayMeet(const CubeGrid &grid, uint32_t i);

  // Calls visit(j) for one ball after the other, in grid order, until it returns false. Returns whether it never did.
  template <class Visit>
  bool all_of(Visit visit) const {
    for (uint32_t r = 0; r < block_.ranges; ++r) {
      for (uint32_t k = block_.range[r].first; k < block_.range[r].last; ++k) {
        if (!visit(are_few_ ? few_[k] : k)) return false;
      }
    }
    return true;
  }

 private:
  static constexpr uint32_t most_few = small_code ? 1 : 128;
  CubeBlock block_;
  bool are_few_ = false;  // the balls are in few_, and the block's range is one of positions there
  uint32_t few_[most_few];
};

// Which balls a ball `inner` touches freely from inside: in a point that lies in the interior of no third ball. Equal
// balls count as touching freely.
//
// All balls that `inner` touches freely have that point in common: each ball that contains `inner` contains the point,
// but not in its interior, and so touches `inner` there. Hence third balls are looked at once for each ball `inner`,
// not for each pair that touches.
class InnerTouch {
 public:
  InnerTouch(const BallSet &balls, const BallsThatMayMeet &around, uint32_t inner)
      : balls_(balls), around_(around), inner_(inner) {}

  // Whether `inner` touches ball `outer` freely from inside, or is equal to it.
  bool is_free_with(uint32_t outer);

 private:
  [[gnu::cold, gnu::noinline]] bool no_third_covers(const exact::LatticeBall &container, const exact::Vector &v,
                                                    int64_t D) const;

  const BallSet &balls_;
  const BallsThatMayMeet &around_;
  uint32_t inner_;
  bool point_is_known_ = false, point_is_free_ = false;
};

// Whether a ball lies inside another one, for balls that the boundary leaves out.
bool lies_inside_another(const CubeGrid &grid, uint32_t i);

// Calls visit(j) for every ball j that ball i touches freely from inside.
template <class Visit>
void visit_balls_touched_from_inside(const CubeGrid &grid, uint32_t i, Visit visit) {
  const BallSet &balls = grid.balls();
  const BallsThatMayMeet around(grid, i);
  InnerTouch touch(balls, around, i);
  around.all_of([&](uint32_t j) {
    if (j != i && touch.is_free_with(j)) visit(j);
    return true;
  });
}

// Calls visit(i, j) for every ball i inside others and every ball j that it touches freely from inside, if moving one
// of the two would expose a part of it. Of equal balls at most one has faces; if it has none, moving another one
// exposes nothing. A ball that is left out counts as if it had faces.
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

// Sets a flag at both balls of each such pair. flags [n], in the caller's order.
void flag_free_inner_contacts(const CubeGrid &grid, const Boundary &boundary, uint32_t flag, uint32_t *flags);

}  // namespace hsp
