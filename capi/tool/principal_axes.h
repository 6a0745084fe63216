/* How points are spread in space. */
#ifndef HARDSPHERE_TOOL_PRINCIPAL_AXES_H
#define HARDSPHERE_TOOL_PRINCIPAL_AXES_H

#include <stdint.h>

/* The principal axes of points [count][3] of equal weight, about their mean: unit vectors, right-handed, the one along
 * which they spread most first. The largest coordinate of the first and of the second is positive; where two directions
 * have the same spread, the one nearer to the earlier axis of the file comes first. The same bits on every machine. */
void principal_axes(const double *points, uint32_t count, double axis[3][3]);

#endif
