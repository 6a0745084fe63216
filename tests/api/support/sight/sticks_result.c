#include "sticks_result.h"

#include <stdlib.h>
#include <string.h>

HANDLE_FUNCTIONS(sticks)
LIMITS_OF_BALLS(sticks)

static int32_t compute_handle(void *handle, const void *source, void *limits) {
  const sticks_result *s = source;
  return hsp_sticks_compute_map(handle, s->base->model, &s->options, s->stick, s->count, s->radius, NULL, limits);
}

const handle_kind sticks_handle = {(uint32_t)sizeof(hsp_sticks_limits),
                                   4,
                                   {"", "balls", "sticks", "pairs", "edges"},
                                   init_limits,
                                   bytes_of_limits,
                                   init_handle,
                                   compute_handle,
                                   9};

/* Leaves out sticks that are in conflict. Conflicts are found before room for pairs and edges is needed. */
static void choose_sticks(sticks_result *s) {
  const hsp_sticks_limits limits = {(uint32_t)sizeof limits, s->base->n, STICKS_OF_RESULT, 0, 0};
  size_t bytes = 0;
  hsp_sticks *trial = NULL;
  void *memory;
  uint32_t i;
  if (hsp_sticks_bytes(&limits, &bytes) != HSP_OK) return;
  memory = test_zeros(bytes, 1);
  if (hsp_sticks_init(memory, bytes, &limits, &trial) == HSP_OK) {
    for (i = 0; i + 1 < s->base->n && i < STICKS_OF_RESULT; ++i) {
      static const uint32_t kinds[] = {0, HSP_STICK_DOUBLE, HSP_STICK_TRIPLE, HSP_STICK_AROMATIC};
      const hsp_stick next = {{i, i + 1}, kinds[i % 4] | (i % 3 == 2 ? HSP_STICK_WHOLE : 0), 0};
      s->stick[s->count] = next;
      if (hsp_sticks_compute(trial, s->base->model, &s->options, s->stick, s->count + 1, s->radius, NULL, NULL) !=
          HSP_E_CONFLICT)
        ++s->count;
    }
  }
  free(memory);
}

static int32_t read_map(sticks_result *s) {
  const uint32_t bodies = s->base->n + 2 * s->count;
  uint32_t needed = 0;
  int32_t status = hsp_sticks_get_info(s->sticks, &s->info);
  if (status == HSP_OK) status = hsp_sticks_get_map_info(s->sticks, &s->map);
  if (status != HSP_OK) return status;
  s->vertices = test_zeros(s->map.vertices, sizeof *s->vertices);
  s->edges = test_zeros(s->map.edges, sizeof *s->edges);
  s->faces = test_zeros(s->map.faces, sizeof *s->faces);
  s->area = test_zeros(bodies, sizeof *s->area);
  status = hsp_sticks_get_vertices(s->sticks, 0, s->map.vertices, s->vertices);
  if (status == HSP_OK) status = hsp_sticks_get_edges(s->sticks, 0, s->map.edges, s->edges);
  if (status == HSP_OK) status = hsp_sticks_get_faces(s->sticks, 0, s->map.faces, s->faces);
  if (status == HSP_OK) status = hsp_sticks_get_areas(s->sticks, s->area, bodies, &needed);
  return status;
}

static int32_t make(sticks_result *s) {
  void *sticks = NULL;
  const int32_t status =
      grow_until_computed(&sticks_handle, s, s->base->n, &s->memory, &sticks, &s->needed, &s->enlargements);
  s->sticks = sticks;
  return status == HSP_OK ? read_map(s) : status;
}

int32_t sticks_result_make(const computed *base, const hsp_view_options *options, sticks_result *s) {
  uint32_t i;
  memset(s, 0, sizeof *s);
  s->base = base;
  s->options = *options;
  s->radius = 4;
  for (i = 0; i < base->n; ++i) {
    if (base->radius[i] > 0 && base->radius[i] < s->radius) s->radius = base->radius[i];
  }
  s->radius *= 0.25;
  choose_sticks(s);
  return make(s);
}

int32_t sticks_result_make_like(const computed *base, const sticks_result *like, const uint32_t *place,
                                sticks_result *s) {
  uint32_t k;
  memset(s, 0, sizeof *s);
  s->base = base;
  s->options = like->options;
  s->radius = like->radius;
  s->count = like->count;
  for (k = 0; k < s->count; ++k) {
    s->stick[k] = like->stick[k];
    s->stick[k].ball[0] = place[like->stick[k].ball[0]];
    s->stick[k].ball[1] = place[like->stick[k].ball[1]];
  }
  return make(s);
}

void sticks_result_release(sticks_result *s) {
  free(s->memory);
  free(s->vertices);
  free(s->edges);
  free(s->faces);
  free(s->area);
  memset(s, 0, sizeof *s);
}
