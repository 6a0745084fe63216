// The borders of the concave patch of a vertex on the sphere of the probe there, as caps of the unit sphere: the great
// circles through the directions of its three balls, and the bisector planes towards probes at other vertices that
// overlap this one. Probes with their centres on an arc or a face, rather than at a vertex, never cut the patch
// (PROOFS.md, section 5).
#pragma once

#include "sphere/caps.hpp"
#include "surface/chosen_faces.hpp"
#include "surface/probe_grid.hpp"

namespace hsp {

// Vertices closer than this, in units of p, count as one point: the direction from one to the other is noise.
inline constexpr double coincident_distance = 0x1p-25;
// The error of a vertex's position in units of the largest radius: 377e where doubles serve (triangle_kernel.hpp), else
// 100e L (sphere/arc_geometry.hpp), L <= 2 r_max.
inline constexpr double vertex_error = 400 * unit_roundoff;

class ProbeCaps {
 public:
  // For at most so many caps of other probes.
  void carve(Workspace &workspace, uint32_t neighbours);

  // Finds the caps of a vertex. Vertices must be passed in order, from the first on. False if there are no caps but the
  // three sides, or if is_doubtful(). If there is no room, met() is the number of neighbours that would have sufficed.
  bool gather(const BallSet &balls, const Boundary &boundary, const ChosenFaces &chosen, const ProbeGrid &grid,
              uint32_t vertex);

  uint64_t met() const { return others_.required(); }
  // Whether another probe touches this one in a point of the patch: exactly, if it touches the same three balls from
  // the other side, else up to rounding.
  bool touches() const { return touches_; }
  bool overflowed() const { return others_.overflowed(); }
  // How many probes the search has found, before any closer look.
  uint32_t found() const { return found_; }
  // Whether doubles cannot decide the patch: the balls touch in the vertex, the triangle has no area, another vertex is
  // so near that the direction to it is noise but not at the same position, the outside may have an edge here rather
  // than a corner, or another probe may touch this one.
  bool is_doubtful() const { return doubtful_; }
  const Caps &caps() const { return caps_; }
  static constexpr uint32_t sides = 3;  // caps 0, 1, 2
  // Unit vectors towards the balls that the sides are opposite to.
  Vec3 corner(uint32_t side) const { return in_lane(triangles_.corner[side]); }
  // The ball of the vertex that a side is opposite to.
  uint32_t ball_opposite(uint32_t side) const { return triangles_.ball[side][lane_]; }

  // Memory for other searches, which must begin anew with the first vertex, as gather() has to after them.
  ProbeTriangles &triangles() { return triangles_; }

  // The factor by which the errors of the caps exceed those stated in sphere/caps.hpp.
  double amplification() const { return amplification_; }

 private:
  struct Other {
    Vec3 axis;
    double height;  // distance / (2p)
    double distance;
    uint32_t vertex;
  };
  Vec3 in_lane(const double (&a)[3][ProbeTriangles::lanes]) const { return {a[0][lane_], a[1][lane_], a[2][lane_]}; }
  // The unit normal of the side opposite ball k, towards ball k.
  Vec3 inward(uint32_t k) const { return in_lane(triangles_.inward[k]); }
  void measure_sides(const BallSet &balls, const Boundary &boundary, const ProbeGrid &grid);
  void take(const BallSet &balls, const Boundary &boundary, const ProbeGrid &grid, uint32_t other);
  bool touches(const BallSet &balls, const Boundary &boundary, uint32_t other, const Vec3 &axis);
  bool misses(const Vec3 &axis, double height, double error) const;
  bool counts_on_circle(const BallSet &balls, const Boundary &boundary, uint32_t other);
  bool may_be_pinched(const BallSet &balls, const Boundary &boundary, uint32_t other) const;
  void sort_and_merge();
  void store_caps();

  Caps caps_;
  FixedVector<Other> others_;
  uint32_t kept_ = 0;  // of these, after merging
  double merge_distance_ = 0.0;
  double amplification_ = 1.0;

  // Of the vertex at hand.
  uint32_t vertex_ = no_id;
  const ChosenFaces *chosen_ = nullptr;
  uint32_t lane_ = 0;  // of the triangles below
  double side_error_ = 0.0;
  bool touches_ = false;
  bool doubtful_ = false;
  uint32_t found_ = 0;
  bool gap_known_[3];   // of the half-edge on ball k of the vertex's record
  uint32_t across_[3];  // the vertex at the other end of the gap behind it

  ProbeTriangles triangles_;  // of four vertices
};

}  // namespace hsp
