// Radii by element: where they are published and where not, how they grow down the columns of the periodic table, and
// the paper's own. Every number is in api_element_radii.
#pragma once

#include "cases.hpp"
#include "model/element_radii.hpp"

namespace cases {

using hsp::RadiiSet;

// Which elements have a radius of Bondi's or Mantina's, from run to run.
struct Run {
  uint32_t first, last;
  bool published;
};
constexpr Run runs[] = {{1, 20, true},   {21, 27, false}, {28, 38, true},  {39, 45, false}, {46, 56, true},
                        {57, 78, false}, {79, 88, true},  {89, 91, false}, {92, 92, true},  {93, 118, false}};

inline uint32_t published_in_runs() {
  uint32_t next = 1;
  const uint32_t failing = first_failing(runs, [&](const Run &c) {
    if (c.first != next) return false;
    next = c.last + 1;
    for (uint32_t number = c.first; number <= c.last; ++number) {
      const hsp::ElementRadius found = hsp::element_radius(RadiiSet::bondi, number);
      if (found.fallback == c.published) return false;
      if (found.fallback && found.radius != 2.0) return false;
    }
    return true;
  });
  return failing == all_hold && next != hsp::element_count + 1 ? 0 : failing;
}

// Alkali and alkaline earth metals, pnictogens, halogens, noble gases: each is larger than the one above it.
struct Column {
  uint32_t n, number[7];
};
constexpr Column columns[] = {{7, {1, 3, 11, 19, 37, 55, 87}},
                              {6, {4, 12, 20, 38, 56, 88}},
                              {5, {7, 15, 33, 51, 83}},
                              {5, {9, 17, 35, 53, 85}},
                              {6, {2, 10, 18, 36, 54, 86}}};

inline uint32_t radii_grow_down_the_columns() {
  return first_failing(columns, [](const Column &c) {
    for (uint32_t k = 1; k < c.n; ++k) {
      if (hsp::element_radius(RadiiSet::bondi, c.number[k]).radius <=
          hsp::element_radius(RadiiSet::bondi, c.number[k - 1]).radius) {
        return false;
      }
    }
    return true;
  });
}

// Section 2 of the paper; then an element that only Bondi's set has, and one that neither has.
struct OfPaper {
  uint32_t number;
  double radius;
  bool fallback;
};
constexpr OfPaper of_paper[] = {{6, 1.52, false},  {20, 3.48, false}, {1, 0.70, false},
                                {7, 1.36, false},  {8, 1.28, false},  {15, 2.18, false},
                                {16, 2.10, false}, {17, 1.75, true},  {26, 2.00, true}};

inline uint32_t radii_of_the_paper() {
  return first_failing(of_paper, [](const OfPaper &c) {
    const hsp::ElementRadius found = hsp::element_radius(RadiiSet::chem3d, c.number);
    return found.radius == c.radius && found.fallback == c.fallback;
  });
}

inline constexpr Check model_element_radii[] = {{"published_in_runs", published_in_runs},
                                                {"radii_grow_down_the_columns", radii_grow_down_the_columns},
                                                {"radii_of_the_paper", radii_of_the_paper}};

}  // namespace cases
