/* Every output array of the topology's functions, for every set of topology_sets.h, at capacities 0, 1, needed-1,
 * needed and needed+1: HSP_E_CAPACITY with the number needed and nothing written, or success with exactly that many
 * records. Guard bytes lie around every array. */
#include <hardsphere.h>

#include "check.h"
#include "output_sweep.h"
#include "topology_result.h"
#include "topology_sets.h"

/* What is being asked, so that one sweep serves all functions. */
typedef struct question {
  const topology_result *all;
  uint32_t id;
} question;

static int32_t ask_onext(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_quad_edges(q->all->topology, out, NULL, capacity, needed);
}
static int32_t ask_origin(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_quad_edges(q->all->topology, NULL, out, capacity, needed);
}
static int32_t ask_vertices(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_vertices(q->all->topology, out, capacity, needed);
}
static int32_t ask_edges(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_edges(q->all->topology, out, capacity, needed);
}
static int32_t ask_faces(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_faces(q->all->topology, out, capacity, needed);
}
static int32_t ask_shells(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_shells(q->all->topology, out, capacity, needed);
}
static int32_t ask_components(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_components(q->all->topology, out, capacity, needed);
}
static int32_t ask_cells(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_cells(q->all->topology, out, capacity, needed);
}
static int32_t ask_cell_shells(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_cell_shells(q->all->topology, q->id, out, capacity, needed);
}
static int32_t ask_scan(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_traversal(q->all->topology, q->id, out, capacity, needed);
}

/* Without both arrays only the query for their size is good. */
static void no_arrays(const topology_result *all) {
  uint32_t needed = 12345;
  CHECK_EQUAL(hsp_topology_get_quad_edges(all->topology, NULL, NULL, 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_get_quad_edges(all->topology, NULL, NULL, all->counts.edges + 1, &needed), HSP_E_ARGUMENT);
  CHECK_EQUAL(needed, 12345);
}

static void sweep_outputs(const topology_result *all) {
  const hsp_topology_counts *k = &all->counts;
  question q;
  q.all = all;
  q.id = 0;
  sweep_output(ask_onext, &q, 4 * sizeof(uint32_t), k->edges);
  sweep_output(ask_origin, &q, 4 * sizeof(uint32_t), k->edges);
  no_arrays(all);
  sweep_output(ask_vertices, &q, sizeof(hsp_topology_vertex), k->vertices);
  sweep_output(ask_edges, &q, sizeof(hsp_topology_edge), k->edges);
  sweep_output(ask_faces, &q, sizeof(hsp_simple_face), k->simple_faces);
  sweep_output(ask_shells, &q, sizeof(hsp_shell), k->shells);
  sweep_output(ask_components, &q, sizeof(hsp_component), k->components);
  sweep_output(ask_cells, &q, sizeof(hsp_cell), k->cells);
  for (q.id = 0; q.id < k->cells; q.id += 1 + k->cells / 4) {
    sweep_output(ask_cell_shells, &q, sizeof(uint32_t), all->cells[q.id].shells);
  }
  for (q.id = 0; q.id < k->shells; q.id += 1 + k->shells / 4) {
    sweep_output(ask_scan, &q, sizeof(uint32_t), all->shells[q.id].simple_faces);
  }
}

int main(void) {
  uint32_t which;
  for (which = 0; which < topology_set_count(); ++which) {
    static ball_set set;
    computed c;
    topology_result all;
    topology_set_make(which, &set);
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
      if (CHECK_EQUAL(topology_result_make(&c, &all), HSP_OK)) sweep_outputs(&all);
      topology_result_release(&all);
    }
    computed_release(&c);
  }
  return check_report();
}
