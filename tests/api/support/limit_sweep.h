/* Sweeps over the limits of a kind of handle at all values that matter, and over sizes and alignments of its memory. */
#pragma once

#include "handle_kind.h"

/* A computation whose needed limits and results are known, from a run with ample memory. */
typedef struct known_handle {
  const handle_kind *kind;
  const void *source; /* what handle_kind.compute takes */
  const void *needed; /* the limits that it needs, exactly */
  /* Checks that a handle's results are those of `source`. */
  void (*check_results)(const void *handle, const void *source);
  /* Checks that a handle has no results. */
  void (*check_no_results)(const void *handle);
  /* Checks what a handle with the limits `given` says to retry with; NULL: nothing beyond what holds of all kinds. */
  void (*check_asked)(const limit_numbers *given, const limit_numbers *says, const limit_numbers *exact);
} known_handle;

/* Computes with every limit at 0, 1, needed-1, needed and needed+1, with every limit as the only one that suffices, and
 * with no limit that suffices, in memory of exactly the reported size between guard bytes. The outcome must be the
 * known results, or HSP_E_CAPACITY without results; then the limits that come back must lead to success. */
void sweep_limits(const known_handle *known, const char *name);

/* The same with every limit at every value below what it needs, beside limits that are exact. */
void sweep_every_limit(const known_handle *known, const char *name);

/* Computes with the limits `from`, then with those that come back, until the computation succeeds, and checks each
 * step. */
void try_limits(const known_handle *known, const limit_numbers *from, size_t misalignment);

/* Computes in memory of exactly the reported size at 16 alignments; one byte less is refused without a write. `more` is
 * called with each computed handle, NULL for nothing. */
void sweep_alignments(const known_handle *known, void (*more)(void *handle, const void *source));

/* The bound by a kind's macro on the size of its memory, and the macro's factors: of 1, and of every limit. */
typedef struct size_bound {
  size_t (*macro)(const limit_numbers *limits);
  double factors[LIMIT_NUMBERS];
  double too_many_items; /* bytes from which on an array may have 2^32 items, so that limits are refused; or 0 */
} size_bound;

/* The sizes of a kind's memory for all combinations of limits out of `values`, which ascend. Property 1: the macro
 * bounds the sizes. Property 2: the sizes grow with each limit. If size_t has 32 bits, just the sizes of 2 GiB and
 * more are refused. */
void sweep_sizes(const handle_kind *kind, const size_bound *bound, const uint32_t *values, int count);

/* The size of the memory for such limits; SIZE_MAX stands for one that is rightly refused. */
size_t size_of(const handle_kind *kind, const size_bound *bound, const limit_numbers *limits);
