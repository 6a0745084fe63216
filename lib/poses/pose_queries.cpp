#include "poses/pose_queries.hpp"

#include "core/sorting.hpp"
#include "model/query_hits.hpp"

namespace hsp {
namespace {

// Every step of a walk replaces a pair of nodes by two pairs with children of the one or the other.
constexpr uint32_t most_waiting = 2 * SphereTree::largest_height + 2;

// Whether the walk goes on from the children of the node at rest: of the larger sphere, so that both shrink alike.
bool opens_fixed(const TreeNode &fixed, const TreeNode &moving) {
  return moving.is_leaf() || (!fixed.is_leaf() && fixed.radius > moving.radius);
}

// The snapped balls of a leaf of the moving molecule.
struct MovedLeaf {
  MovedLeaf(const SphereTree &moving, const TreeNode &leaf, const Pose &pose) : first(leaf.first), last(leaf.last) {
    for (uint32_t j = first; j < last; ++j) centre[j - first] = pose.snapped(moving.centre(j));
  }
  uint32_t first, last;
  Vec3 centre[SphereTree::leaf_size];
};

// Calls visit(ball at rest, moving ball, vector between their centres), in the order of the trees, for all pairs that
// meet, until it returns true: whether it did.
template <class Visit>
bool visit_meeting_pairs(const SphereTree &fixed, const SphereTree &moving, const Pose &pose, Visit visit) {
  if (fixed.empty() || moving.empty()) return false;
  const double slack = pose.slack(fixed.reach() + moving.reach());
  struct Task {
    uint32_t fixed, moving;
  };
  Task tasks[most_waiting];
  uint32_t count = 0;
  tasks[count++] = {0, 0};
  while (count > 0) {
    const Task task = tasks[--count];
    const TreeNode &a = fixed.node(task.fixed);
    const TreeNode &b = moving.node(task.moving);
    const Vec3 between = pose.image(b.centre) - a.centre;
    const double sum = a.radius + b.radius + slack;
    if (dot(between, between) > sum * sum) continue;
    if (a.is_leaf() && b.is_leaf()) {
      const MovedLeaf moved(moving, b, pose);
      for (uint32_t i = a.first; i < a.last; ++i)
        for (uint32_t j = moved.first; j < moved.last; ++j) {
          const Vec3 difference = moved.centre[j - moved.first] - fixed.centre(i);
          if (meet(difference.x, difference.y, difference.z, fixed.radius(i) + moving.radius(j)) &&
              visit(i, j, difference)) {
            return true;
          }
        }
    } else if (opens_fixed(a, b)) {
      tasks[count++] = {a.second, task.moving};
      tasks[count++] = {task.fixed + 1, task.moving};
    } else {
      tasks[count++] = {task.fixed, b.second};
      tasks[count++] = {task.fixed, task.moving + 1};
    }
  }
  return false;
}

// What two balls have in common, by the distance of their centres.
double lens_volume(double d, double r, double s) {
  const double smaller = r < s ? r : s;
  if (d <= std::fabs(r - s)) return 4.0 / 3.0 * pi * (smaller * smaller * smaller);
  const double depth = (r + s) - d;
  if (depth <= 0) return 0;
  const double difference = r - s;
  return pi / 12.0 * (depth * depth) * ((d * d + 2.0 * d * (r + s)) - 3.0 * (difference * difference)) / d;
}

}  // namespace

Status make_pose(const SphereTree &fixed, const SphereTree &moving, const double *quaternion, const double *translation,
                 Pose &pose) {
  if (fixed.lattice().step() != moving.lattice().step()) return Status::argument;
  const Status status = Pose::make(quaternion, translation, moving.lattice(), pose);
  if (status != Status::ok) return status;
  return pose.has_room_for(moving.reach()) ? Status::ok : Status::range;
}

bool any_balls_meet(const SphereTree &fixed, const SphereTree &moving, const Pose &pose) {
  return visit_meeting_pairs(fixed, moving, pose, [](uint32_t, uint32_t, const Vec3 &) { return true; });
}

uint64_t list_meeting_pairs(const SphereTree &fixed, const SphereTree &moving, const Pose &pose,
                            Span<MeetingPair> pairs) {
  uint64_t count = 0;
  visit_meeting_pairs(fixed, moving, pose, [&](uint32_t i, uint32_t j, const Vec3 &) {
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
  visit_meeting_pairs(fixed, moving, pose, [&](uint32_t i, uint32_t j, const Vec3 &difference) {
    ++sum.pairs;
    sum.volume += lens_volume(std::sqrt(dot(difference, difference)), fixed.radius(i), moving.radius(j));
    return false;
  });
  return sum;
}

PairGap least_gap(const SphereTree &fixed, const SphereTree &moving, const Pose &pose) {
  PairGap best;
  if (fixed.empty() || moving.empty()) return best;
  const double slack = pose.slack(fixed.reach() + moving.reach());
  struct Task {
    double bound;  // no gap below these nodes is less
    uint32_t fixed, moving;
  };
  const auto task_of = [&](uint32_t f, uint32_t m) -> Task {
    const TreeNode &a = fixed.node(f);
    const TreeNode &b = moving.node(m);
    const Vec3 between = pose.image(b.centre) - a.centre;
    return {std::sqrt(dot(between, between)) - (a.radius + b.radius + slack), f, m};
  };
  Task tasks[most_waiting];
  uint32_t count = 0;
  tasks[count++] = task_of(0, 0);
  while (count > 0) {
    const Task task = tasks[--count];
    if (task.bound > best.gap) continue;
    const TreeNode &a = fixed.node(task.fixed);
    const TreeNode &b = moving.node(task.moving);
    if (a.is_leaf() && b.is_leaf()) {
      const MovedLeaf moved(moving, b, pose);
      for (uint32_t i = a.first; i < a.last; ++i)
        for (uint32_t j = moved.first; j < moved.last; ++j) {
          const Vec3 difference = moved.centre[j - moved.first] - fixed.centre(i);
          const PairGap found{std::sqrt(dot(difference, difference)) - (fixed.radius(i) + moving.radius(j)),
                              fixed.caller(i), moving.caller(j)};
          const bool is_first = found.fixed != best.fixed ? found.fixed < best.fixed : found.moving < best.moving;
          if (found.gap < best.gap || (found.gap == best.gap && is_first)) best = found;
        }
      continue;
    }
    const bool by_fixed = opens_fixed(a, b);
    Task near = by_fixed ? task_of(task.fixed + 1, task.moving) : task_of(task.fixed, task.moving + 1);
    Task far = by_fixed ? task_of(a.second, task.moving) : task_of(task.fixed, b.second);
    if (far.bound < near.bound) {
      const Task swapped = near;
      near = far;
      far = swapped;
    }
    tasks[count++] = far;
    tasks[count++] = near;
  }
  return best;
}

}  // namespace hsp
