/* The limits of a topology: what the functions that fill them say, and every limit, size and memory that is refused. */
#include <hardsphere.h>

#include "check.h"
#include "untouched.h"

enum { BALLS = 3, EDGES = 40, EXTRA = 8 };
static unsigned char model_memory[HSP_MODEL_BYTES(BALLS)];
static unsigned char boundary_memory[HSP_BOUNDARY_BYTES(BALLS, BALLS, 16, 16)];
static unsigned char topology_memory[HSP_TOPOLOGY_BYTES(BALLS, BALLS, EDGES, EXTRA)];
static hsp_model *model;
static hsp_boundary *boundary;

static const double xyz[3 * BALLS] = {0, 0, 0, 2, 0, 0, 1, 1.5, 0};
static const double radius[BALLS] = {1.5, 1.5, 1.25};

static hsp_topology_limits good_limits(void) {
  hsp_topology_limits limits;
  CHECK_EQUAL(hsp_topology_limits_init(&limits, (uint32_t)sizeof limits, BALLS), HSP_OK);
  limits.neighbours = BALLS;
  limits.edges = EDGES;
  limits.extra_arcs = EXTRA;
  return limits;
}

static void limits_init(void) {
  static const uint32_t numbers[] = {0, 1, 2, 255, 256, 257, 4392, 1000000};
  const uint32_t most = (HSP_MAX_BALLS - 96) / 16;
  hsp_topology_limits limits;
  size_t i;
  FILL(limits);
  CHECK_EQUAL(hsp_topology_limits_init(NULL, (uint32_t)sizeof limits, 1), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_limits_init(&limits, 0, 1), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_limits_init(&limits, (uint32_t)sizeof limits - 4, 1), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_limits_init(&limits, (uint32_t)sizeof limits + 4, 1), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_limits_init(&limits, (uint32_t)sizeof limits, most + 1), HSP_E_RANGE);
  CHECK_EQUAL(hsp_topology_limits_init(&limits, (uint32_t)sizeof limits, HSP_NONE), HSP_E_RANGE);
  CHECK_UNTOUCHED(limits);
  CHECK_EQUAL(hsp_topology_limits_init(&limits, (uint32_t)sizeof limits, most), HSP_OK);
  CHECK(limits.edges <= HSP_MAX_BALLS);
  for (i = 0; i < sizeof numbers / sizeof numbers[0]; ++i) {
    const uint32_t n = numbers[i];
    check_scene("limits for %u balls", (unsigned)n);
    FILL(limits);
    CHECK_EQUAL(hsp_topology_limits_init(&limits, (uint32_t)sizeof limits, n), HSP_OK);
    CHECK_EQUAL(limits.struct_size, sizeof limits);
    CHECK_EQUAL(limits.balls, n);
    CHECK_EQUAL(limits.neighbours, n < 256 ? n : 256);
    CHECK_EQUAL(limits.edges, 16 * n + 96);
    CHECK_EQUAL(limits.extra_arcs, 2 * n + 16);
    CHECK_EQUAL(limits.reserved, 0);
  }
  check_scene("%s", "");
}

static void limits_for(void) {
  hsp_topology_limits limits;
  FILL(limits);
  CHECK_EQUAL(hsp_topology_limits_for(NULL, (uint32_t)sizeof limits, boundary), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_limits_for(&limits, (uint32_t)sizeof limits, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_limits_for(&limits, 0, boundary), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_limits_for(&limits, (uint32_t)sizeof limits + 4, boundary), HSP_E_ARGUMENT);
  CHECK_UNTOUCHED(limits);
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_limits_for(&limits, (uint32_t)sizeof limits, boundary), HSP_E_STATE);
  CHECK_UNTOUCHED(limits);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model), HSP_OK);
  CHECK_EQUAL(hsp_topology_limits_for(&limits, (uint32_t)sizeof limits, boundary), HSP_OK);
  CHECK_EQUAL(limits.balls, BALLS);
  CHECK_EQUAL(limits.neighbours, BALLS - 1);
  CHECK_EQUAL(limits.reserved, 0);
}

static void check_bad_limits(const hsp_topology_limits *limits, int32_t expected) {
  size_t bytes;
  hsp_topology *made;
  FILL(bytes);
  FILL(made);
  FILL(topology_memory);
  CHECK_EQUAL(hsp_topology_bytes(limits, &bytes), expected);
  CHECK_UNTOUCHED(bytes);
  CHECK_EQUAL(hsp_topology_init(topology_memory, sizeof topology_memory, limits, &made), expected);
  CHECK_UNTOUCHED(made);
  CHECK_UNTOUCHED(topology_memory);
}

static void bytes_and_init(void) {
  hsp_topology_limits limits = good_limits();
  hsp_topology *made;
  size_t bytes;
  FILL(made);
  CHECK_EQUAL(hsp_topology_bytes(&limits, NULL), HSP_E_ARGUMENT);
  check_bad_limits(NULL, HSP_E_ARGUMENT);
  limits.struct_size = 0;
  check_bad_limits(&limits, HSP_E_ARGUMENT);
  limits.struct_size = (uint32_t)sizeof limits - 4;
  check_bad_limits(&limits, HSP_E_ARGUMENT);
  limits.struct_size = (uint32_t)sizeof limits + 8;
  check_bad_limits(&limits, HSP_E_ARGUMENT);
  limits = good_limits();
  limits.reserved = 1;
  check_bad_limits(&limits, HSP_E_ARGUMENT);
  limits = good_limits();
  limits.balls = HSP_MAX_BALLS + 1;
  check_bad_limits(&limits, HSP_E_RANGE);
  limits = good_limits();
  limits.neighbours = HSP_NONE;
  check_bad_limits(&limits, HSP_E_RANGE);
  limits = good_limits();
  limits.edges = HSP_MAX_BALLS + 1;
  check_bad_limits(&limits, HSP_E_RANGE);
  limits = good_limits();
  limits.extra_arcs = HSP_NONE;
  check_bad_limits(&limits, HSP_E_RANGE);

  limits = good_limits();
  CHECK_EQUAL(hsp_topology_bytes(&limits, &bytes), HSP_OK);
  CHECK_EQUAL(hsp_topology_init(NULL, sizeof topology_memory, &limits, &made), HSP_E_ARGUMENT);
  FILL(topology_memory);
  CHECK_EQUAL(hsp_topology_init(topology_memory, sizeof topology_memory, &limits, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_topology_init(topology_memory, 0, &limits, &made), HSP_E_MEMORY);
  CHECK_EQUAL(hsp_topology_init(topology_memory, 100, &limits, &made), HSP_E_MEMORY);
  CHECK_EQUAL(hsp_topology_init(topology_memory, bytes - 1, &limits, &made), HSP_E_MEMORY);
  CHECK_UNTOUCHED(made);
  CHECK_UNTOUCHED(topology_memory);
}

int main(void) {
  hsp_boundary_limits limits;
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, BALLS, &model), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, BALLS, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, BALLS), HSP_OK);
  limits.neighbours = BALLS;
  limits.vertices = limits.circles = 16;
  CHECK_EQUAL(hsp_boundary_init(boundary_memory, sizeof boundary_memory, &limits, &boundary), HSP_OK);
  CHECK_EQUAL(hsp_boundary_compute(boundary, model), HSP_OK);
  limits_init();
  limits_for();
  bytes_and_init();
  return check_report();
}
