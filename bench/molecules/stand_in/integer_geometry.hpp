// Integer points: what the stand-in is made of.
//
// Everything the generator computes is a sum, product, quotient or square root of 64-bit integers, all of them defined
// to the last bit by the language, so the same bytes come out on every machine and from every compiler.
#pragma once

#include <cstdint>

namespace stand_in {

// Lengths are counted in steps of 1e-5 Angstrom while atoms move.
using Length = int64_t;

constexpr Length steps_per_milliangstrom = 100;

// Milliangstrom, the unit of a PDB coordinate's last digit, in steps.
constexpr Length milliangstrom(int64_t count) {
  return count * steps_per_milliangstrom;
}

struct Point {
  Length x = 0;
  Length y = 0;
  Length z = 0;
};

constexpr Point operator+(Point a, Point b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Point operator-(Point a, Point b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

// Dot product; below 2^63 while coordinates stay within 150 Angstrom of each other (1.5e7 steps each).
constexpr int64_t dot(Point a, Point b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

// a * numerator / denominator, rounded towards zero.
constexpr Point scaled(Point a, int64_t numerator, int64_t denominator) {
  return {a.x * numerator / denominator, a.y * numerator / denominator, a.z * numerator / denominator};
}

// The largest integer whose square is at most `square` (0 for negative arguments), by Newton's iteration from above.
constexpr int64_t integer_square_root(int64_t square) {
  if (square <= 0) return 0;
  int64_t root = 1;
  while (root <= square / root) root *= 2;
  for (;;) {
    const int64_t next = (root + square / root) / 2;
    if (next >= root) return root;
    root = next;
  }
}

}  // namespace stand_in
