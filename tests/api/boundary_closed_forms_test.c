/* Sets of balls whose area, volume and topology are known in closed form, most of them degenerate: coincident, nested,
 * touching, collinear, gridded balls, many spheres through one point. Peers fail on these in various ways. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "ball_formulas.h"
#include "ball_sets.h"
#include "boundary_invariants.h"
#include "check.h"

typedef struct topology {
  uint32_t components, voids;
  int euler;
} topology;

static const double exact = 1e-12;

/* Without formula: expected->area < 0. */
static void check_form(const ball_set *set, amount expected, topology topo, double tolerance) {
  computed c;
  const char *broken;
  check_scene("%s", set->name);
  if (CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, &c), HSP_OK)) {
    broken = broken_boundary(&c);
    check_true(broken == NULL, broken == NULL ? "" : broken, __FILE__, __LINE__);
    CHECK_EQUAL(c.counts.components, topo.components);
    CHECK_EQUAL(c.counts.voids, topo.voids);
    CHECK_EQUAL(c.counts.euler, topo.euler);
    if (expected.area >= 0) {
      CHECK_NEAR(c.totals.area, expected.area, tolerance * expected.area);
      CHECK_NEAR(c.totals.volume, expected.volume, tolerance * expected.volume);
    }
  }
  computed_release(&c);
}

static const amount unknown = {-1, -1};

static amount sum(amount a, amount b) {
  amount_add(&a, 1, b);
  return a;
}

static void few_balls(void) {
  static const topology ball = {1, 0, 2}, apart = {2, 0, 4}, nothing = {0, 0, 0};
  static const amount zero = {0, 0};
  static ball_set s;
  double d;
  ball_set_start(&s, "no balls", 1e-8);
  check_form(&s, zero, nothing, exact);
  ball_set_add(&s, -3.25, 7, 1e5, 1.25);
  s.name = "one ball";
  check_form(&s, amount_of_ball(1.25), ball, exact);
  ball_set_add(&s, 30, 7, 1e5, 0.5);
  s.name = "two balls apart";
  check_form(&s, sum(amount_of_ball(1.25), amount_of_ball(0.5)), apart, exact);
  for (d = 1.25; d < 3.75; d += 0.25) {
    ball_set_start(&s, "two overlapping balls", 1e-8);
    ball_set_add(&s, 0, 0, 0, 1.5);
    ball_set_add(&s, 0, d, 0, 2.5);
    check_form(&s, amount_of_two_balls(1.5, 2.5, d), ball, exact);
    s.name = "two overlapping balls and a second copy of one";
    ball_set_add(&s, 0, 0, 0, 1.5);
    check_form(&s, amount_of_two_balls(1.5, 2.5, d), ball, exact);
  }
  /* the lattice is 1e-8 here: one step from touching on either side */
  ball_set_start(&s, "two balls that touch", 1e-8);
  ball_set_add(&s, 0, 0, 0, 1.5);
  ball_set_add(&s, 0, 4, 0, 2.5);
  check_form(&s, sum(amount_of_ball(1.5), amount_of_ball(2.5)), ball, exact);
  s.xyz[4] = 4.00000001;
  s.name = "two balls, one lattice step from touching";
  check_form(&s, sum(amount_of_ball(1.5), amount_of_ball(2.5)), apart, exact);
  s.xyz[4] = 3.99999999;
  s.name = "two balls that overlap by one lattice step";
  check_form(&s, amount_of_two_balls(1.5, 2.5, 3.99999999), ball, exact);
  s.xyz[4] = 1;
  s.name = "a ball that touches another from inside";
  check_form(&s, amount_of_ball(2.5), ball, exact);
  s.xyz[4] = 1.00000001;
  s.name = "a ball that pierces another from inside by one lattice step";
  check_form(&s, amount_of_two_balls(1.5, 2.5, 1.00000001), ball, 1e-11);
  s.xyz[4] = 0.5;
  s.name = "a ball inside another";
  check_form(&s, amount_of_ball(2.5), ball, exact);
  s.xyz[4] = 0;
  s.name = "concentric balls";
  check_form(&s, amount_of_ball(2.5), ball, exact);
  s.radius[0] = 2.5;
  s.name = "two identical balls";
  check_form(&s, amount_of_ball(2.5), ball, exact);
}

static void points(void) {
  static const topology ball = {1, 0, 2}, two = {2, 0, 4};
  static const amount zero = {0, 0};
  static ball_set s;
  ball_set_start(&s, "one point", 1e-8);
  ball_set_add(&s, 4, 5, 6, 0);
  check_form(&s, zero, ball, exact);
  ball_set_add(&s, 4, 5, 6, 0);
  s.name = "two equal points";
  check_form(&s, zero, ball, exact);
  ball_set_add(&s, 4, 5, 7, 0);
  s.name = "points in two places";
  check_form(&s, zero, two, exact);
  ball_set_start(&s, "a point inside a ball", 1e-8);
  ball_set_add(&s, 0, 0, 0, 2);
  ball_set_add(&s, 1, 0, 0, 0);
  check_form(&s, amount_of_ball(2), ball, exact);
  s.xyz[3] = 2;
  s.name = "a point on a sphere";
  check_form(&s, amount_of_ball(2), ball, exact);
  s.xyz[3] = 2.00000001;
  s.name = "a point outside a ball";
  check_form(&s, amount_of_ball(2), two, exact);
}

static void collinear(void) {
  static const topology ball = {1, 0, 2};
  static const double directions[3][3] = {{1, 0, 0}, {3, 4, 0}, {1, -2, 2}};
  static const double lengths[3] = {1, 5, 3};
  static ball_set s;
  int which, i, balls;
  for (which = 0; which < 3; ++which) {
    for (balls = 3; balls <= 40; balls += 37) {
      const double *u = directions[which];
      const double gap = lengths[which], r = gap * 1.25;
      amount all = {0, 0};
      ball_set_start(&s, "collinear balls", 1e-8);
      for (i = 0; i < balls; ++i) ball_set_add(&s, i * u[0], i * u[1], i * u[2], r);
      amount_add(&all, balls, amount_of_ball(r));
      amount_add(&all, -2 * (balls - 1), amount_of_cap(r, gap / 2));
      check_form(&s, all, ball, exact);
    }
  }
}

static void grids(void) {
  static const int five[3] = {5, 5, 5}, three[3] = {3, 3, 3}, box[3] = {4, 3, 2};
  static const double one[3] = {1, 1, 1}, two[3] = {2, 2, 2}, eightfold[3] = {2, 4, 4}, uneven[3] = {2, 3, 4};
  static ball_set s;
  topology t = {1, 0, 2};
  amount all = {0, 0};
  int i;
  ball_set_start(&s, "5 x 5 x 5 grid, spacing 1, radius 1", 1e-8);
  ball_set_add_grid(&s, five, one, 1);
  check_form(&s, amount_of_grid(five, one, 1), t, exact);

  /* between 8 balls with radius < sqrt(3)/2 there is a pore; its windows are closed for radius > sqrt(2)/2 */
  t.voids = 64;
  t.euler = 2 * 65;
  ball_set_start(&s, "5 x 5 x 5 grid, spacing 1, radius 0.75", 1e-8);
  ball_set_add_grid(&s, five, one, 0.75);
  check_form(&s, amount_of_grid(five, one, 0.75), t, exact);

  /* sqrt(3)/2 rounds up to the lattice: the pores are closed by less than a step */
  t.voids = 0;
  t.euler = 2;
  ball_set_start(&s, "5 x 5 x 5 grid, spacing 1, radius sqrt(3)/2", 1e-8);
  ball_set_add_grid(&s, five, one, 0.866025404);
  check_form(&s, amount_of_grid(five, one, sqrt(0.75)), t, 1e-8);

  /* 1 + 4 + 4 = 9: eight spheres of radius 3 meet exactly in the middle of each cell */
  ball_set_start(&s, "eight spheres through the middle of each cell", 1e-8);
  ball_set_add_grid(&s, three, eightfold, 3);
  check_form(&s, amount_of_grid(three, eightfold, 3), t, exact);

  ball_set_start(&s, "uneven grid", 1e-8);
  ball_set_add_grid(&s, box, uneven, 3);
  check_form(&s, amount_of_grid(box, uneven, 3), t, exact);

  /* 27 points of contact along 54 edges: a graph with 54 - 27 + 1 cycles, whose thickening has a boundary of that genus
   */
  ball_set_start(&s, "grid of touching balls", 1e-8);
  ball_set_add_grid(&s, three, two, 1);
  for (i = 0; i < 27; ++i) amount_add(&all, 1, amount_of_ball(1));
  t.euler = 2 - 2 * (54 - 27 + 1);
  check_form(&s, all, t, exact);
}

static void common_points(void) {
  /* integer vectors of length 3 */
  static const double covered[4][3] = {{1, 2, 2}, {-1, -2, 2}, {1, -2, -2}, {-1, 2, -2}};
  static const double exposed[5][3] = {{3, 0, 0}, {1, 2, 2}, {1, -2, 2}, {1, 2, -2}, {1, -2, -2}};
  static const double all[14][3] = {{3, 0, 0},  {-3, 0, 0},  {0, 3, 0},   {0, -3, 0},  {0, 0, 3},
                                    {0, 0, -3}, {1, 2, 2},   {1, 2, -2},  {1, -2, 2},  {1, -2, -2},
                                    {-1, 2, 2}, {-1, 2, -2}, {-1, -2, 2}, {-1, -2, -2}};
  static const topology ball = {1, 0, 2};
  static ball_set s;
  hsp_boundary_counts counts;
  computed c;
  int i;
  ball_set_start(&s, "four spheres through a covered point", 1e-8);
  for (i = 0; i < 4; ++i) ball_set_add(&s, covered[i][0], covered[i][1], covered[i][2], 3);
  check_form(&s, unknown, ball, exact);
  ball_set_start(&s, "fourteen spheres through a covered point", 1e-8);
  for (i = 0; i < 14; ++i) ball_set_add(&s, all[i][0], all[i][1], all[i][2], 3);
  check_form(&s, unknown, ball, exact);
  ball_set_start(&s, "five spheres through an exposed point", 1e-8);
  for (i = 0; i < 5; ++i) ball_set_add(&s, exposed[i][0], exposed[i][1], exposed[i][2], 3);
  check_form(&s, unknown, ball, exact);
  /* the tie is reported */
  if (CHECK_EQUAL(computed_make(s.n, s.xyz, s.radius, NULL, &c), HSP_OK)) {
    counts = c.counts;
    CHECK(counts.tied_vertices >= 1);
    CHECK(counts.tied_vertices <= counts.vertices);
  }
  computed_release(&c);
}

/* Six balls around one, spacing 1, radius 1. Each of the outer six meets three others in a row 60 degrees apart, the
 * inner one six; caps that are not next to each other meet only inside the cap between them. */
static void hexagon(void) {
  static const topology ball = {1, 0, 2};
  static ball_set s;
  static const double half[2] = {0.5, 0.5};
  const double y = 0.866025404; /* sqrt(3)/2 to 9 decimals, hence the tolerance */
  amount all = {0, 0};
  ball_set_start(&s, "hexagon and its centre", 1e-8);
  ball_set_add(&s, 0, 0, 0, 1);
  ball_set_add(&s, 1, 0, 0, 1);
  ball_set_add(&s, 0.5, y, 0, 1);
  ball_set_add(&s, -0.5, y, 0, 1);
  ball_set_add(&s, -1, 0, 0, 1);
  ball_set_add(&s, -0.5, -y, 0, 1);
  ball_set_add(&s, 0.5, -y, 0, 1);
  amount_add(&all, 7, amount_of_ball(1));
  amount_add(&all, -(6 + 6 * 3), amount_of_cap(1, 0.5));
  amount_add(&all, 6 + 6 * 2, amount_of_double_cap(1, half, acos(-1.0) / 3));
  check_form(&s, all, ball, 1e-8);
}

static void catalogue_topology(void) {
  static const struct {
    const char *name;
    topology topo;
  } known[] = {{"closed cavity of 26 balls", {1, 1, 4}},
               {"cubic grid with twelve voids", {1, 12, 26}},
               {"a ring of balls with a hole", {1, 0, 0}},
               {"a ball with a belt and a bump on its pole", {1, 0, 2}},
               {"two chains far apart", {2, 0, 4}}};
  static ball_set s;
  uint32_t which;
  size_t k, seen = 0;
  for (which = 0; which < ball_set_count(); ++which) {
    ball_set_make(which, &s);
    for (k = 0; k < sizeof known / sizeof known[0]; ++k) {
      if (strcmp(s.name, known[k].name) != 0) continue;
      check_form(&s, unknown, known[k].topo, exact);
      ++seen;
    }
  }
  check_scene("%s", "catalogue");
  CHECK_EQUAL(seen, sizeof known / sizeof known[0]);
}

/* Each ball twice, or with a ball of half its size inside: nothing changes. */
static void copies_do_not_count(void) {
  static ball_set s, more;
  computed plain, other;
  uint32_t i;
  int half;
  ball_set_start(&s, "chain", 1e-8);
  ball_set_add_chain(&s, 120, 21);
  CHECK_EQUAL(computed_make(s.n, s.xyz, s.radius, NULL, &plain), HSP_OK);
  for (half = 0; half < 2; ++half) {
    more = s;
    for (i = 0; i < s.n; ++i) {
      ball_set_add(&more, s.xyz[3 * i], s.xyz[3 * i + 1], s.xyz[3 * i + 2], half ? s.radius[i] / 2 : s.radius[i]);
    }
    check_scene("%s", half ? "chain with half-size balls inside" : "chain, each ball twice");
    CHECK_EQUAL(computed_make(more.n, more.xyz, more.radius, NULL, &other), HSP_OK);
    CHECK_EQUAL(other.counts.contained_balls, s.n);
    CHECK_EQUAL(other.counts.vertices, plain.counts.vertices);
    CHECK_EQUAL(other.counts.faces, plain.counts.faces);
    CHECK_EQUAL(other.counts.euler, plain.counts.euler);
    CHECK_NEAR(other.totals.area, plain.totals.area, 1e-13 * plain.totals.area);
    CHECK_NEAR(other.totals.volume, plain.totals.volume, 1e-13 * plain.totals.volume);
    computed_release(&other);
  }
  computed_release(&plain);
}

/* hsp_model_options.probe is the same as larger radii. */
static void probe_is_radius(void) {
  static ball_set s, larger;
  computed with_probe, with_radii;
  hsp_model_options options;
  uint32_t i;
  ball_set_start(&s, "chain with probe", 1e-8);
  ball_set_add_chain(&s, 100, 22);
  larger = s;
  for (i = 0; i < s.n; ++i) larger.radius[i] = floor((s.radius[i] + 1.4) * 1000 + 0.5) / 1000;
  check_scene("%s", s.name);
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.probe = 1.4;
  CHECK_EQUAL(computed_make(s.n, s.xyz, s.radius, &options, &with_probe), HSP_OK);
  CHECK_EQUAL(computed_make(larger.n, larger.xyz, larger.radius, NULL, &with_radii), HSP_OK);
  CHECK_NEAR(with_probe.info.probe, 1.4, 1e-15);
  CHECK_BYTES(&with_probe.counts, &with_radii.counts, sizeof with_probe.counts);
  CHECK_BYTES(with_probe.area, with_radii.area, s.n * sizeof(double));
  CHECK_BYTES(with_probe.volume, with_radii.volume, s.n * sizeof(double));
  computed_release(&with_probe);
  computed_release(&with_radii);
}

int main(void) {
  few_balls();
  points();
  collinear();
  grids();
  common_points();
  hexagon();
  catalogue_topology();
  copies_do_not_count();
  probe_is_radius();
  return check_report();
}
