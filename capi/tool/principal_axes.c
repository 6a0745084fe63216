#include "principal_axes.h"

#include <math.h>
#include <stddef.h>

/* Rounds of rotations; each squares what is left off the diagonal, so that a dozen is ample. */
enum { ROUNDS = 30 };

/* The covariances, up to a factor that keeps them from overflowing. */
static void find_covariances(const double *points, uint32_t count, double c[3][3]) {
  double low[3] = {0.0, 0.0, 0.0};
  double high[3] = {0.0, 0.0, 0.0};
  double size = 0.0;
  for (uint32_t i = 0; i < count; ++i) {
    for (int k = 0; k < 3; ++k) {
      const double x = points[3 * (size_t)i + (size_t)k];
      if (i == 0 || x < low[k]) low[k] = x;
      if (i == 0 || x > high[k]) high[k] = x;
    }
  }
  for (int k = 0; k < 3; ++k) {
    const double half = high[k] / 2.0 - low[k] / 2.0;
    if (half > size) size = half;
  }
  double mean[3] = {0.0, 0.0, 0.0};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) c[row][column] = 0.0;
  }
  if (!(size > 0.0)) return;
  for (int pass = 0; pass < 2; ++pass) { /* the mean first, then about it */
    for (uint32_t i = 0; i < count; ++i) {
      double x[3];
      for (int k = 0; k < 3; ++k) {
        x[k] = (points[3 * (size_t)i + (size_t)k] / 2.0 - low[k] / 2.0) / size - (pass == 0 ? 0.0 : mean[k]);
      }
      for (int row = 0; row < 3; ++row) {
        if (pass == 0) mean[row] += x[row] / count;
        for (int column = 0; pass == 1 && column < 3; ++column) c[row][column] += x[row] * x[column] / count;
      }
    }
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

static int largest_of(const double v[3]) {
  int largest = 0;
  for (int k = 1; k < 3; ++k) {
    if (fabs(v[k]) > fabs(v[largest])) largest = k;
  }
  return largest;
}

/* Whether an axis of spread a belongs before one of spread b; the least rounding decides nothing. */
static int is_before(double a, double b) {
  return a > b * (1.0 + 1e-9);
}

void principal_axes(const double *points, uint32_t count, double axis[3][3]) {
  double c[3][3];
  double found[3][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}};
  int order[3] = {0, 1, 2};
  find_covariances(points, count, c);
  diagonalize(c, found);
  for (int pass = 0; pass < 2; ++pass) {
    for (int k = 0; k < 2; ++k) {
      const int here = order[k];
      if (!is_before(c[order[k + 1]][order[k + 1]], c[here][here])) continue;
      order[k] = order[k + 1];
      order[k + 1] = here;
    }
  }
  for (int k = 0; k < 2; ++k) {
    const double *v = found[order[k]];
    const double sign = v[largest_of(v)] < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < 3; ++i) axis[k][i] = sign * v[i];
  }
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    axis[2][i] = axis[0][j] * axis[1][k] - axis[0][k] * axis[1][j];
  }
}
