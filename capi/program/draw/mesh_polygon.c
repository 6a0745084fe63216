#include "draw/mesh_polygon.h"

#include <stdbool.h>

struct corner polygon_between(const struct corner *a, const struct corner *b, double value_a, double value_b) {
  bool swapped = false;
  for (int k = 0; k < 3; ++k) {
    if (a->at[k] == b->at[k]) continue;
    swapped = a->at[k] > b->at[k];
    break;
  }
  if (swapped) return polygon_between(b, a, value_b, value_a);
  const double share = value_a / (value_a - value_b);
  struct corner corner;
  for (int k = 0; k < 3; ++k) corner.at[k] = a->at[k] + share * (b->at[k] - a->at[k]);
  corner.circle = a->circle + share * (b->circle - a->circle);
  return corner;
}

struct polygon polygon_cut_off(const struct polygon *polygon, const double value[MOST_CORNERS], int on) {
  struct polygon left = {.corners = 0};
  for (int k = 0; k < polygon->corners; ++k) {
    const int next = (k + 1) % polygon->corners;
    if (value[k] <= 0.0 && left.corners < MOST_CORNERS) left.corner[left.corners++] = polygon->corner[k];
    if ((value[k] < 0.0 && value[next] > 0.0) || (value[k] > 0.0 && value[next] < 0.0)) {
      if (left.corners == MOST_CORNERS) continue;
      struct corner *const made = &left.corner[left.corners++];
      *made = polygon_between(&polygon->corner[k], &polygon->corner[next], value[k], value[next]);
      made->on = on | (polygon->corner[k].on & polygon->corner[next].on);
    }
  }
  return left;
}
