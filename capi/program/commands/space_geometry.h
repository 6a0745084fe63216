/* The results of the library's component space for a molecule: free space and ways through it. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* Cut free space into cells, from the model alone. */
bool geometry_compute_cells(struct geometry *geometry, struct failure *failure);

/* Find a path through free space, from the model alone. */
bool geometry_find_path(struct geometry *geometry, const double from[3], const double to[3], hsp_path *path,
                        struct failure *failure);

/* The widest probe between two points, and the balls that stop a wider one: three at a gate, one at an end. */
struct widest_probe {
  bool passes;   /* whether a point does: else the rest is 0 */
  double radius; /* infinite without balls */
  uint32_t balls;
  uint32_t gate[3]; /* [balls], ascending */
};

/* Find it, from one point to another, or to the outside if `to` is NULL, by the pores of all balls. The model is made
 * again on a coarser lattice if probes are too wide for its own. */
bool geometry_find_widest(struct geometry *geometry, const struct molecule *molecule, const double from[3],
                          const double *to, struct widest_probe *widest, struct failure *failure);

/* Find maxima and gates that are wider than the narrowest probe, of the model, whose balls are grown by the probe;
 * likewise. */
bool geometry_find_pores(struct geometry *geometry, const struct molecule *molecule, double probe, double narrowest,
                         struct failure *failure);

/* The same in a periodic box, [9]. */
bool geometry_find_pores_in_box(struct geometry *geometry, const struct molecule *molecule, const double *box,
                                double narrowest, struct failure *failure);

/* Find the regions of free space beside the balls grown by a probe, in a box or, if that is NULL, of the molecule. The
 * handles hold this model or box and its pores afterwards, others than before. */
bool geometry_find_regions(struct geometry *geometry, const struct molecule *molecule, const double *box, double probe,
                           hsp_pore_access *access, uint32_t *regions, struct failure *failure);

/* Measure the pockets that were found in the pores last: sizes gets a record for each. box: as above. If free space is
 * too narrow somewhere to tell, none of them is closed. */
bool geometry_measure_pockets(const struct geometry *geometry, const double *box, uint32_t pockets,
                              hsp_pore_pocket_size *sizes, struct failure *failure);

/* A pocket in the order of a list: the largest volume first; those whose volume is not known last, by their numbers. */
struct sized_pocket {
  uint32_t pocket;
  double volume; /* below 0: not known */
};
void sized_pockets_sort(struct sized_pocket *pockets, uint32_t count);

/* Which tunnel is wanted, in the pores of the same narrowest probe. */
struct tunnel_question {
  double narrowest;
  bool in_box;
  bool cheapest;      /* rather than widest */
  const double *from; /* [3] */
  const double *to;   /* [3], or NULL: the outside, or in a box a copy of the start */
  uint32_t *avoided;  /* [count] gates */
  uint32_t count;
};

/* Find it. */
bool geometry_find_tunnel(struct geometry *geometry, const struct tunnel_question *question, hsp_tunnel *tunnel,
                          struct failure *failure);
