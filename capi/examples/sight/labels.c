/* Balls as they are seen from a direction, and where a label fits.
 *   labels FILE.xyzr [X Y Z]       x y z r on each line; X Y Z points to the viewer, 0 0 1 if left out
 * One line for each ball that is seen: how much of it is seen in the view plane, and of its widest face how large a
 * circle fits where. Then the outline of the ball of which most is seen, as points. */
#include <hardsphere_workspace.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "../read_balls.h"

/* The face of the ball with most room; HSP_NONE if nothing is seen of it. The faces of a ball are beside the loops of
 * its outline. */
static int32_t widest_face(const hsp_map *map, uint32_t ball, uint32_t *widest, hsp_map_pole *pole) {
  uint32_t count = 0;
  uint32_t *loops;
  int32_t status = hsp_map_get_outline(map, ball, NULL, 0, &count);
  *widest = HSP_NONE;
  if (status == HSP_OK) return HSP_OK; /* no loops */
  if (status != HSP_E_CAPACITY) return status;
  loops = malloc(count * sizeof *loops);
  if (loops == NULL) return HSP_E_MEMORY;
  status = hsp_map_get_outline(map, ball, loops, count, &count);
  for (uint32_t i = 0; status == HSP_OK && i < count; ++i) {
    const uint32_t face = hsp_map_left(map, loops[i]);
    hsp_map_pole found;
    status = hsp_map_get_pole(map, face, &found);
    if (status != HSP_OK || (*widest != HSP_NONE && found.radius <= pole->radius)) continue;
    *widest = face;
    *pole = found;
  }
  free(loops);
  return status;
}

/* The loops around what is seen of a ball, every edge in steps of at most 0.2 rad. */
static int32_t print_outline(const hsp_map *map, uint32_t face) {
  hsp_map_face record;
  int32_t status = hsp_map_get_faces(map, face, 1, &record);
  uint32_t loop = record.h;
  for (uint32_t i = 0; status == HSP_OK && i < record.loops; ++i, loop = hsp_map_next_loop(map, loop)) {
    uint32_t h = loop;
    printf("%s of face %u\n", i == 0 ? "rim" : "hole", (unsigned)face);
    do {
      hsp_map_edge edge;
      status = hsp_map_get_edges(map, h / 2, 1, &edge);
      if (status != HSP_OK) break;
      const int steps = 1 + (int)((edge.to - edge.from) / 0.2);
      for (int k = 0; k < steps; ++k) {
        const double part = (double)k / steps;
        const double t = h % 2 == 0 ? edge.from + part * (edge.to - edge.from) : edge.to - part * (edge.to - edge.from);
        printf("%12.6f %12.6f\n", edge.centre[0] + cos(t) * edge.first[0] + sin(t) * edge.second[0],
               edge.centre[1] + cos(t) * edge.first[1] + sin(t) * edge.second[1]);
      }
      h = hsp_map_next(map, h);
    } while (h != loop);
  }
  return status;
}

static int32_t print_labels(const hsp_map *map, uint32_t balls) {
  double *area = malloc(balls * sizeof *area + 1);
  uint32_t needed, face, most = HSP_NONE, most_face = HSP_NONE;
  int32_t status = area != NULL ? hsp_map_get_areas(map, area, balls, &needed) : HSP_E_MEMORY;
  printf("%8s %14s %12s %12s %12s\n", "ball", "area", "x", "y", "radius");
  for (uint32_t ball = 0; status == HSP_OK && ball < balls; ++ball) {
    hsp_map_pole pole = {{0.0, 0.0}, 0.0, 0.0};
    status = widest_face(map, ball, &face, &pole);
    if (status != HSP_OK || face == HSP_NONE) continue;
    printf("%8u %14.8f %12.6f %12.6f %12.6f\n", (unsigned)ball, area[ball], pole.centre[0], pole.centre[1],
           pole.radius);
    if (most != HSP_NONE && area[ball] <= area[most]) continue;
    most = ball;
    most_face = face;
  }
  if (status == HSP_OK && most != HSP_NONE) {
    printf("most is seen of ball %u\n", (unsigned)most);
    status = print_outline(map, most_face);
  }
  free(area);
  return status;
}

int main(int count, char **arguments) {
  struct balls balls = {0, NULL, NULL};
  hsp_workspace work = {0};
  hsp_view_options options;
  if (count != 2 && count != 5) {
    fprintf(stderr, "usage: labels FILE.xyzr [X Y Z]\n");
    return 2;
  }
  int done = read_balls(arguments[1], &balls);
  if (done) {
    int32_t status = hsp_view_options_init(&options, sizeof options);
    for (int axis = 0; count == 5 && axis < 3; ++axis) options.towards[axis] = strtod(arguments[2 + axis], NULL);
    if (status == HSP_OK) status = hsp_workspace_set(&work, balls.count, balls.xyz, balls.radius, NULL, NULL);
    if (status == HSP_OK) status = hsp_workspace_map(&work, &options);
    if (status == HSP_OK) status = print_labels(work.map, balls.count);
    if (status != HSP_OK) fprintf(stderr, "labels: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  hsp_workspace_free(&work);
  free_balls(&balls);
  return done ? 0 : 1;
}
