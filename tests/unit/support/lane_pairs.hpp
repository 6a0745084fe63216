// Pairs of caps in lanes (sphere/crossing_pairs.hpp), a kernel apart from the test.
#pragma once

#include "lanes/target.hpp"

namespace hsp {

// Arrays that can be read as whole vectors.
template <class Real>
struct ThreeCaps {
  const Real *x, *y, *z, *b;
};

template <class Real>
struct LanePair {
  Real g, q, centre_jk, centre_kj;
  Real depth[2][3];  // of p- and p+ in the three caps
  Real error;
};

HSP_KERNEL(LanePair<float>, lane_pair, (const ThreeCaps<float> &caps, uint32_t j, uint32_t k), (caps, j, k))
// Kernels for targets whose registers hold four doubles.
HSP_KERNEL(LanePair<double>, lane_pair, (const ThreeCaps<double> &caps, uint32_t j, uint32_t k), (caps, j, k))

}  // namespace hsp
