/* A hash over everything that can be read of a boundary and of the model that it is of. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* FNV-1a, goes on from a hash. */
uint64_t mixed_hash(uint64_t hash, const void *bytes, size_t size);

/* Of a boundary of the model of `source`, a `computed`, by way of a buffer with room for so many of the largest
 * record; 0 if a call fails. */
uint64_t boundary_hash(const void *boundary, const void *source, unsigned char *buffer, uint32_t room);

/* No number of records of the boundary exceeds it. */
uint32_t boundary_room(const computed *c);

/* Calls what uses scratch memory; 0 if a call fails. */
int use_boundary(void *boundary);

#ifdef __cplusplus
}
#endif
