// One worker of a boundary: scratch memory of its own, a share of the balls, and what it finds there. Workers run side
// by side; each writes its own records and those entries of common arrays that belong to its balls.
#pragma once

#include "boundary/faces.hpp"
#include "boundary/half_edge_links.hpp"
#include "core/patience.hpp"
#include "sphere/lane_search.hpp"

namespace hsp {

// A worker's part of the balls: those of consecutive whole cubes, so consecutive balls.
struct BallShare {
  uint32_t first_cube = 0, last_cube = 0;  // last_cube is one past the end
  BallRange balls{0, 0};
};

// The share of a worker, one of `workers`. Shares ascend and have about as many balls each; some are empty if there are
// few cubes. Images are in no share.
BallShare share_of(const CubeGrid &grid, uint32_t worker, uint32_t workers);

// Aligned to cache lines, since each is written by a thread of its own.
class alignas(64) BoundaryWorker {
 public:
  BoundaryWorker();  // out of line: the class is large

  // Worker 0 writes its records into the boundary's own arrays, the others into arrays of their own. scratch: memory
  // that nobody else uses while balls are searched.
  void carve(Workspace &workspace, const BoundaryLimits &limits, BoundaryArrays &arrays, uint32_t worker,
             Span<uint32_t> scratch);

  // Takes a share; the worker has no records then. selected: null, or for each ball in grid order 0 if it is left out.
  // joins: whether balls that meet are joined. executor: null, or the executor that may stop the search and the
  // linking.
  void start(const BallShare &share, const uint32_t *selected, bool joins, const Executor *executor = nullptr);

  // Finds the vertices and circles of the share's balls, each at the first of its balls, and joins balls that meet. If
  // balls are left out: finds what lies on a selected ball, at the first selected one of its balls.
  void search(const CubeGrid &grid, uint8_t *ball_state);
  // The same for a set without a grid. The share is its first balls; these are at most 1.5 `side` from `centre` along
  // each axis, and no radius is larger than side / 2. Balls are not joined.
  void search(const BallSet &balls, const double (&centre)[3], double side, uint8_t *ball_state);

  const BallShare &share() const { return share_; }
  const FixedVector<VertexRecord> &vertices() const { return vertices_; }
  const FixedVector<CircleRecord> &circles() const { return circles_; }
  // The largest number of balls that meet one ball of the share.
  uint32_t neighbours() const { return neighbours_; }
  // The balls of the share and of the cubes around it.
  const BallRange &met() const { return met_; }
  // Joins in `components` the balls that this worker has joined.
  void join_components(DisjointSets &components) const;

  // Writes sqrt(D) of vertices first .. last - 1, which are in their places in the boundary.
  static void find_root_discriminants(const BallSet &balls, uint32_t first, uint32_t last, BoundaryArrays &arrays);
  // Counts the half-edges on the share's balls. All vertices and circles are in their places.
  void count(BoundaryArrays &arrays);
  // Chains the half-edges of the share's balls to loops and gathers these to faces. All half-edges are in their places.
  // There is a gap between the numbers of loops, and of faces, of one worker and the next.
  void link(const BallSet &balls, BlockSweep &sweep, const Boundary &boundary, Span<uint32_t> scratch,
            BoundaryArrays &arrays);
  // Close these gaps: move_down() moves the records of loops and faces, renumber() changes their numbers in all other
  // records.
  void move_down(uint32_t loops_down, uint32_t faces_down, BoundaryArrays &arrays) const;
  void renumber(uint32_t loops_down, uint32_t faces_down, BoundaryArrays &arrays) const;

  Patience &patience() { return patience_; }

  Caps caps;
  LaneSearch lanes;
  IdRange placed_vertices, placed_circles;  // the ids of this worker's records in the boundary
  TouchingRecords touching;                 // the records that may lie on the share's balls
  HalfEdgeCounts counts;                    // on the share's balls
  IdRange loops, faces;                     // of the share's balls, as link() numbers them

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
  Span<uint32_t> parent_;              // [balls] disjoint sets of balls, for those in met_
  Span<uint32_t> arriving_, leaving_;  // [balls] words for HalfEdgeChain
  Span<uint32_t> idle_while_searching_;
  BallRange met_{0, 0};
  uint32_t neighbours_ = 0;
  Patience patience_;
};

}  // namespace hsp
