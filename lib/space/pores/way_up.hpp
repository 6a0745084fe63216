// Ways up from gates to maxima. At a point all nearest balls are known. Three of them are chosen on whose curve, that
// of points equally near to the three, f rises and no other nearest ball gets nearer at once. The way follows the curve
// to the first point at which a further ball is as near. From there it goes on in the same way, up to a maximum. f
// rises all the way, so that the maximum is in the component of free space in which the way begins.
//
// A curve that is an ellipse has a top, where the way may arrive without a further ball. If the centres of all nearest
// balls are in one plane with the top, no curve of three leads up: the way goes on in that plane, on a curve of two.
//
// Beyond the box around all centres is the outside.
#pragma once

#include "core/fixed_vector.hpp"
#include "pores/name_table.hpp"
#include "pores/pore_balls.hpp"
#include "pores/tied_balls.hpp"

namespace hsp {

class WayUp {
 public:
  // near: how many balls may be around a way; balls: how many there are in all.
  void carve(Workspace &workspace, uint32_t near, uint32_t balls);
  void prepare(PoreBalls &balls);

  // Where a way ends.
  struct End {
    bool outside = false;
    PointName name{};  // of the maximum, unless it is the outside
    BoxShift shift{};  // which of its copies in a box
  };
  // Goes up from a gate, on the side from which its first three balls are seen counter-clockwise, or on the other side.
  // tied, shifts: all nearest balls of the gate. Status::capacity: `near` of carve() is too small. Status::range: an
  // image is too many boxes away, or the way leaves the lattice. Status::check would mean that there was no way up from
  // a point that is no maximum.
  Status climb(const CriticalPoint &gate, Span<const uint32_t> tied, Span<const SmallShift> shifts, bool other_side,
               End &end);

  // The next ways append their points to `points`, if it is not null: where each curve ends, and some points between.
  void trace_into(FixedVector<WayPoint> *points) { trace_ = points; }

  uint32_t needed_near() const { return larger_count(needed_near_, near_balls_.needed()); }
  uint64_t steps() const { return steps_; }
  uint64_t questions() const { return lines_[0].questions(); }

 private:
  struct Way {
    TangentCurve curve;
    int side = 0;  // of the plane of its centres; see TangentPoint::side_of_curve()
  };
  // A point where four balls tie. rising: of the two such points the one with W' > 0 (tangent_point.hpp).
  struct Vertex {
    PointName name;
    bool rising;
    bool operator==(const Vertex &other) const = default;
  };
  // From one vertex on all ways are the same. So the ends of some ways before are kept by vertices that they passed.
  struct KnownEnd {
    Vertex vertex;
    End end;  // of the way through the copy of the vertex whose first ball is not moved
  };
  // A vertex on the way; its first ball is moved by `shift` boxes.
  struct Passed {
    Vertex vertex;
    BoxShift shift;
  };
  bool leave_gate(const TangentCurve &named, int side, Way &way);
  bool find_lowest(const TangentCurve &named, int side, Way &way);
  bool leave(Way &way);
  bool leave_in_plane(const TangentCurve &before, Way &way);
  uint32_t find_nearer(const Way &way, bool from_lowest) const;
  bool is_open(const Way &way, bool from_lowest) const { return find_nearer(way, from_lowest) == no_id; }
  Status follow(const Way &way, bool &outside);
  Status gather(const CurveShape &shape, const TangentCurve &curve, double from, int64_t to);
  bool first_event(const Way &way, const CurvePiece &piece, TangentPoint &event);
  bool is_beyond_box(const CurveShape &shape, uint32_t base, double z) const;
  bool name_vertex(Vertex &vertex) const;
  bool put_name(const uint32_t *four, PointName &name) const;
  KnownEnd &known_end(const Vertex &vertex);
  Status name_end(End &end);
  bool is_tied(uint32_t ball) const;
  // The number of a ball or image in *balls_: in a box that of near_balls_, else its own.
  uint32_t number_of(uint32_t ball, const BoxShift &shift);
  uint32_t ball_of(uint32_t number) const { return all_->box() == nullptr ? number : near_balls_.ball(number); }
  BoxShift shift_of(uint32_t number) const { return all_->box() == nullptr ? BoxShift{} : near_balls_.shift(number); }
  // A level, and how far it may be off.
  struct RoundedLevel {
    double level, error;
  };
  void trace(const Way &way, const CurveShape &shape, const RoundedLevel &from, const RoundedLevel &to);

  PoreBalls *all_ = nullptr;
  NearBalls near_balls_;  // in a box: the images around the way
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
