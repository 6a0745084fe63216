/* Every limit of hsp_view and every output array of its functions, for every set of topology_sets.h, at 0, 1, needed-1,
 * needed and needed+1: HSP_E_CAPACITY with nothing written beyond what the header names, or the same results as with
 * ample memory. Guard bytes lie around all memory. Sizes of handles: property numbers of hsp_view_bytes. */
#include <hardsphere.h>
#include <string.h>

#include "check.h"
#include "guarded_memory.h"
#include "limit_sweep.h"
#include "output_sweep.h"
#include "topology_sets.h"
#include "view_result.h"

/* ---- limits ---- */

/* The results are those that are known. */
static void check_results(const void *view, const void *source) {
  const view_result *all = source;
  hsp_view_info info;
  uint32_t count = 0;
  guarded_memory pieces = guarded_take(sizeof(hsp_view_piece) * all->info.pieces, 0, GUARDED_PATTERN);
  guarded_memory loops = guarded_take(sizeof(hsp_view_loop) * all->info.loops, 0, GUARDED_PATTERN);
  guarded_memory arcs = guarded_take(sizeof(hsp_view_arc) * all->info.arcs, 0, GUARDED_PATTERN);
  memset(&info, 0, sizeof info);
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

static void check_no_results(const void *view) {
  hsp_view_info info;
  uint32_t count = 12345;
  CHECK_EQUAL(hsp_view_get_info(view, &info), HSP_E_STATE);
  CHECK_EQUAL(hsp_view_get_arcs(view, NULL, 0, &count), HSP_E_STATE);
  CHECK_EQUAL(count, 12345);
}

static known_handle known_view(const view_result *all) {
  known_handle known = {&view_handle, NULL, NULL, check_results, check_no_results, NULL};
  known.source = all;
  known.needed = &all->needed;
  return known;
}

/* ---- output arrays ---- */

static int32_t ask_pieces(const void *view, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_view_get_pieces(view, out, capacity, needed);
}
static int32_t ask_loops(const void *view, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_view_get_loops(view, out, capacity, needed);
}
static int32_t ask_arcs(const void *view, void *out, uint32_t capacity, uint32_t *needed) {
  return hsp_view_get_arcs(view, out, capacity, needed);
}

static void sweep_view(const computed *c, const hsp_view_options *options, int with_boundary, const char *name) {
  view_result all;
  if (CHECK_EQUAL(view_result_make(c, options, with_boundary, &all), HSP_OK)) {
    const known_handle known = known_view(&all);
    CHECK(all.enlargements <= 3);
    sweep_limits(&known, name);
    check_scene("%s, outputs", name);
    sweep_output(ask_pieces, all.view, sizeof(hsp_view_piece), all.info.pieces);
    sweep_output(ask_loops, all.view, sizeof(hsp_view_loop), all.info.loops);
    sweep_output(ask_arcs, all.view, sizeof(hsp_view_arc), all.info.arcs);
  }
  view_result_release(&all);
}

/* ---- sizes ---- */

static size_t macro(const limit_numbers *limits) {
  const uint32_t *n = limits->number;
  return HSP_VIEW_BYTES(n[1], n[2], n[3]);
}

static void sizes(void) {
  static const size_bound bound = {macro, {32768, 192, 384, 64, 0}};
  static const uint32_t box[] = {0, 1, 2, 3, 7, 8, 9, 64, 65, 1000, 4097, 65535, 1000000, 0x0FFFFFFE, 0x0FFFFFFF};
  const uint32_t own = (uint32_t)sizeof(hsp_view_limits);
  const limit_numbers few = {{own, 1000, 50, 1000}}, balls = {{own, 2000, 50, 1000}},
                      neighbours = {{own, 1000, 500, 1000}}, arcs = {{own, 1000, 50, 2000}};
  uint32_t n;
  sweep_sizes(&view_handle, &bound, box, sizeof box / sizeof box[0]);
  for (n = 0; n < 600; ++n) {
    const limit_numbers limits = {{own, n, n / 2, 3}};
    CHECK(size_of(&view_handle, &bound, &limits) <= HSP_VIEW_BYTES(n, n / 2, 3));
  }
  CHECK(size_of(&view_handle, &bound, &few) < size_of(&view_handle, &bound, &balls));
  CHECK(size_of(&view_handle, &bound, &few) < size_of(&view_handle, &bound, &neighbours));
  CHECK(size_of(&view_handle, &bound, &few) < size_of(&view_handle, &bound, &arcs));
}

static void every_alignment(void) {
  static ball_set set;
  computed c;
  view_result all;
  hsp_view_options options;
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 30, 5);
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
  if (CHECK_EQUAL(view_result_make(&c, &options, 0, &all), HSP_OK)) {
    const known_handle known = known_view(&all);
    CHECK(all.info.arcs > 10);
    sweep_alignments(&known, NULL);
  }
  view_result_release(&all);
  computed_release(&c);
}

int main(void) {
  uint32_t which;
  sizes();
  every_alignment();
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
