#define _GNU_SOURCE /* sched_getaffinity of Linux; elsewhere nothing hides the number of processors */

#include "read/threads.h"

#include <pthread.h>
#include <sched.h>
#include <stdlib.h>
#include <unistd.h>

/* Some systems give threads a smaller stack, or a much larger one than they need. */
#define STACK_BYTES ((size_t)1 << 20)

uint32_t threads_of_machine(void) {
  long count = 0;
#ifdef __linux__
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) count = CPU_COUNT(&allowed);
#endif
#ifdef _SC_NPROCESSORS_ONLN
  if (count < 1) count = sysconf(_SC_NPROCESSORS_ONLN);
#endif
  return count < 1 ? 1 : count > MOST_THREADS ? MOST_THREADS : (uint32_t)count;
}

/* ---- threads that do the same, and one number each ---- */

struct member {
  pthread_t thread;
  uint32_t number;
  void (*part)(void *data, uint32_t number);
  void *data;
};

static void *take_part(void *of) {
  const struct member *const member = of;
  member->part(member->data, member->number);
  return NULL;
}

/* Call part(data, 0) in this thread and part(data, 1) .. part(data, threads - 1) in others, as far as they are to be
 * had, and wait for them. */
static void run_members(uint32_t threads, void part(void *data, uint32_t number), void *data) {
  struct member *const members = threads > 1 ? malloc((threads - 1) * sizeof *members) : NULL;
  uint32_t started = 0;
  pthread_attr_t attributes;
  if (members != NULL && pthread_attr_init(&attributes) == 0) {
    (void)pthread_attr_setstacksize(&attributes, STACK_BYTES);
    while (started + 1 < threads) {
      struct member *const next = &members[started];
      next->number = started + 1;
      next->part = part;
      next->data = data;
      if (pthread_create(&next->thread, &attributes, take_part, next) != 0) break;
      ++started;
    }
    pthread_attr_destroy(&attributes);
  }
  part(data, 0);
  for (uint32_t k = 0; k < started; ++k) pthread_join(members[k].thread, NULL);
  free(members);
}

/* ---- a loop of tasks ---- */

struct tasks {
  pthread_mutex_t lock;
  uint32_t next;
  uint32_t count;
  void (*task)(void *data, uint32_t task);
  void *data;
};

static void do_tasks(void *of, uint32_t number) {
  struct tasks *const tasks = of;
  (void)number;
  for (;;) {
    pthread_mutex_lock(&tasks->lock);
    const uint32_t k = tasks->next < tasks->count ? tasks->next++ : tasks->count;
    pthread_mutex_unlock(&tasks->lock);
    if (k == tasks->count) return;
    tasks->task(tasks->data, k);
  }
}

void threads_run(uint32_t threads, uint32_t tasks, void task(void *data, uint32_t task), void *data) {
  struct tasks all = {.next = 0, .count = tasks, .task = task, .data = data};
  pthread_mutex_init(&all.lock, NULL);
  run_members(threads < tasks ? threads : tasks, do_tasks, &all);
  pthread_mutex_destroy(&all.lock);
}

/* ---- items in order ---- */

struct slot {
  bool worked; /* and not given yet */
  uint64_t weight;
};

struct line {
  const struct in_order *loop;
  pthread_mutex_t taking; /* the thread that takes an item has it, and may wait for bytes meanwhile */
  pthread_mutex_t lock;   /* of all that follows, but of `taken`, which is the taker's */
  pthread_cond_t given_some;
  uint64_t taken;
  uint64_t given;
  uint64_t weight; /* of all between */
  bool ended;      /* nothing more is to be taken */
  bool stopped;    /* nor given */
  bool giving;
  struct slot *slots;
};

/* Wait until there is room for the next item, and later until it may weigh as much. False: nothing is to be taken. */
static bool wait_for_slot(struct line *line) {
  pthread_mutex_lock(&line->lock);
  while (!line->ended && line->taken - line->given >= line->loop->slots) {
    pthread_cond_wait(&line->given_some, &line->lock);
  }
  const bool ended = line->ended;
  pthread_mutex_unlock(&line->lock);
  return !ended;
}

static void wait_for_weight(struct line *line, uint32_t slot, uint64_t weight) {
  const uint64_t most = line->loop->most;
  pthread_mutex_lock(&line->lock);
  while (most > 0 && !line->stopped && line->weight > 0 && line->weight + weight > most) {
    pthread_cond_wait(&line->given_some, &line->lock);
  }
  line->weight += weight;
  line->slots[slot].weight = weight;
  pthread_mutex_unlock(&line->lock);
}

static bool take_next(struct line *line, uint32_t *slot) {
  pthread_mutex_lock(&line->taking);
  bool taken = wait_for_slot(line);
  if (taken) {
    uint64_t weight = 0;
    *slot = (uint32_t)(line->taken % line->loop->slots);
    taken = line->loop->take(line->loop->of, *slot, &weight);
    if (taken) {
      ++line->taken;
      wait_for_weight(line, *slot, weight);
    } else {
      pthread_mutex_lock(&line->lock);
      line->ended = true;
      pthread_mutex_unlock(&line->lock);
    }
  }
  pthread_mutex_unlock(&line->taking);
  return taken;
}

/* Give the next items on which work is done. A thread that finishes an item while another thread gives leaves it to
 * that thread. */
static void give_worked(struct line *line, uint32_t slot) {
  pthread_mutex_lock(&line->lock);
  line->slots[slot].worked = true;
  while (!line->giving && !line->stopped) {
    const uint32_t next = (uint32_t)(line->given % line->loop->slots);
    if (!line->slots[next].worked) break;
    line->giving = true;
    pthread_mutex_unlock(&line->lock);
    const bool more = line->loop->give(line->loop->of, next);
    pthread_mutex_lock(&line->lock);
    line->giving = false;
    line->slots[next].worked = false;
    line->weight -= line->slots[next].weight;
    ++line->given;
    if (!more) line->stopped = line->ended = true;
    pthread_cond_broadcast(&line->given_some);
  }
  pthread_mutex_unlock(&line->lock);
}

static void walk_line(void *of, uint32_t number) {
  struct line *const line = of;
  uint32_t slot;
  while (take_next(line, &slot)) {
    line->loop->work(line->loop->of, number, slot);
    give_worked(line, slot);
  }
}

bool in_order_run(const struct in_order *loop) {
  struct line line = {.loop = loop};
  line.slots = calloc(loop->slots, sizeof *line.slots);
  if (line.slots == NULL) return false;
  pthread_mutex_init(&line.taking, NULL);
  pthread_mutex_init(&line.lock, NULL);
  pthread_cond_init(&line.given_some, NULL);
  run_members(loop->workers, walk_line, &line);
  pthread_cond_destroy(&line.given_some);
  pthread_mutex_destroy(&line.lock);
  pthread_mutex_destroy(&line.taking);
  free(line.slots);
  return true;
}
