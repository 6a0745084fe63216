#include "draw/mesh_parts.h"

#include <math.h>
#include <stdlib.h>

#include "read/vectors.h"

enum { CRUMB_PART = 100 };

uint32_t mesh_parts_root(uint32_t *root, uint32_t v) {
  while (root[v] != v) {
    root[v] = root[root[v]];
    v = root[v];
  }
  return v;
}

static double determinant(const double *a, const double *b, const double *c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* Triangles are counter-clockwise seen from outside the balls: around a void the volume is negative. */
static void find_connected(const struct triangle_mesh *mesh, struct mesh_parts *parts) {
  for (uint32_t v = 0; v < mesh->vertices; ++v) parts->root[v] = v;
  for (size_t t = 0; t < mesh->triangles; ++t) {
    const uint32_t *c = mesh->corners + 3 * t;
    for (int k = 1; k < 3; ++k) parts->root[mesh_parts_root(parts->root, c[k])] = mesh_parts_root(parts->root, c[0]);
  }
  for (uint32_t v = 0; v < mesh->vertices; ++v) parts->root[v] = mesh_parts_root(parts->root, v);
  for (size_t t = 0; t < mesh->triangles; ++t) {
    const uint32_t *c = mesh->corners + 3 * t;
    const uint32_t root = parts->root[c[0]];
    double side[3][3];
    for (int k = 0; k < 9; ++k) {
      side[k / 3][k % 3] =
          parts->seen[3 * (size_t)c[k / 3] + (size_t)(k % 3)] - parts->seen[3 * (size_t)root + (size_t)(k % 3)];
    }
    parts->volume[root] += determinant(side[0], side[1], side[2]) / 6.0;
  }
}

bool mesh_parts_is_of_void(const struct mesh_parts *parts, uint32_t vertex) {
  return parts->volume[parts->root[vertex]] < 0.0;
}

static void look(const struct triangle_mesh *mesh, const double axis[3][3], struct mesh_parts *parts) {
  for (size_t v = 0; v < mesh->vertices; ++v) {
    const double *at = mesh->xyz + 3 * v;
    for (int k = 0; k < 3; ++k) {
      const double x = dot(axis[k], at);
      parts->seen[3 * v + (size_t)k] = x;
      if (v == 0 || x < parts->low[k]) parts->low[k] = x;
      if (v == 0 || x > parts->high[k]) parts->high[k] = x;
    }
  }
}

static double find_plane(const struct triangle_mesh *mesh, const struct mesh_parts *parts) {
  uint32_t largest = UINT32_MAX;
  for (uint32_t v = 0; v < mesh->vertices; ++v) {
    const double volume = parts->volume[v];
    if (volume < 0.0 && (largest == UINT32_MAX || volume < parts->volume[largest])) largest = v;
  }
  double low = parts->low[2];
  double high = parts->high[2];
  bool any = false;
  for (uint32_t v = 0; v < mesh->vertices && largest != UINT32_MAX; ++v) {
    if (parts->root[v] != largest) continue;
    const double depth = parts->seen[3 * (size_t)v + 2];
    if (!any || depth < low) low = depth;
    if (!any || depth > high) high = depth;
    any = true;
  }
  return low / 2.0 + high / 2.0;
}

static bool is_behind(const struct mesh_parts *parts, uint32_t vertex) {
  return parts->seen[3 * (size_t)vertex + 2] <= parts->cut;
}

/* One of the corners behind the plane, or UINT32_MAX; *crosses becomes whether there are others before it. */
static uint32_t corner_behind(const struct mesh_parts *parts, const uint32_t *corner, bool *crosses) {
  uint32_t behind = UINT32_MAX;
  *crosses = false;
  for (int k = 0; k < 3; ++k) {
    if (is_behind(parts, corner[k])) {
      behind = corner[k];
    } else {
      *crosses = true;
    }
  }
  return behind;
}

/* The connected pieces behind the plane, by their roots; for each the number of its triangles, and whether the plane
 * cuts it. */
struct pieces {
  uint32_t *root;      /* [vertices] */
  uint32_t *triangles; /* [vertices] */
  bool *is_cut;        /* [vertices] */
};

static void drop_crumbs(const struct triangle_mesh *mesh, uint32_t of_outside, struct mesh_parts *parts,
                        const struct pieces *pieces) {
  bool crosses = false;
  uint32_t all = 0;
  for (uint32_t v = 0; v < mesh->vertices; ++v) pieces->root[v] = v;
  for (size_t t = 0; t < of_outside; ++t) {
    const uint32_t *c = mesh->corners + 3 * t;
    const uint32_t behind = corner_behind(parts, c, &crosses);
    for (int k = 0; k < 3 && behind != UINT32_MAX; ++k) {
      if (is_behind(parts, c[k]))
        pieces->root[mesh_parts_root(pieces->root, c[k])] = mesh_parts_root(pieces->root, behind);
    }
  }
  for (size_t t = 0; t < of_outside; ++t) {
    const uint32_t behind = corner_behind(parts, mesh->corners + 3 * t, &crosses);
    if (behind == UINT32_MAX || mesh_parts_is_of_void(parts, behind)) continue;
    const uint32_t root = mesh_parts_root(pieces->root, behind);
    ++pieces->triangles[root];
    if (crosses) pieces->is_cut[root] = true;
    ++all;
  }
  for (uint32_t v = 0; v < mesh->vertices; ++v) {
    const uint32_t root = mesh_parts_root(pieces->root, v);
    parts->dropped[v] = pieces->is_cut[root] && pieces->triangles[root] < all / CRUMB_PART;
  }
}

bool mesh_parts_cut(const struct triangle_mesh *mesh, uint32_t of_outside, const double *depth,
                    struct mesh_parts *parts) {
  const size_t v = (size_t)mesh->vertices + 1;
  const struct pieces pieces = {calloc(v, sizeof(uint32_t)), calloc(v, sizeof(uint32_t)), calloc(v, sizeof(bool))};
  const bool enough = pieces.root != NULL && pieces.triangles != NULL && pieces.is_cut != NULL;
  if (enough) {
    parts->cut = depth != NULL ? *depth : find_plane(mesh, parts);
    drop_crumbs(mesh, of_outside, parts, &pieces);
  }
  free(pieces.root);
  free(pieces.triangles);
  free(pieces.is_cut);
  return enough;
}

bool mesh_parts_find(const struct triangle_mesh *mesh, const double axis[3][3], struct mesh_parts *parts) {
  const size_t v = (size_t)mesh->vertices + 1;
  *parts = (struct mesh_parts){.seen = calloc(v, 3 * sizeof *parts->seen),
                               .root = calloc(v, sizeof *parts->root),
                               .volume = calloc(v, sizeof *parts->volume),
                               .dropped = calloc(v, sizeof *parts->dropped),
                               .cut = INFINITY};
  if (parts->seen == NULL || parts->root == NULL || parts->volume == NULL || parts->dropped == NULL) return false;
  look(mesh, axis, parts);
  find_connected(mesh, parts);
  return true;
}

void mesh_parts_free(struct mesh_parts *parts) {
  free(parts->seen);
  free(parts->root);
  free(parts->volume);
  free(parts->dropped);
}
