// The painter's order of Theorem 5.1: centres by their depth along the view, the farthest first. (The theorem says
// "decreasing z" with viewing direction -z; with the viewer at z = +infinity it is increasing z.) Exact: depths are
// products of integers, and equal ones go by the rank of the symbolic perturbation.
#pragma once

#include "core/patience.hpp"
#include "view/view_frame.hpp"

namespace hsp {

// Whether ball a comes before ball b.
bool is_farther(const BallSet &balls, const exact::Vector &direction, uint32_t a, uint32_t b);

struct DepthKey {
  double depth;  // along the direction, from the frame's origin, rounded
  uint32_t ball;
  uint32_t item;  // whatever goes with the ball
};

// Sets the depths of the keys and sorts them, farthest ball first. scratch: as many as keys.
void sort_by_depth(const BallSet &balls, const ViewFrame &frame, Span<DepthKey> keys, Span<uint32_t> scratch,
                   Patience &patience);

}  // namespace hsp
