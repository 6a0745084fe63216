// The part of unequal weights in the derivatives of the smooth surface's area: S = sum over the balls of weight * area
// instead of their plain sum (surface_gradients.hpp). Gathered ball by ball, from its arcs and the vertices on it.
//
// A patch counts as the balls that share it (surface_areas.hpp): a convex patch with the weight w of its ball, the two
// parts of a saddle with those of theirs, a concave patch with the mean W of three. Then
//   S' = integral of weight * 2H * (normal speed) + integral of weight * (conormal speed) along all borders
// where a border counts once for either side. Along smooth joints the two sides cancel but for the difference of their
// weights. Proofs and formulas are in PROOFS.md, section 9. The caller has w_i times the derivatives for equal weights.
// In addition ball i gets
//   saddle   of its saddle patches the other balls' parts, times the difference of weights
//   waist    the border between two parts of a saddle
//   vertex   the concave patch, its sides and its creases: all that moves with the vertex, as one vector
//   side     what moves a side beyond that
#pragma once

#include "measure/gradients.hpp"
#include "surface/saddle.hpp"
#include "surface/surface.hpp"

namespace hsp {

// Derivatives of S by one ball, in lattice steps.
struct AreaDerivatives {
  Vec3 centre{0.0, 0.0, 0.0};
  double radius = 0.0;
  double offset = 0.0;     // by t, see surface_gradients.hpp
  bool one_sided = false;  // the plane of a waist has a centre in it, or a crease is between vertices at one position
};

class WeightedJoints {
 public:
  WeightedJoints(const BallSet &balls, const Boundary &boundary, const Surface &surface, const AreaWeights &weights,
                 uint32_t ball)
      : balls_(balls),
        boundary_(boundary),
        surface_(surface),
        weights_(weights),
        ball_(ball),
        weight_(weights.of(balls, ball)),
        p_(static_cast<double>(balls.probe_steps)) {}

  // The arcs and circles of a batch, of which `saddles` has the radii.
  void add_saddles(const ArcBatch &batch, const SaddlePatches &saddles);
  // A vertex on the ball with a discriminant above 0. `offset` from the ball's centre to it. equal_weights: the factor
  // of the vertex's velocity in the derivatives for equal weights.
  void add_vertex(uint32_t vertex, const Vec3 &offset, const Vec3 &equal_weights);

  double weight() const { return weight_; }
  const AreaDerivatives &sums() const { return sums_; }

 private:
  double weight_of(uint32_t ball) const { return weights_.of(balls_, ball); }
  double weight_of_vertex(uint32_t vertex) const;
  void add_waist(const ArcBatch &batch, uint32_t s, double circle_radius, double difference);
  void add_sides(uint32_t vertex, const Vec3 &offset, double mean, Vec3 by_vertex);
  Vec3 crease_part(uint32_t vertex, const Vec3 &offset, double mean);
  bool turn_crease(uint32_t vertex, uint32_t across, const SphereArc &crease, const Vec3 &offset,
                   double half_difference, Vec3 &by_vertex);

  const BallSet &balls_;
  const Boundary &boundary_;
  const Surface &surface_;
  const AreaWeights &weights_;
  const uint32_t ball_;
  const double weight_, p_;
  AreaDerivatives sums_;
};

}  // namespace hsp
