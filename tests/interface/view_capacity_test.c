/* Every limit of hsp_view and every output array of its functions, for every set of topology_sets.h, at 0, 1, needed-1,
 * needed and needed+1: HSP_E_CAPACITY with nothing written beyond what the header names, or the same results as with
 * ample memory. Guard bytes lie around all memory. */
#include <hardsphere.h>
#include <string.h>

#include "check.h"
#include "guarded_memory.h"
#include "topology_sets.h"
#include "view_result.h"

/* ---- limits ---- */

enum { LIMITS = 3 };

static uint32_t *limit_number(hsp_view_limits *limits, int which) {
  return which == 0 ? &limits->balls : which == 1 ? &limits->neighbours : &limits->arcs;
}

/* The results are those that are known. */
static void check_same_results(const view_result *all, const hsp_view *view) {
  hsp_view_limits needed;
  hsp_view_info info;
  uint32_t count = 0;
  guarded_memory pieces = guarded_take(sizeof(hsp_view_piece) * all->info.pieces, 0, GUARDED_PATTERN);
  guarded_memory loops = guarded_take(sizeof(hsp_view_loop) * all->info.loops, 0, GUARDED_PATTERN);
  guarded_memory arcs = guarded_take(sizeof(hsp_view_arc) * all->info.arcs, 0, GUARDED_PATTERN);
  memset(&needed, 0, sizeof needed);
  memset(&info, 0, sizeof info);
  CHECK_EQUAL(hsp_view_get_needed(view, &needed), HSP_OK);
  CHECK_BYTES(&needed, &all->needed, sizeof needed);
  CHECK_EQUAL(hsp_view_get_info(view, &info), HSP_OK);
  CHECK_BYTES(&info, &all->info, sizeof info);
  CHECK_EQUAL(hsp_view_get_pieces(view, (void *)pieces.block, all->info.pieces, &count), HSP_OK);
  CHECK_BYTES(pieces.block, all->pieces, pieces.bytes);
  CHECK_EQUAL(hsp_view_get_loops(view, (void *)loops.block, all->info.loops, &count), HSP_OK);
  CHECK_BYTES(loops.block, all->loops, loops.bytes);
  CHECK_EQUAL(hsp_view_get_arcs(view, (void *)arcs.block, all->info.arcs, &count), HSP_OK);
  CHECK_BYTES(arcs.block, all->arcs, arcs.bytes);
  CHECK(guarded_clean(&pieces) && guarded_clean(&loops) && guarded_clean(&arcs));
  guarded_give_back(&pieces);
  guarded_give_back(&loops);
  guarded_give_back(&arcs);
}

/* A computation with room for `limits`; adds what it asks for. Whether it succeeded. */
static int try_once(const view_result *all, hsp_view_limits *limits, size_t misalignment) {
  size_t bytes = 0;
  guarded_memory memory;
  hsp_view *view = NULL;
  hsp_view_limits needed, exact = all->needed;
  hsp_view_info info;
  uint32_t count = 12345;
  int enough = 1, asked = 0, which;
  for (which = 0; which < LIMITS; ++which) {
    if (*limit_number(limits, which) < *limit_number(&exact, which)) enough = 0;
  }
  if (!CHECK_EQUAL(hsp_view_bytes(limits, &bytes), HSP_OK)) return 1;
  memory = guarded_take(bytes, misalignment, GUARDED_RANDOM);
  CHECK_EQUAL(hsp_view_init(memory.block, bytes, limits, &view), HSP_OK);
  CHECK_EQUAL(hsp_view_compute(view, all->base->model, all->with_boundary ? all->base->boundary : NULL, &all->options),
              enough ? HSP_OK : HSP_E_CAPACITY);
  if (enough) {
    check_same_results(all, view);
  } else {
    CHECK_EQUAL(hsp_view_get_needed(view, &needed), HSP_OK);
    CHECK_EQUAL(needed.struct_size, sizeof needed);
    for (which = 0; which < LIMITS; ++which) {
      const uint32_t given = *limit_number(limits, which), says = *limit_number(&needed, which);
      const int short_of = given < *limit_number(&exact, which);
      /* larger than given only where that was too small */
      if (says > given) asked = CHECK(short_of);
      if (short_of) CHECK(says > given || says == 0);
      if (says > given) *limit_number(limits, which) = says;
    }
    CHECK(asked);
    CHECK_EQUAL(hsp_view_get_info(view, &info), HSP_E_STATE);
    CHECK_EQUAL(hsp_view_get_arcs(view, NULL, 0, &count), HSP_E_STATE);
    CHECK_EQUAL(count, 12345);
  }
  CHECK(guarded_clean(&memory));
  guarded_give_back(&memory);
  return enough;
}

/* A view with room for `limits`, enlarged by what it asks for until it succeeds. */
static void try_limits(const view_result *all, const hsp_view_limits *from, size_t misalignment) {
  hsp_view_limits limits = *from;
  int enlargements;
  for (enlargements = 0; enlargements <= 3; ++enlargements) {
    if (try_once(all, &limits, misalignment)) return;
  }
  check_true(0, "three enlargements by hsp_view_get_needed lead to success", __FILE__, __LINE__);
}

static void sweep_limits(const view_result *all, const char *name) {
  static const char *const names[LIMITS] = {"balls", "neighbours", "arcs"};
  hsp_view_limits limits = all->needed;
  int which, i, other;
  check_scene("%s, all limits exact", name);
  try_limits(all, &limits, 1);
  for (which = 0; which < LIMITS; ++which) {
    const uint32_t needed = *limit_number(&limits, which);
    uint32_t values[5];
    values[0] = 0;
    values[1] = 1;
    values[2] = needed == 0 ? 0 : needed - 1;
    values[3] = needed;
    values[4] = needed + 1;
    for (i = 0; i < 5; ++i) {
      check_scene("%s, %s %u of %u", name, names[which], (unsigned)values[i], (unsigned)needed);
      *limit_number(&limits, which) = values[i];
      try_limits(all, &limits, (size_t)(3 * i + which));
      /* and as the only one that suffices */
      if (i == 3) {
        hsp_view_limits alone = limits;
        for (other = 0; other < LIMITS; ++other) {
          if (other != which) *limit_number(&alone, other) = 0;
        }
        try_limits(all, &alone, 5);
      }
    }
    *limit_number(&limits, which) = needed;
  }
  check_scene("%s, nothing at all", name);
  limits.balls = limits.neighbours = limits.arcs = 0;
  try_limits(all, &limits, 7);
}

/* ---- output arrays ---- */

typedef int32_t (*asking)(const hsp_view *view, void *out, uint32_t capacity, uint32_t *needed);

static int32_t ask_pieces(const hsp_view *view, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_view_get_pieces(view, out, capacity, needed);
}
static int32_t ask_loops(const hsp_view *view, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_view_get_loops(view, out, capacity, needed);
}
static int32_t ask_arcs(const hsp_view *view, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_view_get_arcs(view, out, capacity, needed);
}

static void sweep(asking ask, const hsp_view *view, size_t record, uint32_t expected) {
  uint32_t capacities[5], i, needed = 12345;
  capacities[0] = 0;
  capacities[1] = 1;
  capacities[2] = expected == 0 ? 0 : expected - 1;
  capacities[3] = expected;
  capacities[4] = expected + 1;
  CHECK_EQUAL(ask(view, NULL, 0, &needed), expected == 0 ? HSP_OK : HSP_E_CAPACITY);
  CHECK_EQUAL(needed, expected);
  for (i = 0; i < 5; ++i) {
    const uint32_t capacity = capacities[i];
    /* records are aligned as their type wants, hence a misalignment of 0 */
    guarded_memory out = guarded_take(capacity * record, 0, GUARDED_PATTERN);
    needed = 12345;
    if (capacity < expected) {
      CHECK_EQUAL(ask(view, out.block, capacity, &needed), HSP_E_CAPACITY);
      CHECK(guarded_untouched(&out, GUARDED_PATTERN));
    } else {
      /* all of every record is written, and nothing behind the last */
      guarded_memory again = guarded_take(capacity * record, 0, 0x11);
      CHECK_EQUAL(ask(view, out.block, capacity, &needed), HSP_OK);
      CHECK_EQUAL(ask(view, again.block, capacity, &needed), HSP_OK);
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

static void sweep_view(const computed *c, const hsp_view_options *options, int with_boundary, const char *name) {
  view_result all;
  if (CHECK_EQUAL(view_result_make(c, options, with_boundary, &all), HSP_OK)) {
    CHECK(all.enlargements <= 3);
    sweep_limits(&all, name);
    check_scene("%s, outputs", name);
    sweep(ask_pieces, all.view, sizeof(hsp_view_piece), all.info.pieces);
    sweep(ask_loops, all.view, sizeof(hsp_view_loop), all.info.loops);
    sweep(ask_arcs, all.view, sizeof(hsp_view_arc), all.info.arcs);
  }
  view_result_release(&all);
}

int main(void) {
  uint32_t which;
  for (which = 0; which < topology_set_count(); ++which) {
    static ball_set set;
    hsp_view_options options;
    computed c;
    topology_set_make(which, &set);
    check_scene("%s", set.name);
    CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
    options.towards[0] = 3;
    options.towards[1] = which % 3;
    options.towards[2] = 1;
    if (CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK)) {
      sweep_view(&c, &options, 0, set.name);
      options.flags = HSP_VIEW_ALL_BALLS;
      sweep_view(&c, &options, which % 2 == 0, set.name);
      options.pieces = HSP_PIECES_H;
      options.flags = which % 2 == 0 ? 0 : HSP_VIEW_ALL_BALLS;
      sweep_view(&c, &options, 1, set.name);
    }
    computed_release(&c);
  }
  return check_report();
}
