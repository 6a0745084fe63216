// All maxima and gates of f above a floor: its critical points (pores.hpp has f).
//
// Cubes that cover all centres are halved. A cube is dropped where one direction leads up everywhere in it: then it has
// no critical point. Halving ends where only few balls, the candidates, may be nearest somewhere in the cube. The
// candidates are found by bounds in doubles, rounded outward: between two points f changes by no more than their
// distance. So nothing is missed. All sets of three and four candidates are tried, and integers decide.
//
// Many balls that tie, or nearly tie, never become fewer by halving. If all candidates of a cube tie at one point, no
// other point of it is critical, except for sets that are nearly flat. Candidates that nearly tie become fewer in cubes
// of a fraction of a step. Around a point x a larger cube is searched at once, by this bound: let all balls within 2
// delta of the nearest one at x be within eps of it, and let 0 be inside the convex hull of their directions by eta. A
// point at a distance d < delta from x is not critical if eps / d + 1.5 d / (D - d) < eta, D the least distance from x
// to the centres: all balls that are nearest there lie ahead, so that the way back leads up. So the sets of these balls
// are tried near x, and the cube around x is done. Only candidates of the cube that is halved count here; points found
// outside that cube are left to other cubes.
//
// Other pores may know the critical points of some of the balls. Then all other balls are new. A known point stays if
// every new ball is farther there. At any other point a new ball is nearest: cubes without a new candidate are dropped.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/patience.hpp"
#include "lanes/target.hpp"
#include "pores/cube_directions.hpp"
#include "pores/name_table.hpp"
#include "pores/pore_balls.hpp"
#include "pores/tied_balls.hpp"

namespace hsp {

class PoresBuilder;

class CriticalPoints {
 public:
  // A cube: its centre in lattice steps, moved by `off`, a fraction of a step; `half` an edge.
  struct Block {
    exact::Vector centre;
    double half;
    Vec3 off{0.0, 0.0, 0.0};
  };
  // Work that was done, for measurements.
  struct Work {
    uint64_t cubes = 0, leaves = 0, triples = 0, quadruples = 0;
  };

  void carve(Workspace &workspace, const PoreLimits &limits);
  // No ball lies inside another one; points name balls by their numbers in `balls`. Status::capacity: a limit is too
  // small, and needed() tells what suffices as far as it is known. Status::range: an image is too many boxes away.
  // Status::stopped: patience allows no more work. before: null, or pores with all points above this floor whose balls
  // PoreBalls::compare() has compared. The result is the same with and without them.
  Status find(PoreBalls &balls, int64_t floor, Patience patience, const PoresBuilder *before = nullptr);
  int64_t floor() const { return floor_; }

  // The records found, unsorted, with only `point` set, and of gates `translation`.
  FixedVector<PoreMaximum> &maxima() { return maxima_; }
  FixedVector<PoreGate> &gates() { return gates_; }
  const FixedVector<PoreMaximum> &maxima() const { return maxima_; }
  const FixedVector<PoreGate> &gates() const { return gates_; }
  FixedVector<uint32_t> &tied() { return tied_; }
  const FixedVector<uint32_t> &tied() const { return tied_; }
  const FixedVector<SmallShift> &tied_shifts() const { return tied_shifts_; }
  // The names of the maxima; the caller may enter other numbers when it has sorted them.
  NameTable &maximum_names() { return maximum_names_; }
  const PoreLimits &needed() const { return needed_; }
  const Work &work() const { return work_; }
  // The name of the point to which translation number `translation` takes the point of this name.
  PointName moved_name(const PointName &name, uint32_t translation);
  // Memory of the search, which others may use after it.
  Span<uint32_t> scratch() { return candidates_; }
  // Memory for further points of the same balls.
  TangentLines &lines() const { return lines_[0]; }

 private:
  static constexpr uint32_t most_tried_whole = 5;  // a cube with so many candidates is not halved: all sets are tried
  static constexpr uint32_t most_in_leaf = 12;     // a leaf with more candidates is divided further

  struct Cube {
    exact::Vector centre;
    int64_t half;
    uint32_t first, last;  // of candidates_
    uint32_t next_part;
    double most_level[8];           // upper bounds of f in its parts
    exact::Vector searched_centre;  // the centre of a cube in which all sets have been tried
    int64_t searched_half;          // half its edge; 0: there is none
  };
  // A part of a leaf, the last cube whose edges are whole steps.
  struct FineCube {
    Vec3 off;  // from the middle of the leaf to its middle
    double half;
    uint32_t first, last;  // of candidates_
    uint32_t next_part;
  };

  void forget();
  Status take_known();
  Status keep_known(const CriticalPoint &known, Span<const uint32_t> tied, PointKind kind);
  bool is_far_from_new(const TangentPoint &point, bool &far);
  // Whether one of some candidates is a new ball, so that they may have a point that is not known.
  bool may_be_new(uint32_t first, uint32_t count) const {
    bool may = before_ == nullptr;
    for (uint32_t k = first; k < first + count && !may; ++k) may = all_->is_new(candidates_[k]);
    return may;
  }
  Status search(const Vec3 &low, const Vec3 &high);
  NearArrays near_arrays(Span<const uint32_t> ids) const;
  void halve(Cube &cube);
  uint32_t enter(const Cube &cube, const Cube &whole, uint32_t part);
  bool is_searched(const Cube &cube) const;
  void search_ties(Cube &cube);
  uint32_t drop_farther(uint32_t first, uint32_t count, uint64_t dropped);
  uint64_t compare_clustered(uint32_t first, uint32_t count, const Vec3 &at, double half) const;
  uint32_t leave_few(const Vec3 &at, double half, uint32_t first, uint32_t count, bool thoroughly);
  uint32_t leave_many(const Vec3 &at, double half, uint32_t first, uint32_t count);
  void see_directions(Span<const uint32_t> near, const Vec3 &at);
  uint32_t enter(const FineCube &cube, const FineCube &whole, const Block &block);
  void try_leaf(Span<const uint32_t> near, const Block &block, const Block &other, PointKind alone, uint32_t last);
  void try_finely(Span<const uint32_t> near, const Block &block, const Block &other, uint32_t last, double least_part);
  bool try_common_point(Span<const uint32_t> near, const Block &block, const Block &other);
  void try_tied(TangentPoint &point, Span<const uint32_t> near, const Block &block, const Block &other, bool all_tie);
  // Which of the balls that tie at a point may have another critical point nearby: none, those on one circle, any.
  enum class FlatSets : uint32_t { none, one, any };
  FlatSets flat_sets(const TangentPoint &common, Span<const uint32_t> near, double nearly, uint32_t *set);
  void try_flat_sets(const TangentPoint &common, Span<const uint32_t> near, const Block &block, const Block &other,
                     double flat);
  void try_sets(Span<const uint32_t> near, const Block &block, const Block &other, PointKind alone);
  // The balls that tie at each point found in one cube: a bit for each of the cube's candidates.
  struct KnownTies {
    static constexpr uint32_t room = 8;
    uint64_t set[room];
    bool in_plane[room];  // the point is a gate: all centres of the set are in one plane
    uint32_t size = 0;

    // Whether some of them are certainly in one plane.
    bool are_in_plane(uint64_t some) const {
      bool are = false;
      for (uint32_t k = 0; k < size; ++k) are = are || (in_plane[k] && (some & ~set[k]) == 0);
      return are;
    }
  };
  bool try_point(const uint32_t *ids, uint32_t count, Span<const uint32_t> near, const Block &block, const Block &other,
                 KnownTies &known);
  void add(TangentPoint &point, const uint32_t *ids, PointKind kind, Span<uint32_t> tied);
  void add_moved(CriticalPoint record, const Vec3 &off, const PointName &name, PointKind kind,
                 Span<const uint32_t> tied, const BoxShift &from, uint32_t translation);
  PointName name_of_ids(const uint32_t *ids, uint32_t count);

  PoreBalls *all_ = nullptr;
  const PoresBuilder *before_ = nullptr;
  const BallSet *balls_ = nullptr;
  int64_t floor_ = 0;
  // In a box images far away are left out: no such image is nearest at a point where f is up to ceiling_. If f may be
  // larger somewhere, beyond_ceiling_ is the largest upper bound of it that was found; else it is 0.
  double ceiling_ = 0.0, beyond_ceiling_ = 0.0;
  bool unsure_ = false;  // whether f may be larger than ceiling_ in the last cube
  Vec3 low_{}, high_{};  // corners of the box in which points are looked for
  FixedVector<PoreMaximum> maxima_;
  FixedVector<PoreGate> gates_;
  FixedVector<uint32_t> tied_;
  FixedVector<SmallShift> tied_shifts_;
  NameTable maximum_names_, gate_names_;
  Span<uint32_t> candidates_;
  Span<uint8_t> in_parts_;  // [candidates]: a bit for each part of the cube in which the candidate may be nearest
  Target target_ = Target::baseline;
  Span<Cube> cubes_;  // the cubes that are being halved, as a stack
  Span<uint32_t> at_point_, cluster_;
  Span<TangentLines> lines_;         // [1]
  Span<CubeDirections> directions_;  // [1]
  Span<Vec3> hull_, room_;           // [near] directions to a point; vectors to it, or directions to balls that tie
  Span<double> inverse_;             // [near] inverse lengths of these vectors; or distances to the balls
  Span<FineCube> fine_cubes_;
  PoreLimits limits_, needed_;
  Work work_;
  bool beyond_reach_ = false;
  Patience patience_;
};

// Keeps of the candidates of a cube those that may be nearest at a critical point in it, and returns how many. count:
// no more than directions_ has room for.
[[gnu::always_inline]] inline uint32_t CriticalPoints::leave_few(const Vec3 &at, double half, uint32_t first,
                                                                 uint32_t count, bool thoroughly) {
  CubeDirections &directions = directions_[0];
  directions.set(target_, near_arrays(candidates_.part(first, first + count)), at, half);
  uint32_t left = drop_farther(first, count, directions.compare(target_, count));
  if (left < 3 || directions.lead_up(left)) return 0;
  if (thoroughly && left > most_tried_whole) left = drop_farther(first, left, compare_clustered(first, left, at, half));
  if (left < 3) return 0;
  return thoroughly && directions.lead_up_at_all(left) ? 0 : left;
}

}  // namespace hsp
