/* Every output array of every function, for every set of the catalogue, at capacities 0, 1, needed-1, needed and
 * needed+1: HSP_E_CAPACITY with the number needed and nothing written, or success with exactly that many records and
 * nothing written behind them. Guard bytes lie around every array. */
#include <hardsphere.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "computed.h"
#include "guarded_memory.h"
#include "output_sweep.h"

/* The call that is tried, so that one sweep serves all functions. */
typedef struct question {
  const computed *all;
  uint32_t ball;
  double reach;
} question;

static int32_t ask_vertices(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_boundary_get_vertices(q->all->boundary, out, capacity, needed);
}
static int32_t ask_arcs(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_boundary_get_arcs(q->all->boundary, out, capacity, needed);
}
static int32_t ask_circles(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_boundary_get_circles(q->all->boundary, out, capacity, needed);
}
static int32_t ask_faces(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_boundary_get_faces(q->all->boundary, out, capacity, needed);
}
static int32_t ask_loops(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_boundary_get_loops(q->all->boundary, out, capacity, needed);
}
static int32_t ask_loop_arcs(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_boundary_get_loop_arcs(q->all->boundary, out, capacity, needed);
}
static int32_t ask_balls(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_boundary_get_balls(q->all->boundary, out, capacity, needed);
}
static int32_t ask_point(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_query_point(q->all->model, q->all->xyz + 3 * q->ball, out, capacity, needed);
}
static int32_t ask_ball(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_query_ball(q->all->model, q->all->xyz + 3 * q->ball, q->reach, out, capacity, needed);
}
static int32_t ask_neighbours(const void *asked, void *out, uint32_t capacity, uint32_t *needed) {
  const question *q = asked;
  return hsp_query_neighbours(q->all->model, q->ball, out, capacity, needed);
}

static void sweep_measure(const computed *all) {
  const uint32_t n = all->n;
  uint32_t capacities[AROUND], i, arrays;
  values_around(n, capacities);
  for (i = 0; i < AROUND; ++i) {
    for (arrays = 1; arrays < 4; ++arrays) {
      const uint32_t capacity = capacities[i];
      guarded_memory area = guarded_take(capacity * sizeof(double), 0, GUARDED_PATTERN);
      guarded_memory volume = guarded_take(capacity * sizeof(double), 0, GUARDED_PATTERN);
      hsp_totals totals, before;
      int32_t status;
      memset(&totals, GUARDED_PATTERN, sizeof totals);
      before = totals;
      status =
          hsp_boundary_measure(all->boundary, NULL, &totals, (arrays & 1) != 0 ? (double *)(void *)area.block : NULL,
                               (arrays & 2) != 0 ? (double *)(void *)volume.block : NULL, capacity, NULL);
      if (capacity < n) {
        CHECK_EQUAL(status, HSP_E_CAPACITY);
        CHECK_BYTES(&totals, &before, sizeof totals);
        CHECK(guarded_untouched(&area, GUARDED_PATTERN) && guarded_untouched(&volume, GUARDED_PATTERN));
      } else {
        CHECK_EQUAL(status, HSP_OK);
        CHECK_BYTES(&totals, &all->totals, sizeof totals);
        if ((arrays & 1) != 0) {
          CHECK_BYTES(area.block, all->area, n * sizeof(double));
        } else {
          CHECK(guarded_untouched(&area, GUARDED_PATTERN));
        }
        if ((arrays & 2) != 0) {
          CHECK_BYTES(volume.block, all->volume, n * sizeof(double));
        } else {
          CHECK(guarded_untouched(&volume, GUARDED_PATTERN));
        }
      }
      CHECK(guarded_clean(&area) && guarded_clean(&volume));
      guarded_give_back(&area);
      guarded_give_back(&volume);
    }
  }
}

int main(void) {
  uint32_t which, i;
  for (which = 0; which < ball_set_count(); ++which) {
    static ball_set set;
    computed all;
    question q;
    ball_set_make(which, &set);
    check_scene("%s", set.name);
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &all), HSP_OK)) {
      q.all = &all;
      q.ball = 0;
      q.reach = 0;
      sweep_output(ask_vertices, &q, sizeof(hsp_vertex), all.counts.vertices);
      sweep_output(ask_arcs, &q, sizeof(hsp_arc), all.counts.arcs);
      sweep_output(ask_circles, &q, sizeof(hsp_circle), all.counts.circles);
      sweep_output(ask_faces, &q, sizeof(hsp_face), all.counts.faces);
      sweep_output(ask_loops, &q, sizeof(hsp_loop), all.counts.loops);
      sweep_output(ask_loop_arcs, &q, sizeof(hsp_loop_arc), 2 * all.counts.arcs);
      sweep_output(ask_balls, &q, sizeof(hsp_ball), all.n);
      sweep_measure(&all);
      for (i = 0; i < set.n; i += 1 + set.n / 5) {
        static const double reaches[3] = {0, 1.5, 1000};
        uint32_t needed = 0, r;
        q.ball = i;
        (void)ask_point(&q, NULL, 0, &needed);
        sweep_output(ask_point, &q, sizeof(uint32_t), needed);
        (void)ask_neighbours(&q, NULL, 0, &needed);
        sweep_output(ask_neighbours, &q, sizeof(uint32_t), needed);
        for (r = 0; r < 3; ++r) {
          q.reach = reaches[r];
          (void)ask_ball(&q, NULL, 0, &needed);
          sweep_output(ask_ball, &q, sizeof(uint32_t), needed);
        }
      }
    }
    computed_release(&all);
  }
  return check_report();
}
