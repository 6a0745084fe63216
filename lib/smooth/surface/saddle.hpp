// Saddle patches: what the probe's lower side sweeps while it rolls along an arc, touching two balls. Their geometry
// and its integrals are in saddle_kernel.hpp.
#pragma once

#include "measure/arc_batches.hpp"
#include "surface/saddle_sums.hpp"

namespace hsp {

// Whether the surface of a circle meets its own axis: the circle is smaller than the probe, and its plane lies above
// either centre, towards the other one. Where the two are equal up to rounding both answers are right: the piece that
// is cut off is empty up to rounding.
constexpr bool has_cusps(double probe, double circle_radius, double height, double other_height) {
  return circle_radius < probe && height > 0.0 && other_height > 0.0;
}

// From the middle of such a circle to its cusps.
inline double half_way_between_cusps(double probe, double circle_radius) {
  return circle_radius < probe ? std::sqrt((probe - circle_radius) * (probe + circle_radius)) : 0.0;
}

// The saddle patches around one ball; the probe is not 0.
class SaddlePatches {
 public:
  SaddlePatches(const BallSet &balls, const Boundary &boundary, uint32_t ball);

  SaddleMeasures measure(const ArcBatch &batch);
  SaddleDerivatives differentiate(const ArcBatch &batch);

  const RolledBall &rolled() const { return rolled_; }
  // Of the last batch: those of its slots.
  const double (&circle_radius() const)[ArcBatch::room] { return circle_radius_; }

 private:
  void find_circle_radii(const ArcBatch &batch);

  const BallSet &balls_;
  [[maybe_unused]] const Boundary &boundary_;  // says whether there is code for wide registers
  const uint32_t ball_;
  const RolledBall rolled_;
  double circle_radius_[ArcBatch::room];
};

}  // namespace hsp
