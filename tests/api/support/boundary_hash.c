#include "boundary_hash.h"

#include "check.h"

uint64_t mixed_hash(uint64_t hash, const void *bytes, size_t size) {
  const unsigned char *from = bytes;
  size_t i;
  for (i = 0; i < size; ++i) hash = (hash ^ from[i]) * UINT64_C(0x100000001B3);
  return hash;
}

/* Results that are computed on request: areas of faces, a gradient, and rows of derivatives of areas. */
static uint64_t derived_hash(const hsp_boundary *boundary, const hsp_boundary_counts *counts, unsigned char *buffer,
                             uint64_t hash) {
  const uint32_t n = counts->balls;
  double *numbers = (void *)buffer;
  uint32_t *flags = (void *)(numbers + 4 * (size_t)n);
  hsp_totals totals;
  hsp_energy energy;
  uint32_t needed = 0, i;
  int bad = hsp_boundary_measure(boundary, NULL, &totals, numbers, numbers + n, n, NULL) != HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &totals, sizeof totals), numbers, 2 * (size_t)n * sizeof *numbers);
  bad |= hsp_boundary_measure_faces(boundary, numbers, numbers + counts->faces, counts->faces, NULL) != HSP_OK;
  hash = mixed_hash(hash, numbers, 2 * (size_t)counts->faces * sizeof *numbers);
  bad |= hsp_boundary_get_gradient(boundary, SIZED(hsp_gradient_request, .tension = 1, .pressure = -0.5),
                                   SIZED(hsp_gradient_outputs, .energy = &energy, .d_centre = numbers,
                                         .d_radius = numbers + 3 * (size_t)n, .flags = flags, .capacity = n)) != HSP_OK;
  hash = mixed_hash(mixed_hash(hash, &energy, sizeof energy), numbers, 4 * (size_t)n * sizeof *numbers);
  hash = mixed_hash(hash, flags, n * sizeof *flags);
  for (i = 0; i < n; ++i) {
    bad |= hsp_boundary_get_area_row(boundary, i, HSP_TANGENT_DISJOINT, (void *)buffer, n, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(hsp_area_derivative));
  }
  return bad ? 0 : hash;
}

/* The answers of queries to the boundary's model are hashed too. */
uint64_t boundary_hash(const void *boundary, const void *source, unsigned char *buffer, uint32_t room) {
  const computed *c = source;
  uint64_t hash = UINT64_C(0xCBF29CE484222325);
  hsp_boundary_counts counts;
  uint32_t needed = 0, i;
  int bad = 0;
  if (hsp_boundary_get_counts(boundary, &counts) != HSP_OK) return 0;
  hash = mixed_hash(hash, &counts, sizeof counts);
  bad |= hsp_boundary_get_vertices(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_vertex));
  bad |= hsp_boundary_get_arcs(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_arc));
  bad |= hsp_boundary_get_circles(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_circle));
  bad |= hsp_boundary_get_faces(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_face));
  bad |= hsp_boundary_get_loops(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_loop));
  bad |= hsp_boundary_get_loop_arcs(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_loop_arc));
  bad |= hsp_boundary_get_balls(boundary, (void *)buffer, room, &needed) != HSP_OK;
  hash = mixed_hash(hash, buffer, needed * sizeof(hsp_ball));
  for (i = 0; i < c->n; ++i) {
    bad |= hsp_query_neighbours(c->model, i, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(uint32_t));
    bad |= hsp_query_ball(c->model, c->xyz + 3 * i, 2.5, (void *)buffer, room, &needed) != HSP_OK;
    hash = mixed_hash(hash, buffer, needed * sizeof(uint32_t));
  }
  return bad ? 0 : derived_hash(boundary, &counts, buffer, hash);
}

int use_boundary(void *boundary) {
  uint32_t invariant, id;
  return hsp_boundary_check(boundary, &invariant, &id) == HSP_OK;
}

uint32_t boundary_room(const computed *c) {
  const hsp_boundary_counts *counts = &c->counts;
  return 64 + 6 * c->n + counts->vertices + 2 * counts->arcs + counts->circles + counts->loops + 2 * counts->faces;
}
