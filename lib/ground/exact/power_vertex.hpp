// A power vertex of which much is asked: whether it is nearer to its balls than to one ball after another. All that
// does not depend on the other ball is computed once. The answers are those of ExactPredicates::near; by (3) of
// PROOFS.md each is the sign of something linear in the other ball's plane, at each level of section 3.
//
// As an example three balls with v = (6,0,0), (0,6,0) and (0,0,6) and h = 36: B = 216, H = 36 * 36 * (1,1,1), a vertex
// at H / B = (6,6,6). Of a ball with s = (2,2,2) and h_S = 36 G = 36 B - s.H = 7776 - 7776 = 0: balls that grow decide.
#pragma once

#include "exact/exact_predicates.hpp"

namespace hsp::exact {

template <class Limb>
class PowerVertexOf {
 public:
  // Of planes of which no two are the same, and which outlive it. B is not 0.
  PowerVertexOf(const Sphere &sphere, const Plane (&planes)[3]);

  // +1 if it is nearer to them than to ball S, in power distance, else -1.
  Sign near(const Plane &S) const;
  // Whether one of its planes is virtual, and it stays on its side of S, however that moves.
  bool moves_along(const Plane &S) const;

 private:
  using I128 = WideInteger<Limb, 128>;

  // Of section 3: nothing grows; all do in proportion; all do by the quadratic form. That decides nearly all.
  static constexpr int levels = 3;
  // By what h changes at a level.
  static I128 change_of(int level, const Plane &plane);
  int sign_of_G(int level, const Plane &S) const;

  // H at a level: its last 128 bits, about it in doubles, and the sums of its terms' sizes.
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
  Vector of_virtual_{0, 0, 0};  // the cross product that is H's factor of a virtual plane, if there is but one
  int virtual_planes_ = 0;
};

using PowerVertex = PowerVertexOf<FastLimb>;

}  // namespace hsp::exact
