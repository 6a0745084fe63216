/* Newton's method with a surface energy: four dimers on a square, bonds and attraction between all others, and a
 * tension of -0.1 of their surface, so that they want to show it and to touch at once.
 *   newton [WINDOW [START]]
 * Prints the largest component of the gradient at each step. With a window (0.05 without arguments) it goes below
 * 1e-12; the area itself, window 0, has its minima where balls touch and its slope jumps, and stalls.
 * Source of the smooth energy and of its derivatives: capi/clients/smooth_energy.h. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../clients/smooth_energy.h"

enum { BALLS = 8, N = 3 * BALLS, MOST_STEPS = 60 };

static const double tension = -0.1, spring = 600, bond = 1.54, depth = 0.1, rest = 3.2;
static double radius[BALLS];

struct energy {
  double value, gradient[N], matrix[N * N];
};

/* Adds f(r) of two balls, whose derivatives by their distance are `slope` and `bend`. */
static void add_pair(const double *xyz, int i, int j, double slope, double bend, struct energy *e) {
  double u[3], r = 0;
  for (int k = 0; k < 3; ++k) {
    u[k] = xyz[3 * j + k] - xyz[3 * i + k];
    r += u[k] * u[k];
  }
  r = sqrt(r);
  for (int k = 0; k < 3; ++k) {
    e->gradient[3 * j + k] += slope * u[k] / r;
    e->gradient[3 * i + k] -= slope * u[k] / r;
    for (int l = 0; l < 3; ++l) {
      const double along = u[k] * u[l] / (r * r), part = bend * along + slope / r * ((k == l) - along);
      e->matrix[(3 * i + k) * N + 3 * i + l] += part;
      e->matrix[(3 * j + k) * N + 3 * j + l] += part;
      e->matrix[(3 * i + k) * N + 3 * j + l] -= part;
      e->matrix[(3 * j + k) * N + 3 * i + l] -= part;
    }
  }
}

static int32_t evaluate(smooth_energy *surface, const double *xyz, struct energy *e) {
  double value, gradient[N];
  int32_t status;
  memset(e, 0, sizeof *e);
  for (int i = 0; i < BALLS; ++i) {
    for (int j = i + 1; j < BALLS; ++j) {
      const double x = xyz[3 * j] - xyz[3 * i], y = xyz[3 * j + 1] - xyz[3 * i + 1],
                   z = xyz[3 * j + 2] - xyz[3 * i + 2];
      const double r = sqrt(x * x + y * y + z * z), s = pow(rest / r, 6);
      if (i / 2 == j / 2) {
        e->value += spring / 2 * (r - bond) * (r - bond);
        add_pair(xyz, i, j, spring * (r - bond), spring, e);
      } else {
        e->value += depth * (s * s - 2 * s);
        add_pair(xyz, i, j, 12 * depth / r * (s - s * s), depth / (r * r) * (156 * s * s - 84 * s), e);
      }
    }
  }
  status = smooth_energy_set(surface, BALLS, xyz, radius);
  if (status == HSP_OK) status = smooth_energy_gradient(surface, &value, gradient);
  if (status == HSP_OK) status = smooth_energy_add_matrix(surface, tension, e->matrix);
  if (status != HSP_OK) return status;
  e->value += tension * value;
  for (int k = 0; k < N; ++k) e->gradient[k] += tension * gradient[k];
  return HSP_OK;
}

/* Eigenvalues of a symmetric matrix, which becomes diagonal, and its vectors, the columns of v: Jacobi 1846. */
static void diagonalise(double *a, double *v) {
  for (int i = 0; i < N * N; ++i) v[i] = i % (N + 1) == 0;
  for (int sweep = 0; sweep < 30; ++sweep) {
    double off = 0;
    for (int p = 0; p < N; ++p) {
      for (int q = p + 1; q < N; ++q) {
        double theta, t, c, s;
        off += a[p * N + q] * a[p * N + q];
        if (fabs(a[p * N + q]) < 1e-300) continue;
        theta = (a[q * N + q] - a[p * N + p]) / (2 * a[p * N + q]);
        t = (theta >= 0 ? 1 : -1) / (fabs(theta) + sqrt(theta * theta + 1));
        c = 1 / sqrt(t * t + 1);
        s = t * c;
        for (int k = 0; k < N; ++k) {
          const double x = a[k * N + p], y = a[k * N + q];
          a[k * N + p] = c * x - s * y;
          a[k * N + q] = s * x + c * y;
        }
        for (int k = 0; k < N; ++k) {
          const double x = a[p * N + k], y = a[q * N + k], z = v[k * N + p], w = v[k * N + q];
          a[p * N + k] = c * x - s * y;
          a[q * N + k] = s * x + c * y;
          v[k * N + p] = c * z - s * w;
          v[k * N + q] = s * z + c * w;
        }
      }
    }
    if (off < 1e-26) return;
  }
}

/* Against the gradient along each eigenvector, by the size of its eigenvalue: downhill also where that is negative.
 * Motions of the whole are left out; no coordinate moves by more than 0.2. */
static void newton_step(const struct energy *e, double *step) {
  static double a[N * N], v[N * N];
  double longest = 0;
  memcpy(a, e->matrix, sizeof a);
  memset(step, 0, N * sizeof *step);
  diagonalise(a, v);
  for (int i = 0; i < N; ++i) {
    double along = 0;
    if (fabs(a[i * N + i]) < 1e-6) continue;
    for (int k = 0; k < N; ++k) along += v[k * N + i] * e->gradient[k];
    for (int k = 0; k < N; ++k) step[k] -= along / fmax(fabs(a[i * N + i]), 1e-3) * v[k * N + i];
  }
  for (int k = 0; k < N; ++k) longest = fmax(longest, fabs(step[k]));
  for (int k = 0; k < N && longest > 0.2; ++k) step[k] *= 0.2 / longest;
}

static double largest(const double *gradient) {
  double size = 0;
  for (int k = 0; k < N; ++k) size = fmax(size, fabs(gradient[k]));
  return size;
}

/* A number in [-1, 1), the next of a fixed row of them. */
static double jitter(uint64_t *state) {
  *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return (double)(*state >> 11) * 0x1p-52 - 1;
}

int main(int count, char **arguments) {
  static struct energy here, there;
  smooth_energy surface = {.step = 1e-8, .largest_radius = 2};
  uint64_t start = count > 2 ? strtoull(arguments[2], NULL, 10) : 3;
  double xyz[N], step[N], next[N];
  int32_t status;
  surface.window = count > 1 ? strtod(arguments[1], NULL) : 0.05;
  for (int i = 0; i < BALLS; ++i) {
    radius[i] = 1.7;
    xyz[3 * i] = 3.7 * (i / 2 % 2) + 0.3 * jitter(&start);
    xyz[3 * i + 1] = 3.7 * (i / 4) + 0.3 * jitter(&start);
    xyz[3 * i + 2] = bond * (i % 2) + 0.3 * jitter(&start);
  }
  status = evaluate(&surface, xyz, &here);
  for (int k = 0; k < MOST_STEPS && status == HSP_OK && largest(here.gradient) > 1e-12; ++k) {
    double scale = 1;
    int better = 0;
    printf("%3d  energy %16.10f  gradient %.1e\n", k, here.value, largest(here.gradient));
    newton_step(&here, step);
    for (; scale > 1e-9 && status == HSP_OK && !better; scale /= 2) {
      for (int q = 0; q < N; ++q) next[q] = xyz[q] + scale * step[q];
      status = evaluate(&surface, next, &there);
      /* near the minimum the energy's last digits say nothing any more, and the gradient decides */
      better = there.value < here.value ||
               (there.value < here.value + 1e-9 && largest(there.gradient) < largest(here.gradient));
    }
    if (!better) break;
    memcpy(xyz, next, sizeof xyz);
    here = there;
  }
  if (status != HSP_OK) fprintf(stderr, "newton: %s\n", hsp_status_text(status));
  if (status == HSP_OK) printf("ends at energy %.10f, gradient %.1e\n", here.value, largest(here.gradient));
  smooth_energy_free(&surface);
  return status == HSP_OK ? 0 : 1;
}
