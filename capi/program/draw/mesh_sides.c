#include "draw/mesh_sides.h"

#include <stdlib.h>

static bool is_before(const struct mesh_side *a, const struct mesh_side *b) {
  return a->high != b->high ? a->high < b->high : a->triangle < b->triangle;
}

/* Sides are distributed by their lower ends; each end has only few. */
struct mesh_side *mesh_sides_find(const struct triangle_mesh *mesh) {
  const size_t corners = 3 * (size_t)mesh->triangles;
  struct mesh_side *sides = calloc(corners + 1, sizeof *sides);
  size_t *begin = calloc((size_t)mesh->vertices + 2, sizeof *begin);
  for (int pass = 0; pass < 2 && sides != NULL && begin != NULL; ++pass) {
    for (size_t corner = 0; corner < corners; ++corner) {
      const uint32_t from = mesh->corners[corner], to = mesh->corners[corner % 3 == 2 ? corner - 2 : corner + 1];
      const struct mesh_side side = {from < to ? from : to, from < to ? to : from, (uint32_t)(corner / 3), from > to};
      if (pass == 0) {
        ++begin[side.low + 2];
        continue;
      }
      size_t at = begin[side.low + 1]++;
      while (at > 0 && sides[at - 1].low == side.low && is_before(&side, &sides[at - 1])) {
        sides[at] = sides[at - 1];
        --at;
      }
      sides[at] = side;
    }
    for (size_t v = 2; v < (size_t)mesh->vertices + 2 && pass == 0; ++v) begin[v] += begin[v - 1];
  }
  if (begin == NULL) free(sides);
  if (begin == NULL) return NULL;
  free(begin);
  return sides;
}

bool mesh_sides_share_edge(const struct mesh_side side[2]) {
  return side[0].low == side[1].low && side[0].high == side[1].high;
}
