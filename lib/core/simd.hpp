// Two doubles at once, with the vector types of GCC and clang. Targets with a 128-bit vector unit keep them in
// registers. Each lane is computed by the same IEEE operations as a scalar, so that results do not depend on the
// target.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>

#include "core/floating_point.hpp"

namespace hsp {

inline constexpr uint32_t lane_count = 2;

typedef double Lanes __attribute__((vector_size(16)));
typedef int64_t LaneMask __attribute__((vector_size(16)));  // -1 where true

inline Lanes load_lanes(const double *p) {
  Lanes lanes;
  std::memcpy(&lanes, p, sizeof lanes);
  return lanes;
}
inline Lanes all_lanes(double x) {
  return Lanes{x, x};
}

inline bool any(const LaneMask &mask) {
  return (mask[0] | mask[1]) != 0;
}
inline uint32_t count(const LaneMask &mask) {
  return static_cast<uint32_t>(-(mask[0] + mask[1]));
}

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
inline Lanes mask_and(const LaneMask &mask, const Lanes &a) {
  return std::bit_cast<Lanes>(mask & std::bit_cast<LaneMask>(a));
}
// The same for masks. (On targets without a blend instruction GCC splits a plain & of two comparisons into single
// lanes.)
inline LaneMask mask_and(const LaneMask &a, const LaneMask &b) {
  return std::bit_cast<LaneMask>(mask_and(a, std::bit_cast<Lanes>(b)));
}
inline Lanes select(const LaneMask &mask, const Lanes &a, const Lanes &b) {
  return std::bit_cast<Lanes>((mask & std::bit_cast<LaneMask>(a)) | (~mask & std::bit_cast<LaneMask>(b)));
}
// -a where the mask is set, else a.
inline Lanes negate_if(const LaneMask &mask, const Lanes &a) {
  return std::bit_cast<Lanes>(std::bit_cast<LaneMask>(a) ^ (mask & std::bit_cast<LaneMask>(all_lanes(-0.0))));
}
inline Lanes absolute(const Lanes &a) {
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
inline LaneVector mask_and(const LaneMask &mask, const LaneVector &a) {
  return {mask_and(mask, a.x), mask_and(mask, a.y), mask_and(mask, a.z)};
}

}  // namespace hsp
