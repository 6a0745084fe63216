/* Curves through points that rise only where the points rise, and fall only where they fall. */
#pragma once

#include <stddef.h>

/* The slopes of a cubic Hermite spline through points (x, y) whose x do not fall. Between two points the curve stays
 * between their y (Fritsch and Butland 1984), so that its extrema are points. The slope is 0 where it could leap. */
void smooth_curve_slopes(const double *x, const double *y, size_t count, double *slope);
