/* Curves through points that rise and fall as these do. */
#pragma once

#include <stddef.h>

/* The slopes of a cubic Hermite spline through points (x, y) of which x does not fall: between two of them the curve
 * stays within their y (Fritsch and Butland 1984), so that its extrema are among the points. 0 where it could leap. */
void smooth_curve_slopes(const double *x, const double *y, size_t count, double *slope);
