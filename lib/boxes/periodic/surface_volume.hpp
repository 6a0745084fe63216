// The volume beside a closed surface in a periodic box, from the surface alone, up to whole boxes.
//
// With u, v, w the coordinates of a point as multiples of the three vectors, the box's part of a region R is
//   integral over R of du dv dw = integral over the surface of R of u dv dw
// if R has an end on all sides. Where it goes on for ever u jumps on its surface, wherever one looks from: each face is
// taken as seen from one of its copies, so that u, v, w of two neighbours f, g differ by whole numbers n_u, n_v, n_w.
// Three sums are the same up to whole numbers for any choice of copies, and so are right up to these:
//   faces      integral over f of u dv dw
//   arcs       - n_u(f,g) integral of v_g dw along the arc, f on its left
//   vertices   n_u(f,g) n_v(g,h) w, if the arc of f and g with f on its left ends there; less that, if it begins there
// with f, g, h in an order that all copies of the box share. (These are the steps of a product of three phases in the
// cohomology of Deligne and Beilinson. A change of f's copy changes each sum by what the next one takes back.)
#pragma once

#include "measure/areas.hpp"
#include "periodic/periodic_union.hpp"

namespace hsp {

class SurfaceVolume {
 public:
  explicit SurfaceVolume(const PeriodicUnion &periodic);

  // Of a face, as seen near the centre of the grid's ball `origin`: its area, and its term of the volume on its free
  // side. All faces of a region need one origin. If the region ends on all sides and is small beside the box,
  // the sum is its volume at once.
  BallMeasure measure(uint32_t face, uint32_t origin) const;
  // The volume that a sum of terms stands for, of a region whose volume is above 0 and up to `most`.
  double reduced(double sum, double most) const;
  double box_volume() const { return box_volume_; }

 private:
  struct Seam {
    double moment = 0.0;  // three times what the second moments of the face lack of its area's part
    double sum = 0.0;     // of arcs and vertices
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
