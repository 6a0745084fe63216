/* One molecule, from coordinates to areas, volume, gradient and topology, in memory that is there from the beginning.
 * It prints the bits of all results; then, on lines that begin with #, what each step took. The file MOLECULE has
 * BALLS, xyz, radius. The limits are exact: EXACT_NEIGHBOURS and so on are what a run without them has said. */
#include <hardsphere.h>
#include <string.h>

#include MOLECULE
#include "machine.h"

#ifndef EXACT_NEIGHBOURS
#define EXACT_NEIGHBOURS 0
#define EXACT_VERTICES 0
#define EXACT_CIRCLES 0
#define EXACT_EDGES 0
#define EXACT_CUT_ARCS 0
#define EXACT_SHELLS 1
#endif

static double area[BALLS], volume[BALLS], centre[BALLS][3], slope[BALLS];

/* Memory from one piece, never given back but from a mark on. */
static size_t taken;

static void *take(size_t bytes) {
  const size_t room = (bytes + 15) & ~(size_t)15;
  if (room > machine_pool_bytes() - taken) return NULL;
  void *memory = machine_pool() + taken;
  taken += room;
  return memory;
}

static void print_bits(const void *words, size_t count) {
  for (size_t k = 0; k < count; ++k) {
    uint64_t bits;
    memcpy(&bits, (const char *)words + k * sizeof bits, sizeof bits);
    char text[18];
    for (int digit = 0; digit < 16; ++digit) text[digit] = "0123456789abcdef"[bits >> (60 - 4 * digit) & 15];
    text[16] = (k + 1) % 4 != 0 && k + 1 < count ? ' ' : '\n';
    text[17] = '\0';
    machine_print(text);
  }
}

static void print_numbers(const char *name, const uint32_t *numbers, size_t count) {
  machine_print(name);
  for (size_t k = 0; k < count; ++k) {
    char text[12];
    char *at = text + sizeof text - 1;
    uint32_t left = numbers[k];
    *at = '\0';
    do {
      *--at = (char)('0' + left % 10);
      left /= 10;
    } while (left != 0);
    *--at = ' ';
    machine_print(at);
  }
  machine_print("\n");
}

/* A step is over: instructions in thousands, and the bytes of stack it used. */
static void report(const char *name) {
  uint32_t cost[2];
  if (machine_cost(cost)) print_numbers(name, cost, 2);
}

static int32_t make_model(hsp_model **model) {
  size_t bytes;
  machine_begin();
  int32_t status = hsp_model_bytes(BALLS, &bytes);
  if (status == HSP_OK) status = hsp_model_init(take(bytes), bytes, BALLS, model);
  if (status == HSP_OK) status = hsp_model_set(*model, BALLS, xyz, radius, NULL, NULL);
  report("# model");
  return status;
}

static int32_t make_boundary(const hsp_model *model, hsp_boundary **boundary) {
  hsp_boundary_limits limits = {.struct_size = sizeof limits,
                                .balls = BALLS,
                                .neighbours = EXACT_NEIGHBOURS,
                                .vertices = EXACT_VERTICES,
                                .circles = EXACT_CIRCLES};
  const size_t mark = taken;
  int32_t status;
  do { /* once, with exact limits */
    size_t bytes;
    taken = mark;
    status = hsp_boundary_bytes(&limits, &bytes);
    if (status == HSP_OK) status = hsp_boundary_init(take(bytes), bytes, &limits, boundary);
    machine_begin();
    if (status == HSP_OK) status = hsp_boundary_compute(*boundary, model, &limits);
    report("# boundary");
  } while (status == HSP_E_CAPACITY && machine_may_retry());
  print_numbers("boundary", (const uint32_t[]){limits.neighbours, limits.vertices, limits.circles}, 3);
  return status;
}

static int32_t make_topology(const hsp_boundary *boundary, hsp_topology **topology) {
  hsp_topology_limits limits = {.struct_size = sizeof limits,
                                .balls = BALLS,
                                .neighbours = EXACT_NEIGHBOURS,
                                .edges = EXACT_EDGES,
                                .cut_arcs = EXACT_CUT_ARCS,
                                .shells = EXACT_SHELLS};
  const size_t mark = taken;
  int32_t status;
  do {
    size_t bytes;
    taken = mark;
    status = hsp_topology_bytes(&limits, &bytes);
    if (status == HSP_OK) status = hsp_topology_init(take(bytes), bytes, &limits, topology);
    machine_begin();
    if (status == HSP_OK) status = hsp_topology_compute(*topology, boundary, &limits);
    report("# topology");
  } while (status == HSP_E_CAPACITY && machine_may_retry());
  print_numbers("topology", (const uint32_t[]){limits.edges, limits.cut_arcs, limits.shells}, 3);
  return status;
}

static int32_t run(void) {
  hsp_model *model;
  hsp_boundary *boundary;
  hsp_topology *topology;
  hsp_totals totals;
  hsp_energy energy;
  hsp_boundary_counts counts;
  hsp_topology_counts topology_counts;
  int32_t status = make_model(&model);
  if (status == HSP_OK) status = make_boundary(model, &boundary);
  if (status == HSP_OK) status = hsp_boundary_get_counts(boundary, &counts);
  machine_begin();
  if (status == HSP_OK) status = hsp_boundary_measure(boundary, NULL, &totals, area, volume, BALLS, NULL);
  report("# measure");
  machine_begin();
  if (status == HSP_OK) {
    status = hsp_boundary_get_gradient(
        boundary, &(hsp_gradient_request){.struct_size = sizeof(hsp_gradient_request), .tension = 1, .pressure = 1},
        &(hsp_gradient_outputs){.struct_size = sizeof(hsp_gradient_outputs),
                                .energy = &energy,
                                .d_centre = &centre[0][0],
                                .d_radius = slope,
                                .capacity = BALLS});
  }
  report("# gradient");
  if (status == HSP_OK) status = make_topology(boundary, &topology);
  if (status == HSP_OK) status = hsp_topology_get_counts(topology, &topology_counts);
  if (status != HSP_OK) return status;
  print_numbers("counts", (const uint32_t *)&counts, sizeof counts / sizeof(uint32_t));
  print_numbers("counts", (const uint32_t *)&topology_counts, sizeof topology_counts / sizeof(uint32_t));
  print_bits(&totals, 2);
  print_bits(&energy, 4);
  print_bits(area, BALLS);
  print_bits(volume, BALLS);
  print_bits(centre, 3 * (size_t)BALLS);
  print_bits(slope, BALLS);
  const uint32_t memory = (uint32_t)(taken + sizeof area + sizeof volume + sizeof centre + sizeof slope);
  print_numbers("# memory", &memory, 1);
  return status;
}

int main(void) {
  const int32_t status = run();
  if (status != HSP_OK) {
    machine_print(hsp_status_text(status));
    machine_print("\n");
  }
  return status == HSP_OK ? 0 : 1;
}
