/* The request of a user of `mesh`. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "write/mesh_file.h"

enum mesh_surface { MESH_VAN_DER_WAALS, MESH_SOLVENT_ACCESSIBLE, MESH_SOLVENT_EXCLUDED };

/* Choices are negative if the user has not given them. */
struct meshing {
  const char *out;    /* a file, or NULL; for MSMS the file of the vertices */
  int format;         /* if it is not given, meshing_check takes it from the extension of `out` */
  int surface;        /* if it is not given, meshing_check chooses it by the probe */
  double edge;        /* negative: not given */
  bool cut;           /* in a picture: cut the surface open, so that voids are seen */
  bool dark;          /* in a picture: a dark page */
  double pockets;     /* in a picture: show pockets that a probe of this radius does not reach; negative: none */
  double persistence; /* the least persistence of these pockets */
};

#define MESHING_DEFAULT \
  { .out = NULL, .format = -1, .surface = -1, .edge = -1.0, .pockets = -1.0 }

/* The user's name of the surface. */
const char *meshing_surface_name(const struct meshing *meshing);

/* Whether all options may be combined, also with this probe, and with options of viewing if `viewed`. Sets values that
 * follow from them. */
bool meshing_check(struct meshing *meshing, double probe, bool viewed, struct failure *failure);
