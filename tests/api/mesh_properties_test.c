/* What the header promises of every mesh, on all sets of the interface tests with several probes: a closed surface with
 * the boundary's own Euler characteristic, vertices on their balls, areas and volumes that approach the exact ones. */
#include <hardsphere.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "limit_sweep.h"
#include "mesh_result.h"
#include "topology_sets.h"

static hsp_model_options options_of(double probe) {
  hsp_model_options options;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.probe = probe;
  return options;
}

/* Every vertex lies on the sphere of its ball, and normals are unit vectors that in the middle of a patch point
 * straight away from its ball. */
static void check_positions(const mesh_result *m) {
  uint32_t *patch = test_zeros(m->counts.vertices, sizeof *patch); /* 1 more than the one it is in, HSP_NONE: several */
  uint32_t v, t, k, axis;
  double sum = 0.0;
  for (t = 0; t < m->counts.triangles; ++t) {
    for (k = 0; k < 3; ++k) {
      uint32_t *const p = &patch[m->corners[t][k]];
      *p = *p == 0 || *p == m->patches[t] + 1 ? m->patches[t] + 1 : HSP_NONE;
    }
  }
  for (v = 0; v < m->counts.vertices; ++v) {
    const double *c = m->base->xyz + 3 * (size_t)m->vertex_balls[v];
    const double radius = m->base->radius[m->vertex_balls[v]];
    double square = 0.0, unit = 0.0, along = 0.0;
    for (axis = 0; axis < 3; ++axis) {
      const double d = m->xyz[v][axis] - c[axis];
      square += d * d;
      unit += m->normals[v][axis] * m->normals[v][axis];
      along += d * m->normals[v][axis];
    }
    CHECK_NEAR(sqrt(square), radius, 1e-6 * (1.0 + radius));
    CHECK_NEAR(unit, 1.0, 1e-12);
    if (patch[v] != HSP_NONE) CHECK_NEAR(along, radius, 1e-6 * (1.0 + radius));
    sum += m->areas[v];
  }
  CHECK_NEAR(sum, mesh_area(m), 1e-10 * (1.0 + sum));
  free(patch);
}

static void check_triangles(const mesh_result *m) {
  uint32_t t;
  for (t = 0; t < m->counts.triangles; ++t) {
    const uint32_t ball = m->balls[t];
    CHECK_EQUAL(m->kinds[t], HSP_PATCH_CONVEX);
    if (!CHECK(m->patches[t] < m->base->counts.faces)) return;
    CHECK_EQUAL(m->base->faces[m->patches[t]].ball, ball);
  }
}

static void same_results(const void *handle, const void *source) {
  const mesh_result *m = source;
  hsp_mesh_counts counts;
  uint32_t(*corners)[3] = test_zeros(m->counts.triangles, sizeof *corners);
  double(*xyz)[3] = test_zeros(m->counts.vertices, sizeof *xyz);
  CHECK_EQUAL(hsp_mesh_get_counts(handle, &counts), HSP_OK);
  CHECK_BYTES(&counts, &m->counts, sizeof counts);
  CHECK_EQUAL(hsp_mesh_get_triangles(handle, corners[0], NULL, NULL, NULL, m->counts.triangles, NULL), HSP_OK);
  CHECK_BYTES(corners, m->corners, m->counts.triangles * sizeof *corners);
  CHECK_EQUAL(hsp_mesh_get_vertices(handle, xyz[0], NULL, NULL, NULL, m->counts.vertices, NULL), HSP_OK);
  CHECK_BYTES(xyz, m->xyz, m->counts.vertices * sizeof *xyz);
  free(corners);
  free(xyz);
}
static void no_results(const void *handle) {
  hsp_mesh_counts counts;
  CHECK_EQUAL(hsp_mesh_get_counts(handle, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_mesh_get_vertices(handle, NULL, NULL, NULL, NULL, 0, NULL), HSP_E_STATE);
  CHECK_EQUAL(hsp_mesh_get_triangles(handle, NULL, NULL, NULL, NULL, 0, NULL), HSP_E_STATE);
}

static size_t macro(const limit_numbers *limits) {
  return HSP_MESH_BYTES(limits->number[1], limits->number[2], limits->number[3], limits->number[4], limits->number[5]);
}

static void sizes(void) {
  static const uint32_t values[] = {0, 1, 3, 8, 65, 1000, 1024, 4097, 0x0FFFFFFF};
  static const size_bound bound = {macro, {4096, 16, 32, 64, 32, 384}};
  check_scene("sizes");
  sweep_sizes(&mesh_handle, &bound, values, sizeof values / sizeof values[0]);
}

static uint32_t meshes, refused;

static void check_set(const ball_set *set, double probe) {
  const hsp_model_options options = options_of(probe);
  computed c;
  mesh_result m;
  double largest = 0.0;
  uint32_t i;
  int32_t status;
  check_scene("%s, probe %g", set->name, probe);
  if (!CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, &options, &c), HSP_OK)) return;
  ++meshes;
  for (i = 0; i < c.n; ++i) largest = c.radius[i] > largest ? c.radius[i] : largest;
  status = mesh_result_make(&c, largest > 0.0 ? 0.4 * largest : 1.0, &m);
  if (status == HSP_E_CHECK) {
    ++refused;
  } else if (CHECK_EQUAL(status, HSP_OK)) {
    const known_handle known = {&mesh_handle, &m, &m.needed, same_results, no_results, NULL};
    const char *const fault = mesh_fault(&m);
    if (fault != NULL) printf("%s: %s\n", set->name, fault);
    CHECK(fault == NULL);
    CHECK_EQUAL((int64_t)m.counts.vertices - (int64_t)m.counts.triangles / 2, c.counts.euler);
    CHECK(m.enlargements <= 20);
    check_positions(&m);
    check_triangles(&m);
    if (set->n <= 6 && m.counts.vertices < 600) sweep_limits(&known, set->name);
    if (set->n > 3 && set->n < 6) sweep_alignments(&known, NULL);
  }
  mesh_result_release(&m);
  computed_release(&c);
}

/* Half the edge, a quarter of the error. */
static void converges(void) {
  static const double xyz[5][3] = {{0, 0, 0}, {1.5, 0, 0}, {2.0, 1.4, 0}, {1.0, 0.7, 1.1}, {-1.0, 0.9, 0.3}};
  static const double radius[5] = {1.0, 1.2, 0.9, 1.1, 0.8};
  const double origin[3] = {0.0, 0.0, 0.0};
  double area[3], volume[3];
  computed c;
  int k;
  check_scene("convergence");
  CHECK_EQUAL(computed_make(5, xyz[0], radius, NULL, &c), HSP_OK);
  for (k = 0; k < 3; ++k) {
    mesh_result m;
    CHECK_EQUAL(mesh_result_make(&c, 0.2 / (1 << k), &m), HSP_OK);
    area[k] = c.totals.area - mesh_area(&m);
    volume[k] = c.totals.volume - mesh_volume(&m, origin);
    mesh_result_release(&m);
  }
  for (k = 0; k < 2; ++k) {
    CHECK(area[k] > 3.0 * area[k + 1] && area[k] < 6.0 * area[k + 1]);
    CHECK(volume[k] > 3.0 * volume[k + 1] && volume[k] < 6.0 * volume[k + 1]);
  }
  computed_release(&c);
}

int main(void) {
  static const double probes[] = {0.0, 0.25, 1.5};
  static ball_set set;
  uint32_t which, k;
  sizes();
  for (k = 0; k < sizeof probes / sizeof probes[0]; ++k) {
    for (which = 0; which < ball_set_count(); ++which) {
      ball_set_make(which, &set);
      check_set(&set, probes[k]);
    }
    for (which = 0; which < topology_set_count(); ++which) {
      topology_set_make(which, &set);
      check_set(&set, probes[k]);
    }
  }
  converges();
  CHECK(50 * refused <= meshes);
  return check_report();
}
