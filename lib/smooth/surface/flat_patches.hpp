// Concave patches without area: of a vertex that lies in the plane of its balls' centres, where two circles touch.
// Under the symbolic perturbation it is two vertices on both sides of the plane, infinitely near, and their probes
// leave of each other's patch what lies on their own side: strips between sides, or between a side and the crease in
// the plane.
//
// Seen in the plane from the vertex, by directions theta. A side with cusps lies beyond the plane between these. Where
// two sides lie above each other there is
//   what is between them   if both are on the vertex's side of the plane,
//   what is between one of them and the crease   if only that one is,
//   nothing   if neither is;
// and where there is one side, as around a vertex inside the triangle of the centres, there is what is between it and
// the crease, or nothing. So which strips there are follows from the order of the cusps.
#pragma once

#include "surface/cusped_circles.hpp"
#include "surface/cut_patches.hpp"
#include "surface/probe_caps.hpp"

namespace hsp {

// Whether a vertex, at a position, lies in the plane of its balls' centres up to rounding; then the plane's normal on
// the vertex's side.
bool is_flat(const BallSet &balls, const Boundary &boundary, const Position &position, uint32_t vertex, Vec3 &normal);

class FlatPatches {
 public:
  FlatPatches(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen, const ProbeGrid &grid,
              const CuspedCircles &cusped)
      : balls_(balls), boundary_(boundary), chosen_(chosen), grid_(grid), cusped_(cusped) {}

  // False if the vertex is not in the plane of its balls, or which strips there are is not known.
  bool find(uint32_t vertex);
  // The findings, as pieces without area.
  void store(CutPatches &cut) const;

 private:
  // A part of a side, or the gap between its cusps, from one direction to another.
  struct Item {
    uint32_t slot;
    bool is_gap;
    double from, to;
  };
  struct Chain {
    Item item[9];
    uint32_t count = 0;
  };
  struct Arc {
    uint32_t across;
    double angle;
    bool last_of_loop, last_of_piece;
  };

  bool look(uint32_t vertex);
  bool add_side(uint32_t from, uint32_t to, double from_angle, double to_angle, Chain &chain);
  bool find_strips(const Chain &forwards, const Chain &backwards);
  bool find_ring(const Chain &around);
  bool add_between(const Chain &chain, double first, double last, bool backwards);
  bool add_crease(uint32_t across, double angle);
  void add(uint32_t across, double angle) {
    if (count_ < most_arcs) arc_[count_] = {across, angle, false, false};
    ++count_;
  }
  void end_loop(bool ends_piece) {
    if (count_ > 0 && count_ <= most_arcs) {
      arc_[count_ - 1].last_of_loop = true;
      arc_[count_ - 1].last_of_piece = ends_piece;
    }
  }
  double direction_of(const Vec3 &v) const;
  uint32_t across_side(uint32_t slot) const;

  static constexpr uint32_t most_arcs = 24;

  const BallSet &balls_;
  const Boundary &boundary_;
  const ChosenFaces &chosen_;
  const ProbeGrid &grid_;
  const CuspedCircles &cusped_;
  uint32_t vertex_ = no_id;
  Vec3 normal_{}, x_{}, y_{};  // on the vertex's side; in the plane
  double angle_[3];            // of the directions towards the balls
  Arc arc_[most_arcs];
  uint32_t count_ = 0;
};

}  // namespace hsp
