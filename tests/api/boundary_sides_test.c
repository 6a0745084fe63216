/* Where arcs and circles lie, and which face is on which side of them: points of a sphere a little to the left of a
 * loop lie outside all balls, points a little to the right inside the other ball. Everything is computed here from
 * centres and radii. */
#include <hardsphere.h>
#include <math.h>

#include "ball_sets.h"
#include "check.h"
#include "computed.h"
#include "vectors.h"

static int outside_all(const computed *c, const double xyz[3]) {
  uint32_t j;
  for (j = 0; j < c->n; ++j) {
    double w[3];
    difference(xyz, c->xyz + 3 * j, w);
    if (length(w) < c->radius[j] - 1e-9) return 0;
  }
  return 1;
}

static int inside(const computed *c, const double xyz[3], uint32_t ball) {
  double w[3];
  difference(xyz, c->xyz + 3 * ball, w);
  return length(w) < c->radius[ball] - 1e-9;
}

/* The circle of two spheres, from the triangle of a point on it with the centres. */
typedef struct circle_of_two {
  double centre[3], axis[3], radius;
} circle_of_two;

static circle_of_two circle_of(const computed *c, const uint32_t ball[2]) {
  circle_of_two circle;
  const double *from = c->xyz + 3 * ball[0], r = c->radius[ball[0]], s = c->radius[ball[1]];
  double distance, height;
  int k;
  difference(c->xyz + 3 * ball[1], from, circle.axis);
  distance = length(circle.axis);
  height = (distance * distance + r * r - s * s) / (2 * distance);
  for (k = 0; k < 3; ++k) {
    circle.axis[k] /= distance;
    circle.centre[k] = from[k] + height * circle.axis[k];
  }
  circle.radius = sqrt(r * r - height * height);
  return circle;
}

static void check_circle(const circle_of_two *circle, const double centre[3], const double axis[3], double radius) {
  int k;
  for (k = 0; k < 3; ++k) {
    CHECK_NEAR(centre[k], circle->centre[k], 1e-13);
    CHECK_NEAR(axis[k], circle->axis[k], 1e-13);
  }
  CHECK_NEAR(radius, circle->radius, 1e-13);
}

/* The point where a turn counter-clockwise about the axis leads, and the direction there. */
static void turned(const circle_of_two *circle, const double from[3], double angle, double xyz[3], double along[3]) {
  double start[3], quarter[3];
  int k;
  difference(from, circle->centre, start);
  cross(circle->axis, start, quarter);
  for (k = 0; k < 3; ++k) {
    xyz[k] = circle->centre[k] + cos(angle) * start[k] + sin(angle) * quarter[k];
    along[k] = cos(angle) * quarter[k] - sin(angle) * start[k];
  }
}

/* A loop on ball `own` walks through `xyz` along (sign 1) or against (sign -1) a direction on the sphere of `other`. */
static void check_sides(const computed *c, uint32_t own, uint32_t other, const double xyz[3], const double along[3],
                        double sign) {
  const double aside = 1e-3;
  double outward[3], left[3], point[2][3];
  int side, k;
  difference(xyz, c->xyz + 3 * own, outward);
  cross(outward, along, left);
  for (side = 0; side < 2; ++side) {
    const double turn = side == 0 ? aside : -aside;
    for (k = 0; k < 3; ++k) {
      point[side][k] =
          c->xyz[3 * own + (uint32_t)k] + cos(turn) * outward[k] + sin(turn) * sign * left[k] / length(along);
    }
  }
  CHECK(outside_all(c, point[0]));
  CHECK(inside(c, point[1], other));
}

static void check_loops(const computed *c) {
  uint32_t i, s;
  for (i = 0; i < c->counts.loops; ++i) {
    const hsp_loop *loop = c->loops + i;
    const uint32_t own = c->faces[loop->face].ball;
    double xyz[3], along[3];
    if (loop->circle != HSP_NONE) {
      const hsp_circle *of = c->circles + loop->circle;
      const circle_of_two circle = circle_of(c, of->ball);
      const double across[3] = {-circle.axis[1], circle.axis[0], 0}; /* no axis is vertical */
      double from[3];
      int k;
      for (k = 0; k < 3; ++k) from[k] = circle.centre[k] + circle.radius * across[k] / length(across);
      check_circle(&circle, of->centre, of->axis, of->radius);
      turned(&circle, from, 1, xyz, along);
      check_sides(c, own, of->ball[1 - loop->side], xyz, along, loop->side == 1 ? 1 : -1);
    }
    for (s = loop->first_arc; s < loop->first_arc + loop->arcs; ++s) {
      const hsp_loop_arc *at = c->loop_arcs + s;
      const hsp_arc *of = c->arcs + at->arc;
      const circle_of_two circle = circle_of(c, of->ball);
      check_circle(&circle, of->centre, of->axis, of->radius);
      turned(&circle, c->vertices[of->vertex[0]].xyz, of->angle / 2, xyz, along);
      CHECK(outside_all(c, xyz));
      CHECK_EQUAL(own, of->ball[at->side]);
      check_sides(c, own, of->ball[1 - at->side], xyz, along, at->side == 1 ? 1 : -1);
    }
  }
}

/* Three balls that meet in two points, one that cuts a circle out of the first, and two small ones on the second and
 * the third: every pair occurs in either order of its indices. */
enum { BALLS = 6 };
static const double places[BALLS][4] = {{0, 0, 0, 1.5},         {2, 0, 0, 1.5},          {1, 1.5, 0, 1.25},
                                        {-1.75, 0.25, 0, 0.75}, {3.25, -0.5, 0.25, 0.5}, {1, 2.75, 0.25, 0.5}};

int main(void) {
  uint32_t first, i;
  int backwards;
  for (first = 0; first < BALLS; ++first) {
    for (backwards = 0; backwards < 2; ++backwards) {
      static ball_set set;
      computed c;
      ball_set_start(&set, "six balls", 1e-8);
      for (i = 0; i < BALLS; ++i) {
        const double *ball = places[(first + (backwards ? BALLS - i : i)) % BALLS];
        ball_set_add(&set, ball[0], ball[1], ball[2], ball[3]);
      }
      check_scene("six balls from number %u, %s", (unsigned)first, backwards ? "backwards" : "forwards");
      if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
        CHECK_EQUAL(c.counts.arcs, 3);
        CHECK_EQUAL(c.counts.circles, 3);
        CHECK_EQUAL(c.counts.loops, 3 + 2 * 3);
        check_loops(&c);
      }
      computed_release(&c);
    }
  }
  return check_report();
}
