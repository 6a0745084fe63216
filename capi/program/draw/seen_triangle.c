#include "draw/seen_triangle.h"

double seen_triangle_middle(const struct seen_triangle *triangle) {
  return (triangle->depth[0] + triangle->depth[1] + triangle->depth[2]) / 3.0;
}

double seen_triangle_area(const struct seen_triangle *a) {
  return (double)(a->at[1][0] - a->at[0][0]) * (a->at[2][1] - a->at[0][1]) -
         (double)(a->at[1][1] - a->at[0][1]) * (a->at[2][0] - a->at[0][0]);
}

double seen_triangle_side(const struct seen_triangle *triangle, int k, const double at[2]) {
  const int32_t *from = triangle->at[k];
  const int32_t *to = triangle->at[(k + 1) % 3];
  const double side = ((double)to[0] - from[0]) * (at[1] - from[1]) - ((double)to[1] - from[1]) * (at[0] - from[0]);
  return seen_triangle_area(triangle) < 0.0 ? -side : side;
}

double seen_triangle_depth(const struct seen_triangle *triangle, const double at[2]) {
  double sum = 0.0, sides = 0.0;
  for (int k = 0; k < 3; ++k) {
    const double side = seen_triangle_side(triangle, k, at);
    sum += side * triangle->depth[(k + 2) % 3];
    sides += side;
  }
  return sides > 0.0 ? sum / sides : seen_triangle_middle(triangle);
}

void seen_triangle_box(const struct seen_triangle *triangle, int32_t low[2], int32_t high[2]) {
  for (int axis = 0; axis < 2; ++axis) {
    low[axis] = high[axis] = triangle->at[0][axis];
    for (int k = 1; k < 3; ++k) {
      const int32_t at = triangle->at[k][axis];
      if (at < low[axis]) low[axis] = at;
      if (at > high[axis]) high[axis] = at;
    }
  }
}

int64_t seen_triangles_page(const struct seen_triangle *triangle, uint32_t count, int32_t low[2], int32_t high[2]) {
  int64_t sides = 0;
  for (uint32_t i = 0; i < count; ++i) {
    int32_t own[2][2];
    seen_triangle_box(&triangle[i], own[0], own[1]);
    for (int axis = 0; axis < 2; ++axis) {
      if (i == 0 || own[0][axis] < low[axis]) low[axis] = own[0][axis];
      if (i == 0 || own[1][axis] > high[axis]) high[axis] = own[1][axis];
      sides += own[1][axis] - (int64_t)own[0][axis];
    }
  }
  return sides;
}
