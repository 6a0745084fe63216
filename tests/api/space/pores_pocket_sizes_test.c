/* The size of pockets that are closed by plugs: between flat lids, in closed form and by sums over a grid; cavities,
 * which are regions; a box beside none; pockets that are not closed or filled; and every status. */
#include <hardsphere.h>
#include <hardsphere_workspace.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "untouched.h"

enum { MOST = 600, POCKETS = 64 };
static const double pi = 3.14159265358979323846;
static hsp_workspace work, plugged;
static double xyz[3 * MOST], radii[MOST], with_plugs[3 * MOST], grown[MOST], box[9];
static uint32_t n, all, pockets;
static hsp_pore_pocket listed[POCKETS];
static hsp_pore_pocket_size sizes[POCKETS];

static void add(double x, double y, double z, double radius) {
  xyz[3 * n] = x;
  xyz[3 * n + 1] = y;
  xyz[3 * n + 2] = z;
  radii[n++] = radius;
}

/* Pores with pockets, and the balls with plugs. */
static void find_pockets(const double *in, double narrow, double wide) {
  hsp_pores_options options;
  uint32_t k;
  CHECK_EQUAL(hsp_pores_options_init(&options, sizeof options), HSP_OK);
  options.floor = narrow < 0 ? narrow : 0;
  if (in == NULL) {
    CHECK_EQUAL(hsp_workspace_set(&work, n, xyz, radii, NULL, NULL), HSP_OK);
    CHECK_EQUAL(hsp_workspace_pores(&work, &options), HSP_OK);
  } else {
    CHECK_EQUAL(hsp_workspace_periodic(&work, n, xyz, radii, in, NULL, NULL), HSP_OK);
    CHECK_EQUAL(hsp_workspace_pores_periodic(&work, &options), HSP_OK);
  }
  CHECK_EQUAL(hsp_pores_find_pockets(work.pores, narrow, wide, &pockets), HSP_OK);
  CHECK(pockets <= POCKETS);
  CHECK_EQUAL(hsp_pores_get_pockets(work.pores, 0, pockets, listed), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_plugged_balls(work.pores, with_plugs, grown, MOST, &all), HSP_OK);
  for (k = 0; k < pockets; ++k) all -= listed[k].mouths;
  CHECK_EQUAL(all, n);
  for (k = 0; k < n; ++k) CHECK_NEAR(grown[k], radii[k] + narrow > 0 ? radii[k] + narrow : 0, 2e-8);
  for (k = 0; in == NULL && k < 3 * n; ++k) CHECK_NEAR(with_plugs[k], xyz[k], 1e-8);
  for (k = 0; k < pockets; ++k) all += listed[k].mouths;
}

static void plug(const double *in, const hsp_model_options *options) {
  if (in == NULL) {
    CHECK_EQUAL(hsp_workspace_set(&plugged, all, with_plugs, grown, options, NULL), HSP_OK);
    CHECK_EQUAL(hsp_workspace_boundary(&plugged), HSP_OK);
    CHECK_EQUAL(hsp_workspace_pores(&plugged, NULL), HSP_OK);
  } else {
    CHECK_EQUAL(hsp_workspace_periodic(&plugged, all, with_plugs, grown, in, options, NULL), HSP_OK);
    CHECK_EQUAL(hsp_workspace_pores_periodic(&plugged, NULL), HSP_OK);
  }
}

static const hsp_boundary *surface(const double *in) {
  return in == NULL ? plugged.boundary : NULL;
}

/* All sizes are of regions that are blocked, some of these or all. */
static void measure(const double *in) {
  hsp_pore_access access;
  double area = 0, volume = 0;
  uint32_t needed = 0, regions = 0, k;
  memset(sizes, 0, sizeof sizes);
  CHECK_EQUAL(hsp_pores_measure_pockets(work.pores, plugged.pores, surface(in), sizes, POCKETS, &needed), HSP_OK);
  CHECK_EQUAL(needed, pockets);
  for (k = 0; k < pockets; ++k) {
    const hsp_pore_pocket_size *const size = &sizes[k];
    CHECK(size->closed <= 1);
    if (size->closed == 0) {
      CHECK(isnan(size->volume) && isnan(size->area) && isnan(size->plug_area) && size->regions == 0);
      continue;
    }
    CHECK((size->regions == 0) == (size->volume == 0) && (size->regions == 0) == (size->area == 0));
    CHECK(size->volume >= 0 && size->area >= 0 && size->plug_area >= 0);
    if (listed[k].mouths == 0) CHECK(size->regions == 1 && size->plug_area == 0);
    area += size->area + size->plug_area;
    volume += size->volume;
    regions += size->regions;
  }
  CHECK_EQUAL(hsp_pores_find_regions(plugged.pores, surface(in), &access, NULL), HSP_OK);
  CHECK(regions <= access.blocked);
  CHECK(area <= access.blocked_area + 1e-9 && volume <= access.blocked_volume + 1e-9);
}

/* Plugs in what leaks, until nothing does; how many times. */
static uint32_t close_leaks(const double *in) {
  uint32_t times = 0, needed = 0;
  for (;;) {
    CHECK_EQUAL(hsp_pores_get_plugged_balls(plugged.pores, with_plugs, grown, MOST, &needed), HSP_OK);
    CHECK(needed >= all);
    if (needed <= all || times == 20) return times;
    all = needed;
    plug(in, NULL);
    measure(in);
    ++times;
  }
}

static void compute(const double *in, double narrow, double wide) {
  find_pockets(in, narrow, wide);
  plug(in, NULL);
  measure(in);
}

/* 26 balls of a cubic lattice around a place without one, or less the middle of the side z = 0. */
static void set_cage(double radius, int open) {
  int x, y, z;
  n = 0;
  for (x = 0; x < 3; ++x) {
    for (y = 0; y < 3; ++y) {
      for (z = 0; z < 3; ++z) {
        if (x == 1 && y == 1 && (z == 1 || (open && z == 0))) continue;
        add(10.0 * x, 10.0 * y, 10.0 * z, radius);
      }
    }
  }
}

/* Of half a plug in a square of four balls, with sides of 10, the part that is free: by columns over a grid. */
static double free_half_plug(double plug_radius, double radius) {
  enum { PARTS = 1000 };
  const double step = plug_radius / PARTS;
  double sum = 0;
  int i, j;
  for (i = 0; i < PARTS; ++i) {
    for (j = 0; j < PARTS; ++j) {
      const double x = (i + 0.5) * step, y = (j + 0.5) * step;
      const double high = plug_radius * plug_radius - x * x - y * y;
      const double low = radius * radius - (5 - x) * (5 - x) - (5 - y) * (5 - y);
      const double column = high <= 0 ? 0 : sqrt(high) - (low <= 0 ? 0 : sqrt(low));
      if (column > 0) sum += column;
    }
  }
  return 4 * sum * step * step;
}

/* The sides of a cage of balls that meet in pairs have 24 mouths between four balls each. Flat lids there make its
 * volume that of a cube less eighths, quarters and halves of balls. */
static void many_mouths(void) {
  const double r = 7, depth = sqrt(49.0 - 25.0), ball = 4 * pi * r * r * r / 3;
  const double lens = pi * (4 * r + 10) * (2 * r - 10) * (2 * r - 10) / 12, lids = 8000 - 7 * ball + 18 * lens;
  uint32_t k;
  set_cage(6, 0);
  compute(NULL, 1, 1.1);
  CHECK(pockets == 1 && listed[0].mouths == 24 && listed[0].maxima == 9 && all == n + 24);
  for (k = n; k < all; ++k) {
    CHECK(grown[k] >= 5 - depth && grown[k] < 5 - depth + 2e-5);
    CHECK_NEAR(fmod(with_plugs[3 * k], 5), 0, 1e-8);
  }
  CHECK(sizes[0].closed == 1 && sizes[0].regions == 1 && sizes[0].plug_area > 0);
  CHECK(sizes[0].volume < lids && lids - sizes[0].volume < 24 * 2 * pi * grown[n] * grown[n] * grown[n] / 3);
  CHECK_NEAR(lids - sizes[0].volume, 24 * free_half_plug(grown[n], r), 1e-5);
  /* The narrow probe is rounded up. */
  compute(NULL, 0.999999996, 1.1);
  CHECK(grown[0] == 7 && sizes[0].closed == 1);
}

/* One side of a closed cage is open: the part of the cube that is free is behind a flat lid in that side. */
static void one_mouth(void) {
  enum { PARTS = 100 };
  const double r = 7.2, step = 20.0 / PARTS;
  double lid = 0, inside = 0, narrow;
  int i, j, k;
  uint32_t b;
  set_cage(r, 1);
  compute(NULL, 0, 3);
  CHECK(pockets == 1 && listed[0].mouths == 1 && all == n + 1 && sizes[0].closed == 1);
  CHECK_NEAR(grown[n], 10 / sqrt(2) - sqrt(r * r - 50), 2e-5);
  for (k = 0; k < 3; ++k) CHECK_NEAR(with_plugs[3 * n + (uint32_t)k], k == 2 ? 0 : 10, 1e-8);
  for (i = 0; i < PARTS; ++i) {
    for (j = 0; j < PARTS; ++j) {
      for (k = 0; k < PARTS; ++k) {
        const double at[3] = {(i + 0.5) * step, (j + 0.5) * step, (k + 0.5) * step};
        int plug_only = 0, covered = 0;
        for (b = 0; b < all && !covered; ++b) {
          const double *c = with_plugs + 3 * (size_t)b;
          const double dx = at[0] - c[0], dy = at[1] - c[1], dz = at[2] - c[2];
          const int in_it = dx * dx + dy * dy + dz * dz <= grown[b] * grown[b];
          covered = in_it && b < n;
          plug_only = in_it && b == n;
        }
        if (covered) continue;
        lid += step * step * step;
        if (!plug_only) inside += step * step * step;
      }
    }
  }
  CHECK(fabs(sizes[0].volume - inside) < 0.004 * inside);
  CHECK(sizes[0].volume < lid && lid < sizes[0].volume + 2 * pi * grown[n] * grown[n] * grown[n] / 3);
  /* As the narrow probe grows there is less of both, until it does not fit. */
  inside = sizes[0].volume;
  for (narrow = 0.25; narrow < 2.6; narrow += 0.25) {
    compute(NULL, narrow, 3);
    CHECK(pockets >= 1 && sizes[0].closed == 1 && sizes[0].volume < inside);
    inside = sizes[0].volume;
  }
  /* A narrow probe of less than nothing; small balls have no radius left then. */
  add(10, 10, 10, 0.1);
  compute(NULL, -0.125, 3);
  CHECK(grown[n - 1] == 0 && pockets == 1);
}

/* Where both probes are one, pockets are blocked regions of balls grown by that, to the last bit. */
static void cavities(void) {
  hsp_pore_region region;
  hsp_model_options options;
  set_cage(7, 0);
  compute(NULL, 0.5, 0.5);
  CHECK(pockets == 1 && all == n && sizes[0].closed == 1);
  CHECK_EQUAL(hsp_model_options_init(&options, sizeof options), HSP_OK);
  options.probe = 0.5;
  CHECK_EQUAL(hsp_workspace_set(&plugged, n, xyz, radii, &options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_boundary(&plugged), HSP_OK);
  CHECK_EQUAL(hsp_workspace_pores(&plugged, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_find_regions(plugged.pores, plugged.boundary, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_regions(plugged.pores, 1, 1, &region), HSP_OK);
  CHECK(region.volume == sizes[0].volume && region.area == sizes[0].area);
  /* Nothing is grown and nothing has a plug: pores can be their own. */
  set_cage(7.2, 0);
  compute(NULL, 0, 0);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
  CHECK_EQUAL(hsp_pores_measure_pockets(work.pores, work.pores, work.boundary, sizes + 1, 1, NULL), HSP_OK);
  CHECK(memcmp(&sizes[0], &sizes[1], sizeof sizes[0]) == 0);
}

/* Balls anywhere: as many pockets as one likes, in a molecule and in the middle of a box that is much larger. */
static void set_random(uint32_t *state, uint32_t balls, double side) {
  uint32_t axis;
  n = 0;
  while (n < balls) {
    double at[4];
    for (axis = 0; axis < 4; ++axis) {
      *state = *state * 1664525U + 1013904223U;
      at[axis] = (double)(*state >> 8) / 16777216.0;
    }
    add(side * at[0], side * at[1], side * at[2], 1.2 + 0.6 * at[3]);
  }
}

static void anywhere(void) {
  hsp_model_options coarse;
  hsp_pore_pocket_size alone[POCKETS];
  uint32_t state = 4, turn, k, closed = 0, open = 0, filled = 0, several = 0, times = 0;
  CHECK_EQUAL(hsp_model_options_init(&coarse, sizeof coarse), HSP_OK);
  coarse.step = 1e-7;
  for (turn = 0; turn < 40; ++turn) {
    set_random(&state, 60, 10);
    compute(NULL, 0.1 * (turn % 5), 0.1 * (turn % 5) + 0.5 + 0.5 * (turn % 3));
    memcpy(alone, sizes, sizeof alone);
    for (k = 0; k < pockets; ++k) {
      closed += sizes[k].closed;
      open += 1 - sizes[k].closed;
      filled += sizes[k].closed == 1 && sizes[k].regions == 0;
      several += sizes[k].regions > 1;
    }
    plug(NULL, &coarse);
    measure(NULL);
    for (k = 0; k < pockets; ++k) {
      CHECK_EQUAL(sizes[k].closed, alone[k].closed);
      if (sizes[k].closed == 1) CHECK_NEAR(sizes[k].volume, alone[k].volume, 1e-4);
    }
    plug(NULL, NULL);
    measure(NULL);
    times += close_leaks(NULL);
    for (k = 0; k < pockets; ++k) {
      CHECK_EQUAL(sizes[k].closed, 1);
      if (alone[k].closed == 1) CHECK(sizes[k].volume <= alone[k].volume + 1e-9); /* others' plugs may reach into it */
    }
    memset(box, 0, sizeof box);
    box[0] = box[4] = box[8] = 40;
    box[3] = turn % 2 == 0 ? 0 : 7;
    compute(box, 0.1 * (turn % 5), 0.1 * (turn % 5) + 0.5 + 0.5 * (turn % 3));
    for (k = 0; k < pockets; ++k) {
      CHECK(sizes[k].closed == alone[k].closed && sizes[k].regions == alone[k].regions);
      if (sizes[k].closed == 0) continue;
      CHECK_NEAR(sizes[k].volume, alone[k].volume, 1e-9);
      CHECK_NEAR(sizes[k].area, alone[k].area, 1e-9);
      CHECK_NEAR(sizes[k].plug_area, alone[k].plug_area, 1e-9);
    }
  }
  CHECK(closed > 100 && open > 5 && filled > 5 && several > 0 && times > 5);
  /* In a box that nothing wide goes on in for ever, a pocket without mouths goes on for ever. */
  n = 0;
  box[0] = box[4] = box[8] = 6;
  box[3] = 0;
  add(1, 2, 3, 2);
  compute(box, 0, 50);
  CHECK(pockets == 1 && listed[0].mouths == 0 && sizes[0].closed == 0);
  CHECK_EQUAL(close_leaks(box), 0);
}

static int32_t try_measure(const hsp_boundary *boundary) {
  return hsp_pores_measure_pockets(work.pores, plugged.pores, boundary, sizes, POCKETS, NULL);
}

static void statuses(void) {
  hsp_pore_region region;
  hsp_model_options model_options;
  hsp_pores_options options;
  uint32_t needed = 0, regions = 0;
  CHECK_EQUAL(hsp_model_options_init(&model_options, sizeof model_options), HSP_OK);
  CHECK_EQUAL(hsp_pores_options_init(&options, sizeof options), HSP_OK);
  set_cage(6, 0);
  /* Before pockets are looked for the balls are as they are. */
  CHECK_EQUAL(hsp_workspace_set(&work, n, xyz, radii, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_pores(&work, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_plugged_balls(work.pores, with_plugs, grown, MOST, &needed), HSP_OK);
  CHECK(needed == n && memcmp(with_plugs, xyz, 3 * n * sizeof *xyz) == 0 &&
        memcmp(grown, radii, n * sizeof *radii) == 0);
  find_pockets(NULL, 1, 1.1);
  plug(NULL, NULL);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_plugged_balls(work.pores, NULL, grown, n, &needed), HSP_E_CAPACITY);
  CHECK_EQUAL(needed, all);
  CHECK_EQUAL(hsp_pores_get_plugged_balls(work.pores, NULL, NULL, 0, NULL), HSP_OK);
  FILL(sizes[0]);
  CHECK_EQUAL(hsp_pores_measure_pockets(work.pores, plugged.pores, plugged.boundary, sizes, 0, &needed),
              HSP_E_CAPACITY);
  CHECK_UNTOUCHED(sizes[0]);
  CHECK_EQUAL(needed, 1);
  CHECK_EQUAL(hsp_pores_measure_pockets(work.pores, plugged.pores, plugged.boundary, NULL, 1, NULL), HSP_E_ARGUMENT);
  /* A refused call changes nothing: with its arguments exchanged neither pockets nor regions are forgotten. */
  CHECK_EQUAL(hsp_pores_measure_pockets(plugged.pores, work.pores, work.boundary, sizes, POCKETS, NULL),
              HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_pores_get_pockets(work.pores, 0, 1, listed), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_regions(plugged.pores, 0, 1, &region), HSP_OK);
  CHECK_EQUAL(try_measure(NULL), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
  CHECK_EQUAL(try_measure(work.boundary), HSP_E_ARGUMENT);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_regions(plugged.pores, 0, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_find_regions(plugged.pores, plugged.boundary, NULL, &regions), HSP_OK);
  CHECK(regions > 1);
  /* Its own pockets are forgotten. */
  CHECK_EQUAL(hsp_pores_find_pockets(plugged.pores, 0, 1, &pockets), HSP_OK);
  CHECK(pockets > 0);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_pockets(plugged.pores, 0, 1, listed), HSP_E_ID);
  CHECK_EQUAL(hsp_pores_get_plugged_balls(plugged.pores, NULL, NULL, 0, &needed), HSP_OK);
  CHECK_EQUAL(needed, all);
  /* Other balls: without plugs, with a probe, and one a step away. */
  CHECK_EQUAL(hsp_pores_measure_pockets(work.pores, work.pores, work.boundary, sizes, POCKETS, NULL), HSP_E_ARGUMENT);
  model_options.probe = 0.5;
  plug(NULL, &model_options);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_E_ARGUMENT);
  with_plugs[3] += 1e-8;
  plug(NULL, NULL);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_E_ARGUMENT);
  with_plugs[3] -= 1e-8;
  grown[all - 1] += 1e-8;
  plug(NULL, NULL);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_E_ARGUMENT);
  grown[all - 1] -= 1e-8;
  plug(NULL, NULL);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_OK);
  /* A floor that hides regions, and what is no longer there. */
  options.floor = 0.1;
  CHECK_EQUAL(hsp_workspace_pores(&plugged, &options), HSP_OK);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_E_RANGE);
  options.floor = -0.5;
  CHECK_EQUAL(hsp_workspace_pores(&plugged, &options), HSP_OK);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_OK);
  CHECK(sizes[0].closed == 1 && sizes[0].volume > 800);
  CHECK_EQUAL(hsp_pores_find_pockets(work.pores, 2, 1, &pockets), HSP_E_ARGUMENT);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_E_ARGUMENT); /* pockets are forgotten, and so are plugs */
  CHECK_EQUAL(hsp_pores_find_pockets(work.pores, 1, 1.1, &pockets), HSP_OK);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_OK);
  /* In boxes. */
  memset(box, 0, sizeof box);
  box[0] = box[4] = box[8] = 60;
  find_pockets(box, 1, 1.1);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_E_ARGUMENT);
  plug(box, NULL);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_E_ARGUMENT);
  CHECK_EQUAL(try_measure(NULL), HSP_OK);
  box[3] = 1e-6;
  plug(box, NULL);
  CHECK_EQUAL(try_measure(NULL), HSP_E_ARGUMENT);
  box[3] = 60; /* the same lattice of copies by other vectors is another box */
  plug(box, NULL);
  CHECK_EQUAL(try_measure(NULL), HSP_E_ARGUMENT);
  hsp_workspace_free(&plugged);
  memset(&plugged, 0, sizeof plugged);
  find_pockets(NULL, 1, 1.1);
  plug(NULL, NULL);
  CHECK_EQUAL(hsp_workspace_set(&work, 1, xyz, radii, NULL, NULL), HSP_OK);
  CHECK_EQUAL(try_measure(plugged.boundary), HSP_E_STATE);
  CHECK_EQUAL(hsp_pores_get_plugged_balls(work.pores, NULL, NULL, 0, &needed), HSP_E_STATE);
}

int main(void) {
  many_mouths();
  one_mouth();
  cavities();
  anywhere();
  statuses();
  hsp_workspace_free(&work);
  hsp_workspace_free(&plugged);
  return check_report();
}
