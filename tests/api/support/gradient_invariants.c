#include "gradient_invariants.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "vectors.h"

/* A gradient, and how large the terms are that its sums are made of. */
typedef struct gradient {
  uint32_t n;
  hsp_energy energy;
  double *centre, *radius;
  uint32_t *flags;
} gradient;

static const char *gradient_make(const computed *c, const double *sigma, double tension, double pressure,
                                 uint32_t tangency, gradient *g) {
  uint32_t i;
  g->n = c->n;
  g->centre = test_zeros(c->n, 3 * sizeof *g->centre);
  g->radius = test_zeros(c->n, sizeof *g->radius);
  g->flags = test_zeros(c->n, sizeof *g->flags);
  if (hsp_boundary_get_gradient(
          c->boundary,
          SIZED(hsp_gradient_request, .sigma = sigma, .tension = tension, .pressure = pressure, .tangency = tangency),
          SIZED(hsp_gradient_outputs, .energy = &g->energy, .d_centre = g->centre, .d_radius = g->radius,
                .flags = g->flags, .capacity = c->n)) != HSP_OK) {
    return "hsp_boundary_get_gradient: not HSP_OK";
  }
  for (i = 0; i < c->n; ++i) {
    if (!(isfinite(length(g->centre + 3 * i)) && isfinite(g->radius[i]))) return "a derivative is not finite";
    if ((g->flags[i] & ~HSP_GRADIENT_ONE_SIDED) != 0) return "unknown flags of a gradient";
  }
  return NULL;
}

static void gradient_release(gradient *g) {
  free(g->centre);
  free(g->radius);
  free(g->flags);
}

/* A sum that should be 0, with the sum of the sizes of its terms. */
typedef struct balance {
  double sum, size;
} balance;

static void add_term(balance *b, double term) {
  b->sum += term;
  b->size += fabs(term);
}

static double largest_size(const balance b[3]) {
  return fmax(fmax(b[0].size, b[1].size), b[2].size);
}

double slope_of_arcs(const computed *c, uint32_t i, uint32_t j) {
  double off[3];
  difference(c->xyz + 3 * j, c->xyz + 3 * i, off);
  return c->radius[i] * c->radius[j] / length(off);
}

/* A lower bound for the size of terms before they cancel: the largest term of a single whole sphere. */
static double largest_term(const computed *c, const double *sigma, double tension, double pressure) {
  const double r = c->info.largest_radius;
  double weight = 1, slope = r;
  uint32_t i;
  for (i = 0; i < c->n && sigma != NULL; ++i) weight = fmax(weight, fabs(sigma[i]));
  for (i = 0; i < c->counts.arcs; ++i) slope = fmax(slope, slope_of_arcs(c, c->arcs[i].ball[0], c->arcs[i].ball[1]));
  for (i = 0; i < c->counts.circles; ++i)
    slope = fmax(slope, slope_of_arcs(c, c->circles[i].ball[0], c->circles[i].ball[1]));
  return weight * (fabs(tension) * slope + fabs(pressure) * r * r);
}

/* Neither a translation nor a rotation changes an energy. */
static const char *broken_motions(const computed *c, const gradient *g, double least) {
  balance force[3], torque[3];
  double forces, torques;
  uint32_t i;
  int axis;
  memset(force, 0, sizeof force);
  memset(torque, 0, sizeof torque);
  for (i = 0; i < c->n; ++i) {
    const double *at = c->xyz + 3 * i, *slope = g->centre + 3 * i;
    for (axis = 0; axis < 3; ++axis) {
      const int next = (axis + 1) % 3, last = (axis + 2) % 3;
      add_term(&force[axis], slope[axis]);
      add_term(&torque[axis], at[next] * slope[last]);
      add_term(&torque[axis], -at[last] * slope[next]);
    }
  }
  forces = fmax(largest_size(force), least);
  torques = fmax(largest_size(torque), least * c->extent);
  for (axis = 0; axis < 3; ++axis) {
    if (!near(force[axis].sum, 0, 1e-11 * forces)) return "hsp_boundary_get_gradient, property 1: translations";
    if (!near(torque[axis].sum, 0, 1e-11 * torques + 8 * c->rounding * forces)) {
      return "hsp_boundary_get_gradient, property 1: rotations";
    }
  }
  return NULL;
}

/* Areas grow with the square, volumes with the cube of all lengths. */
static const char *broken_dilation(const computed *c, const gradient *g, double tension, double pressure,
                                   double least) {
  balance all = {0, 0}, slopes = {0, 0};
  uint32_t i, axis;
  for (i = 0; i < c->n; ++i) {
    for (axis = 0; axis < 3; ++axis) {
      add_term(&all, c->xyz[3 * i + axis] * g->centre[3 * i + axis]);
      add_term(&slopes, g->centre[3 * i + axis]);
    }
    add_term(&all, c->radius[i] * g->radius[i]);
    add_term(&slopes, g->radius[i]);
  }
  add_term(&all, -2 * tension * g->energy.area);
  add_term(&all, -3 * pressure * g->energy.volume);
  if (near(all.sum, 0,
           1e-11 * fmax(all.size, least * (c->extent + c->info.largest_radius)) + 8 * c->rounding * slopes.size))
    return NULL;
  return "hsp_boundary_get_gradient, property 2: dilations";
}

static const char *broken_energy(const computed *c, const double *sigma, const gradient *g, double tension,
                                 double pressure) {
  const hsp_energy *energy = &g->energy;
  balance area = {0, 0}, radii = {0, 0};
  double volumes = 0;
  uint32_t i;
  for (i = 0; i < c->n; ++i) {
    add_term(&area, (sigma == NULL ? 1 : sigma[i]) * c->area[i]);
    add_term(&radii, g->radius[i]);
    volumes += fabs(c->volume[i]);
  }
  if (!near(energy->area, area.sum, 1e-12 * area.size)) return "energy.area is not that of hsp_boundary_measure";
  if (!near(energy->volume, c->totals.volume, 1e-12 * volumes)) {
    return "energy.volume is not that of hsp_boundary_measure";
  }
  if (!near(energy->value, tension * energy->area + pressure * energy->volume,
            1e-15 * (fabs(tension * energy->area) + fabs(pressure * energy->volume)))) {
    return "energy.value is not tension * area + pressure * volume";
  }
  if (!near(energy->d_probe, radii.sum, 1e-13 * radii.size)) return "energy.d_probe is not the sum of dE/dr";
  return NULL;
}

static const char *broken_gradient(const computed *c, const double *sigma, double tension, double pressure,
                                   const gradient *g) {
  const double least = largest_term(c, sigma, tension, pressure);
  const char *broken = broken_energy(c, sigma, g, tension, pressure);
  uint32_t i;
  if (broken == NULL) broken = broken_motions(c, g, least);
  if (broken == NULL && sigma == NULL) broken = broken_dilation(c, g, tension, pressure, least);
  for (i = 0; i < c->n && broken == NULL; ++i) {
    if (c->balls[i].faces == 0 && (length(g->centre + 3 * i) != 0 || g->radius[i] != 0)) {
      broken = "a ball without faces has derivatives";
    }
    if (tension == 0 && !near(g->radius[i], pressure * c->area[i], 1e-13 * fabs(pressure) * c->area[i])) {
      broken = "the volume's derivative by a radius is not the ball's area";
    }
  }
  return broken;
}

/* tension times one gradient and pressure times another is the third. */
static const char *broken_sum(const computed *c, const double *sigma, const gradient *area, double tension,
                              const gradient *volume, double pressure, const gradient *both) {
  const double largest = largest_term(c, sigma, tension, pressure);
  uint32_t i, axis;
  for (i = 0; i < c->n; ++i) {
    for (axis = 0; axis <= 3; ++axis) {
      const double a = tension * (axis < 3 ? area->centre[3 * i + axis] : area->radius[i]);
      const double v = pressure * (axis < 3 ? volume->centre[3 * i + axis] : volume->radius[i]);
      const double sum = axis < 3 ? both->centre[3 * i + axis] : both->radius[i];
      if (!near(sum, a + v, 1e-13 * (fabs(a) + fabs(v) + largest))) {
        return "a gradient is not linear in tension and pressure";
      }
    }
    if (both->flags[i] != area->flags[i] || both->flags[i] != volume->flags[i]) {
      return "flags depend on tension or pressure";
    }
  }
  return NULL;
}

const char *broken_gradients(const computed *c, const double *sigma, double tension, double pressure,
                             uint32_t tangency) {
  static const double terms[2][2] = {{1, 0}, {0, 1}};
  gradient g[3];
  const char *broken[3], *first = NULL;
  int k;
  for (k = 0; k < 3; ++k) {
    const double t = k < 2 ? terms[k][0] : tension, p = k < 2 ? terms[k][1] : pressure;
    broken[k] = gradient_make(c, sigma, t, p, tangency, &g[k]);
    if (broken[k] == NULL) broken[k] = broken_gradient(c, sigma, t, p, &g[k]);
    if (first == NULL) first = broken[k];
  }
  if (first == NULL) first = broken_sum(c, sigma, &g[0], tension, &g[1], pressure, &g[2]);
  for (k = 0; k < 3; ++k) gradient_release(&g[k]);
  return first;
}

static long long steps(double value, double step) {
  return (long long)floor(value / step + 0.5);
}

int spheres_touch(const computed *c, uint32_t i, uint32_t j) {
  const double step = c->info.step;
  const long long r = steps(c->radius[i], step), s = steps(c->radius[j], step);
  /* Compared as distance^2 - (r - s)^2 = 4 r s or 0, modulo 2^64, which decides as both sides are far below that. */
  unsigned long long squared = 0, difference = (unsigned long long)(r - s) * (unsigned long long)(r - s);
  uint32_t axis;
  for (axis = 0; axis < 3; ++axis) {
    const long long d = steps(c->xyz[3 * i + axis], step) - steps(c->xyz[3 * j + axis], step);
    /* farther apart than any two radii reach */
    if (d > (1LL << 31) || d < -(1LL << 31)) return 0;
    squared += (unsigned long long)d * (unsigned long long)d;
  }
  return squared == difference || squared - difference == 4 * (unsigned long long)r * (unsigned long long)s;
}

static const char *broken_tangency(const computed *c, const gradient *meeting, const gradient *apart) {
  uint32_t i, j;
  if (memcmp(&meeting->energy.value, &apart->energy.value, 3 * sizeof(double)) != 0)
    return "energy depends on tangency";
  for (i = 0; i < c->n; ++i) {
    int touches = 0;
    if (meeting->flags[i] != apart->flags[i]) return "flags depend on tangency";
    if (meeting->flags[i] == 0) {
      if (memcmp(meeting->centre + 3 * i, apart->centre + 3 * i, 3 * sizeof(double)) != 0 ||
          memcmp(meeting->radius + i, apart->radius + i, sizeof(double)) != 0) {
        return "a gradient without flag depends on tangency";
      }
      continue;
    }
    for (j = 0; j < c->n; ++j) touches |= j != i && spheres_touch(c, i, j);
    if (!touches) return "a flag of a ball that touches none";
  }
  return NULL;
}

const char *broken_gradient_flags(const computed *c, const double *sigma) {
  gradient meeting, apart;
  const char *first = gradient_make(c, sigma, 1, -1, HSP_TANGENT_OVERLAP, &meeting);
  const char *second = gradient_make(c, sigma, 1, -1, HSP_TANGENT_DISJOINT, &apart);
  const char *broken = first != NULL ? first : second;
  if (broken == NULL) broken = broken_tangency(c, &meeting, &apart);
  gradient_release(&meeting);
  gradient_release(&apart);
  return broken;
}

/* One ball's part without its id. */
typedef struct plain_part {
  double xyz[3], r, centre[3], radius;
  uint64_t flags;
} plain_part;

static int by_bytes(const void *a, const void *b) {
  return memcmp(a, b, sizeof(plain_part));
}

static plain_part *plain_parts(const computed *c, const gradient *g) {
  plain_part *parts = test_zeros(c->n, sizeof *parts);
  uint32_t i;
  for (i = 0; i < c->n; ++i) {
    memcpy(parts[i].xyz, c->xyz + 3 * i, sizeof parts[i].xyz);
    parts[i].r = c->radius[i];
    memcpy(parts[i].centre, g->centre + 3 * i, sizeof parts[i].centre);
    parts[i].radius = g->radius[i];
    parts[i].flags = g->flags[i];
  }
  qsort(parts, c->n, sizeof *parts, by_bytes);
  return parts;
}

const char *gradient_difference_after_permutation(const computed *c, const double *sigma, const computed *other,
                                                  const double *other_sigma, uint32_t tangency) {
  gradient here, there;
  const char *first = gradient_make(c, sigma, 0.5, 0.25, tangency, &here);
  const char *second = gradient_make(other, other_sigma, 0.5, 0.25, tangency, &there);
  const char *what = first != NULL ? first : second;
  plain_part *parts = plain_parts(c, &here), *other_parts = plain_parts(other, &there);
  if (what == NULL && (c->n != other->n || memcmp(parts, other_parts, c->n * sizeof *parts) != 0)) {
    what = "gradients depend on the order of the balls";
  }
  if (what == NULL &&
      !near(here.energy.value, there.energy.value, 1e-12 * (fabs(here.energy.area) + fabs(here.energy.volume)))) {
    what = "energies depend on the order of the balls";
  }
  free(parts);
  free(other_parts);
  gradient_release(&here);
  gradient_release(&there);
  return what;
}
