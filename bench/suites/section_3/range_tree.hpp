// The first approach of Section 3: the centres in a three-dimensional range tree, asked for the box around the query
// ball grown by r_max (Preparata and Shamos: "Computational Geometry", 1985, section 2.3.4, with layers: Willard, "New
// data structures for orthogonal range queries", SIAM J. Comput. 14 (1985) 232). O(n log^2 n) time and space to build,
// O(log^2 n + hits) a query.
//
// A node of the tree over x has a tree over y of its points. A node of that has its points by z, and with each how many
// points before it went to the left child. So z is searched for once in a tree over y, and positions follow from level
// to level. Nodes are ranges of the order by x or y, halved down to `leaf` points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ball_list.hpp"
#include "section_3/grouped_balls.hpp"

namespace bench {

class RangeTree {
 public:
  // Throws std::length_error beyond 2^31 - 1 balls.
  void build(const support::BallList &balls);

  // The balls that meet a ball, in no particular order.
  void meeting(const double *centre, double radius, Hits &hits) const;

  size_t bytes() const;

 private:
  static constexpr uint32_t leaf = 16;
  using Points = std::vector<uint32_t>;

  // Points first .. last - 1 of the order by x. A leaf has no tree over y.
  struct Node {
    uint32_t first, last;
    uint32_t left, right;  // children, 0 for a leaf
    size_t by_y;           // where its `last - first` values of y begin, ascending
    size_t layers;         // where its levels begin, each of last - first entries
    uint32_t size() const { return last - first; }
  };
  // Of a point in the order by z of a node of a tree over y.
  struct Entry {
    uint32_t point;
    uint32_t to_left;  // how many entries before this one are in the left child
  };
  struct Interval {
    uint32_t first, last;
    bool empty() const { return first >= last; }
  };
  struct Box {
    std::array<double, 3> low, high;
  };

  uint32_t build_node(Interval points, Points by_y, Points by_z);
  void build_layers(const Node &node, const Points &by_z);
  Interval find(const std::vector<double> &sorted, size_t begin, size_t size, double low, double high) const;

  template <class Visit>
  void visit_node(const Node &node, const Interval &wanted, const Box &box, Visit &visit) const;
  template <class Visit>
  void visit_layers(const Node &node, size_t level, Interval part, const Interval &wanted, Interval by_z,
                    Visit &visit) const;

  const double *centre(uint32_t point) const { return &balls_.xyz[3 * size_t{point}]; }

  support::BallList balls_;
  double largest_radius_ = 0;
  Points by_x_;
  std::vector<double> x_;  // ascending
  std::vector<Node> nodes_;
  std::vector<double> y_;
  std::vector<Entry> entries_;
  std::vector<uint32_t> rank_;  // while building: a point's place in the order by x, then by y of the node
};

}  // namespace bench
