/* Paths through free space: arguments that tests/laws says nothing about, every call out of order, and what is known of
 * a ball and of a cage in closed form. */
#include <hardsphere.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "untouched.h"

enum { CAGE = 26, CUBES = 64, ENTRIES = 512, CELLS = 1200, PAIRS = 6000, MARKS = 1000, FACETS = 2400, CORNERS = 12000 };
enum { IN_CUBE = CAGE, IN_CUBE_CORNERS = 1200, POINTS = 200 };
static unsigned char model_memory[HSP_MODEL_BYTES(CAGE)];
static unsigned char paths_memory[HSP_PATHS_BYTES(CUBES, ENTRIES, CELLS, PAIRS, MARKS, FACETS, CORNERS, IN_CUBE,
                                                  IN_CUBE_CORNERS, POINTS)];
static hsp_model *model;
static hsp_paths *paths;
static hsp_path path;
static double points[POINTS][3];
static uint32_t number;

/* A ball in the middle of a cube of the grid, points on both sides of it, and in it. */
static const double one_xyz[3] = {2, 2, 2}, one_radius[1] = {2};
static const double under[3] = {2, 2, -8}, above[3] = {2, 2, 8}, inside[3] = {2, 2, 3};
static const double not_finite[3] = {0, (double)NAN, 0}, far_away[3] = {1e300, 0, 0};

static hsp_paths_limits paths_limits(void) {
  const hsp_paths_limits limits = {
      (uint32_t)sizeof limits, CUBES, ENTRIES, CELLS, PAIRS, MARKS, FACETS, CORNERS, IN_CUBE, IN_CUBE_CORNERS, POINTS};
  return limits;
}

static void set_one(void) {
  CHECK_EQUAL(hsp_model_set(model, 1, one_xyz, one_radius, NULL, NULL), HSP_OK);
}

/* 26 balls of a cubic lattice around a place without one. */
static void set_cage(double radius) {
  double xyz[3 * CAGE], radii[CAGE];
  uint32_t n = 0, x, y, z;
  for (x = 0; x < 3; ++x) {
    for (y = 0; y < 3; ++y) {
      for (z = 0; z < 3; ++z) {
        if (x == 1 && y == 1 && z == 1) continue;
        xyz[3 * n] = 10.0 * x;
        xyz[3 * n + 1] = 10.0 * y;
        xyz[3 * n + 2] = 10.0 * z;
        radii[n++] = radius;
      }
    }
  }
  CHECK_EQUAL(hsp_model_set(model, n, xyz, radii, NULL, NULL), HSP_OK);
}

static void check_no_path(hsp_paths *which, int32_t status) {
  FILL(path);
  FILL(number);
  FILL(points);
  CHECK_EQUAL(hsp_paths_find(which, under, above, &path, NULL), status);
  CHECK_EQUAL(hsp_paths_get_points(which, points[0], POINTS, &number), status);
  CHECK_UNTOUCHED(path);
  CHECK_UNTOUCHED(number);
  CHECK_UNTOUCHED(points);
}

static void find(const double *from, const double *to) {
  CHECK_EQUAL(hsp_paths_find(paths, from, to, &path, NULL), HSP_OK);
  CHECK_EQUAL(path.reserved, 0);
  CHECK_EQUAL(hsp_paths_get_points(paths, points[0], POINTS, &number), HSP_OK);
  CHECK_EQUAL(number, path.points);
  if (path.ends != HSP_PATH_CONNECTED) {
    CHECK(path.points == 0 && path.certified == 0 && path.length == 0 && path.clearance == 0);
    return;
  }
  CHECK(path.points >= 2);
  CHECK(memcmp(points[0], from, sizeof points[0]) == 0 && memcmp(points[number - 1], to, sizeof points[0]) == 0);
}

/* One limit, or all, at or above a power of two, where tables grow; the others small. */
static void sizes(void) {
  static const uint32_t small[2] = {0, 1};
  uint32_t which, other, exponent, k;
  for (which = 0; which < 11; ++which) {
    for (exponent = 0; exponent < 18; ++exponent) {
      for (k = 0; k < 4; ++k) {
        uint32_t n[11] = {0};
        hsp_paths_limits of_paths;
        size_t bytes = 0;
        for (other = 1; other < 11; ++other) {
          n[other] = which == 0 || which == other ? (UINT32_C(1) << exponent) + k / 2 : small[k % 2];
        }
        n[0] = (uint32_t)sizeof of_paths;
        memcpy(&of_paths, n, sizeof of_paths);
        CHECK_EQUAL(hsp_paths_bytes(&of_paths, &bytes), HSP_OK);
        CHECK(bytes > 0 && bytes <= HSP_PATHS_BYTES(n[1], n[2], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10]));
      }
    }
  }
}

static void default_paths_limits(void) {
  hsp_paths_limits limits;
  CHECK_EQUAL(hsp_paths_limits_init(&limits, (uint32_t)sizeof limits, (HSP_MAX_BALLS - 2048) / 80 + 1), HSP_E_RANGE);
  CHECK_EQUAL(hsp_paths_limits_init(&limits, (uint32_t)sizeof limits, 10), HSP_OK);
  CHECK(limits.cubes == 84 && limits.cells == 356 && limits.cube_corners == 464 && limits.points == 1064);
}

static void finding_paths(void) {
  hsp_paths_limits asked = paths_limits();
  CHECK_EQUAL(hsp_paths_init(paths_memory, sizeof paths_memory, &asked, &paths), HSP_OK);
  set_one();
  CHECK_EQUAL(hsp_paths_compute(paths, model, &asked), HSP_OK);
  CHECK(asked.cubes == 7 && asked.entries == 7 && asked.points == 0);
  CHECK_EQUAL(hsp_paths_get_points(paths, NULL, 0, &number), HSP_OK);
  CHECK_EQUAL(number, 0);
  find(under, above);
  CHECK(path.ends == HSP_PATH_CONNECTED && path.certified == 1 && path.points > 2);
  CHECK(path.clearance > 0 && path.clearance < 4 && path.length > 16 && path.length < 30);
  CHECK_EQUAL(hsp_paths_get_points(paths, NULL, 0, &number), HSP_E_CAPACITY);
  CHECK_EQUAL(number, path.points);
  CHECK_EQUAL(hsp_paths_get_points(paths, points[0], path.points - 1, &number), HSP_E_CAPACITY);
  find(under, under);
  CHECK(path.ends == HSP_PATH_CONNECTED && path.points == 2 && path.length == 0);
  find(under, inside);
  CHECK_EQUAL(path.ends, HSP_PATH_COVERED);

  // A refused caller has no path of an earlier call.
  find(under, above);
  FILL(path);
  CHECK_EQUAL(hsp_paths_find(paths, NULL, above, &path, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_paths_find(paths, under, NULL, &path, NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_paths_find(paths, under, above, NULL, NULL), HSP_E_ARGUMENT);
  asked.struct_size = 4;
  CHECK_EQUAL(hsp_paths_find(paths, under, above, &path, &asked), HSP_E_VERSION);
  CHECK_EQUAL(hsp_paths_find(paths, not_finite, above, &path, NULL), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_paths_find(paths, under, not_finite, &path, NULL), HSP_E_NOT_FINITE);
  CHECK_EQUAL(hsp_paths_find(paths, far_away, above, &path, NULL), HSP_E_RANGE);
  CHECK_UNTOUCHED(path);
  CHECK_EQUAL(hsp_paths_get_points(paths, NULL, 0, &number), HSP_OK);
  CHECK_EQUAL(number, 0);

  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, NULL), HSP_OK);
  check_no_path(paths, HSP_E_STATE);
  set_one();
  find(under, above);
  CHECK_EQUAL(hsp_model_set(model, 0, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_paths_compute(paths, model, NULL), HSP_OK);
  find(under, above);
  CHECK(path.ends == HSP_PATH_CONNECTED && path.certified == 1 && path.points == 2 && isinf(path.clearance));
  CHECK(fabs(path.length - 16) < 1e-9);
}

/* The widest way out of the middle is through the squares of four balls, the half of whose diagonals is sqrt(50). */
static void cage(void) {
  static const double middle[3] = {10, 10, 10}, outside[3] = {10, 10, 60};
  set_cage(6);
  CHECK_EQUAL(hsp_paths_compute(paths, model, NULL), HSP_OK);
  find(middle, outside);
  CHECK(path.ends == HSP_PATH_CONNECTED && path.certified == 1 && path.points > 2 && path.clearance > 0);
  CHECK(path.clearance <= sqrt(50.0) - 6 + 1e-7);
  set_cage(7.5);
  CHECK_EQUAL(hsp_paths_compute(paths, model, NULL), HSP_OK);
  find(middle, outside);
  CHECK_EQUAL(path.ends, HSP_PATH_APART);
}

/* Every limit below what is needed is refused, and what is handed back suffices in the end. */
static void small_paths_limits(void) {
  uint32_t needed[11], words[11], which;
  hsp_paths_limits asked = paths_limits();
  CHECK_EQUAL(hsp_paths_init(paths_memory, sizeof paths_memory, &asked, &paths), HSP_OK);
  CHECK_EQUAL(hsp_paths_compute(paths, model, NULL), HSP_OK);
  CHECK_EQUAL(hsp_paths_find(paths, under, above, &path, &asked), HSP_OK);
  CHECK(asked.cubes == 7 && asked.points >= path.points);
  memcpy(needed, &asked, sizeof needed);
  for (which = 1; which < 11; ++which) {
    int retries = 0;
    int32_t status;
    if (needed[which] == 0) continue;
    memcpy(words, needed, sizeof words);
    --words[which];
    memcpy(&asked, words, sizeof asked);
    for (;; ++retries) {
      CHECK_EQUAL(hsp_paths_init(paths_memory, sizeof paths_memory, &asked, &paths), HSP_OK);
      status = hsp_paths_compute(paths, model, which == 10 ? NULL : &asked);
      CHECK_EQUAL(status == HSP_OK || which != 10, 1);
      if (status == HSP_OK) status = hsp_paths_find(paths, under, above, &path, &asked);
      if (status != HSP_E_CAPACITY || retries == 6) break;
      CHECK_EQUAL(hsp_paths_get_points(paths, NULL, 0, &number), which == 10 ? HSP_OK : HSP_E_STATE);
    }
    CHECK_EQUAL(status, HSP_OK);
    CHECK(retries > 0);
    CHECK(memcmp(&asked, needed, sizeof needed) == 0);
  }
}

int main(void) {
  CHECK_EQUAL(hsp_model_init(model_memory, sizeof model_memory, CAGE, &model), HSP_OK);
  default_paths_limits();
  sizes();
  finding_paths();
  cage();
  set_one();
  small_paths_limits();
  return check_report();
}
