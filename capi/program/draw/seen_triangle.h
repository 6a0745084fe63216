/* A triangle on the page. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

/* In whole units, with the depths of its corners. */
struct seen_triangle {
  int32_t at[3][2];
  double depth[3];
  uint32_t number; /* anything of the caller's, each once */
  uint32_t layer;
  bool whole;      /* it is painted as a whole, not cut */
  uint32_t points; /* of it that are seen; 0: it is not painted */
};

double seen_triangle_middle(const struct seen_triangle *triangle); /* the depth there */

/* Twice the area, below 0 if it is clockwise. */
double seen_triangle_area(const struct seen_triangle *triangle);

/* How far on its inner side of the k-th edge of a triangle a point lies, times the edge's length. */
double seen_triangle_side(const struct seen_triangle *triangle, int k, const double at[2]);

/* The depth of its plane over a point; of one without an area that of its middle. */
double seen_triangle_depth(const struct seen_triangle *triangle, const double at[2]);

/* The box of a triangle, and that of all, which is left as it is without any; returns the sum of the sides of their
 * own. */
void seen_triangle_box(const struct seen_triangle *triangle, int32_t low[2], int32_t high[2]);
int64_t seen_triangles_page(const struct seen_triangle *triangle, uint32_t count, int32_t low[2], int32_t high[2]);
