// Several doubles at once, as many as registers of every width hold that the target's baseline may have.
#pragma once

#include "cases.hpp"
#include "double_lanes_checks.hpp"

namespace cases {

inline uint32_t double_lanes_answer_one_by_one() {
  const bool conditions[] = {check_lanes<1>() == nullptr, check_lanes<2>() == nullptr};
  return first_false(conditions);
}
inline uint32_t vectors_of_lanes() {
  const bool conditions[] = {check_lane_vectors<1>() == nullptr, check_lane_vectors<2>() == nullptr};
  return first_false(conditions);
}

inline constexpr Check lanes_double_lanes[] = {{"double_lanes_answer_one_by_one", double_lanes_answer_one_by_one},
                                               {"vectors_of_lanes", vectors_of_lanes}};

}  // namespace cases
