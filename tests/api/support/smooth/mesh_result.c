#include "mesh_result.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

HANDLE_FUNCTIONS(mesh)

static int32_t compute_handle(void *handle, const void *source, void *limits) {
  const mesh_result *m = source;
  return m->surface == NULL ? hsp_mesh_compute(handle, m->base->boundary, m->edge, limits)
                            : hsp_mesh_compute_surface(handle, m->surface, m->edge, limits);
}

const handle_kind mesh_handle = {(uint32_t)sizeof(hsp_mesh_limits),
                                 5,
                                 {"", "balls", "curves", "vertices", "triangles", "points"},
                                 NULL,
                                 bytes_of_limits,
                                 init_handle,
                                 compute_handle,
                                 17};

static int32_t make(const computed *base, const hsp_surface *surface, double edge, mesh_result *m) {
  void *mesh = NULL;
  uint32_t vertices = 0, triangles = 0;
  int32_t status;
  memset(m, 0, sizeof *m);
  m->base = base;
  m->surface = surface;
  m->edge = edge;
  status = grow_until_computed(&mesh_handle, m, base->n, &m->memory, &mesh, &m->needed, &m->enlargements);
  m->mesh = mesh;
  if (status == HSP_OK) status = hsp_mesh_get_counts(m->mesh, &m->counts);
  vertices = m->counts.vertices;
  triangles = m->counts.triangles;
  m->xyz = test_zeros(vertices, sizeof *m->xyz);
  m->normals = test_zeros(vertices, sizeof *m->normals);
  m->areas = test_zeros(vertices, sizeof *m->areas);
  m->vertex_balls = test_zeros(vertices, sizeof *m->vertex_balls);
  m->corners = test_zeros(triangles, sizeof *m->corners);
  m->kinds = test_zeros(triangles, sizeof *m->kinds);
  m->patches = test_zeros(triangles, sizeof *m->patches);
  m->balls = test_zeros(triangles, sizeof *m->balls);
  if (status == HSP_OK) {
    status = hsp_mesh_get_vertices(m->mesh, m->xyz[0], m->normals[0], m->areas, m->vertex_balls, vertices, &vertices);
  }
  if (status == HSP_OK) {
    status = hsp_mesh_get_triangles(m->mesh, m->corners[0], m->kinds, m->patches, m->balls, triangles, &triangles);
  }
  return status;
}

int32_t mesh_result_make(const computed *base, double edge, mesh_result *m) {
  return make(base, NULL, edge, m);
}

int32_t mesh_result_make_surface(const surface_result *base, double edge, mesh_result *m) {
  return make(base->base, base->surface, edge, m);
}

void mesh_result_release(mesh_result *m) {
  free(m->memory);
  free(m->xyz);
  free(m->normals);
  free(m->areas);
  free(m->vertex_balls);
  free(m->corners);
  free(m->kinds);
  free(m->patches);
  free(m->balls);
  memset(m, 0, sizeof *m);
}

/* ---- a closed surface ---- */

/* A corner of a triangle, seen from its vertex: the triangle lies between the edges to vertices `next` and `last`. */
typedef struct wedge {
  uint32_t vertex, next, last;
} wedge;

static int compare_wedges(const void *a, const void *b) {
  const wedge *p = a, *q = b;
  if (p->vertex != q->vertex) return p->vertex < q->vertex ? -1 : 1;
  if (p->next != q->next) return p->next < q->next ? -1 : 1;
  return 0;
}

/* The fault of the wedges of one vertex, or NULL: each must begin where another one ends, and going around from one
 * must meet them all. */
static const char *ring_fault(const wedge *ring, size_t count) {
  size_t at = 0, seen = 0, k;
  for (k = 1; k < count; ++k) {
    if (ring[k].next == ring[k - 1].next) return "two triangles run through an edge in the same direction";
  }
  do {
    const wedge *found = NULL;
    wedge wanted;
    wanted.vertex = ring[at].vertex;
    wanted.next = ring[at].last;
    wanted.last = 0;
    found = bsearch(&wanted, ring, count, sizeof *ring, compare_wedges);
    if (found == NULL) return "an edge in one triangle alone";
    at = (size_t)(found - ring);
    ++seen;
  } while (at != 0 && seen <= count);
  return seen == count ? NULL : "several rings of triangles around a vertex";
}

const char *mesh_fault(const mesh_result *m) {
  const size_t count = 3 * (size_t)m->counts.triangles;
  wedge *wedges = test_zeros(count, sizeof *wedges);
  const char *fault = NULL;
  size_t first, last, rings = 0;
  uint32_t t, k;
  for (t = 0; t < m->counts.triangles; ++t) {
    for (k = 0; k < 3; ++k) {
      wedge *w = &wedges[3 * (size_t)t + k];
      w->vertex = m->corners[t][k];
      w->next = m->corners[t][(k + 1) % 3];
      w->last = m->corners[t][(k + 2) % 3];
      if (w->vertex >= m->counts.vertices) fault = "no such vertex";
      if (w->vertex == w->next) fault = "an edge from a vertex to itself";
    }
  }
  qsort(wedges, count, sizeof *wedges, compare_wedges);
  for (first = 0; first < count && fault == NULL; first = last) {
    for (last = first; last < count && wedges[last].vertex == wedges[first].vertex;) ++last;
    fault = ring_fault(wedges + first, last - first);
    ++rings;
  }
  if (fault == NULL && rings != m->counts.vertices) fault = "a vertex without triangles";
  free(wedges);
  return fault;
}

static void cross_product(const double a[3], const double b[3], double out[3]) {
  out[0] = a[1] * b[2] - a[2] * b[1];
  out[1] = a[2] * b[0] - a[0] * b[2];
  out[2] = a[0] * b[1] - a[1] * b[0];
}

double mesh_volume(const mesh_result *m, const double about[3]) {
  double sum = 0.0;
  uint32_t t, k, axis;
  for (t = 0; t < m->counts.triangles; ++t) {
    double p[3][3], normal[3];
    for (k = 0; k < 3; ++k) {
      for (axis = 0; axis < 3; ++axis) p[k][axis] = m->xyz[m->corners[t][k]][axis] - about[axis];
    }
    cross_product(p[1], p[2], normal);
    for (axis = 0; axis < 3; ++axis) sum += p[0][axis] * normal[axis] / 6;
  }
  return sum;
}

double mesh_area(const mesh_result *m) {
  double sum = 0.0;
  uint32_t t, axis;
  for (t = 0; t < m->counts.triangles; ++t) {
    double u[3], v[3], normal[3];
    for (axis = 0; axis < 3; ++axis) {
      u[axis] = m->xyz[m->corners[t][1]][axis] - m->xyz[m->corners[t][0]][axis];
      v[axis] = m->xyz[m->corners[t][2]][axis] - m->xyz[m->corners[t][0]][axis];
    }
    cross_product(u, v, normal);
    sum += 0.5 * sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
  }
  return sum;
}
