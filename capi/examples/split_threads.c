/* One boundary computed, measured and differentiated by several threads of C11.
 *   split_threads FILE.xyzr [THREADS]       x y z r on each line */
#include <stdatomic.h>
#include <threads.h>

#include "split_work.h"

enum { MOST_THREADS = 64, WORKERS_PER_THREAD = 4 /* who is ready early takes more */ };

/* Threads meet here before they go on. */
struct barrier {
  mtx_t mutex;
  cnd_t all_there;
  uint32_t threads, waiting;
  unsigned round;
};

static void meet(struct barrier *barrier) {
  mtx_lock(&barrier->mutex);
  const unsigned round = barrier->round;
  if (++barrier->waiting == barrier->threads) {
    barrier->waiting = 0;
    ++barrier->round;
    cnd_broadcast(&barrier->all_there);
  }
  while (round == barrier->round) cnd_wait(&barrier->all_there, &barrier->mutex);
  mtx_unlock(&barrier->mutex);
}

struct job {
  struct molecule *molecule;
  struct barrier barrier;
  uint32_t workers, stages;
  atomic_uint next[16]; /* worker that has no thread yet, of each stage; the last one is for the measuring */
  int32_t status;       /* of hsp_boundary_end */
  hsp_totals totals;
  hsp_energy energy;
};

enum { MEASURING = 15 };

static int take_part(void *argument) {
  struct job *job = argument;
  const struct molecule *m = job->molecule;
  uint32_t worker;
  for (uint32_t stage = 0; stage < job->stages; ++stage) {
    while ((worker = atomic_fetch_add(&job->next[stage], 1)) < job->workers) {
      hsp_boundary_work(m->boundary, stage, worker);
    }
    meet(&job->barrier);
  }
  mtx_lock(&job->barrier.mutex);
  if (job->status == HSP_E_STATE)
    job->status = hsp_boundary_end(m->boundary, &job->molecule->limits); /* the first one */
  mtx_unlock(&job->barrier.mutex);
  if (job->status != HSP_OK) return 0;
  while ((worker = atomic_fetch_add(&job->next[MEASURING], 1)) < job->workers) {
    measure_part(m, worker, job->workers);
  }
  return 0;
}

/* Areas and volumes by so many threads, the calling one among them. */
static int32_t compute(struct job *job, uint32_t threads) {
  struct molecule *m = job->molecule;
  thrd_t thread[MOST_THREADS];
  uint32_t started = 0;
  int32_t status = hsp_boundary_begin(m->boundary, m->model, job->workers, &job->stages);
  if (status != HSP_OK) return status;
  if (job->stages > MEASURING) return HSP_E_RANGE;
  for (int k = 0; k <= MEASURING; ++k) atomic_init(&job->next[k], 0);
  job->status = HSP_E_STATE;
  mtx_lock(&job->barrier.mutex); /* nobody comes through before it is known how many there are */
  while (started + 1 < threads && thrd_create(&thread[started], take_part, job) == thrd_success) ++started;
  job->barrier.threads = started + 1;
  mtx_unlock(&job->barrier.mutex);
  take_part(job);
  for (uint32_t k = 0; k < started; ++k) thrd_join(thread[k], NULL);
  return job->status == HSP_OK ? end_measuring(m, &job->totals, &job->energy) : job->status;
}

int main(int count, char **arguments) {
  static struct molecule molecule;
  static struct job job;
  const unsigned long threads = count == 3 ? strtoul(arguments[2], NULL, 10) : 2;
  if (count < 2 || count > 3 || threads < 1 || threads > MOST_THREADS) {
    fprintf(stderr, "usage: split_threads FILE.xyzr [THREADS]\n");
    return 2;
  }
  job.molecule = &molecule;
  job.workers = (uint32_t)threads * WORKERS_PER_THREAD;
  if (mtx_init(&job.barrier.mutex, mtx_plain) != thrd_success || cnd_init(&job.barrier.all_there) != thrd_success)
    return 1;
  int done = read_balls(arguments[1], &molecule.balls);
  if (done) {
    int32_t status = make_molecule(&molecule, job.workers);
    if (status == HSP_OK) {
      while ((status = compute(&job, (uint32_t)threads)) == HSP_E_CAPACITY) {
        if ((status = make_boundary(&molecule)) != HSP_OK) break;
      }
    }
    if (status == HSP_OK) status = compare_with_one(&molecule, &job.totals, &job.energy);
    if (status != HSP_OK) fprintf(stderr, "split_threads: %s\n", hsp_status_text(status));
    done = status == HSP_OK;
  }
  free_molecule(&molecule);
  return done ? 0 : 1;
}
