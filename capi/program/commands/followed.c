#include "commands/followed.h"

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "read/growing_array.h"

/* A known cavity, as it was in the last frame that had it. */
struct followed_cavity {
  uint32_t *balls;
  uint32_t ball_count;
  uint64_t last; /* that frame, by its place among those taken, from 1 on */
  bool taken;    /* a cavity of the present frame has its number */
  bool ended;    /* it is part of another cavity of the present frame */
};

/* A known cavity and one of the frame that may be the same. */
struct likeness {
  uint32_t known, cavity;
  uint64_t shared, either; /* balls that both have, and that one of them has */
};

struct likenesses {
  struct likeness *of;
  size_t count, room;
};

/* Which cavities of the frame are at each ball. */
struct cavities_at_balls {
  size_t *first; /* [balls + 1] */
  uint32_t *cavity;
};

static bool find_at_balls(const struct cavity *cavities, uint32_t count, uint32_t balls, struct cavities_at_balls *at) {
  size_t all = 0;
  for (uint32_t c = 0; c < count; ++c) all += cavities[c].ball_count;
  at->first = calloc((size_t)balls + 2, sizeof *at->first);
  at->cavity = calloc(all + 1, sizeof *at->cavity);
  if (at->first == NULL || at->cavity == NULL) return false;
  for (uint32_t c = 0; c < count; ++c) {
    for (uint32_t k = 0; k < cavities[c].ball_count; ++k) ++at->first[cavities[c].balls[k] + 2];
  }
  for (uint32_t b = 0; b < balls; ++b) at->first[b + 2] += at->first[b + 1];
  for (uint32_t c = 0; c < count; ++c) {
    for (uint32_t k = 0; k < cavities[c].ball_count; ++k) at->cavity[at->first[cavities[c].balls[k] + 1]++] = c;
  }
  return true;
}

/* The most alike first; ties are ordered by number and by place in the list. */
static int order_of_likeness(const void *left, const void *right) {
  const struct likeness *const a = left, *const b = right;
  const uint64_t more = a->shared * b->either, less = b->shared * a->either;
  if (more != less) return more > less ? -1 : 1;
  if (a->known != b->known) return a->known < b->known ? -1 : 1;
  return (a->cavity > b->cavity) - (a->cavity < b->cavity);
}

/* shared [count]: zeros, before and after; touched [count]. */
static bool add_likenesses(uint32_t number, const struct followed_cavity *known, const struct cavity *cavities,
                           const struct cavities_at_balls *at, uint32_t *shared, uint32_t *touched,
                           struct likenesses *found) {
  uint32_t meets = 0;
  for (uint32_t k = 0; k < known->ball_count; ++k) {
    for (size_t i = at->first[known->balls[k]]; i < at->first[known->balls[k] + 1]; ++i) {
      if (shared[at->cavity[i]]++ == 0) touched[meets++] = at->cavity[i];
    }
  }
  bool done = true;
  for (uint32_t t = 0; t < meets; ++t) {
    const uint32_t c = touched[t], both = shared[c], own = cavities[c].ball_count;
    const uint32_t fewer = own < known->ball_count ? own : known->ball_count;
    shared[c] = 0;
    if (2 * (uint64_t)both < fewer || !done) continue;
    const struct likeness likeness = {number, c, both, (uint64_t)own + known->ball_count - both};
    done = array_append(&found->of, &found->count, &found->room, &likeness, sizeof likeness);
  }
  return done;
}

static bool find_likenesses(const struct followed *followed, const struct cavity *cavities, uint32_t count,
                            uint32_t balls, struct likenesses *found) {
  struct cavities_at_balls at = {NULL, NULL};
  uint32_t *const shared = calloc((size_t)count + 1, sizeof *shared), *const touched = calloc((size_t)count + 1, 4);
  bool done = shared != NULL && touched != NULL && find_at_balls(cavities, count, balls, &at);
  for (uint32_t n = 0; done && n < followed->numbers; ++n) {
    done = add_likenesses(n, &followed->known[n], cavities, &at, shared, touched, found);
  }
  if (done && found->count > 1) qsort(found->of, found->count, sizeof *found->of, order_of_likeness);
  free(at.first);
  free(at.cavity);
  free(shared);
  free(touched);
  return done;
}

/* Find the cavities of the frame before from which new ones split off, and those that have ended in present ones. */
static bool find_changes(struct followed *followed, struct cavity *cavities, uint32_t count,
                         const struct likenesses *found) {
  const uint64_t before = followed->frames;
  uint32_t *const merged = realloc(followed->merged, (found->count + 1) * sizeof *merged);
  if (merged == NULL) return false;
  followed->merged = merged;
  for (size_t i = 0; i < found->count; ++i) {
    const struct likeness *const one = &found->of[i];
    struct followed_cavity *const known = &followed->known[one->known];
    struct cavity *const cavity = &cavities[one->cavity];
    if (known->last != before) continue;
    const bool is_new = cavity->number == 0 || followed->known[cavity->number - 1].last != before;
    if (is_new && cavity->from == 0) cavity->from = one->known + 1;
    if (known->taken || known->ended) continue;
    known->ended = true;
    ++cavity->merged_count;
  }
  size_t used = 0;
  for (uint32_t c = 0; c < count; ++c) {
    cavities[c].merged = merged + used;
    used += cavities[c].merged_count;
    cavities[c].merged_count = 0;
  }
  for (size_t i = 0; i < found->count; ++i) {
    const struct likeness *const one = &found->of[i];
    struct followed_cavity *const known = &followed->known[one->known];
    struct cavity *const cavity = &cavities[one->cavity];
    if (!known->ended) continue;
    known->ended = false;
    merged[(size_t)(cavity->merged - merged) + cavity->merged_count++] = one->known + 1;
  }
  return true;
}

/* Keep a cavity as it is in this frame, under its number, which may be a new one. */
static bool keep(struct followed *followed, struct cavity *cavity) {
  if (cavity->number == 0) {
    if (!array_make_room(&followed->known, followed->numbers, &followed->room, sizeof *followed->known)) return false;
    followed->known[followed->numbers] = (struct followed_cavity){.balls = NULL};
    cavity->number = ++followed->numbers;
  }
  struct followed_cavity *const known = &followed->known[cavity->number - 1];
  uint32_t *const balls = realloc(known->balls, ((size_t)cavity->ball_count + 1) * sizeof *balls);
  if (balls == NULL) return false;
  if (cavity->ball_count > 0) memcpy(balls, cavity->balls, cavity->ball_count * sizeof *balls);
  *known = (struct followed_cavity){.balls = balls, .ball_count = cavity->ball_count, .last = followed->frames};
  return true;
}

static bool keep_volume(struct followed *followed, uint64_t frame, const struct cavity *cavity) {
  const struct followed_volume volume = {frame, followed->frames, cavity->number, cavity->volume};
  return array_append(&followed->volumes, &followed->volume_count, &followed->volume_room, &volume, sizeof volume);
}

bool followed_take(struct followed *followed, const struct molecule *molecule, struct cavity *cavities, uint32_t count,
                   struct failure *failure) {
  struct likenesses found = {NULL, 0, 0};
  const uint64_t frame = molecule->frame.number;
  for (uint32_t c = 0; c < count; ++c) cavities[c].number = cavities[c].from = cavities[c].merged_count = 0;
  bool done = find_likenesses(followed, cavities, count, molecule->atoms, &found);
  for (size_t i = 0; done && i < found.count; ++i) {
    struct followed_cavity *const known = &followed->known[found.of[i].known];
    struct cavity *const cavity = &cavities[found.of[i].cavity];
    if (known->taken || cavity->number > 0) continue;
    known->taken = true;
    cavity->number = found.of[i].known + 1;
  }
  done = done && find_changes(followed, cavities, count, &found);
  free(found.of);
  if (followed->frames++ == 0) followed->first_frame = frame;
  followed->last_frame = frame;
  for (uint32_t c = 0; done && c < count; ++c) {
    done = keep(followed, &cavities[c]) && (!followed->keeps_volumes || keep_volume(followed, frame, &cavities[c]));
  }
  return done || failure_of_memory(failure);
}

void followed_cells(const struct cavity *cavity, union cell *number, union cell more[FOLLOWED], char text[CELL_BYTES]) {
  char *const place = text + CELL_BYTES / 2; /* the first half may be that of another cell */
  number->count = cavity->number;
  snprintf(place, CELL_BYTES / 2, "%" PRIu32, cavity->from);
  more[0].text = cavity->from == 0 ? "none" : place;
  more[1].counts.list = cavity->merged;
  more[1].counts.length = cavity->merged_count;
}

void followed_free(struct followed *followed) {
  for (uint32_t n = 0; n < followed->numbers; ++n) free(followed->known[n].balls);
  free(followed->known);
  free(followed->merged);
  free(followed->volumes);
}
