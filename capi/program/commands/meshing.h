/* The request of a user of `mesh`. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "write/mesh_file.h"

enum mesh_surface { MESH_VAN_DER_WAALS, MESH_SOLVENT_ACCESSIBLE, MESH_SOLVENT_EXCLUDED };

/* Choices are negative where the user has said nothing. */
struct meshing {
  const char *out;    /* a file, or NULL; of MSMS the one with the vertices */
  int format;         /* meshing_check sets it, by the extension of out if the user has not said */
  int surface;        /* meshing_check sets it, by the probe if the user has not said */
  double edge;        /* negative: not said */
  bool cut;           /* of a picture: open it, so that voids are seen */
  bool dark;          /* its page */
  double pockets;     /* likewise, radius of a probe that does not get to those that are shown; negative: none are */
  double persistence; /* of these, at least */
};

#define MESHING_DEFAULT \
  { .out = NULL, .format = -1, .surface = -1, .edge = -1.0, .pockets = -1.0 }

/* The user's name of the surface. */
const char *meshing_surface_name(const struct meshing *meshing);

/* Whether all options go together, with this probe, and with options of viewing; sets what follows from them. */
bool meshing_check(struct meshing *meshing, double probe, bool viewed, struct failure *failure);
