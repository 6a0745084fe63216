// Sums of angles that are multiples of 45 degrees, in every order, so that the product of the phases crosses the ends
// of both half-planes exactly; and of angles close to 0 and 180 degrees.
#pragma once

#include <initializer_list>

#include "cases.hpp"
#include "measure/exterior_angles.hpp"

namespace cases {

constexpr double eighth_x[] = {0.5, 0.5, 0, -0.5, -0.5};
constexpr double eighth_y[] = {0, 0.5, 0.5, 0.5, 0};

using TwoLanes = hsp::Wide<double, 2>;
using TwoReals = TwoLanes::Real;

inline double total(const hsp::ExteriorAngleSum<2> &sum) {
  const TwoReals rest = sum.angles();
  return 2 * hsp::pi * static_cast<double>(TwoLanes::sum(sum.turns())) + (rest[0] + rest[1]);
}

// Every sequence of five angles in one lane, the same backwards in the other.
inline uint32_t sums_of_eighths() {
  for (uint32_t sequence = 0; sequence < 3125; ++sequence) {
    uint32_t eighths[5], sum = 0;
    for (uint32_t k = 0, rest = sequence; k < 5; ++k, rest /= 5) sum += eighths[k] = rest % 5;
    hsp::ExteriorAngleSum<2> angles;
    for (uint32_t k = 0; k < 5; ++k) {
      const uint32_t a = eighths[k], b = eighths[4 - k];
      angles.add_directions(TwoReals{eighth_x[a], eighth_x[b]}, TwoReals{eighth_y[a], eighth_y[b]});
    }
    if (!near(total(angles), 2 * sum * hsp::pi / 4, 1e-14)) return sequence;
  }
  return all_hold;
}

// As many of one angle as there may be, as short and as long as a direction may be.
inline uint32_t sums_of_many() {
  constexpr uint32_t most = hsp::ExteriorAngleSum<2>::most_directions;
  for (uint32_t a = 0; a < 5; ++a) {
    for (const double length : {0x1p-6, 1.0, 0x1p124}) {
      hsp::ExteriorAngleSum<2> angles;
      for (uint32_t k = 0; k < most; ++k) {
        angles.add_directions(TwoLanes::all(length * eighth_x[a]), TwoLanes::all(length * eighth_y[a]));
      }
      if (!near(total(angles), 2 * most * a * hsp::pi / 4, 1e-11)) return a;
    }
  }
  return all_hold;
}

// Next to 0 and next to 180 degrees, where rounding must not take a turn for none.
struct NearEnds {
  double x, y;
};
constexpr NearEnds near_ends[] = {{1, 0x1p-30},  {1, 0x1p-53},  {1, 0x1p-1000},  {1, 0},
                                  {-1, 0x1p-30}, {-1, 0x1p-53}, {-1, 0x1p-1000}, {-1, 0},
                                  {0x1p-30, 1},  {-0x1p-53, 1}, {-0.75, 0.5},    {0.625, 0.0078125}};

inline uint32_t sums_next_to_half_turns() {
  Random random(4);
  for (uint32_t round = 0; round < 2000; ++round) {
    hsp::ExteriorAngleSum<2> angles;
    double expected = 0.0;
    for (uint32_t k = 0; k < hsp::ExteriorAngleSum<2>::most_directions; ++k) {
      const NearEnds &a = near_ends[random.below(12)], &b = near_ends[random.below(12)];
      angles.add_directions(TwoReals{a.x, b.x}, TwoReals{a.y, b.y});
      expected += std::atan2(a.y, a.x) + std::atan2(b.y, b.x);
    }
    if (!near(total(angles), expected, 1e-12)) return round;
  }
  return all_hold;
}

// A lane without directions adds nothing, and directions (1, 0) change nothing.
inline uint32_t sums_of_nothing() {
  hsp::ExteriorAngleSum<2> none, lower, with_nothing;
  for (hsp::ExteriorAngleSum<2> *sum : {&lower, &with_nothing}) {
    for (uint32_t k = 0; k < 4; ++k) sum->add_directions(TwoReals{-1.0, 0.0}, TwoReals{0.0, 1.0});
  }
  with_nothing.add_directions(TwoLanes::all(1.0), TwoLanes::all(0.0));
  const bool conditions[] = {total(none) == 0.0, total(lower) == total(with_nothing),
                             near(total(lower), 6 * hsp::pi, 1e-14)};
  return first_false(conditions);
}

inline constexpr Check measure_exterior_angles[] = {{"sums_of_eighths", sums_of_eighths},
                                                    {"sums_of_many", sums_of_many},
                                                    {"sums_next_to_half_turns", sums_next_to_half_turns},
                                                    {"sums_of_nothing", sums_of_nothing}};

}  // namespace cases
