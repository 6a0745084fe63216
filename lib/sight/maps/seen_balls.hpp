// The balls that may be seen, in view coordinates, those with the highest tops first. Their ranks in this order are
// the ids of this room.
#pragma once

#include "core/workspace.hpp"
#include "view/covered_balls.hpp"
#include "view/occlusion.hpp"

namespace hsp {

struct SeenBall {
  double x, y, z, r;
  uint32_t ball;    // grid order
  uint32_t inside;  // 1 if it lies inside another ball, so that nothing of it is seen

  double top() const { return z + r; }
};

// Balls that reach less into or out of each other than this part of their radii only touch. The circle in which others
// meet is not lost in rounding.
inline constexpr double touching = 0x1p-40;

inline bool is_inside(const SeenBall &ball, const SeenBall &other) {
  const double dx = other.x - ball.x;
  const double dy = other.y - ball.y;
  const double dz = other.z - ball.z;
  const double room = other.r * (1.0 + touching) - ball.r;
  return room > 0.0 && dx * dx + dy * dy + dz * dz <= room * room;
}

// How far centres are moved where roundings cannot be overcome, of all radii, and in which of several ways.
struct Perturbation {
  double size;
  uint32_t way;
};
// One after the other. Where discs touch in one point and meet there, all moves in one way may leave a loop that is too
// small to tell what it shows: then others.
inline constexpr Perturbation perturbations[] = {{0.0, 0},     {0x1p-20, 0}, {0x1p-17, 0}, {0x1p-14, 0},
                                                 {0x1p-17, 1}, {0x1p-17, 2}, {0x1p-14, 3}};

// A centre in view coordinates, moved by at most the size times the ball's radius, in a way that depends on its centre
// and radius alone.
Vec3 moved_centre(const BallSet &balls, uint32_t i, const Vec3 &centre, const Perturbation &perturbation);

class SeenBalls {
 public:
  void carve(Workspace &workspace, uint32_t balls, uint32_t neighbours);

  // Leaves out what is hidden as a whole for certain; that is so for every perturbation afterwards.
  // False if that is stopped.
  bool choose(const CubeGrid &grid, const ViewFrame &frame, Patience &patience);
  // Places what is left and sorts it, every centre moved as above.
  void place(const BallSet &balls, const ViewFrame &frame, const Perturbation &perturbation, Patience &patience);

  Span<const SeenBall> balls() const { return balls_.part(0, count_); }
  Span<SeenBall> balls() { return balls_.part(0, count_); }
  // Whether ball a is the nearer one of two: by the depth of its centre, and by the order where these are equal.
  bool is_nearer(uint32_t a, uint32_t b) const {
    return balls_[a].z > balls_[b].z || (balls_[a].z == balls_[b].z && a < b);
  }
  // How many caps of a ball the next two look at together.
  void use_room(uint32_t caps) { covered_.use_room(caps); }
  // Whether others are known to cover the sphere of ball k. It is asked once, and such balls are left out for every
  // perturbation afterwards.
  bool is_covered(uint32_t k, Patience &patience);
  // Whether such balls were found after the balls were moved and placed: as a rule ones that lay inside others before.
  // They were left out near some balls and not near others, and may show where the move has uncovered them.
  bool some_are_late() const { return moved_ && some_are_late_; }
  // Asks that of those inside others, too, which would be the next ones.
  void ask_of_those_inside(Patience &patience);
  // Marks the balls that may have a crease with ball k, which is not covered. False if all may, and none is marked; so
  // it is where balls are moved, which may uncover creases.
  bool mark_creases(uint32_t k, Patience &patience);
  bool may_crease(uint32_t k) const { return creases_[balls_[k].ball] != 0; }
  void unmark_creases();

  // Whether everything in the box is hidden for certain up to a height. Only of balls that are not moved.
  bool hides(const BoundingBox &box, double height) { return !moved_ && hidden_.floor().is_above(box, height); }

 private:
  // In visible_, covered ones as hidden.
  static constexpr uint8_t hidden = 0, open = 1, uncovered = 2;

  OcclusionCuller hidden_;
  CoveredBalls covered_;
  Span<uint8_t> visible_;  // [balls]
  Span<uint8_t> creases_;  // [balls]
  Span<SeenBall> balls_;   // [balls]
  uint32_t count_ = 0;
  bool moved_ = false;
  bool some_are_late_ = false;
};

}  // namespace hsp
