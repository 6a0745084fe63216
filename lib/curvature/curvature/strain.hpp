// Derivatives by a strain x -> x + eps x of all centres, but not of radii. They are sums of terms whose derivatives by
// the centres of their balls sum to zero, so that only relative positions count.
#pragma once

#include "core/summation.hpp"
#include "core/vec3.hpp"

namespace hsp {

// by[3 p + q]: the derivative by eps_pq, with which x_p changes in proportion to x_q.
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
