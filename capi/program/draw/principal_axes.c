#include "draw/principal_axes.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "read/molecule.h"
#include "read/vectors.h"

/* Rounds of rotations; each squares the rest off the diagonal, so that a dozen is ample. */
enum { ROUNDS = 30 };

/* Variances that differ by less than this part of them, or of the largest, count as equal: those of a symmetric
 * molecule whose atoms are known to 0.01 of its size, and those across a straight one to 0.003 of its length. */
static const double tie = 0.02;
static const double nothing = 1e-5;

/* A direction whose y is larger is too near to y for y to be upwards across it: by 41 degrees, as no direction of small
 * whole numbers is. */
static const double too_near = 0.76;

/* Coordinates as whole numbers: sums of these do not depend on the order of their terms. */
struct whole_points {
  const struct molecule *molecule;
  bool all;      /* water counts */
  double low[3]; /* box of the points */
  double high[3];
  double size; /* half of its longest side */
  uint32_t count;
  int64_t steps; /* in that half */
};

static bool takes(const struct whole_points *points, uint32_t atom) {
  return points->all || !atom_is_water(&points->molecule->label[atom]);
}

static int64_t whole(const struct whole_points *points, uint32_t atom, int k) {
  const double middle = points->low[k] / 2.0 + points->high[k] / 2.0;
  const double x = (points->molecule->xyz[3 * (size_t)atom + (size_t)k] / 2.0 - middle / 2.0) / points->size;
  const double within = x < -0.5 ? -0.5 : x > 0.5 ? 0.5 : x; /* where doubles have no room for the middle */
  return (int64_t)floor(2.0 * within * (double)points->steps + 0.5);
}

static void find_box(struct whole_points *points) {
  points->count = 0;
  points->size = 0.0;
  for (uint32_t i = 0; i < points->molecule->atoms; ++i) {
    if (!takes(points, i)) continue;
    for (int k = 0; k < 3; ++k) {
      const double x = points->molecule->xyz[3 * (size_t)i + (size_t)k];
      if (points->count == 0 || x < points->low[k]) points->low[k] = x;
      if (points->count == 0 || x > points->high[k]) points->high[k] = x;
    }
    ++points->count;
  }
  for (int k = 0; points->count > 0 && k < 3; ++k) {
    const double half = points->high[k] / 2.0 - points->low[k] / 2.0;
    if (half > points->size) points->size = half;
  }
}

/* The covariances, up to a factor. As fine as sums below 2^63 allow: coordinates about their mean are at most twice as
 * large as those about the middle of the box. */
static void find_covariances(struct whole_points *points, double c[3][3]) {
  int64_t mean[3] = {0, 0, 0};
  int64_t sum[3][3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
  points->steps = INT64_C(1) << 26;
  while (points->steps * points->steps > (INT64_C(1) << 60) / points->count) points->steps /= 2;
  for (int pass = 0; pass < 2; ++pass) { /* the mean first, then about it */
    for (uint32_t i = 0; i < points->molecule->atoms; ++i) {
      if (!takes(points, i)) continue;
      int64_t x[3];
      for (int k = 0; k < 3; ++k) x[k] = whole(points, i, k) - (pass == 0 ? 0 : mean[k]);
      for (int row = 0; row < 3; ++row) {
        if (pass == 0) mean[row] += x[row];
        for (int column = 0; pass == 1 && column < 3; ++column) sum[row][column] += x[row] * x[column];
      }
    }
    for (int k = 0; pass == 0 && k < 3; ++k) mean[k] /= (int64_t)points->count;
  }
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) c[row][column] = (double)sum[row][column];
  }
}

/* Jacobi's method: rotations about the coordinate axes until nothing is left off the diagonal of c. Rows of `axis` are
 * rotated with it. */
static void diagonalize(double c[3][3], double axis[3][3]) {
  for (int round = 0; round < ROUNDS; ++round) {
    for (int p = 0; p < 2; ++p) {
      for (int q = p + 1; q < 3; ++q) {
        if (!(fabs(c[p][q]) > 1e-15 * (fabs(c[p][p]) + fabs(c[q][q])))) continue;
        const double theta = (c[q][q] - c[p][p]) / (2.0 * c[p][q]);
        const double t = (theta < 0.0 ? -1.0 : 1.0) / (fabs(theta) + sqrt(theta * theta + 1.0));
        const double cosine = 1.0 / sqrt(t * t + 1.0);
        const double sine = t * cosine;
        for (int k = 0; k < 3; ++k) {
          const double a = c[k][p];
          const double b = c[k][q];
          c[k][p] = cosine * a - sine * b;
          c[k][q] = sine * a + cosine * b;
        }
        for (int k = 0; k < 3; ++k) {
          const double a = c[p][k];
          const double b = c[q][k];
          c[p][k] = cosine * a - sine * b;
          c[q][k] = sine * a + cosine * b;
          const double u = axis[p][k];
          const double v = axis[q][k];
          axis[p][k] = cosine * u - sine * v;
          axis[q][k] = sine * u + cosine * v;
        }
      }
    }
  }
}

/* Take v or -v, whichever is on the side of the file's axis `main`, or, if v is nearly at a right angle to it, of the
 * other axes in turn: 9, 3, 1 times whole numbers from -2 to 2, not all 0, do not sum to 0. */
static void take_side(const double v[3], int main, int next, int last, double out[3]) {
  const double side = 9.0 * v[main] + 3.0 * v[next] + v[last];
  for (int k = 0; k < 3; ++k) out[k] = side < 0.0 ? -v[k] : v[k];
}

/* The direction upwards across a unit vector if nothing but the file says so: y, or z where y is nearly along it. */
static void find_upright(const double across[3], double up[3]) {
  const int main = fabs(across[1]) > too_near ? 2 : 1;
  double squares = 0.0;
  for (int k = 0; k < 3; ++k) {
    up[k] = (k == main ? 1.0 : 0.0) - across[main] * across[k];
    squares += up[k] * up[k];
  }
  for (int k = 0; k < 3; ++k) up[k] /= sqrt(squares);
}

static bool is_tie(double more, double less, double largest) {
  return more <= less * (1.0 + tie) + largest * nothing;
}

void principal_axes(const struct molecule *molecule, double axis[3][3]) {
  struct whole_points points = {molecule, false, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 0.0, 0, 0};
  double c[3][3];
  double found[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  int order[3] = {0, 1, 2};
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 3; ++k) axis[row][k] = found[row][k];
  }
  find_box(&points);
  if (points.count == 0) {
    points.all = true;
    find_box(&points);
  }
  if (!(points.size > 0.0)) return;
  find_covariances(&points, c);
  diagonalize(c, found);
  for (int pass = 0; pass < 2; ++pass) {
    for (int k = 0; k < 2; ++k) {
      const int here = order[k];
      if (!(c[order[k + 1]][order[k + 1]] > c[here][here])) continue;
      order[k] = order[k + 1];
      order[k + 1] = here;
    }
  }
  const double *longest = found[order[0]], *middle = found[order[1]], *shortest = found[order[2]];
  const double spread[3] = {c[order[0]][order[0]], c[order[1]][order[1]], c[order[2]][order[2]]};
  const bool wide = is_tie(spread[0], spread[1], spread[0]);
  const bool deep = is_tie(spread[1], spread[2], spread[0]);
  if (wide && deep) return;
  if (deep) {
    take_side(longest, 0, 1, 2, axis[0]);
    find_upright(axis[0], axis[1]);
    cross(axis[0], axis[1], axis[2]);
    return;
  }
  take_side(shortest, 2, 0, 1, axis[2]);
  if (wide) {
    find_upright(axis[2], axis[1]);
  } else {
    take_side(middle, 1, 2, 0, axis[1]);
  }
  cross(axis[1], axis[2], axis[0]);
}
