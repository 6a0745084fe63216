/* The numbered properties of gradients and of rows of the Jacobian, and what ties them to each other and to the rest of
 * the interface, for every set of the catalogue, for either tangency and in any order of the balls. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "gradients.h"

/* Weights that depend on where a ball lies, so that copies of a ball have the same and the order does not matter. */
static void weigh(const ball_set *set, double *sigma) {
  uint32_t i;
  for (i = 0; i < set->n; ++i) {
    const double *c = set->xyz + 3 * i;
    sigma[i] = sin(3 * c[0] + 5 * c[1] + 7 * c[2]) + 0.25 * set->radius[i];
  }
}

/* Sizes of rounding errors: sums of derivatives of areas and of volumes, and of these times a distance. */
typedef struct magnitude {
  double area_slope, area_turn, volume_slope, volume_turn;
} magnitude;

static magnitude magnitude_of(const ball_set *set, const double *sigma) {
  magnitude m;
  double r = 0, far = 0, largest_weight = 1;
  uint32_t i;
  for (i = 0; i < set->n; ++i) {
    r = fmax(r, set->radius[i]);
    largest_weight = fmax(largest_weight, fabs(sigma[i]));
  }
  for (i = 0; i < 3 * set->n; ++i) far = fmax(far, fabs(set->xyz[i]));
  m.area_slope = largest_weight * 100 * r * (1 + set->n);
  m.volume_slope = 100 * r * r * (1 + set->n);
  m.area_turn = m.area_slope * (far + r);
  m.volume_turn = m.volume_slope * (far + r);
  return m;
}

static const double rounding = 1e-15;

/* hsp_boundary_gradient, properties 1 and 2, and the sums in hsp_energy. */
static void check_sums(const ball_set *set, const computed *c, const double *sigma, uint32_t tangency,
                       const magnitude *m) {
  static gradients area, volume, both, plain;
  double force[2][3] = {{0, 0, 0}, {0, 0, 0}}, torque[2][3] = {{0, 0, 0}, {0, 0, 0}};
  double weighted = 0, radii = 0, scaled_area = 0, scaled_volume = 0;
  uint32_t i;
  int k, axis;
  CHECK_EQUAL(gradients_make(c, sigma, 1, 0, tangency, &area), HSP_OK);
  CHECK_EQUAL(gradients_make(c, sigma, 0, 1, tangency, &volume), HSP_OK);
  CHECK_EQUAL(gradients_make(c, sigma, -0.75, 2.5, tangency, &both), HSP_OK);
  CHECK_EQUAL(gradients_make(c, NULL, 1, 0, tangency, &plain), HSP_OK);
  for (i = 0; i < c->n; ++i) {
    const double *at = set->xyz + 3 * i;
    weighted += sigma[i] * c->area[i];
    radii += both.radius[i];
    scaled_area += set->radius[i] * plain.radius[i];
    scaled_volume += set->radius[i] * volume.radius[i];
    for (k = 0; k < 2; ++k) {
      const double *g = (k == 0 ? area.centre : volume.centre) + 3 * i;
      for (axis = 0; axis < 3; ++axis) {
        const int next = (axis + 1) % 3, last = (axis + 2) % 3;
        force[k][axis] += g[axis];
        torque[k][axis] += at[next] * g[last] - at[last] * g[next];
      }
    }
    for (axis = 0; axis < 3; ++axis) {
      const size_t at_axis = 3 * (size_t)i + (size_t)axis;
      scaled_area += set->xyz[at_axis] * plain.centre[at_axis];
      scaled_volume += set->xyz[at_axis] * volume.centre[at_axis];
      /* linear in tension and pressure */
      CHECK_NEAR(both.centre[at_axis], -0.75 * area.centre[at_axis] + 2.5 * volume.centre[at_axis],
                 rounding * (m->area_slope + m->volume_slope));
    }
    CHECK_NEAR(both.radius[i], -0.75 * area.radius[i] + 2.5 * volume.radius[i],
               rounding * (m->area_slope + m->volume_slope));
    CHECK_NEAR(volume.radius[i], c->area[i], rounding * m->volume_slope);
    CHECK_EQUAL(volume.flags[i], area.flags[i]);
    CHECK_EQUAL(plain.flags[i], area.flags[i]);
    if (c->balls[i].faces == 0) {
      CHECK(both.centre[3 * i] == 0 && both.centre[3 * i + 1] == 0 && both.centre[3 * i + 2] == 0);
      CHECK(both.radius[i] == 0);
    }
  }
  for (axis = 0; axis < 3; ++axis) {
    CHECK_NEAR(force[0][axis], 0, rounding * m->area_slope);
    CHECK_NEAR(force[1][axis], 0, rounding * m->volume_slope);
    CHECK_NEAR(torque[0][axis], 0, rounding * m->area_turn);
    CHECK_NEAR(torque[1][axis], 0, rounding * m->volume_turn);
  }
  CHECK_NEAR(scaled_area, 2 * c->totals.area, rounding * m->area_turn);
  CHECK_NEAR(scaled_volume, 3 * c->totals.volume, rounding * m->volume_turn);
  CHECK_NEAR(area.energy.area, weighted, rounding * m->volume_slope);
  CHECK_NEAR(plain.energy.area, c->totals.area, rounding * c->totals.area);
  CHECK_NEAR(both.energy.volume, c->totals.volume, rounding * c->totals.volume);
  CHECK_NEAR(both.energy.value, -0.75 * both.energy.area + 2.5 * both.energy.volume,
             rounding * (fabs(both.energy.area) + fabs(both.energy.volume)));
  CHECK_NEAR(both.energy.probe, radii, rounding * (m->area_slope + m->volume_slope));
}

/* What the arcs and circles of the boundary say about the circle of i and j: the sum of its free angles, or -1 if none
 * of it is free. */
static double free_angle(const computed *c, uint32_t i, uint32_t j) {
  const uint32_t a = i < j ? i : j, b = i < j ? j : i;
  double angle = -1;
  uint32_t k;
  for (k = 0; k < c->counts.arcs; ++k) {
    if (c->arcs[k].ball[0] == a && c->arcs[k].ball[1] == b) angle = fmax(angle, 0) + c->arcs[k].angle;
  }
  for (k = 0; k < c->counts.circles; ++k) {
    if (c->circles[k].ball[0] == a && c->circles[k].ball[1] == b) angle = 2 * acos(-1.0);
  }
  return angle;
}

/* hsp_boundary_get_area_row, properties 1 and 2, which entries there are, and that rows add up to gradients. */
static void check_rows(const ball_set *set, const computed *c, const double *sigma, uint32_t tangency,
                       const magnitude *m) {
  static gradients g;
  static double centre[3 * BALL_SET_MOST], radius[BALL_SET_MOST];
  jacobian rows;
  uint32_t i, j, k;
  int axis;
  CHECK_EQUAL(gradients_make(c, sigma, 1, 0, tangency, &g), HSP_OK);
  CHECK_EQUAL(jacobian_make(c, tangency, &rows), HSP_OK);
  memset(centre, 0, sizeof centre);
  memset(radius, 0, sizeof radius);
  for (i = 0; i < c->n; ++i) {
    const hsp_area_derivative *row = rows.entries + (size_t)i * c->n, *own = jacobian_entry(&rows, i, i);
    double sum[3] = {0, 0, 0};
    uint32_t one_sided = 0;
    if (c->balls[i].faces == 0) {
      CHECK_EQUAL(rows.length[i], 0);
      continue;
    }
    if (!CHECK(own != NULL)) continue;
    CHECK(own->angle == 0);
    for (k = 0; k < rows.length[i]; ++k) {
      const hsp_area_derivative *entry = row + k, *mirrored;
      j = entry->ball;
      CHECK(j < c->n && (k == 0 || row[k - 1].ball < j));
      for (axis = 0; axis < 3; ++axis) {
        sum[axis] += entry->centre[axis];
        centre[3 * j + (uint32_t)axis] += sigma[i] * entry->centre[axis];
      }
      radius[j] += sigma[i] * entry->radius;
      if (entry == own) continue;
      mirrored = jacobian_entry(&rows, j, i);
      if (CHECK(mirrored != NULL)) {
        CHECK_NEAR(mirrored->radius, entry->radius, rounding * m->area_slope);
        CHECK_NEAR(mirrored->angle, entry->angle, 1e-11);
        CHECK_EQUAL(mirrored->flags, entry->flags);
      }
      CHECK_EQUAL(entry->flags, spheres_touch(set, i, j) ? HSP_GRADIENT_ONE_SIDED : 0);
      if (entry->flags == 0) CHECK_NEAR(entry->angle, free_angle(c, i, j), 1e-11);
      one_sided |= entry->flags;
    }
    CHECK_EQUAL(own->flags, one_sided);
    for (axis = 0; axis < 3; ++axis) CHECK_NEAR(sum[axis], 0, rounding * m->area_slope);
    /* an entry for every circle with a free piece, and for no other */
    for (j = 0; j < c->n; ++j) {
      if (j != i) CHECK_EQUAL(jacobian_entry(&rows, i, j) != NULL, free_angle(c, i, j) >= 0);
    }
    /* what a row says is in the ball's flags as well; these also tell of balls that touch from inside */
    CHECK_EQUAL(one_sided & ~g.flags[i], 0);
  }
  for (i = 0; i < c->n; ++i) {
    for (axis = 0; axis < 3; ++axis) {
      CHECK_NEAR(centre[3 * i + (uint32_t)axis], g.centre[3 * i + (uint32_t)axis], rounding * m->area_slope);
    }
    CHECK_NEAR(radius[i], g.radius[i], rounding * m->area_slope);
  }
  jacobian_release(&rows);
}

/* A ball has a flag only if its sphere touches another; without flags there is one gradient, whatever the tangency. */
static void check_flags(const ball_set *set, const computed *c, const double *sigma) {
  static gradients meeting, apart;
  uint32_t i, j, flagged = 0;
  CHECK_EQUAL(gradients_make(c, sigma, 1, -1, HSP_TANGENT_MEETING, &meeting), HSP_OK);
  CHECK_EQUAL(gradients_make(c, sigma, 1, -1, HSP_TANGENT_APART, &apart), HSP_OK);
  CHECK_BYTES(meeting.flags, apart.flags, c->n * sizeof(uint32_t));
  CHECK_BYTES(&meeting.energy.value, &apart.energy.value, 3 * sizeof(double));
  for (i = 0; i < c->n; ++i) {
    int touches = 0;
    for (j = 0; j < c->n; ++j) touches |= j != i && spheres_touch(set, i, j);
    CHECK((meeting.flags[i] & ~HSP_GRADIENT_ONE_SIDED) == 0);
    CHECK(meeting.flags[i] == 0 || touches);
    flagged += meeting.flags[i];
    if (meeting.flags[i] == 0) {
      CHECK_BYTES(meeting.centre + 3 * i, apart.centre + 3 * i, 3 * sizeof(double));
      CHECK_BYTES(meeting.radius + i, apart.radius + i, sizeof(double));
    }
  }
  if (strcmp(set->name, "cubic grid of touching balls") == 0) CHECK_EQUAL(flagged, 27);
  if (strcmp(set->name, "a chain of 60 atoms") == 0) CHECK_EQUAL(flagged, 0);
}

/* One ball's part without its id. */
typedef struct plain_part {
  double xyz[3], r, centre[3], radius;
  uint64_t flags;
} plain_part;

static int by_bytes(const void *a, const void *b) {
  return memcmp(a, b, sizeof(plain_part));
}

static void plain_parts(const ball_set *set, const gradients *g, plain_part *parts) {
  uint32_t i;
  memset(parts, 0, set->n * sizeof *parts);
  for (i = 0; i < set->n; ++i) {
    memcpy(parts[i].xyz, set->xyz + 3 * i, sizeof parts[i].xyz);
    parts[i].r = set->radius[i];
    memcpy(parts[i].centre, g->centre + 3 * i, sizeof parts[i].centre);
    parts[i].radius = g->radius[i];
    parts[i].flags = g->flags[i];
  }
  qsort(parts, set->n, sizeof *parts, by_bytes);
}

/* hsp_boundary_gradient, property 3. Of copies any one may have what all but one lack. */
static void check_order(const ball_set *set, const computed *c, const double *sigma, uint32_t tangency) {
  static ball_set permuted;
  static gradients g, other;
  static plain_part parts[BALL_SET_MOST], other_parts[BALL_SET_MOST];
  uint32_t order[BALL_SET_MOST], i;
  double other_sigma[BALL_SET_MOST];
  int round;
  CHECK_EQUAL(gradients_make(c, sigma, 0.5, 0.25, tangency, &g), HSP_OK);
  plain_parts(set, &g, parts);
  for (round = 0; round < 3; ++round) {
    computed d;
    for (i = 0; i < set->n; ++i) order[i] = set->n - 1 - i;
    if (round > 0) ball_set_shuffle(set->n, (uint64_t)round, order);
    ball_set_permute(set, order, &permuted);
    weigh(&permuted, other_sigma);
    CHECK_EQUAL(computed_make(permuted.n, permuted.xyz, permuted.radius, NULL, &d), HSP_OK);
    CHECK_EQUAL(gradients_make(&d, other_sigma, 0.5, 0.25, tangency, &other), HSP_OK);
    plain_parts(&permuted, &other, other_parts);
    CHECK_BYTES(other_parts, parts, set->n * sizeof *parts);
    CHECK_NEAR(other.energy.value, g.energy.value, 1e-13 * (fabs(g.energy.area) + fabs(g.energy.volume)));
    computed_release(&d);
  }
}

/* The same integers in another unit: derivatives of areas grow with it, those of the volume with its square. */
static void check_unit(const ball_set *set, double unit, double step) {
  static ball_set scaled;
  static gradients area, volume, other;
  hsp_model_options options;
  computed c, d;
  uint32_t i;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  scaled = *set;
  for (i = 0; i < 3 * set->n; ++i) scaled.xyz[i] *= unit;
  for (i = 0; i < set->n; ++i) scaled.radius[i] *= unit;
  options.step = 1e-6;
  CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, &options, &c), HSP_OK);
  options.step = step;
  CHECK_EQUAL(computed_make(set->n, scaled.xyz, scaled.radius, &options, &d), HSP_OK);
  CHECK_EQUAL(gradients_make(&c, NULL, 1, 0, HSP_TANGENT_MEETING, &area), HSP_OK);
  CHECK_EQUAL(gradients_make(&c, NULL, 0, 1, HSP_TANGENT_MEETING, &volume), HSP_OK);
  CHECK_EQUAL(gradients_make(&d, NULL, 2, 3, HSP_TANGENT_MEETING, &other), HSP_OK);
  CHECK_BYTES(other.flags, area.flags, set->n * sizeof(uint32_t));
  for (i = 0; i < 3 * set->n; ++i) {
    const double expected = 2 * unit * area.centre[i] + 3 * unit * unit * volume.centre[i];
    CHECK_NEAR(other.centre[i], expected, 1e-14 * (unit * fabs(area.centre[i]) + unit * unit * fabs(volume.centre[i])));
  }
  for (i = 0; i < set->n; ++i) {
    const double expected = 2 * unit * area.radius[i] + 3 * unit * unit * volume.radius[i];
    CHECK_NEAR(other.radius[i], expected, 1e-14 * (unit * fabs(area.radius[i]) + unit * unit * fabs(volume.radius[i])));
  }
  computed_release(&c);
  computed_release(&d);
}

/* hsp_model_options.probe is the same as larger radii. */
static void check_probe(void) {
  static ball_set set, larger;
  static gradients with_probe, with_radii;
  hsp_model_options options;
  computed c, d;
  uint32_t i;
  check_scene("probe");
  ball_set_start(&set, "chain with probe", 1e-8);
  ball_set_add_chain(&set, 60, 23);
  larger = set;
  for (i = 0; i < set.n; ++i) larger.radius[i] = floor((set.radius[i] + 1.4) * 1000 + 0.5) / 1000;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.probe = 1.4;
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, &options, &c), HSP_OK);
  CHECK_EQUAL(computed_make(set.n, larger.xyz, larger.radius, NULL, &d), HSP_OK);
  CHECK_EQUAL(gradients_make(&c, NULL, 1, 1, HSP_TANGENT_APART, &with_probe), HSP_OK);
  CHECK_EQUAL(gradients_make(&d, NULL, 1, 1, HSP_TANGENT_APART, &with_radii), HSP_OK);
  CHECK_BYTES(&with_probe, &with_radii, sizeof with_probe);
  computed_release(&c);
  computed_release(&d);
}

/* Flags tell of touches at free points alone: copies of a ball that is buried bare nothing by moving a little. */
static void check_buried_copies(void) {
  static ball_set set;
  static gradients g;
  computed c;
  uint32_t i;
  ball_set_start(&set, "buried copies", 1e-8);
  ball_set_add(&set, 0, 0, 0, 3);
  for (i = 0; i < 3; ++i) ball_set_add(&set, 0.5, 0, 0, 1);
  check_scene("%s", set.name);
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
  CHECK_EQUAL(gradients_make(&c, NULL, 1, 0, HSP_TANGENT_MEETING, &g), HSP_OK);
  for (i = 0; i < 4; ++i) CHECK_EQUAL(g.flags[i], 0);
  computed_release(&c);
}

int main(void) {
  static ball_set set;
  double sigma[BALL_SET_MOST];
  uint32_t which, tangency;
  for (which = 0; which < ball_set_count(); ++which) {
    computed c;
    magnitude m;
    ball_set_make(which, &set);
    weigh(&set, sigma);
    m = magnitude_of(&set, sigma);
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
      check_flags(&set, &c, sigma);
      for (tangency = HSP_TANGENT_MEETING; tangency <= HSP_TANGENT_APART; ++tangency) {
        check_scene("%s, tangency %u", set.name, (unsigned)tangency);
        check_sums(&set, &c, sigma, tangency, &m);
        check_rows(&set, &c, sigma, tangency, &m);
        check_order(&set, &c, sigma, tangency);
      }
    }
    computed_release(&c);
    check_scene("%s in other units", set.name);
    check_unit(&set, 1e6, 1);
    check_unit(&set, 10, 1e-5);
  }
  check_probe();
  check_buried_copies();
  return check_report();
}
