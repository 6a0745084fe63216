#include "boundary_invariants.h"

#include <stddef.h>

const char *broken_by_own_check(int32_t status, uint32_t invariant, uint32_t id) {
  static const char *const found[] = {"the library's own check fails without an invariant",
                                      "the library's own check: invariant 1",
                                      "the library's own check: invariant 2",
                                      "the library's own check: invariant 3",
                                      "the library's own check: invariant 4",
                                      "the library's own check: invariant 5",
                                      "the library's own check: invariant 6",
                                      "the library's own check: invariant 7",
                                      "the library's own check: invariant 8",
                                      "the library's own check: invariant 9",
                                      "the library's own check: invariant 10",
                                      "the library's own check: invariant 11"};
  if (invariant >= sizeof found / sizeof found[0]) return "the library's own check: no such invariant";
  if (status == HSP_OK) {
    return invariant == 0 && id == HSP_NONE ? NULL : "the library's own check: HSP_OK with an invariant or an id";
  }
  return found[invariant];
}

const char *broken_boundary(const computed *c) {
  const char *broken = broken_boundary_records(c);
  return broken == NULL ? broken_boundary_measures(c) : broken;
}
