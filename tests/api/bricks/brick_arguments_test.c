/* Summaries of bricks: two balls in closed form, arguments that are refused, memory of every size, faults and the brick
 * that they name. */
#include <hardsphere.h>
#include <string.h>

#include "check.h"
#include "computed.h"
#include "untouched.h"

enum { BALLS = 2, BYTES = 20000 };
static const double xyz[BALLS][3] = {{0, 0, 0}, {8, 0, 0}}, radius[BALLS] = {5, 5};
static const double pi = 3.14159265358979323846;
static uint64_t id[BALLS] = {7, 1000000000007};
static uint32_t owner[BALLS] = {0, 1};
static uint8_t memory[BYTES];

typedef struct summary {
  uint8_t byte[4096];
  size_t bytes;
} summary;

static hsp_brick_request request_of(uint32_t brick, uint32_t bricks, uint32_t flags) {
  hsp_brick_request request;
  memset(&request, 0, sizeof request);
  request.struct_size = sizeof request;
  request.brick = brick;
  request.bricks = bricks;
  request.flags = flags;
  request.id = id;
  request.owner = owner;
  return request;
}

/* With one brick it owns all. */
static summary summarised(const hsp_boundary *boundary, uint32_t brick, uint32_t bricks, uint32_t flags) {
  const hsp_brick_request request = request_of(brick, bricks, flags);
  summary result;
  size_t bytes = sizeof memory;
  if (bricks == 1) owner[1] = 0;
  CHECK_EQUAL(hsp_brick_summarise(boundary, &request, memory, &bytes, NULL), HSP_OK);
  owner[1] = 1;
  memset(&result, 0, sizeof result);
  if (!CHECK(bytes <= sizeof result.byte)) bytes = 0;
  memcpy(result.byte, memory, bytes);
  result.bytes = bytes;
  return result;
}

static int32_t merge(const summary *a, const summary *b, summary *merged, uint32_t *brick) {
  size_t bytes = sizeof memory;
  const int32_t status = hsp_brick_merge(a->byte, a->bytes, b->byte, b->bytes, NULL, memory, &bytes, brick);
  if (status != HSP_OK || !CHECK(bytes <= sizeof merged->byte)) return status;
  memcpy(merged->byte, memory, bytes);
  merged->bytes = bytes;
  return status;
}

/* Each ball has the area 90 pi and a circle of radius 3; the volume is twice a ball less a cap. */
static void closed_forms(const hsp_boundary *boundary) {
  const summary first = summarised(boundary, 0, 2, HSP_BRICK_KEEP_SHELLS);
  const summary second = summarised(boundary, 1, 2, HSP_BRICK_KEEP_SHELLS);
  summary whole;
  hsp_brick_totals totals;
  hsp_brick_shell shell;
  uint32_t brick = 5, needed = 0;
  check_scene("two balls, each a brick");
  CHECK_EQUAL(hsp_brick_get_totals(first.byte, first.bytes, &totals, &brick), HSP_E_STATE);
  CHECK_EQUAL(brick, 1);
  CHECK_EQUAL(hsp_brick_get_totals(second.byte, second.bytes, &totals, &brick), HSP_E_STATE);
  CHECK_EQUAL(brick, 0);
  CHECK_EQUAL(merge(&second, &first, &whole, &brick), HSP_OK);
  CHECK_EQUAL(brick, HSP_NONE);
  CHECK_EQUAL(hsp_brick_get_totals(whole.byte, whole.bytes, &totals, NULL), HSP_OK);
  CHECK(totals.balls == 2 && totals.exposed_balls == 2 && totals.contained_balls == 0 && totals.vertices == 0);
  CHECK(totals.arcs == 0 && totals.circles == 1 && totals.faces == 2 && totals.loops == 2 && totals.shells == 1);
  CHECK(totals.components == 1 && totals.voids == 0 && totals.tied_vertices == 0 && totals.euler == 2);
  CHECK_NEAR(totals.area, 180 * pi, 1e-12 * totals.area);
  CHECK_NEAR(totals.volume, 324 * pi, 1e-12 * totals.volume);
  CHECK(totals.void_volume == 0 && totals.reserved[0] == 0 && totals.reserved[1] == 0);
  CHECK_EQUAL(hsp_brick_get_shells(whole.byte, whole.bytes, NULL, 0, &needed, &brick), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, 1);
  CHECK_EQUAL(hsp_brick_get_shells(whole.byte, whole.bytes, &shell, 1, &needed, &brick), HSP_OK);
  CHECK(shell.component == 7 && shell.faces == 2 && shell.euler == 2 && shell.kind == HSP_SHELL_OUTER);
  CHECK(shell.area == totals.area && shell.volume == totals.volume);
  CHECK(shell.reserved[0] == 0 && shell.reserved[1] == 0 && shell.reserved[2] == 0);
}

/* The check sum, which ends a block, depends on every byte of it: on big-endian machines, too, and for every target. A
 * change of the format, or of last bits of areas, is seen here. */
static void bytes_are_the_same_everywhere(const hsp_boundary *boundary) {
  static const uint8_t expected[2][8] = {{0xF6, 0x25, 0x88, 0x5E, 0x10, 0x6C, 0x6F, 0xE1},
                                         {0xE0, 0xBC, 0x35, 0xAB, 0xBF, 0xDF, 0xAB, 0x3B}};
  uint32_t brick;
  for (brick = 0; brick < 2; ++brick) {
    const summary part = summarised(boundary, brick, 2, 0);
    check_scene("the check sum of brick %u", (unsigned)brick);
    CHECK_EQUAL(part.bytes, 560);
    CHECK_BYTES(part.byte + part.bytes - 8, expected[brick], 8);
  }
}

/* The inner ball touches the other one at the highest point, and comes first: it has none of the surface. */
static void highest_point_of_two(void) {
  static const double centre[BALLS][3] = {{0, 0, 3}, {0, 0, 0}}, radii[BALLS] = {2, 5};
  computed c;
  summary whole;
  hsp_brick_totals totals;
  check_scene("a ball that touches another from inside at its top");
  if (!CHECK_EQUAL(computed_make(BALLS, centre[0], radii, NULL, &c), HSP_OK)) return;
  whole = summarised(c.boundary, 0, 1, 0);
  CHECK_EQUAL(hsp_brick_get_totals(whole.byte, whole.bytes, &totals, NULL), HSP_OK);
  CHECK(totals.shells == 1 && totals.voids == 0 && totals.contained_balls == 1);
  CHECK_NEAR(totals.area, 100 * pi, 1e-12 * totals.area);
  CHECK_NEAR(totals.volume, 500 * pi / 3, 1e-12 * totals.volume);
  computed_release(&c);
}

static void shells_that_were_not_kept(const hsp_boundary *boundary) {
  const summary whole = summarised(boundary, 0, 1, 0);
  hsp_brick_shell shell;
  uint32_t needed = 0, brick = 5;
  check_scene("shells that were not kept");
  FILL(shell);
  CHECK_EQUAL(hsp_brick_get_shells(whole.byte, whole.bytes, &shell, 1, &needed, &brick), HSP_E_STATE);
  CHECK_EQUAL(brick, HSP_NONE);
  CHECK_UNTOUCHED(shell);
}

/* A call that fails reports how many bytes suffice, or more than before. */
static void every_size(const hsp_boundary *boundary) {
  const hsp_brick_request request = request_of(0, 2, 0);
  const summary first = summarised(boundary, 0, 2, 0), second = summarised(boundary, 1, 2, 0);
  size_t size, suffices = 0, merged_in = 0;
  check_scene("a summary in memory of every size");
  for (size = 0; size < BYTES; ++size) {
    size_t bytes = size;
    const int32_t status = hsp_brick_summarise(boundary, &request, size > 0 ? memory : NULL, &bytes, NULL);
    if (status == HSP_OK) {
      if (suffices == 0) suffices = size;
      CHECK_EQUAL(bytes, first.bytes);
      CHECK_BYTES(memory, first.byte, first.bytes);
      if (size > suffices + 300) break;
    } else {
      CHECK_EQUAL(status, HSP_E_CAPACITY);
      CHECK(suffices == 0 && bytes > size);
    }
  }
  CHECK(suffices > first.bytes && suffices < 4096);
  check_scene("a merge in memory of every size");
  for (size = 0; size < BYTES; ++size) {
    size_t bytes = size;
    const int32_t status = hsp_brick_merge(first.byte, first.bytes, second.byte, second.bytes, NULL,
                                           size > 0 ? memory : NULL, &bytes, NULL);
    if (merged_in == 0) {
      CHECK(status == HSP_E_CAPACITY);
      merged_in = bytes;
    }
    CHECK_EQUAL(status, size < merged_in ? HSP_E_CAPACITY : HSP_OK);
    CHECK(size < merged_in ? bytes == merged_in : bytes < merged_in);
    if (size > merged_in + 64) break;
  }
}

static void refused(hsp_boundary *boundary) {
  hsp_brick_request request = request_of(0, 2, 0);
  uint32_t first_bad = 9;
  size_t bytes = sizeof memory;
  check_scene("a summary that is refused");
  FILL(memory);
  CHECK_EQUAL(hsp_brick_summarise(NULL, &request, memory, &bytes, &first_bad), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_brick_summarise(boundary, NULL, memory, &bytes, &first_bad), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_brick_summarise(boundary, &request, NULL, &bytes, &first_bad), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_brick_summarise(boundary, &request, memory, NULL, &first_bad), HSP_E_ARGUMENT);
  request.brick = 2;
  CHECK_EQUAL(hsp_brick_summarise(boundary, &request, memory, &bytes, &first_bad), HSP_E_ARGUMENT);
  request = request_of(0, 2, 2);
  CHECK_EQUAL(hsp_brick_summarise(boundary, &request, memory, &bytes, &first_bad), HSP_E_ARGUMENT);
  request = request_of(0, 2, 0);
  request.id = NULL;
  CHECK_EQUAL(hsp_brick_summarise(boundary, &request, memory, &bytes, &first_bad), HSP_E_ARGUMENT);
  request = request_of(0, 2, 0);
  request.owner = NULL;
  CHECK_EQUAL(hsp_brick_summarise(boundary, &request, memory, &bytes, &first_bad), HSP_E_ARGUMENT);
  request = request_of(0, 2, 0);
  request.struct_size = 1;
  CHECK_EQUAL(hsp_brick_summarise(boundary, &request, memory, &bytes, &first_bad), HSP_E_VERSION);
  CHECK_EQUAL(first_bad, HSP_NONE);
  request = request_of(0, 2, 0);
  owner[1] = 2;
  CHECK_EQUAL(hsp_brick_summarise(boundary, &request, memory, &bytes, &first_bad), HSP_E_ID);
  CHECK_EQUAL(first_bad, 1);
  owner[1] = 1;
  id[0] = id[1];
  first_bad = 9;
  CHECK_EQUAL(hsp_brick_summarise(boundary, &request, memory, &bytes, &first_bad), HSP_E_ID);
  CHECK_EQUAL(first_bad, 1);
  id[0] = 7;
  CHECK_UNTOUCHED(memory);
  CHECK_EQUAL(bytes, sizeof memory);
}

/* Every bit of a block counts, and so does its length. */
static void damage(const hsp_boundary *boundary) {
  summary whole = summarised(boundary, 0, 1, 0), part = summarised(boundary, 0, 2, 0);
  const summary other = summarised(boundary, 1, 2, 0);
  hsp_brick_totals totals;
  summary merged;
  size_t k, bytes = whole.bytes;
  uint32_t brick = 5;
  check_scene("bits that are turned around");
  for (k = 0; k < 8 * part.bytes; ++k) {
    part.byte[k / 8] = (uint8_t)(part.byte[k / 8] ^ 1U << k % 8);
    CHECK_EQUAL(merge(&part, &other, &merged, &brick), HSP_E_DAMAGED);
    CHECK_EQUAL(merge(&other, &part, &merged, &brick), HSP_E_DAMAGED);
    part.byte[k / 8] = (uint8_t)(part.byte[k / 8] ^ 1U << k % 8);
  }
  CHECK_EQUAL(brick, HSP_NONE);
  check_scene("bytes that are missing");
  for (k = 0; k < bytes; ++k) {
    CHECK_EQUAL(hsp_brick_get_totals(whole.byte, k, &totals, NULL), HSP_E_DAMAGED);
    CHECK_EQUAL(hsp_brick_get_shells(whole.byte, k, NULL, 0, NULL, NULL), HSP_E_DAMAGED);
  }
  CHECK_EQUAL(hsp_brick_get_totals(whole.byte, bytes + 4, &totals, NULL), HSP_E_DAMAGED);
  CHECK_EQUAL(hsp_brick_get_totals(whole.byte, bytes, &totals, NULL), HSP_OK);
}

static void faults(const hsp_boundary *boundary) {
  const summary first = summarised(boundary, 0, 2, 0), second = summarised(boundary, 1, 2, 0);
  const summary of_three = summarised(boundary, 1, 3, 0), kept = summarised(boundary, 1, 2, HSP_BRICK_KEEP_SHELLS);
  uint32_t brick = 5, other = 5;
  summary merged, lonely;
  size_t bytes = sizeof memory;
  check_scene("parts that do not fit");
  CHECK_EQUAL(merge(&first, &first, &merged, &brick), HSP_E_ID);
  CHECK_EQUAL(brick, 0);
  CHECK_EQUAL(merge(&first, &of_three, &merged, &brick), HSP_E_ARGUMENT);
  CHECK_EQUAL(brick, 1);
  CHECK_EQUAL(merge(&second, &kept, &merged, &brick), HSP_E_ARGUMENT);
  const hsp_executor older = {1, 1, NULL, NULL, NULL}, without_run = {sizeof without_run, 2, NULL, NULL, NULL};
  bytes = 0;
  CHECK_EQUAL(hsp_brick_merge(first.byte, first.bytes, second.byte, second.bytes, &older, NULL, &bytes, &brick),
              HSP_E_VERSION);
  CHECK_EQUAL(hsp_brick_merge(first.byte, first.bytes, second.byte, second.bytes, &without_run, NULL, &bytes, &brick),
              HSP_E_ARGUMENT);
  bytes = sizeof memory;
  CHECK_EQUAL(hsp_brick_merge(NULL, 0, second.byte, second.bytes, NULL, memory, &bytes, &brick), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_brick_merge(first.byte, first.bytes, NULL, 0, NULL, memory, &bytes, &brick), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_brick_merge(first.byte, first.bytes, second.byte, second.bytes, NULL, NULL, &bytes, NULL),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_brick_merge(first.byte, first.bytes, second.byte, second.bytes, NULL, memory, NULL, NULL),
              HSP_E_ARGUMENT);
  check_scene("a brick that does not know of its neighbour");
  owner[1] = 0;
  lonely = summarised(boundary, 1, 2, 0); /* which owns nothing, and has no seam */
  CHECK_EQUAL(merge(&first, &lonely, &merged, &brick), HSP_E_CONFLICT);
  CHECK_EQUAL(merge(&lonely, &first, &merged, &other), HSP_E_CONFLICT);
  CHECK(brick == 1 && other == 1);
}

int main(void) {
  computed c;
  if (!CHECK_EQUAL(computed_make(BALLS, xyz[0], radius, NULL, &c), HSP_OK)) return check_report();
  closed_forms(c.boundary);
  bytes_are_the_same_everywhere(c.boundary);
  highest_point_of_two();
  shells_that_were_not_kept(c.boundary);
  every_size(c.boundary);
  refused(c.boundary);
  damage(c.boundary);
  faults(c.boundary);
  computed_release(&c);
  return check_report();
}
