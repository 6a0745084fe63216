/* The sets of balls that the interface tests go through: ordinary ones, and every degenerate position with a name.
 * All coordinates and radii are multiples of the set's step, so that nothing is lost in rounding. */
#pragma once

#include <stdint.h>

enum { BALL_SET_MOST = 400 };

typedef struct ball_set {
  const char *name;
  uint32_t n;
  double step; /* every number below is an integer multiple of it */
  double xyz[3 * BALL_SET_MOST];
  double radius[BALL_SET_MOST];
} ball_set;

uint32_t ball_set_count(void);

/* Set number `which`, always the same. */
void ball_set_make(uint32_t which, ball_set *set);

/* ---- building blocks, for tests with sets of their own ---- */

void ball_set_start(ball_set *set, const char *name, double step);
void ball_set_add(ball_set *set, double x, double y, double z, double radius);

/* Three balls that meet in two points, with a face each. */
enum { THREE_BALLS = 3 };
extern const double three_balls_xyz[3 * THREE_BALLS], three_balls_radius[THREE_BALLS];
void ball_set_add_three(ball_set *set);

/* The full grid counts[0] x counts[1] x counts[2] with the given spacings, first ball at the origin. */
void ball_set_add_grid(ball_set *set, const int counts[3], const double spacing[3], double radius);

/* A closed wall of 26 balls, 3 x 3 x 3 without the middle. It reaches to 1.75 spacings from its centre along each
 * axis; its void holds the points up to 1/4 of the spacing along each axis. */
void ball_set_add_hollow(ball_set *set, double x, double y, double z, double spacing);

/* A ring of eight balls about (x, 0, 0), with centres at a distance of 5, in the plane of the x axis and another one.
 */
void ball_set_add_ring(ball_set *set, double x, int other_axis, double radius);

/* A self-avoiding walk of atoms with van der Waals radii and bonds of about 1.5, coordinates with 3 decimals. */
void ball_set_add_chain(ball_set *set, uint32_t atoms, uint64_t seed);

/* The balls of `set` in the order order[0], order[1], ... */
void ball_set_permute(const ball_set *set, const uint32_t *order, ball_set *permuted);

/* A permutation of 0 .. n-1. */
void ball_set_shuffle(uint32_t n, uint64_t seed, uint32_t *order);
