/* Pores of a molecule: which cavities there are for any probe, how the widest of them opens, and how large pockets are.
 *   pores                    a cage with two rooms
 *   pores FILE.xyzr [N]      x y z r on each line; the N classes of free space that persist most, default 10
 */
#include <hardsphere_workspace.h>
#include <stdio.h>
#include <stdlib.h>

#include "../read_balls.h"

/* A lattice of 5 by 3 by 3 places without two of them. */
static int take_rooms(struct balls *balls) {
  for (int place = 0; place < 45; ++place) {
    const int x = place / 9, y = place / 3 % 3, z = place % 3;
    const double ball[4] = {2.0 * x, 2.0 * y, 2.0 * z, x == 2 ? 1.15 : 1.2};
    if (x % 2 == 1 && y == 1 && z == 1) continue;
    if (!add_ball(balls, ball)) return 0;
  }
  return 1;
}

static int by_persistence(const void *a, const void *b) {
  const hsp_pore_maximum *const one = a, *const other = b;
  const double first = one->radius - one->death, second = other->radius - other->death;
  return first < second ? 1 : first > second ? -1 : 0;
}

/* Free space that a probe of the radius of the birth fits in, until one of the radius of the death gets out of it. */
static int32_t print_classes(const hsp_workspace *work, uint32_t most) {
  hsp_pores_counts counts;
  int32_t status = hsp_pores_get_counts(work->pores, &counts);
  if (status != HSP_OK) return status;
  hsp_pore_maximum *maxima = malloc(((size_t)counts.maxima + 1) * sizeof *maxima);
  if (maxima == NULL) return HSP_E_MEMORY;
  status = hsp_pores_get_maxima(work->pores, 0, counts.maxima, maxima);
  printf("%u maxima, %u gates, %u cavities that nothing reaches\n", (unsigned)counts.maxima, (unsigned)counts.gates,
         (unsigned)counts.cavities);
  qsort(maxima, counts.maxima, sizeof *maxima, by_persistence);
  for (uint32_t k = 0; status == HSP_OK && k < counts.maxima && k < most; ++k) {
    hsp_pore_gate gate;
    const hsp_pore_maximum *m = &maxima[k];
    printf("a probe of %.4f fits at %.4f %.4f %.4f", m->radius, m->xyz[0], m->xyz[1], m->xyz[2]);
    if (m->gate == HSP_NONE) {
      printf(", and no point gets out\n");
      continue;
    }
    status = hsp_pores_get_gates(work->pores, m->gate, 1, &gate);
    printf(", one of %.4f gets %s between balls %u, %u and %u\n", m->death,
           m->parent == HSP_PORE_OUTSIDE ? "out" : "into a wider place", (unsigned)gate.ball[0], (unsigned)gate.ball[1],
           (unsigned)gate.ball[2]);
  }
  free(maxima);
  return status;
}

/* From the widest place the three best ways out, each by another bottleneck. */
static int32_t print_tunnels(hsp_workspace *work) {
  hsp_pore_maximum widest;
  uint32_t avoided[3];
  int32_t status = hsp_pores_get_maxima(work->pores, 0, 1, &widest);
  if (status == HSP_E_ID) return HSP_OK; /* no place is enclosed */
  for (uint32_t k = 0; status == HSP_OK && k < 3; ++k) {
    hsp_tunnel tunnel;
    status = hsp_workspace_tunnel(work, NULL, widest.xyz, NULL, avoided, k, &tunnel);
    if (status != HSP_OK || tunnel.there == 0) return status;
    printf("way out %u: radius %.4f, length %.4f, %u gates\n", (unsigned)k + 1, tunnel.radius, tunnel.length,
           (unsigned)tunnel.gates);
    if (tunnel.gate == HSP_NONE) return HSP_OK;
    avoided[k] = tunnel.gate;
  }
  return status;
}

/* Balls with plugs, in the mouths of pockets or in leaks, with their boundary and pores. *count: how many they are. */
static int32_t compute_plugged(const hsp_pores *pores, hsp_workspace *plugged, uint32_t *count) {
  int32_t status = hsp_pores_get_plugged_balls(pores, NULL, NULL, 0, count);
  double *xyz = malloc(((size_t)*count + 1) * 3 * sizeof *xyz), *radius = malloc(((size_t)*count + 1) * sizeof *radius);
  if (xyz == NULL || radius == NULL) status = HSP_E_MEMORY;
  if (status == HSP_OK) status = hsp_pores_get_plugged_balls(pores, xyz, radius, *count, count);
  if (status == HSP_OK) status = hsp_workspace_set(plugged, *count, xyz, radius, NULL, NULL);
  if (status == HSP_OK) status = hsp_workspace_boundary(plugged);
  if (status == HSP_OK) status = hsp_workspace_pores(plugged, NULL);
  free(xyz);
  free(radius);
  return status;
}

/* Sizes of the pockets that were found last, in a second workspace: again with more plugs while there are leaks. */
static int32_t measure_pockets(hsp_workspace *work, hsp_workspace *plugged, hsp_pore_pocket_size *sizes,
                               uint32_t pockets) {
  uint32_t before, count = 0;
  int32_t status = compute_plugged(work->pores, plugged, &count);
  do {
    if (status == HSP_OK) {
      status = hsp_pores_measure_pockets(work->pores, plugged->pores, plugged->boundary, sizes, pockets, NULL);
    }
    before = count;
    if (status == HSP_OK) status = compute_plugged(plugged->pores, plugged, &count);
  } while (status == HSP_OK && count > before);
  return status;
}

/* Where a point fits that a probe of some radius does not get to. */
static int32_t print_pockets(hsp_workspace *work, double wide) {
  uint32_t count = 0;
  int32_t status = hsp_pores_find_pockets(work->pores, 0, wide, &count);
  if (status != HSP_OK) return status;
  hsp_workspace plugged = {0};
  hsp_pore_pocket *pockets = malloc(((size_t)count + 1) * sizeof *pockets);
  hsp_pore_pocket_size *sizes = malloc(((size_t)count + 1) * sizeof *sizes);
  if (pockets == NULL || sizes == NULL) status = HSP_E_MEMORY;
  if (status == HSP_OK) status = hsp_pores_get_pockets(work->pores, 0, count, pockets);
  if (status == HSP_OK) status = measure_pockets(work, &plugged, sizes, count);
  for (uint32_t k = 0; status == HSP_OK && k < count; ++k) {
    printf("pocket for probes up to %.4f, %u mouths up to %.4f: ", pockets[k].radius, (unsigned)pockets[k].mouths,
           pockets[k].mouth);
    if (sizes[k].closed == 0) {
      printf("its mouths cannot be closed\n");
    } else {
      printf("volume %.4f, area %.4f\n", sizes[k].volume, sizes[k].area);
    }
  }
  hsp_workspace_free(&plugged);
  free(pockets);
  free(sizes);
  return status;
}

int main(int argc, char **argv) {
  struct balls balls = {0, NULL, NULL};
  hsp_workspace work = {0};
  const uint32_t most = argc > 2 ? (uint32_t)strtoul(argv[2], NULL, 10) : 10;
  if (!(argc > 1 ? read_balls(argv[1], &balls) : take_rooms(&balls))) {
    free_balls(&balls);
    return 1;
  }
  int32_t status = hsp_workspace_set(&work, balls.count, balls.xyz, balls.radius, NULL, NULL);
  if (status == HSP_OK) status = hsp_workspace_pores(&work, NULL);
  if (status == HSP_OK) status = print_classes(&work, most);
  if (status == HSP_OK) status = print_tunnels(&work);
  if (status == HSP_OK) status = print_pockets(&work, 0.3);
  if (status != HSP_OK) fprintf(stderr, "pores: %s\n", hsp_status_text(status));
  hsp_workspace_free(&work);
  free_balls(&balls);
  return status == HSP_OK ? 0 : 1;
}
