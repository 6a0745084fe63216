/* Every output array of the topology's functions, for every set of topology_sets.h, at capacities 0, 1, needed-1,
 * needed and needed+1: HSP_E_CAPACITY with the number needed and nothing written, or success with exactly that many
 * records; and at all ranges around the ends of the ids. Guard bytes lie around every array. */
#include <hardsphere.h>

#include "check.h"
#include "guarded_memory.h"
#include "output_sweep.h"
#include "topology_result.h"
#include "topology_sets.h"

/* The call that is tried, so that one sweep serves all functions. */
typedef struct question {
  const topology_result *all;
  uint32_t id;
} question;

static int32_t ask_shells(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_shells(q->all->topology, out, capacity, needed);
}
static int32_t ask_components(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_components(q->all->topology, out, capacity, needed);
}
static int32_t ask_regions(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_regions(q->all->topology, out, capacity, needed);
}
static int32_t ask_region_shells(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_region_shells(q->all->topology, q->id, out, capacity, needed);
}
static int32_t ask_scan(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_topology_get_traversal(q->all->topology, q->id, out, capacity, needed);
}

/* ---- ranges of ids ---- */

typedef int32_t (*reading)(const hsp_topology *topology, uint32_t first, uint32_t count, void *out);

static int32_t read_onext(const hsp_topology *topology, uint32_t first, uint32_t count, void *out) {
  return hsp_topology_get_quad_edges(topology, first, count, out, NULL);
}
static int32_t read_origin(const hsp_topology *topology, uint32_t first, uint32_t count, void *out) {
  return hsp_topology_get_quad_edges(topology, first, count, NULL, out);
}
static int32_t read_vertices(const hsp_topology *topology, uint32_t first, uint32_t count, void *out) {
  return hsp_topology_get_vertices(topology, first, count, out);
}
static int32_t read_edges(const hsp_topology *topology, uint32_t first, uint32_t count, void *out) {
  return hsp_topology_get_edges(topology, first, count, out);
}
static int32_t read_faces(const hsp_topology *topology, uint32_t first, uint32_t count, void *out) {
  return hsp_topology_get_simple_faces(topology, first, count, out);
}

/* Every range around the ends of `number` records: exactly what stands in `records`, which has them all, or HSP_E_ID
 * with nothing written. Ids and counts that are no ids at all, too, whose sum wraps around. */
static void sweep_range(reading read, const topology_result *all, const void *records, size_t record, uint32_t number) {
  uint32_t values[AROUND + 2];
  int f, k;
  values_around(number, values);
  values[AROUND] = number / 2;
  values[AROUND + 1] = HSP_NONE;
  for (f = 0; f < AROUND + 2; ++f) {
    const uint32_t first = values[f];
    for (k = 0; k < AROUND + 2; ++k) {
      const uint32_t count = values[k];
      const int there = first <= number && count <= number - first;
      guarded_memory out = guarded_take((there ? count : 1) * record, 0, GUARDED_PATTERN);
      CHECK_EQUAL(read(all->topology, first, count, out.block), there ? HSP_OK : HSP_E_ID);
      if (there) {
        CHECK_BYTES(out.block, (const unsigned char *)records + first * record, count * record);
      } else {
        CHECK(guarded_untouched(&out, GUARDED_PATTERN));
      }
      CHECK(guarded_clean(&out));
      guarded_give_back(&out);
      CHECK_EQUAL(read(all->topology, first, count, NULL), count > 0 ? HSP_E_ARGUMENT : there ? HSP_OK : HSP_E_ID);
    }
  }
}

static void sweep_outputs(const topology_result *all) {
  const hsp_topology_counts *k = &all->counts;
  question q;
  q.all = all;
  q.id = 0;
  sweep_range(read_onext, all, all->onext, 4 * sizeof(uint32_t), k->edges);
  sweep_range(read_origin, all, all->origin, 4 * sizeof(uint32_t), k->edges);
  sweep_range(read_vertices, all, all->vertices, sizeof(hsp_topology_vertex), k->vertices);
  sweep_range(read_edges, all, all->edges, sizeof(hsp_topology_edge), k->edges);
  sweep_range(read_faces, all, all->faces, sizeof(hsp_simple_face), k->simple_faces);
  sweep_output(ask_shells, &q, sizeof(hsp_shell), k->shells);
  sweep_output(ask_components, &q, sizeof(hsp_component), k->components);
  sweep_output(ask_regions, &q, sizeof(hsp_region), k->regions);
  for (q.id = 0; q.id < k->regions; q.id += 1 + k->regions / 4) {
    sweep_output(ask_region_shells, &q, sizeof(uint32_t), all->regions[q.id].shells);
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
