// Sums over all balls against those of single balls, and derivatives of the energy against differences.
#pragma once

#include <cmath>

#include "energy_of_all.hpp"
#include "measure/totals.hpp"
#include "small_union.hpp"

namespace cases {

// A lens and a ball apart, in an order that is not that of the grid.
constexpr SmallBall lens_and_ball[] = {{9000, 0, 0, 1000}, {600, 0, 0, 500}, {0, 0, 0, 500}, {0, 0, 0, 100}};
constexpr double ball_area = 4 * hsp::pi * 1e6, ball_volume = 4.0 / 3 * hsp::pi * 1e9;
// Each cap of the lens has height 200.
constexpr double lens_area = 2 * (4 * hsp::pi * 500 * 500 - 2 * hsp::pi * 500 * 200);
constexpr double lens_volume = 2 * (4.0 / 3 * hsp::pi * 500 * 500 * 500 - hsp::pi * 200 * 200 * (3 * 500 - 200) / 3);

struct Selected {
  bool all;
  uint8_t selected[4];
  double area, volume;
};
constexpr Selected selections[] = {{true, {}, ball_area + lens_area, ball_volume + lens_volume},
                                   {false, {1, 1, 1, 1}, ball_area + lens_area, ball_volume + lens_volume},
                                   {false, {1, 0, 0, 0}, ball_area, ball_volume},
                                   {false, {0, 1, 1, 0}, lens_area, lens_volume},
                                   {false, {0, 0, 0, 1}, 0, 0}};

inline uint32_t sums_ball_by_ball_in_the_order_of_the_input() {
  return first_failing(selections, [](const Selected &c) {
    if (!small_union().build(lens_and_ball, 4)) return false;
    uint32_t visited = 0;
    bool holds = true;
    const uint8_t *const selected = c.all ? nullptr : c.selected;
    const hsp::BallMeasure total = hsp::measure_union(
        small_union().grid(), small_union().boundary(), selected, [&](uint32_t i, const hsp::BallMeasure &measure) {
          hsp::BallMeasure own;
          const uint32_t ball = small_union().grid().grid_index(i);
          if (c.all || c.selected[i] != 0)
            own = hsp::measure_ball(small_union().balls(), small_union().boundary(), ball);
          holds = holds && i == visited++ && measure.area == own.area && measure.volume == own.volume;
        });
    return holds && visited == 4 && near(total.area, c.area, 1e-7) && near(total.volume, c.volume, 1e-4);
  });
}

struct EnergyOf {
  hsp::Energy energy;
  hsp::EnergyGradient gradient[4];
  bool holds = false;

  EnergyOf(const SmallBall *balls, uint32_t n, const hsp::EnergyTerms &terms) {
    if (!small_union().build(balls, n)) return;
    uint32_t visited = 0;
    holds = true;
    energy = support::differentiate_energy(small_union().grid(), small_union().boundary(), terms,
                                           [&](uint32_t i, const hsp::EnergyGradient &own) {
                                             holds = holds && i == visited;
                                             gradient[visited++] = own;
                                           });
    holds = holds && visited == n;
  }
};

inline uint32_t values_of_weighted_areas_and_volume() {
  constexpr double weight[] = {2.0, 3.0, 5.0, 7.0};
  const EnergyOf of(lens_and_ball, 4, {{weight, hsp::TouchingBalls::meet}, 0.5, -0.25});
  double by_probe = 0.0;
  for (const hsp::EnergyGradient &gradient : of.gradient) by_probe += gradient.radius;
  const bool conditions[] = {of.holds, near(of.energy.area, 2 * ball_area + (3 + 5) * lens_area / 2, 1e-6),
                             near(of.energy.volume, ball_volume + lens_volume, 1e-4),
                             of.energy.value == 0.5 * of.energy.area - 0.25 * of.energy.volume,
                             near(of.energy.by_probe, by_probe, 1e-12 * std::fabs(by_probe))};
  return first_false(conditions);
}

inline uint32_t derivatives_agree_with_differences() {
  constexpr SmallBall balls[] = {
      {0, 0, 0, 5000000}, {6000000, 1000000, 0, 4500000}, {2000000, 5500000, 1000000, 4000000}};
  constexpr double weight[] = {1.5, 1.0, 2.5};
  const hsp::EnergyTerms terms{{weight, hsp::TouchingBalls::meet}, 1.25, 1e-7};
  constexpr int32_t h = 100;  // steps
  const EnergyOf of(balls, 3, terms);
  if (!of.holds) return 0;
  double shift_sum[3] = {0, 0, 0};
  for (uint32_t i = 0; i < 3; ++i) {
    for (uint32_t k = 0; k < 4; ++k) {
      const auto value_at = [&](int32_t by) {
        SmallBall moved[] = {balls[0], balls[1], balls[2]};
        (k == 0 ? moved[i].x : k == 1 ? moved[i].y : k == 2 ? moved[i].z : moved[i].r) += by;
        return EnergyOf(moved, 3, terms).energy.value;
      };
      const double difference = (value_at(h) - value_at(-h)) / (2 * h);
      const double derivative = k < 3 ? of.gradient[i].centre[k] : of.gradient[i].radius;
      if (!near(derivative, difference, 1e-6 * (std::fabs(derivative) + 1e7))) return 4 * i + k;
      if (k < 3) shift_sum[k] += derivative;
    }
    if (of.gradient[i].one_sided) return 4 * i;
  }
  // A shift of all balls changes nothing.
  for (const double sum : shift_sum) {
    if (!near(sum, 0, 1e-6)) return 12;
  }
  return all_hold;
}

inline uint32_t touching_is_one_sided() {
  constexpr SmallBall balls[] = {{0, 0, 0, 500}, {1000, 0, 0, 500}, {5000, 0, 0, 500}};
  hsp::EnergyTerms terms;
  terms.tension = 1.0;
  const EnergyOf of(balls, 3, terms);
  const bool conditions[] = {of.holds, of.gradient[0].one_sided, of.gradient[1].one_sided, !of.gradient[2].one_sided};
  return first_false(conditions);
}

inline constexpr Check measure_totals[] = {
    {"sums_ball_by_ball_in_the_order_of_the_input", sums_ball_by_ball_in_the_order_of_the_input},
    {"values_of_weighted_areas_and_volume", values_of_weighted_areas_and_volume},
    {"derivatives_agree_with_differences", derivatives_agree_with_differences},
    {"touching_is_one_sided", touching_is_one_sided}};

}  // namespace cases
