/* The limits of a view: what the functions that fill them say, and every limit, size and memory that is refused. */
#include <hardsphere.h>

#include "check.h"
#include "untouched.h"

enum { BALLS = 3, NEIGHBOURS = 3, ARCS = 40 };
static unsigned char view_memory[HSP_VIEW_BYTES(BALLS, NEIGHBOURS, ARCS)];

static hsp_view_limits good_limits(void) {
  hsp_view_limits limits;
  CHECK_EQUAL(hsp_view_limits_init(&limits, (uint32_t)sizeof limits, BALLS), HSP_OK);
  limits.neighbours = NEIGHBOURS;
  limits.arcs = ARCS;
  return limits;
}

static void limits_init(void) {
  static const uint32_t numbers[] = {0, 1, 2, 255, 256, 257, 4392, 1000000};
  const uint32_t most = (HSP_MAX_BALLS - 64) / 12;
  hsp_view_limits limits;
  size_t i;
  FILL(limits);
  CHECK_EQUAL(hsp_view_limits_init(NULL, (uint32_t)sizeof limits, 1), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_view_limits_init(&limits, 0, 1), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_view_limits_init(&limits, (uint32_t)sizeof limits - 4, 1), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_view_limits_init(&limits, (uint32_t)sizeof limits + 4, 1), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_view_limits_init(&limits, (uint32_t)sizeof limits, most + 1), HSP_E_RANGE);
  CHECK_EQUAL(hsp_view_limits_init(&limits, (uint32_t)sizeof limits, HSP_MAX_BALLS), HSP_E_RANGE);
  CHECK_EQUAL(hsp_view_limits_init(&limits, (uint32_t)sizeof limits, HSP_NONE), HSP_E_RANGE);
  CHECK_UNTOUCHED(limits);
  CHECK_EQUAL(hsp_view_limits_init(&limits, (uint32_t)sizeof limits, most), HSP_OK);
  CHECK(limits.arcs <= HSP_MAX_BALLS);
  for (i = 0; i < sizeof numbers / sizeof numbers[0]; ++i) {
    const uint32_t n = numbers[i];
    check_scene("limits for %u balls", (unsigned)n);
    FILL(limits);
    CHECK_EQUAL(hsp_view_limits_init(&limits, (uint32_t)sizeof limits, n), HSP_OK);
    CHECK_EQUAL(limits.struct_size, sizeof limits);
    CHECK_EQUAL(limits.balls, n);
    CHECK_EQUAL(limits.neighbours, n < 256 ? n : 256);
    CHECK_EQUAL(limits.arcs, 12 * n + 64);
  }
  check_scene("%s", "");
}

static void check_bad_limits(const hsp_view_limits *limits, int32_t expected) {
  size_t bytes;
  hsp_view *made;
  FILL(bytes);
  FILL(made);
  FILL(view_memory);
  CHECK_EQUAL(hsp_view_bytes(limits, &bytes), expected);
  CHECK_UNTOUCHED(bytes);
  CHECK_EQUAL(hsp_view_init(view_memory, sizeof view_memory, limits, &made), expected);
  CHECK_UNTOUCHED(made);
  CHECK_UNTOUCHED(view_memory);
}

static void bytes_and_init(void) {
  hsp_view_limits limits = good_limits();
  hsp_view *made;
  size_t bytes;
  FILL(made);
  CHECK_EQUAL(hsp_view_bytes(&limits, NULL), HSP_E_ARGUMENT);
  check_bad_limits(NULL, HSP_E_ARGUMENT);
  limits.struct_size = 0;
  check_bad_limits(&limits, HSP_E_ARGUMENT);
  limits.struct_size = (uint32_t)sizeof limits - 4;
  check_bad_limits(&limits, HSP_E_ARGUMENT);
  limits.struct_size = (uint32_t)sizeof limits + 4;
  check_bad_limits(&limits, HSP_E_ARGUMENT);
  limits = good_limits();
  limits.balls = HSP_MAX_BALLS + 1;
  check_bad_limits(&limits, HSP_E_RANGE);
  limits = good_limits();
  limits.neighbours = HSP_NONE;
  check_bad_limits(&limits, HSP_E_RANGE);
  limits = good_limits();
  limits.arcs = HSP_MAX_BALLS + 1;
  check_bad_limits(&limits, HSP_E_RANGE);

  limits = good_limits();
  CHECK_EQUAL(hsp_view_bytes(&limits, &bytes), HSP_OK);
  CHECK_EQUAL(hsp_view_init(NULL, sizeof view_memory, &limits, &made), HSP_E_ARGUMENT);
  FILL(view_memory);
  CHECK_EQUAL(hsp_view_init(view_memory, sizeof view_memory, &limits, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_view_init(view_memory, 0, &limits, &made), HSP_E_MEMORY);
  CHECK_EQUAL(hsp_view_init(view_memory, 100, &limits, &made), HSP_E_MEMORY);
  CHECK_EQUAL(hsp_view_init(view_memory, bytes - 1, &limits, &made), HSP_E_MEMORY);
  CHECK_UNTOUCHED(made);
  CHECK_UNTOUCHED(view_memory);
  CHECK_EQUAL(hsp_view_init(view_memory, sizeof view_memory, &limits, &made), HSP_OK);
}

int main(void) {
  limits_init();
  bytes_and_init();
  return check_report();
}
