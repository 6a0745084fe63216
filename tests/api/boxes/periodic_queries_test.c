/* Queries in periodic boxes against all images, one by one: balls at a ball of any size, neighbours, and all pairs. All
 * lengths are quarters, so that what meets is decided exactly here, too. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "random_numbers.h"
#include "untouched.h"

enum { FEW = 6, MANY = 300, BALLS = 1200, MOST = 60000 };
static unsigned char memory[HSP_PERIODIC_BYTES(BALLS, 4000, 200, 9000, 4000, 9000)];
static hsp_periodic *periodic;
static hsp_image found[MOST], expected[MOST], rows[MOST];
static uint32_t found_count, expected_count, first[BALLS + 1];

typedef struct crystal {
  uint32_t n;
  double xyz[3 * BALLS], radius[BALLS], box[9];
} crystal;

static double quarters(uint64_t *random, int least, int most) {
  return 0.25 * (least + random_below(random, most - least + 1));
}

/* Balls far outside the box, skew and straight ones, and a box that is thinner than its balls. */
static void choose(uint64_t *random, int set, crystal *c) {
  const int thin = set % 4 == 3;
  uint32_t i;
  int k;
  memset(c, 0, sizeof *c);
  c->n = 1 + (uint32_t)random_below(random, FEW);
  for (k = 0; k < 3; ++k) c->box[4 * k] = thin ? quarters(random, 5, 8) : quarters(random, 16, 26);
  if (set % 2 == 1) {
    c->box[3] = quarters(random, -12, 12);
    c->box[6] = quarters(random, -12, 12);
    c->box[7] = quarters(random, -12, 12);
  }
  for (i = 0; i < c->n; ++i) {
    for (k = 0; k < 3; ++k) c->xyz[3 * i + (uint32_t)k] = quarters(random, -60, 60);
    c->radius[i] = quarters(random, thin ? 2 : 3, thin ? 8 : 9);
  }
}

/* Many small balls, so that a query ball that is larger than all of them goes by cubes; in a flat box it goes around
 * it, where cubes of images are, too. */
static void choose_many(uint64_t *random, int flat, crystal *c) {
  uint32_t i;
  memset(c, 0, sizeof *c);
  c->n = MANY;
  for (i = 0; i < 9; i += 4) c->box[i] = quarters(random, 60, 70);
  if (flat) c->box[8] = quarters(random, 8, 14);
  c->box[3] = quarters(random, -12, 12);
  c->box[7] = quarters(random, -12, 12);
  for (i = 0; i < 3 * c->n; ++i) c->xyz[i] = quarters(random, -60, 60);
  for (i = 0; i < c->n; ++i) c->radius[i] = quarters(random, 1, 3);
}

/* So many that the few large ones among them are no reason to look at all small ones around each small one. */
static void choose_colloid(uint64_t *random, crystal *c) {
  uint32_t i;
  memset(c, 0, sizeof *c);
  c->n = BALLS;
  for (i = 0; i < 9; i += 4) c->box[i] = quarters(random, 84, 90);
  c->box[3] = quarters(random, -12, 12);
  for (i = 0; i < 3 * c->n; ++i) c->xyz[i] = quarters(random, -120, 120);
  for (i = 0; i < c->n; ++i) c->radius[i] = i % 700 == 7 ? 4 : quarters(random, 1, 3);
}

static void compute(const crystal *c) {
  const hsp_periodic_limits limits = {(uint32_t)sizeof limits, BALLS, 4000, 200, 9000, 4000, 9000, 0};
  hsp_model_options options;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.step = 0.25;
  CHECK_EQUAL(hsp_periodic_init(memory, sizeof memory, &limits, &periodic), HSP_OK);
  CHECK_EQUAL(hsp_periodic_compute(periodic, c->n, c->xyz, c->radius, c->box, &options, NULL, NULL), HSP_OK);
}

static int shift_order(const hsp_image *p, const hsp_image *q) {
  int k;
  for (k = 0; k < 3; ++k) {
    if (p->shift[k] != q->shift[k]) return p->shift[k] < q->shift[k] ? -1 : 1;
  }
  return 0;
}

/* Adds the images of ball i that meet a ball, by their shifts. */
static void add_images(const crystal *c, uint32_t i, const double *at, double radius) {
  const double *const xyz = &c->xyz[3 * i], *const box = c->box, r = c->radius[i] + radius;
  const uint32_t before = expected_count;
  const double high = ceil((r + fabs(at[2] - xyz[2])) / box[8]);
  uint32_t k;
  double p, q, s;
  for (p = -high; p <= high; ++p) {
    const double y = xyz[1] + p * box[7] - at[1], z = xyz[2] + p * box[8] - at[2];
    for (q = floor((-y - r) / box[4]); q <= ceil((-y + r) / box[4]); ++q) {
      const double x = xyz[0] + p * box[6] + q * box[3] - at[0], yy = y + q * box[4];
      for (s = floor((-x - r) / box[0]); s <= ceil((-x + r) / box[0]); ++s) {
        const double xx = x + s * box[0];
        hsp_image image;
        if (xx * xx + yy * yy + z * z > r * r || expected_count == MOST) continue;
        image.ball = i;
        image.shift[0] = (int32_t)s;
        image.shift[1] = (int32_t)q;
        image.shift[2] = (int32_t)p;
        for (k = expected_count++; k > before && shift_order(&image, &expected[k - 1]) < 0; --k)
          expected[k] = expected[k - 1];
        expected[k] = image;
      }
    }
  }
}

static void at_balls(uint64_t *random, const crystal *c) {
  static const double radii[] = {0, 0.25, 1, 2.25, 2.5, 5, 9.25};
  size_t k;
  for (k = 0; k < sizeof radii / sizeof *radii; ++k) {
    double at[3];
    uint32_t i, axis;
    int32_t times[3];
    for (axis = 0; axis < 3; ++axis) at[axis] = quarters(random, -50, 50);
    expected_count = 0;
    for (i = 0; i < c->n; ++i) add_images(c, i, at, radii[k]);
    CHECK_EQUAL(hsp_periodic_query_ball(periodic, at, radii[k], found, MOST, &found_count), HSP_OK);
    CHECK_EQUAL(found_count, expected_count);
    CHECK_BYTES(found, expected, found_count * sizeof *found);
    if (found_count > 0) {
      FILL(found[0]);
      CHECK_EQUAL(hsp_periodic_query_ball(periodic, at, radii[k], found, expected_count - 1, &found_count),
                  HSP_E_CAPACITY);
      CHECK_EQUAL(found_count, expected_count);
      CHECK_UNTOUCHED(found[0]);
    }
    /* Moved by vectors of the box. */
    for (axis = 0; axis < 3; ++axis) times[axis] = random_below(random, 9) - 4;
    for (axis = 0; axis < 3; ++axis) {
      at[axis] += times[0] * c->box[axis] + times[1] * c->box[3 + axis] + times[2] * c->box[6 + axis];
    }
    CHECK_EQUAL(hsp_periodic_query_ball(periodic, at, radii[k], found, MOST, &found_count), HSP_OK);
    CHECK_EQUAL(found_count, expected_count);
    for (i = 0; i < found_count; ++i) {
      for (axis = 0; axis < 3; ++axis) expected[i].shift[axis] += times[axis];
    }
    CHECK_BYTES(found, expected, found_count * sizeof *found);
    if (radii[k] == 0) {
      CHECK_EQUAL(hsp_periodic_query_point(periodic, at, found, MOST, &found_count), HSP_OK);
      CHECK_EQUAL(found_count, expected_count);
      CHECK_BYTES(found, expected, found_count * sizeof *found);
    }
  }
}

static int is_itself(const hsp_image *image, uint32_t i) {
  return image->ball == i && image->shift[0] == 0 && image->shift[1] == 0 && image->shift[2] == 0;
}

static void all_pairs(const crystal *c) {
  uint32_t i, j, k, number = 0, once = 0;
  /* Each row against all images, and against the same for one ball. */
  CHECK_EQUAL(hsp_periodic_query_pairs(periodic, 0, first, rows, MOST, &number), HSP_OK);
  CHECK(first[0] == 0 && first[c->n] == number);
  for (i = 0; i < c->n; ++i) {
    expected_count = 0;
    for (j = 0; j < c->n; ++j) add_images(c, j, &c->xyz[3 * i], c->radius[i]);
    for (j = k = 0; j < expected_count; ++j) {
      if (!is_itself(&expected[j], i)) expected[k++] = expected[j];
    }
    CHECK_EQUAL(k, expected_count - 1);
    CHECK_EQUAL(first[i + 1] - first[i], k);
    CHECK_BYTES(rows + first[i], expected, k * sizeof *rows);
    CHECK_EQUAL(hsp_periodic_query_neighbours(periodic, i, found, MOST, &found_count), HSP_OK);
    CHECK_EQUAL(found_count, k);
    CHECK_BYTES(found, expected, k * sizeof *found);
  }
  /* Too little room, then each pair once. */
  if (number > 0) {
    FILL(first);
    FILL(found[0]);
    CHECK_EQUAL(hsp_periodic_query_pairs(periodic, 0, first, found, number - 1, &found_count), HSP_E_CAPACITY);
    CHECK(found_count == number && first[0] == 0 && first[c->n] == number);
    CHECK_UNTOUCHED(found[0]);
  }
  CHECK_EQUAL(hsp_periodic_query_pairs(periodic, HSP_PAIRS_ONCE, first, found, MOST, &once), HSP_OK);
  CHECK(2 * once == number && first[c->n] == once);
  for (i = 0; i < c->n; ++i) {
    for (k = first[i]; k < first[i + 1]; ++k) {
      const hsp_image *const p = &found[k];
      uint32_t q;
      CHECK(p->ball >= i && !is_itself(p, i));
      CHECK(k == first[i] || p[-1].ball < p->ball || (p[-1].ball == p->ball && shift_order(&p[-1], p) < 0));
      for (q = first[i]; q < first[i + 1] && p->ball == i; ++q) {
        CHECK(found[q].ball != i || found[q].shift[0] != -p->shift[0] || found[q].shift[1] != -p->shift[1] ||
              found[q].shift[2] != -p->shift[2]);
      }
    }
  }
}

/* Every contact is a pair that meets, with the same shift. */
static void contacts_are_pairs(const crystal *c) {
  static hsp_periodic_contact contact[9000];
  uint32_t number = 0, k, q, i;
  CHECK_EQUAL(hsp_periodic_get_contacts(periodic, contact, 9000, &number), HSP_OK);
  CHECK_EQUAL(hsp_periodic_query_pairs(periodic, HSP_PAIRS_ONCE, first, found, MOST, &found_count), HSP_OK);
  CHECK(c->n > 0);
  for (k = 0; k < number; ++k) {
    int there = 0;
    i = contact[k].ball[0];
    for (q = first[i]; q < first[i + 1]; ++q) {
      there += found[q].ball == contact[k].ball[1] && found[q].shift[0] == contact[k].shift[0] &&
               found[q].shift[1] == contact[k].shift[1] && found[q].shift[2] == contact[k].shift[2];
    }
    CHECK_EQUAL(there, 1);
  }
}

/* A list by a cutoff, as simulations ask for it: atoms of a simple cubic crystal, 6 and 12 neighbours. */
static void by_cutoff(void) {
  static const double at[3] = {1, 2, 3}, none = 0, box[9] = {3, 0, 0, 0, 3, 0, 0, 0, 3};
  const hsp_periodic_limits limits = {(uint32_t)sizeof limits, BALLS, 4000, 200, 9000, 4000, 9000, 0};
  static const struct {
    double cutoff;
    uint32_t pairs;
  } known[] = {{2.75, 0}, {3, 6}, {4.25, 18}, {6, 32}};
  hsp_model_options options;
  size_t k;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  CHECK_EQUAL(hsp_periodic_init(memory, sizeof memory, &limits, &periodic), HSP_OK);
  for (k = 0; k < sizeof known / sizeof *known; ++k) {
    options.probe = known[k].cutoff / 2;
    CHECK_EQUAL(hsp_periodic_compute(periodic, 1, at, &none, box, &options, NULL, NULL), HSP_OK);
    CHECK_EQUAL(hsp_periodic_query_pairs(periodic, 0, first, found, MOST, &found_count), HSP_OK);
    CHECK_EQUAL(found_count, known[k].pairs);
    CHECK_EQUAL(first[1], known[k].pairs);
  }
}

/* The widest query ball that is answered, and the narrowest that is not. */
static void widest(void) {
  static const double at[3] = {0.5, 0.5, 0.5}, radius = 0.25, box[9] = {40, 0, 0, 0, 1, 0, 0, 0, 40};
  static crystal c;
  c.n = 1;
  c.radius[0] = radius;
  memcpy(c.box, box, sizeof box);
  compute(&c);
  expected_count = 0;
  add_images(&c, 0, at, 64);
  CHECK_EQUAL(hsp_periodic_query_ball(periodic, at, 64, found, MOST, &found_count), HSP_OK);
  CHECK(found_count == expected_count && found_count > 500);
  CHECK_BYTES(found, expected, found_count * sizeof *found);
  CHECK_EQUAL(hsp_periodic_query_ball(periodic, at, 64.25, found, MOST, &found_count), HSP_E_RANGE);
}

int main(void) {
  static crystal c;
  uint64_t random = 71;
  int set;
  for (set = 0; set < 24; ++set) {
    check_scene("set %d", set);
    choose(&random, set, &c);
    compute(&c);
    at_balls(&random, &c);
    all_pairs(&c);
    contacts_are_pairs(&c);
  }
  for (set = 0; set < 6; ++set) {
    check_scene("many balls %d", set);
    choose_many(&random, set % 2, &c);
    compute(&c);
    at_balls(&random, &c);
  }
  check_scene("a colloid");
  choose_colloid(&random, &c);
  compute(&c);
  at_balls(&random, &c);
  all_pairs(&c);
  check_scene("known");
  by_cutoff();
  widest();
  return check_report();
}
