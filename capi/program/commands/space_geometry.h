/* The results of the library's component space for a molecule: free space and ways through it. */
#pragma once

#include <stdbool.h>

#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* Cut free space into cells; it needs only the model. */
bool geometry_compute_cells(struct geometry *geometry, struct failure *failure);

/* Find a path through free space; it needs only the model. */
bool geometry_find_path(struct geometry *geometry, const double from[3], const double to[3], hsp_path *path,
                        struct failure *failure);

/* The widest probe between two points, and the balls that stop a wider one: three at a gate, one at an end. */
struct widest_probe {
  bool passes;   /* a probe of radius 0 passes; if not, the rest is 0 */
  double radius; /* infinite without balls */
  uint32_t balls;
  uint32_t gate[3]; /* [balls], ascending */
};

/* Find it from one point to another, or to the outside if `to` is NULL, by the pores of all balls. If probes are too
 * wide for the lattice of the model, this is made again on a coarser one. */
bool geometry_find_widest(struct geometry *geometry, const struct molecule *molecule, const double from[3],
                          const double *to, struct widest_probe *widest, struct failure *failure);

/* Find the maxima and gates of the model that are wider than the narrowest probe. The model's balls are grown by
 * `probe`, and it is made again on a coarser lattice if need be. */
bool geometry_find_pores(struct geometry *geometry, const struct molecule *molecule, double probe, double narrowest,
                         struct failure *failure);

/* The same in a periodic box, [9]. */
bool geometry_find_pores_in_box(struct geometry *geometry, const struct molecule *molecule, const double *box,
                                double narrowest, struct failure *failure);

/* Find the regions of free space outside the balls grown by a probe, in a box, or around the molecule if `box` is NULL.
 * The geometry has another model or box, and its pores, afterwards. */
bool geometry_find_regions(struct geometry *geometry, const struct molecule *molecule, const double *box, double probe,
                           hsp_pore_access *access, uint32_t *regions, struct failure *failure);

/* Measure the pockets that were found last: `sizes` gets a record for each. box: as above. If free space is too narrow
 * somewhere to decide, none of them is closed. */
bool geometry_measure_pockets(const struct geometry *geometry, const double *box, uint32_t pockets,
                              hsp_pore_pocket_size *sizes, struct failure *failure);

/* A pocket in the order of a list: the largest volume first; pockets of unknown volume last, by their numbers. */
struct sized_pocket {
  uint32_t pocket;
  double volume; /* below 0: not known */
};
void sized_pockets_sort(struct sized_pocket *pockets, uint32_t count);

/* The tunnel that is wanted, in pores found with the same narrowest probe. */
struct tunnel_question {
  double narrowest;
  bool in_box;
  bool cheapest;      /* the cheapest rather than the widest */
  const double *from; /* [3] */
  const double *to;   /* [3], or NULL: the outside, or in a box a copy of the start */
  uint32_t *avoided;  /* [count] gates that it must not pass */
  uint32_t count;
};

/* Find the tunnel. */
bool geometry_find_tunnel(struct geometry *geometry, const struct tunnel_question *question, hsp_tunnel *tunnel,
                          struct failure *failure);
