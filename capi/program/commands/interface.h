/* The area that two groups of chains bury between them. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* "A,B" or "A+B,C": two groups of chains; '.' is the chain without a name. The failure says what is wrong with a text
 * that is not of this form. */
bool interface_parse(const char *text, struct failure *failure);

/* One of the groups. */
struct interface_side {
  uint32_t atoms;
  double alone;    /* its area if there were nothing else */
  double together; /* its area in the presence of the other group, and of nothing beyond */
};

struct interface {
  struct interface_side side[2];
  double together; /* the area of both groups together */
  double buried;   /* what the two have more alone */
};

/* Measure the interface that the text names. A group without atoms is refused. The geometry's model and boundary serve
 * for it, and hold both groups together at the end. */
bool interface_measure(const char *text, const struct molecule *molecule, double probe, struct geometry *geometry,
                       struct interface *interface, struct failure *failure);
