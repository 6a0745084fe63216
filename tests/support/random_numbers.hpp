// Random numbers that are the same everywhere: the standard leaves the values of its distributions to each library.
// Needs no heap.
#pragma once

#include <cstdint>

namespace support {

// Steele, Lea, Flood: "Fast splittable pseudorandom number generators" (2014).
class SplitMix64 {
 public:
  explicit constexpr SplitMix64(uint64_t seed) : state_(seed) {}
  constexpr uint64_t operator()() {
    uint64_t z = state_ += UINT64_C(0x9E3779B97F4A7C15);
    z = (z ^ (z >> 30)) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94D049BB133111EB);
    return z ^ (z >> 31);
  }

 private:
  uint64_t state_;
};

// Numbers from an engine of 64 bits. The bias of remainders is far below what tests could notice.
template <class Engine>
class RandomNumbers {
 public:
  explicit constexpr RandomNumbers(uint64_t seed) : engine_(seed) {}

  constexpr uint64_t next() { return engine_(); }
  constexpr uint32_t below(uint32_t n) { return static_cast<uint32_t>(next() % n); }
  constexpr int64_t in(int64_t first, int64_t last) {
    return first + static_cast<int64_t>(next() % (static_cast<uint64_t>(last - first) + 1));
  }
  constexpr bool one_in(int64_t n) { return in(1, n) == 1; }
  // In [0, 1).
  constexpr double fraction() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  Engine engine_;
};

using Random = RandomNumbers<SplitMix64>;

}  // namespace support
