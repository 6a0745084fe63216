/* Values read of the smooth surface by patches, shells and triangles agree with its totals: sets full of near-ties, of
 * balls that are points or tiny against the probe. */
#include <hardsphere.h>
#include <math.h>
#include <stdlib.h>

#include "check.h"
#include "mesh_result.h"
#include "random_numbers.h"

enum { most_balls = 5 };

typedef struct tied_set {
  const char *name;
  double probe;
  uint32_t n;
  double ball[most_balls][4]; /* x, y, z, radius */
} tied_set;

static const tied_set tied_sets[] = {
    {"points in general position",
     2,
     4,
     {{2.3, 2.8, 0.4, 0}, {2.7, 0.4, 0.2, 0}, {2.5, 2.7, 0.8, 0}, {2.2, 2.3, 1.8, 0}}},
    {"tiny balls nearly on a lattice",
     8,
     5,
     {{4e-8, 5e-8, 1.00000006, 0.01},
      {1.99999995, 1.99999996, 1.99999995, 0.01},
      {1.00000007, 2.00000006, 2e-8, 0.01},
      {1.99999991, 2, 1.00000006, 0.01},
      {1.99999994, 1.00000002, 2.00000005, 0.01}}},
    {"the lattice itself", 8, 5, {{0, 0, 1, 0}, {2, 2, 2, 0}, {1, 2, 0, 0}, {2, 2, 1, 0}, {2, 1, 2, 0}}},
    {"three points nearly in a corner",
     8,
     3,
     {{0.99999996, 1.9999999, 1.99999998, 0}, {1.00000004, 2.00000006, 1.99999999, 0}, {4e-8, 2.00000007, 2, 0}}},
    {"a crease whose ends two probes see in different places",
     2,
     5,
     {{0.99999991, 1.99999995, 5e-8, 0.1},
      {2.00000006, 2.00000004, 7e-8, 0.1},
      {1.99999994, 3e-8, 1e-8, 0.1},
      {1.99999991, -6e-8, 0.99999999, 0.1},
      {0.99999996, -1e-8, 1.0000001, 0.1}}},
    {"shared decisions that leave another part of the same area",
     2,
     5,
     {{2.0000005, 1.9999997, 0.9999997, 0.03},
      {0.9999991, 0.9999997, -7e-7, 0.03},
      {1e-6, 4e-7, 1.0000004, 0.03},
      {1.9999997, 1.0000006, 0.9999991, 0.03},
      {0.9999999, 0, 1.999999, 0.03}}},
    {"ends that differ at a corner of three creases",
     8,
     5,
     {{4e-7, 0.9999992, 0.9999998, 0.01},
      {-1e-6, 1.0000003, 1.9999998, 0.01},
      {1.9999996, 2.0000004, 1.9999993, 0.01},
      {2.0000003, 2.0000006, 1.0000006, 0.01},
      {1.0000008, 0.9999994, 1.0000009, 0.01}}}};

static uint32_t agreeing;

/* The triangles are of the surface: as many handles, and volumes that are near. */
static void check_triangles(const surface_result *s, int64_t euler) {
  const double p = s->base->info.probe, origin[3] = {0, 0, 0};
  mesh_result m;
  if (mesh_result_make_surface(s, 0.25 * p, &m) == HSP_OK) {
    CHECK(mesh_fault(&m) == NULL);
    CHECK_EQUAL((int64_t)m.counts.vertices - (int64_t)m.counts.triangles / 2, euler);
    CHECK_NEAR(mesh_volume(&m, origin), s->totals.volume, 0.2 * s->totals.volume + 1e-2 * p * p * p);
  }
  mesh_result_release(&m);
}

static void check_closed(const surface_result *s, double probe, int with_triangles) {
  hsp_surface_part_counts counts;
  hsp_surface_patch *patches;
  hsp_surface_shell *shells;
  double of_patches = 0, of_shells = 0, volume = 0;
  int64_t euler = 0;
  uint32_t needed, k;
  if (!CHECK_EQUAL(hsp_surface_get_part_counts(s->surface, &counts), HSP_OK)) return;
  patches = test_zeros(counts.patches, sizeof *patches);
  shells = test_zeros(counts.shells, sizeof *shells);
  CHECK_EQUAL(hsp_surface_get_patches(s->surface, 0, counts.patches, patches), HSP_OK);
  CHECK_EQUAL(hsp_surface_get_shells(s->surface, shells, counts.shells, &needed), HSP_OK);
  for (k = 0; k < counts.patches; ++k) {
    CHECK(patches[k].area >= 0);
    of_patches += patches[k].area;
  }
  for (k = 0; k < counts.shells; ++k) {
    of_shells += shells[k].area;
    volume += shells[k].volume;
    euler += shells[k].euler;
  }
  CHECK_NEAR(of_patches, s->totals.area, 1e-12 * (probe * probe + s->totals.area));
  CHECK_NEAR(of_shells, s->totals.area, 1e-12 * (probe * probe + s->totals.area));
  CHECK_NEAR(volume, s->totals.volume, 1e-12 * (probe * probe * probe + s->totals.volume));
  if (with_triangles) check_triangles(s, euler);
  free(patches);
  free(shells);
}

static void check_set(uint32_t n, const double *xyz, const double *radius, double probe, int with_triangles) {
  const hsp_model_options options = options_with_probe(probe);
  uint32_t invariant = HSP_NONE, id = HSP_NONE;
  computed c;
  surface_result s;
  CHECK_EQUAL(computed_make(n, xyz, radius, &options, &c), HSP_OK);
  CHECK_EQUAL(surface_result_make(&c, &s), HSP_OK);
  if (s.surface != NULL) {
    const int32_t status = hsp_surface_check(s.surface, &invariant, &id);
    CHECK_EQUAL(status, HSP_OK);
    CHECK_EQUAL(invariant, 0);
    CHECK_EQUAL(s.counts.open_joints, 0);
    check_closed(&s, probe, with_triangles);
    ++agreeing;
  }
  surface_result_release(&s);
  computed_release(&c);
}

static void check_tied(const tied_set *set) {
  double xyz[3 * most_balls], radius[most_balls];
  check_scene("%s", set->name);
  spread_balls(set->n, set->ball, xyz, radius);
  check_set(set->n, xyz, radius, set->probe, 1);
}

/* Five balls at points of a lattice, moved by up to `most`; or with most < 0 anywhere. */
static void check_family(const char *name, double r, double most) {
  uint64_t state = 7;
  double xyz[3 * most_balls], radius[most_balls];
  uint32_t set, k;
  for (set = 0; set < 200; ++set) {
    check_scene("%s, set %u", name, set);
    for (k = 0; k < 3 * most_balls; ++k) {
      xyz[k] = most < 0 ? 1e-6 * random_below(&state, 3000000)
                        : random_below(&state, 3) + 0.1 * most * (random_below(&state, 21) - 10);
    }
    for (k = 0; k < most_balls; ++k) radius[k] = r;
    check_set(most_balls, xyz, radius, random_below(&state, 2) == 0 ? 2 : 8, 0);
  }
}

int main(void) {
  uint32_t set;
  for (set = 0; set < sizeof tied_sets / sizeof tied_sets[0]; ++set) check_tied(&tied_sets[set]);
  check_family("points anywhere", 0, -1);
  check_family("points of a lattice", 0, 0);
  check_family("points near a lattice", 0, 1e-7);
  check_family("tiny balls near a lattice", 0.01, 1e-7);
  check_family("small balls near a lattice", 0.1, 1e-7);
  check_family("balls near a lattice", 1, 1e-7);
  CHECK(agreeing > 1000);
  return check_report();
}
