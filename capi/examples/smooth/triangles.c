/* The smooth surface that a probe leaves, as triangles in an .off file on standard output.
 *   triangles FILE.xyzr PROBE EDGE       x y z r on each line */
#include <hardsphere_workspace.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "../read_balls.h"

/* With the limits that are expected to suffice; if they do not, with those that come back. */
static int32_t make_mesh(const hsp_surface *surface, double edge, void **memory, hsp_mesh **mesh) {
  hsp_mesh_limits limits;
  int32_t status = hsp_mesh_limits_init_surface(&limits, sizeof limits, surface, edge);
  if (status != HSP_OK) return status;
  do {
    size_t bytes = 0;
    status = hsp_mesh_bytes(&limits, &bytes);
    if (status == HSP_OK) status = hsp_workspace_allocate(memory, bytes);
    if (status == HSP_OK) status = hsp_mesh_init(*memory, bytes, &limits, mesh);
    if (status != HSP_OK) return status;
    status = hsp_mesh_compute_surface(*mesh, surface, edge, &limits);
  } while (status == HSP_E_CAPACITY);
  return status;
}

static int32_t print_mesh(const hsp_mesh *mesh) {
  hsp_mesh_counts counts;
  int32_t status = hsp_mesh_get_counts(mesh, &counts);
  if (status != HSP_OK) return status;
  double *const xyz = malloc(3 * (size_t)counts.vertices * sizeof *xyz + 1);
  uint32_t *const corners = malloc(3 * (size_t)counts.triangles * sizeof *corners + 1);
  if (xyz == NULL || corners == NULL) status = HSP_E_MEMORY;
  if (status == HSP_OK) status = hsp_mesh_get_vertices(mesh, xyz, NULL, NULL, NULL, counts.vertices, NULL);
  if (status == HSP_OK) status = hsp_mesh_get_triangles(mesh, corners, NULL, NULL, NULL, counts.triangles, NULL);
  if (status == HSP_OK) {
    printf("OFF\n%" PRIu32 " %" PRIu32 " 0\n", counts.vertices, counts.triangles);
    for (uint32_t v = 0; v < counts.vertices; ++v) {
      const double *const p = xyz + 3 * (size_t)v;
      printf("%.6f %.6f %.6f\n", p[0], p[1], p[2]);
    }
    for (uint32_t t = 0; t < counts.triangles; ++t) {
      const uint32_t *const c = corners + 3 * (size_t)t;
      printf("3 %" PRIu32 " %" PRIu32 " %" PRIu32 "\n", c[0], c[1], c[2]);
    }
  }
  free(xyz);
  free(corners);
  return status;
}

int main(int count, char **arguments) {
  struct balls balls = {0, NULL, NULL};
  hsp_workspace work = {0};
  hsp_model_options options;
  hsp_mesh *mesh = NULL;
  void *memory = NULL;
  if (count != 4) {
    fprintf(stderr, "usage: triangles FILE.xyzr PROBE EDGE\n");
    return 2;
  }
  int done = read_balls(arguments[1], &balls);
  if (done) {
    int32_t status = hsp_model_options_init(&options, sizeof options);
    options.probe = strtod(arguments[2], NULL);
    if (status == HSP_OK) status = hsp_workspace_set(&work, balls.count, balls.xyz, balls.radius, &options, NULL);
    if (status == HSP_OK) status = hsp_workspace_boundary(&work);
    if (status == HSP_OK) status = hsp_workspace_surface(&work);
    if (status == HSP_OK) status = make_mesh(work.surface, strtod(arguments[3], NULL), &memory, &mesh);
    if (status == HSP_OK) status = print_mesh(mesh);
    if (status != HSP_OK) fprintf(stderr, "triangles: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  free(memory);
  hsp_workspace_free(&work);
  free_balls(&balls);
  return done ? 0 : 1;
}
