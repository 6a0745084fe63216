/* The balls of a computed set in a periodic box and everything the interface tells about them, in memory of its own. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct periodic_result {
  const computed *base; /* the set; must outlive this */
  double box[9];        /* a little less wide than the set, so that it meets its images, and skew */
  void *memory;
  hsp_periodic *periodic;
  hsp_periodic_limits needed; /* exactly */
  uint32_t enlargements;      /* how often limits had to be raised, starting from none of anything but balls */
  hsp_periodic_counts counts;
  hsp_periodic_totals totals;
  double *area, *share_volume; /* [n] */
  hsp_periodic_contact *contacts;
  hsp_periodic_vertex *vertices;
  hsp_periodic_arc *arcs;
  hsp_periodic_circle *circles;
  hsp_winding *windings; /* [components] */
} periodic_result;

/* Computes and reads everything. The first status that is not HSP_OK, or HSP_OK. To be followed by
 * periodic_result_release in either case. */
int32_t periodic_result_make(const computed *base, periodic_result *result);

/* The same with the vectors of the box turned, so that none of their components is 0. */
int32_t periodic_result_make_turned(const computed *base, periodic_result *result);

void periodic_result_release(periodic_result *result);

/* How such handles are made; they are computed from a `periodic_result` of which only base and box are used. */
extern const handle_kind periodic_handle;

#ifdef __cplusplus
}
#endif
