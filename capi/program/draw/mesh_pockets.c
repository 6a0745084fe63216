#include "draw/mesh_pockets.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "commands/space_geometry.h"
#include "draw/mesh_split.h"
#include "draw/smooth_borders.h"
#include "read/stopping.h"

enum { MOST_LIFTS = 4 };

static const double below = 0.01; /* the narrowest probe: so the one that touches fits for all rounding; of an edge */
static const double edges_smoothed = 4.0; /* around a vertex */

/* The pocket of each maximum, from 1 on; OTHER_POCKETS: one that has no colour of its own; 0: none. The first ones of
 * the list [all] have colours. */
static int32_t mark_maxima(const hsp_pores *pores, const struct sized_pocket *list, uint32_t all, double least,
                           uint32_t *maxima, uint32_t room, struct mesh_pockets *found, uint8_t *of_maximum) {
  int32_t status = HSP_OK;
  for (uint32_t place = 0; status == HSP_OK && place < all; ++place) {
    const uint32_t p = list[place].pocket;
    hsp_pore_pocket pocket;
    hsp_pore_maximum widest;
    uint32_t needed = 0;
    status = hsp_pores_get_pockets(pores, p, 1, &pocket);
    if (status == HSP_OK) status = hsp_pores_get_pocket_maxima(pores, p, maxima, room, &needed);
    if (status == HSP_OK) status = hsp_pores_get_maxima(pores, pocket.maximum, 1, &widest);
    if (status != HSP_OK) return status;
    const bool coloured = pocket.radius - pocket.mouth >= least && found->count < MESH_POCKETS;
    if (coloured && found->count == 0) memcpy(found->through, widest.xyz, sizeof found->through);
    if (coloured) found->number[found->count++] = p + 1;
    for (uint32_t k = 0; k < needed; ++k) {
      of_maximum[maxima[k]] = (uint8_t)(coloured ? found->count : OTHER_POCKETS);
    }
  }
  return status;
}

/* All pockets that were found last, as a list that is to be freed; NULL: the failure says why. */
static struct sized_pocket *list_pockets(const struct geometry *geometry, uint32_t all, struct failure *failure) {
  hsp_pore_pocket_size *const sizes = calloc((size_t)all + 1, sizeof *sizes);
  struct sized_pocket *list = calloc((size_t)all + 1, sizeof *list);
  bool done = (sizes != NULL && list != NULL) || failure_of_memory(failure);
  done = done && geometry_measure_pockets(geometry, NULL, all, sizes, failure);
  for (uint32_t p = 0; done && p < all; ++p) {
    list[p] = (struct sized_pocket){p, sizes[p].volume >= 0.0 ? sizes[p].volume : -1.0};
  }
  if (done) sized_pockets_sort(list, all);
  free(sizes);
  if (done) return list;
  free(list);
  return NULL;
}

/* *of_maximum is to be freed on true and on false. */
static bool find_pockets(const struct geometry *geometry, double wide, double least, struct mesh_pockets *found,
                         uint8_t **of_maximum, struct failure *failure) {
  hsp_pores *const pores = geometry->work.pores;
  hsp_pores_counts counts;
  uint32_t all = 0;
  int32_t status = hsp_pores_get_counts(pores, &counts);
  if (status == HSP_OK) status = hsp_pores_find_pockets(pores, 0.0, wide, &all);
  if (status != HSP_OK) return failure_in_library(failure, status);
  found->all = all;
  struct sized_pocket *const list = list_pockets(geometry, all, failure);
  if (list == NULL) return false;
  uint32_t *const maxima = malloc(((size_t)counts.maxima + 1) * sizeof *maxima);
  *of_maximum = calloc((size_t)counts.maxima + 1, 1);
  const bool enough = maxima != NULL && *of_maximum != NULL;
  status = enough ? mark_maxima(pores, list, all, least, maxima, counts.maxima, found, *of_maximum) : HSP_E_MEMORY;
  free(maxima);
  free(list);
  return status == HSP_OK || failure_in_library(failure, status);
}

/* The data by which the pocket of a probe that touches the surface is found. */
struct places {
  const hsp_pores *pores;
  const struct molecule *molecule;
  const struct triangle_mesh *mesh;
  double above;              /* of the probe's centre over the surface */
  const uint8_t *of_maximum; /* its pocket */
};

/* Find the pocket of a probe whose centre is near a point. The point may be on a chord of the probe's path, which lies
 * within the ball that the probe touches; then it is moved out of that ball. NO_AREA: no pocket, or beyond the
 * lattice. */
static int32_t locate(const struct places *places, const double xyz[3], uint8_t *pocket) {
  double at[3] = {xyz[0], xyz[1], xyz[2]};
  hsp_pore_place place;
  *pocket = NO_AREA;
  for (int tries = 0; tries < MOST_LIFTS; ++tries) {
    const int32_t status = hsp_pores_locate(places->pores, at, &place);
    if (status == HSP_E_RANGE) return HSP_OK;
    if (status != HSP_OK) return status;
    if (place.maximum != HSP_NONE) {
      *pocket = place.maximum == HSP_PORE_OUTSIDE ? 0 : places->of_maximum[place.maximum];
      return HSP_OK;
    }
    const double *const centre = places->molecule->xyz + 3 * (size_t)place.ball;
    double away[3], square = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      away[axis] = at[axis] - centre[axis];
      square += away[axis] * away[axis];
    }
    for (int axis = 0; axis < 3 && square > 0.0; ++axis) at[axis] -= place.radius * away[axis] / sqrt(square);
  }
  return HSP_OK;
}

static void find_probe(const struct places *places, uint32_t vertex, double xyz[3]) {
  for (size_t axis = 0; axis < 3; ++axis) {
    const size_t k = 3 * (size_t)vertex + axis;
    xyz[axis] = places->mesh->xyz[k] + places->above * places->mesh->normals[k];
  }
}

static bool is_concave(const struct triangle_mesh *mesh, uint32_t triangle) {
  return mesh->kinds[triangle] == HSP_PATCH_CONCAVE;
}

/* Find the pockets of all vertices and patches. A concave patch has one place of the probe, also for its border. A
 * vertex without a place of its own has that of its patch. */
static int32_t find_vertices(const struct places *places, uint8_t *of_vertex, uint8_t *of_patch) {
  const struct triangle_mesh *const mesh = places->mesh;
  for (int concave = 1; concave >= 0; --concave) {
    for (uint32_t t = 0; t < mesh->triangles; ++t) {
      uint8_t *const own = &of_patch[mesh->patches[t]];
      for (size_t k = 0; k < 3 && (concave == 1) == is_concave(mesh, t); ++k) {
        const uint32_t vertex = mesh->corners[3 * (size_t)t + k];
        double xyz[3];
        find_probe(places, vertex, xyz);
        uint8_t *const wanted = concave == 1 ? own : &of_vertex[vertex];
        const int32_t status = *wanted == NO_AREA ? locate(places, xyz, wanted) : HSP_OK;
        if (status != HSP_OK) return status;
        if (concave == 1) of_vertex[vertex] = *own;
        if (*own == NO_AREA) *own = of_vertex[vertex];
      }
    }
  }
  for (size_t k = 0; k < 3 * (size_t)mesh->triangles; ++k) {
    uint8_t *const pocket = &of_vertex[mesh->corners[k]];
    if (*pocket == NO_AREA) *pocket = of_patch[mesh->patches[k / 3]];
  }
  return HSP_OK;
}

/* Set the pockets of triangles. A part of a split triangle has that of its first corner, unless this is a new vertex:
 * then it is in the middle of three pockets, and any of them is right. */
static void set_triangles(const struct triangle_mesh *mesh, const uint8_t *of_vertex, uint32_t old,
                          struct mesh_pockets *found) {
  for (uint32_t t = 0; t < mesh->triangles; ++t) {
    uint8_t own = found->of_patch[mesh->patches[t]];
    for (size_t k = 3; k-- > 0;) {
      const uint32_t vertex = mesh->corners[3 * (size_t)t + k];
      if (vertex < old && of_vertex[vertex] != NO_AREA) own = of_vertex[vertex];
    }
    found->of_triangle[t] = own == NO_AREA ? 0 : own;
  }
}

/* Splits triangles at the borders of pockets. Ways up are made of long steps: near a gate which of two they end in
 * changes in leaps, to and fro, so that only smooth borders show where pockets end. */
static bool colour_mesh(const struct places *places, struct triangle_mesh *mesh, uint32_t patches, double reach,
                        struct mesh_pockets *found, struct failure *failure) {
  const uint32_t old = mesh->vertices;
  uint8_t *const of_vertex = malloc((size_t)old + 1);
  struct split_edge *edges = NULL;
  size_t count = 0;
  found->of_patch = calloc((size_t)patches + 1, 1);
  int32_t status = of_vertex == NULL || found->of_patch == NULL ? HSP_E_MEMORY : HSP_OK;
  if (status == HSP_OK) {
    memset(of_vertex, NO_AREA, old);
    memset(found->of_patch, NO_AREA, patches);
    status = find_vertices(places, of_vertex, found->of_patch);
  }
  const bool enough =
      status != HSP_OK || smooth_borders_find(mesh, OTHER_POCKETS + 1, reach, of_vertex, &edges, &count);
  if (!enough) status = HSP_E_MEMORY;
  bool done = status == HSP_OK ? mesh_split(mesh, edges, count, NULL, failure) : failure_in_library(failure, status);
  if (done) found->of_triangle = calloc((size_t)mesh->triangles + 1, 1);
  if (done && found->of_triangle == NULL) done = failure_of_memory(failure);
  if (done) set_triangles(mesh, of_vertex, old, found);
  for (uint32_t p = 0; done && p < patches; ++p)
    found->of_patch[p] = found->of_patch[p] == NO_AREA ? 0 : found->of_patch[p];
  free(of_vertex);
  free(edges);
  return done;
}

bool mesh_pockets_find(struct geometry *geometry, const struct molecule *molecule, struct triangle_mesh *mesh,
                       bool smooth, double wide, double least, struct mesh_pockets *pockets, struct failure *failure) {
  const hsp_pores_options options = {
      .struct_size = (uint32_t)sizeof options, .floor = -below * mesh->edge, .executor = stopping_executor()};
  uint8_t *of_maximum = NULL;
  uint32_t patches = 0;
  progress_show(&geometry->progress, "looking for pockets");
  const int32_t status = hsp_workspace_pores(&geometry->work, &options);
  if (status == HSP_E_RANGE) return failure_in_input(failure, 0, "--pockets: %s", geometry_reason(status));
  /* The balls of the model are grown by the probe. */
  bool done = status == HSP_OK ? find_pockets(geometry, wide - mesh->probe, least, pockets, &of_maximum, failure)
                               : failure_in_library(failure, status);
  for (uint32_t t = 0; t < mesh->triangles; ++t) patches = mesh->patches[t] < patches ? patches : mesh->patches[t] + 1;
  const struct places places = {geometry->work.pores, molecule, mesh, smooth ? mesh->probe : 0.0, of_maximum};
  /* No farther than an atom is wide: across a pocket none would be left of it, however long edges are. */
  const double reach = fmin(edges_smoothed * mesh->edge, molecule_mean_radius(molecule));
  done = done && colour_mesh(&places, mesh, patches, reach, pockets, failure);
  free(of_maximum);
  return done;
}
