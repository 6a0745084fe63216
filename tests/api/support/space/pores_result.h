/* Pores of a computed set, in memory of their own. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Pores down to the level at which the largest ball has no radius left, with the tunnel from the widest maximum, if
 * there is one, to the outside. */
typedef struct pores_result {
  const computed *base;         /* what it was computed from; must outlive it */
  const hsp_periodic *periodic; /* if not NULL, its pores, above the floor 0 and without a tunnel; must outlive this */
  void *memory;
  hsp_pores *pores;
  hsp_pores_limits needed; /* exactly */
  uint32_t enlargements;   /* how often limits had to be raised, starting from none of anything */
  hsp_pores_counts counts;
  hsp_tunnel tunnel;
} pores_result;

/* Computes everything. The first status that is not HSP_OK, or HSP_OK. To be followed by the release in either case. */
int32_t pores_result_make(const computed *base, pores_result *result);
int32_t pores_result_make_in_box(const computed *base, const hsp_periodic *periodic, pores_result *result);
void pores_result_release(pores_result *result);

/* Finds the tunnel from the widest maximum to the outside in pores that were computed. */
int32_t find_widest_tunnel(hsp_pores *pores, hsp_tunnel *tunnel, hsp_pores_limits *limits);

/* How such handles are made; they are computed from a `pores_result` of which the base is used. Finding the tunnel is
 * part of the computation. */
extern const handle_kind pores_handle;

#ifdef __cplusplus
}
#endif
