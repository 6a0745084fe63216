/* In place of void_sphere.c if the library has no pores. */
#include "commands/void_sphere.h"

const char void_columns[] =
    "  volume in @^3, area in @^2; x y z clearance: they need the component space, which this build leaves out";

bool void_spheres_find(const struct geometry *geometry, const struct molecule *molecule, double probe,
                       struct void_list *list, struct failure *failure) {
  (void)geometry, (void)molecule, (void)probe, (void)list, (void)failure;
  return true;
}
