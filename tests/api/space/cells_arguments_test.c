/* Cells of free space: arguments that tests/laws says nothing about, every call out of order, and what records say of
 * balls whose cells can be counted by hand. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "topology_result.h"
#include "untouched.h"

enum { CAGE = 26, CUBES = 64, ENTRIES = 512, CELLS = 800, PAIRS = 4000, MARKS = 1000, FACETS = 2000, CORNERS = 9000 };
enum { IN_CUBE = CAGE, IN_CUBE_CORNERS = 1200 };
static unsigned char model_memory[HSP_MODEL_BYTES(CAGE)];
static unsigned char
    cells_memory[HSP_CELLS_BYTES(CUBES, ENTRIES, CELLS, PAIRS, MARKS, FACETS, CORNERS, IN_CUBE, IN_CUBE_CORNERS)];
static hsp_model *model;
static hsp_cells *cells;
static hsp_cells_counts counts;
static hsp_free_cell records[CELLS];
static hsp_cell_pair pairs[PAIRS];
static uint32_t neighbours[CELLS], number;
static uint32_t invariant, violated_at;

/* A ball in the middle of a cube of the grid, whose side is 4: nothing but one power cell, of the whole cube. */
static const double one_xyz[3] = {2, 2, 2}, one_radius[1] = {2};

static hsp_cells_limits good_limits(void) {
  const hsp_cells_limits limits = {
      (uint32_t)sizeof limits, CUBES, ENTRIES, CELLS, PAIRS, MARKS, FACETS, CORNERS, IN_CUBE, IN_CUBE_CORNERS};
  return limits;
}

static void check_no_results(hsp_cells *which, int32_t status) {
  CHECK_EQUAL(hsp_cells_check(which, NULL, &invariant, &violated_at), status);
}

static void set_one(void) {
  CHECK_EQUAL(hsp_model_set(model, 1, one_xyz, one_radius, NULL, NULL), HSP_OK);
}

static void check_has_results(void) {
  CHECK_EQUAL(hsp_cells_compute(cells, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_cells_check(cells, NULL, &invariant, &violated_at), HSP_OK);
  CHECK(invariant == 0 && violated_at == HSP_NONE);
  CHECK_EQUAL(hsp_cells_get_counts(cells, &counts), HSP_OK);
}

static void default_limits(void) {
  hsp_cells_limits limits;
  CHECK_EQUAL(hsp_cells_limits_init(&limits, (uint32_t)sizeof limits, (HSP_MAX_BALLS - 2048) / 80 + 1), HSP_E_RANGE);
  CHECK_EQUAL(hsp_cells_limits_init(&limits, (uint32_t)sizeof limits, 10), HSP_OK);
  CHECK(limits.cubes == 84 && limits.entries == 144 && limits.cells == 356 && limits.adjacencies == 1424 &&
        limits.landmarks == 672);
  CHECK(limits.facets == 672 && limits.corners == 2848 && limits.cube_balls == 10 && limits.cube_corners == 464);
  CHECK_EQUAL(hsp_cells_limits_init(&limits, (uint32_t)sizeof limits, 1000), HSP_OK);
  CHECK(limits.cube_balls == 192 && limits.cube_corners == 192 * 40 + 64);
}

/* Much of one thing, and of all. */
static void sizes(void) {
  int which;
  for (which = 0; which < 10; ++which) {
    uint32_t n[10] = {0};
    hsp_cells_limits limits;
    size_t bytes = 0;
    int other;
    for (other = 1; other < 10; ++other) n[other] = which == 0 || which == other ? 100000 : 0;
    n[0] = (uint32_t)sizeof limits;
    memcpy(&limits, n, sizeof limits);
    CHECK_EQUAL(hsp_cells_bytes(&limits, &bytes), HSP_OK);
    CHECK(bytes > 0 && bytes <= HSP_CELLS_BYTES(n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9]));
    limits.cube_balls = HSP_MAX_BALLS; /* an array of more than 2^32 items */
    CHECK_EQUAL(hsp_cells_bytes(&limits, &bytes), HSP_E_RANGE);
  }
}

static void computing(void) {
  hsp_cells_limits asked = good_limits();
  CHECK_EQUAL(hsp_cells_init(cells_memory, sizeof cells_memory, &asked, &cells), HSP_OK);
  set_one();
  check_has_results();
  CHECK_EQUAL(hsp_cells_get_cells(cells, counts.cells, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_cells_get_cells(cells, counts.cells, 1, records), HSP_E_ID);
  CHECK_EQUAL(hsp_cells_get_pairs(cells, counts.adjacencies, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_cells_get_pairs(cells, counts.adjacencies, 1, pairs), HSP_E_ID);
  CHECK_EQUAL(hsp_cells_get_neighbours(cells, counts.cells, neighbours, CELLS, &number), HSP_E_ID);
  CHECK_EQUAL(hsp_cells_get_neighbours(cells, 0, NULL, 0, &number), HSP_E_CAPACITY);
  CHECK(number > 0);
}

static uint32_t cell_at(double x, double y, double z) {
  const double xyz[3] = {x, y, z};
  uint32_t cell = 0;
  CHECK_EQUAL(hsp_cells_locate(cells, xyz, &cell), HSP_OK);
  return cell;
}

/* It touches the six cubes around its own, and there is nothing else but runs: below and above, before and behind each
 * of the three layers of cubes, and to the left and right of the five rows. */
static void one_ball(void) {
  uint32_t k, at_ball = 0, infinite = 0, seen;
  set_one();
  check_has_results();
  CHECK(counts.cubes == 7 && counts.power_cells == 7 && counts.regions == 1);
  CHECK_EQUAL(counts.runs, 2 + 6 + 10);
  CHECK_EQUAL(hsp_cells_get_cells(cells, 0, counts.cells, records), HSP_OK);
  for (k = 0; k < counts.cells; ++k) {
    const hsp_free_cell *cell = &records[k];
    CHECK(cell->region == 0 && cell->reserved == 0 && cell->neighbours > 0);
    CHECK((cell->kind == HSP_CELL_RUN) == (k < counts.runs));
    CHECK((cell->kind == HSP_CELL_RUN) == (cell->ball == HSP_NONE) &&
          (cell->ball == HSP_NONE) == (cell->cube == HSP_NONE));
    infinite += isinf(cell->low[0]) || isinf(cell->high[0]) ? 1U : 0U;
    if (cell->kind == HSP_CELL_RUN) continue;
    ++at_ball;
    CHECK(cell->kind == HSP_CELL_AT_BALL && cell->ball == 0 && fabs(cell->high[1] - cell->low[1] - 4) < 1e-9);
  }
  CHECK_EQUAL(at_ball, counts.cells - counts.runs);
  CHECK_EQUAL(infinite, counts.runs);
  CHECK(records[0].low[2] < 0 && isinf(records[0].low[2]) && fabs(records[0].high[2] + 4) < 1e-9);
  CHECK_EQUAL(cell_at(0, 0, -100), 0);
  CHECK_EQUAL(cell_at(2, 2, 2), HSP_NONE);
  CHECK_EQUAL(cell_at(2, 2, 4), HSP_NONE);
  k = cell_at(0.1, 0.1, 0.1);
  CHECK(k != HSP_NONE && records[k].kind == HSP_CELL_AT_BALL && records[k].low[0] == 0 && records[k].high[2] == 4);

  CHECK_EQUAL(hsp_cells_get_pairs(cells, 0, counts.adjacencies, pairs), HSP_OK);
  for (k = 0; k < counts.adjacencies; ++k) {
    uint32_t found = 0;
    CHECK(pairs[k].cell[0] < pairs[k].cell[1] && pairs[k].cell[1] < counts.cells);
    CHECK_EQUAL(hsp_cells_get_neighbours(cells, pairs[k].cell[1], neighbours, CELLS, &number), HSP_OK);
    CHECK_EQUAL(number, records[pairs[k].cell[1]].neighbours);
    for (seen = 0; seen < number; ++seen) found += neighbours[seen] == pairs[k].cell[0] ? 1U : 0U;
    CHECK_EQUAL(found, 1);
  }
}

/* Two balls of nearly the largest radius on the lattice, which has steps of 1e-9 here: one reaches over the face of its
 * cube, the other over the face of one two cubes on. Their squared distances from cubes need 64 bits without a sign. */
static void large_balls(void) {
  static const double xyz[6] = {1.050001, 1.05, 1.05, 5.250005, 1.05, 1.05}, radius[2] = {1.05, 1.05};
  CHECK_EQUAL(hsp_model_set(model, 2, xyz, radius, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK(counts.cubes == 12 && counts.regions == 1);
  CHECK(cell_at(1.05, 1.05, 1.05) == HSP_NONE && cell_at(5.25, 1.05, 1.05) == HSP_NONE);
  CHECK(cell_at(3.15, 1.05, 1.05) != HSP_NONE);
}

static uint32_t are_neighbours(uint32_t one, uint32_t other) {
  uint32_t k, found = 0;
  CHECK_EQUAL(hsp_cells_get_neighbours(cells, one, neighbours, CELLS, &number), HSP_OK);
  for (k = 0; k < number; ++k) found += neighbours[k] == other ? 1U : 0U;
  return found;
}

/* Two equal balls on both sides of the plane x = 0, in which cubes have sides: points of this plane, of the same power
 * to both, are of the ball that comes first, and a cell of no thickness between the cells on both sides. */
static void tied_side(void) {
  static const double xyz[6] = {1, 0, 0, -1, 0, 0}, radius[2] = {2, 2};
  uint32_t before, between, behind;
  CHECK_EQUAL(hsp_model_set(model, 2, xyz, radius, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(hsp_cells_get_cells(cells, 0, counts.cells, records), HSP_OK);
  before = cell_at(-1e-8, 3, 1);
  between = cell_at(0, 3, 1);
  behind = cell_at(1e-8, 3, 1);
  CHECK(records[before].ball == 1 && records[between].ball == 1 && records[behind].ball == 0);
  CHECK(records[before].high[0] == 0 && records[between].low[0] == 0 && records[behind].low[0] == 0);
  CHECK(between != before && are_neighbours(before, behind) == 0);
  CHECK(are_neighbours(before, between) == 1 && are_neighbours(between, behind) == 1);
}

/* A closed cage: what is in it is a region of its own, and it is open once one ball is away. */
static void cage(void) {
  double xyz[3 * CAGE], radius[CAGE];
  uint32_t n = 0, x, y, z;
  for (x = 0; x < 3; ++x) {
    for (y = 0; y < 3; ++y) {
      for (z = 0; z < 3; ++z) {
        if (x == 1 && y == 1 && z == 1) continue;
        xyz[3 * n] = 10.0 * x;
        xyz[3 * n + 1] = 10.0 * y;
        xyz[3 * n + 2] = 10.0 * z;
        radius[n++] = 7.5;
      }
    }
  }
  CHECK_EQUAL(hsp_model_set(model, n, xyz, radius, NULL, NULL), HSP_OK);
  check_has_results();
  CHECK_EQUAL(counts.regions, 2);
  CHECK_EQUAL(hsp_cells_get_cells(cells, 0, counts.cells, records), HSP_OK);
  CHECK_EQUAL(records[cell_at(10, 10, 10)].region, 1);
  CHECK_EQUAL(records[cell_at(10, 10, 100)].region, 0);
  radius[4] = 0;
  CHECK_EQUAL(hsp_model_set(model, n, xyz, radius, NULL, NULL), HSP_OK);
  check_no_results(cells, HSP_E_STATE);
  check_has_results();
  CHECK_EQUAL(counts.regions, 1);
}

/* With a topology, which must be one of the same model, and have results. */
static void checking(void) {
  static const double xyz[12] = {0, 0, 0, 2, 0, 0, 1, 1.5, 0, 9, 0, 0}, radius[4] = {1.5, 1.5, 1.25, 1};
  computed base;
  topology_result result;
  CHECK_EQUAL(computed_make(4, xyz, radius, NULL, &base), HSP_OK);
  CHECK_EQUAL(topology_result_make(&base, &result), HSP_OK);
  set_one();
  check_has_results();
  FILL(invariant);
  CHECK_EQUAL(hsp_cells_check(cells, result.topology, &invariant, &violated_at), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_cells_compute(cells, base.model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_topology_compute(result.topology, NULL, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_cells_check(cells, result.topology, &invariant, &violated_at), HSP_E_STATE);
  CHECK_UNTOUCHED(invariant);
  CHECK_EQUAL(hsp_topology_compute(result.topology, base.boundary, NULL), HSP_OK);
  CHECK_EQUAL(hsp_cells_check(cells, result.topology, &invariant, &violated_at), HSP_OK);
  CHECK(invariant == 0 && violated_at == HSP_NONE);
  topology_result_release(&result);
  computed_release(&base);
}

/* Three unit spheres that share two points, and one apart. Words one too few are refused. */
static void arrangement(void) {
  static const double xyz[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 9, 9, 9}, radius[4] = {1, 1, 1, 1};
  hsp_arrangement total, of_ball[4];
  uint32_t scratch[4], k;
  FILL(total);
  FILL(of_ball);
  FILL(number);
  CHECK_EQUAL(hsp_model_set(model, 4, xyz, radius, NULL, NULL), HSP_OK);
  CHECK_UNTOUCHED(number);
  CHECK_EQUAL(hsp_model_arrangement(model, &total, of_ball, scratch, 3, &number), HSP_E_CAPACITY);
  CHECK_EQUAL(number, 4);
  CHECK_EQUAL(hsp_model_arrangement(model, &total, of_ball, NULL, 0, &number), HSP_E_CAPACITY);
  CHECK_UNTOUCHED(total);
  CHECK_UNTOUCHED(of_ball);
  CHECK_EQUAL(hsp_model_arrangement(model, &total, of_ball, scratch, 4, &number), HSP_OK);
  CHECK_EQUAL(number, 4);
  CHECK(total.vertices == 2 && total.edges == 6 && total.faces == 13);
  for (k = 0; k < 3; ++k) CHECK(of_ball[k].vertices == 2 && of_ball[k].edges == 4 && of_ball[k].faces == 4);
  CHECK(of_ball[3].vertices == 0 && of_ball[3].edges == 0 && of_ball[3].faces == 1);
  CHECK_EQUAL(hsp_model_arrangement(model, NULL, NULL, scratch, 4, &number), HSP_OK);
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_model_arrangement(model, &total, NULL, NULL, 0, &number), HSP_OK);
  CHECK(number == 0 && total.faces == 0 && total.vertices == 0 && total.edges == 0);
}

/* Every limit below what is needed is refused, and what is handed back suffices in the end. */
static void small_limits(void) {
  uint32_t needed[10], words[10], which;
  hsp_cells_limits asked = good_limits();
  set_one();
  CHECK_EQUAL(hsp_cells_compute(cells, model, &asked), HSP_OK);
  memcpy(needed, &asked, sizeof needed);
  CHECK(asked.cubes == 7 && asked.cube_balls >= 1);
  for (which = 1; which < 10; ++which) {
    int retries = 0;
    int32_t status;
    if (needed[which] == 0) continue;
    memcpy(words, needed, sizeof words);
    --words[which];
    memcpy(&asked, words, sizeof asked);
    for (;; ++retries) {
      CHECK_EQUAL(hsp_cells_init(cells_memory, sizeof cells_memory, &asked, &cells), HSP_OK);
      status = hsp_cells_compute(cells, model, &asked);
      if (status != HSP_E_CAPACITY || retries == 6) break;
      check_no_results(cells, HSP_E_STATE);
    }
    CHECK_EQUAL(status, HSP_OK);
    CHECK(retries > 0);
    CHECK(memcmp(&asked, needed, sizeof needed) == 0);
  }
}

int main(void) {
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, CAGE, &model), HSP_OK);
  default_limits();
  sizes();
  computing();
  one_ball();
  large_balls();
  tied_side();
  cage();
  checking();
  arrangement();
  set_one();
  check_has_results();
  small_limits();
  return check_report();
}
