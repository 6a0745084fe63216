#include "commands/mesh_pockets.h"

#include <stdlib.h>
#include <string.h>

enum { UNKNOWN = 0xFF };

static const double below = 0.01; /* the narrowest probe: so the one that touches fits for all rounding; of an edge */

/* The pocket of each maximum, from 1 on; 0: none that has a colour. */
static int32_t mark_maxima(const hsp_pores *pores, uint32_t all, double least, uint32_t *maxima, uint32_t room,
                           struct mesh_pockets *found, uint8_t *of_maximum) {
  int32_t status = HSP_OK;
  for (uint32_t p = 0; status == HSP_OK && p < all && found->count < MESH_POCKETS; ++p) {
    hsp_pore_pocket pocket;
    hsp_pore_maximum widest;
    uint32_t needed = 0;
    status = hsp_pores_get_pockets(pores, p, 1, &pocket);
    if (status == HSP_OK && pocket.radius - pocket.mouth < least) continue;
    if (status == HSP_OK) status = hsp_pores_get_pocket_maxima(pores, p, maxima, room, &needed);
    if (status == HSP_OK) status = hsp_pores_get_maxima(pores, pocket.maximum, 1, &widest);
    if (status != HSP_OK) return status;
    if (found->count == 0) memcpy(found->through, widest.xyz, sizeof found->through);
    found->number[found->count++] = p + 1;
    for (uint32_t k = 0; k < needed; ++k) of_maximum[maxima[k]] = (uint8_t)found->count;
  }
  return status;
}

/* *of_maximum is to be freed on every status. */
static int32_t find_pockets(hsp_pores *pores, double wide, double least, struct mesh_pockets *found,
                            uint8_t **of_maximum) {
  hsp_pores_counts counts;
  uint32_t all = 0;
  int32_t status = hsp_pores_get_counts(pores, &counts);
  if (status == HSP_OK) status = hsp_pores_find_pockets(pores, 0.0, wide, &all);
  if (status != HSP_OK) return status;
  uint32_t *const maxima = malloc(((size_t)counts.maxima + 1) * sizeof *maxima);
  *of_maximum = calloc((size_t)counts.maxima + 1, 1);
  const bool enough = maxima != NULL && *of_maximum != NULL;
  status = enough ? mark_maxima(pores, all, least, maxima, counts.maxima, found, *of_maximum) : HSP_E_MEMORY;
  free(maxima);
  return status;
}

/* The pocket where a probe is that touches the surface at a corner of a triangle. */
static int32_t locate(const hsp_pores *pores, const struct triangle_mesh *mesh, uint32_t triangle, double above,
                      const uint8_t *of_maximum, uint8_t *pocket) {
  const size_t vertex = mesh->corners[3 * (size_t)triangle];
  double xyz[3];
  hsp_pore_place place;
  for (size_t axis = 0; axis < 3; ++axis) {
    xyz[axis] = mesh->xyz[3 * vertex + axis] + above * mesh->normals[3 * vertex + axis];
  }
  const int32_t status = hsp_pores_locate(pores, xyz, &place);
  if (status != HSP_OK) return status;
  *pocket = place.maximum == HSP_NONE || place.maximum == HSP_PORE_OUTSIDE ? 0 : of_maximum[place.maximum];
  return HSP_OK;
}

/* A concave patch has one place of the probe. */
static int32_t find_triangles(const hsp_pores *pores, const struct triangle_mesh *mesh, double above,
                              const uint8_t *of_maximum, struct mesh_pockets *found) {
  for (uint32_t t = 0; t < mesh->triangles; ++t) {
    uint8_t *const of_patch = &found->of_patch[mesh->patches[t]];
    const bool known = mesh->kinds[t] == HSP_PATCH_CONCAVE && *of_patch != UNKNOWN;
    const int32_t status = known ? HSP_OK : locate(pores, mesh, t, above, of_maximum, of_patch);
    if (status != HSP_OK) return status;
    found->of_triangle[t] = *of_patch;
  }
  return HSP_OK;
}

bool mesh_pockets_find(struct geometry *geometry, const struct triangle_mesh *mesh, bool smooth, double wide,
                       double least, struct mesh_pockets *pockets, struct failure *failure) {
  const hsp_pores_options options = {
      .struct_size = (uint32_t)sizeof options, .reserved = 0, .floor = -below * mesh->edge};
  uint8_t *of_maximum = NULL;
  uint32_t patches = 0;
  progress_show(&geometry->progress, "looking for pockets");
  int32_t status = hsp_workspace_pores(&geometry->work, &options);
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--pockets: %s", geometry_reason(status));
  /* The balls of the model are grown by the probe. */
  if (status == HSP_OK) status = find_pockets(geometry->work.pores, wide - mesh->probe, least, pockets, &of_maximum);
  for (uint32_t t = 0; t < mesh->triangles; ++t) patches = mesh->patches[t] < patches ? patches : mesh->patches[t] + 1;
  pockets->of_patch = calloc((size_t)patches + 1, 1);
  pockets->of_triangle = calloc((size_t)mesh->triangles + 1, 1);
  const bool enough = pockets->of_patch != NULL && pockets->of_triangle != NULL;
  if (status == HSP_OK && !enough) status = HSP_E_MEMORY;
  if (status == HSP_OK) {
    memset(pockets->of_patch, UNKNOWN, patches);
    status = find_triangles(geometry->work.pores, mesh, smooth ? mesh->probe : 0.0, of_maximum, pockets);
  }
  free(of_maximum);
  return status == HSP_OK || failure_in_library(failure, status);
}
