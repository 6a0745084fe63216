/* counted_TARGET BALLS: runs Steps 1 and 2 and queries once on the balls of a file that counted_stages has written,
 * for target_budgets.sh to count their instructions. After each stage it prints a line as counted_stages does: stage,
 * molecule, surface, number of balls. */
#include <hardsphere.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

enum { MOST_BALLS = 1000, MOST_HITS = 4096, MOST_IDS = MOST_BALLS * 100 };

static double xyz[3 * MOST_BALLS], radius[MOST_BALLS], point[3 * MOST_BALLS];
static uint32_t count, needed, ids[MOST_IDS], first[MOST_BALLS + 1];
static double largest;
static hsp_model *model;
static hsp_boundary *boundary;

static void expect_ok(int32_t status) {
  if (status == HSP_OK) return;
  fprintf(stderr, "counted_target: %s\n", hsp_status_text(status));
  exit(1);
}

static void *taken(size_t bytes) {
  void *const memory = malloc(bytes);
  if (memory == NULL) exit(1);
  return memory;
}

static void compute_boundary(void) {
  expect_ok(hsp_boundary_compute(boundary, model, NULL));
}
static void query_balls(void) {
  uint32_t i;
  for (i = 0; i < count; ++i) expect_ok(hsp_query_ball(model, point + 3 * i, largest, ids, MOST_HITS, &needed));
}
static void query_neighbours(void) {
  uint32_t i;
  for (i = 0; i < count; ++i) expect_ok(hsp_query_neighbours(model, i, ids, MOST_HITS, &needed));
}
static void query_pairs(void) {
  expect_ok(hsp_query_pairs(model, 0, first, ids, MOST_IDS, &needed));
}

/* The counters know these by their names. */
__attribute__((noinline)) void stage_begins(void);
__attribute__((noinline)) void stage_begins(void) {
  __asm__ volatile("");
}
__attribute__((noinline)) void stage_ends(void);
__attribute__((noinline)) void stage_ends(void) {
  __asm__ volatile("");
}

/* The first run leaves memory and limits as those of a repeated call. */
static void count_stage(const char *stage, const char *surface, void (*run)(void)) {
  run();
  stage_begins();
  run();
  stage_ends();
  printf("%s crambin %s %" PRIu32 "\n", stage, surface, count);
}

static void count_stages(const char *surface, double probe) {
  hsp_model_options options;
  hsp_model_info info;
  expect_ok(hsp_model_options_init(&options, sizeof options));
  options.probe = probe;
  expect_ok(hsp_model_set(model, count, xyz, radius, &options, NULL));
  expect_ok(hsp_model_get_info(model, &info));
  largest = info.largest_radius;
  count_stage("boundary", surface, compute_boundary);
  count_stage("query_ball", surface, query_balls);
  count_stage("query_neighbours", surface, query_neighbours);
  count_stage("query_pairs", surface, query_pairs);
}

int main(int argc, char **argv) {
  FILE *const balls = argc == 2 ? fopen(argv[1], "r") : NULL;
  hsp_boundary_limits limits;
  size_t bytes = 0;
  if (balls == NULL) return 2;
  while (count < MOST_BALLS) {
    double *const x = xyz + 3 * count, *const p = point + 3 * count;
    if (fscanf(balls, "%lf %lf %lf %lf %lf %lf %lf", x, x + 1, x + 2, radius + count, p, p + 1, p + 2) != 7) break;
    ++count;
  }
  fclose(balls);
  expect_ok(hsp_model_bytes(count, &bytes));
  expect_ok(hsp_model_init(taken(bytes), bytes, count, &model));
  expect_ok(hsp_boundary_limits_init(&limits, sizeof limits, count));
  expect_ok(hsp_boundary_bytes(&limits, &bytes));
  expect_ok(hsp_boundary_init(taken(bytes), bytes, &limits, &boundary));
  count_stages("van_der_waals", 0);
  count_stages("solvent_accessible", 1.4);
  return 0;
}
