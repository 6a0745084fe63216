/* Contacts and curvature: calls out of order, limits that are too small, and closed forms of a few balls. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "untouched.h"

enum { BALLS = 5, NEIGHBOURS = 5, CONTACTS = 12, SIMPLICES = 8 };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(BALLS, NEIGHBOURS, 40, 20)];
static unsigned char contacts_memory[HSP_CONTACTS_BYTES(BALLS, NEIGHBOURS, CONTACTS, SIMPLICES, SIMPLICES)];
static hsp_model *model;
static hsp_boundary *boundary;
static hsp_contacts *contacts;
static const double pi = 3.14159265358979323846;

/* Four balls with one tetrahedron, and one apart that touches the second. */
static const double xyz[3 * BALLS] = {0, 0, 0, 1, 0, 0, 0.3, 0.9, 0, 0.2, 0.4, 0.8, 3, 0, 0};
static const double radius[BALLS] = {1, 1, 1, 1.1, 1};
static const uint32_t group[BALLS] = {7, 7, 3, HSP_NONE, 3};

static hsp_contacts_limits good_limits(void) {
  const hsp_contacts_limits limits = {(uint32_t)sizeof limits, BALLS, NEIGHBOURS, CONTACTS, SIMPLICES, SIMPLICES};
  return limits;
}

static void make(void) {
  const hsp_boundary_limits of_boundary = {(uint32_t)sizeof of_boundary, BALLS, NEIGHBOURS, 40, 20, 0};
  const hsp_contacts_limits of_contacts = good_limits();
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &of_boundary, &boundary), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_contacts_init(contacts_memory, sizeof contacts_memory, &of_contacts, &contacts), HSP_OK);
}

static void default_limits(void) {
  hsp_contacts_limits limits;
  CHECK_EQUAL(hsp_contacts_limits_init(&limits, (uint32_t)sizeof limits, boundary), HSP_OK);
  CHECK(limits.balls == BALLS && limits.contacts == 12 * BALLS + 64 && limits.triangles == 0 && limits.tetrahedra == 0);
}

static void check_reading(hsp_contacts *which, int32_t status) {
  hsp_contact contact;
  uint32_t needed;
  CHECK_EQUAL(hsp_contacts_get_pairs(which, &contact, 1, &needed), status);
}

static void check_has_results(void) {
  CHECK_EQUAL(hsp_contacts_compute(contacts, boundary, NULL), HSP_OK);
}

static void computing(void) {
  hsp_contacts_limits asked = good_limits();
  check_has_results();
  CHECK_EQUAL(hsp_boundary_compute(boundary, NULL, NULL), HSP_E_ARGUMENT);
  check_reading(contacts, HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_contacts_measure(contacts, NULL, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, xyz, radius, NULL, NULL), HSP_OK);
  check_reading(contacts, HSP_E_STATE);
  asked = good_limits();
  CHECK_EQUAL(hsp_contacts_compute(contacts, boundary, &asked), HSP_E_STATE);
  CHECK_EQUAL(hsp_contacts_limits_init(&asked, (uint32_t)sizeof asked, boundary), HSP_E_STATE);
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, NULL, NULL), HSP_OK);
  asked = good_limits();
  CHECK_EQUAL(hsp_contacts_compute(contacts, boundary, &asked), HSP_OK);
  CHECK(asked.balls == BALLS && asked.neighbours == 4 && asked.contacts == 7);
  CHECK(asked.triangles == 4 && asked.tetrahedra == 1);
}

static void small_limits(void) {
  static const hsp_contacts_limits small[] = {
      {(uint32_t)sizeof small[0], BALLS - 1, NEIGHBOURS, CONTACTS, SIMPLICES, SIMPLICES},
      {(uint32_t)sizeof small[0], BALLS, 3, CONTACTS, SIMPLICES, SIMPLICES},
      {(uint32_t)sizeof small[0], BALLS, NEIGHBOURS, 6, SIMPLICES, SIMPLICES},
      {(uint32_t)sizeof small[0], BALLS, NEIGHBOURS, CONTACTS, 3, SIMPLICES},
      {(uint32_t)sizeof small[0], 0, 0, 0, 1, 1},
  };
  size_t which;
  for (which = 0; which < sizeof small / sizeof small[0]; ++which) {
    hsp_contacts_limits asked = small[which];
    int retries = 0;
    int32_t status;
    for (;; ++retries) {
      CHECK_EQUAL(hsp_contacts_init(contacts_memory, sizeof contacts_memory, &asked, &contacts), HSP_OK);
      status = hsp_contacts_compute(contacts, boundary, &asked);
      if (status != HSP_E_CAPACITY || retries == 3) break;
      check_reading(contacts, HSP_E_STATE);
    }
    CHECK_EQUAL(status, HSP_OK);
    CHECK(retries > 0);
    CHECK(asked.balls == BALLS && asked.neighbours == 4 && asked.contacts == 7);
    CHECK(asked.triangles == 4 && asked.tetrahedra == 1);
  }
}

static void reading(void) {
  static const double areas[7] = {1.29712472104, 1.11139153272, 1.63741130143, 0.999606692974, 1.17419466727, 0,
                                  1.70290930173};
  static const uint32_t pairs[7][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {1, 4}, {2, 3}};
  hsp_contact contact[CONTACTS], row[CONTACTS];
  hsp_group_contact sum[3];
  hsp_complex counts;
  hsp_simplex simplex[SIMPLICES];
  hsp_totals totals, of_boundary;
  double cell[BALLS], area[BALLS], own = 0;
  uint32_t needed = 0, k, in_rows = 0, invariant, id;
  hsp_contacts_limits limits = good_limits();
  CHECK_EQUAL(hsp_contacts_init(contacts_memory, sizeof contacts_memory, &limits, &contacts), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_contacts_get_pairs(contacts, NULL, 0, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, 7);
  CHECK_EQUAL(hsp_contacts_get_pairs(contacts, contact, 6, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_contacts_get_pairs(contacts, contact, 7, &needed), HSP_OK);
  for (k = 0; k < 7; ++k) {
    CHECK(contact[k].ball[0] == pairs[k][0] && contact[k].ball[1] == pairs[k][1]);
    CHECK_NEAR(contact[k].area, areas[k], 1e-11);
    CHECK(contact[k].reserved[0] == 0 && contact[k].reserved[1] == 0);
    CHECK_EQUAL(contact[k].flags, k == 5 ? HSP_CONTACT_TOUCHING | HSP_CONTACT_CIRCLE : 0);
    CHECK_EQUAL(contact[k].chords, k == 5 ? 0 : 2);
  }
  CHECK_NEAR(contact[0].distance, 1, 1e-15);
  CHECK_NEAR(contact[5].distance, 2, 1e-15);
  CHECK_EQUAL(hsp_contacts_get_row(contacts, BALLS, row, CONTACTS, &needed), HSP_E_ID);
  for (k = 0; k < BALLS; ++k) {
    uint32_t m;
    CHECK_EQUAL(hsp_contacts_get_row(contacts, k, row, CONTACTS, &needed), HSP_OK);
    in_rows += needed;
    for (m = 0; m < needed; ++m) {
      CHECK(row[m].ball[0] == k || row[m].ball[1] == k);
      CHECK(m == 0 || row[m - 1].ball[0] + row[m - 1].ball[1] < row[m].ball[0] + row[m].ball[1]);
    }
  }
  CHECK_EQUAL(in_rows, 14);
  CHECK_EQUAL(hsp_contacts_get_row(contacts, 4, row, CONTACTS, &needed), HSP_OK);
  CHECK_BYTES(&row[0], &contact[5], sizeof contact[5]);

  CHECK_EQUAL(hsp_contacts_measure(contacts, &totals, cell, area, BALLS - 1, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, BALLS);
  CHECK_EQUAL(hsp_contacts_measure(contacts, &totals, cell, area, BALLS, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, &of_boundary, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_NEAR(totals.area, 7.92263821715679, 2e-14);
  CHECK_NEAR(totals.volume, of_boundary.volume, 1e-13);
  CHECK_NEAR(cell[0], 2.40163561094021, 1e-14);
  CHECK_NEAR(cell[4], 4 * pi / 3, 1e-14);
  for (k = 0; k < BALLS; ++k) own += area[k];
  CHECK_NEAR(own, 2 * totals.area, 1e-13);
  CHECK_EQUAL(hsp_contacts_measure(contacts, &totals, NULL, NULL, 0, NULL), HSP_OK);

  CHECK_EQUAL(hsp_contacts_group(contacts, group, NULL, 0, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, 1);
  CHECK_EQUAL(hsp_contacts_group(contacts, group, sum, 3, &needed), HSP_OK);
  CHECK(sum[0].group[0] == 3 && sum[0].group[1] == 7 && sum[0].contacts == 3 && sum[0].reserved == 0);
  CHECK_NEAR(sum[0].area, areas[1] + areas[3], 1e-11);

  CHECK_EQUAL(hsp_contacts_get_complex(contacts, &counts), HSP_OK);
  CHECK(counts.regular[0] == 5 && counts.singular[1] == 1 && counts.regular[1] == 6 && counts.regular[2] == 4);
  CHECK(counts.interior[3] == 1 && counts.euler == 1);
  CHECK(counts.betti[0] == 1 && counts.betti[1] == 0 && counts.betti[2] == 0);
  CHECK_EQUAL(hsp_contacts_get_simplices(contacts, 1, simplex, SIMPLICES, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_contacts_get_simplices(contacts, 4, simplex, SIMPLICES, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_contacts_get_simplices(contacts, 2, simplex, 3, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, 4);
  CHECK_EQUAL(hsp_contacts_get_simplices(contacts, 2, simplex, SIMPLICES, &needed), HSP_OK);
  for (k = 0; k < 4; ++k) {
    CHECK(simplex[k].ball[0] < simplex[k].ball[1] && simplex[k].ball[1] < simplex[k].ball[2]);
    CHECK(simplex[k].ball[3] == HSP_NONE && simplex[k].kind == HSP_SIMPLEX_REGULAR && simplex[k].reserved == 0);
  }
  CHECK_EQUAL(hsp_contacts_get_simplices(contacts, 3, simplex, SIMPLICES, &needed), HSP_OK);
  CHECK(needed == 1 && simplex[0].ball[0] == 0 && simplex[0].ball[3] == 3 && simplex[0].kind == HSP_SIMPLEX_INTERIOR);
  CHECK_EQUAL(hsp_contacts_check(contacts, &invariant, &id), HSP_OK);
  CHECK(invariant == 0 && id == HSP_NONE);

  limits.triangles = limits.tetrahedra = 0;
  CHECK_EQUAL(hsp_contacts_init(contacts_memory, sizeof contacts_memory, &limits, &contacts), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_contacts_get_simplices(contacts, 2, simplex, SIMPLICES, &needed), HSP_E_STATE);
  CHECK_EQUAL(hsp_contacts_get_complex(contacts, &counts), HSP_OK);
  CHECK_EQUAL(counts.regular[2], 4);
}

#if HSP_HAS_CURVATURE
static void curvature(void) {
  hsp_curvatures totals;
  hsp_morphometry_request factors = {.struct_size = sizeof factors, .bending = 1};
  hsp_morphometric_energy energy;
  hsp_morphometry_outputs asked = {.struct_size = sizeof asked, .energy = &energy};
  double mean[BALLS], d_centre[3 * BALLS], d_radius[BALLS], sigma[BALLS] = {1, 1, 1, 1, 1}, sum = 0, moment = 0;
  double area[BALLS], measured[BALLS];
  int32_t thirds[BALLS], all = 0;
  uint32_t flags[BALLS], needed = 0, k;
  CHECK_EQUAL(hsp_boundary_curvature(boundary, &totals, mean, thirds, BALLS - 1, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, BALLS);
  CHECK_EQUAL(hsp_boundary_curvature(boundary, &totals, mean, thirds, BALLS, NULL), HSP_OK);
  CHECK_NEAR(totals.mean, 19.3887479300771 + 4 * pi, 1e-13);
  CHECK_NEAR(totals.gauss, 4 * pi, 1e-14);
  for (k = 0; k < BALLS; ++k) {
    sum += mean[k];
    all += thirds[k];
  }
  CHECK_NEAR(sum, totals.mean, 1e-13);
  CHECK_EQUAL(all, 12);
  CHECK_EQUAL(thirds[4], 6);

  asked.d_centre = d_centre;
  asked.capacity = 1;
  CHECK_EQUAL(hsp_boundary_get_morphometry(boundary, &factors, &asked), HSP_E_CAPACITY);
  CHECK_EQUAL(asked.needed, BALLS);
  asked.d_centre = NULL;
  asked.area = area;
  CHECK_EQUAL(hsp_boundary_get_morphometry(boundary, &factors, &asked), HSP_E_CAPACITY);
  sigma[2] = (double)NAN;
  factors.sigma = sigma;
  CHECK_EQUAL(hsp_boundary_get_morphometry(boundary, &factors, &asked), HSP_E_NOT_FINITE);
  CHECK_EQUAL(asked.first_bad, 2);
  factors.sigma = NULL;
  for (k = 0; k < 4; ++k) {
    double *const factor[4] = {&factors.pressure, &factors.tension, &factors.bending, &factors.gaussian};
    const double before = *factor[k];
    *factor[k] = (double)INFINITY;
    CHECK_EQUAL(hsp_boundary_get_morphometry(boundary, &factors, &asked), HSP_E_NOT_FINITE);
    *factor[k] = before;
  }
  asked.d_centre = d_centre;
  asked.d_radius = d_radius;
  asked.flags = flags;
  asked.capacity = BALLS;
  CHECK_EQUAL(hsp_boundary_get_morphometry(boundary, &factors, &asked), HSP_OK);
  CHECK_EQUAL(asked.first_bad, HSP_NONE);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, NULL, measured, NULL, BALLS, NULL), HSP_OK);
  CHECK(measured[0] > 0 && memcmp(area, measured, sizeof area) == 0);
  CHECK_NEAR(energy.value, totals.mean, 1e-13);
  CHECK_NEAR(energy.mean, totals.mean, 1e-13);
  CHECK_NEAR(energy.gauss, totals.gauss, 1e-14);
  for (k = 0; k < 3; ++k) {
    uint32_t i;
    sum = 0;
    for (i = 0; i < BALLS; ++i) sum += d_centre[3 * i + k];
    CHECK_NEAR(sum, 0, 1e-13);
  }
  sum = 0;
  for (k = 0; k < BALLS; ++k) {
    const double *c = xyz + 3 * k, *d = d_centre + 3 * k;
    moment += radius[k] * d_radius[k] + c[0] * d[0] + c[1] * d[1] + c[2] * d[2];
    sum += d_radius[k];
    CHECK_EQUAL(flags[k], k == 1 || k == 4 ? HSP_CURVATURE_ONE_SIDED : 0);
  }
  CHECK_NEAR(moment, energy.mean, 1e-12);
  CHECK_NEAR(sum, energy.d_probe, 1e-13);
  factors.pressure = 2;
  factors.tension = 3;
  factors.gaussian = 5;
  CHECK_EQUAL(hsp_boundary_get_morphometry(boundary, &factors, SIZED(hsp_morphometry_outputs, .energy = &energy)),
              HSP_OK);
  CHECK_NEAR(energy.value, 2 * energy.volume + 3 * energy.area + energy.mean + 5 * energy.gauss, 1e-12);
  CHECK_EQUAL(hsp_model_set(model, BALLS - 1, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_curvature(boundary, &totals, NULL, NULL, 0, NULL), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_get_morphometry(boundary, &factors, SIZED(hsp_morphometry_outputs, .energy = &energy)),
              HSP_E_STATE);
}
#endif

static void no_balls(void) {
  hsp_complex counts;
  uint32_t needed = 1;
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_contacts_get_pairs(contacts, NULL, 0, &needed), HSP_OK);
  CHECK_EQUAL(needed, 0);
  CHECK_EQUAL(hsp_contacts_get_complex(contacts, &counts), HSP_OK);
  CHECK(counts.euler == 0 && counts.betti[0] == 0 && counts.betti[1] == 0);
  CHECK_EQUAL(hsp_contacts_get_simplices(contacts, 2, NULL, 0, &needed), HSP_OK);
}

/* Two small balls at the surface of one that is 10^8 times as large, in steps of the lattice. The large one's plane
 * cuts the disk between them near its centre. */
static void beside_a_large_ball(void) {
  static const double centres[9] = {-6, 0, 0, 6, 0, 0, 0, 600000003, 799999996}, radii[3] = {10, 10, 999999999};
  const hsp_model_options steps = {.struct_size = (uint32_t)sizeof steps, .step = 1};
  const double length = sqrt(centres[7] * centres[7] + centres[8] * centres[8]); /* of its centre from 0 */
  /* length^2 - 10^18, and below 10^18 less the squared radius: integers that doubles hold. */
  const double of_centre = 3 * (2 * 6e8 + 3) - 4 * (2 * 8e8 - 4);
  const double from_origin = (of_centre + (2e9 - 1) + 64) / (2 * length);
  const double in_disk = sqrt(64 - from_origin * from_origin);
  const double area = 64 * (pi / 2 + asin(from_origin / 8)) + from_origin * in_disk;
  hsp_contact found[3];
  double share[3];
  uint32_t needed = 0;
  CHECK_EQUAL(hsp_model_set(model, 3, centres, radii, &steps, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_contacts_get_pairs(contacts, found, 3, &needed), HSP_OK);
  CHECK_EQUAL(needed, 3);
  CHECK(from_origin > -8 && from_origin < 8);
  CHECK_NEAR(found[0].area, area, 1e-14 * area);
  CHECK_EQUAL(hsp_contacts_measure(contacts, NULL, share, NULL, 3, &needed), HSP_OK);
  CHECK_NEAR(share[0], share[1], 1e-14 * share[0]);
}

int main(void) {
  make();
  default_limits();
  computing();
  small_limits();
  reading();
#if HSP_HAS_CURVATURE
  curvature();
#endif
  no_balls();
  beside_a_large_ball();
  return check_report();
}
