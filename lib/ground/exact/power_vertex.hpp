// A power vertex about which many questions are asked: whether it is nearer to its balls than to one other ball after
// another. Everything that does not depend on the other ball is computed once. The answers are those of
// ExactPredicates::near. By (3) of PROOFS.md an answer is the sign of a linear function of the other ball's plane, at
// each level of section 3.
//
// As an example three balls with v = (6,0,0), (0,6,0) and (0,0,6) and h = 36: B = 216, H = 36 * 36 * (1,1,1), and the
// vertex is at H / B = (6,6,6). A ball with s = (2,2,2) and h_S = 36 has G = 36 B - s.H = 7776 - 7776 = 0: this is a
// tie, and the growth of the balls decides.
#pragma once

#include "exact/exact_predicates.hpp"

namespace hsp::exact {

template <class Limb>
class PowerVertexOf {
 public:
  // The vertex of three planes, which must outlive this object. No two of them are the same, and B is not 0.
  PowerVertexOf(const Sphere &sphere, const Plane (&planes)[3]);

  // +1 if the vertex is nearer to its balls than to ball S, in power distance, else -1.
  Sign near(const Plane &S) const;
  // Whether exactly one of the planes is virtual and the line of the two others is parallel to S: then the vertex stays
  // on its side of S if the virtual plane moves.
  bool moves_along(const Plane &S) const;

 private:
  using I128 = WideInteger<Limb, 128>;

  // The levels that decide nearly all questions (section 3). 0: nothing grows; 1: balls grow in proportion; 2: balls
  // grow by the quadratic form.
  static constexpr int levels = 3;
  // h itself at level 0; the change of h at the other levels.
  static I128 change_of(int level, const Plane &plane);
  int sign_of_G(int level, const Plane &S) const;

  // H at a level: its last 128 bits, its rounded value, and the sums of the sizes of its terms.
  struct Level {
    I128 H[3];
    double about[3], size[3];
    bool changes;
  };

  const Sphere &sphere_;
  const Plane (&plane_)[3];
  I128 B_;
  double about_B_;
  int sign_B_;
  Level level_[levels];
  Vector of_virtual_{0, 0, 0};  // if there is one virtual plane: the cross product of the other two normals
  int virtual_planes_ = 0;
};

using PowerVertex = PowerVertexOf<FastLimb>;

}  // namespace hsp::exact
