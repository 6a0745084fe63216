// Ways up from gates to maxima. From a point, with all balls that are nearest there, a curve of three of them is
// followed on which f rises and no other gets nearer at once, to the first further ball; and again, up to a maximum. f
// rises all the way, so that the maximum is in the component of free space that the way begins in.
//
// A curve that is an ellipse has a top, where it may end with no further ball. If the centres of all nearest balls are
// in one plane with the point then, no curve of three leads up: the way goes on in that plane, with two balls.
//
// Far away from all centres, beyond the box around them, is the outside.
#pragma once

#include "core/fixed_vector.hpp"
#include "pores/name_table.hpp"
#include "pores/pore_balls.hpp"
#include "pores/tied_balls.hpp"

namespace hsp {

class WayUp {
 public:
  // near: how many balls may be around a way; of so many balls.
  void carve(Workspace &workspace, uint32_t near, uint32_t balls);
  void prepare(PoreBalls &balls);

  // Where a way ends.
  struct End {
    bool outside = false;
    PointName name{};  // of a maximum
    BoxShift shift{};  // which of its copies in a box
  };
  // From a gate, all of whose balls are given, on the side where its three turn counter-clockwise or on the other one.
  // Status::capacity: near is too small. Status::range: an image is too many boxes away, or the way leaves the lattice.
  // Status::check would mean that a point was neither a maximum nor left upwards.
  Status climb(const CriticalPoint &gate, Span<const uint32_t> tied, Span<const SmallShift> shifts, bool other_side,
               End &end);

  // The points of the next ways are added to that, if it is not null: where another curve begins, and some between.
  void trace_into(FixedVector<WayPoint> *points) { trace_ = points; }

  uint32_t needed_near() const { return larger_count(needed_near_, near_balls_.needed()); }
  uint64_t steps() const { return steps_; }
  uint64_t questions() const { return lines_[0].questions(); }

 private:
  struct Way {
    TangentCurve curve;
    int side = 0;
  };
  // Where four balls tie; of the two such points that with W' < 0 or the other one.
  struct Vertex {
    PointName name;
    bool rising;
    bool operator==(const Vertex &other) const = default;
  };
  // Ways that have met go on alike: where some of those before have ended.
  struct KnownEnd {
    Vertex vertex;
    End end;  // for the vertex whose first ball is not moved
  };
  // One on the way, whose first ball is moved by so many boxes.
  struct Passed {
    Vertex vertex;
    BoxShift shift;
  };
  bool leave_gate(const TangentCurve &named, int side, Way &way);
  bool find_lowest(const TangentCurve &named, int side, Way &way);
  bool leave(Way &way);
  bool leave_in_plane(const TangentCurve &before, Way &way);
  bool is_open(const Way &way);
  bool is_open_from_lowest(const Way &way);
  Status follow(const Way &way, bool &outside);
  Status gather(const CurveShape &shape, const TangentCurve &curve, double from, int64_t to);
  bool first_event(const Way &way, const CurvePiece &piece, TangentPoint &event);
  bool is_beyond_box(const CurveShape &shape, uint32_t base, double z) const;
  bool name_vertex(Vertex &vertex) const;
  KnownEnd &known_end(const Vertex &vertex);
  Status name_end(End &end);
  bool is_tied(uint32_t ball) const;
  // Without a box balls have their own numbers.
  uint32_t number_of(uint32_t ball, const BoxShift &shift);
  uint32_t ball_of(uint32_t number) const { return all_->box() == nullptr ? number : near_balls_.ball(number); }
  BoxShift shift_of(uint32_t number) const { return all_->box() == nullptr ? BoxShift{} : near_balls_.shift(number); }
  // And how far it may be off.
  struct RoundedLevel {
    double level, error;
  };
  void trace(const Way &way, const CurveShape &shape, const RoundedLevel &from, const RoundedLevel &to);

  PoreBalls *all_ = nullptr;
  NearBalls near_balls_;  // whose numbers are used here in a box
  const BallSet *balls_ = nullptr;
  Vec3 low_{}, high_{};
  double extent_ = 0.0;
  Span<TangentLines> lines_;  // [1]
  Span<Vec3> directions_;     // of tied balls
  TangentPoint point_;
  FixedVector<uint32_t> tied_, near_;
  Span<KnownEnd> known_;
  Span<Passed> passed_;
  FixedVector<WayPoint> *trace_ = nullptr;
  uint32_t needed_near_ = 0;
  uint64_t steps_ = 0;
  bool beyond_reach_ = false;
};

}  // namespace hsp
