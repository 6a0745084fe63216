/* The limits of boundaries, topologies, surfaces, views and maps: what hsp_X_limits_init says, and every limit, size
 * and memory that is refused. */
#include <hardsphere.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "map_result.h"
#include "surface_result.h"
#include "topology_result.h"
#include "untouched.h"
#include "view_result.h"

enum { PATTERN = 0xA5, SMALL = 3 };

typedef struct kind_of_limits {
  const char *name;
  const handle_kind *kind;
  /* hsp_X_limits_init, if it goes by balls, sets limit k to per_ball[k] balls + more[k], but number 2, the neighbours,
   * to 256 at most */
  uint32_t per_ball[LIMIT_NUMBERS], more[LIMIT_NUMBERS];
  uint32_t most;       /* for so many balls, and not for more */
  limit_numbers small; /* for SMALL balls */
} kind_of_limits;

static const kind_of_limits kinds[] = {{"boundary",
                                        &boundary_handle,
                                        {0, 1, 1, 8, 2},
                                        {0, 0, 0, 64, 16},
                                        (HSP_MAX_BALLS - 64) / 8,
                                        {{(uint32_t)sizeof(hsp_boundary_limits), SMALL, SMALL, 16, 16}}},
                                       {"topology",
                                        &topology_handle,
                                        {0}, /* its limits suit a boundary: see topology_arguments_test.c */
                                        {0},
                                        0,
                                        {{(uint32_t)sizeof(hsp_topology_limits), SMALL, SMALL, 40, 8}}},
                                       {"surface",
                                        &surface_handle,
                                        {0}, /* as of topologies: see surface_properties_test.c */
                                        {0},
                                        0,
                                        {{(uint32_t)sizeof(hsp_surface_limits), SMALL, SMALL, 4, 8, 40, 2}}},
                                       {"view",
                                        &view_handle,
                                        {0, 1, 1, 12},
                                        {0, 0, 0, 64},
                                        (HSP_MAX_BALLS - 64) / 12,
                                        {{(uint32_t)sizeof(hsp_view_limits), SMALL, SMALL, 40}}},
                                       {"map",
                                        &map_handle,
                                        {0, 1, 1, 12},
                                        {0, 0, 0, 64},
                                        (HSP_MAX_BALLS - 64) / 12,
                                        {{(uint32_t)sizeof(hsp_map_limits), SMALL, SMALL, 40}}}};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

/* How many numbers the limits consist of: struct_size, the limits, and for some kinds one that is reserved. */
static int number_count(const handle_kind *kind) {
  return (int)(kind->struct_size / sizeof(uint32_t));
}

static void limits_init(const kind_of_limits *k) {
  static const uint32_t balls[] = {0, 1, 2, 255, 256, 257, 4392, 1000000};
  const uint32_t size = k->kind->struct_size;
  limit_numbers limits;
  size_t i;
  int which;
  FILL(limits);
  CHECK_EQUAL(k->kind->limits_init(NULL, size, 1), HSP_E_ARGUMENT);
  CHECK_EQUAL(k->kind->limits_init(&limits, 0, 1), HSP_E_VERSION);
  CHECK_EQUAL(k->kind->limits_init(&limits, size - 4, 1), HSP_E_VERSION);
  CHECK_EQUAL(k->kind->limits_init(&limits, 1028, 1), HSP_E_VERSION);
  CHECK_EQUAL(k->kind->limits_init(&limits, size, k->most + 1), HSP_E_RANGE);
  CHECK_EQUAL(k->kind->limits_init(&limits, size, HSP_MAX_BALLS), HSP_E_RANGE);
  CHECK_EQUAL(k->kind->limits_init(&limits, size, HSP_MAX_BALLS + 1), HSP_E_RANGE);
  CHECK_EQUAL(k->kind->limits_init(&limits, size, HSP_NONE), HSP_E_RANGE);
  CHECK_UNTOUCHED(limits);
  CHECK_EQUAL(k->kind->limits_init(&limits, size, k->most), HSP_OK);
  for (which = 1; which <= k->kind->limits; ++which) CHECK(limits.number[which] <= HSP_MAX_BALLS);
  for (i = 0; i < sizeof balls / sizeof balls[0]; ++i) {
    const uint32_t n = balls[i];
    check_scene("%s, limits for %u balls", k->name, (unsigned)n);
    FILL(limits);
    CHECK_EQUAL(k->kind->limits_init(&limits, size, n), HSP_OK);
    CHECK_EQUAL(limits.number[0], size);
    for (which = 1; which <= k->kind->limits; ++which) {
      const uint32_t plain = k->per_ball[which] * n + k->more[which];
      CHECK_EQUAL(limits.number[which], which == 2 && plain > 256 ? 256 : plain);
    }
    for (; which < number_count(k->kind); ++which) CHECK_EQUAL(limits.number[which], 0);
  }
}

/* The kind's functions say `expected` to these limits, or to NULL, and write nothing. */
static void check_refused(const kind_of_limits *k, const limit_numbers *limits, int32_t expected) {
  static unsigned char memory[64 * 1024];
  size_t bytes;
  void *made;
  FILL(bytes);
  FILL(made);
  FILL(memory);
  CHECK_EQUAL(k->kind->bytes(limits, &bytes), expected);
  CHECK_UNTOUCHED(bytes);
  CHECK_EQUAL(k->kind->init(memory, sizeof memory, limits, &made), expected);
  CHECK_UNTOUCHED(made);
  CHECK_UNTOUCHED(memory);
}

static void bad_limits(const kind_of_limits *k) {
  static const uint32_t too_many[] = {HSP_MAX_BALLS + 1, HSP_NONE};
  const uint32_t size = k->kind->struct_size;
  const uint32_t sizes[] = {0, size - 4, size + 2, 1028, HSP_NONE};
  limit_numbers limits = k->small;
  size_t i;
  int which;
  check_scene("%s, no limits", k->name);
  CHECK_EQUAL(k->kind->bytes(&limits, NULL), HSP_E_ARGUMENT);
  check_refused(k, NULL, HSP_E_ARGUMENT);
  for (i = 0; i < sizeof sizes / sizeof sizes[0]; ++i) {
    check_scene("%s, struct_size %u", k->name, (unsigned)sizes[i]);
    limits.number[0] = sizes[i];
    check_refused(k, &limits, HSP_E_VERSION);
  }
  for (which = 1; which < number_count(k->kind); ++which) {
    const int reserved = k->kind->names[which] == NULL;
    for (i = 0; i < 2; ++i) {
      check_scene("%s, %s too large", k->name, reserved ? "a reserved number" : k->kind->names[which]);
      limits = k->small;
      limits.number[which] = reserved ? (uint32_t)i + 1 : too_many[i];
      check_refused(k, &limits, reserved ? HSP_E_VERSION : HSP_E_RANGE);
    }
  }
}

/* An array of more than 2^32 items, the size of which no handle knows. */
static void too_large_arrays(void) {
  const limit_numbers surface = {{(uint32_t)sizeof(hsp_surface_limits), SMALL, SMALL, HSP_MAX_BALLS, 8, 40, 2}};
  const limit_numbers boundary = {{(uint32_t)sizeof(hsp_boundary_limits), SMALL, HSP_MAX_BALLS, 16, 16}};
  size_t bytes = 0;
  check_scene("arrays that are too large");
  CHECK_EQUAL(surface_handle.bytes(&surface, &bytes), HSP_E_RANGE);
  CHECK(sizeof(size_t) == 4 || boundary_handle.bytes(&boundary, &bytes) == HSP_OK);
}

static void bad_memory(const kind_of_limits *k) {
  unsigned char *memory, *pattern;
  void *made;
  size_t bytes = 0;
  check_scene("%s, memory", k->name);
  FILL(made);
  CHECK_EQUAL(k->kind->bytes(&k->small, &bytes), HSP_OK);
  memory = test_zeros(bytes, 1);
  pattern = test_zeros(bytes, 1);
  memset(memory, PATTERN, bytes);
  memset(pattern, PATTERN, bytes);
  CHECK_EQUAL(k->kind->init(NULL, bytes, &k->small, &made), HSP_E_ARGUMENT);
  CHECK_EQUAL(k->kind->init(memory, bytes, &k->small, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(k->kind->init(memory, 0, &k->small, &made), HSP_E_MEMORY);
  CHECK_EQUAL(k->kind->init(memory, 100, &k->small, &made), HSP_E_MEMORY);
  CHECK_EQUAL(k->kind->init(memory, bytes - 1, &k->small, &made), HSP_E_MEMORY);
  CHECK_UNTOUCHED(made);
  CHECK_BYTES(memory, pattern, bytes);
  CHECK_EQUAL(k->kind->init(memory, bytes, &k->small, &made), HSP_OK);
  CHECK((unsigned char *)made >= memory && (unsigned char *)made < memory + bytes);
  free(memory);
  free(pattern);
}

int main(void) {
  int i;
  for (i = 0; i < KINDS; ++i) {
    check_scene("%s", kinds[i].name);
    if (kinds[i].kind->limits_init != NULL) limits_init(&kinds[i]);
    bad_limits(&kinds[i]);
    bad_memory(&kinds[i]);
  }
  too_large_arrays();
  return check_report();
}
