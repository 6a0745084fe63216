/* Structs of other versions of the header. A program with a newer one passes more bytes than the library knows: zeros
 * there are taken, anything else is refused. Nothing is written beyond struct_size, and what the library writes into a
 * larger struct ends with zeros. */
#include <hardsphere.h>
#include <string.h>

#include "check.h"
#include "four_handles.h"
#include "untouched.h"

enum { LARGEST = 1024, ROOM = LARGEST + 64 };

/* A struct of any size; the first word is struct_size. */
typedef union struct_version {
  unsigned char bytes[ROOM];
  uint32_t struct_size;
  double alignment;
} struct_version;

static four_handles h;
static unsigned char other_memory[2 * SIZE], surface_memory[SIZE], mesh_memory[1 << 18];
static hsp_surface *surface;
static hsp_mesh *mesh;
static hsp_map *map;
static hsp_sticks *sticks;
static hsp_contacts *contacts;
static hsp_cells *cells;
static hsp_paths *paths;
static hsp_gate *gate;
static unsigned char cells_memory[1 << 19];

static int32_t ignore_bytes(void *context, const char *bytes, size_t count) {
  (void)context;
  (void)bytes;
  (void)count;
  return 0;
}

/* ---- structs that the library reads ---- */

static int32_t read_model_options(const void *given) {
  return hsp_model_set(h.model, BALLS, four_xyz, four_radius, given, NULL);
}
static int32_t read_boundary_limits(const void *given) {
  size_t bytes = 0;
  hsp_boundary *made = NULL;
  const int32_t status = hsp_boundary_bytes(given, &bytes);
  CHECK_EQUAL(hsp_boundary_init(other_memory, sizeof other_memory, given, &made), status);
  return status;
}
static int32_t read_surface_limits(const void *given) {
  size_t bytes = 0;
  hsp_surface *made = NULL;
  const int32_t status = hsp_surface_bytes(given, &bytes);
  CHECK_EQUAL(hsp_surface_init(other_memory, sizeof other_memory, given, &made), status);
  return status;
}
static int32_t read_mesh_limits(const void *given) {
  size_t bytes = 0;
  hsp_mesh *made = NULL;
  const int32_t status = hsp_mesh_bytes(given, &bytes);
  CHECK_EQUAL(hsp_mesh_init(mesh_memory, sizeof mesh_memory, given, &made), status);
  return status;
}
static int32_t read_topology_limits(const void *given) {
  size_t bytes = 0;
  hsp_topology *made = NULL;
  const int32_t status = hsp_topology_bytes(given, &bytes);
  CHECK_EQUAL(hsp_topology_init(other_memory, sizeof other_memory, given, &made), status);
  return status;
}
static int32_t read_contacts_limits(const void *given) {
  size_t bytes = 0;
  hsp_contacts *made = NULL;
  const int32_t status = hsp_contacts_bytes(given, &bytes);
  CHECK_EQUAL(hsp_contacts_init(other_memory, sizeof other_memory, given, &made), status);
  return status;
}
static int32_t read_view_limits(const void *given) {
  size_t bytes = 0;
  hsp_view *made = NULL;
  const int32_t status = hsp_view_bytes(given, &bytes);
  CHECK_EQUAL(hsp_view_init(other_memory, sizeof other_memory, given, &made), status);
  return status;
}
static int32_t read_map_limits(const void *given) {
  size_t bytes = 0;
  hsp_map *made = NULL;
  const int32_t status = hsp_map_bytes(given, &bytes);
  CHECK_EQUAL(hsp_map_init(other_memory, sizeof other_memory, given, &made), status);
  return status;
}
static int32_t read_sticks_limits(const void *given) {
  size_t bytes = 0;
  hsp_sticks *made = NULL;
  const int32_t status = hsp_sticks_bytes(given, &bytes);
  CHECK_EQUAL(hsp_sticks_init(other_memory, sizeof other_memory, given, &made), status);
  return status;
}
static int32_t read_cells_limits(const void *given) {
  size_t bytes = 0;
  hsp_cells *made = NULL;
  const int32_t status = hsp_cells_bytes(given, &bytes);
  CHECK_EQUAL(hsp_cells_init(cells_memory, sizeof cells_memory, given, &made), status);
  return status;
}
static int32_t read_paths_limits(const void *given) {
  size_t bytes = 0;
  hsp_paths *made = NULL;
  const int32_t status = hsp_paths_bytes(given, &bytes);
  CHECK_EQUAL(hsp_paths_init(cells_memory, sizeof cells_memory, given, &made), status);
  return status;
}
static int32_t read_gate_limits(const void *given) {
  size_t bytes = 0;
  hsp_gate *made = NULL;
  const int32_t status = hsp_gate_bytes(given, &bytes);
  CHECK_EQUAL(hsp_gate_init(cells_memory, sizeof cells_memory, given, &made), status);
  return status;
}
static int32_t read_periodic_limits(const void *given) {
  size_t bytes = 0;
  hsp_periodic *made = NULL;
  const int32_t status = hsp_periodic_bytes(given, &bytes);
  CHECK_EQUAL(hsp_periodic_init(cells_memory, sizeof cells_memory, given, &made), status);
  return status;
}
static int32_t read_moving_limits(const void *given) {
  size_t bytes = 0;
  hsp_moving *made = NULL;
  const int32_t status = hsp_moving_bytes(given, &bytes);
  CHECK_EQUAL(hsp_moving_init(cells_memory, sizeof cells_memory, given, &made), status);
  return status;
}
static int32_t read_view_options(const void *given) {
  return hsp_view_compute(h.view, h.model, NULL, given, NULL);
}
static int32_t read_picture_options(const void *given) {
  return hsp_picture_write(h.view, NULL, given, NULL, NULL, ignore_bytes, NULL, NULL);
}

/* ---- structs that the library writes ---- */

static int32_t write_model_options(void *out, uint32_t size) {
  return hsp_model_options_init(out, size);
}
static int32_t write_view_options(void *out, uint32_t size) {
  return hsp_view_options_init(out, size);
}
static int32_t write_picture_options(void *out, uint32_t size) {
  return hsp_picture_options_init(out, size);
}
static int32_t write_boundary_limits(void *out, uint32_t size) {
  return hsp_boundary_limits_init(out, size, BALLS);
}
static int32_t write_surface_limits(void *out, uint32_t size) {
  return hsp_surface_limits_init(out, size, h.boundary);
}
static int32_t write_mesh_limits(void *out, uint32_t size) {
  return hsp_mesh_limits_init(out, size, h.boundary, 1.0);
}
static int32_t write_surface_mesh_limits(void *out, uint32_t size) {
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_surface_compute(surface, h.boundary, NULL), HSP_OK);
  return hsp_mesh_limits_init_surface(out, size, surface, 1.0);
}
static int32_t write_topology_limits(void *out, uint32_t size) {
  return hsp_topology_limits_init(out, size, h.boundary);
}
static int32_t write_contacts_limits(void *out, uint32_t size) {
  return hsp_contacts_limits_init(out, size, h.boundary);
}
static int32_t write_view_limits(void *out, uint32_t size) {
  return hsp_view_limits_init(out, size, BALLS);
}
static int32_t write_map_limits(void *out, uint32_t size) {
  return hsp_map_limits_init(out, size, BALLS);
}
static int32_t write_sticks_limits(void *out, uint32_t size) {
  return hsp_sticks_limits_init(out, size, BALLS);
}

static int32_t write_cells_limits(void *out, uint32_t size) {
  return hsp_cells_limits_init(out, size, BALLS);
}

static int32_t write_paths_limits(void *out, uint32_t size) {
  return hsp_paths_limits_init(out, size, BALLS);
}

static int32_t write_gate_limits(void *out, uint32_t size) {
  return hsp_gate_limits_init(out, size, BALLS);
}

static int32_t write_periodic_limits(void *out, uint32_t size) {
  return hsp_periodic_limits_init(out, size, BALLS);
}

static int32_t write_moving_limits(void *out, uint32_t size) {
  return hsp_moving_limits_init(out, size, BALLS);
}

/* The size comes with the struct where a computation hands limits back. */
static int32_t return_boundary_limits(void *out, uint32_t size) {
  memcpy(out, &size, sizeof size);
  return hsp_boundary_compute(h.boundary, h.model, out);
}
static int32_t return_surface_limits(void *out, uint32_t size) {
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  memcpy(out, &size, sizeof size);
  return hsp_surface_compute(surface, h.boundary, out);
}
static int32_t return_mesh_limits(void *out, uint32_t size) {
  const hsp_mesh_limits of_mesh = {(uint32_t)sizeof of_mesh, BALLS, 64, 400, 800, 200};
  CHECK_EQUAL(hsp_mesh_init(mesh_memory, sizeof mesh_memory, &of_mesh, &mesh), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  memcpy(out, &size, sizeof size);
  return hsp_mesh_compute(mesh, h.boundary, 1.0, out);
}
static int32_t return_contacts_limits(void *out, uint32_t size) {
  static unsigned char memory[HSP_CONTACTS_BYTES(BALLS, 8, 16, 0, 0)];
  const hsp_contacts_limits of_contacts = {(uint32_t)sizeof of_contacts, BALLS, 8, 16, 0, 0};
  CHECK_EQUAL(hsp_contacts_init(memory, sizeof memory, &of_contacts, &contacts), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  memcpy(out, &size, sizeof size);
  return hsp_contacts_compute(contacts, h.boundary, out);
}
static int32_t return_topology_limits(void *out, uint32_t size) {
  CHECK_EQUAL(hsp_boundary_compute(h.boundary, h.model, NULL), HSP_OK);
  memcpy(out, &size, sizeof size);
  return hsp_topology_compute(h.topology, h.boundary, out);
}
static int32_t return_map_limits(void *out, uint32_t size) {
  const hsp_map_limits of_map = {(uint32_t)sizeof of_map, BALLS, BALLS, 64};
  CHECK_EQUAL(hsp_map_init(other_memory, sizeof other_memory, &of_map, &map), HSP_OK);
  memcpy(out, &size, sizeof size);
  return hsp_map_compute(map, h.model, NULL, out);
}
/* Of an empty model, which no limit is too small for. */
static int32_t return_sticks_limits(void *out, uint32_t size) {
  static unsigned char memory[HSP_MODEL_BYTES(0)];
  const hsp_sticks_limits of_sticks = {(uint32_t)sizeof of_sticks, BALLS, BALLS, 64, 0};
  hsp_model *empty = NULL;
  CHECK_EQUAL(hsp_model_init(memory, sizeof memory, 0, &empty), HSP_OK);
  CHECK_EQUAL(hsp_model_set(empty, 0, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_sticks_init(other_memory, sizeof other_memory, &of_sticks, &sticks), HSP_OK);
  memcpy(out, &size, sizeof size);
  return hsp_sticks_compute(sticks, empty, NULL, NULL, 0, 0.5, NULL, out);
}
static int32_t return_cells_limits(void *out, uint32_t size) {
  hsp_cells_limits of_cells;
  CHECK_EQUAL(hsp_cells_limits_init(&of_cells, (uint32_t)sizeof of_cells, BALLS), HSP_OK);
  CHECK_EQUAL(hsp_cells_init(cells_memory, sizeof cells_memory, &of_cells, &cells), HSP_OK);
  memcpy(out, &size, sizeof size);
  return hsp_cells_compute(cells, h.model, out);
}
static int32_t return_paths_limits(void *out, uint32_t size) {
  hsp_paths_limits of_paths;
  CHECK_EQUAL(hsp_paths_limits_init(&of_paths, (uint32_t)sizeof of_paths, BALLS), HSP_OK);
  CHECK_EQUAL(hsp_paths_init(cells_memory, sizeof cells_memory, &of_paths, &paths), HSP_OK);
  memcpy(out, &size, sizeof size);
  return hsp_paths_compute(paths, h.model, out);
}
static int32_t return_found_limits(void *out, uint32_t size) {
  static const double away[3] = {50, 50, 50};
  hsp_paths_limits of_paths;
  hsp_path path;
  CHECK_EQUAL(hsp_paths_limits_init(&of_paths, (uint32_t)sizeof of_paths, BALLS), HSP_OK);
  CHECK_EQUAL(hsp_paths_init(cells_memory, sizeof cells_memory, &of_paths, &paths), HSP_OK);
  CHECK_EQUAL(hsp_paths_compute(paths, h.model, NULL), HSP_OK);
  memcpy(out, &size, sizeof size);
  return hsp_paths_find(paths, away, away, &path, out);
}
static int32_t return_gate_limits(void *out, uint32_t size) {
  static const double away[3] = {50, 50, 50};
  hsp_gate_limits of_gate;
  CHECK_EQUAL(hsp_gate_limits_init(&of_gate, (uint32_t)sizeof of_gate, BALLS), HSP_OK);
  CHECK_EQUAL(hsp_gate_init(cells_memory, sizeof cells_memory, &of_gate, &gate), HSP_OK);
  memcpy(out, &size, sizeof size);
  return hsp_gate_compute(gate, h.model, away, NULL, out);
}
static int32_t return_periodic_limits(void *out, uint32_t size) {
  static const double box[9] = {40, 0, 0, 0, 40, 0, 0, 0, 40};
  hsp_periodic *periodic = NULL;
  hsp_periodic_limits limits;
  CHECK_EQUAL(hsp_periodic_limits_init(&limits, (uint32_t)sizeof limits, BALLS), HSP_OK);
  CHECK_EQUAL(hsp_periodic_init(cells_memory, sizeof cells_memory, &limits, &periodic), HSP_OK);
  memcpy(out, &size, sizeof size);
  return hsp_periodic_compute(periodic, BALLS, four_xyz, four_radius, NULL, box, out, NULL);
}
static hsp_moving *make_moving(void) {
  hsp_moving *moving = NULL;
  hsp_moving_limits limits;
  CHECK_EQUAL(hsp_moving_limits_init(&limits, (uint32_t)sizeof limits, BALLS), HSP_OK);
  CHECK_EQUAL(hsp_moving_init(cells_memory, sizeof cells_memory, &limits, &moving), HSP_OK);
  return moving;
}
static int32_t return_moving_limits(void *out, uint32_t size) {
  hsp_moving *const moving = make_moving();
  memcpy(out, &size, sizeof size);
  return hsp_moving_set(moving, h.model, NULL, 1, 0, HSP_TANGENT_OVERLAP, out, NULL);
}
static int32_t return_limits_of_move(void *out, uint32_t size) {
  const uint32_t ball = 0;
  hsp_moving *const moving = make_moving();
  CHECK_EQUAL(hsp_moving_set(moving, h.model, NULL, 1, 0, HSP_TANGENT_OVERLAP, NULL, NULL), HSP_OK);
  memcpy(out, &size, sizeof size);
  return hsp_moving_move(moving, 1, &ball, four_xyz + 3, NULL, out, NULL);
}
static int32_t return_view_limits(void *out, uint32_t size) {
  memcpy(out, &size, sizeof size);
  return hsp_view_compute(h.view, h.model, NULL, NULL, out);
}

static const struct versioned {
  const char *name;
  uint32_t size, earlier; /* in this header, and in an earlier one */
  int32_t (*read)(const void *given);
  int32_t (*write[3])(void *out, uint32_t size);
} structs[] = {
    {"hsp_model_options",
     sizeof(hsp_model_options),
     24, /* before largest_radius */
     read_model_options,
     {write_model_options, NULL, NULL}},
    {"hsp_boundary_limits",
     sizeof(hsp_boundary_limits),
     sizeof(hsp_boundary_limits),
     read_boundary_limits,
     {write_boundary_limits, return_boundary_limits, NULL}},
    {"hsp_surface_limits",
     sizeof(hsp_surface_limits),
     sizeof(hsp_surface_limits),
     read_surface_limits,
     {write_surface_limits, return_surface_limits, NULL}},
    {"hsp_mesh_limits",
     sizeof(hsp_mesh_limits),
     sizeof(hsp_mesh_limits),
     read_mesh_limits,
     {write_mesh_limits, return_mesh_limits, write_surface_mesh_limits}},
    {"hsp_contacts_limits",
     sizeof(hsp_contacts_limits),
     sizeof(hsp_contacts_limits),
     read_contacts_limits,
     {write_contacts_limits, return_contacts_limits, NULL}},
    {"hsp_topology_limits",
     sizeof(hsp_topology_limits),
     sizeof(hsp_topology_limits),
     read_topology_limits,
     {write_topology_limits, return_topology_limits, NULL}},
    {"hsp_view_limits",
     sizeof(hsp_view_limits),
     sizeof(hsp_view_limits),
     read_view_limits,
     {write_view_limits, return_view_limits, NULL}},
    {"hsp_map_limits",
     sizeof(hsp_map_limits),
     sizeof(hsp_map_limits),
     read_map_limits,
     {write_map_limits, return_map_limits, NULL}},
    {"hsp_sticks_limits",
     sizeof(hsp_sticks_limits),
     sizeof(hsp_sticks_limits),
     read_sticks_limits,
     {write_sticks_limits, return_sticks_limits, NULL}},
    {"hsp_cells_limits",
     sizeof(hsp_cells_limits),
     sizeof(hsp_cells_limits),
     read_cells_limits,
     {write_cells_limits, return_cells_limits, NULL}},
    {"hsp_paths_limits",
     sizeof(hsp_paths_limits),
     sizeof(hsp_paths_limits),
     read_paths_limits,
     {write_paths_limits, return_paths_limits, return_found_limits}},
    {"hsp_gate_limits",
     sizeof(hsp_gate_limits),
     sizeof(hsp_gate_limits),
     read_gate_limits,
     {write_gate_limits, return_gate_limits, NULL}},
    {"hsp_periodic_limits",
     sizeof(hsp_periodic_limits),
     sizeof(hsp_periodic_limits),
     read_periodic_limits,
     {write_periodic_limits, return_periodic_limits, NULL}},
    {"hsp_moving_limits",
     sizeof(hsp_moving_limits),
     sizeof(hsp_moving_limits),
     read_moving_limits,
     {write_moving_limits, return_moving_limits, return_limits_of_move}},
    {"hsp_view_options",
     sizeof(hsp_view_options),
     sizeof(hsp_view_options),
     read_view_options,
     {write_view_options, NULL, NULL}},
    {"hsp_picture_options",
     sizeof(hsp_picture_options),
     72, /* before scale */
     read_picture_options,
     {write_picture_options, NULL, NULL}},
};
enum { STRUCTS = sizeof structs / sizeof structs[0] };

static int is_good_size(const struct versioned *s, uint32_t size) {
  return size == s->size || size == s->earlier || (size > s->size && size <= LARGEST && size % 4 == 0);
}

static void check_reading(const struct versioned *s) {
  uint32_t size;
  for (size = 0; size < ROOM; ++size) {
    struct_version given;
    check_scene("%s of %u bytes, read", s->name, (unsigned)size);
    memset(&given, 0, sizeof given);
    CHECK_EQUAL(s->write[0](&given, s->size), HSP_OK);
    given.struct_size = size;
    if (is_good_size(s, size)) memset(given.bytes + size, 1, ROOM - size); /* not the program's any more */
    CHECK_EQUAL(s->read(&given), is_good_size(s, size) ? HSP_OK : HSP_E_VERSION);
    if (size <= s->size || !is_good_size(s, size)) continue;
    given.bytes[size - 1] = 1;
    CHECK_EQUAL(s->read(&given), HSP_E_VERSION);
    given.bytes[size - 1] = 0;
    given.bytes[s->size] = 1;
    CHECK_EQUAL(s->read(&given), HSP_E_VERSION);
  }
  {
    struct_version given;
    memset(&given, 0, sizeof given);
    given.struct_size = UINT32_MAX;
    CHECK_EQUAL(s->read(&given), HSP_E_VERSION);
    CHECK_EQUAL(s->read(NULL) == HSP_OK,
                s->read == read_model_options || s->read == read_view_options || s->read == read_picture_options);
  }
}

static void check_writing(const struct versioned *s, int32_t (*write)(void *out, uint32_t size)) {
  struct_version known;
  uint32_t size, i;
  memset(&known, 0, sizeof known);
  CHECK_EQUAL(write(&known, s->size), HSP_OK);
  for (size = 4; size < ROOM; ++size) {
    struct_version out, before;
    check_scene("%s of %u bytes, written", s->name, (unsigned)size);
    FILL(out);
    memcpy(out.bytes, &size, sizeof size);
    before = out;
    if (!is_good_size(s, size)) {
      CHECK_EQUAL(write(&out, size), HSP_E_VERSION);
      CHECK_BYTES(&out, &before, sizeof out);
      continue;
    }
    CHECK_EQUAL(write(&out, size), HSP_OK);
    CHECK_EQUAL(out.struct_size, size);
    CHECK_BYTES(out.bytes + 4, known.bytes + 4, (size < s->size ? size : s->size) - 4);
    for (i = s->size; i < size; ++i) CHECK(out.bytes[i] == 0);
    CHECK_BYTES(out.bytes + size, before.bytes + size, ROOM - size);
  }
}

int main(void) {
  const hsp_surface_limits of_surface = {(uint32_t)sizeof of_surface, 2 * BALLS, 8, BALLS, 8, 64, 8};
  int i, k;
  h = four_handles_make(BALLS);
  CHECK_EQUAL(hsp_surface_init(surface_memory, sizeof surface_memory, &of_surface, &surface), HSP_OK);
  for (i = 0; i < STRUCTS; ++i) {
    four_handles_compute(&h);
    check_reading(&structs[i]);
    four_handles_compute(&h);
    for (k = 0; k < 3 && structs[i].write[k] != NULL; ++k) check_writing(&structs[i], structs[i].write[k]);
  }
  return check_report();
}
