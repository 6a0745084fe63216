// All maxima and gates above a floor.
//
// Cubes that cover all centres are halved until what may be nearest in one is few balls, or until one direction leads
// up everywhere in it: then no critical point is there. Balls that are nearest somewhere in a cube are found by bounds
// in doubles, rounded outward: f changes by no more than the way. So nothing is missed. Of the few all sets of three
// and four are tried, and integers decide.
//
// Many balls that tie, or nearly, never become fewer. Where all in a cube tie at one point, that is its one critical
// point, if it is one, but for sets that are nearly flat. Those that tie nearly become fewer in parts of a step. Larger
// cubes are searched at once by this: let all balls within 2 delta of the nearest one at a point x be within eps of it,
// and 0 be inside the hull of their directions by eta. At a distance d < delta from x no point is critical if eps / d +
// 1.5 d / (D - d) < eta, D the least distance of the centres: what is nearest there all lies ahead, so that the way
// back leads up. So a cube around x is searched at once where its sets are tried. Only balls that can be nearest in the
// cube that is halved count for that; what is found outside it is left to other cubes.
//
// Where the points of some of the balls are known, as those of other pores, they stay as far as every other ball, a new
// one, is farther there. All other points have a new ball that is nearest: cubes without one are left out.
#pragma once

#include "core/fixed_vector.hpp"
#include "core/patience.hpp"
#include "lanes/target.hpp"
#include "pores/cube_directions.hpp"
#include "pores/name_table.hpp"
#include "pores/pore_balls.hpp"
#include "pores/tied_balls.hpp"

namespace hsp {

struct CriticalLimits {
  uint32_t balls = 0;
  uint32_t maxima = 0;
  uint32_t gates = 0;
  uint32_t tied = 0;        // balls of points where more tie than are needed, all together
  uint32_t candidates = 0;  // balls that may be nearest, in all cubes that are being halved
  uint32_t near = 0;        // balls of one set of candidates that are tried
};

class PoresBuilder;

class CriticalPoints {
 public:
  // A cube in steps, moved by parts of steps.
  struct Block {
    exact::Vector centre;
    double half;
    Vec3 off{0.0, 0.0, 0.0};
  };
  // Work that was done, for measurements.
  struct Work {
    uint64_t cubes = 0, leaves = 0, triples = 0, quadruples = 0;
  };

  void carve(Workspace &workspace, const CriticalLimits &limits);
  // Of balls none of which lies inside another one; points have their numbers there. Status::capacity: a limit is too
  // small, needed() tells what suffices as far as it is known. Status::range: an image is too many boxes away.
  // Status::stopped: more is not allowed. before: null, or pores with all points above this floor whose balls
  // PoreBalls::compare() has compared; the same are found as without them.
  Status find(PoreBalls &balls, int64_t floor, Patience patience, const PoresBuilder *before = nullptr);
  int64_t floor() const { return floor_; }

  // Unsorted records with only `point` set, and `translation` of gates.
  FixedVector<PoreMaximum> &maxima() { return maxima_; }
  FixedVector<PoreGate> &gates() { return gates_; }
  const FixedVector<PoreMaximum> &maxima() const { return maxima_; }
  const FixedVector<PoreGate> &gates() const { return gates_; }
  FixedVector<uint32_t> &tied() { return tied_; }
  const FixedVector<uint32_t> &tied() const { return tied_; }
  const FixedVector<SmallShift> &tied_shifts() const { return tied_shifts_; }
  // Of the maxima, for numbers in another order.
  NameTable &maximum_names() { return maximum_names_; }
  const CriticalLimits &needed() const { return needed_; }
  const Work &work() const { return work_; }
  // Where a translation takes a point.
  PointName moved_name(const PointName &name, uint32_t translation);
  // Memory of the search, free after it.
  Span<uint32_t> scratch() { return candidates_; }
  // For further points of the same balls.
  TangentLines &lines() const { return lines_[0]; }

 private:
  static constexpr uint32_t most_tried_whole = 5;  // balls of a cube that is not halved: all their sets are tried
  static constexpr uint32_t most_in_leaf = 12;     // of more the leaf is divided further

  struct Cube {
    exact::Vector centre;
    int64_t half;
    uint32_t first, last;  // of candidates_
    uint32_t next_part;
    double most_level[8];           // of its parts
    exact::Vector searched_centre;  // of a cube in which all sets have been tried
    int64_t searched_half;          // 0: there is none
  };
  // A part of a leaf, as far as its middle from that of the leaf.
  struct FineCube {
    Vec3 off;
    double half;
    uint32_t first, last;  // of candidates_
    uint32_t next_part;
  };

  void forget();
  Status take_known();
  Status keep_known(const CriticalPoint &known, Span<const uint32_t> tied, PointKind kind);
  bool is_far_from_new(const TangentPoint &point, bool &far);
  // Whether one of some candidates may have a point that is not known.
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
  uint32_t drop_farther(uint32_t first, uint32_t count);
  uint32_t leave_few(const Vec3 &at, double half, uint32_t first, uint32_t count, bool thoroughly);
  uint32_t leave_many(const Vec3 &at, double half, uint32_t first, uint32_t count);
  void see_directions(Span<const uint32_t> near, const Vec3 &at);
  uint32_t enter(const FineCube &cube, const FineCube &whole, const Block &block);
  void try_leaf(Span<const uint32_t> near, const Block &block, const Block &other, PointKind alone, uint32_t last);
  void try_finely(Span<const uint32_t> near, const Block &block, const Block &other, uint32_t last);
  bool try_common_point(Span<const uint32_t> near, const Block &block, const Block &other);
  void try_tied(TangentPoint &point, Span<const uint32_t> near, const Block &block, const Block &other, bool all_tie);
  // Of balls that tie at a point those that may have another one nearby: none, those on one circle, any.
  enum class FlatSets : uint32_t { none, one, any };
  FlatSets flat_sets(const TangentPoint &common, Span<const uint32_t> near, double nearly, uint32_t *set);
  void try_flat_sets(const TangentPoint &common, Span<const uint32_t> near, const Block &block, const Block &other,
                     double flat);
  void try_sets(Span<const uint32_t> near, const Block &block, const Block &other, PointKind alone);
  // Sets of balls that tie at points which were found in one cube: bits of ranks among those that are near.
  struct KnownTies {
    static constexpr uint32_t room = 8;
    uint64_t set[room];
    bool in_plane[room];  // of gates all centres are in one
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
  // Levels up to which no ball that is left out can be nearest; where it is more, the most that was found possible.
  double ceiling_ = 0.0, beyond_ceiling_ = 0.0;
  bool unsure_ = false;  // whether it is more in the last cube
  Vec3 low_{}, high_{};  // of where points are looked for
  FixedVector<PoreMaximum> maxima_;
  FixedVector<PoreGate> gates_;
  FixedVector<uint32_t> tied_;
  FixedVector<SmallShift> tied_shifts_;
  NameTable maximum_names_, gate_names_;
  Span<uint32_t> candidates_;
  Span<uint8_t> in_parts_;  // [candidates]: a bit for each part of their cube
  Target target_ = Target::baseline;
  Span<Cube> cubes_;  // that are being halved
  Span<uint32_t> at_point_, cluster_;
  Span<TangentLines> lines_;         // [1]
  Span<CubeDirections> directions_;  // [1]
  Span<Vec3> hull_, room_;           // [near] directions to a point; vectors to it, or directions to balls that tie
  Span<double> inverse_;             // [near] of the lengths of these vectors, or gaps
  Span<FineCube> fine_cubes_;
  CriticalLimits limits_, needed_;
  Work work_;
  bool beyond_reach_ = false;
  Patience patience_;
};

// Of candidates of a cube leaves those that may be nearest in it at a critical point, and returns how many. No more
// than directions_ has room for.
[[gnu::always_inline]] inline uint32_t CriticalPoints::leave_few(const Vec3 &at, double half, uint32_t first,
                                                                 uint32_t count, bool thoroughly) {
  CubeDirections &directions = directions_[0];
  directions.set(target_, near_arrays(candidates_.part(first, first + count)), at, half);
  const uint32_t left = drop_farther(first, count);
  if (left < 3 || directions.lead_up(left)) return 0;
  return thoroughly && directions.lead_up_at_all(left) ? 0 : left;
}

}  // namespace hsp
