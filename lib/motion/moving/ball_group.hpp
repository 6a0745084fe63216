// Balls that changed, in groups of balls close together. The boundary on the balls of a group is computed together with
// the balls around them, as a set of their own.
#pragma once

#include "core/patience.hpp"
#include "moving/ball_cells.hpp"
#include "moving/boundary_part.hpp"
#include "moving/moving_records.hpp"

namespace hsp {

class BallGroup {
 public:
  void carve(Workspace &workspace, uint32_t balls, uint32_t neighbours);
  // Begins for n balls on a lattice.
  void clear(const exact::Lattice &lattice, uint32_t n);

  // Computes the records of the first `affected` balls of the journal. Returns for how many neighbours there has to be
  // room. If there was not enough, or if patience has ended, some of the balls are as before.
  uint32_t compute(MovingRecords &records, const BallCells &cells, uint32_t affected, AreaWeights weights,
                   Patience &patience);
  // Flags pairs of balls of which the one lies inside others and touches the other from inside at a free point: both
  // have one-sided derivatives. That depends only on balls that meet one of them. For the first `affected` balls, after
  // all are computed.
  void flag_inner_contacts(MovingRecords &records, const BallCells &cells, uint32_t affected);

  // Memory for other uses between these calls: room for the ids of all balls; and a mark of each ball, to be left as 0.
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
  BallSet near_;              // the group, then the balls around it
  Span<uint32_t> near_ball_;  // [balls + 1] the ids of these balls
  Span<uint8_t> in_group_;    // [balls]
  double centre_[3] = {0.0, 0.0, 0.0};
  exact::Vector low_{}, high_{};  // the corners of a box around the group's centres
};

}  // namespace hsp
