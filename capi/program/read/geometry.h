/* The library's handles for one molecule, in memory that the program owns. */
#ifndef HARDSPHERE_TOOL_GEOMETRY_H
#define HARDSPHERE_TOOL_GEOMETRY_H

#include <stdbool.h>

#include "draw/viewing.h"
#include "hardsphere_workspace.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "read/progress.h"

struct geometry {
  hsp_workspace work;       /* zeros at first */
  struct progress progress; /* of what is done here; not watched at first */
  hsp_sticks *sticks;       /* NULL at first; ball_and_stick.h computes them */
  void *sticks_memory;
  hsp_periodic *periodic; /* NULL at first */
  void *periodic_memory;
  hsp_periodic_limits periodic_limits;
};

/* Make the model. A ball that the library refuses is named by its line. step: of the lattice, 0 for the library's
 * choice. */
bool geometry_set_model(struct geometry *geometry, const struct molecule *molecule, double probe, double step,
                        struct failure *failure);

/* Compute the boundary of the model, with as much memory as it turns out to need. */
bool geometry_compute_boundary(struct geometry *geometry, struct failure *failure);

/* Compute the boundary and its topology. */
bool geometry_compute_topology(struct geometry *geometry, struct failure *failure);

/* Compute the boundary and the contacts over it. */
bool geometry_compute_contacts(struct geometry *geometry, struct failure *failure);

/* Compute the union in a periodic box, [9], with as much memory as it turns out to need; of the molecule itself. */
bool geometry_compute_periodic(struct geometry *geometry, const struct molecule *molecule, double probe,
                               const double *box, struct failure *failure);

/* Cut free space into cells, from the model alone. */
bool geometry_compute_cells(struct geometry *geometry, struct failure *failure);

/* Find a path through free space, from the model alone. */
bool geometry_find_path(struct geometry *geometry, const double from[3], const double to[3], hsp_path *path,
                        struct failure *failure);

/* Find the widest probe from one point to another, or to the outside if `to` is NULL. The model is made again on a
 * coarser lattice if probes are too wide for its own. */
bool geometry_find_gate(struct geometry *geometry, const struct molecule *molecule, const double from[3],
                        const double *to, struct failure *failure);

/* Compute the solvent-excluded surface over the boundary, which is computed. */
bool geometry_compute_surface(struct geometry *geometry, struct failure *failure);

/* The same of the outer cell alone, as if voids were filled. */
bool geometry_compute_outer_surface(struct geometry *geometry, struct failure *failure);

/* Make triangles of the boundary or of the solvent-excluded surface, which is computed. */
bool geometry_compute_mesh(struct geometry *geometry, bool of_surface, double edge, struct failure *failure);

/* Cut and sort the pieces of a view: from the boundary if that was computed, from the model alone if not. */
bool geometry_compute_view(struct geometry *geometry, const hsp_view_options *options, struct failure *failure);

/* Find what is seen, from the model alone. */
bool geometry_compute_map(struct geometry *geometry, const struct viewing *viewing, const struct molecule *molecule,
                          struct failure *failure);

/* The shells of a computed topology; *shells is to be freed on true. */
bool geometry_list_shells(const struct geometry *geometry, hsp_shell **shells, uint32_t *count,
                          struct failure *failure);

/* Progress is taken away. */
void geometry_free(struct geometry *geometry);

/* Why the library refuses a ball, the probe or a point. */
const char *geometry_reason(int32_t status);

/* Record a status of the library that is not HSP_OK. Always false. */
bool failure_in_library(struct failure *failure, int32_t status);

#endif
