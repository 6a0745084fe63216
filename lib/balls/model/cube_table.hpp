// A hash table of cubes that are numbered as they come. Its size depends only on the number of cubes, not on their
// extent.
#pragma once

#include "model/cube_list.hpp"

namespace hsp {

class CubeTable : public CubeList {
 public:
  CubeTable() = default;
  CubeTable(Span<uint32_t> slots, Span<CubeCoordinates> cubes) : slots_(slots) { take(cubes); }

  // Removes all cubes; from now on there are as many slots as `cubes` cubes need.
  void clear(uint32_t cubes) {
    CubeList::clear();
    slots_.clear(cubes);
  }
  uint32_t find(const CubeCoordinates &cube) const { return slots_.find(cube, linear_hash(cube), cube_of()); }
  // Gives the next number to a cube that is not there yet.
  void append(const CubeCoordinates &cube) {
    push(cube);
    slots_.insert(count() - 1, cube_of());
  }
  const CubeSlots &slots() const { return slots_; }

 private:
  CubeSlots slots_;
};

}  // namespace hsp
