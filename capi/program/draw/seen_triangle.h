/* A triangle on the page. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* A triangle in whole units, with the depths of its corners. */
struct seen_triangle {
  int32_t at[3][2];
  double depth[3];
  uint32_t number; /* for the caller; all differ */
  uint32_t layer;
  bool whole;      /* it is painted as a whole, not cut */
  uint32_t points; /* how many points of it are seen; 0: it is not painted */
};

double seen_triangle_middle(const struct seen_triangle *triangle); /* the depth of its middle */

/* Twice the area, below 0 if it is clockwise. */
double seen_triangle_area(const struct seen_triangle *triangle);

/* The distance of a point from the k-th edge of a triangle, positive on the inner side, times the edge's length. */
double seen_triangle_side(const struct seen_triangle *triangle, int k, const double at[2]);

/* The depth of a triangle's plane over a point; for a triangle without area the depth of its middle. */
double seen_triangle_depth(const struct seen_triangle *triangle, const double at[2]);

/* The box of a triangle; and that of all triangles, which is not changed if there are none. The latter returns the sum
 * of the sides of all single boxes. */
void seen_triangle_box(const struct seen_triangle *triangle, int32_t low[2], int32_t high[2]);
int64_t seen_triangles_page(const struct seen_triangle *triangle, uint32_t count, int32_t low[2], int32_t high[2]);
