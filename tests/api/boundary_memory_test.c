/* Sizes of handles: the macros bound the functions (properties numbered as in the header), sizes grow with the limits,
 * memory of any alignment and exactly the told size serves, one byte less is refused without a write. */
#include <hardsphere.h>
#include <string.h>

#include "ball_sets.h"
#include "check.h"
#include "computed.h"
#include "guarded_memory.h"
#include "limit_sweep.h"

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
      CHECK(too_large(1024.0 + 128.0 * numbers[i]));
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

static size_t macro(const limit_numbers *limits) {
  const uint32_t *n = limits->number;
  return HSP_BOUNDARY_BYTES(n[1], n[2], n[3], n[4]);
}

static void boundary_sizes(void) {
  static const size_bound bound = {macro, {4096, 64, 256, 160, 80}};
  static const uint32_t box[] = {0, 1, 2, 3, 7, 8, 9, 64, 65, 1000, 4097, 1000000, 0x0FFFFFFF};
  int a;
  sweep_sizes(&boundary_handle, &bound, box, sizeof box / sizeof box[0]);
  check_scene("%s", "the limits of hsp_boundary_limits_init");
  for (a = 0; a < NUMBERS; ++a) {
    hsp_boundary_limits limits;
    limit_numbers same = {{0}};
    size_t bytes;
    if (numbers[a] > 30000000) continue; /* 8 vertices a ball pass HSP_MAX_BALLS */
    CHECK_EQUAL(hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, numbers[a]), HSP_OK);
    memcpy(&same, &limits, sizeof limits);
    bytes = size_of(&boundary_handle, &bound, &same);
    CHECK(bytes == SIZE_MAX || bytes <= macro(&same));
  }
}

static void every_alignment(void) {
  static ball_set set;
  static hsp_vertex first[4000], vertices[4000];
  size_t misalignment, model_bytes = 0, bytes = 0;
  hsp_boundary_limits limits;
  uint32_t count = 0, first_count = 0;
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 50, 5);
  CHECK_EQUAL(hsp_model_bytes(set.n, &model_bytes), HSP_OK);
  CHECK_EQUAL(hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, set.n), HSP_OK);
  CHECK_EQUAL(hsp_boundary_bytes(&limits, &bytes), HSP_OK);
  for (misalignment = 0; misalignment < 16; ++misalignment) {
    guarded_memory model_memory = guarded_take(model_bytes, misalignment, GUARDED_RANDOM);
    guarded_memory memory = guarded_take(bytes, misalignment, GUARDED_RANDOM);
    hsp_model *model = NULL;
    hsp_boundary *boundary = NULL;
    check_scene("misalignment %u", (unsigned)misalignment);
    CHECK_EQUAL(hsp_model_init(model_memory.block, model_bytes, set.n, &model), HSP_OK);
    CHECK_EQUAL(hsp_boundary_init(memory.block, bytes, &limits, &boundary), HSP_OK);
    CHECK((unsigned char *)model >= model_memory.block && (unsigned char *)model < model_memory.block + model_bytes);
    CHECK((unsigned char *)boundary >= memory.block && (unsigned char *)boundary < memory.block + bytes);
    CHECK_EQUAL(hsp_model_set(model, set.n, set.xyz, set.radius, NULL, NULL), HSP_OK);
    CHECK_EQUAL(hsp_boundary_compute(boundary, model), HSP_OK);
    CHECK_EQUAL(hsp_boundary_get_vertices(boundary, vertices, 4000, &count), HSP_OK);
    CHECK(count > 0);
    if (misalignment == 0) {
      first_count = count;
      CHECK_EQUAL(hsp_boundary_get_vertices(boundary, first, 4000, &count), HSP_OK);
    }
    CHECK_EQUAL(count, first_count);
    CHECK_BYTES(vertices, first, first_count * sizeof(hsp_vertex));
    CHECK(guarded_clean(&model_memory));
    CHECK(guarded_clean(&memory));
    guarded_give_back(&model_memory);
    guarded_give_back(&memory);
  }
}

static void one_byte_less(void) {
  static const uint32_t sizes[] = {0, 1, 2, 10, 257};
  size_t i, misalignment;
  for (i = 0; i < sizeof sizes / sizeof sizes[0]; ++i) {
    for (misalignment = 0; misalignment < 16; ++misalignment) {
      size_t model_bytes = 0, bytes = 0;
      hsp_boundary_limits limits;
      guarded_memory model_memory, memory;
      hsp_model *model = NULL;
      hsp_boundary *boundary = NULL;
      check_scene("%u balls, misalignment %u", (unsigned)sizes[i], (unsigned)misalignment);
      CHECK_EQUAL(hsp_model_bytes(sizes[i], &model_bytes), HSP_OK);
      CHECK_EQUAL(hsp_boundary_limits_init(&limits, (uint32_t)sizeof limits, sizes[i]), HSP_OK);
      CHECK_EQUAL(hsp_boundary_bytes(&limits, &bytes), HSP_OK);
      model_memory = guarded_take(model_bytes - 1, misalignment, GUARDED_PATTERN);
      memory = guarded_take(bytes - 1, misalignment, GUARDED_PATTERN);
      CHECK_EQUAL(hsp_model_init(model_memory.block, model_bytes - 1, sizes[i], &model), HSP_E_MEMORY);
      CHECK_EQUAL(hsp_boundary_init(memory.block, bytes - 1, &limits, &boundary), HSP_E_MEMORY);
      CHECK(model == NULL && boundary == NULL);
      CHECK(guarded_untouched(&model_memory, GUARDED_PATTERN) && guarded_clean(&model_memory));
      CHECK(guarded_untouched(&memory, GUARDED_PATTERN) && guarded_clean(&memory));
      guarded_give_back(&model_memory);
      guarded_give_back(&memory);
    }
  }
}

int main(void) {
  model_sizes();
  boundary_sizes();
  every_alignment();
  one_byte_less();
  return check_report();
}
