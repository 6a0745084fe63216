// Finds which balls of two molecules may meet in a pose: all pairs that are not certainly apart, by floats, eight
// spheres at a time. The caller decides about these pairs exactly. The pairs that meet come in the same order on every
// target. Raw pointers are used for the reason given in lanes/target.hpp.
//
// Errors, in units of u s with u = 2^-24 and s the sum of the radii of both root spheres and of the slack of exact
// positions. The walk starts only if the root spheres meet, so that no vector here is longer than 2 s. No radius is
// more than twice that of its root, since centres are within the root. A centre is rounded by u, its image by 14 u
// (entries of the rotation, the shift, three products and three sums along each axis), the centre with which it is
// compared by u, two radii by 4 u. The difference, its square and the square of the sum of the radii change the
// distance that decides by at most 10 u. The sum is 30 u: with a slack of 32 u = 2^-19 s no pair is missed.
#pragma once

#include <cstdint>

#include "lanes/target.hpp"

namespace hsp {

// Eight spheres. Slots without a sphere have one that is far from all others.
struct SphereBlock {
  float x[8], y[8], z[8], r[8];
};

// A molecule in levels. Level 0 is its balls in the order of the tree. Sphere k of a higher level is around the spheres
// 8 k to 8 k + 7 of the level below, which are one block. Positions are relative to the centre of the root, in steps.
struct SphereLevels {
  const SphereBlock *blocks;
  uint32_t first[11];  // the first block of each level
  uint32_t top;        // the level of the root, which is alone there; at least 1
};

// A pose relative to the centres of both roots.
struct FloatPose {
  float row[3][3];
  float shift[3];
  float slack;
};

struct NearPair {
  uint32_t fixed, moving;  // ranks in the orders of the trees
};

// Two spheres that are not certainly apart, of any level but 0, and the image of the moving one.
struct SpherePair {
  float moving[4];  // x, y, z, and the radius plus the slack
  uint32_t fixed_node, moving_node;
  uint32_t fixed_level, moving_level;
};

// A walk down both molecules. It begins with one pair that waits, the two roots.
struct PairWalk {
  uint32_t waiting;
  SpherePair pair[141];  // a pair is replaced by up to eight pairs, with one sphere a level lower
  NearPair found[512];   // pairs of balls: of a leaf with the leaves below a sphere of level 2
};

// Goes on until some pairs of balls are found. Returns their number; 0 at the end of the walk.
HSP_KERNEL(uint32_t, find_near_pairs,
           (const SphereLevels &fixed, const SphereLevels &moving, const FloatPose &pose, PairWalk &walk),
           (fixed, moving, pose, walk))

}  // namespace hsp
