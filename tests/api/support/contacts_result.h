/* Contacts of a computed set and everything the interface tells about them, in memory of its own. */
#pragma once

#include "computed.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct contacts_result {
  const computed *base; /* what they were computed from; must outlive them */
  void *memory;
  hsp_contacts *contacts;     /* triangles and tetrahedra are kept */
  hsp_contacts_limits needed; /* exactly, with triangles and tetrahedra */
  uint32_t enlargements;      /* how often limits had to be raised, starting from none of anything but balls */
  hsp_complex counts;
  uint32_t count; /* of contacts */
  hsp_contact *list;
  hsp_totals totals;
  double *share_volume, *contact_area; /* [n] */
} contacts_result;

/* Computes and reads everything. The first status that is not HSP_OK, or HSP_OK. To be followed by
 * contacts_result_release in either case. */
int32_t contacts_result_make(const computed *base, contacts_result *result);

void contacts_result_release(contacts_result *result);

/* How such handles are made; they are computed from a `contacts_result` of which only the base is used. The limits of
 * triangles and tetrahedra, where 0 means that they are only counted, are not among the limits of this kind. */
extern const handle_kind contacts_handle;

#ifdef __cplusplus
}
#endif
