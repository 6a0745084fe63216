#include "fixture.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "handle_kind.h"
#include "untouched.h"

/* Six balls around a void, one that crosses one of them alone (a free circle), one inside that, one
 * apart: there are records of every kind. */
const double fixture_xyz[FIXTURE_BALLS][3] = {{1.5, 0, 0},  {-1.5, 0, 0}, {0, 1.5, 0},   {0, -1.5, 0}, {0, 0, 1.5},
                                              {0, 0, -1.5}, {3.4, 0, 0},  {3.4, 0.1, 0}, {0, 0, 7}};
const double fixture_radius[FIXTURE_BALLS] = {1.2, 1.2, 1.2, 1.2, 1.2, 1.2, 0.9, 0.3, 0.8};
const double fixture_box[9] = {12, 0, 0, 0, 12, 0, 0, 0, 12};
const double fixture_outside[3] = {9, 9, 9};
const double fixture_probe = 0.2, fixture_edge = 0.7, fixture_stick_radius = 0.1, fixture_floor = -0.3;
#if HSP_HAS_SIGHT
const hsp_stick fixture_stick = {{0, FIXTURE_STICK_END}, 0, 0};
#endif

fixture given;

static void need(int32_t status, const char *what) {
  if (status == HSP_OK) return;
  printf("the fixture of %u balls: %s: %s\n", (unsigned)given.balls, what, hsp_status_text(status));
  exit(2);
}

/* hsp_<noun><end>, where noun is the type of a handle; NULL if the library has none. */
static const function *function_of(int noun, const char *end) {
  size_t i;
  for (i = 0; i < registry_size; ++i) {
    const function *f = &registry[i];
    const argument *last = f->count > 0 ? &f->arguments[f->count - 1] : NULL;
    if (last != NULL && last->kind == KIND_handle_out && last->noun == noun) {
      const size_t stem = strlen(f->name) - strlen("_init");
      size_t k;
      for (k = 0; k < registry_size; ++k) {
        if (strncmp(registry[k].name, f->name, stem) == 0 && strcmp(registry[k].name + stem, end) == 0)
          return &registry[k];
      }
    }
  }
  return NULL;
}

static value limits_of(int noun, void *limits) {
  value v;
  memset(&v, 0, sizeof v);
  if (noun == NOUN_model || noun == NOUN_body) {
    memcpy(&v.u, limits, sizeof v.u);
  } else {
    v.p = limits;
  }
  return v;
}

int32_t handle_bytes(int noun, void *limits, size_t *bytes) {
  value v[2];
  v[0] = limits_of(noun, limits);
  v[1].p = bytes;
  return (int32_t)function_of(noun, "_bytes")->call(v);
}

int32_t handle_init(int noun, void *memory, size_t bytes, void *limits, void **handle) {
  value v[4];
  v[0].p = memory;
  v[1].z = bytes;
  v[2] = limits_of(noun, limits);
  v[3].p = handle;
  return (int32_t)function_of(noun, "_init")->call(v);
}

int replaces_contents(const function *f) {
  return strstr(f->name, "_compute") != NULL || strstr(f->name, "_set") == f->name + strlen(f->name) - 4 ||
         strstr(f->name, "_set_with") != NULL;
}

int reads_contents(const function *f, int i) {
  const argument *const a = &f->arguments[i];
  if (a->kind != KIND_handle || (i == 0 && replaces_contents(f))) return 0;
  if (a->noun != NOUN_model && a->noun != NOUN_body) return 1;
  if (strcmp(f->name, "hsp_model_get_info") == 0) return 0;
  return a->is_const || strcmp(f->name, "hsp_model_get_packing") == 0;
}

int depends_on(int noun, int base) {
  switch (noun) {
    case NOUN_boundary:
    case NOUN_cells:
    case NOUN_paths:
    case NOUN_pores:
    case NOUN_map:
    case NOUN_sticks:
    case NOUN_view:
      return base == NOUN_model;
    case NOUN_contacts:
    case NOUN_surface:
    case NOUN_mesh:
    case NOUN_topology:
      return base == NOUN_model || base == NOUN_boundary;
    default: /* these keep the balls themselves */
      return 0;
  }
}

/* The first limits to try, with room for the workers of the base arguments' executor and for simplices. */
static int32_t start_limits(int noun, void *limits) {
  static const struct {
    const char *of, *name;
    uint32_t number;
  } raised[] = {{"hsp_boundary_limits", "workers", 2},
                {"hsp_periodic_limits", "workers", 2},
                {"hsp_contacts_limits", "triangles", 64},
                {"hsp_contacts_limits", "tetrahedra", 64}};
  const function *const f = function_of(noun, "_limits_init");
  value v[4];
  int32_t status;
  size_t i, k;
  if (f == NULL) { /* a model or a body */
    memcpy(limits, &given.balls, sizeof given.balls);
    return HSP_OK;
  }
  v[0].p = limits;
  v[1].u = (uint32_t)f->arguments[0].size;
  if (f->arguments[2].kind == KIND_handle) {
    v[2].p = given.handle[f->arguments[2].noun];
  } else {
    v[2].u = given.balls;
  }
  v[3].d = fixture_edge;
  status = (int32_t)f->call(v);
  for (i = 0; i < sizeof raised / sizeof raised[0]; ++i) {
    for (k = 0; k < registry_fields_size && strcmp(raised[i].of, f->arguments[0].base) == 0; ++k) {
      const field *const it = &registry_fields[k];
      if (strcmp(it->of, raised[i].of) == 0 && strcmp(it->name, raised[i].name) == 0)
        memcpy((unsigned char *)limits + it->offset, &raised[i].number, sizeof raised[i].number);
    }
  }
  return status;
}

/* The laws are there with all components or with none. */
#if HSP_HAS_SIGHT
static int32_t larger_status(int32_t a, int32_t b) {
  return a != HSP_OK ? a : b;
}

static int32_t compute_of_component(int noun, void *handle, void *limits) {
  static const double there[3] = {0, 0, 5.4};
  const hsp_model *const model = given.handle[NOUN_model];
  const hsp_boundary *const boundary = given.handle[NOUN_boundary];
  const uint32_t n = given.balls, sticks = n > FIXTURE_STICK_END, last = FIXTURE_BALLS - 1;
  hsp_path path;
  hsp_tunnel tunnel;
  hsp_pores_options below;
  uint32_t pockets;
  int32_t status;
  switch (noun) {
    case NOUN_body:
      return hsp_body_set(handle, model);
    case NOUN_moving:
      status = hsp_moving_set(handle, model, NULL, 1, 0, HSP_TANGENT_OVERLAP, limits, NULL);
      if (status != HSP_OK || n < FIXTURE_BALLS) return status;
      return hsp_moving_move(handle, 1, &last, there, NULL, limits, NULL); /* a move to be taken back */
    case NOUN_periodic:
      return hsp_periodic_compute(handle, n, fixture_xyz[0], fixture_radius, fixture_box, NULL, limits, NULL);
    case NOUN_surface:
      return hsp_surface_compute(handle, boundary, limits);
    case NOUN_mesh: /* with room for either */
      status = hsp_mesh_compute_surface(handle, given.handle[NOUN_surface], fixture_edge, limits);
      return larger_status(status, hsp_mesh_compute(handle, boundary, fixture_edge, status == HSP_OK ? limits : NULL));
    case NOUN_cells:
      return hsp_cells_compute(handle, model, limits);
    case NOUN_paths:
      status = hsp_paths_compute(handle, model, limits);
      return status != HSP_OK ? status : hsp_paths_find(handle, fixture_outside, there, &path, limits);
    case NOUN_pores: /* down to where there are gates of the void, with tunnel, pocket and regions */
      need(hsp_pores_options_init(&below, sizeof below), "options");
      below.floor = fixture_floor;
      status = hsp_pores_compute_periodic(handle, given.handle[NOUN_periodic], &below, limits);
      status = larger_status(status, hsp_pores_compute(handle, model, &below, status == HSP_OK ? limits : NULL));
      if (status == HSP_OK) status = hsp_pores_find_pockets(handle, 0, 0, &pockets);
      if (status == HSP_OK) status = hsp_pores_find_regions(handle, boundary, NULL, NULL);
      return status != HSP_OK ? status : hsp_pores_find_tunnel(handle, fixture_outside, NULL, NULL, 0, &tunnel, limits);
    case NOUN_view:
      return hsp_view_compute(handle, model, boundary, NULL, limits);
    case NOUN_map:
      return hsp_map_compute(handle, model, NULL, limits);
    default:
      status = hsp_sticks_compute(handle, model, NULL, &fixture_stick, sticks, fixture_stick_radius, NULL, limits);
      if (status != HSP_OK) return status;
      return hsp_sticks_compute_map(handle, model, NULL, &fixture_stick, sticks, fixture_stick_radius, NULL, limits);
  }
}
#else
static int32_t compute_of_component(int noun, void *handle, void *limits) {
  (void)noun;
  (void)handle;
  (void)limits;
  return HSP_E_CHECK;
}
#endif

static int32_t compute(int noun, void *handle, void *limits) {
  hsp_model_options options;
  switch (noun) {
    case NOUN_model:
      need(hsp_model_options_init(&options, sizeof options), "options");
      options.probe = fixture_probe;
      return hsp_model_set(handle, given.balls, fixture_xyz[0], fixture_radius, &options, NULL);
    case NOUN_boundary:
      return hsp_boundary_compute(handle, given.handle[NOUN_model], limits);
    case NOUN_contacts:
      return hsp_contacts_compute(handle, given.handle[NOUN_boundary], limits);
    case NOUN_topology:
      return hsp_topology_compute(handle, given.handle[NOUN_boundary], limits);
    default:
      return compute_of_component(noun, handle, limits);
  }
}

static void *empty_handle(int noun, void **memory) {
  void *handle = NULL;
  *memory = test_zeros(given.bytes[noun], 1);
  need(handle_init(noun, *memory, given.bytes[noun], given.limits[noun], &handle), "init");
  return handle;
}

/* In memory that grows until it suffices. */
static void make(int noun) {
  unsigned char next[LIMIT_BYTES];
  int32_t status;
  if (function_of(noun, "_init") == NULL) return;
  need(start_limits(noun, given.limits[noun]), "limits_init");
  for (;;) {
    need(handle_bytes(noun, given.limits[noun], &given.bytes[noun]), "bytes");
    given.handle[noun] = empty_handle(noun, &given.memory[noun]);
    memcpy(next, given.limits[noun], LIMIT_BYTES);
    status = compute(noun, given.handle[noun], next);
    if (status != HSP_E_CAPACITY) break;
    memcpy(given.limits[noun], next, LIMIT_BYTES);
    free(given.memory[noun]);
  }
  need(status, "compute");
  given.fresh[noun] = empty_handle(noun, &given.fresh_memory[noun]);
}

static void release(void) {
  int i;
  for (i = 0; i < NOUNS; ++i) {
    free(given.memory[i]);
    free(given.fresh_memory[i]);
    free(given.refused_memory[i]);
  }
  for (i = 0; i < 2; ++i) free(given.spare_memory[i]);
  for (i = 0; i < 3; ++i) free(given.summary[i]);
  memset(&given, 0, sizeof given);
}

#if HSP_HAS_SIGHT
/* Makes the summary of one of `bricks` bricks. Ball i belongs to brick i % bricks; each model has all balls. */
static void summarise(int which, uint32_t brick, uint32_t bricks, uint32_t flags) {
  uint64_t id[FIXTURE_BALLS];
  uint32_t owner[FIXTURE_BALLS], i;
  hsp_brick_request request;
  size_t bytes = 0;
  for (i = 0; i < FIXTURE_BALLS; ++i) {
    id[i] = i;
    owner[i] = i % bricks;
  }
  memset(&request, 0, sizeof request);
  request.struct_size = sizeof request;
  request.brick = brick;
  request.bricks = bricks;
  request.flags = flags;
  request.id = id;
  request.owner = owner;
  while (hsp_brick_summarise(given.handle[NOUN_boundary], &request, given.summary[which], &bytes, NULL) ==
         HSP_E_CAPACITY) {
    free(given.summary[which]);
    given.summary[which] = test_zeros(bytes, 1);
  }
  given.summary_bytes[which] = bytes;
}

static void make_of_components(void) {
  summarise(0, 0, 1, HSP_BRICK_KEEP_SHELLS);
  summarise(1, 0, 2, 0);
  summarise(2, 1, 2, 0);
  given.moving_body = empty_handle(NOUN_body, &given.spare_memory[1]);
  need(compute(NOUN_body, given.moving_body, NULL), "the body that moves");
  given.refused[NOUN_body] = empty_handle(NOUN_body, &given.refused_memory[NOUN_body]);
  if (hsp_body_set(given.refused[NOUN_body], NULL) != HSP_E_ARGUMENT) need(HSP_E_CHECK, "what is refused");
}
#else
static void make_of_components(void) {}
#endif

void fixture_make(uint32_t balls) {
  int noun;
  release();
  given.balls = balls;
  for (noun = NOUN_none + 1; noun < NOUNS; ++noun) make(noun);
  make_of_components();
  given.spare_model = empty_handle(NOUN_model, &given.spare_memory[0]);
  given.refused[NOUN_model] = empty_handle(NOUN_model, &given.refused_memory[NOUN_model]);
  if (hsp_model_set(given.refused[NOUN_model], 1, NULL, NULL, NULL, NULL) != HSP_E_ARGUMENT)
    need(HSP_E_CHECK, "what is refused");
}

void fixture_make_again(int noun) {
  void *handle = NULL;
  need(handle_init(noun, given.memory[noun], given.bytes[noun], given.limits[noun], &handle), "init again");
  need(compute(noun, handle, NULL), "compute again");
}

void fixture_set_model(void) {
  need(compute(NOUN_model, given.handle[NOUN_model], NULL), "the same balls again");
}

void fixture_set_other_balls(void) {
  need(hsp_model_set(given.handle[NOUN_model], given.balls, fixture_xyz[0], fixture_radius, NULL, NULL), "other balls");
}
