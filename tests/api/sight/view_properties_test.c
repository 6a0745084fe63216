/* Every promise about a view's records, the regions they enclose and what is seen, for every set of topology_sets.h
 * from several directions, of both kinds, with and without a boundary; no effect of the order of the balls. And sets
 * whose pieces are known. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "topology_sets.h"
#include "view_invariants.h"

static const double pi = 3.14159265358979323846;

enum { DIRECTIONS = 8, WAYS = 6 };
static const double directions[DIRECTIONS][3] = {{0, 0, 0},  {0, 0, 1}, {0, 0, -5},  {1, 0, 0},
                                                 {0, -1, 1}, {1, 1, 1}, {3, -4, 12}, {0.3, 0.7, -0.2}};

/* The cuts, their flags, and whether the boundary is handed in. */
static const struct {
  uint32_t pieces, flags;
  int with_boundary;
} ways[WAYS] = {{HSP_PIECES_OUTSIDE_FARTHER, 0, 0}, {HSP_PIECES_OUTSIDE_FARTHER, HSP_VIEW_ALL_BALLS, 0},
                {HSP_PIECES_OUTSIDE_FARTHER, 0, 1}, {HSP_PIECES_OUTSIDE_FARTHER, HSP_VIEW_ALL_BALLS, 1},
                {HSP_PIECES_OUTSIDE_ALL, 0, 1},     {HSP_PIECES_OUTSIDE_ALL, HSP_VIEW_ALL_BALLS, 1}};

static hsp_view_options options_for(int direction, int way) {
  hsp_view_options options;
  int axis;
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  for (axis = 0; axis < 3; ++axis) options.towards[axis] = directions[direction][axis];
  options.pieces = ways[way].pieces;
  options.flags = ways[way].flags;
  return options;
}

static void check_nothing_broken(const char *broken) {
  if (!CHECK(broken == NULL)) check_true(0, broken, __FILE__, __LINE__);
}

static void every_set(void) {
  static ball_set set, shuffled;
  static uint32_t order[BALL_SET_MOST];
  uint32_t which;
  int direction, way;
  for (which = 0; which < topology_set_count(); ++which) {
    computed c, other;
    topology_set_make(which, &set);
    ball_set_shuffle(set.n, which + 1, order);
    ball_set_permute(&set, order, &shuffled);
    check_scene("%s", set.name);
    CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
    CHECK_EQUAL(computed_make(set.n, shuffled.xyz, shuffled.radius, NULL, &other), HSP_OK);
    for (direction = (int)(which % 2); direction < DIRECTIONS; direction += 2) {
      for (way = 0; way < WAYS; ++way) {
        const hsp_view_options options = options_for(direction, way);
        view_result v, w;
        check_scene("%s, direction %d, way %d", set.name, direction, way);
        memset(&w, 0, sizeof w);
        if (CHECK_EQUAL(view_result_make(&c, &options, ways[way].with_boundary, &v), HSP_OK) &&
            CHECK_EQUAL(view_result_make(&other, &options, ways[way].with_boundary, &w), HSP_OK)) {
          CHECK(v.enlargements <= 3);
          check_nothing_broken(broken_view(&v));
          check_nothing_broken(broken_view_regions(&v, set.n < 40 ? 24 : 6, which));
          /* hsp_view_compute, property 1 */
          check_nothing_broken(view_difference_after_permutation(&v, &w));
        }
        view_result_release(&v);
        view_result_release(&w);
      }
    }
    computed_release(&c);
    computed_release(&other);
  }
  check_scene("%s", "");
}

/* ---- sets whose pieces are known ---- */

static void known(const ball_set *set, int direction, int way, uint32_t pieces, uint32_t loops, uint32_t arcs,
                  view_result *v, computed *c) {
  const hsp_view_options options = options_for(direction, way);
  check_scene("%s, direction %d, way %d", set->name, direction, way);
  CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, c), HSP_OK);
  CHECK_EQUAL(view_result_make(c, &options, ways[way].with_boundary, v), HSP_OK);
  CHECK_EQUAL(v->info.pieces, pieces);
  CHECK_EQUAL(v->info.loops, loops);
  CHECK_EQUAL(v->info.arcs, arcs);
  check_nothing_broken(broken_view(v));
}

static void release(view_result *v, computed *c) {
  view_result_release(v);
  computed_release(c);
}

/* The only loop of a piece is the ball's whole silhouette. */
static void check_whole_disc(const view_result *v, uint32_t piece) {
  const hsp_view_piece *p = &v->pieces[piece];
  const hsp_view_arc *arc = &v->arcs[p->first_arc];
  CHECK_EQUAL(p->loops, 1);
  CHECK_EQUAL(p->arcs, 1);
  CHECK_EQUAL(arc->other_ball, HSP_NONE);
  CHECK(arc->to - arc->from == 2 * pi);
  CHECK_NEAR(arc->semi_axis[0], p->radius, 0);
  CHECK_NEAR(arc->semi_axis[1], p->radius, 0);
  CHECK_BYTES(arc->centre, p->centre, sizeof arc->centre);
  CHECK_BYTES(arc->start, arc->end, sizeof arc->start);
}

static void few_balls(void) {
  ball_set s;
  computed c;
  view_result v;
  int way, direction;
  for (way = 0; way < WAYS; ++way) {
    const int all = (ways[way].flags & HSP_VIEW_ALL_BALLS) != 0;
    for (direction = 0; direction < DIRECTIONS; ++direction) {
      ball_set_start(&s, "no balls", 1e-8);
      known(&s, direction, way, 0, 0, 0, &v, &c);
      release(&v, &c);
      ball_set_start(&s, "a ball of radius 0", 1e-8);
      ball_set_add(&s, 1, 2, 3, 0);
      known(&s, direction, way, 0, 0, 0, &v, &c);
      release(&v, &c);
      ball_set_start(&s, "one ball", 1e-8);
      ball_set_add(&s, 1, 2, 3, 1.25);
      known(&s, direction, way, 1, 1, 1, &v, &c);
      check_whole_disc(&v, 0);
      CHECK_NEAR(v.pieces[0].centre[0], 0, 0);
      CHECK_NEAR(v.pieces[0].depth, 0, 0);
      release(&v, &c);
      ball_set_start(&s, "equal balls", 1e-8);
      ball_set_add(&s, 1, 2, 3, 1.25);
      ball_set_add(&s, 1, 2, 3, 1.25);
      ball_set_add(&s, 1, 2, 3, 1.25);
      known(&s, direction, way, 1, 1, 1, &v, &c);
      check_whole_disc(&v, 0);
      release(&v, &c);
      ball_set_start(&s, "a ball inside another and a point", 1e-8);
      ball_set_add(&s, 0.5, 0, 0, 1);
      ball_set_add(&s, 0, 0, 0, 2);
      ball_set_add(&s, 0, 1, 0, 0);
      known(&s, direction, way, 1, 1, 1, &v, &c);
      CHECK_EQUAL(v.pieces[0].ball, 1);
      check_whole_disc(&v, 0);
      release(&v, &c);
    }
    /* far apart, seen beside each other and one behind the other */
    ball_set_start(&s, "two balls apart", 1e-8);
    ball_set_add(&s, 0, 0, 5, 1);
    ball_set_add(&s, 0, 0, 0, 0.75);
    known(&s, 3, way, 2, 2, 2, &v, &c);
    check_whole_disc(&v, 0);
    check_whole_disc(&v, 1);
    release(&v, &c);
    /* without the flag the hidden one may be left out */
    {
      const hsp_view_options options = options_for(1, way);
      CHECK_EQUAL(computed_make(s.n, s.xyz, s.radius, NULL, &c), HSP_OK);
      CHECK_EQUAL(view_result_make(&c, &options, ways[way].with_boundary, &v), HSP_OK);
      CHECK(v.info.pieces == 2 || (!all && v.info.pieces == 1));
      CHECK_EQUAL(v.pieces[v.info.pieces - 1].ball, 0);
      release(&v, &c);
    }
  }
}

/* A ball buried by six others, inside none of them. Its front outside farther balls is not empty, but with a boundary
 * it has no piece, as it has no face. */
static void buried_ball(void) {
  ball_set s;
  int way, direction;
  ball_set_start(&s, "a buried ball", 1e-8);
  ball_set_add(&s, 1, 0, 0, 1.3);
  ball_set_add(&s, -1, 0, 0, 1.3);
  ball_set_add(&s, 0, 1, 0, 1.3);
  ball_set_add(&s, 0, 0, 0, 1);
  ball_set_add(&s, 0, -1, 0, 1.3);
  ball_set_add(&s, 0, 0, 1, 1.3);
  ball_set_add(&s, 0, 0, -1, 1.3);
  for (way = 0; way < WAYS; ++way) {
    for (direction = 0; direction < DIRECTIONS; ++direction) {
      const hsp_view_options options = options_for(direction, way);
      const int cut_from_all = options.pieces == HSP_PIECES_OUTSIDE_ALL || ways[way].with_boundary;
      computed c;
      view_result v;
      uint32_t i, buried = 0;
      check_scene("%s, direction %d, way %d", s.name, direction, way);
      CHECK_EQUAL(computed_make(s.n, s.xyz, s.radius, NULL, &c), HSP_OK);
      CHECK_EQUAL(c.balls[3].faces, 0);
      CHECK_EQUAL(c.counts.contained_balls, 0);
      CHECK_EQUAL(view_result_make(&c, &options, ways[way].with_boundary, &v), HSP_OK);
      for (i = 0; i < v.info.pieces; ++i) buried += v.pieces[i].ball == 3;
      if (cut_from_all) CHECK_EQUAL(buried, 0);
      if (!cut_from_all && (options.flags & HSP_VIEW_ALL_BALLS) != 0) CHECK_EQUAL(buried, 1);
      check_nothing_broken(broken_view_records(&v));
      release(&v, &c);
    }
  }
}

/* Which balls are found hidden does not depend on the order either, nor do the limits: the second ball sticks out of
 * the first one behind, and no piece of it is seen. */
static void hidden_in_any_order(void) {
  static const double xyz[9] = {0, 0, 0, 0, 0, -4, 20, 0, -50}, radius[3] = {5, 2, 1};
  static const double other_xyz[9] = {0, 0, -4, 0, 0, 0, 20, 0, -50}, other_radius[3] = {2, 5, 1};
  int way;
  for (way = 0; way < WAYS; ++way) {
    const hsp_view_options options = options_for(1, way);
    computed c, other;
    view_result v, w;
    check_scene("hidden in any order, way %d", way);
    CHECK_EQUAL(computed_make(3, xyz, radius, NULL, &c), HSP_OK);
    CHECK_EQUAL(computed_make(3, other_xyz, other_radius, NULL, &other), HSP_OK);
    CHECK_EQUAL(view_result_make(&c, &options, ways[way].with_boundary, &v), HSP_OK);
    CHECK_EQUAL(view_result_make(&other, &options, ways[way].with_boundary, &w), HSP_OK);
    CHECK_EQUAL(v.info.pieces, w.info.pieces);
    check_nothing_broken(view_difference_after_permutation(&v, &w));
    release(&v, &c);
    release(&w, &other);
  }
}

/* Two balls of radius 5 whose centres are 6 apart meet in a circle of radius 4. Seen from the side that is a line, seen
 * along the axis a circle, and at 45 degrees an ellipse; the nearer ball, which the farther one cuts, is the one on the
 * viewer's side. */
static void two_balls(void) {
  ball_set s;
  computed c;
  view_result v;
  uint32_t k;
  ball_set_start(&s, "two balls of radius 5", 1e-8);
  ball_set_add(&s, 0, 0, 0, 5);
  ball_set_add(&s, 6, 0, 0, 5);

  /* from z: depths are equal, the first by x is the farther one and whole; the other is half a disc and more */
  known(&s, 1, 1, 2, 2, 3, &v, &c);
  CHECK_EQUAL(v.pieces[0].ball, 0);
  check_whole_disc(&v, 0);
  for (k = 1; k < v.info.arcs; ++k) {
    const hsp_view_arc *arc = &v.arcs[k];
    if (arc->other_ball == HSP_NONE) {
      CHECK_NEAR(arc->to - arc->from, 2 * pi - 2 * acos(0.6), 1e-12);
      CHECK_NEAR(fabs(arc->start[1]), 4, 1e-12);
    } else {
      CHECK_EQUAL(arc->other_ball, 0);
      CHECK_NEAR(arc->semi_axis[0], 4, 1e-12);
      CHECK(arc->semi_axis[1] == 0);
      CHECK_NEAR(arc->centre[0], 0, 1e-12);
      CHECK_NEAR(arc->start[0], 0, 1e-12);
      CHECK_NEAR(fabs(arc->end[1] - arc->start[1]), 8, 1e-12);
      CHECK_NEAR(fabs(arc->to - arc->from), pi, 1e-12);
    }
  }
  release(&v, &c);

  /* H: both are cut */
  known(&s, 1, 5, 2, 2, 4, &v, &c);
  release(&v, &c);

  /* along the axis: the circle lies in the nearer ball's rear half, so that both discs are whole */
  known(&s, 3, 1, 2, 2, 2, &v, &c);
  CHECK_EQUAL(v.pieces[0].ball, 0);
  CHECK_EQUAL(v.pieces[1].ball, 1);
  check_whole_disc(&v, 0);
  check_whole_disc(&v, 1);
  CHECK_NEAR(v.pieces[1].depth - v.pieces[0].depth, 6, 1e-12);
  release(&v, &c);
  /* H: the farther ball's front has a hole where the nearer one is */
  known(&s, 3, 5, 2, 3, 3, &v, &c);
  CHECK_EQUAL(v.pieces[0].loops, 2);
  for (k = 0; k < 2; ++k) {
    const hsp_view_arc *arc = &v.arcs[k];
    if (arc->other_ball == HSP_NONE) continue;
    CHECK_EQUAL(arc->other_ball, 1);
    CHECK(arc->from - arc->to == 2 * pi); /* a hole runs clockwise */
    CHECK_NEAR(arc->semi_axis[0], 4, 1e-12);
    CHECK_NEAR(arc->semi_axis[1], 4, 1e-12);
  }
  release(&v, &c);

  /* (1, 1, 1): the ellipse's smaller semi-axis is 4 |n_z| = 4/sqrt(3) */
  known(&s, 5, 1, 2, 2, 3, &v, &c);
  CHECK_EQUAL(v.pieces[1].ball, 1);
  CHECK_EQUAL(v.pieces[1].arcs, 2);
  for (k = 1; k < v.info.arcs; ++k) {
    if (v.arcs[k].other_ball == HSP_NONE) continue;
    CHECK_NEAR(v.arcs[k].semi_axis[0], 4, 1e-12);
    CHECK_NEAR(v.arcs[k].semi_axis[1], 4 / sqrt(3), 1e-12);
  }
  release(&v, &c);
}

/* Touching balls meet in a circle that has no size: nothing of it need be drawn, and pieces stay whole within rounding.
 */
static void touching_balls(void) {
  ball_set s;
  computed c;
  view_result v;
  int direction, way;
  for (direction = 1; direction < DIRECTIONS; ++direction) {
    for (way = 0; way < WAYS; ++way) {
      const hsp_view_options options = options_for(direction, way);
      ball_set_start(&s, "two balls that touch", 1e-8);
      ball_set_add(&s, 0, 0, 0, 1);
      ball_set_add(&s, 0, 3, 0, 2);
      check_scene("%s, direction %d, way %d", s.name, direction, way);
      CHECK_EQUAL(computed_make(s.n, s.xyz, s.radius, NULL, &c), HSP_OK);
      CHECK_EQUAL(view_result_make(&c, &options, ways[way].with_boundary, &v), HSP_OK);
      check_nothing_broken(broken_view(&v));
      check_nothing_broken(broken_view_regions(&v, 400, 9));
      release(&v, &c);
    }
  }
}

/* Two balls one behind the other but for one lattice step meet in an ellipse that is a circle up to rounding. */
static void nearly_a_circle(void) {
  static const double xyz[6] = {0, 0, 0, -1, -1 - 1e-8, -1e-8}, radius[2] = {1.5, 1.5};
  hsp_view_options options = options_for(0, WAYS - 1);
  computed c;
  view_result v;
  options.towards[0] = options.towards[1] = 1;
  check_scene("%s", "nearly a circle");
  CHECK_EQUAL(computed_make(2, xyz, radius, NULL, &c), HSP_OK);
  CHECK_EQUAL(view_result_make(&c, &options, 1, &v), HSP_OK);
  check_nothing_broken(broken_view(&v));
  release(&v, &c);
}

int main(void) {
  every_set();
  few_balls();
  buried_ball();
  hidden_in_any_order();
  two_balls();
  touching_balls();
  nearly_a_circle();
  check_scene("%s", "all sets");
  CHECK(mostly_decided(&view_pieces_decided, 0.9));
  CHECK(mostly_decided(&view_sights_decided, 0.9));
  return check_report();
}
