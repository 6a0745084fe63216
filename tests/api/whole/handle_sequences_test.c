/* Sequences of calls across handles, in random order, against a model of what is valid: results are there exactly if
 * the handle was computed since it was made, what it was computed from is still where it was, and that holds the same.
 * Then they are those of a computation in fresh memory, bit for bit. Handles are made again where they are, with other
 * limits, or in other memory; what is written over their memory is no handle. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "guarded_memory.h"
#include "handle_life.h"
#include "loops.h"
#include "picture_sink.h"
#include "random_numbers.h"

enum { FIRST, SMALLER, PERMUTED, PROBE, STEP, LARGEST_RADIUS, MOVED, FEWER, EMPTY, CONTENTS, REFUSED = CONTENTS };
enum { DEPENDENT_KINDS = PORES + 1, COPIES = 2, BALLS = 5, MOST_CAPACITY = 24, ROOM = 4096 };

static struct {
  ball_set set;
  hsp_model_options options;
  computations all;
  uint64_t hash[DEPENDENT_KINDS], mesh_of_surface; /* 0: that is not computed from these balls */
} known[CONTENTS];
static unsigned char *buffer;

/* A handle with two blocks of memory, in one of which it is, and what the test knows of it. */
typedef struct slot {
  guarded_memory block[2];
  int which;
  void *handle; /* NULL if its memory holds something else */
  int complete;
  int content;        /* when it was computed; of a model what it holds */
  int copy;           /* of the model or boundary that it was computed from, */
  const void *source; /* where that was then */
  int of_surface;
} slot;
static slot models[COPIES], slots[DEPENDENT_KINDS][COPIES];
static limit_numbers most[DEPENDENT_KINDS];

/* ---- what is known ---- */

static int is_of_boundary(int kind) {
  return kind == TOPOLOGY || kind == SURFACE || kind == MESH || kind == CONTACTS;
}

/* Sources of a computation of these contents from a model and a boundary. */
static void take_sources(int content, hsp_model *model, hsp_boundary *boundary, computations *all) {
  *all = known[content].all;
  all->boundary.model = model;
  all->boundary.boundary = boundary;
  all->topology.base = all->view.base = all->map.base = all->sticks.base = all->surface.base = all->mesh.base =
      all->contacts.base = all->cells.base = all->paths.base = all->pores.base = &all->boundary;
}

static void make_contents(void) {
  static const uint32_t order[BALLS] = {1, 0, 2, 4, 3};
  ball_set first;
  int c;
  ball_set_start(&first, "five balls", 1e-3);
  ball_set_add_chain(&first, BALLS, 5);
  for (c = 0; c < CONTENTS; ++c) {
    ball_set *set = &known[c].set;
    *set = first;
    CHECK_EQUAL(hsp_model_options_init(&known[c].options, sizeof known[c].options), HSP_OK);
    if (c == SMALLER) set->radius[1] *= 0.875;
    if (c == PERMUTED) ball_set_permute(&first, order, set);
    if (c == PROBE) known[c].options.probe = 0.5;
    if (c == STEP) known[c].options.step = 1e-6;
    if (c == LARGEST_RADIUS) known[c].options.largest_radius = 2.5;
    if (c == MOVED) set->xyz[0] += 0.25;
    if (c == FEWER) set->n = 2;
    if (c == EMPTY) set->n = 0;
  }
}

static void compute_contents(void) {
  hsp_view_options options;
  int c, kind, which;
  CHECK_EQUAL(hsp_view_options_init(&options, sizeof options), HSP_OK);
  for (c = 0; c < CONTENTS; ++c) {
    computations *all = &known[c].all;
    const computed *base = &all->boundary;
    int made[DEPENDENT_KINDS];
    const ball_set *set = &known[c].set;
    check_scene("contents %d", c);
    made[BOUNDARY] = computed_make(set->n, set->xyz, set->radius, &known[c].options, &all->boundary);
    made[TOPOLOGY] = topology_result_make(base, &all->topology);
    made[VIEW] = view_result_make(base, &options, 0, &all->view);
    made[MAP] = map_result_make(base, &options, &all->map);
    made[STICKS] = sticks_result_make(base, &options, &all->sticks);
    made[SURFACE] = surface_result_make(base, &all->surface);
    made[CONTACTS] = contacts_result_make(base, &all->contacts);
    made[CELLS] = cells_result_make(base, &all->cells);
    made[PATHS] = paths_result_make(base, &all->paths);
    made[PORES] = pores_result_make(base, &all->pores);
    all->room = ROOM;
    if (buffer == NULL) buffer = buffer_for(all);
    if (mesh_result_make_surface(&all->surface, 1.0, &all->mesh) == HSP_OK) {
      known[c].mesh_of_surface = kinds_of_life[MESH].hash(all->mesh.mesh, &all->mesh, buffer, ROOM);
      for (which = 1; which < LIMIT_NUMBERS; ++which) {
        const uint32_t number = limits_of(all, MESH).number[which];
        if (number > most[MESH].number[which]) most[MESH].number[which] = number;
      }
      mesh_result_release(&all->mesh);
    }
    made[MESH] = mesh_result_make(base, 1.0, &all->mesh);
    for (kind = 0; kind < DEPENDENT_KINDS; ++kind) {
      const limit_numbers limits = limits_of(all, kind);
      if (c != EMPTY) CHECK_EQUAL(made[kind], HSP_OK);
      if (made[kind] != HSP_OK) continue;
      known[c].hash[kind] = kinds_of_life[kind].hash(handle_of(all, kind), source_of(all, kind), buffer, ROOM);
      most[kind].number[0] = limits.number[0];
      for (which = 1; which < LIMIT_NUMBERS; ++which) {
        if (limits.number[which] > most[kind].number[which]) most[kind].number[which] = limits.number[which];
      }
    }
  }
  /* Else nothing could be mistaken for something else. */
  for (kind = 0; kind < DEPENDENT_KINDS; ++kind) {
    check_scene("%s", kinds_of_life[kind].name);
    CHECK(known[FIRST].hash[kind] != 0);
    CHECK(known[FIRST].hash[kind] != known[PROBE].hash[kind]);
    CHECK(known[FIRST].hash[kind] != known[FEWER].hash[kind]);
  }
}

/* ---- what is valid ---- */

static int has_results(int kind, const slot *s) {
  const slot *source = is_of_boundary(kind) ? &slots[BOUNDARY][s->copy] : &models[s->copy];
  if (s->handle == NULL || !s->complete || source->handle == NULL || source->handle != s->source) return 0;
  return source->content == s->content && (!is_of_boundary(kind) || has_results(BOUNDARY, source));
}

static int32_t first_reading(int kind, const void *handle) {
  union {
    hsp_boundary_counts boundary;
    hsp_topology_counts topology;
    hsp_view_info view;
    hsp_surface_counts surface;
    hsp_mesh_counts mesh;
    hsp_map_info map;
    hsp_sticks_info sticks;
    hsp_complex contacts;
    hsp_cells_counts cells;
    hsp_pores_counts pores;
  } out;
  uint32_t needed;
  switch (kind) {
    case BOUNDARY:
      return hsp_boundary_get_counts(handle, &out.boundary);
    case TOPOLOGY:
      return hsp_topology_get_counts(handle, &out.topology);
    case VIEW:
      return hsp_view_get_info(handle, &out.view);
    case SURFACE:
      return hsp_surface_get_counts(handle, &out.surface);
    case MESH:
      return hsp_mesh_get_counts(handle, &out.mesh);
    case MAP:
      return hsp_map_get_info(handle, &out.map);
    case STICKS:
      return hsp_sticks_get_info(handle, &out.sticks);
    case CONTACTS:
      return hsp_contacts_get_complex(handle, &out.contacts);
    case CELLS:
      return hsp_cells_get_counts(handle, &out.cells);
    case PATHS: {
      const int32_t status = hsp_paths_get_points(handle, NULL, 0, &needed);
      return status == HSP_E_CAPACITY ? HSP_OK : status;
    }
    default:
      return hsp_pores_get_counts(handle, &out.pores);
  }
}

static void check_results(int kind, int copy) {
  const slot *s = &slots[kind][copy];
  const int valid = has_results(kind, s);
  computations own;
  uint64_t expected;
  if (s->handle == NULL) return;
  if (!CHECK_EQUAL(first_reading(kind, s->handle), valid ? HSP_OK : HSP_E_STATE) || !valid) return;
  expected = s->of_surface ? known[s->content].mesh_of_surface : known[s->content].hash[kind];
  if (expected == 0) return;
  /* Only hashes of boundaries ask a model and a boundary as well. */
  take_sources(s->content, models[s->copy].handle, slots[BOUNDARY][s->copy].handle, &own);
  CHECK(kinds_of_life[kind].hash(s->handle, source_of(&own, kind), buffer, ROOM) == expected);
}

/* Functions of two handles with results. */
static void check_pairs(int copy, int other) {
  const slot *view = &slots[VIEW][copy], *map = &slots[MAP][other];
  const slot *cells = &slots[CELLS][copy], *topology = &slots[TOPOLOGY][other];
  if (view->handle != NULL && map->handle != NULL) {
    hsp_picture_options options;
    picture_sink sink;
    int32_t expected = HSP_E_STATE;
    if (has_results(VIEW, view)) {
      expected = has_results(MAP, map) && map->source == view->source ? HSP_OK : HSP_E_ARGUMENT;
    }
    CHECK_EQUAL(hsp_picture_options_init(&options, sizeof options), HSP_OK);
    options.ink = map->handle;
    picture_sink_start(&sink, SIZE_MAX);
    CHECK_EQUAL(hsp_picture_write(view->handle, NULL, &options, NULL, NULL, picture_sink_take, &sink, NULL), expected);
    picture_sink_release(&sink);
  }
  if (cells->handle != NULL && topology->handle != NULL) {
    uint32_t invariant, id;
    int32_t expected = HSP_E_STATE;
    if (has_results(CELLS, cells) && has_results(TOPOLOGY, topology)) {
      expected = slots[BOUNDARY][topology->copy].source == cells->source ? HSP_OK : HSP_E_ARGUMENT;
    }
    CHECK_EQUAL(hsp_cells_check(cells->handle, topology->handle, &invariant, &id), expected);
  }
}

/* ---- what is done ---- */

/* From here on its memory holds something else, as after free and malloc. */
static void overwrite(slot *s) {
  if (s->handle != NULL) memset(s->handle, 0x5A, 16);
  s->handle = NULL;
}

/* Before a handle is made: its block, the old one or the other. */
static unsigned char *choose_block(slot *s, uint64_t *seed) {
  if (random_below(seed, 4) == 0) {
    overwrite(s);
    s->which = 1 - s->which;
  }
  return s->block[s->which].block;
}

static void init_model(slot *s, uint64_t *seed) {
  const uint32_t capacity = BALLS + (uint32_t)random_below(seed, MOST_CAPACITY - BALLS + 1);
  hsp_model *model = NULL;
  size_t bytes = 0;
  unsigned char *const block = choose_block(s, seed);
  CHECK_EQUAL(hsp_model_bytes(capacity, &bytes), HSP_OK);
  CHECK_EQUAL(hsp_model_init(block, bytes, capacity, &model), HSP_OK);
  s->handle = model;
  s->content = EMPTY;
}

static void set_model(slot *s, uint64_t *seed) {
  const int content = random_below(seed, CONTENTS);
  const ball_set *set = &known[content].set;
  if (s->handle == NULL) return;
  if (random_below(seed, 8) == 0) {
    double radius[BALLS] = {1, 1, 1, 1, 0};
    radius[BALLS - 1] = NAN;
    CHECK_EQUAL(hsp_model_set(s->handle, BALLS, set->xyz, radius, NULL, NULL), HSP_E_NOT_FINITE);
    s->content = REFUSED;
    return;
  }
  CHECK_EQUAL(hsp_model_set(s->handle, set->n, set->xyz, set->radius, &known[content].options, NULL), HSP_OK);
  s->content = content;
}

/* Balls that move make the other model, perhaps of balls that have moved. */
static void write_moving(const slot *from, slot *to, uint64_t *seed) {
  static const uint32_t ball = 0;
  hsp_moving_limits limits;
  hsp_moving *moving = NULL;
  guarded_memory memory;
  size_t bytes = 0;
  int content = from->content;
  const int32_t expected = from->content == REFUSED ? HSP_E_STATE : HSP_OK;
  if (from->handle == NULL || to->handle == NULL) return;
  CHECK_EQUAL(hsp_moving_limits_init(&limits, sizeof limits, BALLS), HSP_OK);
  CHECK_EQUAL(hsp_moving_bytes(&limits, &bytes), HSP_OK);
  memory = guarded_take(bytes, 3, GUARDED_RANDOM);
  CHECK_EQUAL(hsp_moving_init(memory.block, bytes, &limits, &moving), HSP_OK);
  CHECK_EQUAL(hsp_moving_set(moving, from->handle, NULL, 1, 0, HSP_TANGENT_OVERLAP, NULL, NULL), expected);
  if (content == FIRST && random_below(seed, 2) == 0) {
    CHECK_EQUAL(hsp_moving_move(moving, 1, &ball, known[MOVED].set.xyz, NULL, NULL, NULL), HSP_OK);
    content = MOVED;
    if (random_below(seed, 2) == 0) {
      CHECK_EQUAL(hsp_moving_undo(moving), HSP_OK);
      content = FIRST;
    }
  }
  CHECK_EQUAL(hsp_moving_get_model(moving, to->handle), expected);
  if (expected == HSP_OK) to->content = content;
  guarded_give_back(&memory);
}

/* Limits that suffice, often more than that. */
static void init_handle(int kind, slot *s, uint64_t *seed) {
  const handle_kind *k = kinds_of_life[kind].kind;
  limit_numbers limits = most[kind];
  size_t bytes = 0;
  int which;
  unsigned char *block;
  void *handle = NULL;
  for (which = 1; which < LIMIT_NUMBERS; ++which) {
    limits.number[which] += (uint32_t)random_below(seed, 1 + (int)limits.number[which]);
  }
  if (kind == BOUNDARY) limits.number[5] = (uint32_t)random_below(seed, 4);
  CHECK_EQUAL(k->bytes(&limits, &bytes), HSP_OK);
  if (random_below(seed, 8) == 0) { /* which changes nothing */
    CHECK_EQUAL(k->init(s->block[s->which].block, bytes - 1, &limits, &handle), HSP_E_MEMORY);
    return;
  }
  block = choose_block(s, seed);
  CHECK_EQUAL(k->init(block, bytes, &limits, &handle), HSP_OK);
  s->handle = handle;
  s->complete = 0;
}

/* By two workers, if there is room for them. */
static int32_t compute_in_parts(hsp_boundary *boundary, const hsp_model *model) {
  loop own = loop_of(LOOP_SHUFFLED);
  const hsp_executor executor = executor_of(&own, 2);
  hsp_boundary_request request = {.struct_size = sizeof request};
  hsp_boundary_limits limits = {.struct_size = sizeof limits};
  int32_t status;
  request.executor = &executor;
  status = hsp_boundary_compute_with(boundary, model, &request, &limits);
  return status == HSP_E_CAPACITY && own.runs == 0 ? hsp_boundary_compute(boundary, model, NULL) : status;
}

static void compute(int kind, slot *s, uint64_t *seed) {
  const int copy = random_below(seed, COPIES);
  slot *const source = is_of_boundary(kind) ? &slots[BOUNDARY][copy] : &models[copy];
  const slot *const surface = &slots[SURFACE][random_below(seed, COPIES)];
  const int there =
      source->handle != NULL && (is_of_boundary(kind) ? has_results(BOUNDARY, source) : source->content != REFUSED);
  computations own;
  int32_t status;
  if (s->handle == NULL) return;
  s->complete = 0;
  s->of_surface = 0;
  if (kind == MESH && surface->handle != NULL && random_below(seed, 2) == 0) {
    status = hsp_mesh_compute_surface(s->handle, surface->handle, 1.0, NULL);
    CHECK((status == HSP_E_STATE) == !has_results(SURFACE, surface));
    if (status != HSP_OK) return;
    CHECK(known[surface->content].mesh_of_surface != 0);
    s->copy = surface->copy;
    s->content = surface->content;
    s->source = surface->source;
    s->complete = s->of_surface = 1;
    return;
  }
  /* Memory that is no handle any more is refused. */
  take_sources(there ? source->content : EMPTY, models[copy].handle, slots[BOUNDARY][copy].handle, &own);
  if (kind == BOUNDARY && random_below(seed, 2) == 0) {
    status = compute_in_parts(s->handle, source->handle);
  } else {
    status = kinds_of_life[kind].kind->compute(s->handle, source_of(&own, kind), NULL);
  }
  if (source->handle == NULL) {
    CHECK(status != HSP_OK);
  } else if (!there) {
    CHECK_EQUAL(status, HSP_E_STATE);
  } else if (known[source->content].hash[kind] != 0) {
    CHECK_EQUAL(status, HSP_OK);
  }
  if (status != HSP_OK) return;
  s->copy = copy;
  s->content = source->content;
  s->source = source->handle;
  s->complete = 1;
}

/* Pieces outside all balls need a boundary of that model. */
static void compute_with_boundary(slot *s, uint64_t *seed) {
  const slot *const model = &models[random_below(seed, COPIES)];
  const slot *const boundary = &slots[BOUNDARY][random_below(seed, COPIES)];
  hsp_view_options options;
  int32_t expected = HSP_E_STATE, status;
  if (s->handle == NULL || model->handle == NULL || boundary->handle == NULL) return;
  if (model->content != REFUSED && has_results(BOUNDARY, boundary))
    expected = boundary->source == model->handle ? HSP_OK : HSP_E_ARGUMENT;
  CHECK_EQUAL(hsp_view_options_init(&options, sizeof options), HSP_OK);
  options.pieces = HSP_PIECES_OUTSIDE_ALL;
  status = hsp_view_compute(s->handle, model->handle, boundary->handle, &options, NULL);
  CHECK(status == expected || (expected == HSP_OK && status == HSP_E_CAPACITY));
  /* That has no results, either. */
  CHECK_EQUAL(hsp_view_compute(s->handle, NULL, NULL, NULL, NULL), HSP_E_ARGUMENT);
  s->complete = 0;
}

static void take_memory(void) {
  size_t bytes = 0;
  int kind, copy, which, b;
  for (copy = 0; copy < COPIES; ++copy) {
    for (b = 0; b < 2; ++b) {
      CHECK_EQUAL(hsp_model_bytes(MOST_CAPACITY, &bytes), HSP_OK);
      models[copy].block[b] = guarded_take(bytes, (size_t)(copy + 7 * b), GUARDED_RANDOM);
      for (kind = 0; kind < DEPENDENT_KINDS; ++kind) {
        limit_numbers limits = most[kind];
        for (which = 1; which < LIMIT_NUMBERS; ++which) limits.number[which] *= 2;
        if (kind == BOUNDARY) limits.number[5] = 4;
        CHECK_EQUAL(kinds_of_life[kind].kind->bytes(&limits, &bytes), HSP_OK);
        slots[kind][copy].block[b] = guarded_take(bytes, (size_t)(kind + 5 * copy + 11 * b), GUARDED_RANDOM);
      }
    }
  }
}

static void give_back_memory(void) {
  int kind, copy, b;
  for (copy = 0; copy < COPIES; ++copy) {
    for (b = 0; b < 2; ++b) {
      CHECK(guarded_clean(&models[copy].block[b]));
      guarded_give_back(&models[copy].block[b]);
      for (kind = 0; kind < DEPENDENT_KINDS; ++kind) {
        CHECK(guarded_clean(&slots[kind][copy].block[b]));
        guarded_give_back(&slots[kind][copy].block[b]);
      }
    }
  }
}

/* Something on handles of the kind or on a model. */
static void step(int kind, slot *s, uint64_t *seed) {
  const int action = random_below(seed, 24);
  slot *const model = &models[random_below(seed, COPIES)];
  if (action == 0 || model->handle == NULL) {
    init_model(model, seed);
  } else if (action < 5) {
    set_model(model, seed);
  } else if (action == 5) {
    write_moving(&models[random_below(seed, COPIES)], model, seed);
  } else if (action == 6) {
    overwrite(random_below(seed, 4) == 0 ? model : s);
  } else if (action < 9 || s->handle == NULL) {
    init_handle(kind, s, seed);
  } else if (action < 11) {
    compute(BOUNDARY, &slots[BOUNDARY][random_below(seed, COPIES)], seed);
  } else if (action == 11 && kind == VIEW) {
    compute_with_boundary(s, seed);
  } else {
    compute(kind, s, seed);
  }
}

int main(void) {
  enum { STEPS = 8000 };
  uint64_t seed = 20261124;
  int kind, copy, k, valid[DEPENDENT_KINDS] = {0}, stale[DEPENDENT_KINDS] = {0};
  make_contents();
  compute_contents();
  take_memory();
  for (k = 0; k < STEPS; ++k) {
    kind = random_below(&seed, DEPENDENT_KINDS);
    copy = random_below(&seed, COPIES);
    check_scene("step %d, with %s", k, kinds_of_life[kind].name);
    step(kind, &slots[kind][copy], &seed);
    for (kind = 0; kind < DEPENDENT_KINDS; ++kind) {
      const slot *const s = &slots[kind][copy];
      valid[kind] += has_results(kind, s);
      stale[kind] += s->handle != NULL && s->complete && !has_results(kind, s);
      check_results(kind, copy);
    }
    check_pairs(copy, random_below(&seed, COPIES));
  }
  /* Both must have been there often. */
  for (kind = 0; kind < DEPENDENT_KINDS; ++kind) {
    check_scene("%s", kinds_of_life[kind].name);
    CHECK(valid[kind] > STEPS / 50);
    CHECK(stale[kind] > STEPS / 50);
  }
  give_back_memory();
  return check_report();
}
