#include "poses/sphere_tree.hpp"

#include "core/sorting.hpp"

namespace hsp {
namespace {

double along(const BallSet &balls, int axis, uint32_t i) {
  return axis == 0 ? balls.x[i] : axis == 1 ? balls.y[i] : balls.z[i];
}

Vec3 centre_of(const BallSet &balls, uint32_t i) {
  return {balls.x[i], balls.y[i], balls.z[i]};
}

double length(const Vec3 &v) {
  return std::sqrt(dot(v, v));
}

// The levels for so many balls, without the spheres.
SphereLevels shape_of_levels(uint32_t balls) {
  SphereLevels levels{};
  uint32_t spheres = balls;
  do {
    const uint32_t blocks = (spheres + 7) / 8;
    levels.first[levels.top + 1] = levels.first[levels.top] + blocks;
    ++levels.top;
    spheres = blocks;
  } while (spheres > 1);
  return levels;
}

// The first ball of the second child, for a node with more balls than a leaf. Groups of the largest possible size of 4,
// 8, 64, 512, .. stay together; the first child has as many groups as the second one, or one more.
uint32_t second_part_of(uint32_t first, uint32_t last) {
  const uint32_t balls = last - first;
  uint32_t group = SphereTree::leaf_size;
  for (uint32_t larger = 8; larger < balls; larger *= 8) group = larger;
  const uint32_t groups = (balls + group - 1) / group;
  return first + (groups + 1) / 2 * group;
}

}  // namespace

void SphereTree::carve(Workspace &workspace, uint32_t balls) {
  // All leaves but the last one are full.
  const uint32_t leaves = (balls + leaf_size - 1) / leaf_size;
  nodes_ = FixedVector<TreeNode>(workspace.take<TreeNode>(2 * leaves));
  const SphereLevels shape = shape_of_levels(balls);
  blocks_ = workspace.take<SphereBlock>(shape.first[shape.top] + 1);
  target_ = workspace.target();
  workspace.take_each(balls, x_, y_, z_, r_, caller_);
  for (Span<uint32_t> &each : along_) each = workspace.take<uint32_t>(balls);
  waiting_ = workspace.take<uint32_t>(balls);
  in_second_ = workspace.take<uint8_t>(balls);
  clear();
}

Status SphereTree::build(const BallSet &balls, Patience patience) {
  clear();
  lattice_ = balls.lattice;
  reach_ = 0;
  if (balls.n > x_.size()) return Status::capacity;
  if (balls.n == 0) return Status::ok;
  sort_axes(balls, patience);
  if (!patience.allows(10 * uint64_t{balls.n})) return Status::stopped;
  start_levels(balls.n);
  struct Task {
    uint32_t first, last;
    uint32_t parent;  // the node whose second child this is, or no_id
  };
  Task tasks[largest_height + 1];
  uint32_t count = 0;
  tasks[count++] = {0, balls.n, no_id};
  while (count > 0) {
    const Task task = tasks[--count];
    const uint32_t k = nodes_.size();
    if (task.parent != no_id) nodes_[task.parent].second = k;
    nodes_.push(node_around(balls, task.first, task.last, patience));
    store_node(nodes_[k]);
    if (task.last - task.first <= leaf_size) continue;
    const uint32_t middle = second_part_of(task.first, task.last);
    split(balls, task.first, middle, task.last);
    if (!patience.allows(50 * uint64_t{task.last - task.first})) return Status::stopped;
    tasks[count++] = {middle, task.last, k};
    tasks[count++] = {task.first, middle, no_id};
  }
  for (uint32_t p = 0; p < balls.n; ++p) {
    if (!patience.allows(100)) return Status::stopped;
    const uint32_t i = along_[0][p];
    x_[p] = balls.x[i];
    y_[p] = balls.y[i];
    z_[p] = balls.z[i];
    r_[p] = balls.r[i];
    caller_[p] = balls.caller[i];
    const double reach = length(centre(p));
    if (reach > reach_) reach_ = reach;
    store_sphere(0, p, centre(p), r_[p]);
  }
  // Centres of nodes are convex combinations of centres.
  reach_ = reach_ * (1 + 0x1p-48) + 1;
  return Status::ok;
}

// Fills all slots of the blocks with spheres that are far from all others.
void SphereTree::start_levels(uint32_t balls) {
  levels_ = shape_of_levels(balls);
  levels_.blocks = blocks_.data();
  constexpr float far = 0x1p60F;
  for (SphereBlock &block : blocks_.part(0, levels_.first[levels_.top] + 1)) {
    for (uint32_t lane = 0; lane < 8; ++lane) {
      block.x[lane] = far;
      block.y[lane] = block.z[lane] = block.r[lane] = 0;
    }
  }
}

// Stores a node as sphere of all levels on which its balls have one.
void SphereTree::store_node(const TreeNode &node) {
  const uint32_t balls = nodes_[0].last;
  uint64_t size = 8;
  for (uint32_t level = 1; level <= levels_.top && node.first % size == 0; ++level, size *= 8) {
    const uint64_t count = node.last - node.first;
    if (count == size || (node.last == balls && count < size))
      store_sphere(level, static_cast<uint32_t>(node.first / size), node.centre, node.radius);
  }
}

void SphereTree::store_sphere(uint32_t level, uint32_t k, const Vec3 &centre, double radius) {
  const Vec3 from_root = centre - nodes_[0].centre;
  SphereBlock &block = blocks_[levels_.first[level] + k / 8];
  block.x[k % 8] = static_cast<float>(from_root.x);
  block.y[k % 8] = static_cast<float>(from_root.y);
  block.z[k % 8] = static_cast<float>(from_root.z);
  block.r[k % 8] = static_cast<float>(radius);
}

void SphereTree::sort_axes(const BallSet &balls, Patience &patience) {
  for (int axis = 0; axis < 3; ++axis) {
    const Span<uint32_t> order = along_[axis].part(0, balls.n);
    for (uint32_t i = 0; i < balls.n; ++i) order[i] = i;
    const auto comes_first = [&](uint32_t i, uint32_t j) {
      const double a = along(balls, axis, i);
      const double b = along(balls, axis, j);
      return a != b ? a < b : i < j;  // the grid's order, which depends on the balls alone
    };
    if (!patience.may_end()) {
      sort_in_place(order, comes_first);
    } else {
      sort_in_place(order, [&](uint32_t i, uint32_t j) { return patience.allows(40) && comes_first(i, j); });
    }
  }
}

// A node whose sphere is nearly as small as possible: its centre goes from the middle of the box in some steps, ever
// smaller ones, towards the ball that sticks out most (Badoiu and Clarkson 2003).
TreeNode SphereTree::node_around(const BallSet &balls, uint32_t first, uint32_t last, Patience &patience) const {
  const auto middle_of = [&](int axis) {
    return (along(balls, axis, along_[axis][first]) + along(balls, axis, along_[axis][last - 1])) / 2;
  };
  Vec3 centre{middle_of(0), middle_of(1), middle_of(2)};
  const auto farthest = [&](double &distance) {
    uint32_t found = no_id;
    for (uint32_t p = first; p < last; ++p) {
      const uint32_t i = along_[0][p];
      const double d = length(centre_of(balls, i) - centre) + balls.r[i];
      if (found == no_id || d > distance) {
        distance = d;
        found = i;
      }
    }
    return found;
  };
  constexpr int steps = 16;
  double radius = 0;
  for (int k = 0; k < steps && last - first > 1 && patience.allows(30 * uint64_t{last - first}); ++k) {
    const uint32_t i = farthest(radius);
    centre = centre + (0.5 / (k + 2)) * (centre_of(balls, i) - centre);
  }
  farthest(radius);
  return {centre, radius * (1 + 0x1p-48) + 1, first, last, 0};
}

// Splits the balls [first, last) along the widest axis into those before `middle` and the others, in all three orders,
// and keeps each part in order.
void SphereTree::split(const BallSet &balls, uint32_t first, uint32_t middle, uint32_t last) {
  int widest = 0;
  double width = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const double spread = along(balls, axis, along_[axis][last - 1]) - along(balls, axis, along_[axis][first]);
    if (spread > width) {
      width = spread;
      widest = axis;
    }
  }
  for (uint32_t p = first; p < last; ++p) in_second_[along_[widest][p]] = p < middle ? 0 : 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == widest) continue;
    const Span<uint32_t> order = along_[axis];
    uint32_t kept = first, moved = 0;
    for (uint32_t p = first; p < last; ++p) {
      if (in_second_[order[p]] != 0) {
        waiting_[moved++] = order[p];
      } else {
        order[kept++] = order[p];
      }
    }
    for (uint32_t k = 0; k < moved; ++k) order[kept + k] = waiting_[k];
  }
}

}  // namespace hsp
