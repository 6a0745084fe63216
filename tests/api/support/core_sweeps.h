/* Limits of the core's handles, which are boundaries, topologies and contacts, at the values that a sweep chooses. */
#pragma once

#include "ball_sets.h"
#include "computed.h"
#include "limit_sweep.h"

/* sweep_limits or sweep_every_limit. */
typedef void limits_sweep(const known_handle *known, const char *name);

void sweep_boundary(const computed *all, const char *name, limits_sweep *sweep);
void sweep_topology(const computed *c, const char *name, limits_sweep *sweep);
void sweep_contacts(const computed *c, const char *name, limits_sweep *sweep);

/* Every limit at every value below what suffices, for all sets of topology_sets.h with so many balls: HSP_E_CAPACITY,
 * no results and nothing written beside the handle's memory; with what is handed back, as often as the header says,
 * the results that there are with ample memory. Returns how many sets that were. */
uint32_t sweep_every_limit_of_core(uint32_t least, uint32_t most);
