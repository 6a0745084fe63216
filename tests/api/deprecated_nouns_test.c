/* Old names of nouns in hardsphere/deprecated.h: the same bytes and statuses as the new ones. */
#define HSP_NO_DEPRECATION_WARNINGS
#include <hardsphere_workspace.h>
#include <string.h>

#include "check.h"

enum { BALLS = 8, MOST = 64 };
static const double inside[3] = {0, 0, 0};

/* The corners of a cube, whose balls close its faces and leave its middle open: a void. */
static int make(hsp_workspace *work) {
  double xyz[3 * BALLS], radius[BALLS];
  hsp_model_options options;
  int k;
  for (k = 0; k < 3 * BALLS; ++k) xyz[k] = (k / 3 >> k % 3 & 1) != 0 ? 1 : -1;
  for (k = 0; k < BALLS; ++k) radius[k] = 1.25;
  CHECK_EQUAL(hsp_model_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  options.probe = 0.25;
  return CHECK_EQUAL(hsp_workspace_set(work, BALLS, xyz, radius, &options, NULL), HSP_OK) &&
         CHECK_EQUAL(hsp_workspace_boundary(work), HSP_OK) && CHECK_EQUAL(hsp_workspace_topology(work), HSP_OK) &&
         CHECK_EQUAL(hsp_workspace_contacts(work), HSP_OK) && CHECK_EQUAL(hsp_workspace_surface(work), HSP_OK) &&
         CHECK_EQUAL(hsp_workspace_gate(work, inside, NULL), HSP_OK);
}

static void regions(const hsp_workspace *work) {
  hsp_cell old_records[MOST];
  hsp_region records[MOST];
  uint32_t old_ids[MOST], ids[MOST], old_needed = 7, needed = 9, region;
  memset(old_records, 0, sizeof old_records);
  memset(records, 0, sizeof records);
  CHECK_EQUAL(hsp_topology_get_regions(work->topology, records, MOST, &needed), HSP_OK);
  CHECK_EQUAL(hsp_topology_get_cells(work->topology, old_records, MOST, &old_needed), HSP_OK);
  CHECK_EQUAL(needed, 2);
  CHECK_EQUAL(old_needed, needed);
  CHECK_BYTES(old_records, records, sizeof records);
  CHECK_EQUAL(hsp_topology_get_cells(work->topology, NULL, 0, NULL), HSP_E_CAPACITY);
  for (region = 0; region < 3; ++region) {
    const int32_t status = region < 2 ? HSP_OK : HSP_E_ID;
    memset(old_ids, 0, sizeof old_ids);
    memset(ids, 0, sizeof ids);
    CHECK_EQUAL(hsp_topology_get_region_shells(work->topology, region, ids, MOST, &needed), status);
    CHECK_EQUAL(hsp_topology_get_cell_shells(work->topology, region, old_ids, MOST, &old_needed), status);
    CHECK_EQUAL(old_needed, needed);
    CHECK_BYTES(old_ids, ids, sizeof ids);
    CHECK_EQUAL(hsp_topology_get_region_balls(work->topology, region, ids, MOST, &needed), status);
    CHECK_EQUAL(hsp_topology_get_cell_balls(work->topology, region, old_ids, MOST, &old_needed), status);
    CHECK_EQUAL(old_needed, needed);
    CHECK_BYTES(old_ids, ids, sizeof ids);
  }
}

static void pairs_and_gate(const hsp_workspace *work) {
  hsp_contact old_pairs[MOST], pairs[MOST];
  hsp_widest_probe old_widest, widest;
  uint32_t old_needed = 7, needed = 9;
  memset(old_pairs, 0, sizeof old_pairs);
  memset(pairs, 0, sizeof pairs);
  CHECK_EQUAL(hsp_contacts_get_pairs(work->contacts, pairs, MOST, &needed), HSP_OK);
  CHECK_EQUAL(hsp_contacts_get(work->contacts, old_pairs, MOST, &old_needed), HSP_OK);
  CHECK(needed >= 12);
  CHECK_EQUAL(old_needed, needed);
  CHECK_BYTES(old_pairs, pairs, sizeof pairs);
  CHECK_EQUAL(hsp_contacts_get(NULL, old_pairs, MOST, NULL), HSP_E_ARGUMENT);
  memset(&old_widest, 0, sizeof old_widest);
  memset(&widest, 0, sizeof widest);
  CHECK_EQUAL(hsp_gate_get_widest(work->gate, &widest), HSP_OK);
  CHECK_EQUAL(hsp_gate_get(work->gate, &old_widest), HSP_OK);
  CHECK_BYTES(&old_widest, &widest, sizeof widest);
}

static void parts(const hsp_workspace *work) {
  hsp_surface_map_counts old_counts;
  hsp_surface_part_counts counts;
  int32_t status;
  memset(&old_counts, 0, sizeof old_counts);
  memset(&counts, 0, sizeof counts);
  status = hsp_surface_get_part_counts(work->surface, &counts);
  CHECK_EQUAL(hsp_surface_get_map_counts(work->surface, &old_counts), status);
  CHECK(status == HSP_OK && counts.patches > 0);
  CHECK_BYTES(&old_counts, &counts, sizeof counts);
  CHECK_EQUAL(hsp_surface_get_map_counts(work->surface, NULL), HSP_E_ARGUMENT);
}

int main(void) {
  hsp_workspace work = {0};
  if (make(&work)) {
    regions(&work);
    pairs_and_gate(&work);
    parts(&work);
  }
  hsp_workspace_free(&work);
  return check_report();
}
