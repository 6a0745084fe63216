/* Every output array of every function, for every set of the catalogue, at capacities 0, 1, needed-1, needed and
 * needed+1: HSP_E_CAPACITY with the number needed and nothing written, or success with exactly that many records and
 * nothing written behind them. Guard bytes lie around every array. */
#include <hardsphere.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "computed.h"
#include "guarded_memory.h"

/* What is being asked, so that one sweep serves all functions. */
typedef struct question {
  const computed *all;
  uint32_t ball;
  double reach;
} question;

typedef int32_t (*asking)(const question *q, void *out, uint32_t capacity, uint32_t *needed);

static int32_t ask_vertices(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_boundary_get_vertices(q->all->boundary, out, capacity, needed);
}
static int32_t ask_arcs(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_boundary_get_arcs(q->all->boundary, out, capacity, needed);
}
static int32_t ask_circles(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_boundary_get_circles(q->all->boundary, out, capacity, needed);
}
static int32_t ask_faces(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_boundary_get_faces(q->all->boundary, out, capacity, needed);
}
static int32_t ask_balls(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_boundary_get_balls(q->all->boundary, out, capacity, needed);
}
static int32_t ask_point(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_query_point(q->all->model, q->all->xyz + 3 * q->ball, out, capacity, needed);
}
static int32_t ask_ball(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_query_ball(q->all->model, q->all->xyz + 3 * q->ball, q->reach, out, capacity, needed);
}
static int32_t ask_neighbours(const question *q, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_query_neighbours(q->all->model, q->ball, out, capacity, needed);
}

static void sweep(asking ask, const question *q, size_t record, uint32_t expected) {
  uint32_t capacities[5], i;
  capacities[0] = 0;
  capacities[1] = 1;
  capacities[2] = expected == 0 ? 0 : expected - 1;
  capacities[3] = expected;
  capacities[4] = expected + 1;
  uint32_t needed = 12345;
  CHECK_EQUAL(ask(q, NULL, 0, &needed), expected == 0 ? HSP_OK : HSP_E_CAPACITY);
  CHECK_EQUAL(needed, expected);
  for (i = 0; i < 5; ++i) {
    const uint32_t capacity = capacities[i];
    /* records are aligned as their type wants, hence a misalignment of 0 */
    guarded_memory out = guarded_take(capacity * record, 0, GUARDED_PATTERN);
    needed = 12345;
    if (capacity < expected) {
      CHECK_EQUAL(ask(q, out.block, capacity, &needed), HSP_E_CAPACITY);
      CHECK(guarded_untouched(&out, GUARDED_PATTERN));
    } else {
      guarded_memory again = guarded_take(capacity * record, 0, 0x11);
      CHECK_EQUAL(ask(q, out.block, capacity, &needed), HSP_OK);
      CHECK_EQUAL(ask(q, again.block, capacity, &needed), HSP_OK);
      CHECK_BYTES(out.block, again.block, expected * record);
      CHECK(capacity == expected || out.block[expected * record] == GUARDED_PATTERN);
      CHECK(capacity == expected || again.block[capacity * record - 1] == 0x11);
      CHECK(guarded_clean(&again));
      guarded_give_back(&again);
    }
    CHECK_EQUAL(needed, expected);
    CHECK(guarded_clean(&out));
    guarded_give_back(&out);
  }
}

static void sweep_measure(const computed *all) {
  const uint32_t n = all->n;
  uint32_t capacities[5], i, arrays;
  capacities[0] = 0;
  capacities[1] = 1;
  capacities[2] = n == 0 ? 0 : n - 1;
  capacities[3] = n;
  capacities[4] = n + 1;
  for (i = 0; i < 5; ++i) {
    for (arrays = 1; arrays < 4; ++arrays) {
      const uint32_t capacity = capacities[i];
      guarded_memory area = guarded_take(capacity * sizeof(double), 0, GUARDED_PATTERN);
      guarded_memory volume = guarded_take(capacity * sizeof(double), 0, GUARDED_PATTERN);
      hsp_totals totals, before;
      int32_t status;
      memset(&totals, GUARDED_PATTERN, sizeof totals);
      before = totals;
      status = hsp_boundary_measure(all->boundary, &totals, (arrays & 1) != 0 ? (double *)(void *)area.block : NULL,
                                    (arrays & 2) != 0 ? (double *)(void *)volume.block : NULL, capacity);
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
      sweep(ask_vertices, &q, sizeof(hsp_vertex), all.counts.vertices);
      sweep(ask_arcs, &q, sizeof(hsp_arc), all.counts.arcs);
      sweep(ask_circles, &q, sizeof(hsp_circle), all.counts.circles);
      sweep(ask_faces, &q, sizeof(hsp_face), all.counts.faces);
      sweep(ask_balls, &q, sizeof(hsp_ball), all.n);
      sweep_measure(&all);
      for (i = 0; i < set.n; i += 1 + set.n / 5) {
        static const double reaches[3] = {0, 1.5, 1000};
        uint32_t needed = 0, r;
        q.ball = i;
        (void)ask_point(&q, NULL, 0, &needed);
        sweep(ask_point, &q, sizeof(uint32_t), needed);
        (void)ask_neighbours(&q, NULL, 0, &needed);
        sweep(ask_neighbours, &q, sizeof(uint32_t), needed);
        for (r = 0; r < 3; ++r) {
          q.reach = reaches[r];
          (void)ask_ball(&q, NULL, 0, &needed);
          sweep(ask_ball, &q, sizeof(uint32_t), needed);
        }
      }
    }
    computed_release(&all);
  }
  return check_report();
}
