#include "contacts_result.h"

#include <stdlib.h>
#include <string.h>

HANDLE_FUNCTIONS(contacts)

static int32_t compute_handle(void *handle, const void *source, void *limits) {
  const contacts_result *c = source;
  return hsp_contacts_compute(handle, c->base->boundary, limits);
}

const handle_kind contacts_handle = {(uint32_t)sizeof(hsp_contacts_limits),
                                     3,
                                     {"", "balls", "neighbours", "contacts", "triangles", "tetrahedra"},
                                     NULL,
                                     bytes_of_limits,
                                     init_handle,
                                     compute_handle,
                                     0};

static uint32_t simplices(const hsp_complex *counts, int dimension) {
  return counts->singular[dimension] + counts->regular[dimension] + counts->interior[dimension];
}

/* Once more, with room for all triangles and tetrahedra. */
static int32_t keep_simplices(contacts_result *c) {
  hsp_contacts_limits *limits = &c->needed;
  void *contacts = NULL;
  size_t bytes = 0;
  int32_t status = hsp_contacts_get_complex(c->contacts, &c->counts);
  limits->triangles = simplices(&c->counts, 2);
  limits->tetrahedra = simplices(&c->counts, 3);
  if (status == HSP_OK) status = hsp_contacts_bytes(limits, &bytes);
  if (status != HSP_OK) return status;
  free(c->memory);
  c->memory = test_zeros(bytes, 1);
  status = contacts_handle.init(c->memory, bytes, limits, &contacts);
  c->contacts = contacts;
  return status == HSP_OK ? hsp_contacts_compute(contacts, c->base->boundary, NULL) : status;
}

int32_t contacts_result_make(const computed *base, contacts_result *c) {
  void *contacts = NULL;
  uint32_t needed = 0;
  int32_t status;
  memset(c, 0, sizeof *c);
  c->base = base;
  status = grow_until_computed(&contacts_handle, c, base->n, &c->memory, &contacts, &c->needed, &c->enlargements);
  c->contacts = contacts;
  if (status == HSP_OK) status = keep_simplices(c);
  if (status != HSP_OK) return status;
  c->count = simplices(&c->counts, 1);
  c->list = test_zeros(c->count, sizeof *c->list);
  c->share_volume = test_zeros(base->n, sizeof *c->share_volume);
  c->contact_area = test_zeros(base->n, sizeof *c->contact_area);
  status = hsp_contacts_get_pairs(c->contacts, c->list, c->count, &needed);
  if (status != HSP_OK) return status;
  return hsp_contacts_measure(c->contacts, &c->totals, c->share_volume, c->contact_area, base->n, NULL);
}

void contacts_result_release(contacts_result *c) {
  free(c->memory);
  free(c->list);
  free(c->share_volume);
  free(c->contact_area);
  memset(c, 0, sizeof *c);
}
