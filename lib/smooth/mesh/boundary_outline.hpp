// The questions that MeshBuilder asks about a boundary, a van der Waals or solvent-accessible surface: on which spheres
// patches lie, which curves bound the patches, and where the points of the curves are.
//
// It asks the same about the smooth surface (surface_outline.hpp): corners, curves with points between their ends,
// spheres with patches, and bands that are no part of any sphere.
#pragma once

#include "mesh/boundary_curves.hpp"
#include "mesh/mesh.hpp"
#include "mesh/spherical_patch.hpp"

namespace hsp {

// Limits that nearly always suffice for edges of this length, in lattice steps. Status::range if they would be too
// large.
Status expected_limits_of_boundary(const BallSet &balls, const Boundary &boundary, double edge, MeshLimits &limits);

// The angle between neighbouring points on a sphere for edges of this length.
double spacing_on(double radius, double edge);

MeshVertex mesh_vertex(const BallSet &balls, const Position &position, const Vec3 &normal, uint32_t ball);
// The vertex in a direction from the centre of a ball, at the distance `radius`.
MeshVertex vertex_on_ball(const BallSet &balls, uint32_t ball, double radius, const Vec3 &direction);

// Makes the patch keep off the caps whose circles bound the ball's faces.
void keep_off_neighbours(const BallSet &balls, const Boundary &boundary, uint32_t ball, SphericalPatch &patch);

// The chosen faces of a boundary, of which a mesh is made, numbered on each ball.
class MeshedFaces {
 public:
  MeshedFaces(const Boundary &boundary, const ChosenFaces &chosen) : boundary_(boundary), chosen_(chosen) {}

  // Calls visit(face, number) for the chosen faces of a ball.
  template <class Visit>
  void visit(uint32_t ball, Visit visit) const {
    uint32_t number = 0;
    for (const uint32_t face : boundary_.faces(ball)) {
      if (chosen_.has(face)) visit(face, number++);
    }
  }
  bool any(uint32_t ball) const {
    bool found = false;
    visit(ball, [&found](uint32_t, uint32_t) { found = true; });
    return found;
  }
  // The solid angle of the chosen faces of a ball.
  double steradians(const BallSet &balls, uint32_t ball) const;
  // Chosen face number k of the ball.
  uint32_t face(uint32_t ball, uint32_t k) const {
    if (chosen_.all()) return boundary_.faces(ball).first + k;
    uint32_t found = no_id;
    visit(ball, [&found, k](uint32_t face, uint32_t number) { found = number == k ? face : found; });
    return found;
  }

 private:
  const Boundary &boundary_;
  const ChosenFaces &chosen_;
};

class BoundaryOutline {
 public:
  BoundaryOutline(const BallSet &balls, const Boundary &boundary, BoundaryCurves &curves, const ChosenFaces &chosen)
      : balls_(balls), boundary_(boundary), curves_(curves), faces_(boundary, chosen) {}

  uint32_t sphere_count() const { return balls_.n; }
  uint32_t corner_count() const { return boundary_.vertex_count(); }
  uint32_t curve_count() const { return boundary_.arc_count() + boundary_.circle_count(); }
  MeshCurve &curve(uint32_t c) { return curves_.curve(c); }
  // False if there are more points than any limit allows.
  bool divide_curves(double length, Patience &patience) { return curves_.build(balls_, boundary_, length, patience); }

  MeshVertex corner(uint32_t v) const;
  // Every point between the curve's ends.
  void add_samples(uint32_t c, FixedVector<MeshVertex> &vertices) const;
  // Whether points would lie too near each other if the curve had more of them.
  bool is_too_fine(uint32_t c) const;
  // The curve that must have as many points as c; c itself if there is none.
  uint32_t partner(uint32_t c) const { return c; }
  template <class Sink>
  void for_each_sphere(uint32_t c, Sink sink) const {
    uint32_t owners[2];
    find_owners(c, owners);
    for (const uint32_t ball : owners) sink(ball);
  }

  bool has_patches(uint32_t sphere) const { return faces_.any(sphere); }
  double spacing(uint32_t sphere, double edge) const { return spacing_on(balls_.r[sphere], edge); }
  // Whether the patches of a sphere have less than some area, as those of probes in the plane of their balls: never on
  // a ball.
  bool has_next_to_no_area(uint32_t, double) const { return false; }
  double steradians(uint32_t sphere) const { return faces_.steradians(balls_, sphere); }
  void add_border(uint32_t sphere, SphericalPatch &patch) const;
  // A point inside a patch.
  MeshVertex inner_vertex(uint32_t sphere, const Vec3 &direction) const {
    return vertex_on_ball(balls_, sphere, balls_.r[sphere], direction);
  }
  uint32_t patch(uint32_t sphere, uint32_t face) const { return faces_.face(sphere, face); }
  PatchKind kind(uint32_t) const { return PatchKind::convex; }
  // The ball that a triangle with this middle belongs to.
  uint32_t ball_at(uint32_t sphere, const double (&)[3]) const { return sphere; }

  bool add_bands(double, Patience &, FixedVector<MeshVertex> &, FixedVector<MeshTriangle> &) const { return true; }

 private:
  // The two balls of a curve, in the order of their ranks.
  void find_owners(uint32_t c, uint32_t owners[2]) const;
  MeshVertex vertex_at(const Position &position, const uint32_t *owners, uint32_t count) const;
  void add_loop(uint32_t ball, uint32_t loop, SphericalPatch &patch) const;
  // The points of a curve between its ends, or all of a circle.
  void add_points(uint32_t ball, LoopElement e, SphericalPatch &patch) const;

  const BallSet &balls_;
  const Boundary &boundary_;
  BoundaryCurves &curves_;
  const MeshedFaces faces_;
};

}  // namespace hsp
