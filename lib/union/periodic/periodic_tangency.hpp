// Balls in a periodic box that touch others from inside, of which the boundary holds nothing.
#pragma once

#include "measure/tangency.hpp"
#include "periodic/periodic_union.hpp"

namespace hsp {

// Calls visit(i, j) for every ball i of the input inside others and every ball j that it, or an image of it, touches
// freely from inside, if moving one of them would bare a part of it. All that is seen of a ball is seen of its images.
template <class Visit>
void for_each_inner_tangency_in_box(const PeriodicUnion &periodic, Visit visit) {
  const BallSet &balls = periodic.balls();
  const PeriodicImages &images = periodic.images();
  for (uint32_t inner = 0; inner < images.balls(); ++inner) {
    if (!periodic.boundary().is_contained(inner)) continue;
    visit_balls_touched_from_inside(periodic.grid(), inner, [&](uint32_t outer) {
      if (balls.r[inner] == balls.r[outer] && !periodic.is_exposed(outer)) return;
      visit(images.ball_of(balls.caller[inner]), images.ball_of(balls.caller[outer]));
    });
  }
}

// Sets a flag of both balls of each such pair. flags [n].
inline void flag_free_inner_contacts_in_box(const PeriodicUnion &periodic, uint32_t flag, uint32_t *flags) {
  for_each_inner_tangency_in_box(periodic, [&](uint32_t inner, uint32_t outer) {
    flags[inner] |= flag;
    flags[outer] |= flag;
  });
}

}  // namespace hsp
