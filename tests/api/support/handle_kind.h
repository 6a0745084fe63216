/* The common form of all handles with limits (boundaries, topologies, views and others): limits, each of which is a
 * number, memory whose size follows from the limits, and a computation that says which limits it needed. */
#pragma once

#include <hardsphere.h>
#include <stddef.h>
#include <stdint.h>

/* A struct of limits as an array of its numbers: struct_size, balls, neighbours and so on, then zeros. The header
 * promises that a computation succeeds after its limits were raised at most three times to what the handle asked for.
 *  */
enum { LIMIT_NUMBERS = 11, MOST_ENLARGEMENTS = 3 };
typedef struct limit_numbers {
  uint32_t number[LIMIT_NUMBERS];
} limit_numbers;

typedef struct handle_kind {
  uint32_t struct_size;             /* of the limits */
  int limits;                       /* how many there are: number[1] to number[limits] */
  const char *names[LIMIT_NUMBERS]; /* by their places in limit_numbers; NULL: reserved */
  /* NULL for topologies, whose limits suit a boundary */
  int32_t (*limits_init)(void *limits, uint32_t struct_size, uint32_t balls);
  int32_t (*bytes)(const void *limits, size_t *bytes);
  int32_t (*init)(void *memory, size_t bytes, const void *limits, void **handle);
  /* source: the computed, topology_result, view_result ... of this kind; limits: of struct_size bytes, or NULL */
  int32_t (*compute)(void *handle, const void *source, void *limits);
  uint32_t more_enlargements; /* how many more than MOST_ENLARGEMENTS the header allows for this kind */
} handle_kind;

/* The functions of hsp_boundary, hsp_topology or hsp_view as a handle_kind holds them, but for `limits_init` and
 * `compute`. */
#define HANDLE_FUNCTIONS(noun)                                                                      \
  static int32_t bytes_of_limits(const void *limits, size_t *bytes) {                               \
    return hsp_##noun##_bytes(limits, bytes);                                                       \
  }                                                                                                 \
  static int32_t init_handle(void *memory, size_t bytes, const void *limits, void **handle) {       \
    hsp_##noun *made = handle != NULL ? *handle : NULL;                                             \
    const int32_t status = hsp_##noun##_init(memory, bytes, limits, handle != NULL ? &made : NULL); \
    if (handle != NULL) *handle = made;                                                             \
    return status;                                                                                  \
  }

/* `limits_init` of hsp_boundary and hsp_view. */
#define LIMITS_OF_BALLS(noun)                                                      \
  static int32_t init_limits(void *limits, uint32_t struct_size, uint32_t balls) { \
    return hsp_##noun##_limits_init(limits, struct_size, balls);                   \
  }

/* Zeros, to be freed by the caller; at least one byte. Ends the program if there is no memory. */
void *test_zeros(size_t count, size_t size);

/* Computes with room for nothing but the balls, and again with the limits that come back, until the computation
 * succeeds. The limits that were needed go to `needed`, which has struct_size bytes. *memory was allocated and must be
 * freed by the caller in any case. Returns HSP_OK, or the first status that is neither HSP_OK nor an allowed
 * HSP_E_CAPACITY. */
int32_t grow_until_computed(const handle_kind *kind, const void *source, uint32_t balls, void **memory, void **handle,
                            void *needed, uint32_t *enlargements);
