// Saddle patches: what the probe's lower side sweeps while it rolls along an arc, touching two balls. Their geometry
// and its integrals are in saddle_kernel.hpp.
#pragma once

#include "measure/arc_batches.hpp"
#include "surface/saddle_sums.hpp"

namespace hsp {

// A circle's saddle meets the circle's axis in two cusps if the circle is smaller than the probe and its plane lies
// strictly between the two centres. Returns the distance of the cusps from the middle of the circle of balls a and b,
// the root of p^2 - rho^2; it is computed from exact integers, as p and rho may be nearly equal. Returns 0 if there are
// no cusps.
double half_way_between_cusps(const BallSet &balls, uint32_t a, uint32_t b);

// The saddle patches around one ball; the probe is not 0.
class SaddlePatches {
 public:
  SaddlePatches(const BallSet &balls, const Boundary &boundary, uint32_t ball);

  SaddleMeasures measure(const ArcBatch &batch);
  SaddleDerivatives differentiate(const ArcBatch &batch);

  const RolledBall &rolled() const { return rolled_; }
  // The circles in the slots of the last batch.
  const SaddleCircles &circles() const { return circles_; }

 private:
  void find_circles(const ArcBatch &batch);

  const BallSet &balls_;
  [[maybe_unused]] const Boundary &boundary_;  // says whether there is code for wide registers
  const uint32_t ball_;
  const RolledBall rolled_;
  SaddleCircles circles_;
};

}  // namespace hsp
