/* Gradients of sets whose area and volume are known in closed form: one and two balls in every position to each other,
 * the ones that touch among them, points, and grids under stretching. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "ball_formulas.h"
#include "check.h"
#include "gradients.h"

static const double pi = 3.14159265358979323846;

/* Derivatives of the areas of two balls with radii r and s whose centres are d apart, by d, r and s. The cap of ball 0
 * beyond the plane at distance h = (d^2 + r^2 - s^2)/(2d) leaves 2 pi r (r + h) of its sphere. */
typedef struct two_ball_slopes {
  double area[2];
  double by_distance[2]; /* dA_0/dd, dA_1/dd */
  double by_radius[2][2];
  double volume_by_distance;
} two_ball_slopes;

static two_ball_slopes slopes_of_two_balls(double r, double s, double d) {
  const double h = (d * d + r * r - s * s) / (2 * d), h_by_d = 1 - h / d;
  two_ball_slopes f;
  f.area[0] = 2 * pi * r * (r + h);
  f.area[1] = 2 * pi * s * (s + d - h);
  f.by_distance[0] = 2 * pi * r * h_by_d;
  f.by_distance[1] = 2 * pi * s * (1 - h_by_d);
  f.by_radius[0][0] = 2 * pi * (2 * r + h) + 2 * pi * r * r / d;
  f.by_radius[0][1] = -2 * pi * r * s / d;
  f.by_radius[1][0] = -2 * pi * r * s / d;
  f.by_radius[1][1] = 2 * pi * (2 * s + d - h) + 2 * pi * s * s / d;
  f.volume_by_distance = pi * (r * r - h * h);
  return f;
}

/* Two balls that do not change each other's area. */
static two_ball_slopes slopes_apart(double r, double s) {
  two_ball_slopes f;
  memset(&f, 0, sizeof f);
  f.area[0] = 4 * pi * r * r;
  f.area[1] = 4 * pi * s * s;
  f.by_radius[0][0] = 8 * pi * r;
  f.by_radius[1][1] = 8 * pi * s;
  return f;
}

/* Ball 1 inside ball 0. */
static two_ball_slopes slopes_inside(double r) {
  two_ball_slopes f = slopes_apart(r, 0);
  return f;
}

/* Integer vectors of integer length: balls at whole multiples of them are represented exactly. */
static const double directions[4][4] = {{1, 0, 0, 1}, {3, 4, 0, 5}, {1, -2, 2, 3}, {-2, -3, -6, 7}};

static void check_two_balls(const ball_set *set, const double *u, const two_ball_slopes *f, uint32_t tangency,
                            uint32_t flags) {
  static const double sigma[2] = {2, -3};
  static gradients g;
  computed c;
  double size, slope;
  int axis, k;
  if (CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, &c), HSP_OK)) {
    size = f->area[0] + f->area[1] + 1;
    /* the area, weighted */
    CHECK_EQUAL(gradients_make(&c, sigma, 0.5, 0, tangency, &g), HSP_OK);
    slope = 0.5 * (sigma[0] * f->by_distance[0] + sigma[1] * f->by_distance[1]);
    for (axis = 0; axis < 3; ++axis) {
      CHECK_NEAR(g.centre[3 + axis], slope * u[axis] / u[3], 1e-13 * size);
      CHECK_NEAR(g.centre[axis], -slope * u[axis] / u[3], 1e-13 * size);
    }
    for (k = 0; k < 2; ++k) {
      CHECK_NEAR(g.radius[k], 0.5 * (sigma[0] * f->by_radius[0][k] + sigma[1] * f->by_radius[1][k]), 1e-13 * size);
      CHECK_EQUAL(g.flags[k], flags);
    }
    CHECK_NEAR(g.energy.area, sigma[0] * f->area[0] + sigma[1] * f->area[1], 1e-13 * size);
    CHECK_NEAR(g.energy.value, 0.5 * g.energy.area, 1e-13 * size);
    CHECK_NEAR(g.energy.d_probe, g.radius[0] + g.radius[1], 1e-13 * size);
    /* the volume */
    CHECK_EQUAL(gradients_make(&c, NULL, 0, 1, tangency, &g), HSP_OK);
    for (axis = 0; axis < 3; ++axis) {
      CHECK_NEAR(g.centre[3 + axis], f->volume_by_distance * u[axis] / u[3], 1e-13 * size);
      CHECK_NEAR(g.centre[axis], -f->volume_by_distance * u[axis] / u[3], 1e-13 * size);
    }
    CHECK_NEAR(g.radius[0], f->area[0], 1e-13 * size);
    CHECK_NEAR(g.radius[1], f->area[1], 1e-13 * size);
    CHECK_NEAR(g.energy.value, c.totals.volume, 1e-13 * c.totals.volume);
  }
  computed_release(&c);
}

/* The rows of two balls that meet in a circle, which may have radius 0: then it counts only where they are to meet. */
static void check_two_rows(const ball_set *set, const double *u, const two_ball_slopes *f, uint32_t tangency,
                           uint32_t flags) {
  const double angle = flags != 0 && tangency == HSP_TANGENT_DISJOINT ? 0 : 2 * pi;
  computed c;
  jacobian rows;
  uint32_t i, j;
  int axis;
  if (CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, &c), HSP_OK)) {
    CHECK_EQUAL(jacobian_make(&c, tangency, &rows), HSP_OK);
    for (i = 0; i < 2; ++i) {
      if (!CHECK_EQUAL(rows.length[i], 2)) continue;
      for (j = 0; j < 2; ++j) {
        const hsp_area_derivative *entry = rows.entries + i * c.n + j;
        const double slope = (j == 1 ? 1 : -1) * f->by_distance[i];
        CHECK_EQUAL(entry->ball, j);
        CHECK_EQUAL(entry->flags, flags);
        CHECK_NEAR(entry->angle, i == j ? 0 : angle, 1e-14);
        CHECK_NEAR(entry->radius, f->by_radius[i][j], 1e-13 * (f->area[0] + f->area[1]));
        for (axis = 0; axis < 3; ++axis) {
          CHECK_NEAR(entry->centre[axis], slope * u[axis] / u[3], 1e-13 * (f->area[0] + f->area[1]));
        }
      }
    }
    jacobian_release(&rows);
  }
  computed_release(&c);
}

static void two_balls_at(ball_set *set, double r, double s, const double *u, double times) {
  ball_set_start(set, "", 1e-8);
  ball_set_add(set, 7, -8, 9, r);
  ball_set_add(set, 7 + times * u[0], -8 + times * u[1], 9 + times * u[2], s);
}

static void few_balls(void) {
  static ball_set set;
  static gradients g;
  uint32_t tangency;
  computed c;
  int k, which;
  for (tangency = HSP_TANGENT_OVERLAP; tangency <= HSP_TANGENT_DISJOINT; ++tangency) {
    check_scene("one ball, tangency %u", (unsigned)tangency);
    ball_set_start(&set, "one ball", 1e-8);
    ball_set_add(&set, 1.25, -2.5, 3.75, 1.5);
    CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
    CHECK_EQUAL(gradients_make(&c, NULL, 3, 0, tangency, &g), HSP_OK);
    CHECK(g.centre[0] == 0 && g.centre[1] == 0 && g.centre[2] == 0 && g.flags[0] == 0);
    CHECK_NEAR(g.radius[0], 3 * 8 * pi * 1.5, 1e-13);
    CHECK_NEAR(g.energy.area, 9 * pi, 1e-13);
    CHECK_NEAR(g.energy.volume, 4.5 * pi, 1e-13);
    CHECK_EQUAL(gradients_make(&c, NULL, 0, 2, tangency, &g), HSP_OK);
    CHECK(g.centre[0] == 0 && g.centre[1] == 0 && g.centre[2] == 0 && g.flags[0] == 0);
    CHECK_NEAR(g.radius[0], 2 * 9 * pi, 1e-13);
    CHECK_NEAR(g.energy.value, 9 * pi, 1e-13);
    computed_release(&c);

    for (which = 0; which < 4; ++which) {
      const double *u = directions[which];
      /* from piercing by a quarter of u to nearly apart, r = 1.5 |u|, s = 1 |u| */
      for (k = 3; k < 10; ++k) {
        const double d = 0.25 * k;
        const two_ball_slopes f = slopes_of_two_balls(1.5 * u[3], u[3], d * u[3]);
        check_scene("two balls, direction %d, distance %g, tangency %u", which, d, (unsigned)tangency);
        two_balls_at(&set, 1.5 * u[3], u[3], u, d);
        check_two_balls(&set, u, &f, tangency, 0);
        check_two_rows(&set, u, &f, tangency, 0);
      }
      check_scene("two balls apart, direction %d, tangency %u", which, (unsigned)tangency);
      two_balls_at(&set, 1.5 * u[3], u[3], u, 2.75);
      {
        const two_ball_slopes f = slopes_apart(1.5 * u[3], u[3]);
        check_two_balls(&set, u, &f, tangency, 0);
      }
      check_scene("a ball inside another, direction %d, tangency %u", which, (unsigned)tangency);
      two_balls_at(&set, 1.5 * u[3], u[3], u, 0.25);
      {
        const two_ball_slopes f = slopes_inside(1.5 * u[3]);
        check_two_balls(&set, u, &f, tangency, 0);
      }
    }
  }
}

/* Spheres that touch from outside: the derivatives of either side, and a flag. */
static void touching_from_outside(void) {
  static ball_set set;
  int which;
  for (which = 0; which < 4; ++which) {
    const double *u = directions[which];
    const double r = 1.5 * u[3], s = u[3];
    const two_ball_slopes meeting = slopes_of_two_balls(r, s, r + s), apart = slopes_apart(r, s);
    two_ball_slopes none = apart;
    two_balls_at(&set, r, s, u, 2.5);
    check_scene("touching balls as if they met, direction %d", which);
    check_two_balls(&set, u, &meeting, HSP_TANGENT_OVERLAP, HSP_GRADIENT_ONE_SIDED);
    check_two_rows(&set, u, &meeting, HSP_TANGENT_OVERLAP, HSP_GRADIENT_ONE_SIDED);
    check_scene("touching balls as if they were apart, direction %d", which);
    check_two_balls(&set, u, &apart, HSP_TANGENT_DISJOINT, HSP_GRADIENT_ONE_SIDED);
    check_two_rows(&set, u, &none, HSP_TANGENT_DISJOINT, HSP_GRADIENT_ONE_SIDED);
    /* one step of the lattice to either side there is nothing to choose; balls that only just meet share a circle
     * whose derivatives are those at the touch up to the step times a second derivative */
    check_scene("almost touching balls, direction %d", which);
    if (which == 0) {
      static gradients g, other;
      computed c;
      int side;
      for (side = -1; side <= 1; side += 2) {
        set.xyz[3] = 7 + 2.5 + side * 1e-8;
        CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
        CHECK_EQUAL(gradients_make(&c, NULL, 1, 0, HSP_TANGENT_OVERLAP, &g), HSP_OK);
        CHECK_EQUAL(gradients_make(&c, NULL, 1, 0, HSP_TANGENT_DISJOINT, &other), HSP_OK);
        CHECK(g.flags[0] == 0 && g.flags[1] == 0);
        CHECK_BYTES(g.centre, other.centre, 6 * sizeof(double));
        CHECK_NEAR(g.centre[3], side < 0 ? meeting.by_distance[0] + meeting.by_distance[1] : 0, 1e-6);
        computed_release(&c);
      }
    }
  }
}

/* A ball that touches another from inside lies inside it, for either tangency and whatever the perturbation makes of
 * it; moved outward it would poke out, hence the flags. */
static void touching_from_inside(void) {
  static ball_set set;
  int which, sign;
  uint32_t tangency;
  for (which = 0; which < 4; ++which) {
    const double *u = directions[which];
    const two_ball_slopes f = slopes_inside(1.5 * u[3]);
    for (sign = -1; sign <= 1; sign += 2) {
      for (tangency = HSP_TANGENT_OVERLAP; tangency <= HSP_TANGENT_DISJOINT; ++tangency) {
        check_scene("touching from inside, direction %d times %d, tangency %u", which, sign, (unsigned)tangency);
        two_balls_at(&set, 1.5 * u[3], u[3], u, 0.5 * sign);
        check_two_balls(&set, u, &f, tangency, HSP_GRADIENT_ONE_SIDED);
      }
    }
  }
}

/* A third ball that covers the point where two balls touch: nothing there is free, so nothing is one-sided. */
static void covered_touch(void) {
  static ball_set set;
  static gradients meeting, apart;
  computed c;
  ball_set_start(&set, "touching balls, the touch covered", 1e-8);
  ball_set_add(&set, -1.5, 0, 0, 1.5);
  ball_set_add(&set, 1, 0, 0, 1);
  ball_set_add(&set, 0, 0.25, 0, 0.75);
  check_scene("%s", set.name);
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
  CHECK_EQUAL(gradients_make(&c, NULL, 1, 0.5, HSP_TANGENT_OVERLAP, &meeting), HSP_OK);
  CHECK_EQUAL(gradients_make(&c, NULL, 1, 0.5, HSP_TANGENT_DISJOINT, &apart), HSP_OK);
  CHECK(meeting.flags[0] == 0 && meeting.flags[1] == 0 && meeting.flags[2] == 0);
  CHECK_BYTES(meeting.centre, apart.centre, 9 * sizeof(double));
  CHECK_BYTES(meeting.radius, apart.radius, 3 * sizeof(double));
  CHECK_BYTES(meeting.flags, apart.flags, 3 * sizeof(uint32_t));
  computed_release(&c);

  ball_set_start(&set, "touching from inside, the touch covered", 1e-8);
  ball_set_add(&set, 0, 0, 0, 2);
  ball_set_add(&set, 1, 0, 0, 1);
  ball_set_add(&set, -1, 0, 0, 1);
  ball_set_add(&set, 2, 0.25, 0, 0.75);
  check_scene("%s", set.name);
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
  CHECK_EQUAL(gradients_make(&c, NULL, 1, 0.5, HSP_TANGENT_OVERLAP, &meeting), HSP_OK);
  CHECK_EQUAL(meeting.flags[0], HSP_GRADIENT_ONE_SIDED); /* for the sake of ball 2 */
  CHECK_EQUAL(meeting.flags[1], 0);
  CHECK_EQUAL(meeting.flags[2], HSP_GRADIENT_ONE_SIDED);
  CHECK_EQUAL(meeting.flags[3], 0);
  computed_release(&c);
}

/* Balls inside others, copies, points: no area, no derivative, and the others do not notice. */
static void hidden_balls(void) {
  static ball_set set, more;
  static gradients g, of_more;
  computed c, d;
  uint32_t tangency, i, needed;
  ball_set_start(&set, "three balls", 1e-8);
  ball_set_add_three(&set);
  for (tangency = HSP_TANGENT_OVERLAP; tangency <= HSP_TANGENT_DISJOINT; ++tangency) {
    check_scene("hidden balls, tangency %u", (unsigned)tangency);
    more = set;
    ball_set_add(&more, 0.25, -0.25, 0.125, 0.5); /* inside ball 0 */
    ball_set_add(&more, 2, 0, 0, 1);              /* concentric with ball 1 */
    ball_set_add(&more, 1, 1.5, 0, 0);            /* the centre of ball 2 */
    CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
    CHECK_EQUAL(computed_make(more.n, more.xyz, more.radius, NULL, &d), HSP_OK);
    CHECK_EQUAL(gradients_make(&c, NULL, 2, 3, tangency, &g), HSP_OK);
    CHECK_EQUAL(gradients_make(&d, NULL, 2, 3, tangency, &of_more), HSP_OK);
    for (i = 0; i < 3 * 3; ++i) CHECK_NEAR(of_more.centre[i], g.centre[i], 1e-12);
    for (i = 0; i < 3; ++i) CHECK_NEAR(of_more.radius[i], g.radius[i], 1e-12);
    for (i = 3; i < 6; ++i) {
      CHECK(of_more.centre[3 * i] == 0 && of_more.centre[3 * i + 1] == 0 && of_more.centre[3 * i + 2] == 0);
      CHECK(of_more.radius[i] == 0 && of_more.flags[i] == 0);
      needed = 77;
      CHECK_EQUAL(hsp_boundary_get_area_row(d.boundary, i, tangency, NULL, 0, &needed), HSP_OK);
      CHECK_EQUAL(needed, 0);
    }
    computed_release(&c);
    computed_release(&d);

    check_scene("copies, tangency %u", (unsigned)tangency);
    more = set;
    for (i = 0; i < 3; ++i) ball_set_add(&more, set.xyz[3 * i], set.xyz[3 * i + 1], set.xyz[3 * i + 2], set.radius[i]);
    CHECK_EQUAL(computed_make(more.n, more.xyz, more.radius, NULL, &d), HSP_OK);
    CHECK_EQUAL(gradients_make(&d, NULL, 2, 3, tangency, &of_more), HSP_OK);
    for (i = 0; i < 3; ++i) {
      /* one of each two has all of it */
      const uint32_t shown = d.area[i] > 0 ? i : i + 3, hidden = d.area[i] > 0 ? i + 3 : i;
      int axis;
      CHECK(d.area[shown] > 0 && d.area[hidden] == 0);
      for (axis = 0; axis < 3; ++axis) {
        CHECK_NEAR(of_more.centre[3 * shown + (uint32_t)axis], g.centre[3 * i + (uint32_t)axis], 1e-12);
        CHECK(of_more.centre[3 * hidden + (uint32_t)axis] == 0);
      }
      CHECK_NEAR(of_more.radius[shown], g.radius[i], 1e-12);
      CHECK(of_more.radius[hidden] == 0);
      /* and each would show if it were a little larger */
      CHECK_EQUAL(of_more.flags[shown], HSP_GRADIENT_ONE_SIDED);
      CHECK_EQUAL(of_more.flags[hidden], HSP_GRADIENT_ONE_SIDED);
    }
    computed_release(&d);

    check_scene("points, tangency %u", (unsigned)tangency);
    ball_set_start(&more, "points", 1e-8);
    ball_set_add(&more, 0, 0, 0, 2);
    ball_set_add(&more, 5, 0, 0, 0);
    ball_set_add(&more, 5, 0, 0, 0);
    ball_set_add(&more, 1, 0, 0, 0);
    CHECK_EQUAL(computed_make(more.n, more.xyz, more.radius, NULL, &d), HSP_OK);
    CHECK_EQUAL(gradients_make(&d, NULL, 1, 1, tangency, &of_more), HSP_OK);
    CHECK_NEAR(of_more.radius[0], 16 * pi + 16 * pi, 1e-12);
    for (i = 0; i < 12; ++i) CHECK(of_more.centre[i] == 0);
    for (i = 1; i < 4; ++i) CHECK(of_more.radius[i] == 0);
    computed_release(&d);
  }
}

/* d/dx of the closed form by central differences of fourth order. */
static double slope_of_grid(const int counts[3], const double spacing[3], double r, int axis, int volume) {
  static const double weight[4] = {1, -8, 8, -1};
  static const int at[4] = {-2, -1, 1, 2};
  const double h = 1e-3;
  double sum = 0;
  int k;
  for (k = 0; k < 4; ++k) {
    double moved[3];
    amount a;
    memcpy(moved, spacing, sizeof moved);
    if (axis < 3) moved[axis] += at[k] * h;
    a = amount_of_grid(counts, moved, axis < 3 ? r : r + at[k] * h);
    sum += weight[k] * (volume ? a.volume : a.area);
  }
  return sum / (12 * h);
}

/* Stretching a grid along one axis moves every ball by its place in it; all radii at once are the probe. */
static void stretched_grids(void) {
  static const struct {
    int counts[3];
    double spacing[3], radius;
  } grids[5] = {{{2, 1, 1}, {1, 1, 1}, 0.75},
                {{3, 2, 1}, {1, 1, 1}, 0.875},
                {{4, 3, 2}, {2, 3, 4}, 3},
                {{3, 3, 3}, {1, 1.125, 1.25}, 0.75},
                {{2, 2, 2}, {1, 1, 1}, 0.625}};
  static ball_set set;
  static gradients g;
  computed c;
  uint32_t i;
  int which, axis, volume;
  for (which = 0; which < 5; ++which) {
    const double r = grids[which].radius;
    ball_set_start(&set, "grid", 1e-8);
    ball_set_add_grid(&set, grids[which].counts, grids[which].spacing, r);
    CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
    for (volume = 0; volume < 2; ++volume) {
      check_scene("grid %d, %s", which, volume ? "volume" : "area");
      CHECK_EQUAL(gradients_make(&c, NULL, volume ? 0 : 1, volume ? 1 : 0, HSP_TANGENT_OVERLAP, &g), HSP_OK);
      for (axis = 0; axis < 3; ++axis) {
        double stretch = 0;
        for (i = 0; i < set.n; ++i) {
          stretch += set.xyz[3 * i + (uint32_t)axis] / grids[which].spacing[axis] * g.centre[3 * i + (uint32_t)axis];
        }
        CHECK_NEAR(stretch, slope_of_grid(grids[which].counts, grids[which].spacing, r, axis, volume),
                   1e-8 * c.totals.area);
      }
      CHECK_NEAR(g.energy.d_probe, slope_of_grid(grids[which].counts, grids[which].spacing, r, 3, volume),
                 1e-8 * c.totals.area);
    }
    computed_release(&c);
  }
}

int main(void) {
  few_balls();
  touching_from_outside();
  touching_from_inside();
  covered_touch();
  hidden_balls();
  stretched_grids();
  return check_report();
}
