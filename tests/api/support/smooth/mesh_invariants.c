#include "mesh_invariants.h"

#include <stdlib.h>

#include "vectors.h"

uint32_t *patches_of_vertices(const mesh_result *m) {
  uint32_t *const patch = test_zeros(m->counts.vertices, sizeof *patch);
  uint32_t t, k;
  for (t = 0; t < m->counts.triangles; ++t) {
    for (k = 0; k < 3; ++k) {
      uint32_t *const p = &patch[m->corners[t][k]];
      *p = *p == 0 || *p == m->patches[t] + 1 ? m->patches[t] + 1 : HSP_NONE;
    }
  }
  return patch;
}

/* The allowed error of a vertex: roundings, the move to the lattice, and 2^-37 of the radius. The last is for the
 * points around a place where balls touch, which are 2^-18 of the radius apart. */
static double slack(const computed *c, const double xyz[3]) {
  return 4 * position_error(xyz) + 1e-11 * c->info.largest_radius + 8 * c->rounding;
}

static const char *broken_vertex(const mesh_result *m, uint32_t v, int is_inside_patch) {
  const computed *const c = m->base;
  const double allowed = slack(c, m->xyz[v]);
  const uint32_t ball = m->vertex_balls[v];
  double arm[3];
  uint32_t i;
  for (i = 0; i < c->n; ++i) {
    if (fabs(m->xyz[v][0] - c->xyz[3 * i]) >= c->radius[i]) continue;
    difference(m->xyz[v], c->xyz + 3 * i, arm);
    if (!(length(arm) >= c->radius[i] - allowed)) return "mesh: a vertex inside a ball";
  }
  difference(m->xyz[v], c->xyz + 3 * ball, arm);
  if (!near(length(arm), c->radius[ball], allowed)) return "mesh: a vertex that is not on its ball";
  if (!near(length(m->normals[v]), 1.0, 1e-12)) return "mesh: a normal that is not of length 1";
  if (is_inside_patch && !near(dot(arm, m->normals[v]), c->radius[ball], allowed)) {
    return "mesh: a normal that does not point away from its ball";
  }
  return NULL;
}

const char *broken_mesh_vertices(const mesh_result *m) {
  uint32_t *const patch = patches_of_vertices(m);
  const char *broken = NULL;
  uint32_t v;
  for (v = 0; v < m->counts.vertices && broken == NULL; ++v) broken = broken_vertex(m, v, patch[v] != HSP_NONE);
  free(patch);
  return broken;
}
