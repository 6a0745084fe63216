// From loops to faces: finds which loops of one sphere bound the same free part.
#pragma once

#include "boundary/boundary.hpp"
#include "core/patience.hpp"
#include "model/block_sweep.hpp"
#include "sphere/cap_clusters.hpp"
#include "sphere/great_circles.hpp"
#include "sphere/vertex_finder.hpp"

namespace hsp {

class FaceFinder {
 public:
  void carve(Workspace &workspace, uint32_t neighbours);

  const FreeIntervals &idle_while_searching() const { return intervals_; }
  // The number of clusters of a ball's caps, for BoundaryArrays::ball_state, while the caps are at hand. known: this
  // number, or 0 if it is not known; then they are counted if there are few caps, else the result is 0.
  uint32_t count_clusters(const Caps &caps, uint32_t known);

  // Gathers the loops of consecutive balls into faces, numbered from `first` on, and sorts each ball's loops by face.
  // Returns the number after the last face. Writes only what belongs to these balls. The caps of a ball are gathered
  // again, into `caps`, in two cases. If it has several loops and its clusters were not counted: first the caps on its
  // loops alone, and all caps if these are not one cluster. If only meridians show which loops belong together: all.
  // `sweep` has not passed these balls yet, `arrays` are those of the boundary; scratch [loops].
  uint32_t find(const BallSet &balls, BlockSweep &sweep, const Boundary &boundary, BallRange range, IdRange loops,
                uint32_t first, Caps &caps, const VertexFinder &finder, Span<uint32_t> scratch, Patience &patience,
                BoundaryArrays &arrays);

 private:
  void join_loops(const BallSet &balls, BlockSweep &sweep, const Boundary &boundary, uint32_t ball, uint32_t first_loop,
                  uint32_t counted_clusters, Caps &caps, const VertexFinder &finder, DisjointSets &loops);
  uint32_t find_clusters(const Caps &caps) {
    return NearCaps::are_many(caps, caps.b.data()) ? clusters_.find(caps, intervals_.near_caps())
                                                   : clusters_.find(caps);
  }
  void join_loops_by_meridians(Caps &caps, const Boundary &boundary, uint32_t first_loop, uint32_t joins,
                               DisjointSets &loops);

  CapClusters clusters_;
  FreeIntervals intervals_;
  static constexpr uint32_t not_counted = 0;
};

}  // namespace hsp
