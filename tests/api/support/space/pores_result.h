/* Pores of a computed set, in memory of their own. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Down to where the largest ball has no radius left, with the tunnel from the widest maximum, if there is one, to the
 * outside. */
typedef struct pores_result {
  const computed *base;         /* what it was computed from; must outlive it */
  const hsp_periodic *periodic; /* or NULL: instead of that, above the floor 0 and without a tunnel; likewise */
  void *memory;
  hsp_pores *pores;
  hsp_pores_limits needed; /* exactly */
  uint32_t enlargements;   /* how often limits had to be raised, starting from none of anything */
  hsp_pores_counts counts;
  hsp_tunnel tunnel;
} pores_result;

/* Compute everything. The first status that is not HSP_OK, or HSP_OK. To be followed by the release in either case. */
int32_t pores_result_make(const computed *base, pores_result *result);
int32_t pores_result_make_in_box(const computed *base, const hsp_periodic *periodic, pores_result *result);
void pores_result_release(pores_result *result);

/* Find that tunnel of pores that were computed. */
int32_t find_widest_tunnel(hsp_pores *pores, hsp_tunnel *tunnel, hsp_pores_limits *limits);

/* How such handles are made; they are computed from a `pores_result`, which needs its base. The tunnel is part of
 * it. */
extern const handle_kind pores_handle;

#ifdef __cplusplus
}
#endif
