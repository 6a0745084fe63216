// Saddle patches: what the probe's lower side sweeps while it rolls along an arc, touching two balls. Their geometry
// and its integrals are in saddle_kernel.hpp.
#pragma once

#include "measure/arc_batches.hpp"
#include "surface/saddle_sums.hpp"

namespace hsp {

// The surface of a circle meets its own axis in two cusps if the circle is smaller than the probe, and its plane lies
// above either centre, towards the other one. How far these are from the middle of the circle of two balls, the root of
// p^2 - rho^2: from exact integers, as probe and circle may be nearly one. 0 if there are none.
double half_way_between_cusps(const BallSet &balls, uint32_t a, uint32_t b);

// The saddle patches around one ball; the probe is not 0.
class SaddlePatches {
 public:
  SaddlePatches(const BallSet &balls, const Boundary &boundary, uint32_t ball);

  SaddleMeasures measure(const ArcBatch &batch);
  SaddleDerivatives differentiate(const ArcBatch &batch);

  const RolledBall &rolled() const { return rolled_; }
  // Of the last batch: those of its slots.
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
