// Balls on the integer lattice, as every oracle of this folder sees them, and the order in which ties are broken.
//
// The oracles are slow and meant to be obviously right. They share no code with the library and may allocate.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "int128.hpp"

namespace oracle {

// A vector of lattice steps; 128 bits because products of two such vectors occur as directions too.
using Vector = std::array<Int128, 3>;

// The index that no ball has.
inline constexpr uint32_t no_ball = 0xFFFFFFFFU;

// A closed ball: centre and radius in lattice steps.
struct LatticeBall {
  int64_t x = 0;
  int64_t y = 0;
  int64_t z = 0;
  int64_t radius = 0;

  auto operator<=>(const LatticeBall &) const = default;
};

using Balls = std::vector<LatticeBall>;

using LatticePoint = std::array<int64_t, 3>;

inline LatticePoint centre_of(const LatticeBall &ball) {
  return {ball.x, ball.y, ball.z};
}

inline LatticeBall ball_around(const LatticePoint &centre, int64_t radius) {
  return {centre[0], centre[1], centre[2], radius};
}

inline Vector centre_difference(const LatticeBall &from, const LatticeBall &to) {
  return {Int128{to.x} - from.x, Int128{to.y} - from.y, Int128{to.z} - from.z};
}

inline Int128 dot(const Vector &a, const Vector &b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vector cross(const Vector &a, const Vector &b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline bool is_zero(const Vector &a) {
  return a[0] == 0 && a[1] == 0 && a[2] == 0;
}

inline int sign_of(Int128 value) {
  return (value > 0) - (value < 0);
}

// rank[i] = place of ball i in the lexicographic order of (x, y, z, radius, index).
std::vector<uint32_t> tie_ranks(const Balls &balls);

// "{x, y, z, radius}, ..." for messages: a failing set can be pasted into a test.
std::string to_text(const Balls &balls);

}  // namespace oracle
