// The discs of the balls in the view plane, sorted by the squares that hold their centres. The list of a square is
// front to back, so that a search for balls that reach above a height stops early. Discs of nearly one size share a
// level, and the squares of a level have twice the radius of its largest disc as their side: a large disc does not
// widen the squares of small ones.
#pragma once

#include "core/fixed_vector.hpp"
#include "maps/seen_balls.hpp"
#include "model/ball_range.hpp"
#include "model/cube_table.hpp"

namespace hsp {

class DiscGrid {
 public:
  void carve(Workspace &workspace, uint32_t balls);

  void build(Span<const SeenBall> balls);
  // Marks the balls that lie inside others, or nearly: touching from inside counts. Of equal balls the first is not
  // inside. If patience ends not all are marked.
  void mark_inside(Span<SeenBall> balls, Patience &patience) const;

  // Finds the balls whose discs meet the disc of ball i and whose tops are above its centre, ascending; without i
  // itself and balls inside others.
  void gather(uint32_t i, FixedVector<uint32_t> &near) const;

  // The ball with the highest front at a point, `except` left out. Certain unless the point is close to the edge of a
  // disc that reaches as high, or the two highest fronts are close to each other.
  HighestBody highest_at(double x, double y, uint32_t except) const;

 private:
  // A level has discs of up to four times the radius of its smallest ones, but for the last level, which has the rest.
  static constexpr uint32_t most_levels = 12;
  struct Level {
    double largest = 0.0, per_length = 1.0;
    bool any = false;
  };

  uint32_t level_of(double r) const;
  CubeCoordinates square_at(double x, double y, uint32_t level) const;
  template <class Reach, class Visit>
  void visit_squares(double x, double y, Reach reach_to, Visit visit) const;

  Span<const SeenBall> balls_;
  CubeTable squares_;     // the third coordinate is the level
  Span<uint32_t> first_;  // [balls + 1]
  Span<uint32_t> item_;   // [balls]
  Level level_[most_levels];
  uint32_t levels_ = 0;
  double largest_ = 0.0;
};

}  // namespace hsp
