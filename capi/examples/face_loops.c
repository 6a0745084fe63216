/* The loops around each face of the boundary, arc by arc: what it takes to draw faces or to walk along their rims.
 *   face_loops FILE.xyzr [PROBE]       x y z r on each line
 * One line a loop: face, ball, arcs, length. Holes are loops beyond a face's first; a whole sphere has none. */
#include <hardsphere_workspace.h>
#include <stdio.h>
#include <stdlib.h>

#include "read_balls.h"

struct records {
  hsp_face *faces;
  hsp_loop *loops;
  hsp_loop_arc *loop_arcs;
  hsp_arc *arcs;
  hsp_circle *circles;
  uint32_t face_count;
};

static int32_t read_records(const hsp_boundary *boundary, struct records *records) {
  hsp_boundary_counts counts;
  uint32_t needed;
  int32_t status = hsp_boundary_get_counts(boundary, &counts);
  if (status != HSP_OK) return status;
  records->face_count = counts.faces;
  records->faces = malloc(counts.faces * sizeof *records->faces + 1);
  records->loops = malloc(counts.loops * sizeof *records->loops + 1);
  records->loop_arcs = malloc(2 * (size_t)counts.arcs * sizeof *records->loop_arcs + 1);
  records->arcs = malloc(counts.arcs * sizeof *records->arcs + 1);
  records->circles = malloc(counts.circles * sizeof *records->circles + 1);
  if (!records->faces || !records->loops || !records->loop_arcs || !records->arcs || !records->circles) {
    return HSP_E_MEMORY;
  }
  status = hsp_boundary_get_faces(boundary, records->faces, counts.faces, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_loops(boundary, records->loops, counts.loops, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_loop_arcs(boundary, records->loop_arcs, 2 * counts.arcs, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_arcs(boundary, records->arcs, counts.arcs, &needed);
  if (status == HSP_OK) status = hsp_boundary_get_circles(boundary, records->circles, counts.circles, &needed);
  return status;
}

static double length_of(const struct records *records, const hsp_loop *loop) {
  if (loop->circle != HSP_NONE) return 6.283185307179586 * records->circles[loop->circle].radius;
  double length = 0.0;
  for (uint32_t i = loop->first_arc; i < loop->first_arc + loop->arcs; ++i) {
    const hsp_arc *arc = &records->arcs[records->loop_arcs[i].arc];
    length += arc->angle * arc->radius;
  }
  return length;
}

static void print_loops(const struct records *records) {
  printf("%8s %8s %8s %14s\n", "face", "ball", "arcs", "length");
  for (uint32_t f = 0; f < records->face_count; ++f) {
    const hsp_face *face = &records->faces[f];
    for (uint32_t i = 0; i < face->loops; ++i) {
      const hsp_loop *loop = &records->loops[face->first_loop + i];
      printf("%8u %8u %8u %14.8f\n", (unsigned)f, (unsigned)face->ball, (unsigned)loop->arcs, length_of(records, loop));
    }
  }
}

int main(int count, char **arguments) {
  struct balls balls = {0, NULL, NULL};
  struct records records = {NULL, NULL, NULL, NULL, NULL, 0};
  hsp_workspace work = {0};
  hsp_model_options options;
  if (count < 2 || count > 3) {
    fprintf(stderr, "usage: face_loops FILE.xyzr [PROBE]\n");
    return 2;
  }
  int done = read_balls(arguments[1], &balls);
  if (done) {
    int32_t status = hsp_model_options_init(&options, sizeof options);
    options.probe = count == 3 ? strtod(arguments[2], NULL) : 0.0;
    if (status == HSP_OK) status = hsp_workspace_set(&work, balls.count, balls.xyz, balls.radius, &options, NULL);
    if (status == HSP_OK) status = hsp_workspace_boundary(&work);
    if (status == HSP_OK) status = read_records(work.boundary, &records);
    if (status == HSP_OK) print_loops(&records);
    if (status != HSP_OK) fprintf(stderr, "face_loops: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  free(records.faces);
  free(records.loops);
  free(records.loop_arcs);
  free(records.arcs);
  free(records.circles);
  hsp_workspace_free(&work);
  free_balls(&balls);
  return done ? 0 : 1;
}
