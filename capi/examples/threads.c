/* Many threads on one molecule: they read the same handles, which are const to them, and each has its own part to ask.
 *   threads FILE.xyzr [THREADS]       x y z r on each line
 * A grid of points about the molecule: how many lie outside, how many in voids, how many in balls. */
#define _POSIX_C_SOURCE 200112L /* pthread */

#include <hardsphere_workspace.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>

#include "read_balls.h"

enum { STEPS = 24, MOST_THREADS = 64 };

struct part {
  const hsp_topology *topology;
  double low[3], step[3];
  uint32_t first, threads; /* this one takes first, first + threads, ... */
  unsigned outside, in_voids, in_balls;
  int32_t status;
};

static void *locate(void *argument) {
  struct part *part = argument;
  for (uint32_t at = part->first; at < STEPS * STEPS * STEPS && part->status == HSP_OK; at += part->threads) {
    const double point[3] = {part->low[0] + part->step[0] * (at % STEPS),
                             part->low[1] + part->step[1] * (at / STEPS % STEPS),
                             part->low[2] + part->step[2] * (at / STEPS / STEPS)};
    uint32_t region = HSP_NONE;
    part->status = hsp_topology_locate(part->topology, point, &region);
    if (region == HSP_NONE) {
      ++part->in_balls;
    } else if (region == 0) {
      ++part->outside;
    } else {
      ++part->in_voids;
    }
  }
  return NULL;
}

/* The grid fills the box of the balls. */
static void lay_grid(const struct balls *balls, struct part *part) {
  for (size_t axis = 0; axis < 3; ++axis) {
    double low = 0.0, high = 0.0;
    for (uint32_t i = 0; i < balls->count; ++i) {
      const double x = balls->xyz[3 * (size_t)i + axis], r = balls->radius[i];
      if (i == 0 || x - r < low) low = x - r;
      if (i == 0 || x + r > high) high = x + r;
    }
    part->low[axis] = low;
    part->step[axis] = (high - low) / (STEPS - 1);
  }
}

static int32_t locate_all(const struct balls *balls, const hsp_topology *topology, uint32_t threads) {
  static struct part parts[MOST_THREADS];
  pthread_t thread[MOST_THREADS];
  struct part sum = {0};
  uint32_t started = 0;
  for (uint32_t i = 0; i < threads; ++i) {
    lay_grid(balls, &parts[i]);
    parts[i].topology = topology;
    parts[i].first = i;
    parts[i].threads = threads;
  }
  while (started < threads && pthread_create(&thread[started], NULL, locate, &parts[started]) == 0) ++started;
  for (uint32_t i = 0; i < threads; ++i) {
    if (i < started) {
      pthread_join(thread[i], NULL);
    } else {
      locate(&parts[i]); /* what no thread could be had for */
    }
    if (parts[i].status != HSP_OK) sum.status = parts[i].status;
    sum.outside += parts[i].outside;
    sum.in_voids += parts[i].in_voids;
    sum.in_balls += parts[i].in_balls;
  }
  if (sum.status == HSP_OK) {
    printf("%u points outside, %u in voids, %u in balls\n", sum.outside, sum.in_voids, sum.in_balls);
  }
  return sum.status;
}

int main(int count, char **arguments) {
  struct balls balls = {0, NULL, NULL};
  hsp_workspace work = {0};
  const unsigned long threads = count == 3 ? strtoul(arguments[2], NULL, 10) : 4;
  if (count < 2 || count > 3 || threads < 1 || threads > MOST_THREADS) {
    fprintf(stderr, "usage: threads FILE.xyzr [THREADS]\n");
    return 2;
  }
  int done = read_balls(arguments[1], &balls);
  if (done) {
    int32_t status = hsp_workspace_set(&work, balls.count, balls.xyz, balls.radius, NULL, NULL);
    if (status == HSP_OK) status = hsp_workspace_boundary(&work);
    if (status == HSP_OK) status = hsp_workspace_topology(&work);
    if (status == HSP_OK) status = locate_all(&balls, work.topology, (uint32_t)threads);
    if (status != HSP_OK) fprintf(stderr, "threads: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  hsp_workspace_free(&work);
  free_balls(&balls);
  return done ? 0 : 1;
}
