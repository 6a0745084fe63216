#include "boundary_invariants.h"

const char *broken_boundary(const computed *c) {
  const char *broken = broken_boundary_records(c);
  return broken == NULL ? broken_boundary_measures(c) : broken;
}
