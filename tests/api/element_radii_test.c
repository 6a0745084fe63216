/* Radii by element: every element of each set against the published numbers, which stand here by columns of the
 * periodic table; which elements are flagged; what is refused. */
#include <hardsphere.h>

#include "check.h"
#include "untouched.h"

enum { ELEMENTS = 118 };

typedef struct column {
  uint32_t count;
  uint32_t number[7];
  double radius[7];
} column;

/* Table 12 of Mantina et al. 2009. */
static const column main_group[] = {
    {7, {1, 3, 11, 19, 37, 55, 87}, {1.10, 1.81, 2.27, 2.75, 3.03, 3.43, 3.48}}, /* H, Li to Fr */
    {6, {4, 12, 20, 38, 56, 88}, {1.53, 1.73, 2.31, 2.49, 2.68, 2.83}},          /* Be to Ra */
    {5, {5, 13, 31, 49, 81}, {1.92, 1.84, 1.87, 1.93, 1.96}},                    /* B to Tl */
    {5, {6, 14, 32, 50, 82}, {1.70, 2.10, 2.11, 2.17, 2.02}},                    /* C to Pb */
    {5, {7, 15, 33, 51, 83}, {1.55, 1.80, 1.85, 2.06, 2.07}},                    /* N to Bi */
    {5, {8, 16, 34, 52, 84}, {1.52, 1.80, 1.90, 2.06, 1.97}},                    /* O to Po */
    {5, {9, 17, 35, 53, 85}, {1.47, 1.75, 1.83, 1.98, 2.02}},                    /* F to At */
    {6, {2, 10, 18, 36, 54, 86}, {1.40, 1.54, 1.88, 2.02, 2.16, 2.20}}};         /* He to Rn */

/* Bondi 1964. */
static const column metals[] = {{2, {28, 46}, {1.63, 1.63}},           /* Ni Pd */
                                {3, {29, 47, 79}, {1.40, 1.72, 1.66}}, /* Cu Ag Au */
                                {3, {30, 48, 80}, {1.39, 1.58, 1.55}}, /* Zn Cd Hg */
                                {1, {92}, {1.86}}};                    /* U */

/* C, Ca, H, N, O, P, S in Section 2 of Halperin and Overmars. */
static const column of_paper = {7, {6, 20, 1, 7, 8, 15, 16}, {1.52, 3.48, 0.70, 1.36, 1.28, 2.18, 2.10}};

/* sigma of UFF in thousandths of an angstrom, by atomic number: x_I / 2^(1/6) of Table 1 of Rappe et al. 1992, in
 * decimals with 40 digits, rounded. Those of H, C, O, V, Cu and Zn are as published with PoreBlazer. */
static const uint16_t sigma[] = {
    0,    2571, 2104, 2184, 2446, 3638, 3431, 3261, 3118, 2997, 2889, 2658, 2691, 4008, 3826, 3695, 3595, 3516,
    3446, 3396, 3028, 2936, 2829, 2801, 2693, 2638, 2594, 2559, 2525, 3114, 2462, 3905, 3813, 3769, 3746, 3732,
    3689, 3665, 3244, 2980, 2783, 2820, 2719, 2671, 2640, 2609, 2583, 2805, 2537, 3976, 3913, 3938, 3982, 4009,
    3924, 4024, 3299, 3138, 3168, 3213, 3185, 3160, 3136, 3112, 3001, 3074, 3054, 3037, 3021, 3006, 2989, 3243,
    2798, 2824, 2734, 2632, 2780, 2530, 2454, 2934, 2410, 3873, 3828, 3893, 4195, 4232, 4245, 4365, 3276, 3099,
    3025, 3050, 3025, 3050, 3050, 3012, 2963, 2975, 2952, 2939, 2927, 2917, 2894, 2883};

/* By atomic number; 0 where nothing is published. */
static double bondi[ELEMENTS + 1], chem3d[ELEMENTS + 1];

static void enter(double *radius, const column *columns, size_t count) {
  size_t i;
  uint32_t k;
  for (i = 0; i < count; ++i) {
    for (k = 0; k < columns[i].count; ++k) {
      CHECK(radius[columns[i].number[k]] == 0);
      radius[columns[i].number[k]] = columns[i].radius[k];
    }
  }
}

static uint32_t entered(const double *radius) {
  uint32_t number, count = 0;
  for (number = 0; number <= ELEMENTS; ++number) count += radius[number] != 0;
  return count;
}

/* The same number, bit for bit, with and without a place for the flags. */
static void check_radius(uint32_t set, uint32_t number, double expected, uint32_t expected_flags) {
  double radius, alone;
  uint32_t flags;
  FILL(radius);
  FILL(alone);
  FILL(flags);
  check_scene("set %u, element %u", (unsigned)set, (unsigned)number);
  CHECK_EQUAL(hsp_element_radius(set, number, &radius, &flags), HSP_OK);
  CHECK_BYTES(&radius, &expected, sizeof radius);
  CHECK_EQUAL(flags, expected_flags);
  CHECK_EQUAL(hsp_element_radius(set, number, &alone, NULL), HSP_OK);
  CHECK_BYTES(&alone, &expected, sizeof alone);
}

static void every_element(void) {
  uint32_t number;
  for (number = 1; number <= ELEMENTS; ++number) {
    const double substitute = bondi[number] != 0 ? bondi[number] : 2.00;
    check_radius(HSP_RADII_BONDI, number, substitute, bondi[number] != 0 ? 0 : HSP_RADIUS_FALLBACK);
    if (chem3d[number] != 0) {
      check_radius(HSP_RADII_CHEM3D, number, chem3d[number], 0);
    } else {
      check_radius(HSP_RADII_CHEM3D, number, substitute, HSP_RADIUS_FALLBACK);
    }
    if (number < sizeof sigma / sizeof sigma[0]) {
      check_radius(HSP_RADII_UFF, number, sigma[number] / 2000.0, 0);
    } else {
      check_radius(HSP_RADII_UFF, number, substitute, HSP_RADIUS_FALLBACK);
    }
  }
}

static void check_refused(uint32_t set, uint32_t number, int32_t expected) {
  double radius;
  uint32_t flags;
  FILL(radius);
  FILL(flags);
  check_scene("set %u, number %u", (unsigned)set, (unsigned)number);
  CHECK_EQUAL(hsp_element_radius(set, number, &radius, &flags), expected);
  CHECK_EQUAL(hsp_element_radius(set, number, &radius, NULL), expected);
  CHECK_UNTOUCHED(radius);
  CHECK_EQUAL(hsp_element_radius(set, number, NULL, &flags), HSP_E_ARGUMENT);
  CHECK_UNTOUCHED(flags);
}

static void refusals(void) {
  static const uint32_t no_element[] = {0, ELEMENTS + 1, 255, 256 + 6, 65536 + 6, HSP_NONE};
  static const uint32_t no_set[] = {HSP_RADII_CHEM3D + 1, HSP_RADII_UFF - 1, HSP_RADII_UFF + 1, 256, 65536, HSP_NONE};
  uint32_t flags;
  size_t i;
  for (i = 0; i < sizeof no_element / sizeof no_element[0]; ++i) {
    check_refused(HSP_RADII_BONDI, no_element[i], HSP_E_ID);
    check_refused(HSP_RADII_CHEM3D, no_element[i], HSP_E_ID);
    check_refused(HSP_RADII_UFF, no_element[i], HSP_E_ID);
  }
  for (i = 0; i < sizeof no_set / sizeof no_set[0]; ++i) {
    check_refused(no_set[i], 6, HSP_E_ARGUMENT);
    check_refused(no_set[i], 0, HSP_E_ARGUMENT);
  }
  check_scene("nowhere to put the radius");
  FILL(flags);
  CHECK_EQUAL(hsp_element_radius(HSP_RADII_BONDI, 6, NULL, &flags), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_element_radius(HSP_RADII_CHEM3D, 26, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_UNTOUCHED(flags);
}

int main(void) {
  enter(bondi, main_group, sizeof main_group / sizeof main_group[0]);
  enter(bondi, metals, sizeof metals / sizeof metals[0]);
  enter(chem3d, &of_paper, 1);
  CHECK_EQUAL(entered(bondi), 44 + 9);
  CHECK_EQUAL(entered(chem3d), 7);
  every_element();
  refusals();
  return check_report();
}
