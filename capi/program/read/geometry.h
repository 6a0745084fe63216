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
  double largest_radius;     /* for which the lattice is chosen; 0: that of the balls */
  double largest_rounding;   /* of all models that were made, as hsp_model_info has it */
  struct progress progress;  /* of what is done here; not watched at first */
  hsp_executor executor;     /* geometry_share_work; zeros: the calling thread alone */
  struct hsp_sticks *sticks; /* NULL at first; ball_and_stick.h computes them */
  void *sticks_memory;
  struct hsp_sticks *ink_of_sticks; /* their map, for contours; the same where that is drawn */
  void *ink_of_sticks_memory;
  struct bond *bond; /* [bonds] of the sticks; NULL at first */
  uint32_t bonds;
  uint32_t multiple_bonds;          /* among the sticks, where the file says so */
  bool multiple_shown;              /* as such */
  char misfit[MISFIT_BYTES];        /* what of them did not fit, and what became of it; empty where all do */
  uint64_t labels, labels_left_out; /* of pictures; those for which there was no room */
  hsp_periodic *periodic;           /* NULL at first */
  void *periodic_memory;
  hsp_periodic_limits periodic_limits;
};

/* Let as many threads share what follows, as far as sets of so many balls have enough for them. */
void geometry_share_work(struct geometry *geometry, uint32_t threads, uint32_t balls);

/* The threads that share it; NULL: the calling thread alone. */
const hsp_executor *geometry_executor(const struct geometry *geometry);

/* Area and volume of all, and of each ball unless `area` is NULL, from the boundary. */
bool geometry_measure(const struct geometry *geometry, uint32_t balls, const uint8_t *selected, hsp_totals *totals,
                      double *area, struct failure *failure);

/* Make the model. A ball that the library refuses is named by its line. step: of the lattice, 0 for the library's
 * choice. */
bool geometry_set_model(struct geometry *geometry, const struct molecule *molecule, double probe, double step,
                        struct failure *failure);

/* Compute the boundary of the model, with as much memory as it turns out to need. */
bool geometry_compute_boundary(struct geometry *geometry, struct failure *failure);

/* The same of selected balls [balls] alone, while all others only block; NULL: of all. */
bool geometry_compute_boundary_of(struct geometry *geometry, const uint8_t *selected, struct failure *failure);

/* Compute the boundary and its topology. */
bool geometry_compute_topology(struct geometry *geometry, struct failure *failure);
/* The same of the boundary that is there. */
bool geometry_topology_of_boundary(struct geometry *geometry, struct failure *failure);

/* Compute the boundary and the contacts over it. */
bool geometry_compute_contacts(struct geometry *geometry, struct failure *failure);

/* Compute the union in a periodic box, [9], with as much memory as it turns out to need; of the molecule itself. step:
 * of the lattice; 0: as the library chooses. */
bool geometry_compute_periodic(struct geometry *geometry, const struct molecule *molecule, double probe, double step,
                               const double *box, struct failure *failure);

/* The shells of a computed topology; *shells is to be freed on true. */
bool geometry_list_shells(const struct geometry *geometry, hsp_shell **shells, uint32_t *count,
                          struct failure *failure);

/* Progress is taken away. */
void geometry_free(struct geometry *geometry);

/* Why the library refuses a ball, the probe or a point. */
const char *geometry_reason(int32_t status);

/* Record a status of the library that is not HSP_OK. Always false. */
bool failure_in_library(struct failure *failure, int32_t status);
