/* Regions of free space beside balls: areas and volumes in closed form, of one region and of several that go on for
 * ever, by symmetry and by what stays when the box grows; the same for other cells of a crystal; those of a molecule
 * beside its topology; and every status. */
#include <hardsphere.h>
#include <hardsphere_workspace.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "untouched.h"

enum { MOST = 4000, REGIONS = 64 };
static const double pi = 3.14159265358979323846;
static hsp_workspace work;
static hsp_pore_access access;
static hsp_pore_region regions[REGIONS];
static hsp_periodic_totals totals;
static double xyz[3 * MOST], radii[MOST], box[9];
static uint32_t n, count;

static void set_box(double ax, double bx, double by, double cx, double cy, double cz) {
  const double vectors[9] = {ax, 0, 0, bx, by, 0, cx, cy, cz};
  memcpy(box, vectors, sizeof box);
  n = 0;
}

static void add(double x, double y, double z, double radius) {
  xyz[3 * n] = x;
  xyz[3 * n + 1] = y;
  xyz[3 * n + 2] = z;
  radii[n++] = radius;
}

static double box_volume(void) {
  return box[0] * box[4] * box[8];
}

/* Reads them, and checks what holds for all. */
static void read_regions(const hsp_boundary *boundary) {
  hsp_pore_access sums;
  uint32_t k;
  CHECK_EQUAL(hsp_pores_find_regions(work.pores, boundary, &access, &count), HSP_OK);
  CHECK(count <= REGIONS && access.accessible + access.blocked == count);
  CHECK_EQUAL(hsp_pores_get_regions(work.pores, 0, count, regions), HSP_OK);
  memset(&sums, 0, sizeof sums);
  for (k = 0; k < count; ++k) {
    const hsp_pore_region *const region = &regions[k];
    *(region->accessible ? &sums.accessible_area : &sums.blocked_area) += region->area;
    *(region->accessible ? &sums.accessible_volume : &sums.blocked_volume) += region->volume;
    CHECK(k == 0 || region->radius <= regions[k - 1].radius);
    CHECK(region->volume >= 0 && region->reserved == 0);
  }
  CHECK_NEAR(sums.accessible_area, access.accessible_area, 1e-9);
  CHECK_NEAR(sums.blocked_area, access.blocked_area, 1e-9);
  CHECK_NEAR(sums.blocked_volume, access.blocked_volume, 1e-9);
}

static void compute(void) {
  hsp_pore_channel channels[REGIONS];
  uint32_t needed = 0, k, r;
  CHECK_EQUAL(hsp_workspace_periodic(&work, n, xyz, radii, box, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_pores_periodic(&work, NULL), HSP_OK);
  CHECK_EQUAL(hsp_periodic_measure(work.periodic, &totals, NULL, NULL, 0, NULL), HSP_OK);
  read_regions(NULL);
  CHECK_NEAR(access.accessible_area + access.blocked_area, totals.area, 1e-11 * (1 + totals.area));
  CHECK_NEAR(access.accessible_volume + access.blocked_volume, totals.free_volume, 1e-12 * totals.box_volume);
  if (n == 0) return;
  CHECK_EQUAL(hsp_pores_get_channels(work.pores, 0, channels, REGIONS, &needed), HSP_OK);
  CHECK_EQUAL(needed, count);
  for (k = 0; k < needed; ++k) {
    CHECK(channels[k].maximum == regions[k].maximum && channels[k].maxima == regions[k].maxima);
    CHECK(channels[k].directions == regions[k].directions && channels[k].copies == regions[k].copies);
    CHECK(channels[k].radius == regions[k].radius && (channels[k].directions > 0) == (regions[k].accessible == 1));
    CHECK(regions[k].shells > 0);
    for (r = 0; r < 9; ++r) CHECK_EQUAL(channels[k].row[r], regions[k].row[r]);
  }
}

/* Of a packing with balls that overlap at most in pairs, each with `contacts` neighbours at a distance. */
static void expect_pairs(double edge, double radius, double contacts, double distance) {
  const double height = radius > distance / 2 ? radius - distance / 2 : 0;
  const double cap = pi * height * height * (3 * radius - height) / 3;
  CHECK(count == 1 && regions[0].directions == 3 && regions[0].copies == 1);
  CHECK_NEAR(regions[0].area, n * 2 * pi * radius * (2 * radius - contacts * height), 1e-9);
  CHECK_NEAR(edge * edge * edge - regions[0].volume, n * (4 * pi * radius * radius * radius / 3 - contacts * cap),
             1e-9);
}

static void packings(void) {
  static const double quarters[8][3] = {{0, 0, 0}, {0, 2, 2}, {2, 0, 2}, {2, 2, 0},
                                        {1, 1, 1}, {1, 3, 3}, {3, 1, 3}, {3, 3, 1}};
  static const double contacts[4] = {6, 8, 12, 4};
  static const uint32_t balls[4] = {1, 2, 4, 8};
  const double edge = 8;
  const double distance[4] = {8, 4 * sqrt(3), 4 * sqrt(2), 2 * sqrt(3)};
  uint32_t kind, size, k;
  for (kind = 0; kind < 4; ++kind) {
    for (size = 0; size < 4; ++size) {
      /* On the lattice; apart, and overlapping at last. */
      const double radius = floor(1e4 * distance[kind] * (0.3 + 0.075 * size)) / 1e4;
      set_box(edge, 0, edge, 0, 0, edge);
      for (k = 0; k < balls[kind]; ++k) {
        const double *q = quarters[k];
        if (kind == 1 && k == 1) {
          add(edge / 2 - 3 * edge, edge / 2, edge / 2, radius); /* anywhere, three boxes away */
        } else {
          add(q[0] * edge / 4, q[1] * edge / 4, q[2] * edge / 4, radius);
        }
      }
      compute();
      expect_pairs(edge, radius, contacts[kind], distance[kind]);
    }
  }
  /* Face-centred balls that meet in threes: octahedral cavities, and at first tetrahedral ones, eight to four. */
  for (size = 0; size < 2; ++size) {
    set_box(edge, 0, edge, 0, 0, edge);
    for (k = 0; k < 4; ++k) {
      add(quarters[k][0] * edge / 4, quarters[k][1] * edge / 4, quarters[k][2] * edge / 4, size == 0 ? 3.4 : 3.6);
    }
    compute();
    CHECK(access.accessible == 0 && access.accessible_volume == 0 && count == (size == 0 ? 12 : 4));
    for (k = 0; k < count; ++k) {
      const hsp_pore_region *const first = &regions[k < 4 ? 0 : 4];
      CHECK(regions[k].directions == 0 && regions[k].copies == 1 && regions[k].shells == 1 && regions[k].maxima == 1);
      CHECK_NEAR(regions[k].volume, first->volume, 1e-11);
      CHECK_NEAR(regions[k].area, first->area, 1e-10);
    }
  }
}

/* Balls that touch at points, where they are as near as a step too: on the axes and on diagonals, in a box and without
 * one. */
static void touching(void) {
  static const double ways[4][4] = {{2, 0, 0, 1}, {0, -2, 0, 1}, {6, 0, 8, 5}, {2, 3, 6, 3.5}};
  const double least = 1e-10;
  uint32_t k, near;
  for (k = 0; k < 4; ++k) {
    const double *way = ways[k], r = way[3];
    for (near = 0; near < 2; ++near) {
      const double area = 8 * pi * r * r, volume = 8 * pi * r * r * r / 3;
      set_box(10 * r, 0, 10 * r, 0, 0, 10 * r);
      add(0, 0, 0, r);
      add(way[0] + (near ? least : 0), way[1], way[2], r);
      compute();
      CHECK(count == 1 && regions[0].directions == 3);
      CHECK_NEAR(regions[0].area, area, 1e-6);
      CHECK_NEAR(regions[0].volume, 1000 * r * r * r - volume, 1e-6);
      CHECK_EQUAL(hsp_workspace_set(&work, n, xyz, radii, NULL, NULL), HSP_OK);
      CHECK_EQUAL(hsp_workspace_pores(&work, NULL), HSP_OK);
      CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
      read_regions(work.boundary);
      CHECK_EQUAL(count, 1);
      CHECK_NEAR(regions[0].area, area, 1e-6);
    }
  }
  /* Each touches six copies of itself: free space around the corners of the box. */
  set_box(8, 0, 8, 0, 0, 8);
  add(1, 2, 3, 4);
  compute();
  CHECK(count == 1 && regions[0].directions == 3);
  CHECK_NEAR(regions[0].volume, 512 - 4 * pi * 64 / 3, 1e-9);
}

/* Closed walls of balls, square lattices in the planes z = 1 and z = 1 + gap of a box of the height c: with as much
 * wall on both sides, the two gaps differ by the wall's area times what their heights differ by. */
static void slabs(double lean) {
  const double gap = 3.5, height = 9, side = 6;
  uint32_t wall, i, j;
  set_box(side, 2, side, lean, lean, height);
  for (wall = 0; wall < 2; ++wall) {
    for (i = 0; i < 6; ++i) {
      for (j = 0; j < 6; ++j) add(i + 0.3, j - 11.7, wall == 0 ? 1 : 1 + gap, 0.8);
    }
  }
  compute();
  CHECK(count == 2 && access.accessible == 2 && access.blocked == 0);
  for (i = 0; i < 2; ++i) {
    const double own = i == 0 ? height - gap : gap;
    CHECK(regions[i].directions == 2 && regions[i].shells == 2 && regions[i].row[2] == 0 && regions[i].row[5] == 0);
    CHECK_NEAR(regions[i].area, totals.area / 2, 1e-9);
    CHECK_NEAR(regions[i].volume, totals.free_volume / 2 + side * side * (own - height / 2), 1e-9);
  }
}

/* A tube of twisted rings along the first vector: what it encloses stays as it is in a wider box. */
static void tubes(void) {
  double inside = 0, outside = 0, wall = 0;
  uint32_t wide, i, k;
  for (wide = 0; wide < 3; ++wide) {
    const double b = 8 + wide, c = 9 + 2 * wide;
    set_box(3, 1.1, b, -0.4, 2.5 * wide - 2, c);
    for (i = 0; i < 6; ++i) {
      for (k = 0; k < 24; ++k) {
        const double angle = k * pi / 12;
        add(0.5 * i + 0.01 * k + 40 * wide, 6 + 2.4 * cos(angle), 0.5 + 2.4 * sin(angle), 0.5);
      }
    }
    compute();
    CHECK(count == 2 && access.accessible == 2);
    /* Outside there is more room. */
    CHECK(regions[0].directions == 3 && regions[1].directions == 1 && regions[1].row[0] == 1);
    CHECK(regions[1].volume > pi * 1.9 * 1.9 * 3 && regions[1].volume < pi * 2.3 * 2.3 * 3);
    if (wide == 0) {
      inside = regions[1].volume;
      outside = regions[0].volume;
      wall = box_volume() - inside - outside;
    }
    CHECK_NEAR(regions[1].volume, inside, 1e-10);
    CHECK_NEAR(regions[0].volume, box_volume() - wall - inside, 1e-9);
  }
}

/* Two networks of three directions each, with a wall between them along cos x + cos y + cos z = 0. A half of the
 * diagonal takes one to the other, and balls off their places by a little take part in that. */
static void networks(uint32_t kind) {
  enum { GRID = 14, HALF = GRID / 2 };
  const double edge = 14, turn = 2 * pi / GRID;
  uint32_t i, j, k, half;
  set_box(edge, 0, edge, 0, 0, edge);
  if (kind == 1) set_box(edge, edge, edge, -edge, 2 * edge, edge); /* the same lattice */
  for (i = 0; i < HALF; ++i) {
    for (j = 0; j < GRID; ++j) {
      for (k = 0; k < GRID; ++k) {
        const double off = 0.01 * ((i * 7 + j * 13 + k * 29) % 11);
        if (fabs(cos(turn * i) + cos(turn * j) + cos(turn * k)) > 0.5) continue;
        for (half = 0; half < 2; ++half) {
          const double to = HALF * half;
          add(i + to + 3.3 + off, j + to - 17.1 - off, k + to + 0.2 + 2 * off, 0.95);
        }
      }
    }
  }
  compute();
  CHECK(count == 2 && access.accessible == 2 && access.blocked == 0);
  for (i = 0; i < 2; ++i) {
    CHECK(regions[i].directions == 3 && regions[i].copies == 1 && regions[i].shells == 1);
    CHECK_NEAR(regions[i].volume, totals.free_volume / 2, 1e-9);
    CHECK_NEAR(regions[i].area, totals.area / 2, 1e-8);
  }
}

/* Two cavities that touch in a point, a gate of the width 0, where vertices of both shells are; and what is left of
 * them when balls are a little smaller or larger. */
static void pinched(void) {
  hsp_pores_options options;
  int32_t size;
  CHECK_EQUAL(hsp_pores_options_init(&options, sizeof options), HSP_OK);
  options.floor = -0.01;
  for (size = -1; size <= 1; ++size) {
    set_box(8, 4, 8, -4, -4, 8);
    add(-4, 6, 2, 6 + 1e-3 * size);
    compute();
    CHECK_EQUAL(count, size < 0 ? 1 : 2);
    CHECK_EQUAL(access.accessible, 0);
    if (size < 0) continue;
    CHECK(regions[0].shells == 1 && regions[1].shells == 1);
    CHECK_NEAR(regions[0].volume, totals.free_volume / 2, 1e-11);
    CHECK_NEAR(regions[1].volume, totals.free_volume / 2, 1e-11);
    CHECK_EQUAL(hsp_workspace_pores_periodic(&work, &options), HSP_OK); /* what is below a point does not count */
    read_regions(NULL);
    CHECK(count == 2 && regions[0].shells == 1 && regions[1].shells == 1);
  }
}

/* The eight windows between six balls, open by less than levels are rounded to, and a step narrower and wider. */
static void windows(void) {
  hsp_pores_options options;
  hsp_model_options lattice;
  hsp_pore_channel channel;
  uint32_t k, floor, needed = 0;
  int32_t more;
  CHECK_EQUAL(hsp_pores_options_init(&options, sizeof options), HSP_OK);
  CHECK_EQUAL(hsp_model_options_init(&lattice, sizeof lattice), HSP_OK);
  lattice.step = 1;
  for (floor = 0; floor < 3; ++floor) {
    options.floor = floor == 0 ? 0 : floor == 1 ? -1 : -1e6;
    for (more = -1; more <= 1; ++more) {
      const double d = 4656965; /* 2 d^2 = 3 r^2 + 2 */
      set_box(3e7, 0, 3e7, 0, 0, 3e7);
      for (k = 0; k < 6; ++k) {
        const double at = k % 2 == 0 ? d : -d;
        add(k / 2 == 0 ? at : 0, k / 2 == 1 ? at : 0, k / 2 == 2 ? at : 0, 3802396 + more);
      }
      CHECK_EQUAL(hsp_workspace_set(&work, n, xyz, radii, &lattice, NULL), HSP_OK);
      CHECK_EQUAL(hsp_workspace_pores(&work, &options), HSP_OK);
      CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
      CHECK_EQUAL(hsp_pores_find_regions(work.pores, work.boundary, &access, &count), HSP_OK);
      CHECK_EQUAL(count, more > 0 ? 2 : 1);
      CHECK(access.accessible == 1 && access.blocked == count - 1);
      CHECK_EQUAL(hsp_pores_get_channels(work.pores, 0, &channel, 1, &needed), HSP_OK);
      CHECK_EQUAL(needed, count - 1);
      CHECK_EQUAL(hsp_workspace_periodic(&work, n, xyz, radii, box, &lattice, NULL), HSP_OK);
      CHECK_EQUAL(hsp_workspace_pores_periodic(&work, &options), HSP_OK);
      CHECK_EQUAL(hsp_pores_find_regions(work.pores, NULL, &access, &count), HSP_OK);
      CHECK_EQUAL(count, more > 0 ? 2 : 1);
      CHECK(access.accessible == 1 && access.blocked == count - 1);
    }
  }
}

/* A cage without the ball in its middle, around a small ball that floats; far from others of its kind. */
static void add_cage(double floating) {
  int x, y, z;
  for (x = -1; x <= 1; ++x) {
    for (y = -1; y <= 1; ++y) {
      for (z = -1; z <= 1; ++z) {
        if (x != 0 || y != 0 || z != 0) add(x, y, z, 0.75);
      }
    }
  }
  if (floating > 0) add(0.02, 0.01, -0.03, floating);
}

/* Blocked room inside a lattice of cages that a probe gets everywhere between; anywhere in the box, in any cell. */
static void cages(void) {
  static const double shift[4][3] = {{0, 0, 0}, {3.1, 2.4, -1.7}, {-50.5, 4, 17}, {2.5, 2.5, 3}};
  double hollow = 0, surface = 0;
  uint32_t k, i;
  hsp_region voids[2];
  uint32_t needed = 0;
  n = 0;
  add_cage(0.1);
  CHECK_EQUAL(hsp_workspace_set(&work, n, xyz, radii, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_pores(&work, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
  CHECK_EQUAL(hsp_workspace_topology(&work), HSP_OK);
  read_regions(work.boundary);
  CHECK_EQUAL(hsp_topology_get_regions(work.topology, voids, 2, &needed), HSP_OK);
  CHECK(count == 2 && needed == 2 && access.accessible == 1 && access.blocked == 1);
  CHECK(regions[0].maximum == HSP_PORE_OUTSIDE && isinf(regions[0].radius) && isinf(regions[0].volume));
  CHECK(isinf(access.accessible_volume) && regions[0].accessible == 1 && regions[0].directions == 0);
  CHECK(regions[0].shells == voids[0].shells && regions[1].shells == 2 && voids[1].shells == 2);
  CHECK_NEAR(regions[0].area, voids[0].area, 1e-10);
  CHECK_NEAR(regions[1].area, voids[1].area, 1e-10);
  CHECK_NEAR(regions[1].volume, voids[1].volume, 1e-11);
  hollow = regions[1].volume;
  surface = regions[1].area;
  for (k = 0; k < 4; ++k) {
    set_box(5, k == 1 ? 2 : 0, 5, k == 3 ? -2 : 0, k > 1 ? 1.5 : 0, 6);
    add_cage(0.1);
    for (i = 0; i < 3 * n; ++i) xyz[i] += shift[k][i % 3];
    compute();
    CHECK(count == 2 && access.accessible == 1 && access.blocked == 1);
    CHECK(regions[0].directions == 3 && regions[1].directions == 0 && regions[1].shells == 2);
    CHECK_NEAR(access.blocked_volume, hollow, 1e-11);
    CHECK_NEAR(access.blocked_area, surface, 1e-10);
    CHECK_NEAR(access.accessible_volume, totals.free_volume - hollow, 1e-10);
  }
}

/* A box of copies has so many times everything, a probe in the options is that in the radii. */
static void copies_and_probes(void) {
  hsp_model_options options;
  double volume, area;
  uint32_t k;
  set_box(4, 1, 5, -1, 2, 6);
  add(0.3, 0.4, 0.5, 1.9);
  add(2.1, 2.6, 3.2, 1.5);
  add(3.9, 4.4, 1, 1.2);
  compute();
  volume = access.accessible_volume;
  area = access.accessible_area;
  CHECK(volume > 0 && count == 1);
  for (k = 0; k < 3; ++k) add(xyz[3 * k] + box[3], xyz[3 * k + 1] + box[4], xyz[3 * k + 2], radii[k]);
  box[3] *= 2;
  box[4] *= 2;
  compute();
  CHECK_NEAR(access.accessible_volume, 2 * volume, 1e-10);
  CHECK_NEAR(access.accessible_area, 2 * area, 1e-10);
  CHECK_EQUAL(hsp_model_options_init(&options, sizeof options), HSP_OK);
  options.probe = 0.5;
  for (k = 0; k < n; ++k) radii[k] -= 0.5;
  CHECK_EQUAL(hsp_workspace_periodic(&work, n, xyz, radii, box, &options, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_pores_periodic(&work, NULL), HSP_OK);
  read_regions(NULL);
  CHECK_NEAR(access.accessible_volume, 2 * volume, 1e-7);
  CHECK_NEAR(access.accessible_area, 2 * area, 1e-7);
}

/* Nothing, and points. */
static void nothing(void) {
  uint32_t k;
  set_box(2, 0, 3, 1, 0, 4);
  compute();
  CHECK(count == 1 && regions[0].maximum == HSP_PORE_OUTSIDE && regions[0].directions == 3 && regions[0].maxima == 0);
  CHECK_NEAR(access.accessible_volume, 24, 1e-12);
  for (k = 0; k < 9; ++k) CHECK_EQUAL(regions[0].row[k], k % 4 == 0 ? 1 : 0);
  add(1, 1, 1, 0);
  add(1.5, 2, 1, 0);
  compute();
  CHECK(count == 1 && access.accessible == 1 && regions[0].shells == 2);
  CHECK_NEAR(access.accessible_volume, 24, 1e-12);
  add(0, 0, 0, 5); /* everything */
  compute();
  CHECK(count == 0 && access.accessible_volume == 0 && access.blocked_volume == 0);
  n = 0;
  CHECK_EQUAL(hsp_workspace_set(&work, 0, NULL, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_pores(&work, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
  read_regions(work.boundary);
  CHECK(count == 1 && regions[0].maximum == HSP_PORE_OUTSIDE && regions[0].area == 0 && isinf(regions[0].volume));
}

static void statuses(void) {
  static hsp_workspace other;
  hsp_pores_options options;
  uint32_t number = 0, k;
  CHECK_EQUAL(hsp_pores_options_init(&options, sizeof options), HSP_OK);
  set_box(4, 0, 4, 0, 0, 4);
  add(0, 0, 0, 1);
  compute();
  CHECK_EQUAL(hsp_pores_find_regions(work.pores, NULL, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_regions(work.pores, 0, 1, regions), HSP_OK);
  CHECK_EQUAL(hsp_pores_get_regions(work.pores, 0, 2, regions), HSP_E_ID);
  CHECK_EQUAL(hsp_pores_get_regions(work.pores, 1, 0, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_set(&other, n, xyz, radii, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_boundary(&other), HSP_OK);
  FILL(number);
  CHECK_EQUAL(hsp_pores_find_regions(work.pores, other.boundary, NULL, &number), HSP_E_ARGUMENT);
  CHECK_UNTOUCHED(number);
  CHECK_EQUAL(hsp_pores_get_regions(work.pores, 0, 1, regions), HSP_E_ID); /* they are gone */
  options.floor = 0.1;
  CHECK_EQUAL(hsp_workspace_pores_periodic(&work, &options), HSP_OK);
  CHECK_EQUAL(hsp_pores_find_regions(work.pores, NULL, &access, &number), HSP_E_RANGE);
  CHECK_UNTOUCHED(number);
  options.floor = -0.1;
  CHECK_EQUAL(hsp_workspace_pores_periodic(&work, &options), HSP_OK);
  CHECK_EQUAL(hsp_pores_find_regions(work.pores, NULL, &access, &number), HSP_OK);
  CHECK(number == 1 && fabs(access.accessible_volume - (64 - 4 * pi / 3)) < 1e-10);
  radii[0] = 1.5;
  CHECK_EQUAL(hsp_workspace_periodic(&work, n, xyz, radii, box, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_find_regions(work.pores, NULL, &access, &number), HSP_E_STATE);
  CHECK_EQUAL(hsp_pores_get_regions(work.pores, 0, 0, NULL), HSP_E_STATE);
  /* Of a molecule: a boundary, of the same model. */
  CHECK_EQUAL(hsp_workspace_pores(&other, NULL), HSP_OK);
  CHECK_EQUAL(hsp_pores_find_regions(other.pores, NULL, &access, &number), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_pores_find_regions(other.pores, other.boundary, &access, &number), HSP_OK);
  CHECK(number == 1 && access.blocked == 0);
  CHECK_EQUAL(hsp_workspace_set(&work, n, xyz, radii, NULL, NULL), HSP_OK);
  CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
  CHECK_EQUAL(hsp_pores_find_regions(other.pores, work.boundary, &access, &number), HSP_E_ARGUMENT);
  CHECK_EQUAL(hsp_pores_find_regions(NULL, work.boundary, &access, &number), HSP_E_ARGUMENT);
  /* Where all of free space is a step wide nothing is certain. */
  {
    hsp_model_options coarse;
    CHECK_EQUAL(hsp_model_options_init(&coarse, sizeof coarse), HSP_OK);
    coarse.step = 1e-3;
    set_box(4, 0, 4, 0, 0, 4);
    add(0, 0, 0, 3.463);
    CHECK_EQUAL(hsp_workspace_periodic(&work, n, xyz, radii, box, &coarse, NULL), HSP_OK);
    CHECK_EQUAL(hsp_workspace_pores_periodic(&work, NULL), HSP_OK);
    CHECK_EQUAL(hsp_pores_find_regions(work.pores, NULL, &access, &number), HSP_E_RANGE);
    CHECK_EQUAL(hsp_pores_get_regions(work.pores, 0, 1, regions), HSP_E_ID);
  }
  for (k = 0; k < 3; ++k) CHECK(isfinite(xyz[k]));
  hsp_workspace_free(&other);
}

/* Nearly as far apart as a lattice has room for, where doubles know a way up to large parts of a step. */
static void far_apart(void) {
  static const double few[6][4] = {{138890635400101, 146, 4, 1},
                                   {732695847167402, 533, 0, 0},
                                   {624956066369055, 355384633425766, -1125899906842624, 0},
                                   {823343881347983, 1012484514223645, -1125899906842624, 0},
                                   {145077089474572, 981570190253599, -1125899906842624, 0},
                                   {769631864943859, 1100473082478136, -1125899906842624, 0}};
  hsp_model_options steps;
  uint32_t set, k, axis;
  CHECK_EQUAL(hsp_model_options_init(&steps, sizeof steps), HSP_OK);
  steps.step = 1;
  for (set = 0; set < 2; ++set) {
    double area = 0;
    n = 0;
    for (k = set == 0 ? 0 : 2; k < (set == 0 ? 2U : 6U); ++k) add(few[k][0], few[k][1], few[k][2], few[k][3]);
    for (k = 0; k < n; ++k) area += 4 * pi * radii[k] * radii[k];
    CHECK_EQUAL(hsp_workspace_set(&work, n, xyz, radii, &steps, NULL), HSP_OK);
    CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
    CHECK_EQUAL(hsp_workspace_pores(&work, NULL), HSP_OK);
    read_regions(work.boundary);
    CHECK(count == 1 && regions[0].maximum == HSP_PORE_OUTSIDE && regions[0].shells == n);
    CHECK_NEAR(regions[0].area, area, 1e-12);
    for (k = 0; k < n; ++k) {
      for (axis = 0; axis < 3; ++axis) {
        double at[3];
        hsp_pore_place place;
        memcpy(at, xyz + 3 * k, sizeof at);
        at[axis] += 8;
        CHECK_EQUAL(hsp_pores_locate(work.pores, at, &place), HSP_OK);
        CHECK(place.maximum == HSP_PORE_OUTSIDE && place.ball == k);
      }
    }
  }
}

/* Nearly in a plane, so that ways up are too flat for some sets of balls so far apart. */
static void nearly_flat(void) {
  hsp_model_options steps;
  uint32_t set, k, known = 0, lost = 0, state = 2654435761U;
  CHECK_EQUAL(hsp_model_options_init(&steps, sizeof steps), HSP_OK);
  steps.step = 1;
  for (set = 0; set < 6; ++set) {
    double part[4];
    int32_t status;
    for (n = 0; n < 160;) {
      for (k = 0; k < 4; ++k) {
        state = state * 1664525U + 1013904223U;
        part[k] = (state >> 8) / 16777216.0;
      }
      add(part[0] * 1e15, part[1] * 1e15, part[2] * 1e9, 5e8 * (1 + part[3]));
    }
    CHECK_EQUAL(hsp_workspace_set(&work, n, xyz, radii, &steps, NULL), HSP_OK);
    CHECK_EQUAL(hsp_workspace_boundary(&work), HSP_OK);
    CHECK_EQUAL(hsp_workspace_pores(&work, NULL), HSP_OK);
    status = hsp_pores_find_regions(work.pores, work.boundary, &access, &count);
    CHECK(status == HSP_OK || status == HSP_E_RANGE);
    if (status == HSP_OK) CHECK_EQUAL(count, 1);
    known += status == HSP_OK;
    lost += status == HSP_E_RANGE;
    n = 0;
  }
  CHECK(known > 0 && lost > 0);
}

int main(void) {
  memset(&work, 0, sizeof work);
  far_apart();
  nearly_flat();
  packings();
  touching();
  slabs(0);
  slabs(2.5);
  tubes();
  networks(0);
  networks(1);
  pinched();
  windows();
  cages();
  copies_and_probes();
  nothing();
  statuses();
  hsp_workspace_free(&work);
  return check_report();
}
