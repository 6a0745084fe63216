// Where the probes at two vertices meet on the smooth surface: the creases, the corners where three of them do, and
// where each ends. All of it is decided once for all patches that it bounds, by signs of one actual set
// (actual_balls.hpp), so that these patches fit together. PROOFS.md, section 12, has the rules.
//
// A pair of vertices can have creases only if the cap of either probe may meet the triangle of the other: floats leave
// out others for certain (near_probes.hpp).
#pragma once

#include "surface/actual_balls.hpp"
#include "surface/chosen_faces.hpp"
#include "surface/cusped_circles.hpp"
#include "surface/probe_grid.hpp"

namespace hsp {

struct CreaseLimits {
  uint32_t vertices = 0;  // of the boundary
  uint32_t near = 0;      // probes that may meet the triangles of others, for each of these
  uint32_t pairs = 0;     // of vertices of which both may
  uint32_t corners = 0;   // of three creases
  uint32_t creases = 0;
  uint32_t ends = 0;  // of creases, of any one pair
};

struct CreaseCorner {
  uint32_t vertex[3];  // ascending
  int32_t sign;
  uint32_t next[3];  // the next corner of pairs 01, 02, 12
};

struct Crease {
  uint32_t start, end;  // numbers as in cut_patches.hpp, counter-clockwise about the way from the lower vertex to the
                        // higher one; no_id if it is a whole circle
};

struct CreasePair {
  uint32_t low, high;     // vertices
  uint32_t first_corner;  // in its list, or no_id
  uint32_t first_crease;  // those of the next pair follow
};

class Creases : public Limited<CreaseLimits> {
 public:
  void carve(Workspace &workspace, const CreaseLimits &limits);

  // Status::capacity if a limit is too small, of which needed() tells; Status::degenerate if a sign is not certain in
  // any width, or if cusped is not what the actual balls have.
  Status build(const ActualBalls &actual, const ChosenFaces &chosen, const ProbeGrid &grid,
               const CuspedCircles &cusped);

  Span<const CreaseCorner> corners() const { return corners_.items(); }
  Span<const Crease> creases() const { return creases_.items(); }
  const CreasePair &pair(uint32_t k) const { return pairs_[k]; }
  IdRange creases_of(uint32_t pair) const {
    return {pairs_[pair].first_crease, pair + 1 < pairs_.size() ? pairs_[pair + 1].first_crease : creases_.size()};
  }
  // Pairs of a vertex, by the other one: no_id for probes with which it makes none.
  IdRange near(uint32_t vertex) const { return {first_near_[vertex], first_near_[vertex + 1]}; }
  uint32_t pair_of_near(uint32_t k) const { return near_[k].pair; }
  // By its number.
  BorderPoint point(uint32_t corner) const;

 private:
  struct Near {
    uint32_t vertex, pair;
  };
  struct End {
    uint32_t number;
    bool starts, in_second_half;
  };

  void find_near(const ChosenFaces &chosen, const ProbeGrid &grid);
  void find_pairs();
  Status find_corners();
  Status find_creases(const ChosenFaces &chosen, const ProbeGrid &grid);
  uint32_t near_of(uint32_t v, uint32_t w) const;
  bool on_one_circle(uint32_t a, uint32_t b, uint32_t c) const;
  bool in_patch(const BorderPoint &point, uint32_t v) const;
  bool in_other_probe(const BorderPoint &point, uint32_t v, uint32_t w, uint32_t x) const;
  void add_corner(const BorderPoint &corner);
  bool add_cusps(const ChosenFaces &chosen, uint32_t v, uint32_t w);
  Status add_creases(const ProbeGrid &grid, uint32_t v, uint32_t w, bool share_cusps);

  FixedVector<Near> near_;  // by vertex, and for each by the other's number
  Span<uint32_t> first_near_;
  FixedVector<CreasePair> pairs_;  // by the lower vertex, and for each by the higher one
  FixedVector<CreaseCorner> corners_;
  FixedVector<Crease> creases_;
  FixedVector<End> ends_;  // of the pair at hand

  const ActualBalls *actual_ = nullptr;
  const CuspedCircles *cusped_ = nullptr;
  uint32_t first_cusp_ = 0, first_crease_corner_ = 0;
};

}  // namespace hsp
