#include "poses/pose_queries.hpp"

#include <type_traits>
#include <utility>

#include "core/sorting.hpp"
#include "exact/power.hpp"
#include "model/meeting.hpp"

namespace hsp {
namespace {

// The stack of a walk: every step replaces a pair of nodes by two pairs, with the children of one of the nodes.
constexpr uint32_t most_waiting = 2 * SphereTree::largest_height + 2;

// Differences and sums are rounded before they are squared, too: at most as much again.
constexpr double error = 2 * meeting_doubt;

// Whether the walk goes on with the children of the node at rest. The larger sphere is opened, so that both shrink
// alike.
bool opens_fixed(const TreeNode &fixed, const TreeNode &moving) {
  return moving.is_leaf() || (!fixed.is_leaf() && fixed.radius > moving.radius);
}

// The positions of balls in a pose, and the decisions about them. In a snapped pose they are lattice points; in a
// rational one the place of a ball is known in doubles up to the slack.
template <class AnyPose>
class PosedBalls {
 public:
  PosedBalls(const SphereTree &fixed, const SphereTree &moving, const AnyPose &pose)
      : pose_(pose), slack_(pose.slack(fixed.reach() + moving.reach())) {}

  // The image of a centre of the moving molecule, of a ball or a node: at most slack() from its place.
  Vec3 image(const Vec3 &p) const { return pose_.image(p); }
  const Pose &rounded() const {
    if constexpr (are_snapped) {
      return pose_;
    } else {
      return pose_.rounded();
    }
  }
  double slack() const { return slack_; }
  // The place of a ball, from its image.
  Vec3 place(const Vec3 &image) const { return are_snapped ? snapped(image) : image; }

  // Whether a ball at rest about c and the moved ball about p meet. between: from c to the place of p.
  bool meet(const Vec3 &c, const Vec3 &p, const Vec3 &between, double sum) const {
    if constexpr (are_snapped) {
      return hsp::meet(between.x, between.y, between.z, sum);
    } else {
      const double square = dot(between, between);
      const double least = sum - slack_, most = sum + slack_;
      if (square > most * most * (1 + error)) return false;
      if (least > 0 && square < least * least * (1 - error)) return true;
      return pose_.meet_exactly(c, p, sum);
    }
  }
  double distance(const Vec3 &c, const Vec3 &p, const Vec3 &between) const {
    if constexpr (are_snapped) {
      return std::sqrt(dot(between, between));
    } else {
      return pose_.distance(c, p);
    }
  }

 private:
  static constexpr bool are_snapped = std::is_same_v<AnyPose, Pose>;

  const AnyPose &pose_;
  double slack_;
};

// Whether the root spheres are within a margin of each other. If so, begins the walk for pairs within the margin, with
// the pose relative to the centres of the roots. The margin is added to the slack of all positions.
template <class Balls>
bool start_walk(const SphereTree &fixed, const SphereTree &moving, const Balls &balls, double margin, FloatPose &floats,
                PairWalk &walk) {
  const TreeNode &a = fixed.node(0), &b = moving.node(0);
  const Vec3 between = balls.image(b.centre) - a.centre;
  const double sum = a.radius + b.radius + (balls.slack() + margin);
  if (dot(between, between) > sum * sum) return false;
  const auto store = [](const Vec3 &v, float *to) {
    to[0] = static_cast<float>(v.x);
    to[1] = static_cast<float>(v.y);
    to[2] = static_cast<float>(v.z);
  };
  for (uint32_t k = 0; k < 3; ++k) store(balls.rounded().row(k), floats.row[k]);
  store(between, floats.shift);
  // The slack of a position, that of the shift, the margin, and the rounding of all floats.
  floats.slack = static_cast<float>((2 * balls.slack() + margin) + 0x1p-19 * sum);
  SpherePair &roots = walk.pair[0];
  store(between, roots.moving);
  roots.moving[3] = static_cast<float>(b.radius) + floats.slack;
  roots.fixed_node = roots.moving_node = 0;
  roots.fixed_level = fixed.levels().top;
  roots.moving_level = moving.levels().top;
  walk.waiting = 1;
  return true;
}

uint32_t go_on(const SphereTree &fixed, const SphereTree &moving, const FloatPose &floats, PairWalk &walk) {
  return find_near_pairs(fixed.target(), fixed.levels(), moving.levels(), floats, walk);
}

// Calls visit(ball at rest, moving ball, vector between their centres) for all pairs that meet, until it returns true;
// returns whether it did. The order depends on the trees and the pose alone.
template <class Balls, class Visit>
bool visit_meeting_pairs(const SphereTree &fixed, const SphereTree &moving, const Balls &balls, Visit visit) {
  if (fixed.empty() || moving.empty()) return false;
  FloatPose floats;
  PairWalk walk;
  if (!start_walk(fixed, moving, balls, 0, floats, walk)) return false;
  while (const uint32_t found = go_on(fixed, moving, floats, walk)) {
    uint32_t placed = no_id;
    Vec3 position{};
    for (uint32_t k = 0; k < found; ++k) {
      const auto [i, j] = walk.found[k];
      if (j != placed) position = balls.place(balls.image(moving.centre(j)));
      placed = j;
      const Vec3 c = fixed.centre(i);
      const Vec3 between = position - c;
      if (balls.meet(c, moving.centre(j), between, fixed.radius(i) + moving.radius(j)) && visit(i, j, between))
        return true;
    }
  }
  return false;
}

template <class Balls>
bool still_meet(const SphereTree &fixed, const SphereTree &moving, const Balls &balls, const PairRanks &witness) {
  if (witness.fixed >= fixed.ball_count() || witness.moving >= moving.ball_count()) return false;
  const Vec3 c = fixed.centre(witness.fixed), p = moving.centre(witness.moving);
  return balls.meet(c, p, balls.place(balls.image(p)) - c, fixed.radius(witness.fixed) + moving.radius(witness.moving));
}

// Whether no ball of the molecule goes as far as the budget from a pose to this one. A ball goes as far as the centre
// of the root sphere does, plus at most the length of (R - S) y, with R and S the two rotations and y the vector from
// that centre to the ball's, |y| <= radius of the root. R S^T - 1 multiplies the length of every vector across the axis
// of R S^T by one factor, and maps the axis to 0: the factor is the root of half the sum of the squares of its entries.
// Each centre is within a slack, and each entry within 2^-50, of its exact value, and so is the sum.
template <class Balls>
bool stays_within(double budget, const SphereTree &moving, const Pose &from, const Balls &balls) {
  const TreeNode &root = moving.node(0);
  const Vec3 shift = balls.image(root.centre) - from.image(root.centre);
  double squares = 0;
  for (uint32_t k = 0; k < 3; ++k) {
    const Vec3 difference = balls.rounded().row(k) - from.row(k);
    squares += dot(difference, difference);
  }
  const double turned = (std::sqrt(0.5 * squares) + 0x1p-46) * root.radius;
  return (std::sqrt(dot(shift, shift)) + turned) * (1 + 0x1p-46) + 2 * balls.slack() < budget;
}

// d^2 - length^2 for the distance d of two centres, rounded once.
double square_beyond(const Vec3 &between, double length) {
  const exact::Vector v{static_cast<int64_t>(between.x), static_cast<int64_t>(between.y),
                        static_cast<int64_t>(between.z)};
  return exact::power(v, static_cast<int64_t>(length)).to_double();
}

// The intersection of two balls, from centre to centre, up to 1e-13 of itself. Where one hardly reaches into the other,
// or is far smaller, differences of lengths would cancel: there they come from squares.
double lens_volume(const Vec3 &between, double r, double s) {
  const double d = std::sqrt(dot(between, between));
  const double smaller = r < s ? r : s, sum = r + s, difference = std::fabs(r - s);
  if (d <= difference) return 4.0 / 3.0 * pi * (smaller * smaller * smaller);
  const double depth = sum - d, enough = 0x1p-7 * sum;
  if (depth > enough && smaller > enough)
    return pi / 12.0 * (depth * depth) * ((d * d + 2.0 * d * sum) - 3.0 * (difference * difference)) / d;
  const double certain_depth = -square_beyond(between, sum) / (sum + d);
  if (certain_depth <= 0) return 0;
  const double outside = square_beyond(between, difference) / (d + difference);
  return pi / 12.0 * (certain_depth * certain_depth) * (outside * (d + 3.0 * difference) + 4.0 * smaller * d) / d;
}

template <class Balls>
PairGap find_least_gap(const SphereTree &fixed, const SphereTree &moving, const Balls &balls, PairRanks &witness) {
  PairGap best;
  if (fixed.empty() || moving.empty()) return best;
  const double slack = balls.slack();
  const auto compare = [&](uint32_t i, uint32_t j, const Vec3 &between) {
    const Vec3 c = fixed.centre(i);
    const double sum = fixed.radius(i) + moving.radius(j);
    // A pair whose centres are farther apart than this cannot be better; the slack is more than all rounding.
    const double enough = best.gap + sum + (slack + 0x1p-46 * sum);
    if (enough < 0 || dot(between, between) > enough * enough) return;
    const PairGap found{balls.distance(c, moving.centre(j), between) - sum, fixed.caller(i), moving.caller(j)};
    const bool is_first = found.fixed != best.fixed ? found.fixed < best.fixed : found.moving < best.moving;
    if (found.gap > best.gap || (found.gap == best.gap && !is_first)) return;
    best = found;
    witness = {i, j};
  };
  if (witness.fixed < fixed.ball_count() && witness.moving < moving.ball_count())
    compare(witness.fixed, witness.moving,
            balls.place(balls.image(moving.centre(witness.moving))) - fixed.centre(witness.fixed));
  struct Task {
    double bound;  // a lower bound of all gaps below these nodes
    uint32_t fixed, moving;
    Vec3 image;  // of the centre of the moving node
  };
  const auto task_of = [&](uint32_t f, uint32_t m, const Vec3 &image) -> Task {
    const TreeNode &a = fixed.node(f);
    const Vec3 between = image - a.centre;
    return {std::sqrt(dot(between, between)) - (a.radius + moving.node(m).radius + slack), f, m, image};
  };
  Task tasks[most_waiting];
  uint32_t count = 0;
  tasks[count++] = task_of(0, 0, balls.image(moving.node(0).centre));
  while (count > 0) {
    const Task task = tasks[--count];
    if (task.bound > best.gap) continue;
    const TreeNode &a = fixed.node(task.fixed);
    const TreeNode &b = moving.node(task.moving);
    if (a.is_leaf() && b.is_leaf()) {
      for (uint32_t j = b.first; j < b.last; ++j) {
        const Vec3 image = balls.image(moving.centre(j));
        const Vec3 from_node = image - a.centre;
        const double enough = best.gap + (a.radius + moving.radius(j)) + slack;
        if (enough < 0 || dot(from_node, from_node) > enough * enough * (1 + error)) continue;
        const Vec3 position = balls.place(image);
        for (uint32_t i = a.first; i < a.last; ++i) compare(i, j, position - fixed.centre(i));
      }
      continue;
    }
    const bool by_fixed = opens_fixed(a, b);
    Task near = by_fixed ? task_of(task.fixed + 1, task.moving, task.image)
                         : task_of(task.fixed, task.moving + 1, balls.image(moving.node(task.moving + 1).centre));
    Task far = by_fixed ? task_of(a.second, task.moving, task.image)
                        : task_of(task.fixed, b.second, balls.image(moving.node(b.second).centre));
    if (far.bound < near.bound) std::swap(near, far);
    if (far.bound <= best.gap) tasks[count++] = far;
    if (near.bound <= best.gap) tasks[count++] = near;
  }
  return best;
}

}  // namespace

template <class AnyPose>
bool any_balls_meet(const SphereTree &fixed, const SphereTree &moving, const AnyPose &pose, PairRanks &witness) {
  const PosedBalls balls(fixed, moving, pose);
  return still_meet(fixed, moving, balls, witness) ||
         visit_meeting_pairs(fixed, moving, balls, [&](uint32_t i, uint32_t j, const Vec3 &) {
           witness = {i, j};
           return true;
         });
}

template <class AnyPose>
bool any_balls_meet(const SphereTree &fixed, const SphereTree &moving, const AnyPose &pose, GapBudget &known) {
  const PosedBalls balls(fixed, moving, pose);
  if (fixed.empty() || moving.empty() || stays_within(known.budget, moving, known.from, balls)) return false;
  if (still_meet(fixed, moving, balls, known.witness)) return true;
  const TreeNode &a = fixed.node(0), &b = moving.node(0);
  const double slack = balls.slack(), sum_of_roots = a.radius + b.radius;
  // A margin larger than both molecules would only lose precision of the floats.
  double gap = known.margin < sum_of_roots ? known.margin : sum_of_roots;
  FloatPose floats;
  PairWalk walk;
  if (start_walk(fixed, moving, balls, gap, floats, walk)) {
    while (const uint32_t found = go_on(fixed, moving, floats, walk)) {
      for (uint32_t k = 0; k < found; ++k) {
        const auto [i, j] = walk.found[k];
        const Vec3 c = fixed.centre(i), p = moving.centre(j);
        const Vec3 between = balls.place(balls.image(p)) - c;
        const double sum = fixed.radius(i) + moving.radius(j), square = dot(between, between);
        const double enough = sum + (gap + slack);
        if (square > enough * enough * (1 + error)) continue;
        if (balls.meet(c, p, between, sum)) {
          known.witness = {i, j};
          return true;
        }
        const double own = std::sqrt(square) - sum;
        gap = own < gap ? own : gap;
      }
    }
  } else {
    const Vec3 between = balls.image(b.centre) - a.centre;
    gap = std::sqrt(dot(between, between)) - sum_of_roots;
  }
  // The gap is one of rounded positions, and so are the lengths compared with the budget.
  known.from = balls.rounded();
  known.budget = gap - 4 * slack;
  return false;
}

template <class AnyPose>
uint64_t list_meeting_pairs(const SphereTree &fixed, const SphereTree &moving, const AnyPose &pose,
                            Span<MeetingPair> pairs) {
  uint64_t count = 0;
  visit_meeting_pairs(fixed, moving, PosedBalls(fixed, moving, pose), [&](uint32_t i, uint32_t j, const Vec3 &) {
    if (count < pairs.size()) pairs[static_cast<uint32_t>(count)] = {fixed.caller(i), moving.caller(j)};
    ++count;
    return false;
  });
  if (count <= pairs.size())
    sort_in_place(pairs.part(0, static_cast<uint32_t>(count)), [](const MeetingPair &a, const MeetingPair &b) {
      return a.fixed != b.fixed ? a.fixed < b.fixed : a.moving < b.moving;
    });
  return count;
}

Overlap sum_overlaps(const SphereTree &fixed, const SphereTree &moving, const Pose &pose) {
  Overlap sum;
  visit_meeting_pairs(fixed, moving, PosedBalls(fixed, moving, pose),
                      [&](uint32_t i, uint32_t j, const Vec3 &difference) {
                        ++sum.pairs;
                        sum.volume += lens_volume(difference, fixed.radius(i), moving.radius(j));
                        return false;
                      });
  return sum;
}

template <class AnyPose>
PairGap least_gap(const SphereTree &fixed, const SphereTree &moving, const AnyPose &pose, PairRanks &witness) {
  return find_least_gap(fixed, moving, PosedBalls(fixed, moving, pose), witness);
}

template bool any_balls_meet(const SphereTree &, const SphereTree &, const Pose &, PairRanks &);
template bool any_balls_meet(const SphereTree &, const SphereTree &, const RationalPose &, PairRanks &);
template bool any_balls_meet(const SphereTree &, const SphereTree &, const Pose &, GapBudget &);
template bool any_balls_meet(const SphereTree &, const SphereTree &, const RationalPose &, GapBudget &);
template uint64_t list_meeting_pairs(const SphereTree &, const SphereTree &, const Pose &, Span<MeetingPair>);
template uint64_t list_meeting_pairs(const SphereTree &, const SphereTree &, const RationalPose &, Span<MeetingPair>);
template PairGap least_gap(const SphereTree &, const SphereTree &, const Pose &, PairRanks &);
template PairGap least_gap(const SphereTree &, const SphereTree &, const RationalPose &, PairRanks &);

}  // namespace hsp
