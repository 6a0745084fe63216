// The side of a plane through two of the longest vectors there may be, and of nearly the same ones.
#pragma once

#include "cases.hpp"
#include "exact/angular_order.hpp"

namespace cases {

// The vector size * direction + offset. Of vectors shorter than 2^31 each component is below 2^31 / sqrt(3) if all are
// alike.
struct LongVector {
  int64_t size;
  hsp::exact::Vector direction, offset;

  constexpr hsp::exact::Vector vector() const {
    return {size * direction.x + offset.x, size * direction.y + offset.y, size * direction.z + offset.z};
  }
};
inline constexpr int64_t longest_axis = (INT64_C(1) << 31) - 1, longest_diagonal = 1239850262;
constexpr LongVector long_axes[] = {{longest_axis, {1, 0, 0}, {}},
                                    {longest_axis, {0, 1, 0}, {}},
                                    {longest_axis, {0, 0, 1}, {}},
                                    {longest_axis, {-1, 0, 0}, {}},
                                    {longest_axis, {0, -1, 0}, {}},
                                    {longest_axis, {0, 0, -1}, {}},
                                    {longest_diagonal, {1, 1, 1}, {}},
                                    {longest_diagonal, {-1, 1, 1}, {}},
                                    {longest_diagonal, {1, -1, 1}, {}},
                                    {longest_diagonal, {1, 1, -1}, {}},
                                    {longest_diagonal, {1, 1, 1}, {0, 0, -1}},
                                    {longest_diagonal, {1, 1, 1}, {0, -1, 0}},
                                    {longest_axis, {0, 0, 0}, {}}};

// The determinant is a polynomial in the sizes whose coefficients are small determinants: the first of these that is
// not 0 has its sign, as sizes are large. A vector without an offset may have any size.
inline int sign_of_long_determinant(const LongVector &u, const LongVector &v, const LongVector &w) {
  const LongVector *of[] = {&u, &v, &w};
  for (uint32_t offsets = 0; offsets <= 3; ++offsets) {
    int64_t coefficient = 0;
    for (uint32_t chosen = 0; chosen < 8; ++chosen) {
      if ((chosen & 1U) + (chosen >> 1 & 1U) + (chosen >> 2) != offsets) continue;
      hsp::exact::Vector part[3];
      for (uint32_t k = 0; k < 3; ++k) part[k] = (chosen >> k & 1U) != 0 ? of[k]->offset : of[k]->direction;
      coefficient += part[0].x * (part[1].y * part[2].z - part[1].z * part[2].y) +
                     part[0].y * (part[1].z * part[2].x - part[1].x * part[2].z) +
                     part[0].z * (part[1].x * part[2].y - part[1].y * part[2].x);
    }
    if (coefficient != 0) return coefficient > 0 ? 1 : -1;
  }
  return 0;
}

inline uint32_t orientations_of_the_longest_vectors() {
  uint32_t left = 0, right = 0, flat = 0;
  for (const LongVector &u : long_axes) {
    for (const LongVector &v : long_axes) {
      for (const LongVector &w : long_axes) {
        const int expected = sign_of_long_determinant(u, v, w);
        ++(expected > 0 ? left : expected < 0 ? right : flat);
        if (hsp::exact::orientation(u.vector(), v.vector(), w.vector()) != expected) return left + right + flat;
      }
    }
  }
  return left == right && left > 100 && flat > 100 ? all_hold : 0;
}

inline constexpr Check exact_angular_order[] = {
    {"orientations_of_the_longest_vectors", orientations_of_the_longest_vectors}};

}  // namespace cases
