#include "draw/smooth_curve.h"

/* The slope of the chord from one point to the next; 0 if x stays the same. */
static double chord(const double *x, const double *y, size_t k) {
  return x[k + 1] > x[k] ? (y[k + 1] - y[k]) / (x[k + 1] - x[k]) : 0.0;
}

void smooth_curve_slopes(const double *x, const double *y, size_t count, double *slope) {
  for (size_t k = 0; k < count; ++k) {
    const double before = k > 0 ? chord(x, y, k - 1) : 0.0;
    const double after = k + 1 < count ? chord(x, y, k) : 0.0;
    if (k == 0 || k + 1 == count) {
      slope[k] = k == 0 ? after : before;
      continue;
    }
    const double near = x[k] - x[k - 1], far = x[k + 1] - x[k];
    /* A harmonic mean in which the shorter chord has more weight: at most three times the flatter slope. */
    const double first = 2.0 * far + near, second = far + 2.0 * near;
    slope[k] = before * after > 0.0 ? (first + second) / (first / before + second / after) : 0.0;
  }
}
