/* The header's promises for every mesh, of boundaries and of smooth surfaces, on all sets of the interface tests with
 * several probes: a closed surface with the Euler characteristic of what it is made from, vertices on their balls,
 * areas and volumes that approach the exact ones. */
#include <hardsphere.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "limit_sweep.h"
#include "mesh_invariants.h"
#include "topology_sets.h"

static void check_vertices(const mesh_result *m) {
  const char *const broken = broken_mesh_vertices(m);
  double sum = 0.0;
  uint32_t v;
  if (!CHECK(broken == NULL)) printf("%s\n", broken);
  for (v = 0; v < m->counts.vertices; ++v) sum += m->areas[v];
  CHECK_NEAR(sum, mesh_area(m), 1e-10 * (1.0 + sum));
}

static double triangle_area(const mesh_result *m, uint32_t t) {
  const double *const a = m->xyz[m->corners[t][0]], *const b = m->xyz[m->corners[t][1]],
                      *const c = m->xyz[m->corners[t][2]];
  double squared = 0.0;
  int axis;
  for (axis = 0; axis < 3; ++axis) {
    const int y = (axis + 1) % 3, z = (axis + 2) % 3;
    const double part = (b[y] - a[y]) * (c[z] - a[z]) - (b[z] - a[z]) * (c[y] - a[y]);
    squared += part * part;
  }
  return 0.5 * sqrt(squared);
}

/* Each triangle gives its corners a third each of its part of its patch's exact area. */
static void check_weights(const mesh_result *m, const double *area, uint32_t patches) {
  const uint32_t n = m->counts.vertices;
  double *const of_patch = test_zeros(patches, sizeof *of_patch), *const expected = test_zeros(n, sizeof *expected);
  double *const weights = test_zeros(n, sizeof *weights);
  uint32_t *const triangles = test_zeros(patches, sizeof *triangles);
  double sum = 0.0, exact = 0.0;
  uint32_t needed = HSP_NONE, t, v, k;
  for (t = 0; t < m->counts.triangles; ++t) {
    of_patch[m->patches[t]] += triangle_area(m, t);
    ++triangles[m->patches[t]];
  }
  for (t = 0; t < m->counts.triangles; ++t) {
    const uint32_t patch = m->patches[t];
    const double part = of_patch[patch] > 0.0 ? triangle_area(m, t) / of_patch[patch] : 1.0 / triangles[patch];
    for (k = 0; k < 3; ++k) expected[m->corners[t][k]] += area[patch] * part / 3;
  }
  for (k = 0; k < patches; ++k) exact += triangles[k] > 0 ? area[k] : 0.0;
  CHECK_EQUAL(hsp_mesh_get_weights(m->mesh, area, patches, weights, n, &needed), HSP_OK);
  CHECK_EQUAL(needed, n);
  for (v = 0; v < n; ++v) {
    CHECK_NEAR(weights[v], expected[v], 1e-9 * (1.0 + exact));
    sum += weights[v];
  }
  CHECK_NEAR(sum, exact, 1e-12 * (1.0 + exact));
  if (m->counts.triangles > 0) {
    const uint32_t last = m->patches[m->counts.triangles - 1];
    CHECK_EQUAL(hsp_mesh_get_weights(m->mesh, area, last, weights, n, NULL), HSP_E_ID);
    CHECK_EQUAL(hsp_mesh_get_weights(m->mesh, area, last + 1, weights, n, NULL), HSP_OK);
  }
  free(of_patch);
  free(expected);
  free(weights);
  free(triangles);
}

static void check_weights_of_boundary(const computed *c, const mesh_result *m) {
  double *const area = test_zeros(c->counts.faces, sizeof *area);
  double sum = 0.0;
  uint32_t v;
  CHECK_EQUAL(hsp_boundary_measure_faces(c->boundary, area, NULL, c->counts.faces, NULL), HSP_OK);
  check_weights(m, area, c->counts.faces);
  if (CHECK_EQUAL(hsp_mesh_get_weights(m->mesh, area, c->counts.faces, m->areas, m->counts.vertices, NULL), HSP_OK)) {
    for (v = 0; v < m->counts.vertices; ++v) sum += m->areas[v];
    CHECK_NEAR(sum, c->totals.area, 1e-11 * (1.0 + c->totals.area));
  }
  free(area);
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
  static const size_bound bound = {macro, {4096, 16, 32, 64, 32, 384}, 0};
  check_scene("sizes");
  sweep_sizes(&mesh_handle, &bound, values, sizeof values / sizeof values[0]);
}

static uint32_t meshes, refused, surfaces;

static void check_closed(const ball_set *set, const mesh_result *m, int64_t euler) {
  const known_handle known = {&mesh_handle, m, &m->needed, same_results, no_results, NULL};
  const char *const fault = mesh_fault(m);
  if (fault != NULL) printf("%s: %s\n", set->name, fault);
  CHECK(fault == NULL);
  CHECK_EQUAL((int64_t)m->counts.vertices - (int64_t)m->counts.triangles / 2, euler);
  CHECK(m->enlargements <= 20);
  if (set->n <= 6 && m->counts.vertices < 150) sweep_limits(&known, set->name);
  if (set->n == 4 && m->counts.vertices < 300) sweep_alignments(&known, NULL);
}

static void check_boundary(const ball_set *set, const computed *c, double edge) {
  mesh_result m;
  const int32_t status = mesh_result_make(c, edge, &m);
  ++meshes;
  if (status == HSP_E_DEGENERATE) {
    ++refused;
  } else if (CHECK_EQUAL(status, HSP_OK)) {
    check_closed(set, &m, c->counts.euler);
    check_vertices(&m);
    check_triangles(&m);
    check_weights_of_boundary(c, &m);
  }
  mesh_result_release(&m);
}

static int64_t euler_of_shells(const hsp_surface *surface) {
  hsp_surface_part_counts map;
  int64_t sum = 0;
  uint32_t shells = 0, s;
  hsp_surface_shell *shell;
  CHECK_EQUAL(hsp_surface_get_part_counts(surface, &map), HSP_OK);
  shell = test_zeros(map.shells, sizeof *shell);
  CHECK_EQUAL(hsp_surface_get_shells(surface, shell, map.shells, &shells), HSP_OK);
  for (s = 0; s < shells; ++s) sum += shell[s].euler;
  free(shell);
  return sum;
}

/* The triangles of every patch are one range, of its kind and of the balls that its probes touch, and together they
 * come near its area. */
static void check_patches(const surface_result *s, const mesh_result *m) {
  hsp_surface_part_counts map;
  double *area;
  uint32_t p, t, next = 0;
  CHECK_EQUAL(hsp_surface_get_part_counts(s->surface, &map), HSP_OK);
  area = test_zeros(map.patches, sizeof *area);
  for (p = 0; p < map.patches; ++p) {
    hsp_surface_patch patch;
    uint32_t first = HSP_NONE, count = HSP_NONE;
    CHECK_EQUAL(hsp_surface_get_patches(s->surface, p, 1, &patch), HSP_OK);
    area[p] = patch.area;
    CHECK_EQUAL(hsp_mesh_get_patch(m->mesh, p, &first, &count), HSP_OK);
    if (!CHECK(first == next && count <= m->counts.triangles - first)) break;
    for (t = first; t < first + count; ++t) {
      CHECK_EQUAL(m->patches[t], p);
      CHECK_EQUAL(m->kinds[t], patch.kind);
      CHECK(m->balls[t] < s->base->n);
      if (patch.kind == HSP_PATCH_CONVEX) CHECK_EQUAL(m->balls[t], s->base->faces[patch.source].ball);
      if (patch.kind == HSP_PATCH_CONCAVE) {
        const uint32_t *const ball = s->base->vertices[patch.source].ball;
        CHECK(m->balls[t] == ball[0] || m->balls[t] == ball[1] || m->balls[t] == ball[2]);
      }
    }
    next = first + count;
  }
  CHECK_EQUAL(next, m->counts.triangles);
  check_weights(m, area, map.patches);
  free(area);
}

static void check_surface(const ball_set *set, const computed *c, double probe, double edge) {
  surface_result s;
  if (CHECK_EQUAL(surface_result_make(c, &s), HSP_OK)) {
    mesh_result m;
    const int32_t status = mesh_result_make_surface(&s, edge, &m);
    ++surfaces;
    CHECK_EQUAL(s.counts.open_joints, 0);
    if (status == HSP_E_DEGENERATE) {
      ++refused;
    } else if (CHECK_EQUAL(status, HSP_OK)) {
      check_closed(set, &m, probe > 0.0 ? euler_of_shells(s.surface) : c->counts.euler);
      if (probe > 0.0) check_patches(&s, &m);
    }
    mesh_result_release(&m);
  }
  surface_result_release(&s);
}

static void check_set(const ball_set *set, double probe) {
  const hsp_model_options options = options_with_probe(probe);
  computed c;
  double largest = 0.0;
  uint32_t i;
  check_scene("%s, probe %g", set->name, probe);
  if (!CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, &options, &c), HSP_OK)) return;
  for (i = 0; i < c.n; ++i) largest = c.radius[i] > largest ? c.radius[i] : largest;
  check_boundary(set, &c, largest > 0.0 ? largest : 1.0);
  check_surface(set, &c, probe, largest > 0.0 ? largest : 1.0);
  computed_release(&c);
}

/* A probe in the plane of three of its balls' centres that touches two more balls: the surface is closed, and its
 * triangles are refused, or closed as well. */
static void tied_surface(void) {
  static const double xyz[8][3] = {{4, 12, 0},  {8, 6, 0},  {8, 12, 0}, {4, 6, 12},
                                   {4, 12, 12}, {8, 0, 12}, {0, 0, 12}, {4, 6, 12}};
  static const double radius[8] = {3, 3, 7, 3, 3, 3, 5, 3};
  const hsp_model_options options = options_with_probe(4.0);
  computed c;
  surface_result s;
  mesh_result m;
  int32_t status;
  uint32_t invariant = HSP_NONE, id = HSP_NONE;
  check_scene("a tied surface");
  CHECK_EQUAL(computed_make(8, xyz[0], radius, &options, &c), HSP_OK);
  CHECK_EQUAL(surface_result_make(&c, &s), HSP_OK);
  CHECK_EQUAL(s.counts.open_joints, 0);
  CHECK_EQUAL(hsp_surface_check(s.surface, &invariant, &id), HSP_OK);
  status = mesh_result_make_surface(&s, 4.0, &m);
  CHECK(status == HSP_OK ? mesh_fault(&m) == NULL : status == HSP_E_DEGENERATE);
  mesh_result_release(&m);
  surface_result_release(&s);
  computed_release(&c);
}

/* The surface around five points is far smaller than the probe, and so is what its triangles need. */
static void small_surface(void) {
  static const double xyz[5][3] = {{0.97725248, 1.39405712, 0.23740841},
                                   {1.41230417, 0.13996758, 0.76255342},
                                   {0.56500406, 0.52507112, 0.77333069},
                                   {1.04756273, 0.60954096, 0.88831195},
                                   {0.65461145, 1.84013881, 0.56015178}};
  static const double radius[5] = {0, 0, 0, 0, 0};
  const double edge = 7e-4;
  const hsp_model_options options = options_with_probe(1.0);
  computed c;
  surface_result s;
  mesh_result m;
  hsp_mesh_limits limits;
  check_scene("a small surface");
  CHECK_EQUAL(computed_make(5, xyz[0], radius, &options, &c), HSP_OK);
  CHECK_EQUAL(surface_result_make(&c, &s), HSP_OK);
  CHECK(s.totals.area > 1e-5 && s.totals.area < 1e-3);
  CHECK_EQUAL(hsp_mesh_limits_init_surface(&limits, sizeof limits, s.surface, edge), HSP_OK);
  CHECK(limits.points < 100000);
  CHECK_EQUAL(mesh_result_make_surface(&s, edge, &m), HSP_OK);
  CHECK(mesh_fault(&m) == NULL);
  CHECK(m.counts.vertices < 2000 && m.needed.points < 2000);
  mesh_result_release(&m);
  surface_result_release(&s);
  computed_release(&c);
}

/* Half the edge, a quarter of the error: of the boundary, and of the smooth surface of the same balls. */
static void check_quarters(const double *error) {
  CHECK(error[0] > 3.0 * error[1] && error[0] < 6.0 * error[1]);
  CHECK(error[1] > 3.0 * error[2] && error[1] < 6.0 * error[2]);
}

static void surface_converges(void) {
  static const double xyz[4][3] = {{0, 0, 0}, {2.5, 0, 0}, {2.9, 2.4, 0}, {-1.0, 4.0, 0.3}};
  static const double radius[4] = {1.0, 1.2, 0.9, 0.8};
  const double origin[3] = {0.0, 0.0, 0.0};
  const hsp_model_options options = options_with_probe(1.4);
  double area[3], volume[3];
  computed c;
  surface_result s;
  int k;
  check_scene("convergence of the smooth surface");
  CHECK_EQUAL(computed_make(4, xyz[0], radius, &options, &c), HSP_OK);
  CHECK_EQUAL(surface_result_make(&c, &s), HSP_OK);
  for (k = 0; k < 3; ++k) {
    mesh_result m;
    CHECK_EQUAL(mesh_result_make_surface(&s, 0.2 / (1 << k), &m), HSP_OK);
    area[k] = s.totals.area - mesh_area(&m);
    volume[k] = s.totals.volume - mesh_volume(&m, origin);
    mesh_result_release(&m);
  }
  check_quarters(area);
  check_quarters(volume);
  surface_result_release(&s);
  computed_release(&c);
}

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
  check_quarters(area);
  check_quarters(volume);
  computed_release(&c);
}

int main(void) {
  static const double probes[] = {0.0, 0.25, 1.5};
  sizes();
  sets_with_probes(probes, (uint32_t)(sizeof probes / sizeof probes[0]), check_set);
  converges();
  surface_converges();
  tied_surface();
  small_surface();
  printf("%u meshes, %u surfaces, %u refused\n", meshes, surfaces, refused);
  CHECK_EQUAL(refused, 0);
  return check_report();
}
