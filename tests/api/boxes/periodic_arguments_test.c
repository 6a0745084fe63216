/* Periodic boxes: arguments that tests/laws says nothing about, every call out of order, limits that are too small,
 * closed forms of a few balls, queries against all images, and the laws that tie the outputs together. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "untouched.h"

enum { BALLS = 4, IMAGES = 200, NEIGHBOURS = 40, VERTICES = 2000, CIRCLES = 400, CONTACTS = 1500, OUT = 200 };
static unsigned char memory[HSP_PERIODIC_BYTES(BALLS, IMAGES, NEIGHBOURS, VERTICES, CIRCLES, CONTACTS)];
static hsp_periodic *periodic;
static const double pi = 3.14159265358979323846;

/* A broken rod along a, a ball on its own beside it, and a skew box. */
static const double xyz[3 * BALLS] = {0, 0, 0, 14, 0, 0, -4, 4.5, 8, 1.5, -3, 2};
static const double radius[BALLS] = {1.25, 1.25, 1, 0.75};
static const double small[9] = {2.5, 0, 0, 1, 3, 0, -0.75, 1.25, 2.75};
static const double box[9] = {4, 0, 0, 1.25, 6.5, 0, -1.5, 0.75, 8};

static hsp_periodic_counts counts;
static hsp_periodic_totals totals;
static hsp_periodic_contact contact[OUT];
static hsp_winding winding[BALLS];
static hsp_image image[OUT];
static hsp_periodic_circle circle[OUT];
static hsp_periodic_face face[OUT];
static hsp_periodic_loop loop[OUT];
static hsp_ball ball[BALLS];
static hsp_energy energy;
static hsp_morphometric_energy morphometric;
static const hsp_morphometry_request factors = {
    .struct_size = sizeof factors, .pressure = 0.5, .tension = 1.5, .bending = -2, .gaussian = 0.25};
static hsp_group_contact between[OUT];
static double area[BALLS], cell[BALLS], mean[BALLS], centre[BALLS][3], by_radius[BALLS], strain[9], by_box[9];
static hsp_curvatures curvatures;
static int32_t thirds[BALLS];
static uint32_t component[BALLS], flags[BALLS], begins[BALLS + 1], number, invariant, id;

static hsp_periodic_limits good_limits(void) {
  const hsp_periodic_limits limits = {
      (uint32_t)sizeof limits, BALLS, IMAGES, NEIGHBOURS, VERTICES, CIRCLES, CONTACTS, 0};
  return limits;
}

static void make(void) {
  const hsp_periodic_limits limits = good_limits();
  CHECK_EQUAL(hsp_periodic_init(memory, sizeof memory, &limits, &periodic), HSP_OK);
}

static void compute(uint32_t n, const double *at, const double *radii, const double *vectors) {
  uint32_t bad = 0;
  CHECK_EQUAL(hsp_periodic_compute(periodic, n, at, radii, vectors, NULL, NULL, &bad), HSP_OK);
  CHECK_EQUAL(bad, HSP_NONE);
  CHECK_EQUAL(hsp_periodic_check(periodic, &invariant, &id), HSP_OK);
  CHECK_EQUAL(invariant, 0);
  CHECK_EQUAL(hsp_periodic_get_counts(periodic, &counts), HSP_OK);
  CHECK_EQUAL(hsp_periodic_measure(periodic, &totals, area, cell, BALLS, &number), HSP_OK);
  CHECK_EQUAL(number, n);
  CHECK_EQUAL(hsp_periodic_curvature(periodic, &curvatures, mean, thirds, BALLS, &number), HSP_OK);
  CHECK_EQUAL(number, n);
  CHECK_NEAR(curvatures.gauss, 2 * pi * (double)counts.euler, 1e-12);
}

static void default_limits(void) {
  hsp_periodic_limits limits = good_limits();
  size_t bytes;
  limits.images = HSP_MAX_BALLS - BALLS + 1; /* together more than HSP_MAX_BALLS */
  CHECK_EQUAL(hsp_periodic_bytes(&limits, &bytes), HSP_E_RANGE);
  CHECK_EQUAL(hsp_periodic_limits_init(&limits, (uint32_t)sizeof limits, (HSP_MAX_BALLS - 2048) / 36 + 1), HSP_E_RANGE);
  CHECK_EQUAL(hsp_periodic_limits_init(&limits, (uint32_t)sizeof limits, (HSP_MAX_BALLS - 2048) / 36), HSP_OK);
  CHECK(limits.contacts <= HSP_MAX_BALLS && limits.balls + limits.images <= HSP_MAX_BALLS);
  CHECK_EQUAL(hsp_periodic_limits_init(&limits, (uint32_t)sizeof limits, 10), HSP_OK);
  CHECK(limits.balls == 10 && limits.images == 148 && limits.neighbours == 256 && limits.vertices == 8 * 158 + 64);
  CHECK(limits.circles == 2 * 158 + 16 && limits.contacts == 12 * 158 + 64);
}

/* Limits of which one or two are large: the bound for static arrays holds of each of them, up to some millions. */
static void bounded_bytes(void) {
  uint32_t first, second, many;
  for (many = 1; many < 6000000; many += many / 16 + 1) {
    for (first = 1; first < 7; ++first) {
      for (second = first; second < 7; ++second) {
        uint32_t words[8] = {sizeof words, 0, 0, 0, 0, 0, 0, 0};
        hsp_periodic_limits limits;
        size_t bytes = 0;
        words[first] = words[second] = many;
        memcpy(&limits, words, sizeof limits);
        CHECK_EQUAL(hsp_periodic_bytes(&limits, &bytes), HSP_OK);
        CHECK(bytes <= HSP_PERIODIC_BYTES(limits.balls, limits.images, limits.neighbours, limits.vertices,
                                          limits.circles, limits.contacts));
      }
    }
  }
}

static void check_unread(const hsp_periodic *handle, int32_t status) {
  CHECK_EQUAL(hsp_periodic_get_counts(handle, &counts), status);
}

static void refused_reading(void) {
  const double boxes_away[3] = {0, 0, 8e6};
  make();
  compute(BALLS, xyz, radius, box);
  CHECK_EQUAL(hsp_periodic_measure(periodic, NULL, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_periodic_curvature(periodic, NULL, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_periodic_get_contacts(periodic, NULL, 0, &number), HSP_E_CAPACITY);
  CHECK_EQUAL(number, counts.contacts);
  CHECK_EQUAL(hsp_periodic_get_windings(periodic, NULL, 0, &number), HSP_E_CAPACITY);
  CHECK_EQUAL(number, counts.components);
  CHECK_EQUAL(hsp_periodic_get_gradient(periodic, SIZED(hsp_gradient_request, .tension = 1, .tangency = 2),
                                        SIZED(hsp_periodic_gradient_outputs, .capacity = 0)),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_periodic_query_point(periodic, xyz, NULL, 0, &number), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_periodic_query_point(periodic, boxes_away, image, OUT, &number), HSP_E_RANGE);
  CHECK_EQUAL(hsp_periodic_query_ball(periodic, xyz, 1, NULL, 0, &number), HSP_E_CAPACITY);
  CHECK_EQUAL(hsp_periodic_query_ball(periodic, boxes_away, 1, image, OUT, &number), HSP_E_RANGE);
  CHECK_EQUAL(hsp_periodic_query_ball(periodic, xyz, 256.1, image, OUT, &number), HSP_E_RANGE);
  CHECK_EQUAL(hsp_periodic_query_pairs(periodic, 2, begins, image, OUT, &number), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_periodic_query_pairs(periodic, 0, begins, NULL, 0, &number), HSP_E_CAPACITY);
  CHECK(number == 4 && begins[0] == 0 && begins[1] == 2 && begins[2] == 4 && begins[BALLS] == 4);
}

/* The rod along a: two circles, between a ball and two images of the other one. */
static void known_records(void) {
  uint32_t k;
  make();
  compute(BALLS, xyz, radius, box);
  CHECK_EQUAL(hsp_periodic_get_vertices(periodic, NULL, 0, &number), HSP_OK);
  CHECK_EQUAL(number, 0);
  CHECK_EQUAL(hsp_periodic_get_loop_arcs(periodic, NULL, 0, &number), HSP_OK);
  CHECK_EQUAL(number, 0);
  CHECK_EQUAL(hsp_periodic_get_balls(periodic, ball, BALLS, &number), HSP_OK);
  CHECK_EQUAL(number, BALLS);
  CHECK_EQUAL(hsp_periodic_get_faces(periodic, face, OUT, &number), HSP_OK);
  CHECK_EQUAL(number, 4);
  for (k = 0; k < BALLS; ++k) {
    const uint32_t f = ball[k].first_face;
    CHECK(ball[k].faces == 1 && ball[k].flags == 0 && face[f].image.ball == k && face[f].reserved == 0);
    CHECK_EQUAL(ball[k].component, k < 2 ? 0 : k - 1);
    CHECK_EQUAL(face[f].loops, k < 2 ? 2 : 0);
  }
  /* Ball 0 is at its place, 0 0 0; ball 1, given at 14 0 0, has its own at 2 0 0, three boxes back. */
  CHECK(face[ball[0].first_face].image.shift[0] == 0 && face[ball[1].first_face].image.shift[0] == -3);
  CHECK_EQUAL(face[ball[0].first_face].shell, face[ball[1].first_face].shell);
  CHECK_EQUAL(hsp_periodic_get_circles(periodic, circle, OUT, &number), HSP_OK);
  CHECK_EQUAL(number, 2);
  for (k = 0; k < 2; ++k) {
    const int right = circle[k].centre[0] > 0;
    CHECK(circle[k].image[0].ball == 0 && circle[k].image[0].shift[0] == 0 && circle[k].image[1].ball == 1);
    CHECK_EQUAL(circle[k].image[1].shift[0], right ? -3 : -4);
    CHECK_NEAR(circle[k].centre[0], right ? 1 : -1, 1e-15);
    CHECK_NEAR(circle[k].axis[0], right ? 1 : -1, 1e-15);
    CHECK_NEAR(circle[k].radius, 0.75, 1e-15);
    CHECK(circle[k].face[0].id == ball[0].first_face && circle[k].face[0].shift[0] == 0);
    CHECK(circle[k].face[1].id == ball[1].first_face && circle[k].face[1].shift[0] == (right ? 0 : -1));
  }
  CHECK(circle[0].centre[0] != circle[1].centre[0]);
  CHECK_EQUAL(hsp_periodic_get_loops(periodic, loop, OUT, &number), HSP_OK);
  CHECK_EQUAL(number, 4);
  for (k = 0; k < number; ++k) {
    const hsp_periodic_circle *const c = &circle[loop[k].circle.id];
    const int right = c->centre[0] > 0, own = loop[k].face == ball[0].first_face;
    CHECK(loop[k].arcs == 0 && loop[k].first_arc == 0 && loop[k].side == (own ? 0U : 1U));
    CHECK_EQUAL(loop[k].circle.shift[0], own || right ? 0 : 1);
    CHECK(loop[k].circle.shift[1] == 0 && loop[k].circle.shift[2] == 0);
  }
}

static void check_refused(uint32_t n, const double *at, const double *radii, const hsp_model_options *options,
                          const double *vectors, int32_t status, uint32_t first) {
  uint32_t bad = 77;
  CHECK_EQUAL(hsp_periodic_compute(periodic, n, at, radii, vectors, options, NULL, &bad), status);
  CHECK_EQUAL(bad, first);
  CHECK_EQUAL(hsp_periodic_get_counts(periodic, &counts), HSP_E_STATE);
}

static void refused_input(void) {
  hsp_model_options options;
  static const double in_plane[9] = {4, 1, 2, -1, 5, 3, 3, 6, 5}, on_line[9] = {4, 1, 2, 8, 2, 4, 1, 1, 7};
  static const double enormous[9] = {1e308, 1e308, 1e308, -1e308, 1e308, 0, 0, 1e308, -1e308};
  static const double minute[9] = {5e-324, 5e-324, 0, 0, 5e-324, 0, 0, 0, 5e-324};
  static const double turned[9] = {2.5, 1, -1, 1, 3, 2, -0.75, 1.25, -2.75};
  double changed[9], moved[3 * BALLS], grown[BALLS];
  int k;
  make();
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.probe = -1;
  check_refused(BALLS, xyz, radius, &options, box, HSP_E_NEGATIVE, HSP_NONE);
  options.probe = 0;
  options.step = 1e-300;
  check_refused(BALLS, xyz, radius, &options, box, HSP_E_RANGE, HSP_NONE);
  options.step = 0;
  options.largest_radius = 1.1;
  check_refused(BALLS, xyz, radius, &options, box, HSP_E_RANGE, 0);
  for (k = 0; k < 9; ++k) {
    memcpy(changed, box, sizeof changed);
    changed[k] = k % 4 == 0 ? 0 : 1e6;
    check_refused(BALLS, xyz, radius, NULL, changed, HSP_E_RANGE, HSP_NONE);
    changed[k] = (double)INFINITY;
    check_refused(BALLS, xyz, radius, NULL, changed, HSP_E_NOT_FINITE, HSP_NONE);
  }
  check_refused(BALLS, xyz, radius, NULL, in_plane, HSP_E_RANGE, HSP_NONE);
  check_refused(BALLS, xyz, radius, NULL, on_line, HSP_E_RANGE, HSP_NONE);
  check_refused(BALLS, xyz, radius, NULL, enormous, HSP_E_RANGE, HSP_NONE);
  check_refused(BALLS, xyz, radius, NULL, minute, HSP_E_RANGE, HSP_NONE);
  memcpy(changed, box, sizeof changed);
  changed[8] = 0.01;
  check_refused(BALLS, xyz, radius, NULL, changed, HSP_E_RANGE, HSP_NONE);
  memcpy(moved, xyz, sizeof moved);
  moved[7] = (double)INFINITY;
  check_refused(BALLS, moved, radius, NULL, box, HSP_E_NOT_FINITE, 2);
  moved[7] = 2e6;
  check_refused(BALLS, moved, radius, NULL, box, HSP_E_RANGE, 2);
  memcpy(grown, radius, sizeof grown);
  grown[3] = -0.5;
  check_refused(BALLS, xyz, grown, NULL, box, HSP_E_NEGATIVE, 3);
  /* The same of balls that are turned, also where a number is too large once it is turned. */
  memcpy(moved, xyz, sizeof moved);
  moved[7] = (double)NAN;
  check_refused(BALLS, moved, radius, NULL, turned, HSP_E_NOT_FINITE, 2);
  moved[7] = 2e6;
  check_refused(BALLS, moved, radius, NULL, turned, HSP_E_RANGE, 2);
  moved[6] = moved[7] = moved[8] = 1.7e308;
  check_refused(BALLS, moved, radius, NULL, turned, HSP_E_RANGE, 2);
  compute(BALLS, xyz, radius, turned);
  CHECK_EQUAL(hsp_periodic_query_point(periodic, moved + 6, image, OUT, &number), HSP_E_RANGE);
  moved[8] = (double)INFINITY;
  CHECK_EQUAL(hsp_periodic_query_ball(periodic, moved + 6, 1, image, OUT, &number), HSP_E_NOT_FINITE);
  compute(BALLS, xyz, radius, box);
  compute(0, NULL, NULL, box);
  CHECK_EQUAL(counts.balls + counts.images + counts.faces + counts.components, 0);
  CHECK(totals.volume == 0 && totals.free_volume == totals.box_volume && totals.box_volume == 4 * 6.5 * 8);
  CHECK_EQUAL(hsp_periodic_query_ball(periodic, xyz, 9, NULL, 0, &number), HSP_OK);
  CHECK_EQUAL(number, 0);
  CHECK_EQUAL(hsp_periodic_query_pairs(periodic, 0, begins, NULL, 0, &number), HSP_OK);
  CHECK(number == 0 && begins[0] == 0);
}

/* Every limit too small, alone and all together; what comes back leads to the same results. */
static void too_little_room(void) {
  const hsp_periodic_limits good = good_limits();
  hsp_periodic_limits needed = good, limits;
  hsp_periodic_totals expected, same;
  int which, attempt;
  make();
  CHECK_EQUAL(hsp_periodic_compute(periodic, BALLS, xyz, radius, small, NULL, &needed, NULL), HSP_OK);
  CHECK_EQUAL(hsp_periodic_measure(periodic, &expected, NULL, NULL, 0, NULL), HSP_OK);
  CHECK(needed.vertices > 0 && needed.circles > 0 && needed.balls == BALLS && needed.images <= IMAGES &&
        needed.contacts <= CONTACTS);
  for (which = 0; which <= 13; ++which) {
    uint32_t words[7];
    int k;
    check_scene("limit %d", which);
    memcpy(words, &needed, sizeof words);
    for (k = 1; k < 7; ++k) {
      if (which == k) words[k] -= 1;
      if (which == 6 + k || which == 13) words[k] = 0;
    }
    limits = needed;
    memcpy(&limits, words, sizeof words);
    for (attempt = 0; attempt < 6; ++attempt) {
      const hsp_periodic_limits given = limits;
      uint32_t of_given[7], asked[7];
      int32_t status;
      int more = 0;
      CHECK_EQUAL(hsp_periodic_init(memory, sizeof memory, &given, &periodic), HSP_OK);
      status = hsp_periodic_compute(periodic, BALLS, xyz, radius, small, NULL, &limits, NULL);
      if (status == HSP_OK) break;
      CHECK_EQUAL(status, HSP_E_CAPACITY);
      check_unread(periodic, HSP_E_STATE);
      memcpy(of_given, &given, sizeof of_given);
      memcpy(asked, &limits, sizeof asked);
      for (k = 1; k < 7; ++k) {
        CHECK(asked[k] >= of_given[k]);
        more += asked[k] > of_given[k];
      }
      CHECK(more > 0);
    }
    CHECK(attempt < 6 && (attempt > 0) == (which > 0));
    CHECK_EQUAL(hsp_periodic_measure(periodic, &same, NULL, NULL, 0, NULL), HSP_OK);
    CHECK_BYTES(&same, &expected, sizeof same);
  }
  check_scene("limits");
}

/* A rod of balls along a: two contacts, no vertex, one direction; and two single balls. */
static void known_values(void) {
  static const double cube[9] = {4, 0, 0, 0, 4, 0, 0, 0, 4};
  static const double one[3] = {1, 2, 3}, large = 2.25, covering = 3.5, half = 2;
  uint32_t i;
  make();
  compute(BALLS, xyz, radius, box);
  CHECK(counts.balls == BALLS && counts.components == 3 && counts.contacts == 2 && counts.circles == 2);
  CHECK(counts.vertices == 0 && counts.arcs == 0 && counts.faces == 4 && counts.loops == 4 && counts.shells == 3);
  CHECK_EQUAL(counts.euler, 4);
  CHECK_NEAR(totals.area, 2 * 2 * pi * 1.25 * 2 + 4 * pi * (1 + 0.5625), 1e-12);
  CHECK_NEAR(totals.box_volume, 208, 1e-12);
  CHECK_NEAR(totals.volume, 15.44616388015 + 4 * pi / 3 * (1 + 0.421875), 1e-11);
  CHECK(totals.free_volume == totals.box_volume - totals.volume);
  CHECK_NEAR(totals.contact_area, 2 * pi * (1.5625 - 1), 1e-12);
  /* Of the rod the circles have radius 3/4, and the cosine of what the normals turn by is -7/25. */
  CHECK_NEAR(curvatures.mean, 15 * pi - 1.5 * pi * acos(-0.28), 1e-12);
  CHECK_NEAR(mean[0], 4 * pi - 0.75 * pi * acos(-0.28), 1e-13);
  CHECK(mean[0] == mean[1] && thirds[0] == 0 && thirds[1] == 0 && thirds[2] == 12 && thirds[3] == 12);
  CHECK_NEAR(mean[3], 3 * pi, 1e-13);
  CHECK_EQUAL(hsp_periodic_get_windings(periodic, winding, BALLS, &number), HSP_OK);
  CHECK_EQUAL(number, 3);
  CHECK(winding[0].balls == 2 && winding[0].first == 0 && winding[0].directions == 1 && winding[0].copies == 1);
  CHECK(winding[0].row[0] == 1 && winding[0].row[1] == 0 && winding[0].row[2] == 0 && winding[0].row[3] == 0);
  CHECK(winding[1].balls == 1 && winding[1].first == 2 && winding[1].directions == 0 && winding[1].copies == 1);
  CHECK(winding[2].balls == 1 && winding[2].first == 3 && winding[2].row[8] == 0);
  CHECK_EQUAL(hsp_periodic_get_components(periodic, component, BALLS, &number), HSP_OK);
  CHECK(component[0] == 0 && component[1] == 0 && component[2] == 1 && component[3] == 2);
  /* Ball 1 is at 14: three boxes behind it is beside ball 0 on the right, four on the left. */
  CHECK_EQUAL(hsp_periodic_get_contacts(periodic, contact, OUT, &number), HSP_OK);
  CHECK_EQUAL(number, 2);
  for (i = 0; i < 2; ++i) {
    CHECK(contact[i].ball[0] == 0 && contact[i].ball[1] == 1 && contact[i].chords == 0 && contact[i].reserved == 0);
    CHECK(contact[i].shift[0] == (int32_t)i - 4 && contact[i].shift[1] == 0 && contact[i].shift[2] == 0);
    CHECK_EQUAL(contact[i].flags, HSP_CONTACT_CIRCLE);
    CHECK_NEAR(contact[i].area, pi * 0.5625, 1e-12);
    CHECK_NEAR(contact[i].rim, 2 * pi * 0.75, 1e-12);
    CHECK_NEAR(contact[i].distance, 2, 1e-15);
  }
  CHECK_EQUAL(hsp_periodic_query_neighbours(periodic, 1, image, OUT, &number), HSP_OK);
  CHECK(number == 2 && image[0].ball == 0 && image[0].shift[0] == 3 && image[1].shift[0] == 4);

  /* One ball that meets six images of itself. */
  compute(1, one, &large, cube);
  CHECK(counts.contacts == 3 && counts.circles == 3 && counts.euler == -4 && counts.components == 1);
  CHECK_NEAR(totals.volume, 45.160394395353, 1e-11);
  CHECK_EQUAL(thirds[0], -24);
  CHECK_NEAR(curvatures.mean, 42.411500823462 / 2.25 - 3 * pi * sqrt(1.0625) * acos(-2.9375 / 5.0625), 1e-11);
  CHECK_EQUAL(hsp_periodic_get_windings(periodic, winding, BALLS, &number), HSP_OK);
  CHECK(winding[0].directions == 3 && winding[0].row[0] == 1 && winding[0].row[4] == 1 && winding[0].row[8] == 1);
  CHECK_EQUAL(hsp_periodic_get_contacts(periodic, contact, OUT, &number), HSP_OK);
  CHECK(number == 3 && contact[0].shift[2] == 1 && contact[1].shift[1] == 1 && contact[2].shift[0] == 1);
  CHECK_EQUAL(hsp_periodic_get_gradient(
                  periodic, SIZED(hsp_gradient_request, .pressure = 1),
                  SIZED(hsp_periodic_gradient_outputs, .energy = &energy, .d_centre = centre[0], .d_radius = by_radius,
                        .flags = flags, .d_strain = strain, .d_box = by_box, .capacity = BALLS)),
              HSP_OK);
  for (i = 0; i < 9; ++i) {
    CHECK_NEAR(strain[i], i % 4 == 0 ? 13.351768777757 : 0, 1e-11);
    CHECK_NEAR(by_box[i], i % 4 == 0 ? 13.351768777757 / 4 : 0, 1e-11);
  }
  CHECK_NEAR(energy.volume, 45.160394395353, 1e-11);
  CHECK_NEAR(by_radius[0], 42.411500823462, 1e-11);
  CHECK_NEAR(energy.d_probe, 42.411500823462, 1e-11);
  CHECK_NEAR(fabs(centre[0][0]) + fabs(centre[0][1]) + fabs(centre[0][2]), 0, 1e-11);
  CHECK_EQUAL(flags[0], 0);

  /* One that touches six of them, and one that leaves nothing free. */
  compute(1, one, &half, cube);
  CHECK(counts.contacts == 3 && totals.contact_area == 0);
  CHECK_NEAR(totals.area, 16 * pi, 1e-12);
  CHECK_EQUAL(hsp_periodic_get_gradient(
                  periodic, SIZED(hsp_gradient_request, .tension = 1, .tangency = HSP_TANGENT_DISJOINT),
                  SIZED(hsp_periodic_gradient_outputs, .d_radius = by_radius, .flags = flags, .capacity = 1)),
              HSP_OK);
  CHECK_EQUAL(flags[0], HSP_GRADIENT_ONE_SIDED);
  CHECK_NEAR(by_radius[0], 16 * pi, 1e-12);
  compute(1, one, &covering, cube);
  CHECK(counts.faces == 0 && counts.shells == 0 && totals.area == 0);
  CHECK(totals.volume == 64 && totals.free_volume == 0);
}

/* The rod again, stretched and grown; and balls that touch across a face. */
static void known_energies(void) {
  static const double cube[9] = {4, 0, 0, 0, 4, 0, 0, 0, 4};
  static const double in_pairs[6] = {0.5, 1, 1, 3.75, 5, 1}, equal_balls[2] = {1, 1}, one_inside[2] = {1, 0.25};
  static const double twice[6] = {0.5, 1, 1, 4.5, 5, 1};
  static const uint32_t rod_and_rest[BALLS] = {HSP_NONE, 4, 4, 2}, halves[BALLS] = {9, 4, 9, 9};
  static const hsp_morphometry_request bending = {.struct_size = sizeof bending, .bending = 1};
  double own[BALLS];
  hsp_periodic_morphometry_outputs all = {.struct_size = sizeof all,
                                          .capacity = BALLS,
                                          .energy = &morphometric,
                                          .d_centre = centre[0],
                                          .d_radius = by_radius,
                                          .flags = flags,
                                          .d_strain = strain,
                                          .d_box = by_box,
                                          .area = own};
  const double beta = acos(-0.28);
  uint32_t i;
  make();
  compute(BALLS, xyz, radius, box);
  CHECK_EQUAL(hsp_periodic_get_morphometry(periodic, &factors, &all), HSP_OK);
  CHECK_EQUAL(all.needed, BALLS);
  CHECK_NEAR(morphometric.volume, totals.volume, 1e-12);
  CHECK_NEAR(morphometric.area, totals.area, 1e-12);
  CHECK(area[0] > 0 && memcmp(own, area, sizeof area) == 0);
  CHECK_NEAR(morphometric.mean, curvatures.mean, 1e-12);
  CHECK(morphometric.gauss == curvatures.gauss);
  CHECK_NEAR(morphometric.value,
             0.5 * totals.volume + 1.5 * totals.area - 2 * curvatures.mean + 0.25 * curvatures.gauss, 1e-12);
  CHECK_NEAR(morphometric.d_probe, by_radius[0] + by_radius[1] + by_radius[2] + by_radius[3], 1e-12);
  /* With d = 2 between its balls M is 4 pi d - 2 pi rho beta, where rho = 3/4 falls by 2/3 as d grows by 1, and beta
   * grows by 4/3. */
  CHECK_EQUAL(
      hsp_periodic_get_morphometry(periodic, &bending,
                                   SIZED(hsp_periodic_morphometry_outputs, .d_radius = by_radius, .flags = flags,
                                         .d_strain = strain, .d_box = by_box, .capacity = BALLS)),
      HSP_OK);
  CHECK_NEAR(curvatures.mean, 15 * pi - 1.5 * pi * beta, 1e-12);
  CHECK_NEAR(strain[0], 4 * pi + 8 * pi / 3 * beta, 1e-12);
  CHECK_NEAR(strain[0] + 2.5 * by_radius[0], 8 * pi - 1.5 * pi * beta, 1e-12);
  CHECK_NEAR(by_box[0], strain[0] / 4, 1e-13);
  for (i = 1; i < 9; ++i) CHECK_NEAR(strain[i], 0, 1e-12);
  for (i = 0; i < BALLS; ++i) CHECK_EQUAL(flags[i], 0);
  CHECK_NEAR(by_radius[2], 4 * pi, 1e-12);

  /* Both contacts are of the two balls of the rod. */
  CHECK_EQUAL(hsp_periodic_group_contacts(periodic, halves, between, OUT, &number), HSP_OK);
  CHECK(number == 1 && between[0].group[0] == 4 && between[0].group[1] == 9 && between[0].contacts == 2);
  CHECK_NEAR(between[0].area, totals.contact_area, 1e-13);
  CHECK_NEAR(between[0].rim, 3 * pi, 1e-12);
  CHECK_EQUAL(between[0].reserved, 0);
  CHECK_EQUAL(hsp_periodic_group_contacts(periodic, rod_and_rest, between, OUT, &number), HSP_OK);
  CHECK_EQUAL(number, 0);

  /* A small ball that touches a large one from inside, and one twice. */
  for (i = 0; i < 2; ++i) {
    compute(2, i == 0 ? in_pairs : twice, i == 0 ? one_inside : equal_balls, cube);
    FILL(flags);
    CHECK_EQUAL(hsp_periodic_get_morphometry(periodic, &factors,
                                             SIZED(hsp_periodic_morphometry_outputs, .flags = flags, .capacity = 2)),
                HSP_OK);
    CHECK(flags[0] == HSP_CURVATURE_ONE_SIDED && flags[1] == HSP_CURVATURE_ONE_SIDED);
    CHECK_EQUAL(hsp_periodic_get_gradient(periodic, SIZED(hsp_gradient_request, .tension = 1),
                                          SIZED(hsp_periodic_gradient_outputs, .flags = flags, .capacity = 2)),
                HSP_OK);
    CHECK(flags[0] == HSP_GRADIENT_ONE_SIDED && flags[1] == HSP_GRADIENT_ONE_SIDED);
  }
}

/* Queries against all images within five boxes, in lengths that doubles hold exactly. */
static void known_queries(void) {
  uint32_t point, i, k;
  make();
  compute(BALLS, xyz, radius, box);
  for (point = 0; point < 60; ++point) {
    const double at[3] = {0.25 * (point % 7) - 3, 0.5 * (point % 11) - 1, 0.75 * (point % 13)};
    uint32_t found = 0;
    CHECK_EQUAL(hsp_periodic_query_point(periodic, at, image, OUT, &number), HSP_OK);
    for (i = 0; i < BALLS; ++i) {
      int32_t a, b, c;
      for (a = -9; a <= 9; ++a) {
        for (b = -5; b <= 5; ++b) {
          for (c = -5; c <= 5; ++c) {
            const double x = xyz[3 * i] + a * box[0] + b * box[3] + c * box[6] - at[0];
            const double y = xyz[3 * i + 1] + b * box[4] + c * box[7] - at[1];
            const double z = xyz[3 * i + 2] + c * box[8] - at[2];
            if (x * x + y * y + z * z > radius[i] * radius[i]) continue;
            CHECK(found < number && image[found].ball == i);
            CHECK(image[found].shift[0] == a && image[found].shift[1] == b && image[found].shift[2] == c);
            ++found;
          }
        }
      }
    }
    CHECK_EQUAL(found, number);
  }
  /* A ball that meets another one is met by it, from the other side. */
  for (i = 0; i < BALLS; ++i) {
    static hsp_image back[OUT];
    uint32_t n, m, there;
    CHECK_EQUAL(hsp_periodic_query_neighbours(periodic, i, image, OUT, &n), HSP_OK);
    for (k = 0; k < n; ++k) {
      int found = 0;
      CHECK_EQUAL(hsp_periodic_query_neighbours(periodic, image[k].ball, back, OUT, &m), HSP_OK);
      for (there = 0; there < m; ++there) {
        found += back[there].ball == i && back[there].shift[0] == -image[k].shift[0] &&
                 back[there].shift[1] == -image[k].shift[1] && back[there].shift[2] == -image[k].shift[2];
      }
      CHECK_EQUAL(found, 1);
    }
  }
}

/* Sums and scaling (hsp_periodic_get_gradient, Properties 1 and 2), of contacts and of cells. */
static void laws(void) {
  double sum[3] = {0, 0, 0}, cells = 0, by_radii, tripled;
  uint32_t i, pass, k;
  make();
  compute(BALLS, xyz, radius, small);
  CHECK(counts.vertices > 0 && counts.contacts > BALLS);
  CHECK_EQUAL(counts.euler,
              (int32_t)counts.vertices - (int32_t)counts.arcs + 2 * (int32_t)counts.faces - (int32_t)counts.loops);
  CHECK_EQUAL(hsp_periodic_get_contacts(periodic, contact, OUT, &number), HSP_OK);
  tripled = 0;
  for (k = 0; k < number; ++k) tripled += contact[k].distance * contact[k].area;
  for (i = 0; i < BALLS; ++i) {
    cells += cell[i];
    tripled += radius[i] * area[i];
  }
  CHECK_NEAR(cells, totals.volume, 1e-12);
  CHECK_NEAR(tripled, 3 * totals.volume, 1e-11);
  for (pass = 0; pass < 2; ++pass) {
    CHECK_EQUAL(hsp_periodic_get_gradient(periodic, SIZED(hsp_gradient_request, .tension = pass == 0, .pressure = pass),
                                          SIZED(hsp_periodic_gradient_outputs, .energy = &energy, .d_centre = centre[0],
                                                .d_radius = by_radius, .d_strain = strain, .capacity = BALLS)),
                HSP_OK);
    by_radii = 0;
    for (i = 0; i < BALLS; ++i) {
      for (k = 0; k < 3; ++k) sum[k] += centre[i][k];
      by_radii += radius[i] * by_radius[i];
    }
    for (k = 0; k < 3; ++k) CHECK_NEAR(sum[k], 0, 1e-12);
    CHECK_NEAR(strain[0] + strain[4] + strain[8] + by_radii, pass == 0 ? 2 * totals.area : 3 * totals.volume, 1e-10);
    CHECK_NEAR(energy.value, pass == 0 ? totals.area : totals.volume, 1e-12);
  }
}

int main(void) {
  default_limits();
  bounded_bytes();
  refused_reading();
  refused_input();
  too_little_room();
  known_values();
  known_records();
  known_energies();
  known_queries();
  laws();
  return check_report();
}
