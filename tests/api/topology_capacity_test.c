/* Every limit of hsp_topology and every output array of its functions, for every set of topology_sets.h, at 0, 1,
 * needed-1, needed and needed+1: HSP_E_CAPACITY with nothing written beyond what the header names, or the same results
 * as with ample memory. Guard bytes lie around all memory. Sizes of handles: property numbers of hsp_topology_bytes. */
#include <hardsphere.h>
#include <string.h>

#include "check.h"
#include "guarded_memory.h"
#include "limit_sweep.h"
#include "output_sweep.h"
#include "topology_result.h"
#include "topology_sets.h"

/* ---- limits ---- */

/* The results are those that are known. */
static void check_results(const void *topology, const void *source) {
  const topology_result *all = source;
  hsp_topology_counts counts;
  uint32_t count = 0;
  guarded_memory onext = guarded_take(4 * sizeof(uint32_t) * (size_t)all->counts.edges, 0, GUARDED_PATTERN);
  guarded_memory origin = guarded_take(4 * sizeof(uint32_t) * (size_t)all->counts.edges, 0, GUARDED_PATTERN);
  guarded_memory edges = guarded_take(sizeof(hsp_topology_edge) * all->counts.edges, 0, GUARDED_PATTERN);
  guarded_memory shells = guarded_take(sizeof(hsp_shell) * all->counts.shells, 0, GUARDED_PATTERN);
  CHECK_EQUAL(hsp_topology_get_counts(topology, &counts), HSP_OK);
  CHECK_BYTES(&counts, &all->counts, sizeof counts);
  CHECK_EQUAL(hsp_topology_get_quad_edges(topology, (uint32_t *)(void *)onext.block, (uint32_t *)(void *)origin.block,
                                          all->counts.edges, &count),
              HSP_OK);
  CHECK_BYTES(onext.block, all->onext, onext.bytes);
  CHECK_BYTES(origin.block, all->origin, origin.bytes);
  CHECK_EQUAL(hsp_topology_get_edges(topology, (hsp_topology_edge *)(void *)edges.block, all->counts.edges, &count),
              HSP_OK);
  CHECK_BYTES(edges.block, all->edges, edges.bytes);
  CHECK_EQUAL(hsp_topology_get_shells(topology, (hsp_shell *)(void *)shells.block, all->counts.shells, &count), HSP_OK);
  CHECK_BYTES(shells.block, all->shells, shells.bytes);
  CHECK(guarded_clean(&onext) && guarded_clean(&origin) && guarded_clean(&edges) && guarded_clean(&shells));
  guarded_give_back(&onext);
  guarded_give_back(&origin);
  guarded_give_back(&edges);
  guarded_give_back(&shells);
}

static void check_no_results(const void *topology) {
  hsp_topology_counts counts;
  uint32_t count = 12345;
  CHECK_EQUAL(hsp_topology_get_counts(topology, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_topology_get_shells(topology, NULL, 0, &count), HSP_E_STATE);
  CHECK_EQUAL(hsp_topology_onext(topology, 0), HSP_NONE);
  CHECK_EQUAL(count, 12345);
}

static known_handle known_topology(const topology_result *all) {
  known_handle known = {&topology_handle, NULL, NULL, check_results, check_no_results, NULL};
  known.source = all;
  known.needed = &all->needed;
  return known;
}

/* ---- output arrays ---- */

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
  return hsp_topology_get_scan(q->all->topology, q->id, out, capacity, needed);
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

/* ---- sizes ---- */

static size_t macro(const limit_numbers *limits) {
  const uint32_t *n = limits->number;
  return HSP_TOPOLOGY_BYTES(n[1], n[2], n[3], n[4]);
}

static void sizes(void) {
  static const size_bound bound = {macro, {4096, 64, 192, 160, 160}};
  static const uint32_t box[] = {0, 1, 2, 3, 7, 8, 9, 64, 65, 1000, 4097, 1000000, 0x0FFFFFFF};
  const uint32_t own = (uint32_t)sizeof(hsp_topology_limits);
  const limit_numbers few = {{own, 1000, 50, 1000, 100}}, balls = {{own, 2000, 50, 1000, 100}},
                      edges = {{own, 1000, 50, 2000, 100}};
  sweep_sizes(&topology_handle, &bound, box, sizeof box / sizeof box[0]);
  CHECK(size_of(&topology_handle, &bound, &few) < size_of(&topology_handle, &bound, &balls));
  CHECK(size_of(&topology_handle, &bound, &few) < size_of(&topology_handle, &bound, &edges));
}

/* What uses scratch memory. */
static void check_and_locate(void *topology, const void *source) {
  static const double place[3] = {0, 1, 0};
  uint32_t law = 77, where = 77, cell = 77;
  (void)source;
  CHECK_EQUAL(hsp_topology_check(topology, &law, &where), HSP_OK);
  CHECK_EQUAL(hsp_topology_locate(topology, place, &cell, NULL, 0, NULL), HSP_OK);
  CHECK_EQUAL(cell, 1);
}

static void every_alignment(void) {
  static ball_set set;
  computed c;
  topology_result all;
  topology_set_two_in_a_void(&set);
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
  if (CHECK_EQUAL(topology_result_make(&c, &all), HSP_OK)) {
    const known_handle known = known_topology(&all);
    sweep_alignments(&known, check_and_locate);
  }
  topology_result_release(&all);
  computed_release(&c);
}

int main(void) {
  uint32_t which;
  sizes();
  every_alignment();
  for (which = 0; which < topology_set_count(); ++which) {
    static ball_set set;
    computed c;
    topology_result all;
    topology_set_make(which, &set);
    check_scene("%s", set.name);
    memset(&all, 0, sizeof all);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK) &&
        CHECK_EQUAL(topology_result_make(&c, &all), HSP_OK)) {
      const known_handle known = known_topology(&all);
      sweep_limits(&known, set.name);
      check_scene("%s", set.name);
      sweep_outputs(&all);
    }
    topology_result_release(&all);
    computed_release(&c);
  }
  return check_report();
}
