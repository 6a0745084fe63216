// Answers questions about one power vertex.
//
// As an example balls of one size whose centres are on a circle. For one of them the planes of all others go through
// one line, the circle's axis. A side of the cube of sphere/outer_cell and two of the planes have a vertex on this
// line. G is 0 there for all other planes, and stays 0 as balls grow in proportion; it is not 0 as they grow by the
// quadratic form.
#include "exact/power_vertex.hpp"

#include "exact/power.hpp"
#include "lanes/floating_point.hpp"

namespace hsp::exact {

template <class Limb>
[[gnu::cold]] PowerVertexOf<Limb>::PowerVertexOf(const Sphere &sphere, const Plane (&planes)[3])
    : sphere_(sphere), plane_(planes) {
  using I64 = WideInteger<Limb, 64>;
  const Vector across[3] = {cross(planes[1].v, planes[2].v), cross(planes[2].v, planes[0].v),
                            cross(planes[0].v, planes[1].v)};
  B_ = dot128<Limb>(across[2], planes[2].v);
  sign_B_ = B_.sign();
  about_B_ = B_.to_double();
  for (int p = 0; p < 3; ++p) {
    if (plane_[p].perturbed != 0) continue;
    of_virtual_ = across[p];
    ++virtual_planes_;
  }
  for (int k = 0; k < levels; ++k) {
    Level &level = level_[k];
    level = {};
    for (int p = 0; p < 3; ++p) {
      const I128 h = change_of(k, plane_[p]);
      if (h.sign() == 0) continue;
      level.changes = true;
      const double about_h = h.to_double();
      const int64_t part[3] = {across[p].x, across[p].y, across[p].z};
      for (int axis = 0; axis < 3; ++axis) {
        level.H[axis] = level.H[axis] + product<128>(h, I64::from(part[axis]));
        const double term = about_h * static_cast<double>(part[axis]);
        level.about[axis] += term;
        level.size[axis] += std::fabs(term);
      }
    }
  }
}

template <class Limb>
WideInteger<Limb, 128> PowerVertexOf<Limb>::change_of(int level, const Plane &plane) {
  if (level == 0) return times<Limb>(plane.h, 1);
  if (plane.perturbed == 0) return {};
  if (level == 1) return times<Limb>(plane.h - dot(plane.v, plane.v), 1);
  return -last_amount<Limb>(plane.v);
}

// Doubles give the sign, unless the value is so small that its last 128 bits are all of it (PROOFS.md, section 3).
template <class Limb>
int PowerVertexOf<Limb>::sign_of_G(int k, const Plane &S) const {
  using I64 = WideInteger<Limb, 64>;
  const Level &level = level_[k];
  const I128 h = change_of(k, S);
  if (!level.changes && h.sign() == 0) return 0;
  const double about_h = h.to_double();
  const double x = static_cast<double>(S.v.x), y = static_cast<double>(S.v.y), z = static_cast<double>(S.v.z);
  const double about = about_h * about_B_ - x * level.about[0] - y * level.about[1] - z * level.about[2];
  const double size = std::fabs(about_h * about_B_) + std::fabs(x) * level.size[0] + std::fabs(y) * level.size[1] +
                      std::fabs(z) * level.size[2];
  const double error = 16.0 * unit_roundoff * size;
  if (std::fabs(about) > error) return about > 0.0 ? 1 : -1;
  return (product<128>(B_, h) - product<128>(level.H[0], I64::from(S.v.x)) -
          product<128>(level.H[1], I64::from(S.v.y)) - product<128>(level.H[2], I64::from(S.v.z)))
      .sign();
}

template <class Limb>
bool PowerVertexOf<Limb>::moves_along(const Plane &S) const {
  return virtual_planes_ == 1 && dot128<Limb>(of_virtual_, S.v).sign() == 0;
}

template <class Limb>
Sign PowerVertexOf<Limb>::near(const Plane &S) const {
  for (int level = 0; level < levels; ++level) {
    if (const int sign = sign_of_G(level, S); sign != 0) return {sign * sign_B_, level > 0};
    // Without virtual planes the levels of the centre's coordinates decide nothing, nor do they if the change with the
    // virtual plane is 0. Else these levels come next: the general function decides.
    if (level == 1 && virtual_planes_ > 0 && !moves_along(S)) break;
  }
  return ExactPredicates<Limb>::near(sphere_, plane_[0], plane_[1], plane_[2], S);
}

template class PowerVertexOf<FastLimb>;

}  // namespace hsp::exact
