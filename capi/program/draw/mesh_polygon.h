/* Parts of triangles, cut along the line where a linear function is 0. */
#pragma once

enum { MOST_CORNERS = 12 };

struct corner {
  double at[3];  /* along the axes of the view */
  double circle; /* the circle of the light: surface_light.h */
  int on;        /* bits: the borders of a band of light on which it lies */
};

struct polygon {
  struct corner corner[MOST_CORNERS];
  int corners;
};

/* The point between two corners where a function is 0 that has these values, of different signs, at them. Both orders
 * of the corners give the same point, so that neighbours meet. */
struct corner polygon_between(const struct corner *a, const struct corner *b, double value_a, double value_b);

/* The part where the values at the corners are 0 or less; new corners are on the border `on`. */
struct polygon polygon_cut_off(const struct polygon *polygon, const double value[MOST_CORNERS], int on);
