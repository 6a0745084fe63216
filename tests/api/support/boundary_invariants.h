/* Invariants of any computed boundary: the promises of the header, checked from the records alone, in C99, without the
 * library's inner code. Each function returns NULL, or a sentence about the first invariant that does not hold. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The records, then the measures. */
const char *broken_boundary(const computed *c);

/* Structure and numbers of records. Time is at most quadratic in the number of balls. */
const char *broken_boundary_records(const computed *c);

/* Positions, angles, areas and volumes, within rounding errors. The records must be sound. */
const char *broken_boundary_measures(const computed *c);

/* A sentence if hsp_boundary_check or hsp_topology_check, whose status and outputs these are, found anything. */
const char *broken_by_own_check(int32_t status, uint32_t invariant, uint32_t id);

/* The order of the balls has no effect but on ids: ball i of `other` is ball order[i] of c. Positions and areas agree
 * bit for bit. Balls with equal centre and radius are interchangeable. */
const char *boundary_difference_after_permutation(const computed *c, const computed *other, const uint32_t *order);

#ifdef __cplusplus
}
#endif
