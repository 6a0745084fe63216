/* One set of balls with its model and boundary, and everything that the interface tells about them, in memory of its
 * own: the input of all invariants of this folder. */
#pragma once

#include <hardsphere.h>

#include "handle_kind.h"

/* The fuzz harnesses, which are C++, use these checks as well. */
#ifdef __cplusplus
extern "C" {
#endif

typedef struct computed {
  uint32_t n;
  double *xyz;     /* copy of the input */
  double *radius;  /* radius plus probe */
  double extent;   /* the largest coordinate of a centre, without its sign */
  double rounding; /* the most by which the lattice moves a coordinate or radius */
  void *model_memory;
  void *boundary_memory;
  hsp_model *model;
  hsp_boundary *boundary;
  hsp_model_info info;
  hsp_boundary_limits needed; /* what the boundary needed, exactly */
  uint32_t enlargements;      /* how often limits had to be raised, starting from none of anything but balls */
  hsp_boundary_counts counts;
  hsp_vertex *vertices;
  hsp_arc *arcs;
  hsp_circle *circles;
  hsp_face *faces;
  hsp_loop *loops;
  hsp_loop_arc *loop_arcs; /* twice as many as arcs */
  hsp_ball *balls;
  hsp_totals totals;
  double *area;
  double *volume;
} computed;

/* The default options of a model, with this probe. */
hsp_model_options options_with_probe(double probe);

/* Balls as tests write them down, x, y, z, radius, in the arrays that the interface takes. */
void spread_balls(uint32_t n, const double (*ball)[4], double *xyz, double *radius);

/* Sets the model and computes and reads everything. The first status that is not HSP_OK, or HSP_OK. To be followed by
 * computed_release in either case. */
int32_t computed_make(uint32_t n, const double *xyz, const double *radius, const hsp_model_options *options,
                      computed *result);

/* Computes the boundary again, in new memory, by an executor with so many workers that runs tasks in orders drawn from
 * `seed`, and reads everything again. */
int32_t computed_by_workers(computed *result, uint32_t workers, uint64_t seed);

void computed_release(computed *result);

/* How boundaries are made; they are computed from a `computed` of which only the model is used. */
extern const handle_kind boundary_handle;

#ifdef __cplusplus
}
#endif
