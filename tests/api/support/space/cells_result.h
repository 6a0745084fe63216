/* The cells of free space of a computed set and everything the interface tells about them, in memory of its own. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct cells_result {
  const computed *base; /* what they were computed from; must outlive them */
  void *memory;
  hsp_cells *cells;
  hsp_cells_limits needed; /* exactly */
  uint32_t enlargements;   /* how often limits had to be raised, starting from none of anything */
  hsp_cells_counts counts;
  hsp_free_cell *list;
  hsp_cell_pair *pairs;
} cells_result;

/* Computes and reads everything. The first status that is not HSP_OK, or HSP_OK. To be followed by cells_result_release
 * in either case. */
int32_t cells_result_make(const computed *base, cells_result *result);

void cells_result_release(cells_result *result);

/* How such handles are made; they are computed from a `cells_result` of which only the base is used. */
extern const handle_kind cells_handle;

#ifdef __cplusplus
}
#endif
