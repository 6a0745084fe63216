// Several numbers at once, as many as registers of every width hold that the target's baseline may have.
#pragma once

#include "cases.hpp"
#include "wide_checks.hpp"

namespace cases {

inline uint32_t lanes_answer_one_by_one() {
  const bool conditions[] = {check_lanes<double, 1>() == nullptr, check_lanes<double, 2>() == nullptr,
                             check_lanes<float, 1>() == nullptr, check_lanes<float, 4>() == nullptr};
  return first_false(conditions);
}
inline uint32_t vectors_of_lanes() {
  const bool conditions[] = {check_lane_vectors<1>() == nullptr, check_lane_vectors<2>() == nullptr};
  return first_false(conditions);
}

inline constexpr Check lanes_wide[] = {{"lanes_answer_one_by_one", lanes_answer_one_by_one},
                                       {"vectors_of_lanes", vectors_of_lanes}};

}  // namespace cases
