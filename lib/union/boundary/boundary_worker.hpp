// One worker of a boundary: scratch memory of its own, a share of the balls, and what it finds there. Workers run side
// by side; each writes its own records and those entries of common arrays that belong to its balls.
#pragma once

#include "boundary/faces.hpp"
#include "boundary/half_edge_links.hpp"
#include "core/patience.hpp"
#include "sphere/lane_search.hpp"

namespace hsp {

// A worker's part of the balls: whole cubes, so consecutive balls.
struct BallShare {
  uint32_t first_cube = 0, last_cube = 0;  // last is one past the end
  BallRange balls{0, 0};
};

// Shares of about as many balls each, ascending; some are empty if there are few cubes. Images are in none.
BallShare share_of(const CubeGrid &grid, uint32_t worker, uint32_t workers);

// Aligned to cache lines, since each is written by a thread of its own.
class alignas(64) BoundaryWorker {
 public:
  BoundaryWorker();  // out of line: it is large

  // Worker 0 writes into the boundary's own arrays; the others have copies of them. scratch: memory that is free while
  // balls are searched.
  void carve(Workspace &workspace, const BoundaryLimits &limits, BoundaryArrays &arrays, uint32_t worker,
             Span<uint32_t> scratch);

  // Takes a share. Nothing is found. selected: null, or in the grid's order whether a ball is not left out. joins:
  // whether components are looked for. executor: null, or who may stop the search and the linking.
  void start(const BallShare &share, const uint32_t *selected, bool joins, const Executor *executor = nullptr);

  // Vertices and circles of the share's balls, and which balls meet. Of some balls alone: what lies on one of them,
  // found at the first of those.
  void search(const CubeGrid &grid, uint8_t *ball_state);
  // The same for the first balls of a set without a grid, the share's, that are at most 1.5 sides from a centre along
  // each axis; no radius is larger than half a side. Components are not looked for.
  void search(const BallSet &balls, const double (&centre)[3], double side, uint8_t *ball_state);

  const BallShare &share() const { return share_; }
  const FixedVector<VertexRecord> &vertices() const { return vertices_; }
  const FixedVector<CircleRecord> &circles() const { return circles_; }
  // Most balls that meet a ball of the share.
  uint32_t neighbours() const { return neighbours_; }
  // The balls of the share and those around it.
  const BallRange &met() const { return met_; }
  // Joins what this worker found to be one component.
  void join_components(DisjointSets &components) const;

  // sqrt(D) of vertices that are in their slots.
  static void find_root_discriminants(const BallSet &balls, uint32_t first, uint32_t last, BoundaryArrays &arrays);
  // Counts the half-edges on the share's balls, once all vertices and circles are in their slots.
  void count(BoundaryArrays &arrays);
  // Chains the half-edges of the share's balls to loops and gathers these to faces, once all half-edges are in their
  // slots. The numbers of loops and faces leave gaps behind those of the worker before.
  void link(const BallSet &balls, BlockSweep &sweep, const Boundary &boundary, Span<uint32_t> scratch,
            BoundaryArrays &arrays);
  // Closes such gaps: in the records of loops and faces; in everything else that stores their numbers.
  void move_down(uint32_t loops_down, uint32_t faces_down, BoundaryArrays &arrays) const;
  void renumber(uint32_t loops_down, uint32_t faces_down, BoundaryArrays &arrays) const;

  Patience &patience() { return patience_; }

  Caps caps;
  LaneSearch lanes;
  IdRange placed_vertices, placed_circles;  // where in the boundary
  TouchingRecords touching;                 // the share's balls
  HalfEdgeCounts counts;                    // on them
  IdRange loops, faces;                     // of them, as link() numbers these

 private:
  bool is_left_out(uint32_t i) const { return selected_ != nullptr && selected_[i] == 0; }
  bool leaves_out(BallRange range) const;
  void order_balls_of_records(uint32_t first_vertex, uint32_t first_circle);
  void cover(const CubeBlock &block);
  void search_ball(const BallSet &balls, const CubeBlock &block, uint32_t i, bool in_lanes, DisjointSets *components,
                   uint8_t *ball_state);

  void search_nested(const BallSet &balls, const CubeBlock &block, BallRange own, bool in_lanes,
                     DisjointSets *components, uint8_t *ball_state);

  BallShare share_;
  const uint32_t *selected_ = nullptr;
  bool joins_ = false;
  VertexFinder finder_;
  FaceFinder face_finder_;
  FixedVector<VertexRecord> vertices_;
  FixedVector<CircleRecord> circles_;
  Span<uint32_t> parent_;              // [balls] disjoint sets of those that were met
  Span<uint32_t> arriving_, leaving_;  // [balls] words for chaining
  Span<uint32_t> idle_while_searching_;
  BallRange met_{0, 0};
  uint32_t neighbours_ = 0;
  Patience patience_;
};

}  // namespace hsp
