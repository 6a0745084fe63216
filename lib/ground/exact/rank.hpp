// The rank of a ball: its place in the lexicographic order of (x, y, z, R, index). It is the last level of the symbolic
// perturbation (PROOFS.md, section 3), where the ball of lower rank is inflated infinitely more. It is also the order
// of everything that must not depend on ids.
//
// As an example balls (x, y, z, R, index), in the order of their ranks: (0,0,0,1,7), (0,0,0,2,3), (0,0,0,2,5),
// (0,1,-9,1,0). The first two have one centre and differ in their radii, the second and the third are equal but
// for the index.
#pragma once

#include <cstdint>

namespace hsp::exact {

// Length: int64_t or double that holds integers.
template <class Length>
struct RankKey {
  Length x, y, z, R;
  uint32_t index;  // the caller's
};

template <class Length>
constexpr bool ranks_before(const RankKey<Length> &a, const RankKey<Length> &b) {
  if (a.x != b.x) return a.x < b.x;
  if (a.y != b.y) return a.y < b.y;
  if (a.z != b.z) return a.z < b.z;
  if (a.R != b.R) return a.R < b.R;
  return a.index < b.index;
}

}  // namespace hsp::exact
