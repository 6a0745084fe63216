// Caps of the sphere of one probe as a source of decisions for free_region.hpp where several patches meet in one point:
// every question that patches share has one answer for all of them. For surfaces whose joints are open otherwise.
//
// Doubles decide where they are certain, as in circles_in_doubles.hpp. Else
//   four probes in one point, and two that touch or circles that do: exactly, for the vertices rounded to a lattice of
//     2^-29 p, as the spheres of equal balls. Ties are left to the symbolic perturbation, so the answers are those of
//     one set of probes in general position, whichever of its spheres asks;
//   a side of the patch: no cap cuts one, but on a circle with cusps that of the vertex across the covered gap, in the
//     two cusps, which no other cap contains (PROOFS.md, sections 4 to 6);
//     But where the vertex across is at the same position, and the gap a whole turn, the side itself is the crease
//     between the cusps;
//   whether a corner of three creases lies in the patches: if it is clearly outside of one, in none of them. If it is
//     at a cusp, where a crease starts, it is there iff that crease enters the third cap. A crease that joins two cusps
//     at one position enters none.
//   two vertices at one position and two more probes that meet them in a point of the side between them: the corner of
//     the two probes is on that side of it where the lower vertex sees it, for all four.
//
// All of this is asked for the smaller probe of cusped_circles.hpp.
#pragma once

#include "exact/circle_crossing.hpp"
#include "surface/coincident_patches.hpp"
#include "surface/free_region.hpp"

namespace hsp {

class SettledCircles {
 public:
  // Of the vertex that the caps were gathered for.
  SettledCircles(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen, const ProbeGrid &grid,
                 const CuspedCircles &cusped, const ProbeCaps &probe);

  struct Crossing {
    uint32_t first, second;
    double root;
    Vec3 point[2];  // p-, p+
    double error;   // of axis.point - height for any cap; negative if only integers know
  };

  uint32_t count() const { return caps_.count; }
  Vec3 axis(uint32_t k) const { return caps_.axis(k); }
  double height(uint32_t k) const { return growth_of_lengths * caps_.b[k]; }

  Answer crossing(uint32_t j, uint32_t k, Crossing &crossing) const;
  Answer contains(const Crossing &crossing, int sign, uint32_t r) const;
  RegionCorner corner(const Crossing &crossing, int sign) const {
    return {crossing.first, crossing.second, sign, crossing.root, crossing.point[sign > 0 ? 1 : 0], 0.0, false};
  }
  Answer lies_inside(uint32_t k, uint32_t r) const;
  bool ends_sooner(uint32_t k, const RegionCorner &exit, const RegionCorner &a, const RegionCorner &b) const;
  double arc_angle(uint32_t k, const RegionCorner &exit, const RegionCorner &entry) const;
  double exterior_angle(const RegionCorner &corner) const;

  static bool is_side(uint32_t k) { return k < ProbeCaps::sides; }
  // The vertex at the same position beyond the cusps of a side; no_id if there is none.
  uint32_t opposite_probe(uint32_t side) const { return opposite_probe_[side]; }
  bool has_opposite_probes() const {
    return opposite_probe_[0] != no_id || opposite_probe_[1] != no_id || opposite_probe_[2] != no_id;
  }
  // Whether a point of a side belongs to the vertex at the same position, if there is one.
  bool is_beyond_opposite_probe(uint32_t side, const Vec3 &point) const {
    const SideCircle &circle = circle_[side];
    return opposite_probe_[side] != no_id && circle.radius + dot(point, circle.outward) < 0.0;
  }
  Vec3 cusp_near(uint32_t side, const Vec3 &point) const {
    const SideCircle &circle = circle_[side];
    return dot(point, circle.cusp[0]) > dot(point, circle.cusp[1]) ? circle.cusp[0] : circle.cusp[1];
  }
  const CoincidentPatches &patches() const { return patches_; }

 private:
  // The circle of a side, seen from the vertex, in units of the smaller probe.
  struct SideCircle {
    Vec3 cusp[2];  // as the balls of the record have them
    Vec3 outward;  // from the axis to the vertex
    double radius;
  };

  bool is_opposite_probe(uint32_t vertex) const {
    return vertex != no_id &&
           (opposite_probe_[0] == vertex || opposite_probe_[1] == vertex || opposite_probe_[2] == vertex);
  }
  bool is_covered_beside(uint32_t side, uint32_t cap, uint32_t other, const Vec3 &point) const;

  void find_cusps(uint32_t side);
  // Of a probe that touches this one, up to rounding: seen so from both, it cuts nothing.
  bool is_point(uint32_t k) const { return height(k) > 1.0 - 0x1p-40; }
  bool has_cusps(uint32_t side, uint32_t cap) const { return cusp_cap_[side] == cap; }
  Answer crossing_of_probes(uint32_t j, uint32_t k, Crossing &crossing) const;
  bool is_in_patches(const Crossing &crossing, int sign) const;
  // Seen along the circle: from the middle of what one cap covers to that of another.
  Vec3 across_axis(uint32_t k, const Vec3 &v) const { return combine(1.0, v, -dot(v, axis(k)), axis(k)); }
  double turn_between(uint32_t k, uint32_t from, uint32_t to) const;
  exact::Vector on_lattice(uint32_t vertex) const;
  // Of another probe's cap.
  exact::Plane plane(uint32_t k) const;

  const BallSet &balls_;
  const ProbeCaps &probe_;
  const Caps &caps_;
  CoincidentPatches patches_;
  exact::Predicates predicates_;
  double error_;
  exact::Vector own_;                    // the vertex on the lattice
  uint32_t cusp_cap_[ProbeCaps::sides];  // the cap that meets a side in its cusps
  uint32_t opposite_probe_[ProbeCaps::sides];
  SideCircle circle_[ProbeCaps::sides];  // of sides with cusps
};

}  // namespace hsp
