#include "core_sweeps.h"

#include <hardsphere.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "contacts_result.h"
#include "guarded_memory.h"
#include "output_sweep.h"
#include "topology_result.h"
#include "topology_sets.h"

/* ---- boundaries ---- */

static void boundary_results(const void *boundary, const void *source) {
  const computed *all = source;
  hsp_boundary_counts counts;
  hsp_totals totals;
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_OK);
  CHECK_BYTES(&counts, &all->counts, sizeof counts);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, &totals, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_BYTES(&totals, &all->totals, sizeof totals);
}

static void no_boundary_results(const void *boundary) {
  hsp_boundary_counts counts;
  uint32_t count = 12345;
  CHECK_EQUAL(hsp_boundary_get_counts(boundary, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_get_faces(boundary, NULL, 0, &count), HSP_E_STATE);
  CHECK_EQUAL(hsp_boundary_measure(boundary, NULL, NULL, NULL, NULL, 0, NULL), HSP_E_STATE);
  CHECK_EQUAL(count, 12345);
}

/* Exactly the limits that are too small must come back larger than given, as large as the full computation needs: balls
 * first, then neighbours, then vertices and circles. */
static void check_asked(const limit_numbers *given, const limit_numbers *says, const limit_numbers *exact) {
  static const int stages[3][2] = {{1, 1}, {2, 2}, {3, 4}};
  int stage, which, enough = 1;
  for (stage = 0; stage < 3 && enough; ++stage) {
    for (which = stages[stage][0]; which <= stages[stage][1]; ++which) {
      const int more = says->number[which] > given->number[which];
      CHECK_EQUAL(more, exact->number[which] > given->number[which]);
      CHECK(!more || says->number[which] == exact->number[which]);
      if (more) enough = 0;
    }
  }
  for (; stage < 3; ++stage) {
    for (which = stages[stage][0]; which <= stages[stage][1]; ++which) {
      CHECK_EQUAL(says->number[which], given->number[which]);
    }
  }
}

void sweep_boundary(const computed *all, const char *name, limits_sweep *sweep) {
  const known_handle known = {&boundary_handle, all, &all->needed, boundary_results, no_boundary_results, check_asked};
  sweep(&known, name);
  if (all->needed.vertices > 0 || all->needed.circles > 0) {
    limit_numbers limits = {{0}};
    memcpy(&limits, &all->needed, sizeof all->needed);
    limits.number[3] = limits.number[4] = 0;
    check_scene("%s, neither vertices nor circles", name);
    try_limits(&known, &limits, 5);
  }
}

/* ---- topologies ---- */

static void topology_results(const void *handle, const void *source) {
  hsp_topology *topology = (hsp_topology *)handle; /* not const for what scans its shells */
  const topology_result *all = source;
  hsp_topology_counts counts;
  uint32_t count = 0;
  guarded_memory onext = guarded_take(4 * sizeof(uint32_t) * (size_t)all->counts.edges, 0, GUARDED_PATTERN);
  guarded_memory origin = guarded_take(4 * sizeof(uint32_t) * (size_t)all->counts.edges, 0, GUARDED_PATTERN);
  guarded_memory edges = guarded_take(sizeof(hsp_topology_edge) * all->counts.edges, 0, GUARDED_PATTERN);
  guarded_memory shells = guarded_take(sizeof(hsp_shell) * all->counts.shells, 0, GUARDED_PATTERN);
  CHECK_EQUAL(hsp_topology_get_counts(topology, &counts), HSP_OK);
  CHECK_BYTES(&counts, &all->counts, sizeof counts);
  CHECK_EQUAL(hsp_topology_get_quad_edges(topology, 0, all->counts.edges, (uint32_t *)(void *)onext.block,
                                          (uint32_t *)(void *)origin.block),
              HSP_OK);
  CHECK_BYTES(onext.block, all->onext, onext.bytes);
  CHECK_BYTES(origin.block, all->origin, origin.bytes);
  CHECK_EQUAL(hsp_topology_get_edges(topology, 0, all->counts.edges, (hsp_topology_edge *)(void *)edges.block), HSP_OK);
  CHECK_BYTES(edges.block, all->edges, edges.bytes);
  CHECK_EQUAL(hsp_topology_get_shells(topology, (hsp_shell *)(void *)shells.block, all->counts.shells, &count), HSP_OK);
  CHECK_BYTES(shells.block, all->shells, shells.bytes);
  CHECK(guarded_clean(&onext) && guarded_clean(&origin) && guarded_clean(&edges) && guarded_clean(&shells));
  guarded_give_back(&onext);
  guarded_give_back(&origin);
  guarded_give_back(&edges);
  guarded_give_back(&shells);
}

static void no_topology_results(const void *handle) {
  hsp_topology *topology = (hsp_topology *)handle;
  hsp_topology_counts counts;
  uint32_t count = 12345;
  CHECK_EQUAL(hsp_topology_get_counts(topology, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_topology_get_shells(topology, NULL, 0, &count), HSP_E_STATE);
  CHECK_EQUAL(hsp_topology_onext(topology, 0), HSP_NONE);
  CHECK_EQUAL(count, 12345);
}

/* The limit for shells, where 0 stands for as many as the edges allow: beside exact limits, and beside no limits. */
static void sweep_shells(const known_handle *known, const topology_result *all, const char *name) {
  const uint32_t needed = all->needed.shells;
  uint32_t values[AROUND], i, few;
  values_around(needed, values);
  for (i = 0; i < AROUND; ++i) {
    for (few = 0; few < 2; ++few) {
      hsp_topology_limits limits = all->needed;
      size_t bytes = 0;
      guarded_memory memory;
      hsp_topology *topology = NULL;
      check_scene("%s, shells %u of %u", name, (unsigned)values[i], (unsigned)needed);
      limits.shells = values[i];
      if (few) limits.edges = limits.cut_arcs = 0;
      CHECK_EQUAL(hsp_topology_bytes(&limits, &bytes), HSP_OK);
      memory = guarded_take(bytes, i, GUARDED_RANDOM);
      CHECK_EQUAL(hsp_topology_init(memory.block, bytes, &limits, &topology), HSP_OK);
      if ((values[i] == 0 || values[i] >= needed) && (!few || all->needed.edges == 0)) {
        CHECK_EQUAL(hsp_topology_compute(topology, all->base->boundary, &limits), HSP_OK);
        CHECK_BYTES(&limits, &all->needed, sizeof limits);
        known->check_results(topology, all);
      } else {
        CHECK_EQUAL(hsp_topology_compute(topology, all->base->boundary, &limits), HSP_E_CAPACITY);
        CHECK_EQUAL(limits.shells, values[i] == 0 || values[i] > needed ? values[i] : needed);
        CHECK(limits.edges <= all->needed.edges && (few == 0 || limits.edges > 0));
        known->check_no_results(topology);
      }
      CHECK(guarded_clean(&memory));
      guarded_give_back(&memory);
    }
  }
}

void sweep_topology(const computed *c, const char *name, limits_sweep *sweep) {
  topology_result all;
  if (CHECK_EQUAL(topology_result_make(c, &all), HSP_OK)) {
    const known_handle known = {&topology_handle, &all, &all.needed, topology_results, no_topology_results, NULL};
    sweep(&known, name);
    sweep_shells(&known, &all, name);
  }
  topology_result_release(&all);
}

/* ---- contacts ---- */

static void contacts_results(const void *contacts, const void *source) {
  const contacts_result *all = source;
  const uint32_t n = all->base->n;
  hsp_complex counts;
  hsp_totals totals;
  uint32_t count = 0;
  guarded_memory list = guarded_take(sizeof(hsp_contact) * all->count, 0, GUARDED_PATTERN);
  guarded_memory volume = guarded_take(sizeof(double) * n, 0, GUARDED_PATTERN);
  guarded_memory area = guarded_take(sizeof(double) * n, 0, GUARDED_PATTERN);
  CHECK_EQUAL(hsp_contacts_get_complex(contacts, &counts), HSP_OK);
  CHECK_BYTES(&counts, &all->counts, sizeof counts);
  CHECK_EQUAL(hsp_contacts_get_pairs(contacts, (void *)list.block, all->count, &count), HSP_OK);
  CHECK_BYTES(list.block, all->list, list.bytes);
  CHECK_EQUAL(hsp_contacts_measure(contacts, &totals, (void *)volume.block, (void *)area.block, n, NULL), HSP_OK);
  CHECK_BYTES(&totals, &all->totals, sizeof totals);
  CHECK_BYTES(volume.block, all->share_volume, volume.bytes);
  CHECK_BYTES(area.block, all->contact_area, area.bytes);
  CHECK(guarded_clean(&list) && guarded_clean(&volume) && guarded_clean(&area));
  guarded_give_back(&list);
  guarded_give_back(&volume);
  guarded_give_back(&area);
}

static void no_contacts_results(const void *contacts) {
  hsp_complex counts;
  uint32_t count = 12345;
  CHECK_EQUAL(hsp_contacts_get_complex(contacts, &counts), HSP_E_STATE);
  CHECK_EQUAL(hsp_contacts_get_pairs(contacts, NULL, 0, &count), HSP_E_STATE);
  CHECK_EQUAL(count, 12345);
}

/* The limits for simplices, where 0 means that they are only counted: 0 suffices, and so does the number needed. */
static void sweep_simplices(const contacts_result *all, const char *name) {
  int dimension;
  for (dimension = 2; dimension < 4; ++dimension) {
    const uint32_t needed = dimension == 2 ? all->needed.triangles : all->needed.tetrahedra;
    uint32_t values[AROUND], i;
    values_around(needed, values);
    for (i = 0; i < AROUND; ++i) {
      const int enough = values[i] == 0 || values[i] >= needed;
      hsp_contacts_limits limits = all->needed;
      uint32_t *limit = dimension == 2 ? &limits.triangles : &limits.tetrahedra;
      size_t bytes = 0;
      guarded_memory memory;
      hsp_contacts *contacts = NULL;
      check_scene("%s, %u of %u simplices of dimension %d", name, (unsigned)values[i], (unsigned)needed, dimension);
      *limit = values[i];
      CHECK_EQUAL(hsp_contacts_bytes(&limits, &bytes), HSP_OK);
      memory = guarded_take(bytes, i, GUARDED_RANDOM);
      CHECK_EQUAL(hsp_contacts_init(memory.block, bytes, &limits, &contacts), HSP_OK);
      CHECK_EQUAL(hsp_contacts_compute(contacts, all->base->boundary, &limits), enough ? HSP_OK : HSP_E_CAPACITY);
      CHECK_EQUAL(*limit, values[i] == 0 ? 0 : needed);
      CHECK_EQUAL(limits.contacts, all->needed.contacts);
      if (enough) {
        uint32_t count = 12345;
        hsp_simplex *list = test_zeros(needed, sizeof *list);
        contacts_results(contacts, all);
        CHECK_EQUAL(hsp_contacts_get_simplices(contacts, (uint32_t)dimension, list, needed, &count),
                    values[i] == 0 && needed > 0 ? HSP_E_STATE : HSP_OK);
        CHECK_EQUAL(count, values[i] == 0 && needed > 0 ? 12345 : needed);
        free(list);
      } else {
        no_contacts_results(contacts);
      }
      CHECK(guarded_clean(&memory));
      guarded_give_back(&memory);
    }
  }
}

void sweep_contacts(const computed *c, const char *name, limits_sweep *sweep) {
  contacts_result all;
  if (CHECK_EQUAL(contacts_result_make(c, &all), HSP_OK)) {
    hsp_contacts_limits needed = all.needed;
    const known_handle known = {&contacts_handle, &all, &needed, contacts_results, no_contacts_results, NULL};
    needed.triangles = needed.tetrahedra = 0;
    sweep(&known, name);
    sweep_simplices(&all, name);
  }
  contacts_result_release(&all);
}

uint32_t sweep_every_limit_of_core(uint32_t least, uint32_t most) {
  static ball_set set;
  uint32_t which, sets = 0;
  for (which = 0; which < topology_set_count(); ++which) {
    computed all;
    topology_set_make(which, &set);
    if (set.n < least || set.n > most) continue;
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &all), HSP_OK)) {
      sweep_boundary(&all, set.name, sweep_every_limit);
      sweep_topology(&all, set.name, sweep_every_limit);
      sweep_contacts(&all, set.name, sweep_every_limit);
      ++sets;
    }
    computed_release(&all);
  }
  return sets;
}
