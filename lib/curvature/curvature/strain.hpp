// Derivatives by the strain of everything, x -> x + eps x of all centres but not of radii: for pieces of balls whose
// derivatives by their centres sum to zero, so that only relative positions count.
#pragma once

#include "core/summation.hpp"
#include "core/vec3.hpp"

namespace hsp {

// Rows: [3 p + q] is by eps_pq, of x_p by x_q.
struct Strain {
  double by[9] = {};

  double trace() const { return by[0] + by[4] + by[8]; }
};

class StrainSum {
 public:
  // factor * v (x) w
  void add(double factor, const Vec3 &v, const Vec3 &w) {
    const double left[3] = {factor * v.x, factor * v.y, factor * v.z};
    const double right[3] = {w.x, w.y, w.z};
    for (int p = 0; p < 3; ++p) {
      for (int q = 0; q < 3; ++q) sum_[3 * p + q].add(left[p] * right[q]);
    }
  }
  Strain total() const {
    Strain strain;
    for (int k = 0; k < 9; ++k) strain.by[k] = sum_[k].total();
    return strain;
  }

 private:
  TreeSum sum_[9];
};

}  // namespace hsp
