/* Parts for tests of the life of handles: all that is computed of one set of balls, and a hash over everything that can
 * be read of a handle of any kind. */
#pragma once

#include "ball_sets.h"
#include "body_result.h"
#include "cells_result.h"
#include "contacts_result.h"
#include "map_result.h"
#include "mesh_result.h"
#include "moving_result.h"
#include "paths_result.h"
#include "periodic_result.h"
#include "pores_result.h"
#include "sticks_result.h"
#include "topology_result.h"
#include "view_result.h"

typedef struct kind_of_life {
  const handle_kind *kind;
  const char *name;
  /* A hash over everything that can be read, by way of a buffer of the caller's; 0 if a call fails. */
  uint64_t (*hash)(const void *handle, const void *source, unsigned char *buffer, uint32_t room);
  /* Calls what uses scratch memory; 0 if a call fails. */
  int (*use)(void *handle);
} kind_of_life;
enum {
  BOUNDARY,
  TOPOLOGY,
  VIEW,
  SURFACE,
  MESH,
  MAP,
  STICKS,
  CONTACTS,
  CELLS,
  PATHS,
  PORES,
  BODY,
  PERIODIC,
  MOVING,
  KINDS
};
extern const kind_of_life kinds_of_life[KINDS];

enum { CELLS_OF_BALLS = 20, STICKS_OF_BALLS = 40 };

/* All that is computed of one set. */
typedef struct computations {
  computed boundary;
  topology_result topology;
  view_result view;
  map_result map;
  sticks_result sticks; /* its handle is NULL if there are more balls than STICKS_OF_BALLS, for the sake of time */
  computed rolled;      /* the boundary with a probe */
  surface_result surface;
  mesh_result mesh; /* of the surface; its handle is NULL if there is none */
  contacts_result contacts;
  cells_result cells; /* none of sets of more than CELLS_OF_BALLS balls, for the sake of time */
  paths_result paths; /* likewise */
  pores_result pores; /* likewise */
  body_result body;
  periodic_result periodic;
  moving_result moving;
  uint32_t room; /* an upper bound of all numbers of records */
} computations;

/* Computes the boundary of a set. Unless `options` is NULL it also computes the topology, the view and map with these
 * options, sticks, the smooth surface and its triangles, contacts, cells, path, pores, the body, the set in a periodic
 * box and the set as balls that move. 0, after a failed check, if a call fails. To be followed by computations_release.
 * */
int computations_make(const ball_set *set, const hsp_view_options *options, computations *all);
void computations_release(computations *all);

/* Computes the cells, a path and sticks of a larger set, too. */
int computations_add_slow(computations *all, const hsp_view_options *options);

/* The handle of a kind; NULL if there is none, or if it is a body without balls. The functions behind it: the source
 * that the handle was computed from, and the limits that it needs. */
void *handle_of(const computations *all, int kind);
const void *source_of(const computations *all, int kind);
limit_numbers limits_of(const computations *all, int kind);

/* Zeros, all->room of the largest record; to be freed by the caller. */
unsigned char *buffer_for(const computations *all);
