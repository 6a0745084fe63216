/* The limits of a view and its memory: what the functions that fill them say, every limit, size and memory that is
 * refused, the size macro, and memory of every alignment. */
#include <hardsphere.h>

#include "ball_sets.h"
#include "check.h"
#include "guarded_memory.h"
#include "untouched.h"
#include "view_result.h"

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

/* Where size_t has 32 bits, sizes of 2 GiB and more are refused, and only they: SIZE_MAX stands for them, so that
 * property 2 covers them. */
static size_t bytes_of(uint32_t balls, uint32_t neighbours, uint32_t arcs) {
  hsp_view_limits limits;
  size_t bytes = 0;
  limits.struct_size = (uint32_t)sizeof limits;
  limits.balls = balls;
  limits.neighbours = neighbours;
  limits.arcs = arcs;
  if (hsp_view_bytes(&limits, &bytes) == HSP_OK) return bytes;
  CHECK_EQUAL(hsp_view_bytes(&limits, &bytes), HSP_E_RANGE);
  CHECK(32768.0 + 192.0 * balls + 384.0 * neighbours + 64.0 * arcs > (double)(SIZE_MAX / 2));
  return SIZE_MAX;
}

static void sizes(void) {
  static const uint32_t box[] = {0, 1, 2, 3, 7, 8, 9, 64, 65, 1000, 4097, 65535, 1000000, 0x0FFFFFFE, 0x0FFFFFFF};
  enum { BOX = sizeof box / sizeof box[0] };
  int a, b, c;
  for (a = 0; a < BOX; ++a) {
    for (b = 0; b < BOX; ++b) {
      for (c = 0; c < BOX; ++c) {
        const size_t bytes = bytes_of(box[a], box[b], box[c]);
        check_scene("limits %u %u %u", (unsigned)box[a], (unsigned)box[b], (unsigned)box[c]);
        /* hsp_view_bytes, property 1: at most HSP_VIEW_BYTES of the three limits */
        CHECK(bytes == SIZE_MAX || bytes <= HSP_VIEW_BYTES(box[a], box[b], box[c]));
        /* hsp_view_bytes, property 2: grows with each limit */
        if (a > 0) CHECK(bytes >= bytes_of(box[a - 1], box[b], box[c]));
        if (b > 0) CHECK(bytes >= bytes_of(box[a], box[b - 1], box[c]));
        if (c > 0) CHECK(bytes >= bytes_of(box[a], box[b], box[c - 1]));
      }
    }
  }
  check_scene("%s", "");
  for (a = 0; a < 600; ++a) CHECK(bytes_of((uint32_t)a, (uint32_t)a / 2, 3) <= HSP_VIEW_BYTES(a, a / 2, 3));
  CHECK(bytes_of(1000, 50, 1000) < bytes_of(2000, 50, 1000));
  CHECK(bytes_of(1000, 50, 1000) < bytes_of(1000, 500, 1000));
  CHECK(bytes_of(1000, 50, 1000) < bytes_of(1000, 50, 2000));
}

static void every_alignment(void) {
  static ball_set set;
  computed c;
  view_result all;
  hsp_view_options options;
  size_t misalignment, bytes = 0;
  ball_set_start(&set, "chain", 1e-8);
  ball_set_add_chain(&set, 30, 5);
  CHECK_EQUAL(hsp_view_options_init(&options, (uint32_t)sizeof options), HSP_OK);
  CHECK_EQUAL(computed_make(set.n, set.xyz, set.radius, NULL, &c), HSP_OK);
  CHECK_EQUAL(view_result_make(&c, &options, 0, &all), HSP_OK);
  CHECK_EQUAL(hsp_view_bytes(&all.needed, &bytes), HSP_OK);
  CHECK(all.info.arcs > 10);
  for (misalignment = 0; misalignment < 16; ++misalignment) {
    guarded_memory memory = guarded_take(bytes, misalignment, GUARDED_RANDOM);
    guarded_memory less = guarded_take(bytes - 1, misalignment, GUARDED_PATTERN);
    guarded_memory arcs = guarded_take(all.info.arcs * sizeof *all.arcs, 0, GUARDED_PATTERN);
    hsp_view *view = NULL;
    uint32_t needed = 0;
    check_scene("misalignment %u", (unsigned)misalignment);
    CHECK_EQUAL(hsp_view_init(less.block, bytes - 1, &all.needed, &view), HSP_E_MEMORY);
    CHECK(view == NULL);
    CHECK(guarded_untouched(&less, GUARDED_PATTERN) && guarded_clean(&less));
    CHECK_EQUAL(hsp_view_init(memory.block, bytes, &all.needed, &view), HSP_OK);
    CHECK((unsigned char *)view >= memory.block && (unsigned char *)view < memory.block + bytes);
    CHECK_EQUAL(hsp_view_compute(view, c.model, NULL, NULL), HSP_OK);
    CHECK_EQUAL(hsp_view_get_arcs(view, (void *)arcs.block, all.info.arcs, &needed), HSP_OK);
    CHECK_EQUAL(needed, all.info.arcs);
    CHECK_BYTES(arcs.block, all.arcs, arcs.bytes);
    CHECK(guarded_clean(&memory) && guarded_clean(&arcs));
    guarded_give_back(&memory);
    guarded_give_back(&less);
    guarded_give_back(&arcs);
  }
  check_scene("%s", "");
  view_result_release(&all);
  computed_release(&c);
}

int main(void) {
  limits_init();
  bytes_and_init();
  sizes();
  every_alignment();
  return check_report();
}
