// A digest of a grid's content: balls, the caller's order, lattice, probe and the side of cubes. Grid order follows
// from these, and so does all that is computed from the grid. Nothing else has an effect on the digest: not memory,
// capacity or the number of computations.
//
// It is a sum over the balls, modulo 2^64. The 64 bits of a ball are mixed by two products from its coordinates, its
// radius and its index. Two different sets have the same sum only by accident, with a probability of the order of
// 2^-64: if a million pairs of sets are compared each second, one such pair is met in hundreds of thousands of years.
// Sets that collide can be made, as this is no cryptographic hash.
#pragma once

#include "exact/wide_integer.hpp"
#include "model/cube_grid.hpp"

namespace hsp {

// The exclusive or of both halves of the product of two numbers.
constexpr uint64_t folded_product(uint64_t a, uint64_t b) {
#if defined(__SIZEOF_INT128__) && !defined(HSP_PORTABLE_LIMBS)
  const exact::uint128 product = static_cast<exact::uint128>(a) * b;
  return static_cast<uint64_t>(product) ^ static_cast<uint64_t>(product >> 64);
#else
  constexpr uint64_t half = 0xFFFFFFFF;
  const uint64_t low = (a & half) * (b & half);
  const uint64_t cross = (a >> 32) * (b & half) + (low >> 32);
  const uint64_t middle = (a & half) * (b >> 32) + (cross & half);
  return (middle << 32 | (low & half)) ^ ((a >> 32) * (b >> 32) + (cross >> 32) + (middle >> 32));
#endif
}

uint64_t digest_of(const CubeGrid &grid);

// Mixes four numbers. a and b are small integers, or the bits of doubles that are small integers.
uint64_t mixed(uint64_t a, uint64_t b, uint64_t c, uint64_t d);

}  // namespace hsp
