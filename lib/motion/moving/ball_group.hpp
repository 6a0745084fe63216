// Balls that changed, in groups that lie together: what lies on those of a group is computed with the balls around
// them, as a set of their own.
#pragma once

#include "core/patience.hpp"
#include "moving/ball_cells.hpp"
#include "moving/boundary_part.hpp"
#include "moving/moving_records.hpp"

namespace hsp {

class BallGroup {
 public:
  void carve(Workspace &workspace, uint32_t balls, uint32_t neighbours);
  // For n balls on a lattice.
  void clear(const exact::Lattice &lattice, uint32_t n);

  // Computes what lies on the first `affected` balls of the journal. Returns how many neighbours there has to be room
  // for; if there was none, or if it is stopped, some of the balls are as before.
  uint32_t compute(MovingRecords &records, const BallCells &cells, uint32_t affected, AreaWeights weights,
                   Patience &patience);
  // A ball inside others that touches one of them at a free point: both have one-sided derivatives. Whether it does
  // depends on balls alone that meet either. For the first `affected` balls, once all are computed.
  void flag_inner_contacts(MovingRecords &records, const BallCells &cells, uint32_t affected);

  // Between these calls: room for the ids of all balls; and a mark of each ball, to be left as 0.
  Span<uint32_t> scratch() { return near_ball_; }
  uint8_t &mark(uint32_t ball) { return in_group_[ball]; }
  BoundaryPart &part() { return part_; }

 private:
  uint32_t choose(const MovingRecords &records, const BallCells &cells, uint32_t first, uint32_t last);
  void gather_around(const MovingRecords &records, const BallCells &cells, uint32_t count);
  Status compute_chosen(MovingRecords &records, const BallCells &cells, uint32_t count, AreaWeights weights);
  void store(MovingRecords &records, uint32_t count, AreaWeights weights) const;
  void flag(MovingRecords &records, uint32_t count) const;

  uint32_t neighbours_ = 0;
  BoundaryPart part_;
  BallSet near_;              // the group, and those around it
  Span<uint32_t> near_ball_;  // [balls + 1] which they are
  Span<uint8_t> in_group_;    // [balls]
  double centre_[3] = {0.0, 0.0, 0.0};
  exact::Vector low_{}, high_{};  // the corners of a box around the group's centres
};

}  // namespace hsp
