// Balls whose spheres other balls cover, which integers decide: nothing of them is seen. In sets of many overlaps, as
// models of one molecule are, most balls are covered, though few lie inside another one.
//
// All of them may be left out at once: where a line of sight first meets the union is a point of a sphere that no ball
// has inside, and that ball is not covered.
#pragma once

#include "model/cube_grid.hpp"
#include "sphere/exposed_caps.hpp"

namespace hsp {

class CoveredBalls {
 public:
  // Fewer near balls are dealt with as they are.
  static bool are_many(uint32_t balls) { return !small_code && balls >= ExposedCaps::fewest; }

  // Memory for so many caps of one ball. Of a ball that has more those are kept that may have a free part, again and
  // again; where these alone are nearly as many the answer is not certain.
  void carve(Workspace &workspace, uint32_t caps);
  void start(const CubeGrid &grid) {
    grid_ = &grid;
    use_room(caps_.capacity());
  }
  // Uses memory for so many caps, if there is so much: whether an answer is certain must not depend on how much there
  // happens to be.
  void use_room(uint32_t caps) { room_ = caps < caps_.capacity() ? caps : caps_.capacity(); }

  // Of a ball in grid order, its radius above 0. False if that is not certain.
  bool contains(uint32_t ball);
  // Of the last ball, which is not covered: calls visit(other) for all whose circles on its sphere may have a free
  // part. False, and no call, if that is not known.
  template <class Visit>
  bool visit_neighbours(Visit visit) const {
    if (!all_known_) return false;
    for (const uint32_t other : caps_.ball.part(0, caps_.count)) visit(other);
    return true;
  }

 private:
  bool keep_exposed(uint32_t ball, uint32_t count);

  const CubeGrid *grid_ = nullptr;
  Caps caps_;
  Span<uint32_t> order_;
  Span<uint8_t> state_;
  uint32_t room_ = 0;
  bool all_known_ = false;
};

}  // namespace hsp
