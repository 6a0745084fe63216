// A molecule prepared for questions about another one: a binary tree of spheres, each around the balls below it. The
// balls of a node are divided between its children along the axis on which the centres are spread most (Quinlan 1994):
// evenly, except that groups of 8^k balls, k as large as possible, stay together. So every 8, 64, 512 and so on of the
// balls in the order of the tree have a sphere of their own, and the tree can also be walked eight spheres at a time
// (near_pairs.hpp).
//
// The tree depends on the balls alone and not on their order, except for equal balls.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/patience.hpp"
#include "core/workspace.hpp"
#include "model/ball_set.hpp"
#include "poses/near_pairs.hpp"

namespace hsp {

struct TreeNode {
  Vec3 centre;
  double radius;         // a little more than enough for all balls below
  uint32_t first, last;  // balls [first, last) in the order of the tree
  uint32_t second;       // the second child, 0 for leaves; the first one follows its parent

  bool is_leaf() const { return second == 0; }
};

class SphereTree {
 public:
  static constexpr uint32_t leaf_size = 4;
  // The height of a tree of the largest number of balls.
  static constexpr uint32_t largest_height = 27;

  void carve(Workspace &workspace, uint32_t balls);
  // Status::capacity if there is no room for so many balls; the tree is empty then. Status::stopped if patience has
  // ended; the tree must not be used then.
  Status build(const BallSet &balls, Patience patience = Patience());
  void clear() { nodes_.clear(); }

  bool empty() const { return nodes_.size() == 0; }
  uint32_t ball_count() const { return empty() ? 0 : nodes_[0].last; }
  const TreeNode &node(uint32_t k) const { return nodes_[k]; }
  // Balls in the order of the tree: integers, in steps.
  Vec3 centre(uint32_t i) const { return {x_[i], y_[i], z_[i]}; }
  double radius(uint32_t i) const { return r_[i]; }
  uint32_t caller(uint32_t i) const { return caller_[i]; }
  // The levels for walks eight spheres at a time. The tree must not be empty.
  const SphereLevels &levels() const { return levels_; }
  Target target() const { return target_; }
  // For tests that compare kernels.
  void use(Target target) { target_ = target; }
  // An upper bound of the distances of all centres, of balls and nodes, from the origin.
  double reach() const { return reach_; }
  const exact::Lattice &lattice() const { return lattice_; }

 private:
  void sort_axes(const BallSet &balls, Patience &patience);
  TreeNode node_around(const BallSet &balls, uint32_t first, uint32_t last, Patience &patience) const;
  void split(const BallSet &balls, uint32_t first, uint32_t middle, uint32_t last);
  void start_levels(uint32_t balls);
  void store_node(const TreeNode &node);
  void store_sphere(uint32_t level, uint32_t k, const Vec3 &centre, double radius);

  FixedVector<TreeNode> nodes_;
  Span<double> x_, y_, z_, r_;
  Span<uint32_t> caller_;
  // Used by build(): the balls of each node, ascending along each axis.
  Span<uint32_t> along_[3];
  Span<uint32_t> waiting_;
  Span<uint8_t> in_second_;
  Span<SphereBlock> blocks_;
  SphereLevels levels_{};
  Target target_ = Target::baseline;
  exact::Lattice lattice_;
  double reach_ = 0;
};

}  // namespace hsp
