/* Vectors in space. */
#pragma once

#include <math.h>

static inline double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline void cross(const double a[3], const double b[3], double out[3]) {
  for (int k = 0; k < 3; ++k) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* hypot differs from one mathematics library to the next; sqrt does not. */
static inline double vector_length(const double v[3]) {
  return sqrt(dot(v, v));
}

static inline double distance_between(const double a[3], const double b[3]) {
  const double way[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  return vector_length(way);
}
