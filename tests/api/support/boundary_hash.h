/* A hash over everything that can be read of a boundary and of the model that it is of. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The FNV-1a hash of more bytes, continued from `hash`. */
uint64_t mixed_hash(uint64_t hash, const void *bytes, size_t size);

/* The hash of a boundary; `source` is the `computed` whose model the boundary is of. Records are read into `buffer`,
 * which has room for `room` records of the largest kind. 0 if a call fails. */
uint64_t boundary_hash(const void *boundary, const void *source, unsigned char *buffer, uint32_t room);

/* An upper bound of every number of records of the boundary. */
uint32_t boundary_room(const computed *c);

/* Calls the functions of a boundary that use its scratch memory; 0 if a call fails. */
int use_boundary(void *boundary);

#ifdef __cplusplus
}
#endif
