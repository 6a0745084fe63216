// Vectors of fixed capacity: what they store and what they count when they are full.
#pragma once

#include "cases.hpp"
#include "core/fixed_vector.hpp"

namespace cases {

struct Pushed {
  uint32_t capacity, pushed, stored;
  bool overflowed;
};
constexpr Pushed pushed[] = {{0, 0, 0, false}, {0, 1, 0, true},  {3, 0, 0, false}, {3, 2, 2, false},
                             {3, 3, 3, false}, {3, 4, 3, true},  {3, 7, 3, true},  {7, 7, 7, false},
                             {7, 8, 7, true},  {1, 1, 1, false}, {1, 2, 1, true}};

inline uint32_t full_vectors_go_on_counting() {
  return first_failing(pushed, [](const Pushed &c) {
    constexpr uint32_t untouched = 99;
    uint32_t storage[9];
    for (uint32_t &word : storage) word = untouched;
    hsp::FixedVector<uint32_t> vector(hsp::Span<uint32_t>(storage, c.capacity));
    for (uint32_t round = 0; round < 2; ++round) {  // the second time after clear()
      for (uint32_t k = 0; k < c.pushed; ++k) vector.push(k);
      if (vector.required() != c.pushed || vector.size() != c.stored || vector.overflowed() != c.overflowed)
        return false;
      if (vector.capacity() != c.capacity || vector.items().size() != c.stored) return false;
      for (uint32_t k = 0; k < 9; ++k) {
        if (storage[k] != (k < c.stored ? k : untouched)) return false;
      }
      for (uint32_t k = 0; k < c.stored; ++k) {
        if (vector[k] != k || &vector.items()[k] != &storage[k]) return false;
      }
      vector.clear();
      if (vector.required() != 0 || vector.size() != 0 || vector.overflowed()) return false;
    }
    return true;
  });
}

struct Clamped {
  uint64_t count;
  uint32_t limit;
};
constexpr Clamped clamped[] = {{0, 0},
                               {UINT64_C(0xFFFFFFFE), UINT32_C(0xFFFFFFFE)},
                               {UINT64_C(0xFFFFFFFF), hsp::no_id},
                               {UINT64_C(0x100000000), hsp::no_id},
                               {UINT64_MAX, hsp::no_id}};

inline uint32_t counts_are_clamped() {
  return first_failing(clamped, [](const Clamped &c) { return hsp::clamped_count(c.count) == c.limit; });
}

inline constexpr Check core_fixed_vector[] = {{"full_vectors_go_on_counting", full_vectors_go_on_counting},
                                              {"counts_are_clamped", counts_are_clamped}};

}  // namespace cases
