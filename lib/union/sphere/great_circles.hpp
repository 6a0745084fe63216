// Meridians: great circles of one sphere in planes that contain the direction z, and their free intervals. They show
// which loops bound a common face (boundary/faces.cpp), where a face with several loops can be cut
// (topology/cut_arcs.hpp), and in which face a point lies (boundary/point_location.hpp). All meridians pass through the
// sphere's poles, its highest and lowest points.
#pragma once

#include "exact/angular_order.hpp"
#include "sphere/cap_boxes.hpp"
#include "sphere/exposed_caps.hpp"
#include "sphere/meridian_sectors.hpp"
#include "sphere/near_caps.hpp"

namespace hsp {

// The plane of the meridian through the tip of an axis. If the axis is parallel to z: the plane with the normal x or
// -x.
exact::Plane meridian_through(const exact::Vector &axis);

// A free part of a circle between two caps, counter-clockwise.
struct FreeInterval {
  uint32_t exit_cap, entry_cap;  // it starts at the exit of the first cap and ends at the entry of the second
};

// A cap in the plane of a meridian, which has the axes "along" and "up" (great_circles.cpp).
struct MeridianCap {
  double along, up;  // components of the cap's axis
  double b;
  uint32_t cap;
  uint32_t free_ends;  // the two bits below; during the search the other bits may hold the place of its entry

  static constexpr uint32_t free_entry = 1;
  static constexpr uint32_t free_exit = 2;
};

// The free intervals of one meridian, in cyclic order.
class FreeIntervals {
 public:
  void carve(Workspace &workspace, uint32_t capacity);

  // Finds the caps that may touch the free part, in memory that is idle before `find`.
  ExposedCaps exposed_caps() const {
    const uint32_t capacity = caps_.size();
    return {words(0, 1), {reinterpret_cast<uint8_t *>(words(1, 2).data()), capacity}};
  }
  // Indices of very many caps, in the same memory.
  NearCaps near_caps() const {
    return NearCaps(
        {words(0, 1), words(1, 2), words(2, 3), {reinterpret_cast<float *>(words(3, 4).data()), caps_.size()}});
  }
  CapBoxes cap_boxes() const { return CapBoxes(words(0, CapBoxes::words_for_each)); }
  // Called before the meridians of a ball with these caps. meridians: how many there may be. Until the last of them
  // neither the caps nor this memory may change.
  void start(const Caps &caps, uint32_t meridians) {
    if constexpr (!small_code) {
      indexed_ = caps.count >= MeridianSectors::fewest && meridians >= fewest_indexed;
      if (indexed_) make_index(caps);
    }
  }
  // If there is an index: an array with room for one number for each cap. A meridian may need the memory of this array
  // and of the index; from then on there is no index. Without an index the array is empty.
  Span<uint32_t> of_caps() const { return !small_code && indexed_ ? of_caps_ : Span<uint32_t>(); }
  // If of_caps() is not empty: the index, and whether it has a mark at a meridian.
  const MeridianSectors &sectors() const { return sectors_; }
  bool is_marked(const exact::Plane &meridian) const;
  // Finds the free intervals of a meridian. There are none if it is free as a whole or covered as a whole.
  void find(const Caps &caps, const exact::Predicates &predicates, const exact::Plane &meridian);

  bool empty() const { return bounding_caps_ == 0; }

  // Calls visit(interval) for each free interval.
  template <class Visit>
  void visit(Visit visit) const {
    for (uint32_t a = 0; a < bounding_caps_; ++a) {
      if ((caps_[a].free_ends & MeridianCap::free_exit) == 0) continue;
      visit(FreeInterval{caps_[a].cap, caps_[a + 1 < bounding_caps_ ? a + 1 : 0].cap});
    }
  }

 private:
  static constexpr uint32_t fewest_indexed = 4;

  void make_index(const Caps &caps);
  // The memory holds words_for_each arrays of a word for each cap: arrays first .. last - 1 of them.
  Span<uint32_t> words(uint32_t first, uint32_t last) const {
    static_assert(sizeof(MeridianCap) == CapBoxes::words_for_each * sizeof(uint32_t));
    const uint32_t capacity = caps_.size();
    return {reinterpret_cast<uint32_t *>(caps_.data()) + size_t{capacity} * first, capacity * (last - first)};
  }

  Span<MeridianCap> caps_;      // caps that the meridian crosses; after find() those with a free end point come first
  uint32_t bounding_caps_ = 0;  // the number of caps with a free end point
  bool indexed_;                // whether the memory behind the first `room_` entries of caps_ holds the index
  uint32_t room_;
  MeridianSectors sectors_;
  Span<uint32_t> of_caps_;  // if indexed_: see of_caps()
};

// Circle P has several free intervals, each from the exit of a plane to the entry of another one. Returns which of them
// contains the free point of P and M with this sign. interval(k, leave, entry) stores the planes of interval k,
// 0 <= k < intervals.
//
// Each end of an interval lies inside or outside M. If one end of an interval lies inside and the other one outside,
// the interval contains the entry or the exit of M. If there is no such interval, all ends lie on one side and one
// interval contains both points: the one around the mid-point of what M covers, or of what it does not cover.
template <class Interval>
uint32_t interval_that_contains(const exact::Predicates &predicates, const exact::Plane &P, uint32_t intervals,
                                Interval interval, const exact::Plane &M, int sign) {
  exact::Plane leave, entry;
  bool ends_inside = false;
  for (uint32_t k = 0; k < intervals && intervals > 1; ++k) {
    interval(k, leave, entry);
    const bool exit_inside = predicates.inside(P, leave, +1, M) > 0;
    const bool entry_inside = predicates.inside(P, entry, -1, M) > 0;
    if (exit_inside != entry_inside && (sign < 0) == entry_inside) return k;
    if (exit_inside == entry_inside) ends_inside = exit_inside;
  }
  const exact::Vector middle = ends_inside ? exact::Vector{-M.v.x, -M.v.y, -M.v.z} : M.v;
  for (uint32_t k = 0; k + 1 < intervals; ++k) {
    interval(k, leave, entry);
    if (exact::strictly_between(P.v, leave.v, middle, entry.v)) return k;
  }
  return intervals - 1;
}

// Whether the sphere's highest (pole = +1) or lowest (-1) point lies strictly between the mid-points of two caps,
// counter-clockwise about the normal m of a meridian's plane; `from` and `to` are the axes of the caps. If it does, and
// lies in neither cap, it lies between the exit of the first and the entry of the second.
bool pole_lies_between(const exact::Vector &m, const exact::Vector &from, const exact::Vector &to, int pole);

// Whether a free interval of a meridian contains the highest (pole = +1) or lowest (-1) point.
bool contains_pole(const Caps &caps, const exact::Predicates &predicates, const exact::Plane &meridian,
                   const FreeInterval &interval, int pole);

// The caps of one ball that has free points, gathered again for questions that its loops alone do not answer, with
// scratch memory. Of many caps only those are here that may touch the ball's free part.
struct GatheredBall {
  Caps caps;
  FreeIntervals intervals;

  void carve(Workspace &workspace, uint32_t neighbours) {
    caps.carve(workspace, neighbours);
    intervals.carve(workspace, neighbours);
  }
  void gather(const CubeGrid &grid, uint32_t i) { gather(grid, grid.block_around(cube_of(grid, i)), i); }
  // The same with the cubes around the ball's own already looked up.
  void gather(const CubeGrid &grid, const CubeBlock &block, uint32_t i) {
    caps.gather(grid.balls(), block, i, nullptr);
    intervals.exposed_caps().keep(ExposedCaps::Part::sphere, caps);
    intervals.start(caps, 1);
  }
  static CubeCoordinates cube_of(const CubeGrid &grid, uint32_t i) { return grid.cube_at(grid.balls().ball(i).centre); }
};

}  // namespace hsp
