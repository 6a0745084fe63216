/* Base arguments by name: numbers, texts, arrays, structs. */
#include <string.h>

#include "call.h"

static const struct {
  const char *name;
  double value;
} numbers[] = {
    {"count", 1},         {"poses", 2},     {"tension", 1}, {"pressure", 0.5},  {"radius", 0.1},
    {"margin", 1},        {"workers", 1},   {"first", 1},   {"face", 1},        {"dimension", 2},
    {"atomic_number", 6}, {"patches", 100}, {"shell", 0},   {"x", 0.3},         {"y", 0.2},
    {"z", 0.1},           {"narrow", 0.1},  {"wide", 1},    {"bending", 1},     {"gaussian", 1},
    {"full_width", 2},    {"gap", 1},       {"nearest", 1}, {"mean_radius", 1}, {"bricks", 1},
};

static double number_named(const argument *a) {
  size_t k;
  if (strcmp(a->name, "n") == 0 || strcmp(a->name, "balls") == 0) return given.balls;
  if (strcmp(a->name, "edge_length") == 0) return fixture_edge;
  for (k = 0; k < sizeof numbers / sizeof numbers[0]; ++k) {
    if (strcmp(numbers[k].name, a->name) == 0) return numbers[k].value;
  }
  return 0;
}

const char *base_text(const argument *a) {
  if (strcmp(a->name, "residue") == 0) return "ALA";
  return strcmp(a->name, "atom") == 0 ? "CA" : "c";
}

static double number_of_array(const argument *a, size_t i, size_t count) {
  static const double identity[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const char *const n = a->name;
  if (strcmp(n, "xyz") == 0 && count > 3) return fixture_xyz[i / 3 % FIXTURE_BALLS][i % 3];
  if (strcmp(n, "xyz") == 0) return i == 2 ? 6.5 : 0.2; /* in the last ball */
  if (strcmp(n, "radius") == 0) return count > 1 ? fixture_radius[i % FIXTURE_BALLS] : 0.7;
  if (strcmp(n, "box") == 0) return fixture_box[i];
  if (strcmp(n, "matrix") == 0) return identity[i];
  if (strcmp(n, "from") == 0 || strcmp(n, "to") == 0 || strcmp(n, "origin") == 0) return fixture_outside[i];
  if (strcmp(n, "direction") == 0) return -1;
  return 0.25;
}

static void fill_struct(const char *base, void *out, size_t size) {
#if HSP_HAS_SIGHT
  static const hsp_pose pose = {{1, 0, 0, 0}, {0.5, 0, 0}};
  static const hsp_rational_pose rational = {{1, 0, 0, 0}, {0.5, 0, 0}};
  if (strcmp(base, "hsp_pose") == 0) memcpy(out, &pose, size);
  if (strcmp(base, "hsp_rational_pose") == 0) memcpy(out, &rational, size);
  if (strcmp(base, "hsp_stick") == 0) memcpy(out, &fixture_stick, size);
#else
  (void)base;
  (void)out;
  (void)size;
#endif
}

/* All tasks in the caller's thread, the last first. */
static int32_t run_tasks(void *context, uint32_t tasks, hsp_task *task, void *data) {
  (void)context;
  while (tasks > 0) task(data, --tasks);
  return 0;
}

/* Limits are those that the fixture's handles were made with. */
static void fill_sized(const argument *a, void *out) {
  static const char *const limits_of[NOUNS] = {
      [NOUN_boundary] = "hsp_boundary_limits", [NOUN_moving] = "hsp_moving_limits",
      [NOUN_contacts] = "hsp_contacts_limits", [NOUN_periodic] = "hsp_periodic_limits",
      [NOUN_surface] = "hsp_surface_limits",   [NOUN_mesh] = "hsp_mesh_limits",
      [NOUN_topology] = "hsp_topology_limits", [NOUN_cells] = "hsp_cells_limits",
      [NOUN_paths] = "hsp_paths_limits",       [NOUN_pores] = "hsp_pores_limits",
      [NOUN_view] = "hsp_view_limits",         [NOUN_map] = "hsp_map_limits",
      [NOUN_sticks] = "hsp_sticks_limits"};
  static const hsp_executor executor = {sizeof executor, 2, NULL, run_tasks, NULL};
  const uint32_t size = (uint32_t)a->size;
  int noun;
  memset(out, 0, a->size);
  memcpy(out, &size, sizeof size);
  for (noun = 0; noun < NOUNS; ++noun) {
    if (limits_of[noun] != NULL && strcmp(limits_of[noun], a->base) == 0) memcpy(out, given.limits[noun], a->size);
  }
  if (strcmp(a->base, "hsp_executor") == 0) memcpy(out, &executor, sizeof executor);
  if (strcmp(a->base, "hsp_model_options") == 0) hsp_model_options_init(out, sizeof(hsp_model_options));
#if HSP_HAS_SIGHT
  if (strcmp(a->base, "hsp_view_options") == 0) hsp_view_options_init(out, sizeof(hsp_view_options));
  if (strcmp(a->base, "hsp_pores_options") == 0) hsp_pores_options_init(out, sizeof(hsp_pores_options));
  if (strcmp(a->base, "hsp_picture_options") == 0) {
    hsp_picture_options options;
    hsp_picture_options_init(&options, sizeof options);
    options.scale = 20;
    memcpy(out, &options, sizeof options);
  }
#endif
}

/* Which summary of the fixture an argument is, or the number of its bytes. */
static int summary_named(const char *name) {
  return name[0] == 'a' ? 1 : name[0] == 'b' && strcmp(name, "bytes") != 0 ? 2 : 0;
}

void fill_base(const argument *a, void *out, size_t count) {
  size_t i;
  if (is_sized(a)) {
    fill_sized(a, out);
  } else if (strcmp(a->base, "uint8_t") == 0 && strcmp(a->name, "selected") != 0) {
    memcpy(out, given.summary[summary_named(a->name)], count);
  } else if (strcmp(a->name, "id") == 0) { /* ascending */
    for (i = 0; i < count; ++i) {
      const uint64_t id = i;
      memcpy((unsigned char *)out + i * sizeof id, &id, sizeof id);
    }
  } else if (strcmp(a->base, "double") == 0) {
    for (i = 0; i < count; ++i) {
      const double number = number_of_array(a, i, count);
      memcpy((unsigned char *)out + i * sizeof number, &number, sizeof number);
    }
  } else if (strncmp(a->base, "hsp_", 4) == 0) {
    memset(out, 0, count * a->size);
    for (i = 0; i < count; ++i) fill_struct(a->base, (unsigned char *)out + i * a->size, a->size);
  } else {
    memset(out, 0, count * a->size);
  }
}

#if HSP_HAS_SIGHT
/* A parameter of edge 0 of a map, if that has edges. */
static double parameter_on_edge(const function *f) {
  hsp_map_edge edge;
  const int32_t status = f->arguments[0].noun == NOUN_sticks
                             ? hsp_sticks_get_edges(given.handle[NOUN_sticks], 0, 1, &edge)
                             : hsp_map_get_edges(given.handle[NOUN_map], 0, 1, &edge);
  return status == HSP_OK ? edge.from + 0.25 * (edge.to - edge.from) : 0;
}

/* Whether it reads pores, of which the fixture has one maximum. */
static int is_of_pores(const function *f) {
  return f->count > 0 && f->arguments[0].noun == NOUN_pores && f->arguments[0].kind == KIND_handle;
}

static double number_for(const function *f, const argument *a) {
  return strcmp(a->name, "t") == 0                         ? parameter_on_edge(f)
         : strcmp(f->noun, "residue") == 0                 ? HSP_RADII_PROTOR
         : is_of_pores(f) && strcmp(a->name, "first") == 0 ? 0
                                                           : number_named(a);
}
#else
static double number_for(const function *f, const argument *a) {
  (void)f;
  return number_named(a);
}
#endif

value base_number(const function *f, int i) {
  const argument *const a = &f->arguments[i];
  const double number = number_for(f, a);
  value v;
  memset(&v, 0, sizeof v);
  if (strcmp(a->base, "double") == 0) {
    v.d = number;
  } else if (strcmp(a->base, "size_t") == 0 && strcmp(f->noun, "bricks") == 0) {
    v.z = given.summary_bytes[summary_named(a->name)];
  } else if (strcmp(a->base, "size_t") == 0) { /* of the memory for a handle */
    v.z = given.bytes[f->arguments[place_of_kind(f, KIND_handle_out)].noun];
  } else if (strcmp(a->name, "struct_size") == 0) {
    v.u = (uint32_t)f->arguments[i - 1].size;
  } else if (strcmp(a->base, "int32_t") == 0) {
    v.i = (int32_t)number;
  } else {
    v.u = (uint32_t)number;
  }
  return v;
}
