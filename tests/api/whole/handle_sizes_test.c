/* Sizes of handles: the macros bound the functions (properties numbered as in the header), sizes grow with the limits,
 * memory of any alignment and of exactly the reported size serves, one byte less is refused without a write. */
#include <hardsphere.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "guarded_memory.h"
#include "handle_life.h"
#include "limit_sweep.h"
#include "topology_sets.h"
#include "untouched.h"

static const uint32_t numbers[] = {
    0,    1,    2,     3,     4,     7,       8,         9,          15,         16,         17,        31,   32,
    33,   63,   64,    65,    127,   128,     129,       255,        256,        257,        1000,      1023, 1024,
    1025, 4392, 65535, 65536, 65537, 1000000, 100000000, 0x07FFFFFF, 0x08000000, 0x0FFFFFFE, 0x0FFFFFFF};
enum { NUMBERS = sizeof numbers / sizeof numbers[0] };

/* Where size_t has 32 bits, sizes of 2 GiB and more are refused: only then. */
static int too_large(double bound) {
  return bound > (double)(SIZE_MAX / 2);
}

static void model_sizes(void) {
  size_t i, bytes = 0, before = 0;
  for (i = 0; i < NUMBERS; ++i) {
    check_scene("%u balls", (unsigned)numbers[i]);
    if (hsp_model_bytes(numbers[i], &bytes) != HSP_OK) {
      CHECK_EQUAL(hsp_model_bytes(numbers[i], &bytes), HSP_E_RANGE);
      CHECK(too_large(1536.0 + 192.0 * numbers[i]));
      continue;
    }
    /* hsp_model_bytes, property 1: at most HSP_MODEL_BYTES(balls) */
    CHECK(bytes <= HSP_MODEL_BYTES(numbers[i]));
    CHECK(bytes > 0 && bytes >= before);
    before = bytes;
  }
  for (i = 0; i < 5000; ++i) {
    CHECK_EQUAL(hsp_model_bytes((uint32_t)i, &bytes), HSP_OK);
    if (!CHECK(bytes <= HSP_MODEL_BYTES(i))) break;
  }
}

/* ---- kinds with limits ---- */

static size_t boundary_macro(const limit_numbers *limits) {
  const uint32_t *n = limits->number;
  return HSP_BOUNDARY_BYTES(n[1], n[2], n[3], n[4]);
}
static size_t topology_macro(const limit_numbers *limits) {
  const uint32_t *n = limits->number;
  return HSP_TOPOLOGY_BYTES(n[1], n[2], n[3], n[4]);
}
static size_t view_macro(const limit_numbers *limits) {
  const uint32_t *n = limits->number;
  return HSP_VIEW_BYTES(n[1], n[2], n[3]);
}
enum { BOUNDED = VIEW + 1 }; /* of these kinds; those of surfaces, meshes and maps have tests of their own */
static const size_bound bounds[BOUNDED] = {{boundary_macro, {4096, 64, 256, 160, 80}, 0},
                                           {topology_macro, {4096, 64, 192, 112, 96}, 0},
                                           {view_macro, {32768, 192, 384, 64, 0}, 0}};

/* Limits that suffice for molecules of so many balls; of a topology as the header says. */
static limit_numbers default_limits(const handle_kind *kind, uint32_t balls) {
  limit_numbers limits = {{0}};
  if (kind->limits_init != NULL) {
    CHECK_EQUAL(kind->limits_init(&limits, kind->struct_size, balls), HSP_OK);
  } else {
    const limit_numbers of_topology = {
        {kind->struct_size, balls, balls < 256 ? balls : 256, 16 * balls + 96, 2 * balls + 16}};
    limits = of_topology;
  }
  return limits;
}

static void sizes(int kind) {
  static const uint32_t box[] = {0, 1, 2, 3, 7, 8, 9, 64, 65, 1000, 4097, 65535, 1000000, 0x0FFFFFFE, 0x0FFFFFFF};
  const handle_kind *k = kinds_of_life[kind].kind;
  limit_numbers few = default_limits(k, 1000);
  uint32_t n, i;
  int which;
  sweep_sizes(k, &bounds[kind], box, sizeof box / sizeof box[0]);
  check_scene("%s, default limits", kinds_of_life[kind].name);
  for (i = 0; i < NUMBERS; ++i) {
    if (numbers[i] <= 15000000) { /* 16 edges a ball pass HSP_MAX_BALLS */
      const limit_numbers limits = default_limits(k, numbers[i]);
      const size_t bytes = size_of(k, &bounds[kind], &limits);
      CHECK(bytes == SIZE_MAX || bytes <= bounds[kind].macro(&limits));
    }
  }
  check_scene("%s, few balls", kinds_of_life[kind].name);
  for (n = 0; n < 600; ++n) {
    const limit_numbers limits = {{k->struct_size, n, n / 2, 3}};
    CHECK(size_of(k, &bounds[kind], &limits) <= bounds[kind].macro(&limits));
  }
  check_scene("%s, twice as much of one thing", kinds_of_life[kind].name);
  for (which = 1; which <= k->limits; ++which) {
    limit_numbers more = few;
    more.number[which] *= 2;
    CHECK(size_of(k, &bounds[kind], &few) < size_of(k, &bounds[kind], &more));
  }
}

/* Shells are no limit of their own to the macro: 0 stands for as many as the edges allow, which is the most. */
static void shells_of_topologies(void) {
  limit_numbers limits = default_limits(&topology_handle, 1000);
  const size_t most = size_of(&topology_handle, &bounds[1], &limits);
  const uint32_t edges = limits.number[3];
  size_t bytes = 0, before = 0;
  uint32_t shells;
  check_scene("shells of topologies");
  for (shells = 1; shells < edges; shells += 1 + shells / 8, before = bytes) {
    limits.number[5] = shells;
    bytes = size_of(&topology_handle, &bounds[1], &limits);
    CHECK(bytes >= before && bytes <= most);
    CHECK(shells > 1 || 5 * bytes < 4 * most); /* few shells make a difference */
    CHECK(shells + 8 < edges / 2 ? bytes < most : shells < edges / 2 || bytes == most);
  }
  limits.number[5] = HSP_MAX_BALLS;
  CHECK(size_of(&topology_handle, &bounds[1], &limits) == most);
}

/* ---- memory that is not used yet ---- */

/* Large limits cost no time: what nothing is kept in is not written. */
static void memory_is_not_touched(int kind) {
  const handle_kind *k = kinds_of_life[kind].kind;
  limit_numbers limits = {{k->struct_size}};
  size_t bytes = 0, touched = 0, i;
  const uint32_t many = 20000;
  guarded_memory memory;
  void *handle = NULL;
  int which;
  check_scene("memory of %s", kinds_of_life[kind].name);
  for (which = 1; which <= k->limits; ++which) limits.number[which] = k->names[which] != NULL ? many : 0;
  if (k->limits_init != NULL) CHECK_EQUAL(k->limits_init(&limits, k->struct_size, many), HSP_OK);
  CHECK_EQUAL(k->bytes(&limits, &bytes), HSP_OK);
  memory = guarded_take(bytes, 0, GUARDED_PATTERN);
  CHECK_EQUAL(k->init(memory.block, bytes, &limits, &handle), HSP_OK);
  unpoison(memory.block, bytes);
  for (i = 0; i < bytes; ++i) touched += memory.block[i] != GUARDED_PATTERN;
  CHECK(touched < bytes / 8);
  guarded_give_back(&memory);
}

/* ---- alignment ---- */

static const computations *known_set;
static int known_kind;

static uint64_t hash_of(const void *handle) {
  unsigned char *buffer = buffer_for(known_set);
  const uint64_t hash =
      kinds_of_life[known_kind].hash(handle, source_of(known_set, known_kind), buffer, known_set->room);
  free(buffer);
  return hash;
}
static void check_results(const void *handle, const void *source) {
  (void)source;
  CHECK(hash_of(handle) != 0 && hash_of(handle) == hash_of(handle_of(known_set, known_kind)));
}
static void check_no_results(const void *handle) {
  CHECK(hash_of(handle) == 0);
}
/* A call that uses scratch memory. */
static void use(void *handle, const void *source) {
  (void)source;
  CHECK(kinds_of_life[known_kind].use(handle));
}

static void every_alignment(const ball_set *set) {
  computations all;
  hsp_view_options options;
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  if (computations_make(set, &options, &all)) {
    for (known_kind = 0; known_kind < BOUNDED; ++known_kind) {
      const limit_numbers needed = limits_of(&all, known_kind);
      const known_handle known = {
          kinds_of_life[known_kind].kind, source_of(&all, known_kind), &needed, check_results, check_no_results, NULL};
      known_set = &all;
      sweep_alignments(&known, use);
    }
  }
  computations_release(&all);
}

/* Models, and boundaries with default limits, of a few sizes: any alignment serves, one byte less does not. */
static void check_bytes_are_enough(uint32_t balls, size_t misalignment) {
  const limit_numbers limits = default_limits(&boundary_handle, balls);
  size_t model_bytes = 0, bytes = 0;
  guarded_memory model_memory, memory;
  hsp_model *model = NULL;
  void *boundary = NULL;
  check_scene("%u balls, misalignment %u", (unsigned)balls, (unsigned)misalignment);
  CHECK_EQUAL(hsp_model_bytes(balls, &model_bytes), HSP_OK);
  CHECK_EQUAL(boundary_handle.bytes(&limits, &bytes), HSP_OK);
  model_memory = guarded_take(model_bytes - 1, misalignment, GUARDED_PATTERN);
  memory = guarded_take(bytes - 1, misalignment, GUARDED_PATTERN);
  CHECK_EQUAL(hsp_model_init(model_memory.block, model_bytes - 1, balls, &model), HSP_E_MEMORY);
  CHECK_EQUAL(boundary_handle.init(memory.block, bytes - 1, &limits, &boundary), HSP_E_MEMORY);
  CHECK(model == NULL && boundary == NULL);
  CHECK(guarded_untouched(&model_memory, GUARDED_PATTERN) && guarded_clean(&model_memory));
  CHECK(guarded_untouched(&memory, GUARDED_PATTERN) && guarded_clean(&memory));
  guarded_give_back(&model_memory);
  guarded_give_back(&memory);
}

/* A model at this alignment holds what a boundary needs. */
static void check_model_alignment(const ball_set *set, size_t misalignment) {
  computed known, own;
  size_t bytes = 0;
  guarded_memory memory;
  hsp_model *model = NULL;
  hsp_totals totals;
  check_scene("model, misalignment %u", (unsigned)misalignment);
  CHECK_EQUAL(computed_make(set->n, set->xyz, set->radius, NULL, &known), HSP_OK);
  own = known;
  CHECK_EQUAL(hsp_model_bytes(set->n, &bytes), HSP_OK);
  memory = guarded_take(bytes, misalignment, GUARDED_RANDOM);
  CHECK_EQUAL(hsp_model_init(memory.block, bytes, set->n, &model), HSP_OK);
  CHECK((unsigned char *)model >= memory.block && (unsigned char *)model < memory.block + bytes);
  CHECK_EQUAL(hsp_model_set(model, set->n, set->xyz, set->radius, NULL, NULL), HSP_OK);
  own.model = model;
  CHECK_EQUAL(boundary_handle.compute(own.boundary, &own, NULL), HSP_OK);
  CHECK_EQUAL(hsp_boundary_measure(own.boundary, NULL, &totals, NULL, NULL, 0, NULL), HSP_OK);
  CHECK_BYTES(&totals, &known.totals, sizeof totals);
  CHECK(guarded_clean(&memory));
  guarded_give_back(&memory);
  computed_release(&known);
}

int main(void) {
  static const uint32_t balls[] = {0, 1, 2, 10, 257};
  static ball_set set;
  size_t i, misalignment;
  int kind;
  model_sizes();
  for (kind = 0; kind < BOUNDED; ++kind) sizes(kind);
  for (kind = 0; kind < KINDS; ++kind) memory_is_not_touched(kind);
  shells_of_topologies();
  topology_set_two_in_a_void(&set);
  every_alignment(&set);
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 50, 5);
  every_alignment(&set);
  for (misalignment = 0; misalignment < 16; ++misalignment) {
    check_model_alignment(&set, misalignment);
    for (i = 0; i < sizeof balls / sizeof balls[0]; ++i) check_bytes_are_enough(balls[i], misalignment);
  }
  return check_report();
}
