/* The functions for views and pictures never allocate: malloc and its relatives are replaced by functions that count
 * while armed, and every entry point is called armed. For glibc only, and not for sanitizer builds, which bring their
 * own malloc. */
#include <hardsphere.h>
#include <stdlib.h>

#include "check.h"
#include "malloc_trap.h"
#include "topology_sets.h"
#include "view_result.h"

static int32_t count_bytes(void *context, const char *bytes, size_t count) {
  (void)bytes;
  *(uint64_t *)context += count;
  return 0;
}

/* Every format in every style; the number of calls that did not succeed. */
static int write_everything(hsp_view *view, const uint32_t *colour) {
  hsp_picture_options options;
  uint32_t format, style;
  int bad = hsp_picture_options_init(&options, (uint32_t)sizeof options) != HSP_OK;
  for (format = HSP_FORMAT_SVG; format <= HSP_FORMAT_PDF; ++format) {
    for (style = HSP_STYLE_FLAT; style <= HSP_STYLE_SOFT; ++style) {
      uint64_t taken = 0, said = 0;
      options.format = format;
      options.style = style;
      bad +=
          hsp_picture_write(view, colour, &options, "a title", "a description", count_bytes, &taken, &said) != HSP_OK;
      bad += taken == 0 || taken != said;
    }
  }
  return bad;
}

/* Every entry point once, into the arrays of `v`; the number of calls that did not succeed. */
static int call_everything(view_result *v, void *memory, size_t bytes, uint32_t *colour) {
  const computed *c = v->base;
  hsp_view *view = NULL;
  hsp_view_limits limits;
  hsp_view_options options;
  hsp_view_info info;
  uint32_t needed, i;
  size_t size;
  int bad = 0;
  bad += hsp_view_limits_init(&limits, (uint32_t)sizeof limits, c->n) != HSP_OK;
  bad += hsp_view_bytes(&v->needed, &size) != HSP_OK;
  bad += hsp_view_init(memory, bytes, &v->needed, &view) != HSP_OK;
  bad += hsp_view_options_init(&options, (uint32_t)sizeof options) != HSP_OK;
  bad += hsp_view_options_turn(&options, 10, 20, 30) != HSP_OK;
  bad += hsp_view_compute(view, c->model, v->with_boundary ? c->boundary : NULL, &v->options) != HSP_OK;
  bad += hsp_view_get_needed(view, &limits) != HSP_OK;
  bad += hsp_view_get_info(view, &info) != HSP_OK;
  bad += hsp_view_get_pieces(view, v->pieces, v->info.pieces, &needed) != HSP_OK;
  bad += hsp_view_get_loops(view, v->loops, v->info.loops, &needed) != HSP_OK;
  bad += hsp_view_get_arcs(view, v->arcs, v->info.arcs, &needed) != HSP_OK;
  for (i = 0; i < c->n; ++i) colour[i] = hsp_palette_colour(i % 4, i % 120, i);
  return bad + write_everything(view, colour);
}

int main(void) {
  static ball_set set;
  uint32_t which, kind;
  void *volatile bait;
  armed = 1;
  bait = malloc(10);
  free(bait);
  armed = 0;
  CHECK_EQUAL(caught, 2);
  for (which = 0; which < topology_set_count(); ++which) {
    computed c;
    topology_set_make(which, &set);
    CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
    for (kind = HSP_PIECES_G; kind <= HSP_PIECES_H; ++kind) {
      hsp_view_options options;
      view_result v;
      check_scene("%s, kind %u", set.name, (unsigned)kind);
      CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
      CHECK_EQUAL(hsp_view_options_turn(&options, 25, 35, 0), HSP_OK);
      options.pieces = kind;
      if (CHECK_EQUAL(view_result_make(&c, &options, kind == HSP_PIECES_H, &v), HSP_OK)) {
        uint32_t *colour = malloc((c.n + 1) * sizeof *colour);
        size_t bytes = 0;
        void *memory;
        int bad, allocations;
        CHECK_EQUAL(hsp_view_bytes(&v.needed, &bytes), HSP_OK);
        memory = malloc(bytes);
        if (memory == NULL || colour == NULL) return 2;
        caught = 0;
        armed = 1;
        bad = call_everything(&v, memory, bytes, colour);
        armed = 0;
        allocations = caught;
        CHECK_EQUAL(bad, 0);
        CHECK_EQUAL(allocations, 0);
        free(memory);
        free(colour);
      }
      view_result_release(&v);
    }
    computed_release(&c);
  }
  return check_report();
}
