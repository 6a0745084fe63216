/* Sweeps over the limits of the core's handles: boundaries, topologies and contacts. */
#pragma once

#include "ball_sets.h"
#include "computed.h"
#include "limit_sweep.h"

/* sweep_limits or sweep_every_limit. */
typedef void limits_sweep(const known_handle *known, const char *name);

void sweep_boundary(const computed *all, const char *name, limits_sweep *sweep);
void sweep_topology(const computed *c, const char *name, limits_sweep *sweep);
void sweep_contacts(const computed *c, const char *name, limits_sweep *sweep);

/* Tries every limit at every value below the one that suffices, for all sets of topology_sets.h of `least` to `most`
 * balls. Each computation must return HSP_E_CAPACITY, have no results, and write nothing beside the handle's memory.
 * With the limits handed back, as often as the header says, it must have the same results as with ample memory. Returns
 * the number of sets. */
uint32_t sweep_every_limit_of_core(uint32_t least, uint32_t most);
