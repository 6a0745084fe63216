// The balls that may be seen, in view coordinates, with the highest tops first. In this room the id of a ball is its
// rank in this order.
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
  // The square of the height of its sphere over its centre at a point of the view plane; negative beside its disc.
  double squared_height(double at_x, double at_y) const {
    const double dx = at_x - x;
    const double dy = at_y - y;
    return r * r - dx * dx - dy * dy;
  }
};

// The body with the highest front at a point, no_id if there is none; and whether that is certain.
struct HighestBody {
  uint32_t body;
  bool certain;
};

// Balls that reach into or out of each other by less than this fraction of their radii only touch. The circle in which
// other balls meet is not lost in rounding.
inline constexpr double touching = 0x1p-40;

inline bool is_inside(const SeenBall &ball, const SeenBall &other) {
  const double dx = other.x - ball.x;
  const double dy = other.y - ball.y;
  const double dz = other.z - ball.z;
  const double room = other.r * (1.0 + touching) - ball.r;
  return room > 0.0 && dx * dx + dy * dy + dz * dz <= room * room;
}

// A move of all centres, made when rounding has spoiled a map: by at most `size` times each ball's radius, in one of
// several ways.
struct Perturbation {
  double size;
  uint32_t way;
};
// The moves, tried one after another. If discs touch in one point and meet there, all moves in one way may leave a loop
// that is too small to find its owner: other ways follow.
inline constexpr Perturbation perturbations[] = {{0.0, 0},     {0x1p-20, 0}, {0x1p-17, 0}, {0x1p-14, 0},
                                                 {0x1p-17, 1}, {0x1p-17, 2}, {0x1p-14, 3}};

// A centre in view coordinates, moved. The move depends on the ball's centre and radius alone.
Vec3 moved_centre(const BallSet &balls, uint32_t i, const Vec3 &centre, const Perturbation &perturbation);

class SeenBalls {
 public:
  void carve(Workspace &workspace, uint32_t balls, uint32_t neighbours);

  // Leaves out the balls that are certainly hidden as a whole, for every perturbation afterwards. False if patience
  // ends.
  bool choose(const CubeGrid &grid, const ViewFrame &frame, Patience &patience);
  // Places and sorts the balls that are left, every centre moved by the perturbation.
  void place(const BallSet &balls, const ViewFrame &frame, const Perturbation &perturbation, Patience &patience);

  Span<const SeenBall> balls() const { return balls_.part(0, count_); }
  Span<SeenBall> balls() { return balls_.part(0, count_); }
  // Whether ball a is nearer than ball b: its centre is higher, or equally high and a is before b.
  bool is_nearer(uint32_t a, uint32_t b) const {
    return balls_[a].z > balls_[b].z || (balls_[a].z == balls_[b].z && a < b);
  }
  // How many caps of a ball is_covered() and mark_creases() look at together.
  void use_room(uint32_t caps) { covered_.use_room(caps); }
  // Whether others are known to cover the sphere of ball k. The question is decided once, and covered balls are left
  // out for every perturbation afterwards.
  bool is_covered(uint32_t k, Patience &patience);
  // Whether covered balls were found after the balls were moved and placed; as a rule they lay inside others before.
  // Some balls were looked at with them and others without, and the move may have uncovered them.
  bool some_are_late() const { return moved_ && some_are_late_; }
  // Asks of the balls that lie inside others, too, whether they are covered: they would be the next late ones.
  void ask_of_those_inside(Patience &patience);
  // Marks the balls that may have a crease with ball k, which is not covered. False, with none marked, if all balls may
  // have one; always so when balls are moved, as a move may uncover creases.
  bool mark_creases(uint32_t k, Patience &patience);
  bool may_crease(uint32_t k) const { return creases_[balls_[k].ball] != 0; }
  void unmark_creases();

  // Whether everything in a box of the view plane is certainly hidden up to a height. False if balls are moved.
  bool hides(const BoundingBox &box, double height) { return !moved_ && hidden_.floor().is_above(box, height); }

 private:
  // Values in visible_. hidden: hidden as a whole, or covered; open: not asked whether covered; uncovered: asked, it is
  // not.
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
