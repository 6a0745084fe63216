#include "pores_result.h"

#include <stdlib.h>
#include <string.h>

int32_t find_widest_tunnel(hsp_pores *pores, hsp_tunnel *tunnel, hsp_pores_limits *limits) {
  hsp_pores_counts counts;
  hsp_pore_maximum widest = {{1000, 0, 0}, 0, 0, {0}, 0, 0};
  int32_t status = hsp_pores_get_counts(pores, &counts);
  if (status == HSP_OK && counts.maxima > 0) status = hsp_pores_get_maxima(pores, 0, 1, &widest);
  return status != HSP_OK ? status : hsp_pores_find_tunnel(pores, widest.xyz, NULL, NULL, 0, tunnel, limits);
}

HANDLE_FUNCTIONS(pores)
LIMITS_OF_BALLS(pores)

static int32_t pores_compute(void *handle, const void *source, void *limits) {
  const computed *base = ((const pores_result *)source)->base;
  const hsp_periodic *periodic = ((const pores_result *)source)->periodic;
  hsp_pores_options options;
  hsp_tunnel tunnel;
  uint32_t i;
  int32_t status = hsp_pores_options_init(&options, (uint32_t)sizeof options);
  if (periodic != NULL) return hsp_pores_compute_periodic(handle, periodic, NULL, limits);
  for (i = 0; i < base->n; ++i) {
    if (-base->radius[i] < options.floor) options.floor = -base->radius[i];
  }
  if (status == HSP_OK) status = hsp_pores_compute(handle, base->model, &options, limits);
  return status != HSP_OK ? status : find_widest_tunnel(handle, &tunnel, limits);
}

/* By the header at most forty enlargements for the pores, and one for the tunnel. */
const handle_kind pores_handle = {(uint32_t)sizeof(hsp_pores_limits),
                                  7,
                                  {"", "balls", "maxima", "gates", "tied balls", "candidates", "neighbours", "points"},
                                  init_limits,
                                  bytes_of_limits,
                                  init_handle,
                                  pores_compute,
                                  38};

int32_t pores_result_make(const computed *base, pores_result *p) {
  return pores_result_make_in_box(base, NULL, p);
}

int32_t pores_result_make_in_box(const computed *base, const hsp_periodic *periodic, pores_result *p) {
  void *pores = NULL;
  int32_t status;
  memset(p, 0, sizeof *p);
  p->base = base;
  p->periodic = periodic;
  status = grow_until_computed(&pores_handle, p, 0, &p->memory, &pores, &p->needed, &p->enlargements);
  p->pores = pores;
  if (status == HSP_OK) status = hsp_pores_get_counts(p->pores, &p->counts);
  return status != HSP_OK || periodic != NULL ? status : find_widest_tunnel(p->pores, &p->tunnel, NULL);
}

void pores_result_release(pores_result *p) {
  free(p->memory);
  memset(p, 0, sizeof *p);
}
