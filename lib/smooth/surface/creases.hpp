// The creases of the smooth surface, where the patches of two probes meet; the corners where three creases meet; and
// the ends of each crease. Each of these is decided once for all patches beside it, by signs of one actual set
// (actual_balls.hpp), so that the patches fit together. PROOFS.md, section 10, has the rules.
//
// Only the creases and corners that exist are stored, both in the order of their vertices. The probes that may cut a
// patch are searched for once. A corner is found at the lowest of its three vertices, a crease at the lower of its two:
// by then the corners at both of its ends are known.
#pragma once

#include "core/first_index.hpp"
#include "surface/actual_balls.hpp"
#include "surface/cusped_circles.hpp"
#include "surface/near_vertices.hpp"

namespace hsp {

struct CreaseCorner {
  uint32_t vertex[3];  // ascending
  int32_t sign;
};

struct Crease {
  uint32_t low, high;   // vertices
  uint32_t start, end;  // corners, numbered as in cut_patches.hpp; the crease runs counter-clockwise about the vector
                        // from low to high. no_id if it is a whole circle
};

// An end of a crease of the pair of vertices at hand; in_second_half: more than half a turn behind the pair's first
// end.
struct CreaseEnd {
  uint32_t number;
  bool starts, in_second_half;
};

class Creases {
 public:
  void carve(Workspace &workspace, uint32_t near, uint32_t creases, uint32_t corners);

  // Status::capacity if there is no room; Status::degenerate if a sign is not certain in any width; Status::stopped.
  // `triangles` is memory for the search.
  Status build(const ActualBalls &actual, const ChosenFaces &chosen, const ProbeGrid &grid, const CuspedCircles &cusped,
               ProbeTriangles &triangles, Patience &patience);

  // The most vertices near one vertex, and the numbers of all corners and creases. They are counted also where there is
  // no room, but creases only if there was room for the other two.
  uint32_t most_near() const { return most_near_; }
  uint32_t required_corners() const { return clamped_count(corners_.required()); }
  uint32_t required_creases() const { return clamped_count(creases_.required()); }

  Span<const CreaseCorner> corners() const { return corners_.items(); }
  Span<const Crease> creases() const { return creases_.items(); }
  // Calls visit(crease) for all creases of a vertex, in the order of the other vertex.
  template <class Visit>
  void for_each_of_vertex(uint32_t v, Visit visit) const {
    const uint32_t n = creases_.size();
    const auto by_high = [this](uint32_t k) -> const Crease & { return creases_[by_high_[k]]; };
    uint32_t k = first_index(0, n, [&](uint32_t j) { return by_high(j).high >= v; });
    for (; k < n && by_high(k).high == v; ++k) visit(by_high(k));
    k = first_index(0, n, [&](uint32_t j) { return creases_[j].low >= v; });
    for (; k < n && creases_[k].low == v; ++k) visit(creases_[k]);
  }
  // The name of a corner, by its number.
  BorderPoint point(uint32_t corner) const;

 private:
  bool find_corners(uint32_t a, Patience &patience);
  Status find_creases(const ChosenFaces &chosen, const ProbeGrid &grid, uint32_t v, Patience &patience);
  bool on_one_circle(uint32_t a, uint32_t b, uint32_t c) const;
  void add_corner_ends(uint32_t v, uint32_t w, uint32_t x);
  bool add_cusps(const ChosenFaces &chosen, uint32_t v, uint32_t w);
  Status add_creases(const ProbeGrid &grid, uint32_t v, uint32_t w, bool share_cusps);

  FixedVector<uint32_t> near_;  // of the vertex at hand
  FixedVector<CreaseEnd> ends_;
  FixedVector<CreaseCorner> corners_;
  FixedVector<Crease> creases_;
  Span<uint32_t> by_high_;  // the creases by their higher vertex

  const ActualBalls *actual_ = nullptr;
  const CuspedCircles *cusped_ = nullptr;
  uint32_t first_cusp_ = 0, first_crease_corner_ = 0;
  uint32_t most_near_ = 0;
};

}  // namespace hsp
