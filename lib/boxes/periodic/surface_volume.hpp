// The volume on one side of a closed surface in a periodic box, from the surface alone, up to whole boxes.
//
// Let u, v, w be the coordinates of a point as multiples of the three vectors. The volume of a region R, in boxes, is
//   integral over R of du dv dw = integral over the surface of R of u dv dw
// if R is bounded on all sides. If R goes on for ever, u cannot be continuous on its surface. Each face is taken as one
// of its copies, so that u, v, w of two neighbouring faces f, g differ by whole numbers n_u, n_v, n_w. The sum of these
// three sums is the same, up to whole numbers, for any choice of copies; so it is right up to whole numbers:
//   faces      integral over f of u dv dw
//   arcs       - n_u(f,g) integral of v_g dw along the arc, f on its left
//   vertices   n_u(f,g) n_v(g,h) w, if the arc of f and g with f on its left ends there; less that, if it begins there
// with f, g, h in an order that all copies of the box share. (These are the steps of a product of three phases in the
// cohomology of Deligne and Beilinson. If another copy of f is taken, the change of each sum is cancelled by the next.)
#pragma once

#include "measure/areas.hpp"
#include "periodic/periodic_union.hpp"

namespace hsp {

class SurfaceVolume {
 public:
  explicit SurfaceVolume(const PeriodicUnion &periodic);

  // The area of a face, and its term of the volume on its free side, for the copy of the face near the centre of the
  // grid's ball `origin`. All faces of a region need the same origin. If the region is bounded on all sides and small
  // beside the box, the sum of the terms is its volume.
  BallMeasure measure(uint32_t face, uint32_t origin) const;
  // The volume of a region from the sum of its terms, reduced by whole boxes to above 0 and up to `most`.
  double reduced(double sum, double most) const;
  double box_volume() const { return box_volume_; }

 private:
  struct Seam {
    double moment = 0.0;  // the part of three times the second moments of the face that comes from its border
    double sum = 0.0;     // the terms of arcs and vertices
  };
  void add_piece(const ArcBatch &batch, uint32_t s, uint32_t own, uint32_t origin, const Vec3 &centre,
                 const BoxShift &away, Seam &seam) const;
  BoxShift shift_across(uint32_t other, uint32_t origin, const BoxShift &away) const;

  const PeriodicUnion &periodic_;
  double box_volume_;
  Vec3 u_, v_, w_;  // gradients of the coordinates
  Vec3 vw_;         // v_ x w_
};

}  // namespace hsp
