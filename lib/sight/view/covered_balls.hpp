// Finds balls whose spheres other balls cover, decided by integers: nothing of them is seen. In sets with many
// overlaps, as of several models of one molecule, most balls are covered, though few lie inside another one.
//
// All covered balls may be left out at once: a line of sight first meets the union at a point of a sphere that is
// inside no ball, and the ball of that sphere is not covered.
#pragma once

#include "model/cube_grid.hpp"
#include "sphere/exposed_caps.hpp"

namespace hsp {

class CoveredBalls {
 public:
  // Whether so many near balls are worth the search for covered ones.
  static bool are_many(uint32_t balls) { return !small_code && balls >= ExposedCaps::fewest; }

  // Takes memory for so many caps of one ball. If a ball has more, only caps that may have a free part are kept, each
  // time the memory is full. If these alone nearly fill it, the answer is not certain.
  void carve(Workspace &workspace, uint32_t caps);
  void start(const CubeGrid &grid) {
    grid_ = &grid;
    use_room(caps_.capacity());
  }
  // Uses memory for only so many caps, at most all: so whether an answer is certain does not depend on the limits.
  void use_room(uint32_t caps) { room_ = caps < caps_.capacity() ? caps : caps_.capacity(); }

  // Whether a ball in grid order, of a radius above 0, is covered. False if it is not certain.
  bool contains(uint32_t ball);
  // After contains(ball) was false: calls visit(other) for all balls whose circles on the sphere of `ball` may have a
  // free part. False, without a call, if these are not known.
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
