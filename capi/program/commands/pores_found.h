/* The pores of a molecule that `pores` finds, prints and writes to files. */
#pragma once

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "commands/followed.h"
#include "commands/periodic_result.h"
#include "commands/request.h"
#include "commands/space_geometry.h"
#include "hardsphere.h"
#include "read/failure.h"
#include "read/geometry.h"
#include "read/molecule.h"

/* A list of numbers for each of several things; those of thing i are number[first[i] .. first[i + 1]). */
struct number_lists {
  size_t *first; /* [things + 1] */
  uint32_t *number;
};

/* The steps of the tunnels, one after another. */
struct tunnel_step {
  uint32_t tunnel; /* from 1 on */
  double length;   /* of the tunnel from its start to this point */
  hsp_tunnel_point point;
};

/* The results that the request asks for. */
struct pores_found {
  const struct request *request;
  hsp_pores_counts counts;
  hsp_pore_maximum *maxima;
  hsp_pore_gate *gates;
  struct number_lists of_maxima; /* the balls of each maximum */
  struct number_lists of_gates;  /* and of each gate */
  uint32_t pocket_count;
  hsp_pore_pocket *pockets;
  hsp_pore_pocket_size *sizes; /* of the pockets */
  struct sized_pocket *listed; /* [listed_count] */
  uint32_t listed_count;
  uint32_t smaller;        /* pockets too small to be listed */
  struct cavity *followed; /* [listed_count] in a trajectory; NULL for a single molecule */
  struct number_lists mouths;
  struct number_lists lining;
  struct number_lists of_pockets; /* the maxima of each pocket */
  double from[3], to[3];          /* `to` only if the request names it */
  double room;                    /* the radius of the largest probe at the start */
  uint32_t tunnel_count;
  hsp_tunnel *tunnels;
  hsp_tunnel_route *routes;
  struct tunnel_step *steps;
  size_t step_count;
  struct periodic_result box; /* this and what follows: with --box */
  hsp_pore_percolation wide;
  hsp_pore_gate_shifts *shifts; /* [gates] */
  uint32_t channel_count;
  hsp_pore_channel *channels;
  hsp_pore_access access; /* with --regions */
  uint32_t region_count;
  hsp_pore_region *regions;
  hsp_pore_maximum *widest; /* [region_count] the maximum of the widest probe in each; none for the outside */
};

/* Find all that found->request asks for; everything else in `found` is 0 before. Free it on true and on false. */
bool pores_find(const struct molecule *molecule, struct geometry *geometry, struct pores_found *found,
                struct failure *failure);
void pores_free(struct pores_found *found);

/* Whether the class of a maximum lives long enough to be listed. */
bool pores_lists_maximum(const struct pores_found *found, size_t maximum);

/* Write all files that the request names. */
bool pores_write_files(const struct pores_found *found, const struct molecule *molecule, struct failure *failure);
