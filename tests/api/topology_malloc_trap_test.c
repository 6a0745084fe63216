/* The topology's functions never allocate: malloc and its relatives are replaced by functions that count while armed,
 * and every entry point is called armed. For glibc only, and not for sanitizer builds, which bring their own malloc. */
#include <hardsphere.h>
#include <stdlib.h>

#include "check.h"
#include "malloc_trap.h"
#include "topology_result.h"
#include "topology_sets.h"

/* Every entry point once, into the arrays of `t`; the number of calls that did not succeed. */
static int call_everything(topology_result *t, void *memory, size_t bytes, uint32_t *ids, uint32_t room) {
  const computed *c = t->base;
  hsp_topology *topology = NULL;
  hsp_topology_limits limits;
  hsp_topology_counts counts;
  hsp_topology_vertex vertex;
  hsp_topology_edge edge;
  hsp_simple_face face;
  uint32_t needed, law, where, cell;
  int32_t same;
  size_t size;
  int bad = 0;
  bad += hsp_topology_limits_init(&limits, (uint32_t)sizeof limits, c->n) != HSP_OK;
  bad += hsp_topology_limits_for(&limits, (uint32_t)sizeof limits, c->boundary) != HSP_OK;
  bad += hsp_topology_bytes(&t->needed, &size) != HSP_OK;
  bad += hsp_topology_init(memory, bytes, &t->needed, &topology) != HSP_OK;
  bad += hsp_topology_compute(topology, c->boundary) != HSP_OK;
  bad += hsp_topology_get_needed(topology, &limits) != HSP_OK;
  bad += hsp_topology_get_counts(topology, &counts) != HSP_OK;
  bad += hsp_topology_get_quad_edges(topology, t->onext, t->origin, counts.edges, &needed) != HSP_OK;
  bad += hsp_quad_rot(hsp_quad_inverse_rot(hsp_quad_sym(0))) != 2;
  bad += hsp_topology_oprev(topology, hsp_topology_onext(topology, 0)) != 0;
  bad += hsp_topology_lprev(topology, hsp_topology_lnext(topology, 0)) != 0;
  bad += hsp_topology_origin(topology, 0) == HSP_NONE || hsp_topology_left(topology, 0) == HSP_NONE;
  bad += hsp_topology_ball(topology, 0) >= c->n;
  bad += hsp_topology_get_vertex(topology, 0, &vertex) != HSP_OK;
  bad += hsp_topology_get_edge(topology, 0, &edge) != HSP_OK;
  bad += hsp_topology_get_face(topology, 0, &face) != HSP_OK;
  bad += hsp_topology_get_vertices(topology, t->vertices, counts.vertices, &needed) != HSP_OK;
  bad += hsp_topology_get_edges(topology, t->edges, counts.edges, &needed) != HSP_OK;
  bad += hsp_topology_get_faces(topology, t->faces, counts.simple_faces, &needed) != HSP_OK;
  bad += hsp_topology_get_shells(topology, t->shells, counts.shells, &needed) != HSP_OK;
  bad += hsp_topology_get_components(topology, t->components, counts.components, &needed) != HSP_OK;
  bad += hsp_topology_get_cells(topology, t->cells, counts.cells, &needed) != HSP_OK;
  bad += hsp_topology_get_cell_shells(topology, 0, ids, room, &needed) != HSP_OK;
  bad += hsp_topology_get_scan(topology, 0, ids, room, &needed) != HSP_OK;
  bad += hsp_topology_locate(topology, c->xyz, &cell, ids, room, &needed) != HSP_OK;
  bad += hsp_topology_same_cell(topology, c->xyz, c->xyz, &same) != HSP_OK;
  bad += hsp_topology_check(topology, &law, &where) != HSP_OK;
  return bad;
}

int main(void) {
  static ball_set set;
  uint32_t which;
  void *volatile bait;
  armed = 1;
  bait = malloc(10);
  free(bait);
  armed = 0;
  CHECK_EQUAL(caught, 2);
  for (which = 0; which < topology_set_count(); ++which) {
    computed c;
    topology_result t;
    topology_set_make(which, &set);
    if (set.n == 0) continue;
    check_scene("%s", set.name);
    CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
    if (CHECK_EQUAL(topology_result_make(&c, &t), HSP_OK)) {
      const uint32_t room = t.counts.edges + t.counts.shells + c.n;
      uint32_t *ids = malloc(room * sizeof *ids);
      size_t bytes = 0;
      void *memory;
      int bad, allocations;
      CHECK_EQUAL(hsp_topology_bytes(&t.needed, &bytes), HSP_OK);
      memory = malloc(bytes);
      if (memory == NULL || ids == NULL) return 2;
      caught = 0;
      armed = 1;
      bad = call_everything(&t, memory, bytes, ids, room);
      armed = 0;
      allocations = caught;
      CHECK_EQUAL(bad, 0);
      CHECK_EQUAL(allocations, 0);
      free(memory);
      free(ids);
    }
    topology_result_release(&t);
    computed_release(&c);
  }
  return check_report();
}
