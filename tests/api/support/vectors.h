/* Vectors of three doubles, for checks of positions, and how close numbers are. */
#pragma once

#include <math.h>

static const double pi = 3.14159265358979323846;

static inline double dot(const double u[3], const double v[3]) {
  return u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
}

static inline double length(const double v[3]) {
  return sqrt(dot(v, v));
}

static inline void cross(const double u[3], const double v[3], double w[3]) {
  w[0] = u[1] * v[2] - u[2] * v[1];
  w[1] = u[2] * v[0] - u[0] * v[2];
  w[2] = u[0] * v[1] - u[1] * v[0];
}

static inline void difference(const double to[3], const double from[3], double v[3]) {
  int axis;
  for (axis = 0; axis < 3; ++axis) v[axis] = to[axis] - from[axis];
}

static inline int near(double a, double b, double tolerance) {
  return fabs(a - b) <= tolerance; /* false for NaN */
}

/* An upper bound of the error that the rounding of coordinates of this size causes in a computed position. */
static inline double position_error(const double xyz[3]) {
  return 1e-15 * (fabs(xyz[0]) + fabs(xyz[1]) + fabs(xyz[2]));
}
