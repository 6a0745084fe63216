// Lanes that are brought to the front, every choice of them.
#pragma once

#include "cases.hpp"
#include "surface/front.hpp"

namespace cases {

template <uint32_t n>
bool come_first(uint32_t chosen) {
  float numbers[n], numbers_first[n];
  uint32_t ids[n], ids_first[n];
  for (uint32_t lane = 0; lane < n; ++lane) {
    ids[lane] = 10 + lane;
    numbers[lane] = static_cast<float>(ids[lane]);
  }
  const hsp::Front<n> front(chosen);
  front.store(numbers_first, hsp::Wide<float, n>::load(numbers));
  front.copy(ids_first, ids);
  uint32_t to = 0;
  for (uint32_t lane = 0; lane < n; ++lane) {
    if ((chosen >> lane & 1U) == 0) continue;
    if (ids_first[to] != ids[lane] || numbers_first[to] != numbers[lane]) return false;
    ++to;
  }
  return front.count() == to;
}

template <uint32_t n>
uint32_t first_bad_choice() {
  for (uint32_t chosen = 0; chosen < 1U << n; ++chosen) {
    if (!come_first<n>(chosen)) return chosen;
  }
  return all_hold;
}

inline uint32_t lowest_lanes() {
  const bool conditions[] = {hsp::first_of<1>(0) == 0, hsp::first_of<1>(7) == 1,   hsp::first_of<4>(0) == 0,
                             hsp::first_of<4>(3) == 7, hsp::first_of<4>(4) == 15U, hsp::first_of<4>(UINT32_MAX) == 15U};
  return first_false(conditions);
}

inline constexpr Check surface_front[] = {
    {"one_lane", first_bad_choice<1>}, {"four_lanes", first_bad_choice<4>}, {"lowest_lanes", lowest_lanes}};

}  // namespace cases
