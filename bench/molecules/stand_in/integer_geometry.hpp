// Integer points and an integer random generator: what the stand-in is made of.
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

// SplitMix64 (Steele, Lea, Flood 2014): a 64-bit counter through a bijective mixer.
class RandomSequence {
 public:
  explicit constexpr RandomSequence(uint64_t seed) : state_(seed) {}

  constexpr uint64_t next() {
    state_ += 0x9E3779B97F4A7C15U;
    uint64_t mixed = state_;
    mixed = (mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9U;
    mixed = (mixed ^ (mixed >> 27)) * 0x94D049BB133111EBU;
    return mixed ^ (mixed >> 31);
  }

  // An integer from -limit to limit.
  constexpr int64_t within(int64_t limit) {
    const auto span = static_cast<uint64_t>(2 * limit + 1);
    return static_cast<int64_t>(next() % span) - limit;
  }

 private:
  uint64_t state_;
};

}  // namespace stand_in
