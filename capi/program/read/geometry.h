/* The library's handles for one molecule, in memory that the program owns. */
#pragma once

#include <stdbool.h>

#include "hardsphere_workspace.h"
#include "read/failure.h"
#include "read/molecule.h"
#include "read/progress.h"

enum { MISFIT_BYTES = 256 };

struct geometry {
  hsp_workspace work;        /* zeros at first */
  double largest_radius;     /* the lattice is chosen for it; 0: for the largest ball */
  double largest_rounding;   /* of all models made so far, as in hsp_model_info */
  struct progress progress;  /* of the work here; not watched at first */
  hsp_executor executor;     /* set by geometry_share_work; zeros: the calling thread alone */
  struct hsp_sticks *sticks; /* NULL at first; ball_and_stick.h computes them */
  void *sticks_memory;
  struct hsp_sticks *ink_of_sticks; /* the map of the sticks, for contours; the same handle if the map is drawn */
  void *ink_of_sticks_memory;
  struct bond *bond; /* [bonds] of the sticks; NULL at first */
  uint32_t bonds;
  uint32_t multiple_bonds;          /* how many sticks are multiple bonds, if the file says so */
  bool multiple_shown;              /* whether they are drawn as such */
  char misfit[MISFIT_BYTES];        /* which sticks did not fit, and how that was mended; empty if all fit */
  uint64_t labels, labels_left_out; /* of pictures: all labels, and those for which there was no room */
  hsp_periodic *periodic;           /* NULL at first */
  void *periodic_memory;
  hsp_periodic_limits periodic_limits;
};

/* Let so many threads share the work that follows, as far as sets of so many balls have enough work for them. */
void geometry_share_work(struct geometry *geometry, uint32_t threads, uint32_t balls);

/* The executor of the threads that share the work; NULL: the calling thread alone. */
const hsp_executor *geometry_executor(const struct geometry *geometry);

/* Measure area and volume of the union, and unless `area` is NULL the area of each ball, from the boundary. */
bool geometry_measure(const struct geometry *geometry, uint32_t balls, const uint8_t *selected, hsp_totals *totals,
                      double *area, struct failure *failure);

/* Make the model. A ball that the library refuses is named by its line. step: of the lattice, 0 for the library's
 * choice. */
bool geometry_set_model(struct geometry *geometry, const struct molecule *molecule, double probe, double step,
                        struct failure *failure);

/* Compute the boundary of the model; memory grows as needed. */
bool geometry_compute_boundary(struct geometry *geometry, struct failure *failure);

/* The same on selected balls [balls] alone, while all others only block; NULL: on all. */
bool geometry_compute_boundary_of(struct geometry *geometry, const uint8_t *selected, struct failure *failure);

/* Compute the boundary and its topology. */
bool geometry_compute_topology(struct geometry *geometry, struct failure *failure);
/* Compute the topology of the boundary that is there. */
bool geometry_topology_of_boundary(struct geometry *geometry, struct failure *failure);

/* Compute the boundary and the contacts over it. */
bool geometry_compute_contacts(struct geometry *geometry, struct failure *failure);

/* Compute the union of the molecule's balls in a periodic box, [9]; memory grows as needed. step: of the lattice; 0:
 * the library chooses. */
bool geometry_compute_periodic(struct geometry *geometry, const struct molecule *molecule, double probe, double step,
                               const double *box, struct failure *failure);

/* List the shells of a computed topology; *shells has to be freed on true. */
bool geometry_list_shells(const struct geometry *geometry, hsp_shell **shells, uint32_t *count,
                          struct failure *failure);

/* Also takes the line of progress away. */
void geometry_free(struct geometry *geometry);

/* The reason, as a text, why the library refuses a ball, the probe or a point. */
const char *geometry_reason(int32_t status);

/* Record a status of the library that is not HSP_OK. Always false. */
bool failure_in_library(struct failure *failure, int32_t status);
