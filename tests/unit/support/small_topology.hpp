// A few balls with their topology in memory of fixed size, and small topologies whose parts are counted by hand.
#pragma once

#include "small_union.hpp"
#include "topology/topology_builder.hpp"

namespace cases {

// Over small_union(), which it builds anew.
class SmallTopology {
 public:
  // False if something does not fit or fails.
  bool build(const SmallBall *balls, uint32_t n) {
    if (!small_union().build(balls, n)) return false;
    const hsp::TopologyLimits limits{n, SmallUnion::most_balls, 120, 30};
    hsp::Workspace measured;
    builder_.carve(measured, limits);
    if (measured.bytes() > sizeof memory_) return false;
    hsp::Workspace workspace(memory_, sizeof memory_);
    builder_.carve(workspace, limits);
    if (builder_.build(grid(), boundary(), n) != hsp::Status::ok) return false;
    topology_ = builder_.structure();
    return true;
  }

  const hsp::CubeGrid &grid() const { return small_union().grid(); }
  const hsp::BallSet &balls() const { return small_union().balls(); }
  const hsp::Boundary &boundary() const { return small_union().boundary(); }
  // The arrays are those of the topology; the numbers beside them are a copy, to be changed at will.
  hsp::Topology &topology() { return topology_; }
  hsp::Span<uint32_t> marks() const { return builder_.marks(); }

 private:
  hsp::TopologyBuilder builder_;
  hsp::Topology topology_;
  alignas(64) unsigned char memory_[32 * 1024];
};

// One for all cases, as it is large for a stack.
inline SmallTopology &small_topology() {
  static SmallTopology one;
  return one;
}

struct CountedTopology {
  uint32_t n;
  SmallBall ball[8];
  uint32_t vertices, edges, shells;
  // Simple faces by their numbers of edges.
  uint32_t with_two, with_three, with_four, with_six;
};
constexpr CountedTopology counted_topologies[] = {
    {0, {}, 0, 0, 0, 0, 0, 0, 0},
    // A whole sphere is cut along one great circle, from pole to pole and back.
    {1, {{1, 2, 3, 4}}, 2, 2, 1, 2, 0, 0, 0},
    {2, {{0, 0, 0, 5}, {0, 0, 0, 5}}, 2, 2, 1, 2, 0, 0, 0},
    {2, {{0, 0, 0, 5}, {11, 0, 0, 5}}, 4, 4, 2, 4, 0, 0, 0},
    // A circle has two halves.
    {2, {{0, 0, 0, 5}, {8, 0, 0, 5}}, 2, 2, 1, 2, 0, 0, 0},
    {2, {{0, 0, 0, 5}, {10, 0, 0, 5}}, 2, 2, 1, 2, 0, 0, 0},
    {3, {{0, 0, 0, 5}, {4, 0, 0, 7}, {-4, 0, 0, 7}}, 2, 2, 1, 2, 0, 0, 0},
    // Loops of arcs, none of them cut.
    {3, {{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 800, 0, 1000}}, 2, 3, 1, 3, 0, 0, 0},
    {4, {{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 800, 0, 1000}, {500, 300, 800, 1000}}, 4, 6, 1, 0, 4, 0, 0},
    {4, {{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 866, 0, 300}, {500, -866, 0, 300}}, 4, 6, 1, 2, 0, 2, 0},
    // Six around a void, with a ball in it and one beside it.
    {8,
     {{1000, 0, 0, 850},
      {-1000, 0, 0, 850},
      {0, 1000, 0, 850},
      {0, -1000, 0, 850},
      {0, 0, 1000, 850},
      {0, 0, -1000, 850},
      {0, 0, 0, 100},
      {9000, 0, 0, 10}},
     20,
     28,
     4,
     4,
     0,
     12,
     0},
    // Faces with two loops that one great circle joins, by an arc over each side: halves of four edges. The cut arcs
    // end where the circles have their halves.
    {3, {{0, 0, 0, 500}, {600, 0, 0, 500}, {1200, 0, 0, 500}}, 4, 6, 1, 2, 0, 2, 0},
    {3, {{0, 0, 0, 100}, {60, 0, 80, 9}, {60, 0, -80, 9}}, 4, 6, 1, 2, 0, 2, 0},
    {3, {{0, 0, 0, 100}, {0, 0, 100, 9}, {0, 0, -100, 9}}, 4, 6, 1, 2, 0, 2, 0},
    // The same between a circle and a loop of two arcs, where they end inside one arc.
    {4, {{0, 0, 0, 1000}, {1000, 0, 0, 1000}, {500, 800, 0, 1000}, {-1500, 0, 0, 600}}, 6, 9, 1, 2, 0, 2, 1},
    // Between two circles, of which one is not cut where it has its halves.
    {3, {{0, 0, 0, 100}, {-100, 0, 0, 60}, {96, 28, 0, 9}}, 6, 8, 1, 1, 0, 2, 1},
    {3, {{300, 300, 300, 100}, {220, 300, 360, 60}, {396, 328, 300, 9}}, 6, 8, 1, 1, 0, 2, 1},  // all in one cube
    // Two great circles that meet in both poles: four lunes, with half a bump on four of their sides.
    {3, {{0, 0, 0, 100}, {100, 0, 0, 9}, {0, 100, 0, 9}}, 6, 10, 1, 3, 0, 2, 1},
    {3, {{0, 0, 0, 550}, {1000, 0, 0, 550}, {500, 866, 0, 550}}, 12, 24, 1, 3, 0, 6, 3}};

}  // namespace cases
