// The balls that meet a cube, when they are very many, in blocks of 64 that lie close together. The planes between a
// ball and a block are not nearer than a bound, from the box around the block's centres and its largest radius. So the
// power cell of a small ball is cut by the planes of a few blocks, and those of the others are never computed.
//
// As an example 64,000 balls of radius 1 and one of radius 28 in a box of side 60, which is little more than a cube:
// there are 1,000 blocks of some 6 x 6 x 6, and most power cells need the planes of a few blocks around their balls and
// those of the block that has the large ball.
#pragma once

#include "cells/cube_members.hpp"
#include "core/workspace.hpp"

namespace hsp {

class MemberBlocks {
 public:
  static constexpr uint32_t in_block = 64;
  // In fewer balls it takes no more time to find all planes.
  static constexpr uint32_t fewest = 2048;
  // The number of places for the planes of so many balls: few have one each, many are in whole blocks.
  static constexpr uint64_t places_for(uint64_t balls) {
    return balls < fewest ? balls : (balls + in_block - 1) / in_block * in_block;
  }

  void carve(Workspace &workspace, uint32_t balls);

  // Takes the balls of a cube of this side. They are is_there() if they are many.
  void enter(const MemberArrays &members, double side);
  bool is_there() const { return blocks_ != 0; }
  void discard(uint32_t member) { not_discarded_[place_[member]] = 0.0; }

  // Begins with the planes of a ball that find_planes() would find. None is known yet.
  void begin(const MemberBall &own, double limit);
  // Finds the planes of some more blocks, the nearest ones, behind those known; each time more blocks. Planes have
  // places: member_at() is the ball of a plane. False if all are known.
  bool find_more(Target target, const PlaneArrays &planes);
  // The number of places of known planes.
  uint32_t known() const { return in_block * known_blocks_; }
  // No plane that is not known is nearer, rounded as it is; a square with a sign as in PlaneArrays.
  double nearest_unknown() const { return nearest_unknown_; }
  uint32_t member_at(uint32_t place) const {
    return member_[in_block * known_block_[place / in_block] + place % in_block];
  }
  // Whether a point has less power to the ball than to all balls of known planes that are not done with.
  bool is_before_known(Target target, const Vec3 &point, double error, const double *distance) const;

 private:
  struct Box {
    double low[3], high[3];
    double largest;  // radius
  };
  double least_distance(const Box &box) const;
  MemberArrays block(uint32_t b) const;

  Span<uint32_t> member_, place_;                            // [places] in the order of blocks; [balls] the inverse
  Span<double> x_, y_, z_, radius_, power_, not_discarded_;  // [places] as in MemberArrays
  Span<Box> box_;                                            // [blocks]
  Span<double> distance_;                                    // [blocks] bounds; infinite for blocks that are known
  Span<uint32_t> known_block_;                               // [blocks] in the order in which they became known
  MemberBall own_{};
  uint32_t blocks_ = 0, known_blocks_ = 0, at_once_ = 0;
  double limit_ = 0.0, nearest_unknown_ = 0.0;
};

}  // namespace hsp
