// Vectors of space and the like, two at once. Every lane is computed by the IEEE operations that a scalar would be.
#pragma once

#include <bit>

#include "core/floating_point.hpp"
#include "core/simd.hpp"

namespace hsp {

inline void store_lanes(double *p, const Lanes &a) {
  std::memcpy(p, &a, sizeof a);
}
inline LaneMask load_mask(const int64_t *p) {
  LaneMask mask;
  std::memcpy(&mask, p, sizeof mask);
  return mask;
}
inline void store_mask(int64_t *p, const LaneMask &mask) {
  std::memcpy(p, &mask, sizeof mask);
}

// a where the mask is set, else 0.
inline Lanes kept(const LaneMask &mask, const Lanes &a) {
  return std::bit_cast<Lanes>(mask & std::bit_cast<LaneMask>(a));
}
// The same for masks. (GCC takes a & of two comparisons apart where the target has no blend instruction.)
inline LaneMask both(const LaneMask &a, const LaneMask &b) {
  return std::bit_cast<LaneMask>(kept(a, std::bit_cast<Lanes>(b)));
}
inline Lanes chosen(const LaneMask &mask, const Lanes &a, const Lanes &b) {
  return std::bit_cast<Lanes>((mask & std::bit_cast<LaneMask>(a)) | (~mask & std::bit_cast<LaneMask>(b)));
}
// -a where the mask is set, else a.
inline Lanes negated(const LaneMask &mask, const Lanes &a) {
  return std::bit_cast<Lanes>(std::bit_cast<LaneMask>(a) ^ (mask & std::bit_cast<LaneMask>(all_lanes(-0.0))));
}
inline Lanes magnitude(const Lanes &a) {
  return std::bit_cast<Lanes>(std::bit_cast<LaneMask>(a) & ~std::bit_cast<LaneMask>(all_lanes(-0.0)));
}
inline Lanes square_root(const Lanes &a) {
  return Lanes{std::sqrt(a[0]), std::sqrt(a[1])};
}
inline double sum_of(const Lanes &a) {
  return a[0] + a[1];
}

struct LaneVector {
  Lanes x, y, z;

  friend LaneVector operator+(const LaneVector &a, const LaneVector &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend LaneVector operator-(const LaneVector &a, const LaneVector &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend LaneVector operator*(const Lanes &s, const LaneVector &a) { return {s * a.x, s * a.y, s * a.z}; }
};
inline Lanes dot(const LaneVector &a, const LaneVector &b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline LaneVector cross(const LaneVector &a, const LaneVector &b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline LaneVector kept(const LaneMask &mask, const LaneVector &a) {
  return {kept(mask, a.x), kept(mask, a.y), kept(mask, a.z)};
}

}  // namespace hsp
