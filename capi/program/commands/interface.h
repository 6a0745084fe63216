/* The areas that groups of atoms bury between each other, for each pair of groups. */
#pragma once

#include <stdbool.h>

#include "commands/request.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"
#include "read/selection_groups.h"
#include "write/record.h"

/* Two groups, without all other atoms. */
struct interface_pair {
  uint32_t group[2];  /* ascending */
  double together[2]; /* the area of each in the presence of the other */
  double both;        /* the area of their union */
  double buried;      /* the sum of their areas alone, less that of their union */
};

struct interface {
  struct found_groups groups;
  double *alone;               /* [groups.count], the area of each group alone */
  struct interface_pair *pair; /* [pairs], all of them, ascending */
  uint32_t pairs;
};

/* Measure the interfaces of the groups that the request names. The geometry's model and boundary are used for it, and
 * overwritten. Free the interface on true and on false. */
bool interface_measure(const struct request *request, const struct molecule *molecule, struct geometry *geometry,
                       struct interface *interface, struct failure *failure);

/* Write the results: for two groups under "interface", for more under "interfaces". */
void interface_record(struct record *record, const struct selection_groups *groups, const struct interface *interface);

void interface_free(struct interface *interface);
